//! Nanoseconds a step natively, one round, as JSON: the other half of the Node bench, which runs this between its own
//! rounds and prints the ratios.

use estimate::dynamic::{Belief, System, kalman_replay};
use estimate::kf::{Gaussian, kalman_step};
use estimate::landmarks::RangeBearing;
use estimate::localizer::{EkfLocalizer, LandmarkReading, Logged, SensorKind};
use estimate::rail::position_sensor;
use estimate::slam::{self, EkfSlam};
use estimate::{Landmark, Localizer, Sighting};
use filters::association::Thresholds;
use filters::linear;
use lab::Lab;
use nalgebra::{DMatrix, DVector, Matrix2, Matrix3, Vector1, Vector2, Vector3};
use std::hint::black_box;
use std::time::Instant;

const STEPS: u32 = 200_000;
/// The steps of a log, as many as the module is given in one call.
const LOG: u32 = 5_000;

fn kalman() -> f64 {
    let (sys, mut belief) = position_sensor();
    let u = Vector1::new(0.1);
    let start = Instant::now();
    for step in 0..STEPS {
        let y = Vector1::new(f64::from(step % 7) * 0.3 - 0.9);
        if let Ok(step) = black_box(kalman_step(black_box(&sys), &belief, &u, &y)) {
            belief = step.posterior;
        }
    }
    start.elapsed().as_secs_f64() / f64::from(STEPS) * 1e9
}

/// The same from a log, by the function that the module exports.
fn kalman_log() -> f64 {
    let diagonal = |entries: &[f64]| DMatrix::from_diagonal(&DVector::from_column_slice(entries));
    let (f, v) =
        (DMatrix::from_row_slice(2, 2, &[1.0, 0.5, 0.0, 1.0]), DMatrix::from_row_slice(2, 2, &[0.2, 0.05, 0.05, 0.1]));
    let (g, h) = (DMatrix::from_column_slice(2, 1, &[0.0, 0.5]), DMatrix::from_row_slice(1, 2, &[1.0, 0.0]));
    let Ok(system) = System::new(f, g, h, v, diagonal(&[0.5])) else { return f64::NAN };
    let belief = Belief { x: DVector::from_vec(vec![2.0, 4.0]), p: diagonal(&[1.0, 2.0]) };
    let (inputs, readings) =
        (vec![0.1; LOG as usize], (0..LOG).map(|step| f64::from(step % 7) * 0.3 - 0.9).collect::<Vec<_>>());
    let (start, mut sound) = (Instant::now(), true);
    for _ in 0..STEPS / LOG {
        sound &= kalman_replay(&system, &belief, black_box(&inputs), black_box(&readings)).is_ok();
    }
    let ns = start.elapsed().as_secs_f64() / f64::from(STEPS) * 1e9;
    if sound { ns } else { f64::NAN }
}

/// One prediction and one sighting by the filter itself.
fn ekf() -> f64 {
    let map = [Landmark { id: 1, x: 6.0, y: 6.0 }];
    let model = RangeBearing { map: &map };
    let mut ekf = Localizer::new(&Gaussian { x: Vector3::new(1.5, 1.5, 0.0), p: Matrix3::identity() * 0.01 });
    let (u, v, w) = (Vector2::zeros(), Matrix3::identity() * 1e-4, Matrix2::new(0.01, 0.0, 0.0, 0.001));
    let sighting = Sighting { j: 0, y: Vector2::new(6.363961, -2.3561945) };
    let (start, mut sound) = (Instant::now(), true);
    for _ in 0..STEPS {
        sound &= ekf.predict(black_box(&u), black_box(&v)).is_ok();
        sound &= ekf.update(&model, black_box(&sighting), black_box(&w)).is_ok();
    }
    let ns = start.elapsed().as_secs_f64() / f64::from(STEPS) * 1e9;
    if sound { ns } else { f64::NAN }
}

/// The same by the checked localizer, from a log at rest, every reading as expected: a filter can replay it for ever
/// without leaving its place.
fn localizer() -> f64 {
    let (belief, v) = (DMatrix::identity(3, 3) * 0.01, DMatrix::identity(3, 3) * 1e-4);
    let belief = Belief { x: DVector::from_vec(vec![1.5, 1.5, 0.0]), p: belief };
    let (map, w) =
        (vec![Landmark { id: 1, x: 6.0, y: 6.0 }], DMatrix::from_diagonal(&DVector::from_vec(vec![0.01, 0.001])));
    let Ok(mut ekf) = EkfLocalizer::new(belief, map, w, None, SensorKind::RangeBearing) else { return f64::NAN };
    let reading = LandmarkReading { range: 6.363961, bearing: Some(-2.3561945), landmark: Some(1) };
    let log = vec![Logged { u: [0.0, 0.0], reading }; LOG as usize];
    let (start, mut sound) = (Instant::now(), true);
    for _ in 0..STEPS / LOG {
        sound &= ekf.replay(black_box(&log).iter().copied(), v.clone()).is_ok();
    }
    let ns = start.elapsed().as_secs_f64() / f64::from(STEPS) * 1e9;
    if sound { ns } else { f64::NAN }
}

