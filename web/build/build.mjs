/**
 * Bundles scripts, styles, fonts and the module into target/assets, with names that carry a hash of the content, and
 * writes manifest.json: logical name → file name.
 */

import { createHash } from 'node:crypto'
import { cpSync, existsSync, mkdirSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs'
import { basename, dirname, extname, join, relative } from 'node:path'
import { fileURLToPath } from 'node:url'
import { build } from 'esbuild'
import { FIGURES } from '../../target/figures.js'
import { subsetFonts } from './fonts.mjs'
import { styleHeights } from './heights.mjs'
import { styleLayouts } from './layouts.mjs'
import { lap, vignette } from './vignette.mjs'

const web = dirname(dirname(fileURLToPath(import.meta.url)))
const root = dirname(web)
const out = join(root, 'target/assets')
/**
 * The folder of each build of the module: whole, and with the labs of some figures alone.
 * @type {Map<string, string>}
 */
const pkg = new Map([
  ...FIGURES.map(({ build }) => /** @type {const} */ ([build, join(root, 'target/pkg', build)])),
  ['whole', join(root, 'target/pkg/web')],
])
const [atHand] = pkg.keys()
/** The folder of one of them. @param {string | undefined} build */
function folderOf(build) {
  const folder = pkg.get(build ?? '')
  if (!folder) throw new Error(`no build “${build}” of the module`)
  return folder
}

/**
 * KaTeX has a rule for each change from one of eleven sizes to another; formulas here change among these
 * (crates/book/src/slim.rs).
 */
const OTHER_SIZES = /\.katex \.fontsize-ensurer\.reset-size(?!(?:6\.size[13]|3\.size1),)\d+\.size\d+,[^{}]*\{[^}]*\}/g

/** Selectors of what no formula of the book needs, and of the MathML, for which we have a rule of our own. */
const UNUSED = JSON.parse(readFileSync(join(web, 'style/katex-left-out.json'), 'utf8'))
const LEFT_OUT = new RegExp(`\\.(?:${[...UNUSED, 'katex-mathml'].join('|')})(?![\\w-])`)

/** Logical name → file name. @type {Record<string, string>} */
const manifest = {}

/** @type {import('esbuild').BuildOptions & { metafile: true }} */
const shared = {
  bundle: true,
  minify: true,
  outdir: out,
  target: ['chrome109', 'firefox115', 'safari16.4'],
  entryNames: '[name]-[hash]',
  chunkNames: 'part-[hash]',
  assetNames: '[name]-[hash]',
  metafile: true,
  logLevel: 'warning',
  // wasm-bindgen names a script of ours once for each of its functions.
  logOverride: { 'empty-import-meta': 'silent', 'duplicate-object-key': 'silent' },
}

/**
 * The builds of the module. `module-builds` is the table of all (its first build is at hand with the script that asks,
 * each other is fetched); `estimate-wasm/of/tune` the build that has the lab of the figure `tune`, and `wasm-of/tune`
 * where its binary lies.
 */
const wasm = {
  name: 'wasm',
  setup(to) {
    const folder = (figure) => folderOf(FIGURES.find(({ name }) => name === figure)?.build)
    const virtual = (contents) => ({ contents, resolveDir: join(web, 'load') })
    to.onResolve({ filter: /^estimate-wasm\/of\// }, ({ path }) => ({
      path: join(folder(path.split('/')[2]), 'estimate_wasm.js'),
    }))
    to.onResolve({ filter: /^wasm-of\// }, ({ path }) => ({
      path: join(folder(path.split('/')[1]), 'estimate_wasm_bg.wasm'),
    }))
    to.onResolve({ filter: /^module-builds?(\/|$)/ }, ({ path }) => ({ path, namespace: 'module' }))
    const loader = (name) => (name === atHand ? 'async () => first' : `() => import('module-build/${name}')`)
    to.onLoad({ filter: /^module-builds$/, namespace: 'module' }, () =>
      virtual(`import * as first from 'module-build/${atHand}'
        export const BUILDS = { ${[...pkg.keys()].map((name) => `'${name}': ${loader(name)}`)} }`),
    )
    to.onLoad({ filter: /^module-build\//, namespace: 'module' }, ({ path }) => {
      const file = (name) => JSON.stringify(join(folderOf(path.split('/')[1]), name))
      return virtual(`import init, * as estimate from ${file('estimate_wasm.js')}
        import address from ${file('estimate_wasm_bg.wasm')}
        import { loader } from './loader.js'
        export const load = loader(init, estimate, address)`)
    })
  },
}

/** The script of a widget's worker, bundled by itself, and its address. */
const worker = {
  name: 'worker',
  setup(to) {
    to.onResolve({ filter: /^[\w-]+-worker$/ }, ({ path }) => ({ path, namespace: 'worker' }))
    to.onLoad({ filter: /.*/, namespace: 'worker' }, async ({ path: name }) => {
      const { metafile } = await build({
        ...shared,
        entryPoints: { [name]: join(web, 'widgets', name.replace(/-worker$/, ''), 'worker.js') },
        format: 'esm',
        loader: { '.wasm': 'file' },
        plugins: [wasm],
      })
      const [script] = Object.keys(metafile.outputs).filter((path) => metafile.outputs[path].entryPoint)
      return { contents: `export default ${JSON.stringify(`./${basename(script)}`)}` }
    })
  },
}

