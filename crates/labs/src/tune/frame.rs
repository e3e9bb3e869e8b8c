//! What the tuning shows.

use super::TuneParams;
use geom::Ellipse;
use lab::record;

record! {
    /// A log filtered with the noise levels that the reader has chosen. Every list over the log has an entry for each
    /// reading.
    pub struct TuneFrame {
        /// The parameters.
        pub params: TuneParams,
        /// ν, metres.
        pub innovations: Vec<f64>,
        /// 2√S, metres: of a filter with the right noise 95.4 % of the innovations lie within.
        pub two_sigma: Vec<f64>,
        /// The part of the innovations that lie beyond 2√S; 0.0455 is expected.
        pub beyond: f64,
        /// The autocorrelation Σ e(k) e(k+l) / Σ e(k)² of the normalized innovations e = ν/√S, at the lags l = 1, 2, …;
        /// 0 is expected.
        pub autocorrelation: Vec<f64>,
        /// Where 95 % of each of them lie, to either side of 0: 1.96/√N.
        pub autocorrelation_band: f64,
        /// NIS, νᵀS⁻¹ν; 1 is expected.
        pub nis: Vec<f64>,
        /// The mean of NIS up to each reading.
        pub mean_nis: Vec<f64>,
        /// Where 95 % of the means of NIS lie, at some of the readings and at the last.
        pub mean_nis_band: Vec<TuneBand>,
        /// The log-likelihood at the chosen noise levels.
        pub log_likelihood: f64,
        /// The likeliest noise levels, when they are looked for or the reader has committed.
        pub fit: Option<TuneFit>,
        /// The truth, when the reader has committed.
        pub verdict: Option<TuneVerdict>,
    }

    /// Where 95 % of the means of so many NIS lie: χ² of as many degrees of freedom, over their number.
    #[derive(Copy)]
    pub struct TuneBand {
        /// How many NIS the mean is of.
        pub readings: u32,
        /// 2.5 % lie below.
        pub low: f64,
        /// 2.5 % lie above.
        pub high: f64,
    }

    /// The noise levels under which the log is likeliest, and what this log can tell of them.
    #[derive(Copy)]
    pub struct TuneFit {
        /// Decimal logarithm of q.
        pub log_q: f64,
        /// Decimal logarithm of W in m².
        pub log_w: f64,
        /// The log-likelihood there, the greatest within the limits.
        pub log_likelihood: f64,
        /// Whether each was held by the end of its range: the log is likelier still beyond it.
        pub held: [bool; 2],
        /// The standard deviations of log q and log W by the Fisher information there; none where one is held.
        pub sigma: Option<[f64; 2]>,
        /// The ellipse about the fit that holds the true (log q, log W) in 95 of 100 long logs, by the Fisher
        /// information; none where one is held. Its long axis is what this log tells least.
        pub region: Option<Ellipse>,
        /// Twice the log-likelihood that the chosen noise levels lack. In 95 of 100 long logs the true ones lack less
        /// than `limit`.
        pub lacking: f64,
        /// The 95 % quantile of χ² with 2 degrees of freedom.
        pub limit: f64,
    }

    /// The truth behind the log.
    pub struct TuneVerdict {
        /// Decimal logarithm of the true q.
        pub log_q: f64,
        /// Decimal logarithm of the true W in m².
        pub log_w: f64,
        /// The log-likelihood at the truth.
        pub log_likelihood: f64,
        /// Twice the log-likelihood that the truth lacks; see the fit's `limit`.
        pub lacking: f64,
        /// NEES, eᵀP⁻¹e of the chosen filter's two states; 2 is expected.
        pub nees: Vec<f64>,
        /// Its mean. Neighbouring errors are alike, so it scatters more than that of as many independent values.
        pub mean_nees: f64,
        /// Where 95 % of single values of a consistent filter's NEES lie.
        pub nees_band: [f64; 2],
    }
}
