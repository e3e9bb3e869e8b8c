// Links to figures as each release made them, kept in tests/links/VERSION.json with the state and the numbers that they
// opened. Run as a program, this file keeps links of the version in Cargo.toml: before its release, and never again.
import { spawnSync } from 'node:child_process'
import { createHash } from 'node:crypto'
import { existsSync, readFileSync, readdirSync, writeFileSync } from 'node:fs'
import { createRequire } from 'node:module'
import path from 'node:path'
import { fileURLToPath, pathToFileURL } from 'node:url'
import { withState } from '../../web/figure/state-in-url.js'
import { WIDGETS } from '../../web/widgets/index.js'
import { dice as seeded } from './nonsense.mjs'

const root = fileURLToPath(new URL('../..', import.meta.url))
const folder = path.join(root, 'tests/links')
const core = createRequire(import.meta.url)(path.join(root, 'target/pkg/node/estimate_wasm.js'))

/** Where a kept address, which is relative, stands. */
export const SITE = 'https://book.example/'

/** The kept links: `{ version, links: [{ figure, widget, address, state, frame }] }` for each release. */
export const kept = () =>
  readdirSync(folder)
    .filter((name) => name.endsWith('.json'))
    .map((name) => JSON.parse(readFileSync(path.join(folder, name), 'utf8')))

/** The lab of a figure in some state. @param {import('../../web/figure/spec.js').FigureSpec} spec */
export const opened = (spec, state) => core[spec.lab].from(...logs(spec), state)
const parsed = new Map()
function logs(spec) {
  if (!spec.log) return []
  if (!parsed.has(spec.log)) parsed.set(spec.log, core[spec.lab].parse(readFileSync(path.join(root, spec.log), 'utf8')))
  return [parsed.get(spec.log)]
}

/**
 * The numbers of a frame, to the last bit: a hash for each member, however deep; but the parameters, which the state
 * has.
 */
export function hashes(frame) {
  const found = {}
  const collect = (value, name) => {
    if (name === 'params') return
    if (value !== null && typeof value === 'object' && !Array.isArray(value) && !ArrayBuffer.isView(value)) {
      for (const [key, inner] of Object.entries(value)) collect(inner, name ? `${name}.${key}` : key)
    } else
      found[name] = createHash('sha256')
        .update(JSON.stringify(value, exact) ?? 'undefined')
        .digest('hex')
        .slice(0, 12)
  }
  collect(frame, '')
  return found
}
/** Typed arrays as arrays, and what JSON does not know in words. */
const exact = (_, value) => {
  if (ArrayBuffer.isView(value)) return [.../** @type {Float64Array} */ (value)]
  return typeof value === 'number' && (!Number.isFinite(value) || Object.is(value, -0))
    ? `${Object.is(value, -0) ? '-' : ''}${value}`
    : value
}

/** What `had` holds and `has` does not hold as it was. What is new since then does not matter. */
export const lost = (had, has) =>
  Object.keys(had).filter((name) => JSON.stringify(had[name]) !== JSON.stringify(has[name]))

/** A value within the limits of a parameter. */
function drawn({ name, least, greatest, step, default: usual, words }, dice) {
  if (words) return dice.pick(words)
  if (typeof usual === 'boolean') return dice.uniform() < 0.5
  if (usual === null && dice.uniform() < 0.5) return null
  const [from, to] =
    name === 'gate' && usual === null ? [0.5, 1] : [Math.max(least, -10), step >= 1 ? greatest : Math.min(greatest, 10)]
  const one = () => {
    const value = from + dice.uniform() * (to - from)
    return step >= 1 ? Math.floor(value) : value
  }
  // Matrices stay as they are: one drawn by lot is no covariance.
  if (Array.isArray(usual?.[0]) && from < 0) return undefined
  return Array.isArray(usual) ? usual.map((row) => (Array.isArray(row) ? row.map(one) : one())) : one()
}

async function keep() {
  const version = /^version = "(.+)"$/m.exec(readFileSync(path.join(root, 'Cargo.toml'), 'utf8'))[1]
  const file = path.join(folder, `${version}.json`)
  if (spawnSync('git', ['rev-parse', '--verify', '--quiet', `v${version}`], { cwd: root }).status === 0)
    throw new Error(`${version} is released; its links stay as they are`)
  const dice = seeded(1)
  // A link that is kept stays; figures that have none get theirs.
  const links = existsSync(file) ? JSON.parse(readFileSync(file, 'utf8')).links : []
  const known = new Set(links.map((link) => link.figure))
  for (const [page, text] of pages()) {
    for (const [, figure, widget, start] of text.matchAll(
      /^:::figure\{#(\S+) widget="([^"]+)"[^\n]*?(?: start='([^'\n]+)')?\}$/gm,
    )) {
      // The page of one's own log opens no log by itself.
      if (!WIDGETS[widget] || page === 'log/' || known.has(figure)) continue
      const spec = await WIDGETS[widget]()
      const given = JSON.parse(start ?? '{}')
      for (let count = 0, tries = 0; count < 4; tries++) {
        if (tries > 400) throw new Error(`${figure}: no state by lot is accepted`)
        const usual = { ...spec.start.params, ...given.params }
        const most = spec.timeless ? 1 : spec.start.step > 1000 ? spec.start.step : 400
        const step = count === 0 ? (given.step ?? spec.start.step) : dice.below(most)
        const params = { ...usual }
        if (count > 0) {
          for (const parameter of core[spec.lab].parameters()) {
            // Some stay as they are: a log of odometry refuses what is of held speeds.
            if (dice.uniform() < 0.6) continue
            const value = drawn(parameter, dice)
            if (value !== undefined) params[parameter.name] = value
          }
        }
        let lab
        try {
          lab = opened(spec, { version: 1, lab: spec.name, step, params })
        } catch {
          continue
        }
        const state = lab.state()
        const text = JSON.stringify(state)
        if (links.some((link) => link.figure === figure && JSON.stringify(link.state) === text)) continue
        links.push({
          figure,
          widget,
          address: withState(SITE + page, figure, state).slice(SITE.length),
          state,
          frame: hashes(lab.frame()),
        })
        lab.free()
        count++
      }
    }
  }
  const lines = links.map((link) => `  ${JSON.stringify(link)}`).join(',\n')
  writeFileSync(file, `{ "version": "${version}", "links": [\n${lines}\n] }\n`)
  console.log(`${path.relative(root, file)}: ${links.length} links`)
}

/** Each page of the book by its address, with its Markdown. */
function pages() {
  const content = path.join(root, 'content')
  const text = (/** @type {string} */ folder) =>
    readdirSync(path.join(content, folder))
      .filter((name) => name.endsWith('.md'))
      .sort()
      .map((name) => readFileSync(path.join(content, folder, name), 'utf8'))
      .join('\n')
  // Parts of a chapter that have a page of their own stand in folders of its.
  const parts = readdirSync(path.join(content, 'kalman'), { withFileTypes: true })
    .filter((entry) => entry.isDirectory())
    .map(({ name }) => `kalman/${name}`)
  return [
    ...['kalman', ...parts].map((folder) => [`${folder}/`, text(folder)]),
    ...readdirSync(path.join(content, 'pages')).map((name) => [
      `${path.basename(name, '.md')}/`,
      readFileSync(path.join(content, 'pages', name), 'utf8'),
    ]),
  ]
}

if (import.meta.url === pathToFileURL(process.argv[1] ?? '').href) await keep()
