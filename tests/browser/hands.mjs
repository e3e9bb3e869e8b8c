// The three hands of a reader: a mouse, keys and a finger. Each presses a button, ticks a box, chooses and drags.
import { quiet } from './harness.mjs'

/** The middle of what is dragged, once it is in the middle of the screen. */
async function middle(page, handle) {
  await handle.evaluate((element) =>
    scrollTo({ top: scrollY + element.getBoundingClientRect().top - innerHeight / 2, behavior: 'instant' }),
  )
  await quiet(page, 3)
  const { x, y, width, height } = await handle.locator('.handle-dot').boundingBox()
  return [x + width / 2, y + height / 2]
}

/** What a press of a key with Shift moves, pixels: about as far as a short drag. */
const KEYED = 16
const BITS = 4

/**
 * @typedef {object} Hand
 * @property {(button: import('playwright-core').Locator) => Promise<unknown>} press
 * @property {(page: any, handle: any, dx: number, dy: number) => Promise<unknown>} drag so many pixels, about
 */

/** @type {Record<'mouse' | 'keys' | 'touch', Hand>} */
export const HANDS = {
  mouse: {
    press: (button) => button.click(),
    async drag(page, handle, dx, dy) {
      const [x, y] = await middle(page, handle)
      await page.mouse.move(x, y)
      await page.mouse.down()
      await page.mouse.move(x + dx, y + dy, { steps: BITS })
      await page.mouse.up()
    },
  },
  keys: {
    press: async (button) => {
      await button.focus()
      await button.press('Space')
    },
    async drag(_page, handle, dx, dy) {
      await handle.focus()
      const [right, up] = [dx, -dy].map((way) => Math.round(way / KEYED))
      for (let i = 0; i < Math.abs(right); i++) await handle.press(`Shift+Arrow${right > 0 ? 'Right' : 'Left'}`)
      if (up !== 0) await handle.press(`Arrow${up > 0 ? 'Up' : 'Down'}`)
    },
  },
  touch: {
    press: (button) => button.tap(),
    async drag(page, handle, dx, dy) {
      const [x, y] = await middle(page, handle)
      const wire = await page.context().newCDPSession(page)
      const touch = (type, part) =>
        wire.send('Input.dispatchTouchEvent', {
          type,
          touchPoints: type === 'touchEnd' ? [] : [{ x: x + dx * part, y: y + dy * part }],
        })
      await touch('touchStart', 0)
      for (let i = 1; i <= BITS; i++) await touch('touchMove', i / BITS)
      await touch('touchEnd')
      await wire.detach()
    },
  },
}