/// Landmarks on a spiral about the robot, none near another.
fn spiral(j: u32) -> slam::LandmarkReading {
    let at = f64::from(j);
    slam::LandmarkReading { range: 3.0 + 0.5 * at, bearing: 2.4 * at, landmark: Some(j) }
}

/// Predict and one sighting with `n` landmarks in the map.
fn mapping(n: u32) -> f64 {
    let belief = Gaussian { x: Vector3::zeros(), p: Matrix3::identity() * 1e-4 };
    let w = Matrix2::new(0.01, 0.0, 0.0, 0.0009);
    let Ok(mut map) = EkfSlam::new(&belief, &w, Thresholds { gate: 9.21, found: 50.0 }) else { return f64::NAN };
    let mut sound = (0..n).all(|j| map.update(&[spiral(j)]).is_ok());
    let (u, v, reading) = (Vector2::zeros(), Matrix3::identity() * 1e-6, [spiral(n / 2)]);
    let steps = 2_000_000 / (n * n + 100) + 20;
    let start = Instant::now();
    for _ in 0..steps {
        sound &= map.predict(black_box(&u), &v).is_ok() && map.update(black_box(&reading)).is_ok();
    }
    let ns = start.elapsed().as_secs_f64() / f64::from(steps) * 1e9;
    if sound { ns } else { f64::NAN }
}

/// The same update as dense algebra, Joseph's form over all 3 + 2n states.
fn dense(n: usize) -> f64 {
    let size = 3 + 2 * n;
    let at = |i: usize, j: usize| if i == j { 1.0 } else { 0.1 / (1.0 + (i as f64 - j as f64).abs()) };
    let mut p = DMatrix::from_fn(size, size, at);
    let (f, v) = (DMatrix::identity(size, size), DMatrix::identity(size, size) * 1e-6);
    let mut h = DMatrix::zeros(2, size);
    for (row, column, value) in [(0, 0, 0.6), (0, 1, 0.8), (1, 0, -0.2), (1, 1, 0.15), (1, 2, -1.0)] {
        h[(row, column)] = value;
        if column < 2 {
            h[(row, 3 + n / 2 * 2 + column)] = -value;
        }
    }
    let w = DMatrix::from_diagonal(&DVector::from_vec(vec![0.01, 0.0009]));
    let steps = 5;
    let start = Instant::now();
    for _ in 0..steps {
        let predicted = linear::predicted_covariance(&f, &p, &v);
        match predicted.and_then(|predicted| linear::gain(&predicted, black_box(&h), &w)) {
            Ok(gain) => p = gain.p,
            Err(_) => return f64::NAN,
        }
    }
    start.elapsed().as_secs_f64() / f64::from(steps) * 1e9
}

fn lab<L: Lab<World = ()>>(steps: u32) -> f64 {
    let Ok(mut lab) = L::new(L::Params::default()) else { return f64::NAN };
    let start = Instant::now();
    let ran = lab.run(black_box(steps));
    let ns = start.elapsed().as_secs_f64() / f64::from(steps) * 1e9;
    if ran.is_ok() { ns } else { f64::NAN }
}

/// A pace once the processor has met the code, as the module's are taken.
fn warm(pace: impl Fn() -> f64) -> f64 {
    pace();
    pace()
}

fn main() {
    let mut times = vec![
        ("kalmanStep".to_string(), warm(kalman)),
        ("kalmanReplay".to_string(), warm(kalman_log)),
        ("ObserverBench".to_string(), warm(|| lab::<labs::ObserverBench>(20_000))),
        ("Localizer".to_string(), warm(ekf)),
        ("EkfLocalizer".to_string(), warm(localizer)),
        ("dense 100".to_string(), warm(|| dense(100))),
    ];
    times.extend([3, 30, 100, 300, 500].map(|n| (format!("EkfSlam {n}"), warm(|| mapping(n)))));
    let parts: Vec<String> = times.iter().map(|(name, ns)| format!("\"{name}\": {ns:.3}")).collect();
    println!("{{ {} }}", parts.join(", "));
}
