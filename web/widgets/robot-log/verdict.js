/** The verdict on a log in words: which fault the readings tell, how large it is, and what mends it. */

import { fixed, metres } from '../../draw/numbers.js'
import { antennaSentence, ofAStep } from './antenna.js'
import {
  DILUTED,
  odometrySentence,
  byNoise,
  lengthsSentence,
  turnScaleSentence,
  unequalSentence,
  wheelsSentence,
} from './driven.js'
import { HIDDEN, bridged, cutsFirst } from './gaps.js'
import { MIRRORED_BEARINGS, mirroredSentence } from './mirrored.js'
import { NEAR, named } from './named.js'
import { asMean, asMotion, late, lateSentence } from './late.js'
import { READINGS, alike, noisy, wandering } from './noise.js'
import { off as offset, scaleSentence } from './scales.js'
import { blind, hides, sigmaSentence, withoutOutliers } from './sigmas.js'
import { biased, displaced, exchanged } from './misplaced.js'
import { besideSet, brief, claimed, digits, ownStep, plusMinus } from './sized.js'
import { startSentence } from './start.js'

/** @typedef {import('estimate-wasm').LogJudgement} LogJudgement */
/** @typedef {import('estimate-wasm').LogSuspect} Suspect */
/** @typedef {Suspect['sizes'][number]} Size */
/** @typedef {import('./looks.js').Log} Log */

const DEGREES = 180 / Math.PI

/**
 * @param {LogJudgement} judgement
 * @param {{ rows: number, truth: boolean, log?: Log | null }} drive
 */
export function ranked(judgement, { rows, truth, log = null }) {
  const { suspects, readings, ungated, other } = judgement
  const [first] = suspects
  const own = suspects.filter(({ own, standing }) => own && standing === 'cleared')
  const sound = first.standing === 'cleared'
  if (!sound && cutsFirst(judgement.gaps)) return [...judgement.gaps.map(bridged), HIDDEN].join(' ')
  const parts = [
    ...(sound ? [] : judgement.gaps.map(bridged)),
    ungated ? 'The gate refuses more than one reading in ten, which hides a fault: it is off for this verdict.' : '',
    sound
      ? `No fault: of the ${suspects.length} that were looked for, none makes the ${count(readings)} readings ` +
        `likelier than chance does${own.length > 0 ? ', but for what may be the motion model’s own' : ''}.` +
        (log?.motion === 'odometry' && !suspects.some(({ fault }) => fault === 'odometry') ? UNSOUGHT : '')
      : alike(judgement) || (other ? foreign(judgement, truth, log) : sentences(judgement, truth, log)),
    ...own.map((suspect) => model(suspect, judgement)),
    sound ? arcs(judgement) : '',
    // A σ that has taken in a fault of the motion lets the start turn towards it.
    sound || judgement.suspects[0].fault === 'start' ? loose(judgement) : '',
    sound ? blind(judgement.suspects) : '',
    sound ? delayed(judgement) : '',
    sound ? noisy(judgement) : '',
    errors(judgement),
    judgement.rows < rows ? `The first ${count(judgement.rows)} rows are judged.` : '',
  ]
  return parts.filter(Boolean).join(' ')
}

/** What brings more than this has bent what else was found. */
const LARGE = 30
/** Headings alone do not tell it. */
const UNSOUGHT = ' A scale of odometry’s distances is not among them.'

/** @param {LogJudgement} judgement @param {boolean} truth @param {Log | null} log */
function sentences(judgement, truth, log) {
  const { suspects, beside, pace, thinning } = judgement
  const [, ...others] = suspects
  const [first, rival] = named(judgement, log)
  const told = (/** @type {Suspect} */ suspect) => {
    // What may be no fault is not to be set.
    if (suspect.own && suspect.fault === 'clock') return `${late(suspect)}. ${inPart(suspect, judgement)}`
    const part = suspect.name === 'sigmaDistance' ? hides(suspect.sizes[0].value, pace) : inPart(suspect, judgement)
    const more = part || (log?.motion === 'velocity' ? asMean(suspect, judgement) : '')
    return [sentence(suspect, truth, log), more, truth ? '' : asMotion(suspect, suspects)].filter(Boolean).join(' ')
  }
  // A larger σ explains any error of the model, and with it this one gains less than the page's own sum shows.
  const gain = beside
    ? `Even with a σ so large that it allows for the other errors, the log-likelihood rises by ${rise(first.gain)}.`
    : `The log-likelihood rises by ${rise(first.gain)}.`
  const more = others.some(({ standing }) => standing !== 'cleared') || first.gain > LARGE
  const next = more ? ` What else is wrong shows once this is mended${bent(first)}.` : ''
  if (thinning) return `Either: ${wandering(thinning)} Or: ${told(first)} The readings do not tell which.`
  if (first.standing === 'sure') return `${told(first)} ${gain}${next}`
  if (rival) return `Either: ${told(first)} Or: ${told(rival)} The readings do not tell which.`
  if (first.excess < NEAR) return `Perhaps: ${told(first)} Chance explains it nearly as well.`
  return `Perhaps: ${told(first)}${first.own && first.fault === 'clock' ? '' : ` ${gain}`}`
}

