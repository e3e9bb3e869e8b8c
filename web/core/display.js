/**
 * What of a frame is on the screen. The first panel, which the hand moves, is drawn at every turn that changes it; controls,
 * readouts, labels and the other panels where there is time, on a slow machine one after another.
 */

import { STEP_MS, ease } from './motion.js'

/** A turn that has worked so long, milliseconds, leaves the panels it has not drawn to the next … */
const PATIENCE = 4
/** … unless nothing but the first has been drawn for so long: then one of them is. Words and numbers wait likewise. */
const LAG = 200
/** Nobody hears a label change at every frame: while it plays they follow twice a second. */
const LABELS_MS = 500

export class Display {
  /**
   * @param {import('./spec.js').FigureSpec} spec
   * @param {import('./shell.js').Shell} shell
   * @param {import('./spec.js').View['handle']} handle
   */
  constructor(spec, shell, handle) {
    this.spec = spec
    this.shell = shell
    this.handle = handle
    /** @type {any} */
    this.frame = null
    /** @type {any} */
    this.previous = null
    this.beatStart = -Infinity
    this.memory = {}
    /** Whether the first panel has not come to rest: its camera, or a beat. */
    this.moving = false
    /** What each panel shows. @type {Map<string, { frame: any, width: number }>} */
    this.drawn = new Map()
    /** The panel, of those behind the first, whose turn it is to be drawn. */
    this.next = 0
    /** When one of them was last drawn. */
    this.caughtUp = -Infinity
    /** What controls, readouts and labels say already: a camera or a beat may move without a new frame. */
    this.shown = { frame: /** @type {any} */ (null), at: -Infinity, described: /** @type {any} */ (null), describedAt: -Infinity, rate: 1, playing: false }
  }

  /** @param {any} frame to be shown @param {any} previous the one a step led from @param {number} beatStart */
  take(frame, previous, beatStart) {
    this.frame = frame
    this.previous = previous
    this.beatStart = beatStart
  }

  measure() {
    for (const panel of Object.values(this.shell.panels)) {
      const { width, height } = panel.svg.getBoundingClientRect()
      if (width < 1 || (Math.abs(panel.width - width) < 0.5 && Math.abs(panel.height - height) < 0.5)) continue
      const usual = this.spec.panels.find(({ name }) => panel.svg.classList.contains(`panel-${name}`))
      panel.width = width
      panel.height = usual ? (width * usual.height) / usual.width : height
      panel.svg.setAttribute('viewBox', `0 0 ${panel.width} ${panel.height}`)
    }
  }

  /**
   * The first panel.
   * @param {number} now
   * @param {number} glide how long its camera has had to move
   * @returns {boolean} whether it is still moving
   */
  paint(now, glide) {
    const beat = this.beat(now)
    const [first] = this.spec.panels
    const view = { previous: this.previous, beat, elapsed: glide, memory: this.memory, handle: this.handle }
    if (this.moving || beat.name !== 'rest' || !this.shows(first.name)) {
      this.moving = first.draw(this.shell.panels[first.name], this.frame, view) === true || beat.name !== 'rest'
      this.showed(first.name)
    }
    return this.moving
  }

  /** Which half of a step is on the screen, and how far along. @param {number} now @returns {import('./spec.js').Beat} */
  beat(now) {
    const t = (now - this.beatStart) / (STEP_MS / 2)
    if (t < 1) return { name: 'predict', t: ease(Math.max(0, t)) }
    return t < 2 ? { name: 'update', t: ease(t - 1) } : { name: 'rest', t: 1 }
  }

  /**
   * Controls, readouts and labels.
   * @param {number} now
   * @param {number} began when this turn did
   * @param {{ rate: number, playing: boolean }} how
   * @returns {boolean} whether they are behind, on a slow machine
   */
  label(now, began, { rate, playing }) {
    const { shell, spec, frame, shown } = this
    const asked = shown.rate !== rate || shown.playing !== playing
    if (!asked && performance.now() - began > PATIENCE && began - shown.at < LAG) return shown.frame !== frame
    if (asked || shown.frame !== frame) {
      this.shown = { ...shown, frame, at: began, rate, playing }
      shell.show(frame, this.shown)
    }
    if (shown.described !== frame && this.beat(now).name === 'rest' && (!playing || now - shown.describedAt > LABELS_MS)) {
      this.shown.described = frame
      this.shown.describedAt = now
      for (const [name, words] of Object.entries(spec.describe(frame))) shell.panels[name].svg.setAttribute('aria-label', words)
    }
    return false
  }

  /**
   * Draws what shows another frame than the present one, or another size. On a slow machine not all at once: what the hand
   * moves follows it, and the plots come after.
   * @param {number} began when this turn did
   * @returns {boolean} whether a panel is left
   */
  drawOthers(began) {
    const { shell, frame } = this
    const others = this.spec.panels.slice(1)
    const view = { previous: null, beat: /** @type {const} */ ({ name: 'rest', t: 1 }), elapsed: Infinity, memory: this.memory, handle: this.handle }
    for (let seen = 0; seen < others.length; seen += 1) {
      const { name, draw } = others[this.next % others.length]
      if (!this.shows(name)) {
        const patient = performance.now() - began <= PATIENCE
        if (!patient && began - this.caughtUp < LAG) return true
        draw(shell.panels[name], frame, view)
        this.showed(name)
        this.caughtUp = began
      }
      this.next += 1
    }
    return false
  }

  /** Whether a panel shows the present frame at its present size. @param {string} name */
  shows(name) {
    const last = this.drawn.get(name)
    return last?.frame === this.frame && last?.width === this.shell.panels[name].width
  }

  /** @param {string} name */
  showed(name) {
    this.drawn.set(name, { frame: this.frame, width: this.shell.panels[name].width })
  }
}
