//! The courses of the chapter, as ticks: a length along the heading, then a turn on the spot.

use core::f64::consts::{FRAC_PI_2, PI};
use geom::SE2;
use nalgebra::Vector3;

/// What the robot drives in one sampling period.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tick {
    /// Ahead along the heading before the turn, metres.
    pub ds: f64,
    /// Then turned counter-clockwise, radians.
    pub dtheta: f64,
}

impl Tick {
    /// The pose after the tick: `ds` along the old heading, then the turn. This is the truth; the estimator's own model
    /// of it is [`estimate::Unicycle`].
    pub fn drive(self, world_from_robot: SE2) -> SE2 {
        let (sin, cos) = libm::sincos(world_from_robot.theta());
        world_from_robot.boxplus(&Vector3::new(self.ds * cos, self.ds * sin, self.dtheta))
    }
}

/// A rectangle driven counter-clockwise from its first corner along its first side, for ever; each quarter turn falls
/// into the last tick of a side.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rectangle {
    /// Where the first side begins, and its direction.
    pub start: [f64; 3],
    /// Ticks of the first and third side, and of the second and fourth.
    pub ticks: [u32; 2],
    /// Metres a tick.
    pub ds: f64,
}

/// The Probe's square in room A: 3 m sides from (1.5, 1.5) in the room's own frame, 120 ticks of 0.1 m a lap.
pub const SQUARE: Rectangle = Rectangle { start: [1.5, 1.5, 0.0], ticks: [30, 30], ds: 0.1 };

/// The corridor's loop: 10 × 6 m from (0, 0), 640 ticks of 0.05 m a lap.
pub const LOOP: Rectangle = Rectangle { start: [0.0, 0.0, 0.0], ticks: [200, 120], ds: 0.05 };

/// The same loop in longer ticks, 128 of 0.25 m a lap.
pub const CORRIDOR: Rectangle = Rectangle { ticks: [40, 24], ds: 0.25, ..LOOP };

/// Two straights joined by two half circles, driven counter-clockwise for ever.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stadium {
    /// Where the first straight begins, and its direction.
    pub start: [f64; 3],
    /// Ticks of a straight.
    pub straight: u32,
    /// Ticks of a half circle, each with an equal part of its turn.
    pub bend: u32,
    /// Metres a tick.
    pub ds: f64,
}

impl Stadium {
    /// Where the course begins.
    pub fn start(&self) -> SE2 {
        SE2::new(self.start[0], self.start[1], self.start[2])
    }

    /// Ticks a lap.
    pub fn lap(&self) -> u32 {
        2 * (self.straight + self.bend)
    }

    /// Tick `k` of the course, counted from 0.
    pub fn tick(&self, k: u32) -> Tick {
        let turns = k % (self.straight + self.bend) >= self.straight;
        Tick { ds: self.ds, dtheta: if turns { PI / f64::from(self.bend) } else { 0.0 } }
    }
}

impl Rectangle {
    /// Where the course begins.
    pub fn start(&self) -> SE2 {
        SE2::new(self.start[0], self.start[1], self.start[2])
    }

    /// Ticks a lap.
    pub fn lap(&self) -> u32 {
        2 * (self.ticks[0] + self.ticks[1])
    }

    /// Tick `k` of the course, counted from 0.
    pub fn tick(&self, k: u32) -> Tick {
        let [first, second] = self.ticks;
        let within = k % (first + second);
        let turns = within == first - 1 || within == first + second - 1;
        Tick { ds: self.ds, dtheta: if turns { FRAC_PI_2 } else { 0.0 } }
    }

    /// The four corners, in the order in which they are passed, the start first.
    pub fn corners(&self) -> [[f64; 2]; 4] {
        let mut pose = self.start();
        [0, 1, 2, 3].map(|side| {
            let corner = [pose.x(), pose.y()];
            let length = self.ds * f64::from(self.ticks[side % 2]);
            pose = Tick { ds: length, dtheta: FRAC_PI_2 }.drive(pose);
            corner
        })
    }

    /// The poses at ticks 0, 1, 2, …, the start first.
    pub fn poses(&self) -> impl Iterator<Item = SE2> {
        let course = *self;
        let mut pose = course.start();
        (0..).map(move |k| {
            let now = pose;
            pose = course.tick(k).drive(pose);
            now
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_lap_closes() {
        for (course, ticks) in [(SQUARE, 120), (LOOP, 640), (CORRIDOR, 128)] {
            assert_eq!(course.lap(), ticks);
            let end = course.poses().nth(ticks as usize).expect("it goes on for ever");
            assert!(end.boxminus(course.start()).norm() < 1e-12);
        }
    }

    #[test]
    fn the_square_turns_in_the_last_tick_of_a_side() {
        assert_eq!(SQUARE.tick(28), Tick { ds: 0.1, dtheta: 0.0 });
        assert_eq!(SQUARE.tick(29), Tick { ds: 0.1, dtheta: FRAC_PI_2 });
        assert_eq!(SQUARE.tick(149), SQUARE.tick(29));
        let corner = SQUARE.poses().nth(30).expect("for ever");
        assert!(corner.boxminus(SE2::new(4.5, 1.5, FRAC_PI_2)).norm() < 1e-12);
    }

    #[test]
    fn the_loop_is_ten_by_six() {
        let turns: Vec<u32> = (0..640).filter(|k| LOOP.tick(*k).dtheta != 0.0).collect();
        assert_eq!(turns, [199, 319, 519, 639]);
        for (corner, expected) in LOOP.corners().iter().zip([[0.0, 0.0], [10.0, 0.0], [10.0, 6.0], [0.0, 6.0]]) {
            assert!((corner[0] - expected[0]).abs() < 1e-12 && (corner[1] - expected[1]).abs() < 1e-12);
        }
    }
}
