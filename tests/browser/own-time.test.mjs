// The two figures of readings that belong to their time, on a phone and on a wide screen, by a mouse, by keys and by a
// finger: what the chapter says is found there is found.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { HANDS } from './hands.mjs'
import { frameOf, openFigure, PHONE, quiet, until } from './harness.mjs'

const WIDTHS = [PHONE, { width: 1440, height: 900 }]

/** Both figures at both widths with each hand. */
function byEveryHand(name, find) {
  for (const viewport of WIDTHS) {
    for (const [called, hand] of Object.entries(HANDS)) {
      test(`${name} at ${viewport.width} px, by ${called}`, async (t) => {
        const { page, it } = await openFigure(t, name, { viewport, touch: called === 'touch' })
        const button = (label) => it.getByRole('button', { name: label, exact: true })
        await find({
          it,
          press: (label) => hand.press(button(label)),
          // The list of a native choice is the system's own.
          choose: (label, option) => it.getByLabel(label).selectOption({ label: option }),
          unfold: async () => {
            for (const fold of await it.locator('.live .controls details:not([open]) > summary').all())
              await hand.press(fold)
          },
          // As far to the right, and down, in pixels.
          drag: async (label, dx, dy = 0) => {
            await hand.drag(page, it.getByRole('slider', { name: label, exact: true }).last(), dx, dy)
            await quiet(page, 3)
          },
          frame: (wanted, what) => until(it, wanted, what),
        })
      })
    }
  }
}

const rms = ({ ways }) => ways.map((way) => way.rms)

byEveryHand('late-readings', async ({ it, press, choose, unfold, drag, frame }) => {
  await press('The camera alone')
  const alone = await frame(({ params }) => params.laserRate === 0 && params.sonarRate === 0, 'the camera alone')
  assert.ok(alone.params.way === 'as-new' && Math.abs(alone.lag - alone.travelled) < 0.1 * alone.travelled, 'v·τ')
  await choose('What is late is taken', 'Go back')
  const back = await frame(({ params }) => params.way === 'go-back', 'going back')
  assert.ok(Math.abs(back.lag) < alone.lag / 5, 'put where it was measured, it leaves no lag')

  // One reading: it comes later and later, and is taken out.
  await press('One reading 3 s late')
  const one = await frame(({ params }) => params.ownDelay === 3, 'one reading')
  assert.ok(rms(one)[0] > rms(one)[2])
  await drag('When that reading came; up takes it out', -32)
  const sooner = await frame(({ params }) => params.ownDelay < 3, 'it comes sooner')
  assert.ok(rms(sooner)[0] < rms(one)[0], 'the less late, the less it does')
  await drag('When that reading came; up takes it out', 0, -48)
  const { ways } = await frame(({ params }) => params.removed, 'it is taken out')
  assert.ok(
    ways.every((way) => way.rms === ways[0].rms),
    'then all ways are one',
  )
  await drag('When that reading came; up takes it out', 0, -48)
  await drag('Which of the camera’s readings is in hand', 48)
  await frame(({ params }) => !params.removed && params.picked > one.params.picked, 'another is in hand')

  // A gap, which grows.
  await press('A gap, and the track afterwards')
  const { gap } = await frame(({ params }) => params.gap, 'a gap')
  await drag('Where the gap ends', 64)
  const wider = await frame(({ gap: now }) => now.to > gap.to, 'a longer gap')
  assert.ok(wider.gap.sigmaAfter > gap.sigmaAfter && gap.sigmaAfter > 2 * gap.sigmaBefore, 'σ grows in it')
  assert.ok(gap.sigmaSmoothed < gap.sigmaAfter / 2, 'from both ends it is closed')
  assert.ok(gap.worstPlace > 1 / 3 && gap.worstPlace < 2 / 3, 'worst near its middle')

  // In a setting of one's own a gap opens and closes by a tick, and nothing else changes.
  await unfold()
  const tick = it.getByLabel('a gap, in which nothing is read')
  const { params: mine } = await frame(() => true, 'as it is')
  await tick.uncheck()
  const { params: closed } = await frame(({ gap: now }) => now === null, 'the gap is closed')
  assert.deepEqual(closed, { ...mine, gap: null })
  await tick.check()
  const { params: opened } = await frame(({ gap: now }) => now, 'it is open again')
  assert.deepEqual(opened, { ...mine, gap: [8, 13] })

  // The fine sensors, one after the other.
  await press('Drop what is late')
  const dropped = await frame(({ params }) => params.way === 'drop', 'dropped')
  assert.ok(rms(dropped)[1] < rms(dropped)[0], 'beside another fine one it is better dropped than taken as new')
  await it.getByLabel(/^Laser/).press('Home')
  const without = await frame(({ params }) => params.laserRate === 0, 'no laser')
  assert.ok(rms(without)[1] - rms(without)[2] > rms(dropped)[1] - rms(dropped)[2], 'the only fine one is missed more')
})

byEveryHand('car-log', async ({ it, press, drag, frame }) => {
  const { logLikelihood } = await frameOf(it)
  // By hand along the curve, until the likelihood falls again.
  const seen = []
  for (const way of [16, -8]) {
    for (let fell = 0; fell < 2 && seen.length < 30; ) {
      await drag('Delay of the speed', way)
      const { params, logLikelihood: now } = await frameOf(it)
      fell = seen.length > 0 && now < seen.at(-1)[1] ? fell + 1 : 0
      seen.push([params.delay, now])
    }
  }
  const [delay, best] = seen.reduce((one, other) => (other[1] > one[1] ? other : one))
  assert.ok(delay > 0.5 && delay < 0.66 && best - logLikelihood > 146, `${delay} s, ${best - logLikelihood}`)

  await press('Without fixes')
  const none = await frame(({ params }) => params.fixes === 'none', 'no fixes')
  assert.equal(Math.round(none.reckonedOff / 10), 9)
  await press('All fixes')
  const all = await frame(({ params }) => params.fixes === 'all', 'all fixes')
  await press('One a second')
  const second = await frame(({ params }) => params.fixes === 'second' && params.delay === 0, 'one a second')
  assert.ok(all.nis < 0.7 && second.nis > 2.8 && all.lag1 > 0.5, 'ten times the readings tell no more')
  await press('Learn scale and bias')
  const { learned } = await frame(({ learned: now }) => now, 'the scale')
  assert.ok(Math.abs(learned.speedScale - 0.025) < 0.005)
  await press('A tunnel')
  const { tunnel } = await frame(({ tunnel: now }) => now?.worstSmoothed, 'the tunnel')
  assert.ok(tunnel.worst > 40 && tunnel.worstSmoothed < 15)
  await it.locator('.live .panel-map').getByText('the track afterwards', { exact: true }).waitFor()
  await press('A gate')
  const { refusals, nis } = await frame(({ params }) => params.gate, 'the gate')
  assert.ok(refusals === 43 && nis < 1.2)
})
