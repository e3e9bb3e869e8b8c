// The npm package as somebody finds it: installed from its tarball into empty folders, and used by Node, by bundlers,
// by a page without any, in workers, and by TypeScript. The README's examples are what is run.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { readFileSync, readdirSync, writeFileSync } from 'node:fs'
import { homedir } from 'node:os'
import path from 'node:path'
import { gzipSync } from 'node:zlib'
import { EXAMPLES, NAME, answerOf, folder, installed, node, root, run, tarball } from './folder.mjs'

const bin = (where, name) => path.join(root, where, 'node_modules/.bin', name)

/** Runs every reference run, and answers where the digest is another. */
const REFERENCE = `
const others = digests.filter(({ class: name, params, steps, digest }) => {
  const lab = new core[name](params)
  lab.run(steps)
  return lab.digest() !== digest
})`
const NODE_REFERENCE = `import * as core from '${NAME}'
import { readFileSync } from 'node:fs'
const digests = JSON.parse(readFileSync(new URL(import.meta.resolve('${NAME}/digests.json'))))
${REFERENCE}
console.log(JSON.stringify({ runs: digests.length, others }))`

const place = await folder('node', { ...EXAMPLES, 'reference.mjs': NODE_REFERENCE })

test('the package holds what its README and manifest name, and nothing of this machine', () => {
  const entry = ['estimate.wasm', 'index.d.cts', 'index.d.ts', 'index.js', 'node.cjs', 'node.js']
  entry.push('slim.cjs', 'slim.d.cts', 'slim.d.ts', 'slim.js')
  const files = readdirSync(installed(place), { recursive: true }).filter((file) => file !== 'filters')
  const once = [
    'COMING-FROM.md',
    'LICENSE-APACHE',
    'LICENSE-MIT',
    'README.md',
    'THIRD-PARTY.txt',
    'digests.json',
    'package.json',
  ]
  assert.deepEqual(files.sort(), [...once, ...entry, ...entry.map((file) => `filters/${file}`)].sort())
  for (const file of files) {
    const bytes = readFileSync(path.join(installed(place), String(file)), 'latin1')
    for (const secret of [root, homedir()])
      assert.ok(!bytes.includes(secret) || secret.length < 6, `${file} names ${secret}`)
  }
  const manifest = JSON.parse(readFileSync(path.join(installed(place), 'package.json'), 'utf8'))
  assert.equal(manifest.name, NAME)
  assert.equal(manifest.private, true)
  const readme = readFileSync(path.join(installed(place), 'README.md'), 'utf8')
  assert.ok(readme.startsWith(`# ${NAME}\n`) && readme.includes(`npm install ./${path.basename(tarball)}\n`))
})

test('publint and arethetypeswrong find nothing wrong', async () => {
  await run(bin('tests/package', 'publint'), ['run', tarball, '--strict'])
  await run(bin('tests/package', 'attw'), [
    tarball,
    '--profile',
    'node16',
    '--exclude-entrypoints',
    'estimate.wasm',
    'filters/estimate.wasm',
    '--format',
    'ascii',
  ]).catch((error) => {
    throw new Error(error.stdout)
  })
})

test('imported and required it is one module', async () => {
  writeFileSync(
    path.join(place, 'both.mjs'),
    `import { createRequire } from 'node:module'
import * as imported from '${NAME}'
const required = createRequire(import.meta.url)('${NAME}')
const more = Object.keys(imported).filter((name) => !required[name] && name !== 'default')
console.log(Object.keys(required).every((name) => required[name] === imported[name]), more.length)`,
  )
  assert.equal(await node(place, 'both.mjs'), 'true 0')
})

test('the slim entry runs on bytes that its caller brings, imported and required', async () => {
  assert.equal(await node(place, 'slim.mjs'), '1')
  writeFileSync(
    path.join(place, 'slim.cjs'),
    `const { initSync, observability } = require('${NAME}/slim')
initSync({ module: require('node:fs').readFileSync(require.resolve('${NAME}/estimate.wasm')) })
console.log(observability([[1, 0.5], [0, 1]], [[1, 0]]).rank)`,
  )
  assert.equal(await node(place, 'slim.cjs'), '2')
})

