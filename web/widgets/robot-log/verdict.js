/** The verdict on a log in words: which fault the readings tell, how large it is, and what mends it. */

import { fixed } from '../../draw/numbers.js'

/** @typedef {import('estimate-wasm').LogJudgement} LogJudgement */
/** @typedef {import('estimate-wasm').LogSuspect} Suspect */
/** @typedef {Suspect['sizes'][number]} Size */

/** A suspect this near to the first, in log-likelihood, is named beside it. */
const NEAR = 3
/** A mended filter whose error grows by more than this ratio is not mended. */
const WORSE = 1.05
const DEGREES = 180 / Math.PI

/** What the rows of a sensor are called. */
const READINGS = { fix: 'positions', heading: 'headings', range: 'ranges', bearing: 'ranges with a bearing' }
/** @type {Record<string, [string, string]>} what comes late, and its verb */
const DELAYED = {
  delaySpeed: ['speed', 'comes'],
  delayFix: ['positions', 'come'],
  delayHeading: ['headings', 'come'],
  delaySighting: ['ranges', 'come'],
}
/** @type {Record<string, [string, string]>} whose σ it is, and its unit */
const SIGMAS = {
  sigmaDistance: ['the distance driven', 'm/√s'],
  sigmaTurn: ['the turn', 'rad/√s'],
  sigmaFix: ['a position', 'm'],
  sigmaHeading: ['a heading', 'rad'],
  sigmaRange: ['a range', 'm'],
  sigmaBearing: ['a bearing', 'rad'],
}

/**
 * @param {LogJudgement} judgement
 * @param {{ rows: number, truth: boolean }} log
 */
export function ranked(judgement, { rows, truth }) {
  const { suspects, readings, against, ungated } = judgement
  const [first] = suspects
  const parts = [
    ungated ? 'The gate refuses more than one reading in ten, which hides a fault: it is off for this verdict.' : '',
    first.standing === 'cleared'
      ? `No fault: of the ${suspects.length} that were looked for, none makes the ${count(readings)} readings ` +
        'likelier than chance does.'
      : named(judgement, truth),
    against ? errors(first, against) : '',
    judgement.rows < rows ? `The first ${count(judgement.rows)} rows are judged.` : '',
  ]
  return parts.filter((part) => part !== '').join(' ')
}

/** @param {LogJudgement} judgement @param {boolean} truth */
function named({ suspects: [first, ...others], beside }, truth) {
  const rise = first.gain < 1000 ? fixed(first.gain, 1) : count(Math.round(first.gain))
  // A larger σ explains any error of the model, and with it this one gains less than the page's own sum shows.
  const gain = beside
    ? `Even with a σ so large that it allows for the other errors, the log-likelihood rises by ${rise}.`
    : `The log-likelihood rises by ${rise}.`
  const more = others.some(({ standing }) => standing !== 'cleared')
  const next = more ? ' What else is wrong shows once this is mended.' : ''
  if (first.standing === 'sure') return `${sentence(first, truth)} ${gain}${next}`
  const rivals = others.filter(({ standing, excess }) => standing !== 'cleared' && excess > first.excess - NEAR)
  const [rival] = rivals
  if (rival) return `Either: ${sentence(first, truth)} Or: ${sentence(rival, truth)} The readings do not tell which.`
  if (first.excess < NEAR) return `Perhaps: ${sentence(first, truth)} Chance explains it nearly as well.`
  return `Perhaps: ${sentence(first, truth)} ${gain}`
}

/** @param {Suspect} first @param {NonNullable<LogJudgement['against']>} against */
function errors({ mended }, { rmse, nees, outside }) {
  const now =
    `Against the truth the NEES of the position is ${fixed(nees, 1)}, where 2 is expected, and ` +
    `${fixed(100 * outside, 0)} % of the errors lie beyond the ellipse that should hold 95 %.`
  if (!mended) return now
  const after = `from ${fixed(rmse, 2)} to ${fixed(mended.rmse, 2)} m`
  if (mended.rmse > WORSE * rmse) return `${now} Mended so, the error would grow ${after}: something else is wrong.`
  return `${now} Mended so, the RMS error goes ${after} and the NEES to ${fixed(mended.nees, 1)}.`
}

