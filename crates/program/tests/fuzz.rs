//! Random texts, spoilt pastes, their steps, verdicts, trees and other letters: nothing panics, everything ends, and
//! every fault lies in the text.
//!
//! `TEXTS` says how many, `SEED` which; a release (`RELEASE=1`) reads a million.

use program::judge::{Outcome, divides, has_gain, judge};
use program::{Matrix, Notation, Program, Stop, World, relettered};

const PIECES: [&str; 104] = [
    "x",
    "P",
    "u",
    "y",
    "F",
    "G",
    "H",
    "V",
    "W",
    "R",
    "S",
    "K",
    "Q",
    "A",
    "B",
    "C",
    "z",
    "mu",
    "Sigma",
    "nu",
    "I",
    "n",
    "p",
    "m",
    "l",
    "gate",
    "pi",
    " = ",
    "=",
    "\n",
    "\n",
    "\n",
    " ",
    " ",
    "+",
    "-",
    "−",
    "*",
    "@",
    "/",
    "\\",
    "^",
    "'",
    "ᵀ",
    "⁻¹",
    "⁻",
    "⁺",
    "⊤",
    "- =",
    "²",
    "³",
    ".T",
    ".",
    "(",
    ")",
    "(",
    ")",
    "[",
    "]",
    "[",
    "]",
    ",",
    ";",
    ":",
    "1",
    "2",
    "0",
    "64",
    "1e300",
    "1e-7",
    "0.5",
    "999999999999999999999",
    "inv(",
    "eye(",
    "zeros(",
    "diag(",
    "sqrt(",
    "chol(",
    "det(",
    "jac(",
    "f(x, u)",
    "h(x, l)",
    "f",
    "h",
    "sin(",
    "wrap(",
    "np.linalg.",
    "np.",
    "#",
    "%",
    "x̂",
    "ν",
    "é",
    "end",
    "\u{1d49e}",
    "(k+1|k)",
    "(k|k)",
    "_{t-1}",
    "_k",
    "ₜ₋₁",
    "^-",
    "∣",
    "\u{302}",
    "_hat",
];

const WHOLE: [&str; 5] = [
    "x = F x + G u\nP = F P Fᵀ + V\nν = y − H x\nS = H P Hᵀ + W\nR = P Hᵀ S⁻¹\nx = x + R ν\nP = P − R H P\n",
    "x = F @ x + G @ u\nP = F @ P @ F.T + V\nS = H @ P @ H.T + W\nR = np.linalg.solve(S, H @ P).T\n\
     x = x + R @ (y - H @ x)\n\
     P = (np.eye(n) - R @ H) @ P @ (np.eye(n) - R @ H).T + R @ W @ R.T",
    "F = jac(f, x)\nx = f(x, u)\nP = F P F' + V\nH = jac(h(x, l), x)\nnu = y - h(x, l)\nnu[2] = wrap(nu[2])\n\
     S = H P H' + W\n\
     R = P H' / S\nx = x + R nu\nx[3] = wrap(x[3])\nP = (I - R H) P",
    "L = chol(V + [1 0; 0 1])\nx = [x(1) + x(2); x(2)];\nP = L*L'; % MATLAB\n",
    "a = zeros((2, 3))\nb = [[1, 2], [3, 4]]\nc = diag([1; 2]) \\ x[1:2]\nx = x + 0*x\nP = sym(P)^2",
];

struct Dice(u64);

impl Dice {
    fn below(&mut self, n: usize) -> usize {
        // SplitMix64.
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) % n as u64) as usize
    }

    fn text(&mut self) -> String {
        let mut text = String::new();
        if self.below(3) > 0 {
            let whole: Vec<char> = WHOLE[self.below(WHOLE.len())].chars().collect();
            let mut chars = whole.clone();
            for _ in 0..self.below(4) {
                let at = self.below(chars.len());
                match self.below(3) {
                    0 => drop(chars.remove(at)),
                    1 => {
                        let piece: Vec<char> = PIECES[self.below(PIECES.len())].chars().collect();
                        chars.splice(at..at, piece).for_each(drop);
                    }
                    _ => {
                        let to = (at + self.below(30)).min(chars.len());
                        let copy = chars[at..to].to_vec();
                        let into = self.below(chars.len());
                        chars.splice(into..into, copy).for_each(drop);
                    }
                }
            }
            text.extend(chars);
        } else {
            for _ in 0..self.below(60) {
                text.push_str(PIECES[self.below(PIECES.len())]);
            }
        }
        text
    }

    fn matrix(&mut self, rows: usize, columns: usize) -> Matrix {
        let numbers = [0.0, 1.0, -1.0, 0.5, 1e-300, 1e300, 3.0, -0.25];
        Matrix::new(rows, columns, (0..rows * columns).map(|_| numbers[self.below(numbers.len())]).collect())
    }

    fn given(&mut self, world: World) -> Vec<Matrix> {
        let [n, p, m] = match world {
            World::Linear => [1 + self.below(4), 1 + self.below(2), self.below(2)],
            World::Robot => [3, 2, 2],
        };
        let mut sides = vec![(n, 1), (n, n), (m, 1), (p, 1), (n, n), (p, p)];
        sides.extend(match world {
            World::Linear => vec![(n, n), (n, m), (p, n)],
            World::Robot => vec![(2, 1), (1, 1)],
        });
        sides.into_iter().map(|(rows, columns)| self.matrix(rows, columns)).collect()
    }
}