rmSync(out, { recursive: true, force: true })
mkdirSync(out, { recursive: true })
for (const folder of pkg.values()) {
  if (!existsSync(folder)) throw new Error(`no wasm module in ${relative(root, folder)}: run scripts/build`)
}

const fonts = await subsetFonts(join(root, 'target/fonts'))

const scripts = await build({
  ...shared,
  entryPoints: { page: join(web, 'page/page.js'), figure: join(web, 'page/figure.js') },
  format: 'esm',
  splitting: true,
  loader: { '.wasm': 'file', '.csv': 'file' },
  plugins: [wasm, worker],
})
collect(scripts.metafile)
const first = await build({
  ...shared,
  entryPoints: { 'before-paint': join(web, 'page/before-paint.js'), theme: join(web, 'page/theme.js') },
  format: 'iife',
})
collect(first.metafile)

const styles = await build({
  ...shared,
  entryPoints: {
    site: join(web, 'style/site.css'),
    pages: join(web, 'style/pages.css'),
    figure: join(web, 'style/figure.css'),
    log: join(web, 'style/log.css'),
    katex: join(web, 'node_modules/katex/dist/katex.min.css'),
  },
  loader: { '.woff2': 'file' },
  alias: {
    'cut-fonts': fonts,
    'part-heights': styleHeights(join(root, 'target/heights')),
    'figure-layouts': await styleLayouts(join(root, 'target/layouts')),
  },
  plugins: [ownFaces()],
})
collect(styles.metafile)

// Scripts and styles that a page carries inside itself, each with the hash that the page's policy must name.
const inside = await build({
  ...shared,
  write: false,
  entryPoints: { 'not-found': join(web, 'page/not-found.js') },
  format: 'iife',
})
const insideStyle = await build({
  ...shared,
  write: false,
  entryPoints: { 'not-found': join(web, 'style/not-found.css') },
})
const inline = Object.fromEntries(
  [...inside.outputFiles, ...insideStyle.outputFiles].map(({ path, text: built }) => {
    const text = built.trim()
    return [`not-found${extname(path)}`, { text, sha256: createHash('sha256').update(text).digest('base64') }]
  }),
)
for (const [name, draw] of Object.entries({ vignette, lap }))
  inline[`${name}.svg`] = { text: draw(join(root, 'target/pkg/node')), sha256: '' }
writeFileSync(join(out, 'inline.json'), `${JSON.stringify(inline, null, 2)}\n`)

for (const file of readdirSync(out).filter((name) => name.endsWith('.woff2'))) {
  const logical = {
    'serif-upright': 'text.woff2',
    'serif-italic': 'italic.woff2',
    sans: 'plain.woff2',
    'KaTeX_Main-Regular': 'katex-main.woff2',
    'KaTeX_Math-Italic': 'katex-math.woff2',
  }
  const name = logical[file.replace(/-[A-Z0-9]{8}\.woff2$/, '')]
  if (name) manifest[name] = file
}

hashed('favicon.svg', readFileSync(join(web, 'page/favicon.svg')))
const icon = manifest['favicon.svg']
const app = readFileSync(join(web, 'page/manifest.webmanifest'), 'utf8').replaceAll('favicon.svg', icon)
hashed('manifest.webmanifest', Buffer.from(app))
cpSync(join(web, 'page/sw.js'), join(out, 'sw.js'))
manifest['sw.js'] = 'sw.js'
writeFileSync(join(out, 'manifest.json'), `${JSON.stringify(manifest, null, 2)}\n`)
console.log(`target/assets: ${readdirSync(out).length} files`)

/** @param {import('esbuild').Metafile} metafile */
function collect({ outputs }) {
  for (const [path, output] of Object.entries(outputs)) {
    const file = basename(path)
    if (output.entryPoint) manifest[`${file.replace(/-[A-Z0-9]{8}\.(js|css)$/, '.$1')}`] = file
  }
}

/** KaTeX's style sheet names whole font files in three formats; ours names the subsets that `subsetFonts` has cut. */
function ownFaces() {
  return {
    name: 'own-faces',
    setup(to) {
      to.onLoad({ filter: /katex\.min\.css$/ }, ({ path }) => ({
        contents: `@import 'cut-fonts/formulas.css';\n${readFileSync(path, 'utf8')
          .replace(/@font-face\{[^}]*\}/g, '')
          .replace(OTHER_SIZES, '')
          .replace(/([^{}]+)\{[^{}]*\}/g, (rule, selectors) =>
            selectors.split(',').every((one) => LEFT_OUT.test(one)) ? '' : rule,
          )
          .replaceAll('.katex-base', '.base')}${readFileSync(join(web, 'style/formulas.css'), 'utf8')}`,
        loader: 'css',
        resolveDir: dirname(path),
      }))
    },
  }
}

/** @param {string} name @param {Buffer} content */
function hashed(name, content) {
  const hash = createHash('sha256').update(content).digest('hex').slice(0, 8).toUpperCase()
  const file = `${basename(name, extname(name))}-${hash}${extname(name)}`
  writeFileSync(join(out, file), content)
  manifest[name] = file
}
