//! From the Probe's state to its frame.

use super::frame::{Fate, MapLandmark, Means, ProbeFrame, ProbeLandmark, ProbeMap, ProbeSighting, RoomShape, Traces};
use super::ranks::{ProbeRanks, frozen_ranks, stacked_ranks};
use super::{Estimator, ObservabilityProbe};
use crate::mapping::{Mapping, Seen, Tally};
use crate::shapes::{ellipse_of, innovation, rows};
use crate::true_path::parts;
use estimate::slam::Outcome;
use sim::scenarios::PROBE;

pub(super) fn frame(probe: &ObservabilityProbe) -> ProbeFrame {
    let (pose, p) = probe.estimator.belief();
    let shown = probe.shown.len();
    let landmark = |i: usize| {
        let [x, y] = probe.params.landmarks[i];
        ProbeLandmark { x, y, shown: i < shown }
    };
    let [position, heading] = parts(&p);
    let [reference_position, reference_heading] = probe.reference.parts();
    let mean = |sum: f64, n: u32| (n > 0).then(|| sum / f64::from(n));
    let [frozen, along_path] = both_ranks(probe);
    ProbeFrame {
        step: probe.step,
        lap: probe.driven / PROBE.course.lap(),
        params: probe.params,
        sensor: probe.params.sight(),
        room: RoomShape { width: PROBE.room, height: PROBE.room },
        square: PROBE.course.corners(),
        moving: probe.moving(),
        truth: probe.truth.to_vector().into(),
        estimate: pose.to_vector().into(),
        p: rows(&p),
        ellipse: ellipse_of(&p.fixed_view::<2, 2>(0, 0).into_owned()),
        error: probe.truth.boxminus(pose).into(),
        landmarks: [0, 1, 2].map(landmark),
        sightings: probe.sightings.clone(),
        frozen,
        along_path,
        trace: Traces {
            total: p.trace(),
            position,
            heading,
            reference: probe.reference.trace(),
            reference_position,
            reference_heading,
        },
        nees: probe.nees,
        nis: probe.nis.map(|(nis, _)| nis),
        nis_dof: probe.nis.map_or(0, |(_, dof)| dof),
        mean: Means { nees: probe.mean_nees(), nis_per_dof: mean(probe.sums.nis, probe.sums.nis_dof) },
        bands: BANDS,
        series: probe.series.clone(),
        tracks: probe.tracks.outlined(),
        slam: match &probe.estimator {
            Estimator::Localizer(_) => None,
            Estimator::Mapper(mapping) => Some(map_shape(mapping)),
        },
        ghost: probe.haunting.as_ref().map(|ghost| ghost.frame(probe.truth, probe.params.sight())),
    }
}

/// Where 95 % of single draws of χ² lie, for 0 to 6 degrees of freedom: three landmarks read twice. A table, which a
/// test holds to `chi2_interval` bit by bit: the quantiles' functions would be a fortieth of all that a reader of the
/// figures fetches.
pub(super) const BANDS: [[f64; 2]; 7] = [
    [f64::NAN; 2],
    [0.0009820691171752583, 5.023886187314889],
    [0.05063561596857977, 7.377758907714865],
    [0.21579528262389827, 9.348403604496138],
    [0.4844185570879301, 11.143286781877789],
    [0.831211613486664, 12.83250199341188],
    [1.2373442457912047, 14.449375335447915],
];

/// Frozen at the present estimate, after the update, and along the true path. On finite poses both are found; otherwise
/// an empty one is shown.
fn both_ranks(probe: &ObservabilityProbe) -> [ProbeRanks; 2] {
    let sight = probe.params.sight();
    let mapped = matches!(probe.estimator, Estimator::Mapper(_));
    let tolerance = probe.params.tolerance;
    let frozen = frozen_ranks(&probe.believed(), sight, mapped, tolerance);
    let along_path = stacked_ranks(probe.moments.iter(), sight, mapped, tolerance);
    [frozen, along_path].map(|ranks| ranks.unwrap_or_default())
}

pub(crate) fn map_shape(mapping: &Mapping) -> ProbeMap {
    let errors = mapping.errors();
    let Tally { sightings, matched, founded, rejected, wrong, spurious } = mapping.tally;
    let landmarks = mapping.slam.landmarks().zip(&mapping.truth).zip(&errors);
    ProbeMap {
        landmarks: landmarks
            .map(|((mapped, &truth), e)| MapLandmark {
                id: mapped.id,
                x: mapped.position[0],
                y: mapped.position[1],
                p: rows(&mapped.p),
                ellipse: ellipse_of(&mapped.p),
                truth,
                error: e.error,
                sigma: e.sigma,
            })
            .collect(),
        sightings,
        matched,
        founded,
        rejected,
        wrong,
        spurious,
        full: mapping.is_full(),
        worst: mapping.worst(),
    }
}

/// A sighting of a robot without a map, after the step that used it.
pub(crate) fn mapped_sighting(seen: &Seen, mapping: &Mapping) -> ProbeSighting {
    let evidence = seen.report.evidence;
    let place = mapping.slam.landmarks().find(|l| Some(l.id) == seen.report.landmark);
    ProbeSighting {
        landmark: seen.truth,
        range: seen.range,
        bearing: Some(seen.bearing),
        innovation: evidence.map(|(nu, s, _)| innovation(&nu, &s).0),
        s: evidence.map(|(nu, s, _)| innovation(&nu, &s).1),
        chi2: evidence.map(|(.., chi2)| chi2),
        outcome: match seen.report.outcome {
            Outcome::Matched => Fate::Matched,
            Outcome::Founded => Fate::Founded,
            Outcome::Rejected => Fate::Rejected,
        },
        to: place.map(|l| l.position.into()),
    }
}
