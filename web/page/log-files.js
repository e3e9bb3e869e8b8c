/**
 * How the files of a log are read, for correction: their roles, columns and units, what a file asks, and what follows.
 */

import { button, part } from '../draw/dom.js'
import { COUNTINGS, NAMES, ROLES, WHEELS } from './log-file-names.js'
import { clocksOf, faultWords, framesOf, originOf, short, unreadWords } from './log-file-words.js'

/** @typedef {import('estimate-wasm').LogFile} LogFile */
/** @typedef {import('estimate-wasm').LogValue} LogValue */
/** @typedef {import('../widgets/robot-log/change.js').Change} Change */

/** The answers to the question of what a file is, where it names them. @type {Record<string, string>} */
const ANSWERS = {
  truth: 'The true position',
  sensors: 'What a sensor read',
  reckoned: 'The robot’s odometry',
  ranges: 'Ranges to landmarks',
  unused: 'Leave it out',
}
/** Values that few files have. */
const RARE = ['fraction', 'day', 'sigma', 'sigma of heading', 'latitude', 'longitude', 'landmark x', 'landmark y']
/** So many characters of a column’s name are seen in its field on a phone. */
const IN_A_FIELD = 15

export class FileForm {
  /** @param {HTMLElement} into @param {(change: Change) => void} change */
  constructor(into, change) {
    this.box = into
    into.id = 'log-files'
    this.change = change
    /** The files whose rare values a reader has opened. @type {Set<string>} */
    this.opened = new Set()
  }

  /** Shows files of which one may be read otherwise. @param {LogFile[]} files */
  show(files) {
    const focused = document.activeElement?.getAttribute('data-key')
    this.box.replaceChildren()
    // A log in the book's own format says itself what it is.
    if (files.every(({ role, header }) => role === 'log' && header.length === 0)) return
    // A table that is read once more stands beneath itself.
    const order = [...files.entries()].sort(([i, a], [j, b]) => (a.again ?? i) - (b.again ?? j) || i - j)
    for (const [i, file] of order) this.showFile(i, file)
    const find = (/** @type {string} */ key) => this.box.querySelector(`[data-key="${key}"]`)
    // An answer's button is gone once it was pressed: what was chosen stands in the list.
    const again = focused && (find(focused) ?? find(focused.replace(/ read as .*$/, ' read as')))
    if (again instanceof HTMLElement) again.focus({ preventScroll: true })
  }

  /** @param {number} i @param {LogFile} file */
  showFile(
    i,
    { name, role, header, values, unread, wheels, needs, several, frame, clock, asks, answers, follows, fault },
  ) {
    const set = part(document, this.box, 'fieldset', `log-file${asks.length > 0 ? ' asks' : ''}`)
    part(document, set, 'legend', '').textContent = name
    if (fault) part(document, set, 'p', 'log-ask').textContent = faultWords(fault)
    for (const [at, ask] of asks.entries()) {
      part(document, set, 'p', 'log-ask').textContent = ask
      // What the file is is asked first.
      if (at > 0 || answers.length === 0) continue
      const line = part(document, set, 'p', 'log-choices')
      for (const one of answers) this.answer(line, i, one)
    }
    const roles = Object.entries(ROLES).filter(([key]) => key !== 'undecided' || role === key)
    const what = part(document, set, 'div', `log-value log-role${role === 'undecided' ? ' asked' : ''}`)
    this.choice(what, `${i} read as`, 'read as', roles, role, (value) => ({ file: i, role: value }))
    const called = header.map((one, at) => /** @type {[string, string]} */ ([String(at), one || `column ${at + 1}`]))
    /** @type {[string, string][]} */
    const columns = [['', '–'], ...called]
    // What the file has, what it must have and what is asked; of a file in which nothing is known, what is usual.
    const known = values.some(({ name: value, column, asked }) => asked || (column !== null && value !== 'time'))
    const shown = values.filter(
      ({ name: value, column, optional, asked }) =>
        column !== null || asked || !optional || (!known && !RARE.includes(value)),
    )
    const hidden = values.filter((value) => !shown.includes(value))
    for (const value of shown) this.value(set, i, columns, value)
    // The clock of a file whose times are those of the motion is seldom another one.
    const aside = clock && !clock.asked && clock.said === null
    if (hidden.length > 0 || aside) {
      const more = /** @type {HTMLDetailsElement} */ (part(document, set, 'details', 'log-more'))
      more.open = this.opened.has(name)
      more.addEventListener('toggle', () => (more.open ? this.opened.add(name) : this.opened.delete(name)))
      part(document, more, 'summary', '').textContent = aside ? 'more columns, and its clock' : 'more columns'
      const inner = part(document, more, 'div', 'log-values')
      for (const value of hidden) this.value(inner, i, columns, value)
      if (aside) this.added(inner, i, 'seconds that are added to its times')
    }
    if (several) this.several(set, i, header, several)
    if (wheels) this.wheels(set, i, wheels, needs)
    if (clock && !aside) this.clock(set, i, clock)
    if (frame) this.frame(set, i, frame)
    if (follows) part(document, set, 'p', 'log-follows').textContent = `So: ${follows}.`
    const left = unreadWords(unread.map((at) => header[at] || `column ${at + 1}`))
    if (left) part(document, set, 'p', 'log-unread').textContent = left
  }

