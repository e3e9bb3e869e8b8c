/**
 * What a figure says in words. A screen reader hears what the frame shows once the figure has come to rest. Notes say
 * what became of a button or a link, and every reader sees them.
 */

import { button, focusFirst } from '../draw/dom.js'
import { plain } from '../draw/words.js'

/**
 * A frame is announced this long after the last change, milliseconds. A run in play changes at every step: there the
 * wait is longer, and counts from the first change.
 */
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
    /** When to speak, and when the timer ends. */
    this.speakAt = 0
    this.wakesAt = 0
    /** @type {HTMLElement | null} */
    this.note = null
    /** @type {ReturnType<typeof setTimeout> | undefined} */
    this.noting = undefined
    /** Whether the note stays until the reader does something. */
    this.lasting = false
    this.status = document.createElement('p')
    this.status.className = 'visually-hidden'
    this.status.setAttribute('role', 'status')
  }

  /** @param {HTMLElement} note where notes are shown @param {any} frame the first, of which nothing need be said */
  begin(note, frame) {
    this.note = note
    this.said = frame
  }

  /** Announces, after the pause, the frame that is on the screen by then. */
  soon() {
    const { playing } = this.present()
    if (playing && this.speaking) return
    const now = performance.now()
    this.speakAt = now + (playing ? PAUSE_IN_PLAY : PAUSE)
    if (this.speaking && this.wakesAt <= this.speakAt) return
    clearTimeout(this.speaking)
    this.wait(now)
  }

  /** One timer serves many changes: when it ends it waits again if there was a change meanwhile. @param {number} now */
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
    const words = plain(this.spec.announce(frame, this.said))
    // While a run plays, words that differ only in their numbers are not announced again.
    const gist = words.replace(/[\d.]+/g, '')
    if (playing && gist === this.gist) return
    this.gist = gist
    this.said = frame
    if (words) this.status.textContent = words
  }

  /**
   * Says words, and shows them for a while.
   * @param {string} words
   * @param {boolean} [lasting] whether they stay until the reader dismisses them or does something else
   */
  tell(words, lasting = false) {
    this.status.textContent = words
    const { note } = this
    if (!note) return
    note.textContent = words
    clearTimeout(this.noting)
    this.lasting = lasting
    if (!lasting) {
      this.noting = setTimeout(() => {
        note.textContent = ''
      }, NOTE_MS)
      return
    }
    note.append(' ')
    button(
      document,
      note,
      'Dismiss',
      () => {
        this.hush()
        focusFirst(this.host)
      },
      'quiet',
    )
  }

  /** Takes a lasting note away, because the reader has done something. */
  hush() {
    if (this.lasting && this.note) this.note.textContent = ''
    this.lasting = false
  }
}
