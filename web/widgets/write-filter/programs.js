/** The programs that a text may begin as, in words, and the run that each is shown in. */

/** Steps of a run: on the rail, and in the stadium. */
const STEPS = { linear: 60, robot: 240 }

/** @typedef {import('estimate-wasm').WriteParams} Params */
/** @typedef {Params['begin']} Begin */

/**
 * Each program by its name, in groups, with its world.
 * @type {{ group: string, world: 'linear' | 'robot', programs: [Begin, string][] }[]}
 */
export const GROUPS = [
  {
    group: 'The rail robot',
    world: 'linear',
    programs: [
      ['empty', 'an empty box'],
      ['kalman', 'the chapter’s algorithm'],
      ['joseph', 'Joseph’s form'],
      ['short', 'the short form'],
      ['observer', 'an observer with a gain of your own'],
      ['forget', 'without W'],
    ],
  },
  {
    group: 'The museum’s robot',
    world: 'robot',
    programs: [
      ['ekf', 'the extended filter'],
      ['unwrapped-innovation', 'innovation not wrapped'],
      ['unwrapped-heading', 'heading not wrapped'],
      ['wrong-derivative', 'wrong derivative of a bearing'],
      ['transposed', 'FᵀPF for FPFᵀ'],
      ['degrees', 'degrees for radians'],
      ['deviation', 'σ for σ²'],
      ['step-length', 'V of another step'],
      ['short-form', 'short form, gain by hand'],
      ['asymmetric', 'P not made symmetric'],
      ['twice', 'readings used twice'],
    ],
  },
  {
    group: 'Exercises on the rail',
    world: 'linear',
    programs: [
      ['fill', 'fill in four lines'],
      ['change', 'a form that does not break'],
      ['information', 'no gain at all'],
      ['sequential', 'one reading after the other'],
      ['fixed', 'a gain that is fixed'],
      ['mend-1', 'mend the first'],
      ['mend-2', 'mend the second'],
    ],
  },
  {
    group: 'Exercises with the robot',
    world: 'robot',
    programs: [
      ['mend-3', 'mend the third'],
      ['extend', 'from f and h alone'],
    ],
  },
]

const ALL = GROUPS.flatMap(({ world, programs }) => programs.map(([begin, name]) => ({ begin, name, world })))

/** @param {string | null} name @returns {name is Begin} */
export const isBegin = (name) => ALL.some(({ begin }) => begin === name)

/** How many steps the run of a program has. @param {Begin} begin */
export const stepsOf = (begin) => STEPS[ALL.find((one) => one.begin === begin)?.world ?? 'linear']

/** A program as it begins, and its run. @param {Begin} begin */
export const opened = (begin) => ({ begin, text: null, step: stepsOf(begin) })