test('the entry without labs has the filters of the whole, bit for bit, and no lab', async () => {
  const light = EXAMPLES['track.mjs'].replace(`'${NAME}'`, `'${NAME}/filters'`)
  writeFileSync(path.join(place, 'light.mjs'), light)
  assert.equal(await node(place, 'light.mjs'), await node(place, 'track.mjs'))
  writeFileSync(
    path.join(place, 'entries.cjs'),
    `const [whole, filters] = [require('${NAME}'), require('${NAME}/filters')]
console.log(JSON.stringify({ whole: Object.keys(whole), filters: Object.keys(filters) }))`,
  )
  const { whole, filters } = JSON.parse(await node(place, 'entries.cjs'))
  assert.deepEqual(
    filters.filter((name) => !whole.includes(name)),
    [],
  )
  for (const name of ['KalmanFilter', 'Timeline', 'kalmanReplay', 'EkfLocalizer', 'EkfSlam'])
    assert.ok(filters.includes(name), name)
  const labs = JSON.parse(readFileSync(path.join(installed(place), 'digests.json'), 'utf8')).map((run) => run.class)
  assert.deepEqual(
    filters.filter((name) => labs.includes(name) || /Log|chapter/.test(name)),
    [],
  )
  for (const kind of ['index', 'slim']) {
    const declared = readFileSync(path.join(installed(place), `filters/${kind}.d.ts`), 'utf8')
    assert.doesNotMatch(declared, /Lab|Params|Frame|\bCheck\b/)
  }
})

test('in Node the reference runs have the digests of the native code', async () => {
  const { runs, others } = JSON.parse(await node(place, 'reference.mjs'))
  assert.ok(runs >= 10)
  assert.deepEqual(others, [])
})

/** A page that filters as the README does, asks the README's worker, and runs the reference runs. */
const RULES = "default-src 'self'; script-src 'self' 'wasm-unsafe-eval'"
const POLICY = `<meta http-equiv="content-security-policy" content="${RULES}">`
const MAIN = `${EXAMPLES['track.mjs'].replace(/console\.log.*\n/g, '')}
import * as core from '${NAME}'
import digests from '${NAME}/digests.json'
const worker = new Worker(new URL('./worker.js', import.meta.url), { type: 'module' })
const said = () => new Promise((resolve, reject) => {
  worker.onmessage = ({ data }) => resolve(data)
  worker.onerror = () => reject(new Error('the worker failed'))
})
await said()
const V = [[0.01, 0, 0], [0, 0.01, 0], [0, 0, 0.01]]
worker.postMessage({ u: [1, 0], V, reading: { range: 0.9, bearing: Math.PI } })
const robot = await said()
${REFERENCE}
window.answer = { x: filter.x, P: filter.P, robot, runs: digests.length, others }
`
const built = (main) => `<!doctype html><meta charset="utf-8"><link rel="icon" href="data:,">${main}`

async function asInNode(answer) {
  writeFileSync(
    path.join(place, 'expected.mjs'),
    `${EXAMPLES['track.mjs'].replace(/console\.log.*\n/g, '')}
import { EkfLocalizer } from '${NAME}'
const belief = { x: [0, 0, 0], P: [[0.04, 0, 0], [0, 0.04, 0], [0, 0, 0.01]] }
const robot = new EkfLocalizer(belief, [{ id: 7, x: 2, y: 0 }], { W: [[0.01, 0], [0, 0.01]], gate: 9.21 })
robot.predict([1, 0], [[0.01, 0, 0], [0, 0.01, 0], [0, 0, 0.01]])
const { outcome } = robot.update({ range: 0.9, bearing: Math.PI })
console.log(JSON.stringify({ x: filter.x, P: filter.P, robot: { outcome, pose: robot.belief().x } }))`,
  )
  const expected = JSON.parse(await node(place, 'expected.mjs'))
  assert.deepEqual({ x: answer.x, P: answer.P, robot: answer.robot }, expected)
  assert.equal(expected.robot.outcome, 'accepted')
  assert.ok(answer.runs >= 10)
  assert.deepEqual(answer.others, [], 'reference runs with another digest')
}

