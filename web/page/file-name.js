/** The most letters of a file's name that are shown. */
const MOST = 60

/** A file's name as it is shown: of a long one its beginning and its end. @param {string} name */
export function shortName(name) {
  const letters = [...name]
  if (letters.length <= MOST) return name
  return `${letters.slice(0, MOST - 20).join('')}…${letters.slice(-19).join('')}`
}
