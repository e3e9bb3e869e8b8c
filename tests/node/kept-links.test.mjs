// A link that a release has made opens in every later one: the same figure, the same state, the same numbers.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { existsSync, readFileSync } from 'node:fs'
import { readState } from '../../web/figure/state-in-url.js'
import { WIDGETS } from '../../web/widgets/index.js'
import { SITE, hashes, kept, lost, opened } from './kept-links.mjs'

const root = new URL('../../', import.meta.url)
const version = /^version = "(.+)"$/m.exec(readFileSync(new URL('Cargo.toml', root), 'utf8'))[1]

test('links of this version are kept, several for every figure', () => {
  const ours = kept().find((one) => one.version === version)
  assert.ok(ours, 'node tests/node/kept-links.mjs keeps them')
  for (const widget of Object.keys(WIDGETS)) {
    const states = new Set(
      ours.links.filter(({ state }) => state.lab === widget).map(({ state }) => JSON.stringify(state)),
    )
    assert.ok(states.size >= 4, `${widget}: ${states.size}`)
  }
})

for (const { version: of, links } of kept()) {
  test(`the links of ${of} open the states and the numbers that they did`, async () => {
    for (const { figure, address, state, frame } of links) {
      const page = new URL(address, SITE).pathname.slice(1)
      const file = new URL(`dist/${page}index.html`, root)
      assert.ok(existsSync(file), `${page} is a page`)
      assert.match(
        readFileSync(file, 'utf8'),
        new RegExp(`id="${figure}"[^]{0,400} data-widget="${state.lab}"`),
        `${page} has ${state.lab} as ${figure}`,
      )
      const spec = await WIDGETS[state.lab]()
      const read = readState(SITE + address, figure, spec.name)
      assert.deepEqual(read, state, address)
      const lab = opened(spec, read)
      assert.deepEqual(lost(state.params, lab.state().params), [], `${address}: parameters`)
      assert.equal(lab.state().step, state.step)
      assert.deepEqual(lost(frame, hashes(lab.frame())), [], `${address}: numbers`)
      lab.free()
    }
  })
}

test('a parameter or number that is gone or changed is found, and what is new is not held against a release', () => {
  const had = hashes({ step: 3, series: { x: Float64Array.of(0.1, NaN), y: [0] }, params: { gain: 1 } })
  assert.deepEqual(lost(had, hashes({ step: 3, series: { x: [0.1, NaN], y: [0], z: [1] }, words: 'new' })), [])
  assert.deepEqual(lost(had, hashes({ step: 3, series: { x: [0.1 + 2 ** -56, NaN], y: [-0] } })), [
    'series.x',
    'series.y',
  ])
  assert.deepEqual(lost({ gain: 1, gate: null }, { gain: 1 }), ['gate'])
})

test('a place of the chapter that an address once named is on the chapter still, or its line that leads on is', () => {
  const chapter = readFileSync(new URL('dist/kalman/index.html', root), 'utf8')
  const ids = new Set([...chapter.matchAll(/ id="?([^" >]+)/g)].map(([, id]) => id))
  const places = readFileSync(new URL('tests/links/places.txt', root), 'utf8').trim().split('\n')
  assert.ok(places.length > 200)
  assert.deepEqual(
    places.filter((id) => !ids.has(id)),
    [],
  )
})
