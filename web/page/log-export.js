/** What a reader has tuned on a log as a starting configuration of robot_localization’s extended filter. */

/** @typedef {import('estimate-wasm').LogContents} LogContents */
/** @typedef {import('estimate-wasm').LogFrame} Frame */

/** The order of robot_localization’s state. */
const STATE = 'x y z roll pitch yaw vx vy vz vroll vpitch vyaw ax ay az'.split(' ')
/** Its own defaults of the process noise of speeds and accelerations, which a log does not tell. */
const USUAL = { vx: 0.025, vy: 0.025, vz: 0.04, vroll: 0.01, vpitch: 0.01, vyaw: 0.02, ax: 0.01, ay: 0.01, az: 0.015 }
export const SENSORS = /** @type {const} */ (['fix', 'heading', 'range', 'bearing'])

/** @param {Frame['params']['gate']} gate @param {'fix' | 'heading' | 'range' | 'bearing'} sensor */
export const gateOf = (gate, sensor) => (gate !== null && typeof gate === 'object' ? (gate[sensor] ?? null) : gate)
/** @param {Frame['params']['every']} every @param {'fix' | 'heading' | 'range' | 'bearing'} sensor */
export const everyOf = (every, sensor) => (typeof every === 'object' ? (every[sensor] ?? 0) : every)
/** How far a number that is written may lie from what was computed: rounding has made the digits beyond. */
const WITHIN = 1e-12
/** The shortest number that is as near to one as that, in its own size where it is small. @param {number} x */
function shortest(x) {
  const near = (/** @type {number} */ one) => Math.abs(one - x) <= WITHIN * Math.min(1, Math.abs(x))
  for (let digits = 1; digits <= 16; digits += 1) {
    const one = Number(x.toPrecision(digits))
    if (near(one)) return one
  }
  return x
}
/** A number as a float of YAML’s and of Python’s, with all its digits. @param {number} x */
export const exact = (x) =>
  Number.isInteger(x) && Math.abs(x) < 1e15 ? x.toFixed(1) : String(x).replace(/^(-?\d+)e/, '$1.0e')
/** The same with the digits that matter. @param {number} x */
export const float = (x) => exact(shortest(x))
/** @param {string[]} names that are measured */
const config = (names) => list(STATE.map((name) => String(names.includes(name))))
/** Five rows of three, as the package’s own examples have them. @param {string[]} all */
const list = (all) => `[${[0, 3, 6, 9, 12].map((at) => all.slice(at, at + 3).join(', ')).join(`,\n${' '.repeat(12)}`)}]`

/** What was learned is fixed in an export. @param {Frame} frame */
export function fixed({ params, summary }) {
  const { learn, learnSpeed, learnBias } = params
  return {
    scale: (learn ? summary.epsilon : null) ?? params.scale,
    speedScale: (learnSpeed ? summary.speedScale : null) ?? params.speedScale,
    turnBias: (learnBias ? summary.turnBias : null) ?? params.turnBias,
  }
}

/** What a factor on the readings’ own σ does to their covariance. @param {unknown} own @param {number} factor */
const scaled = (own, factor) =>
  own && factor !== 1
    ? [`  where it has one: that covariance times ${float(Number((factor ** 2).toPrecision(6)))};`]
    : []

/** What the page reads otherwise than the files have it. @param {LogContents} contents */
function corrected({ corrections, motion }) {
  const { driven, swerve = 0 } = corrections
  const [far, much] = driven
  const speeds = motion === 'velocity' && far !== 1
  const rates = motion === 'velocity' && much !== 1
  const ways = motion === 'odometry' && (far !== 1 || much !== 1)
  return [
    ...(speeds ? [`Multiply speeds by ${float(far)} before they are published.`] : []),
    ...(rates ? [`Multiply turn rates by ${float(much)} before they are published.`] : []),
    ...(ways
      ? [`Multiply distances of odometry by ${float(far)} and turns by ${float(much)} before they are published.`]
      : []),
    ...(swerve !== 0
      ? [`Then add ${float(swerve)} times its metres to each turn of the wheels, and as much to its rate, rad.`]
      : []),
  ]
}

/** Where the antenna of the fixes stands. @param {Frame} frame @param {LogContents} contents */
function antenna({ params: { fixes, antennaAhead: ahead, antennaLeft: left } }, { readings }) {
  if (!readings.fix || !fixes || (ahead === 0 && left === 0)) return []
  return [
    `The antenna stands ${float(ahead)} m ahead of base_link and ${float(left)} m to its left: publish the transform`,
    'from base_link to its frame, by which navsat_transform_node takes that off each fix.',
  ]
}

