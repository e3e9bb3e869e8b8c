//! The language: what is read, what is refused and where.

use crate::{Matrix, Notation, Program, Quantity, World};
use alloc::string::String;
use alloc::vec;
use alloc::vec::Vec;

const CHAPTER: &str =
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

fn faults(text: &str) -> Vec<String> {
    let program = Program::new(text, World::Linear, Notation::Choset);
    program.faults().iter().map(|f| alloc::format!("{}:{} {}", f.line, f.column, f.message)).collect()
}

#[test]
fn the_chapters_seven_lines_are_a_step_by_hand() {
    let mut program = Program::new(CHAPTER, World::Linear, Notation::Choset);
    assert_eq!(program.faults(), []);
    let step = program.step(rail()).expect("runs");
    assert!((program.made(&step, Quantity::S).expect("made").at(0, 0) - 2.6).abs() < 1e-12);
    let gain = program.made(&step, Quantity::Gain).expect("made");
    assert!((gain.at(0, 0) - 21.0 / 52.0).abs() < 1e-12 && (gain.at(1, 0) - 21.0 / 26.0).abs() < 1e-12);
    assert!(
        (program.made(&step, Quantity::X).expect("made").at(0, 0) - (4.0 + 21.0 / 52.0 * (2.7 - 4.0))).abs() < 1e-12
    );
    assert_eq!(step.made.len(), 7);
}
