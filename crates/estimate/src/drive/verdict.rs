//! What is wrong with a log or its settings, ranked: each number that may be wrong is freed by itself, and the readings
//! say which of them makes them likelier, and by how much.
//!
//! Twice the gain in log-likelihood of a number without a fault is χ² (Wilks 1938). So many are tried that the best
//! gains by chance: a fault is named beyond the quantile that the best of all stays below in 97 of 100 sound logs
//! (Bonferroni). Faults are compared by what they gain beyond it. Readings that a gate refuses count as outliers; a
//! gate that refuses one in ten hides a fault, and is off meanwhile, unless outliers are what it refuses.
//!
//! A larger σ makes any error of the model likelier. Where one explains most, the other faults are freed once more
//! beside it, and what makes the readings much likelier even so is named before it: at once where it alone explains by
//! itself most of what that σ does.
//!
//! The motion model has faults of its own: what it reads is held until the next row, and it drives straight and turns
//! then. Where the readings are likelier with the turn on the way, all is freed beside that; a delay of at most half a
//! step between rows of motion is set apart, and the others are freed beside it.

use crate::drive::beside::{by_itself, explained, hoist};
use crate::drive::course::{Course, Otherwise};
use crate::drive::diluted::{diluted, noisy_turns};
use crate::drive::evidence::{Against, Evidence, Trial};
use crate::drive::fault::Fault;
use crate::drive::gaps::{Gaps, gaps_and_end};
use crate::drive::gates::Gates;
use crate::drive::judgement::{
    Judgement, as_mended, for_the_filter, is_own, may_be_own, own_delay, own_delay_left, refuted, stairs, turning,
};
use crate::drive::noise::{Noise, noise};
use crate::drive::pace::Paced;
use crate::drive::round::{Round, Scope};
use crate::drive::row::{Drive, Motion};
use crate::drive::settings::Settings;
use crate::drive::suspect::{Standing, Suspect};
use crate::drive::thinning::{Thinning, wandering, without_smaller};
use crate::drive::tried::Tried;
use crate::drive::weight::{CLEAR, ranked, sifted, stand};
use crate::error::{Code, Error};
use alloc::vec::Vec;

/// What the truth does not refuse is named where it has this share of the evidence of all that it has refused before.
const HALF: f64 = 0.5;

/// A verdict on a log, suspect by suspect.
///
/// # Example
/// ```
/// use estimate::drive::{Drive, Event, Fault, Motion, Row, Settings, Standing, Truth, Verdict};
/// // Fixes say that the robot drives a tenth faster than it reads.
/// let fix = |k: i32| Event::Position { x: 1.1 * f64::from(k), y: 0.1 * f64::from(k % 2), sigma: Some(0.1) };
/// let drives = Event::Velocity { v: 1.0, omega: 0.0 };
/// let rows = (0..60).flat_map(|k| [drives, fix(k)].map(|event| Row::new(f64::from(k), event))).collect();
/// let drive = Drive { landmarks: Vec::new(), truth: Truth::default(), rows, motion: Motion::Velocity };
/// let mut verdict = Verdict::new(&drive, Settings::default())?;
/// while verdict.step(&drive)? {}
/// let judgement = verdict.found();
/// let first = &judgement.suspects[0];
/// assert_eq!((first.fault, first.standing), (Fault::Scale, Standing::Sure));
/// assert!((first.sizes[0].value - 0.1).abs() < 3.0 * first.sizes[0].sigma);
/// # Ok::<(), estimate::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct Verdict {
    scope: Scope,
    first: Round,
    /// The faults beside a σ that is enlarged.
    beside: Option<Round>,
    stage: Stage,
    gates: Gates,
    /// Whether the first suspects were found beside the larger σ, and whether the first goes before it by itself.
    hoisted: bool,
    thinning: Option<Thinning>,
    sole: bool,
    /// How far the filter is from the truth as it is set, once that is known.
    against: Option<Against>,
    /// Whether it was asked what turns on the way would bring, and that.
    asked: bool,
    arcs: Option<f64>,
    /// Delays that are the motion model's own, and how many suspects were tried before they were set apart.
    own: Vec<Suspect>,
    before: u32,
    motion: Motion,
    paced: Paced,
    gaps: Vec<Gaps>,
    other: bool,
    noise: Noise,
    suspects: Vec<Suspect>,
}

/// How far a verdict has come.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Stage {
    First,
    Beside,
    Done,
}

