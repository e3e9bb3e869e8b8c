//! One predict and one update of a filter with two states, one input-free step and one reading, by four libraries.
//!
//! Each round runs every library once over the same readings, so that a change of the processor's clock meets all of
//! them; the median of five rounds is printed, and the ratio to the fastest peer. All four end at the same mean, or the
//! program says so and fails: a library that computes something else is no peer.

use nalgebra::U1;
use std::hint::black_box;
use std::time::Instant;

const STEPS: usize = 2_000_000;
const ROUNDS: usize = 5;
const T: f64 = 0.5;

/// The same readings for everyone: a bounded wiggle, cheap to make.
fn reading(step: usize) -> f64 {
    (step % 7) as f64 * 0.3 - 0.9
}

fn ours() -> [f64; 2] {
    use filters::{Gaussian, Kf};
    use nalgebra::{Matrix1, Matrix2, RowVector2, Vector1, Vector2};
    let a = Matrix2::new(1.0, T, 0.0, 1.0);
    let r = Matrix2::new(0.2, 0.05, 0.05, 0.1);
    let c = RowVector2::new(1.0, 0.0);
    let q = Matrix1::new(0.5);
    let mut kf = Kf::from(Gaussian { x: Vector2::new(0.0, 0.0), p: Matrix2::identity() });
    for step in 0..STEPS {
        kf.predict::<U1>(black_box(&a), black_box(&r), None).expect("finite");
        black_box(kf.update(&Vector1::new(reading(step)), black_box(&c), black_box(&q)).expect("positive definite"));
    }
    kf.belief().x.into()
}

fn kfilter() -> [f64; 2] {
    use kfilter::kalman::{Kalman, KalmanFilter, KalmanPredict, KalmanUpdate};
    use kfilter::measurement::{LinearMeasurement, Measurement};
    use nalgebra_kfilter::{Matrix1, Matrix1x2, Matrix2, Vector2};
    let mut kf = Kalman::new(
        Matrix2::new(1.0, T, 0.0, 1.0),
        Matrix2::new(0.2, 0.05, 0.05, 0.1),
        Vector2::new(0.0, 0.0),
        Matrix2::identity(),
    );
    let mut measurement = LinearMeasurement::new(Matrix1x2::new(1.0, 0.0), Matrix1::new(0.5), Matrix1::new(0.0));
    for step in 0..STEPS {
        black_box(&mut kf).predict().expect("finite");
        measurement.set_measurement(Matrix1::new(reading(step)));
        black_box(kf.update(black_box(&measurement)).expect("positive definite"));
    }
    [kf.state()[0], kf.state()[1]]
}

fn minikalman() -> [f64; 2] {
    use minikalman::prelude::*;
    use minikalman::regular::builder::KalmanFilterBuilder;
    let builder = KalmanFilterBuilder::<2, f64>::default();
    let mut kf = builder.build();
    let mut measurement = builder.observations().build::<1>();
    kf.state_transition_mut().as_matrix_mut().apply(|a| {
        a.set_at(0, 0, 1.0);
        a.set_at(0, 1, T);
        a.set_at(1, 0, 0.0);
        a.set_at(1, 1, 1.0);
    });
    kf.direct_process_noise_mut().as_matrix_mut().apply(|q| {
        q.set_at(0, 0, 0.2);
        q.set_at(0, 1, 0.05);
        q.set_at(1, 0, 0.05);
        q.set_at(1, 1, 0.1);
    });
    kf.estimate_covariance_mut().as_matrix_mut().apply(|p| {
        p.set_at(0, 0, 1.0);
        p.set_at(1, 1, 1.0);
    });
    measurement.observation_matrix_mut().as_matrix_mut().apply(|h| {
        h.set_at(0, 0, 1.0);
        h.set_at(0, 1, 0.0);
    });
    measurement.measurement_noise_covariance_mut().as_matrix_mut().apply(|r| r.set_at(0, 0, 0.5));
    for step in 0..STEPS {
        black_box(&mut kf).predict();
        measurement.measurement_vector_mut().as_matrix_mut().apply(|z| z.set_at(0, 0, reading(step)));
        kf.correct(black_box(&mut measurement));
    }
    let x = kf.state_vector().as_matrix();
    [x.get_at(0, 0), x.get_at(1, 0)]
}

fn bayes_estimate() -> [f64; 2] {
    use bayes_estimate::models::{ExtendedLinearObserver, ExtendedLinearPredictor, KalmanState};
    use bayes_estimate::noise::CorrelatedNoise;
    use nalgebra::{Matrix1, Matrix2, RowVector2, Vector1, Vector2};
    let a = Matrix2::new(1.0, T, 0.0, 1.0);
    let process = CorrelatedNoise { Q: Matrix2::new(0.2, 0.05, 0.05, 0.1) };
    let c = RowVector2::new(1.0, 0.0);
    let sensor = CorrelatedNoise { Q: Matrix1::new(0.5) };
    let mut kf = KalmanState { x: Vector2::new(0.0, 0.0), X: Matrix2::identity() };
    for step in 0..STEPS {
        let x = black_box(&a) * kf.x;
        kf.predict(&x, &a, black_box(&process)).expect("finite");
        let innovation = Vector1::new(reading(step)) - black_box(&c) * kf.x;
        kf.observe_innovation(&innovation, &c, black_box(&sensor)).expect("positive definite");
    }
    kf.x.into()
}

fn main() {
    type Peer = (&'static str, fn() -> [f64; 2]);
    let peers: [Peer; 4] =
        [("ours", ours), ("kfilter", kfilter), ("minikalman", minikalman), ("bayes_estimate", bayes_estimate)];
    let mut times = [[0.0; ROUNDS]; 4];
    let mut end = None;
    for round in 0..ROUNDS {
        for (peer, (name, run)) in peers.iter().enumerate() {
            let start = Instant::now();
            let x = black_box(run());
            times[peer][round] = start.elapsed().as_secs_f64() / STEPS as f64 * 1e9;
            let ours = *end.get_or_insert(x);
            let gap = (x[0] - ours[0]).abs().max((x[1] - ours[1]).abs());
            assert!(gap < 1e-9, "{name} ends at {x:?}, we at {ours:?}");
        }
    }
    let median = times.map(|mut of| {
        of.sort_by(f64::total_cmp);
        of[ROUNDS / 2]
    });
    let best = median[1..].iter().copied().fold(f64::INFINITY, f64::min);
    println!("2-state Kalman step, predict and update, median of {ROUNDS} interleaved rounds of {STEPS} steps");
    println!("{:<16} {:>8} {:>22}", "library", "ns/step", "ratio to the best peer");
    for ((name, _), ns) in peers.iter().zip(median) {
        println!("{name:<16} {ns:>8.1} {:>22.2}", ns / best);
    }
}
