//! The maximum of a smooth function of a few variables in a box: Newton's method on central differences, damped where
//! the function is not concave or a step would lead down (Nocedal and Wright 2006, §3.4 and §16.7).

use crate::spd::Spd;
use nalgebra::{Const, SMatrix, SVector};

/// The most Newton steps. Near a maximum each squares the distance, so that few are needed.
const MAX_STEPS: usize = 60;
/// The most dampings tried for one step, each ten times the one before; the last shortens a step to nothing.
const MAX_DAMPINGS: usize = 20;

/// Where a function of N variables is greatest, and how it bends there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Maximum<const N: usize> {
    /// The place.
    pub at: SVector<f64, N>,
    /// The function's value there.
    pub value: f64,
    /// The first derivatives there.
    pub gradient: SVector<f64, N>,
    /// The second derivatives there.
    pub hessian: SMatrix<f64, N, N>,
    /// Which variables the box holds back: each is at a bound, and the function still rises beyond.
    pub held: [bool; N],
    /// Whether the search ended because another Newton step promised no more than the tolerance.
    pub converged: bool,
}

/// The local maximum of `f` in the box `bounds` (least and greatest of each variable) that Newton's method reaches from
/// `start`. The derivatives are central differences of this `step`, so `f` is evaluated that far outside the box too.
/// The search stops where a Newton step promises a gain of at most `tolerance`, after 60 steps, or where no step leads
/// up, as where `f` is flat or not a number; only the first of these is called converged.
///
/// # Example
/// ```
/// use nalgebra::Vector2;
/// let hill = |x: &Vector2<f64>| -(x[0] - 1.0) * (x[0] - 1.0) - 2.0 * x[1] * x[1];
/// let top = numerics::maximum(hill, Vector2::new(3.0, 3.0), &[[-5.0, 5.0]; 2], 1e-3, 1e-12);
/// assert!(top.converged && (top.at - Vector2::new(1.0, 0.0)).amax() < 1e-8);
/// assert!((top.hessian[(1, 1)] + 4.0).abs() < 1e-6);
/// ```
pub fn maximum<const N: usize>(
    f: impl Fn(&SVector<f64, N>) -> f64,
    start: SVector<f64, N>,
    bounds: &[[f64; 2]; N],
    step: f64,
    tolerance: f64,
) -> Maximum<N> {
    let within = |x: SVector<f64, N>| SVector::<f64, N>::from_fn(|i, _| x[i].max(bounds[i][0]).min(bounds[i][1]));
    let mut here = expanded(&f, within(start), bounds, step);
    for _ in 0..MAX_STEPS {
        let mut damping = 0.0;
        let mut higher = None;
        for _ in 0..MAX_DAMPINGS {
            if let Some(newton) = here.newton_step(damping) {
                if damping == 0.0 && 0.5 * here.gradient.dot(&newton) <= tolerance {
                    here.converged = true;
                    return here;
                }
                higher = Some(within(here.at + newton)).filter(|x| f(x) > here.value);
                if higher.is_some() {
                    break;
                }
            }
            damping = if damping == 0.0 { 1e-3 * (here.hessian.amax() + here.gradient.amax()) } else { 10.0 * damping };
        }
        let Some(higher) = higher else { break };
        here = expanded(&f, higher, bounds, step);
    }
    here
}

/// Value and differences of `f` at `x`.
fn expanded<const N: usize>(
    f: &impl Fn(&SVector<f64, N>) -> f64,
    x: SVector<f64, N>,
    bounds: &[[f64; 2]; N],
    step: f64,
) -> Maximum<N> {
    let value = f(&x);
    let beside = |i: usize, j: usize, sign: f64| {
        let mut moved = x;
        moved[i] += sign * step;
        if i != j {
            moved[j] += sign * step;
        }
        f(&moved)
    };
    let (mut gradient, mut hessian) = (SVector::<f64, N>::zeros(), SMatrix::<f64, N, N>::zeros());
    for i in 0..N {
        let (up, down) = (beside(i, i, 1.0), beside(i, i, -1.0));
        gradient[i] = (up - down) / (2.0 * step);
        hessian[(i, i)] = (up - 2.0 * value + down) / (step * step);
    }
    for i in 0..N {
        for j in 0..i {
            // Along the diagonal of i and j the second difference is h² (fᵢᵢ + 2 fᵢⱼ + fⱼⱼ).
            let along = (beside(i, j, 1.0) - 2.0 * value + beside(i, j, -1.0)) / (step * step);
            let mixed = 0.5 * (along - hessian[(i, i)] - hessian[(j, j)]);
            hessian[(i, j)] = mixed;
            hessian[(j, i)] = mixed;
        }
    }
    let mut held = [false; N];
    for i in 0..N {
        held[i] = (x[i] <= bounds[i][0] && gradient[i] < 0.0) || (x[i] >= bounds[i][1] && gradient[i] > 0.0);
    }
    Maximum { at: x, value, gradient, hessian, held, converged: false }
}

