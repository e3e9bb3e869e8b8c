// What the scripts share (scripts/common.sh): one at a time where they must be, tools set up whole or not at all,
// arguments refused before any work.
import { after, test } from 'node:test'
import assert from 'node:assert/strict'
import { spawn, spawnSync } from 'node:child_process'
import { cpSync, existsSync, mkdirSync, mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs'
import { once } from 'node:events'
import { tmpdir } from 'node:os'
import path from 'node:path'
import { fileURLToPath } from 'node:url'
import { HANGS_MS } from '../browser/places.mjs'

const root = fileURLToPath(new URL('../..', import.meta.url))
const home = mkdtempSync(path.join(tmpdir(), 'scripts-'))
after(() => rmSync(home, { recursive: true }))

/**
 * Runs lines of bash after scripts/common.sh, without the user's .bashrc: where its input is a socket, as a pipe of
 * Node's is, bash may take itself for a remote shell and read that, and a PATH of its own comes before the test's.
 */
const bash = (lines, env = {}) =>
  spawn('bash', ['--norc', '-c', `. scripts/common.sh; ${lines}`], { cwd: root, env: { ...process.env, ...env } })
const ended = async (program) => {
  let said = ''
  program.stderr.on('data', (part) => {
    said += part
  })
  const [status] = await once(program, 'close')
  return { status, said }
}
/** Waits until a program has said this. @param {RegExp} words */
const says = (program, words) =>
  new Promise((resolve) => {
    let said = ''
    program.stderr.on('data', (part) => {
      said += part
      if (words.test(said)) resolve(said)
    })
  })

test('of two scripts under one lock the second waits, and says so', async () => {
  const [lock, log, go] = ['lock', 'log', 'go'].map((name) => path.join(home, name))
  const run = (name) =>
    bash(
      `work() { echo '${name} in' >>'${log}'; until [ -e '${go}' ]; do sleep 0.05; done; ` +
        `echo '${name} out' >>'${log}'; }; ` +
        `alone '${lock}' 'the other' work`,
    )
  const first = run('a')
  while (!existsSync(log)) {
    await new Promise((resolve) => setTimeout(resolve, 50))
    assert.equal(first.exitCode, null, 'the first has ended')
  }
  const second = run('b')
  const both = [ended(first), ended(second)]
  // The first holds the lock until the second has said that it waits.
  await says(second, /Waiting for the other to end/)
  writeFileSync(go, '')
  assert.deepEqual(
    (await Promise.all(both)).map(({ status }) => status),
    [0, 0],
  )
  assert.equal(readFileSync(log, 'utf8'), 'a in\na out\nb in\nb out\n')
})

test('in a checkout that cannot be written to every script says so in a sentence', () => {
  const folder = path.join(home, 'closed')
  cpSync(path.join(root, 'scripts'), path.join(folder, 'scripts'), { recursive: true })
  // Whoever runs the tests may be allowed everything; a file in the folder's place stands in nobody's power.
  writeFileSync(path.join(folder, 'target'), '')
  for (const script of ['build', 'test', 'serve']) {
    const { status, stderr } = spawnSync(path.join(folder, 'scripts', script), [], { encoding: 'utf8' })
    assert.equal(status, 1, script)
    assert.match(
      stderr,
      /^\n✗ Nothing can be written into this checkout\.\n {2}The scripts put what they build/,
      script,
    )
    assert.doesNotMatch(stderr, /mkdir/)
  }
})

test('a lock ends with the script that held it, however it ends', async () => {
  const lock = path.join(home, 'lock-killed')
  const holder = bash(`alone '${lock}' 'the other' exec sleep 60`)
  let below = ''
  while (!/\bsleep\b/.test(below)) {
    await new Promise((resolve) => setTimeout(resolve, 50))
    below = spawnSync('ps', ['-o', 'pid=,comm=', '--ppid', String(holder.pid)], { encoding: 'utf8' }).stdout
    assert.equal(holder.exitCode, null, 'the holder has ended')
  }
  assert.ok(readdirSync(home).includes('lock-killed'))
  const children = [...below.matchAll(/^\s*(\d+)/gm)].map(([, pid]) => Number(pid))
  for (const pid of [...children, Number(holder.pid)]) process.kill(pid, 'SIGKILL')
  const { status } = await ended(bash(`alone '${lock}' 'the other' true`))
  assert.equal(status, 0)
})

/** A cargo that installs a program or fails, in front of the real one. */
function stub(name, body) {
  const folder = path.join(home, name)
  mkdirSync(folder)
  writeFileSync(path.join(folder, 'cargo'), `#!/usr/bin/env bash\n${body}\n`, { mode: 0o755 })
  return { PATH: `${folder}:${process.env.PATH}`, XDG_CACHE_HOME: path.join(folder, 'cache') }
}

test('a set-up that fails or was interrupted leaves nothing behind, and the next one succeeds', async () => {
  const failing = stub('failing', 'exit 1')
  const tools = path.join(failing.XDG_CACHE_HOME, 'robot-motion/tools')
  mkdirSync(path.join(tools, 'a-tool-1.2.3.part-999/bin'), { recursive: true })
  const failed = await ended(bash('need_tool a-tool a-tool 1.2.3', failing))
  assert.equal(failed.status, 1)
  assert.match(failed.said, /a-tool 1\.2\.3 could not be built/)
  assert.deepEqual(
    readdirSync(tools).filter((name) => name.startsWith('a-tool')),
    [],
  )

  const working = stub(
    'working',
    'while [ "$1" != --root ]; do shift; done; mkdir -p "$2/bin"; ' +
      'printf "#!/bin/sh\\necho a-tool 1.2.3\\n" >"$2/bin/a-tool"; chmod +x "$2/bin/a-tool"',
  )
  const done = await ended(bash('need_tool a-tool a-tool 1.2.3; [ "$(a-tool --version)" = "a-tool 1.2.3" ]', working))
  assert.equal(done.status, 0, done.said)
  assert.deepEqual(
    readdirSync(path.join(working.XDG_CACHE_HOME, 'robot-motion/tools')).filter((name) => name.startsWith('a-tool')),
    ['a-tool-1.2.3'],
  )
})

test('the module is compiled without the RUSTFLAGS of the user, who is told', async () => {
  const quiet = stub('quiet', 'exit 0')
  const { status, said } = await ended(
    bash('same_module_everywhere; [ -z "$(without_rustflags printenv RUSTFLAGS)" ]', {
      ...quiet,
      RUSTFLAGS: '-Ctarget-cpu=native',
    }),
  )
  assert.equal(status, 0, said)
  assert.match(said, /RUSTFLAGS is set/)
})

/** The scripts and the crates in a folder of their own, where a build harms nothing. */
function copy(name) {
  const folder = path.join(home, name)
  for (const one of [
    'scripts',
    'crates',
    'tests/Cargo.toml',
    'tests/src',
    'Cargo.toml',
    'Cargo.lock',
    '.cargo',
    'rustfmt.toml',
    'web/package.json',
    'web/package-lock.json',
  ]) {
    if (existsSync(path.join(root, one)))
      cpSync(path.join(root, one), path.join(folder, one), {
        recursive: true,
        filter: (from) => !/\/(target|node_modules)$/.test(from),
      })
  }
  return folder
}
/** Builds the module in such a copy. */
const buildIn = (folder, env) =>
  spawnSync('bash', ['scripts/build', '--module'], {
    cwd: folder,
    encoding: 'utf8',
    timeout: HANGS_MS,
    env: { ...process.env, ...env },
  })

test('the build takes the module from CARGO_BUILD_TARGET_DIR, and cargo is always told --locked', () => {
  const folder = copy('elsewhere')
  const [elsewhere, log] = [path.join(home, 'cargo target'), path.join(home, 'cargo-log')]
  const real = spawnSync('bash', ['-c', 'command -v cargo'], { encoding: 'utf8' }).stdout.trim()
  // It compiles nothing: a build leaves a file where cargo would, tools cannot be had, and all else is the real
  // cargo's.
  const env = stub(
    'compiling',
    `printf '%s\\n' "$*" >>'${log}'
case $1 in install) exit 1 ;; build) ;; *) exec '${real}' "$@" ;; esac
built="$CARGO_BUILD_TARGET_DIR/wasm32-unknown-unknown/release"
mkdir -p "$built"; echo compiled >"$built/estimate_wasm.wasm"; echo 'x: Cargo.toml' >"$built/estimate_wasm.d"`,
  )
  for (const tool of ['npm', 'wasm-bindgen'])
    writeFileSync(path.join(home, 'compiling', tool), '#!/bin/sh\nexit 1\n', { mode: 0o755 })
  const { stderr } = buildIn(folder, { ...env, CARGO_BUILD_TARGET_DIR: elsewhere, CARGO_TARGET_DIR: undefined })
  // Without tools it ends there; the module is taken by then.
  assert.equal(
    existsSync(path.join(folder, 'target/pkg/whole.wasm')) &&
      readFileSync(path.join(folder, 'target/pkg/whole.wasm'), 'utf8'),
    'compiled\n',
    stderr,
  )
  const calls = readFileSync(log, 'utf8')
    .trim()
    .split('\n')
    .filter((call) => !/^install|--version/.test(call))
  assert.ok(
    calls.some((call) => call.startsWith('build')) && calls.some((call) => call.startsWith('metadata')),
    `${calls}`,
  )
  assert.deepEqual(
    calls.filter((call) => !call.split(' ').includes('--locked')),
    [],
  )
})

test('a copy of a built folder compiles its own module, and not the one that it was copied with', () => {
  const first = copy('first')
  const core = 'crates/numerics/src/lib.rs'
  // Where cargo would leave a module stands a file of the core; what it was made of is noted as cargo does, by whole
  // paths.
  const real = spawnSync('bash', ['-c', 'command -v cargo'], { encoding: 'utf8' }).stdout.trim()
  const env = {
    ...stub(
      'noting',
      `case $1 in install) exit 1 ;; build) ;; *) exec '${real}' "$@" ;; esac
built="$PWD/target/wasm32-unknown-unknown/release"
mkdir -p "$built"; cp ${core} "$built/estimate_wasm.wasm"; echo "x: $PWD/${core}" >"$built/estimate_wasm.d"`,
    ),
    CARGO_BUILD_TARGET_DIR: undefined,
    CARGO_TARGET_DIR: undefined,
  }
  for (const tool of ['npm', 'wasm-bindgen'])
    writeFileSync(path.join(home, 'noting', tool), '#!/bin/sh\nexit 1\n', { mode: 0o755 })
  const moduleOf = (folder) => {
    const { stderr } = buildIn(folder, env)
    const file = path.join(folder, 'target/pkg/whole.wasm')
    assert.ok(existsSync(file), stderr)
    return readFileSync(file, 'utf8')
  }
  moduleOf(first)
  const second = path.join(home, 'second')
  cpSync(first, second, { recursive: true })
  writeFileSync(path.join(second, core), `${readFileSync(path.join(second, core), 'utf8')}// only here\n`)
  assert.match(moduleOf(second), /only here/)
  assert.doesNotMatch(moduleOf(first), /only here/)
})

test('a Cargo.lock that lags behind the manifests stops the build, and is left as it was', () => {
  const folder = copy('lagging')
  const [manifest, lock] = ['Cargo.toml', 'Cargo.lock'].map((name) => path.join(folder, name))
  writeFileSync(manifest, readFileSync(manifest, 'utf8').replace(/^version = "(\d+\.\d+)\.\d+"/m, 'version = "$1.999"'))
  const before = readFileSync(lock, 'utf8')
  const { status, stderr } = buildIn(folder, {})
  assert.notEqual(status, 0)
  assert.match(stderr, /--locked|Cargo\.lock/)
  assert.equal(readFileSync(lock, 'utf8'), before)
})

test('an argument that a script does not know stops it at once', () => {
  for (const [script, argument] of [
    ['serve', '--prot=80'],
    ['build', '--modul'],
    ['release', '--quick'],
    ['test', 'browsers'],
    ['bench', 'everything'],
  ]) {
    const { status, stderr } = spawnSync('bash', [`scripts/${script}`, argument], {
      cwd: root,
      encoding: 'utf8',
      timeout: HANGS_MS,
    })
    assert.equal(status, 1, script)
    assert.match(stderr, /knows|know /, script)
  }
})
