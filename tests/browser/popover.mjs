// The box that says what a word or a number means, and how a test comes to it.

export const popover = (page) => page.locator('#popover')
/** Waits until the page listens. */
export const listening = (page) => popover(page).waitFor({ state: 'attached' })
export const rest = (page) => page.mouse.move(2, 2)
