/** The numbers that the filter is told of a log: their words, how far their sliders go, and what they are set to. */

import { fixed } from '../draw/numbers.js'

const DEGREE = Math.PI / 180
/** @param {number} from @param {number} to decimal logarithms */
const powers = (from, to) => ({ ends: /** @type {[number, number]} */ ([from, to]), step: 0.02, log: true })
const LATE = { ends: /** @type {[number, number]} */ ([-1.5, 1.5]), step: 0.01 }
/**
 * A number of the filter: its name, its words, how far its slider goes, and what one of its units is in the lab's.
 * @typedef {[string, string, import('./log-slider.js').Scale, number?]} Told
 */
/** @type {Told} */
const SIGMA_RANGE = ['sigmaRange', 'σ of a range, m', powers(-2, 1.5)]
/** What ranges have besides, with or without a bearing. @type {Told[]} */
const RANGED = [
  ['scale', 'scale ε', { ends: [-0.2, 0.2], step: 0.001 }],
  ['offset', 'offset, m', { ends: [-5, 5], step: 0.05 }],
]

/** What is told of the σ that readings bring themselves. */
const OWN = 'factor on own σ'
const TIMES = powers(-1.5, 1.5)

/**
 * The sensors of readings, by their names in the summary.
 * @type {{ name: string, words: string, on: string, numbers: Told[] }[]}
 */
export const SENSORS = [
  {
    name: 'fix',
    words: 'positions',
    on: 'fixes',
    numbers: [
      ['sigmaFix', 'σ, m', powers(-2, 2)],
      ['fixSigmaScale', OWN, TIMES],
      ['delayFix', 'delay, s', LATE],
      ['antennaAhead', 'antenna ahead, m', { ends: [-5, 5], step: 0.05 }],
      ['antennaLeft', 'antenna to the left, m', { ends: [-5, 5], step: 0.05 }],
    ],
  },
  {
    name: 'heading',
    words: 'headings',
    on: 'headings',
    numbers: [
      ['sigmaHeading', 'σ, rad', powers(-3, 0.5)],
      ['headingSigmaScale', OWN, TIMES],
      ['headingOffset', 'offset, °', { ends: [-180, 180], step: 0.5 }, DEGREE],
      ['delayHeading', 'delay, s', LATE],
    ],
  },
  {
    name: 'range',
    words: 'ranges',
    on: 'sightings',
    numbers: [SIGMA_RANGE, ['delaySighting', 'delay, s', LATE], ...RANGED],
  },
  {
    name: 'bearing',
    words: 'ranges with bearings',
    on: 'sightings',
    numbers: [
      SIGMA_RANGE,
      ['sigmaBearing', 'σ of a bearing, rad', powers(-3, 0)],
      ['bearingOffset', 'offset of the bearings, °', { ends: [-15, 15], step: 0.1 }, DEGREE],
      ['delaySighting', 'delay, s', LATE],
      ...RANGED,
    ],
  },
]
/** What is known of the motion. @type {Told[]} */
export const MOTION = [
  ['sigmaDistance', 'σ of the distance, m/√s', powers(-3, 0.5)],
  ['sigmaTurn', 'σ of the turn, rad/√s', powers(-4, 0.5)],
]
/** Of motion that is held from row to row. @type {Told[]} */
export const HELD = [
  ['delaySpeed', 'delay of the speed, s', LATE],
  ['delayTurn', 'delay of the turn rate, s', LATE],
]
export const GATES = [null, 0.95, 0.99, 0.999]

/**
 * What a setting is that is no number of one sensor.
 * @type {Record<string, string>}
 */
const OTHERS = {
  fixes: 'whether positions are used',
  headings: 'whether headings are used',
  sightings: 'whether ranges are used',
  gate: 'gates',
  every: 'least gaps in time',
  learn: 'learn the scale ε',
  learnSpeed: 'learn the scale of the speed',
  learnBias: 'learn the bias of the turn rate',
  speedScale: 'scale of the speed',
  turnBias: 'bias of the turn rate',
}

/** A setting in words. @param {string} name */
export function settingWords(name) {
  const sensor = SENSORS.find(({ numbers }) => numbers.some((told) => told[0] === name))
  const told = [...(sensor?.numbers ?? []), ...MOTION, ...HELD].find((one) => one[0] === name)
  const words = told ? told[1].replace(/, [^,]+$/, '') : (OTHERS[name] ?? name)
  return sensor ? `${words} of ${sensor.words}` : words
}

