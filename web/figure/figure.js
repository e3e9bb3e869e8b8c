/**
 * The life of a figure: still → loading → live, or failed with a way to try again.
 *
 * It starts when it comes near the screen, and rests while it is far from it or the tab is hidden. Input only notes
 * what the reader asks for. The work is done in one turn for each animation frame: the lab computes, one frame is taken
 * from it, and the panels are drawn.
 */

import { Display } from './display.js'
import { focusFirst } from '../draw/dom.js'
import { hideFailure, showFailure } from './failure.js'
import { liveHandles } from './handle.js'
import { keepFocused, keepPressed, keepTop } from './hold-scroll.js'
import { openLab } from './open-lab.js'
import { loadBuild } from '../load/modules.js'
import { STEP_MS } from './motion.js'
import { Progress } from './progress.js'
import { Run } from './run.js'
import { Share } from './share.js'
import { buildShell } from './shell.js'
import { Voice } from './announcer.js'

/** @typedef {import('./spec.js').FigureSpec} FigureSpec */

const NEAR = '300px 0px'
/** A key press waits this long at most, milliseconds, for the press before it to take effect. */
const SETTLE_MS = 6
const MANGLED = 'The link to this figure could not be read; it shows its usual state.'

export class Figure {
  /** @param {HTMLElement} host @param {FigureSpec} spec */
  constructor(host, spec) {
    this.host = host
    this.spec = spec
    this.id = host.dataset.figure || spec.tag
    /** @type {Run | null} */
    this.run = null
    /** @type {import('./shell.js').Shell | null} */
    this.shell = null
    /** @type {Display | null} */
    this.display = null
    /** @type {Progress | null} */
    this.progress = null
    /** @type {import('./spec.js').Beside | null} */
    this.beside = null
    this.near = false
    /** When the last turn was; NaN when the figure has come to rest since. */
    this.turned = NaN
    /** Whether something on the screen is older than the frame. */
    this.behind = false
    this.calm = matchMedia('(prefers-reduced-motion: reduce)')
    /** The animation frame that was asked for, 0 if none. */
    this.asked = 0
    /** @type {IntersectionObserver | undefined} */
    this.eye = undefined
    /** @type {ResizeObserver | undefined} */
    this.resized = undefined
    this.handle = liveHandles(
      (patch) => this.change(patch),
      () => this.settle(),
      () => this.measure(true),
    )
    this.voice = new Voice(host, spec, () => ({ frame: this.run?.frame, playing: this.run?.playing ?? false }))
  }

  /** The lab behind the picture. Tests ask it for digests. */
  get lab() {
    return this.run?.lab
  }

  watch() {
    this.host.dataset.state ??= 'still'
    this.eye ??= new IntersectionObserver((entries) => this.approach(entries[entries.length - 1].isIntersecting), {
      rootMargin: NEAR,
    })
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
    if (this.spec.open) return this.opened(await this.spec.open(this.id, this.host.dataset.start, this.spec))
    const loaded = await loadBuild(this.spec.build)
    if (!loaded.ok) return this.fail(loaded.why)
    try {
      const { lab, linked, mangled } = openLab(loaded.module, this.spec, this.id, this.host.dataset.start)
      this.run = new Run(lab, this.spec.pace ?? 2, undefined, this.spec.lap, this.spec.end, this.spec.whole)
      if (linked) {
        this.run.open(linked.lab, linked.step, MANGLED)
        // A link was made of a whole figure.
        if (this.host.dataset.stage) this.host.dataset.stage = '3'
      }
      this.live(this.run)
      if (mangled) this.voice.tell(MANGLED, true)
    } catch (error) {
      this.fail(error instanceof Error ? error.message : 'its lab could not be started')
    }
  }

  /** A run that the widget has opened itself. @param {import('./spec.js').Opened} opened */
  opened(opened) {
    if (!opened.ok) return this.fail(opened.why)
    this.run = opened.run
    this.live(opened.run)
    if (opened.mangled) this.voice.tell(MANGLED, true)
  }

