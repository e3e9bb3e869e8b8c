/** What the browser keeps of the programs that a reader has written: the text of each, and which was the last. */

import { recall, remember } from '../../page/storage.js'
import { isBegin } from './programs.js'

/** @typedef {import('./programs.js').Begin} Begin */
/** @typedef {'choset' | 'thrun' | 'common'} Letters */
/** @typedef {{ text: string, notation: Letters }} Own */

const LAST = 'filter:last'
const TEXT = 'filter:text:'
const LETTERS = ['choset', 'thrun', 'common']

/** A text as the lab takes it: short enough for a link, and without control characters. @param {string} text */
export function faultOf(text) {
  const bytes = new TextEncoder().encode(text).length
  if (bytes > 2000) return `The text has ${bytes} bytes, and a link carries 2000: it is not read.`
  // biome-ignore lint/suspicious/noControlCharactersInRegex: they are what is looked for
  return /[\u0000-\u0008\u000b-\u001f\u007f-\u009f]/.test(text)
    ? 'The text has a control character, and is not read.'
    : ''
}

/** The text that was written last where a program began. @param {Begin} begin @returns {Own | null} */
export function textOf(begin) {
  try {
    const { text, notation } = JSON.parse(recall(TEXT + begin) ?? '{}')
    if (typeof text !== 'string' || !LETTERS.includes(notation) || faultOf(text) !== '') return null
    return { text, notation }
  } catch {
    return null
  }
}

/** @param {Begin} begin @param {Own | null} own null forgets */
export function keep(begin, own) {
  remember(LAST, begin)
  remember(TEXT + begin, own && JSON.stringify(own))
}

/** The program that was shown last. @returns {Begin | null} */
export function last() {
  const begin = recall(LAST)
  return isBegin(begin) ? begin : null
}
