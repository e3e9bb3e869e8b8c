// How a page comes to rest: nothing loads, moves, fades or computes any more.
import { HANGS_MS } from './places.mjs'

/** Waits until the whole book is kept for reading offline. */
export const keptOffline = (page) =>
  page.evaluate(async () => {
    const { active } = /** @type {any} */ (await navigator.serviceWorker.ready)
    while (active.state !== 'activated') await new Promise((resolve) => setTimeout(resolve, 50))
  })

/** Shows the page in another theme, until nothing fades any more; what is not laid out does not fade. */
export async function turn(page, theme) {
  await page.emulateMedia({ colorScheme: theme })
  await page.evaluate(async () => {
    const fades = ({ playState, effect }) =>
      playState === 'running' &&
      Number.isFinite(effect?.getComputedTiming().endTime) &&
      effect.target?.checkVisibility({ contentVisibilityAuto: true })
    do for (let i = 0; i < 2; i++) await new Promise((resolve) => requestAnimationFrame(resolve))
    while (document.getAnimations().some(fades))
  })
}

/**
 * Waits until a page has come to rest: for so many frames in a row its fonts and images are there, no animation runs,
 * no figure computes, the main thread has been idle, and neither its height nor its place has changed. `held`: the test
 * holds back what figures load, so that a figure that loads is at rest.
 */
export async function quiet(page, frames = 20, held = false) {
  await page.evaluate(
    async ([wanted, holds, hangs]) => {
      const look = () => {
        const { scrollHeight, clientWidth } = document.documentElement
        const onScreen = ({ top, bottom }) => bottom > 0 && top < innerHeight
        // Off the screen a figure sleeps, whatever it has to do, an image may stay away, and what is not laid out does
        // not move.
        const figures = [...document.querySelectorAll('.widget')].map((it) => {
          const asleep = !onScreen(it.getBoundingClientRect())
          return [it.dataset.state, asleep || (it.settled ?? true), it.clientHeight]
        })
        const moves = document
          .getAnimations()
          .some(
            (/** @type {any} */ { playState, effect }) =>
              playState === 'running' &&
              Number.isFinite(effect?.getComputedTiming().endTime) &&
              effect.target?.checkVisibility({ contentVisibilityAuto: true }),
          )
        const missing = [...document.images].some(
          (it) => !it.complete && it.checkVisibility() && onScreen(it.getBoundingClientRect()),
        )
        const works = figures.some(([state, settled]) => (state === 'loading' ? !holds : state === 'live' && !settled))
        return {
          state:
            moves || missing || works ? null : JSON.stringify([scrollX, scrollY, scrollHeight, clientWidth, figures]),
          ends: moves || works,
        }
      }
      await document.fonts.ready
      let before = null
      const began = performance.now()
      // What never rests (a figure that plays, a picture that does not come) is looked at as it is, after ten times as
      // many frames; what computes or fades is waited for.
      for (let held = 0, seen = 0; held < wanted && seen < Math.max(120, 10 * wanted); ) {
        await new Promise((resolve) => requestIdleCallback(resolve, { timeout: 500 }))
        await new Promise((resolve) => requestAnimationFrame(resolve))
        const { state: now, ends } = look()
        held = now !== null && now === before ? held + 1 : 0
        before = now
        if (!ends) seen++
        if (performance.now() - began > hangs) throw new Error('The page never comes to rest.')
      }
    },
    [frames, held, HANGS_MS],
  )
}

/**
 * What keeps a page that stands still: its scripts, its frames, or neither.
 * @param {import('playwright-core').Page} page
 */
export async function stillness(page) {
  const within = (wait) => Promise.race([wait.catch(String), new Promise((r) => setTimeout(r, 10_000, 'none in 10 s'))])
  const place = await within(page.evaluate(() => [document.visibilityState, scrollY, document.body.scrollHeight] + ''))
  const frame = await within(page.evaluate(() => new Promise((r) => requestAnimationFrame(r)).then(() => 'one')))
  return `the page's answer: ${place}; a frame: ${frame}`
}
