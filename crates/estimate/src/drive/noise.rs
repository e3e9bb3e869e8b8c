//! Whether the innovations look like noise. Where they do not, something is wrong that may be none of the suspects: a
//! receiver that is off for a minute, a sensor whose errors are alike from one reading to the next.

use crate::drive::evidence::Weighed;
use crate::drive::row::Drive;
use crate::drive::sensor::Sensor;
use crate::drive::thinning::{lag1, squared};
use alloc::vec::Vec;
use filters::consistency::chi2_quantile;

/// The readings are looked at in so many parts, of so many readings at least.
const PARTS: usize = 60;
const FEWEST: usize = 20;
/// A log without a fault has a part that stands out with this probability.
const CHANCE: f64 = 0.001;
/// A part stands out where NIS, or the share that is refused, is so many times that of the others.
const TIMES: f64 = 1.5;
/// Innovations are correlated by so much, and by so many standard deviations of chance.
const LEAST: f64 = 0.1;
const DEVIATIONS: f64 = 5.0;

/// A stretch of a log that stands out, seconds since its first row, with what it has there and elsewhere.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stretch {
    /// From when to when.
    pub times: [f64; 2],
    /// What it has.
    pub there: f64,
    /// What the others have.
    pub elsewhere: f64,
}

/// A sensor whose innovations are correlated from one to the next.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Correlated {
    /// Whose.
    pub sensor: Sensor,
    /// The autocorrelation at lag 1.
    pub by: f64,
    /// The standard deviation that it has by chance.
    pub chance: f64,
}

/// What does not look like noise.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Noise {
    /// Where NIS for each output is high.
    pub nis: Option<Stretch>,
    /// Where gates refuse more than elsewhere, as a share.
    pub refused: Option<Stretch>,
    /// The sensor that is correlated most.
    pub correlated: Option<Correlated>,
}

/// How many numbers a sensor reads at once.
fn outputs(sensor: Sensor) -> u32 {
    if matches!(sensor, Sensor::Fix | Sensor::Bearing) { 2 } else { 1 }
}

/// What of a replay's innovations does not look like noise.
pub(crate) fn noise(drive: &Drive, readings: &[Weighed]) -> Noise {
    if readings.len() < 2 * FEWEST {
        return Noise::default();
    }
    let size = (readings.len() / PARTS).max(FEWEST);
    let parts: Vec<&[Weighed]> = readings.chunks(size).filter(|part| part.len() >= FEWEST).collect();
    let used = |part: &[Weighed]| -> (f64, f64) {
        let all = part.iter().filter(|it| it.used);
        all.fold((0.0, 0.0), |(sum, count), it| (sum + squared(it), count + f64::from(outputs(it.sensor))))
    };
    let level = 1.0 - CHANCE / parts.len() as f64;
    let wild = |(sum, count): (f64, f64)| {
        count >= 1.0 && chi2_quantile(count as u32, level).is_ok_and(|quantile| sum > quantile)
    };
    let refused = |part: &[Weighed]| (part.iter().filter(|it| !it.used).count() as f64, part.len() as f64);
    let (out, all) = refused(readings);
    let share = out / all;
    let many = |(count, of): (f64, f64)| {
        // So many of a Poisson distribution: P(X ≥ n) = P(χ²₂ₙ < 2m).
        let chance = chi2_quantile(2 * count as u32, CHANCE / parts.len() as f64);
        count > 0.0 && chance.is_ok_and(|quantile| 2.0 * share * of < quantile)
    };
    Noise {
        nis: standing_out(drive, &parts, used, wild),
        refused: standing_out(drive, &parts, refused, many),
        correlated: correlated(readings),
    }
}

/// The parts that stand out in a row about the one that does most: a sum over each, and the count that it is over.
fn standing_out(
    drive: &Drive,
    parts: &[&[Weighed]],
    of: impl Fn(&[Weighed]) -> (f64, f64),
    out: impl Fn((f64, f64)) -> bool,
) -> Option<Stretch> {
    let sums: Vec<(f64, f64)> = parts.iter().map(|part| of(part)).collect();
    let is_out: Vec<bool> = sums.iter().map(|sum| out(*sum)).collect();
    let mean = |(sum, count): (f64, f64)| if count > 0.0 { sum / count } else { 0.0 };
    let most =
        (0..parts.len()).filter(|i| is_out[*i]).max_by(|one, other| mean(sums[*one]).total_cmp(&mean(sums[*other])))?;
    let begin = (0..=most).rev().take_while(|i| is_out[*i]).last()?;
    let end = (most..parts.len()).take_while(|i| is_out[*i]).last()?;
    let total = |within: bool| {
        let chosen = sums.iter().enumerate().filter(|(i, _)| (begin..=end).contains(i) == within);
        mean(chosen.fold((0.0, 0.0), |(sum, count), (_, it)| (sum + it.0, count + it.1)))
    };
    let (there, elsewhere) = (total(true), total(false));
    let time = |reading: &Weighed| drive.rows[reading.row as usize].time - drive.rows[0].time;
    let times = [time(parts[begin].first()?), time(parts[end].last()?)];
    (there > TIMES * elsewhere).then_some(Stretch { times, there, elsewhere })
}

/// The sensor whose used innovations are correlated most from one to the next, where chance does not explain it.
fn correlated(readings: &[Weighed]) -> Option<Correlated> {
    let all = [Sensor::Fix, Sensor::Heading, Sensor::Range, Sensor::Bearing].into_iter().filter_map(|sensor| {
        let (count, by) = lag1(readings, sensor);
        let chance = 1.0 / libm::sqrt(count as f64 * f64::from(outputs(sensor)));
        (by.abs() > LEAST.max(DEVIATIONS * chance)).then_some(Correlated { sensor, by, chance })
    });
    all.max_by(|one, other| (one.by.abs() / one.chance).total_cmp(&(other.by.abs() / other.chance)))
}
