/** What a reader takes along from a log: the settings as a file, which is read again, and programs of others. */

import { button, part } from '../draw/dom.js'
import { save } from '../figure/save.js'
import { sameCorrections } from './log-corrections.js'
import { robotLocalization } from './log-export.js'
import { filterpy } from './log-filterpy.js'
import { NotOpen, nextChange } from './log-saved-files.js'
import { MOST_SETTINGS, isSameLog, isSettings, readSettings, settingsText, startsElsewhere } from './log-settings.js'

/** @typedef {import('estimate-wasm').LogFile} LogFile */
/** @typedef {import('../widgets/robot-log/change.js').Change} Change */
/**
 * What the page gives: the run, its log, the files as they are read, whether these make the log that the figure shows,
 * how one is read otherwise, and the filter told.
 * @typedef {object} Page
 * @property {() => Promise<import('../widgets/robot-log/remote-run.js').RemoteRun>} run
 * @property {() => LogFile[]} files
 * @property {() => boolean} isLog
 * @property {() => import('estimate-wasm').LogCorrections | null} mark what the page corrected in the files before it
 *   wrote them
 * @property {(change: Change) => Promise<void>} reread
 * @property {(patch: Record<string, unknown>) => void} change
 */

/** @typedef {(words: string, taken: boolean) => void} Say */

/** Changes of reading that one file of settings may need, and more than any needs. */
const MOST_CHANGES = 500

/** @param {HTMLElement} before what it stands before @param {Page} page */
export function takeAlong(before, page) {
  const opened = new Opened(page)
  const row = document.createElement('p')
  row.className = 'log-actions'
  before.before(row)
  // The report’s own note is emptied by each frame; this one stays until something else is said.
  const note = part(document, row, 'span', 'log-note')
  const say = (/** @type {string} */ words) => {
    note.textContent = words
  }
  const exported = async (
    /** @type {string} */ name,
    /** @type {string} */ type,
    /** @type {(run: any) => string} */ text,
  ) => {
    const run = await page.run()
    save(name, type, text(run))
  }
  button(document, row, 'Download the settings', () =>
    // What was asked for last is told, whether it is drawn yet or not.
    exported('settings.json', 'application/json', (run) =>
      settingsText(run.state().params, page.files(), run.contents),
    ),
  )
  const input = /** @type {HTMLInputElement} */ (part(document, row, 'input', ''))
  input.type = 'file'
  input.accept = '.json,application/json'
  input.hidden = true
  button(document, row, 'Open settings', () => input.click())
  input.addEventListener('change', async () => {
    const [file] = input.files ?? []
    if (file) await opened.open(file, say)
    input.value = ''
  })
  button(document, row, 'For robot_localization', () =>
    exported('ekf.yaml', 'application/yaml', ({ frame, contents }) => robotLocalization(frame, contents)),
  )
  button(document, row, 'For filterpy', () => exported('filter.py', 'text/x-python', ({ frame }) => filterpy(frame)))
  note.setAttribute('role', 'status')
  row.append(note)
  return opened
}

/** Files of settings that are opened: one may wait for the log that it is of, or for the answers to its questions. */
class Opened {
  /** @param {Page} page */
  constructor(page) {
    this.page = page
    /** @type {{ file: File, say: Say } | null} */
    this.waiting = null
    this.busy = false
  }

  /**
   * Reads files of which one may be one of settings; where none is called so, they are read at once.
   * @param {File[]} files @param {(log: File[]) => Promise<void>} read @param {Say} say
   */
  give(files, read, say) {
    return files.some(({ name }) => /\.(json|txt)$/i.test(name)) ? this.giveApart(files, read, say) : read(files)
  }

  /** @param {File[]} files @param {(log: File[]) => Promise<void>} read @param {Say} say */
  async giveApart(files, read, say) {
    const told = await Promise.all(files.map(isSettings))
    const [settings, second] = files.filter((_, i) => told[i])
    if (second) return say(`${settings.name} and ${second.name} are both settings: open one of them.`, false)
    const log = files.filter((_, i) => !told[i])
    if (log.length === 0) return this.open(settings, say)
    if (settings) this.wait(settings, say)
    return read(log)
  }

  /** Leaves a file until files have been read. @param {File} file @param {Say} say */
  wait(file, say) {
    this.waiting = { file, say }
  }

  /** Files have been read: what waited for them is taken. */
  async arrived() {
    const { waiting, busy } = this
    if (waiting && !busy) await this.open(waiting.file, waiting.say)
  }

  /** @param {File} file @param {Say} say */
  async open(file, say) {
    this.waiting = null
    this.busy = true
    try {
      say(...(await this.take(file, say)))
    } finally {
      this.busy = false
    }
  }

  /**
   * @param {File} file @param {Say} say
   * @returns {Promise<[string, boolean]>} what has come of it, and whether the filter has its settings now
   */
  async take(file, say) {
    const { page } = this
    let read = 0
    try {
      if (file.size > MOST_SETTINGS) throw new Error('it is too large to hold settings.')
      const [text, run] = await Promise.all([file.text(), page.run()])
      const settings = readSettings(text, run.parameters())
      const { params, missing, corrections } = settings
      const files = page.isLog() && isSameLog(settings, page.files(), run.contents) ? [] : settings.files
      for (; read < MOST_CHANGES; read += 1) {
        const change = nextChange(files, page.files())
        if (!change) break
        const before = JSON.stringify(page.files())
        await page.reread(change)
        if (JSON.stringify(page.files()) === before) throw new Error('the open files cannot be read as it says.')
      }
      if (!page.isLog()) {
        this.wait(file, say)
        const then = 'The filter has its settings once the files make a log.'
        return [`${file.name}: the files are read as it says. ${then}`, false]
      }
      const mark = page.mark()
      const written = mark !== null && sameCorrections(mark, corrections)
      if (!written && !sameCorrections(run.contents.corrections, corrections)) await page.reread({ corrections })
      const elsewhere = startsElsewhere(settings, run.contents)
      page.change({ ...params, ...elsewhere?.patch })
      const usual = missing.length > 0 ? ` It says nothing of ${missing.join(', ')}: they have their usual values.` : ''
      const rows = written ? ' The rows are read as they stand: the page corrected them before it wrote them.' : ''
      return [`The filter has the settings of ${file.name}.${usual}${rows}${elsewhere?.words ?? ''}`, true]
    } catch (error) {
      const stays = read > 0 ? ' What was read otherwise before that stays so.' : ''
      const waits = error instanceof NotOpen
      if (waits) this.wait(file, say)
      const then = waits ? ' The settings wait until you open that.' : ''
      const why = error instanceof Error ? error.message : 'it could not be read.'
      return [`${file.name}: ${why}${then}${stays}`, false]
    }
  }
}
