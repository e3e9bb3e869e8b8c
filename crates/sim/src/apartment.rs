//! The Apartment: a corridor about a block of two rooms, and room A beside it, as data.
//!
//! ```text
//!  y                                            7 ┌────────────── corridor ─────────────┐
//!                                                 │   ┌───────┬──door─┐                 │─────┐ 6
//!                                                 │   │   B   │   C   │                 door A│
//!                                                 │   └─door──┴───────┘                 │─────┘ 0
//!                                              −1 └─────────────────────────────────────┘
//! ```

use estimate::Landmark;
use geom::SE2;
use nalgebra::Vector2;
use serde::Serialize;

/// A straight wall between two points, metres.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wall {
    /// One end.
    pub from: [f64; 2],
    /// The other.
    pub to: [f64; 2],
}

/// A rectangular room.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Room {
    /// Its name.
    pub name: &'static str,
    /// West wall, metres.
    pub x: f64,
    /// South wall, metres.
    pub y: f64,
    /// West to east, metres.
    pub width: f64,
    /// South to north, metres.
    pub height: f64,
}

/// Rooms, walls and mapped corners.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Apartment {
    /// The rooms, the corridor not among them.
    pub rooms: &'static [Room],
    /// Every wall; doors are the gaps.
    pub walls: &'static [Wall],
    /// The outer corners of the corridor, which are on the map.
    pub corners: &'static [Landmark],
}

const fn wall(x1: f64, y1: f64, x2: f64, y2: f64) -> Wall {
    Wall { from: [x1, y1], to: [x2, y2] }
}

/// Room A, 6 × 6 m, east of the corridor. The Probe's map has its origin in this room's south-west corner.
const ROOM_A: Room = Room { name: "A", x: 11.0, y: 0.0, width: 6.0, height: 6.0 };

const ROOMS: [Room; 3] = [
    ROOM_A,
    Room { name: "B", x: 1.0, y: 1.0, width: 4.0, height: 4.0 },
    Room { name: "C", x: 5.0, y: 1.0, width: 4.0, height: 4.0 },
];

const WALLS: [Wall; 15] = [
    // The corridor's outer walls, 1 m outside the loop that the robot drives; a door to A in the east.
    wall(-1.0, -1.0, 11.0, -1.0),
    wall(11.0, -1.0, 11.0, 2.5),
    wall(11.0, 3.5, 11.0, 7.0),
    wall(11.0, 7.0, -1.0, 7.0),
    wall(-1.0, 7.0, -1.0, -1.0),
    // The block within the loop: B opens to the south, C to the north.
    wall(1.0, 1.0, 2.5, 1.0),
    wall(3.5, 1.0, 9.0, 1.0),
    wall(9.0, 1.0, 9.0, 5.0),
    wall(9.0, 5.0, 7.5, 5.0),
    wall(6.5, 5.0, 1.0, 5.0),
    wall(1.0, 5.0, 1.0, 1.0),
    wall(5.0, 1.0, 5.0, 5.0),
    // The rest of room A.
    wall(11.0, 0.0, 17.0, 0.0),
    wall(17.0, 0.0, 17.0, 6.0),
    wall(17.0, 6.0, 11.0, 6.0),
];

const CORNERS: [Landmark; 4] = [
    Landmark { id: 0, x: -1.0, y: -1.0 },
    Landmark { id: 1, x: 11.0, y: -1.0 },
    Landmark { id: 2, x: 11.0, y: 7.0 },
    Landmark { id: 3, x: -1.0, y: 7.0 },
];

/// The part of a sightline at each end that may touch a wall: a landmark in a corner stands on two walls.
const TOUCH: f64 = 1e-9;

impl Wall {
    /// Whether the wall stands between `a` and `b`: the sightline's inner part meets the wall, its ends included.
    ///
    /// A sightline along a wall is not blocked by it.
    pub fn blocks(&self, a: Vector2<f64>, b: Vector2<f64>) -> bool {
        let (p, q) = (Vector2::from(self.from), Vector2::from(self.to));
        let (sight, along, to) = (b - a, q - p, p - a);
        let cross = sight.perp(&along);
        if cross == 0.0 {
            return false;
        }
        let (t, s) = (to.perp(&along) / cross, to.perp(&sight) / cross);
        t > TOUCH && t < 1.0 - TOUCH && (0.0..=1.0).contains(&s)
    }
}

impl Apartment {
    /// The chapter's apartment.
    pub const fn new() -> Self {
        Self { rooms: &ROOMS, walls: &WALLS, corners: &CORNERS }
    }

    /// Room A.
    pub const fn room_a(&self) -> Room {
        ROOM_A
    }

    /// Whether no wall stands between the robot and the landmark.
    pub fn in_sight(&self, world_from_robot: SE2, landmark: &Landmark) -> bool {
        let a = Vector2::new(world_from_robot.x(), world_from_robot.y());
        let b = Vector2::new(landmark.x, landmark.y);
        self.walls.iter().all(|wall| !wall.blocks(a, b))
    }
}

impl Default for Apartment {
    fn default() -> Self {
        Self::new()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn walls_block_what_is_behind_them_and_nothing_else() {
        let wall = wall(0.0, 0.0, 0.0, 2.0);
        let sees = |x1: f64, y1: f64, x2: f64, y2: f64| !wall.blocks(Vector2::new(x1, y1), Vector2::new(x2, y2));
        assert!(!sees(-1.0, 1.0, 1.0, 1.0), "straight through");
        assert!(!sees(-1.0, 2.0, 1.0, 2.0), "the edge is part of the wall");
        assert!(sees(-1.0, 2.1, 1.0, 2.1), "past the end");
        assert!(sees(-2.0, 1.0, -1.0, 1.0), "before the wall");
        assert!(sees(-1.0, 1.0, 0.0, 0.0), "a corner is on the wall, not behind it");
        assert!(sees(0.0, -1.0, 0.0, 3.0), "along it");
    }

    #[test]
    fn doors_are_gaps_between_the_rooms_and_the_corridor() {
        let home = Apartment::new();
        let a = home.room_a();
        let inside = Landmark { id: 9, x: a.x + 3.0, y: a.y + 3.0 };
        assert!(home.in_sight(SE2::new(10.0, 3.0, 0.0), &inside), "through the door");
        assert!(!home.in_sight(SE2::new(10.0, 0.5, 0.0), &inside), "through the wall");
    }

    #[test]
    fn every_corner_is_seen_from_its_own_turn_and_not_across_the_block() {
        let home = Apartment::new();
        for (corner, turn) in home.corners.iter().zip([[0.0, 0.0], [10.0, 0.0], [10.0, 6.0], [0.0, 6.0]]) {
            assert!(home.in_sight(SE2::new(turn[0], turn[1], 0.0), corner));
            assert!(!home.in_sight(SE2::new(10.0 - turn[0], 6.0 - turn[1], 0.0), corner));
        }
    }

    #[test]
    fn rooms_are_walled_by_walls() {
        let home = Apartment::new();
        for room in home.rooms {
            for (x, y) in [(room.x, room.y), (room.x + room.width, room.y), (room.x, room.y + room.height)] {
                let on = home.walls.iter().any(|w| {
                    let (p, q) = (Vector2::from(w.from), Vector2::from(w.to));
                    let c = Vector2::new(x, y);
                    (c - p).norm() + (q - c).norm() <= (q - p).norm() + 1e-12
                });
                assert!(on, "{room:?}: no wall at ({x}, {y})");
            }
        }
    }
}
