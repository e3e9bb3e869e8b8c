//! A program that is written line by line: what is right so far is no line's fault, and what is missing is said.

use program::judge::{Outcome, Verdict, judge, right};
use program::{Notation, Program, World, relettered};

use World::{Linear, Robot};

const NOTATIONS: [Notation; 3] = [Notation::Choset, Notation::Thrun, Notation::Common];
const CHAPTER: &str =
    "x = F x + G u\nP = F P F' + V\nnu = y - H x\nS = H P H' + W\nR = P H' inv(S)\nx = x + R nu\nP = P - R H P";
const SHORT: &str = "x = F x + G u\nP = F P F' + V\nR = P H' / (H P H' + W)\nx = x + R (y - H x)\nA = I - R H\n\
                     P = A P A' + R W R'";
const COVARIANCE_FIRST: &str =
    "P = F P F' + V\nx = F x + G u\nR = P H' / (H P H' + W)\nP = sym(P - R H P)\nx = x + R (y - H x)";
const ROBOT: &str = "F = jac(f, x)\nx = f(x, u)\nx[3] = wrap(x[3])\nP = F P F' + V\nP = sym(P)\nH = jac(h, x)\n\
                     nu = y - h(x, l)\nnu[2] = wrap(nu[2])\nS = H P H' + W\nR = P H' / S\nx = x + R nu\n\
                     x[3] = wrap(x[3])\nP = sym(P - R H P)";

fn judged(text: &str, world: World) -> Verdict {
    judge(&Program::new(text, world, Notation::Choset))
}

#[test]
fn no_line_of_a_beginning_of_a_right_filter_is_at_fault() {
    let texts = [CHAPTER, SHORT, COVARIANCE_FIRST].map(|text| (Linear, String::from(text)));
    let robots = [(Robot, String::from(ROBOT)), (Robot, right(Robot)), (Linear, right(Linear))];
    for (world, whole) in texts.into_iter().chain(robots) {
        for notation in NOTATIONS {
            let text = relettered(&whole, world, [Notation::Choset, notation]);
            let lines: Vec<&str> = text.lines().collect();
            for count in 1..lines.len() {
                let begun = lines[..count].join("\n");
                let program = Program::new(&begun, world, notation);
                let verdict = judge(&program);
                assert_eq!(verdict.line, None, "{begun}\n{verdict:#?}");
                let said = &verdict.sentences[0];
                let missing = match verdict.outcome {
                    Outcome::Refused => program.faults().len() == 1 && said.starts_with("No line makes "),
                    Outcome::Unfinished => {
                        said.starts_with("Not finished: no line corrects ") && said.ends_with(" by the reading yet.")
                    }
                    _ => false,
                };
                assert!(missing, "{begun}\n{verdict:#?}");
            }
            assert_eq!(judge(&Program::new(&text, world, notation)).outcome, Outcome::Right, "{text}");
        }
    }
}

#[test]
fn what_is_missing_is_named() {
    let begun = |lines: usize| CHAPTER.lines().take(lines).collect::<Vec<_>>().join("\n");
    for (text, world, said) in [
        (begun(1), Linear, "No line makes P: a step of a filter makes a new x and a new P of the old ones."),
        (begun(2), Linear, "Not finished: no line corrects x and P by the reading yet."),
        (begun(2), Linear, "Right so far: the predicted x and the predicted P."),
        (begun(4), Linear, "Right so far: the predicted x, the predicted P, nu and S."),
        (begun(6), Linear, "Not finished: no line corrects P by the reading yet."),
        (begun(6), Linear, "Right so far: x, the predicted P, nu, S and R."),
        (
            ROBOT.lines().take(7).collect::<Vec<_>>().join("\n"),
            Robot,
            "No line wraps nu[2] yet: near ±π it is off by a turn.",
        ),
        (
            ROBOT.lines().take(11).collect::<Vec<_>>().join("\n"),
            Robot,
            "No line wraps x[3] yet: near ±π it is off by a turn.",
        ),
    ] {
        let verdict = judged(&text, world);
        assert!(verdict.sentences.iter().any(|one| one == said), "{text}\n{verdict:#?}");
    }
}

#[test]
fn a_prediction_of_its_own_name_is_no_result_and_what_is_missing_is_no_lines_fault() {
    let begun = "xp = F x + G u\nPp = F P F' + V\nnu = y - H xp\nS = H Pp H' + W";
    let messages = |text: &str| -> Vec<String> {
        Program::new(text, Linear, Notation::Choset).faults().iter().map(|fault| fault.message.clone()).collect()
    };
    let missing = "No line makes x, and none P: a step of a filter makes a new x and a new P of the old ones.";
    assert_eq!(messages(begun), [missing], "a later line goes on with both");
    let last = messages("xp = F x + G u\nPp = F P F' + V");
    assert!(last[0].ends_with("Line 2 makes Pp: if the reading has corrected it, call it P."), "{last:?}");
    let faulty = messages(&begun.replace("F P F'", "FPF'"));
    assert!(faulty.len() == 1 && faulty[0].starts_with("FPF is not known."), "{faulty:?}");
}

#[test]
fn a_beginning_with_a_fault_is_told_the_line_at_fault() {
    for (text, line, said) in [
        ("x = F x + G u\nP = F' P F + V", 2, "No line corrects x by the reading yet."),
        ("x = F x\nP = F P F' + V", 1, "No line corrects P by the reading yet."),
        ("x = F x + G u\nP = F P F' + V\nnu = H x - y", 3, "No line corrects x and P by the reading yet."),
        ("x = F x + G u\nP = F P F' + V\nS = H P H' + V[1, 1]", 3, "No line corrects x and P by the reading yet."),
        (
            "x = F x + G u\nP = F P F' + V\nR = P H' / (H P H' + W)\nx = x + R (y + H x)",
            4,
            "No line corrects P by the reading yet.",
        ),
        ("x = F x + G u\nP = F P F' + V\nK = 0 H'\nx = x + K (y - H x)", 4, "No line corrects P by the reading yet."),
        // A line that leaves out the correction is at fault.
        (
            "x = F x + G u\nP = F P F' + V\nR = P H' / (H P H' + W)\nx = x + R (y - H x)\nP = P",
            5,
            "x is right in all cases.",
        ),
        ("xm = F x + G u\nP = F P F' + V\nx = xm", 3, "No line corrects P by the reading yet."),
    ] {
        let verdict = judged(text, Linear);
        assert_eq!((verdict.outcome, verdict.line), (Outcome::Wrong, Some(line)), "{text}\n{verdict:#?}");
        assert!(verdict.sentences.iter().any(|one| one == said), "{text}\n{verdict:#?}");
    }
}

#[test]
fn what_is_missing_at_a_lines_end_is_missing_there() {
    for (text, place, message) in [
        ("x = x\nP = F P F' +\n\n", (2, 13), "Here a formula is missing."),
        ("x = x\nP = F P F' +", (2, 13), "Here a formula is missing."),
        ("x = x — x\nP = P", (1, 7), "This is a dash of texts, not a sign of an operation. A minus is typed -."),
    ] {
        let program = Program::new(text, Linear, Notation::Choset);
        let found: Vec<_> = program.faults().iter().map(|it| ((it.line, it.column), it.message.as_str())).collect();
        assert_eq!(found, [(place, message)], "{text}");
    }
}