/** The ± of a size is of one fault alone. @param {Suspect} suspect */
const bent = ({ sizes }) =>
  sizes.some(({ sigma, end }) => sigma !== null && !end) ? ', and may bend this size by more than its ±' : ''

/**
 * What is wrong is none of the suspects by itself.
 * @param {LogJudgement} judgement @param {boolean} truth @param {Log | null} log
 */
function foreign({ suspects, ungated, against }, truth, log) {
  const [first] = suspects
  const sigmas = first.fault === 'sigma' && suspects.some((one) => one !== first && one.fault === 'sigma')
  const most = sigmas
    ? `Several σ may be wrong together: none of the ${suspects.length} faults that were looked for mends all by itself.`
    : `Something is wrong that none of the ${suspects.length} faults that were looked for mends by itself.`
  if (!first.mended || !against) return most
  const likely = `${most} The likeliest is this: ${sentence(first, truth, log)}`
  if (sigmas) return likely
  const from = `${metres(first.mended.rmse)} m from the truth, where it is ${metres(against.rmse)} m from it now`
  const gate = ungated ? ' without the gate' : ''
  return `${likely} Mended so, the estimate would be ${from}${gate} (RMS): another fault may hide behind it.`
}

/** A delay that the motion model’s own explains. @param {Suspect} suspect @param {LogJudgement} judgement */
function model(suspect, judgement) {
  const [size] = suspect.sizes
  const off = size.value - size.now
  const step = ownStep(judgement)
  const said =
    Math.abs(off) > judgement.ownDelay ? `, which makes the readings no likelier than ${step}` : `: less than ${step}`
  return (
    `${late(suspect)}${said}. ` +
    'That may be the motion model’s own, which holds what it reads for a step, drives it straight and turns then.'
  )
}

/**
 * What of a fault the motion model may have as its own: of a delay of a step or two, of one that is told as well, and
 * of a turned camera.
 * @param {Suspect} suspect @param {LogJudgement} judgement
 */
function inPart({ fault, own, name, sizes, dilution }, judgement) {
  const { period, ownDelay, halfTurn } = judgement
  if (fault === 'antenna') return ofAStep(sizes, judgement)
  const [size] = sizes
  if (name === 'bearingOffset' && size.sigma !== null && Math.abs(halfTurn) > size.sigma / 2)
    return `${fixed(halfTurn * DEGREES, 2)}° of that may be the motion model’s own, half of the turn of a step.`
  if (fault !== 'clock') return own ? DILUTED : byNoise(dilution)
  if (ownDelay === 0) return ''
  const step = ownStep({ period, ownDelay })
  if (Math.abs(size.value - size.now) > 2 * period)
    return size.sigma !== null && size.sigma < period / 2
      ? `It may be ${step}, longer or shorter: that is the motion model’s own.`
      : ''
  const all = Math.abs(size.value - size.now) <= ownDelay
  const part = `${all ? `All of it, less than ${step},` : `Of it ${step},`} may be the motion model’s own`
  if (own && all) return `${part}: it may be no fault.`
  return own ? `${part}, and chance explains what is left nearly as well: it may be no fault.` : `${part}.`
}

/** What a robot that turns on its way would bring. @param {LogJudgement} judgement */
function arcs({ arcs: gain, period }) {
  if (gain === null) return ''
  return (
    `The filter drives each step straight and turns then: with rows of motion ${brief(period)} s apart this costs ` +
    `${rise(gain)} of the log-likelihood. That is the motion model’s own, and no fault of the log.`
  )
}

/** A σ of the distance, as it is set, that may have taken in what is wrong. @param {LogJudgement} judgement */
function loose({ suspects, pace }) {
  const distance = suspects.find(({ name }) => name === 'sigmaDistance')
  const said = distance ? hides(distance.sizes[0].now, pace) : ''
  return said && `The σ of the distance is set to ${claimed(distance?.sizes[0].now ?? 0)} m/√s. ${said}`
}

/** A delay that is set, of which a part may be the motion model’s own. @param {LogJudgement} judgement */
const delayed = ({ suspects, period, ownDelay }) =>
  ownDelay > 0 && suspects.some(({ fault, sizes }) => fault === 'clock' && sizes.some(({ now }) => now !== 0))
    ? `A delay is set. It may be ${ownStep({ period, ownDelay })}, longer or shorter: that is the motion model’s own.`
    : ''

