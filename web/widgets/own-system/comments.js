/** What of a paste is a comment. */

/** What MATLAB ends with a comment, and Python computes: the rest of a division; not within a comment or a string. */
const REST_OR_COMMENT = /^((?:(?!\/\/|\/\*)[^%#"'\n])*?)(\d[\d.]*[^\S\n]*%[^\S\n]*\d[\d.]*)[^\S\n]*(?=[\n;,)\]]|$)/m

/** A fault where Python and MATLAB would read another number. @param {string} text */
export function restOrComment(text) {
  const unsure = REST_OR_COMMENT.exec(text)
  if (!unsure) return null
  const line = text.slice(0, unsure.index).split(/\r\n?|\n/).length
  return { fault: `“${unsure[2]}” is a comment in MATLAB and a rest in Python; write one number.`, line }
}

/**
 * Without comments, each line in its place: a line that goes on after `…` is joined to the next by a vertical tab.
 * @param {string} text
 */
export function withoutComments(text) {
  const lines = (/** @type {string} */ gone) => gone.replace(/[^\n]/g, '')
  return (
    text
      .replace(/\r\n?/g, '\n')
      .replace(/\v/g, ' ')
      .replace(/^\s*%\{\s*\n[\s\S]*?^\s*%\}.*$/gm, lines)
      // One after the other, as they stand: a mark within a comment or a string begins nothing. 5//2 is no comment.
      .replace(
        /("(?:[^"\\\n]|\\.)*")|\/\*[\s\S]*?\*\/|(?:[%#]|\/\/(?!(?<=\d\/\/)\d)).*$/gm,
        (all, string) => string ?? lines(all),
      )
      // Python's prompt of a line that goes on; elsewhere the same dots join two lines.
      .replace(/^\.\.\.(?=\s)/gm, ' ')
      .replace(/(\.\.\.|…)[^\n]*\n/g, '\v')
  )
}
