/** The report on a log: its facts, the settings, the results, and the readings of each landmark. */

import { button, part } from '../draw/dom.js'
import { decimal, fixed, metres } from '../draw/numbers.js'
import { writeHtml } from '../draw/words.js'
import { looksOf } from '../widgets/robot-log/looks.js'
import { clock } from '../widgets/robot-log/words.js'
import { grouped as likelihoodWords } from './log-likelihood.js'
import { settingsOf } from './log-numbers.js'
import { readings } from './log-report-files.js'
import { headsOf, rowsOf } from './log-sources.js'

/** @typedef {import('estimate-wasm').LogContents} LogContents */
/** @typedef {import('../widgets/robot-log/looks.js').Frame} Frame */
/** @typedef {import('../draw/words.js').Words} Words */

/** What the tables hold. */
const HOLDS = {
  track:
    'track.csv: the estimate at each row of motion, before the readings of its time, as it is held against a truth.',
  innovations: 'innovations.csv: what the filter made of each reading, and behind it the estimate after that reading.',
  log: 'log.csv: the log in this book’s format, as the page reads it.',
}

export class Report {
  /**
   * @param {HTMLElement} into
   * @param {{ table: (kind: 'track' | 'innovations' | 'log') => void, print: () => void }} orders
   */
  constructor(into, { table, print }) {
    /** @type {LogContents | null} */
    this.contents = null
    /** @type {string[]} */
    this.names = []
    /** @type {[string, string][]} */
    this.readings = []
    headed(into)
    const actions = part(document, into, 'p', 'log-actions')
    button(document, actions, 'Print the report', print)
    button(document, actions, 'Download the filter’s track', () => table('track'))
    button(document, actions, 'Download the innovations', () => table('innovations'))
    button(document, actions, 'Download the log’s rows', () => table('log'))
    this.note = part(document, actions, 'span', 'log-note')
    this.note.setAttribute('role', 'status')
    this.box = part(document, into, 'div', 'log-tables')
  }

  /** Says what a table that was saved holds. @param {'track' | 'innovations' | 'log'} kind */
  saved(kind) {
    this.say(HOLDS[kind])
  }

  /** @param {string} words */
  say(words) {
    this.note.textContent = words
  }

  /**
   * @param {LogContents} contents
   * @param {string[]} names of the files
   * @param {import('estimate-wasm').LogFile[]} files as they are read; none of the page’s own log
   */
  take(contents, names, files) {
    this.contents = contents
    this.names = names
    this.readings = readings(files)
  }

  /** What the log holds. @returns {[string, string][]} */
  facts() {
    const { contents, names } = this
    if (!contents) return []
    const { rows, span, landmarks, motion, bearings, truth } = contents
    return [
      ['Files', names.join(', ')],
      ['Rows', rows.toLocaleString('en')],
      ['Duration', clock(Math.round(span[1] - span[0]))],
      ['Motion', motion === 'velocity' ? 'velocities' : 'distances and turns'],
      ['Landmarks', `${landmarks.length}${landmarks.length > 0 && bearings ? ', with bearings' : ''}`],
      ['True track', truth ? 'known' : 'not known'],
    ]
  }

  /** @param {any} figure with its specification and its run */
  show({ run, spec }) {
    /** @type {Frame} */
    const frame = run.frame
    this.say('')
    this.box.replaceChildren()
    this.table('The log', [], this.facts())
    const read = [...this.readings, ...said(this.contents)]
    if (read.length > 0) this.table('How it is read', [], read, ' has-words')
    const { kept } = looksOf(frame)
    const heads = kept ? ['', 'A', 'B'] : []
    const both = (/** @type {(one: Frame) => Words[][]} */ told) =>
      kept ? beside(told(kept), told(frame)) : told(frame)
    this.table(
      'Settings',
      heads,
      both((one) => [...settingsOf(one, this.contents), ...begun(one, this.contents)]),
    )
    this.table(
      'Results',
      heads,
      // What this log does not tell, such as the scale of ranges where there are none, is no result.
      both((one) => [...results(spec, one, Boolean(this.contents?.truth)), ...tested(one)]).filter(([, ...cells]) =>
        cells.some((cell) => cell !== '–'),
      ),
    )
    const sources = kept ? underOneAnother(rowsOf(kept), rowsOf(frame)) : rowsOf(frame)
    if (sources.length > 0)
      this.table(
        'Each sensor and landmark',
        ['', ...headsOf(frame)],
        sources.map(({ name, cells }) => [name, ...cells]),
      )
  }

  /**
   * @param {string} title @param {string[]} heads
   * @param {Words[][]} rows the first cell of each is its head
   * @param {string} [kind] of sentences, which need more room than numbers
   */
  table(title, heads, rows, kind = '') {
    const table = part(
      document,
      part(document, this.box, 'div', 'table-box'),
      'table',
      `log-table${heads.length > 0 ? ' has-heads' : ''}${kind}`,
    )
    part(document, table, 'caption', '').textContent = title
    if (heads.length > 0) {
      const head = part(document, part(document, table, 'thead', ''), 'tr', '')
      for (const name of heads) headCell(head, 'col', name)
    }
    const body = part(document, table, 'tbody', '')
    for (const [name, ...cells] of rows) {
      const row = part(document, body, 'tr', '')
      headCell(row, 'row', name)
      for (const cell of cells) part(document, row, 'td', '').textContent = String(cell)
    }
  }
}

/**
 * What else is said of the log, such as what is read otherwise than its files have it.
 * @param {LogContents | null} contents @returns {[string, string][]}
 */
