//! Noise and delays of a log, by the likelihood of its readings: a search that goes on by one replay at a time.
//!
//! The search moves one number after the other, and on along the way that a round has led, by steps that grow while
//! they lead up and shrink where neither way does (Hooke and Jeeves 1961). Where all are fine it begins again with long
//! ones, until that leads up no more. Derivatives are of no use: where a delay passes a row, the likelihood has a
//! corner. The readings are the same ones in every replay: those stamped two seconds after the latest start that is
//! tried. Where a gate is on, whatever its level, a reading that is likelier an outlier is taken for one, as a verdict
//! takes it: a sum over used readings alone would reward refusal. A gate that refuses much where the search begins is
//! off until the search has ended without it, since what it refuses need not be outliers. At last the search goes on
//! with the other readings alone, which tell the uncertainties too: of all it has a step where one becomes an outlier.

use crate::drive::course::Course;
use crate::drive::evidence::OUTLIER_GATE;
use crate::drive::fit_result::FitResult;
use crate::drive::fitted::Fitted;
use crate::drive::flat::flat;
use crate::drive::gates::MUCH;
use crate::drive::likelihood::{beyond, with_outliers, without_outliers};
use crate::drive::moves::{Moves, mean_range};
use crate::drive::pace::Paced;
use crate::drive::row::Drive;
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
/// The most replays of a search.
const MOST_REPLAYS: u32 = 1200;
/// A search that has risen by no more than this since it last began is at its end.
const RISEN: f64 = 0.2;

/// How far delays are tried either way in a log of so many seconds, s.
pub(crate) fn most_delay(duration: f64) -> f64 {
    MOST_DELAY.min(SHARE * duration)
}

/// A search for the noise and the delays under which a log's readings are likeliest.
#[derive(Clone, Debug)]
pub struct Fit {
    settings: Settings,
    /// Where the search began, while gates are off until it ends without them.
    later: Option<Vec<f64>>,
    paced: Paced,
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
    outliers: u32,
    /// What the outliers add to the log-likelihood, once the search goes on without them.
    of_outliers: f64,
    /// The gates as they are set, and how many readings they refuse under what was found.
    set: BySensor<Option<f64>>,
    refused: u32,
    /// The drive without its outliers, once they are known.
    clean: Option<Drive>,
    replays: u32,
    /// The most replays before this search ends.
    until: u32,
    settled: bool,
    /// How well the log tells the numbers, once they are found.
    told: Option<Told>,
    beyond: u32,
    flat: Option<Vec<(Fitted, [f64; 2])>>,
}

