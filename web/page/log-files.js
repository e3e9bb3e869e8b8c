/**
 * How the files of a log are read, for correction: what each is, which column holds which value, and in which units.
 */

import { part } from '../draw/dom.js'

/** @typedef {import('estimate-wasm').LogFile} LogFile */
/** @typedef {import('../widgets/robot-log/server.js').Change} Change */

const ROLES = {
  log: 'a log in this book’s format',
  velocities: 'velocities',
  odometry: 'odometry',
  sightings: 'sightings',
  landmarks: 'landmarks',
  truth: 'truth',
  barcodes: 'barcodes',
  unused: 'not used',
}
/** The units that a file may be in, and the values that have them. */
const UNITS = [
  { name: 'time', units: ['s', 'ms', 'us', 'ns'], values: ['time'] },
  { name: 'length', units: ['m', 'cm', 'mm'], values: ['v', 'distance', 'range', 'x', 'y'] },
  { name: 'angle', units: ['rad', 'deg'], values: ['omega', 'turn', 'bearing', 'heading'] },
]
const NAMES = /** @type {Record<string, string>} */ ({ omega: 'ω', us: 'µs' })

export class FileForm {
  /** @param {HTMLElement} into @param {(change: Change) => void} change */
  constructor(into, change) {
    this.box = into
    this.change = change
  }

  /** Shows files of which one may be read otherwise. @param {LogFile[]} files */
  show(files) {
    const focused = document.activeElement?.getAttribute('data-key')
    this.box.replaceChildren()
    // A log in the book's own format says itself what it is.
    if (files.every(({ role }) => role === 'log')) return
    for (const [i, file] of files.entries()) this.showFile(i, file)
    const again = focused && this.box.querySelector(`[data-key="${focused}"]`)
    if (again instanceof HTMLElement) again.focus({ preventScroll: true })
  }

  /** @param {number} i @param {LogFile} file */
  showFile(i, { name, role, header, values, ...units }) {
    const set = part(document, this.box, 'fieldset', 'log-file')
    part(document, set, 'legend', '').textContent = name
    /**
     * @param {string} label
     * @param {[string, string][]} options
     * @param {string} value
     * @param {(value: string) => Change} make
     */
    const choice = (label, options, value, make) => {
      const line = part(document, set, 'label', '')
      part(document, line, 'span', '').textContent = label
      const select = /** @type {HTMLSelectElement} */ (part(document, line, 'select', ''))
      select.setAttribute('data-key', `${i} ${label}`)
      for (const [key, words] of options) {
        const option = /** @type {HTMLOptionElement} */ (part(document, select, 'option', ''))
        option.value = key
        option.textContent = words
        option.selected = key === value
      }
      select.addEventListener('change', () => this.change(make(select.value)))
    }
    choice('read as', Object.entries(ROLES), role, (value) => ({ file: i, role: value }))
    /** @type {[string, string][]} */
    const columns = [
      ['', '–'],
      ...header.map((column, at) => /** @type {[string, string]} */ ([String(at), column || `column ${at + 1}`])),
    ]
    for (const { name: value, column } of values) {
      choice(NAMES[value] ?? value, columns, column === null ? '' : String(column), (at) => ({
        file: i,
        value,
        column: at === '' ? null : Number(at),
      }))
    }
    for (const { name: of, units: all, values: having } of UNITS) {
      if (!values.some(({ name: value }) => having.includes(value))) continue
      choice(
        `unit of ${of}`,
        all.map((unit) => [unit, NAMES[unit] ?? unit]),
        units[/** @type {'time'} */ (of)],
        (unit) => ({ file: i, unit }),
      )
    }
  }
}
