//! The language: what is read, what is refused and where.

mod derivatives;
mod times;

use crate::{Matrix, Notation, Program, Quantity, Step, Stop, Trouble, World};
use alloc::string::String;
use alloc::vec;
use alloc::vec::Vec;

pub(crate) const CHAPTER: &str =
    "x = F x + G u\nP = F P Fᵀ + V\nν = y − H x\nS = H P Hᵀ + W\nR = P Hᵀ S⁻¹\nx = x + R ν\nP = P − R H P\n";

fn rail() -> Vec<Matrix> {
    vec![
        Matrix::column(&[2.0, 4.0]),
        Matrix::new(2, 2, vec![1.0, 0.0, 0.0, 2.0]),
        Matrix::column(&[0.0]),
        Matrix::column(&[2.7]),
        Matrix::new(2, 2, vec![0.2, 0.05, 0.05, 0.1]),
        Matrix::new(1, 1, vec![0.5]),
        Matrix::new(2, 2, vec![1.0, 0.5, 0.0, 1.0]),
        Matrix::column(&[0.0, 0.5]),
        Matrix::new(1, 2, vec![0.0, 1.0]),
    ]
}

fn faults_in(text: &str, world: World, notation: Notation) -> Vec<String> {
    let program = Program::new(text, world, notation);
    program.faults().iter().map(|f| alloc::format!("{}:{} {}", f.line, f.column, f.message)).collect()
}

fn faults(text: &str) -> Vec<String> {
    faults_in(text, World::Linear, Notation::Choset)
}

/// The first two lines leave x and P as they are, so that any line can be tried.
fn tried(line: &str) -> Vec<String> {
    faults(&alloc::format!("x = x\nP = P\n{line}"))
}

fn run(text: &str) -> (Program, Step) {
    let mut program = Program::new(text, World::Linear, Notation::Choset);
    assert_eq!(program.faults(), [], "{text}");
    let step = program.step(rail()).unwrap_or_else(|stop| panic!("{text}: {stop:?}"));
    (program, step)
}

/// What the last line makes in the rail robot's world.
fn value(line: &str) -> Vec<f64> {
    let (_, step) = run(&alloc::format!("x = x\nP = P\na = {line}"));
    step.made[2].value().entries.clone()
}

#[test]
fn the_chapters_seven_lines_are_a_step_by_hand() {
    let (program, step) = run(CHAPTER);
    let of = |quantity| program.made(&step, quantity).expect("made");
    assert!((of(Quantity::S).at(0, 0) - 2.6).abs() < 1e-12);
    let gain = of(Quantity::Gain);
    assert!((gain.at(0, 0) - 21.0 / 52.0).abs() < 1e-12 && (gain.at(1, 0) - 21.0 / 26.0).abs() < 1e-12);
    assert!((of(Quantity::X).at(0, 0) - (4.0 + 21.0 / 52.0 * (2.7 - 4.0))).abs() < 1e-12);
    assert_eq!(step.made.iter().map(|made| made.line).collect::<Vec<_>>(), [1, 2, 3, 4, 5, 6, 7]);
}

#[test]
fn numpy_matlab_and_julia_are_read_to_the_same_bits() {
    let (_, chapter) = run(CHAPTER);
    let others = [
        "x = F @ x + G @ u\nP = F @ P @ F.T + V\nnu = y - H @ x\nS = H @ P @ H.T + W\n\
         R = P @ H.T @ np.linalg.inv(S)\n\
         x = x + R @ nu\nP = P - R @ H @ P",
        "x = F*x + G*u;\nP = F*P*F' + V; % the covariance\nnu = y - H*x;\nS = H*P*H' + W;\nR = P*H'*inv(S);\n\
         x = x + R*nu;\nP = P - R*H*P;",
        "x = F.dot(x) + G.dot(u)\nP = F.dot(P).dot(F.T) + V\nnu = (y\n  - H.dot(x))\n\
         S = np.dot(np.dot(H, P), H.T) + W\n\
         R = P.dot(H.transpose()).dot(inv(S))\nx += R @ nu\nP -= R @ H @ P",
    ];
    for text in others {
        let (_, step) = run(text);
        let entries = |step: &Step| step.made.iter().map(|made| made.value().clone()).collect::<Vec<_>>();
        assert_eq!(entries(&step), entries(&chapter), "{text}");
    }
}

