// In no figure does a name cover another or lose a part of itself at an edge: many states, at each width that a reader
// may have.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { createRequire } from 'node:module'
import path from 'node:path'
import { FIGURES } from '../../target/figures.js'
import { openFigure, RELEASE, root } from './harness.mjs'

const core = createRequire(import.meta.url)(path.join(root, 'target/pkg/node/estimate_wasm.js'))

/** A phone, a tablet, a desk; before a release the widths between them too. */
const WIDTHS = RELEASE ? [320, 390, 768, 900, 1024, 1280, 1440] : [320, 768, 1280]

/**
 * @type {Record<string, Record<string, unknown>[]>} changes of parameters, one after the other; `step` goes to a step
 */
const STATES = {
  'own-system': [
    {},
    { step: 0 },
    { step: 1 },
    { step: 300 },
    { logTolerance: -14 },
    { logTolerance: -1 },
    { gain: 'placement' },
    {
      poles: [
        [0.5, 0.4],
        [0, 0],
        [0.2, 0],
        [0.3, 0],
      ],
    },
    {
      poles: [
        [-1.3, 1.2],
        [0, 0],
        [0, 0],
        [0, 0],
      ],
    },
    {
      gain: 'hand',
      k: [
        [3, 0, 0, 0],
        [-3, 0, 0, 0],
        [0, 0, 0, 0],
        [0, 0, 0, 0],
      ],
    },
    {
      h: [
        [0, 1, 0, 0],
        [0, 0, 0, 0],
        [0, 0, 0, 0],
        [0, 0, 0, 0],
      ],
      gain: 'filter',
    },
    { start: 1e6 },
    { start: 0 },
    {
      states: 4,
      readings: 4,
      f: [
        [1, 0.1, 0, 0],
        [0, 0.9, 0.1, 0],
        [0, 0, 0.8, 0.1],
        [0, 0, 0, 1.1],
      ],
      h: [
        [1, 0, 0, 0],
        [0, 1, 0, 0],
        [0, 0, 1, 0],
        [0, 0, 0, 1],
      ],
      w: [
        [1, 0, 0, 0],
        [0, 1, 0, 0],
        [0, 0, 1, 0],
        [0, 0, 0, 1],
      ],
    },
  ],
  'odometry-hook': [
    {},
    { step: 1 },
    { step: 45 },
    { step: 160 },
    { step: 260 },
    { step: 330 },
    { step: 640 },
    { fixes: true },
    { step: 300 },
    { bias: 0.01, fixes: false, step: 640 },
    { bias: 0, slip: 0 },
    { learn: true, fixes: true, slip: 0.001, step: 0 },
    { step: 100 },
    { step: 640, bias: 0.005 },
    { fixes: false },
  ],
  'observer-bench': [
    ...['velocity', 'position'].flatMap((sensor) => [
      { sensor, mode: 'fixed', gain: 1, step: 0 },
      ...[1, 2, 3, 5, 8, 12, 17, 23].map((step) => ({ sensor, step })),
    ]),
    { gain: 0 },
    { gain: 0.2 },
    { gain: 2.5 },
    { gain: 3.03 },
    { gain: 6, step: 12 },
    { step: 30 },
    { step: 300 },
    { sensor: 'velocity', gain: 5.8 },
    { gain: 6, step: 60 },
    { mode: 'filter', step: 0 },
    { step: 2 },
    { step: 20 },
  ],
  picture: [
    {},
    { noise: 0 },
    { noise: 4 },
    { noise: 0.5, mean: [4, 2.8] },
    { mean: [1, 1] },
    { mean: [6.4, 6.4] },
    { mean: [6.4, 1] },
    { mean: [4, 4], semiMajor: 0.15 },
    { semiMajor: 3 },
    { semiMajor: 3, angle: 2.4 },
    { semiMajor: 1.72, angle: 0.88, tilt: -0.4 },
    { tilt: -0.8 },
    { tilt: -1.2 },
    { tilt: -Math.PI / 2 },
    { reading: 6.5 },
    { reading: -6 },
    { tilt: 0, reading: -8 },
    { reading: 8 },
    { reading: 4 },
    { reading: 2.7, radius: 0.9 },
    { radius: 3 },
    { guess: 0, sealed: true },
    { guess: 2 },
    { sealed: false, radius: 0 },
    { guess: -0.65, noise: 0 },
    { mean: [20, 20], noise: 4 },
  ],
  'loop-closure': [
    {},
    { step: 1 },
    { step: 20 },
    { step: 64 },
    { step: 112 },
    { step: 113 },
    { step: 128 },
    { gate: 0.5, found: 0.5 },
    { gate: 100, found: 100 },
    { gate: 12, found: 6 },
    { gate: 9.21, found: 50, correlated: false, seed: 2 },
    { step: 300 },
  ],
  tune: [
    {},
    { logQ: -1.5, logW: 0.5 },
    { fit: true },
    { logQ: -2, logW: 2 },
    { logQ: 2, logW: -2, committed: true },
    { logQ: -0.1, logW: -0.86 },
    { seed: 2 },
    { seed: 5, length: 50, logQ: -2, logW: 0.4 },
    { length: 20 },
    { seed: 2, length: 1000, logQ: 0.74, logW: 0.04 },
  ],
  'bug-museum': [
    {},
    { step: 0 },
    { step: 1 },
    { step: 60 },
    { step: 1000 },
    { bug: 'none', step: 240 },
    ...[
      'unwrapped-heading',
      'frozen-jacobian',
      'wrong-derivative',
      'transposed',
      'degrees',
      'deviation',
      'step-length',
      'short-form',
      'asymmetric',
      'twice',
      'open-gate',
      'late',
    ].map((bug) => ({ bug })),
    { bug: 'late', many: true, step: 40 },
    { bug: 'open-gate' },
    { many: false, lot: 7, bug: 'none', step: 240 },
    { guess: 'late', committed: true },
  ],
  'robot-log': [
    {},
    { step: 0 },
    { step: 200 },
    { step: 4000 },
    { sightings: true },
    { step: 15_123 },
    { gate: 0.999 },
    { gate: null, offset: 2.4 },
    { offset: 0, scale: 0.07 },
    { learn: true },
  ],
  'observability-probe': [
    {},
    { step: 0 },
    { step: 10 },
    { step: 75 },
    { step: 130 },
    { count: 2, step: 240 },
    { count: 3 },
    {
      count: 1,
      landmarks: [
        [1.5, 1.5],
        [4.5, 4.5],
        [3, 3],
      ],
    },
    {
      landmarks: [
        [3, 6],
        [0, 3],
        [3, 3],
      ],
      count: 2,
    },
    {
      landmarks: [
        [0, 0],
        [0.2, 0.1],
        [6, 6],
      ],
      count: 2,
    },
    { sensor: 'range-bearing' },
    {
      forget: true,
      count: 1,
      landmarks: [
        [6, 6],
        [0, 6],
        [3, 0],
      ],
    },
    { count: 3, step: 20 },
    { forget: false, tolerance: 1 },
    { tolerance: 1e-16, stop: 20, step: 90 },
    { stop: null, step: 240, tolerance: 1e-6, count: 1, ghost: true, ghostAround: 0.175 },
    { ghostTurn: 0.175, sensor: 'range-bearing' },
    { count: 3 },
    { ghostShift: 1, step: 0 },
    { ghost: false },
  ],
}

