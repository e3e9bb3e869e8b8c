/** What is said of a log that was opened: what it holds, what is wrong with it and where, and that it is being read. */

import { button, part } from '../draw/dom.js'
import { othersWords } from './log-file-words.js'

/** What pasted rows are called, as a file has its name. */
export const PASTED = 'pasted rows'

export class Answer {
  /** @param {HTMLElement} box @param {HTMLTextAreaElement} text the rows that were pasted */
  constructor(box, text) {
    this.box = box
    this.text = text
    /** The bar of the question that waits for its answer. @type {Element | null} */
    this.bar = null
  }

  /** Shows the bar of a question. @param {Element} bar */
  begin(bar) {
    this.bar = bar
    this.say('')
  }

  /** Takes a bar away, if no later question has put its own there. @param {Element} bar */
  end(bar) {
    if (this.bar === bar) this.bar = null
  }

  /** @param {any} answer */
  wrong({ files, file, line, column, message, shown, mend: given, name: unread }) {
    const name = unread || (files[file]?.name ?? 'the log')
    const place = line === 0 ? '' : `${name}, line ${line}, character ${column}: `
    this.say('')
    const words = part(document, this.box, 'p', 'log-wrong')
    // A file keeps its name at the beginning of a sentence, and a question its mark at the end.
    const named = files.some((/** @type {any} */ { name }) => message.startsWith(name))
    const sentence = named ? message : `${message[0].toUpperCase()}${message.slice(1)}`
    words.textContent = `${place}${place ? message : sentence}${/[.?]$/.test(message) ? '' : '.'}`
    if (shown) {
      const lines = part(document, this.box, 'pre', 'log-line')
      const before = [...shown].slice(0, column - 1)
      lines.append(before.join(''))
      part(document, lines, 'mark', '').textContent = [...shown][column - 1] ?? ' '
      lines.append([...shown].slice(column).join(''))
    }
    const tables = files.some((/** @type {any} */ { role }) => role !== 'log')
    const open = `Open the missing file together with ${files.length === 1 ? 'this one' : 'these'}`
    const pasted = name === PASTED
    const usual = place ? `Mend the ${pasted ? 'rows' : 'file'}` : pasted ? 'Paste rows of motion too' : open
    const mend = given || usual
    const again = given
      ? ''
      : tables
        ? `, or correct below how ${pasted ? 'they' : 'the files'} are read`
        : place
          ? ` and ${pasted ? 'read them' : 'open it'} again`
          : ''
    part(document, this.box, 'p', '').textContent = `The figure keeps the previous log. ${mend}${again}.`
    // A fault of all together is of none of them, and a question or a row is of one.
    const others = othersWords(files, place || given ? file : -1)
    if (others) part(document, this.box, 'p', '').textContent = others
    if (place && pasted) this.point(line, column)
  }

  /** Puts the cursor of the pasted rows where the fault is. @param {number} line @param {number} column */
  point(line, column) {
    const { text } = this
    const lines = text.value.split('\n')
    const from = lines.slice(0, line - 1).reduce((sum, each) => sum + each.length + 1, 0)
    const at = from + Math.max(0, [...(lines[line - 1] ?? '')].slice(0, column - 1).join('').length)
    text.focus()
    text.setSelectionRange(at, from + (lines[line - 1]?.length ?? 0))
  }

  /** The way to what the filter makes of the log: on a phone the files, as they are read, stand before it. */
  lead() {
    const link = /** @type {HTMLAnchorElement} */ (part(document, part(document, this.box, 'p', 'log-lead'), 'a', ''))
    link.href = '#fig-own-log'
    link.textContent = 'See the map and the verdict'
    // Keys go on there: a place that takes no focus would leave them with the page.
    link.addEventListener('click', () => {
      const figure = document.querySelector('#fig-own-log')
      figure?.setAttribute('tabindex', '-1')
      if (figure instanceof HTMLElement) figure.focus({ preventScroll: true })
    })
  }

  /**
   * Says something that a press makes otherwise.
   * @param {{ words: string, press: string, after: string }} told @param {() => void} act
   */
  offer({ words, press, after }, act) {
    const line = part(document, this.box, 'p', 'log-offer')
    line.append(`${words} `)
    const pressed = button(document, line, press, () => {
      act()
      line.textContent = after
      line.tabIndex = -1
      line.focus({ preventScroll: true })
    })
    pressed.className = 'try'
  }

  /** Says that the log is read otherwise than its files have it, and reads it as they do. @param {() => void} act */
  correct(act) {
    const line = part(document, this.box, 'p', '')
    line.append('The log is read otherwise than its files have it. ')
    button(document, line, 'Take it all back', act).className = 'try'
  }

  /**
   * What came of a file of settings, below what is said of the log.
   * @param {string} words @param {boolean} taken then no others are offered
   */
  tell(words, taken) {
    if (taken) this.box.querySelector('.log-offer')?.remove()
    const before = this.box.querySelector('.log-told')
    const line = before ?? part(document, this.box, 'p', 'log-told')
    line.textContent = words
  }

  /** @param {string} words */
  say(words) {
    this.box.replaceChildren()
    if (words) part(document, this.box, 'p', '').textContent = words
    if (this.bar) this.box.append(this.bar)
  }
}
