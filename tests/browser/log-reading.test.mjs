// A log of the reader's own while it is read: it can be given up, other files can come meanwhile, and a worker that met
// a fault is replaced.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { until } from './harness.mjs'
import { drop, openLog } from './own-log.mjs'

const table = (rows) => `time,v,omega\n${Array.from({ length: rows }, (_, i) => `${i},0.5,1\n`).join('')}`
const orders = (all) =>
  all.length ? all.flatMap((one) => orders(all.filter((x) => x !== one)).map((rest) => [one, ...rest])) : [[]]

test('drop, read as, cancel and drop again, in every order: the page reads on and shows the last log', async (t) => {
  const { page, it, answer } = await openLog(t)
  const slow = table(60_000)
  for (const order of orders(['drop', 'read as', 'cancel', 'drop again'])) {
    await drop(page, [['first.csv', table(3)]])
    await until(it, ({ rows }) => rows === 3, 'the first log')
    // All in one go: no answer comes between two of them.
    await page.evaluate(
      ([acts, first, again]) => {
        const give = (name, text) => {
          const data = new DataTransfer()
          data.items.add(new File([text], name))
          document
            .querySelector('h1')
            .dispatchEvent(new DragEvent('drop', { dataTransfer: data, bubbles: true, cancelable: true }))
        }
        for (const act of acts) {
          if (act === 'drop') give('slow.csv', first)
          if (act === 'drop again') give('again.csv', again)
          if (act === 'cancel') {
            const cancel = document.querySelector('.log-reading button')
            cancel?.focus()
            cancel?.click()
            if (cancel && document.activeElement !== document.querySelector('.log-drop button'))
              throw new Error('the focus is lost')
          }
          if (act === 'read as') {
            const role = document.querySelector('.log-file select')
            role.value = 'odometry'
            role.dispatchEvent(new Event('change', { bubbles: true }))
          }
        }
      },
      [order, slow, table(9)],
    )
    const words = order.join(', ')
    await page.waitForFunction(() => !document.querySelector('.log-reading'))
    const last = order
      .slice(order.indexOf('cancel') + 1)
      .filter((act) => act.startsWith('drop'))
      .at(-1)
    const rows = last === 'drop' ? 60_000 : last ? 9 : 3
    await until(it, (frame) => frame.rows === rows, `${words}: ${rows} rows`)
    const name = await page.locator('.log-file legend').textContent()
    assert.equal(name, last === 'drop' ? 'slow.csv' : last ? 'again.csv' : 'first.csv', words)
    if (order.at(-1) !== 'cancel') continue
    assert.match(await answer.textContent(), /given up/, words)
  }
})

test('a worker that met a fault is replaced: a sentence says so, the log stays and is replayed', async (t) => {
  const { page, it, answer } = await openLog(t)
  await drop(page, [['first.csv', table(30)]])
  await until(it, ({ rows }) => rows === 30, 'the first log')
  const [worker] = page.workers()
  // Whatever it is asked next, it meets a fault.
  await worker.evaluate(() => {
    const tell = globalThis.postMessage.bind(globalThis)
    globalThis.postMessage = () => tell({ kind: 'fault' })
  })
  await drop(page, [['other.csv', table(50)]])
  await answer.getByText('met a fault of its own').waitFor()
  assert.match(await answer.textContent(), /was started anew\. The figure keeps the previous log\./)
  await it.locator('.live').getByRole('button', { name: 'Reset' }).click()
  await until(it, ({ rows, step }) => rows === 30 && step === 0, 'the log before, from its start')
  await drop(page, [['other.csv', table(50)]])
  await until(it, ({ rows }) => rows === 50, 'the other log')
  assert.notEqual(page.workers()[0], worker)
})

test('the answers to what positions are stand beside the question, and what is not read is named', async (t) => {
  const { page, it, choose } = await openLog(t)
  const rows = Array.from({ length: 30 }, (_, k) => `${k / 2},0.5,0,${k / 4},${(k % 3) / 10},21\n`).join('')
  await choose({ name: 'both.csv', mimeType: 'text/csv', buffer: Buffer.from(`t,v,omega,x,y,temp\n${rows}`) })
  const press = page.getByRole('button', { name: 'What a sensor read', exact: true })
  await press.waitFor()
  assert.equal(await page.locator('.log-choices button').count(), 2)
  await press.focus()
  await page.keyboard.press('Enter')
  await until(it, ({ rows: count }) => count === 60, 'the log')
  assert.equal(await page.locator('[data-key="0 read as"]').inputValue(), 'sensors')
  assert.equal(await page.evaluate(() => document.activeElement.getAttribute('data-key')), '0 read as')
  assert.equal(await page.locator('.log-choices').count(), 0)
  assert.equal(await page.locator('.log-unread').innerText(), 'Not read: temp.')
})

test('a clock that is an hour off is asked beside its answers, and of any file the seconds may be typed', async (t) => {
  const { page, it } = await openLog(t)
  const gps = Array.from({ length: 60 }, (_, i) => `${3600 + i},${i},0\n`).join('')
  await drop(page, [
    ['wheels.csv', table(61)],
    ['gps.csv', `time,gps_x,gps_y\n${gps}`],
  ])
  await page.locator('select[data-key="1 read as"]').selectOption('sensors')
  await page.locator('.log-file.asks').filter({ hasText: 'Its times begin 3540.0 s after the motion ends' }).waitFor()
  await page.getByLabel('its clock').selectOption({ label: 'of another zone: 1 hour is taken off' })
  await until(it, ({ rows, log }) => rows === 121 && log.readings.fix === 60, 'the log with its fixes')
  assert.equal(await page.locator('.log-file.asks').count(), 0)
  // What was added stays to be changed; a number that is none is refused where it stands.
  const typed = page.getByLabel('or seconds that are added to its times')
  await typed.fill('soon')
  await typed.press('Tab')
  assert.equal(await typed.getAttribute('aria-invalid'), 'true')
  await typed.fill('−3598,5')
  await typed.press('Tab')
  await page.getByLabel('its clock').filter({ hasText: 'its own: −3598.5 s are added' }).waitFor()
})
