/**
 * The odometry hook: a lap of the corridor on encoders with a biased wheel. The error outruns the ellipse; fixes from
 * mapped corners hold the position, and the heading shows what the model still does not know.
 */

import { fixed } from '../../draw/numbers.js'
import { learned } from './bias.js'
import { drawHeading, drawPosition, drawWheel, whole } from './history.js'
import { drawMap } from './map.js'

/** @typedef {import('estimate-wasm').HookFrame} Frame */

// State: at the start of a lap. The still shows the whole lap, with the error.

/** Ticks of a lap. */
const LAP = 640
const start = { params: {}, step: 0 }

// Model: the lab `OdometryHook` in the module. What follows only reads its frame.

/** @param {number} angle */
const degrees = (angle) => (angle * 180) / Math.PI

/** @param {number} ratio */
const times = (ratio) => `${fixed(ratio, 1)} times the σ it claims`

/** An error in words: within the claim, near it, or past it. @param {string} off @param {number | null} ratio */
function against(off, ratio) {
  if (ratio === null) return `off by ${off}, and the filter claims no error at all`
  if (ratio > 0.95 && ratio < 1.05) return `off by ${off}, about the σ it claims`
  if (ratio <= 1) return `off by ${off}, within the σ it claims`
  return `off by ${off}, ${times(ratio)}`
}

/** A part of a whole. @param {number} part */
const percent = (part) => `${fixed(100 * part, 2)} %`

/** What is known of the wheel, where its bias is a state. @param {Frame} frame */
function ofTheWheel({ wheel, params }) {
  if (!wheel) return ''
  const { bias, sigma } = learned(wheel.epsilon, wheel.sigma)
  const stands = `${percent(bias)}, with a σ of ${percent(sigma)}`
  if (wheel.rank === 0)
    return params.fixes
      ? ` No reading yet: the bias is taken as ${stands}.`
      : ` No reading is used, so the bias stays at ${stands}.`
  if (wheel.rank < 4)
    return ` The readings so far fix ${wheel.rank} of 4 numbers (their rank): they do not tell the bias from the pose.`
  return ` The bias is learned as ${stands}; in truth it is ${percent(params.bias)}.`
}

/** @param {Frame} frame */
const verdict = (frame) => `${ofThePose(frame)}${ofTheWheel(frame)}`

/** @param {Frame} frame */
function ofThePose(frame) {
  const { error, ratio, params, step, lastSighting } = frame
  if (step === 0) return 'At the start the pose is known exactly.'
  const heading = `The heading is ${against(`${fixed(Math.abs(degrees(error.heading)), 1)}°`, ratio.heading)}.`
  const position = `position is ${against(`${fixed(error.position, 2)} m`, ratio.position)}`
  if (!params.fixes) {
    const outrun =
      error.position > 0.005 && (ratio.position ?? Infinity) > 2 ? ': the error has outrun the ellipse' : ''
    return `Dead reckoning: the ${position}${outrun}. ${heading}`
  }
  if (!lastSighting) return `No corner seen yet: the ${position}. ${heading}`
  return `With fixes, the ${position}. ${heading}`
}

/** @param {number} ticks */
const ago = (ticks) => (ticks === 0 ? 'in this tick' : ticks === 1 ? 'one tick ago' : `${ticks} ticks ago`)

/** @param {Frame} frame */
function describe(frame) {
  const { error, sigma, params, step, lap } = frame
  const track = params.fixes ? 'the estimate corrected by mapped corners' : 'the dead-reckoned track'
  const seen = frame.lastSighting
    ? ` Corner ${frame.lastSighting.landmark + 1} was seen last, ${ago(step - frame.lastSighting.step)}.`
    : ''
  const turn = (/** @type {number} */ angle) => `${fixed(Math.abs(degrees(angle)), 1)} degrees`
  const wheel = frame.wheel && learned(frame.wheel.epsilon, frame.wheel.sigma)
  return {
    map:
      `Map of the corridor’s loop at tick ${step}, ${lap === 1 ? 'one whole lap' : `${lap} whole laps`} driven: ` +
      `the true track and ${track}, ${fixed(error.position, 2)} metres apart now, ` +
      `with an ellipse of semi-axes ${fixed(frame.ellipse.semiMajor, 2)} and ${fixed(frame.ellipse.semiMinor, 2)} ` +
      `metres.${seen}`,
    position:
      `Position error over time, now ${fixed(error.position, 2)} metres against a claimed σ of ` +
      `${fixed(sigma.position, 2)}.`,
    heading: `Heading error over time, now ${turn(error.heading)} against a claimed σ of ${turn(sigma.heading)}.`,
    wheel: wheel
      ? `Learned bias of the right wheel over time, now ${percent(wheel.bias)} with a claimed σ of ` +
        `${percent(wheel.sigma)}; in truth ${percent(params.bias)}.`
      : '',
  }
}

