//! The algorithm's box as it is printed in each notation, with its times.

use super::{CHAPTER, faults, rail, run};
use crate::{Notation, Program, Quantity, World, relettered};

const CHOSET: &str = "x̂(k+1|k) = F x̂(k|k) + G u(k)\nP(k+1|k) = F P(k|k) Fᵀ + V\nν = y(k+1) − H x̂(k+1|k)\n\
                      S = H P(k+1|k) Hᵀ + W\nR = P(k+1|k) Hᵀ S⁻¹\nx̂(k+1|k+1) = x̂(k+1|k) + R ν\n\
                      P(k+1|k+1) = P(k+1|k) − R H P(k+1|k)\n";

#[test]
fn the_box_of_each_notation_is_a_step_to_the_same_bits() {
    let (chapter, step) = run(CHAPTER);
    let of = |program: &Program, step: &_| [Quantity::X, Quantity::P].map(|of| program.made(step, of).cloned());
    let expected = of(&chapter, &step);
    let short = "x^- = F x + G u\nP^- = F P F^t + V\nR = P^- H^T (H P^- H' + W)^-1\nx^+ = x^- + R (y - H x^-)\n\
                 P^+ = P^- - R H P^-";
    let copied = CHOSET.replace("x̂(", "x^(").replace('|', "∣").replace(" = ", "=").replace("S⁻¹", "S^−1");
    let thrun = "mu_bar_t = A mu_{t-1} + B u_t\nSigma_bar_t = A Sigma_{t-1} A^T + R\nnu = z_t - C mu_bar_t\n\
                 S = C Sigma_bar_t C^T + Q\nK = Sigma_bar_t C^T S^-1\nmu_t = mu_bar_t + K nu\n\
                 Sigma_t = Sigma_bar_t - K C Sigma_bar_t";
    let marks = "μ̄ₜ = A μₜ₋₁ + B uₜ\nΣ̄ₜ = A Σₜ₋₁ Aᵀ + R\nν = zₜ − C μ̄ₜ\nS = C Σ̄ₜ Cᵀ + Q\nK = Σ̄ₜ Cᵀ S⁻¹\n\
                 μₜ = μ̄ₜ + K ν\nΣₜ = Σ̄ₜ − K C Σ̄ₜ";
    let common = "x_{k|k-1} = F x_{k-1|k-1} + B u_k\nP_{k|k-1} = F P_{k-1|k-1} F^T + Q\ny = z_k - H x_{k|k-1}\n\
                  S = H P_{k|k-1} H^T + R\nK = P_{k|k-1} H^T S^{-1}\nx_{k|k} = x_{k|k-1} + K y\n\
                  P_{k|k} = P_{k|k-1} - K H P_{k|k-1}";
    let bare = common.replace(['{', '}'], "").replace("S^-1", "S^(-1)");
    let hats = common.replace("x_", "x_hat_");
    let close = bare.replace("x_", "x").replace("P_", "P");
    let raised = common.replace("_{k|k-1}", "_k^-").replace("_{k-1|k-1}", "_{k-1}").replace("_{k|k}", "_k");
    for (notation, text) in [
        (Notation::Choset, CHOSET),
        (Notation::Choset, &copied),
        (Notation::Choset, short),
        (Notation::Thrun, thrun),
        (Notation::Thrun, marks),
        (Notation::Common, common),
        (Notation::Common, &bare),
        (Notation::Common, &close),
        (Notation::Common, &hats),
        (Notation::Common, &raised),
    ] {
        let mut program = Program::new(text, World::Linear, notation);
        assert_eq!(program.faults(), [], "{text}");
        let step = program.step(rail()).expect("a step");
        assert_eq!(of(&program, &step), expected, "{text}");
    }
}

/// Of two times of one name a program keeps the later alone: it is told, and not computed.
#[test]
fn a_value_of_a_time_that_is_gone_is_not_read() {
    let with = |last: &str| faults(&alloc::format!("x_t = F x_t-1 + G u_t\nP = F P F' + V\n{last}"));
    assert_eq!(with("x_t = x_t + P H' (y_t - H x_t)"), [] as [&str; 0]);
    let words = ": they are one name, which keeps one value. Give the old value a name of its own before, as x0 = x.";
    let expected = |read: &str| alloc::format!("3:7 {read} is read here, and line 1 makes x_t{words}");
    assert_eq!(with("x_t = x_{t-1} + P H' y"), [expected("x_{t-1}")]);
    assert_eq!(with("x_t = x + P H' y"), [expected("x")]);
}

/// An empty name would begin every other one, without end.
#[test]
fn a_hat_by_itself_is_no_name() {
    for text in ["\u{302} = 1\nx = bogus", "_hat = 1\nx = bogus", "\u{302}(k) = 1\na = bogus"] {
        assert!(!faults(text).is_empty(), "{text}");
    }
    assert_eq!(faults("x = x \u{302}\nP = P"), ["1:7 This sign belongs to no formula."]);
}

/// A k of the reader's own is a number, and a function has no time.
#[test]
fn brackets_that_hold_no_time_are_brackets() {
    let (_, step) = run("k = 2\nx = x(k) + G(k)\nP = P");
    assert_eq!(step.made[1].value().entries, [4.0, 9.0]);
    assert_eq!(faults("x = x\nP = P\na = sin(t)")[0].split('.').next(), Some("3:9 t is not known"));
}

#[test]
fn other_letters_keep_the_times_or_mark_the_prediction() {
    let thrun = relettered(CHOSET, World::Linear, [Notation::Choset, Notation::Thrun]);
    assert!(thrun.starts_with("mu⁻ = A mu + B u(k)\nSigma⁻ = A Sigma Aᵀ + R\nν = z − C mu⁻\n"), "{thrun}");
    assert_eq!(Program::new(&thrun, World::Linear, Notation::Thrun).faults(), []);
}

#[test]
fn the_short_marks_of_the_chapter_are_names() {
    let printed = "x̂⁻ = F x̂ + G u\nP⁻ = F P F⊤ + V\nν = y − H x̂⁻\nS = H P⁻ H⊤ + W\nR = P⁻ H⊤ S⁻¹\nx̂⁺ = x̂⁻ + R ν\n\
                   P⁺ = P⁻ − R H P⁻";
    let ((program, step), (_, chapter)) = (run(printed), run(CHAPTER));
    assert_eq!(program.made(&step, Quantity::X), Some(chapter.made[5].value()));
}
