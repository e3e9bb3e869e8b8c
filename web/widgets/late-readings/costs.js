/**
 * What the three ways cost over 500 seeds, computed beside the run, a few seeds at a time, and anew for each schedule
 * of readings.
 */

export const SEEDS = 500
/** Seeds of one call: about five milliseconds. */
const CALL = 20
/** What the costs do not depend on. */
const BESIDE = ['way', 'smooth', 'seed']

/** @typedef {{ rms: number, nees: number }} Cost */
/** @typedef {{ seeds: number, ways: Cost[] }} Costs the means so far */

/** @param {number[]} numbers of so many seeds @returns {Costs} */
function means(numbers) {
  const seeds = numbers.length / 6
  const mean = (/** @type {number} */ i) => {
    let sum = 0
    for (let k = i; k < numbers.length; k += 6) sum += numbers[k]
    return sum / seeds
  }
  return { seeds, ways: [0, 2, 4].map((i) => ({ rms: mean(i), nees: mean(i + 1) })) }
}

/** @type {import('../../figure/spec.js').Aside} */
export const costs = {
  whole: (lab) => means([...lab.seeds(0, SEEDS)]),
  open: (changed) => new Counting(changed, open),
}

/** A lab with these parameters. @param {any} params */
async function open(params) {
  const { loadLab } = await import('../../load/modules.js')
  const loaded = await loadLab('late-readings')
  if (!loaded.ok) throw new Error(loaded.why)
  return loaded.module.LateReadings.from({ version: 1, lab: 'late-readings', step: 0, params })
}

export class Counting {
  /**
   * @param {() => void} changed
   * @param {(params: any) => Promise<any>} open
   * @param {(act: () => void) => void} [soon] calls back after what waits
   */
  constructor(changed, open, soon = (act) => setTimeout(act, 0)) {
    this.changed = changed
    this.open = open
    this.soon = soon
    /** @type {Costs | null} */
    this.value = null
    this.key = ''
    this.id = 0
    this.counting = false
  }

  /** @returns {import('../../figure/progress.js').Work | null} */
  get progress() {
    return this.counting ? { step: this.value?.seeds ?? 0, of: SEEDS, unit: 'seed' } : null
  }

  /** Begins anew where the readings, or the drive, are others. @param {{ params: any }} frame */
  follow({ params }) {
    const key = JSON.stringify(Object.entries(params).filter(([name]) => !BESIDE.includes(name)))
    if (key === this.key) return
    this.key = key
    this.id += 1
    this.counting = true
    this.count(this.id, params)
  }

  /** @param {number} id @param {any} params */
  async count(id, params) {
    try {
      const lab = await this.open(params)
      /** @type {number[]} */
      const numbers = []
      const go = () => {
        if (id === this.id) {
          numbers.push(...lab.seeds(numbers.length / 6, CALL))
          this.value = means(numbers)
          this.counting = this.value.seeds < SEEDS
          this.changed()
        }
        if (id === this.id && this.counting) this.soon(go)
        else lab.free()
      }
      this.soon(go)
    } catch {
      // Without its costs the figure goes on; the next change tries again.
      if (id === this.id) this.cancel()
    }
  }

  cancel() {
    this.id += 1
    this.counting = false
    this.changed()
  }
}
