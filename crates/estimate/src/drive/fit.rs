//! Noise and delays of a log, by the likelihood of its readings: a search that goes on by one replay at a time.
//!
//! The search moves one number after the other, and on along the way that a round has led, by steps that grow while
//! they lead up and shrink where neither way does (Hooke and Jeeves 1961). Where all are fine it begins again with long
//! ones, until that leads up no more. Derivatives are of no use: where a delay passes a row, the likelihood has a
//! corner. Gates are off, since a sum over used readings rewards refusal, and the readings are the same ones in every
//! replay: those stamped two seconds after the latest start that is tried.

use crate::drive::course::Course;
use crate::drive::fitted::Fitted;
use crate::drive::flat::flat;
use crate::drive::judgement::period;
use crate::drive::likelihood::{beyond, log_likelihood};
use crate::drive::moves::Moves;
use crate::drive::pace::pace;
use crate::drive::row::{Drive, Event};
use crate::drive::sensor::{BySensor, Sensor};
use crate::drive::settings::Settings;
use crate::drive::told::Told;
use crate::error::{Code, Error};
use alloc::vec::Vec;

/// Readings count from so long after the latest start that is tried, s.
pub(crate) const SETTLED: f64 = 2.0;
/// Delays are tried so far either way, s, and no further than this share of the log.
const MOST_DELAY: f64 = 3.0;
const SHARE: f64 = 0.1;
/// Readings are held against what holds all but this share of them.
const EXPECTED: f64 = 0.001;
/// The most replays of the search itself.
const MOST_REPLAYS: u32 = 1200;
/// A search that has risen by no more than this since it last began is at its end.
const RISEN: f64 = 0.2;

/// How far delays are tried either way in a log of so many seconds, s.
pub(crate) fn most_delay(duration: f64) -> f64 {
    MOST_DELAY.min(SHARE * duration)
}

/// What a fit has found.
#[derive(Clone, Debug, PartialEq)]
pub struct FitResult {
    /// Each number: what it is, its value, and its standard deviation, relative of a σ, else in the number's unit.
    /// `None` where the log does not tell it.
    pub numbers: Vec<(Fitted, f64, Option<f64>)>,
    /// The log-likelihood of the counted readings before and after.
    pub log_likelihood: [f64; 2],
    /// How many readings are counted.
    pub readings: u32,
    /// Replays so far, and how many there may be at most.
    pub replays: [u32; 2],
    /// Whether the search has ended where no step leads up, and not at the most replays.
    pub settled: bool,
    /// How many of the counted readings lie where this share of them is expected under what was found: more are
    /// outliers, which have bent it. 0 before the search has ended.
    pub beyond: u32,
    /// That share.
    pub expected: f64,
    /// The mean distance of a second in which the robot drives, m: a σ of the distance that is a good part of it, in
    /// m/√s, is more than noise.
    pub pace: f64,
    /// The median time between rows of motion, s: a delay of at most half of it may be the motion model's own.
    pub period: f64,
    /// Delays of a log of odometry, from where to where its likelihood is the same.
    pub flat: Vec<(Fitted, [f64; 2])>,
}

/// A search for the noise and the delays under which a log's readings are likeliest.
#[derive(Clone, Debug)]
pub struct Fit {
    settings: Settings,
    pace: f64,
    period: f64,
    /// Readings stamped before are not counted.
    from: f64,
    numbers: Vec<Fitted>,
    /// The numbers as the search moves them.
    at: Vec<f64>,
    bounds: Vec<[f64; 2]>,
    moves: Moves,
    /// The log-likelihood where the search last began.
    began: f64,
    first: Option<f64>,
    best: f64,
    readings: u32,
    replays: u32,
    settled: bool,
    /// How well the log tells the numbers, once they are found.
    told: Option<Told>,
    beyond: u32,
    flat: Option<Vec<(Fitted, [f64; 2])>>,
}

impl Fit {
    /// A search that begins at `settings`, for the σ of motion and of the sensors that the log has and that are used,
    /// for their delays, the scale and the offset of ranges, the offsets of bearings and headings; the turn's delay
    /// stays 0, since a delay of all together cannot be seen. In a log without turn rates the speed's stays what it is
    /// instead.
    ///
    /// # Errors
    /// As [`Course::new`]; [`Code::Limit`] where the log has no reading that counts.
    pub fn new(drive: &Drive, settings: Settings) -> Result<Self, Error> {
        Self::begin(drive, settings, Fitted::of)
    }

    /// A search for these numbers alone, as far as the log may tell them.
    ///
    /// # Errors
    /// As [`Fit::new`], and where the log may tell none of them.
    pub fn only(drive: &Drive, settings: Settings, numbers: &[Fitted]) -> Result<Self, Error> {
        Self::begin(drive, settings, |drive, course| {
            Fitted::all(drive, course).into_iter().filter(|number| numbers.contains(number)).collect()
        })
    }

