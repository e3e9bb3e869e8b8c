/** Brings into sight what words in the text ask of a figure: a control, a plot, the numbers; and what moves it. */

/** The bar of the page has this much of the window's upper edge, pixels. */
const BAR = 48

/**
 * @param {Element} widget
 * @param {string} name of a control or of a panel, or `readouts`
 */
export function showPart(widget, name) {
  const part = [
    ...widget.querySelectorAll(`:is(.live, .still) :is(.panel-${name}, .${name}, [data-control="${name}"])`),
  ].find((found) => found.closest('.live, .still')?.checkVisibility())
  const figure = part?.closest('.live, .still')
  if (!part || !figure) return
  // On a phone it may wait with all that waits.
  if (!part.checkVisibility()) press(figure.querySelector('.further, .more > summary'))
  const { roof, floor, picture } = roomOf(figure)
  const hand = figure.querySelector('.params input[type=range]')
  const knob = hand?.closest('.control')
  // As much as there is room for: the part, what moves it, and the picture.
  const groups = [[part, knob, picture], [part, knob], [part, hand], [part]].map((group) =>
    reach(group.flatMap((it) => (it?.checkVisibility() ? it : []))),
  )
  const { top, bottom } = groups.find((it) => it.bottom - it.top <= floor - roof) ?? groups[3]
  const by = top < roof ? top - roof : Math.max(0, Math.min(bottom - floor, top - roof))
  if (by !== 0) scrollBy({ top: by, behavior: 'instant' })
}

/**
 * Where a part can be seen: below the panel that stays in sight on a phone, which is its picture, and above the
 * sentence that does.
 * @param {Element} figure
 */
function roomOf(figure) {
  const [picture, said] = ['.panel', '.verdict'].map((it) => figure.querySelector(`:scope > ${it}`))
  const pin = figure.querySelector(':scope > [data-pin]')
  const above = pin && sticks(pin) && pin.clientWidth > figure.clientWidth / 2 ? pin.clientHeight : 0
  return {
    roof: BAR + above,
    floor: innerHeight - (said && sticks(said) ? said.clientHeight : 0),
    picture: above ? null : picture,
  }
}

/** @param {Element} element */
const sticks = (element) => getComputedStyle(element).position === 'sticky'

/** @param {Element[]} elements */
function reach(elements) {
  const boxes = elements.map((it) => it.getBoundingClientRect())
  return { top: Math.min(...boxes.map(({ top }) => top)), bottom: Math.max(...boxes.map(({ bottom }) => bottom)) }
}

/** @param {Element | null | undefined} element */
function press(element) {
  if (element instanceof HTMLElement) element.click()
}
