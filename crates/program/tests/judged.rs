//! Forty programs and the museum's ten bugs, each judged.

#[path = "judged/right.rs"]
mod right;
#[path = "judged/wrong.rs"]
mod wrong;

use estimate::dynamic::{Belief, System};
use estimate::kf::kalman_step;
use estimate::landmarks::RangeBearing;
use estimate::{Landmark, Unicycle};
use filters::{Ekf, MeasurementModel};
use geom::SE2;
use nalgebra::{DMatrix, DVector, Matrix2, Matrix3, Vector2};
use program::judge::{Bug, Outcome, Verdict, cases, judge};
use program::words::Words;
use program::{Matrix, Notation, Program, Quantity, World};
use right::RIGHT;
use wrong::WRONG;

fn judged(text: &str, world: World, notation: Notation) -> Verdict {
    let program = Program::new(text, world, notation);
    assert_eq!(program.faults(), [], "{text}");
    judge(&program)
}

#[test]
fn right_filters_are_called_right_in_any_form() {
    for (name, world, notation, text) in RIGHT {
        let verdict = judged(text, world, notation);
        assert_eq!(verdict.outcome, Outcome::Right, "{name}: {verdict:#?}");
        assert!(verdict.sentences[0].starts_with("Right: "), "{name}: {verdict:#?}");
    }
}

#[test]
fn wrong_filters_are_called_wrong_by_a_sentence_that_is_true() {
    for (name, world, notation, text, said) in WRONG {
        let verdict = judged(text, world, notation);
        assert_eq!(verdict.outcome, Outcome::Wrong, "{name}: {verdict:#?}");
        let all = verdict.sentences.join(" ");
        assert!(all.contains(said), "{name}: {verdict:#?}");
    }
}

/// What a sentence says of an entry: the quantity, its place, the case, and the values of the program and of a right
/// filter; none of a sentence that compares nothing.
fn compared(said: &str, notation: Notation) -> Option<(Quantity, [usize; 2], usize, [&str; 2])> {
    let sentence = said.split(". ").find(|part| part.contains("and a right filter has "))?;
    let (before, ours) = sentence.split_once(", and a right filter has ")?;
    let (case, entry, theirs) = match before.strip_prefix("In case ") {
        Some(rest) => {
            let (case, rest) = rest.split_once(", ")?;
            let (entry, theirs) = rest.split_once(" is ")?;
            (case, entry, theirs)
        }
        None => {
            let (_, rest) = before.strip_prefix("In line ")?.split_once(", ")?;
            let (entry, rest) = rest.split_once(" is ")?;
            let (theirs, case) = rest.split_once(" in case ")?;
            (case, entry, theirs)
        }
    };
    let (letter, place) = entry.strip_suffix(']')?.split_once('[')?;
    let mut place = place.split(", ").map(|number| number.parse::<usize>().expect("a number") - 1);
    let place = [place.next()?, place.next().unwrap_or(0)];
    let letters = [Quantity::X, Quantity::P, Quantity::Innovation, Quantity::S, Quantity::Gain];
    let program = Program::new("", World::Linear, notation);
    let quantity = letters.into_iter().find(|quantity| program.letter(*quantity) == letter)?;
    Some((quantity, place, case.parse::<usize>().ok()? - 1, [theirs, ours.trim_end_matches('.')]))
}

/// Holds the numbers of a verdict to those of the two filters in the case that it names; answers how many there were.
fn the_numbers_are_those_of_the_case(text: &str, world: World, notation: Notation) -> usize {
    let mut theirs = Program::new(text, world, notation);
    let mut ours = Program::new(&program::judge::right(world), world, Notation::Choset);
    let verdict = judge(&theirs);
    let cases = cases(world, theirs.sizes());
    let mut count = 0;
    for said in &verdict.sentences {
        let Some((quantity, [i, j], case, numbers)) = compared(said, notation) else {
            assert!(!said.contains("and a right filter has "), "not understood: {said}");
            continue;
        };
        let values = [&mut theirs, &mut ours].map(|program| {
            let step = program.step(cases[case].clone()).expect("a step");
            let made = program.made(&step, quantity).expect("a value");
            Words::default().number(made.at(i, j)).0.clone()
        });
        assert_eq!(values, numbers, "{said}\n{text}");
        assert_ne!(numbers[0], numbers[1], "{said}");
        count += 1;
    }
    count
}