impl Fit {
    /// A search that begins at `settings`, for the σ of motion and of the sensors that the log has and that are used,
    /// for their delays, the scale and the offset of ranges, the offsets of bearings and headings; the turn's delay
    /// stays what it is, since a delay of all together cannot be seen. In a log without turn rates the speed's does.
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
        let set = settings.gate;
        let settings = Settings { gate: for_outliers(set), ..settings };
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
            later: None,
            paced: Paced::new(drive, &settings),
            from: start + SETTLED,
            numbers,
            at,
            bounds,
            moves,
            began: f64::NEG_INFINITY,
            first: None,
            best: f64::NEG_INFINITY,
            readings: 0,
            outliers: 0,
            of_outliers: 0.0,
            set,
            refused: 0,
            clean: None,
            replays: 0,
            until: MOST_REPLAYS,
            settled: false,
            told: None,
            beyond: 0,
            flat: None,
        };
        let fix = drive.rows.iter().find(|row| Sensor::of(&row.event) == Some(Sensor::Fix));
        if let (Some(fix), true) = (fix, drive.truth.poses().is_empty()) {
            fit.from = fit.from.max(fix.time + most + SETTLED);
        }
        if fit.numbers.is_empty() || fit.replay(drive, &fit.at)?.1[0] == 0 {
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
            let clean = self.clean.as_ref().unwrap_or(drive);
            let value = self.replay(clean, &at).map_or(f64::NEG_INFINITY, |(value, _)| value);
            if let Some(told) = &mut self.told {
                told.take(value);
            }
            return Ok(true);
        }
        self.replays += 1;
        if self.first.is_none() {
            let (value, [readings, outliers]) = self.replay(drive, &self.at)?;
            (self.first, self.best, self.readings) = (Some(value), value, readings);
            if f64::from(outliers) > MUCH * f64::from(readings) {
                self.later = Some(self.at.clone());
                self.settings.gate = BySensor::all(None);
                self.best = self.replay(drive, &self.at)?.0;
            }
            return Ok(true);
        }
        // What leaves the numbers is no likelihood that could be the greatest.
        let clean = self.clean.as_ref().unwrap_or(drive);
        let better = self.moves.next(&self.at).and_then(|tried| {
            let value = self.replay(clean, &tried).map_or(f64::NEG_INFINITY, |it| it.0);
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
        if !self.settled && self.replays < self.until {
            return Ok(true);
        }
        if let Some(began) = self.later.take() {
            self.put_back(drive, began)?;
        } else if self.settings.gate != BySensor::all(None) {
            let clean = without_outliers(drive, self.set_to(&self.at))?;
            self.outliers = self.replay(drive, &self.at)?.1[1];
            self.settings.gate = BySensor::all(None);
            let value = self.replay(&clean, &self.at)?.0;
            self.of_outliers = self.best - value;
            self.clean = Some(clean);
            self.again(value);
        } else {
            self.told = Some(Told::new(&self.numbers, &self.bounds, self.best));
        }
        Ok(true)
    }

    /// Goes on behind the gates from what was found without them, or from the start where that is likelier.
    fn put_back(&mut self, drive: &Drive, began: Vec<f64>) -> Result<(), Error> {
        self.settings.gate = for_outliers(self.set);
        let (first, value) = (self.first.unwrap_or(f64::NEG_INFINITY), self.replay(drive, &self.at)?.0);
        if value < first {
            self.at = began;
        }
        self.again(value.max(first));
        Ok(())
    }

    /// Begins another search from where the last one has ended, by a likelihood that is so much there.
    fn again(&mut self, value: f64) {
        (self.best, self.began, self.settled) = (value, f64::NEG_INFINITY, false);
        self.until = self.replays + MOST_REPLAYS;
        self.moves.again(&self.at);
    }

    /// Looks for outliers, and for delays that the log tells in stairs, once.
    fn look_back(&mut self, drive: &Drive) -> Result<(), Error> {
        if self.flat.is_some() {
            return Ok(());
        }
        let clean = self.clean.as_ref().unwrap_or(drive);
        let [beyond, _] = beyond(clean, self.set_to(&self.at), self.from, 1.0 - EXPECTED)?;
        let stair = |(i, number): (usize, &Fitted)| {
            let value = |to: f64| {
                let mut at = self.at.clone();
                at[i] = to;
                self.replay(clean, &at).ok().map(|it| it.0)
            };
            Some((*number, flat(clean, self.at[i], value)?))
        };
        let delays = self.numbers.iter().enumerate().filter(|(_, number)| number.is_delay());
        (self.flat, self.beyond) = (Some(delays.filter_map(stair).collect()), beyond);
        let behind = Settings { gate: self.set, ..self.set_to(&self.at) };
        self.refused = with_outliers(drive, behind, self.from)?.1[1];
        Ok(())
    }

    /// The settings with the numbers at these places.
    fn set_to(&self, at: &[f64]) -> Settings {
        let mut settings = self.settings;
        self.numbers.iter().zip(at).for_each(|(number, at)| number.set(&mut settings, *at));
        settings
    }

    /// The log-likelihood of the counted readings, how many there are, and how many of them are outliers.
    fn replay(&self, drive: &Drive, at: &[f64]) -> Result<(f64, [u32; 2]), Error> {
        with_outliers(drive, self.set_to(at), self.from)
    }

    /// What has been found so far.
    pub fn found(&self) -> FitResult {
        let sigmas = self.told.as_ref().map(Told::sigmas);
        let sigma = |i: usize| sigmas.as_ref().and_then(|sigmas| sigmas[i]);
        let number = |(i, number): (usize, &Fitted)| (*number, number.value(self.at[i]), sigma(i));
        let edge = |(i, above): (usize, f64)| (self.numbers[i], self.numbers[i].value(self.at[i] + above));
        let further = if self.set == BySensor::all(None) || self.clean.is_some() { 0 } else { MOST_REPLAYS };
        let most = self.until + further + Told::most(self.numbers.len());
        FitResult {
            numbers: self.numbers.iter().enumerate().map(number).collect(),
            at_most: self.told.iter().flat_map(Told::edges).map(edge).collect(),
            log_likelihood: [self.first.unwrap_or(self.best), self.best + self.of_outliers],
            readings: self.readings,
            outliers: (self.set != BySensor::all(None)).then_some(self.outliers),
            refused: (self.set != BySensor::all(None)).then_some(self.refused),
            replays: [self.replays, most],
            settled: self.settled,
            beyond: self.beyond,
            expected: EXPECTED,
            pace: self.paced.pace,
            half_turn: self.paced.half_turn,
            period: self.paced.period,
            own_delay: self.paced.own_delay,
            flat: self.flat.clone().unwrap_or_default(),
        }
    }
}

/// The gates behind which outliers are looked for, whatever the level of those that are set.
fn for_outliers(set: BySensor<Option<f64>>) -> BySensor<Option<f64>> {
    set.map(|gate| gate.map(|_| OUTLIER_GATE))
}
