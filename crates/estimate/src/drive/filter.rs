//! The filter of a replay: a pose, and as many learned numbers as are asked for.

use crate::drive::course::Course;
use crate::drive::learned::{FIRST_SIGMA_BIAS, Learned, Moved, Rolling, Which};
use crate::ekf::Localizer;
use crate::error::Error;
use crate::reading::{Corrected, Reading, Setup};
use crate::scaled::{FIRST_SIGMA, of_pose};
use filters::{Ekf, MotionModel};
use geom::SE2;
use nalgebra::{DMatrix, DVector, Matrix2, SMatrix, Vector2, Vector3};

/// The localizer: of the pose alone, or with all that can be learned. States that are not learned stay at 0, and no
/// covariance ties them to the others, so that every digit is that of a filter without them.
#[derive(Clone, Copy, Debug)]
#[expect(clippy::large_enum_variant, reason = "a replay is copied, and what is boxed is not")]
pub(crate) enum Filter {
    Three(Localizer),
    Six(Localizer<Learned<6>, 6>),
}

/// Does the same with the localizer of any size.
macro_rules! of_any_size {
    ($filter:expr, $localizer:ident => $answer:expr) => {
        match $filter {
            Filter::Three($localizer) => $answer,
            Filter::Six($localizer) => $answer,
        }
    };
}

/// What moves the estimate between two times: distance and turn as they were read, over `rolling.dt` seconds, with the
/// input noise M of that time.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Move {
    pub u: Vector2<f64>,
    pub rolling: Rolling,
    pub noise: Matrix2<f64>,
}

impl Move {
    /// V = B M Bᵀ at a state.
    pub fn process<X: Moved<N>, const N: usize>(&self, x: &X) -> SMatrix<f64, N, N> {
        of_pose(&self.rolling.process(x, &self.u, &self.noise))
    }
}

impl Filter {
    /// The belief at the start of a course.
    pub fn new(course: &Course) -> Self {
        let which = course.which();
        match which.states() {
            3 => Self::Three(Localizer { filter: Ekf { x: course.pose(), p: first(course) } }),
            _ => Self::Six(learning(course)),
        }
    }

    pub fn predict(&mut self, moved: &Move) -> Result<(), Error> {
        of_any_size!(self, localizer => predict(&mut localizer.filter, moved))
    }

    pub fn correct(&mut self, reading: &Reading, setup: &Setup<'_>) -> Result<Corrected, Error> {
        of_any_size!(self, localizer => localizer.correct(reading, setup))
    }

    /// The pose, which numbers are learned, and these.
    pub fn estimate(&self) -> (SE2, Which, Vector3<f64>) {
        match self {
            Self::Three(localizer) => (localizer.filter.x, Which::default(), Vector3::zeros()),
            Self::Six(Localizer { filter }) => (filter.x.pose, filter.x.which, filter.x.numbers),
        }
    }

    /// The state as a vector: x, y, θ and what is learned.
    pub fn state(&self) -> DVector<f64> {
        let (pose, which, numbers) = self.estimate();
        let pose = pose.to_vector();
        DVector::from_fn(which.states(), |i, _| if i < 3 { pose[i] } else { numbers[i - 3] })
    }

    /// That of x and y.
    pub fn place_covariance(&self) -> Matrix2<f64> {
        of_any_size!(self, localizer => localizer.filter.p.fixed_view::<2, 2>(0, 0).into_owned())
    }

    /// P of the states that there are.
    pub fn covariance(&self) -> DMatrix<f64> {
        let n = self.estimate().1.states();
        of_any_size!(self, localizer => {
            let p = &localizer.filter.p;
            DMatrix::from_fn(n, n, |i, j| p[(i, j)])
        })
    }
}

/// P ← F P Fᵀ + B M Bᵀ.
fn predict<X: Moved<N>, const N: usize>(filter: &mut Ekf<X, N>, moved: &Move) -> Result<(), Error>
where
    Rolling: MotionModel<X, N, 2>,
{
    let v = moved.process(&filter.x);
    Ok(filter.predict(&moved.rolling, &moved.u, &v)?)
}

fn learning(course: &Course) -> Localizer<Learned<6>, 6> {
    let x = Learned { pose: course.pose(), which: course.which(), numbers: Vector3::zeros() };
    Localizer { filter: Ekf { x, p: first(course) } }
}

/// P at the start.
fn first<const N: usize>(course: &Course) -> SMatrix<f64, N, N> {
    let (settings, which) = (course.settings(), course.which());
    let sigma = |i: usize| match i {
        0 | 1 => settings.start_sigma,
        2 => settings.start_sigma_heading,
        _ if which.turn_bias() == Some(i) => FIRST_SIGMA_BIAS,
        // Any that is not 0: a smoother factors P.
        _ if i >= which.states() => 1.0,
        _ => FIRST_SIGMA[3],
    };
    SMatrix::from_fn(|i, j| if i == j { sigma(i) * sigma(i) } else { 0.0 })
}
