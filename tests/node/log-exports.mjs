// What the fuzz test knows of the exports that read and replay logs, as `class-exports.mjs` says it of the others.

const LOG = [
  'L,1,5,5',
  'L,2,-5,5',
  ...Array.from(
    { length: 40 },
    (_, i) => `O,${i},0.4,0.05\nR,${i},${1 + (i % 2)},${5 + (i % 7) / 5}\nB,${i},${2 - (i % 2)},6,0.3`,
  ),
].join('\n')
const HELD = [
  'L,1,5,5',
  ...Array.from({ length: 40 }, (_, i) => [
    `S,${i},0.4\nT,${i},0.05\nP,${i},${0.4 * i},0${i % 3 ? '' : ',0.5'}`,
    `H,${i},${0.05 * i}\nR,${i},1,6\nB,${i},1,6,0.3`,
  ]),
]
  .flat()
  .join('\n')
const TABLES = [
  'time_ms,v,omega\n0,0.4,0.05\n100,0.4,0.05\n',
  '# Time [s]    Subject #    range [m]    bearing [rad]\n0.05 \t 6 \t 2.0 \t 0.1\n',
  'id;x;y\n6;1;2\n',
  '# Subject #    Barcode #\n 6 \t 6\n',
  't,x,y\n0,0,0\n1,1,0\n',
  'time,lat,lon,speed,yaw_rate\n0,48,11,1,0\n1,48,11.1,1,0\n',
  'time,left_ticks,right_ticks\n0,0,0\n1,40,42\n',
  'time,left_ticks,right_ticks\n0,0,0\n1,41,44\n',
  't,d1,d2\n0,1,2\n1,1,nan\n',
  't,true_x,true_y\n0,9,9\n1,10,9\n',
  't,compass_heading_deg\n7200,0\n7201,1\n',
  't,speed,yaw_rate\n0,1,0\n1,1,0\n',
  't,tag,anchor,range\n0,T7,6,2\n1,T9,6,3\n',
  LOG,
]
const ROLES = [
  'log',
  'velocities',
  'odometry',
  'encoders',
  'reckoned',
  'sensors',
  'sightings',
  'ranges',
  'landmarks',
  'truth',
  'barcodes',
  'undecided',
  'unused',
]
const FRAMES = ['same', 'moved', 'own']
const VALUES = ['time', 'time', 'v', 'omega', 'x', 'range', 'landmark', 'heading', 'left', 'latitude']

/** A file that was added, and what is asked of its columns; one that is `such` where there is one. */
function fileOf(it, dice, such = () => true) {
  const files = it.files().map(({ values, role, several, frame }, at) => ({ at, values, role, several, frame }))
  return dice.pick(files.filter(such)) ?? dice.pick(files) ?? { at: 0, values: [] }
}
const encoders = (it, dice) => fileOf(it, dice, ({ role }) => role === 'encoders').at

