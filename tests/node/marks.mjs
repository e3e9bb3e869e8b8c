// What a panel draws, as a list: each mark and text with its key and its attributes, in the order of drawing. Groups
// and windows are taken as they come, since what is asked of a drawing is where its marks stand.

/**
 * @param {(panel: any, frame: any, view: any) => unknown} draw of a panel
 * @param {{ width: number, height: number | ((frame: any) => number) }} size
 * @param {any} frame
 * @param {object} [view]
 * @returns {(Record<string, any> & { key: string })[]}
 */
export function marksOf(draw, size, frame, view = {}) {
  const marks = []
  const pen = {
    draw: (act) => act(pen),
    group: (_key, _attributes, act) => act(pen),
    window: (_key, _box, act) => act(pen),
    mark: (tag, key, attributes) => marks.push({ tag, key, ...attributes }),
    text: (key, attributes, words) => marks.push({ tag: 'text', key, words, ...attributes }),
  }
  draw({ pen, ...size }, frame, { handle: () => {}, memory: {}, elapsed: 0, limits: {}, ...view })
  return marks
}
