/** A speed or ranges that read too much or too little by a factor, in words: what is read beside what is there. */

import { claimed, digits, plusMinus } from './sized.js'

/** @typedef {import('estimate-wasm').LogSuspect} Suspect */

/** @type {Record<string, { what: string, verb: string, are: string, too: [string, string] }>} */
const READ = {
  speedScale: { what: 'speed', verb: 'reads', are: 'it is', too: ['low', 'high'] },
  scale: { what: 'ranges', verb: 'read', are: 'they are', too: ['short', 'long'] },
}

/** So many times what is there is a share too much, or too little. @param {number} times @param {string[]} too */
const side = (times, too) => too[times > 1 ? 1 : 0]

/**
 * What is wrong with a scale, and what to do; of ranges with their offset, where that is off as well.
 * @param {Suspect} suspect
 */
export function scaleSentence({ name, sizes: [size, offset], times }) {
  const { what, verb, are, too } = READ[name ?? '']
  const { value, sigma, set, unit } = times ?? { value: 1, sigma: null, set: 1, unit: null }
  if (size.end)
    return `The ${what} ${verb} ${value > 1 ? 'more' : 'less'} than ${claimed(value)} times what ${are}: ${UNIT}.`
  const known = { now: set, value, sigma, end: false }
  const remedy =
    name === 'speedScale'
      ? 'let the filter learn its scale'
      : `set their scale to ${digits(size, 100)} %${offset ? ` and their offset to ${digits(offset)} m` : ''}`
  const beside = offset ? ` and ${off(offset)}` : ''
  if (unit) {
    const [is, taken] = unit
    const ask = `${are.split(' ').reverse().join(' ')} in ${is}, and taken for ${taken}`
    return `The ${what} ${verb} ${plusMinus(known)} times what ${are}${beside}: ${ask}? Then ${UNIT}; else ${remedy}.`
  }
  const much = plusMinus({ ...known, value: Math.abs(value - 1) }, 100)
  const taken =
    set === 1 ? '' : `, where ${claimed(100 * Math.abs(set - 1))} % too ${side(set, too)} is what the settings say`
  return `The ${what} ${verb} ${much} % too ${side(value, too)}${beside}${taken}: ${remedy}.`
}

const UNIT = 'mend the unit'

/** Ranges that are off by a length. @param {Suspect['sizes'][number]} offset */
export function off(offset) {
  const by = offset.value - offset.now
  return `${plusMinus({ ...offset, value: Math.abs(by) })} m too ${by > 0 ? 'long' : 'short'}`
}
