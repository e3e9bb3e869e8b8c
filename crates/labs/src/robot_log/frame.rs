//! What the figure on a robot's log shows.

use super::LogParams;
use super::seen::LogSensor;
use estimate::Landmark;
use estimate::drive::{Line, Summary};
use geom::Ellipse;
use lab::series::Track;
use lab::{record, words};

words! {
    /// What became of a fix.
    pub enum FixOutcome {
        /// It corrected the estimate.
        Used = "used",
        /// It lay beyond the gate.
        Refused = "refused",
        /// It was withheld from the estimate.
        Withheld = "withheld",
        /// It was passed over, or fixes are off.
        Unused = "unused",
    }
}

record! {
    /// A sighting that the filter looked at.
    #[derive(Copy)]
    pub struct LogSighting {
        /// When, seconds since the log's first row.
        pub time: f64,
        /// The id of the landmark.
        pub landmark: u32,
        /// Where the landmark stands, metres.
        pub at: [f64; 2],
        /// Where the estimate was, metres.
        pub from: [f64; 2],
        /// Whether it corrected the estimate.
        pub used: bool,
    }

    /// Where the robot was, where its odometry alone says it was, and where the filter believes it was, up to now.
    #[derive(Default)]
    pub struct LogTracks {
        /// True positions; empty without a truth.
        pub truth: Track,
        /// Dead reckoning.
        pub reckoning: Track,
        /// The estimate.
        pub estimate: Track,
    }

    /// How many rows are taken by when: by this a reader goes to a time.
    #[derive(Default)]
    pub struct LogTimeline {
        /// Seconds since the log's first row, from the first to the last.
        pub time: Vec<f64>,
        /// Rows of motion and sightings up to then.
        pub step: Vec<u32>,
    }

    /// Fixes: every so many readings.
    #[derive(Default)]
    pub struct LogFixes {
        /// When they were measured, seconds since the log's first row.
        pub time: Vec<f64>,
        /// Metres.
        pub x: Vec<f64>,
        /// Metres.
        pub y: Vec<f64>,
        /// What became of it: `used`, `refused` beyond the gate, `withheld`, or `unused` of one that was passed over or
        /// switched off.
        pub outcome: Vec<FixOutcome>,
    }

    /// What the filter made of fixes: every so many of those that it looked at.
    #[derive(Default)]
    pub struct LogFixInnovations {
        /// When they were measured, seconds since the log's first row.
        pub time: Vec<f64>,
        /// Where the estimate was after it, metres.
        pub x: Vec<f64>,
        /// Metres.
        pub y: Vec<f64>,
        /// ν/√S along the estimated heading.
        pub along: Vec<f64>,
        /// ν/√S across it, to the left.
        pub across: Vec<f64>,
        /// Whether it was used.
        pub used: Vec<bool>,
    }

    /// The best track afterwards, in the light of all readings: every so many rows of motion.
    #[derive(Default)]
    pub struct LogSmoothed {
        /// Seconds since the log's first row.
        pub time: Vec<f64>,
        /// Metres.
        pub x: Vec<f64>,
        /// Metres.
        pub y: Vec<f64>,
        /// Twice the claimed σ of the position, metres.
        pub bound: Vec<f64>,
    }

    /// What ranges read, against what they should read: every so many of them.
    #[derive(Default)]
    pub struct LogRanges {
        /// Seconds since the log's first row.
        pub time: Vec<f64>,
        /// The range from the true position; without a truth from the dead-reckoned one. Metres.
        pub range: Vec<f64>,
        /// The range that was read, less that range. Metres.
        pub residual: Vec<f64>,
    }

    /// What the filter made of readings: every so many of them.
    #[derive(Default)]
    pub struct LogInnovations {
        /// Seconds since the log's first row.
        pub time: Vec<f64>,
        /// ν/√S of the first number: a range, the x of a fix, a heading.
        pub normalized: Vec<f64>,
        /// What the filter expected, metres; of a heading radians.
        pub expected: Vec<f64>,
        /// ν, what was read less what was expected.
        pub innovation: Vec<f64>,
        /// Whether the reading was used.
        pub used: Vec<bool>,
        /// Which sensor it is of.
        pub sensor: Vec<LogSensor>,
        /// The id of its landmark; null of a fix and a heading.
        pub landmark: Vec<Option<u32>>,
        /// ν of the bearing, radians; null of a reading without one.
        pub bearing: Vec<Option<f64>>,
        /// ν/√S of the bearing.
        pub second: Vec<Option<f64>>,
        /// Where the estimate was after it, metres.
        pub x: Vec<f64>,
        /// Metres.
        pub y: Vec<f64>,
    }
    /// The error of the position against what the filter claims.
    #[derive(Default)]
    pub struct LogErrors {
        /// Seconds since the log's first row.
        pub time: Vec<f64>,
        /// The distance between estimate and truth, metres; empty without a truth.
        pub error: Vec<f64>,
        /// Twice the claimed σ of the position, metres.
        pub bound: Vec<f64>,
    }

    /// The normalized innovations squared, averaged over blocks of used readings.
    #[derive(Default)]
    pub struct LogNis {
        /// How many used readings a block has.
        pub block: u32,
        /// When each block ended, seconds since the log's first row.
        pub time: Vec<f64>,
        /// The mean of νᵀS⁻¹ν for each output: 1 is expected.
        pub mean: Vec<f64>,
        /// The lower end of the band that holds 95 of 100 such means.
        pub low: Vec<f64>,
        /// The upper end.
        pub high: Vec<f64>,
    }

