// A system of one’s own that is copied as a program computes what the figure shows.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { execFileSync } from 'node:child_process'
import { copyFileSync, existsSync, mkdirSync, writeFileSync } from 'node:fs'
import { createRequire } from 'node:module'
import path from 'node:path'
import { fileURLToPath } from 'node:url'
import { javascript, numpy, rust } from '../../web/widgets/own-system/copy-as.js'
import { PRESETS, paramsOf } from '../../web/widgets/own-system/presets.js'
import { python } from './python.mjs'

const root = fileURLToPath(new URL('../..', import.meta.url))
const core = createRequire(import.meta.url)(path.join(root, 'target/pkg/node/estimate_wasm.js'))
const open = (params, step = 0) => core.OwnSystem.from({ version: 1, lab: 'own-system', step, params })

/** The states whose programs are run: one of each kind. */
const STATES = [
  paramsOf(PRESETS[0]),
  {
    ...paramsOf(PRESETS[1]),
    gain: 'hand',
    k: [
      [0.1, 0, 0, 0],
      [0.7, 0, 0, 0],
      [0, 0, 0, 0],
      [0, 0, 0, 0],
    ],
  },
  {
    ...paramsOf(PRESETS[2]),
    gain: 'placement',
    poles: [
      [0.4, 0.3],
      [0, 0],
      [0.2, 0],
      [0, 0],
    ],
  },
  { ...paramsOf(PRESETS[5]), inputs: 0, start: 4 },
  paramsOf(PRESETS[4]),
  // Sampled from continuous time, and with a start of its own for each state.
  paramsOf({ ...PRESETS[8], spread: [4, 0.25] }),
  paramsOf(PRESETS[9]),
]

/** What a program prints, against the frame. @param {string} printed @param {any} params @param {boolean} verdicts */
function compare(printed, params, verdicts) {
  const frame = open(params).frame()
  const numbers = (text) => [...text.matchAll(/-?\d+\.?\d*(?:e[+-]?\d+)?/g)].map(([one]) => Number(one))
  const close = (a, b, what) =>
    assert.ok(
      a.length === b.length && a.every((one, i) => Math.abs(one - b[i]) <= 1e-7 * (1 + Math.abs(b[i]))),
      `${what}: ${a} and ${b}`,
    )
  const lines = printed.trim().split('\n')
  const [rank, ...values] = numbers(lines[0])
  assert.equal(rank, frame.rank.rank)
  close(values, frame.rank.singularValues, 'singular values')
  // Of equal moduli the order may differ from one library to the next.
  const roots = lines.filter((line) => line.startsWith('eigenvalue')).map(numbers)
  for (const { re, im } of frame.eigenvalues)
    assert.ok(
      roots.some(([x, y]) => Math.hypot(x - re, y - im) < 1e-6),
      `${re} + ${im} i among ${roots}`,
    )
  const gains = lines.filter((line) => line.startsWith('gain')).map(numbers)
  const run = open(params, 5).frame().series.gain
  assert.equal(gains.length, 5)
  gains.forEach((gain, k) =>
    close(
      gain,
      run.slice(0, params.states).flatMap((row) => row.slice(0, params.readings).map((series) => series[k + 1])),
      `gain ${k + 1}`,
    ),
  )
  if (!verdicts) return
  const [settles, ...limit] = [lines[4].split(' ')[1] === 'true', ...numbers(lines[4])]
  assert.equal(settles, frame.doubled.converged)
  if (params.gain !== 'hand' && params.gain !== 'placement' && settles) close(limit, frame.K.flat(), 'the limit')
  const words = lines.slice(1, 4).join('\n').toLowerCase()
  assert.equal(
    words
      .replace(/fromeverystart/, 'from-every-start')
      .replace(/dependsonstart/, 'depends-on-start')
      .replace(/fromlargestart/, 'from-large-start'),
    `observable ${frame.observable}, detectable ${frame.detectable}\n` +
      `reached by noise ${frame.noise.reachable}, stabilizable ${frame.noise.stabilizable}\nlimit ${frame.limit}`,
  )
}

const programs = path.join(root, 'target/own-system')
mkdirSync(path.join(programs, 'src/bin'), { recursive: true })

test('a program says first which package it needs, and where that is', () => {
  const frame = open(paramsOf(PRESETS[8])).frame()
  for (const [text, needs] of /** @type {[string, RegExp][]} */ ([
    [rust(frame), /^\/\/ The crate robot-motion-estimate, in crates\/estimate of the book’s source/],
    [javascript(frame), /^\/\/ The package robot-motion: \.\/scripts\/package in the book’s source makes/],
    [numpy(frame), /^# numpy alone\./],
  ])) {
    assert.match(text, needs)
    assert.match(text, /F, G and V are sampled every 0\.1 s from continuous time\./)
  }
})

test('a system copied as JavaScript prints what the figure shows', () => {
  for (const params of STATES) {
    const text = javascript(open(params).frame()).replace(
      "'robot-motion'",
      JSON.stringify(path.join(root, 'target/pkg/node/estimate_wasm.js')),
    )
    const file = path.join(programs, 'system.cjs')
    writeFileSync(file, text)
    compare(execFileSync(process.execPath, [file], { encoding: 'utf8' }), params, true)
  }
})

test('a system copied as numpy prints what the figure shows', { timeout: 120_000 }, () => {
  const program = python()
  for (const params of STATES)
    compare(execFileSync(program, ['-c', numpy(open(params).frame())], { encoding: 'utf8' }), params, false)
})

test('in Rust a number is written so that it is a float: with a point or an exponent, and to the last bit', () => {
  for (const one of [0.1, 2, 1e15, 2 ** 53, 123456789012345680000, 1e21, 1.5e300, 5e-324]) {
    const params = { ...paramsOf(PRESETS[0]), start: one }
    const text = rust({ ...open(paramsOf(PRESETS[0])).frame(), params })
    const [, written] = /dvector!\[(\S+), /.exec(text)
    assert.match(written, /[.e]/)
    assert.equal(Number(written), one)
  }
})

test('a system copied as Rust prints what the figure shows', { timeout: 600_000 }, () => {
  // A package of its own beside the workspace, with the versions that the workspace has.
  writeFileSync(
    path.join(programs, 'Cargo.toml'),
    `[package]
name = "own-system"
version = "0.1.0"
edition = "2024"

[workspace]

[dependencies]
estimate = { package = "robot-motion-estimate", path = "../../crates/estimate" }
nalgebra = { version = "0.35", default-features = false, features = ["alloc", "macros", "libm-force"] }

[profile.dev]
opt-level = 1
debug = "line-tables-only"

[profile.dev.package."*"]
debug = false
`,
  )
  if (!existsSync(path.join(programs, 'Cargo.lock')))
    copyFileSync(path.join(root, 'Cargo.lock'), path.join(programs, 'Cargo.lock'))
  STATES.forEach((params, i) => writeFileSync(path.join(programs, `src/bin/system${i}.rs`), rust(open(params).frame())))
  execFileSync('cargo', ['build', '--quiet', '--offline'], { cwd: programs, stdio: ['ignore', 'inherit', 'inherit'] })
  STATES.forEach((params, i) =>
    compare(execFileSync(path.join(programs, `target/debug/system${i}`), { encoding: 'utf8' }), params, true),
  )
})