impl Verdict {
    /// A verdict on `drive` under `settings`.
    ///
    /// # Errors
    /// As [`Course::new`]; [`Code::Limit`] where no reading is used.
    pub fn new(drive: &Drive, settings: Settings) -> Result<Self, Error> {
        let course = Course::new(drive, settings)?;
        let tried = Tried::all(drive, &course);
        if tried.is_empty() || course.looked_at(drive) == 0 {
            return Err(Error::new(Code::Limit, "log", "has no reading that is used, and could be judged by"));
        }
        let paced = Paced::new(drive, &settings);
        let (scope, duration) = Scope::new(drive, &course, &paced, tried.len())?;
        let first = Round::new(Trial { settings, otherwise: Otherwise::default() }, tried);
        Ok(Self {
            scope,
            first,
            beside: None,
            stage: Stage::First,
            gates: Gates::Set,
            hoisted: false,
            thinning: None,
            sole: false,
            against: None,
            asked: false,
            arcs: None,
            own: Vec::new(),
            before: 0,
            motion: drive.motion,
            paced,
            gaps: gaps_and_end(&drive.rows, drive.motion).into_iter().filter(|it| it.longest[0] < duration).collect(),
            other: false,
            noise: Noise::default(),
            suspects: Vec::new(),
        })
    }

    /// The same where two wheels alone say how the robot drove and turned.
    #[must_use]
    pub fn by_wheels(mut self) -> Self {
        Tried::by_wheels(&mut self.first.tried);
        self
    }

    /// Looks at the next suspect, by one to some twenty replays; whether there is more to do.
    ///
    /// # Errors
    /// The log cannot be replayed under the settings.
    pub fn step(&mut self, drive: &Drive) -> Result<bool, Error> {
        let more = match self.stage {
            Stage::First => self.first.step(drive, &self.scope)?,
            Stage::Beside => self.beside.as_mut().map_or(Ok(false), |round| round.step(drive, &self.scope))?,
            Stage::Done => return Ok(false),
        };
        if self.first.found.is_empty() && !self.asked && !self.gates.open(&mut self.first) {
            self.against = self.first.base.as_ref().and_then(|base| base.against);
        }
        if more {
            return Ok(true);
        }
        if self.stage == Stage::First {
            let mut found = core::mem::take(&mut self.first.found);
            sifted(drive, &mut found, &self.scope);
            without_smaller(&self.first.place.settings, &mut found);
            self.first.found = ranked(found);
            if self.trust_gates() || self.turn_on_the_way(drive) || self.set_apart(drive) {
                return Ok(true);
            }
            for_the_filter(drive, &mut self.first, &self.own, &self.scope)?;
            self.sole = by_itself(&mut self.first, drive, &self.scope)?;
            self.beside = if self.sole { None } else { explained(&self.first) };
        }
        self.stage = if self.stage == Stage::First && self.beside.is_some() { Stage::Beside } else { Stage::Done };
        if self.stage == Stage::Done {
            self.conclude(drive);
        }
        Ok(self.stage != Stage::Done)
    }

    /// Begins again with the gates where outliers are what they refuse; whether it does.
    fn trust_gates(&mut self) -> bool {
        let (tried, trusts) = (self.first.tried.len() as u32, self.gates.trust(&mut self.first));
        self.before += if trusts { tried } else { 0 };
        trusts
    }

    /// Frees the suspects anew beside a robot that turns on its way, where that makes the readings likelier than any of
    /// them does by itself, or likelier still where the likeliest, a clock, is mended; whether it does.
    fn turn_on_the_way(&mut self, drive: &Drive) -> bool {
        if self.asked {
            return false;
        }
        self.asked = true;
        self.arcs = turning(drive, &self.first, &self.scope);
        if self.arcs.is_none() {
            return false;
        }
        let place = Trial { otherwise: Otherwise { arcs: true, ..Otherwise::default() }, ..self.first.place };
        self.before += self.first.tried.len() as u32;
        self.first = Round::new(place, core::mem::take(&mut self.first.tried));
        true
    }

    /// Sets a delay apart that is the motion model's own, and frees the others beside it; whether there was one.
    fn set_apart(&mut self, drive: &Drive) -> bool {
        let likely = |suspect: &Suspect| suspect.excess > 0.0 && suspect.fault != Fault::Sigma;
        let Some((own, place)) = self.first.found.iter().find(|(suspect, _)| likely(suspect)) else {
            return false;
        };
        if !is_own(drive, own, &self.first, &self.scope, own_delay(self.motion, true, self.paced.period)) {
            return false;
        }
        let tried: Vec<Tried> = self.first.tried.iter().copied().filter(|tried| *tried != own.tried()).collect();
        self.before += self.first.tried.len() as u32;
        self.own.push(Suspect { own: true, ..own.clone() });
        self.first = Round::new(*place, tried);
        true
    }

