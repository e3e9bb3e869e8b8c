//! One table may hold the motion, the ranges and the positions of a robot: it is read once for each.

use crate::file::File;
use crate::guess::{IS_TRUE, moving};
use crate::holds::{Again, Holds};
use crate::names::candidates;
use crate::question::Question;
use crate::role::{Quantity, Role};
use crate::true_names::{has_coordinates, has_place, has_truth, is_received, is_reckoned};
use crate::wide;

/// Reads the tables once more that hold what they are not read as, behind all that were added, and no longer those that
/// do not. What is taken out of a log changes no index of a file that was added. Answers which are new.
pub(crate) fn again(files: &mut Vec<File>) -> Vec<usize> {
    let mut new = Vec::new();
    for of in 0..added(files) {
        for holds in [Holds::Truth, Holds::Positions, Holds::Motion, Holds::Ranges] {
            let it = Again { of, holds };
            let there = files.iter().position(|file| file.again == Some(it));
            match (wanted(files, it), there) {
                (Some(role), None) => {
                    files.push(files[of].once_more(it, role));
                    new.push(files.len() - 1);
                }
                (None, Some(at)) => {
                    files.remove(at);
                    new = new.into_iter().filter(|it| *it != at).map(|it| it - usize::from(it > at)).collect();
                }
                _ => {}
            }
        }
    }
    new
}

/// How many of the files were added.
pub(crate) fn added(files: &[File]) -> usize {
    files.iter().take_while(|file| file.again.is_none()).count()
}

/// As what a file is to be read once more.
fn wanted(files: &[File], Again { of, holds }: Again) -> Option<Role> {
    let file = &files[of];
    let (names, role) = (&file.source.names, file.role());
    let ranges = matches!(role, Role::Ranges | Role::Sightings);
    let counted = matches!(role, Role::Encoders | Role::Odometry);
    let driven = counted || role == Role::Reckoned;
    let called = has_truth(names);
    match holds {
        Holds::Truth => {
            let other = ranges || driven || matches!(role, Role::Velocities | Role::Sensors);
            (other && called).then_some(Role::Truth)
        }
        Holds::Positions => {
            let truth = role == Role::Truth && called;
            match () {
                () if (ranges || driven || truth) && has_coordinates(names, false) => Some(Role::Sensors),
                () if (truth || counted || role == Role::Ranges) && has_place(names, false) => {
                    Some(if is_received(names) { Role::Sensors } else { Role::Undecided })
                }
                () => None,
            }
        }
        Holds::Motion if ranges || role == Role::Truth => {
            let beside = |at: usize, file: &File| at != of && (file.may_move() || file.role() == Role::Undecided);
            let moves = files.iter().enumerate().any(|(at, file)| beside(at, file) && !is_motion_of(file, of));
            moving(names, file.name()).filter(|_| !moves)
        }
        // Wheels beside a gyro: it says the turn and they say the speed, where nothing else does.
        Holds::Motion if role == Role::Sensors && file.source.column("v").is_none() => {
            let beside = |at: usize, file: &File| at != of && !is_motion_of(file, of) && may_drive(file);
            let driven = files.iter().enumerate().any(|(at, file)| beside(at, file));
            moving(names, file.name()).filter(|role| !driven && is_its_own(file, *role))
        }
        Holds::Ranges if !ranges && (driven || matches!(role, Role::Velocities | Role::Sensors | Role::Truth)) => {
            (wide::group(names).is_some() || !file.source.called.is_empty()).then_some(Role::Ranges)
        }
        _ => None,
    }
}

/// Whether a table of sensors has a motion of its own: the speeds or counts of two wheels, or poses of odometry that
/// are not its fixes; and no speed.
fn is_its_own(file: &File, role: Role) -> bool {
    let names = &file.source.names;
    let fixes = file.source.column("x").is_some_and(|at| is_reckoned(&names[at]));
    let alone = candidates("v", Quantity::Speed, names).is_empty();
    alone && (role == Role::Encoders || (role == Role::Reckoned && !fixes))
}

/// Whether a file says how fast the robot drove, or may do so: more than a gyro does.
fn may_drive(file: &File) -> bool {
    let other = match file.role() {
        Role::Sensors => true,
        Role::Undecided => !file.answers().is_empty(),
        _ => false,
    };
    file.may_move() && !(other && candidates("v", Quantity::Speed, &file.source.names).is_empty())
}

fn is_motion_of(file: &File, of: usize) -> bool {
    file.again == Some(Again { of, holds: Holds::Motion })
}

impl File {
    /// Which of the files of its log it is, by its index, if it is one of them read once more.
    pub fn again(&self) -> Option<usize> {
        self.again.map(|again| again.of)
    }

    /// The same file, read as another role.
    fn once_more(&self, again: Again, role: Role) -> Self {
        let what = match again.holds {
            Holds::Truth => "truth",
            Holds::Positions => "positions",
            Holds::Motion => "motion",
            Holds::Ranges => "ranges",
        };
        let name = format!("{}, its {what}", self.name());
        let mut file = self.clone();
        file.again = Some(again);
        file.set_role(role);
        file.rename(name);
        if role == Role::Undecided {
            let (words, answers): (&str, &[Role]) = match has_place(&file.source.names, true) {
                true => ("Are x and y what a sensor read? Else leave them out.", &[Role::Sensors, Role::Unused]),
                false => (IS_TRUE, &[Role::Truth, Role::Sensors, Role::Unused]),
            };
            file.source.undecided = Some(Question { words: words.into(), answers });
        }
        file
    }
}
