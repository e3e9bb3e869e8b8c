// What a report says of how a log's files are read: without it nobody gets the same numbers from the same files.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { createRequire } from 'node:module'
import { applyChange } from '../../web/widgets/robot-log/change.js'
import { readings } from '../../web/page/log-report-files.js'

const { LogFiles } = createRequire(import.meta.url)('../../target/pkg/node/estimate_wasm.js')

/** @param {[string, string][]} all @param {any[]} changes */
function read(all, changes = []) {
  const files = new LogFiles()
  for (const [name, text] of all) files.add(name, text)
  for (const change of changes) applyChange(files, change)
  return Object.fromEntries(readings(files.files()))
}

test('a report says the columns and units of each file, and what was said of its wheels', () => {
  const said = read(
    [
      ['wheels.csv', 't,left_ticks,right_ticks\n0,0,0\n1,40,42\n2,80,85\n'],
      ['uwb.csv', 't,x,y,sigma_m\n0,1,2,0.1\n1,2,2,0.1\n'],
    ],
    [
      { file: 0, wheel: 'ticks', number: 4096 },
      { file: 0, wheel: 'radius', number: 0.1 },
      { file: 0, wheel: 'base', number: 0.62 },
      { file: 0, counting: 'total' },
      { file: 1, role: 'sensors' },
    ],
  )
  assert.equal(
    said['wheels.csv'],
    'encoders of two wheels; time from t, s; left from left_ticks, ticks; right from right_ticks, ticks; ' +
      'ticks in one turn of a wheel: 4096; radius of a wheel, m: 0.1; distance between the wheels, m: 0.62; ' +
      'counted from the start of the log.',
  )
  assert.match(
    said['uwb.csv'],
    /^sensors: .*; time from t, s; x from x, m; y from y, m; σ of the position from sigma_m, m\.$/,
  )
})

test('a report says whose rows are read, and by which clock', () => {
  const said = read(
    [
      ['drive.csv', 't,v,omega\n0,1,0\n1,1,0\n2,1,0\n'],
      ['ranges.csv', 't,tag,anchor,range\n3600,T7,6,2\n3601,T9,6,3\n3602,T7,6,2.5\n'],
    ],
    [
      { file: 1, only: 'T7' },
      { file: 1, clockShift: -3600 },
    ],
  )
  assert.match(said['ranges.csv'], /; only rows of which tag is T7; its clock: of another zone: 1 hour is taken off\.$/)
})
