//! The one list of figures.

use crate::*;
use lab::{Figure, Kind};

/// Hands the list of figures to the macro `$with`: `labs::figures!(with)`. A line names the module and the lab, the
/// build of the module that has its class (`first` is at hand when a page opens, any other is fetched when such a
/// figure comes near), what a lab stands on that is none of its parameters, and the name that its addresses had before.
#[macro_export]
macro_rules! figures {
    ($with:ident) => {
        $with! {
            odometry_hook::OdometryHook in "first";
            error_cloud::ErrorCloud in "linear";
            cart_copy::CartCopy in "linear";
            observer_bench::ObserverBench in "linear";
            touch::Touch in "linear";
            two_bells::TwoBells in "linear";
            picture::Picture in "linear", was "kalman-picture";
            two_carts::TwoCarts in "late";
            observability_probe::ObservabilityProbe in "late";
            loop_closure::LoopClosure in "late", was "close-loop";
            tune::Tune in "late", was "tune-me";
            late_readings::LateReadings in "late";
            bug_museum::BugMuseum in "late";
            robot_log::RobotLog of DriveLog in "log";
            car_log::CarLog of DriveLog in "log";
            own_system::OwnSystem in "system";
            write_filter::WriteFilter in "filter";
        }
    };
}

macro_rules! listed {
    ($($module:ident::$lab:ident $(of $world:ident)? in $build:literal $(, was $was:literal)?;)*) => {
        /// Every figure, by the list.
        pub const FIGURES: &[Figure] = &[$(Figure {
            class: stringify!($lab),
            build: $build,
            world: !concat!($(stringify!($world))?).is_empty(),
            was: [$(Some($was),)? None][0],
            kind: const { &Kind::of::<$lab>() },
        }),*];
    };
}

figures!(listed);
