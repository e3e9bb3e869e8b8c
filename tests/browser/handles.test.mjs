// Every handle and every slider of every figure: large enough for a finger, reached by Tab, named, with its value in
// words, moved by the keys; and under a finger only the handle itself holds the page.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { figure, openFigure, PHONE, quiet, settled, tagOf } from './harness.mjs'
import { WIDGETS } from '../../web/widgets/index.js'

/** Figures of which a panel has handles when they open, known before the first test: nothing is awaited after that. */
const DRAGGED = []
for (const [tag, load] of Object.entries(WIDGETS))
  if ((await load()).panels.some(({ handles }) => handles)) DRAGGED.push(tag)

/** Not the sliders that a figure hides where there is nothing to set. */
const KNOBS = '.live :is(svg [role=slider], input[type=range]:enabled):not([hidden] *)'

for (const tag of Object.keys(WIDGETS)) {
  test(`every handle and slider of the ${tag} is large, named, reached by Tab and moved by keys`, async (t) => {
    const { page, it } = await openFigure(t, tag, { viewport: PHONE })
    // What waits in a fold is reached once that is open.
    await it.evaluate((host) => host.querySelectorAll('.live .controls details').forEach((fold) => (fold.open = true)))
    const count = await it.locator(KNOBS).count()
    if (count === 0) {
      // A figure to write in has a box.
      const box = it.locator('.live textarea:not([readonly])')
      assert.ok((await box.getAttribute('aria-label')).length > 2, 'a name')
      return
    }
    // By Tab, from the first thing in the figure to what comes after it.
    await it.evaluate((host, selector) => {
      for (const [i, knob] of [...host.querySelectorAll(selector)].entries()) knob.dataset.knob = i
      host.querySelector('.live :is(button, input, select, [tabindex])').focus()
    }, KNOBS)
    const reached = new Set()
    for (let i = 0; i < 60; i++) {
      const now = await page.evaluate(
        (name) => ({
          inside: Boolean(document.activeElement?.closest(`${name} .live`)),
          knob: document.activeElement?.dataset.knob,
        }),
        tagOf(tag),
      )
      if (!now.inside) break
      if (now.knob !== undefined) reached.add(now.knob)
      await page.keyboard.press('Tab')
    }
    assert.equal(reached.size, count, `Tab reaches ${[...reached]}`)

    // By their numbers: a handle goes where another knob leaves nothing for it to hold.
    for (let i = 0; i < count; i++) {
      const knob = it.locator(`[data-knob="${i}"]`)
      const { name, words, width, height, handle } = await knob.evaluate((element) => {
        const { width, height } = (element.querySelector('.handle-reach') ?? element).getBoundingClientRect()
        const name =
          element.getAttribute('aria-label') ?? element.labels?.[0]?.querySelector('.control-name')?.textContent ?? ''
        return {
          name,
          words: element.getAttribute('aria-valuetext') ?? '',
          width,
          height,
          handle: element instanceof SVGElement,
        }
      })
      assert.ok(name.trim().length > 2, 'a name')
      assert.match(words, /\d|none/, `${name} says its value`)
      assert.ok(Math.round(height) >= 44 && Math.round(width) >= 44, `${name} is ${width} × ${height} px`)
      // What it says and where it is: of a handle with two values, one may stay.
      const state = () =>
        knob.evaluate((element) =>
          JSON.stringify([element.getAttribute('aria-valuetext'), element.value ?? element.getAttribute('transform')]),
        )
      const pressed = async (keys) => {
        const before = await state()
        for (const key of keys) {
          await knob.press(key)
          await quiet(page, 3)
          if ((await state()) !== before) return
        }
        assert.fail(`${name} stays at ${before} under ${keys}`)
      }
      // At one end of its range the first of two does nothing.
      await pressed(['ArrowLeft', 'ArrowRight'])
      await pressed(['Shift+ArrowRight', 'Shift+ArrowLeft'])
      await pressed(handle ? ['PageUp', 'PageDown'] : ['PageDown', 'PageUp'])
      await pressed(['Home', 'End'])
      await pressed(['End', 'Home'])
    }
  })
}

