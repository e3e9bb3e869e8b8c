/**
 * Draws a picture again and again with the same elements.
 *
 * A drawing asks for each mark by a key. If the last round had this key, its element gets the new attributes. An
 * element that is not asked for again is removed, and the elements stand in the order of the calls. The same calls draw
 * a still in Node.
 */

import { SVG } from './dom.js'
import { writeSvg } from './words.js'

/** @typedef {Record<string, string | number | null | undefined>} Attributes */
/**
 * @typedef {{ element: Element, turn: number, last: Attributes, said: string, pen: Pen | null, stamp: string | null }}
 * Held
 */

export class Pen {
  /** @param {Element} root an `svg` or a `g` */
  constructor(root) {
    this.root = root
    this.turn = 0
    /** @type {Map<string, Held>} */
    this.kept = new Map()
    this.touched = 0
    /** @type {Element | null} */
    this.latest = null
    /**
     * The children in the order of the last round; empty once this round has asked for another order.
     * @type {Element[]}
     */
    this.order = []
    this.next = 0
  }

  /**
   * Whether the reader holds a handle of this picture. Its scale stays until the hand lets go: on a scale that follows
   * the handle, the pointer would mean more at every move, and the handle would run away.
   */
  get held() {
    return this.root.querySelector('.dragging') !== null
  }

  /**
   * Draws one round. What `paint` does not ask for is removed.
   * @param {(pen: Pen) => void} paint
   */
  draw(paint) {
    this.turn += 1
    this.touched = 0
    this.next = 0
    this.latest = null
    paint(this)
    if (this.touched === this.kept.size && this.next === this.order.length) return
    for (const [key, held] of this.kept) {
      if (held.turn === this.turn) continue
      held.element.remove()
      this.kept.delete(key)
    }
    this.order = [...this.root.children]
  }

  /**
   * @param {string} tag
   * @param {string} key unique among its siblings
   * @param {Attributes} [attributes] numbers are rounded to a tenth of a pixel; null takes an attribute away
   * @returns {Element}
   */
  mark(tag, key, attributes = {}) {
    return this.hold(tag, key, attributes).element
  }

  /**
   * @param {string} key
   * @param {Attributes} attributes
   * @param {import('./words.js').Words} words
   */
  text(key, attributes, words) {
    const held = this.hold('text', key, attributes)
    if (held.said !== words) {
      writeSvg(held.element, words)
      held.said = words
    }
    return held.element
  }

  /**
   * @param {string} key
   * @param {Attributes} attributes
   * @param {(pen: Pen) => void} paint
   * @param {string} [stamp] what the picture depends on: while this stays the same nothing is painted
   */
  group(key, attributes, paint, stamp) {
    return this.nest('g', key, attributes, paint, stamp)
  }

  /**
   * Draws inside a window in the same coordinates, whose edges cut the drawing off.
   * @param {string} key
   * @param {import('./plot.js').Box} box
   * @param {(pen: Pen) => void} paint
   */
  window(key, { left, top, right, bottom }, paint) {
    const [width, height] = [Math.max(0, right - left), Math.max(0, bottom - top)]
    return this.nest(
      'svg',
      key,
      { x: left, y: top, width, height, viewBox: [left, top, width, height].join(' '), class: 'window' },
      paint,
    )
  }

  /**
   * @param {string} tag
   * @param {string} key
   * @param {Attributes} attributes
   * @param {(pen: Pen) => void} paint
   * @param {string} [stamp]
   */
  nest(tag, key, attributes, paint, stamp) {
    const held = this.hold(tag, key, attributes)
    if (stamp !== undefined && held.stamp === stamp) return held.element
    held.stamp = stamp ?? null
    held.pen ??= new Pen(held.element)
    held.pen.draw(paint)
    return held.element
  }

  /**
   * @param {string} tag
   * @param {string} key
   * @param {Attributes} attributes
   * @returns {Held}
   */
  hold(tag, key, attributes) {
    let held = this.kept.get(key)
    if (!held) {
      const element = this.root.ownerDocument.createElementNS(SVG, tag)
      held = { element, turn: 0, last: {}, said: '', pen: null, stamp: null }
      this.kept.set(key, held)
    }
    this.place(held.element)
    if (held.turn !== this.turn) this.touched += 1
    held.turn = this.turn
    const { element, last } = held
    for (const name in attributes) {
      let value = attributes[name]
      if (last[name] === value) continue
      if (typeof value === 'number') value = Math.round(value * 10) / 10
      if (last[name] === value) continue
      if (value === null || value === undefined) element.removeAttribute(name)
      else element.setAttribute(name, String(value))
      last[name] = value
    }
    return held
  }

  /**
   * Puts an element behind the latest mark. An element that is in the picture already is not moved, because that would
   * cost it the focus; the elements before it go to the end instead.
   * @param {Element} element
   */
  place(element) {
    if (this.order[this.next] === element) {
      this.next += 1
      this.latest = element
      return
    }
    this.order = []
    this.next = -1
    const next = () => (this.latest ? this.latest.nextElementSibling : this.root.firstElementChild)
    if (element.parentNode !== this.root) this.root.insertBefore(element, next())
    else for (let before = next(); before && before !== element; before = next()) this.root.append(before)
    this.latest = element
  }
}
