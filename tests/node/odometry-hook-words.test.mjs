import { check, number, prints } from './claims.mjs'

check(
  'odometry-hook',
  {
    bias: [0, 0.0005, 0.005, 0.01],
    slip: [0, 0.001, 0.005],
    fixes: [false, true],
    learn: [false, true],
    seed: [1, 3],
  },
  [0, 1, 5, 40, 160, 186, 640, 1300],
  () => {
    const off = (frame, words, kind) => {
      const value = kind === 'heading' ? Math.abs(frame.error.heading * 180) / Math.PI : frame.error.position
      const ratio = frame.ratio[kind]
      const [, printed, rest] = words.match(/^off by ([\d.]+)(?: m|°), (.*)$/) ?? []
      if (!printed || !prints(printed, value)) return false
      if (rest === 'and the filter claims no error at all') return ratio === null
      if (rest === 'about the σ it claims') return ratio > 0.94 && ratio < 1.06
      if (rest === 'within the σ it claims') return ratio < 1
      const [, times] = rest.match(/^([\d.]+) times the σ it claims$/) ?? []
      return times !== undefined && ratio > 1 && prints(times, ratio)
    }
    return [
      [
        /^At the start the pose is known exactly\.$/,
        ({ step, error, sigma }) => step === 0 && error.position === 0 && sigma.position === 0,
      ],
      [
        /^Dead reckoning: the position is (off [^:]*)(: the error has outrun the ellipse)?\.$/,
        (frame, words, outrun) =>
          !frame.params.fixes &&
          off(frame, words, 'position') &&
          (outrun === undefined ||
            (frame.error.position > 0.005 && (frame.ratio.position === null || frame.ratio.position > 2))),
      ],
      [
        /^No corner seen yet: the position is (off .*)\.$/,
        (frame, words) => frame.params.fixes && frame.lastSighting === null && off(frame, words, 'position'),
      ],
      [
        /^With fixes, the position is (off .*)\.$/,
        (frame, words) => frame.params.fixes && frame.lastSighting !== null && off(frame, words, 'position'),
      ],
      [/^The heading is (off .*)\.$/, (frame, words) => off(frame, words, 'heading')],
      [
        /^No reading is used, so the bias stays at ([−\d.]+) %, with a σ of ([\d.]+) %\.$/,
        ({ params, wheel }, bias, sigma) =>
          params.learn && !params.fixes && wheel.rank === 0 && number(bias) === 0 && prints(sigma, 100 * wheel.sigma),
      ],
      [
        /^No reading yet: the bias is taken as ([−\d.]+) %, with a σ of ([\d.]+) %\.$/,
        ({ params, step, wheel }, bias, sigma) =>
          params.learn &&
          params.fixes &&
          step === 0 &&
          wheel.rank === 0 &&
          number(bias) === 0 &&
          prints(sigma, 100 * wheel.sigma),
      ],
      [
        /^The readings so far fix (\d) of 4 numbers \(their rank\): they do not tell the bias from the pose\.$/,
        ({ params, step, wheel }, rank) =>
          params.learn && params.fixes && step < 186 && Number(rank) === wheel.rank && wheel.rank < 4,
      ],
      [
        /^The bias is learned as ([−\d.]+) %, with a σ of ([\d.]+) %; in truth it is ([\d.]+) %\.$/,
        ({ params, wheel }, bias, sigma, truth) =>
          params.learn &&
          params.fixes &&
          wheel.rank === 4 &&
          // What is learned and what is true are said in the words of the slider, as parts of the true radius.
          prints(truth, 100 * params.bias) &&
          prints(truth, 100 * (1 / (1 - wheel.truth) - 1)) &&
          prints(bias, 100 * (1 / (1 - wheel.epsilon) - 1)) &&
          prints(sigma, (100 * wheel.sigma) / (1 - wheel.epsilon) ** 2),
      ],
    ]
  },
)
