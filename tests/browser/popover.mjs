// The box that says what a word or a number means, and how a test comes to it.

export const popover = (page) => page.locator('#popover')
/** Waits until the page listens. */
export const listening = (page) => popover(page).waitFor({ state: 'attached' })
export const rest = (page) => page.mouse.move(2, 2)
/**
 * Waits until an element has kept its place for a second: a part of the text that comes near is laid out, and a figure
 * in it comes to life.
 */
export const resting = (it) =>
  it.evaluate(async (element) => {
    let [y, since] = [NaN, 0]
    while (performance.now() - since < 1000) {
      const { top } = element.getBoundingClientRect()
      if (top !== y) [y, since] = [top, performance.now()]
      await new Promise(requestAnimationFrame)
    }
  })
