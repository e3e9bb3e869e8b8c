//! Right filters lie in their bands, and the bugs that NEES or NIS shows lie outside.

use super::Worlds;
use crate::bug_museum::{Bug, museum_run};
use crate::ensemble::SEEDS;
use program::{Notation, Program, Stop, World, judge};

const LINEAR: &str =
    "x = F x + G u\nP = F P F' + V\nnu = y - H x\nS = H P H' + W\nR = P H' / S\nx = x + R nu\nP = sym(P - R H P)";

fn worlds(text: &str, world: World, count: u32) -> Worlds {
    let program = Program::new(text, world, Notation::Choset);
    assert_eq!(program.faults(), [], "{text}");
    let mut worlds = Worlds::new(&program);
    (0..count).for_each(|_| worlds.next_world().expect("every line has a value"));
    worlds
}

#[test]
fn a_right_filter_lies_in_both_bands_and_bugs_do_not() {
    let of = |text: &str| {
        let worlds = worlds(text, World::Linear, SEEDS);
        assert!(worlds.is_done());
        let [nees, nis] = [worlds.nees(), worlds.nis()].map(|mean| mean.expect("a band").expect("a mean"));
        (nees.fits(), nis.fits(), worlds.sentences().expect("sentences").join(" "))
    };
    let (nees, nis, said) = of(LINEAR);
    assert!(nees && nis && said.starts_with("The mean NEES of 500 worlds is "), "{said}");
    assert!(!said.contains("larger"), "{said}");
    for (old, new, tells) in [
        ("+ W", "+ 4 W", "the filter claims larger errors than it makes"),
        ("+ V", "+ 0.05 V", "the filter’s errors are larger than it claims"),
        ("F P F'", "F' P F", "larger"),
    ] {
        let (nees, nis, said) = of(&LINEAR.replace(old, new));
        assert!(!(nees && nis) && said.contains(tells), "{new}: {said}");
    }
}

#[test]
fn a_program_without_names_for_them_is_told_so() {
    let text = "x = F x + G u\nP = F P F' + V\nK = P H' / (H P H' + W)\nx = x + K (y - H x)\nP = (I - K H) P";
    let said = worlds(text, World::Linear, 20).sentences().expect("sentences").join(" ");
    assert!(said.contains("The program does not make nu and S under these names, so there is no NIS."), "{said}");
}

#[test]
fn the_robots_right_filter_does_in_the_stadium_what_the_museums_does() {
    let runs = 12;
    let worlds = worlds(&judge::right(World::Robot), World::Robot, runs);
    let nees = worlds.nees().expect("a band").expect("a mean").value;
    let nis = worlds.nis().expect("a band").expect("a mean").value;
    let museum: Vec<_> = (0..runs).map(|seed| museum_run([Bug::None; 2], seed).expect("a run")).collect();
    let mean = |figure: usize| museum.iter().map(|run| run[figure]).sum::<f64>() / f64::from(runs);
    // A step without a reading is one of variance 10¹²: what that moves is far below these digits.
    assert!((nees - mean(3)).abs() < 1e-6 && (nis - mean(4)).abs() < 1e-6, "{nees} {nis} {} {}", mean(3), mean(4));
}

#[test]
fn a_line_without_a_value_ends_the_count() {
    let program = Program::new("x = x / 0\nP = P", World::Linear, Notation::Choset);
    let mut worlds = Worlds::new(&program);
    assert!(matches!(worlds.next_world(), Err(Stop::Trouble(..))));
    assert_eq!(worlds.count, 0);
    assert_eq!(worlds.nees().map(|mean| mean.is_some()), Ok(false));
}
