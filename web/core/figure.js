/**
 * A figure's life: still → loading → live, or failed with a way to try again.
 *
 * It starts when it comes near the screen and rests when it leaves or the tab hides. Input only writes what is wanted;
 * one turn of the animation frame does the work: parameters to the lab, steps that are due, one frame, one drawing.
 */

import { asCsv, asSvg, save } from './download.js'
import { button, focusFirst } from './element.js'
import { hideFailure, showFailure } from './failure.js'
import { liveHandles } from './handle.js'
import { openLab, withState } from './link.js'
import { loadModule } from './module.js'
import { STEP_MS, ease } from './motion.js'
import { buildShell } from './shell.js'

/** @typedef {import('./spec.js').FigureSpec} FigureSpec */

const NEAR = '300px 0px'
const MOST_STEPS = 64
/** Where motion is not wanted a run goes on in lumps, and this long, milliseconds, each picture stays. */
const STILL_MS = 500
/** A turn that has worked so long, milliseconds, leaves the panels it has not drawn to the next … */
const PATIENCE = 4
/** … unless nothing but the first has been drawn for so long: then one of them is. Words and numbers wait likewise. */
const LAG = 200

/**
 * Defines the custom element of a specification.
 * @param {FigureSpec} spec
 */
export function defineFigure(spec) {
  if (customElements.get(spec.tag)) return
  customElements.define(spec.tag, class extends HTMLElement {
    /** @type {Figure | null} */
    figure = null

    connectedCallback() {
      // Its script is here now, though it was another of its kind that asked again.
      if (!this.figure) hideFailure(this)
      this.figure ??= new Figure(this, spec)
      this.figure.watch()
    }

    disconnectedCallback() {
      this.figure?.rest()
    }

    /** The frame on the screen, for tests and for the curious. */
    get frame() {
      return this.figure?.frame ?? null
    }

    /** Whether every panel shows that frame, or will not wait for the rest to. */
    get settled() {
      return !this.figure?.behind || this.figure.playing
    }

    /** Parameters and step, as a link carries them. */
    get state() {
      return this.figure?.lab?.state() ?? null
    }
  })
}

class Figure {
  /** @param {HTMLElement} host @param {FigureSpec} spec */
  constructor(host, spec) {
    this.host = host
    this.spec = spec
    this.id = host.dataset.figure || spec.tag
    /** @type {any} */
    this.lab = null
    /** @type {any} */
    this.frame = null
    /** @type {any} */
    this.previous = null
    /** @type {import('./shell.js').Shell | null} */
    this.shell = null
    this.playing = false
    this.rate = 1
    this.near = false
    /** What the reader wants and the next turn does. @type {{ patch: Record<string, unknown> | null, steps: number, reset: boolean, draw: boolean }} */
    this.wanted = { patch: null, steps: 0, reset: false, draw: false }
    this.due = 0
    /** When steps were last taken in play. */
    this.stepped = -Infinity
    this.beatStart = -Infinity
    this.turned = NaN
    this.memory = {}
    /** What each panel shows. @type {Map<string, { frame: any, width: number }>} */
    this.drawn = new Map()
    /** The panel, of those behind the first, whose turn it is to be drawn. */
    this.next = 0
    this.behind = false
    /** Whether the first panel has not come to rest: its camera, or a beat. */
    this.moving = false
    /** When one of them was last drawn. */
    this.caughtUp = -Infinity
    this.said = /** @type {any} */ (null)
    /** What controls, readouts and labels say already: a camera or a beat may move without a new frame. */
    this.shown = { frame: /** @type {any} */ (null), at: -Infinity, described: /** @type {any} */ (null), describedAt: -Infinity, rate: 1, playing: false }
    this.calm = matchMedia('(prefers-reduced-motion: reduce)')
    this.asked = 0
    /** @type {IntersectionObserver | undefined} */
    this.eye = undefined
    /** @type {ResizeObserver | undefined} */
    this.resized = undefined
    this.speaking = 0
    /** When to speak, and when the timer looks whether to. */
    this.speakAt = 0
    this.wakesAt = 0
    this.gist = ''
    /** @type {ReturnType<typeof setTimeout> | undefined} */
    this.noting = undefined
    /** Whether what is noted stays until the reader does something. */
    this.lasting = false
    this.handle = liveHandles((patch) => this.change(patch), () => this.settle())
    this.status = document.createElement('p')
    this.status.className = 'visually-hidden'
    this.status.setAttribute('role', 'status')
  }

