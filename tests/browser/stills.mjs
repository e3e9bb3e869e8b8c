// The stills of a page, and what every still has.
import assert from 'node:assert/strict'

/**
 * How each figure's still is drawn: panels that show, drawn in the page or as images that have come, and how much they
 * hold.
 */
export async function stills(page) {
  // Where scripts are on, an image waits until it is near the screen.
  await page.evaluate(() => {
    for (const image of document.querySelectorAll('.still > img')) image.loading = 'eager'
  })
  // A page without scripts answers questions, and draws no frame of its own accord.
  while (!(await page.evaluate(() => [...document.querySelectorAll('.still > img')].every((image) => image.complete))));
  return page.evaluate(() => {
    /** Of an image, the pixels that it inks, in hundreds. */
    const inked = (image) => {
      const canvas = document.createElement('canvas')
      Object.assign(canvas, { width: 300, height: 200 })
      const brush = /** @type {any} */ (canvas.getContext('2d'))
      if (image.naturalWidth > 0) brush.drawImage(image, 0, 0, 300, 200)
      return brush.getImageData(0, 0, 300, 200).data.filter((value, i) => i % 4 === 3 && value > 60).length / 100
    }
    return [...document.querySelectorAll('figure.figure-widget')].map((figure) => {
      const panels = [...figure.querySelectorAll('.still > .panel')].filter((panel) => {
        const box = panel.getBoundingClientRect()
        return box.width > 100 && box.height > 80
      })
      return {
        id: figure.id,
        panels: panels.length,
        marks: Math.min(
          ...panels.map((panel) =>
            panel.localName === 'img' ? inked(panel) : panel.querySelectorAll('path, line, circle').length,
          ),
        ),
        words: figure.querySelector('.still-text')?.textContent.trim().length ?? 0,
        caption: figure.querySelector('figcaption')?.textContent.trim().length ?? 0,
      }
    })
  })
}

export function judge(figures) {
  assert.ok(figures.length >= 1, 'there are figures')
  for (const { id, panels, marks, words, caption } of figures) {
    assert.ok(panels > 0 && marks > 5, `${id} is drawn: ${panels} panels, the least with ${marks} marks`)
    assert.ok(words > 40, `${id} is described`)
    assert.ok(caption > 20, `${id} has a caption`)
  }
}
