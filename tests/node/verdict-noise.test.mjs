// What a verdict without a fault says of innovations that do not look like noise.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { ranked } from '../../web/widgets/robot-log/verdict.js'
import { judgement, suspect } from './verdicts.mjs'

const log = { rows: 1000, truth: false }

test('beside no fault it is said where the innovations do not look like noise', () => {
  const noise = {
    nis: { times: [152.04, 160], there: 3.52, elsewhere: 0.93 },
    refused: { times: [100, 159.8], there: 0.49, elsewhere: 0.003 },
    correlated: { sensor: 'fix', by: 0.16, chance: 0.02 },
  }
  assert.match(
    ranked(judgement([suspect({ standing: 'cleared' })], { noise }), log),
    /Yet from 152\.0 to 160\.0 s after the first row NIS is 3\.5, and 0\.9 elsewhere; from 100\.0 to 159\.8 s after /,
  )
  assert.match(
    ranked(judgement([suspect({ standing: 'cleared' })], { noise: { ...noise, nis: null } }), log),
    /Yet from 100\.0 .* gates refuse 49 % of the readings, and 0\.3 % elsewhere; the innovations of the positions are /,
  )
  assert.doesNotMatch(ranked(judgement([suspect({})], { noise }), log), /Yet/, 'what is named is mended first')
})