  /** A press that answers what a file is. @param {Element} into @param {number} i @param {string} role */
  answer(into, i, role) {
    const press = button(document, into, ANSWERS[role] ?? role, () => this.change({ file: i, role }))
    press.setAttribute('data-key', `${i} read as ${role}`)
  }

  /** A value: its column, its unit, and what stands there. */
  /** @param {Element} into @param {number} i @param {[string, string][]} columns @param {LogValue} value */
  value(into, i, columns, { name, column, unit, units, asked, samples }) {
    const words = NAMES[name] ?? name
    const cell = part(document, into, 'div', `log-value${asked ? ' asked' : ''}`)
    this.choice(cell, `${i} ${words}`, words, columns, column === null ? '' : String(column), (at) => ({
      file: i,
      value: name,
      column: at === '' ? null : Number(at),
    }))
    if (column === null) return
    if (units.length > 0) {
      /** @type {[string, string][]} */
      const options = units.map((one) => [one, NAMES[one] ?? one])
      if (unit === null) options.unshift(['', 'choose a unit'])
      this.choice(cell, `${i} unit of ${words}`, `unit of ${words}`, options, unit ?? '', (one) => ({
        file: i,
        value: name,
        unit: one,
      }))
    }
    if (samples.length === 0) return
    // A longer name is cut off in its field on a phone.
    const chosen = columns.find(([at]) => at === String(column))?.[1] ?? ''
    const whole = chosen.length > IN_A_FIELD ? `${chosen}: ` : ''
    part(document, cell, 'p', 'log-samples').textContent = whole + samples.map(short).join(' · ')
  }

  /**
   * What wheels need in their unit: of speeds nothing is counted.
   * @param {Element} set @param {number} i @param {NonNullable<LogFile['wheels']>} wheels
   * @param {LogFile['needs']} needs
   */
  wheels(set, i, wheels, needs) {
    for (const [name, words] of WHEELS.filter(([one]) => needs.includes(one))) {
      const input = this.entry(set, `${i} ${name}`, words, String(wheels[name] ?? ''), (text) => {
        const number = Number(text.replace(',', '.'))
        return Number.isFinite(number) && number > 0 ? { file: i, wheel: name, number } : null
      })
      input.inputMode = 'decimal'
    }
    if (!needs.includes('counting')) return
    /** @type {[string, string][]} */
    const ways = Object.entries(COUNTINGS)
    if (wheels.counting === null) ways.unshift(['', 'choose one'])
    this.choice(set, `${i} counting`, 'each row’s number is counted', ways, wheels.counting ?? '', (counting) => ({
      file: i,
      counting,
    }))
  }

  /**
   * Whose rows are read, of several robots.
   * @param {Element} into @param {number} i @param {string[]} header @param {NonNullable<LogFile['several']>} several
   */
  several(into, i, header, { column, values, only, asked }) {
    const words = `rows of which ${header[column]}`
    const cell = part(document, into, 'div', `log-value${asked ? ' asked' : ''}`)
    /** @type {[string, string][]} */
    const options = values.map(({ value, rows }, at) => [
      String(at),
      `${value || '(empty)'}: ${rows.toLocaleString('en')} rows`,
    ])
    if (asked) options.unshift(['', 'choose one'])
    options.push(['all', 'all rows'])
    const chosen = asked ? '' : only === null ? 'all' : String(values.findIndex(({ value }) => value === only))
    this.choice(cell, `${i} only`, words, options, chosen, (at) => ({
      file: i,
      only: at === 'all' ? null : values[Number(at)].value,
    }))
  }

