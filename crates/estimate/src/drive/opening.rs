//! Where a drive began, as far as its first fixes tell: a place to start a filter from where no truth says it.

use super::{Drive, Event};
use core::f64::consts::PI;

/// A second fix tells the heading once it is so many of its standard deviations away from the first.
const FAR: f64 = 5.0;

/// The start of a drive by its first fixes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Opening {
    /// x, y and θ: the first fix, and the direction to the first one far from it. Metres, radians.
    pub pose: [f64; 3],
    /// The standard deviation of x and of y, m: the fix's.
    pub sigma: f64,
    /// That of the heading, rad: √2 σ over the distance of the two fixes; π, which is no knowledge, where none is far.
    pub sigma_heading: f64,
}

impl Drive {
    /// The start by the first fixes; one without a standard deviation of its own takes `sigma`. `None` without a fix.
    ///
    /// The direction of the way is the heading of a robot that drives forward.
    pub fn opening(&self, sigma: f64) -> Option<Opening> {
        let fix = |event: &Event| match *event {
            Event::Position { x, y, sigma: own } => Some((x, y, own.unwrap_or(sigma))),
            _ => None,
        };
        let mut fixes = self.rows.iter().filter_map(|row| fix(&row.event));
        let (x, y, first) = fixes.next()?;
        // Either fix is off by its own σ in each direction.
        let apart = |&(px, py, own): &(f64, f64, f64)| (libm::hypot(px - x, py - y), libm::hypot(first, own));
        let far = fixes.map(|fix| (fix, apart(&fix))).find(|(_, (distance, off))| *distance > FAR * off);
        let (theta, sigma_heading) = match far {
            Some(((px, py, _), (distance, off))) => (libm::atan2(py - y, px - x), off / distance),
            None => (0.0, PI),
        };
        Some(Opening { pose: [x, y, theta], sigma: first, sigma_heading })
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Motion, Row, Truth};
    use super::*;
    use alloc::vec::Vec;

    fn drive(fixes: &[(f64, f64, Option<f64>)]) -> Drive {
        let row = |(i, &(x, y, sigma)): (usize, &(f64, f64, Option<f64>))| {
            Row::new(i as f64, Event::Position { x, y, sigma })
        };
        let rows: Vec<Row> = fixes.iter().enumerate().map(row).collect();
        Drive { landmarks: Vec::new(), truth: Truth::new(Vec::new()), rows, motion: Motion::Velocity }
    }

    #[test]
    fn the_first_fixes_tell_place_and_heading_and_how_well() {
        assert_eq!(drive(&[]).opening(1.0), None);
        let near = drive(&[(3.0, 4.0, None), (3.5, 4.0, None)]).opening(1.0).expect("a fix");
        assert_eq!(near, Opening { pose: [3.0, 4.0, 0.0], sigma: 1.0, sigma_heading: PI });
        // Seven σ are too near where both are off by one: five of √2 are 7.07.
        let fixes = [(3.0, 4.0, Some(0.1)), (3.7, 4.0, Some(0.1)), (3.0, 5.0, Some(0.1))];
        let far = drive(&fixes).opening(1.0).expect("a fix");
        assert_eq!((far.pose, far.sigma), ([3.0, 4.0, PI / 2.0], 0.1));
        assert!((far.sigma_heading - 0.1 * 2_f64.sqrt()).abs() < 1e-15, "{}", far.sigma_heading);
    }
}
