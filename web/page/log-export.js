/**
 * What a reader has tuned on a log, for programs of others: a starting configuration of robot_localization’s extended
 * filter, and the same filter as Python on filterpy.
 */

/** @typedef {import('estimate-wasm').LogContents} LogContents */
/** @typedef {import('estimate-wasm').LogFrame} Frame */

/** The order of robot_localization’s state. */
const STATE = 'x y z roll pitch yaw vx vy vz vroll vpitch vyaw ax ay az'.split(' ')
/** Its own defaults of the process noise of speeds and accelerations, which a log does not tell. */
const USUAL = { vx: 0.025, vy: 0.025, vz: 0.04, vroll: 0.01, vpitch: 0.01, vyaw: 0.02, ax: 0.01, ay: 0.01, az: 0.015 }
const SENSORS = /** @type {const} */ (['fix', 'heading', 'range', 'bearing'])

/** @param {Frame['params']['gate']} gate @param {'fix' | 'heading' | 'range' | 'bearing'} sensor */
const gateOf = (gate, sensor) => (gate !== null && typeof gate === 'object' ? (gate[sensor] ?? null) : gate)
/** @param {Frame['params']['every']} every @param {'fix' | 'heading' | 'range' | 'bearing'} sensor */
const everyOf = (every, sensor) => (typeof every === 'object' ? (every[sensor] ?? 0) : every)
/** A number as a float of YAML’s and of Python’s. @param {number} x */
const float = (x) =>
  Number.isInteger(x) && Math.abs(x) < 1e15 ? x.toFixed(1) : String(x).replace(/^(-?\d+)e/, '$1.0e')
/** @param {string[]} names that are measured */
const config = (names) => list(STATE.map((name) => String(names.includes(name))))
/** Five rows of three, as the package’s own examples have them. @param {string[]} all */
const list = (all) => `[${[0, 3, 6, 9, 12].map((at) => all.slice(at, at + 3).join(', ')).join(`,\n${' '.repeat(12)}`)}]`

/** What was learned is fixed in an export. @param {Frame} frame */
function fixed({ params, summary }) {
  const { learn, learnSpeed, learnBias } = params
  return {
    scale: (learn ? summary.epsilon : null) ?? params.scale,
    speedScale: (learnSpeed ? summary.speedScale : null) ?? params.speedScale,
    turnBias: (learnBias ? summary.turnBias : null) ?? params.turnBias,
  }
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
      ? [`  fixes: ${float(params.sigmaFix ** 2)} m² for x and for y, where a fix has no σ of its own;`]
      : []),
    ...(heading && params.headings ? [`  headings: ${float(params.sigmaHeading ** 2)} rad² for yaw;`] : []),
    '  speeds and turn rates: little, as 1e-4; what they miss is in the process noise below.',
    ...late.map(([name, delay]) => `Stamp ${name} ${float(Number(delay))} s earlier: nothing here takes a delay.`),
    ...(speedScale !== 0 ? [`Multiply speeds by ${float(1 + speedScale)} before they are published.`] : []),
    ...(turnBias !== 0 ? [`Take ${float(turnBias)} rad/s off each turn rate before it is published.`] : []),
    ...(SENSORS.some((sensor) => everyOf(params.every, sensor) > 0)
      ? ['Readings that the page passed over for coming too soon are not thinned out here.']
      : []),
    ...(heading && params.headings && gateOf(params.gate, 'heading') !== null
      ? ['The gate of the headings is left out: set pose1_rejection_threshold by hand.']
      : []),
    ...(contents.landmarks.length > 0 ? ['robot_localization takes no ranges to landmarks: they are left out.'] : []),
  ]
}

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
${history > 0 ? `        # Readings that are late belong before others that were taken already.\n        smooth_lagged_data: true\n        history_length: ${float(Math.ceil(history + 1))}\n` : ''}
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
${fixGate === null ? '' : `        # The Mahalanobis distance within which ${float(100 * fixGate)} % of right fixes lie.\n        pose0_rejection_threshold: ${float(Math.sqrt(-2 * Math.log(1 - fixGate)))}\n`}`
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

/** A value of Python’s. @param {number | boolean | null} value */
const inPython = (value) =>
  value === null ? 'None' : typeof value === 'boolean' ? (value ? 'True' : 'False') : float(value)

/**
 * The page’s filter as Python on filterpy. It reads a log in the book’s own format.
 * @param {Frame} frame
 */
export function filterpy(frame) {
  const { params } = frame
  const { scale, speedScale, turnBias } = fixed(frame)
  const each = (/** @type {(sensor: 'fix' | 'heading' | 'range' | 'bearing') => number | boolean | null} */ of) =>
    `{${SENSORS.map((sensor) => `"${sensor}": ${inPython(of(sensor))}`).join(', ')}}`
  const { delaySpeed, delayTurn, delayFix, delayHeading, delaySighting } = params
  const delays = { speed: delaySpeed, turn: delayTurn, fix: delayFix, heading: delayHeading, range: delaySighting }
  const on = { fix: params.fixes, heading: params.headings, range: params.sightings, bearing: params.sightings }
  const learned = params.learn || params.learnSpeed || params.learnBias
  const settings = Object.entries({
    SIGMA_DISTANCE: params.sigmaDistance,
    SIGMA_TURN: params.sigmaTurn,
    SIGMA_RANGE: params.sigmaRange,
    SIGMA_BEARING: params.sigmaBearing,
    SIGMA_FIX: params.sigmaFix,
    SIGMA_HEADING: params.sigmaHeading,
    START_SIGMA: params.startSigma,
    START_SIGMA_HEADING: params.startSigmaHeading,
    SCALE: scale,
    OFFSET: params.offset,
    BEARING_OFFSET: params.bearingOffset,
    SPEED_SCALE: speedScale,
    TURN_BIAS: turnBias,
  }).map(([name, value]) => `${name} = ${float(value)}\n`)
  return `"""The filter that was tuned on a page of the book Robot Motion, on filterpy. MIT or Apache-2.0.

pip install filterpy; python3 filter.py LOG, where LOG has rows of the book's own format:
L,id,x,y landmark | G,t,x,y,theta truth | O,t,distance,turn | V,t,v,omega | S,t,v | T,t,omega | R,t,id,range
B,t,id,range,bearing | P,t,x,y[,sigma] fix | H,t,theta[,sigma]; seconds, metres, radians.
${learned ? 'What the filter learned is fixed here at what the log had taught where the page stood.\n' : ''}"""

