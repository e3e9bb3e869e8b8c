//! The 2-state step of the rail robot (§8.2.6): the filter, and the observer with a fixed gain.

use criterion::{Criterion, criterion_group, criterion_main};
use estimate::Observer;
use estimate::kf::kalman_step;
use estimate::rail::position_sensor;
use nalgebra::{Vector1, Vector2};
use std::hint::black_box;

fn steps(bench: &mut Criterion) {
    let (sys, start) = position_sensor();
    let (u, y) = (Vector1::new(0.1), Vector1::new(0.3));

    bench.bench_function("kalman_step, 2 states", |b| {
        let mut belief = start;
        b.iter(|| {
            let step = kalman_step(black_box(&sys), &belief, black_box(&u), black_box(&y));
            if let Ok(step) = &step {
                belief = step.posterior;
            }
            step
        });
    });
    bench.bench_function("Observer::step, 2 states", |b| {
        let mut observer = Observer { sys, k: Vector2::new(0.6, 0.3), xhat: start.x };
        b.iter(|| {
            black_box(&mut observer).step(black_box(&u), black_box(&y));
            observer.xhat
        });
    });
}

criterion_group!(benches, steps);
criterion_main!(benches);
