//! How far a robot drives in a second: what the noise of its distance is to be held against.

use crate::drive::judgement::{own_delay, period};
use crate::drive::row::{Drive, Event};
use crate::drive::settings::Settings;

/// What a fit's numbers are held against.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Paced {
    pub pace: f64,
    pub half_turn: f64,
    pub period: f64,
    pub own_delay: f64,
}

impl Paced {
    pub fn new(drive: &Drive, settings: &Settings) -> Self {
        let period = period(&drive.rows);
        let own_delay = own_delay(drive.motion, false, period);
        Self { pace: pace(drive, settings), half_turn: half_turn(drive), period, own_delay }
    }
}

/// A step between rows of motion: how long it took, and how far the robot went and turned on it, as it is read.
struct Step {
    dt: f64,
    distance: f64,
    turn: f64,
}

fn steps(drive: &Drive) -> impl Iterator<Item = Step> {
    let (mut held, mut last) = ([0.0; 2], None);
    drive.rows.iter().filter_map(move |row| {
        let (next, gone) = match row.event {
            Event::Odometry { distance, turn } => ([0.0; 2], Some([distance, turn])),
            Event::Velocity { v, omega } => ([v, omega], None),
            Event::Speed { v } => ([v, held[1]], None),
            Event::TurnRate { omega } => ([held[0], omega], None),
            _ => return None,
        };
        let dt = row.time - last.unwrap_or(row.time);
        let [distance, turn] = gone.unwrap_or(held.map(|rate| rate * dt));
        (held, last) = (next, Some(row.time));
        Some(Step { dt, distance, turn })
    })
}

/// The mean distance of a second in which the robot drives, m, by what is read and its scale; 0 where it never does.
pub(crate) fn pace(drive: &Drive, settings: &Settings) -> f64 {
    let driven = steps(drive).filter(|step| step.distance != 0.0 && step.dt > 0.0);
    let (way, time) = driven.fold((0.0, 0.0), |(way, time), step| (way + step.distance.abs(), time + step.dt));
    if time > 0.0 { (1.0 + settings.speed_scale) * way / time } else { 0.0 }
}

/// Half of the mean turn of a step, rad, counted by its distance; 0 where the robot never drives, or turns on its way.
pub(crate) fn half_turn(drive: &Drive) -> f64 {
    if drive.motion.is_even() {
        return 0.0;
    }
    let sum = |(way, turned), Step { distance, turn, .. }: Step| (way + distance.abs(), turned + distance.abs() * turn);
    let (way, turned) = steps(drive).fold((0.0, 0.0), sum);
    if way > 0.0 { 0.5 * turned / way } else { 0.0 }
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

    #[test]
    fn half_a_turn_is_counted_by_the_way_of_its_step() {
        let half = |motion, events: &[Event]| {
            let rows = events.iter().enumerate().map(|(k, event)| Row::new(0.5 * k as f64, *event)).collect();
            half_turn(&Drive { landmarks: Vec::new(), truth: Truth::default(), rows, motion })
        };
        let o = |distance, turn| Event::Odometry { distance, turn };
        assert!((half(Motion::Odometry, &[o(0.3, 0.1), o(-0.1, 0.3), o(0.0, 9.0)]) - 0.075).abs() < 1e-12);
        assert_eq!(half(Motion::EvenOdometry, &[o(0.3, 0.1), o(-0.1, 0.3)]), 0.0);
        let v = |v, omega| Event::Velocity { v, omega };
        assert!((half(Motion::Velocity, &[v(1.0, 0.2), v(0.0, 5.0), v(1.0, 0.0)]) - 0.05).abs() < 1e-12);
        assert_eq!(half(Motion::Velocity, &[v(0.0, 1.0), v(0.0, 1.0)]), 0.0);
    }
}
