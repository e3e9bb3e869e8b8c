// The Observer Bench: turn the gain until an eigenvalue leaves the disc, then let the filter choose, by mouse, by keys
// and by touch.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { dragSlider, frameOf, openFigure, PHONE, quiet, stateOf, until } from './harness.mjs'

const knob = (bench) => bench.getByRole('slider', { name: /gain/i })
const moving = (frame) =>
  Math.max(...frame.eigenvalues.filter((_, i) => i !== frame.pinned).map(({ re, im }) => Math.hypot(re, im)))
const close = (a, b, tolerance) => Math.abs(a - b) <= tolerance

/** The eigenvalues drawn in the disc's panel: each one's class, and its distance from the disc's centre in radii. */
const drawn = (bench) =>
  bench.locator('.live .panel-disc').evaluate((svg) => {
    const middle = (mark) => {
      const { x, y, width, height } = mark.getBBox()
      return { x: x + width / 2, y: y + height / 2, radius: width / 2 }
    }
    const disc = middle(svg.querySelector('circle.disc'))
    return [...svg.querySelectorAll('.mark.eigenvalue')].map((mark) => {
      const { x, y } = middle(mark)
      return { outside: mark.classList.contains('outside'), modulus: Math.hypot(x - disc.x, y - disc.y) / disc.radius }
    })
  })
/** The text of the readout with this label. */
const readout = (bench, label) =>
  bench
    .locator('.live .readout')
    .filter({ has: bench.page().locator('dt', { hasText: label }) })
    .locator('dd')
    .textContent()

test('dragging the knob drives the eigenvalue out of the disc', async (t) => {
  const { page, it: bench } = await openFigure(t, 'observer-bench')
  const before = await frameOf(bench)
  assert.ok(before.stable && moving(before) < 1)
  const inside = await drawn(bench)
  assert.equal(inside.length, 2)
  // The pinned one is drawn on the rim.
  assert.ok(
    inside.every(({ outside, modulus }) => !outside && modulus < 1 + 1e-3),
    JSON.stringify(inside),
  )
  await dragSlider(page, knob(bench), 5.9)
  const frame = await until(bench, ({ params }) => params.gain > before.stableUpTo, 'the knob is past its limit')
  assert.ok(!frame.stable && moving(frame) > 1, `modulus ${moving(frame)}`)
  await bench
    .getByText(/unstable/i)
    .first()
    .waitFor()
  const left = (await drawn(bench)).filter(({ outside }) => outside)
  assert.equal(left.length, 1, 'one eigenvalue is drawn as outside')
  // Places in the picture are rounded to parts of a pixel.
  assert.ok(
    left[0].modulus > 1 && close(left[0].modulus, moving(frame), 0.01),
    `drawn at ${left[0].modulus}, computed as ${moving(frame)}`,
  )
})

test('the filter, when it may choose, ends where the knob says 1', async (t) => {
  const { it: bench } = await openFigure(t, 'observer-bench')
  await bench.getByRole('button', { name: 'Reset' }).click()
  await until(bench, ({ step }) => step === 0, 'reset goes to step 0')
  await bench.getByRole('checkbox', { name: /let the filter choose/i }).check()
  const first = await until(bench, ({ params }) => params.mode === 'filter', 'the filter has the knob')
  assert.ok(await knob(bench).isDisabled())
  await bench.getByRole('button', { name: 'Play' }).click()
  await bench.getByRole('combobox', { name: 'Speed' }).selectOption({ label: '10×' })
  const frame = await until(bench, ({ step }) => step >= 30, 'it plays to step 30')
  await bench.getByRole('button', { name: 'Pause' }).click()
  const shown = await readout(bench, 'Equivalent knob')
  assert.ok(!close(first.series.knob[0], 1, 0.1), `it starts at ${first.series.knob[0]}`)
  assert.ok(close(frame.equivalentKnob, 1, 1e-3), `it ends at ${frame.equivalentKnob}`)
  assert.ok(/^[01]\.\d{3}$/.test(shown) && close(Number(shown), 1, 2e-3), `the readout says ${shown}`)
})

test('the keys turn the knob, finely, coarsely, and to its ends', async (t) => {
  const { page, it: bench } = await openFigure(t, 'observer-bench')
  const slider = knob(bench)
  await slider.focus()
  const gain = async () => (await frameOf(bench)).params.gain
  const pressed = async (key, expected) => {
    await page.keyboard.press(key)
    await until(bench, ({ params }) => close(params.gain, expected, 1e-9), `${key} gives ${expected}`)
  }
  const start = await gain()
  await pressed('ArrowRight', start + 0.01)
  await pressed('Shift+ArrowRight', start + 0.11)
  await pressed('Shift+ArrowLeft', start + 0.01)
  await pressed('End', 6)
  await pressed('Home', 0)
  await page.keyboard.press('PageUp')
  await until(bench, ({ params }) => params.gain > 0.05, 'Page up is a larger step')
  assert.match(await slider.getAttribute('aria-valuetext'), /\d/)
})