    fn own_delay(&self) -> f64 {
        own_delay(self.motion, self.arcs.is_some(), self.paced.period)
    }

    /// Says how sure each suspect is, and holds the first against the truth.
    fn conclude(&mut self, drive: &Drive) {
        self.noise = self.first.base.as_ref().map(|base| noise(drive, &base.readings)).unwrap_or_default();
        if let Some(round) = self.beside.take() {
            (self.hoisted, self.thinning) = hoist(&mut self.first, round, drive, &self.scope);
        }
        let mut places: Vec<Trial> = self.first.found.iter().map(|(_, place)| *place).collect();
        self.suspects = core::mem::take(&mut self.first.found).into_iter().map(|(suspect, _)| suspect).collect();
        let own_delay = self.own_delay();
        own_delay_left(drive, &mut self.suspects, &mut places, &self.first, &self.scope, own_delay);
        stand(&mut self.suspects, self.hoisted || self.sole);
        stairs(drive, &mut self.suspects, &places, &self.scope);
        diluted(drive, &mut self.suspects);
        noisy_turns(drive, &mut self.suspects, &places, &self.scope);
        if !self.hoisted {
            may_be_own(drive, &mut self.suspects, &self.first, &self.scope, own_delay);
        }
        if self.thinning.is_none() {
            self.thinning = wandering(drive, &self.first, &self.scope, (&self.suspects, &places));
        }
        self.hold_against_the_truth(drive, &places);
        // Where there is no fault, none hides in what they have in common.
        let fault = self.suspects.first().is_some_and(|first| first.standing != Standing::Cleared);
        self.thinning = self.thinning.filter(|_| fault);
        self.suspects.append(&mut self.own);
    }

    /// Mends the likeliest suspects until the truth does not say that it is none, and puts that one first; not where
    /// the readings tell far more of one that the truth refuses: two faults may hide one another from it.
    fn hold_against_the_truth(&mut self, drive: &Drive, places: &[Trial]) {
        let Some(before) = self.against else { return };
        let likely = self.suspects.iter().take_while(|suspect| suspect.excess > 0.0).count();
        let mut refused = 0.0_f64;
        for (i, place) in places.iter().enumerate().take(likely) {
            let mended =
                Evidence::new(drive, &as_mended(place, &self.own), self.scope.rows).ok().and_then(|it| it.against);
            self.suspects[i].mended = mended;
            let Suspect { fault, excess, own, .. } = self.suspects[i];
            if excess >= HALF * refused && mended.is_none_or(|after| !refuted(fault, &before, &after)) {
                self.suspects[..=i].rotate_right(1);
                return;
            }
            // What may be no fault, or chance, and mends nothing, is none.
            refused = refused.max(if own { 0.0 } else { excess });
            let chance = excess < CLEAR && fault != Fault::Sigma;
            self.suspects[i].standing = if own || chance { Standing::Cleared } else { Standing::Maybe };
        }
        let cleared = |it: &Suspect| it.standing == Standing::Cleared;
        self.suspects.sort_by_key(|it| (cleared(it), it.own && cleared(it)));
        self.other = likely > 0 && self.suspects.first().is_some_and(|it| it.standing != Standing::Cleared);
    }

    /// What has been found so far; suspects once all were looked at.
    pub fn found(&self) -> Judgement {
        let (base, beside) = (self.first.base.as_ref(), self.beside.as_ref());
        let of = |round: &Round| [round.found.len() as u32, round.tried.len() as u32];
        let all = self.before + self.first.tried.len() as u32;
        let [done, more] = beside.map_or([0, 0], of);
        let looked = if self.stage == Stage::First { self.before + self.first.found.len() as u32 } else { all };
        Judgement {
            suspects: self.suspects.clone(),
            readings: base.map_or(0, |base| base.readings.len() as u32),
            rows: self.scope.rows,
            tried: [looked + done, all + more],
            against: self.against,
            ungated: matches!(self.gates, Gates::Off(_)),
            beside: self.hoisted,
            thinning: self.thinning,
            arcs: self.arcs,
            period: self.paced.period,
            own_delay: self.own_delay(),
            pace: self.paced.pace,
            half_turn: if self.arcs.is_none() { self.paced.half_turn } else { 0.0 },
            noise: self.noise,
            gaps: self.gaps.clone(),
            other: self.other,
        }
    }
}
