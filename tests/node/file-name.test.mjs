// However long a file's name is, what is shown of it fits, and begins and ends as the name does.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { shortName } from '../../web/page/file-name.js'

test('a name of a million letters is shown by its beginning and its end', () => {
  const name = `robot-7-${'x'.repeat(1_000_000)}-odometry.csv`
  const shown = shortName(name)
  assert.equal([...shown].length, 60)
  assert.match(shown, /^robot-7-x+…x+-odometry\.csv$/)
})

test('a name that fits is shown whole, and no letter of two halves is cut', () => {
  for (const name of ['', 'plaza1.csv', 'a'.repeat(60)]) assert.equal(shortName(name), name)
  const shown = shortName('🤖'.repeat(100))
  assert.ok(shown.isWellFormed(), shown)
})
