//! The two hand-checked steps of §8.2.6 and both observability ranks.

// ANCHOR: example
use estimate::kf::kalman_step;
use estimate::rail::{dead_reckoning, position_sensor};
use nalgebra::Vector1;

fn main() -> Result<(), estimate::Error> {
    let (sys, mut belief) = dead_reckoning();
    for (k, y) in [2.7, 2.0].into_iter().enumerate() {
        let step = kalman_step(&sys, &belief, &Vector1::zeros(), &Vector1::new(y))?;
        let (nu, s, r) = (step.innovation, step.s, step.r);
        println!("step {}: ν = {:+.3}  S = {:.4}  R = [{:.4}, {:.4}]", k + 1, nu[0], s[0], r[0], r[1]);
        belief = step.posterior;
        let (x, p) = (belief.x, belief.p);
        print!("        x̂⁺ = [{:.3}, {:.3}]   ", x[0], x[1]);
        println!("P⁺ = [[{:.4}, {:.4}], [{:.4}, {:.4}]]", p[(0, 0)], p[(0, 1)], p[(1, 0)], p[(1, 1)]);
    }
    let (with_position, _) = position_sensor();
    let (velocity, position) = (sys.observability(1e-9)?, with_position.observability(1e-9)?);
    println!("rank Q = {} (velocity sensor), {} (position sensor)", velocity.rank, position.rank);
    Ok(())
}
// ANCHOR_END: example
