//! What the Probe shows.

use super::ProbeParams;
use super::ranks::ProbeRanks;
use crate::mapping::MapError;
use crate::shapes::{Innovation, InnovationCovariance};
use estimate::localizer::SensorKind;
use geom::Ellipse;
use lab::series::{Series, Track, Tracks};
use lab::{record, words};

record! {
    /// One picture of the Probe.
    pub struct ProbeFrame {
        /// Steps taken.
        pub step: u32,
        /// Whole laps driven.
        pub lap: u32,
        /// The parameters of the run.
        pub params: ProbeParams,
        /// The sensor in effect: range and bearing whenever the map is forgotten, since a range founds no landmark.
        pub sensor: SensorKind,
        /// Room A.
        pub room: RoomShape,
        /// The square's corners.
        pub square: [[f64; 2]; 4],
        /// Whether the next step moves.
        pub moving: bool,
        /// The true pose.
        pub truth: [f64; 3],
        /// The estimated pose.
        pub estimate: [f64; 3],
        /// Its covariance, by rows.
        #[name = "P"]
        pub p: [[f64; 3]; 3],
        /// The one-sigma ellipse of its position.
        pub ellipse: Ellipse,
        /// Truth less estimate, the heading the short way round.
        pub error: [f64; 3],
        /// All three landmarks, shown or not.
        pub landmarks: [ProbeLandmark; 3],
        /// This step's sightings.
        pub sightings: Vec<ProbeSighting>,
        /// The pair frozen at the present estimate.
        pub frozen: ProbeRanks,
        /// The pairs stacked along the steps really driven, on the true path.
        pub along_path: ProbeRanks,
        /// tr P of the pose and its parts, which have different units.
        pub trace: Traces,
        /// eᵀP⁻¹e of the pose; none where P is singular.
        pub nees: Option<f64>,
        /// νᵀS⁻¹ν of this step's accepted sightings together.
        pub nis: Option<f64>,
        /// Its degrees of freedom.
        pub nis_dof: u32,
        /// Means over the run.
        pub mean: Means,
        /// Where 95 % of single steps of a consistent filter lie, for 0 to 6 degrees of freedom; NaN for none.
        pub bands: [[f64; 2]; 7],
        /// The last steps.
        pub series: ProbeSeries,
        /// Where truth and estimate have been.
        pub tracks: Tracks,
        /// The map, when it had to be founded.
        pub slam: Option<ProbeMap>,
        /// The ghost, where one drives along.
        pub ghost: Option<Ghost>,
    }

    /// A copy of the robot that started elsewhere and drove the same ticks, and what it would have read without noise.
    pub struct Ghost {
        /// Its pose.
        pub pose: [f64; 3],
        /// Its last positions.
        pub track: Track,
        /// The farthest that it has been from the robot, metres.
        pub moved: f64,
        /// The largest difference of a range from the robot's so far, metres.
        pub range_gap: f64,
        /// The largest difference of a bearing so far, radians, where bearings are read.
        pub bearing_gap: Option<f64>,
        /// The three dials as a direction at the robot's present pose, scaled as the directions of a rank; none where
        /// all are at zero.
        pub by_hand: Option<[f64; 3]>,
        /// What both read of each landmark shown.
        pub readings: Vec<GhostReadings>,
    }

    /// What robot and ghost read of a landmark over the last steps, without noise; the steps are those of the series.
    #[derive(Default)]
    pub struct GhostReadings {
        /// The robot's ranges, metres.
        pub range: Series,
        /// The ghost's.
        pub ghost_range: Series,
        /// The robot's bearings, radians.
        pub bearing: Series,
        /// The ghost's.
        pub ghost_bearing: Series,
    }

    /// A rectangle with a corner at the origin.
    #[derive(Copy)]
    pub struct RoomShape {
        /// Metres.
        pub width: f64,
        /// Metres.
        pub height: f64,
    }

