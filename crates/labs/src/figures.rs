//! The one list of figures.

use crate::*;
use lab::Kind;
use std::borrow::Cow;

/// Hands the list of figures to the macro `$with`: `labs::figures!(with)`. A line names the lab, the build of the module that has
/// its class (`figures` is at hand when a page opens, any other is fetched when such a figure comes near), what a lab stands on that
/// is none of its parameters, and the name that its addresses had before.
#[macro_export]
macro_rules! figures {
    ($with:ident) => {
        $with! {
            ObserverBench in "figures";
            OdometryHook in "figures";
            Picture in "figures", was "kalman-picture";
            ObservabilityProbe in "late";
            LoopClosure in "late", was "close-loop";
            Tune in "late", was "tune-me";
            BugMuseum in "late";
            RobotLog of DriveLog in "log";
            OwnSystem in "system";
        }
    };
}

/// A figure, and the lab behind it.
#[derive(Debug)]
pub struct Figure {
    /// The class of its lab in the module.
    pub class: &'static str,
    /// The build of the module that has the class.
    pub build: &'static str,
    /// Whether the lab stands on something from outside.
    pub world: bool,
    /// What the figure was called before.
    pub was: Option<&'static str>,
    /// What is known of the lab, its name among it.
    pub kind: &'static Kind,
}

impl Figure {
    /// The name of the figure: its lab's in links, its folder's in `web/widgets`, its page's in `figure/`.
    pub fn name(&self) -> &'static str {
        self.kind.name
    }

    /// The custom element that shows it. Its name must have a hyphen: a name without one gets `lab-` before it.
    pub fn tag(&self) -> Cow<'static, str> {
        let name = self.name();
        if name.contains('-') { name.into() } else { format!("lab-{name}").into() }
    }
}

macro_rules! listed {
    ($($lab:ident $(of $world:ident)? in $build:literal $(, was $was:literal)?;)*) => {
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
