//! A look at some suspects beside one replay.

use crate::drive::course::{Course, Otherwise};
use crate::drive::displaced::{biased, displaced};
use crate::drive::evidence::{Evidence, Trial};
use crate::drive::exchange::{likeliest, pairs};
use crate::drive::fault::Fault;
use crate::drive::fit::{SETTLED, most_delay};
use crate::drive::fitted::Fitted;
use crate::drive::freed::{Freed, Numbers, ROUNDS, ROUNDS_OF_A_FACTOR, Search};
use crate::drive::outliers::{sigma_of, tails};
use crate::drive::pace::Paced;
use crate::drive::row::Drive;
use crate::drive::suspect::{Size, Standing, Suspect};
use crate::drive::tried::Tried;
use crate::error::Error;
use alloc::vec::Vec;
use filters::consistency::chi2_quantile;

/// So many rows are judged at most: what is kept of their readings needs 48 bytes for each.
pub const MOST_JUDGED: u32 = 200_000;
/// A sound log has a fault named with this probability, where its start is as uncertain as it is said to be.
const CHANCE: f64 = 0.03;

/// What is the same for all suspects of a log.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Scope {
    /// So many rows are judged.
    pub rows: u32,
    /// What the best of all gains by chance, by how many numbers it frees: none, one, a pair, the three of the start.
    pub chance: [f64; 4],
    /// How many pairs of landmarks are exchanged.
    pub pairs: f64,
    /// Readings from this row on count for delays: the same in every replay.
    pub from: u32,
    /// How far delays are changed, s.
    pub most: f64,
    /// Motion is read about so often, s.
    pub period: f64,
    /// So far ahead of the robot an antenna seems to stand where what is read is held until the next row, m.
    pub arm: f64,
}

impl Scope {
    /// That of a log in which so many suspects are tried, and how long it is, s.
    pub fn new(drive: &Drive, course: &Course, paced: &Paced, tried: usize) -> Result<(Self, f64), Error> {
        let rows = (drive.rows.len() as u32).min(MOST_JUDGED);
        let judged = &drive.rows[..rows as usize];
        let duration = judged.last().map_or(0.0, |row| row.time) - judged.first().map_or(0.0, |row| row.time);
        let most = most_delay(duration);
        let settled = course.start() + most + SETTLED;
        let share = CHANCE / tried as f64;
        let chance = |freedom: u32| chi2_quantile(freedom, 1.0 - share).map(|quantile| 0.5 * quantile);
        let scope = Self {
            rows,
            // Without a number to free, readings are e^g times likelier by chance in e^−g of all logs at most.
            chance: [-libm::log(share), chance(1)?, chance(2)?, chance(3)?],
            pairs: pairs(drive.landmarks.len()).max(1) as f64,
            from: judged.partition_point(|row| row.time < settled) as u32,
            most,
            period: duration / judged.iter().filter(|row| row.event.is_motion()).count().max(1) as f64,
            arm: paced.pace * paced.own_delay,
        };
        Ok((scope, duration))
    }
}

/// Suspects, and the replay beside which each is freed.
#[derive(Clone, Debug)]
pub(crate) struct Round {
    pub place: Trial,
    pub base: Option<Evidence>,
    pub tried: Vec<Tried>,
    /// Those that were looked at, each with the place where it is mended.
    pub found: Vec<(Suspect, Trial)>,
}

impl Round {
    pub fn new(place: Trial, tried: Vec<Tried>) -> Self {
        Self { place, base: None, found: Vec::with_capacity(tried.len()), tried }
    }

    /// Replays the log as it is, or looks at the next suspect; whether there was one.
    pub fn step(&mut self, drive: &Drive, scope: &Scope) -> Result<bool, Error> {
        let Some(base) = &self.base else {
            self.base = Some(Evidence::new(drive, &self.place, scope.rows)?);
            return Ok(true);
        };
        let Some(tried) = self.tried.get(self.found.len()) else { return Ok(false) };
        let looked = self.look(drive, scope, base, *tried);
        self.found.push(looked);
        Ok(true)
    }

    /// What another suspect has gained; nothing of one that was not looked at.
    fn gain_of(&self, tried: Tried) -> f64 {
        self.found.iter().find(|(suspect, _)| suspect.tried() == tried).map_or(0.0, |(suspect, _)| suspect.gain)
    }