#[test]
fn operators_and_functions_mean_what_the_chapter_means() {
    let cases: [(&str, &[f64]); 32] = [
        ("-2^2", &[-4.0]),
        ("2 * -3 + 1", &[-5.0]),
        ("6 / 3 / 2", &[1.0]),
        ("1.5e1 − .5", &[14.5]),
        ("[1, 2; 3, 4] [1; 1]", &[3.0, 7.0]),
        ("[1 2; 3 4]'", &[1.0, 3.0, 2.0, 4.0]),
        ("[1 -2]", &[1.0, -2.0]),
        ("[1 - 2]", &[-1.0]),
        ("[x[1] x[2]; x[1]]", &[8.0, 2.0]),
        ("[x[1] 0; 0 -x[2]]", &[2.0, 0.0, 0.0, -4.0]),
        ("np.array([[1, 2], [3, 4]])", &[1.0, 2.0, 3.0, 4.0]),
        ("[[1, 2]; [3, 4]]", &[1.0, 2.0, 3.0, 4.0]),
        ("[1, 2\n     3, 4]", &[1.0, 2.0, 3.0, 4.0]),
        ("[4, 2; 2, 3] \\ [8; 8]", &[1.0, 2.0]),
        ("[8, 8] / [4, 2; 2, 3]", &[1.0, 2.0]),
        ("[0, 2; 4, 0]⁻¹", &[0.0, 0.25, 0.5, 0.0]),
        ("[1, 1; 0, 1]^3", &[1.0, 3.0, 0.0, 1.0]),
        ("[1, 1; 0, 1]^-2", &[1.0, -2.0, 0.0, 1.0]),
        ("I − R0", &[0.5, 0.0, -1.0, 1.0]),
        ("2 I + zeros(n, n)", &[2.0, 0.0, 0.0, 2.0]),
        ("eye(2)[1, :]", &[1.0, 0.0]),
        ("x[2] + x(1)", &[6.0]),
        ("P[1:2, 2]", &[0.0, 2.0]),
        ("P[:, end]", &[0.0, 2.0]),
        ("diag([1; 2])", &[1.0, 0.0, 0.0, 2.0]),
        ("diag(P)", &[1.0, 2.0]),
        ("det(P) + trace(P) + norm([3; 4])", &[10.0]),
        ("chol([4, 2; 2, 2])", &[2.0, 0.0, 1.0, 1.0]),
        ("sym([1, 2; 4, 1])", &[1.0, 3.0, 3.0, 1.0]),
        ("wrap(3 pi) − π", &[0.0]),
        ("sqrt(9) + exp(0) + sin(0) + cos(0) + atan2(0, 1) + abs(-1)", &[6.0]),
        ("len(x) + size(P, 2)", &[4.0]),
    ];
    for (line, expected) in cases {
        let line = line.replace("R0", "[0.5, 0; 1, 0]");
        let found = value(&line);
        let near = found.len() == expected.len() && found.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-15);
        assert!(near, "{line}: {found:?}");
    }
}

#[test]
fn a_part_is_filled_and_the_rest_is_kept() {
    let (_, step) = run("x[2] = 7\nP[1, 2] = 0.5\nP(2, 1) = 0.5\nx[1] += 1\nx = x");
    assert_eq!(step.made[4].value().entries, [3.0, 7.0]);
    assert_eq!(step.made[2].value().entries, [1.0, 0.5, 0.5, 2.0]);
}

#[test]
fn sizes_are_told_by_their_letters_before_a_number_moves() {
    let cases = [
        ("a = H x + x", "3:5 H x is p×1 and x is n×1: both sides of a sum have one size."),
        ("a = x F", "3:5 x is n×1 and F is n×n: a product needs as many columns on the left as rows on the right."),
        ("a = H P + W", "3:5 H P is p×n and W is p×p: both sides of a sum have one size."),
        ("a = inv(H)", "3:5 H is p×n; this needs as many rows as columns."),
        ("a = [F, H]", "3:9 H is p×n; parts of a row are as high as the first."),
        ("a = P[1]", "3:5 This is n×n: a part of it needs a row and a column, as P[1, 2] or H[1, :]."),
        ("a = x[0]", "3:5 Rows and columns are counted from 1 here: x[1] is the first."),
        ("a = P / H", "3:5 H is p×n; this needs as many rows as columns."),
        ("x = P", "3:1 x becomes n×n; it must be n×1."),
        ("a = [1, 2][3]", "3:5 This is 1×2: it has no such rows or columns."),
        ("a = [F; 1, 2, 3]", ""),
        ("a = sqrt(P H')", "3:5 P H' is n×p; this function takes a number or a column. The root of a matrix is chol."),
    ];
    for (line, expected) in cases {
        let found = tried(line);
        // A row of three says how many states there are.
        if expected.is_empty() {
            assert_eq!(found, [] as [&str; 0], "{line}");
            continue;
        }
        let is_root = line.contains("sqrt");
        assert!(found.iter().any(|fault| fault == expected) || is_root && found.is_empty(), "{line}: {found:?}");
    }
    let program = Program::new("x = [1, 0.5; 0, 1] x\nP = P", World::Linear, Notation::Choset);
    assert_eq!(program.sizes(), [Some(2), None, None]);
}

