// The scale of a plane that holds still for a run: it widens by factors of two, never narrows while the run goes on,
// and is chosen anew where a run begins.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { createRequire } from 'node:module'
import { Pen } from '../../web/draw/pen.js'
import { axes, plane as plainPlane } from '../../web/draw/plot.js'
import { rounded } from '../../web/draw/scale.js'
import { Scale } from '../../web/figure/motion.js'
import { drawPhase } from '../../web/widgets/observer-bench/phase.js'

const { parseHTML } = createRequire(new URL('../../web/package.json', import.meta.url))('linkedom')

/** The range when the scale has arrived. */
function arrived(scale, range, anew = false) {
  let first = anew
  while (scale.follow(range, 16, first)) first = false
  return scale.now
}

test('a scale holds still while what it shows stays within it, and doubles a side that it leaves', () => {
  const scale = new Scale(0.5)
  assert.deepEqual(arrived(scale, [-0.3, 1.1], true), [-0.5, 2])
  for (const high of [1.2, 1.5, 1.8]) assert.deepEqual(arrived(scale, [-0.3, high]), [-0.5, 2], `${high}`)
  assert.deepEqual(arrived(scale, [-0.3, 2.1]), [-0.5, 4])
  assert.deepEqual(arrived(scale, [-0.3, 1.1]), [-0.5, 4], 'it does not narrow in the run')
  assert.deepEqual(arrived(scale, [-0.3, 1.1], true), [-0.5, 2], 'another run has its own')
})

test('a scale on its way shows every size between, and one of a still is there at once', () => {
  const scale = new Scale(1)
  scale.follow([-0.5, 0.5], Infinity, true)
  assert.deepEqual(scale.now, [-1, 1])
  assert.ok(scale.follow([-0.5, 1.5], 16, false))
  assert.ok(scale.now[1] > 1 && scale.now[1] < 2)
  scale.follow([-0.5, 1.5], Infinity, false)
  assert.deepEqual(scale.now, [-1, 2])
})

test('after something huge a scale comes back, and nothing that is no number moves it', () => {
  const scale = new Scale(0.5)
  assert.deepEqual(arrived(scale, [-1000, 1000], true), [-2048, 2048])
  assert.ok(scale.isLoose([-0.3, 0.3]) && !scale.isLoose([-300, 300]))
  assert.deepEqual(arrived(scale, [-0.3, 0.3]), [-0.5, 0.5])
  assert.deepEqual(arrived(scale, [-Infinity, NaN]), [-0.5, 0.5])
})

test('an axis has two ticks or more, none nearer than its words are high', () => {
  const at = (high, most) => {
    const marks = []
    const plane = plainPlane({ left: 0, top: 0, right: 300, bottom: high }, [0, 10], [-most, most])
    /** @type {any} */
    const pen = { group: (_key, _attributes, act) => act(pen), mark: () => {}, text: (key) => marks.push(key) }
    axes(pen, plane, { ticks: [5, 3] })
    return marks.filter((key) => key.startsWith('ty')).map((key) => plane.y(Number(key.slice(2))))
  }
  for (let high = 40; high < 140; high += 7) {
    for (let most = 0.3; most < 5000; most *= 1.07) {
      const ticks = at(high, rounded(-most, most, 3)[1])
      const gaps = ticks.slice(1).map((tick, i) => Math.abs(tick - ticks[i]))
      assert.ok(ticks.length >= 2 && gaps.every((gap) => gap >= 15), `±${most} on ${high} pixels: ${ticks}`)
    }
  }
})

test('where one axis of the Bench comes back to something small, the other does too', () => {
  const svg = parseHTML('<html><svg></svg></html>').document.querySelector('svg')
  const panel = { pen: new Pen(svg), svg, width: 560, height: 400 }
  /** @type {any} */
  const view = { memory: {}, beat: { name: 'rest', t: 1 }, previous: null, elapsed: Infinity }
  const shown = (/** @type {number[]} */ x) => {
    /** @type {any} */
    const at = { x, ellipse: { semiMajor: 0.5, semiMinor: 0.5, angle: 0 } }
    /** @type {any} */
    const frame = { step: 9, params: { sensor: 'position' }, truth: [0, 0], H: [1, 0], reading: null }
    drawPhase(panel, { ...frame, first: at, predicted: at, posterior: at }, view)
    return view.memory.phase.scales.map(({ now }) => now)
  }
  assert.deepEqual(shown([0, 0]), [
    [-1, 1],
    [-1, 1],
  ])
  assert.deepEqual(shown([12, 30])[0][1], 16)
  // The position alone would keep the sixteen metres.
  assert.deepEqual(shown([2.4, 0])[0][1], 4)
})