const said = (contents) => (contents?.notes ?? []).map((note, i) => [i === 0 ? 'Besides' : '', note])

/**
 * What a line of the table is called where the figure's name of it leans on its neighbours.
 * @type {Record<string, Words>}
 */
const ALONE = {
  reckoned: 'RMS error of dead reckoning',
  lag1: 'Autocorrelation at lag 1',
  offset: 'Range’s error at 0 m',
  r2: '*R*^{2} of the line of the range’s error',
}
/** A whole number with commas between its thousands, as the others on the page. @param {string} value */
function grouped(value) {
  return /^\d{4,}$/.test(value) ? Number(value).toLocaleString('en') : value
}

/** The heading, and its entry in the contents after that of the section it is in. @param {HTMLElement} into */
function headed(into) {
  const heading = part(document, into, 'h2', '')
  heading.id = 'report'
  heading.append('Report ')
  const link = part(document, heading, 'a', 'heading-link')
  link.setAttribute('href', '#report')
  link.setAttribute('aria-label', 'Link to this section')
  link.textContent = '#'
  const before = document.querySelector('.toc a[href="#open"]')?.closest('li')
  if (!before) return
  const entry = document.createElement('li')
  const to = part(document, entry, 'a', '')
  to.setAttribute('href', '#report')
  to.textContent = 'Report'
  before.after(entry)
}

/** @param {Element} row @param {'row' | 'col'} scope @param {Words} words */
function headCell(row, scope, words) {
  // Above the names of the rows there is nothing to say.
  const cell = part(document, row, words === '' ? 'td' : 'th', '')
  if (words !== '') cell.setAttribute('scope', scope)
  writeHtml(cell, words)
}

/** The rows of A with the cells of B behind them; a row that one alone has gets a dash. */
/** @param {Words[][]} a @param {Words[][]} b @returns {Words[][]} */
function beside(a, b) {
  const of = (/** @type {Words[][]} */ rows, /** @type {Words} */ name) =>
    rows.find(([one]) => one === name)?.[1] ?? '–'
  const names = [...new Set([...a, ...b].map(([name]) => name))]
  return names.map((name) => [name, of(a, name), of(b, name)])
}

/**
 * The row of A and below it that of B, for each sensor or landmark: side by side they would be wider than a phone. One
 * without readings in one of them has dashes there.
 * @param {import('./log-sources.js').Row[]} a @param {import('./log-sources.js').Row[]} b
 */
function underOneAnother(a, b) {
  const of = (/** @type {import('./log-sources.js').Row[]} */ rows, /** @type {string} */ name) =>
    rows.find((row) => row.name === name)?.cells ?? (a[0] ?? b[0]).cells.map(() => '–')
  const names = [...new Set([...a, ...b].map(({ name }) => name))]
  return names.flatMap((name) => [
    { name: `${name}, A`, cells: of(a, name) },
    { name: `${name}, B`, cells: of(b, name) },
  ])
}

/**
 * Where the filter begins, of a log without a truth, and the stretch of fixes that is withheld from it.
 * @param {Frame} frame @param {LogContents | null} contents
 * @returns {Words[][]}
 */
function begun({ params: { start, startSigma, startSigmaHeading, withheld } }, contents) {
  if (!contents) return []
  const { truth, readings, span } = contents
  const [x, y, theta] = start ?? [0, 0, 0]
  const degrees = (/** @type {number} */ angle) => `${fixed((angle * 180) / Math.PI, 1)}°`
  /** @type {Words[][]} */
  const rows = []
  if (!truth)
    rows.push(
      ['Start', `${decimal(x)} m, ${decimal(y)} m, ${degrees(theta)}`],
      ['*σ* at the start', `${fixed(startSigma, 2)} m, ${degrees(startSigmaHeading)}`],
    )
  const seconds = (/** @type {number} */ time) => fixed(time - span[0], 1)
  if (readings.fix)
    rows.push(['Withheld fixes', withheld ? `from ${seconds(withheld[0])} s to ${seconds(withheld[1])} s` : 'none'])
  return rows
}

/** What withheld fixes say of the filter, and of the smoother. @param {Frame} frame @returns {Words[][]} */
function tested({ summary: { withheld } }) {
  if (!withheld || withheld.rows === 0) return []
  const { rows, rms, worst, rmsSmoothed, worstSmoothed } = withheld
  const far = (/** @type {number | null | undefined} */ one, /** @type {number | null | undefined} */ most) =>
    one === null || one === undefined ? '–' : `${metres(one)} m RMS, ${metres(most ?? Number.NaN)} m at worst`
  return [
    ['Fixes that were withheld', rows.toLocaleString('en')],
    ['The filter’s distance from them', far(rms, worst)],
    ['The smoothed track’s distance from them', far(rmsSmoothed, worstSmoothed)],
  ]
}

/** Where the range's error is held against dead reckoning, for want of a truth, it is no result. */
const OF_A_TRUTH = ['slope', 'offset', 'r2']

/** @param {any} spec the figure's @param {Frame} frame @param {boolean} truth @returns {Words[][]} */
function results(spec, frame, truth) {
  const { logLikelihood } = frame.summary
  /** @type {Words[][]} */
  const rows = [['Log-likelihood', logLikelihood === null ? '–' : likelihoodWords(logLikelihood)]]
  for (const { key, label, value, unit, shown } of spec.readouts(frame))
    if (shown !== false && (truth || !OF_A_TRUTH.includes(key)))
      rows.push([ALONE[key] ?? label, unit && value !== '–' ? `${grouped(value)}\u00a0${unit}` : grouped(value)])
  return rows
}
