/** What a reader tells the filter of a log, in the strip of the workbench: sensors, start, afterwards, fit. */

import { FitForm } from './log-fit.js'
import { SensorForm } from './log-sensors.js'
import { StartForm } from './log-start.js'

/** What was said of the log before and is not true of another. */
const UNTOLD = ['start', 'startSigma', 'startSigmaHeading', 'withheld']

/** How often the run is led on, milliseconds. */
const FOLLOW_MS = 40

export class Forms {
  /**
   * @param {{ figure: any }} host of the figure
   * @param {() => Promise<import('../widgets/robot-log/remote-run.js').RemoteRun>} run
   */
  constructor(host, run) {
    const box = document.createElement('div')
    box.className = 'log-forms'
    this.box = box
    this.host = host
    /** What waits to follow the run. */
    this.following = 0
    this.change = (/** @type {Record<string, unknown>} */ patch) => {
      host.figure.change(patch)
      this.follow()
    }
    const smooth = async () => {
      const running = await run()
      running.smooth()
      this.follow()
    }
    const fit = async () => {
      const running = await run()
      running.onfitting = (told) => this.fit.progress(told)
      return running.fit()
    }
    this.sensors = new SensorForm(box, this.change)
    this.start = new StartForm(box, this.change, smooth)
    this.fit = new FitForm(box, { fit, stop: () => host.figure?.run?.stop('fit'), take: this.change })
    /** Where the log begins by its first fixes, as text. */
    this.opening = ''
  }

  /** Leads the run on where the figure is far from the window: it takes its turns by itself only near to it. */
  follow() {
    clearTimeout(this.following)
    const { figure } = this.host
    figure.turn(performance.now())
    // A panel may have been left for a later turn.
    if (figure.run?.busy || figure.behind) this.following = setTimeout(() => this.follow(), FOLLOW_MS)
  }

  /** @param {import('estimate-wasm').LogContents} contents */
  take(contents) {
    for (const form of [this.sensors, this.start, this.fit]) form.take(contents)
  }

  /**
   * Starts another log, or one that is read otherwise, where its first fixes say.
   * @param {import('estimate-wasm').LogContents} contents
   * @param {import('estimate-wasm').Parameter[]} parameters
   * @param {boolean} other whether it is another log
   */
  begin({ opening }, parameters, other) {
    const before = this.opening
    this.opening = JSON.stringify(opening)
    if (!other && before === this.opening) return
    const usual = parameters.filter(({ name }) => UNTOLD.includes(name)).map((one) => [one.name, one.default])
    const { sightings } = this.host.figure.run.wanted.params
    const first = other && !sightings && this.untouched(parameters)
    this.change({ ...Object.fromEntries(usual), ...(first ? { sightings: true } : {}), ...opening })
  }

  /**
   * Whether the reader has set nothing yet: the mower begins without its ranges, and no log of a reader's does.
   * @param {import('estimate-wasm').Parameter[]} parameters
   */
  untouched(parameters) {
    const { params } = this.host.figure.run.wanted
    const set = parameters.filter(
      ({ name, default: usual }) => name !== 'sightings' && JSON.stringify(params[name]) !== JSON.stringify(usual),
    )
    return set.length === 0
  }

  /**
   * What the reader has set last, and not what the frame was computed with: a slider that went back to it would take
   * the next key from there.
   * @param {import('estimate-wasm').LogFrame} frame
   */
  show(frame) {
    const told = { ...frame, params: this.host.figure.run.wanted.params }
    this.sensors.show(told)
    this.start.show(told)
  }
}
