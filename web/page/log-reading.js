/** The bar of a log that is being read: what is read, how much of it has been, and a way to give up. */

import { button, part } from '../draw/dom.js'
import { shortName } from './file-name.js'

/**
 * @param {File[]} files none where those that are there already are read otherwise
 * @param {() => void} giveUp
 * @returns {{ box: HTMLElement, show: (told: { done: number, of: number }) => void }} `show` says how far it has come,
 * in bytes
 */
export function readingBar(files, giveUp) {
  const box = document.createElement('div')
  box.className = 'log-reading'
  part(document, box, 'span', '').textContent = wordsOf(files)
  const bar = /** @type {HTMLProgressElement} */ (part(document, box, 'progress', ''))
  bar.setAttribute('aria-label', 'Read')
  button(document, box, 'Cancel', giveUp)
  const show = (/** @type {{ done: number, of: number }} */ { done, of }) => {
    // While the first file is read nobody knows how much of it has been: the bar only moves.
    if (done === 0) return
    bar.max = of
    bar.value = done
  }
  return { box, show }
}

/** @param {File[]} files */
function wordsOf(files) {
  if (files.length === 0) return 'Reading the files anew …'
  const bytes = files.reduce((sum, { size }) => sum + size, 0)
  const size = bytes < 1e5 ? `${Math.ceil(bytes / 1e3)} kB` : `${(bytes / 1e6).toFixed(1)} MB`
  return `Reading ${files.length === 1 ? shortName(files[0].name) : `${files.length} files`}, ${size} …`
}
