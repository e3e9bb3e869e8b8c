// Writes what scripts/package has not made yet of the package for npm: manifest, entries, declarations, digests,
// licences.
import { cpSync, readFileSync, readdirSync, writeFileSync } from 'node:fs'
import { createRequire } from 'node:module'
import path from 'node:path'
import { fileURLToPath } from 'node:url'
import { FIGURES } from '../target/figures.js'

const root = path.resolve(path.dirname(fileURLToPath(import.meta.url)), '..')
const [parts, out] = [path.join(root, 'target/npm/parts'), path.join(root, 'target/npm/package')]
const read = (name) => readFileSync(path.join(parts, name), 'utf8')
const write = (name, text) => writeFileSync(path.join(out, name), text)
const require = createRequire(import.meta.url)
const core = require(path.join(root, 'target/pkg/node/estimate_wasm.js'))

const metadata = JSON.parse(read('metadata'))
const ours = metadata.packages.find(({ name }) => name === 'estimate-wasm')

/** The package's entries: the folder of each, and where its module and its declarations were built. */
const ENTRIES = [
  { at: '.', part: 'whole', built: 'target/pkg/node' },
  { at: './filters', part: 'filters', built: 'target/pkg/filters' },
]
const conditions = (at) => ({
  [at]: {
    node: {
      import: { types: `${at}/index.d.ts`, default: `${at}/node.js` },
      require: { types: `${at}/index.d.cts`, default: `${at}/node.cjs` },
    },
    default: { types: `${at}/index.d.ts`, default: `${at}/index.js` },
  },
  [`${at}/slim`]: {
    import: { types: `${at}/slim.d.ts`, default: `${at}/slim.js` },
    require: { types: `${at}/slim.d.cts`, default: `${at}/slim.cjs` },
  },
  [`${at}/estimate.wasm`]: `${at}/estimate.wasm`,
})
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
      sideEffects: ENTRIES.flatMap(({ at }) => ['index.js', 'node.js', 'node.cjs'].map((file) => `${at}/${file}`)),
      main: './node.cjs',
      types: './index.d.cts',
      exports: {
        ...Object.assign({}, ...ENTRIES.map(({ at }) => conditions(at))),
        './digests.json': './digests.json',
        './package.json': './package.json',
      },
    },
    null,
    2,
  )}\n`,
)

const disposable = '/// <reference lib="esnext.disposable" />\n'
/** `start` is called by whoever loads the binary. */
const withoutStart = (text) => text.replace(/\/\*\*(?:(?!\*\/)[\s\S])*\*\/\nexport function start\(\): void;\n/, '')

/** Writes an entry: the same binary and the same names for all. In Node both kinds of import share one module. */
function writeEntry({ at, part, built }) {
  const names = namesOf(require(path.join(root, built, 'estimate_wasm.js')))
  write(
    `${at}/index.js`,
    `// For browsers, workers and bundlers: the binary beside this file is loaded before the import is done.
import init, { ${names.join(', ')} } from './slim.js'

const binary = new URL('./estimate.wasm', import.meta.url)
await init({ module_or_path: binary }).catch((cause) => {
  const slim = '${path.posix.join(ours.metadata.npm.name, at, 'slim')}'
  const help = \`With esbuild, import \${slim} (README, "In a page").\`
  throw new Error(\`The binary could not be loaded from \${binary}: \${cause.message} \${help}\`, { cause })
})

export { ${names.join(', ')} }
`,
  )
  write(
    `${at}/node.cjs`,
    `'use strict'
const { readFileSync } = require('node:fs')
const { join } = require('node:path')
const core = require('./slim.cjs')

core.initSync({ module: readFileSync(join(__dirname, 'estimate.wasm')) })

${names.map((name) => `exports.${name} = core.${name}`).join('\n')}
`,
  )
  write(
    `${at}/node.js`,
    `import core from './node.cjs'

export const { ${names.join(', ')} } = core
`,
  )
  cpSync(path.join(root, built, 'estimate_wasm_bg.wasm'), path.join(out, at, 'estimate.wasm'))
  const declared = withoutStart(readFileSync(path.join(root, built, 'estimate_wasm.d.ts'), 'utf8'))
  if (/function start\b/.test(declared)) throw new Error('the declaration of start is still there')
  for (const extension of ['d.ts', 'd.cts']) {
    write(`${at}/index.${extension}`, disposable + declared)
    write(`${at}/slim.${extension}`, disposable + withoutStart(read(`${part}/estimate_wasm.d.ts`)))
  }
}
function namesOf(module) {
  const exported = ([name, value]) => typeof value === 'function' && !name.startsWith('_') && name !== 'start'
  return Object.entries(module)
    .filter(exported)
    .map(([name]) => name)
    .sort()
}
for (const entry of ENTRIES) writeEntry(entry)

// ── The digests of the reference runs, as the native code has them; but those over a robot's log, which the package
// does not hold. ──
const classes = new Map(FIGURES.map(({ name, lab }) => [name, lab]))
const overLogs = FIGURES.filter(({ world }) => world).map(({ name }) => name)
const digests = read('digests')
  .trim()
  .split('\n')
  .filter((line) => !overLogs.includes(line.split(' ')[0]))
  .map((line) => {
    const [lab, digest, params] = line.split(' ')
    const known = classes.get(lab) ?? ''
    if (!core[known]) throw new Error(`the module has no lab ${lab}`)
    return { class: known, params: JSON.parse(params), steps: 10_000, digest }
  })
write('digests.json', `${JSON.stringify(digests, null, 2)}\n`)

// ── README and licences: ours, and those of the crates that are compiled into the binary. ──
for (const file of ['LICENSE-MIT', 'LICENSE-APACHE']) cpSync(path.join(root, file), path.join(out, file))
const pages = ['README.md', 'COMING-FROM.md']
for (const name of pages) cpSync(path.join(root, 'crates/estimate-wasm', name), path.join(out, name))
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
  const head = 'The binary is compiled from Rust with its standard library (MIT OR Apache-2.0), and from these crates.'
  return `${head}\n\n${blocks.join(`\n${'─'.repeat(72)}\n\n`)}`
}
