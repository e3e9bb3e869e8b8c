/** A matrix that is typed: a grid of boxes, as many as its rows and columns, made when they are needed. */

import { part } from '../../draw/dom.js'
import { writeHtml } from '../../draw/words.js'
import { textBox, write } from './fields.js'
import { fitted } from './names.js'
import { numberOf } from './number.js'

/** What each matrix means; in continuous time another word stands for a step. */
const MEANINGS = /** @type {Record<string, import('../../draw/words.js').Words>} */ ({
  F: '*F*{also F}: what a step does',
  G: '*G*{also G}: what an input does',
  H: '*H*{also H}: what a reading tells',
  V: '*V*{also V}: noise of a step',
  W: '*W*{also W}: noise of a reading',
  K: '*K*{also K}: the gain by hand',
  P: '{Pstart}: the variances at the start',
})
const IN_TIME = /** @type {Record<string, import('../../draw/words.js').Words>} */ ({
  F: '*A*: how fast the state changes',
  G: '*B*: what an input does in a second',
  V: '*Q*: noise of a second',
})

/**
 * @param {Document} document
 * @param {Element} into
 * @param {string} name
 * @param {(i: number, j: number) => void} typed
 */
export function buildGrid(document, into, name, typed) {
  const group = part(document, into, 'div', 'own-matrix')
  group.setAttribute('role', 'group')
  const head = part(document, group, 'span', 'control-name')
  writeHtml(head, MEANINGS[name])
  group.setAttribute('aria-label', name === 'P' ? 'Variances at the start' : `Matrix ${name}`)
  const grid = part(document, group, 'div', 'own-cells')
  const none = part(document, group, 'span', 'own-none')
  none.textContent = 'none'
  /** @type {HTMLInputElement[][]} */
  let cells = []
  let inTime = false
  /** What a box shows and what it stands for. @type {WeakMap<HTMLInputElement, { short: string, whole: string }>} */
  const wholes = new WeakMap()

  /** @param {number} i @param {number} j */
  function box(i, j) {
    const input = textBox(document, grid)
    input.setAttribute('inputmode', 'decimal')
    input.setAttribute(
      'aria-label',
      name === 'P' ? `Variance at the start of state ${j + 1}` : `${name}, row ${i + 1}, column ${j + 1}`,
    )
    input.addEventListener('input', () => typed(i, j))
    // A box shows as many digits as fit, and all of them to whoever types there.
    input.addEventListener('focus', () => {
      const whole = textOf(input)
      if (whole === input.value) return
      write(input, whole)
      input.select()
    })
    input.addEventListener('blur', () => {
      const number = numberOf(input.value)
      if (Number.isFinite(number) && fitted(number).length < input.value.length) shorten(input, input.value)
    })
    return input
  }

  /** @param {HTMLInputElement} input @param {string} whole */
  function shorten(input, whole) {
    const short = fitted(numberOf(whole))
    write(input, short)
    input.title = short === whole ? '' : whole
    wholes.set(input, { short, whole })
  }

  /** What a box stands for, with the digits that it does not show. @param {HTMLInputElement} input */
  function textOf(input) {
    const held = wholes.get(input)
    return held?.short === input.value ? held.whole : input.value
  }

  /** Makes room for so many rows and columns; a box keeps its place. @param {number} rows @param {number} columns */
  function fit(rows, columns) {
    const [had, wide] = [cells.length, cells[0]?.length ?? 0]
    if (rows <= had && columns <= wide) return
    const old = cells
    grid.replaceChildren()
    cells = Array.from({ length: Math.max(rows, had) }, (_, i) =>
      Array.from({ length: Math.max(columns, wide) }, (_, j) => {
        const kept = old[i]?.[j]
        if (!kept) return box(i, j)
        grid.append(kept)
        return kept
      }),
    )
  }

  return {
    name,
    group,
    cells: () => cells,
    textOf,
    /**
     * @param {number[][]} entries @param {[number, number]} size
     * @param {{ hidden: boolean, wrong: boolean, foreign: boolean, continuous: boolean }} how
     */
    show(entries, [rows, columns], { hidden, wrong, foreign, continuous }) {
      group.toggleAttribute('hidden', hidden)
      if (continuous !== inTime && IN_TIME[name]) writeHtml(head, continuous ? IN_TIME[name] : MEANINGS[name])
      inTime = continuous
      if (hidden) return
      fit(rows, columns)
      grid.setAttribute('style', `--columns:${Math.max(1, columns)}`)
      none.toggleAttribute('hidden', columns > 0)
      cells.forEach((row, i) =>
        row.forEach((cell, j) => {
          cell.toggleAttribute('hidden', i >= rows || j >= columns)
          // What is being typed stays as it is typed, and so does what could not be read.
          if (i >= rows || j >= columns || wrong || (document.activeElement === cell && !foreign)) return
          if (numberOf(textOf(cell)) !== entries[i][j] || cell.value === '') shorten(cell, String(entries[i][j]))
        }),
      )
    },
  }
}
