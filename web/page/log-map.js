/** The map of a log's likelihood over any two numbers of the filter: what the log tells of each and of both. */

import { SVG, button, part } from '../draw/dom.js'
import { drawLegend, drawLikelihood, drawLimit } from '../draw/likelihood.js'
import { fixed } from '../draw/numbers.js'
import { Pen } from '../draw/pen.js'
import { axes, plane as planeOf, scaleLog } from '../draw/plot.js'
import { liveHandles } from '../figure/handle.js'
import { LIMIT, closer, tells, within } from './log-limit.js'
import { bySensor, numbersOf } from './log-numbers.js'

/** @typedef {import('../widgets/robot-log/looks.js').Frame} Frame */
/** @typedef {import('../widgets/robot-log/remote-run.js').RemoteRun} Run */
/** @typedef {ReturnType<typeof numbersOf>[0]} Choice */
/** @typedef {{ number: Choice, places: number[] }} Axis `places` as the slider has them: logarithms of a σ */
/** @typedef {{ axes: [Axis, Axis], values: number[] }} Grid */

/** Cells to a side, and the share of a slider's way that lies either side of the present value. */
const [SIZE, SHARE] = [28, 0.2]
/** How often the map is drawn finer about its top at most. */
const FINER = 4
/** Readings count from so long after the first fix, s: behind every start that a delay leads to. */
const SETTLED = 2
const [WIDTH, HEIGHT] = [460, 430]
/** Digits of the numbers that are tried. */
const PRECISE = 9

export class LikelihoodMap {
  /** @param {() => Run} run @param {(patch: Record<string, unknown>) => void} change */
  constructor(run, change) {
    this.run = run
    this.box = document.createElement('div')
    this.box.className = 'log-likely'
    const set = part(document, this.box, 'fieldset', 'log-sensor')
    part(document, set, 'legend', '').textContent = 'map of the likelihood'
    this.across = choice(set, 'across')
    this.up = choice(set, 'upwards')
    const actions = part(document, set, 'div', 'log-actions')
    this.start = button(document, actions, 'Draw the map', () => this.draw())
    this.bar = /** @type {HTMLProgressElement} */ (part(document, actions, 'progress', ''))
    this.bar.setAttribute('aria-label', 'Map of the likelihood')
    this.end = button(document, actions, 'Cancel', () => this.run().stop('map'))
    this.words = part(document, set, 'p', 'log-says')
    this.words.setAttribute('role', 'status')
    const svg = document.createElementNS(SVG, 'svg')
    svg.setAttribute('viewBox', `0 0 ${WIDTH} ${HEIGHT}`)
    svg.setAttribute('role', 'group')
    svg.setAttribute('aria-label', 'Map of the log-likelihood over two numbers')
    set.append(svg)
    this.svg = svg
    this.pen = new Pen(svg)
    this.handle = liveHandles(
      change,
      () => {},
      () => this.paint(),
    )
    /** @type {Choice[]} */
    this.numbers = []
    /** What is drawn, and the finer map that has the line. @type {Grid | null} */
    this.map = null
    /** @type {Grid | null} */
    this.line = null
    /** @type {Frame | null} */
    this.frame = null
    this.wait(false)
  }

  /** @param {import('estimate-wasm').LogContents} contents */
  begin(contents) {
    this.run()?.stop('map')
    this.numbers = numbersOf(contents)
    this.map = null
    this.line = null
    this.words.textContent = ''
    for (const [i, select] of [this.across, this.up].entries()) {
      select.replaceChildren(...this.numbers.map(({ words }, at) => new Option(words, String(at))))
      select.value = String(Math.min(i, this.numbers.length - 1))
    }
    this.box.hidden = Object.keys(contents.readings).length === 0
    this.paint()
  }

  /** @param {Frame} frame */
  show(frame) {
    if (this.frame?.params === frame.params) return
    this.frame = frame
    this.paint()
  }

  /** @param {boolean} waiting */
  wait(waiting) {
    this.start.disabled = waiting
    this.bar.hidden = this.end.hidden = !waiting
  }

