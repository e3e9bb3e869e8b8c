//! How far a robot drives in a second: what the noise of its distance is to be held against.

use crate::drive::row::{Drive, Event};
use crate::drive::settings::Settings;

/// The mean distance of a second in which the robot drives, m, by what is read and its scale; 0 where it never does.
pub(crate) fn pace(drive: &Drive, settings: &Settings) -> f64 {
    let (mut way, mut driven, mut held, mut last) = (0.0, 0.0, 0.0_f64, None);
    for row in &drive.rows {
        let (next, gone): (f64, Option<f64>) = match row.event {
            Event::Odometry { distance, .. } => (0.0, Some(distance)),
            Event::Velocity { v, .. } | Event::Speed { v } => (v, None),
            _ => continue,
        };
        let dt = row.time - last.unwrap_or(row.time);
        let distance = gone.unwrap_or(held * dt).abs();
        if distance > 0.0 && dt > 0.0 {
            (way, driven) = (way + distance, driven + dt);
        }
        (held, last) = (next, Some(row.time));
    }
    if driven > 0.0 { (1.0 + settings.speed_scale) * way / driven } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::drive::row::{Motion, Row};
    use crate::drive::truth::Truth;
    use alloc::vec::Vec;

    fn paced(motion: Motion, events: &[Event], settings: Settings) -> f64 {
        let rows = events.iter().enumerate().map(|(k, event)| Row::new(0.5 * k as f64, *event)).collect();
        pace(&Drive { landmarks: Vec::new(), truth: Truth::default(), rows, motion }, &settings)
    }

    #[test]
    fn a_pace_is_the_way_by_the_time_in_which_the_robot_drives() {
        let v = |v| Event::Velocity { v, omega: 0.1 };
        let held = [v(2.0), v(0.0), v(-4.0), Event::Heading { theta: 0.0, sigma: None }, v(1.0)];
        // 2 m/s for 0.5 s, nothing for as long, 4 m/s back for 1 s.
        assert!((paced(Motion::Velocity, &held, Settings::default()) - 5.0 / 1.5).abs() < 1e-12);
        let scaled = Settings { speed_scale: -0.5, ..Settings::default() };
        assert!((paced(Motion::Velocity, &held, scaled) - 2.5 / 1.5).abs() < 1e-12);
        let o = |distance| Event::Odometry { distance, turn: 0.0 };
        assert!((paced(Motion::Odometry, &[o(0.0), o(0.3), o(0.0), o(-0.5)], Settings::default()) - 0.8).abs() < 1e-12);
        assert_eq!(paced(Motion::Velocity, &[v(0.0), v(0.0)], Settings::default()), 0.0);
        assert_eq!(paced(Motion::Velocity, &[], Settings::default()), 0.0);
    }
}
