//! From the state of the museum to its frame.

use super::figures::LAGS;
use super::frame::{MuseumAnswer, MuseumFigure, MuseumFrame, MuseumSighting};
use super::{Bug, BugMuseum, Compared, bands, bugs, scale};
use crate::shapes::{POSE_BAND, ellipse_of};
use filters::Autocorrelation;
use sim::scenarios::BUG_MUSEUM;

pub(super) fn frame(lab: &BugMuseum) -> MuseumFrame {
    let Compared { error, two_sigma, nees, .. } = lab.compared;
    let position = lab.filter.p.fixed_view::<2, 2>(0, 0).into_owned();
    let lags = |sums: &Autocorrelation<LAGS>| (1..=LAGS).map_while(|lag| sums.at(lag)).collect();
    let shares = lab.seeds.shares();
    let figure = |(i, value): (usize, f64)| {
        let [least, low, high, greatest] = bands::BANDS[i];
        MuseumFigure {
            value: Some(value).filter(|value| value.is_finite()),
            band: [low, high],
            wide_band: [least, greatest],
            beyond: shares[i],
            place: scale::place(i, value),
            wide_place: [least, greatest].map(|end| scale::place(i, end)),
            counts: lab.seeds.counts[i].to_vec(),
            runs: lab.seeds.runs[i].clone(),
        }
    };
    MuseumFrame {
        step: lab.step,
        driven: lab.driven,
        steps: BUG_MUSEUM.steps,
        lap: lab.driven / BUG_MUSEUM.course.lap(),
        params: lab.params,
        landmarks: &BUG_MUSEUM.landmarks,
        reach: BUG_MUSEUM.sensor.reach,
        truth: lab.truth.to_vector().into(),
        estimate: lab.filter.x.into(),
        ellipse: ellipse_of(&filters::covariance::symmetric(position)),
        error: error.into(),
        two_sigma,
        nees,
        mean_nees: lab.sums.mean_nees(),
        nees_band: *POSE_BAND,
        gate: BUG_MUSEUM.gate,
        sighting: lab.last.first().map(|(seen, outcome)| MuseumSighting {
            landmark: seen.landmark,
            range: seen.range,
            bearing: seen.bearing,
            used: outcome.used,
        }),
        series: lab.series.clone(),
        readings: lab.seen.clone(),
        correlation_range: lags(&lab.sums.range),
        correlation_bearing: lags(&lab.sums.bearing),
        correlation_band: lab.sums.range.band(),
        figures: lab.figures().into_iter().enumerate().map(figure).collect(),
        seeds: lab.seeds.count,
        answer: answer(lab),
        tracks: lab.tracks.outlined(),
    }
}

/// Two bugs are named in either order.
fn answer(lab: &BugMuseum) -> Option<MuseumAnswer> {
    let params = &lab.params;
    let [bug, second] = bugs(params);
    let named = [params.guess, if params.pair { params.second_guess } else { Bug::None }];
    let right = named == [bug, second] || named == [second, bug];
    (params.lot != 0 && params.committed).then_some(MuseumAnswer { bug, second, right })
}
