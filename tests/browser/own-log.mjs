// The page of a reader's own log, and small logs for it.
import { figure, open } from './harness.mjs'

export const SMALL = 'L,7,3,4\nO,0.5,0.1,0.02\nR,0.5,7,4.9\nO,1,0.1,0\nR,1,7,4.8\n'
export const file = (name, text) => ({ name, mimeType: 'text/csv', buffer: Buffer.from(text) })
export const MRCLAM = [
  file(
    'Robot1_Odometry.dat',
    '# Time [s]    forward velocity [m/s]    angular velocity[rad/s]\n1248272263.0 \t 0.10 \t 0.0\n' +
      '1248272263.5 \t 0.10 \t 0.2\n1248272264.0 \t 0.00 \t 0.0\n',
  ),
  file(
    'Robot1_Measurement.dat',
    '# Time [s]    Subject #    range [m]    bearing [rad]\n1248272263.2 \t 63 \t 2.0 \t 0.1\n' +
      '1248272263.4 \t 14 \t 1.0 \t 0.2\n',
  ),
  file('Barcodes.dat', '# Subject #    Barcode #\n 2   \t 14\n 6   \t 63\n'),
  file(
    'Landmark_Groundtruth.dat',
    '# Subject #    x [m]    y [m]    x std-dev [m]    y std-dev [m]\n6 \t 2.0 \t 0.5 \t 0.0001 \t 0.0002\n',
  ),
  file(
    'Robot1_Groundtruth.dat',
    '# Time [s]    x [m]    y [m]    orientation [rad]\n1248272262.9 \t 0.1 \t 0.2 \t 0.3\n' +
      '1248272264.1 \t 0.2 \t 0.2 \t 0.4\n',
  ),
]

/** The page with its figure alive. */
export async function openLog(t, wishes = {}) {
  const page = await open(t, { at: 'log/', ...wishes })
  const it = await figure(page, 'robot-log')
  // The script of the page has come: it gives the examples their addresses.
  await page.locator('.log-example a[href]').first().waitFor()
  return {
    page,
    it,
    choose: (...files) => page.locator('.log-drop input').setInputFiles(files),
    answer: page.locator('.log-answer'),
  }
}

/** Drops files on the page, as a hand would. */
export function drop(page, files) {
  return page.evaluate((given) => {
    const data = new DataTransfer()
    for (const [name, text] of given) data.items.add(new File([text], name))
    document
      .querySelector('h1')
      .dispatchEvent(new DragEvent('drop', { dataTransfer: data, bubbles: true, cancelable: true }))
  }, files)
}

/** The row of a sensor, or of anything else that the filter is told, by its legend. */
export const told = (page, legend) =>
  page.locator('.log-strip .log-sensor', { has: page.locator('legend', { hasText: new RegExp(`^${legend}$`) }) })

/** Writes a number into a field of such a row. */
export async function enter(row, label, value) {
  await row.getByLabel(label, { exact: true }).fill(value)
  await row.getByLabel(label, { exact: true }).press('Enter')
}
