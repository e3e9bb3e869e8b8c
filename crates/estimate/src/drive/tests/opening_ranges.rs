//! The start that the first ranges tell, of a drive without fixes.

use super::opening::normal;
use super::*;
use core::f64::consts::TAU;
use geom::wrap;

const SQUARE: [[f64; 2]; 4] = [[0.0, 0.0], [20.0, 1.0], [19.0, 14.0], [-1.0, 12.0]];

/// How a drive is made: from where, how it turns, and what is wrong with every 15th range.
struct Made<'a> {
    landmarks: &'a [[f64; 2]],
    start: [f64; 3],
    v: f64,
    omega: f64,
    sigma: f64,
    long: f64,
    bearings: bool,
    /// The noise of the turn rate, rad/s in each step of 0.1 s.
    drift: f64,
}

const USUAL: Made<'_> = Made {
    landmarks: &SQUARE,
    start: [5.0, 5.0, 0.7],
    v: 0.5,
    omega: 0.2,
    sigma: 0.1,
    long: 0.0,
    bearings: false,
    drift: 0.005,
};

impl Made<'_> {
    fn drive(&self, seed: &mut u64) -> Drive {
        let landmarks: Vec<Landmark> =
            self.landmarks.iter().enumerate().map(|(i, at)| Landmark { id: i as u32, x: at[0], y: at[1] }).collect();
        let ([mut x, mut y, mut theta], dt) = (self.start, 0.1);
        let mut rows = Vec::new();
        for k in 0..600_usize {
            let time = k as f64 * dt;
            let turned = self.omega * libm::cos(0.3 * time);
            let (v, omega) = (self.v + 0.02 * normal(seed), turned + self.drift * normal(seed));
            rows.push(Row::new(time, Event::Velocity { v: self.v, omega: turned }));
            if k % 2 == 0 {
                let landmark = (k / 2) % landmarks.len();
                let (dx, dy) = (landmarks[landmark].x - x, landmarks[landmark].y - y);
                let long = if k % 30 == 0 { self.long } else { 0.0 };
                let range = libm::hypot(dx, dy) + self.sigma * normal(seed) + long;
                let bearing = wrap(libm::atan2(dy, dx) - theta + 0.05 * normal(seed));
                rows.push(Row::new(
                    time,
                    match self.bearings {
                        true => Event::RangeBearing { landmark, range, bearing },
                        false => Event::Range { landmark, range },
                    },
                ));
            }
            (x, y) = (x + v * dt * libm::cos(theta), y + v * dt * libm::sin(theta));
            theta += omega * dt;
        }
        Drive { landmarks, truth: Truth::default(), rows, motion: Motion::Velocity }
    }
}

/// How far an opening is from where a drive began, in its standard deviations.
fn off(opening: &Opening, start: [f64; 3]) -> f64 {
    let Opening { pose, sigma, sigma_heading } = *opening;
    let sigmas = [sigma, sigma, sigma_heading];
    (0..3)
        .map(|i| (if i == 2 { wrap(pose[2] - start[2]) } else { pose[i] - start[i] }).abs() / sigmas[i])
        .fold(0.0, f64::max)
}

#[test]
fn ranges_to_four_landmarks_tell_where_a_drive_began_wherever_that_is() {
    let mut seed = 3;
    for i in 0..24 {
        let start = [-8.0 + 36.0 * ((7 * i) % 24) as f64 / 24.0, 20.0 - f64::from(i), TAU * f64::from(i) / 24.0 - PI];
        for made in [
            Made { start, ..USUAL },
            Made { start, sigma: 0.5, ..USUAL },
            Made { start, long: 2.0, ..USUAL },
            Made { start, bearings: true, landmarks: &SQUARE[..2], ..USUAL },
        ] {
            let drive = made.drive(&mut seed);
            let opening = drive.opening(&Settings::default()).expect("four landmarks tell it");
            assert!(off(&opening, start) < 4.0, "{i}: {opening:?} of {start:?}");
            assert!(opening.sigma < 2.0 && opening.sigma_heading < 0.3, "{i}: {opening:?}");
        }
    }
}

/// One by one the readings would tell the heading to a third of what it is off by: each has the drift of all before it.
#[test]
fn what_the_motion_has_drifted_is_counted_as_one_error_that_goes_on() {
    let mut seed = 11;
    let made = Made { bearings: true, drift: 0.15, ..USUAL };
    // In a second it drifts by 0.15 rad/s 0.1 s √10.
    let settings = Settings { sigma_range: 0.1, sigma_bearing: 0.05, sigma_turn: 0.047, ..Settings::default() };
    let mut sum = 0.0;
    for _ in 0..60 {
        let opening = made.drive(&mut seed).opening(&settings).expect("four landmarks tell it");
        let off = wrap(opening.pose[2] - made.start[2]) / opening.sigma_heading;
        sum += off * off;
    }
    // Its σ is √2 times as large, as the filter reads the same readings again.
    let rms = libm::sqrt(sum / 60.0);
    assert!((0.5..0.9).contains(&rms), "{rms}");
}

