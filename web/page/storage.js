/** What the browser keeps for the reader between visits. Some browsers keep nothing, or forbid asking. */

/** What the browser refused to keep; it lasts until the page is closed. @type {Map<string, string>} */
const held = new Map()

/** @param {string} key */
export function recall(key) {
  try {
    return localStorage.getItem(key) ?? held.get(key) ?? null
  } catch {
    return held.get(key) ?? null
  }
}

/** @param {string} key @param {string | null} value null forgets */
export function remember(key, value) {
  held.delete(key)
  try {
    if (value === null) localStorage.removeItem(key)
    else localStorage.setItem(key, value)
  } catch {
    if (value !== null) held.set(key, value)
  }
}

/** @param {string} prefix */
export function forgetAll(prefix) {
  for (const key of held.keys()) if (key.startsWith(prefix)) held.delete(key)
  try {
    for (const key of Object.keys(localStorage)) if (key.startsWith(prefix)) localStorage.removeItem(key)
  } catch {
    // Where nothing can be kept, there is nothing to forget.
  }
}

/** Whether what is kept outlasts the page. */
export function outlasts() {
  try {
    localStorage.setItem('probe', '')
    localStorage.removeItem('probe')
    return true
  } catch {
    return false
  }
}
