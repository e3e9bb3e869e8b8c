/**
 * The custom element of a figure, which a page names and whose life begins when the element stands in a document.
 */

import { hideFailure } from './failure.js'
import { Figure } from './figure.js'

/** @typedef {import('./spec.js').FigureSpec} FigureSpec */

/**
 * Defines the custom element of a specification.
 * @param {FigureSpec} spec
 */
export function defineFigure(spec) {
  if (customElements.get(spec.tag)) return
  customElements.define(
    spec.tag,
    class extends HTMLElement {
      /** @type {Figure | null} */
      figure = null

      connectedCallback() {
        // The notice may be about a script that a figure of the same kind has fetched meanwhile.
        if (!this.figure) hideFailure(this)
        this.figure ??= new Figure(this, spec)
        this.figure.watch()
      }

      disconnectedCallback() {
        this.figure?.rest()
      }

      /** The frame on the screen. Tests read it. */
      get frame() {
        return this.figure?.run?.frame ?? null
      }

      /** Whether nothing is left to compute and every panel shows the frame. While a run plays the answer is true. */
      get settled() {
        const { run, behind, beside } = this.figure ?? {}
        return Boolean(run?.playing || (run && !run.busy && !behind && !beside?.progress))
      }

      /** Parameters and step, as a link carries them. */
      get state() {
        return this.figure?.run?.state() ?? null
      }
    },
  )
}