test('a finger turns the knob', async (t) => {
  const { page, it: bench } = await openFigure(t, 'observer-bench', { viewport: PHONE, touch: true })
  const slider = knob(bench)
  await slider.scrollIntoViewIfNeeded()
  const { x, y, width, height } = await slider.boundingBox()
  const wire = await page.context().newCDPSession(page)
  const touch = (type, at) =>
    wire.send('Input.dispatchTouchEvent', {
      type,
      touchPoints: type === 'touchEnd' ? [] : [{ x: at, y: y + height / 2 }],
    })
  const from = x + 8 + ((width - 16) * 1) / 6
  await touch('touchStart', from)
  for (let i = 1; i <= 8; i++) await touch('touchMove', from + ((x + width - 12 - from) * i) / 8)
  await touch('touchEnd')
  const {
    params: { gain },
  } = await until(bench, ({ params }) => params.gain > 5, 'the finger has turned the knob')

  // Upwards it scrolls the page, and the knob stays where it was.
  assert.ok(height >= 44, `${height} px to the touch`)
  const box = await slider.boundingBox()
  const top = await page.evaluate(() => scrollY)
  const swipe = (type, up) =>
    wire.send('Input.dispatchTouchEvent', {
      type,
      touchPoints: type === 'touchEnd' ? [] : [{ x: box.x + box.width / 2, y: box.y + box.height / 2 - up }],
    })
  await swipe('touchStart', 0)
  for (let i = 1; i <= 8; i++) await swipe('touchMove', 15 * i)
  await swipe('touchEnd')
  await page.waitForFunction((y) => scrollY > y + 50, top)
  await quiet(page)
  assert.equal((await frameOf(bench)).params.gain, gain)
})

test('a change is the whole run as it would have been, and a step is announced', async (t) => {
  const { page, it: bench } = await openFigure(t, 'observer-bench')
  const { step } = await frameOf(bench)
  await bench.getByRole('combobox', { name: 'Sensor' }).selectOption('position')
  const frame = await until(bench, ({ params }) => params.sensor === 'position', 'the sensor is changed')
  assert.equal(frame.step, step)
  assert.equal(frame.pinned, null)
  await bench.getByRole('button', { name: 'Step' }).click()
  await until(bench, (now) => now.step === step + 1, 'one step')
  await page.waitForFunction(
    (n) => document.querySelector('observer-bench [role=status]')?.textContent.includes(`Step ${n}`),
    step + 1,
  )
  assert.deepEqual((await stateOf(bench)).params, frame.params)
})

test('with reduced motion a step shows at once; without, in two beats', async (t) => {
  for (const motion of /** @type {const} */ (['reduce', 'no-preference'])) {
    const { page, it: bench } = await openFigure(t, 'observer-bench', { motion })
    await quiet(page)
    // Every outline of the ellipse that the step shows, frame by frame.
    const seen = await bench.evaluate(
      async (it, beats) => {
        const ellipses = new Set()
        const look = () =>
          ellipses.add(
            [...it.querySelectorAll('.live .panel-phase .mark.outline')]
              .map((mark) => mark.getAttribute('d') ?? mark.outerHTML)
              .join(),
          )
        look()
        ;[...it.querySelectorAll('.live button')].find((button) => button.textContent === 'Step').click()
        // To the end of the step and a second's frames more; where beats are due, until the first is seen.
        for (let after = 0; after < 60 || ellipses.size < beats; after += it.settled && it.frame.step === 13 ? 1 : 0) {
          await new Promise((resolve) => requestAnimationFrame(resolve))
          look()
        }
        return ellipses.size
      },
      motion === 'reduce' ? 2 : 3,
    )
    if (motion === 'reduce') assert.equal(seen, 2, 'before and after, and nothing between')
    else assert.ok(seen > 2, `${seen} outlines`)
  }
})

test('with reduced motion a run goes on in lumps, two pictures a second', async (t) => {
  const { it: hook } = await openFigure(t, 'odometry-hook', { motion: 'reduce' })
  await hook.getByRole('button', { name: 'Reset' }).click()
  await until(hook, ({ step }) => step === 0, 'reset')
  await hook.getByRole('button', { name: 'Play' }).click()
  const { pictures, steps, time } = await hook.evaluate(async (it) => {
    const map = it.querySelector('.live .panel-map')
    const [steps, began] = [[it.frame.step], performance.now()]
    let [pictures, last] = [0, map.innerHTML]
    while (steps.length < 5) {
      await new Promise((resolve) => requestAnimationFrame(resolve))
      if (map.innerHTML !== last) pictures += 1
      last = map.innerHTML
      if (it.frame.step !== steps.at(-1)) steps.push(it.frame.step)
    }
    return { pictures, steps, time: performance.now() - began }
  })
  assert.ok(pictures <= 2 * (time / 1000) + 1.5, `${pictures} pictures in ${Math.round(time)} ms`)
  assert.ok(steps.at(-1) - steps.at(-2) > 4, `steps ${steps}`)
})

