//! What the museum shows.

use super::{Bug, MuseumParams};
use crate::ensemble::SEEDS;
use estimate::Landmark;
use geom::Ellipse;
use lab::record;
use lab::series::{Series, Tracks, WINDOW};

/// Readings that are kept: a filter that uses each twice takes up to two a step.
const READINGS: usize = 2 * WINDOW;

record! {
    /// One picture of a run. What follows from the drawn bugs is in the panels alone: the frame names them when the
    /// reader has committed to an answer.
    pub struct MuseumFrame {
        /// Steps taken: of the one run, or seeds.
        pub step: u32,
        /// Steps of the run that the panels show.
        pub driven: u32,
        /// Steps of a run; what is said of the run as a whole is said of these.
        pub steps: u32,
        /// Whole laps driven.
        pub lap: u32,
        /// The parameters of the run.
        pub params: MuseumParams,
        /// The landmarks.
        pub landmarks: &'static [Landmark],
        /// How far the sensor reaches, metres.
        pub reach: f64,
        /// The true pose.
        pub truth: [f64; 3],
        /// The estimated pose; the heading may be beyond ±π.
        pub estimate: [f64; 3],
        /// The one-sigma ellipse of its position, of the symmetric part of P; a negative eigenvalue is drawn as 0.
        pub ellipse: Ellipse,
        /// Truth less estimate, the heading the short way round.
        pub error: [f64; 3],
        /// Two standard deviations of each as claimed; 0 where P has a negative variance.
        pub two_sigma: [f64; 3],
        /// eᵀP⁻¹e; none where P is no covariance.
        pub nees: Option<f64>,
        /// Its mean over the run so far.
        pub mean_nees: Option<f64>,
        /// Where 95 % of single values of a right filter's NEES lie, about.
        pub nees_band: [f64; 2],
        /// χ² beyond which a right filter refuses a reading.
        pub gate: f64,
        /// The reading that the filter got at this step.
        pub sighting: Option<MuseumSighting>,
        /// The last steps.
        pub series: MuseumSeries,
        /// The last readings.
        pub readings: MuseumReadings,
        /// The autocorrelation of the used readings' normalized range innovations, at the lags 1, 2, …
        pub correlation_range: Vec<f64>,
        /// The same of their bearings.
        pub correlation_bearing: Vec<f64>,
        /// Where 95 % of each lie for a white series, to either side of 0; none before the first reading.
        pub correlation_band: Option<f64>,
        /// The figures of the panels with the bands of a right filter, in the order of the symptom table. The bands
        /// hold for a whole run.
        pub figures: Vec<MuseumFigure>,
        /// How many seeds the shares of the figures are of.
        pub seeds: u32,
        /// Which bugs the lot had drawn, when the reader has committed.
        pub answer: Option<MuseumAnswer>,
        /// Where truth and estimate have been.
        pub tracks: Tracks,
    }

    /// A reading.
    #[derive(Copy)]
    pub struct MuseumSighting {
        /// The landmark's number.
        pub landmark: u32,
        /// What was read, metres.
        pub range: f64,
        /// What was read, radians, from the landmark.
        pub bearing: f64,
        /// Whether it corrected the estimate.
        pub used: bool,
    }

    /// A panel in one number.
    pub struct MuseumFigure {
        /// Its value; none where there is nothing to compute it from.
        pub value: Option<f64>,
        /// Where 95 % of a right filter's runs lie.
        pub band: [f64; 2],
        /// Where 99 % of them lie.
        pub wide_band: [f64; 2],
        /// The shares of the seeds' runs below and above the 95 % band, where the figure is no number above it.
        pub beyond: [f64; 2],
        /// Where the value stands on the figure's scale, from 0 to 3, on which the 95 % band is the middle third; at 3
        /// where there is no value.
        pub place: f64,
        /// Where the 99 % band ends on that scale.
        pub wide_place: [f64; 2],
        /// How many of the seeds' runs lie in each part of that scale; the parts are of one width.
        pub counts: Vec<u32>,
        /// The figure of each seed's run, in the order of the seeds; NaN where there is nothing to compute it from.
        pub runs: Series<{ SEEDS as usize }>,
    }

    /// The answer to a round of diagnosis.
    #[derive(Copy)]
    pub struct MuseumAnswer {
        /// The bug.
        pub bug: Bug,
        /// The other one of two.
        pub second: Bug,
        /// Whether the reader has named it, or both.
        pub right: bool,
    }

    /// The last steps, the start first.
    #[derive(Default)]
    pub struct MuseumSeries {
        /// Step.
        pub step: Series,
        /// Truth less estimate, metres.
        pub x: Series,
        /// Metres.
        pub y: Series,
        /// Radians, the short way round.
        pub theta: Series,
        /// Two standard deviations as claimed, metres.
        pub two_sigma_x: Series,
        /// Metres.
        pub two_sigma_y: Series,
        /// Radians.
        pub two_sigma_theta: Series,
        /// eᵀP⁻¹e; NaN where P is no covariance.
        pub nees: Series,
        /// The smallest eigenvalue of P with each state in its own standard deviation.
        pub least: Series,
        /// The largest |Pᵢⱼ − Pⱼᵢ|, as a part of the largest entry.
        pub asymmetry: Series,
    }

    /// The last readings.
    #[derive(Default)]
    pub struct MuseumReadings {
        /// Step.
        pub step: Series<READINGS>,
        /// νᵀS⁻¹ν; NaN where S is no covariance.
        pub nis: Series<READINGS>,
        /// The range's innovation in its own standard deviations.
        pub range: Series<READINGS>,
        /// The bearing's.
        pub bearing: Series<READINGS>,
        /// 1 where the reading was used, 0 where it was refused.
        pub used: Series<READINGS>,
    }
}
