// A figure in a frame tells its height, and stops where the page around it would answer each height with another width.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { Heights } from '../../web/page/embedded.js'

test('two heights that bring each other about are told a few times, and the greater one stays', () => {
  const heights = new Heights()
  const told = []
  // The page around the frame makes it narrow when it is low, and wide when it is high.
  let height = 400
  for (let i = 0; i < 1000 && heights.tells(height); i += 1) {
    told.push(height)
    height = height === 400 ? 600 : 400
  }
  assert.ok(told.length < 30, `${told.length} messages`)
  assert.equal(told.at(-1), 600, 'nothing is cut off')
  assert.ok(heights.tells(700), 'what grows is told still')
})

test('three heights in a circle end too, and what a reader opens and closes is told each time', () => {
  const heights = new Heights()
  let told = 0
  for (let i = 0; i < 1000; i += 1) told += heights.tells([300, 500, 400][i % 3]) ? 1 : 0
  assert.ok(told < 40, `${told} messages`)
  for (let i = 0; i < 100; i += 1) {
    heights.touched()
    assert.ok(heights.tells(i % 2 ? 301 : 601))
  }
})
