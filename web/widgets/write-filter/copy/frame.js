/** What a copy stands on: the program’s lines, what the world gives it, and the steps that are its test. */

import { Refusal, all } from './node.js'
import { sized } from './sized.js'

/** @typedef {import('estimate-wasm').Program} Program */
/** @typedef {import('estimate-wasm').Vector} Vector */
/** @typedef {number[][]} Rows */

/**
 * A world as a copy’s test has it: the system, the belief before the first step, and step by step the input, the
 * reading, and where they are another in each step the landmark and the reading’s covariance.
 * @typedef {{
 *   system: { V: Rows, W: Rows, F?: Rows, G?: Rows, H?: Rows, gate?: number },
 *   belief: { x: number[], P: Rows },
 *   steps: { u: number[], y: number[], landmark?: number[], W?: Rows }[],
 * }} World
 */

/**
 * `constants` are given once, `varying` in each step; a step has their values, and the expected estimate and covariance
 * last. `ended` is why there are fewer than ten, where that is so.
 * @typedef {{
 *   lines: import('./sized.js').Line[], given: string[], x: string, P: string, start: [Rows, Rows],
 *   constants: [string, Rows][], varying: string[], steps: Rows[][], text: string[], ended: string,
 * }} Frame
 */

/** The steps of a test. */
const STEPS = 10
/** Two runs are equal that differ by no more than this part of the largest entry, or of 1 where that is less. */
export const TOLERANCE = 1e-9

const column = (/** @type {ArrayLike<number>} */ list) => Array.from(list, (x) => [x])
const rows = (/** @type {ArrayLike<ArrayLike<number>>} */ m) => Array.from(m, (row) => Array.from(row))

/**
 * @param {Program} program without faults @param {string} text what it was read from @param {World} world
 * @returns {Frame}
 */
export function frameOf(program, text, { system, belief, steps }) {
  const { x, P, u, y, V, W, F, G, H } = program.letters
  const robot = system.F === undefined
  const n = belief.x.length
  const [{ u: input, y: reading }] = steps
  const sizes = /** @type {[number, number, number]} */ ([n, reading.length, input.length])
  const lines = sized(treeOf(program, sizes), sizes)
  const used = new Set(lines.flatMap(({ name, value }) => [name, ...[...all(value)].map((it) => it.name)]))
  const several = steps.some((step) => step.W)
  /** What is given, in the order in which the world gives it. @type {[string, Rows | null][]} */
  const given = [
    [u, null],
    [y, null],
    [V, system.V],
    [W, several ? null : system.W],
  ]
  if (robot) given.push(['l', null], ['gate', [[system.gate ?? 1e12]]])
  else given.push([F, rows(system.F ?? [])], [G, rows(system.G ?? [])], [H, rows(system.H ?? [])])
  const taken = given.filter(([name]) => used.has(name))
  const values = taken.filter(([, value]) => value === null).map(([name]) => name)

  let { x: at, P: covariance } = /** @type {{ x: ArrayLike<number>, P: ArrayLike<ArrayLike<number>> }} */ (belief)
  /** @type {Rows[][]} */
  const done = []
  let ended = ''
  for (const step of steps.slice(0, STEPS)) {
    const noise = step.W ?? system.W
    const stage = robot
      ? { V: system.V, W: noise, gate: system.gate, landmark: step.landmark }
      : { ...system, W: noise }
    const before = { x: Array.from(at), P: rows(covariance) }
    /** @type {import('estimate-wasm').ProgramStep} */
    let after
    try {
      after = program.step(/** @type {any} */ (stage), before, step.u, step.y)
    } catch (error) {
      // The steps before the one that has no value are a test still.
      ended = /** @type {Error} */ (error).message
      if (done.length > 0) break
      throw new Refusal(ended)
    }
    ;({ x: at, P: covariance } = after)
    /** @type {Record<string, Rows>} */
    const all = { [u]: column(step.u), [y]: column(step.y), [W]: noise, l: column(step.landmark ?? []) }
    done.push([...values.map((name) => all[name]), column(at), rows(covariance)])
  }
  return {
    lines,
    given: taken.map(([name]) => name),
    x,
    P,
    start: [column(belief.x), belief.P],
    constants: taken.flatMap(([name, value]) => (value ? [/** @type {[string, Rows]} */ ([name, value])] : [])),
    varying: values,
    steps: done,
    ended,
    // What a language could take for the end of a comment’s line is left out.
    text: text.split('\n').map((line) => line.replace(/[\p{C}\p{Zl}\p{Zp}]/gu, ' ').trim()),
  }
}

