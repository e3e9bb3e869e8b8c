// How the words of a figure are held against its frames: every sentence of a verdict is one of its claims, and each
// claim is held against the frame that the sentence speaks of, over a grid of parameters and steps, just-reset states
// among them.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { readFileSync } from 'node:fs'
import { createRequire } from 'node:module'
import { plain } from '../../web/draw/words.js'
import { WIDGETS } from '../../web/widgets/index.js'

export const estimate = createRequire(import.meta.url)('../../target/pkg/node/estimate_wasm.js')
export const LOG = readFileSync(new URL('../../content/logs/plaza1.csv', import.meta.url), 'utf8')
export const number = (text) => Number(text.replace('\u2212', '-').replace('∞', 'Infinity'))
/** Whether a printed number is this value, rounded. */
export const prints = (text, value) =>
  Math.abs(number(text) - value) <= 0.51 * 10 ** -(text.split('.')[1]?.length ?? 0) + 1e-9 * Math.abs(value)

/**
 * The specification of a figure.
 * @param {string} name
 * @returns {Promise<Required<import('../../web/figure/spec.js').FigureSpec>>} with all that its test reads of it
 */
export const widget = (name) => /** @type {any} */ (WIDGETS[name]())

/** A pattern of these parts, for a sentence that is longer than a line. @param {RegExp[]} parts */
export const pattern = (...parts) => new RegExp(parts.map(({ source }) => source).join(''))

/** Every choice of one value for each name. @returns {Record<string, unknown>[]} */
function grid(axes) {
  return Object.entries(axes).reduce(
    (all, [name, values]) => all.flatMap((one) => values.map((value) => ({ ...one, [name]: value }))),
    [{}],
  )
}

/** The frames of a widget's lab over a grid. */
function* frames(spec, axes, steps) {
  for (const params of grid(axes)) {
    const lab = estimate[spec.lab].from({ version: 1, lab: spec.name, step: 0, params })
    for (const step of steps) {
      if (step > lab.state().step) lab.run(step - lab.state().step)
      yield lab.frame()
    }
    lab.free()
  }
}

/** Sentences: a full stop within a number ends none. */
export const sentences = (text) => text.split(/(?<=\.)\s+/)

/** What a sentence does not have; more digits than anybody reads among it. */
const NO_SENTENCE = pattern(
  /undefined|NaN|null|[a-z]'[a-z]|\[object|(?<![.\d])\d{5}|\.\d{6}| {2}|/,
  /\b1 (steps|ticks|laps|directions)\b/,
)

/** Says what of a widget's words is false of its frames. */
function falsehoods(spec, all, claims) {
  const found = new Set()
  for (const frame of all) {
    const where = `${JSON.stringify(frame.params)} at step ${frame.step}`
    const words = plain(spec.verdict(frame))
    for (const sentence of sentences(words)) {
      const claim = claims.filter(([pattern]) => pattern.test(sentence))
      if (claim.length !== 1) found.add(`“${sentence}” is none of the claims, or several; ${where}`)
      else if (!claim[0][1](frame, ...sentence.match(claim[0][0]).slice(1)))
        found.add(`“${sentence}” is false; ${where}`)
    }
    const others = [
      ...Object.values(spec.describe(frame)),
      spec.announce(frame, frame),
      spec.announce(frame, { ...frame, step: frame.step + 1 }),
    ]
    for (const said of [words, ...others]) {
      if (NO_SENTENCE.test(said)) found.add(`“${said}” is no sentence; ${where}`)
    }
  }
  return [...found].slice(0, 12)
}

export const check = (tag, axes, steps, claims) =>
  test(`what the ${tag} says is true, in every state`, async () => {
    const spec = await widget(tag)
    const all = [...frames(spec, axes, steps)]
    assert.ok(all.length > 60)
    assert.deepEqual(falsehoods(spec, all, claims(spec)), [])
  })
