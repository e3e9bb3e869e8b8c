/**
 * What a worker computes beside a figure's run: asked anew for each thing that is to be known, taken as it comes, and
 * given up. The worker may be a `PartServer`.
 */

/**
 * @typedef {object} Port the way to what computes
 * @property {(message: any) => void} post
 * @property {((message: any) => void) | null} onmessage
 */

/** @template Value */
export class Beside {
  /** @param {() => void} changed @param {() => Promise<Port>} open the way to what computes */
  constructor(changed, open) {
    this.changed = changed
    this.open = open
    /** @type {Promise<Port> | null} */
    this.port = null
    /** What has come so far. @type {Value | null} */
    this.value = null
    this.id = 0
    /** What it is about. */
    this.key = ''
    this.working = false
  }

  /**
   * Asks for something else; with null, for nothing.
   * @param {string} key @param {Record<string, unknown> | null} wish
   */
  ask(key, wish) {
    this.key = key
    this.id += 1
    this.value = null
    this.working = wish !== null
    this.say(wish ? { ...wish, id: this.id } : { kind: 'cancel' })
  }

  /** What has come stays. */
  cancel() {
    if (!this.working) return
    this.working = false
    this.id += 1
    this.say({ kind: 'cancel' })
    this.changed()
  }

  /** @param {any} message */
  async say(message) {
    if (message.kind === 'cancel' && !this.port) return
    try {
      this.port ??= this.open()
      const port = await this.port
      port.onmessage = (told) => this.take(told)
      port.post(message)
    } catch {
      // Without this the figure goes on; the next question tries again.
      this.port = null
      this.stop()
    }
  }

  /** @param {any} message */
  take(message) {
    const { kind, id } = message
    if (kind === 'failed' || kind === 'ended' || (kind === 'refused' && id === this.id)) return this.stop()
    if (id !== this.id) return
    this.hear(message)
    this.changed()
  }

  /** Takes an answer: `value`, and whether it is still `working`. @param {any} message */
  hear(message) {
    throw new Error(`nobody takes ${message.kind}`)
  }

  stop() {
    this.working = false
    this.key = ''
    this.changed()
  }
}
