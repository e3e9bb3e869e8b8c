// What a figure draws are numbers and the reader's letters: no attribute of a drawing is NaN, infinite or undefined,
// whatever the state. Each figure goes through random states, with the cameras and the beats of a living one, drawn by
// the code that draws it in a browser. Two runs of one commit visit the same states; DRAWN_SEED=7 looks elsewhere, and
// DRAWN_STATES=1000 at more of them.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { readFileSync } from 'node:fs'
import { createRequire } from 'node:module'
import { drawHandle } from '../../web/figure/handle.js'
import { Readouts } from '../../web/figure/readouts.js'
import { buildShell } from '../../web/figure/shell.js'
import { writeSvg } from '../../web/draw/words.js'
import { WIDGETS } from '../../web/widgets/index.js'
import { LOG, estimate } from './claims.mjs'
import { dice as seeded } from './nonsense.mjs'

const { parseHTML } = createRequire(new URL('../../web/package.json', import.meta.url))('linkedom')
const SEED = Number(process.env.DRAWN_SEED ?? 1)
const STATES = Number(process.env.DRAWN_STATES ?? 60)
const STEPS = [0, 1, 2, 3, 12, 40, 250, 700]
/** What belongs together in a system of the reader's own. */
const MATRICES = ['states', 'inputs', 'readings', 'f', 'g', 'h', 'v', 'w', 'k', 'shown', 'names']
/** What a log of odometry refuses: it is of held speeds and turn rates. */
const OF_HELD_ROWS = ['speedScale', 'turnBias', 'learnSpeed', 'learnBias', 'delaySpeed', 'delayTurn']
const CAR = readFileSync(new URL('../../content/logs/car.csv', import.meta.url), 'utf8')
const nothing = () => {}

/** A value of a parameter, now and then at an end of its range. @param {import('estimate-wasm').Parameter} parameter */
function value({ default: usual, least, greatest, words }, dice) {
  const number = (like) => {
    const chance = dice.uniform()
    if (chance < 0.1) return like
    const at = chance < 0.2 ? least : chance < 0.3 ? greatest : least + dice.uniform() ** 3 * (greatest - least)
    return Number.isInteger(like) && Number.isInteger(least) && Number.isInteger(greatest) ? Math.round(at) : at
  }
  const any = (like) => {
    if (typeof like === 'number') return number(like)
    if (typeof like === 'boolean') return dice.uniform() < 0.5
    if (Array.isArray(like)) return like.map(any)
    return words ? dice.pick(words) : like
  }
  return any(usual)
}

/** The matrices of a system of the reader's own: sizes by lot, entries of any magnitude, V and W covariances. */
function system(dice) {
  const [states, inputs, readings] = [1 + dice.below(4), dice.below(5), 1 + dice.below(4)]
  const magnitude = 10 ** (dice.uniform() < 0.7 ? 0 : dice.uniform() * 24 - 12)
  const matrix = (rows, columns, entry) =>
    Array.from({ length: 4 }, (_, i) =>
      Array.from({ length: 4 }, (_, j) => (i < rows && j < columns ? entry(i, j) : 0)),
    )
  const any = () => (dice.uniform() < 0.3 ? dice.pick([0, 1, -1]) : dice.normal())
  const covariance = (size) => {
    const factor = matrix(size, size, any)
    return matrix(size, size, (i, j) => magnitude * factor[i].reduce((sum, value, k) => sum + value * factor[j][k], 0))
  }
  const params = {
    states,
    inputs,
    readings,
    f: matrix(states, states, any),
    g: matrix(states, inputs, any),
    h: matrix(readings, states, any),
  }
  return {
    ...params,
    v: covariance(states),
    w: covariance(readings),
    k: matrix(states, readings, any),
    shown: 1 + dice.below(states),
    gain: dice.pick(['filter', 'filter', 'hand', 'placement']),
  }
}

