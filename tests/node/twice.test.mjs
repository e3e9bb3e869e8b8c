// Two builds of one commit are the same site, byte for byte, wherever they are made. The site in dist/ is compared with
// one made in another folder from a copy of the sources: fonts, scripts, styles, stills and pages anew, with the module
// and the book's program as they were compiled. Of the module, which takes a minute to compile, the test asks that it
// names no folder of this machine.
import { after, test } from 'node:test'
import assert from 'node:assert/strict'
import { execFileSync } from 'node:child_process'
import { cpSync, existsSync, mkdirSync, mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs'
import { homedir, tmpdir } from 'node:os'
import path from 'node:path'
import { fileURLToPath } from 'node:url'
import { FIGURES } from '../../target/figures.js'

const root = fileURLToPath(new URL('../..', import.meta.url))
const SOURCES = ['content', 'web', 'crates', 'tests', 'Cargo.toml', 'Cargo.lock']
const other = mkdtempSync(path.join(tmpdir(), 'another folder '))
after(() => rmSync(other, { recursive: true }))

/** Every file below a folder, by its path there. */
function files(folder) {
  const names = readdirSync(folder, { recursive: true, withFileTypes: true }).filter((entry) => entry.isFile())
  return new Map(
    names.map((entry) => {
      const file = path.join(entry.parentPath ?? /** @type {any} */ (entry).path, entry.name)
      return [path.relative(folder, file), readFileSync(file)]
    }),
  )
}

test('a build in another folder writes the same site', { timeout: 300_000 }, () => {
  assert.ok(existsSync(path.join(root, 'dist/index.html')), 'dist/ has no site yet: run ./scripts/build')
  for (const name of SOURCES) {
    cpSync(path.join(root, name), path.join(other, name), {
      recursive: true,
      filter: (from) => !/[/\\](node_modules|target)$/.test(from),
    })
  }
  // Copied, not linked: the bundler follows links, and a file outside the folder would have another name in its hashes.
  const unused = /[/\\]node_modules[/\\](binaryen|typescript)$/
  cpSync(path.join(root, 'web/node_modules'), path.join(other, 'web/node_modules'), {
    recursive: true,
    filter: (from) => !unused.test(from),
  })
  mkdirSync(path.join(other, 'target'))
  cpSync(path.join(root, 'target/pkg'), path.join(other, 'target/pkg'), { recursive: true })
  // The book prints what examples print, and runs them by cargo: with the programs compiled here, since cargo would
  // compile all crates again in another folder.
  const cargo = path.join(other, 'cargo')
  writeFileSync(cargo, `#!/bin/sh\ncd '${root}' && exec cargo "$@"\n`, { mode: 0o755 })
  const { target_directory: target } = JSON.parse(
    execFileSync('cargo', ['metadata', '--no-deps', '--locked', '--format-version', '1'], {
      cwd: root,
      encoding: 'utf8',
      maxBuffer: 2 ** 26,
    }),
  )
  execFileSync('cargo', ['build', '--quiet', '--locked', '-p', 'book'], { cwd: root, stdio: 'pipe' })
  execFileSync(path.join(target, 'debug/book'), ['--list', 'target'], { cwd: other, stdio: 'pipe' })
  for (const script of ['web/build/build.mjs', 'web/build/stills.mjs'])
    execFileSync(process.execPath, [path.join(other, script)], { cwd: other, stdio: 'pipe' })
  execFileSync(path.join(target, 'debug/book'), ['--strict', '--out', 'site'], {
    cwd: other,
    stdio: 'pipe',
    env: { ...process.env, CARGO: cargo },
  })

  const [here, there] = [files(path.join(root, 'dist')), files(path.join(other, 'site'))]
  assert.deepEqual([...there.keys()].sort(), [...here.keys()].sort())
  const differing = [...here].filter(([name, bytes]) => !bytes.equals(there.get(name))).map(([name]) => name)
  assert.deepEqual(differing, [], 'is dist/ of these sources? ./scripts/build makes it so')
})

test('the module names no folder of this machine', () => {
  for (const folder of new Set(['web', 'node', ...FIGURES.map(({ build }) => build)])) {
    const binary = readFileSync(path.join(root, 'target/pkg', folder, 'estimate_wasm_bg.wasm')).toString('latin1')
    for (const place of [root.replace(/\/$/, ''), homedir(), process.env.CARGO_HOME]) {
      assert.ok(!place || place.length < 3 || !binary.includes(place), `${folder} names ${place}`)
    }
  }
})
