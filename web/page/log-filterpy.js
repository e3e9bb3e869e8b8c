/** The page’s filter of a log, as it was tuned, as Python on filterpy. */

import { SENSORS, everyOf, exact, fixed, gateOf } from './log-export.js'

/** @typedef {import('estimate-wasm').LogFrame} Frame */

/** A value of Python’s. @param {number | boolean | null} value */
const inPython = (value) =>
  value === null ? 'None' : typeof value === 'boolean' ? (value ? 'True' : 'False') : exact(value)

/**
 * It reads a log in the book’s own format.
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
    FIX_SIGMA_SCALE: params.fixSigmaScale,
    HEADING_SIGMA_SCALE: params.headingSigmaScale,
    START_SIGMA: params.startSigma,
    START_SIGMA_HEADING: params.startSigmaHeading,
    SCALE: scale,
    OFFSET: params.offset,
    BEARING_OFFSET: params.bearingOffset,
    HEADING_OFFSET: params.headingOffset,
    SPEED_SCALE: speedScale,
    TURN_BIAS: turnBias,
    ANTENNA_AHEAD: params.antennaAhead,
    ANTENNA_LEFT: params.antennaLeft,
  }).map(([name, value]) => `${name} = ${exact(value)}\n`)
  return `"""The filter that was tuned on a page of the book Robot Motion, on filterpy. MIT or Apache-2.0.

pip install filterpy; python3 filter.py LOG, where LOG has rows of the book's own format, in which the page's button
"Download the log's rows" writes whatever log it has read:
L,id,x,y landmark | G,t,x,y,theta truth | O,t,distance,turn driven at t | D,t,distance,turn driven evenly until t
V,t,v,omega | S,t,v | T,t,omega held until the next | VE, SE, TE the same, changing evenly until the next
R,t,id,range | B,t,id,range,bearing | P,t,x,y[,sigma] fix | H,t,theta[,sigma]
Seconds, metres, radians.
${learned ? 'What the filter learned is fixed here at what the log had taught where the page stood.\n' : ''}"""

import json
import math
import sys

import numpy as np
from filterpy.kalman import ExtendedKalmanFilter
from scipy.stats import chi2

${settings.join('')}# The pose at the start of a log without truth.
START = [${(params.start ?? [0, 0, 0]).map(exact).join(', ')}]
# By sensor: whether it corrects, the probability of its gate, and the least time between two readings.
ON = ${each((sensor) => on[sensor])}
GATE = ${each((sensor) => gateOf(params.gate, sensor))}
EVERY = ${each((sensor) => everyOf(params.every, sensor))}
# How late rows are: they were measured at their stamp less this.
DELAY = {${Object.entries(delays)
    .map(([name, value]) => `"${name}": ${exact(value)}`)
    .join(', ')}, "bearing": ${exact(delaySighting)}}
# Fixes stamped between these two times do not correct.
WITHHELD = ${params.withheld ? `(${Array.from(params.withheld, exact).join(', ')})` : 'None'}

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
        elif letter[0] == "V" and DELAY["speed"] != DELAY["turn"]:
            rows.append((numbers[0] - DELAY["speed"], False, line, numbers[0], "S" + letter[1:], numbers[1:2]))
            rows.append((numbers[0] - DELAY["turn"], False, line, numbers[0], "T" + letter[1:], numbers[2:3]))
        else:
            late = {"D": 0.0, "O": 0.0, "V": DELAY["speed"], "S": DELAY["speed"], "T": DELAY["turn"]}
            delay = late[letter[0]] if letter[0] in late else DELAY[KINDS[letter]]
            rows.append((numbers[0] - delay, letter in KINDS, line, numbers[0], letter, numbers[1:]))
    return landmarks, min(truth, default=None), evenly(sorted(rows, key=lambda row: row[:3]))


KINDS_OF = {"VE": "ST", "SE": "S", "TE": "T"}


def longest(rows, kind):
    """3.5 times the median step between rows of a rate: over a longer one it is held."""
    times = [row[3] for row in rows if kind in KINDS_OF.get(row[4], "")]
    steps = sorted(b - a for a, b in zip(times, times[1:]) if b > a)
    return 3.5 * steps[len(steps) // 2] if steps else 0.0


def evenly(rows):
    """Of rates that change evenly, the mean of each row's rate and of the next one's."""
    ahead, most = {}, {kind: longest(rows, kind) for kind in "ST"}
    for at in reversed(range(len(rows))):
        *row, stamp, letter, numbers = rows[at]
        if letter not in KINDS_OF:
            continue
        means = []
        for kind, number in zip(KINDS_OF[letter], numbers):
            after, other = ahead.get(kind, (math.inf, number))
            means.append(0.5 * (number + other) if after - stamp <= most[kind] else number)
            ahead[kind] = stamp, number
        rows[at] = (*row, stamp, letter, means)
    return rows


class Robot(ExtendedKalmanFilter):
    """The distance, the turn and the heading of a move are its input."""

    def predict_x(self, u=0):
        distance, turn, heading = u
        moved = [self.x[0] + distance * math.cos(heading), self.x[1] + distance * math.sin(heading)]
        self.x = np.array([*moved, wrap(self.x[2] + turn)])

    def move(self, distance, turn, dt, on_the_way=False):
        """Drives along the heading at the beginning, or, where the robot turns on the way, along that half-way."""
        heading = self.x[2] + (turn / 2 if on_the_way else 0)
        c, s = math.cos(heading), math.sin(heading)
        self.F = np.array([[1, 0, -distance * s], [0, 1, distance * c], [0, 0, 1]])
        b = np.array([[c, 0], [s, 0], [0, 1]])
        self.Q = b @ np.diag([SIGMA_DISTANCE**2, SIGMA_TURN**2]) @ b.T * dt
        self.predict((distance, turn, heading))

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


def share(way, last, before, time):
    """How much of a D row's way is driven until a time, evenly from the last such row on; all of the first at once."""
    if last is None:
        return 1.0 if time >= way[0] else None
    whole = way[0] - last
    return min(max((time - max(before, last)) / whole, 0.0), 1.0) if whole > 0 else 1.0


def replay(landmarks, truth, rows):
    """The robot behind the last row."""
    robot = Robot(dim_x=3, dim_z=2)
    fixes = [row for row in rows if row[4] == "P"]
    start, robot.x = (fixes or rows)[0][0], np.array(START, dtype=float)
    if truth is not None:
        start, robot.x = truth[0], np.array(truth[1:4])
    robot.P = np.diag([START_SIGMA**2, START_SIGMA**2, START_SIGMA_HEADING**2])
    by_odometry = any(row[4] in "DO" for row in rows)
    on_the_way = any(row[4] == "D" or row[4] in KINDS_OF for row in rows)
    # For each row the D row on whose way the robot is then.
    ways = [None] * len(rows)
    for at in reversed(range(len(rows))):
        ways[at] = rows[at] if rows[at][4] == "D" else ways[at + 1] if at + 1 < len(rows) else None
    before, speed, rate, last, ended = start, 0.0, 0.0, {}, None
    for way, (time, _, _, stamp, letter, numbers) in zip(ways, rows):
        if time >= start:
            dt = max(time - before, 0.0)
            driven = 1.0 if letter == "O" else share(way, ended, before, time) if way else None
            if driven is not None:
                distance, turn = (way[5] if way else numbers)[:2]
                robot.move(driven * distance, driven * turn, dt, on_the_way)
            elif not by_odometry:
                robot.move(speed * (1 + SPEED_SCALE) * dt, (rate - TURN_BIAS) * dt, dt, on_the_way)
            if driven is not None or not by_odometry:
                before = max(before, time)
        ended = time if letter == "D" else ended
        if letter[0] == "V":
            speed, rate = numbers
        elif letter[0] == "S":
            speed = numbers[0]
        elif letter[0] == "T":
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
            sigma = numbers[2] * FIX_SIGMA_SCALE if len(numbers) > 2 else SIGMA_FIX
            robot.correct(sensor, numbers[:2], antenna, by_antenna, [sigma**2] * 2)
        elif sensor == "heading":
            sigma = numbers[1] * HEADING_SIGMA_SCALE if len(numbers) > 1 else SIGMA_HEADING
            theta = wrap(numbers[0] - HEADING_OFFSET)
            robot.correct(sensor, [theta], lambda x: x[2:], lambda x: np.array([[0, 0, 1]]), [sigma**2])
        else:
            see(robot, sensor, landmarks[int(numbers[0])], numbers[1:])
    return robot


def antenna(x):
    """Where the antenna is whose position a fix is."""
    c, s = math.cos(x[2]), math.sin(x[2])
    return np.array([x[0] + c * ANTENNA_AHEAD - s * ANTENNA_LEFT, x[1] + s * ANTENNA_AHEAD + c * ANTENNA_LEFT])


def by_antenna(x):
    c, s = math.cos(x[2]), math.sin(x[2])
    turned = [-s * ANTENNA_AHEAD - c * ANTENNA_LEFT, c * ANTENNA_AHEAD - s * ANTENNA_LEFT]
    return np.array([[1, 0, turned[0]], [0, 1, turned[1]]])


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


if len(sys.argv) != 2:
    sys.exit(__doc__)
with open(sys.argv[1], encoding="utf-8") as file:
    robot = replay(*read(file))
print(json.dumps({"x": robot.x.tolist(), "P": robot.P.tolist()}))
`