#[test]
fn the_numbers_of_a_sentence_are_those_of_its_case() {
    for (name, world, notation, text, _) in WRONG {
        assert!(the_numbers_are_those_of_the_case(text, world, notation) >= 1, "{name}");
    }
    for (world, old, new) in [
        (World::Linear, "P = F P F' + V", "P = F' P F + V"),
        (World::Robot, "nu[2] = wrap(nu[2])\n", ""),
        (World::Robot, "+ W", "+ chol(W)"),
    ] {
        let right = if world == World::Robot { ROBOT } else { LINEAR };
        assert_eq!(the_numbers_are_those_of_the_case(&right.replace(old, new), world, Notation::Choset), 1, "{new}");
    }
}

/// The chapter's step, in which each bug is typed as the museum has it.
const LINEAR: &str =
    "x = F x + G u\nP = F P F' + V\nnu = y - H x\nS = H P H' + W\nR = P H' / S\nx = x + R nu\nP = sym(P - R H P)";
const ROBOT: &str = "F = jac(f, x)\nx = f(x, u)\nP = F P F' + V\nH = jac(h, x)\nnu = y - h(x, l)\n\
 nu[2] = wrap(nu[2])\n\
    S = H P H' + W\nR = P H' / S\nx = x + R nu\nx[3] = wrap(x[3])\nP = sym(P - R H P)";

#[test]
fn each_of_the_museums_formulas_is_named_with_its_line() {
    let cases: [(World, &str, &str, Bug, u32); 16] = [
        (World::Linear, "P = F P F' + V", "P = F' P F + V", Bug::Transposed, 2),
        (World::Robot, "P = F P F' + V", "P = F' P F + V", Bug::Transposed, 3),
        (World::Robot, "nu[2] = wrap(nu[2])\n", "", Bug::UnwrappedInnovation, 5),
        (World::Robot, "x[3] = wrap(x[3])\n", "", Bug::UnwrappedHeading, 9),
        (World::Robot, "nu = y", "H[2, 3] = -1 / norm(x[1:2] - l)^2\nnu = y", Bug::WrongDerivative, 5),
        (World::Robot, "S = H P H' + W", "W[2, 2] = (180/pi)^2 W[2, 2]\nS = H P H' + W", Bug::Degrees, 7),
        (World::Robot, "S = H P H' + W", "S = H P H' + [W[1, 1], 0; 0, (sqrt(W[2, 2]) 180/pi)^2]", Bug::Degrees, 7),
        (World::Linear, "+ W", "+ diag(sqrt(diag(W)))", Bug::Deviation, 4),
        (World::Linear, "+ W", "+ chol(W)", Bug::Deviation, 4),
        (World::Robot, "+ W", "+ diag(sqrt(diag(W)))", Bug::Deviation, 7),
        (World::Linear, "+ V", "+ 16 V", Bug::StepLength, 2),
        (World::Robot, "+ V", "+ 16 V", Bug::StepLength, 3),
        (World::Linear, "R = P H' / S", "R = 1.3 P H' / S", Bug::ShortForm, 5),
        (World::Robot, "R = P H' / S", "R = 1.3 P H' / S", Bug::ShortForm, 8),
        (
            World::Linear,
            "P = sym(P - R H P)",
            "P = P - R H P\nS = H P H' + W\nR = P H' / S\nx = x + R (y - H x)\nP = P - R H P",
            Bug::Twice,
            10,
        ),
        (
            World::Robot,
            "P = sym(P - R H P)",
            "P = P - R H P\nH = jac(h, x)\nnu = y - h(x, l)\nnu[2] = wrap(nu[2])\nS = H P H' + W\nR = P H' / S\n\
             x = x + R nu\n\
             x[3] = wrap(x[3])\nP = P - R H P",
            Bug::Twice,
            13,
        ),
    ];
    for (world, old, new, bug, line) in cases {
        let right = if world == World::Robot { ROBOT } else { LINEAR };
        let text = right.replace(old, new);
        assert_ne!(text, right);
        let verdict = judged(&text, world, Notation::Choset);
        assert_eq!((verdict.outcome, verdict.line), (Outcome::Bug(bug), Some(line)), "{text}\n{verdict:#?}");
        assert!(verdict.sentences[0].starts_with(&format!("Line {line}: ")), "{verdict:#?}");
    }
    // The tenth gives right numbers, and is seen in their last digits.
    for (right, world) in [(LINEAR, World::Linear), (ROBOT, World::Robot)] {
        let verdict = judged(&right.replace("sym(P - R H P)", "P - R H P"), world, Notation::Choset);
        assert_eq!(verdict.outcome, Outcome::Right);
        assert!(verdict.sentences.iter().any(|sentence| sentence.contains("“P is not symmetric”")), "{verdict:#?}");
    }
}