    /// A landmark of the room.
    #[derive(Copy)]
    pub struct ProbeLandmark {
        /// Metres.
        pub x: f64,
        /// Metres.
        pub y: f64,
        /// Whether the robot sees it.
        pub shown: bool,
    }

    /// One sighting.
    #[derive(Copy)]
    pub struct ProbeSighting {
        /// Which of the three landmarks was seen.
        pub landmark: usize,
        /// What was read.
        pub range: f64,
        /// What was read, if the sensor takes bearings.
        pub bearing: Option<f64>,
        /// ν at the prediction.
        pub innovation: Option<Innovation>,
        /// S at the prediction, by rows.
        #[name = "S"]
        pub s: Option<InnovationCovariance>,
        /// νᵀS⁻¹ν.
        pub chi2: Option<f64>,
        /// What became of it.
        pub outcome: Fate,
        /// Where the landmark it was taken for is believed to be: the end of the association line.
        pub to: Option<[f64; 2]>,
    }

    /// tr P and its parts, beside the reference: two range-only landmarks, no noise drawn.
    #[derive(Copy)]
    pub struct Traces {
        /// m² and rad² added, as the chapter's source does.
        pub total: f64,
        /// m².
        pub position: f64,
        /// rad².
        pub heading: f64,
        /// The reference's total.
        pub reference: f64,
        /// m².
        pub reference_position: f64,
        /// rad².
        pub reference_heading: f64,
    }

    /// Means over the run so far.
    #[derive(Copy)]
    pub struct Means {
        /// Expected 3.
        pub nees: Option<f64>,
        /// All νᵀS⁻¹ν over all their degrees of freedom: expected 1.
        pub nis_per_dof: Option<f64>,
    }

    /// Numbers over the last steps; NaN where there is none.
    #[derive(Default)]
    pub struct ProbeSeries {
        /// The step of each entry.
        pub step: Series,
        /// tr P.
        pub trace: Series,
        /// m².
        pub trace_position: Series,
        /// rad².
        pub trace_heading: Series,
        /// The reference's total.
        pub reference: Series,
        /// NEES.
        pub nees: Series,
        /// NIS.
        pub nis: Series,
        /// Its degrees of freedom.
        pub nis_dof: Series,
    }

    /// The map of a robot that had none.
    pub struct ProbeMap {
        /// Its landmarks, in the order in which they were founded.
        pub landmarks: Vec<MapLandmark>,
        /// Sightings so far.
        pub sightings: u32,
        /// Those that corrected the state.
        pub matched: u32,
        /// Those that founded a landmark.
        pub founded: u32,
        /// Those that were not used.
        pub rejected: u32,
        /// Of the matched, those matched to another landmark than the one seen.
        pub wrong: u32,
        /// Of the founded, those of a landmark that was in the map already.
        pub spurious: u32,
        /// Whether the map holds as many landmarks as it may; further sightings found none.
        pub full: bool,
        /// The landmark farthest from its true place.
        pub worst: Option<MapError>,
    }

    /// A landmark of the map.
    #[derive(Copy)]
    pub struct MapLandmark {
        /// Its number.
        pub id: u32,
        /// Where it is believed to be.
        pub x: f64,
        /// Where it is believed to be.
        pub y: f64,
        /// Its covariance, by rows.
        #[name = "P"]
        pub p: [[f64; 2]; 2],
        /// One sigma.
        pub ellipse: Ellipse,
        /// Which of the room's landmarks it was founded on.
        pub truth: usize,
        /// Metres from there.
        pub error: f64,
        /// The same in its own standard deviations.
        pub sigma: f64,
    }
}

words! {
    /// What became of a sighting in the Probe.
    pub enum Fate {
        /// Known map: it corrected the estimate.
        Accepted = "accepted",
        /// Forgotten map: it corrected estimate and map.
        Matched = "matched",
        /// It founded a landmark.
        Founded = "founded",
        /// It was not used.
        Rejected = "rejected",
    }
}
