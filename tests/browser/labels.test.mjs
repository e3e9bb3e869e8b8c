// In no figure does a name cover another or lose a part of itself at an edge: many states, at each width that a reader may have.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { openFigure } from './harness.mjs'

const WIDTHS = [320, 390, 768, 900, 1024, 1280, 1440]

/** @type {Record<string, Record<string, unknown>[]>} changes of parameters, one after the other; `step` goes to a step */
const STATES = {
  'odometry-hook': [{}, { step: 1 }, { step: 45 }, { step: 160 }, { step: 260 }, { step: 330 }, { step: 640 }, { fixes: true }, { step: 300 }, { bias: 0.01, fixes: false, step: 640 }, { bias: 0, slip: 0 }],
  'observer-bench': [
    ...['velocity', 'position'].flatMap((sensor) => [{ sensor, mode: 'fixed', gain: 1, step: 0 }, ...[1, 2, 3, 5, 8, 12, 17, 23].map((step) => ({ sensor, step }))]),
    { gain: 0 }, { gain: 0.2 }, { gain: 2.5 }, { gain: 3.03 }, { gain: 6, step: 12 }, { step: 30 }, { step: 300 }, { sensor: 'velocity', gain: 5.8 }, { gain: 6, step: 60 },
    { mode: 'filter', step: 0 }, { step: 2 }, { step: 20 },
  ],
  'kalman-picture': [
    {}, { noise: 0 }, { noise: 4 }, { noise: 0.5, mean: [4, 2.8] }, { mean: [1, 1] }, { mean: [6.4, 6.4] }, { mean: [6.4, 1] }, { mean: [4, 4], semiMajor: 0.15 }, { semiMajor: 3 }, { semiMajor: 3, angle: 2.4 },
    { semiMajor: 1.72, angle: 0.88, tilt: -0.4 }, { tilt: -0.8 }, { tilt: -1.2 }, { tilt: -Math.PI / 2 }, { reading: 6.5 }, { reading: -6 }, { tilt: 0, reading: -8 }, { reading: 8 }, { reading: 4 },
  ],
  'observability-probe': [
    {}, { step: 0 }, { step: 10 }, { step: 75 }, { step: 130 }, { count: 2, step: 240 }, { count: 3 }, { count: 1, landmarks: [[1.5, 1.5], [4.5, 4.5], [3, 3]] }, { landmarks: [[3, 6], [0, 3], [3, 3]], count: 2 }, { landmarks: [[0, 0], [0.2, 0.1], [6, 6]], count: 2 },
    { sensor: 'range-bearing' }, { forget: true, count: 1, landmarks: [[6, 6], [0, 6], [3, 0]] }, { count: 3, step: 20 }, { forget: false, tolerance: 1 }, { tolerance: 1e-16, stop: 20, step: 90 },
  ],
}

/** What is wrong with the texts of a figure's panels: each pair that overlaps, each text that reaches out of its panel. */
const faults = (host) => [...host.querySelectorAll('.live .panel')].flatMap((svg) => {
  const panel = svg.getBoundingClientRect()
  const texts = [...svg.querySelectorAll('text')].flatMap((text) => {
    // The letters' own height: a line of text has room above and below.
    const { left, right, top, bottom } = text.getBoundingClientRect()
    const spare = (bottom - top) * 0.2
    return right - left > 1 && text.checkVisibility() ? [{ words: text.textContent, left: left + 0.5, right: right - 0.5, top: top + spare, bottom: bottom - spare }] : []
  })
  const name = svg.getAttribute('class')
  const cut = texts.filter(({ left, right, top, bottom }) => left < panel.left - 2 || right > panel.right + 2 || top < panel.top - 3 || bottom > panel.bottom + 3)
  const pairs = texts.flatMap((a, i) => texts.slice(i + 1).filter((b) => a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom).map((b) => [a, b]))
  return [...cut.map(({ words }) => `${name}: “${words}” is cut`), ...pairs.map(([a, b]) => `${name}: “${a.words}” and “${b.words}”`)]
})

for (const [tag, states] of Object.entries(STATES)) {
  test(`no name in the ${tag} covers another or is cut`, { timeout: 300_000 }, async (t) => {
    const { page, it } = await openFigure(t, tag)
    const found = []
    for (const width of WIDTHS) {
      await page.setViewportSize({ width, height: 900 })
      for (const state of states) {
        await it.evaluate(async (host, change) => {
          if (change) host.figure.change(change)
          do await new Promise((resolve) => requestAnimationFrame(resolve)); while (host.figure.asked || !host.settled)
        }, Object.keys(state).length ? state : null)
        for (const fault of await it.evaluate(faults)) found.push(`${width} px, ${JSON.stringify(state)}: ${fault}`)
      }
      await it.evaluate(async (host, start) => {
        host.figure.change(start)
        do await new Promise((resolve) => requestAnimationFrame(resolve)); while (host.figure.asked || !host.settled)
      }, await it.evaluate((host) => ({ ...Object.fromEntries(host.figure.lab.constructor.parameters().map(({ name, default: value }) => [name, value])), step: host.figure.spec.start.step })))
    }
    assert.deepEqual([...new Set(found)].slice(0, 30), [], `${found.length} in all`)
  })
}