  watch() {
    this.host.dataset.state ??= 'still'
    this.eye ??= new IntersectionObserver((entries) => this.approach(entries[entries.length - 1].isIntersecting), { rootMargin: NEAR })
    this.eye.observe(this.host)
    document.addEventListener('visibilitychange', this.wake)
  }

  rest() {
    this.eye?.disconnect()
    this.resized?.disconnect()
    document.removeEventListener('visibilitychange', this.wake)
    cancelAnimationFrame(this.asked)
    this.asked = 0
    this.near = false
  }

  wake = () => this.ask()

  /** @param {boolean} near */
  approach(near) {
    this.near = near
    if (near && this.host.dataset.state === 'still') this.start()
    else if (near && this.shell) this.ask()
  }

  async start() {
    this.host.dataset.state = 'loading'
    hideFailure(this.host)
    const loaded = await loadModule()
    if (!loaded.ok) return this.fail(loaded.why)
    try {
      const { lab, mangled } = openLab(loaded.module, this.spec, this.id, this.host.dataset.start)
      this.lab = lab
      this.live()
      if (mangled) this.tell('The link to this figure could not be read; it shows its usual state.', true)
    } catch (error) {
      this.fail(error instanceof Error ? error.message : 'its lab could not be started')
    }
  }

  live() {
    const into = document.createElement('div')
    into.className = 'live'
    this.shell = buildShell(document, this.spec, into, {
      play: () => this.play(!this.playing),
      step: () => this.steps(),
      reset: () => this.reset(),
      speed: (rate) => {
        this.rate = rate
        this.want('draw', true)
      },
      change: (patch, make) => this.change(make ? make(this.frame, this.lab) : patch),
      link: () => this.copyLink(),
      download: (kind) => this.download(kind),
    })
    this.take(this.lab.frame())
    this.said = this.frame
    this.host.append(into, this.status)
    this.host.dataset.state = 'live'
    this.resized = new ResizeObserver(() => this.measure())
    for (const { svg } of Object.values(this.shell.panels)) this.resized.observe(svg)
    this.measure()
    this.turn(performance.now())
  }

  /** @param {string} why */
  fail(why) {
    showFailure(this.host, why, () => this.start())
  }

  measure() {
    for (const panel of Object.values(this.shell?.panels ?? {})) {
      const { width, height } = panel.svg.getBoundingClientRect()
      if (width < 1 || (Math.abs(panel.width - width) < 0.5 && Math.abs(panel.height - height) < 0.5)) continue
      const usual = this.spec.panels.find(({ name }) => panel.svg.classList.contains(`panel-${name}`))
      panel.width = width
      panel.height = usual ? (width * usual.height) / usual.width : height
      panel.svg.setAttribute('viewBox', `0 0 ${panel.width} ${panel.height}`)
    }
    this.want('draw', true)
  }

  // What the reader wants.

  /** @param {Record<string, unknown>} patch */
  change(patch) {
    this.hush()
    this.want('patch', { ...this.wanted.patch, ...patch })
  }

  settle() {
    if (this.wanted.patch) this.turn(performance.now())
  }

  /** @param {boolean} on */
  play(on) {
    this.hush()
    this.playing = on
    this.due = on ? 1 : 0
    if (!on) this.speakSoon()
    this.want('draw', true)
  }

  steps() {
    this.hush()
    this.playing = false
    this.want('steps', this.wanted.steps + (this.spec.stride ?? 1))
  }

  reset() {
    this.hush()
    this.playing = false
    this.want('reset', true)
  }

