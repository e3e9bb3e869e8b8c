// A program of the reader’s that is copied into another language runs there, and gives the core’s numbers in the first
// ten steps of its world: compiled by cargo and cc, run by Node and by Python with numpy. MATLAB’s is read by our own
// parser.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { execFileSync, spawnSync } from 'node:child_process'
import { copyFileSync, existsSync, mkdirSync, rmSync, writeFileSync } from 'node:fs'
import { createRequire } from 'node:module'
import path from 'node:path'
import { fileURLToPath } from 'node:url'
import { worldOfCopy } from '../../web/widgets/write-filter/copies.js'
import { copies } from '../../web/widgets/write-filter/copy.js'
import { frameOf } from '../../web/widgets/write-filter/copy/frame.js'
import { matlabLines } from '../../web/widgets/write-filter/copy/matlab.js'
import { styled } from '../../web/widgets/write-filter/copy/style.js'
import { GROUPS } from '../../web/widgets/write-filter/programs.js'
import { PROGRAMS, worldOf } from './copied-programs.mjs'
import { python } from './python.mjs'

const root = fileURLToPath(new URL('../..', import.meta.url))
const core = createRequire(import.meta.url)(path.join(root, 'target/pkg/node/estimate_wasm.js'))
const folder = path.join(root, 'target/copied-programs')
rmSync(path.join(folder, 'src'), { recursive: true, force: true })
mkdirSync(path.join(folder, 'src'), { recursive: true })

/** @param {{ text: string, world?: string, notation?: string }} it */
const read = ({ text, world = 'linear', notation = 'choset' }) => new core.Program(text, { world, notation })

/** A program that the figure begins with, and the world that its own copies are tested on. @param {string} begin */
function begun(begin) {
  const lab = core.WriteFilter.from({ version: 1, lab: 'write-filter', step: 0, params: { begin } })
  const [{ text, world: kind }, world] = [lab.frame(), worldOfCopy(lab.world())]
  lab.free()
  return { name: `begin ${begin}`, it: { text, world: kind }, world }
}
/** What the figure begins with and nothing can be copied of: it has no whole step yet. */
const UNFINISHED = ['empty', 'fill', 'sequential', 'extend']
const begins = GROUPS.flatMap(({ programs }) => programs.map(([begin]) => begin))
const trees = new Set()
const all = [
  ...Object.entries(PROGRAMS).map(([name, it]) => ({ name, it, world: worldOf(it) })),
  ...begins.filter((begin) => !UNFINISHED.includes(begin)).map(begun),
].map(({ name, it, world }, i) => {
  const program = read(it)
  const { copies: written, why } = copies(program, it.text, world)
  assert.equal(why, '', name)
  const texts = Object.fromEntries(written.map(({ language, text }) => [language, text]))
  const tree = JSON.stringify(program.tree().map(({ lines, ...line }) => line))
  const isNew = !trees.has(tree)
  trees.add(tree)
  const [{ steps }] = written
  // Ten, but where P is no covariance any more.
  assert.equal(steps, name.endsWith('short-form') ? 1 : 10, name)
  return { name, it, world, program, texts, steps, isNew, file: path.join(folder, `program${i}`) }
})
/** Those whose formulas no other before them has: compilers take their time. */
const different = all.filter(({ isNew }) => isNew)

/** Whether a program ends well, and says that all its steps are right. */
function runs({ name, steps }, command, ...words) {
  const { status, stdout, stderr } = spawnSync(command, words, { encoding: 'utf8' })
  assert.equal(status, 0, `${name}: ${stdout}${stderr}`)
  assert.match(stdout, new RegExp(`^Steps that are right: ${steps}\\.$`, 'm'), name)
}
/** The text with the last of its expected numbers another: its first digits are. */
function spoilt(text) {
  const [number] = [...text.matchAll(/\d\.\d{12,}/g)].at(-1)
  return text.replace(number, `9${number.slice(1)}`)
}
/** Whether a program whose expected numbers are others fails. */
function fails(command, ...words) {
  const { status, stdout, stderr } = spawnSync(command, words, { encoding: 'utf8' })
  assert.notEqual(status, 0)
  assert.match(stdout + stderr, /step \d+ is off by/i)
}

test('copies in JavaScript give the core’s numbers', () => {
  for (const one of all) {
    writeFileSync(`${one.file}.mjs`, one.texts.javascript)
    runs(one, process.execPath, `${one.file}.mjs`)
  }
  writeFileSync(`${folder}/spoilt.mjs`, spoilt(all[0].texts.javascript))
  fails(process.execPath, `${folder}/spoilt.mjs`)
})

