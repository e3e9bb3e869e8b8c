/** What a reader can take away of a figure: a link to its state, markup that embeds it, its picture and its numbers. */

import { copied, offer } from './clipboard.js'
import { focusFirst } from '../draw/dom.js'
import { inTime } from '../load/timeouts.js'
import { markup, pageOf } from './embed.js'
import { withState } from './state-in-url.js'

/** What a frame needs besides the figure, pixels: the margins, and the line that leads to the chapter. */
const ROOM = 72

export class Share {
  /**
   * @param {HTMLElement} host
   * @param {import('./spec.js').FigureSpec} spec
   * @param {string} id
   * @param {import('./run.js').Run} run
   * @param {import('./announcer.js').Voice} voice
   */
  constructor(host, spec, id, run, voice) {
    this.host = host
    this.spec = spec
    this.id = id
    this.run = run
    this.voice = voice
    /** Where text to copy is shown. @type {HTMLElement | null} */
    this.tools = null
    this.orders = {
      link: () => this.link(),
      // Another page has no log of the reader's.
      embed: host.closest('.own-log') ? null : () => this.embed(),
      // A frame without an origin of its own may not save files, and no browser tells the page so.
      download: self.origin === 'null' ? null : (/** @type {'svg' | 'csv'} */ kind) => this.download(kind),
    }
  }

  async link() {
    // The address may hold older states of other figures: the link gets their present ones.
    let link = location.href
    for (const other of /** @type {NodeListOf<HTMLElement & { state: any }>} */ (
      document.querySelectorAll('.widget[data-state="live"]')
    )) {
      const id = other.dataset.figure ?? ''
      if (new URL(link).searchParams.has(id)) link = withState(link, id, other.state)
    }
    link = withState(link, this.id, this.run.state())
    if (await copied(link)) return this.voice.tell(`Link copied.${this.before()}`)
    // A frame has no address bar.
    if (parent !== window) return this.show('Link to this state', link)
    history.replaceState(null, '', link)
    this.voice.tell(`The link is in the address bar.${this.before()}`)
  }

  /** What is typed and could not be taken is not in what is copied. */
  before() {
    return this.host.querySelector('[data-wrong]') ? ' It holds the last state without a fault.' : ''
  }

  async embed() {
    const { host, id } = this
    const figure = host.closest('figure')
    const title = figure?.querySelector('.figure-title')?.textContent?.replace(/\s+/g, ' ').trim() ?? id
    const height = (figure ?? host).getBoundingClientRect().height + ROOM
    const text = markup({ page: pageOf(document, this.spec.name), id, title, height }, this.run.state())
    this.show('Markup that shows this figure, in this state, on another page', text)
    if (await copied(text)) this.voice.tell(`Markup copied.${this.before()}`)
  }

  /** @param {string} name @param {string} text */
  show(name, text) {
    if (this.tools) offer(this.tools, name, text, () => focusFirst(this.host))
  }

  /**
   * Few readers take a file away: what makes it is fetched when one does.
   * @param {'svg' | 'csv'} kind
   */
  async download(kind) {
    const {
      id,
      run: { frame },
      spec,
    } = this
    try {
      const [{ asCsv, asSvg }, { save }] = await inTime(Promise.all([import('./download.js'), import('./save.js')]))
      if (kind === 'csv') return save(`${id}.csv`, 'text/csv', asCsv(spec.series(frame)))
      const panels = this.host.querySelector('.live')
      if (panels) save(`${id}.svg`, 'image/svg+xml', asSvg(panels, Object.values(spec.describe(frame)).join(' ')))
    } catch {
      this.voice.tell('The file could not be made: a part of the page could not be fetched.')
    }
  }
}
