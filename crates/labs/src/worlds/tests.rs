//! Right filters lie in their bands, and the bugs that NEES or NIS shows lie outside.

use super::{Run, Worlds};
use crate::bug_museum::{Bug, BugMuseum, MuseumParams, museum_run};
use crate::ensemble::SEEDS;
use crate::write_filter::Begin;
use lab::{Knob, Lab, Plain, Shape};
use program::{Notation, Program, Stop, World, judge};
use sim::scenarios::BUG_MUSEUM;

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

/// The greatest gap between the estimates of a bug's program and of the museum's filter in whole runs of three seeds,
/// metres or radians, as long as both gates let the same readings in; and how many steps that were.
fn gap(begin: Begin, bug: Bug) -> (f64, u32) {
    let (mut worst, mut steps) = (0.0_f64, 0);
    for seed in 1..=3 {
        let mut program = Program::new(&begin.text(), World::Robot, Notation::Choset);
        let mut run = Run::start(World::Robot, seed).expect("a run");
        let mut museum = BugMuseum::new(MuseumParams { bug, seed, ..MuseumParams::default() }).expect("a museum");
        for step in 1..=BUG_MUSEUM.steps {
            run.next(&mut program).expect("every line has a value");
            museum.step().expect("within the limit");
            let frame = museum.frame();
            assert_eq!(run.truth(), frame.truth, "{bug:?}, seed {seed}, step {step}");
            let uses = frame.readings.step.iter().zip(frame.readings.used.iter());
            if uses.filter(|(at, _)| *at == f64::from(step)).any(|(_, used)| (used == 1.0) != run.used) {
                break;
            }
            steps += 1;
            for (i, (ours, theirs)) in run.belief.0.entries.iter().zip(frame.estimate).enumerate() {
                let off = ours - theirs;
                // Where both wrap a heading, one may stand at π and the other at −π.
                let turned = i == 2 && bug != Bug::UnwrappedHeading;
                worst = worst.max(if turned { geom::wrap(off) } else { off }.abs());
            }
        }
    }
    (worst, steps)
}

#[test]
fn the_programs_of_the_museums_bugs_give_the_museums_estimates() {
    let Shape::Word(words) = Begin::SHAPE else { panic!("Begin is a word") };
    let mut compared = 0;
    for bug in Bug::ALL {
        let Some(at) = words.iter().position(|word| *word == bug.word()) else { continue };
        compared += 1;
        let (gap, steps) = gap(Begin::read(&mut [at as f64].iter()), bug);
        // A step without a reading is one of variance 10¹²: what is left of it is more where P is large, for want of
        // readings or because W is said to be.
        let large = matches!(bug, Bug::UnwrappedHeading | Bug::Deviation);
        assert!(gap < if large { 1e-5 } else { 1e-7 }, "{bug:?}: {gap}");
        // The museum asks its gate at each of two uses, a program's world asks at the last.
        let whole = 3 * BUG_MUSEUM.steps;
        assert!(if bug == Bug::Twice { steps > 60 } else { steps == whole }, "{bug:?}: {steps} of {whole} steps");
    }
    assert_eq!(compared, 10);
}

#[test]
fn a_line_without_a_value_ends_the_count() {
    let program = Program::new("x = x / 0\nP = P", World::Linear, Notation::Choset);
    let mut worlds = Worlds::new(&program);
    assert!(matches!(worlds.next_world(), Err(Stop::Trouble(..))));
    assert_eq!(worlds.count, 0);
    assert_eq!(worlds.nees().map(|mean| mean.is_some()), Ok(false));
}
