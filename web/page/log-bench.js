/**
 * The workbench: what stands between and beside the panels of the page's figure. The strip has what a reader sets,
 * below the likelihood that tells what comes of it; the bar of what is shown and the table of sensors stand with the
 * panels that they speak of.
 */

import { button } from '../draw/dom.js'
import { LikelihoodLine } from './log-likelihood.js'
import { LikelihoodMap } from './log-map.js'
import { MendBar } from './log-mend.js'
import { SourceTable } from './log-sources.js'
import { handOnTime } from './log-time.js'
import { ViewBar } from './log-view.js'

export class Bench {
  /**
   * @param {HTMLElement & { figure: any }} host of the figure
   * @param {HTMLElement} strip what a reader sets
   * @param {import('./log-mend.js').Orders & { follow: () => void }} orders
   */
  constructor(host, strip, { follow, ...orders }) {
    const { change } = orders
    this.host = host
    this.strip = strip
    this.look = (/** @type {any} */ looks) => {
      host.figure.run?.look(looks)
      host.figure.ask()
      follow()
    }
    this.likelihood = new LikelihoodLine({ change, look: this.look })
    this.mend = new MendBar(orders)
    this.view = new ViewBar(this.look, {
      may: orders.may,
      keep: (window, log) => this.mend.keepPart(window, log),
    })
    this.sources = new SourceTable(this.look)
    this.map = new LikelihoodMap(() => host.figure.run, change)
    /** @type {HTMLElement | null} */
    this.live = null
    this.more = button(document, document.createElement('div'), 'More panels', () => this.open(), 'button log-panels')
  }

  /** Takes its place in the figure, which builds its panels anew after a failure. */
  enter() {
    const live = /** @type {HTMLElement | null} */ (this.host.querySelector(':scope > .live'))
    if (!live || live === this.live) return
    this.live = live
    // Here the map stays in sight on a phone.
    live.querySelector('[data-pin]')?.removeAttribute('data-pin')
    live.querySelector('.panel-map')?.setAttribute('data-pin', '')
    live.querySelector('.controls > .params')?.remove()
    live.querySelector('.tries')?.remove()
    live.querySelector('.run > .control')?.remove()
    const controls = live.querySelector('.controls')
    const strip = document.createElement('div')
    strip.className = 'log-strip'
    if (controls) strip.append(this.likelihood.box, ...controls.children, this.strip)
    controls?.append(strip)
    markMore(strip)
    // By keys what the verdict proposes comes next to it, before all that can be set.
    live.querySelector('.verdict')?.after(this.mend.box, this.more)
    live.append(this.view.box, this.sources.box, this.map.box)
    handOnTime(live, () => this.host.figure.run.frame, this.look)
    this.reveal(live.hasAttribute('data-panels'))
  }

  /** Shows the panels behind the verdict, or hides them. */
  open() {
    if (this.live) this.reveal(this.live.toggleAttribute('data-panels'))
  }

  /** @param {boolean} open */
  reveal(open) {
    this.more.setAttribute('aria-expanded', String(open))
    this.host.figure?.measure()
  }

  /** Another log. @param {import('estimate-wasm').LogContents} contents */
  begin(contents) {
    this.likelihood.begin()
    this.mend.begin()
    this.map.begin(contents)
  }

  /** @param {import('../widgets/robot-log/looks.js').Frame} frame */
  show(frame) {
    this.enter()
    this.likelihood.show(frame)
    this.mend.show(frame, this.host.figure.run.wanted.params)
    this.view.show(frame)
    this.sources.show(frame)
    this.map.show(frame)
  }
}

/** Marks a box that scrolls for as long as it goes on below its lower edge. @param {HTMLElement} box */
function markMore(box) {
  const mark = () => box.toggleAttribute('data-more', box.scrollTop < box.scrollHeight - box.clientHeight - 1)
  const eye = new ResizeObserver(mark)
  for (const one of [box, ...box.children]) eye.observe(one)
  box.addEventListener('scroll', mark, { passive: true })
}