  async draw() {
    const { frame } = this
    const chosen = [this.across, this.up].map(({ value }) => this.numbers[Number(value)])
    if (!frame || chosen.some((one) => !one)) return
    if (chosen[0] === chosen[1]) {
      this.words.textContent = 'Choose two numbers that differ.'
      return
    }
    const [across, up] = chosen.map((number) => axisOf(number, frame))
    const map = { axes: /** @type {[Axis, Axis]} */ ([across, up]), values: /** @type {number[]} */ ([]) }
    this.map = map
    this.line = null
    this.wait(true)
    this.words.textContent = ''
    const told = (await this.fill(map, frame)) ?? (await this.draws(map, frame))
    if (this.map !== map) return
    this.wait(false)
    this.start.focus({ preventScroll: true })
    this.words.textContent = told
    this.paint()
  }

  /**
   * Fills a grid; what there is to say where that was given up.
   * @param {Grid} grid @param {Frame} frame @returns {Promise<string | null>}
   */
  async fill(grid, frame) {
    const { map } = this
    const run = this.run()
    this.bar.max = SIZE
    this.bar.value = 0
    run.onmapped = ({ row, values }) => {
      if (this.map !== map) return
      grid.values.push(...values)
      this.bar.value = row + 1
      this.paint()
    }
    const first = run.contents.span[0] + (frame.fixes.time[0] ?? 0)
    const wish = (/** @type {Axis} */ { number, places }) => ({
      name: number.told[0],
      values: places.map((place) => valueAt(number, place, PRECISE)),
    })
    const [across, up] = grid.axes
    const answer = await run.map({ from: first + SETTLED, across: wish(across), up: wish(up) })
    return answer.kind === 'map' ? null : (answer.message ?? 'The map was given up.')
  }

  /**
   * Looks finer about the top until the cells tell the line, and says what it is.
   * @param {Grid} map @param {Frame} frame
   */
  async draws(map, frame) {
    if (within(map.values, SIZE).edge)
      return (
        'Within the map no line closes: the likelihood is still high at its edge. Press Fit, or set the two numbers ' +
        'nearer to the likeliest, and draw it again. Gates are off here.'
      )
    let grid = map
    for (let finer = 0; finer < FINER; finer += 1) {
      const found = within(grid.values, SIZE)
      if (tells(found) && !found.edge) break
      const [across, up] = grid.axes
      const axes = /** @type {[Axis, Axis]} */ ([
        { ...across, places: closer(across.places, found.columns, found.edge) },
        { ...up, places: closer(up.places, found.rows, found.edge) },
      ])
      grid = { axes, values: [] }
      const given = await this.fill(grid, frame)
      if (given !== null || this.map !== map) return given ?? ''
    }
    const found = within(grid.values, SIZE)
    if (!tells(found) || found.edge)
      return (
        'The line that is around the true numbers in 95 of 100 logs is thinner than the cells of a map here, and is ' +
        'not drawn: the two numbers stand in for one another along a ridge. Gates are off here.'
      )
    this.line = grid
    const gated = Object.values(bySensor(frame.params.gate)).some(Boolean)
    const line = gated
      ? 'Gates are off here: outliers bend the line, which is not that of the filter as it is set'
      : 'If the model holds, the line is around the true numbers in 95 of 100 logs'
    const off = gated ? '' : ' Gates are off here.'
    return `${line}: ${reaches(grid.axes[0], found.columns)}, ${reaches(grid.axes[1], found.rows)}.${off}`
  }

