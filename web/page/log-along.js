/** What a reader takes along from a log: the settings as a file, which is read again, and programs of others. */

import { button, part } from '../draw/dom.js'
import { save } from '../figure/save.js'
import { robotLocalization } from './log-export.js'
import { filterpy } from './log-filterpy.js'
import { MOST_SETTINGS, isSameLog, nextChange, readSettings, settingsText } from './log-settings.js'

/** @typedef {import('estimate-wasm').LogFile} LogFile */
/** @typedef {import('../widgets/robot-log/change.js').Change} Change */
/**
 * What the page gives: the run, its log, the files as they are read, how one is read otherwise, the filter told, and
 * where something is said.
 * @typedef {object} Page
 * @property {() => Promise<import('../widgets/robot-log/remote-run.js').RemoteRun>} run
 * @property {() => LogFile[]} files
 * @property {(change: Change) => Promise<void>} reread
 * @property {(patch: Record<string, unknown>) => void} change
 * @property {(words: string) => void} say
 */

/** Changes of reading that one file of settings may need, and more than any needs. */
const MOST_CHANGES = 500

/** @param {HTMLElement} before what it stands before @param {Omit<Page, 'say'>} page */
export function takeAlong(before, page) {
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
    if (file) await open(file, { ...page, say })
    input.value = ''
  })
  button(document, row, 'For robot_localization', () =>
    exported('ekf.yaml', 'application/yaml', ({ frame, contents }) => robotLocalization(frame, contents)),
  )
  button(document, row, 'For filterpy', () => exported('filter.py', 'text/x-python', ({ frame }) => filterpy(frame)))
  note.setAttribute('role', 'status')
  row.append(note)
}

/** @param {File} file @param {Page} page */
async function open(file, page) {
  let read = 0
  try {
    if (file.size > MOST_SETTINGS) throw new Error('it is too large to hold settings.')
    const [text, run] = await Promise.all([file.text(), page.run()])
    const settings = readSettings(text, run.parameters())
    const { params, missing } = settings
    const files = isSameLog(settings, page.files(), run.contents) ? [] : settings.files
    for (; read < MOST_CHANGES; read += 1) {
      const change = nextChange(files, page.files())
      if (!change) break
      const before = JSON.stringify(page.files())
      await page.reread(change)
      if (JSON.stringify(page.files()) === before) throw new Error('the open files cannot be read as it says.')
    }
    page.change(params)
    const usual = missing.length > 0 ? ` It says nothing of ${missing.join(', ')}: they have their usual values.` : ''
    page.say(`The filter has the settings of ${file.name}.${usual}`)
  } catch (error) {
    const stays = read > 0 ? ' What was read otherwise before that stays so.' : ''
    page.say(`${file.name}: ${error instanceof Error ? error.message : 'it could not be read.'}${stays}`)
  }
}
