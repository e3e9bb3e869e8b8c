/**
 * The numbers of a figure: a strip of fixed columns that a large headline opens, a table of those that are read by row
 * and column, and the rest behind “more”. A widget declares readouts in that order; this file lays them out.
 */

import { part } from '../draw/dom.js'
import { plain, writeHtml } from '../draw/words.js'

/** @typedef {import('../draw/words.js').Words} Words */

/**
 * @typedef {object} Readout
 * @property {string} key
 * @property {Words} label
 * @property {string} value
 * @property {string} [unit]
 * @property {import('../draw/plot.js').Kin} [kin]
 * @property {boolean} [headline] the number to watch: large, and first
 * @property {[Words, Words]} [cell] row and column of the table that it stands in
 * @property {boolean} [zero] whether it is a zero to be marked: a right angle
 * @property {boolean} [more] whether it waits behind “more”
 * @property {boolean} [wide] whether it takes the room of two
 * @property {boolean} [row] whether it begins a row
 * @property {boolean} [shown] whether it is there; always if not given
 */

export class Readouts {
  /** @param {Document} document @param {Element} into */
  constructor(document, into) {
    this.document = document
    this.into = part(document, into, 'div', 'readouts')
    /** @type {Map<string, { box: Element, value: Element, said: string }>} */
    this.kept = new Map()
    /** The lists by the place they have. @type {Map<string, Element>} */
    this.lists = new Map()
    /** Rows and columns of the table, in the order in which they came. @type {{ rows: string[], columns: string[] }} */
    this.table = { rows: [], columns: [] }
  }

  /** @param {Readout[]} readouts */
  show(readouts) {
    for (const readout of readouts) {
      let held = this.kept.get(readout.key)
      if (!held) this.kept.set(readout.key, (held = this.build(readout)))
      const hidden = readout.shown === false
      if (held.box.hasAttribute('hidden') !== hidden) held.box.toggleAttribute('hidden', hidden)
      // What has no value yet is a dash, which has no unit; a degree sign stands at its number.
      const text =
        readout.unit && readout.value !== '–'
          ? `${readout.value}${readout.unit === '°' ? '' : ' '}${readout.unit}`
          : readout.value
      if (held.said === text) continue
      held.value.textContent = text
      held.said = text
      if (readout.cell) held.box.classList.toggle('is-zero', readout.zero === true)
    }
  }

  /** @param {Readout} readout */
  build(readout) {
    const { document } = this
    const names = ['readout', readout.kin, readout.headline && 'is-headline', readout.wide && 'is-wide']
    const box = part(document, this.list(readout), 'div', names.filter(Boolean).join(' '))
    if (readout.kin) box.setAttribute('data-kin', readout.kin)
    writeHtml(part(document, box, 'dt', readout.cell ? 'visually-hidden' : ''), readout.label)
    if (readout.row) box.setAttribute('style', readout.wide ? 'grid-column:1/span 2' : 'grid-column:1')
    if (readout.cell)
      box.setAttribute(
        'style',
        `grid-area:${this.place('rows', readout.cell[0])}/${this.place('columns', readout.cell[1])}`,
      )
    return { box, value: part(document, box, 'dd', ''), said: '' }
  }

  /** @param {Readout} readout */
  list({ cell, more }) {
    const place = cell ? 'cells' : more ? 'more' : 'strip'
    let list = this.lists.get(place)
    if (list) return list
    let around = this.into
    if (more) {
      around = part(this.document, this.into, 'details', 'more')
      part(this.document, around, 'summary', '').textContent = 'More numbers'
    }
    if (cell) around = part(this.document, this.into, 'div', 'readout-table')
    list = part(this.document, around, 'dl', `readout-${place}`)
    this.lists.set(place, list)
    return list
  }

  /**
   * The line of a row or a column, which gets its head where it is new.
   * @param {'rows' | 'columns'} which
   * @param {Words} words
   */
  place(which, words) {
    const known = this.table[which]
    if (!known.includes(plain(words))) {
      known.push(plain(words))
      const head = part(
        this.document,
        /** @type {Element} */ (this.lists.get('cells')?.parentElement),
        'span',
        'cell-head',
      )
      head.setAttribute('aria-hidden', 'true')
      head.setAttribute(
        'style',
        which === 'rows' ? `grid-area:${known.length + 1}/1` : `grid-area:1/${known.length + 1}`,
      )
      writeHtml(head, words)
    }
    return known.indexOf(plain(words)) + 2
  }
}
