//! One Kalman step in Choset's letters, and the rail robot of §8.2.6.

use crate::error::Error;
use crate::lti::Lti;
pub use filters::kalman::{Gaussian, Kf};
use nalgebra::{Matrix1, Matrix2, RowVector2, SMatrix, SVector, Vector2};

// ANCHOR: kalman_step
/// ν, S and R of one step: p, p×p and n×p.
pub type Step<const N: usize, const M: usize> = (SVector<f64, M>, SMatrix<f64, M, M>, SMatrix<f64, N, M>);

/// One predict–update pair, eqs. 8.26–8.32: the belief moves on, and the answer is (ν, S, R).
///
/// # Errors
/// [`crate::Code::InnovationNotPositiveDefinite`] or [`crate::Code::NotFinite`]; the belief is then as it was.
///
/// # Example
/// ```
/// use estimate::kf::{dead_reckoning, kalman_step};
/// use nalgebra::Vector1;
/// let (sys, mut belief) = dead_reckoning();
/// let (nu, s, _) = kalman_step(&sys, &mut belief, &Vector1::new(0.0), &Vector1::new(2.7))?;
/// assert!((nu[0] / s[0] + 0.5).abs() < 1e-15);
/// # Ok::<(), estimate::Error>(())
/// ```
pub fn kalman_step<const N: usize, const U: usize, const M: usize>(
    sys: &Lti<N, U, M>,
    belief: &mut Gaussian<N>,
    u: &SVector<f64, U>,
    y: &SVector<f64, M>,
) -> Result<Step<N, M>, Error> {
    let mut filter = Kf::from(*belief);
    filter.predict(&sys.f, &sys.v, Some((&sys.g, u)))?; // Thrun: A, R, (B, u)
    let info = filter.update(y, &sys.h, &sys.w)?; // Thrun: z, C, Q
    *belief = filter.belief();
    Ok((info.innovation, info.s, info.k)) // Choset: ν, S, R
}
// ANCHOR_END: kalman_step

// ANCHOR: dead_reckoning
/// The rail robot of §8.2.6 with its velocity sensor, and its first belief N(x̂(k|k), P(k|k)): state [m, m/s], a force
/// of 1 N accelerates its 1 kg by 1 m/s², sampled every 0.5 s.
pub fn dead_reckoning() -> (Lti<2, 1, 1>, Gaussian<2>) {
    let (t, mass) = (0.5, 1.0);
    let sys = Lti {
        f: Matrix2::new(1.0, t, 0.0, 1.0),
        g: Vector2::new(0.0, t / mass),
        h: RowVector2::new(0.0, 1.0),
        v: Matrix2::new(0.2, 0.05, 0.05, 0.1),
        w: Matrix1::new(0.5),
    };
    (sys, Gaussian { x: Vector2::new(2.0, 4.0), p: Matrix2::new(1.0, 0.0, 0.0, 2.0) })
}

/// The same robot with a sensor of its position instead.
pub fn position_sensor() -> (Lti<2, 1, 1>, Gaussian<2>) {
    let (sys, belief) = dead_reckoning();
    (Lti { h: RowVector2::new(1.0, 0.0), ..sys }, belief)
}
// ANCHOR_END: dead_reckoning

#[cfg(test)]
mod tests {
    use super::*;
    use crate::observer::Observer;
    use nalgebra::Vector1;

    // ANCHOR: tests
    #[test]
    fn two_steps_by_hand_are_met_to_the_last_digits() {
        let (sys, mut belief) = dead_reckoning();
        let step = |belief: &mut Gaussian<2>, y: f64| {
            kalman_step(&sys, belief, &Vector1::zeros(), &Vector1::new(y)).expect("S is positive")
        };
        let (_, s, r) = step(&mut belief, 2.7);
        assert!((s[0] - 2.6).abs() < 1e-12 && (r - Vector2::new(21.0 / 52.0, 21.0 / 26.0)).norm() < 1e-12);
        step(&mut belief, 2.0);
        let exact = Matrix2::new(16429.0 / 10440.0, 59.0 / 261.0, 59.0 / 261.0, 131.0 / 522.0);
        assert!((belief.p - exact).norm() < 1e-12);
    }

    /// The chapter's lens: an observer that is handed R(k) at every step has the filter's mean, bit for bit.
    #[test]
    fn kf_is_observer_with_scheduled_gain() {
        for (sys, mut belief) in [dead_reckoning(), position_sensor()] {
            let mut observer = Observer { sys, k: SMatrix::zeros(), xhat: belief.x };
            for k in 0..400 {
                let (u, y) = (Vector1::new(libm::cos(0.7 * f64::from(k))), Vector1::new(libm::sin(f64::from(k * k))));
                let (_, _, r) = kalman_step(&sys, &mut belief, &u, &y).expect("S is positive");
                observer.k = r;
                observer.step(&u, &y);
                assert_eq!(observer.xhat, belief.x, "step {k}");
            }
        }
    }
    // ANCHOR_END: tests

    #[test]
    fn a_refused_step_leaves_the_belief() {
        let (sys, mut belief) = dead_reckoning();
        let before = belief;
        assert!(kalman_step(&sys, &mut belief, &Vector1::zeros(), &Vector1::new(f64::NAN)).is_err());
        let blind = Lti { w: Matrix1::new(-9.0), ..sys };
        assert!(kalman_step(&blind, &mut belief, &Vector1::zeros(), &Vector1::new(0.0)).is_err());
        assert_eq!(belief, before);
    }
}