  paint() {
    const { map, line, frame, pen, svg } = this
    svg.toggleAttribute('hidden', !map)
    svg.style.display = map ? '' : 'none'
    if (!map || !frame) return pen.draw(() => {})
    const box = { left: 56, top: 26, right: WIDTH - 12, bottom: HEIGHT - 62 }
    const [across, up] = map.axes
    /** @param {Axis} axis */
    const ends = ({ places }) => {
      // A cell lies about its place.
      const half = (places[1] - places[0]) / 2
      return /** @type {[number, number]} */ ([places[0] - half, places[SIZE - 1] + half])
    }
    const places = planeOf(box, ends(across), ends(up))
    /** @param {Axis} axis @param {[number, number]} range @param {import('../draw/plot.js').Scale} plain */
    const scale = (axis, range, plain) => {
      const [low, high] = ends(axis).map((place) => valueAt(axis.number, place) / (axis.number.told[3] ?? 1))
      return axis.number.told[2].log ? scaleLog([low, high], range) : plain
    }
    const shown = {
      box,
      x: scale(across, [box.left, box.right], places.x),
      y: scale(up, [box.bottom, box.top], places.y),
    }
    const rows = Math.floor(map.values.length / SIZE)
    const top = [...map.values, ...(line?.values ?? [])].reduce((most, value) => Math.max(most, value), -Infinity)
    pen.draw(() => {
      pen.window('likelihood', box, (to) => {
        drawLikelihood(to, box, { size: SIZE, rows, values: map.values, top, limit: LIMIT }, false)
        if (!line) return
        const [[left, right], [bottom, high]] = line.axes.map(ends)
        const part = { left: places.x(left), right: places.x(right), bottom: places.y(bottom), top: places.y(high) }
        drawLimit(to, part, { size: SIZE, values: line.values, top, limit: LIMIT })
      })
      axes(pen, shown, {
        title: `log-likelihood; ${up.number.words}`,
        x: across.number.words,
        ticks: [5, 5],
        grid: false,
      })
      drawLegend(pen, box, HEIGHT - 12)
      const at = placesOf(map.axes, frame)
      const inside = [across, up].every((axis, i) => at[i] >= ends(axis)[0] && at[i] <= ends(axis)[1])
      if (!inside) return
      const to = (/** @type {number} */ x, /** @type {number} */ y) => ({
        [across.number.told[0]]: valueAt(across.number, x),
        [up.number.told[0]]: valueAt(up.number, y),
      })
      const [step, rise] = [across, up].map(({ number }) => number.told[2].step)
      pen.group('handles', {}, (into) =>
        this.handle(into, 'chosen', {
          at: [places.x(at[0]), places.y(at[1])],
          label: 'The two numbers',
          value: [across, up]
            .map(({ number }, i) => `${number.words} ${valueAt(number, at[i]) / (number.told[3] ?? 1)}`)
            .join(', '),
          move: (px, py) => to(places.x.invert(px), places.y.invert(py)),
          nudge: (dx, dy) => to(at[0] + dx * step, at[1] + dy * rise),
        }),
      )
    })
  }
}

/** @param {Element} into @param {string} words */
function choice(into, words) {
  const label = part(document, into, 'label', '')
  part(document, label, 'span', '').textContent = words
  return /** @type {HTMLSelectElement} */ (part(document, label, 'select', ''))
}

/** The number in the lab's unit. @param {Choice} number @param {number} place @param {number} [digits] */
function valueAt({ told: [, , { log }, unit = 1] }, place, digits = 4) {
  return Number(((log ? 10 ** place : place) * unit).toPrecision(digits))
}

/** From where to where the line reaches along an axis. @param {Axis} axis @param {[number, number]} ends its cells */
function reaches({ number, places }, [from, to]) {
  const step = places[1] - places[0]
  const { log } = number.told[2]
  const [low, high] = [places[from] - step / 2, places[to] + step / 2].map((place) => (log ? 10 ** place : place))
  const digits = Math.max(0, Math.min(6, 2 - Math.floor(Math.log10(high - low))))
  return `${number.words} from ${fixed(low, digits)} to ${fixed(high, digits)}`
}

/** Where the present numbers are. @param {[Axis, Axis]} axes @param {Frame} frame */
function placesOf(axes, { params }) {
  return axes.map(({ number }) => placeOf(number, params))
}

/** @param {Choice} number @param {any} params */
function placeOf({ told: [name, , { log, ends }, unit = 1] }, params) {
  const value = params[name] / unit
  return log ? Math.log10(Math.max(value, 10 ** (ends[0] - 2))) : value
}

/** @param {Choice} number @param {Frame} frame @returns {Axis} */
function axisOf(number, { params }) {
  const [low, high] = number.told[2].ends
  const half = SHARE * (high - low)
  const middle = placeOf(number, params)
  const places = Array.from({ length: SIZE }, (_, i) => middle + half * ((2 * i) / (SIZE - 1) - 1))
  return { number, places }
}
