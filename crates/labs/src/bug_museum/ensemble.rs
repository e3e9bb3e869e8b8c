//! The museum over many seeds: what a bug does to each figure, beside what a right filter's figures do by chance.

use super::bands::{BANDS, POOLED};
use super::scale::{PARTS, part};
use super::{Bug, BugMuseum, FIGURES, MuseumParams, PANELS};
use crate::ensemble::{Distribution, SEEDS, over_seeds};
use estimate::Error;
use lab::Lab;
use lab::series::Series;
use sim::scenarios::BUG_MUSEUM;

/// The figures of one run.
pub type Figures = [f64; FIGURES];

/// The figures of a whole run with these bugs.
///
/// # Errors
/// Whatever the core answers; on the chapter's constants, nothing.
pub fn museum_run(bugs: [Bug; 2], seed: u32) -> Result<Figures, Error> {
    let mut lab = BugMuseum::new(MuseumParams { bug: bugs[0], second: bugs[1], seed, ..MuseumParams::default() })?;
    lab.run(BUG_MUSEUM.steps)?;
    Ok(lab.figures())
}

/// The same of so many seeds from the first on.
///
/// # Errors
/// As [`museum_run`].
pub fn museum_runs(bugs: [Bug; 2], first: u32, seeds: u32) -> Result<Vec<Figures>, Error> {
    over_seeds(seeds, |seed| museum_run(bugs, first + seed))
}

/// The 0.5, 2.5, 97.5 and 99.5 % quantiles of a right filter's figure, and its mean and standard deviation.
pub fn bands(figure: usize) -> ([f64; 4], [f64; 2]) {
    (BANDS[figure], POOLED[figure])
}

/// On which side of a right filter's 95 % band a figure lies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// Below it, where one run of a right filter in forty lies.
    Below,
    /// Within.
    Within,
    /// Above it, or not a number, because nothing was left to compute the figure from.
    Above,
}

impl Side {
    /// The side of figure `i`.
    pub fn of(i: usize, value: f64) -> Self {
        let [_, low, high, _] = BANDS[i];
        if value < low {
            Self::Below
        } else if value <= high {
            Self::Within
        } else {
            Self::Above
        }
    }
}

/// Counts over the runs of several seeds.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Seeds {
    pub count: u32,
    /// Runs in each part of a figure's scale.
    pub counts: [[u32; PARTS]; FIGURES],
    /// The figures of each run.
    pub runs: [Series<{ SEEDS as usize }>; FIGURES],
    /// Runs below and above a right filter's 95 % band, by figure.
    beyond: [[u32; 2]; FIGURES],
}

impl Seeds {
    pub fn take(&mut self, figures: &Figures) {
        self.count += 1;
        for (i, [below, above]) in self.beyond.iter_mut().enumerate() {
            self.counts[i][part(i, figures[i])] += 1;
            self.runs[i].push(figures[i]);
            match Side::of(i, figures[i]) {
                Side::Below => *below += 1,
                Side::Within => {}
                Side::Above => *above += 1,
            }
        }
    }

    /// The shares of runs below and above, by figure; 0 before the first.
    pub fn shares(&self) -> [[f64; 2]; FIGURES] {
        self.beyond.map(|sides| sides.map(|count| f64::from(count) / f64::from(self.count.max(1))))
    }
}

/// What can be seen of a bug in a figure or a panel.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Sight {
    /// Chance explains the runs of 500 seeds: their mean lies in the range that holds 99 of 100 such means of a right
    /// filter, and neither side of its 95 % band has more runs than in 99 of 100 cases by chance.
    Invisible,
    /// Chance does not explain them, but at least half of the single runs lie in a right filter's 99 % band.
    InMany,
    /// More than half of the single runs lie outside that band.
    InOne,
}

/// What a bug does to the figures.
#[derive(Clone, Debug, PartialEq)]
pub struct Symptoms {
    /// The share of runs below and above a right filter's 95 % band, by figure.
    pub beyond: [[f64; 2]; FIGURES],
    /// What can be seen in each.
    pub sight: [Sight; FIGURES],
}

impl Symptoms {
    /// The symptoms that these runs show.
    pub fn of(runs: &[Figures]) -> Self {
        let count = runs.len() as f64;
        let mut seeds = Seeds::default();
        runs.iter().for_each(|run| seeds.take(run));
        let (beyond, most) = (seeds.shares(), by_chance(seeds.count));
        let sight = |i: usize| {
            let spread = Distribution::new(runs.iter().map(|run| run[i]));
            let [least, _, _, greatest] = BANDS[i];
            let [mean, sigma] = POOLED[i];
            // 99 % of a normal distribution lie within 2.576 standard deviations.
            let error = 2.576 * sigma / count.sqrt();
            if !(least..=greatest).contains(&spread.median()) {
                Sight::InOne
            } else if (spread.mean() - mean).abs() <= error && beyond[i].iter().all(|share| *share <= most) {
                Sight::Invisible
            } else {
                Sight::InMany
            }
        };
        Self { beyond, sight: std::array::from_fn(sight) }
    }

    /// What can be seen in a panel: in the most telling of its figures.
    pub fn panel(&self, panel: usize) -> Sight {
        PANELS[panel].1.iter().map(|&i| self.sight[i]).max().unwrap_or(Sight::Invisible)
    }
}

/// The share of so many runs of a right filter that lie on one side of its 95 % band, at most, in 99 of 100 cases: each
/// run does so with a probability of 1/40, so their number is binomial.
fn by_chance(count: u32) -> f64 {
    const SIDE: f64 = 1.0 / 40.0;
    let runs = f64::from(count);
    let (mut term, mut sum, mut most) = (libm::pow(1.0 - SIDE, runs), 0.0, 0.0);
    while most < runs {
        sum += term;
        if sum >= 0.99 {
            break;
        }
        term *= (runs - most) / (most + 1.0) * SIDE / (1.0 - SIDE);
        most += 1.0;
    }
    most / runs.max(1.0)
}

/// The bug, or none, that the runs look like by the symptom table alone: the one under which it is likeliest that each
/// figure lies on the side of its band where it does. `table` has a row for each candidate.
pub fn diagnosed(table: &[(Bug, Symptoms)], runs: &[Figures]) -> Option<Bug> {
    let likelihood = |symptoms: &Symptoms| -> f64 {
        let of = |run: &Figures| -> f64 {
            let term = |i: usize| {
                let [below, above] = symptoms.beyond[i];
                let share = match Side::of(i, run[i]) {
                    Side::Below => below,
                    Side::Within => 1.0 - below - above,
                    Side::Above => above,
                };
                // A share of 500 seeds that is 0 may be a few thousandths.
                libm::log(share.max(2e-3))
            };
            (0..FIGURES).map(term).sum()
        };
        runs.iter().map(of).sum()
    };
    table.iter().max_by(|(_, a), (_, b)| likelihood(a).total_cmp(&likelihood(b))).map(|(bug, _)| *bug)
}
