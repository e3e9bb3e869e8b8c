//! Which forms of a filter have a gain, and which divide by a matrix, whatever they call them.

use program::judge::{Outcome, divides, has_gain, judge};
use program::{Notation, Program, World};

const PREDICTION: &str = "x = F x + G u\nP = F P F' + V\n";
const LAST: &str = "x = x + K (y - H x)\nP = P - K H P";

#[test]
fn a_gain_is_known_by_its_numbers() {
    for (has, update) in [
        (true, "K = P H' / (H P H' + W)\nx = x + K (y - H x)\nP = P - K H P"),
        // Of no line of its own, S gives it away.
        (true, "M = P\nP = P - P H' (H P H' + W)^-1 H P\nx = x + M H' ((W + H M H') \\ (y - H x))"),
        (true, "L = inv(P) + H' inv(W) H\nP = inv(L)\nB = P H' inv(W)\nx = x + B (y - H x)"),
        (false, "L = inv(P) + H' inv(W) H\nq = P \\ x + H' (W \\ y)\nP = inv(L)\nx = P q"),
        (false, "L = inv(P) + H' inv(W) H\nP = inv(L)\nx = x + P H' (W \\ (y - H x))"),
    ] {
        let program = Program::new(&format!("{PREDICTION}{update}"), World::Linear, Notation::Choset);
        assert_eq!(judge(&program).outcome, Outcome::Right, "{update}");
        assert_eq!(has_gain(&program), has, "{update}");
    }
    let robot = program::judge::right(World::Robot);
    assert!(has_gain(&Program::new(&robot, World::Robot, Notation::Choset)));
    for text in ["x = F x + (", "x = x / 0\nP = P"] {
        assert!(!has_gain(&Program::new(text, World::Linear, Notation::Choset)), "{text}");
    }
}

#[test]
fn a_division_is_by_a_matrix_where_its_divisor_has_rows() {
    let in_turn = "two = eye(2) y\na = H[1, :]\nK = P a' / (a P a' + W[1, 1])\nx = x + K (y[1] - a x)\n\
                   P = (P - K a P) / (2 I) (4 I)^-1 8\n";
    for (by_matrix, update) in [
        (false, in_turn),
        (true, "two = eye(2) y\nK = P H' / (H P H' + W)\n"),
        (true, "two = eye(2) y\nK = ((H P H' + W) \\ (H P))'\n"),
        (true, "two = eye(2) y\nS = H P H' + W\nK = P H' S^-1\n"),
        (true, "two = eye(2) y\nK = P H' inv(H P H' + W)\n"),
        (true, "K = P H' inv(H P H' + W)\n"),
    ] {
        let text = format!("{PREDICTION}{update}{}", if update == in_turn { "" } else { LAST });
        let program = Program::new(&text, World::Linear, Notation::Choset);
        assert_eq!(program.faults(), [], "{text}");
        assert_eq!(divides(&program), by_matrix, "{text}");
    }
    assert!(!divides(&Program::new("x = inv(P) x +", World::Linear, Notation::Choset)), "it has a fault");
}