    fn look(&self, drive: &Drive, scope: &Scope, base: &Evidence, tried: Tried) -> (Suspect, Trial) {
        let clock = tried.delays();
        let search = Search { drive, rows: scope.rows, from: if clock { scope.from } else { 0 }, base };
        let first = tried.first(&self.place);
        let place = |at: &[f64]| tried.place(&self.place, at);
        let numbers = Numbers {
            steps: tried.steps(&self.place, scope.period),
            bounds: tried.bounds(&first, scope.most),
            both: clock,
            others: tried.others(),
            rounds: if tried.is_far() { ROUNDS_OF_A_FACTOR } else { ROUNDS },
            place: &place,
            first,
        };
        let nothing = || Freed { at: numbers.first.clone(), sigmas: Vec::new(), gain: 0.0 };
        let (mut mended, mut landmarks, mut behind) = (None, Vec::new(), None);
        let freed = match tried {
            Tried::Outliers(sensor) => {
                let number = sigma_of(sensor, &self.tried).map(|number| (number, self.gain_of(Tried::Number(number))));
                tails(&search, sensor, place(&[]), number, scope.chance[1]).map(|found| {
                    (mended, behind) = (Some(found.place), found.sigma);
                    found.freed
                })
            }
            Tried::Mirrored | Tried::MirroredBearings => {
                let gain = search.replay(&place(&[])).map(|evidence| evidence.gain(base, search.from));
                gain.filter(|gain| gain.is_finite()).map(|gain| Freed { gain, ..nothing() })
            }
            Tried::Exchanged => likeliest(&search, &self.place).map(|(pair, gain)| {
                landmarks = pair.to_vec();
                let exchanged = Some(pair);
                mended = Some(Trial { otherwise: Otherwise { exchanged, ..self.place.otherwise }, ..self.place });
                Freed { gain, ..nothing() }
            }),
            Tried::Displaced | Tried::LandmarkBias => {
                let look = if tried == Tried::Displaced { displaced } else { biased };
                look(&search, &self.place).map(|(landmark, freed, place)| {
                    landmarks.push(landmark);
                    mended = Some(place);
                    freed
                })
            }
            _ => {
                let gated = base.refused(|sensor| self.place.settings.gate.of(sensor).is_some())[1] > 0;
                let far = |freed: &Freed| gated && freed.gain > scope.chance[tried.freedom()];
                let sigma = tried.fault() == Fault::Sigma;
                let freed = if sigma { search.sigma(&numbers) } else { search.means(&numbers) };
                freed.map(|freed| if far(&freed) { search.widened(&numbers, freed) } else { freed })
            }
        };
        let freed = freed.unwrap_or_else(nothing);
        let begin = Course::new(drive, self.place.settings)
            .map_or([0.0; 3], |course| [course.pose().x(), course.pose().y(), course.pose().theta()]);
        let which = tried.numbers();
        let size = |(i, at): (usize, &f64)| {
            let sigma = freed.sigmas.get(i).copied().unwrap_or(f64::INFINITY);
            let end = numbers.bounds.get(i).is_some_and(|bounds| bounds.contains(at));
            match (which.get(i), tried) {
                (Some(number), _) => {
                    let (now, value) = (number.value(numbers.first[i]), number.value(*at));
                    Size { now, value, sigma: if number.is_sigma() { value * sigma } else { sigma }, end }
                }
                (None, Tried::Displaced) => {
                    let stands = landmarks.first().and_then(|at| drive.landmarks.get(*at));
                    let now = stands.map_or(0.0, |landmark| if i == 0 { landmark.x } else { landmark.y });
                    Size { now, value: now + at, sigma, end }
                }
                (None, Tried::Antenna(delay)) => {
                    let arm = self.place.settings.antenna.get(i).copied();
                    let now = arm.or(delay.map(|delay| delay.get(&self.place.settings))).unwrap_or(0.0);
                    Size { now, value: now + at, sigma, end }
                }
                (None, Tried::Start) => Size { now: begin[i], value: begin[i] + at, sigma, end },
                (None, _) => Size { now: 0.0, value: *at, sigma, end },
            }
        };
        let mut sizes: Vec<Size> = freed.at.iter().enumerate().map(size).collect();
        if let (Tried::Together(_), &[by]) = (tried, freed.at.as_slice()) {
            let Size { sigma, end, .. } = sizes[0];
            let of = |number: &Fitted| {
                let now = number.get(&self.place.settings);
                Size { now, value: now + by, sigma, end }
            };
            sizes = which.iter().map(of).collect();
        }
        // The likeliest of several is likelier by chance.
        let among = match tried {
            Tried::Exchanged => scope.pairs,
            Tried::Displaced | Tried::LandmarkBias => drive.landmarks.len() as f64,
            _ => 1.0,
        };
        sizes.extend(behind.map(|(_, size)| size));
        let chance = scope.chance[tried.freedom() + usize::from(behind.is_some())] + libm::log(among);
        let id = |at: usize| drive.landmarks.get(at).map_or(0, |landmark| landmark.id);
        let mut suspect = Suspect {
            fault: tried.fault(),
            number: which.first().copied().or(behind.map(|(number, _)| number)),
            with: if let Tried::Antenna(delay) = tried { delay } else { which.get(1).copied() },
            sensor: if let Tried::Outliers(sensor) = tried { Some(sensor) } else { None },
            landmarks: landmarks.into_iter().map(id).collect(),
            sizes,
            claims: which.first().and_then(|number| number.claimed_by()).and_then(|sensor| drive.claims(sensor)),
            dilution: None,
            gain: freed.gain,
            excess: freed.gain - chance,
            standing: Standing::Cleared,
            own: false,
            flat: None,
            mended: None,
        };
        suspect.weigh();
        if suspect.is_small_arm(scope.arm) {
            suspect.excess = suspect.excess.min(0.0);
        }
        (suspect, mended.unwrap_or_else(|| place(&freed.at)))
    }
}