fn number(name: &str, default: u64) -> u64 {
    std::env::var(name).ok().and_then(|text| text.parse().ok()).unwrap_or(default)
}

#[test]
fn every_text_is_answered_and_every_fault_lies_in_it() {
    let mut dice = Dice(number("SEED", 1));
    let (mut steps, mut stops) = (0, 0);
    let most = if std::env::var_os("RELEASE").is_some() { 1_000_000 } else { 20_000 };
    for _ in 0..number("TEXTS", most) {
        let text = dice.text();
        let world = [World::Linear, World::Robot][dice.below(2)];
        let notation = [Notation::Choset, Notation::Thrun, Notation::Common][dice.below(3)];
        let mut program = Program::new(&text, world, notation);
        program.faults().iter().for_each(|fault| lies_in(&text, fault));
        is_judged(&program, &text);
        has_a_tree(&program, &text);
        let other = [Notation::Choset, Notation::Thrun, Notation::Common][dice.below(3)];
        let again = relettered(&relettered(&text, world, [notation, other]), world, [other, notation]);
        assert_eq!(again.lines().count(), text.lines().count(), "{text}\n{again}");
        for _ in 0..2 {
            match program.step(dice.given(world)) {
                Ok(step) => {
                    steps += 1;
                    assert!(step.made.iter().all(|made| made.value().entries.iter().all(|x| x.is_finite())), "{text}");
                }
                Err(Stop::Fault(fault) | Stop::Trouble(_, fault)) => {
                    stops += 1;
                    lies_in(&text, &fault);
                }
                Err(Stop::Given) => panic!("what is given fits"),
            }
        }
    }
    assert!(steps > 100 && stops > 100, "{steps} steps, {stops} refusals");
}

/// A verdict says something of a line that there is, and refuses what has a fault.
fn is_judged(program: &Program, text: &str) {
    let verdict = judge(program);
    assert!(!verdict.sentences.is_empty() && verdict.sentences.iter().all(|said| !said.is_empty()), "{text}");
    assert!(verdict.line.is_none_or(|line| line >= 1 && line as usize <= text.split('\n').count()), "{text}");
    assert!(program.faults().is_empty() || verdict.outcome == Outcome::Refused, "{text}\n{verdict:?}");
    if !program.faults().is_empty() {
        assert!(!has_gain(program) && !divides(program), "{text}");
    }
}

/// What has no fault has a tree, whose lines are in the text.
fn has_a_tree(program: &Program, text: &str) {
    let lines = program.tree(None);
    assert_eq!(lines.is_ok(), program.faults().is_empty(), "{text}");
    let last = text.split('\n').count() as u32;
    let within = |[from, to]: [u32; 2]| from >= 1 && from <= to && to <= last;
    assert!(lines.iter().flatten().all(|line| within(line.lines)), "{text}\n{lines:?}");
    let sizes = [0, 1, 2].map(|i| program.sizes()[i].unwrap_or([2, 2, 1][i]));
    match program.tree(Some(sizes)) {
        Ok(lines) => assert!(lines.iter().all(|line| within(line.lines)), "{text}"),
        Err(fault) => lies_in(text, &fault),
    }
}

fn lies_in(text: &str, fault: &program::Fault) {
    let line = text.split('\n').nth(fault.line as usize - 1).unwrap_or_else(|| panic!("{fault:?}\n{text}"));
    let length = line.chars().count() as u32;
    assert!(fault.column >= 1 && fault.column + fault.length <= length + 2, "{fault:?}\n{text}");
    assert!(!fault.message.is_empty() && !fault.message.contains('\n'), "{fault:?}");
}

#[test]
fn long_and_deep_texts_end_soon() {
    let deep = |open: &str, close: &str| format!("x = {}x{}", open.repeat(5000), close.repeat(5000));
    let texts = [
        deep("(", ")"),
        deep("[", "]"),
        deep("-", ""),
        deep("", "'"),
        deep("inv(", ")"),
        deep("x[", "]"),
        deep("", " + x"),
        deep("F ", ""),
        "a=[\n".repeat(4000),
        "x = x\n".repeat(3000),
        format!("a = 1\n{}x = x\nP = P", "a = [a, a]\n".repeat(150)),
        format!("{}x = x\nP = P", "F = [F F; F F]\n".repeat(150)),
        format!("{}x = x\nP = P", "P = F^16 P F^16\n".repeat(190)),
        "[".repeat(19_000),
        "é".repeat(20_001),
    ];
    for text in texts {
        let mut program = Program::new(&text, World::Linear, Notation::Choset);
        program.faults().iter().for_each(|fault| lies_in(&text, fault));
        is_judged(&program, &text);
        has_a_tree(&program, &text);
        let n = 16;
        let given = vec![
            Matrix::column(&[0.1; 16]),
            Matrix::new(n, n, vec![]),
            Matrix::column(&[]),
            Matrix::column(&[0.0; 8]),
            Matrix::new(n, n, vec![]),
            Matrix::new(8, 8, vec![]),
            Matrix::new(n, n, vec![]),
            Matrix::new(n, 0, vec![]),
            Matrix::new(8, n, vec![]),
        ];
        assert!(program.step(given).is_err() || text.len() < 2000, "{}", &text[..40]);
    }
}