test('the seed makes another run, and the same one again', async (t) => {
  const { it: bench } = await openFigure(t, 'observer-bench')
  const seed = bench.getByRole('spinbutton', { name: 'Seed' })
  const first = await frameOf(bench)
  await seed.fill('7')
  await seed.press('Enter')
  const other = await until(bench, ({ params }) => params.seed === 7, 'seed 7')
  assert.notDeepEqual(other.truth, first.truth)
  await seed.fill('1')
  await seed.press('Enter')
  const again = await until(bench, ({ params }) => params.seed === 1, 'seed 1')
  assert.deepEqual(again.truth, first.truth)
})

test('a seed can be typed while the figure plays', async (t) => {
  const { page, it: bench } = await openFigure(t, 'observer-bench', { motion: 'no-preference' })
  const seed = bench.getByRole('spinbutton', { name: 'Seed' })
  await bench.getByRole('combobox', { name: 'Speed' }).selectOption({ label: '10×' })
  await bench.getByRole('button', { name: 'Play' }).click()
  const { step } = await frameOf(bench)
  await seed.click({ clickCount: 3 })
  await page.keyboard.press('Backspace')
  for (const digit of '4711') {
    await page.keyboard.press(digit)
    await quiet(page, 3)
  }
  await until(bench, (frame) => frame.step > step, 'it plays meanwhile')
  await page.keyboard.press('Enter')
  await until(bench, ({ params }) => params.seed === 4711, 'the seed typed')
  // What is left unsaid in it gives way to what holds, when the field is left.
  await seed.evaluate((input) => {
    input.value = ''
  })
  await quiet(page)
  assert.equal(await seed.inputValue(), '')
  await seed.evaluate((input) => input.blur())
  assert.equal(await seed.inputValue(), '4711')
})

test('no name of an eigenvalue lies across the unit circle, nor the line’s on an ellipse, at any width', async (t) => {
  const { page, it } = await openFigure(t, 'observer-bench')
  const faults = () =>
    it.evaluate((host) => {
      const box = (text) => {
        const { left, right, top, bottom } = text.getBoundingClientRect()
        return {
          words: text.textContent,
          left: left + 1,
          right: right - 1,
          top: top + 0.2 * (bottom - top),
          bottom: bottom - 0.2 * (bottom - top),
        }
      }
      const live = host.querySelector('.live')
      const rim = live.querySelector('.disc-rim').getBoundingClientRect()
      const [cx, cy, r] = [(rim.left + rim.right) / 2, (rim.top + rim.bottom) / 2, rim.width / 2]
      const across = [...live.querySelectorAll('.eigenvalue-name')].map(box).filter(({ left, right, top, bottom }) => {
        const far = Math.hypot(Math.max(cx - left, right - cx), Math.max(cy - top, bottom - cy))
        const near = Math.hypot(Math.max(0, left - cx, cx - right), Math.max(0, top - cy, cy - bottom))
        return near < r && far > r
      })
      const omega = [...live.querySelectorAll('.panel-phase .mark-name.measurement')].map(box)
      const matrix = live.querySelector('.panel-phase .outline').getScreenCTM()
      const on = omega.filter(({ left, right, top, bottom }) =>
        [...live.querySelectorAll('.panel-phase .outline')].some((path) =>
          Array.from({ length: 200 }, (_, i) =>
            path.getPointAtLength((i * path.getTotalLength()) / 200).matrixTransform(matrix),
          ).some(({ x, y }) => x > left && x < right && y > top && y < bottom),
        ),
      )
      return [...across, ...on].map(({ words }) => words)
    })
  for (const width of [390, 768, 1440]) {
    await page.setViewportSize({ width, height: 900 })
    for (const change of [
      { sensor: 'velocity', gain: 1, step: 12 },
      { gain: 5.57 },
      { gain: 6 },
      { gain: 0 },
      { sensor: 'position', gain: 1 },
      { gain: 0.3 },
      { gain: 3.1 },
      { gain: 6 },
    ]) {
      await it.evaluate(async (host, change) => {
        host.figure.change(change)
        await new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve)))
        do await new Promise((resolve) => requestAnimationFrame(resolve))
        while (host.figure.asked || !host.settled)
      }, change)
      assert.deepEqual(await faults(), [], `${width} px, ${JSON.stringify(change)}`)
    }
  }
})
