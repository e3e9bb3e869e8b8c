// The workflows give away no right that they need not: actions are pinned by commit, and the one job that may write
// runs nothing of the repository.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { readFileSync, readdirSync } from 'node:fs'
import { fileURLToPath } from 'node:url'
import path from 'node:path'

const folder = fileURLToPath(new URL('../../.github/workflows', import.meta.url))
const workflows = readdirSync(folder).map((name) => [name, readFileSync(path.join(folder, name), 'utf8')])

test('every action is pinned by its commit', () => {
  for (const [name, text] of workflows) {
    for (const [, action] of text.matchAll(/^\s*-?\s*uses:\s*(\S+)/gm)) {
      assert.match(action, /^\.\/\.github\/workflows\/|@[0-9a-f]{40}$/, `${name}: ${action}`)
    }
  }
})

test('a job that may write neither checks out nor runs code of the repository', () => {
  for (const [name, text] of workflows) {
    const [head, body] = text.split(/^jobs:$/m)
    const jobs = body.split(/^ {2}(?=[\w-]+:$)/m)
    assert.doesNotMatch(head, /: write/, `${name}: for all jobs`)
    assert.match(head, /^permissions:/m, name)
    for (const job of jobs.filter((one) => /: write/.test(one))) {
      assert.doesNotMatch(job, /\brun:|actions\/checkout|uses: \.\//, `${name}: ${job.split(':')[0]}`)
    }
  }
})

test('every push and pull request runs all tests, the thirteen checks by wasm-pack among them', () => {
  assert.match(readFileSync(path.join(folder, 'test.yml'), 'utf8'), /^ +- run: \.\/\.ci\/run$/m)
  assert.match(readFileSync(path.join(folder, 'pages.yml'), 'utf8'), /^ +uses: \.\/\.github\/workflows\/test\.yml$/m)
  const [script, tests] = ['.ci/run', 'scripts/test'].map((name) =>
    readFileSync(path.join(folder, '../..', name), 'utf8'),
  )
  assert.match(script, /^exec scripts\/test --ci "\$@"$/m)
  assert.match(tests, /^ +--ci\) with_wasm=yes ;;$/m)
  assert.match(tests, /^ +wasm-pack .*test --node .*tests --test thirteen_checks$/m)
})

test('on a tag the release is made by the script that a person runs, with the releases before it at hand', () => {
  const text = readFileSync(path.join(folder, 'release.yml'), 'utf8')
  assert.match(text, /^ {4}tags: \['v\*'\]$/m)
  assert.match(text, /^ +- run: scripts\/release$/m)
  assert.match(text, /^ +fetch-depth: 0$/m)
  assert.match(text, /^ +path: target\/releases$/m)
})

test('what the step bare needs is installed wherever the tests run', () => {
  const script = readFileSync(path.join(folder, '../../scripts/test'), 'utf8')
  const [, target] = /\btarget=(\S+)/.exec(script)
  for (const name of ['test.yml', 'release.yml']) {
    const text = readFileSync(path.join(folder, name), 'utf8')
    assert.ok(text.includes(`rustup target add ${target}\n`), name)
    assert.match(text, /rustup toolchain install "\$\(sed -n 's\/\^rust-version/, name)
  }
})
