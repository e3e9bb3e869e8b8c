/** What a frame says in sentences. Every sentence is a function of the frame. */

import { fixed, power } from '../../draw/numbers.js'
import { counted, decimalsOf, seconds, steps, sumsOf } from './names.js'
import { endIsOpen, limitIsOpen, observed, wouldDecide } from './undecided.js'

/** @typedef {import('estimate-wasm').OwnFrame} Frame */

/** @param {Frame} frame */
export function verdict(frame) {
  const sentences = [asks, lost, seen, dies, reached, limit, wouldDecide, stability].map((say) => say(frame))
  return sentences.filter(Boolean).join(' ')
}

/** @param {Frame} frame */
function asks({ looksLikeRates }) {
  return looksLikeRates
    ? 'F is taken as what one step does, and looks like one of a differential equation: tick “Continuous time” if ' +
        'it is.'
    : ''
}

/** @param {Frame} frame */
function lost({ conditioned }) {
  return conditioned
    ? ''
    : 'The filter’s numbers have lost their digits: P of the start, V and W lie too many powers of ten apart.'
}

/** @param {Frame} frame */
function seen(frame) {
  const { rank, badlyScaled, params, tolerance } = frame
  const [n, observable] = [params.states, observed(frame)]
  if (rank.rank === n && observable === 'no')
    return 'Not observable: the rank is full only because rounding errors exceed so small a tolerance.'
  if (rank.rank === n)
    return observable === 'yes'
      ? 'Observable: the readings tell every direction of the state.'
      : 'The rank is full, but whether the system is observable is undecided within the tolerance of ' +
          `${power(tolerance)}.`
  if (observable === 'yes')
    return (
      'Observable in units that fit each state; in the units given, the singular values lie too ' +
      'far apart for the rank to say so.'
    )
  const hidden = sumsOf(rank.directions, params)
  if (badlyScaled)
    return (
      `Badly scaled: F and H as written are observable, but the numbers through which ${hidden} ` +
      `${rank.directions.length > 1 ? 'are' : 'is'} read are so small beside others that rounding may hide them.`
    )
  return observable === 'no'
    ? `Not observable: ${hidden} ${rank.directions.length > 1 ? 'are' : 'is'} never seen.`
    : `${upper(hidden)} ${rank.directions.length > 1 ? 'count' : 'counts'} as unseen: less is read ` +
        `of it than the tolerance of ${power(tolerance)}, so whether the system is observable is ` +
        'undecided.'
}

/** A modulus that differs from 1 by less is 1 up to rounding. */
const ON_CIRCLE = 1e-12

/** @param {Frame} frame */
function dies({ observable, detectable, unseenModes, tolerance }) {
  if (observable === 'yes') return ''
  // On the circle, up to rounding, nothing dies out.
  const slow = unseenModes.length > 0 && unseenModes.every(({ re, im }) => Math.hypot(re, im) < 1 - ON_CIRCLE)
  if (detectable === 'no' && slow)
    return (
      'Counts as not detectable: what is not seen dies out so slowly that the tolerance of ' +
      `${power(tolerance)} does not tell it from what stays.`
    )
  return {
    yes: 'Detectable: what is not seen dies out by itself.',
    no: 'Not detectable: what is not seen does not die out.',
    undecided: 'Whether it is detectable is undecided within the tolerance.',
  }[detectable]
}

/** @param {Frame} frame */
function reached({ noise, params }) {
  if (noise.reachable === 'yes') return 'Noise reaches every state.'
  if (noise.reachable === 'undecided') return 'Whether noise reaches every state is undecided within the tolerance.'
  if (noise.unreached.length === params.states) return 'There is no noise in the motion.'
  return `Noise never moves ${sumsOf(noise.unreached, params)}.`
}

/** As far as doubled steps go. */
const FURTHEST = 2 ** 50

/** Whether single steps or doubled ones came to a limit, and none is only as far as they went. @param {Frame} frame */
const arrives = ({ doubled }) => doubled.converged && doubled.steps < 0.99 * FURTHEST

/**
 * Whether a reading without noise lets a small start lead elsewhere: noise reaches what does not die out, but a filter
 * that trusts the reading wholly does not lose all its errors. @param {Frame} frame
 */
const trusting = ({ limit: kind, noise }) => kind === 'from-large-start' && noise.stabilizable === 'yes'

/** Whether the variance falls as that of an average does. @param {Frame} frame */
const averages = (frame) =>
  frame.limit === 'from-large-start' && (frame.noise.reachable === 'no' || trusting(frame)) && frame.doubled.averages

/** Whether it falls to 0 and is never there. @param {Frame} frame */
const vanishes = (frame) => averages(frame) && Boolean(frame.limitP?.every((row) => row.every((entry) => entry === 0)))