#[test]
fn a_form_that_breaks_is_right_and_shown_where_it_breaks() {
    let of = |text: &str| judged(text, World::Linear, Notation::Choset).sentences.join(" ");
    let joseph = of(&LINEAR.replace("sym(P - R H P)", "sym((I - R H) P (I - R H)' + R W R')"));
    assert!(joseph.starts_with("Right: ") && !joseph.contains("breaks"), "{joseph}");
    let short = of(LINEAR);
    assert!(short.contains("P[1, 1] becomes 0, where Joseph’s form has 0.04"), "{short}");
}

#[test]
fn a_program_without_a_value_is_told_the_line() {
    let verdict = judged(&LINEAR.replace("+ W", "- H P H'"), World::Linear, Notation::Choset);
    assert_eq!((verdict.outcome, verdict.line), (Outcome::Refused, Some(5)), "{verdict:#?}");
    let verdict = judge(&Program::new("x = F x +", World::Linear, Notation::Choset));
    assert_eq!((verdict.outcome, verdict.line), (Outcome::Refused, Some(1)));
}

fn dense(m: &Matrix) -> DMatrix<f64> {
    DMatrix::from_row_slice(m.rows, m.columns, &m.entries)
}

fn near(m: &Matrix, core: &[f64], what: &str) {
    let largest = core.iter().fold(0.0_f64, |all, x| all.max(x.abs()));
    for (j, column) in core.chunks(m.rows).enumerate() {
        for (i, entry) in column.iter().enumerate() {
            assert!((m.at(i, j) - entry).abs() <= 1e-12 * largest, "{what}: {} {entry}", m.at(i, j));
        }
    }
}