    fn begin(drive: &Drive, settings: Settings, which: impl Fn(&Drive, &Course) -> Vec<Fitted>) -> Result<Self, Error> {
        let mut settings = Settings { gate: BySensor::all(None), ..settings };
        settings.delays.turn = 0.0;
        let course = Course::new(drive, settings)?;
        let [first, last] = drive.span().unwrap_or_default();
        let most = most_delay(last - first);
        let numbers = which(drive, &course);
        let at: Vec<f64> = numbers.iter().map(|number| number.get(&settings)).collect();
        let bounds: Vec<[f64; 2]> = numbers.iter().map(|number| number.bounds(most)).collect();
        let at: Vec<f64> = at.iter().zip(&bounds).map(|(at, [least, greatest])| at.clamp(*least, *greatest)).collect();
        let moves = Moves::new(&numbers, &at, &bounds, [most, mean_range(drive)]);
        let start = drive.truth.poses().first().map_or(first + most, |pose| pose.time);
        let mut fit = Self {
            settings,
            pace: pace(drive, &settings),
            period: period(&drive.rows),
            from: start + SETTLED,
            numbers,
            at,
            bounds,
            moves,
            began: f64::NEG_INFINITY,
            first: None,
            best: f64::NEG_INFINITY,
            readings: 0,
            replays: 0,
            settled: false,
            told: None,
            beyond: 0,
            flat: None,
        };
        let fix = drive.rows.iter().find(|row| Sensor::of(&row.event) == Some(Sensor::Fix));
        if let (Some(fix), true) = (fix, drive.truth.poses().is_empty()) {
            fit.from = fit.from.max(fix.time + most + SETTLED);
        }
        if fit.numbers.is_empty() || fit.replay(drive, &fit.at)?.1 == 0 {
            return Err(Error::new(Code::Limit, "log", "has no reading that a fit could count"));
        }
        Ok(fit)
    }

    /// Replays the log once more; whether there is more to do.
    ///
    /// # Errors
    /// The log cannot be replayed under the settings that the search begins at.
    pub fn step(&mut self, drive: &Drive) -> Result<bool, Error> {
        if let Some(told) = &mut self.told {
            let Some(at) = told.next(&self.at) else {
                self.look_back(drive)?;
                return Ok(false);
            };
            self.replays += 1;
            let value = self.replay(drive, &at).map_or(f64::NEG_INFINITY, |(value, _)| value);
            if let Some(told) = &mut self.told {
                told.take(value);
            }
            return Ok(true);
        }
        self.replays += 1;
        if self.first.is_none() {
            let (value, readings) = self.replay(drive, &self.at)?;
            (self.first, self.best, self.readings) = (Some(value), value, readings);
            return Ok(true);
        }
        // What leaves the numbers is no likelihood that could be the greatest.
        let better = self.moves.next(&self.at).and_then(|tried| {
            let value = self.replay(drive, &tried).map_or(f64::NEG_INFINITY, |it| it.0);
            (value > self.best).then_some((tried, value))
        });
        let up = better.is_some();
        if let Some((tried, value)) = better {
            (self.at, self.best) = (tried, value);
        }
        self.moves.take(up, &self.at);
        if self.moves.settled() {
            self.settled = self.best - self.began <= RISEN;
            self.began = self.best;
            self.moves.again(&self.at);
        }
        if self.settled || self.replays >= MOST_REPLAYS {
            self.told = Some(Told::new(&self.numbers, &self.bounds, self.best));
        }
        Ok(true)
    }

    /// Looks for outliers, and for delays that the log tells in stairs, once.
    fn look_back(&mut self, drive: &Drive) -> Result<(), Error> {
        if self.flat.is_some() {
            return Ok(());
        }
        let mut settings = self.settings;
        self.numbers.iter().zip(&self.at).for_each(|(number, at)| number.set(&mut settings, *at));
        [self.beyond, _] = beyond(drive, settings, self.from, 1.0 - EXPECTED)?;
        let stair = |(i, number): (usize, &Fitted)| {
            let value = |to: f64| {
                let mut at = self.at.clone();
                at[i] = to;
                self.replay(drive, &at).ok().map(|it| it.0)
            };
            Some((*number, flat(drive, self.at[i], value)?))
        };
        let delays = self.numbers.iter().enumerate().filter(|(_, number)| number.is_delay());
        self.flat = Some(delays.filter_map(stair).collect());
        Ok(())
    }

    /// The log-likelihood of the counted readings, and how many there are.
    fn replay(&self, drive: &Drive, at: &[f64]) -> Result<(f64, u32), Error> {
        let mut settings = self.settings;
        self.numbers.iter().zip(at).for_each(|(number, at)| number.set(&mut settings, *at));
        log_likelihood(drive, settings, self.from)
    }

    /// What has been found so far.
    pub fn found(&self) -> FitResult {
        let sigmas = self.told.as_ref().map(Told::sigmas);
        let sigma = |i: usize| sigmas.as_ref().and_then(|sigmas| sigmas[i]);
        let number = |(i, number): (usize, &Fitted)| (*number, number.value(self.at[i]), sigma(i));
        let most = MOST_REPLAYS + Told::most(self.numbers.len());
        FitResult {
            numbers: self.numbers.iter().enumerate().map(number).collect(),
            log_likelihood: [self.first.unwrap_or(self.best), self.best],
            readings: self.readings,
            replays: [self.replays, most],
            settled: self.settled,
            beyond: self.beyond,
            expected: EXPECTED,
            pace: self.pace,
            period: self.period,
            flat: self.flat.clone().unwrap_or_default(),
        }
    }
}

/// The mean of the ranges, m.
fn mean_range(drive: &Drive) -> f64 {
    let ranges = drive.rows.iter().filter_map(|row| match row.event {
        Event::Range { range, .. } | Event::RangeBearing { range, .. } => Some(range),
        _ => None,
    });
    let (sum, count) = ranges.fold((0.0, 0_u32), |(sum, count), range| (sum + range, count + 1));
    if count == 0 { 0.0 } else { sum / f64::from(count) }
}
