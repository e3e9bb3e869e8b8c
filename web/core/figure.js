/**
 * A figure's life: still → loading → live, or failed with a way to try again.
 *
 * It starts when it comes near the screen and rests when it leaves or the tab hides. Input only writes what is wanted;
 * one turn of the animation frame does the work: parameters to the lab, steps that are due, one frame, one drawing.
 */

import { Display } from './display.js'
import { asCsv, asSvg, save } from './download.js'
import { hideFailure, showFailure } from './failure.js'
import { liveHandles } from './handle.js'
import { openLab, withState } from './link.js'
import { loadModule } from './module.js'
import { STEP_MS } from './motion.js'
import { buildShell } from './shell.js'
import { Voice } from './voice.js'

/** @typedef {import('./spec.js').FigureSpec} FigureSpec */

const NEAR = '300px 0px'
const MOST_STEPS = 64
/** Where motion is not wanted a run goes on in lumps, and this long, milliseconds, each picture stays. */
const STILL_MS = 500

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
    /** @type {import('./shell.js').Shell | null} */
    this.shell = null
    /** @type {Display | null} */
    this.display = null
    this.playing = false
    this.rate = 1
    this.near = false
    /** What the reader wants and the next turn does. @type {{ patch: Record<string, unknown> | null, steps: number, reset: boolean, draw: boolean }} */
    this.wanted = { patch: null, steps: 0, reset: false, draw: false }
    this.due = 0
    /** When steps were last taken in play. */
    this.stepped = -Infinity
    this.turned = NaN
    /** Whether something on the screen is older than the frame. */
    this.behind = false
    this.calm = matchMedia('(prefers-reduced-motion: reduce)')
    this.asked = 0
    /** @type {IntersectionObserver | undefined} */
    this.eye = undefined
    /** @type {ResizeObserver | undefined} */
    this.resized = undefined
    this.handle = liveHandles((patch) => this.change(patch), () => this.settle())
    this.voice = new Voice(host, spec, () => this)
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
      if (mangled) this.voice.tell('The link to this figure could not be read; it shows its usual state.', true)
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
    this.display = new Display(this.spec, this.shell, this.handle)
    this.take(this.lab.frame())
    this.voice.begin(this.shell.note, this.frame)
    this.host.append(into, this.voice.status)
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
    this.display?.measure()
    this.want('draw', true)
  }

  // What the reader wants.

  /** @param {Record<string, unknown>} patch */
  change(patch) {
    this.voice.hush()
    this.want('patch', { ...this.wanted.patch, ...patch })
  }

  settle() {
    if (this.wanted.patch) this.turn(performance.now())
  }

  /** @param {boolean} on */
  play(on) {
    this.voice.hush()
    this.playing = on
    this.due = on ? 1 : 0
    if (!on) this.voice.soon()
    this.want('draw', true)
  }

  steps() {
    this.voice.hush()
    this.playing = false
    this.want('steps', this.wanted.steps + (this.spec.stride ?? 1))
  }

  reset() {
    this.voice.hush()
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
      this.voice.tell(error instanceof Error ? error.message : 'The lab refused.')
    }
    const { display } = this
    if (!display) return
    const moving = display.paint(now, this.glide(elapsed))
    // Both, whatever the first answers.
    const [unlabelled, undrawn] = [display.label(now, began, this), display.drawOthers(began)]
    this.behind = unlabelled || undrawn
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
    if (this.display) this.display.memory = {}
  }

  /** @param {any} frame @param {boolean} [stepped] @param {number} [now] */
  take(frame, stepped = false, now = 0) {
    const slow = !this.playing || this.rate * (this.spec.pace ?? 2) <= 1000 / STEP_MS
    const inBeats = stepped && slow && this.spec.beats && !this.calm.matches
    this.display?.take(frame, stepped ? this.frame : null, inBeats ? now : -Infinity)
    this.frame = frame
    this.voice.soon()
  }

  /** How long a camera has had to move: for ever before the first picture, where it is at once. @param {number} elapsed */
  glide(elapsed) {
    if (this.calm.matches) return Infinity
    if (Number.isFinite(elapsed)) return elapsed
    return this.display?.drawn.size ? 16 : Infinity
  }

  // What it gives.

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
      this.voice.tell('Link copied.')
    } catch {
      history.replaceState(null, '', link)
      this.voice.tell('The link is in the address bar.')
    }
  }

  /** @param {'svg' | 'csv'} kind */
  download(kind) {
    if (!this.shell) return
    if (kind === 'csv') save(`${this.id}.csv`, 'text/csv', asCsv(this.spec.series(this.frame)))
    else save(`${this.id}.svg`, 'image/svg+xml', asSvg(this.shell.into, Object.values(this.spec.describe(this.frame)).join(' ')))
  }
}