test('Vite builds it, with a worker, under a strict policy: the same bits in Chromium', async () => {
  const { build } = await import('vite')
  const html = built(`${POLICY}<script type="module" src="./main.js"></script>`)
  const at = await folder('vite', { 'index.html': html, 'main.js': MAIN, 'worker.js': EXAMPLES['worker.js'] })
  await build({ root: at, configFile: false, logLevel: 'error', base: './', worker: { format: 'es' } })
  await asInNode(await answerOf(path.join(at, 'dist')))
})

test('a page that filters without labs fetches at most 152 kB with gzip: the same bits in Chromium', async (t) => {
  const { build } = await import('vite')
  const main = `${EXAMPLES['track.mjs'].replace(`'${NAME}'`, `'${NAME}/filters'`).replace(/console\.log.*\n/g, '')}
window.answer = { x: filter.x, P: filter.P }`
  const html = built(`${POLICY}<script type="module" src="./main.js"></script>`)
  const at = await folder('light', { 'index.html': html, 'main.js': main })
  await build({ root: at, configFile: false, logLevel: 'error', base: './' })
  const { x, P } = await answerOf(path.join(at, 'dist'))
  writeFileSync(
    path.join(place, 'same.mjs'),
    `${main.replace('window.answer =', 'const answer =')}\nconsole.log(JSON.stringify(answer))`,
  )
  assert.deepEqual({ x, P }, JSON.parse(await node(place, 'same.mjs')))
  const assets = path.join(at, 'dist/assets')
  const weights = readdirSync(assets).map(
    (file) => gzipSync(readFileSync(path.join(assets, file)), { level: 9 }).length,
  )
  const weight = weights.reduce((sum, one) => sum + one, 0)
  t.diagnostic(`${weight} bytes`)
  assert.ok(weight > 0 && weight <= 152_000, `${weight} bytes`)
})

test('webpack builds it, with a worker, under a strict policy: the same bits in Chromium', async () => {
  const { default: webpack } = await import('webpack')
  const at = await folder('webpack', { 'main.js': MAIN, 'worker.js': EXAMPLES['worker.js'] })
  const stats = await new Promise((resolve, reject) => {
    webpack(
      {
        mode: 'production',
        context: at,
        entry: './main.js',
        output: { path: path.join(at, 'dist'), publicPath: 'auto' },
        performance: false,
      },
      (error, done) => (error ? reject(error) : resolve(done)),
    )
  })
  assert.ok(!stats.hasErrors() && !stats.hasWarnings(), stats.toString('errors-warnings'))
  writeFileSync(path.join(at, 'dist/index.html'), built(`${POLICY}<script defer src="./main.js"></script>`))
  await asInNode(await answerOf(path.join(at, 'dist')))
})

/** @param {string} at the folder @param {string} entry what esbuild bundles there, into `dist` */
const esbuild = (at, entry) =>
  run(
    bin('web', 'esbuild'),
    [entry, '--bundle', '--format=esm', '--loader:.wasm=file', '--log-level=warning', '--outdir=dist'],
    { cwd: at },
  )

test('esbuild builds the slim entry with its binary, as the README says, under a strict policy', async () => {
  const answer = '\nwindow.answer = JSON.parse(document.body.textContent)\n'
  const at = await folder('esbuild', { 'boat.js': EXAMPLES['boat.js'] + answer })
  await esbuild(at, 'boat.js')
  const html = built(`${POLICY}<body><script type="module" src="./boat.js"></script>`)
  writeFileSync(path.join(at, 'dist/index.html'), html)
  assert.deepEqual(await answerOf(path.join(at, 'dist')), { semiMajor: 2, semiMinor: 1, angle: 0 })
})