/** Whether a step of the filter has no answer though its covariance is bounded. @param {Frame} frame */
const breaks = ({ settled, tried, doubled, detectable }) =>
  settled === null && tried === null && !doubled.converged && detectable === 'yes'

/** When the filter’s covariance settles, in a few words. @param {Frame} frame */
export function settles(frame) {
  const { settled, tried, doubled, limit: kind } = frame
  if (breaks(frame)) return 'a step has no answer'
  if (limitIsOpen(frame)) return 'undecided'
  if (settled !== null && kind === 'none') return `no change after ${settled}`
  if (frame.slowly || frame.near === null) {
    if (vanishes(frame)) return 'falls towards 0'
    if (frame.slowly || averages(frame)) return 'falls as an average'
  }
  if (frame.near !== null && kind !== 'none') return `in ${stepsTo(frame.near)}`
  if (settled !== null) return `in ${settled} steps`
  if (arrives(frame)) return `in about ${steps(doubled.steps)} steps`
  if (doubled.converged) return `in more than ${steps(FURTHEST)} steps`
  if (doubled.grows) return 'never'
  if (doubled.part) return 'a part falls as an average'
  return tried === null ? 'never' : `not in ${tried}`
}

/** A number of steps. @param {number} count */
const stepsTo = (count) => `${counted(count)} ${count === 1 ? 'step' : 'steps'}`

/** What of noise lets a small start lead elsewhere. @param {Frame} frame */
const unreached = ({ noise }) =>
  noise.stabilizable === 'no'
    ? 'noise does not reach all that does not die out'
    : 'whether noise reaches all that does not die out is undecided'

/** Of which covariance it speaks: beside another gain the plots show that of another. @param {Frame} frame */
function limit(frame) {
  const words = limitOf(frame)
  if (frame.params.gain === 'filter') return words
  return words.replace(/^The covariance|(?<=^Whether )the covariance/, (it) =>
    it.replace('covariance', 'filter’s covariance'),
  )
}

/** @param {Frame} frame */
function limitOf(frame) {
  const { settled, tried, doubled, params } = frame
  // What noise feeds and no reading tells grows, whatever noise does not reach beside it.
  const kind = frame.limit === 'depends-on-start' && doubled.grows ? 'none' : frame.limit
  if (breaks(frame))
    return (
      'Whether the covariance has a limit is not said: from this start a step has no answer, because a reading ' +
      'without noise tells nothing new, or because a number grows too large.'
    )
  if (kind === 'none' && settled === null && doubled.converged)
    return (
      'Whether the covariance has a limit is undecided: something unseen dies out within the tolerance, if at all, ' +
      `and from this start the covariance comes to rest in ${arrives(frame) ? 'about' : 'more than'} ` +
      `${steps(Math.min(doubled.steps, FURTHEST))} steps.`
    )
  if (vanishes(frame))
    return frame.slowly || frame.near === null
      ? 'The covariance tends to 0 from every start, and ever more slowly: no noise moves the state, so each reading ' +
          'counts for ever.'
      : 'The covariance tends to 0 from every start: no noise moves the state, so each reading counts for ever. ' +
          `From this start, which knows what does not die out, 1 % is left after ${stepsTo(frame.near)}.`
  const lasts = (/** @type {number} */ count) => (params.period > 0 ? `, ${seconds(count * params.period)}` : '')
  const another = doubled.dependsOnStart ? '; a larger start leads to another limit' : ''
  // A sum that loses what a weakly read state adds comes to rest early: that says nothing.
  const run = limitIsOpen(frame)
    ? ''
    : settled !== null && kind === 'none'
      ? ` From this start it grows too slowly to show: after ${settled} steps no digit changes.`
      : frame.near !== null && !frame.slowly && kind !== 'none'
        ? ` From this start it settles in ${stepsTo(frame.near)}${lasts(frame.near)}${another}.`
        : trusting(frame) && (averages(frame) || frame.slowly)
          ? ' From this start it goes on falling, and ever more slowly, as the variance of an average.'
          : averages(frame) || (frame.slowly && kind !== 'none')
            ? ' From this start it goes on falling as the variance of an average: where no noise is, each reading ' +
              'counts.'
            : doubled.converged && !arrives(frame)
              ? ` From this start it takes more than ${steps(FURTHEST)} steps.`
              : doubled.converged
                ? ` From this start it settles in about ${steps(doubled.steps)} steps${lasts(doubled.steps)}${another}.`
                : doubled.part
                  ? ` ${kind === 'none' ? 'Another part' : 'From this start a part'} of it goes on falling as the ` +
                    'variance of an average: where no noise is, each reading counts.'
                  : tried === null
                    ? ' From this start it outgrows every number.'
                    : ` From this start it has not settled after ${tried} steps.`
  return (
    {
      'from-every-start':
        'The covariance tends to one limit from every start, because the system is detectable and ' +
        'noise reaches all that does not die out.',
      'from-large-start': trusting(frame)
        ? 'The covariance tends to a limit from every large enough start, because the system is detectable; ' +
          'a reading has no noise, and a filter that trusts it wholly need not lose its other errors, ' +
          'so a smaller start may lead elsewhere.'
        : 'The covariance tends to a limit from every large enough start, because the system is ' +
          `detectable; ${unreached(frame)}; so a smaller start may lead elsewhere, and the filter may in the end ` +
          'stop correcting what noise does not reach.',
      none:
        'The covariance has no limit: something unseen does not die out, and noise feeds it, so its ' +
        'variance grows without end.',
      'depends-on-start':
        'Whether the covariance has a limit may depend on the start: something unseen does not die out, and noise ' +
        'does not reach all of that.',
      undecided: 'Whether the covariance has a limit is undecided within the tolerance.',
    }[kind] + run
  )
}