/** The middle of each handle's ring, by its name. */
const ringsOf = async (it) =>
  new Map(
    await it.evaluate((host) =>
      [...host.querySelectorAll('.live svg [role=slider]')].map((handle) => {
        const { left, top, width, height } = handle.querySelector('.handle-ring').getBoundingClientRect()
        return [handle.getAttribute('aria-label'), [left + width / 2, top + height / 2]]
      }),
    ),
  )
const apart = ([a, b], [c, d]) => Math.hypot(a - c, b - d)

for (const tag of DRAGGED) {
  test(`a finger on a handle of the ${tag} moves it and not the page; beside it, the page`, async (t) => {
    const { page, it } = await openFigure(t, tag, { viewport: PHONE, touch: true })
    // A small figure is on a phone's screen whole, and its page has nothing to scroll.
    await page.evaluate(() => (document.body.style.paddingBlock = '100vh'))
    const wire = await page.context().newCDPSession(page)
    const swipe = async (x, y, far, sideways = 0) => {
      const touch = (type, part) =>
        wire.send('Input.dispatchTouchEvent', {
          type,
          touchPoints: type === 'touchEnd' ? [] : [{ x: x + sideways * part, y: y + far * part }],
        })
      await touch('touchStart', 0)
      for (let i = 1; i <= 8; i++) await touch('touchMove', i / 8)
      await touch('touchEnd')
      await quiet(page)
    }
    await it.evaluate((host) => host.querySelectorAll('.live details').forEach((fold) => (fold.open = true)))
    const handles = await it.locator('.live svg [role=slider]:visible').all()
    assert.ok(handles.length > 0)
    const place = async (handle) => {
      await handle.evaluate((element) =>
        scrollTo({ top: scrollY + element.getBoundingClientRect().top - innerHeight / 2, behavior: 'instant' }),
      )
      await quiet(page)
      const { x, y, width, height } = await handle.locator('.handle-dot').boundingBox()
      return [x + width / 2, y + height / 2, await page.evaluate(() => scrollY)]
    }
    for (const handle of handles) {
      const name = await handle.getAttribute('aria-label')
      const [x, y, top] = await place(handle)
      // Handles that lie on one another: the upper has the finger, and holds the page as well.
      // What is asked for, and what the handle says: one of a step changes no parameter.
      const value = async () =>
        JSON.stringify(await it.evaluate((host) => host.frame.params)) + (await handle.getAttribute('aria-valuetext'))
      const before = await value()
      const rings = await ringsOf(it)
      await swipe(x, y, -70)
      // Of handles whose reaches overlap, the one under the finger has it.
      const taken = await page.evaluate(() => document.activeElement.getAttribute('aria-label'))
      assert.ok(apart(rings.get(name), rings.get(taken)) < 2, `${name} is pressed, and ${taken} moves`)
      // At its upper end it goes down.
      if ((await value()) === before) await swipe(x, y, 70)
      // Along an axis only the way sideways counts.
      if ((await value()) === before) await swipe(x, y, 0, x > PHONE.width / 2 ? -70 : 70)
      assert.equal(await page.evaluate(() => scrollY), top, `${name} holds the page`)
      assert.notEqual(await value(), before, `${name} moves`)
    }
    // Sixty pixels from a handle, where there is no other; the name written beside one is part of it.
    let beside = 0
    for (const handle of handles) {
      const [x, y, top] = await place(handle)
      const free = await page.evaluate(
        ([px, py, name]) =>
          [
            [60, 0],
            [-60, 0],
            [0, 60],
            [0, -60],
          ]
            .map(([dx, dy]) => [px + dx, py + dy])
            .find(([qx, qy]) => {
              const there = document.elementFromPoint(qx, qy)
              const held = [...document.querySelectorAll(`${name} .live [role=slider]`)].some((handle) => {
                const { left, right, top, bottom } = handle.getBoundingClientRect()
                return qx > left - 4 && qx < right + 4 && qy > top - 4 && qy < bottom + 4
              })
              return there?.closest(`${name} .live svg`) && !held
            }),
        [x, y, tagOf(tag)],
      )
      if (!free) continue
      beside += 1
      await swipe(free[0], free[1], -90)
      const gone = (await page.evaluate(() => scrollY)) - top
      assert.ok(
        gone > 30,
        `beside ${await handle.getAttribute('aria-label')}, at ${free}, it being at ${[x, y]}, ` +
          `the page scrolls by ${gone}`,
      )
    }
    assert.ok(beside > 0, 'there is a place beside one')
  })
}