/**
 * A program without faults may be for other sizes than its world has.
 * @param {Program} program @param {[number, number, number]} sizes n, p and m
 */
function treeOf(program, sizes) {
  try {
    return program.tree(sizes)
  } catch (error) {
    throw new Refusal(/** @type {Error} */ (error).message)
  }
}

/**
 * What a program of a language begins with, in comments.
 * @param {string} sign @param {Frame} frame @param {string} how it is run
 */
export function head(sign, { steps, ended }, how) {
  const count = steps.length === 1 ? 'step' : `${steps.length} steps`
  const lines = [
    'A step of a filter, written out from lines of formulas of the book Robot Motion, the chapter Kalman Filtering.',
    `MIT or Apache-2.0. ${how}`,
    `Its test is the first ${count} of its world: x and P are the book’s up to 1e-9 of the largest entry, or of 1.`,
    ...(ended ? [`The world ends there: ${ended}.`] : []),
  ]
  return lines.map((line) => `${sign} ${line.replace(/\s*\n\s*/g, ' ').replace(/\.+$/, '.')}\n`).join('')
}

/** What a row of the test’s steps has. @param {string[]} varying */
export const ofEachStep = (varying) => `Of each step ${[...varying, 'the expected x and P'].join(', ')}.`

/**
 * Names as a language can have them: letters and digits, none of them taken by the language or by a function.
 * @param {string[]} names @param {string[]} reserved @param {Record<string, unknown>} helpers
 * @returns {Map<string, string>}
 */
export function identifiers(names, reserved, helpers) {
  const taken = new Set([...reserved, ...Object.keys(helpers)])
  const given = new Map()
  for (const name of names) {
    if (given.has(name)) continue
    const plain = name
      .normalize('NFD')
      .replace(/\u0303/g, '_tilde')
      .replace(/\u0304/g, '_bar')
      .replace(/⁻/g, '_prior')
      .replace(/⁺/g, '_post')
      .replace(/[₀-₉]/g, (digit) => String(Number(digit.codePointAt(0)) - 0x2080))
      .replace(/[^A-Za-z0-9_]/g, (letter) => `u${letter.codePointAt(0)?.toString(16)}`)
      .replace(/^_/, 'u_')
    let free = plain
    while (taken.has(free)) free += '_'
    taken.add(free)
    given.set(name, free)
  }
  return given
}

/**
 * The reader’s lines of text that end before a line of the program, as far as they are comments.
 * @param {Frame} frame @param {number} i
 */
export function remarks({ lines, text }, i) {
  const from = lines[i - 1]?.lines[1] ?? 0
  return text.slice(from, lines[i].lines[0] - 1).flatMap((line) => /^(?:#|%|\/\/)\s*(.*)$/.exec(line)?.[1] ?? [])
}

/** A line as the reader wrote it, with what is remarked behind it. @param {Frame} frame @param {number} i */
export function source({ lines, text }, i) {
  const whole = text.slice(lines[i].lines[0] - 1, lines[i].lines[1]).join(' ')
  const [formula, remark] = [/^[^#%]*?(?=#|%|\/\/|$)/.exec(whole)?.[0], /(?:#|%|\/\/)\s*(.*)$/.exec(whole)?.[1]]
  return { formula: formula?.trim() ?? '', remark: remark?.trim() ?? '' }
}
