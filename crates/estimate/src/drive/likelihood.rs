//! How likely a log is under some settings: what a search for noise levels and delays asks.

use crate::drive::course::Course;
use crate::drive::evidence::log_likelihood_of;
use crate::drive::replay::Replay;
use crate::drive::row::Drive;
use crate::drive::settings::Settings;
use crate::error::Error;
use crate::validate::finite;
use filters::consistency::chi2_quantile;

/// Σ −½ (ln det 2πS + d²) over the used readings that are stamped `from` or later, s; and how many these are.
///
/// Under settings that start at other times, or refuse other readings, it is a sum over other readings: a search
/// compares it with the gates off, and from a time behind every start. A gate's sum rewards what it refuses.
///
/// # Errors
/// As [`Course::new`] and [`Replay::take`], and [`crate::Code::NotFinite`] naming `from`.
///
/// # Example
/// ```
/// use estimate::drive::{Drive, Event, Motion, Row, Settings, Truth, log_likelihood};
/// let (drives, fix) = (Event::Velocity { v: 1.0, omega: 0.0 }, |x| Event::Position { x, y: 0.0, sigma: None });
/// let rows = [(0.0, drives), (0.0, fix(0.0)), (5.0, fix(5.2)), (10.0, fix(9.9))];
/// let rows = rows.map(|(time, event)| Row::new(time, event)).to_vec();
/// let drive = Drive { landmarks: Vec::new(), truth: Truth::default(), rows, motion: Motion::Velocity };
/// let of = |sigma_fix| log_likelihood(&drive, Settings { sigma_fix, ..Settings::default() }, 1.0);
/// let ((fine, two), (coarse, _)) = (of(0.2)?, of(20.0)?);
/// assert!(fine > coarse && two == 2);
/// # Ok::<(), estimate::Error>(())
/// ```
pub fn log_likelihood(drive: &Drive, settings: Settings, from: f64) -> Result<(f64, u32), Error> {
    finite(from, "from")?;
    let course = Course::new(drive, settings)?;
    let mut replay = Replay::new(&course);
    let (mut sum, mut used) = (0.0, 0);
    while let Some(taken) = replay.take(drive, &course)? {
        if let Some(judged) = taken.judged.filter(|judged| judged.used && drive.rows[taken.row].time >= from) {
            sum += judged.log_likelihood();
            used += 1;
        }
    }
    Ok((sum, used))
}

/// The log-likelihood of all readings that are stamped `from` or later, s, where those that a gate refuses are taken
/// for outliers, as a verdict takes them; how many they are, and how many of them are refused.
///
/// # Errors
/// As [`log_likelihood`].
pub(crate) fn with_outliers(drive: &Drive, settings: Settings, from: f64) -> Result<(f64, [u32; 2]), Error> {
    let course = Course::new(drive, settings)?;
    let mut replay = Replay::new(&course);
    let (mut sum, mut counts) = (0.0, [0, 0]);
    while let Some(taken) = replay.take(drive, &course)? {
        if let Some(judged) = taken.judged.filter(|_| drive.rows[taken.row].time >= from) {
            let gated = course.gates().of(judged.sensor).is_some();
            sum += log_likelihood_of(&judged, gated);
            counts = [counts[0] + 1, counts[1] + u32::from(!judged.used)];
        }
    }
    Ok((sum, counts))
}

/// A drive without the readings that the gates refuse.
///
/// # Errors
/// As [`log_likelihood`].
pub(crate) fn without_outliers(drive: &Drive, settings: Settings) -> Result<Drive, Error> {
    let course = Course::new(drive, settings)?;
    let mut replay = Replay::new(&course);
    let mut kept = alloc::vec![true; drive.rows.len()];
    while let Some(taken) = replay.take(drive, &course)? {
        kept[taken.row] = taken.judged.is_none_or(|judged| judged.used);
    }
    let rows = drive.rows.iter().zip(kept).filter_map(|(row, kept)| kept.then_some(*row)).collect();
    Ok(Drive { rows, ..drive.clone() })
}

/// How many of the used readings that are stamped `from` or later, s, lie beyond what holds `share` of them if the
/// model is right, and how many there are. More than 1 − `share` of them are outliers, or the model is wrong.
///
/// # Errors
/// As [`log_likelihood`], and where `share` is no probability.
pub fn beyond(drive: &Drive, settings: Settings, from: f64, share: f64) -> Result<[u32; 2], Error> {
    finite(from, "from")?;
    let within = [chi2_quantile(1, share)?, chi2_quantile(2, share)?];
    let course = Course::new(drive, settings)?;
    let mut replay = Replay::new(&course);
    let mut counts = [0, 0];
    while let Some(taken) = replay.take(drive, &course)? {
        if let Some(judged) = taken.judged.filter(|judged| judged.used && drive.rows[taken.row].time >= from) {
            counts[0] += u32::from(judged.d2 > within[usize::from(judged.outputs > 1)]);
            counts[1] += 1;
        }
    }
    Ok(counts)
}
