/**
 * What a figure says: of its frames to a screen reader, when they have come to rest, and of what became of a press or a
 * link to everyone.
 */

import { button, focusFirst } from './element.js'

/** After the last change, milliseconds; of a run, which changes at every step, this long after the first. */
const PAUSE = 500
const PAUSE_IN_PLAY = 4000
/** How long a note stands. */
const NOTE_MS = 8000

export class Voice {
  /**
   * @param {HTMLElement} host
   * @param {import('./spec.js').FigureSpec} spec
   * @param {() => { frame: any, playing: boolean }} present
   */
  constructor(host, spec, present) {
    this.host = host
    this.spec = spec
    this.present = present
    /** The frame that was last spoken of. */
    this.said = /** @type {any} */ (null)
    this.gist = ''
    this.speaking = 0
    /** When to speak, and when the timer looks whether to. */
    this.speakAt = 0
    this.wakesAt = 0
    /** @type {HTMLElement | null} */
    this.note = null
    /** @type {ReturnType<typeof setTimeout> | undefined} */
    this.noting = undefined
    /** Whether what is noted stays until the reader does something. */
    this.lasting = false
    this.status = document.createElement('p')
    this.status.className = 'visually-hidden'
    this.status.setAttribute('role', 'status')
  }

  /** @param {HTMLElement} note where words are shown @param {any} frame that needs none */
  begin(note, frame) {
    this.note = note
    this.said = frame
  }

  /** Speaks of the frame that there is then. */
  soon() {
    const { playing } = this.present()
    if (playing && this.speaking) return
    const now = performance.now()
    this.speakAt = now + (playing ? PAUSE_IN_PLAY : PAUSE)
    if (this.speaking && this.wakesAt <= this.speakAt) return
    clearTimeout(this.speaking)
    this.wait(now)
  }

  /** One timer, that goes on where there was a change meanwhile, and not a new one at each. @param {number} now */
  wait(now) {
    this.wakesAt = this.speakAt
    this.speaking = window.setTimeout(() => {
      const then = performance.now()
      if (this.speakAt > then + 1) this.wait(then)
      else this.announce()
    }, this.speakAt - now)
  }

  announce() {
    this.speaking = 0
    const { frame, playing } = this.present()
    const words = this.spec.announce(frame, this.said)
    // While it plays only what reads differently without its numbers is worth an interruption.
    const gist = words.replace(/[\d.]+/g, '')
    if (playing && gist === this.gist) return
    this.gist = gist
    this.said = frame
    if (words) this.status.textContent = words
  }

  /** @param {string} words said, and shown for a while @param {boolean} [lasting] or until dismissed, or the next action */
  tell(words, lasting = false) {
    this.status.textContent = words
    const { note } = this
    if (!note) return
    note.textContent = words
    clearTimeout(this.noting)
    this.lasting = lasting
    if (!lasting) {
      this.noting = setTimeout(() => { note.textContent = '' }, NOTE_MS)
      return
    }
    note.append(' ')
    button(document, note, 'Dismiss', () => {
      this.hush()
      focusFirst(this.host)
    }, 'quiet')
  }

  /** The reader does something: what was to stand until then goes. */
  hush() {
    if (this.lasting && this.note) this.note.textContent = ''
    this.lasting = false
  }
}
