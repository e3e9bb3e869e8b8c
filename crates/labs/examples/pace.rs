//! Nanoseconds a step natively, one round, as JSON: the other half of the Node bench, which runs this between its own
//! rounds and prints the ratios.

use estimate::kf::{kalman_step, position_sensor};
use labs::Lab;
use nalgebra::Vector1;
use std::hint::black_box;
use std::time::Instant;

const STEPS: u32 = 200_000;

fn kalman() -> f64 {
    let (sys, mut belief) = position_sensor();
    let u = Vector1::new(0.1);
    let start = Instant::now();
    for step in 0..STEPS {
        let y = Vector1::new(f64::from(step % 7) * 0.3 - 0.9);
        black_box(kalman_step(black_box(&sys), &mut belief, &u, &y)).ok();
    }
    start.elapsed().as_secs_f64() / f64::from(STEPS) * 1e9
}

fn lab<L: Lab>(steps: u32) -> f64 {
    let Ok(mut lab) = L::new(L::Params::default()) else { return f64::NAN };
    let start = Instant::now();
    let ran = lab.run(black_box(steps));
    let ns = start.elapsed().as_secs_f64() / f64::from(steps) * 1e9;
    if ran.is_ok() { ns } else { f64::NAN }
}

fn main() {
    let times = [("kalmanStep", kalman()), ("ObserverBench", lab::<labs::ObserverBench>(20_000))];
    let parts: Vec<String> = times.iter().map(|(name, ns)| format!("\"{name}\": {ns:.3}")).collect();
    println!("{{ {} }}", parts.join(", "));
}