/**
 * From where to where a setting may be, in a field's unit; null where that is not known.
 * @param {import('estimate-wasm').Parameter[]} parameters @param {string} name @param {number} [unit]
 * @returns {[number, number] | null}
 */
export function boundsOf(parameters, name, unit = 1) {
  const known = parameters.find((one) => one.name === name)
  return known ? [known.least / unit, known.greatest / unit] : null
}

/** A value for each sensor, of one for all or of some. @param {any} value @returns {Record<string, any>} */
export function bySensor(value) {
  if (value !== null && typeof value === 'object') return value
  return Object.fromEntries(SENSORS.map(({ name }) => [name, value]))
}

/**
 * Of which reading of held motion a setting is.
 * @type {Record<string, import('estimate-wasm').LogContents['lacks']>}
 */
const OF_HELD = { delaySpeed: 'speed', learnSpeed: 'speed', delayTurn: 'turn rate', learnBias: 'turn rate' }

/**
 * Whose σ a number is of, and whether it is a factor on what the readings bring.
 * @type {Record<string, ['fix' | 'heading', boolean]>}
 */
const SAID = {
  sigmaFix: ['fix', false],
  fixSigmaScale: ['fix', true],
  sigmaHeading: ['heading', false],
  headingSigmaScale: ['heading', true],
}

/**
 * Whether a number does anything to a log: a σ does nothing where each reading brings its own, nor does the factor on
 * their own where none does.
 * @param {import('estimate-wasm').LogContents} contents @param {string} name
 */
export function acts({ own, readings, motion, lacks }, name) {
  const held = OF_HELD[name]
  if (held) return motion === 'velocity' && lacks !== held
  const [sensor, factor] = SAID[name] ?? []
  if (!sensor) return true
  return factor ? Boolean(own[sensor]) : own[sensor]?.count !== readings[sensor]
}

/**
 * Every number of a log that can be told apart from the others, with whose it is.
 * @param {import('estimate-wasm').LogContents} contents
 * @returns {{ words: string, told: Told }[]}
 */
export function numbersOf(contents) {
  const { readings } = contents
  const has = SENSORS.filter(({ name }) => readings[/** @type {'fix'} */ (name)])
  const all = has.flatMap(({ words, numbers }) => numbers.map((told) => ({ words: `${words}: ${told[1]}`, told })))
  all.push(...[...MOTION, ...HELD].map((told) => ({ words: told[1], told })))
  const first = (/** @type {string} */ name) => all.findIndex(({ told }) => told[0] === name)
  return all.filter(({ told: [name] }, i) => first(name) === i && acts(contents, name))
}

/**
 * What is said where readings bring a σ of their own: the setting is for the others.
 * @param {import('estimate-wasm').LogContents | null} contents @param {string} name of a setting
 */
export function ownSigma(contents, name) {
  const sensor = name === 'sigmaFix' ? 'fix' : name === 'sigmaHeading' ? 'heading' : null
  const own = sensor && contents?.own[sensor]
  if (!own) return ''
  const [least, most] = own.sigmas.map((sigma) => String(Number(sigma.toPrecision(3))))
  const unit = sensor === 'fix' ? 'm' : 'rad'
  const sigmas = least === most ? `${least} ${unit}` : `${least} to ${most} ${unit}`
  const all = contents?.readings[sensor] ?? 0
  if (own.count === all) return `each brings its own: ${sigmas}`
  return `${own.count.toLocaleString('en')} of ${all.toLocaleString('en')} bring their own: ${sigmas}`
}

/**
 * What is said beside the factor on the σ that readings bring.
 * @param {import('estimate-wasm').LogContents} contents @param {string} name of a setting
 */
export function ownFactor(contents, name) {
  const [sensor, factor] = SAID[name] ?? []
  if (!sensor || !factor) return ''
  const own = ownSigma(contents, sensor === 'fix' ? 'sigmaFix' : 'sigmaHeading')
  const start = sensor === 'fix' && startsAt(contents) ? ' With it goes the σ of a start at the first fix.' : ''
  const others = own.startsWith('each') ? '' : ' The others have the σ above.'
  return `σ: ${own}. The filter takes it times this factor.${others}${start}`
}