test('where esbuild has left the binary behind, the page says so, and what to import', async () => {
  for (const entry of ['', '/filters']) {
    const at = await folder(`esbuild-index${entry.replace('/', '-')}`, {
      'main.js': `import('${NAME}${entry}').catch(({ message }) => { window.answer = message })`,
    })
    await esbuild(at, 'main.js')
    writeFileSync(path.join(at, 'dist/index.html'), built('<script type="module" src="./main.js"></script>'))
    const said = await answerOf(path.join(at, 'dist'), 'index.html', /404 \(Not Found\)/)
    assert.match(said, /The binary could not be loaded from http:.*estimate\.wasm: .*With esbuild, import /)
    assert.ok(said.includes(`import ${NAME}${entry}/slim (README, "In a page")`), said)
  }
})

test('a page without a bundler imports it, and so does its worker', async () => {
  const answer = 'window.answer = JSON.parse(document.body.textContent)\n</script>'
  const at = await folder('plain', {
    'page.html': built(EXAMPLES['page.html'].replace('</script>', answer)),
    'worker.js': EXAMPLES['worker.js'].replace(`'${NAME}'`, `'./node_modules/${NAME}/index.js'`),
    'worker.html': built('<script type="module" src="./asks.js"></script>'),
    'asks.js': `const worker = new Worker('./worker.js', { type: 'module' })
worker.onmessage = ({ data }) => { window.answer = data }`,
  })
  assert.deepEqual(await answerOf(at, 'page.html'), { semiMajor: 2, semiMinor: 1, angle: 0 })
  assert.equal(await answerOf(at, 'worker.html'), 'listening')
})

const TYPED = `
const system = { F: [[1, 0.5], [0, 1]], G: [[0], [0.5]], H: [[1, 0]], V: [[1, 0], [0, 1]], W: [[0.5]] }
const filter = new KalmanFilter(system, { x: [0, 0], P: [[1, 0], [0, 1]] })
filter.step(new Float64Array(1), [1])
const speed: number | undefined = filter.x[1]
const nis: number | null = filter.nis
const floats = (matrix: number[][]) => matrix.map((row) => Float64Array.from(row))
const typed = { ...system, F: floats(system.F), V: [new Float64Array(2), [0, 1]] }
kalmanStep(typed, { x: new Float64Array(2), P: floats(system.V) }, new Float64Array(1), [1])
const step: KalmanStep = kalmanStep(system, { x: [0, 0], P: [[1, 0], [0, 1]] }, [0], [1])
// @ts-expect-error The mean is read only.
filter.x = [1, 2]
// @ts-expect-error A system has five matrices.
kalmanStep({ F: [[1]] }, { x: [0], P: [[1]] }, [0], [1])
export const all = [speed, nis, step.R]
`
test('TypeScript takes its declarations, strictly, by node16 and by bundler', async () => {
  const from = (entry) => `import { KalmanFilter, kalmanStep, type KalmanStep } from '${NAME}${entry}'\n`
  const at = await folder('types', {
    'light.mts': `${from('/filters')}import init from '${NAME}/filters/slim'\nexport const load = init${TYPED}`,
    'esm.mts':
      `${from('')}import init, { initSync } from '${NAME}/slim'\n` + `export const loaders = [init, initSync]${TYPED}`,
    'common.cts': `${from('')}import slim = require('${NAME}/slim')\nexport const loader = slim.default${TYPED}`,
    'bundled.ts': `${from('')}import init from '${NAME}/slim'\nexport const load = init${TYPED}`,
  })
  const strict = [
    '--strict',
    '--noEmit',
    '--noUncheckedIndexedAccess',
    '--exactOptionalPropertyTypes',
    '--target',
    'es2022',
    '--lib',
    'es2022,dom',
  ]
  const tsc = (...args) =>
    run(bin('web', 'tsc'), [...strict, ...args], { cwd: at }).catch((error) => {
      throw new Error(error.stdout)
    })
  await tsc('--module', 'node16', '--moduleResolution', 'node16', 'esm.mts', 'light.mts', 'common.cts')
  await tsc('--module', 'esnext', '--moduleResolution', 'bundler', 'bundled.ts')
})
