// What somebody who cites, publishes or packs the book reads of it says the same everywhere.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { spawnSync } from 'node:child_process'
import { cpSync, existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import path from 'node:path'

const read = (name) => readFileSync(new URL(`../../${name}`, import.meta.url), 'utf8')
const manifest = read('Cargo.toml')
const field = (name) => new RegExp(`^${name} = "(.+)"$`, 'm').exec(manifest)[1]

test('the citation is of this version, and names the licences of code and prose', () => {
  const citation = read('CITATION.cff')
  assert.match(citation, new RegExp(`^version: ${field('version')}$`, 'm'))
  const licences = [...citation.matchAll(/^ {2}- ([\w.-]+)$/gm)]
    .map(([, licence]) => licence)
    .filter((one) => /^(MIT|Apache|CC)/.test(one))
  assert.deepEqual(licences, [...field('license').split(' OR '), 'CC-BY-4.0'])
})

test('the README cites what CITATION.cff cites', () => {
  const citation = read('CITATION.cff')
  const of = (name) => new RegExp(`^\\s*(?:- )?${name}: "?(.+?)"?$`, 'm').exec(citation)[1]
  const readme = read('README.md')
  for (const line of [
    `author  = {{${of('name')}}}`,
    `title   = {${of('title')}}`,
    `version = {${of('version')}}`,
    `year    = {${of('date-released').slice(0, 4)}}`,
  ]) {
    assert.ok(readme.includes(line), line)
  }
})

test('the pictures of the README are there, light and dark', () => {
  const names = [...read('README.md').matchAll(/(?:srcset|src)="([^"]+)"/g)].map(([, name]) => name)
  assert.deepEqual(
    names.map((name) => name.replace(/-(light|dark)\.png$/, '')).filter((name, i, all) => all.indexOf(name) === i)
      .length,
    names.length / 2,
  )
  for (const name of names) assert.ok(existsSync(new URL(`../../${name}`, import.meta.url)), name)
})

test("README, the prose's own folder and every page say how the prose is licensed", () => {
  const address = 'https://creativecommons.org/licenses/by/4.0/'
  for (const page of [
    'README.md',
    'content/LICENSE.md',
    'dist/index.html',
    'dist/kalman/index.html',
    'dist/log/index.html',
  ]) {
    assert.ok(read(page).includes(address), page)
  }
})

const core = ['numerics', 'geom', 'filters', 'estimate']

test('each core crate is a package with what a registry asks for, its licences and a README that is compiled', () => {
  for (const name of core) {
    const crate = read(`crates/${name}/Cargo.toml`)
    for (const line of [
      `name = "robot-motion-${name}"`,
      'publish = true',
      `documentation = "https://docs.rs/robot-motion-${name}"`,
      'readme = "README.md"',
      '[package.metadata.docs.rs]',
    ]) {
      assert.ok(crate.includes(`${line}\n`), `${name}: ${line}`)
    }
    for (const list of ['keywords', 'categories']) {
      const words = new RegExp(`^${list} = (\\[.*\\])$`, 'm').exec(crate)
      assert.ok(words && JSON.parse(words[1]).length >= 2 && JSON.parse(words[1]).length <= 5, `${name}: ${list}`)
    }
    for (const licence of ['LICENSE-MIT', 'LICENSE-APACHE'])
      assert.equal(read(`crates/${name}/${licence}`), read(licence), name)
    assert.match(read(`crates/${name}/README.md`), /```rust/)
    assert.match(read(`crates/${name}/src/lib.rs`), /^#!\[doc = include_str!\("\.\.\/README\.md"\)\]/)
  }
})

test('the Rust examples of the READMEs ask for no crate but their own', () => {
  for (const [file, library] of [
    ['README.md', 'estimate'],
    ...core.map((name) => [`crates/${name}/README.md`, name]),
  ]) {
    const examples = [...read(file).matchAll(/^```rust\n([\s\S]*?)^```$/gm)].map(([, text]) => text)
    assert.ok(examples.length > 0, file)
    for (const example of examples) {
      const roots = [
        ...example.matchAll(/(?:^use |(?<![:\w])(?=(?:libm|nalgebra|numerics|geom|filters|estimate)::))([a-z_]+)::/gm),
      ].map(([, name]) => name)
      assert.deepEqual(
        roots.filter((name) => ![library, 'core'].includes(name)),
        [],
        file,
      )
      // nalgebra's macros name the crate nalgebra, wherever they were imported from.
      assert.doesNotMatch(example, /(matrix|vector|stack|point)!/, file)
    }
  }
})

test('the script packs and compares these crates', () => {
  assert.ok(read('scripts/release').includes(`core=(${core.join(' ')})\n`))
})

test('the release is not made of what is not committed, nor under the tag of another version', () => {
  const folder = mkdtempSync(path.join(tmpdir(), 'release-'))
  const run = (...command) =>
    spawnSync(command[0], command.slice(1), {
      cwd: folder,
      encoding: 'utf8',
      env: { ...process.env, GIT_CONFIG_GLOBAL: '/dev/null' },
    })
  const git = (...words) => run('git', '-c', 'user.name=a', '-c', 'user.email=a@book.example', ...words)
  try {
    git('init', '-q')
    for (const name of ['scripts/release', 'scripts/common.sh', 'Cargo.toml'])
      cpSync(new URL(`../../${name}`, import.meta.url), path.join(folder, name))
    git('add', '-A')
    git('commit', '-qm', 'One')
    assert.match(run('bash', 'scripts/release', '--untested').stderr, /No links to figures are kept/)
    git('tag', 'v9.9.9')
    assert.match(run('bash', 'scripts/release', '--untested').stderr, /v9\.9\.9 is of another version/)
    writeFileSync(path.join(folder, 'new'), '')
    assert.match(run('bash', 'scripts/release', '--untested').stderr, /not committed/)
  } finally {
    rmSync(folder, { recursive: true })
  }
})

test('crates that depend on one another ask for the version they have', () => {
  for (const name of ['geom', 'filters', 'estimate']) {
    for (const [, version] of read(`crates/${name}/Cargo.toml`).matchAll(/path = "\.\.\/\w+", version = "([^"]+)"/g))
      assert.equal(version, field('version'), name)
  }
})
