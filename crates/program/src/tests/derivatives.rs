//! Derivatives by dual numbers beside differences, and the robot's f and h beside the core's.

use crate::{Matrix, Notation, Program, World};
use alloc::vec;
use alloc::vec::Vec;
use estimate::landmarks::RangeBearing;
use estimate::{Landmark, Unicycle};
use filters::{MeasurementModel, MotionModel};
use geom::SE2;
use nalgebra::Vector2;

const X: [f64; 3] = [0.4, -1.2, 2.8];

fn given(x: &[f64]) -> Vec<Matrix> {
    let square =
        |n: usize, d: f64| Matrix::new(n, n, (0..n * n).map(|i| if i % (n + 1) == 0 { d } else { 0.01 }).collect());
    vec![
        Matrix::column(x),
        square(3, 0.2),
        Matrix::column(&[0.7, 0.9]),
        Matrix::column(&[1.0, 0.2]),
        square(3, 0.03),
        square(2, 0.04),
        Matrix::column(&[2.0, 1.0]),
        Matrix::number(9.21),
    ]
}

fn last(text: &str, x: &[f64]) -> Matrix {
    let text = alloc::format!("a = x\nP = P\nx = x\n{text}");
    let mut program = Program::new(&text, World::Robot, Notation::Choset);
    assert_eq!(program.faults(), [], "{text}");
    let step = program.step(given(x)).unwrap_or_else(|stop| panic!("{text}: {stop:?}"));
    step.made[3].value().clone()
}

#[test]
fn the_robots_models_and_their_jacobians_are_the_cores() {
    let pose = SE2::new(X[0], X[1], X[2]);
    let u = Vector2::new(0.7, 0.9);
    assert_eq!(last("b = f(x, u)", &X).entries, Unicycle.f(&pose, &u).to_vector().as_slice());
    let near = |m: &Matrix, entries: &[f64]| m.entries.iter().zip(entries).all(|(a, b)| (a - b).abs() < 1e-14);
    assert!(near(&last("b = jac(f, x)", &X), Unicycle.jacobian(&pose, &u).transpose().as_slice()));
    assert!(near(&last("b = jac(f(x, u), u)", &X), Unicycle::input_jacobian(&pose).transpose().as_slice()));
    let map = [Landmark { id: 0, x: 2.0, y: 1.0 }];
    let (h, jacobian) = RangeBearing { map: &map }.linearized(&pose, 0).expect("not at the landmark");
    assert_eq!(last("b = h(x, l)", &X).entries, h.as_slice());
    assert!(near(&last("b = jac(h, x)", &X), jacobian.transpose().as_slice()));
    assert_eq!(last("b = jac(h, x)", &X), last("b = jac(h(x, l), x)", &X));
}

#[test]
fn every_function_is_differentiated_as_its_differences_say() {
    let formulas = [
        "sin(a[1]) + cos(a[2]) * a[3]",
        "sqrt(a[3]) / a[2]",
        "exp(a) - abs(a)",
        "atan2(a[1], a[3]) + norm(a)",
        "det(P + a a') + trace(a a')",
        "chol(P + a a')[:, 1]",
        "inv(P + a a') a",
        "[a[1]^2; a[2]^3; wrap(a[3])]",
        "sym(a l[1] a') a / (1 + a' a)",
        "diag(a) a - a' a a",
    ];
    for formula in formulas {
        let exact = last(&alloc::format!("b = jac({formula}, a)"), &X);
        let step = 1e-6;
        for j in 0..3 {
            let moved = |by: f64| {
                let mut x = X;
                x[j] += by;
                last(&alloc::format!("b = {formula}"), &x)
            };
            let (more, less) = (moved(step), moved(-step));
            for i in 0..exact.rows {
                let slope = (more.at(i, 0) - less.at(i, 0)) / (2.0 * step);
                let off = (slope - exact.at(i, j)).abs();
                assert!(off < 1e-7 * (1.0 + slope.abs()), "{formula} ({i}, {j}): {slope} {}", exact.at(i, j));
            }
        }
    }
}