/** @param {Frame} frame */
function stability(frame) {
  const words = underGain(frame)
  return frame.diverged ? `The simulated run has left every bound and stands still. ${words}` : words
}

/** @param {Frame} frame */
function underGain(frame) {
  const { params, placed, spectralRadius, movable, eigenvalues, badlyScaled } = frame
  const decimals = decimalsOf(eigenvalues, 3)
  if (placed === false) return 'No gain was found that puts the eigenvalues there, so the gain is 0.'
  if (params.gain === 'filter' && averages(frame))
    return (
      'The filter’s gain tends to one that leaves eigenvalues on the unit circle: the error falls as that of ' +
      'an average, and by no factor in each step.'
    )
  // A gain that has no limit yet is that of the last step.
  const falling = frame.doubled.part && !frame.doubled.gainConverged && frame.tried !== null
  const last = falling ? ` after ${frame.tried} steps, a part of which goes on falling,` : ''
  const filters = `With the filter’s gain${last}`
  const who = { filter: filters, hand: 'With this gain', placement: 'With the gain that places them' }[params.gain]
  const stuck = eigenvalues.length - movable
  const fixedOnes =
    stuck === 0
      ? ''
      : badlyScaled
        ? ` ${stuck === 1 ? 'One of them counts' : `${stuck} of them count`} as out of reach of every gain.`
        : ` ${stuck === 1 ? 'One of them stays' : `${stuck} of them stay`} where ` +
          `${stuck === 1 ? 'it is' : 'they are'} whatever the gain.`
  // What is computed as a little less than 1 need not be less.
  const forEver = endIsOpen(frame, 0)
    ? ', and whether an error dies out is undecided'
    : spectralRadius < 1 - ON_CIRCLE
      ? ''
      : ', so an error need not die out'
  const reach = `the eigenvalues of the error’s matrix reach the modulus ${fixed(spectralRadius, decimals)}`
  return `${who} ${reach}${forEver}.${fixedOnes}`
}

/** @param {Frame} frame */
export function describe(frame) {
  const { eigenvalues, rank, tolerance, truth, estimate, params, R, P } = frame
  const i = shownState(params)
  const roots = rootsOf(eigenvalues)
  return {
    disc: `Unit disc: the eigenvalues of the error’s matrix are ${roots.join(', ')}.`,
    ranks:
      'Singular values of the observability matrix, over the largest: ' +
      `${rank.relative.map((value) => power(value)).join(', ')}; the tolerance is ` +
      `${power(tolerance)}, the rank ${rank.rank} of ${params.states}.`,
    run:
      `A simulated run at step ${frame.step}: state ${i + 1} is ${fixed(truth[i], 2)}, its ` +
      `estimate ${fixed(estimate[i], 2)} ± ${fixed(2 * Math.sqrt(Math.max(0, P[i][i])), 2)}.`,
    gain:
      `The filter’s gain for state ${i + 1}: ` +
      `${R ? R[i].map((value) => fixed(value, 3)).join(', ') : 'none before the first step'}.`,
    variance: `Variances over time, now ${P.map((row, j) => fixed(row[j], 3)).join(', ')}.`,
  }
}

/** Eigenvalues, with the digits that tell them apart. @param {Frame['eigenvalues']} eigenvalues */
export function rootsOf(eigenvalues) {
  const decimals = decimalsOf(eigenvalues, 3)
  return eigenvalues.map(({ re, im }) => {
    const beside = `${im < 0 ? '−' : '+'} ${fixed(Math.abs(im), decimals)} i`
    return im === 0 ? fixed(re, decimals) : `${fixed(re, decimals)} ${beside}`
  })
}

/** The state in the plots. @param {any} params */
export function shownState({ shown, states }) {
  return Math.min(shown, states) - 1
}

/** @param {string} words */
function upper(words) {
  return words.charAt(0).toUpperCase() + words.slice(1)
}
