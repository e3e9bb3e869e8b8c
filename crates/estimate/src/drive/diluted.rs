//! Noise in the turns that are read makes them look larger than they are: where it is a part of what is read, the
//! likeliest turn is the smaller by that part, and no wheel is wrong (Fuller 1987, Measurement Error Models).

use crate::drive::evidence::Trial;
use crate::drive::fault::Fault;
use crate::drive::fitted::Fitted;
use crate::drive::gaps::median;
use crate::drive::round::{Round, Scope};
use crate::drive::row::{Drive, Event, Row};
use crate::drive::suspect::{Size, Standing, Suspect};
use crate::drive::tried::Tried;
use alloc::vec::Vec;

/// Over so long turns are summed, s: about as long as ranges and fixes need to tell one.
const WINDOW: f64 = 1.0;
/// So many times that part, and so many of its own standard deviations, a share of the turns may be.
const TIMES: f64 = 2.0;
const SIGMAS: f64 = 2.0;

/// How long readings need to tell a turn at least, s: a bearing or a heading tells it at once.
fn shortest(drive: &Drive) -> f64 {
    let tells = |row: &&Row| matches!(row.event, Event::Heading { .. } | Event::RangeBearing { .. });
    let mut times: Vec<f64> = drive.rows.iter().filter(tells).map(|row| row.time).collect();
    times.dedup();
    match median(times.windows(2).map(|pair| pair[1] - pair[0])) {
        step if step > 0.0 => step.min(WINDOW),
        _ => WINDOW,
    }
}

/// The mean square of the turn that rows of motion read in so long a time: rad², 0 where they are shorter than that.
///
/// Of windows of `window` seconds from row to row, Σ(Δθ)²/n with Δθ the sum of the turns that odometry reads and of the
/// turn rates, each held until the next row.
///
/// # Example
/// ```
/// use estimate::drive::{Event, Row, squared_turn};
/// let turns = |k: i32| Row::new(0.1 * f64::from(k), Event::TurnRate { omega: 0.2 });
/// let rows: Vec<Row> = (0..50).map(turns).collect();
/// assert!((squared_turn(&rows, 1.0) - 0.04).abs() < 1e-9);
/// ```
pub fn squared_turn(rows: &[Row], window: f64) -> f64 {
    let (mut sum, mut count, mut turned, mut from) = (0.0, 0.0, 0.0, None::<f64>);
    let (mut held, mut last) = (0.0, None::<f64>);
    for row in rows.iter().filter(|row| row.event.is_motion()) {
        let began = *from.get_or_insert(row.time);
        turned += held * (row.time - last.replace(row.time).unwrap_or(row.time));
        match row.event {
            Event::Odometry { turn, .. } => turned += turn,
            Event::Velocity { omega, .. } | Event::TurnRate { omega } => held = omega,
            _ => {}
        }
        if row.time - began >= window - ROUNDED {
            (sum, count, turned, from) = (sum + turned * turned, count + 1.0, 0.0, Some(row.time));
        }
    }
    if count > 0.0 { sum / count } else { 0.0 }
}

/// Which part of the square of what is read is noise, of which each second has σ².
fn part(noise: f64, drive: &Drive, window: f64) -> f64 {
    let squared = squared_turn(&drive.rows, window);
    if squared > 0.0 { (noise * noise * window / squared).min(1.0) } else { 0.0 }
}

/// The share of the turns that was found.
fn turned(suspect: &mut Suspect) -> Option<&mut Size> {
    let turns = suspect.fault == Fault::TurnScale || suspect.fault == Fault::Odometry && suspect.sizes.len() > 1;
    suspect.sizes.last_mut().filter(|_| turns)
}

/// Says of a share of the turns that it may be no fault, where noise of the turns does the same.
pub(crate) fn diluted(drive: &Drive, suspects: &mut [Suspect]) {
    let sigma = |suspect: &Suspect| suspect.number == Some(Fitted::SigmaTurn) && suspect.fault == Fault::Sigma;
    let noise = suspects.iter().find(|it| sigma(it)).and_then(|it| it.sizes.first()).map(|it| it.value.max(it.now));
    let Some(part) = noise.map(|noise| part(noise, drive, WINDOW)) else { return };
    for suspect in suspects.iter_mut().filter(|it| it.standing != Standing::Cleared) {
        let Some(Size { value, sigma, .. }) = turned(suspect).copied() else { continue };
        // Distances that are off are a fault of their own.
        let alone = suspect.sizes.len() > 1 && suspect.sizes[0].value.abs() < SIGMAS * suspect.sizes[0].sigma;
        if alone && value < 0.0 && -value < TIMES * part + SIGMAS * sigma && part > sigma {
            (suspect.own, suspect.standing) = (true, Standing::Maybe);
        }
    }
}

/// Says of a share of the turns that is named first which part of it noise may be, as that is once the share is mended:
/// up to all of that where the noise is in what is read, and nothing where it is in what the robot does.
pub(crate) fn noisy_turns(drive: &Drive, suspects: &mut [Suspect], places: &[Trial], scope: &Scope) {
    let (Some(suspect), Some(place)) = (suspects.first_mut(), places.first()) else { return };
    if suspect.standing == Standing::Cleared || suspect.own || turned(suspect).is_none() {
        return;
    }
    let mut round = Round::new(*place, alloc::vec![Tried::Number(Fitted::SigmaTurn)]);
    while matches!(round.step(drive, scope), Ok(true)) {}
    let noise = round.found.first().and_then(|(found, _)| found.sizes.first()).map(|size| size.value);
    let part = noise.map_or(0.0, |noise| part(noise, drive, shortest(drive)));
    let Some(size) = turned(suspect).filter(|size| part > LITTLE * size.sigma) else { return };
    size.sigma = libm::hypot(size.sigma, 0.5 * part);
    let told = size.value.abs() > SIGMAS * size.sigma;
    suspect.dilution = Some(part);
    // Of odometry the distances may be off all the same.
    if suspect.fault == Fault::TurnScale && !told {
        (suspect.own, suspect.standing) = (true, Standing::Maybe);
    }
}

/// Times of rows are so exact, s.
const ROUNDED: f64 = 1e-6;
/// A part of fewer of the size's own standard deviations is passed over.
const LITTLE: f64 = 0.5;

#[cfg(test)]
mod tests {
    use super::*;
    use crate::drive::row::Motion;
    use crate::drive::truth::Truth;

    #[test]
    fn the_square_is_of_the_turns_of_a_second() {
        let row = |k: i32| Row::new(0.25 * f64::from(k), Event::Odometry { distance: 0.1, turn: 0.05 });
        let of =
            |motion| Drive { landmarks: Vec::new(), truth: Truth::default(), rows: (0..9).map(row).collect(), motion };
        // The first second has the turn of the row that it begins with, too.
        let wanted = (0.25 * 0.25 + 0.2 * 0.2) / 2.0;
        assert!((squared_turn(&of(Motion::Odometry).rows, WINDOW) - wanted).abs() < 1e-12);
        let rates = |k: i32| Row::new(0.25 * f64::from(k), Event::Velocity { v: 1.0, omega: 0.2 });
        let held = Drive { rows: (0..9).map(rates).collect(), ..of(Motion::Velocity) };
        assert!((squared_turn(&held.rows, WINDOW) - 0.04).abs() < 1e-12, "{}", squared_turn(&held.rows, WINDOW));
        let none = Drive { rows: Vec::new(), ..of(Motion::Velocity) };
        assert_eq!(squared_turn(&none.rows, WINDOW), 0.0);
    }
}
