//! Rusty: two driven wheels on one axle, and an encoder on each.

use crate::noise::Noise;
use crate::paths::Tick;
use estimate::{Ticks, Wheels};
use geom::SE2;

/// The robot: where it truly is, and what its encoders say.
///
/// It drives its course exactly; what its encoders count differs by slip, by the right wheel's true radius, which is
/// smaller than the nominal one by the bias, and by the rounding to whole ticks.
#[derive(Clone, Debug)]
pub struct Rusty {
    wheels: Wheels,
    bias: f64,
    slip: f64,
    world_from_robot: SE2,
    /// How far each wheel has rolled since its last whole tick, metres of a nominal wheel.
    uncounted: [f64; 2],
}

impl Rusty {
    /// The robot at a pose; `bias` is a fraction of the radius, `slip` one sigma in metres per wheel and tick of the
    /// course.
    pub fn new(world_from_robot: SE2, wheels: Wheels, bias: f64, slip: f64) -> Self {
        Self { wheels, bias, slip, world_from_robot, uncounted: [0.0; 2] }
    }

    /// The true pose.
    pub fn pose(&self) -> SE2 {
        self.world_from_robot
    }

    /// Drives one tick of a course, and answers what the encoders counted meanwhile.
    pub fn drive(&mut self, tick: Tick, noise: &mut Noise) -> Ticks {
        self.world_from_robot = tick.drive(self.world_from_robot);
        let half = 0.5 * self.wheels.baseline * tick.dtheta;
        let mut count = |wheel: usize, rolled: f64| {
            let turned = rolled + self.slip * noise.normal() + self.uncounted[wheel];
            let ticks = libm::round(turned / self.wheels.metres_per_tick());
            self.uncounted[wheel] = turned - ticks * self.wheels.metres_per_tick();
            ticks as i64
        };
        Ticks { left: count(0, tick.ds - half), right: count(1, (tick.ds + half) * (1.0 + self.bias)) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scenarios::HOOK;
    use estimate::{odometry_delta, slip_covariance};
    use nalgebra::{Matrix2, Vector2};

    fn measured(ticks: Ticks) -> [f64; 2] {
        [ticks.left, ticks.right].map(|t| t as f64 * HOOK.wheels.metres_per_tick())
    }

    #[test]
    fn without_bias_and_slip_the_encoders_tell_the_wheels_way_to_a_tick() {
        let mut rusty = Rusty::new(SE2::new(0.0, 0.0, 0.0), HOOK.wheels, 0.0, 0.0);
        let mut noise = Noise::new(1);
        let (mut left, mut right) = (0.0, 0.0);
        for _ in 0..100 {
            let [l, r] = measured(rusty.drive(Tick { ds: 0.05, dtheta: 0.01 }, &mut noise));
            left += l;
            right += r;
        }
        // Counts are rounded, but what was rounded away is counted later: the error does not grow.
        let tick = HOOK.wheels.metres_per_tick();
        assert!((left - (5.0 - 0.2)).abs() <= 0.5 * tick + 1e-12 && (right - (5.0 + 0.2)).abs() <= 0.5 * tick + 1e-12);
    }

    #[test]
    fn the_bias_lengthens_the_right_wheel_s_way_alone() {
        let mut rusty = Rusty::new(SE2::new(0.0, 0.0, 0.0), HOOK.wheels, 0.01, 0.0);
        let mut noise = Noise::new(1);
        let [left, right] = measured(rusty.drive(Tick { ds: 10.0, dtheta: 0.0 }, &mut noise));
        let tick = HOOK.wheels.metres_per_tick();
        assert!((left - 10.0).abs() < tick && (right - 10.1).abs() < tick);
        assert_eq!(rusty.pose(), SE2::new(10.0, 0.0, 0.0), "the truth keeps to its course");
    }

    #[test]
    fn slip_has_the_spread_it_is_given() {
        let mut rusty = Rusty::new(SE2::new(0.0, 0.0, 0.0), HOOK.wheels, 0.0, 0.001);
        let mut noise = Noise::new(2);
        let n = 4000;
        let variance = (0..n)
            .map(|_| {
                let [left, _] = measured(rusty.drive(Tick { ds: 0.05, dtheta: 0.0 }, &mut noise));
                (left - 0.05) * (left - 0.05)
            })
            .sum::<f64>()
            / f64::from(n);
        assert!((variance / 1e-6 - 1.0).abs() < 0.1, "{variance}");
    }

    fn driven(slip: f64, tick: Tick, noise: &mut Noise) -> Vector2<f64> {
        let mut rusty = Rusty::new(SE2::new(0.0, 0.0, 0.0), HOOK.wheels, 0.0, slip);
        odometry_delta(&HOOK.wheels, rusty.drive(tick, noise))
    }

    #[test]
    fn odometry_undoes_the_encoders() {
        let u = driven(0.0, Tick { ds: 0.73, dtheta: -0.4 }, &mut Noise::new(1));
        // Half a tick (38 µm) per wheel.
        assert!((u[0] - 0.73).abs() < 4e-5 && (u[1] + 0.4).abs() < 2e-4);
    }

    #[test]
    fn slip_has_the_covariance_claimed() {
        let (mut noise, n) = (Noise::new(5), 20_000);
        let mut sum = Matrix2::zeros();
        for _ in 0..n {
            let u = driven(0.05, Tick { ds: 0.0, dtheta: 0.0 }, &mut noise);
            sum += u * u.transpose();
        }
        let claimed = slip_covariance(&HOOK.wheels, 0.05);
        let found = sum / f64::from(n);
        // Five standard errors of a sample variance, √(2/n) of itself each.
        assert!((found[(0, 0)] / claimed[(0, 0)] - 1.0).abs() < 0.05);
        assert!((found[(1, 1)] / claimed[(1, 1)] - 1.0).abs() < 0.05);
        assert!(found[(0, 1)].abs() < 5.0 * (claimed[(0, 0)] * claimed[(1, 1)] / f64::from(n)).sqrt());
    }
}