  /**
   * A clock that is not the motion’s.
   * @param {Element} into @param {number} i @param {NonNullable<LogFile['clock']>} clock
   */
  clock(into, i, clock) {
    const { said } = clock
    const cell = part(document, into, 'div', `log-value log-role${said === null ? ' asked' : ''}`)
    const options = clocksOf(clock).map(([one, words]) => /** @type {[string, string]} */ ([String(one), words]))
    if (said === null) options.unshift(['', 'choose one'])
    const make = (/** @type {string} */ one) => ({ file: i, clockShift: Number(one) })
    this.choice(cell, `${i} clock`, 'its clock', options, String(said ?? ''), make)
    this.added(cell, i, 'or seconds that are added to its times')
  }

  /** A field for what is added to the times of a file. @param {Element} into @param {number} i @param {string} words */
  added(into, i, words) {
    this.entry(into, `${i} clock shift`, words, '', (text) => {
      const seconds = Number(text.trim().replace('−', '-').replace(',', '.') || NaN)
      return Math.abs(seconds) <= 1e11 ? { file: i, clockShift: seconds } : null
    })
  }

  /**
   * A file’s frame, and a truth’s clock.
   * @param {Element} into @param {number} i @param {NonNullable<LogFile['frame']>} frame
   */
  frame(into, i, frame) {
    const { said, foreign, beside } = frame
    const cell = part(document, into, 'div', `log-value log-role${said === null ? ' asked' : ''}`)
    const options = framesOf(frame)
    if (said === null) options.unshift(['', 'choose one'])
    const label = beside ? 'its origin' : foreign ? 'its frame' : 'its frame and clock'
    this.choice(cell, `${i} frame`, label, options, said ?? '', (one) => ({ file: i, frame: one }))
    if (foreign || beside) this.origin(into, i, frame)
  }

  /**
   * Where the origin of places in metres lies.
   * @param {Element} into @param {number} i @param {NonNullable<LogFile['frame']>} frame
   */
  origin(into, i, { origin }) {
    const words = 'or its origin’s latitude and longitude, °'
    const cell = part(document, into, 'div', 'log-value log-role')
    this.entry(cell, `${i} origin`, words, (origin ?? []).join(', '), (text) => {
      const origin = originOf(text)
      return origin && { file: i, origin }
    })
  }

  /**
   * A field for numbers.
   * @param {Element} into @param {string} key @param {string} label @param {string} value
   * @param {(text: string) => Change | null} make null of what cannot be taken
   */
  entry(into, key, label, value, make) {
    const line = part(document, into, 'label', '')
    part(document, line, 'span', '').textContent = label
    const input = /** @type {HTMLInputElement} */ (part(document, line, 'input', ''))
    input.type = 'text'
    input.value = value
    input.setAttribute('data-key', key)
    input.addEventListener('change', () => {
      const change = make(input.value)
      input.setAttribute('aria-invalid', String(!change))
      if (change) this.change(change)
    })
    return input
  }

  /**
   * A choice among words.
   * @param {Element} into
   * @param {string} key by which it is found again
   * @param {string} label
   * @param {[string, string][]} options
   * @param {string} value
   * @param {(value: string) => Change} make
   */
  choice(into, key, label, options, value, make) {
    const line = part(document, into, 'label', '')
    part(document, line, 'span', '').textContent = label
    const select = /** @type {HTMLSelectElement} */ (part(document, line, 'select', ''))
    select.setAttribute('data-key', key)
    for (const [name, words] of options) {
      const option = /** @type {HTMLOptionElement} */ (part(document, select, 'option', ''))
      option.value = name
      option.textContent = words
      option.selected = name === value
      option.disabled = name === '' && label !== 'read as' && words.startsWith('choose')
    }
    select.addEventListener('change', () => this.change(make(select.value)))
  }
}