/** Whether the σ of the start is a fix’s own. @param {import('estimate-wasm').LogContents} contents */
const startsAt = (contents) =>
  contents.opening !== null && Boolean(contents.readings.fix) && !acts(contents, 'sigmaFix')

/**
 * Where a log begins by its first fixes, whose σ has the factor that theirs have, or by its first ranges.
 * @param {import('estimate-wasm').LogContents} contents @param {number} factor
 */
export function openingOf(contents, factor) {
  const { opening } = contents
  return opening && { ...opening, startSigma: opening.startSigma * (startsAt(contents) ? factor : 1) }
}

/**
 * What the filter was told, a row for each number, for the sensors that the log has.
 * @param {import('estimate-wasm').LogFrame} frame
 * @param {import('estimate-wasm').LogContents | null} [contents]
 * @returns {[string, string][]}
 */
export function settingsOf({ params, summary }, contents = null) {
  const { sensors } = summary
  const value = (/** @type {string} */ name) => /** @type {any} */ (params)[name]
  const digits = (/** @type {number} */ number) => String(Number(number.toPrecision(4))).replace('-', '−')
  // A number that no reading is read by was not told.
  const wording = (/** @type {string} */ name, /** @type {string} */ number) => {
    const own = ownSigma(contents, name)
    return own.startsWith('each') ? own : own ? `${number}; ${own}` : number
  }
  const said = (/** @type {string} */ whose, /** @type {Told} */ [name, words, , unit = 1]) =>
    /** @type {[string, string]} */ ([`${whose}: ${words}`, wording(name, digits(value(name) / unit))])
  /** @type {[string, string][]} */
  const rows = []
  for (const { name, words, on, numbers } of SENSORS) {
    if (!sensors[/** @type {'fix'} */ (name)]) continue
    const gate = bySensor(params.gate)[name] ?? null
    // A factor on what no reading brings was not told either.
    const told = numbers.filter(([name]) => !SAID[name]?.[1] || (contents && acts(contents, name)))
    rows.push([`${words}: used`, value(on) ? 'yes' : 'no'], ...told.map((number) => said(words, number)))
    rows.push([`${words}: gate`, gate === null ? 'off' : `${Number((100 * gate).toPrecision(6))} %`])
    rows.push([`${words}: least gap in time, s`, digits(bySensor(params.every)[name] ?? 0)])
    if (on === 'sightings') rows.push([`${words}: learn the scale ε`, params.learn ? 'yes' : 'no'])
  }
  const moving = [...MOTION, ...HELD].filter(([name]) => !contents || acts(contents, name))
  rows.push(...moving.map((number) => said('motion', number)))
  const { speed, bias } = learnedWords(summary)
  if (params.learnSpeed) rows.push(['motion: learn the scale of the speed', `yes${speed && `: ${speed}`}`])
  if (params.learnBias) rows.push(['motion: learn the bias of the turn rate', `yes${bias && `: ${bias}`}`])
  return rows.map(([name, words]) => [`${name[0].toUpperCase()}${name.slice(1)}`, words])
}

/**
 * What a filter has learned of its motion so far: the factor of the speed and the bias of the turn rate; empty words
 * where it learns none.
 * @param {import('estimate-wasm').LogFrame['summary']} summary
 */
export function learnedWords({ speedScale, speedScaleSigma, turnBias, turnBiasSigma }) {
  return {
    speed: speedScale === null ? '' : `× ${known(1 + speedScale, speedScaleSigma, 3)}`,
    bias: turnBias === null ? '' : `${known(turnBias, turnBiasSigma, 4)} rad/s`,
  }
}

/**
 * A number and its ±, of which two digits are seen.
 * @param {number} value @param {number | null} sigma @param {number} least decimals
 */
function known(value, sigma, least) {
  const told = sigma === null || !(sigma > 0) ? least : Math.min(9, 1 - Math.floor(Math.log10(sigma)))
  const places = Math.max(least, told)
  return `${fixed(value, places)} ± ${fixed(sigma ?? NaN, places)}`
}

/** What tells where a log begins. @param {import('estimate-wasm').LogContents} contents */
export const openedBy = ({ readings }) => (readings.fix ? 'fixes' : 'ranges')