  /** @param {Run} run */
  live(run) {
    const into = document.createElement('div')
    into.className = 'live'
    const share = new Share(this.host, this.spec, this.id, run, this.voice)
    this.shell = buildShell(
      document,
      this.spec,
      into,
      {
        play: () =>
          this.order(() => {
            run.play(!run.playing)
            if (!run.playing) this.voice.soon()
          }),
        step: () => this.order(() => run.advance(this.spec.stride ?? 1)),
        reset: () => this.order(() => run.reset()),
        speed: (rate) =>
          this.order(() => {
            run.rate = rate
          }),
        grow: (stage) => {
          keepTop(this.host)
          this.host.dataset.stage = String(stage)
          focusFirst(this.host)
        },
        change: (patch, make) => this.change(make ? make(run.wanted, run.lab) : patch),
        ...share.orders,
      },
      run.parameters(),
    )
    share.tools = this.shell.tools
    this.beside = this.spec.aside?.open(() => this.ask()) ?? null
    this.beside?.follow(run.frame)
    this.progress = new Progress(into, () => {
      if (run.progress) run.cancel()
      else this.beside?.cancel()
      this.ask()
      focusFirst(this.host)
    })
    this.display = new Display(this.spec, this.shell, this.handle)
    this.display.take(run.frame, null, -Infinity, run.far)
    this.voice.begin(this.shell.note, run.frame)
    keepTop(this.host)
    keepPressed(into, () => run.busy && !run.playing)
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

  /**
   * @param {boolean} [anew] whether the panels are drawn again even at their old size: a scale may have waited for the
   * hand
   */
  measure(anew) {
    this.display?.measure(anew)
    this.ask()
  }

  // What the reader asks for.

  /** @param {() => void} act */
  order(act) {
    this.voice.hush()
    act()
    this.ask()
  }

  /** @param {Record<string, unknown>} patch */
  change(patch) {
    this.order(() => this.run?.change(patch))
  }

  /** Brings what was asked for into the first panel, so that the next press of a key starts from there. */
  settle() {
    if (this.run?.patch) this.turn(performance.now(), SETTLE_MS)
  }

  ask() {
    if (this.asked || !this.shell || !this.near || document.hidden) return
    this.asked = requestAnimationFrame((now) => {
      this.asked = 0
      this.turn(now)
    })
  }

  // What a turn does.

  /** @param {number} now @param {number} [budget] how long the lab may work, milliseconds */
  turn(now, budget) {
    const { display, progress, run } = this
    if (!display || !progress || !run) return
    const stay = keepFocused(this.host)
    const began = performance.now()
    const elapsed = Number.isNaN(this.turned) ? Infinity : Math.max(0, now - this.turned)
    this.turned = now
    const outcome = run.turn(now, elapsed, this.calm.matches, budget)
    if (outcome.moved !== 'nothing') this.take(outcome.moved, now)
    if (outcome.refused !== null) this.voice.tell(outcome.refused, outcome.refused === MANGLED)
    if (outcome.ended)
      this.voice.tell(`The run ends here, at step ${run.last.toLocaleString('en')}. Reset starts it again.`)
    display.wanted = run.wanted
    display.aside = this.beside?.value ?? null
    if (progress.show(run.progress ?? this.beside?.progress ?? null, now))
      this.voice.status.textContent = progress.words.textContent
    const moving = display.paint(now, this.glide(elapsed))
    // Both, whatever the first answers.
    const [unlabelled, undrawn] = [display.label(now, began, run), display.drawOthers(began)]
    stay()
    this.behind = unlabelled || undrawn
    if (moving || this.behind || run.busy || run.playing) this.ask()
    else this.turned = NaN
  }

  /** @param {'steps' | 'replay' | 'reset'} moved @param {number} now */
  take(moved, now) {
    const { display, run, spec } = this
    if (!display || !run) return
    if (moved === 'reset') display.memory = {}
    const stepped = moved === 'steps'
    const slow = !run.playing || run.rate * run.pace <= 1000 / STEP_MS
    const inBeats = stepped && slow && spec.beats && !this.calm.matches
    display.take(run.frame, stepped ? display.frame : null, inBeats ? now : -Infinity, run.far)
    this.beside?.follow(run.frame)
    this.voice.soon()
    this.host.dispatchEvent(new Event('frame'))
  }

  /**
   * How long a camera has had to move: before the first picture any time, so that it is in place at once.
   * @param {number} elapsed
   */
  glide(elapsed) {
    if (this.calm.matches) return Infinity
    if (Number.isFinite(elapsed)) return elapsed
    return this.display?.drawn.size ? 16 : Infinity
  }
}
