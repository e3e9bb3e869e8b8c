// The examples of the package's pages, run by Node in an empty folder with the package installed.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { EXAMPLES, folder, node } from './folder.mjs'

const place = await folder('examples', EXAMPLES)

test("Node imports it: the README's filter runs", async () => {
  const lines = (await node(place, 'track.mjs')).split('\n')
  assert.match(lines[0], /^\[ 5\.\d+, \d\.\d+ \]$/)
  assert.ok(Number(lines.at(-1)) < 0)
})

test("two sensors at two rates: the README's time line runs", async () => {
  const lines = (await node(place, 'sensors.mjs')).split('\n')
  assert.match(lines[0], /^\[ (3\.9|4\.0)\d+, (0\.9|1\.0)\d+ \]$/)
  assert.equal(lines[1], 'rejected')
  assert.match(lines.slice(2).join(' '), /used: 4,\s+refused: 1,/)
})

test("filterpy's calls beside ours: each line runs", async () => {
  const printed = await node(place, 'from-filterpy.mjs')
  assert.ok(printed.endsWith('6 3\ntrue true'), printed)
})

test('an extended and an unscented filter of own models find the boat', async () => {
  assert.equal(await node(place, 'own-models.mjs'), 'true\ntrue')
})

test("npm's kalman-filter beside ours: each line runs", async () => {
  const lines = (await node(place, 'from-kalman-filter.mjs')).split('\n')
  // The first corrected mean is that of its predict and correct.
  assert.match(lines.at(-1), /^\[ 0\.95\d+, 0\.47\d+ \]$/)
})

test("a filter as text: the README's program runs, and is right", async () => {
  const said = await node(place, 'program.mjs')
  assert.match(said, /^\[\]\n/)
  assert.match(said, /Right: x and P are those of a right filter in all 12 cases/)
})

test("the filter of the book's README is that of the package's", async () => {
  const lines = (await node(place, 'track.mjs')).split('\n')
  assert.ok((await node(place, 'rail.mjs')).startsWith(`${lines[0]} `))
})

test("Node requires it: the README's step is its step by hand", async () => {
  const lines = (await node(place, 'step.cjs')).split('\n')
  assert.equal(lines[0], '[ 1.5 ] [ [ 1 ] ] [ [ 0.5 ] ] [ 3 ]')
})