/**
 * What is wrong with the texts of a figure's panels: each pair that overlaps, each text that reaches out of its panel.
 */
const faults = (host) =>
  [...host.querySelectorAll('.live .panel')].flatMap((svg) => {
    const panel = svg.getBoundingClientRect()
    const texts = [...svg.querySelectorAll('text')].flatMap((text) => {
      // The letters' own height: a line of text has room above and below.
      const { left, right, top, bottom } = text.getBoundingClientRect()
      const spare = (bottom - top) * 0.2
      return right - left > 1 && text.checkVisibility()
        ? [{ words: text.textContent, left: left + 0.5, right: right - 0.5, top: top + spare, bottom: bottom - spare }]
        : []
    })
    const name = svg.getAttribute('class')
    const cut = texts.filter(
      ({ left, right, top, bottom }) =>
        left < panel.left - 2 || right > panel.right + 2 || top < panel.top - 3 || bottom > panel.bottom + 3,
    )
    const pairs = texts.flatMap((a, i) =>
      texts
        .slice(i + 1)
        .filter((b) => a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom)
        .map((b) => [a, b]),
    )
    return [
      ...cut.map(({ words }) => `${name}: “${words}” is cut`),
      ...pairs.map(([a, b]) => `${name}: “${a.words}” and “${b.words}”`),
    ]
  })

/** Where nothing is said of a figure: each of its parameters at either end, or at each of its words. */
const ends = ({ name, words, least, greatest, default: usual }) =>
  (words ?? (typeof usual === 'boolean' ? [!usual] : typeof usual === 'number' ? [least, greatest] : []))
    .filter((value) => typeof value !== 'number' || Math.abs(value) < 1e6)
    .flatMap((value) => [{ [name]: value }, { [name]: usual }])

for (const { name: tag, lab } of FIGURES) {
  const states = STATES[tag] ?? [{}, { step: 0 }, { step: 1 }, ...core[lab].parameters().flatMap(ends)]
  test(`no name in the ${tag} covers another or is cut`, async (t) => {
    const { page, it } = await openFigure(t, tag)
    const found = []
    for (const width of WIDTHS) {
      await page.setViewportSize({ width, height: 900 })
      for (const state of states) {
        await it.evaluate(
          async (host, change) => {
            if (change) host.figure.change(change)
            // A new width is noticed at the end of a frame, and drawn in the next.
            await new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve)))
            do await new Promise((resolve) => requestAnimationFrame(resolve))
            while (host.figure.asked || !host.settled)
          },
          Object.keys(state).length ? state : null,
        )
        for (const fault of await it.evaluate(faults)) found.push(`${width} px, ${JSON.stringify(state)}: ${fault}`)
      }
      await it.evaluate(
        async (host, start) => {
          host.figure.change(start)
          do await new Promise((resolve) => requestAnimationFrame(resolve))
          while (host.figure.asked || !host.settled)
        },
        await it.evaluate((host) => ({
          ...Object.fromEntries(
            Object.values(host.figure.shell.limits).map(({ name, default: value }) => [name, value]),
          ),
          step: host.figure.spec.start.step,
        })),
      )
    }
    assert.deepEqual([...new Set(found)].slice(0, 30), [], `${found.length} in all`)
  })
}
