/**
 * Files as text. A log is written in UTF-8, but spreadsheets save tables in UTF-16, or with one byte for each letter.
 */

/** The most characters of a faulty line that are shown. */
const MOST_SHOWN = 200

/**
 * The text of a file, and a sentence about its encoding where that is not UTF-8. A file with a zero byte is no text:
 * its bytes that no UTF-8 has become U+FFFD, which no log may hold.
 * @param {string} name @param {ArrayBuffer} bytes @returns {{ text: string, note: string }}
 */
export function decode(name, bytes) {
  const all = new Uint8Array(bytes)
  const [first, second] = all
  if (first === 0xff && second === 0xfe) return inAnother(name, 'utf-16le', bytes)
  if (first === 0xfe && second === 0xff) return inAnother(name, 'utf-16be', bytes)
  try {
    return { text: new TextDecoder('utf-8', { fatal: true }).decode(bytes), note: '' }
  } catch {
    return all.includes(0)
      ? { text: new TextDecoder().decode(bytes), note: '' }
      : inAnother(name, 'windows-1252', bytes)
  }
}

/** @param {string} name @param {string} encoding @param {ArrayBuffer} bytes */
function inAnother(name, encoding, bytes) {
  return {
    text: new TextDecoder(encoding).decode(bytes),
    note: `${name} is no UTF-8 and was read as ${encoding.toUpperCase()}.`,
  }
}

/** The line of a text with this number, counted from 1. @param {string} text @param {number} line */
export function lineOf(text, line) {
  const mark = text.includes('\n') ? '\n' : '\r'
  let from = 0
  for (let i = 1; i < line; i += 1) from = text.indexOf(mark, from) + 1
  const end = text.indexOf(mark, from)
  return text.slice(from, Math.min(end < 0 ? text.length : end, from + MOST_SHOWN)).replace(/\r$/, '')
}