#[test]
fn a_name_says_where_it_is_made_or_whose_letter_it_is() {
    let cases = [
        ("a = R\nR = P H'", "3:5 R is not known here; line 4 makes it."),
        (
            "a = R",
            "3:5 R is the gain, and no line above makes it; it is the noise of the motion in Thrun’s letters, here V; \
          the noise of the reading in the common letters, here W.",
        ),
        ("a = K", "3:5 K is the gain in Thrun’s letters, here R, and so in the common letters."),
        (
            "a = Q",
            "3:5 Q is the noise of the reading in Thrun’s letters, here W; \
          the noise of the motion in the common letters, here V.",
        ),
        ("a = FPF'", "3:5 FPF is not known. A product has a blank or a * between its factors: F P F."),
        (
            "a = x (k)",
            "3:8 k is not known. A time stands right behind its name, as in x(k+1|k) or x_k, or is left out.",
        ),
        ("x^2 = F x", "3:2 Before the = there is a name alone. Call a prediction xm, say, and the result x."),
        ("a = F x^ + G u", "3:8 Here ^ has no power. Name a prediction xm or Pm, and an estimate x, without a hat."),
        ("VectorXd a = F x", "3:1 A line begins with the name that it makes and a =; the name’s type is left out."),
        ("a = W^{-1} H + y", "3:5 W^{-1} H is p×n and y is p×1: both sides of a sum have one size."),
        ("a = xm", "3:5 xm is not known: no line above makes it, and the world gives x, P, u, y, V, W, F, G and H."),
        (
            "a = bogus",
            "3:5 bogus is not known: no line above makes it, and the world gives x, P, u, y, V, W, F, G and H.",
        ),
    ];
    for (line, expected) in cases {
        assert_eq!(tried(line).first().map(String::as_str), Some(expected), "{line}");
    }
    let robot = faults_in("mu = mu\nSigma = A Sigma A' + R", World::Robot, Notation::Thrun);
    assert_eq!(robot, ["2:9 A is not given in this world: it is a derivative, jac(f, mu)."]);
    assert_eq!(faults_in("x = F x\nP = F P F' + Q", World::Linear, Notation::Common), [] as [&str; 0]);
}

/// What people type who have read the chapter's section on the algorithm and nothing else.
#[test]
fn first_mistakes_are_told_what_to_type() {
    let cases = [
        ("a = F P Ft", "3:9 Ft is not known. The transpose of F is F'."),
        ("a = P HT", "3:7 HT is not known. The transpose of H is H'."),
        ("a = X", "3:5 X is not known, and x is: capitals are letters of their own."),
        (
            "a = (1 - P) x",
            "3:6 1 is 1×1 and P is n×n: both sides of a sum have one size. The identity is I, and an inverse inv(S).",
        ),
        ("1. a = x", "3:1 A line begins with the name that it makes; a number before it is left out."),
        ("xm- = F x", "3:3 Before the = there is a name alone. Call a prediction xmm, say, and the result xm."),
        ("x' = F x", "3:2 Before the = there is a name alone. Call a prediction xm, say, and the result x."),
        (
            "a = G uk",
            "3:7 uk is not known. A time stands right behind its name, as in x(k+1|k) or x_k, or is left out.",
        ),
    ];
    for (line, expected) in cases {
        assert_eq!(tried(line).first().map(String::as_str), Some(expected), "{line}");
    }
    // A result of another name is that name's, and its line is told.
    assert_eq!(
        faults("xm = F x\nPm = F P F'\nx_new = xm\nP_new = Pm"),
        ["4:11 No line makes x, and none P: a step of a filter makes a new x and a new P of the old ones. \
          Line 3 makes x_new: if the reading has corrected it, call it x. \
          Line 4 makes P_new: if the reading has corrected it, call it P."]
    );
}

