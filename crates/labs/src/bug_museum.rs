//! A museum of bugs: a robot on a stadium, and a filter that is right but for the bugs that the reader, or the lot, has
//! put into it. The wrong code is put together here from the parts of the core.

mod bands;
mod ensemble;
mod figures;
mod filter;
pub(crate) mod frame;
mod params;
mod scale;
mod view;

use ensemble::Seeds;
pub use ensemble::{Figures, Sight, Symptoms, bands, diagnosed, museum_run, museum_runs};
pub use figures::{FIGURES, PANELS};
pub use frame::{MuseumAnswer, MuseumFigure, MuseumFrame, MuseumReadings, MuseumSeries, MuseumSighting};
pub use params::{Bug, MuseumParams};

use crate::ensemble::SEEDS;
use estimate::Error;
use figures::{Compared, Sums};
use filter::{DELAY, Filter, Outcome};
use geom::SE2;
use lab::series::Tracks;
use lab::{Digest, Lab, Params, kept, named};
use nalgebra::{Vector2, Vector3};
use sim::scenarios::BUG_MUSEUM;
use sim::{Noise, Sighting};
use std::collections::VecDeque;

/// How many of the last positions a track keeps: a run and the present.
const TRACK: usize = BUG_MUSEUM.steps as usize + 1;

/// The lab.
#[derive(Clone, Debug)]
pub struct BugMuseum {
    params: MuseumParams,
    noise: Noise,
    step: u32,
    /// Steps of the run that the panels show.
    driven: u32,
    truth: SE2,
    filter: Filter,
    /// The readings of the last steps, the oldest first.
    readings: VecDeque<Option<Sighting>>,
    /// The reading that the filter got at this step, and what it made of it; twice where it was used twice.
    last: Vec<(Sighting, Outcome)>,
    compared: Compared,
    sums: Sums,
    seeds: Seeds,
    series: MuseumSeries,
    seen: MuseumReadings,
    tracks: Tracks,
    digest: Digest,
}

impl Lab for BugMuseum {
    named! {
        "bug-museum", MuseumParams, MuseumFrame, &[frame::INTERFACES],
        "A filter with a bug in it, chosen or drawn by lot, beside what a right filter's panels show."
    }
    kept! {}

    fn start((): (), params: MuseumParams) -> Result<Self, Error> {
        params.check()?;
        let mut noise = Noise::new(u64::from(params.seed));
        let truth = BUG_MUSEUM.course.start();
        let off = Vector3::from_fn(|i, _| BUG_MUSEUM.p0_sigma[i] * noise.normal());
        let filter = Filter::new(bugs(&params), truth.boxplus(&off).to_vector());
        let mut lab = Self {
            params,
            noise,
            step: 0,
            driven: 0,
            truth,
            compared: Compared::new(truth, &filter),
            filter,
            readings: VecDeque::new(),
            last: Vec::new(),
            sums: Sums::default(),
            seeds: Seeds::default(),
            series: MuseumSeries::default(),
            seen: MuseumReadings::default(),
            tracks: Tracks::default(),
            digest: Digest::default(),
        };
        lab.record();
        if params.many {
            (0..BUG_MUSEUM.steps).for_each(|_| lab.drive());
        }
        Ok(lab)
    }

    /// A step of the one run, or the whole run of the next seed.
    fn tried() -> Vec<Self::Params> {
        let open = MuseumParams::default();
        vec![open, MuseumParams { bug: Bug::ShortForm, second: Bug::Transposed, ..open }]
    }

    fn advance(&mut self) -> Result<(), Error> {
        if !self.params.many {
            self.drive();
        } else if self.seeds.count < SEEDS {
            let seed = self.params.seed.wrapping_add(self.step);
            let figures = museum_run(bugs(&self.params), seed)?;
            self.seeds.take(&figures);
            self.digest.take(&figures);
        }
        self.step += 1;
        Ok(())
    }

    fn frame(&self) -> MuseumFrame {
        view::frame(self)
    }
}

impl BugMuseum {
    /// The figures of the run so far, at most of [`BUG_MUSEUM`]`.steps` steps.
    pub fn figures(&self) -> [f64; FIGURES] {
        self.sums.figures()
    }

