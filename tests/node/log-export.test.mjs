// What was tuned on a log, for others: a configuration of robot_localization, and the page’s filter on filterpy.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { execFileSync } from 'node:child_process'
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs'
import { createRequire } from 'node:module'
import path from 'node:path'
import { float, robotLocalization } from '../../web/page/log-export.js'
import { filterpy } from '../../web/page/log-filterpy.js'
import { python } from './python.mjs'

const root = path.join(import.meta.dirname, '../..')
const { RobotLog } = createRequire(import.meta.url)(path.join(root, 'target/pkg/node/estimate_wasm.js'))
const folder = path.join(root, 'target/log-export')
mkdirSync(folder, { recursive: true })
const ours = (name) => readFileSync(path.join(root, 'content/logs', name), 'utf8')

/** A car with speeds and turn rates, fixes that have a σ or none, and headings, all of them late. */
const CAR = Array.from({ length: 60 }, (_, k) => {
  const t = (k / 5).toFixed(1)
  const [x, y] = [Math.cos(0.4 * k) - 0.4 * k, 0.5 * Math.sin(0.3 * k)].map((one) => one.toFixed(3))
  return [
    k % 3 === 0 ? `V,${t},${(2 + 0.3 * Math.sin(k)).toFixed(3)},${(0.2 * Math.cos(k / 9)).toFixed(4)}` : `S,${t},2.1`,
    ...(k % 7 === 0 ? [`T,${t},0.05`] : []),
    ...(k % 5 === 2 ? [`P,${t},${x},${y}${k % 2 ? ',0.7' : ''}`] : []),
    ...(k % 6 === 1 ? [`H,${t},${(3.1 + 0.3 * Math.sin(k)).toFixed(3)}${k % 4 === 1 ? ',0.15' : ''}`] : []),
  ].join('\n')
}).join('\n')

/** A robot by odometry that is driven evenly, its readings between the rows. */
const EVEN = [
  'L,1,6,2',
  ...Array.from({ length: 60 }, (_, k) => {
    const t = k / 4
    const range = Math.hypot(6 - 0.4 * k * 0.3, 2) + 0.1 * Math.sin(3 * k)
    return [
      `D,${t},${(0.12 + 0.02 * Math.sin(k)).toFixed(3)},${(0.05 * Math.cos(k / 7)).toFixed(4)}`,
      `R,${(t + 0.1 + 0.02 * (k % 3)).toFixed(2)},1,${range.toFixed(3)}`,
    ].join('\n')
  }),
].join('\n')

/** Late by different times, which parts speed and turn. */
const LATE = { delaySpeed: 0.1, delayTurn: 0.25, delayFix: 0.3, delayHeading: -0.05 }

/** @type {Record<string, { text: string, params: Record<string, unknown> }>} */
const LOGS = {
  'ranges and bearings': { text: ours('example.csv'), params: { sigmaRange: 0.1, bearingOffset: 0.02, offset: 0.05 } },
  'a gate, and a scale that was learned': {
    text: ours('plaza1.csv').split('\n').slice(0, 3000).join('\n'),
    params: { gate: 0.99, scale: 0.02, every: 0.5 },
  },
  'odometry that is driven evenly, and ranges that are late': {
    text: EVEN,
    params: { delaySighting: 0.07, sigmaRange: 0.2 },
  },
  'fixes and headings that are late': {
    text: CAR,
    params: {
      start: [1, 0.5, 3],
      startSigma: 2,
      startSigmaHeading: 0.6,
      ...LATE,
      speedScale: 0.03,
      turnBias: -0.01,
      sigmaFix: 1.2,
      fixSigmaScale: 1.7,
      headingSigmaScale: 0.8,
      sigmaHeading: 0.2,
      headingOffset: 0.15,
      antennaAhead: 1.3,
      antennaLeft: -0.4,
      gate: { fix: 0.95, heading: 0.9 },
      every: { heading: 0.4 },
      withheld: [5, 6.5],
    },
  },
  'rates that change evenly, with an antenna ahead': {
    // A stretch is not read.
    text: CAR.replace(/^[VST],[56]\..*\n/gm, '').replace(/^([VST]),/gm, '$1E,'),
    params: { ...LATE, sigmaFix: 1.2, antennaAhead: 0.7, antennaLeft: -0.2, speedScale: 0.03 },
  },
}
const all = Object.entries(LOGS).map(([name, { text, params }], i) => {
  const log = RobotLog.parse(text)
  const contents = log.contents()
  const lab = RobotLog.from(log, { version: 1, lab: 'robot-log', params, step: contents.steps })
  return { name, text, contents, frame: structuredClone(lab.frame()), file: path.join(folder, `log${i}`) }
})
const program = python({ numpy: 'numpy', filterpy: 'filterpy', yaml: 'pyyaml' })

