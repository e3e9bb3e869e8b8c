//! Noise in the turns that odometry reads makes them look larger than they are: where it is a part of what is read, the
//! likeliest turn is the smaller by that part, and no wheel is wrong.

use crate::drive::fault::Fault;
use crate::drive::fitted::Fitted;
use crate::drive::row::{Drive, Event};
use crate::drive::suspect::{Standing, Suspect};

/// Over so long turns are summed, s: about as long as readings need to tell one.
const WINDOW: f64 = 1.0;
/// So many times that part, and so many of its own standard deviations, a share of the turns may be.
const TIMES: f64 = 2.0;
const SIGMAS: f64 = 2.0;

/// The mean square of the turn of a second that odometry reads, rad²; 0 of other motion.
fn squared(drive: &Drive) -> f64 {
    let (mut sum, mut count, mut turned, mut from) = (0.0, 0.0, 0.0, None::<f64>);
    for row in &drive.rows {
        let Event::Odometry { turn, .. } = row.event else { continue };
        let began = *from.get_or_insert(row.time);
        turned += turn;
        if row.time - began >= WINDOW {
            (sum, count, turned, from) = (sum + turned * turned, count + 1.0, 0.0, Some(row.time));
        }
    }
    if count > 0.0 { sum / count } else { 0.0 }
}

/// Says of a share of odometry's turns that it may be no fault, where noise of the turns does the same: it is read with
/// σ² of the turn in each second.
pub(crate) fn diluted(drive: &Drive, suspects: &mut [Suspect]) {
    let sigma = |suspect: &Suspect| suspect.number == Some(Fitted::SigmaTurn) && suspect.fault == Fault::Sigma;
    let noise = suspects.iter().find(|it| sigma(it)).and_then(|it| it.sizes.first()).map(|it| it.value.max(it.now));
    let (Some(noise), squared) = (noise, squared(drive)) else { return };
    let part = if squared > 0.0 { (noise * noise * WINDOW / squared).min(1.0) } else { 0.0 };
    for suspect in suspects.iter_mut().filter(|it| it.fault == Fault::Odometry && it.standing != Standing::Cleared) {
        let [far, turned] = suspect.sizes.as_slice() else { continue };
        let small = far.value.abs() < SIGMAS * far.sigma;
        if small && turned.value < 0.0 && -turned.value < TIMES * part + SIGMAS * turned.sigma && part > turned.sigma {
            (suspect.own, suspect.standing) = (true, Standing::Maybe);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::drive::row::{Motion, Row};
    use crate::drive::truth::Truth;
    use alloc::vec::Vec;

    #[test]
    fn the_square_is_of_the_turns_of_a_second() {
        let row = |k: i32| Row::new(0.25 * f64::from(k), Event::Odometry { distance: 0.1, turn: 0.05 });
        let of =
            |motion| Drive { landmarks: Vec::new(), truth: Truth::default(), rows: (0..9).map(row).collect(), motion };
        // The first second has the turn of the row that it begins with, too.
        let wanted = (0.25 * 0.25 + 0.2 * 0.2) / 2.0;
        assert!((squared(&of(Motion::Odometry)) - wanted).abs() < 1e-12);
        let none = Drive { rows: Vec::new(), ..of(Motion::Velocity) };
        assert_eq!(squared(&none), 0.0);
    }
}