/** @param {Frame} frame @param {Frame} before */
function announce(frame, before) {
  return `${frame.step === before.step ? '' : `Tick ${frame.step}: `}${verdict(frame)}`
}

// View: the map and the two errors against what is claimed, in the folder's files, and what is said beside them.

/** @param {Frame} frame @returns {import('../../figure/shell.js').Readout[]} */
function readouts({ step, error, sigma, ratio, wheel }) {
  // As the plots have it, an error is a size.
  const angle = (/** @type {number} */ value) => fixed(Math.abs(degrees(value)), 1)
  const known = wheel && learned(wheel.epsilon, wheel.sigma)
  return [
    {
      key: 'position',
      label: 'Position error',
      value: fixed(error.position, 2),
      unit: 'm',
      kin: 'truth',
      headline: true,
    },
    { key: 'position-sigma', label: '*σ* of the position', value: fixed(sigma.position, 2), unit: 'm' },
    { key: 'heading', label: 'Heading error', value: angle(error.heading), unit: '°', kin: 'truth' },
    { key: 'heading-sigma', label: '*σ* of the heading', value: angle(sigma.heading), unit: '°' },
    { key: 'position-ratio', label: 'position: error / *σ*', value: fixed(ratio.position, 1) },
    { key: 'heading-ratio', label: 'heading: error / *σ*', value: fixed(ratio.heading, 1) },
    { key: 'step', label: 'Tick', value: String(step) },
    {
      key: 'wheel',
      label: 'Learned bias',
      value: fixed(known && 100 * known.bias, 2),
      unit: '%',
      kin: 'posterior',
      shown: Boolean(wheel),
      row: true,
    },
    {
      key: 'wheel-sigma',
      label: '*σ* of the bias',
      value: fixed(known && 100 * known.sigma, 2),
      unit: '%',
      shown: Boolean(wheel),
    },
    {
      key: 'rank',
      label: 'Directions that the readings show',
      value: `${wheel?.rank ?? 0} of 4`,
      shown: Boolean(wheel),
    },
  ]
}

// Controls.

/** @type {import('../../figure/controls.js').Control[]} */
const controls = [
  { kind: 'range', name: 'bias', label: 'Wheel-radius bias', words: (value) => `${fixed(value * 100, 2)} %` },
  { kind: 'range', name: 'slip', label: 'Slip per wheel and tick', words: (value) => `${fixed(value * 1000, 1)} mm` },
  { kind: 'toggle', name: 'fixes', label: 'landmark fixes' },
  { kind: 'toggle', name: 'learn', label: 'learn the wheel’s bias' },
]

/**
 * A lap of the usual wheel on encoders alone, but for what is said.
 * @param {Record<string, unknown>} [but]
 * @returns {import('../../figure/spec.js').Try['change']}
 */
const lap = (but) => () => ({ bias: 0.005, slip: 0.001, fixes: false, learn: false, step: LAP, ...but })

/** @type {import('../../figure/spec.js').Try[]} */
const tries = [
  // What is set stays set: only the way is shortened.
  { name: 'lap', label: 'Show the whole lap', change: () => ({ step: LAP }) },
  { name: 'honest', label: 'Give the wheels no bias', change: lap({ bias: 0 }) },
  { name: 'fixes', label: 'Correct by the corners', change: lap({ fixes: true }) },
  { name: 'learn', label: 'Learn the wheel', change: lap({ fixes: true, learn: true }) },
]

/**
 * Two plots are as high as the map, and so are three: what stands below stays where it is when the third comes.
 * @param {Frame} frame
 */
const tall = ({ wheel }) => (wheel ? 410 / 3 : 205)

/** @type {import('../../figure/spec.js').Widget} */
export const figure = {
  start,
  still: LAP,
  invite: 'Drive one lap',
  lap: LAP,
  whole,
  seeded: true,
  pace: 40,
  stride: 10,
  panels: [
    { name: 'map', width: 590, height: 430, draw: drawMap },
    { name: 'position', width: 350, height: tall, handles: true, draw: drawPosition },
    { name: 'heading', width: 350, height: tall, handles: true, draw: drawHeading },
    { name: 'wheel', width: 350, height: tall, handles: true, draw: drawWheel, shown: ({ wheel }) => Boolean(wheel) },
  ],
  layout: {
    // The plots move the robot on the map, which stays in sight; the switches change the plots, and stand right above
    // the wheel's, which one of them brings, and the heading's, which tells most of them.
    narrow: ['map', 'tries', 'controls', 'wheel', 'heading', 'position', 'verdict', 'readouts'],
    along: 'tries',
    medium: ['map position', 'map heading', 'map wheel', 'verdict verdict'],
    columns: { medium: '59fr 41fr', wide: '62fr 38fr' },
  },
  tries,
  describe,
  controls,
  readouts,
  verdict,
  announce,
  series: (frame) => frame.series,
}