    /// How the normalized innovations of the used readings are distributed.
    #[derive(Default)]
    pub struct LogHistogram {
        /// Where the first bin begins, in σ.
        pub from: f64,
        /// How wide a bin is, in σ.
        pub width: f64,
        /// The density in each bin; what lies beyond the ends is in none.
        pub density: Vec<f64>,
        /// The share that lies beyond the ends.
        pub beyond: f64,
        /// The density of N(0, 1) at the ends and the middle of each bin.
        pub normal: Vec<f64>,
    }

    /// The autocorrelation of the normalized innovations, from one used reading to later ones.
    #[derive(Default)]
    pub struct LogCorrelation {
        /// At the lags 1, 2, …; empty while there are too few readings.
        pub values: Vec<f64>,
        /// The half-width of the band that holds 95 of 100 values of a white series.
        pub band: f64,
    }

    /// What the filter made of the readings of one landmark: one that is displaced or taken for another stands out.
    pub struct LogLandmark {
        /// The id of the landmark.
        pub id: u32,
        /// Readings of it that corrected the estimate.
        pub used: u32,
        /// Readings of it that did not.
        pub refused: u32,
        /// The mean innovation ν of all of them, metres; null without a reading.
        pub mean_innovation: Option<f64>,
    }

    /// Whether the used readings of one landmark are what the model claims.
    pub struct LogLandmarkStatistics {
        /// Mean of d²/p over the used ones: 1 is expected.
        pub nis: Option<f64>,
        /// Mean of ν/√S of the range over the used ones: 0 is expected.
        pub mean: Option<f64>,
        /// Its autocorrelation from one used reading of this landmark to the next: 0 is expected.
        pub lag1: Option<f64>,
        /// Mean ν of the bearing over the used ones, radians: 0 is expected.
        pub mean_bearing: Option<f64>,
    }

    /// How far the statistics of a filter whose model holds stay from what is expected, in 95 of 100 runs of this
    /// length.
    #[derive(Copy)]
    pub struct LogBands {
        /// Of the NIS for each output: from, to.
        pub nis: [f64; 2],
        /// Of the mean of ν/√S, either side of 0.
        pub mean: f64,
    }

    /// A robot's log, replayed up to a row.
    pub struct LogFrame {
        /// Rows of motion and sightings that were taken.
        pub step: u32,
        /// The parameters.
        pub params: LogParams,
        /// Rows of motion and sightings in the log.
        pub rows: u32,
        /// Seconds since the log's first row.
        pub time: f64,
        /// From the log's first row to its last, seconds.
        pub duration: f64,
        /// Rows over time, of the whole log.
        pub timeline: LogTimeline,
        /// The landmarks.
        pub landmarks: Vec<Landmark>,
        /// Whether the log has bearings.
        pub bearings: bool,
        /// Whether the log says where the robot really was.
        pub has_truth: bool,
        /// Where the robot is, metres; null without a truth.
        pub truth: Option<[f64; 2]>,
        /// Where its odometry alone says it is: metres, metres, radians.
        pub reckoning: [f64; 3],
        /// The estimated pose: metres, metres, radians.
        pub estimate: [f64; 3],
        /// P of the pose, by rows.
        #[name = "P"]
        pub p: [[f64; 3]; 3],
        /// The one-sigma ellipse of the estimated position.
        pub ellipse: Ellipse,
        /// The sighting that was looked at last.
        pub sighting: Option<LogSighting>,
        /// Where it has been.
        pub tracks: LogTracks,
        /// Every how many readings one is among `ranges` and `fixes`.
        pub every: u32,
        /// The same of the readings that are looked at, which may be fewer: among `innovations` and `fixInnovations`.
        pub every_looked: u32,
        /// What ranges read.
        pub ranges: LogRanges,
        /// The line through (range, residual) of all ranges.
        pub range_line: Option<Line>,
        /// What the filter made of them.
        pub innovations: LogInnovations,
        /// Fixes of the position.
        pub fixes: LogFixes,
        /// What the filter made of them.
        pub fix_innovations: LogFixInnovations,
        /// The smoothed track; null until smooth() was called for the rows that are taken.
        pub smoothed: Option<LogSmoothed>,
        /// The line through (expected range, ν) of all used ranges.
        pub innovation_line: Option<Line>,
        /// Error and claim.
        pub errors: LogErrors,
        /// NIS over time.
        pub nis: LogNis,
        /// The distribution of ν/√S.
        pub histogram: LogHistogram,
        /// Its autocorrelation.
        pub correlation: LogCorrelation,
        /// The readings of each landmark; empty while no reading has been looked at.
        pub by_landmark: Vec<LogLandmark>,
        /// Their statistics, in the same order.
        pub landmark_statistics: Vec<LogLandmarkStatistics>,
        /// Mean ν of the bearing over all used sightings, radians; a turned camera shows here. Null without a bearing.
        pub mean_bearing: Option<f64>,
        /// The summary so far.
        pub summary: Summary,
        /// How far its statistics may stray; null without a used sighting.
        pub bands: Option<LogBands>,
        /// The RMS error of dead reckoning so far, metres.
        pub reckoned_rmse: Option<f64>,
    }
}