#[test]
fn the_right_filter_is_the_cores_in_every_case() {
    let mut right = Program::new(&program::judge::right(World::Linear), World::Linear, Notation::Choset);
    for (i, case) in cases(World::Linear, [None; 3]).into_iter().enumerate() {
        let [x, p, u, y, v, w, f, g, h] = case.iter().map(dense).collect::<Vec<_>>().try_into().expect("nine");
        let column = |m: &DMatrix<f64>| DVector::from_column_slice(m.as_slice());
        let system = System { f, g, h, v, w };
        let belief = Belief { x: column(&x), p };
        let core = kalman_step(&system, &belief, &column(&u), &column(&y)).expect("a step");
        let step = right.step(case).expect("a step");
        let of = |quantity| right.made(&step, quantity).expect("made");
        near(of(Quantity::X), core.posterior.x.as_slice(), &format!("case {i}, x"));
        near(of(Quantity::P), core.posterior.p.as_slice(), &format!("case {i}, P"));
        near(of(Quantity::S), core.s.as_slice(), &format!("case {i}, S"));
        near(of(Quantity::Gain), core.r.as_slice(), &format!("case {i}, R"));
    }
    let mut right = Program::new(&program::judge::right(World::Robot), World::Robot, Notation::Choset);
    for (i, case) in cases(World::Robot, [None; 3]).into_iter().enumerate() {
        let entries = |k: usize| case[k].entries.clone();
        let mut core = Ekf {
            x: SE2::new(case[0].at(0, 0), case[0].at(1, 0), case[0].at(2, 0)),
            p: Matrix3::from_row_slice(&entries(1)),
        };
        core.predict(&Unicycle, &Vector2::from_row_slice(&entries(2)), &Matrix3::from_row_slice(&entries(4)))
            .expect("predicts");
        let map = [Landmark { id: 0, x: case[6].at(0, 0), y: case[6].at(1, 0) }];
        let model = RangeBearing { map: &map };
        let (expected, h) = model.linearized(&core.x, 0).expect("not at the landmark");
        let nu = model.residual(&Vector2::from_row_slice(&entries(3)), &expected);
        core.correct(&nu, &h, &Matrix2::from_row_slice(&entries(5))).expect("corrects");
        let step = right.step(case.clone()).expect("a step");
        let of = |quantity| right.made(&step, quantity).expect("made");
        near(of(Quantity::Innovation), nu.as_slice(), &format!("case {i}, ν"));
        near(of(Quantity::P), core.p.as_slice(), &format!("case {i}, P"));
        near(of(Quantity::X), core.x.to_vector().as_slice(), &format!("case {i}, x"));
    }
}

#[test]
fn a_quantity_that_is_named_and_off_is_told_of_a_right_answer() {
    let text = "x = F x + G u\nP = F P F' + V\nnu = H x - y\nK = P H' / (H P H' + W)\nx = x - K nu\nP = P - K H P";
    let verdict = judged(text, World::Linear, Notation::Choset);
    assert_eq!(verdict.outcome, Outcome::Right, "{verdict:#?}");
    assert!(verdict.sentences.iter().any(|said| said.starts_with("But line 3 makes another nu")), "{verdict:#?}");
}

#[test]
fn a_prediction_that_no_line_makes_is_looked_at_first() {
    let with =
        |x: &str, p: &str| format!("{x}\n{p}\nnu = y - H x\nS = H P H' + W\nR = P H' / S\nx = x + R nu\nP = P - R H P");
    for (text, line, what) in [
        (with("x = F x + G u", "P = F P F'"), 2, "predicted covariance: look at line 2"),
        (with("x = F x", "P = F P F' + V"), 1, "predicted estimate: look at line 1"),
    ] {
        let verdict = judged(&text, World::Linear, Notation::Choset);
        assert_eq!((verdict.outcome, verdict.line), (Outcome::Wrong, Some(line)), "{verdict:#?}");
        assert!(verdict.sentences.iter().any(|said| said.contains(what)), "{verdict:#?}");
    }
}

#[test]
fn a_jacobian_at_the_wrong_pose_is_looked_at_first() {
    let text = "F = jac(f, x)\nH = jac(h, x)\nx = f(x, u)\nP = F P F' + V\nnu = y - h(x, l)\nnu[2] = wrap(nu[2])\n\
                S = H P H' + W\nR = P H' inv(S)\nx = x + R nu\nx[3] = wrap(x[3])\nP = sym(P - R H P)";
    let verdict = judged(text, World::Robot, Notation::Choset);
    assert_eq!((verdict.outcome, verdict.line), (Outcome::Wrong, Some(2)), "{verdict:#?}");
    assert!(verdict.sentences[2].ends_with("Jacobian of the reading: look at line 2 first."), "{verdict:#?}");
}
