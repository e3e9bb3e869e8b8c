//! One Kalman step in Choset's letters.

use crate::error::{Argument, Code, Error};
use crate::lti::{Lti, SystemSizes};
use alloc::format;
use filters::{Conditioning, Sizes, Update};
pub use filters::{Gaussian, Kf};
use nalgebra::{DefaultAllocator, Dim, OMatrix, OVector};

// ANCHOR: kalman_step
/// What one step computes, eqs. 8.26–8.32.
#[derive(Clone, Debug, PartialEq)]
pub struct KalmanStep<N: Dim, M: Dim>
where
    DefaultAllocator: Sizes<N, M>,
{
    /// x̂(k+1 | k) and P(k+1 | k).
    pub predicted: Gaussian<N>,
    /// ν = y − H x̂(k+1 | k), p.
    pub innovation: OVector<f64, M>,
    /// S = H P(k+1 | k) Hᵀ + W, p×p.
    pub s: OMatrix<f64, M, M>,
    /// R = P(k+1 | k) Hᵀ S⁻¹, n×p: the gain. Thrun K.
    pub r: OMatrix<f64, N, M>,
    /// x̂(k+1 | k+1) and P(k+1 | k+1).
    pub posterior: Gaussian<N>,
    doubted: bool,
}

/// One Kalman step: the belief is predicted with the input `u` and corrected by the reading `y`.
///
/// # Errors
/// [`Code::NotFinite`] or [`Code::InnovationNotPositiveDefinite`]; [`Code::Shape`], for sizes known at run time only.
///
/// # Example
/// ```
/// use estimate::kf::kalman_step;
/// use nalgebra::Vector1;
/// let (sys, belief) = estimate::rail::dead_reckoning();
/// let step = kalman_step(&sys, &belief, &Vector1::new(0.0), &Vector1::new(2.7))?;
/// assert!((step.innovation[0] / step.s[0] + 0.5).abs() < 1e-15);
/// # Ok::<(), estimate::Error>(())
/// ```
pub fn kalman_step<N: Dim, U: Dim, M: Dim>(
    sys: &Lti<N, U, M>,
    belief: &Gaussian<N>,
    u: &OVector<f64, U>,
    y: &OVector<f64, M>,
) -> Result<KalmanStep<N, M>, Error>
where
    DefaultAllocator: SystemSizes<N, U, M>,
{
    fit(sys, belief, u, y)?;
    let input = Some((&sys.g, u)); // Thrun: (B, u)
    let predicted = belief.predicted(&sys.f, &sys.v, input).map_err(blame)?; // Thrun: A, R
    let (posterior, update) = predicted.corrected(y, &sys.h, &sys.w).map_err(blame)?; // Thrun: z, C, Q
    let (innovation, s, r, doubted) = (update.innovation, update.s, update.k, update.doubted); // Choset: ν, S, R
    Ok(KalmanStep { predicted, innovation, s, r, posterior, doubted })
}
// ANCHOR_END: kalman_step

impl<N: Dim, M: Dim> KalmanStep<N, M>
where
    DefaultAllocator: Sizes<N, M>,
{
    /// Whether S, P and x̂ are right to 10⁻⁶ of their largest entries (x̂ to that part of the largest deviation where
    /// this is more), with a `belief` whose P is known to the last digits of its entries. The bounds are of first
    /// order: of steps made to lose digits, fewer than one in 10,000 is called right and is not, by 10⁻⁴ at most.
    /// [`KalmanFilter`](crate::dynamic::KalmanFilter) says it of all steps since its first.
    pub fn conditioned<U: Dim>(&self, sys: &Lti<N, U, M>, belief: &Gaussian<N>) -> bool
    where
        DefaultAllocator: SystemSizes<N, U, M>,
    {
        let mut conditioning = Conditioning::of(&belief.p);
        if self.doubted {
            self.follow(&mut conditioning, sys, belief);
        }
        conditioning.is_well_conditioned()
    }

    /// Carries `conditioning` from the `belief` over this step.
    pub fn follow<U: Dim>(&self, conditioning: &mut Conditioning, sys: &Lti<N, U, M>, belief: &Gaussian<N>)
    where
        DefaultAllocator: SystemSizes<N, U, M>,
    {
        let (s, k, innovation) = (self.s.clone(), self.r.clone(), self.innovation.clone());
        let update = Update { innovation, s, k, d2: None, doubted: self.doubted };
        conditioning.predicted(&sys.f, &belief.p, &sys.v, !self.doubted);
        conditioning.corrected(&self.predicted.p, (&sys.h, &sys.w), &update, &self.posterior);
    }
}

/// Compares the shapes. Where they stand in the types this is decided when it is compiled.
///
/// # Errors
/// [`Code::Shape`], naming the argument that does not fit the system.
#[inline]
pub(crate) fn fit<N: Dim, U: Dim, M: Dim>(
    sys: &Lti<N, U, M>,
    belief: &Gaussian<N>,
    u: &OVector<f64, U>,
    y: &OVector<f64, M>,
) -> Result<(), Error>
where
    DefaultAllocator: SystemSizes<N, U, M>,
{
    belief_fits(belief, sys.f.nrows())?;
    size_fits(u.len(), sys.g.ncols(), "u")?;
    size_fits(y.len(), sys.h.nrows(), "y")
}