test('on a slow machine plots, numbers and labels come after the hand, and come', async (t) => {
  const { page, it } = await openFigure(t, 'observability-probe')
  const wire = await page.context().newCDPSession(page)
  await wire.send('Emulation.setCPUThrottlingRate', { rate: 20 })
  const box = await it.locator('.live .handle-reach').first().boundingBox()
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2]
  await page.mouse.move(x, y)
  await page.mouse.down()
  for (let i = 1; i <= 12; i++) await page.mouse.move(x - 4 * i, y + 3 * i)
  await page.mouse.up()
  const shown = () =>
    it.evaluate((host) =>
      [...host.querySelectorAll('.live .readouts, .live .panel')]
        .filter((part) => part.checkVisibility())
        .map(
          (part) =>
            `${part.getAttribute('aria-label')} ${part.textContent} ` +
            `${part.querySelector('[class*=curve]')?.getAttribute('d')}`,
        ),
    )
  await settled(it)
  const late = await shown()
  // The same state by another way: opened from a link, on a machine that is not slow.
  await wire.send('Emulation.setCPUThrottlingRate', { rate: 1 })
  await it.getByRole('button', { name: 'Copy link' }).click()
  const link = await page.evaluate(() => navigator.clipboard.readText())
  await page.goto(link)
  await figure(page, 'observability-probe')
  await settled(it)
  const fresh = await shown()
  assert.deepEqual(late, fresh)
  assert.ok(late.length > 3 && late.every((words) => words.length > 20))
})

test('a slider is as long at one value as at another, so that its thumb stays under the finger', async (t) => {
  const { it } = await openFigure(t, 'tune')
  const lengths = await it.evaluate(async (host) => {
    const found = []
    for (const slider of host.querySelectorAll('.live input[type=range]')) {
      const lengths = new Set()
      for (let i = 0; i <= 20; i++) {
        slider.value = String(Number(slider.min) + ((Number(slider.max) - Number(slider.min)) * i) / 20)
        slider.dispatchEvent(new Event('input'))
        for (let frames = 0; frames < 3; frames++) await new Promise(requestAnimationFrame)
        lengths.add(slider.getBoundingClientRect().width)
      }
      found.push([...lengths])
    }
    return found
  })
  assert.equal(lengths.length, 3)
  for (const one of lengths) assert.equal(one.length, 1, `${one} px`)
})

test('a button stays under a finger that is still on it, or the press would end on something else', async (t) => {
  const { it } = await openFigure(t, 'own-system', { viewport: PHONE, touch: true })
  const button = it.locator('.live .tries').getByRole('button', { name: 'Read the velocity alone' })
  const moved = await button.evaluate(async (pressed) => {
    // As after another press: the browser does not hold the page by itself.
    document.body.style.overflowAnchor = 'none'
    scrollBy({ top: pressed.getBoundingClientRect().top - innerHeight / 2, behavior: 'instant' })
    for (let frames = 0; frames < 3; frames++) await new Promise(requestAnimationFrame)
    const { top } = pressed.getBoundingClientRect()
    const tell = (what) => pressed.dispatchEvent(new PointerEvent(what, { bubbles: true }))
    tell('pointerdown')
    const above = document.createElement('div')
    above.style.height = '70px'
    pressed.closest('.widget').before(above)
    for (let frames = 0; frames < 3; frames++) await new Promise(requestAnimationFrame)
    const by = pressed.getBoundingClientRect().top - top
    tell('pointerup')
    return by
  })
  assert.ok(Math.abs(moved) < 1, `${moved} px`)
})