/// Offsets and a scale that are set are taken off before.
#[test]
fn a_start_is_told_by_ranges_and_bearings_as_the_settings_read_them() {
    let mut drive = Made { bearings: true, ..USUAL }.drive(&mut 13);
    for row in &mut drive.rows {
        if let Event::RangeBearing { range, bearing, .. } = &mut row.event {
            (*range, *bearing) = (1.05 * *range + 0.4, *bearing + 0.3);
        }
    }
    let set = Settings { scale: 0.05, offset: 0.4, bearing_offset: 0.3, ..Settings::default() };
    let opening = drive.opening(&set).expect("four landmarks tell it");
    assert!(off(&opening, USUAL.start) < 3.0, "{opening:?}");
    let unset = drive.opening(&Settings::default());
    assert!(unset.is_none_or(|it| wrap(it.pose[2] - USUAL.start[2]).abs() > 0.2), "{unset:?}");
}

#[test]
fn of_a_start_and_its_mirrored_twin_none_is_taken() {
    let mut seed = 5;
    let line = [[0.0, 0.0], [10.0, 0.0], [20.0, 0.0]];
    // On one line of landmarks a robot that drives straight has a twin on the other side.
    let straight = Made { landmarks: &line, omega: 0.0, ..USUAL }.drive(&mut seed);
    assert_eq!(straight.opening(&Settings::default()), None);
    // One that turns left has a twin that turns right, which is not what was read.
    let turning = Made { landmarks: &line, omega: 0.4, ..USUAL };
    let opening = turning.drive(&mut seed).opening(&Settings::default()).expect("its turns tell it");
    assert!(off(&opening, turning.start) < 4.0, "{opening:?}");
}

#[test]
fn a_robot_that_stands_has_a_place_and_no_heading() {
    let stands = Made { v: 0.0, omega: 0.0, ..USUAL };
    let opening = stands.drive(&mut 7).opening(&Settings::default());
    // What jitters about it may be its motion, and tells next to nothing.
    assert!(opening.is_none_or(|it| off(&it, [5.0, 5.0, it.pose[2]]) < 4.0 && it.sigma_heading > 0.3), "{opening:?}");
}

/// Round a landmark all starts on a circle fit.
#[test]
fn a_circle_about_the_only_landmark_tells_nothing() {
    let landmarks = vec![Landmark { id: 1, x: 0.0, y: 10.0 }];
    let row = |k: i32, event| Row::new(f64::from(k), event);
    let range = Event::Range { landmark: 0, range: 10.0 };
    let rows = (0..2000).flat_map(|k| [row(k, odometry(0.1, 0.01)), row(k, range)]).collect();
    let drive = Drive { landmarks, truth: Truth::default(), rows, motion: Motion::Odometry };
    assert_eq!(drive.opening(&Settings::default()), None);
}

#[test]
fn ranges_of_another_world_and_too_few_tell_nothing() {
    let mut drive = USUAL.drive(&mut 9);
    for (i, row) in drive.rows.iter_mut().enumerate() {
        if let Event::Range { range, .. } = &mut row.event {
            *range = 3.0 + ((i * 7919) % 37) as f64;
        }
    }
    assert_eq!(drive.opening(&Settings::default()), None);
    let mut few = USUAL.drive(&mut 9);
    few.rows.truncate(4);
    assert_eq!(few.opening(&Settings::default()), None);
}

/// While it stands and sees one landmark a robot may be anywhere around that: its first readings alone tell no start.
#[test]
fn a_robot_that_stands_before_one_landmark_begins_where_its_later_readings_say() {
    let mut seed = 17;
    let [x, y, theta] = USUAL.start;
    let (dx, dy) = (SQUARE[2][0] - x, SQUARE[2][1] - y);
    let stands = Event::Velocity { v: 0.0, omega: 0.0 };
    for _ in 0..6 {
        let later = Made { bearings: true, ..USUAL }.drive(&mut seed);
        let seen = |seed: &mut u64| Event::RangeBearing {
            landmark: 2,
            range: libm::hypot(dx, dy) + 0.06 * normal(seed),
            bearing: wrap(libm::atan2(dy, dx) - theta + 0.015 * normal(seed)),
        };
        let before = (0..100).flat_map(|k| [stands, seen(&mut seed)].map(|it| Row::new(0.2 * f64::from(k), it)));
        let mut rows: Vec<Row> = before.collect();
        let alone = Drive { rows: rows.clone(), ..later.clone() };
        assert_eq!(alone.opening(&Settings::default()), None, "one landmark tells no place");
        rows.extend(later.rows.iter().map(|row| Row { time: row.time + 20.0, ..*row }));
        let opening = Drive { rows, ..later }.opening(&Settings::default()).expect("four landmarks tell it");
        assert!(off(&opening, USUAL.start) < 4.0 && opening.sigma > 0.01, "{opening:?}");
    }
}
