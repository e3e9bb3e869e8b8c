import { check, prints, pattern } from './claims.mjs'

/** Sightings and landmarks in words: `no`, or their number. */
const counted = (word) => (word.toLowerCase() === 'no' ? 0 : Number(word))
check(
  'loop-closure',
  {
    gate: [0.5, 9.21, 100],
    found: [0.5, 6, 50],
    correlated: [true, false],
    seed: [1, 2, 5],
  },
  [0, 1, 60, 112, 113, 128, 300],
  () => [
    [
      /^At the start the pose is known exactly, and (\w+) landmarks? in reach (?:is|are) founded\.$/,
      ({ step, map, P }, founded) =>
        step === 0 && counted(founded) === map.founded && P.flat().every((entry) => entry === 0),
    ],
    [
      /^The map has (\w+) landmarks?; ([1-9]\d*) of (\w+) sightings? (?:was|were) not used\.$/,
      ({ step, map, closure }, landmarks, rejected, all) =>
        step > 0 &&
        closure === null &&
        counted(landmarks) === map.landmarks.length &&
        counted(all) === map.sightings &&
        Number(rejected) === map.rejected &&
        map.matched + map.founded + map.rejected === map.sightings,
    ],
    [
      /^The map has (\w+) landmarks?; (?:all (\d+) sightings were|(1|no) sightings? was) used\.$/,
      ({ step, map, closure }, landmarks, many, few) =>
        step > 0 &&
        closure === null &&
        counted(landmarks) === map.landmarks.length &&
        counted(many ?? few) === map.sightings &&
        map.rejected === 0 &&
        map.matched + map.founded === map.sightings,
    ],
    [
      pattern(
        /^(\d+) landmarks? (?:is a ghost|are ghosts), /,
        /founded though the map had (?:it|them) already/,
        /(?:; (\d+) sightings? (?:was|were) matched to the wrong landmark)?/,
        /(; the map is full and founds no more)?\.$/,
      ),
      ({ map }, spurious, wrong, full) =>
        Number(spurious) === map.spurious &&
        Number(wrong ?? 0) === map.wrong &&
        Boolean(full) === map.full &&
        new Set(map.landmarks.map(({ truth }) => truth)).size === map.landmarks.length - map.spurious,
    ],
    [
      /^(\d+) sightings? (?:was|were) matched to the wrong landmark(; the map is full and founds no more)?\.$/,
      ({ map }, wrong, full) => map.spurious === 0 && Number(wrong) === map.wrong && Boolean(full) === map.full,
    ],
    [/^The map is full and founds no more\.$/, ({ map }) => map.full && map.spurious === 0 && map.wrong === 0],
    [
      /^No landmark that was long out of sight has been recognized\.$/,
      ({ closure, lap }) => closure === null && lap > 0,
    ],
    [
      pattern(
        /^At step (\d+) landmark (\d+) was recognized again, /,
        /and the landmarks’ mean σ (shrank|grew) from ([\d.]+) to ([\d.]+) m\.$/,
      ),
      ({ closure }, step, landmark, how, before, after) =>
        closure.step === Number(step) &&
        closure.landmark + 1 === Number(landmark) &&
        before !== after &&
        prints(before, closure.before) &&
        prints(after, closure.after) &&
        (how === 'shrank') === closure.after < closure.before,
    ],
    [
      /^At step (\d+) landmark (\d+) was recognized again, and the landmarks’ mean σ hardly changed, ([\d.]+) m\.$/,
      ({ closure }, step, landmark, after) =>
        closure.step === Number(step) &&
        closure.landmark + 1 === Number(landmark) &&
        prints(after, closure.after) &&
        prints(after, closure.before),
    ],
    [
      pattern(
        /^Nothing was read of landmark (\d+): its row of the gain, ([\d.]+) m for a reading off by one σ, /,
        /moved it by ([\d.]+) m \(the arrows are 5 times as long\)\.$/,
      ),
      ({ closure, step, pulls, sightings, map }, landmark, reach, moved) => {
        const { id } = map.landmarks.find(({ truth }) => truth + 1 === Number(landmark))
        const pull = pulls.find((one) => one.id === id)
        const far = ({ from, to }) => Math.hypot(to[0] - from[0], to[1] - from[1])
        return (
          closure.step === step &&
          sightings.every((one) => one.landmark + 1 !== Number(landmark)) &&
          prints(reach, pull.reach) &&
          prints(moved, far(pull))
        )
      },
    ],
    [
      /^Its correlation with landmark (\d+), framed in the square, is still (−?[\d.]+)\.$/,
      ({ correlation, sightings, map, pulls }, landmark, value) => {
        const row = map.landmarks.findIndex(({ truth }) => truth + 1 === Number(landmark)) + 1
        const read = new Set(sightings.map((one) => one.landmark))
        const strongest = (unread) =>
          map.landmarks
            .map(({ truth }, i) => [truth, Math.abs(correlation[unread][i + 1])])
            .filter(([truth]) => read.has(truth))
            .reduce((one, other) => (other[1] > one[1] ? other : one))
        return (
          read.has(Number(landmark) - 1) &&
          pulls.some(({ id }) => {
            const at = map.landmarks.findIndex((one) => one.id === id) + 1
            const { truth } = map.landmarks[at - 1]
            return !read.has(truth) && prints(value, correlation[at][row]) && strongest(at)[0] === Number(landmark) - 1
          })
        )
      },
    ],
    [
      /^The mean NEES of the pose is ([\d.]+), where 3 is expected\.$/,
      ({ meanNees, neesBand }, mean) => prints(mean, meanNees) && meanNees <= neesBand[1],
    ],
    [
      pattern(
        /^The mean NEES of the pose is ([\d.]+)( × 10[⁰-⁹]+)?, where 3 is expected: /,
        /the filter claims far more than it knows\.$/,
      ),
      ({ meanNees, neesBand }, mean, large) =>
        (large !== undefined || prints(mean, meanNees)) && meanNees > neesBand[1],
    ],
  ],
)