test('the filter on filterpy ends where the page’s ends, to 1e-9', { timeout: 120_000 }, () => {
  for (const { name, text, frame, file } of all) {
    writeFileSync(`${file}.csv`, text)
    writeFileSync(`${file}.py`, filterpy(frame))
    const { x, P } = JSON.parse(execFileSync(program, [`${file}.py`, `${file}.csv`], { encoding: 'utf8' }))
    const [found, expected] = [
      [...x, ...P.flat()],
      [...frame.estimate, ...frame.P.flat()],
    ]
    found.forEach((one, k) => assert.ok(Math.abs(one - expected[k]) <= 1e-9, `${name}: ${found} and ${expected}`))
    const { used, refused } = frame.summary
    assert.ok(used > 5, name)
    if (frame.params.gate !== null) assert.ok(refused > 0, `${name}: the gate refuses nothing`)
  }
})

test('what was learned is in the program as a number', () => {
  const log = RobotLog.parse(LOGS['a gate, and a scale that was learned'].text)
  const params = { learn: true }
  const frame = RobotLog.from(log, { version: 1, lab: 'robot-log', params, step: 2500 }).frame()
  const text = filterpy(frame)
  assert.match(text, /What the filter learned is fixed here/)
  assert.ok(frame.summary.epsilon !== null && text.includes(`SCALE = ${frame.summary.epsilon}\n`), text)
})

