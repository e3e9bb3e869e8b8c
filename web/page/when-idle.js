/**
 * What a page does once it is idle: it follows the reader in the contents, explains words, and keeps itself for reading
 * offline.
 */

import { follow } from './contents.js'
import { offline } from './offline.js'
import { scrollBoxes } from './scroll-boxes.js'
import { terms } from './terms.js'

export function later() {
  follow()
  terms()
  scrollBoxes()
  offline()
  const copied = () =>
    import('./copied.js').then(
      ({ copyLines }) => copyLines(),
      () => {},
    )
  if (getSelection()?.isCollapsed === false) copied()
  else document.addEventListener('selectionchange', copied, { once: true })
  if (document.querySelector('[data-toy]'))
    import('./toy.js').then(
      ({ toys }) => toys(),
      () => {},
    )
}