    /// A tick of the course, and what the filter makes of it.
    fn drive(&mut self) {
        let tick = BUG_MUSEUM.course.tick(self.driven);
        self.truth = tick.drive(self.truth);
        self.driven += 1;
        let [ahead, turn] = BUG_MUSEUM.u_sigma.map(|sigma| sigma * self.noise.normal());
        self.filter.predict(&Vector2::new(tick.ds + ahead, tick.dtheta + turn));
        let reading = look(&mut self.noise, self.truth, self.driven);
        self.readings.push_back(reading);
        if self.readings.len() > DELAY + 1 {
            self.readings.pop_front();
        }
        let given = if !bugs(&self.params).contains(&Bug::Late) {
            reading
        } else if self.readings.len() > DELAY {
            self.readings[0]
        } else {
            None
        };
        self.last = match given {
            Some(seen) => self.filter.update(&seen).map(|outcome| (seen, outcome)).collect(),
            None => Vec::new(),
        };
        self.compared = Compared::new(self.truth, &self.filter);
        if self.driven <= BUG_MUSEUM.steps {
            self.sums.take(self.truth, &self.compared);
            self.last.iter().for_each(|(_, outcome)| self.sums.take_reading(outcome));
        }
        self.record();
    }

    fn record(&mut self) {
        let Compared { error, two_sigma, nees, covariance } = &self.compared;
        let series = &mut self.series;
        series.step.push(f64::from(self.driven));
        let columns = [&mut series.x, &mut series.y, &mut series.theta].into_iter().zip(error.iter());
        columns.for_each(|(column, error)| column.push(*error));
        let bounds = [&mut series.two_sigma_x, &mut series.two_sigma_y, &mut series.two_sigma_theta];
        bounds.into_iter().zip(two_sigma).for_each(|(column, bound)| column.push(*bound));
        series.nees.push(nees.unwrap_or(f64::NAN));
        series.least.push(covariance.least);
        series.asymmetry.push(covariance.asymmetry);
        self.tracks.truth.push(self.truth.x(), self.truth.y(), TRACK);
        self.tracks.estimate.push(self.filter.x[0], self.filter.x[1], TRACK);
        self.digest.take(self.truth.to_vector().as_slice());
        self.digest.take(self.filter.x.as_slice());
        self.digest.take(self.filter.p.as_slice());
        self.digest.take(&[covariance.least, covariance.asymmetry]);
        self.digest.take(nees.as_slice());
        for (seen, outcome) in &self.last {
            let normalized = outcome.normalized();
            let columns = [&mut self.seen.step, &mut self.seen.nis, &mut self.seen.range, &mut self.seen.bearing];
            let values = [f64::from(self.driven), outcome.nis.unwrap_or(f64::NAN), normalized[0], normalized[1]];
            columns.into_iter().zip(values).for_each(|(column, value)| column.push(value));
            self.seen.used.push(f64::from(u8::from(outcome.used)));
            self.digest.take(&[seen.range, seen.bearing]);
            self.digest.take(outcome.innovation.as_slice());
        }
    }
}

/// The reading of a step, of the landmark whose turn it is: none beyond the sensor's reach.
pub(crate) fn look(noise: &mut Noise, truth: SE2, step: u32) -> Option<Sighting> {
    let constants = BUG_MUSEUM;
    let landmark = &constants.landmarks[step as usize % constants.landmarks.len()];
    if !constants.sensor.reaches(truth, landmark) {
        return None;
    }
    let mut seen = constants.sensor.sight(truth, landmark, noise);
    if noise.uniform() < constants.outliers {
        seen.range += 1.0 + noise.uniform();
        seen.bearing = geom::wrap(seen.bearing + noise.uniform() - 0.5);
    }
    Some(seen)
}

/// The bugs of the filter: those chosen, or those that the lot has drawn, which are never the same twice in a pair.
///
/// A lot is a card of a shuffled deck that holds each bug once, and the next lot is the next card.
fn bugs(params: &MuseumParams) -> [Bug; 2] {
    let Some(lot) = params.lot.checked_sub(1) else { return [params.bug, params.second] };
    let mut deck = Bug::ALL;
    let count = deck.len();
    let mut noise = Noise::new((u64::from(lot) / count as u64 + 1) << 32);
    let mut draw = |of: usize| ((noise.uniform() * of as f64) as usize).min(of - 1);
    (1..count).rev().for_each(|last| deck.swap(last, draw(last + 1)));
    let first = lot as usize % count;
    let second = (first + 1 + draw(count - 1)) % count;
    [deck[first], if params.pair { deck[second] } else { Bug::None }]
}

#[cfg(test)]
mod tests;
