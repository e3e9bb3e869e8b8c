import { check, estimate, number, prints, pattern } from './claims.mjs'

/** A noise level as it is printed: two digits. */
const level = (text, log) => Math.abs(number(text) / 10 ** log - 1) < 0.051
const times = (text, logs) =>
  Math.abs(number(text) / 10 ** Math.abs(logs) - 1) < 0.006 ||
  (Math.abs(logs) >= 1 && Math.abs(number(text) - 10 ** Math.abs(logs)) <= 0.51)
/**
 * The logarithm of q/W over that of the likeliest noise: a log of 200 readings tells its sign where the autocorrelation
 * leaves its band, a shorter one not always.
 */
const ratio = ({ params: { logQ, logW, ...others } }) => {
  const lab = estimate.Tune.from({
    version: 1,
    lab: 'tune',
    step: 0,
    params: { ...others, logQ, logW, fit: true, committed: false },
  })
  const { fit } = lab.frame()
  lab.free()
  return logQ - logW - (fit.logQ - fit.logW)
}
const lastOf = ({ meanNis, meanNisBand }) => ({ mean: meanNis.at(-1), ...meanNisBand.at(-1) })
check(
  'tune',
  {
    logQ: [-2, -0.6, -0.1, 0.74, 2],
    logW: [-2, -0.86, 0.04, 0.42, 2],
    seed: [1, 2, 5],
    length: [20, 50, 200],
    fit: [false, true],
    committed: [false, true],
  },
  [0],
  () => {
    const nis = (frame, mean, low, high) =>
      [
        [mean, lastOf(frame).mean],
        [low, lastOf(frame).low],
        [high, lastOf(frame).high],
      ].every(([text, value]) => prints(text, value))
    const lag = ({ autocorrelation: [first], autocorrelationBand }, printed, band) =>
      prints(printed, first) && prints(band, autocorrelationBand)
    return [
      [
        pattern(
          /^The mean NIS is ([\d.]+), above its band from ([\d.]+) to ([\d.]+): /,
          /the innovations are larger than the filter expects, so its noise as a whole is too small\.$/,
        ),
        (frame, ...said) => !frame.verdict && nis(frame, ...said) && lastOf(frame).mean > lastOf(frame).high,
      ],
      [
        pattern(
          /^The mean NIS is ([\d.]+), below its band from ([\d.]+) to ([\d.]+): /,
          /the innovations are smaller than the filter expects, so its noise as a whole is too large\.$/,
        ),
        (frame, ...said) => !frame.verdict && nis(frame, ...said) && lastOf(frame).mean < lastOf(frame).low,
      ],
      [
        /^The mean NIS is ([\d.]+), above its band from ([\d.]+) to ([\d.]+)\.$/,
        (frame, ...said) => frame.verdict && nis(frame, ...said) && lastOf(frame).mean > lastOf(frame).high,
      ],
      [
        /^The mean NIS is ([\d.]+), below its band from ([\d.]+) to ([\d.]+)\.$/,
        (frame, ...said) => frame.verdict && nis(frame, ...said) && lastOf(frame).mean < lastOf(frame).low,
      ],
      [
        /^The mean NIS is ([\d.]+), within its band from ([\d.]+) to ([\d.]+)\.$/,
        (frame, ...said) =>
          nis(frame, ...said) && lastOf(frame).mean >= lastOf(frame).low && lastOf(frame).mean <= lastOf(frame).high,
      ],
      [
        pattern(
          /^Neighbouring innovations tend to the same side \(([\d.]+), beyond ±([\d.]+)\): /,
          /the filter trusts its motion too much, a sign of too small a q\/W\.$/,
        ),
        (frame, first, band) =>
          lag(frame, first, band) &&
          (frame.params.length < 200 || ratio(frame) < 0) &&
          frame.autocorrelation[0] > frame.autocorrelationBand,
      ],
      [
        pattern(
          /^Neighbouring innovations tend to opposite sides \(([\u2212\d.]+), beyond ±([\d.]+)\): /,
          /the filter trusts its sensor too much, a sign of too large a q\/W\.$/,
        ),
        (frame, first, band) =>
          lag(frame, first, band) &&
          (frame.params.length < 200 || ratio(frame) > 0) &&
          frame.autocorrelation[0] < -frame.autocorrelationBand,
      ],
      [
        /^Neighbouring innovations are uncorrelated, within ±([\d.]+)\.$/,
        ({ autocorrelation: [first], autocorrelationBand }, band) =>
          prints(band, autocorrelationBand) && Math.abs(first) <= autocorrelationBand,
      ],
      [
        pattern(
          /^The log-likelihood is ([\d.]+)( × 10⁴)? below its maximum, (inside|outside) the 95 % region, /,
          /which ends at ([\d.]+)\.$/,
        ),
        ({ fit, logLikelihood }, lacking, large, where, limit) =>
          prints(lacking, (fit.logLikelihood - logLikelihood) / (large ? 1e4 : 1)) &&
          prints(limit, fit.limit / 2) &&
          (where === 'inside') === fit.lacking <= fit.limit,
      ],
      [/^The likeliest noise lies at the end of a range, and may lie beyond\.$/, ({ fit }) => fit.held.includes(true)],
      [/^The truth is still sealed\.$/, ({ params, verdict }) => verdict === null && !params.committed],
      [
        pattern(
          /^The true q is ([\d.]+) and the true sensor noise ([\d.]+) m²: /,
          /yours are off by the factors ([\d.]+) and ([\d.]+)\.$/,
        ),
        ({ params, verdict }, q, w, offQ, offW) =>
          params.committed &&
          level(q, verdict.logQ) &&
          level(w, verdict.logW) &&
          times(offQ, params.logQ - verdict.logQ) &&
          times(offW, params.logW - verdict.logW),
      ],
      [
        /^By its likelihood this log tells them to factors of ([\d.]+) and ([\d.]+) \(one σ\)\.$/,
        ({ fit }, q, w) => fit.sigma && times(q, fit.sigma[0]) && times(w, fit.sigma[1]),
      ],
      [
        /^How well this log tells them cannot be said at the end of a range\.$/,
        ({ fit }) => fit.sigma === null && fit.held.includes(true),
      ],
      [
        /^The mean NEES of your filter is ([\d.]+); 2 is expected\.$/,
        ({ verdict }, mean) => prints(mean, verdict.meanNees),
      ],
    ]
  },
)