/** @param {object} lab what is known of a lab of the page, whose face a log's has too */
export const logClasses = (lab) => ({
  RobotLog: {
    ...lab,
    before: (core) => [core.RobotLog.parse(HELD)],
    make: (dice, fresh) => (dice.uniform() < 0.3 ? [] : [fresh().state().params]),
    methods: {
      ...lab.methods,
      run: (dice) => [1 + dice.below(50)],
      runAll: () => [],
      smooth: () => [],
      summary: () => [],
    },
    // A state does not say that the track was smoothed: what is asked of a lab is asked again of its twin.
    again: (twin, it) => it.frame().smoothed && twin.smooth(),
  },
  CarLog: {
    ...lab,
    before: (core) => [core.CarLog.parse(LOG)],
    make: (dice, fresh) => (dice.uniform() < 0.3 ? [] : [fresh().state().params]),
    methods: { ...lab.methods, run: (dice) => [1 + dice.below(50)], likelihood: (dice) => [dice.uniform()] },
  },
  DriveLog: {
    construct: (core) => (text) => core.RobotLog.parse(text),
    make: () => [LOG],
    spoilt: 0.7,
    methods: { contents: () => [], handle: () => [], opening: () => [{ bearingOffset: 0.1 }] },
    look: (it) => it.contents(),
    covariances: () => [],
  },
  LogFiles: {
    make: () => [],
    spoilt: 0.3,
    chain: 80,
    least: {
      'read()': 1,
      'setRole()': 10,
      'setUnit()': 10,
      'setWheel()': 5,
      'setCounting()': 5,
      'setOnly()': 5,
      'setFrame()': 1,
      'setOrigin()': 1,
      'setClockShift()': 1,
      'correct()': 5,
    },
    methods: {
      add: (dice) => [`${dice.below(9)}.csv`, dice.pick(TABLES)],
      files: () => [],
      setRole: (dice) => [dice.below(3), dice.pick(ROLES)],
      setColumn(dice, _, it) {
        const { at, values } = fileOf(it, dice)
        return [at, dice.pick(values.length > 0 ? values.map(({ name }) => name) : VALUES), dice.pick([null, 0, 1, 2])]
      },
      setUnit(dice, _, it) {
        const { at, values } = fileOf(it, dice, ({ values }) => values.some(({ units }) => units.length > 0))
        const { name, units } = dice.pick(values.filter(({ units }) => units.length > 0)) ?? { name: 'v', units: ['s'] }
        return [at, name, dice.pick(units)]
      },
      setWheel: (dice, _, it) => [encoders(it, dice), dice.pick(['ticks', 'radius', 'base']), dice.pick([0.1, 1000])],
      setCounting: (dice, _, it) => [encoders(it, dice), dice.pick(['total', 'step', 'restarted'])],
      setOnly: (dice, _, it) => [fileOf(it, dice, ({ several }) => several !== null).at, dice.pick([null, 'T7', 'T9'])],
      setFrame: (dice, _, it) => [fileOf(it, dice, ({ frame }) => frame !== null).at, dice.pick(FRAMES)],
      setOrigin: (dice, _, it) => [fileOf(it, dice, ({ frame }) => frame !== null).at, dice.pick([48, 91]), 11],
      setClockShift: (dice, _, it) => [fileOf(it, dice, ({ clock }) => clock !== null).at, dice.pick([0, -3600])],
      correct: (dice) => [
        dice.pick([
          [1, 1],
          [0.97, 1.02],
        ]),
        dice.pick([[], [[1, 2, 3]]]),
        dice.pick([undefined, [[1, 0.4]]]),
        dice.pick([undefined, null, [1, 9]]),
        dice.pick([undefined, 0.04]),
      ],
      read: () => [],
    },
    often: ['add', 'add', 'setColumn', 'setFrame', 'setFrame', 'setOrigin', 'setClockShift', 'setOnly'],
    look: (it) => it.files(),
    covariances: () => [],
  },
  LogFit: {
    before: (core) => [core.RobotLog.parse(LOG)],
    make: (dice) => [{ gate: dice.pick([null, 0.99]) }, dice.pick([undefined, ['sigmaRange', 'scale']])],
    spoilt: 0.5,
    methods: { step: () => [], found: () => [] },
    look: (it) => it.found(),
    covariances: () => [],
  },
  LogVerdict: {
    before: (core) => [core.RobotLog.parse(LOG)],
    make: (dice) => [{ gate: dice.pick([null, 0.99]) }],
    spoilt: 0.5,
    methods: { step: () => [], found: () => [] },
    look: (it) => it.found(),
    covariances: () => [],
  },
  LogTable: {
    before: (core) => [core.RobotLog.parse(LOG)],
    make: (dice) => [{ gate: dice.pick([null, 0.99]) }, dice.pick(['track', 'innovations', 'log'])],
    spoilt: 0.5,
    methods: { next: (dice) => [1 + dice.below(50)] },
    look: () => [],
    covariances: () => [],
  },
})
