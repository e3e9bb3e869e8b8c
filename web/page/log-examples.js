/** Logs of ours, which the page for a reader’s own log opens on request. */

import example from '../../content/logs/example.csv'
import copied from '../../content/logs/plaza1-copied.csv'
import mower from '../../content/logs/plaza1.csv'

/**
 * By the name that the page and an address give them. What is wrong with one that an exercise asks about
 * is for the reader to find: the page gives no verdict on it.
 * @type {Record<string, { file: string, address: string, exercise?: boolean }>}
 */
export const EXAMPLES = {
  small: { file: 'example.csv', address: example },
  mower: { file: 'plaza1.csv', address: mower },
  copied: { file: 'plaza1-copied.csv', address: copied, exercise: true },
}

export const PUZZLE =
  'An exercise of the chapter asks what is wrong with this log, so the page does not name it. Its sensors’ rows tell.'

/** @param {{ address: string }} one */
export function addressOf({ address }) {
  return new URL(address, import.meta.url)
}