#[inline]
pub(crate) fn belief_fits<N: Dim>(belief: &Gaussian<N>, n: usize) -> Result<(), Error>
where
    DefaultAllocator: Sizes<N>,
{
    let (rows, columns) = belief.p.shape();
    size_fits(belief.x.len(), n, "belief")?;
    size_fits(rows, n, "belief")?;
    size_fits(columns, n, "belief")
}

#[inline]
fn size_fits(found: usize, needed: usize, argument: &'static str) -> Result<(), Error> {
    if found == needed { Ok(()) } else { Err(misfit(found, needed, argument)) }
}

#[cold]
fn misfit(found: usize, needed: usize, argument: &'static str) -> Error {
    Error::new(Code::Shape, argument, format!("is of size {found}; the system needs {needed}"))
}

/// A filter's error with the names that the arguments of [`kalman_step`] have.
#[cold]
pub(crate) fn blame(error: filters::Error) -> Error {
    Error::from(error).called(|argument| match argument {
        Argument::Mean => "belief.x".into(),
        Argument::Covariance => "belief.P".into(),
        other => other.letter(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::error::Code;
    use crate::observer::Observer;
    use crate::rail::{dead_reckoning, position_sensor};
    use nalgebra::{Dyn, Matrix1, Matrix2, U1, U2, Vector1, Vector2, dmatrix, dvector};

    // ANCHOR: tests
    #[test]
    fn two_steps_by_hand_are_met_to_the_last_digits() {
        let (sys, belief) = dead_reckoning();
        let step = |belief: &Gaussian<U2>, y: f64| {
            kalman_step(&sys, belief, &Vector1::zeros(), &Vector1::new(y)).expect("S is positive")
        };
        let first = step(&belief, 2.7);
        assert!((first.predicted.p - Matrix2::new(1.7, 1.05, 1.05, 2.1)).norm() < 1e-12);
        assert!((first.s[0] - 2.6).abs() < 1e-12);
        assert!((first.r - Vector2::new(21.0 / 52.0, 21.0 / 26.0)).norm() < 1e-12);
        let second = step(&first.posterior, 2.0);
        let exact = Matrix2::new(16429.0 / 10440.0, 59.0 / 261.0, 59.0 / 261.0, 131.0 / 522.0);
        assert!((second.posterior.p - exact).norm() < 1e-12);
    }

    /// The chapter's lens: an observer that is handed R(k) at every step has the filter's mean, bit for bit.
    #[test]
    fn kf_is_observer_with_scheduled_gain() {
        for (sys, mut belief) in [dead_reckoning(), position_sensor()] {
            let mut observer = Observer { sys, k: Vector2::zeros(), xhat: belief.x };
            for k in 0..400 {
                let u = Vector1::new(libm::cos(0.7 * f64::from(k)));
                let y = Vector1::new(libm::sin(f64::from(k * k)));
                let step = kalman_step(&sys, &belief, &u, &y).expect("S is positive");
                observer.k = step.r;
                observer.step(&u, &y);
                assert_eq!(observer.xhat, step.posterior.x, "step {k}");
                belief = step.posterior;
            }
        }
    }
    // ANCHOR_END: tests

    #[test]
    fn a_step_refuses_what_it_cannot_use_and_names_it() {
        let (sys, belief) = dead_reckoning();
        let blame = |sys: &Lti<U2, U1, U1>, belief: &Gaussian<U2>, u: f64, y: f64| {
            let error = kalman_step(sys, belief, &Vector1::new(u), &Vector1::new(y)).expect_err("refused");
            (error.code, error.argument.to_string())
        };
        assert_eq!(blame(&sys, &belief, 0.0, f64::NAN), (Code::NotFinite, "y".into()));
        assert_eq!(blame(&sys, &belief, f64::INFINITY, 0.0), (Code::NotFinite, "u".into()));
        let lost = Gaussian { x: Vector2::new(f64::NAN, 0.0), ..belief };
        assert_eq!(blame(&sys, &lost, 0.0, 0.0), (Code::NotFinite, "belief.x".into()));
        let blind = Lti { w: Matrix1::new(-9.0), ..sys };
        assert_eq!(blame(&blind, &belief, 0.0, 0.0), (Code::InnovationNotPositiveDefinite, "W".into()));
    }

    #[test]
    fn sizes_known_at_run_time_only_are_compared() {
        let one = dmatrix![1.0];
        let sys = Lti { f: one.clone(), g: one.clone(), h: one.clone(), v: one.clone(), w: one.clone() };
        let belief = Gaussian { x: dvector![1.0], p: one.clone() };
        let blame = |belief: &Gaussian<Dyn>, u, y| {
            let error = kalman_step(&sys, belief, &u, &y).expect_err("refused");
            assert_eq!(error.code, Code::Shape);
            error.argument.to_string()
        };
        assert_eq!(blame(&belief, dvector![0.0, 0.0], dvector![0.0]), "u");
        assert_eq!(blame(&belief, dvector![0.0], dvector![]), "y");
        let wide = Gaussian { x: dvector![1.0, 2.0], p: dmatrix![1.0, 0.0; 0.0, 1.0] };
        assert_eq!(blame(&wide, dvector![0.0], dvector![0.0]), "belief");
        let torn = Gaussian { x: dvector![1.0], p: dmatrix![1.0, 0.0; 0.0, 1.0] };
        assert_eq!(blame(&torn, dvector![0.0], dvector![0.0]), "belief");
        assert!(kalman_step(&sys, &belief, &dvector![0.0], &dvector![0.0]).is_ok());
    }
}