import json
import math
import sys

import numpy as np
from filterpy.kalman import ExtendedKalmanFilter
from scipy.stats import chi2

${settings.join('')}# The pose at the start of a log without truth.
START = [${(params.start ?? [0, 0, 0]).map(float).join(', ')}]
# By sensor: whether it corrects, the probability of its gate, and the least time between two readings.
ON = ${each((sensor) => on[sensor])}
GATE = ${each((sensor) => gateOf(params.gate, sensor))}
EVERY = ${each((sensor) => everyOf(params.every, sensor))}
# How late rows are: they were measured at their stamp less this.
DELAY = {${Object.entries(delays)
    .map(([name, value]) => `"${name}": ${float(value)}`)
    .join(', ')}, "bearing": ${float(delaySighting)}}
# Fixes stamped between these two times do not correct.
WITHHELD = ${params.withheld ? `(${Array.from(params.withheld, float).join(', ')})` : 'None'}

${BODY}`
}

const BODY = `KINDS = {"P": "fix", "H": "heading", "R": "range", "B": "bearing"}


def wrap(angle):
    return math.remainder(angle, 2 * math.pi)


def read(lines):
    """Landmarks, the true start, and rows (time, is a reading, line, stamp, letter, numbers) in their order."""
    landmarks, truth, rows = {}, [], []
    for line, text in enumerate(lines):
        letter, *cells = text.strip().split(",")
        if letter == "" or letter.startswith("#"):
            continue
        numbers = [float(cell) for cell in cells if cell.strip()]
        if letter == "L":
            landmarks[int(numbers[0])] = numbers[1:]
        elif letter == "G":
            truth.append(numbers)
        elif letter == "V" and DELAY["speed"] != DELAY["turn"]:
            rows.append((numbers[0] - DELAY["speed"], False, line, numbers[0], "S", numbers[1:2]))
            rows.append((numbers[0] - DELAY["turn"], False, line, numbers[0], "T", numbers[2:3]))
        else:
            late = {"O": 0.0, "V": DELAY["speed"], "S": DELAY["speed"], "T": DELAY["turn"]}
            delay = late[letter] if letter in late else DELAY[KINDS[letter]]
            rows.append((numbers[0] - delay, letter in KINDS, line, numbers[0], letter, numbers[1:]))
    return landmarks, min(truth, default=None), sorted(rows, key=lambda row: row[:3])