  /**
   * @template {keyof Figure['wanted']} K
   * @param {K} key
   * @param {Figure['wanted'][K]} value
   */
  want(key, value) {
    this.wanted[key] = value
    this.ask()
  }

  ask() {
    if (this.asked || !this.shell || !this.near || document.hidden) return
    this.asked = requestAnimationFrame((now) => {
      this.asked = 0
      this.turn(now)
    })
  }

  // What a turn does.

  /** @param {number} now */
  turn(now) {
    const began = performance.now()
    const elapsed = Number.isNaN(this.turned) ? Infinity : Math.max(0, now - this.turned)
    this.turned = now
    const { patch, reset } = this.wanted
    const steps = this.wanted.steps + this.dueSteps(elapsed, now)
    this.wanted = { patch: null, steps: 0, reset: false, draw: false }
    try {
      if (patch) this.lab.set(patch)
      if (reset) this.restart()
      if (steps > 0) this.lab.run(steps)
      if (patch || reset || steps > 0) this.take(this.lab.frame(), steps > 0 && !patch && !reset, now)
    } catch (error) {
      this.playing = false
      this.tell(error instanceof Error ? error.message : 'The lab refused.')
    }
    const moving = this.paint(now, elapsed)
    // Both, whatever the first answers.
    const [unsaid, undrawn] = [this.sayWhatIsShown(now, began), this.drawOthers(began)]
    this.behind = unsaid || undrawn
    if (moving || this.behind || this.playing) this.ask()
    else this.turned = NaN
  }

  /** @param {number} elapsed @param {number} now */
  dueSteps(elapsed, now) {
    if (!this.playing) return 0
    this.due += Number.isFinite(elapsed) ? (Math.min(elapsed, 250) / 1000) * this.rate * (this.spec.pace ?? 2) : 0
    const calm = this.calm.matches
    if (calm && now - this.stepped < STILL_MS) return 0
    const whole = Math.min(Math.floor(this.due), calm ? 8 * MOST_STEPS : MOST_STEPS)
    this.due -= whole
    if (whole > 0) this.stepped = now
    return whole
  }

  restart() {
    const { step: _, ...state } = this.lab.state()
    const fresh = this.lab.constructor.from({ ...state, step: 0 })
    this.lab.free()
    this.lab = fresh
    this.memory = {}
  }

  /** @param {any} frame @param {boolean} [stepped] @param {number} [now] */
  take(frame, stepped = false, now = 0) {
    this.previous = stepped ? this.frame : null
    this.frame = frame
    const slow = !this.playing || this.rate * (this.spec.pace ?? 2) <= 1000 / STEP_MS
    this.beatStart = stepped && slow && this.spec.beats && !this.calm.matches ? now : -Infinity
    this.speakSoon()
  }