/** What no setting of a program of others says, in sentences. @param {Frame} frame @param {LogContents} contents */
function left(frame, contents) {
  const { params } = frame
  const { fix, heading } = contents.readings
  const { speedScale, turnBias } = fixed(frame)
  const late = [
    ['speeds', params.delaySpeed, contents.motion === 'velocity'],
    ['turn rates', params.delayTurn, contents.motion === 'velocity'],
    ['fixes', params.delayFix, fix],
    ['headings', params.delayHeading, heading],
  ].filter(([, delay, there]) => there && delay !== 0)
  return [
    'A measurement’s covariance comes with each message, not from this file:',
    ...(fix && params.fixes
      ? [
          `  fixes: ${float(params.sigmaFix ** 2)} m² for x and for y, where a fix has no σ of its own;`,
          ...scaled(contents.own.fix, params.fixSigmaScale),
        ]
      : []),
    ...(heading && params.headings
      ? [
          `  headings: ${float(params.sigmaHeading ** 2)} rad² for yaw, where a heading has no σ of its own;`,
          ...scaled(contents.own.heading, params.headingSigmaScale),
        ]
      : []),
    '  speeds and turn rates: little, as 1e-4; what they miss is in the process noise below.',
    ...late.map(([name, delay]) => `Stamp ${name} ${float(Number(delay))} s earlier: nothing here takes a delay.`),
    ...(speedScale !== 0 ? [`Multiply speeds by ${float(1 + speedScale)} before they are published.`] : []),
    ...(turnBias !== 0 ? [`Take ${float(turnBias)} rad/s off each turn rate before it is published.`] : []),
    ...(heading && params.headings && params.headingOffset !== 0
      ? [`Take ${float(params.headingOffset)} rad off each heading before it is published.`]
      : []),
    ...(SENSORS.some((sensor) => everyOf(params.every, sensor) > 0)
      ? ['Readings that the page passed over for coming too soon are not thinned out here.']
      : []),
    ...(heading && params.headings && gateOf(params.gate, 'heading') !== null
      ? ['The gate of the headings is left out: set pose1_rejection_threshold by hand.']
      : []),
    ...antenna(frame, contents),
    'A covariance below is a diagonal of 15 numbers, which robot_localization reads since May 2022: an older one wants',
    'all 225 of the matrix.',
    ...(contents.truth
      ? ['The page’s filter starts at the first true pose of the log: write that into initial_state, which has zeros.']
      : []),
    ...corrected(contents),
    ...(contents.landmarks.length > 0 ? ['robot_localization takes no ranges to landmarks: they are left out.'] : []),
  ]
}

/** @param {number} history seconds */
const late = (history) => `        # Readings that are late belong before others that were taken already.
        smooth_lagged_data: true
        history_length: ${float(Math.ceil(history + 1))}
`
/** χ² of two numbers has a quantile in closed form. @param {number} gate */
const gated = (gate) => `        # The Mahalanobis distance within which ${float(100 * gate)} % of right fixes lie.
        pose0_rejection_threshold: ${float(Math.sqrt(-2 * Math.log(1 - gate)))}
`

/**
 * A starting configuration of robot_localization’s ekf_node, for ROS 2.
 * @param {Frame} frame @param {LogContents} contents
 */
export function robotLocalization(frame, contents) {
  const { params } = frame
  const { fix, heading } = contents.readings
  const [along, turn] = [params.sigmaDistance ** 2, params.sigmaTurn ** 2]
  /** @type {Record<string, number>} */
  const process = { x: along, y: along, z: 1e-9, roll: 1e-9, pitch: 1e-9, yaw: turn, ...USUAL }
  const [place, way] = [params.startSigma ** 2, params.startSigmaHeading ** 2]
  /** @type {Record<string, number>} */
  const initial = { x: place, y: place, yaw: way, vx: 1, vyaw: 1 }
  const [x, y, yaw] = params.start ?? [0, 0, 0]
  /** @type {Record<string, number>} */
  const start = { x, y, yaw }
  const numbers = (/** @type {Record<string, number>} */ of, /** @type {number} */ other) =>
    list(STATE.map((name) => float(of[name] ?? other)))
  const fixGate = gateOf(params.gate, 'fix')
  const delays = [params.delaySpeed, params.delayTurn, params.delayFix, params.delayHeading]
  const history = Math.max(0, ...delays.map(Math.abs))
  return `# A start for robot_localization’s ekf_node, from what was tuned on a log on a page of the book Robot Motion.
# Topics and frames are examples. MIT or Apache-2.0.
${left(frame, contents)
  .map((line) => `# ${line}\n`)
  .join('')}ekf_filter_node:
    ros__parameters:
        frequency: 30.0
        two_d_mode: true
        publish_tf: true
        map_frame: map
        odom_frame: odom
        base_link_frame: base_link
        world_frame: ${fix || heading ? 'map' : 'odom'}
${history > 0 ? late(history) : ''}
        # Speed and turn rate.
        twist0: wheel/twist
        twist0_config: ${config(['vx', 'vyaw'])}
${
  fix && params.fixes
    ? `
        # Fixes of the position.
        pose0: fix/pose
        pose0_config: ${config(['x', 'y'])}
        pose0_differential: false
${fixGate === null ? '' : gated(fixGate)}`
    : ''
}${
  heading && params.headings
    ? `
        # Headings.
        pose1: heading/pose
        pose1_config: ${config(['yaw'])}
        pose1_differential: false
`
    : ''
}
        # Diagonals; the process noise is that of a second. That of x and y is σ_d² both along the heading and across,
        # where the page’s filter has it along the heading alone; that of speeds is the package’s own.
        process_noise_covariance: ${numbers(process, 1e-9)}
        initial_estimate_covariance: ${numbers(initial, 1e-9)}
        initial_state: ${numbers(start, 0)}
`
}
