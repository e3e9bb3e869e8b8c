// Rows of the mower's log replayed in a second: natively, by the module in Node, and by filterpy over the same rows,
// whose RMS error must be ours. Three rounds, medians, ratios. Then a log of a million rows, and whether its goals are
// met. Nothing fails on a time.
import { execFileSync } from 'node:child_process'
import { readFileSync } from 'node:fs'
import { createRequire } from 'node:module'
import path from 'node:path'
import { fileURLToPath } from 'node:url'
import { python } from '../tests/node/python.mjs'

const root = path.resolve(path.dirname(fileURLToPath(import.meta.url)), '..')
const plaza = path.join(root, 'content/logs/plaza1.csv')
/** The module's instance, which shows its memory. @type {WebAssembly.Instance} */
let instance
const { Instance } = WebAssembly
WebAssembly.Instance = class extends Instance {
  constructor(module, imports) {
    super(module, imports)
    instance = this
  }
}
const core = createRequire(import.meta.url)(path.join(root, 'target/pkg/node/estimate_wasm.js'))
const ROUNDS = 3
const TIMES = 20
/** Of a smoothed log of a million rows: seconds, and megabytes of the module's memory. */
const GOALS = { smoothed: 2, memory: 300 }
const PYTHON = python({ numpy: 'numpy', filterpy: 'filterpy' })

execFileSync('cargo', ['build', '--release', '--quiet', '--locked', '--example', 'log_pace', '-p', 'labs'], {
  cwd: root,
  stdio: 'inherit',
})
const pace = path.join(process.env.CARGO_TARGET_DIR ?? path.join(root, 'target'), 'release/examples/log_pace')
const log = core.RobotLog.parse(readFileSync(plaza, 'utf8'))
const { steps } = log.contents()

function inModule() {
  let rmse = NaN
  const began = process.hrtime.bigint()
  for (let i = 0; i < TIMES; i++) {
    const lab = new core.RobotLog(log)
    lab.runAll()
    rmse = lab.summary().rmse
    lab.free()
  }
  return { lab: (TIMES * steps * 1e9) / Number(process.hrtime.bigint() - began), rmse }
}

/** A million rows: the log written one time behind the other. */
function parsing() {
  const text = readFileSync(plaza, 'utf8')
    .split('\n')
    .filter((line) => /^[OR]/.test(line))
  const rows = ['L,0,-46.623,11.026', 'L,1,11.036,-6.959', 'L,6,22.053,23.848', 'L,5,-17.665,59.009']
  for (let i = 0; rows.length < 1_000_000; i++) {
    for (const line of text) {
      const [letter, time, ...rest] = line.split(',')
      rows.push([letter, (Number(time) + 2000 * i).toFixed(3), ...rest].join(','))
    }
  }
  const whole = rows.slice(0, 1_000_000).join('\n')
  const began = process.hrtime.bigint()
  const parsed = core.RobotLog.parse(whole)
  const read = Number(process.hrtime.bigint() - began) / 1e9
  // The module's memory never shrinks: its size is the most that was in use.
  const megabytes = () => /** @type {WebAssembly.Memory} */ (instance.exports.memory).buffer.byteLength / 1e6
  const memory = [megabytes()]
  const lab = new core.RobotLog(parsed)
  const from = process.hrtime.bigint()
  for (let i = 0; i < 4; i++) {
    lab.run(250_000)
    memory.push(megabytes())
  }
  const replayed = Number(process.hrtime.bigint() - from) / 1e9
  lab.frame()
  memory.push(megabytes())
  const back = process.hrtime.bigint()
  lab.smooth()
  const smoothed = Number(process.hrtime.bigint() - back) / 1e9
  memory.push(megabytes())
  return { read, replayed, smoothed, memory }
}

/** @type {Record<string, number[]>} */
const rates = {}
const note = (name, rate) => (rates[name] ??= []).push(rate)
inModule()
for (let round = 0; round < ROUNDS; round++) {
  const native = JSON.parse(execFileSync(pace, { encoding: 'utf8' }))
  note('filter alone, native', native.filter)
  note('lab, native', native.lab)
  const module = inModule()
  note('lab, module', module.lab)
  const filterpy = JSON.parse(
    execFileSync(PYTHON, [path.join(root, 'scripts/bench-log.py'), plaza], {
      encoding: 'utf8',
      stdio: ['ignore', 'pipe', 'ignore'],
    }),
  )
  if (Math.abs(filterpy.rmse - native.rmse) > 1e-6 || Math.abs(module.rmse - native.rmse) > 1e-9)
    throw new Error(`other errors: ${filterpy.rmse}, ${module.rmse}, ${native.rmse}`)
  note('filterpy', filterpy.filterpy)
}
const median = (numbers) => [...numbers].sort((a, b) => a - b)[numbers.length >> 1]
console.log('| replay of the mower’s log | rows a second | times filterpy |\n|---|---:|---:|')
for (const [name, all] of Object.entries(rates)) {
  const times = median(all) / median(rates.filterpy)
  console.log(`| ${name} | ${Math.round(median(all)).toLocaleString('en')} | ${times.toFixed(0)} |`)
}
const { read, replayed, smoothed, memory } = parsing()
const judged = (value, goal, unit) => `(goal: at most ${goal} ${unit}, ${value <= goal ? 'met' : 'missed'})`
console.log(
  `A log of 1,000,000 rows in the module: read in ${read.toFixed(1)} s, replayed in ${replayed.toFixed(1)} s, ` +
    `smoothed in ${smoothed.toFixed(1)} s ${judged(smoothed, GOALS.smoothed, 's')}.`,
)
console.log(
  `The module's memory: ${memory[0].toFixed(1)} MB with the log read, ${memory
    .slice(1, 5)
    .map((size) => size.toFixed(1))
    .join(', ')} MB after each quarter of the replay, ${memory[5].toFixed(1)} MB with a frame, ` +
    `${memory[6].toFixed(1)} MB with the smoothed track ${judged(memory[6], GOALS.memory, 'MB')}.`,
)