impl<const N: usize> Maximum<N> {
    /// (−H + damping · I)⁻¹ ∇f in the variables that are not held; nothing where that matrix is not positive definite.
    fn newton_step(&self, damping: f64) -> Option<SVector<f64, N>> {
        let free = |i: usize| !self.held[i];
        let curvature = SMatrix::<f64, N, N>::from_fn(|i, j| {
            let own = f64::from(u8::from(i == j));
            if free(i) && free(j) { damping * own - self.hessian[(i, j)] } else { own }
        });
        let uphill = SVector::<f64, N>::from_fn(|i, _| if free(i) { self.gradient[i] } else { 0.0 });
        Spd::<Const<N>>::new(curvature).map(|spd| spd.solve(&uphill))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::{Vector1, Vector2};

    const BOX: [[f64; 2]; 2] = [[-4.0, 4.0], [-4.0, 4.0]];

    fn search(f: impl Fn(&Vector2<f64>) -> f64, start: [f64; 2]) -> Maximum<2> {
        maximum(f, Vector2::from(start), &BOX, 1e-4, 1e-9)
    }

    #[test]
    fn a_curved_ridge_is_climbed_to_its_end() {
        // Rosenbrock's function (1960), upside down: its Hessian is indefinite on much of the way.
        let ridge = |x: &Vector2<f64>| {
            let off = x[1] - x[0] * x[0];
            -100.0 * off * off - (1.0 - x[0]) * (1.0 - x[0])
        };
        for start in [[-1.2, 1.0], [3.0, -3.0], [0.0, 0.0], [-4.0, -4.0]] {
            let top = search(ridge, start);
            assert!(top.converged && (top.at - Vector2::new(1.0, 1.0)).amax() < 1e-3, "{start:?} {top:?}");
            // Second derivatives −802, 400 and −200, at a place that the tolerance leaves 10⁻⁴ away.
            let exact = SMatrix::<f64, 2, 2>::new(-802.0, 400.0, 400.0, -200.0);
            assert!((top.hessian - exact).amax() < 0.5, "{}", top.hessian);
        }
    }

    #[test]
    fn a_maximum_beyond_the_box_is_sought_on_its_edge() {
        let hill = |x: &Vector2<f64>| -(x[0] - 9.0) * (x[0] - 9.0) - x[1] * x[1] - x[0] * x[1];
        let top = search(hill, [0.0, 0.0]);
        // On the edge x₀ = 4 the hill is greatest at x₁ = −x₀/2.
        assert!(top.converged && (top.at - Vector2::new(4.0, -2.0)).amax() < 1e-4, "{top:?}");
        assert_eq!(top.held, [true, false]);
        let corner = search(|x| x[0] - x[1], [0.5, 0.5]);
        assert!(corner.converged && corner.held == [true, true] && corner.value == 8.0, "{corner:?}");
    }

    #[test]
    fn where_nothing_rises_the_search_ends_and_says_so() {
        assert!(!search(|_| 1.0, [0.5, 0.5]).converged);
        let nan = search(|_| f64::NAN, [0.5, 0.5]);
        assert!(!nan.converged && nan.at == Vector2::new(0.5, 0.5));
        // A start outside is brought inside first.
        let one = maximum(|x: &Vector1<f64>| -x[0] * x[0], Vector1::new(77.0), &[[1.0, 2.0]], 1e-4, 1e-12);
        assert!(one.converged && one.at[0] == 1.0 && one.held == [true], "{one:?}");
    }
}