test('copies in C99 are compiled without a warning, and give the core’s numbers', () => {
  const strict = ['-std=c99', '-Wall', '-Wextra', '-Werror', '-pedantic']
  const compile = (file) => execFileSync('cc', [...strict, `${file}.c`, '-o', `${file}.out`, '-lm'], { stdio: 'pipe' })
  for (const one of different) {
    assert.doesNotMatch(one.texts.c, /alloc\(/)
    writeFileSync(`${one.file}.c`, one.texts.c)
    compile(one.file)
    runs(one, `${one.file}.out`)
  }
  writeFileSync(`${folder}/spoilt.c`, spoilt(all[0].texts.c))
  compile(`${folder}/spoilt`)
  fails(`${folder}/spoilt.out`)
})

test('copies in numpy give the core’s numbers', { timeout: 120_000 }, () => {
  const program = python()
  for (const one of all) {
    writeFileSync(`${one.file}.py`, one.texts.numpy)
    runs(one, program, '-W', 'error', `${one.file}.py`)
  }
  writeFileSync(`${folder}/spoilt.py`, spoilt(all[0].texts.numpy))
  fails(program, `${folder}/spoilt.py`)
})

test('copies in Rust give the core’s numbers', { timeout: 600_000 }, () => {
  // One package for all, with the versions that the workspace has.
  writeFileSync(
    path.join(folder, 'Cargo.toml'),
    `[package]
name = "copied-programs"
version = "0.1.0"
edition = "2024"

[workspace]

[dependencies]
nalgebra = { version = "0.35", default-features = false, features = ["alloc", "macros", "libm-force"] }

[profile.dev]
debug = false
`,
  )
  if (!existsSync(path.join(folder, 'Cargo.lock')))
    copyFileSync(path.join(root, 'Cargo.lock'), path.join(folder, 'Cargo.lock'))
  const texts = [...different.map(({ texts }) => texts.rust), spoilt(all[0].texts.rust)]
  texts.forEach((text, i) =>
    writeFileSync(path.join(folder, `src/program${i}.rs`), text.replace('\nfn main', '\npub fn main')),
  )
  const modules = texts.map((_, i) => `mod program${i};\n`)
  const arms = texts.map((_, i) => `        ${i} => program${i}::main(),\n`)
  writeFileSync(
    path.join(folder, 'src/main.rs'),
    `${modules.join('')}
fn main() {
    let which: usize = std::env::args().nth(1).expect("a number").parse().expect("a number");
    match which {
${arms.join('')}        _ => panic!("no such program"),
    }
}
`,
  )
  execFileSync('cargo', ['build', '--quiet', '--offline'], {
    cwd: folder,
    stdio: ['ignore', 'inherit', 'inherit'],
    env: { ...process.env, RUSTFLAGS: '-Dwarnings' },
  })
  const program = path.join(folder, 'target/debug/copied-programs')
  for (const [i, one] of different.entries()) runs(one, program, String(i))
  fails(program, String(different.length))
})

test('copies in MATLAB are programs of the language again, and their steps have the same bits', () => {
  for (const { name, it, world, program, steps } of all) {
    const { body } = matlabLines(frameOf(program, it.text, world))
    const again = read({ ...it, text: body })
    assert.deepEqual(again.faults, [], `${name}\n${body}`)
    let belief = world.belief
    for (const { u, y, landmark, W = world.system.W } of /** @type {any[]} */ (world.steps.slice(0, steps))) {
      const system = { ...world.system, W, ...(landmark && { landmark }) }
      const ours = program.step(system, belief, u, y)
      const theirs = again.step(system, belief, u, y)
      // A derivative is there a formula of its entries: the same but for rounding.
      if (it.text.includes('jac(')) near([...theirs.x, ...theirs.P.flat()], [...ours.x, ...ours.P.flat()], name)
      else assert.deepEqual([theirs.x, theirs.P], [ours.x, ours.P], `${name}\n${body}`)
      belief = { x: ours.x, P: ours.P }
    }
  }
})

/** @param {number[]} a @param {number[]} b @param {string} name */
const near = (a, b, name) =>
  a.forEach((one, i) => assert.ok(Math.abs(one - b[i]) <= 1e-12 * Math.max(1, ...b.map(Math.abs)), name))

test('what the reader remarks stays, and a copy says where it is from, how it is run and what it allows', () => {
  for (const text of Object.values(all[0].texts)) {
    assert.match(text, /the innovation/)
    assert.match(text, /the book Robot Motion/)
    assert.match(text, /MIT or Apache-2\.0\. \S/)
    assert.match(text, /first 10 steps .* up to 1e-9 of the largest entry/)
  }
  const broken = all.find(({ name }) => name === 'short-form')
  assert.match(broken.texts.c, /Its test is the first step of its world.*\n.*The world ends there: .*P/)
})

test('a program that no language here has words for is refused with the reason', () => {
  const of = (text, world) => copies(read({ text, world }), text, worldOf({ world })).why
  assert.match(of('x = F x +'), /^Line 1 has a fault: /)
  assert.match(of('P = P\nx = x\nJ = jac(inv(P) x, x)'), /no words for the derivative of inv\.$/)
  assert.match(of('P = P\nx = x\nS = (W - W) \\ y'), /^This program cannot be copied: .*no inverse/)
})

test('a program that its world does not fit, or that is not one yet, is refused with the reason', () => {
  for (const begin of UNFINISHED) {
    const { it, world } = begun(begin)
    const { copies: written, why } = copies(read(it), it.text, world)
    assert.deepEqual(written, [], begin)
    const fault =
      begin === 'sequential' ? /^This program cannot be copied: .*p = 2.*[^.]\.$/ : /^Line \d+ has a fault: ./
    assert.match(why, fault, begin)
  }
})

test('in another style a program is the same tree, with its comments and its empty lines', () => {
  const bare = (it) => JSON.stringify(it.tree().map(({ name, part, value }) => ({ name, part, value })))
  for (const { name, it, program } of all)
    for (const notation of ['choset', 'common']) {
      const text = styled(program, it.text, notation)
      const again = read({ ...it, text })
      assert.deepEqual(again.faults, [], `${name}\n${text}`)
      assert.equal(bare(again), bare(program), `${name}\n${text}`)
      assert.equal(styled(again, text, notation), text)
    }
  const text = "# the mean\n\nnu = y - H x   # seen\nx = x + P H' / (H P H' + W) *\n  nu # used\nP = inv(P)"
  const program = read({ text })
  const chapter = '# the mean\n\nν = y − H x # seen\nx = x + P Hᵀ / (H P Hᵀ + W) ν\n# used\nP = P⁻¹'
  assert.equal(styled(program, text, 'choset'), chapter)
  const typed = "# the mean\n\nnu = y - H*x # seen\nx = x + P*H'/(H*P*H' + W)*nu\n# used\nP = inv(P)"
  assert.equal(styled(program, text, 'common'), typed)
})
