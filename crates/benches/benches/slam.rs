//! Range–bearing SLAM (§8.4.2): predict and one sighting with n landmarks in the map, the landmark named and
//! associated; then the exponent with which the time grows from n = 100 to 500.

use criterion::measurement::WallTime;
use criterion::{BenchmarkGroup, BenchmarkId, Criterion, criterion_group, criterion_main};
use estimate::kf::Gaussian;
use estimate::slam::{EkfSlam, LandmarkReading, Outcome};
use filters::association::Thresholds;
use nalgebra::{Matrix2, Matrix3, Vector2, Vector3};
use std::hint::black_box;
use std::time::{Duration, Instant};

/// Sizes of the map.
const SIZES: [u32; 5] = [3, 30, 100, 300, 500];

/// Landmarks on a spiral about the robot, none near another.
fn reading(j: u32, landmark: Option<u32>) -> LandmarkReading {
    let j = f64::from(j);
    LandmarkReading { range: 3.0 + 0.5 * j, bearing: 2.4 * j, landmark }
}

/// A robot that has met n landmarks.
fn slam(n: u32) -> Option<EkfSlam> {
    let belief = Gaussian { x: Vector3::zeros(), p: Matrix3::identity() * 1e-4 };
    let w = Matrix2::new(0.01, 0.0, 0.0, 0.0009);
    let mut slam = EkfSlam::new(&belief, &w, Thresholds { gate: 9.21, found: 50.0 }).ok()?;
    for id in 0..n {
        slam.update(&[reading(id, Some(id))]).ok()?;
    }
    Some(slam)
}

/// Standing still and reading what is expected, a filter can step for ever without leaving its place. Whether the
/// sighting was matched: a rejected one would cost next to nothing.
fn step(slam: &mut EkfSlam, reading: &LandmarkReading) -> bool {
    let (u, v) = (Vector2::zeros(), Matrix3::identity() * 1e-6);
    let matched = |slam: &mut EkfSlam| {
        let reports = slam.update(black_box(std::slice::from_ref(reading)));
        reports.is_ok_and(|reports| reports.iter().all(|r| r.outcome == Outcome::Matched))
    };
    slam.predict(black_box(&u), black_box(&v)).is_ok() && matched(slam)
}

fn over_sizes(group: &mut BenchmarkGroup<'_, WallTime>, named: bool) {
    for n in SIZES {
        let mut slam = slam(n).unwrap_or_else(|| panic!("{n} landmarks can be founded"));
        let reading = reading(n / 2, named.then_some(n / 2));
        assert!(step(&mut slam, &reading), "the sighting is matched");
        group.bench_with_input(BenchmarkId::from_parameter(n), &reading, |b, reading| {
            b.iter(|| step(&mut slam, reading));
        });
        assert!(step(&mut slam, &reading) && slam.len() == n as usize, "it still is, and nothing was founded");
    }
}

fn steps(bench: &mut Criterion) {
    for (name, named) in [("EKF-SLAM, a named landmark", true), ("EKF-SLAM, associated", false)] {
        let mut group = bench.benchmark_group(name);
        over_sizes(&mut group, named);
        group.finish();
    }
}

/// Seconds a step: the median of five rounds. The rounds of all sizes are interleaved, so that what else the machine is
/// doing falls on all alike.
fn seconds(sizes: &[u32]) -> Option<Vec<f64>> {
    let mut maps = sizes.iter().map(|&n| slam(n)).collect::<Option<Vec<_>>>()?;
    let mut rounds = vec![Vec::new(); sizes.len()];
    for _ in 0..5 {
        for ((slam, n), times) in maps.iter_mut().zip(sizes).zip(&mut rounds) {
            let (reading, began, mut count) = (reading(n / 2, Some(n / 2)), Instant::now(), 0.0);
            while began.elapsed() < Duration::from_millis(200) {
                black_box(step(slam, &reading));
                count += 1.0;
            }
            times.push(began.elapsed().as_secs_f64() / count);
        }
    }
    rounds.iter_mut().for_each(|times| times.sort_by(f64::total_cmp));
    Some(rounds.iter().map(|times| times[times.len() / 2]).collect())
}

/// The slope of ln time over ln n, by least squares.
fn growth(_: &mut Criterion) {
    let sizes = [100, 200, 300, 400, 500];
    let Some(times) = seconds(&sizes) else { return };
    let points: Vec<(f64, f64)> = sizes.iter().zip(&times).map(|(n, t)| (f64::from(*n).ln(), t.ln())).collect();
    let mean = |of: fn(&(f64, f64)) -> f64| points.iter().map(of).sum::<f64>() / points.len() as f64;
    let (x, y) = (mean(|p| p.0), mean(|p| p.1));
    let (above, below) = points.iter().fold((0.0, 0.0), |(a, b), p| (a + (p.0 - x) * (p.1 - y), b + (p.0 - x).powi(2)));
    let listed: Vec<String> = sizes.iter().zip(&times).map(|(n, t)| format!("{n}: {:.1} µs", t * 1e6)).collect();
    println!("EKF-SLAM, predict and one sighting: {}", listed.join(", "));
    println!("EKF-SLAM, growth from 100 to 500 landmarks: n^{:.2}", above / below);
}

criterion_group!(benches, steps, growth);
criterion_main!(benches);