class Robot(ExtendedKalmanFilter):
    """The distance and the turn of a move are its input."""

    def predict_x(self, u=0):
        theta = self.x[2]
        moved = [self.x[0] + u[0] * math.cos(theta), self.x[1] + u[0] * math.sin(theta), wrap(theta + u[1])]
        self.x = np.array(moved)

    def move(self, distance, turn, dt):
        c, s = math.cos(self.x[2]), math.sin(self.x[2])
        self.F = np.array([[1, 0, -distance * s], [0, 1, distance * c], [0, 0, 1]])
        b = np.array([[c, 0], [s, 0], [0, 1]])
        self.Q = b @ np.diag([SIGMA_DISTANCE**2, SIGMA_TURN**2]) @ b.T * dt
        self.predict((distance, turn))

    def correct(self, sensor, z, h, jacobian, r):
        """Takes a reading within its gate; the angle of a residual, its last entry, goes the short way round."""
        def residual(a, b):
            difference = a - b
            if sensor in ("heading", "bearing"):
                difference[-1] = wrap(difference[-1])
            return difference

        z, r = np.array(z), np.diag(r)
        nu, H = residual(z, h(self.x)), jacobian(self.x)
        gate = GATE[sensor]
        if gate is not None and nu @ np.linalg.solve(H @ self.P @ H.T + r, nu) > chi2.ppf(gate, len(z)):
            return
        self.update(z, jacobian, h, R=r, residual=residual)
        self.x[2] = wrap(self.x[2])


def replay(landmarks, truth, rows):
    """The robot behind the last row."""
    robot = Robot(dim_x=3, dim_z=2)
    fixes = [row for row in rows if row[4] == "P"]
    start, robot.x = (fixes or rows)[0][0], np.array(START, dtype=float)
    if truth is not None:
        start, robot.x = truth[0], np.array(truth[1:4])
    robot.P = np.diag([START_SIGMA**2, START_SIGMA**2, START_SIGMA_HEADING**2])
    by_odometry = any(row[4] == "O" for row in rows)
    before, speed, rate, last = start, 0.0, 0.0, {}
    for time, _, _, stamp, letter, numbers in rows:
        if time >= start:
            dt = max(time - before, 0.0)
            if letter == "O":
                robot.move(numbers[0], numbers[1], dt)
            elif not by_odometry:
                robot.move(speed * (1 + SPEED_SCALE) * dt, (rate - TURN_BIAS) * dt, dt)
            if letter == "O" or not by_odometry:
                before = max(before, time)
        if letter == "V":
            speed, rate = numbers
        elif letter == "S":
            speed = numbers[0]
        elif letter == "T":
            rate = numbers[0]
        sensor = KINDS.get(letter)
        if sensor is None or time < start or not ON[sensor]:
            continue
        if sensor == "fix" and WITHHELD and WITHHELD[0] < stamp < WITHHELD[1]:
            continue
        if stamp - last.get(sensor, -math.inf) < EVERY[sensor] - 1e-9:
            continue
        last[sensor] = stamp
        if sensor == "fix":
            sigma = numbers[2] if len(numbers) > 2 else SIGMA_FIX
            robot.correct(sensor, numbers[:2], lambda x: x[:2], lambda x: np.eye(2, 3), [sigma**2] * 2)
        elif sensor == "heading":
            sigma = numbers[1] if len(numbers) > 1 else SIGMA_HEADING
            robot.correct(sensor, numbers[:1], lambda x: x[2:], lambda x: np.array([[0, 0, 1]]), [sigma**2])
        else:
            see(robot, sensor, landmarks[int(numbers[0])], numbers[1:])
    return robot


def see(robot, sensor, mark, z):
    """A range to a landmark, and its bearing from the robot's nose."""
    def off(x):
        dx, dy = mark[0] - x[0], mark[1] - x[1]
        return dx, dy, math.hypot(dx, dy)

    def h(x):
        dx, dy, rho = off(x)
        seen = [(1 + SCALE) * rho + OFFSET, wrap(math.atan2(dy, dx) - x[2] + BEARING_OFFSET)]
        return np.array(seen[:len(z)])

    def jacobian(x):
        dx, dy, rho = off(x)
        by_range = [-(1 + SCALE) * dx / rho, -(1 + SCALE) * dy / rho, 0]
        return np.array([by_range, [dy / rho**2, -dx / rho**2, -1]][:len(z)])

    robot.correct(sensor, z, h, jacobian, [SIGMA_RANGE**2, SIGMA_BEARING**2][:len(z)])


with open(sys.argv[1], encoding="utf-8") as file:
    robot = replay(*read(file))
print(json.dumps({"x": robot.x.tolist(), "P": robot.P.tolist()}))
`
