// Where things are, and how Chromium is started.
import assert from 'node:assert/strict'
import { existsSync, readFileSync } from 'node:fs'
import path from 'node:path'
import { fileURLToPath } from 'node:url'
import { FIGURES } from '../../target/figures.js'

export const root = path.resolve(path.dirname(fileURLToPath(import.meta.url)), '../..')
export const dist = path.join(root, 'dist')
/** The site of the book of two sections that run.mjs builds. */
export const fixture = path.join(root, 'target/fixture-site')
/** Served from a sub-path, as a project page of a static host would be. */
export const BASE = '/shelf/robot-motion/'
/** The pages a reader can land on, relative to the site's root; those of figures and sources are of one kind each. */
export const PAGES = JSON.parse(readFileSync(path.join(dist, 'precache.json'), 'utf8'))
  .map((/** @type {{ url: string }} */ { url }) => url.replace('./', ''))
  .filter((/** @type {string} */ at) => /(^|\/)$/.test(at) && !/^(figure|source)\//.test(at))
  .sort()
/** Where the exercises stand. */
export const EXERCISES = 'kalman/exercises/'
/** The pages that hold one figure each. */
export const FIGURE_PAGES = FIGURES.map(({ name }) => `figure/${name}/`)
/** The custom element of the figure called `name`; any other name is a custom element itself. */
export const tagOf = (name) => FIGURES.find((figure) => figure.name === name)?.tag ?? name
/** The page of the book on which a figure stands, relative to the site's root. @param {string} name */
export function pageOf(name) {
  const page = PAGES.find((/** @type {string} */ at) =>
    readFileSync(path.join(dist, at, 'index.html'), 'utf8').includes(`<${tagOf(name)} `),
  )
  assert.ok(page !== undefined, `no page has ${name}`)
  return page
}
export const CHROMIUM_FLAGS = [
  '--no-sandbox',
  '--disable-gpu',
  '--disable-quic',
  '--no-first-run',
  '--disable-background-networking',
  '--disable-component-update',
  '--disable-sync',
  '--disable-dev-shm-usage',
  '--force-color-profile=srgb',
  // Chromium without a window of its own draws letters as the one with a window does.
  '--font-render-hinting=slight',
]
/** Whether a release is tried: what takes long and seldom finds anything is left to it. */
export const RELEASE = process.env.RELEASE === '1'
/**
 * What takes longer than this hangs. No test's verdict depends on it: a busy machine needs a minute where a quiet one
 * needs a second.
 */
export const HANGS_MS = Number(process.env.HANGS_MS ?? 240_000)
/** A test whose page is open for so long stands still; a file's limit, in which all its tests fit, is longer. */
export const STANDS_STILL_MS = 3 * HANGS_MS
export const PHONE = { width: 390, height: 844 }
export const DESKTOP = { width: 1280, height: 900 }

/**
 * Chromium without the browser around its pages where there is one: the same pages in two thirds of the time. A release
 * is tried in the whole browser.
 */
export function chromiumPath() {
  if (process.env.CHROMIUM) return process.env.CHROMIUM
  const whole = ['chromium', 'chromium-browser', 'google-chrome']
  const found = [...(RELEASE ? [] : ['chromium-headless-shell']), ...whole]
    .map((name) => `/usr/bin/${name}`)
    .find(existsSync)
  assert.ok(found, 'no Chromium: run ./scripts/test, which finds or installs one, or set CHROMIUM')
  return found
}
