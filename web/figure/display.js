/**
 * Draws frames. The first panel, whose handles the reader drags, is drawn in every turn that changes it. Controls,
 * readouts, labels and the other panels follow in the same turn if there is time; on a slow machine they follow one
 * after another.
 */

import { STEP_MS, ease } from './motion.js'

/** Once a turn has taken this long, milliseconds, the other panels wait for the next turn … */
const PATIENCE = 4
/** … but for this long at most, milliseconds; then one of them is drawn all the same. Readouts wait likewise. */
const LAG = 200
/** A figure narrower than this, pixels, keeps the size it had. */
const LEAST_WIDTH = 120
/** While a run plays the labels, which only screen readers read, are written this seldom, milliseconds. */
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
    /** The frame with the parameters that the reader has asked for, which controls and handles show. @type {any} */
    this.wanted = null
    /** @type {any} */
    this.previous = null
    /** What has been computed beside the run. @type {any} */
    this.aside = null
    this.beatStart = -Infinity
    /** @type {import('./spec.js').View['memory']} */
    this.memory = {}
    /** Whether the first panel is still moving, by its camera or by the animation of a step. */
    this.moving = false
    /** What each panel shows. @type {Map<string, { frame: any, width: number, height: number, aside: any }>} */
    this.drawn = new Map()
    /** Which of the other panels is drawn next. */
    this.next = 0
    /** When one of the other panels was last drawn. */
    this.caughtUp = -Infinity
    /** What controls, readouts and labels show already: a turn may move the camera without a new frame. */
    this.shown = {
      frame: /** @type {any} */ (null),
      wanted: /** @type {any} */ (null),
      at: -Infinity,
      described: /** @type {any} */ (null),
      describedAt: -Infinity,
      rate: 1,
      playing: false,
    }
  }

  /**
   * @param {any} frame to be shown
   * @param {any} previous the one a step led from
   * @param {number} beatStart when its animation starts
   * @param {any} far the one of its run that has come farthest
   */
  take(frame, previous, beatStart, far) {
    this.shell.fit(frame)
    this.frame = frame
    this.wanted = frame
    this.previous = previous
    this.beatStart = beatStart
    this.memory.far = far
  }

  /** @param {boolean} [anew] whether every panel is to be drawn again */
  measure(anew) {
    if (anew) for (const shown of this.drawn.values()) shown.width = NaN
    // In a frame that is folded away there is nothing to draw on.
    if (this.shell.into.getBoundingClientRect().width < LEAST_WIDTH) return
    for (const panel of Object.values(this.shell.panels)) {
      const { width, height } = panel.svg.getBoundingClientRect()
      if (width < 1 || (Math.abs(panel.width - width) < 0.5 && Math.abs(panel.height - height) < 0.5)) continue
      const usual = ['height', 'width'].map((side) => Number(panel.svg.getAttribute(side)))
      panel.width = width
      panel.height = (width * usual[0]) / usual[1]
      panel.svg.setAttribute('viewBox', `0 0 ${panel.width} ${panel.height}`)
    }
  }

  /**
   * Draws the first panel.
   * @param {number} now
   * @param {number} glide how long its camera has had to move, milliseconds
   * @returns {boolean} whether it is still moving
   */
  paint(now, glide) {
    const beat = this.beat(now)
    const [first] = this.spec.panels
    const view = {
      previous: this.previous,
      beat,
      elapsed: glide,
      memory: this.memory,
      aside: this.aside,
      limits: this.shell.limits,
      handle: this.handle,
    }
    if (this.moving || beat.name !== 'rest' || !this.shows(first.name)) {
      this.moving = first.draw(this.shell.panels[first.name], this.wanted, view) === true || beat.name !== 'rest'
      this.showed(first.name)
    }
    return this.moving
  }

  /**
   * Which half of a step's animation is on the screen, and how far it has come.
   * @param {number} now
   * @returns {import('./spec.js').Beat}
   */
  beat(now) {
    const t = (now - this.beatStart) / (STEP_MS / 2)
    if (t < 1) return { name: 'predict', t: ease(Math.max(0, t)) }
    return t < 2 ? { name: 'update', t: ease(t - 1) } : { name: 'rest', t: 1 }
  }

  /**
   * Writes controls, readouts and labels.
   * @param {number} now
   * @param {number} began when this turn began
   * @param {{ rate: number, playing: boolean }} how
   * @returns {boolean} whether they wait for the next turn, on a slow machine
   */
  label(now, began, { rate, playing }) {
    const { shell, spec, frame, wanted, shown } = this
    const asked = shown.rate !== rate || shown.playing !== playing || (shown.frame === frame && shown.wanted !== wanted)
    if (!asked && performance.now() - began > PATIENCE && began - shown.at < LAG) return shown.frame !== frame
    if (asked || shown.frame !== frame) {
      this.shown = { ...shown, frame, wanted, at: began, rate, playing }
      shell.show(frame, this.shown, wanted.params)
      // The room that the sentence needs is that of its words in one notation.
      if (spec.layout.along)
        shell.into.setAttribute(
          'data-said',
          (shell.verdict.querySelector('.in-choset') ?? shell.verdict).textContent ?? '',
        )
    }
    if (
      shown.described !== frame &&
      this.beat(now).name === 'rest' &&
      (!playing || now - shown.describedAt > LABELS_MS)
    ) {
      this.shown.described = frame
      this.shown.describedAt = now
      for (const [name, words] of Object.entries(spec.describe(frame)))
        shell.panels[name].svg.setAttribute('aria-label', words)
    }
    return false
  }

  /**
   * Draws the other panels where they show an older frame or another size. On a slow machine it draws some of them and
   * leaves the rest to later turns, so that the first panel follows the hand.
   * @param {number} began when this turn began
   * @returns {boolean} whether a panel is left
   */
  drawOthers(began) {
    const { shell, frame } = this
    const others = this.spec.panels.slice(1).filter(({ shown }) => shown?.(frame) ?? true)
    const view = {
      previous: null,
      beat: /** @type {const} */ ({ name: 'rest', t: 1 }),
      elapsed: Infinity,
      memory: this.memory,
      aside: this.aside,
      limits: shell.limits,
      handle: this.handle,
    }
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
    const { frame, width, height, aside } = this.due(name)
    return last?.frame === frame && last?.width === width && last?.height === height && last?.aside === aside
  }

  /** @param {string} name */
  showed(name) {
    this.drawn.set(name, this.due(name))
  }

  /** What a panel has to show: the first one has the handles, which follow the reader at once. @param {string} name */
  due(name) {
    const { panels } = this.spec
    const frame = name === panels[0].name ? this.wanted : this.frame
    const aside = panels.find((panel) => panel.name === name)?.aside ? this.aside : null
    const { width, height } = this.shell.panels[name]
    return { frame, width, height, aside }
  }
}