/** What is wrong, and what to do. @param {Suspect} suspect @param {boolean} truth */
export function sentence(suspect, truth) {
  const { fault, name, sensor, sizes } = suspect
  const [size] = sizes
  const { now, value } = size
  const off = value - now
  if (fault === 'start') return start(sizes, truth)
  if (fault === 'tails') {
    const rows = READINGS[sensor ?? 'fix']
    return `${plusMinus(size, 100)} % of the ${rows} are outliers: switch their gate on, which refuses them.`
  }
  if (fault === 'clock') {
    const [what, verb] = DELAYED[name ?? '']
    const late = off > 0 ? 'later' : 'earlier'
    const claim = now === 0 ? (off > 0 ? 'late' : 'early') : `${late} than set`
    return (
      `The ${what} ${verb} ${plusMinus({ ...size, value: Math.abs(off) })} s ${claim}: ` +
      `set the delay to ${digits(size)} s.`
    )
  }
  if (fault === 'sigma') {
    const [whose, unit] = SIGMAS[name ?? '']
    return (
      `The σ of ${whose} is ${plusMinus(size)} ${unit}, and is claimed as ${claimed(now)}: ` +
      `set it ${off > 0 ? 'higher' : 'lower'}.`
    )
  }
  const much = { ...size, value: Math.abs(off) }
  if (name === 'bearingOffset')
    return (
      `The camera is turned by ${plusMinus({ ...size, value: off }, DEGREES)}°: ` +
      `set the offset of its bearings to ${digits(size)} rad.`
    )
  if (name === 'turnBias')
    return (
      `The turn rate reads ${plusMinus(much)} rad/s too ${off > 0 ? 'much' : 'little'}: ` +
      'let the filter learn its bias.'
    )
  if (name === 'offset')
    return `The ranges read ${plusMinus(much)} m too ${length(off)}: set their offset to ${digits(size)} m.`
  if (name === 'speedScale')
    return `The speed reads ${plusMinus(much, 100)} % too ${off > 0 ? 'low' : 'high'}: let the filter learn its scale.`
  return `The ranges read ${plusMinus(much, 100)} % too ${length(off)}: set their scale to ${digits(size, 100)} %.`
}

/** @param {Size[]} sizes @param {boolean} truth */
function start([x, y, theta], truth) {
  const far = Math.hypot(x.value - x.now, y.value - y.now)
  const by = theta.value - theta.now
  const turned = Math.abs(Math.atan2(Math.sin(by), Math.cos(by))) * DEGREES
  const where = `${fixed(far, 2)} m beside, and turned by ${fixed(turned, 0)}°`
  if (truth) return `The robot did not start at the first true pose, but ${where}: mend that row of the truth.`
  return (
    `The robot did not start where the filter does, but ${where}: ` +
    `set the start to ${digits(x)} m, ${digits(y)} m and ${digits(theta, DEGREES)}°.`
  )
}

/** @param {number} off */
const length = (off) => (off > 0 ? 'long' : 'short')

/** @param {number} number */
const count = (number) => number.toLocaleString('en')

/** So many decimals that the uncertainty has two digits. @param {Size} size @param {number} times */
function decimals({ value, sigma }, times) {
  const told = (sigma || Math.abs(value) || 1) * times
  return Math.max(0, Math.min(6, 1 - Math.floor(Math.log10(told))))
}

/** @param {Size} size @param {number} [times] */
const digits = (size, times = 1) => fixed(size.value * times, decimals(size, times))

/** @param {Size} size @param {number} [times] */
function plusMinus(size, times = 1) {
  const value = digits(size, times)
  return size.sigma === null ? `about ${value}` : `${value} ± ${fixed(size.sigma * times, decimals(size, times))}`
}

/** A σ as it is set. @param {number} value */
const claimed = (value) => String(Number(value.toPrecision(3)))