/** A share beyond the ellipse that a sound filter does not have. */
const MANY = 0.15
const TRUTH =
  'That is more than chance: a σ may have taken in a fault that was not looked for, or the truth is off, by its ' +
  'origin, its axes, its clock or its own errors.'
const HELD = 'The errors are no larger than what the motion model has as its own, which holds what it reads for a step.'

/** @param {LogJudgement} judgement */
function errors({ suspects: [first], against, ungated, other, pace, ownDelay }) {
  if (!against) return ''
  const { rmse, nees, outside } = against
  const mended = first.standing === 'cleared' ? null : first.mended
  const off = ungated ? ', without the gate,' : ''
  const now =
    `Against the truth${off} the NEES of the position is ${fixed(nees, 1)}, where 2 is expected, and ` +
    `${fixed(100 * outside, 0)} % of the errors lie beyond the ellipse that should hold 95 %.`
  if (!mended && outside > MANY) return `${now} ${rmse <= pace * ownDelay ? HELD : TRUTH}`
  if (!mended || other) return now
  const [before, after] = [rmse, mended.rmse].map((one) => metres(one))
  const goes =
    before === after ? `stays ${after} m and the NEES goes` : `goes from ${before} to ${after} m and the NEES`
  return `${now} Mended so, the RMS error${off} ${goes} to ${fixed(mended.nees, 1)}.`
}

/** @param {number} gain */
const rise = (gain) => (gain < 1000 ? fixed(gain, 1) : count(Math.round(gain)))

/** What is wrong, and what to do. @param {Suspect} suspect @param {boolean} truth @param {Log | null} [log] */
export function sentence(suspect, truth, log = null) {
  const { fault, name, sensor, sizes, landmarks } = suspect
  if (fault === 'odometry') return odometrySentence(sizes, log, suspect.own)
  if (fault === 'exchanged') return exchanged(landmarks ?? [], log)
  if (fault === 'displaced') return displaced(landmarks ?? [], sizes, log)
  if (fault === 'landmark-bias') return biased(landmarks ?? [], sizes, log)
  if (fault === 'turn-scale') return turnScaleSentence(sizes, log)
  if (fault === 'lengths') return lengthsSentence(sizes)
  if (fault === 'wheel-size') return wheelsSentence(sizes)
  if (fault === 'unequal-wheels') return unequalSentence(sizes, log)
  if (fault === 'antenna') return antennaSentence(suspect)
  if (fault === 'mirrored') return mirroredSentence(log)
  if (fault === 'mirrored-bearings') return MIRRORED_BEARINGS
  const [size, second] = sizes
  const off = size.value - size.now
  if (fault === 'start') return startSentence(sizes, truth)
  if (fault === 'tails') {
    const rows = READINGS[sensor ?? 'fix']
    // A handful are counted: that they are there is sure, and their share is not.
    const few = size.sigma !== null && size.value < 2 * size.sigma
    const share = few ? `About ${digits(size, 100)}` : plusMinus(size, 100)
    const others = name && second ? ` ${withoutOutliers(name, second)}` : ''
    return `${share} % of the ${rows} are outliers: switch their gate on, which refuses them.${others}`
  }
  if (fault === 'clock') return lateSentence(suspect)
  if (fault === 'sigma') return sigmaSentence(suspect)
  const much = { ...size, value: Math.abs(off) }
  // Half a turn is no end: it goes on at the other side.
  const turned = { ...size, value: off, sigma: size.end ? null : size.sigma, end: false }
  if (name === 'bearingOffset')
    return (
      `The camera is turned by ${plusMinus(turned, DEGREES)}°${besideSet(size)}: ` +
      `set the offset of its bearings to ${digits(size, DEGREES)}°.`
    )
  if (name === 'headingOffset')
    return (
      `The compass reads ${plusMinus({ ...turned, value: Math.abs(off) }, DEGREES)}° too far ` +
      `${off > 0 ? 'counter-clockwise' : 'clockwise'}${besideSet(size)}: ` +
      `set the offset of the headings, counted counter-clockwise, to ${digits(size, DEGREES)}°.`
    )
  if (name === 'turnBias')
    return (
      `The turn rate reads ${plusMinus(much)} rad/s too ${off > 0 ? 'much' : 'little'}: ` +
      'let the filter learn its bias.'
    )
  if (fault === 'scale') return scaleSentence(suspect)
  return `The ranges read ${offset(size)}: set their offset to ${digits(size)} m.`
}

/** @param {number} number */
const count = (number) => number.toLocaleString('en')
