/** Unfolds every block before the page is printed, and folds those blocks again afterwards. */

export function openForPrint() {
  /** @type {HTMLDetailsElement[]} */
  let opened = []
  addEventListener('beforeprint', () => {
    opened = [...document.querySelectorAll('details')].filter((block) => !block.open)
    for (const block of opened) block.open = true
  })
  addEventListener('afterprint', () => {
    for (const block of opened) block.open = false
    opened = []
  })
}
