/** The page of a log on paper: what it has found, without what a reader sets. */

/** How long printing waits for the figure, milliseconds. */
const DRAWN_MS = 2000

/** @param {HTMLElement} figure */
export async function printReport(figure) {
  const { dataset } = document.documentElement
  if ('report' in dataset) return // It is being drawn for paper already.
  dataset.report = ''
  addEventListener(
    'afterprint',
    () => {
      delete dataset.report
    },
    { once: true },
  )
  await drawn(figure)
  print()
}

/**
 * Waits until every panel is drawn for the report's width, so that letters have one size in all of them.
 * @param {HTMLElement} figure
 */
async function drawn(figure) {
  const panels = /** @type {SVGSVGElement[]} */ ([...figure.querySelectorAll('.live > .panel')])
  const fits = () =>
    panels.every(({ clientWidth, viewBox }) => clientWidth === 0 || Math.abs(clientWidth - viewBox.baseVal.width) < 2)
  for (const until = performance.now() + DRAWN_MS; !fits() && performance.now() < until; )
    await new Promise(requestAnimationFrame)
}
