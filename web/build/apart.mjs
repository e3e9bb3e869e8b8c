/**
 * Takes the panels out of a still, so that a page with many figures need not carry the drawings of all. They go into
 * one SVG file with a view of each, which holds its styles and faces itself. In the still an image of each view takes
 * the panel's place: a browser fetches it when it comes near the screen, when the page is printed, and at once where
 * scripts are off.
 */

import { fileURLToPath } from 'node:url'
import { build } from 'esbuild'
import { heldFaces } from './fonts.mjs'

/**
 * The notations beside the page's own: a view of each panel in each. The page's script chooses (web/page/notation.js).
 */
const OTHERS = ['thrun', 'common']
/** What the book puts in the place of this name: the address of the file. */
export const FILE = 'picture.svg'
/** Pixels between two panels, so that a name that reaches over the edge of one is not seen in the other. */
const GAP = 40

const style = (
  await build({
    entryPoints: [fileURLToPath(new URL('../style/picture.css', import.meta.url))],
    bundle: true,
    minify: true,
    write: false,
    logLevel: 'warning',
    target: ['chrome109', 'firefox115', 'safari16.4'],
  })
).outputFiles[0].text.trim()

/**
 * @param {Element} still changed
 * @param {string} name
 * @param {string} folder where cut faces are kept
 * @returns {Promise<string>} the file
 */
export async function apart(still, name, folder) {
  const document = still.ownerDocument
  for (const panel of still.querySelectorAll('.panel[hidden]')) panel.remove()
  const panels = [...still.querySelectorAll('.panel')]
  let [views, drawn, top, widest] = ['', '', 0, 0]
  for (const panel of panels) {
    const [width, height] = ['width', 'height'].map((side) => Number(panel.getAttribute(side)))
    const view = (panel.getAttribute('class') ?? '').replace('panel panel-', '')
    const image = document.createElement('img')
    const given = {
      class: panel.getAttribute('class'),
      style: panel.getAttribute('style'),
      width,
      height,
      src: `${FILE}#${view}`,
      alt: '',
      loading: 'lazy',
    }
    for (const [key, value] of Object.entries(given)) image.setAttribute(key, String(value))
    for (const key of ['data-from', 'data-later']) {
      if (panel.hasAttribute(key)) image.setAttribute(key, panel.getAttribute(key) ?? '')
      panel.removeAttribute(key)
    }
    panel.replaceWith(image)
    for (const key of ['class', 'style', 'aria-hidden', 'focusable']) panel.removeAttribute(key)
    panel.setAttribute('y', String(top))
    for (const id of [view, ...OTHERS.map((notation) => `${view}-${notation}`)])
      views += `<view id="${id}" viewBox="0 ${top} ${width} ${height}"/>`
    drawn += panel.outerHTML
    widest = Math.max(widest, width)
    top += height + GAP
  }
  // A search in the page finds what the picture says, as it does in the living figure.
  const said = new Set(
    panels
      .flatMap((panel) => [...panel.querySelectorAll('text')].map(inOwnLetters))
      .filter((words) => /\p{L}{2}/u.test(words)),
  )
  const words = document.createElement('p')
  words.setAttribute('class', 'visually-hidden')
  words.setAttribute('aria-hidden', 'true')
  words.textContent = [...said].join(', ')
  still.append(words)
  const faces = await heldFaces(folder, name, letters(panels))
  const rules = style.replaceAll('&', '&amp;').replaceAll('<', '&lt;')
  return (
    `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${widest} ${top - GAP}">` +
    `<style>${faces}${rules}</style>${views}${drawn}</svg>\n`
  )
}

/** @param {Element} text */
function inOwnLetters(text) {
  const own = /** @type {Element} */ (text.cloneNode(true))
  for (const other of own.querySelectorAll(OTHERS.map((notation) => `.in-${notation}`).join())) other.remove()
  return own.textContent.trim()
}

/** The letters in each face: symbols are set in the italic of the text. @param {Element[]} panels */
function letters(panels) {
  /** @type {Record<string, Set<string>>} */
  const found = { 'Plain normal': new Set(), 'Text italic': new Set() }
  const visit = (/** @type {Node} */ node, /** @type {string} */ face) => {
    for (const child of node.childNodes) {
      if (child.nodeType === 3) for (const letter of child.textContent ?? '') found[face].add(letter)
      else visit(child, /** @type {Element} */ (child).classList?.contains('symbol') ? 'Text italic' : face)
    }
  }
  for (const panel of panels) visit(panel, 'Plain normal')
  return found
}
