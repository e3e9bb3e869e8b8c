//! The EKF's step with one range–bearing sighting, 3 states: predict and update.

use criterion::{Criterion, criterion_group, criterion_main};
use estimate::kf::Gaussian;
use estimate::landmarks::RangeBearing;
use estimate::{Landmark, Localizer, Sighting};
use nalgebra::{Matrix2, Matrix3, Vector2, Vector3};
use std::hint::black_box;

fn steps(bench: &mut Criterion) {
    let map = [Landmark { id: 0, x: 6.0, y: 6.0 }];
    let model = RangeBearing { map: &map };
    let start = Gaussian { x: Vector3::new(1.5, 1.5, 0.0), p: Matrix3::identity() * 0.01 };
    // Standing still and reading what is expected, a filter can step for ever without leaving its place.
    let (u, v) = (Vector2::new(0.0, 0.0), Matrix3::identity() * 1e-4);
    let w = Matrix2::new(0.01, 0.0, 0.0, 0.001);
    let sighting = Sighting { j: 0, y: Vector2::new(6.363961, -2.3561945) };

    bench.bench_function("EKF, predict and one range–bearing sighting", |b| {
        let mut ekf = Localizer::new(&start);
        b.iter(|| {
            ekf.predict(black_box(&u), black_box(&v))
                .and_then(|()| ekf.update(&model, black_box(&sighting), black_box(&w)))
        });
    });
    bench.bench_function("EKF, predict and a stack of one", |b| {
        let mut ekf = Localizer::new(&start);
        b.iter(|| {
            ekf.predict(black_box(&u), black_box(&v))
                .and_then(|()| ekf.update_stacked(&model, black_box(&[sighting]), black_box(&w)))
        });
    });
}

criterion_group!(benches, steps);
criterion_main!(benches);