/// `eye(4)` is 4×4, whatever it stands beside, once the system's sizes are known.
#[test]
fn an_identity_of_a_size_fits_no_system_of_another() {
    let text = "x = F x\nP = F P F' + V\nR = P H' / (H P H' + W)\nP = (eye(4) - R H) P";
    let mut program = Program::new(text, World::Linear, Notation::Choset);
    assert_eq!((program.faults(), program.sizes()[0]), (&[][..], Some(4)));
    let Err(Stop::Fault(fault)) = program.step(rail()) else { panic!("for four states") };
    assert_eq!((fault.line, fault.column, fault.length), (4, 6, 12));
    let message = "The program is written for n = 4, and this system has n = 2. eye(4) is 4×4 and R H is 2×2: \
                   both sides of a sum have one size.";
    assert_eq!(fault.message, message);
    // A single reading is a number, which any matrix takes.
    let mut program = Program::new("x = x\nP = P\na = eye(2) y", World::Linear, Notation::Choset);
    let Err(Stop::Fault(fault)) = program.step(rail()) else { panic!("for two readings") };
    assert_eq!(fault.message, "The program is written for p = 2, and this system has p = 1.");
}

#[test]
fn all_faults_are_told_at_once_in_the_order_of_the_text() {
    let found = faults("x = F x +\nP = (F P\nS = H P H' + W $\nK = 2 H H\nbogus + 1\nreturn x");
    let places: Vec<&str> = found.iter().map(|fault| fault.split(' ').next().unwrap_or_default()).collect();
    assert_eq!(places, ["1:10", "2:5", "3:16", "4:5", "5:7", "6:1"], "{found:#?}");
    assert_eq!(
        faults(""),
        ["1:1 The program is empty: its lines make a new estimate and a new covariance of the old ones."]
    );
    assert_eq!(
        faults("x = F x"),
        ["1:8 No line makes P: a step of a filter makes a new x and a new P of the old ones."]
    );
    assert_eq!(faults("x = ")[0], "1:5 Here a formula is missing.");
    assert!(faults("x = 1e400 x\nP = P")[0].contains("22 places"));
}

#[test]
fn work_is_bounded_before_it_runs() {
    let many = alloc::format!("{}x = x\nP = P", "a = F^16 F^16 F^16\n".repeat(60));
    let mut program = Program::new(&many, World::Linear, Notation::Choset);
    assert_eq!(program.faults(), []);
    let fault = program.fit([16, 1, 1]).expect_err("too many products");
    assert!(fault.message.contains("products; at most 200000"), "{fault:?}");
    assert_eq!(program.fit([2, 1, 1]), Ok(()));
    let lines = faults(&"a = 1\n".repeat(201));
    assert!(lines[0].starts_with("200:") || lines.iter().any(|fault| fault.starts_with("201:")), "{lines:?}");
}

#[test]
fn a_step_that_has_no_number_says_its_line_and_keeps_nothing() {
    let mut program = Program::new("x = x\nP = P\na = inv(H' H)", World::Linear, Notation::Choset);
    let Err(Stop::Trouble(Trouble::Singular, fault)) = program.step(rail()) else { panic!("singular") };
    assert_eq!((fault.line, fault.column), (3, 5));
    let mut program = Program::new("x = x\nP = P\na = 1e22^16", World::Linear, Notation::Choset);
    let Err(Stop::Trouble(Trouble::NotFinite, fault)) = program.step(rail()) else { panic!("infinite") };
    assert_eq!((fault.line, fault.message.as_str()), (3, "a is not finite any more."));
    let mut program = Program::new("x = x\nP = P\na = chol(-P)", World::Linear, Notation::Choset);
    assert!(matches!(program.step(rail()), Err(Stop::Trouble(Trouble::NotPositiveDefinite, _))));
    assert_eq!(program.step(vec![]), Err(Stop::Given));
    let mut program = Program::new("x = [1, 0, 0; 0, 1, 0; 0, 0, 1] x\nP = P", World::Linear, Notation::Choset);
    let Err(Stop::Fault(fault)) = program.step(rail()) else { panic!("another size") };
    let message = "The program is written for n = 3, and this system has n = 2. This part is 3×3 and x is 2×1: \
                   a product needs as many columns on the left as rows on the right.";
    assert_eq!((fault.column, fault.message.as_str()), (5, message));
}
