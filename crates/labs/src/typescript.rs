//! The labs' TypeScript: every type that a lab takes or hands out.

use crate::declare::{About, Interface, Text, written};
use crate::{
    BenchParams, HookParams, LogParams, LoopParams, MuseumParams, OwnParams, PictureParams, ProbeParams, TuneParams,
};
use crate::{
    bug_museum, loop_closure, mapping, observability_probe, observer_bench, odometry_hook, own_system, picture,
    robot_log, series, shapes, tune,
};
use estimate::drive::{Line, Summary};
use estimate::{Complex, Landmark};
use geom::Ellipse;
use sim::Room;

/// What the labs take and hand out, and what that is made of.
const ALL: &[&[About]] = &[
    &[
        BenchParams::ABOUT,
        HookParams::ABOUT,
        ProbeParams::ABOUT,
        PictureParams::ABOUT,
        LogParams::ABOUT,
        LoopParams::ABOUT,
        TuneParams::ABOUT,
        MuseumParams::ABOUT,
        OwnParams::ABOUT,
    ],
    &[Complex::ABOUT, Ellipse::ABOUT, Landmark::ABOUT, Line::ABOUT, Summary::ABOUT, Room::ABOUT],
    shapes::INTERFACES,
    series::INTERFACES,
    mapping::INTERFACES,
    observer_bench::frame::INTERFACES,
    odometry_hook::frame::INTERFACES,
    observability_probe::frame::INTERFACES,
    observability_probe::ranks::INTERFACES,
    picture::frame::INTERFACES,
    robot_log::frame::INTERFACES,
    loop_closure::frame::INTERFACES,
    tune::frame::INTERFACES,
    bug_museum::frame::INTERFACES,
    own_system::frame::INTERFACES,
];

/// The interfaces of all labs, with their doc comments, limits and defaults. `Vector` and `Matrix` are not among them.
pub const TYPESCRIPT: &str = WRITTEN.as_str();

const WRITTEN: &Text<60_000> = &written(ALL);