test('what is exported has the σ that was used: that which readings bring times its factor', () => {
  const { frame, contents } = all[3]
  const text = robotLocalization(frame, contents)
  assert.match(text, /fixes: 1\.44 m² .* has no σ of its own;\n# {3}where it has one: that covariance times 2\.89;/)
  assert.match(text, /headings: .*;\n# {3}where it has one: that covariance times 0\.64;/)
  assert.doesNotMatch(robotLocalization(all[0].frame, all[0].contents), /that covariance times/)
  const usual = { ...frame, params: { ...frame.params, fixSigmaScale: 1 } }
  assert.doesNotMatch(robotLocalization(usual, contents), /covariance times 2/)
})

test('what robot_localization has to be told otherwise is said: a true start, and factors on odometry', () => {
  const { frame, contents } = all[0]
  const said = (/** @type {any} */ more) => robotLocalization(frame, { ...contents, ...more })
  assert.match(said({ truth: true }), /# The page’s filter starts at the first true pose of the log: write that into/)
  assert.doesNotMatch(said({ truth: false }), /first true pose/)
  const corrections = { driven: [0.9705, 1.01], landmarks: [], ranges: [] }
  assert.match(
    said({ motion: 'odometry', corrections }),
    /# Multiply distances of odometry by 0\.9705 and turns by 1\.01 /,
  )
  assert.doesNotMatch(said({ motion: 'odometry' }), /Multiply distances/)
  assert.match(
    said({ motion: 'velocity', corrections: { driven: [1, 0.96] } }),
    /# Multiply turn rates by 0\.96 before/,
  )
  const unequal = said({ motion: 'velocity', corrections: { driven: [1, 1], swerve: -0.04 } })
  assert.match(unequal, /# Then add -0\.04 times its metres to each turn of the wheels/)
})

/** What robot_localization’s ekf_node declares in its documentation: without a sensor’s number. */
const DOCUMENTED = [
  'frequency two_d_mode publish_tf map_frame odom_frame base_link_frame world_frame smooth_lagged_data history_length',
  'twistN twistN_config poseN poseN_config poseN_differential poseN_rejection_threshold',
  'process_noise_covariance initial_estimate_covariance initial_state',
].flatMap((line) => line.split(' '))

test('the configuration of robot_localization is YAML of its parameters, of their types and sizes', () => {
  const load = 'import json, sys, yaml; print(json.dumps(yaml.safe_load(sys.stdin)))'
  for (const { name, frame, contents } of all) {
    const text = robotLocalization(frame, contents)
    const read = JSON.parse(execFileSync(program, ['-c', load], { encoding: 'utf8', input: text }))
    assert.deepEqual(Object.keys(read), ['ekf_filter_node'])
    const params = read.ekf_filter_node.ros__parameters
    for (const [key, value] of Object.entries(params)) {
      assert.ok(DOCUMENTED.includes(key.replace(/^(twist|pose)\d/, '$1N')), `${name}: ${key}`)
      if (key.endsWith('_config')) assert.ok(value.length === 15 && value.every((one) => typeof one === 'boolean'))
      // A list of doubles with a whole number in it is refused by ROS 2.
      if (/covariance|initial_state/.test(key)) {
        assert.ok(value.length === 15 && value.every(Number.isFinite), `${key}: ${value}`)
        const written = new RegExp(`${key}: \\[([^\\]]*)\\]`).exec(text)[1].split(',')
        assert.ok(
          written.every((one) => /^\s*-?\d+\.\d+(e[+-]?\d+)?$/.test(one)),
          `${key}: ${written}`,
        )
      }
    }
    const { sigmaDistance, sigmaTurn, startSigma } = frame.params
    const noise = params.process_noise_covariance
    const written = [noise[0], noise[1], noise[5], params.initial_estimate_covariance[0]]
    const squares = [sigmaDistance, sigmaDistance, sigmaTurn, startSigma].map((sigma) => sigma ** 2)
    for (const [i, square] of squares.entries())
      assert.ok(Math.abs(written[i] - square) <= 1e-12 * Math.min(1, square), `${name}: ${written} and ${squares}`)
    assert.match(text, /A measurement’s covariance comes with each message/)
  }
  const [, , , { frame, contents }] = all
  const late = robotLocalization(frame, contents)
  assert.match(late, /# The antenna stands 1\.3 m ahead of base_link and -0\.4 m to its left: publish the transform\n/)
  assert.doesNotMatch(robotLocalization(all[0].frame, all[0].contents), /antenna/)
  assert.match(late, /pose0: fix\/pose[\s\S]*pose0_rejection_threshold: 2\.447/)
  assert.match(late, /smooth_lagged_data: true\n +history_length: 2\.0/)
  assert.match(late, /# Stamp fixes 0\.3 s earlier/)
  assert.match(robotLocalization(all[0].frame, all[0].contents), /takes no ranges to landmarks/)
})

test('a number is written with the digits that matter, and never moved by more than 1e-12', () => {
  for (const [x, text] of [
    [0.4 ** 2, '0.16'],
    [0.1 + 0.2, '0.3'],
    [-0.05, '-0.05'],
    [1e-9, '1.0e-9'],
    [3, '3.0'],
    [0, '0.0'],
    [1 / 3, '0.333333333333'],
    [1.7e9 + 0.123456, '1700000000.123456'],
  ])
    assert.equal(float(Number(x)), text)
  for (const { frame, contents } of all)
    assert.doesNotMatch(robotLocalization(frame, contents), /\d{15}/, 'no digits that rounding has made')
})
