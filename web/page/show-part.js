/** Brings into sight what words in the text ask of a figure: a control, a plot, the numbers. */

/**
 * @param {Element} widget
 * @param {string} name of a control or of a panel, or `readouts`
 */
export function showPart(widget, name) {
  const part = [
    ...widget.querySelectorAll(`:is(.live, .still) :is(.panel-${name}, .${name}, [data-control="${name}"])`),
  ].find((found) => found.closest('.live, .still')?.checkVisibility())
  // On a phone it may wait with all that waits.
  if (part && !part.checkVisibility()) press(part.closest('.live')?.querySelector('.further, .more > summary'))
  part?.scrollIntoView({ block: 'nearest', behavior: 'instant' })
}

/** @param {Element | null | undefined} element */
function press(element) {
  if (element instanceof HTMLElement) element.click()
}
