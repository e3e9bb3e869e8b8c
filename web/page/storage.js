/** What the browser keeps for the reader between visits. Some browsers keep nothing, or forbid asking. */

/** @param {string} key */
export function recall(key) {
  try {
    return localStorage.getItem(key)
  } catch {
    return null
  }
}

/** @param {string} key @param {string | null} value null forgets */
export function remember(key, value) {
  try {
    if (value === null) localStorage.removeItem(key)
    else localStorage.setItem(key, value)
  } catch {
    // Where nothing can be kept, the choice holds until the page is closed.
  }
}

/** @param {string} prefix */
export function forgetAll(prefix) {
  try {
    for (const key of Object.keys(localStorage)) if (key.startsWith(prefix)) localStorage.removeItem(key)
  } catch {
    // Where nothing can be kept, there is nothing to forget.
  }
}