  /** @param {number} now @param {number} elapsed */
  paint(now, elapsed) {
    const { shell, spec, frame } = this
    if (!shell) return false
    const beat = this.beat(now)
    const glide = this.calm.matches ? Infinity : Number.isFinite(elapsed) ? elapsed : this.previous || this.frame !== this.said ? 16 : Infinity
    const [first] = spec.panels
    const view = { previous: this.previous, beat, elapsed: glide, memory: this.memory, handle: this.handle }
    if (this.moving || beat.name !== 'rest' || !this.shows(first.name)) {
      this.moving = first.draw(shell.panels[first.name], frame, view) === true || beat.name !== 'rest'
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
   * @param {number} began
   * @returns {boolean} whether they are behind, on a slow machine
   */
  sayWhatIsShown(now, began) {
    const { shell, spec, frame, shown } = this
    if (!shell) return false
    const asked = shown.rate !== this.rate || shown.playing !== this.playing
    if (!asked && performance.now() - began > PATIENCE && began - shown.at < LAG) return shown.frame !== frame
    if (asked || shown.frame !== frame) {
      this.shown = { ...shown, frame, at: began, rate: this.rate, playing: this.playing }
      shell.show(frame, this.shown)
    }
    // Nobody hears a label change at every frame: while it plays they follow twice a second.
    if (shown.described !== frame && this.beat(now).name === 'rest' && (!this.playing || now - shown.describedAt > 500)) {
      this.shown.described = frame
      this.shown.describedAt = now
      for (const [name, words] of Object.entries(spec.describe(frame))) shell.panels[name].svg.setAttribute('aria-label', words)
    }
    return false
  }

  /** Whether a panel shows the present frame at its present size. @param {string} name */
  shows(name) {
    const last = this.drawn.get(name)
    return last?.frame === this.frame && last?.width === this.shell?.panels[name].width
  }

  /** @param {string} name */
  showed(name) {
    if (this.shell) this.drawn.set(name, { frame: this.frame, width: this.shell.panels[name].width })
  }

  /**
   * Draws what shows another frame than the present one, or another size. On a slow machine not all at once: what the hand
   * moves follows it, and the plots come after.
   * @param {number} began when this turn did
   * @returns {boolean} whether a panel is left
   */
  drawOthers(began) {
    const { shell, spec, frame } = this
    if (!shell) return false
    const others = spec.panels.slice(1)
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

  // What it says and gives.

  /** Half a second after the last change; of a run, which changes at every step, every four seconds. */
  speakSoon() {
    if (this.playing && this.speaking) return
    const now = performance.now()
    this.speakAt = now + (this.playing ? 4000 : 500)
    if (this.speaking && this.wakesAt <= this.speakAt) return
    clearTimeout(this.speaking)
    this.waitToSpeak(now)
  }

  /** One timer, that goes on where there was a change meanwhile, and not a new one at each. @param {number} now */
  waitToSpeak(now) {
    this.wakesAt = this.speakAt
    this.speaking = window.setTimeout(() => {
      const then = performance.now()
      if (this.speakAt > then + 1) this.waitToSpeak(then)
      else this.announce()
    }, this.speakAt - now)
  }

  announce() {
    this.speaking = 0
    const words = this.spec.announce(this.frame, this.said)
    // While it plays only what reads differently without its numbers is worth an interruption.
    const gist = words.replace(/[\d.]+/g, '')
    if (this.playing && gist === this.gist) return
    this.gist = gist
    this.said = this.frame
    if (words) this.status.textContent = words
  }

  /** @param {string} words said, and shown for a while @param {boolean} [lasting] or until dismissed, or the next action */
  tell(words, lasting = false) {
    this.status.textContent = words
    if (!this.shell) return
    const { note } = this.shell
    note.textContent = words
    clearTimeout(this.noting)
    this.lasting = lasting
    if (!lasting) {
      this.noting = setTimeout(() => { note.textContent = '' }, 8000)
      return
    }
    note.append(' ')
    button(document, note, 'Dismiss', () => {
      this.hush()
      focusFirst(this.host)
    }, 'quiet')
  }

  hush() {
    if (this.lasting && this.shell) this.shell.note.textContent = ''
    this.lasting = false
  }

  async copyLink() {
    // What the address says of other figures is as old as the address.
    let link = location.href
    for (const other of /** @type {NodeListOf<HTMLElement & { state: any }>} */ (document.querySelectorAll('.widget[data-state="live"]'))) {
      const id = other.dataset.figure ?? ''
      if (new URL(link).searchParams.has(id)) link = withState(link, id, other.state)
    }
    link = withState(link, this.id, this.lab.state())
    try {
      await navigator.clipboard.writeText(link)
      this.tell('Link copied.')
    } catch {
      history.replaceState(null, '', link)
      this.tell('The link is in the address bar.')
    }
  }

  /** @param {'svg' | 'csv'} kind */
  download(kind) {
    if (!this.shell) return
    if (kind === 'csv') save(`${this.id}.csv`, 'text/csv', asCsv(this.spec.series(this.frame)))
    else save(`${this.id}.svg`, 'image/svg+xml', asSvg(this.shell.into, Object.values(this.spec.describe(this.frame)).join(' ')))
  }
}
