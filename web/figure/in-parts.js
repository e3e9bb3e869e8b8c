/**
 * What a figure computes beside its run in the page's own thread, a part at a time: anew where something else is to be
 * known, and given up where the reader says so. What takes a worker is a `Beside`.
 */

/**
 * @template Value
 * @typedef {object} Task
 * @property {number} parts
 * @property {string} unit what a part is called
 * @property {number} each how many numbers a part has
 * @property {(params: any) => string} about what it is about: while this stays, what has come stays
 * @property {boolean} stays whether what was known before stays until the first new parts are there: they come at once
 * @property {(params: any) => boolean} wanted whether there is anything to compute
 * @property {(lab: any, from: number) => ArrayLike<number>} compute the numbers of the next few parts
 * @property {(numbers: number[]) => Value} value what the numbers so far say
 */

/** All parts at once, for a still. @template Value @param {Task<Value>} task @param {any} lab @returns {Value} */
export function inOne({ parts, each, compute, value }, lab) {
  /** @type {number[]} */
  const numbers = []
  while (numbers.length < parts * each) numbers.push(...Array.from(compute(lab, numbers.length / each)))
  return value(numbers)
}

/** @template Value */
export class InParts {
  /**
   * @param {Task<Value>} task
   * @param {() => void} changed
   * @param {(params: any) => Promise<any>} open a lab with these parameters
   * @param {(act: () => void) => void} [soon] calls back after what waits
   */
  constructor(task, changed, open, soon = (act) => setTimeout(act, 0)) {
    this.task = task
    this.changed = changed
    this.open = open
    this.soon = soon
    /** @type {Value | null} */
    this.value = null
    this.done = 0
    this.key = ''
    this.id = 0
    this.working = false
  }

  /** @returns {import('./progress.js').Work | null} */
  get progress() {
    return this.working ? { step: this.done, of: this.task.parts, unit: this.task.unit } : null
  }

  /** Begins anew where it is about something else. @param {{ params: any }} frame */
  follow({ params }) {
    const key = this.task.about(params)
    if (key === this.key) return
    this.key = key
    this.id += 1
    if (!this.task.stays) this.value = null
    this.done = 0
    this.working = this.task.wanted(params)
    if (this.working) this.work(this.id, params)
  }

  /** @param {number} id @param {any} params */
  async work(id, params) {
    const { parts, each, compute, value } = this.task
    try {
      const lab = await this.open(params)
      /** @type {number[]} */
      const numbers = []
      const go = () => {
        if (id === this.id) {
          numbers.push(...Array.from(compute(lab, numbers.length / each)))
          this.done = numbers.length / each
          this.value = value(numbers)
          this.working = this.done < parts
          this.changed()
        }
        if (id === this.id && this.working) this.soon(go)
        else lab.free()
      }
      this.soon(go)
    } catch {
      // Without this the figure goes on; the next change tries again.
      if (id === this.id) this.cancel()
    }
  }

  /** What has come stays. */
  cancel() {
    this.id += 1
    this.working = false
    this.changed()
  }
}
