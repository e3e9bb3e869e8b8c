// Writes what scripts/package has not made yet of the package for npm: manifest, entries, declarations, digests, licences.
import { cpSync, readFileSync, readdirSync, writeFileSync } from 'node:fs'
import { createRequire } from 'node:module'
import path from 'node:path'
import { fileURLToPath } from 'node:url'

const root = path.resolve(path.dirname(fileURLToPath(import.meta.url)), '..')
const [parts, out] = [path.join(root, 'target/npm/parts'), path.join(root, 'target/npm/package')]
const read = (name) => readFileSync(path.join(parts, name), 'utf8')
const write = (name, text) => writeFileSync(path.join(out, name), text)
const core = createRequire(import.meta.url)(path.join(root, 'target/pkg/node/estimate_wasm.js'))

const metadata = JSON.parse(read('metadata'))
const ours = metadata.packages.find(({ name }) => name === 'estimate-wasm')

const types = { import: './index.d.ts', require: './index.d.cts' }
write(
  'package.json',
  `${JSON.stringify(
    {
      name: ours.metadata.npm.name,
      version: ours.version,
      description: ours.description,
      keywords: ours.metadata.npm.keywords,
      license: ours.license,
      // Taken out by whoever publishes it.
      private: true,
      type: 'module',
      engines: { node: '>=20' },
      // These load the binary when they are imported; a bundler must not drop them.
      sideEffects: ['./index.js', './node.js', './node.cjs'],
      main: './node.cjs',
      types: './index.d.cts',
      exports: {
        '.': {
          node: {
            import: { types: types.import, default: './node.js' },
            require: { types: types.require, default: './node.cjs' },
          },
          default: { types: types.import, default: './index.js' },
        },
        './slim': {
          import: { types: './slim.d.ts', default: './slim.js' },
          require: { types: './slim.d.cts', default: './slim.cjs' },
        },
        './estimate.wasm': './estimate.wasm',
        './digests.json': './digests.json',
        './package.json': './package.json',
      },
    },
    null,
    2,
  )}\n`,
)

// ── Entries: the same binary and the same names for all. In Node both kinds of import share one module. ──
const names = Object.keys(core)
  .filter((name) => typeof core[name] === 'function' && !name.startsWith('_') && name !== 'start')
  .sort()
write(
  'index.js',
  `// For browsers, workers and bundlers: the binary beside this file is loaded before the import is done.
import init, { ${names.join(', ')} } from './slim.js'

await init({ module_or_path: new URL('./estimate.wasm', import.meta.url) })

export { ${names.join(', ')} }
`,
)
write(
  'node.cjs',
  `'use strict'
const { readFileSync } = require('node:fs')
const { join } = require('node:path')
const core = require('./slim.cjs')

core.initSync({ module: readFileSync(join(__dirname, 'estimate.wasm')) })

${names.map((name) => `exports.${name} = core.${name}`).join('\n')}
`,
)
write(
  'node.js',
  `import core from './node.cjs'

export const { ${names.join(', ')} } = core
`,
)
cpSync(path.join(root, 'target/pkg/web/estimate_wasm_bg.wasm'), path.join(out, 'estimate.wasm'))

// ── Declarations. `start` is called by whoever loads the binary. ──
const disposable = '/// <reference lib="esnext.disposable" />\n'
const withoutStart = (text) => text.replace(/\/\*\*(?:(?!\*\/)[\s\S])*\*\/\nexport function start\(\): void;\n/, '')
const whole = withoutStart(readFileSync(path.join(root, 'target/pkg/node/estimate_wasm.d.ts'), 'utf8'))
if (/function start\b/.test(whole)) throw new Error('the declaration of start is still there')
for (const [name, text] of [
  ['index', whole],
  ['slim', withoutStart(read('estimate_wasm.d.ts'))],
]) {
  for (const extension of ['d.ts', 'd.cts']) write(`${name}.${extension}`, disposable + text)
}

// ── The digests of the reference runs, as the native code has them; but those over a robot's log, which the package does not hold. ──
const labs = Object.fromEntries(
  names.flatMap((name) => {
    try {
      const lab = new core[name]()
      return lab.digest ? [[lab.state().lab, name]] : []
    } catch {
      return []
    }
  }),
)
const digests = read('digests')
  .trim()
  .split('\n')
  .filter((line) => !line.startsWith('robot-log '))
  .map((line) => {
    const [lab, digest, params] = line.split(' ')
    if (!labs[lab]) throw new Error(`the module has no lab ${lab}`)
    return { class: labs[lab], params: JSON.parse(params), steps: 10_000, digest }
  })
write('digests.json', `${JSON.stringify(digests, null, 2)}\n`)

// ── README and licences: ours, and those of the crates that are compiled into the binary. ──
for (const file of ['LICENSE-MIT', 'LICENSE-APACHE']) cpSync(path.join(root, file), path.join(out, file))
cpSync(path.join(root, 'crates/estimate-wasm/README.md'), path.join(out, 'README.md'))
write('THIRD-PARTY.txt', thirdParty())

/** The notices of all crates in the binary; a text that several have stands once. */
function thirdParty() {
  const byId = new Map(metadata.packages.map((one) => [one.id, one]))
  const links = new Map(
    metadata.resolve.nodes.map(({ id, deps }) => [
      id,
      deps.filter(({ dep_kinds: kinds }) => kinds.some(({ kind }) => kind === null)).map(({ pkg }) => pkg),
    ]),
  )
  const found = new Set()
  const walk = (id) => {
    if (found.has(id) || byId.get(id).targets.some(({ kind }) => kind.includes('proc-macro'))) return
    found.add(id)
    links.get(id).forEach(walk)
  }
  walk(ours.id)
  const texts = new Map()
  for (const { name, version, license, repository, manifest_path: manifest, source } of [...found].map((id) =>
    byId.get(id),
  )) {
    if (!source) continue
    const folder = path.dirname(manifest)
    const files = readdirSync(folder).filter((file) => /^(licen[cs]e|copying|notice|unlicense)/i.test(file))
    // Of licences to choose from, MIT.
    const chosen =
      license.includes(' OR ') && files.some((file) => /mit/i.test(file))
        ? files.filter((file) => /mit|notice/i.test(file))
        : files
    // A crate without a file of its licence is named with its licence.
    if (chosen.length === 0) texts.set(`${name}: ${repository ?? name}`, [`${name} ${version} (${license})`])
    for (const file of chosen) {
      const text = readFileSync(path.join(folder, file), 'utf8').trim()
      texts.set(text, [...(texts.get(text) ?? []), `${name} ${version} (${license})`])
    }
  }
  const blocks = [...texts].map(([text, crates]) => `${crates.join('\n')}\n\n${text}\n`)
  return `The binary is compiled from Rust with its standard library (MIT OR Apache-2.0), and from these crates.\n\n${blocks.join(`\n${'─'.repeat(72)}\n\n`)}`
}