/** Faults of what stands in a picture. @param {Element} svg */
function faults(svg) {
  const found = []
  for (const element of svg.querySelectorAll('*')) {
    if (!element.children.length && /NaN|undefined|\[object/.test(element.textContent))
      found.push(`<${element.localName}>${element.textContent}`)
    // Such a letter is another in another notation, and has to be written in all of them.
    if (
      element.classList.contains('symbol') &&
      /^[FGHKPVW]$/.test(element.textContent) &&
      !element.closest('[class^=in-]')
    )
      found.push(`${element.textContent} in ${element.parentElement.textContent}`)
    for (const { name, value } of element.attributes) {
      if (name !== 'data-kin' && /NaN|Infinity|undefined|\[object/.test(value))
        found.push(`<${element.localName} ${name}="${value.slice(0, 60)}">`)
    }
  }
  return found
}

for (const [tag, load] of Object.entries(WIDGETS)) {
  test(`the ${tag} draws numbers alone, in every state`, async (t) => {
    const spec = await load()
    const dice = seeded(SEED)
    const { document } = parseHTML('<!doctype html><html><body></body></html>')
    const orders = {
      play: nothing,
      step: nothing,
      reset: nothing,
      speed: nothing,
      change: nothing,
      grow: nothing,
      link: nothing,
      embed: nothing,
      download: nothing,
    }
    const parameters = estimate[spec.lab].parameters()
    const shell = buildShell(document, spec, document.createElement('div'), orders, parameters)
    const memory = {}
    let previous = null
    let drawn = 0
    for (let turn = 0; turn < STATES; turn += 1) {
      const held = tag === 'robot-log' && dice.uniform() < 0.5
      const log = spec.log ? [estimate[spec.lab].parse(held ? CAR : LOG)] : []
      const apart = tag === 'own-system' ? MATRICES : tag === 'robot-log' && !held ? OF_HELD_ROWS : []
      const moved = parameters.filter(({ name }) => dice.uniform() < 0.5 && !apart.includes(name))
      const params = {
        ...Object.fromEntries(moved.map((parameter) => [parameter.name, value(parameter, dice)])),
        ...(tag === 'own-system' ? system(dice) : {}),
      }
      const where = `DRAWN_SEED=${SEED}, turn ${turn}, ${JSON.stringify(params)}`
      let lab
      try {
        lab = estimate[spec.lab].from(...log, { version: 1, lab: spec.name, step: 0, params })
      } catch (error) {
        assert.equal(error.name, 'EstimateError', where)
        continue // The lab refuses what does not go together, and a refusal draws nothing.
      }
      for (const step of [dice.pick(STEPS), dice.pick(STEPS)].sort((a, b) => a - b)) {
        if (!spec.timeless && step > lab.state().step) lab.run(step - lab.state().step)
        const frame = lab.frame()
        const view = {
          previous: dice.uniform() < 0.5 ? previous : null,
          memory,
          limits: shell.limits,
          aside: turn % 8 === 0 ? (spec.aside?.whole(lab) ?? null) : null,
          beat: dice.pick([
            { name: 'rest', t: 1 },
            { name: 'predict', t: dice.uniform() },
            { name: 'update', t: dice.uniform() },
          ]),
          elapsed: dice.pick([0, 16, 300, Infinity]),
          handle: (pen, key, handle) => void drawHandle(pen, key, handle),
        }
        for (const { name, draw, shown } of spec.panels) {
          if (!(shown?.(frame) ?? true)) continue
          draw(shell.panels[name], frame, view)
          assert.deepEqual(faults(shell.panels[name].svg), [], `${name} at step ${step}, ${where}`)
        }
        previous = frame
        drawn += 1
      }
      lab.free()
    }
    t.diagnostic(`${drawn} states were drawn`)
    assert.ok(drawn > STATES, 'most of the states are such as a reader can reach')
  })
}

test('what follows an index or a power stands on the line of what is before it', () => {
  const { document } = parseHTML('<!doctype html><html><body></body></html>')
  const css = readFileSync(new URL('../../web/style/ink.css', import.meta.url), 'utf8')
  const size = (name) =>
    name ? Number(css.match(new RegExp(`\\.${name}\\b[^{]*\\{[^}]*font-size: ([\\d.]+)em`))[1]) : 1
  for (const words of ['slope 0.07, *R*^{2} = 0.78', '*K*_t + 1', 'χ_1^{2} *y*', '*P*_{0|0}*H*']) {
    const text = document.createElement('text')
    writeSvg(text, words)
    const last = text.lastChild
    const low = [...text.children].reduce(
      (sum, span) => sum + Number((span.getAttribute('dy') ?? '0em').slice(0, -2)) * size(span.getAttribute('class')),
      0,
    )
    assert.ok(
      !['sub', 'sup'].includes(last.getAttribute('class')) && Math.abs(low) < 0.02,
      `${words} ends ${low} em below its line`,
    )
  }
})

test('what has no value has no unit', () => {
  const { document } = parseHTML('<!doctype html><html><body></body></html>')
  const readouts = new Readouts(document, document.body)
  const shown = (value) => {
    readouts.show([{ key: 'rmse', label: 'RMS error', value, unit: 'm' }])
    return document.querySelector('dd').textContent
  }
  assert.deepEqual([shown('0.37'), shown('–'), shown('∞')], ['0.37 m', '–', '∞ m'])
})

test('a panel of a log says why it is empty, and one alone says what to do', async () => {
  const spec = await WIDGETS['robot-log']()
  const texts = (params, step, log = LOG) => {
    const { document } = parseHTML('<!doctype html><html><body></body></html>')
    const orders = {
      play: nothing,
      step: nothing,
      reset: nothing,
      speed: nothing,
      change: nothing,
      grow: nothing,
      link: nothing,
      embed: nothing,
      download: nothing,
    }
    const shell = buildShell(document, spec, document.createElement('div'), orders, estimate.RobotLog.parameters())
    const frame = estimate.RobotLog.from(estimate.RobotLog.parse(log), {
      version: 1,
      lab: 'robot-log',
      params,
      step,
    }).frame()
    for (const { name, draw, shown } of spec.panels.slice(1))
      if (shown?.(frame) ?? true) draw(shell.panels[name], frame, /** @type {any} */ ({}))
    return Object.fromEntries(
      spec.panels.map(({ name }) => [
        name,
        [...shell.panels[name].svg.querySelectorAll('text')].map(({ textContent }) => textContent).join('\n'),
      ]),
    )
  }
  const begun = texts({ sightings: true }, 0)
  for (const name of ['innovations', 'ranges', 'inner', 'correlation', 'nis'])
    assert.match(begun[name], /no reading so far/, name)
  assert.match(begun.errors, /nothing is driven yet/)
  const reckoned = texts({ sightings: false }, 400)
  assert.equal(Object.values(reckoned).filter((text) => text.includes('switch the ranges on')).length, 1)
  assert.doesNotMatch(reckoned.errors, /no truth|driven/)
  assert.equal(texts({ sightings: false }, 400, LOG.replace(/^G.*\n/gm, '')).errors, '', 'no error without a truth')
})

test('the claimed 2 σ of dead reckoning stays in its panel', async () => {
  const spec = await WIDGETS['robot-log']()
  const { document } = parseHTML('<!doctype html><html><body></body></html>')
  const orders = {
    play: nothing,
    step: nothing,
    reset: nothing,
    speed: nothing,
    change: nothing,
    grow: nothing,
    link: nothing,
    embed: nothing,
    download: nothing,
  }
  const {
    panels: { errors },
  } = buildShell(document, spec, document.createElement('div'), orders, estimate.RobotLog.parameters())
  const { draw } = spec.panels.find(({ name }) => name === 'errors')
  for (const params of [{ sightings: false }, { sightings: true, learn: true }]) {
    const lab = estimate.RobotLog.from(estimate.RobotLog.parse(LOG), {
      version: 1,
      lab: 'robot-log',
      params,
      step: 4000,
    })
    draw(errors, lab.frame(), /** @type {any} */ ({}))
    // One stroke: its first point, and from each point the way to the next.
    const ways = errors.svg
      .querySelector('path.curve')
      .getAttribute('d')
      .match(/-?(\d+\.?\d*|\.\d+)/g)
      .map(Number)
      .filter((_, i) => i % 2 === 1)
    const heights = ways.map((_, i) => ways.slice(0, i + 1).reduce((sum, way) => sum + way))
    assert.ok(
      heights.length > 20 && Math.min(...heights) >= 26 && Math.max(...heights) <= 212,
      `${heights.length} points from ${Math.min(...heights)} to ${Math.max(...heights)}`,
    )
  }
})
