/** Two boxes: one where a system is pasted, and one where a program is shown that was copied. */

import { button, part } from '../../draw/dom.js'
import { copied } from '../../figure/clipboard.js'
import { motionIn, wordsOfNoises } from './letters.js'
import { begun } from './number.js'
import { paramsOf } from './presets.js'
import { readSystem } from './read.js'
import { keyOf, written } from './typed-system.js'

const OWN_GAIN = 'a gain of your own goes into the boxes of K, which are there where the gain is chosen “by hand”'
const TITLE = 'A system in JSON, MATLAB or numpy notation, in any book’s letters, read while you type'

/**
 * @typedef {object} Desk what the editor lends
 * @property {import('./editor.js').Change} change
 * @property {(name: string, words: string) => void} say names a fault
 * @property {() => string} wrong where the fault is
 * @property {import('./editor.js').Propose} propose
 * @property {() => string} made the system that the reader has made last
 */

/**
 * A box that is empty until it is opened. Each stands below the button that opens it, so that nothing which is pressed
 * moves.
 * @param {Document} document @param {HTMLElement} box
 */
function buildBox(document, box) {
  /** Where the focus was before is where it is afterwards. */
  let close = () => {}
  box.addEventListener('keydown', (event) => {
    if (/** @type {KeyboardEvent} */ (event).key === 'Escape') close()
  })
  /** @param {string} name @param {string} kind @param {() => void} [closed] */
  return function open(name, kind, closed) {
    const from = /** @type {HTMLElement | null} */ (document.activeElement)
    box.replaceChildren()
    const label = part(document, box, 'label', 'own-paste')
    part(document, label, 'span', 'control-name').textContent = name
    const area = /** @type {HTMLTextAreaElement} */ (part(document, label, 'textarea', kind))
    close = () => {
      box.replaceChildren()
      closed?.()
      from?.focus()
    }
    return { area, close: () => close() }
  }
}

/** @param {Document} document @param {{ paste: HTMLElement, give: HTMLElement }} into @param {Desk} desk */
export function buildBoxes(document, into, { change, say, wrong, propose, made }) {
  const [openPaste, openGiven] = [buildBox(document, into.paste), buildBox(document, into.give)]
  /**
   * Where a system is pasted, where its fault is said, and the system that its text was last.
   * @type {{ area: HTMLTextAreaElement, fault: HTMLElement, is: string } | null}
   */
  let pasted = null

  /** What was made of a paste, beside its title. @param {import('./read.js').Good} read */
  function remarks({ as, noises, unused, system, variables, held }) {
    return [
      as,
      variables.length > 0 ? `taken as variables of the formulas alone: ${variables.join(', ')}` : '',
      held ? `${held} as what an input does in one step: write G = … if it is of a differential equation` : '',
      wordsOfNoises(noises, system.continuous),
      system.continuous
        ? `taken as continuous in time and sampled every ${system.period} s, with the noise of the motion per second`
        : /^A\b/.test(as)
          ? // A is the letter of both: taken wrongly, an oscillator that dies out grows without bound.
            'taken as what one step does: tick “Continuous time” if A is of a differential equation'
          : '',
      unused.length > 0 ? `not used: ${unused.map((name) => begun(name)).join(', ')}` : '',
      unused.includes('K') ? OWN_GAIN : '',
    ]
      .filter(Boolean)
      .map((words) => ` ${words.charAt(0).toUpperCase()}${words.slice(1)}.`)
      .join('')
  }

  return {
    paste() {
      if (wrong() === 'paste') say('', '')
      const { area, close } = openPaste(TITLE, '', () => {
        pasted = null
        if (wrong() === 'paste') say('', '')
      })
      const fault = part(document, into.paste, 'p', 'own-fault own-paste-fault')
      fault.setAttribute('role', 'status')
      button(document, into.paste, 'Close', close)
      area.rows = 7
      area.spellcheck = false
      /** Which of Q and R is the noise of the motion, once the reader has said so, and which it is not. */
      let said = /** @type {import('./letters.js').Motion | null} */ (null)
      let unsaid = /** @type {import('./letters.js').Motion} */ ('R')
      const other = button(document, into.paste, '', () => {
        said = unsaid
        read()
        area.focus()
      })
      other.hidden = true
      change({}, ({ params }) => {
        pasted = { area, fault, is: keyOf(params) }
        area.value = written(params)
        return {}
      })
      function read() {
        const read = readSystem(area.value, said ?? motionIn(document.documentElement.dataset.notation ?? ''))
        const remark = read.ok ? remarks(read) : ''
        if (area.previousSibling) area.previousSibling.textContent = remark ? `${TITLE}.${remark}` : TITLE
        // Where the sizes fit both books, the other is a press away.
        other.hidden = !read.ok || read.noises?.told !== 'letters'
        if (!read.ok) return say('paste', `${read.line > 0 ? `Line ${read.line}: ` : ''}${read.fault}`)
        unsaid = read.noises?.V === 'Q' ? 'R' : 'Q'
        other.textContent = `Take ${unsaid} as the noise of the motion`
        propose('paste', () => paramsOf(read.system), read.places)
        if (wrong() === '') pasted = { area, fault, is: made() }
      }
      area.addEventListener('input', read)
      area.focus()
      area.select()
    },
    /** @param {string} language @param {string} text */
    async give(language, text) {
      const name = wrong() === '' ? `The system in ${language}` : `The last system without a fault, in ${language}`
      const { area, close } = openGiven(name, 'own-code')
      button(document, into.give, 'Close', close)
      area.readOnly = true
      area.rows = 10
      area.value = text
      area.focus({ preventScroll: true })
      area.select()
      if ((await copied(text)) && area.previousSibling) area.previousSibling.textContent = `${name}, copied`
    },
    /** The fault of what is pasted; empty where there is none. @param {string} words */
    say(words) {
      if (pasted && pasted.fault.textContent !== words) pasted.fault.textContent = words
    },
    /** A system that comes from elsewhere takes the place of what is pasted. @param {any} params @param {string} now */
    show(params, now) {
      // What is not understood is not lost: the reader may be at mending it.
      if (!pasted || pasted.is === now || wrong() === 'paste') return
      pasted.area.value = written(params)
      pasted.is = now
    },
  }
}
