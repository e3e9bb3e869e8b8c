//! The autocorrelation of a series, by sums alone: a series of any length costs constant memory (Bar-Shalom, Li and
//! Kirubarajan 2001, §5.4.2, for innovations).

use numerics::sqrt;

/// The mean and the autocorrelation of a series x₀, x₁, … at the lags 1 to `LAGS`:
/// r(l) = Σ cᵢcᵢ₊ₗ / Σ cᵢ², with cᵢ the values less their mean.
///
/// The innovations of a filter whose model holds are white: every r(l) is 0 up to [`Autocorrelation::band`].
///
/// The sums are over the values less the first, so that a mean far from 0 costs no digits.
///
/// # Example
/// ```
/// let mut sums = filters::Autocorrelation::<2>::default();
/// [1.0, -1.0, 1.0, -1.0].into_iter().for_each(|x| sums.take(x));
/// assert_eq!((sums.mean(), sums.at(1), sums.at(2)), (Some(0.0), Some(-0.75), Some(0.5)));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Autocorrelation<const LAGS: usize> {
    count: u32,
    first: f64,
    sum: f64,
    squares: f64,
    /// Σ xᵢxᵢ₊ₗ, for l from 1.
    products: [f64; LAGS],
    /// The first values.
    head: [f64; LAGS],
    /// The last values: xᵢ at i modulo `LAGS`.
    tail: [f64; LAGS],
}

impl<const LAGS: usize> Default for Autocorrelation<LAGS> {
    fn default() -> Self {
        let none = [0.0; LAGS];
        Self { count: 0, first: 0.0, sum: 0.0, squares: 0.0, products: none, head: none, tail: none }
    }
}

impl<const LAGS: usize> Autocorrelation<LAGS> {
    /// Takes the next value.
    pub fn take(&mut self, value: f64) {
        let i = self.count as usize;
        if i == 0 {
            self.first = value;
        }
        let shifted = value - self.first;
        for lag in 1..=LAGS.min(i) {
            self.products[lag - 1] += self.tail[(i - lag) % LAGS] * shifted;
        }
        if i < LAGS {
            self.head[i] = shifted;
        }
        self.tail[i % LAGS] = shifted;
        self.sum += shifted;
        self.squares += shifted * shifted;
        self.count += 1;
    }

    /// How many values there were.
    pub fn count(&self) -> u32 {
        self.count
    }

    /// The mean; `None` of no value.
    pub fn mean(&self) -> Option<f64> {
        (self.count > 0).then(|| self.first + self.sum / f64::from(self.count))
    }

    /// r(`lag`), for a lag from 1 to `LAGS`. `None` where there are too few values, or where all are equal.
    pub fn at(&self, lag: usize) -> Option<f64> {
        let n = self.count as usize;
        if lag == 0 || lag > LAGS || n <= lag {
            return None;
        }
        let count = f64::from(self.count);
        let mean = self.sum / count;
        let variance = self.squares - count * mean * mean;
        // Multiplied out: Σ xᵢxᵢ₊ₗ − x̄ (Σ without the last l + Σ without the first l) + (n − l) x̄².
        let first: f64 = self.head[..lag].iter().sum();
        let last: f64 = (n - lag..n).map(|i| self.tail[i % LAGS]).sum();
        let covariance =
            self.products[lag - 1] - mean * (2.0 * self.sum - first - last) + (count - lag as f64) * mean * mean;
        (variance > 0.0).then(|| covariance / variance)
    }

    /// The half-width that r(l) of a white series stays within in 95 of 100 cases, for long series: 1.96 / √n. `None`
    /// of no value.
    pub fn band(&self) -> Option<f64> {
        (self.count > 0).then(|| 1.96 / sqrt(f64::from(self.count)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn taken<const LAGS: usize>(values: &[f64]) -> Autocorrelation<LAGS> {
        let mut sums = Autocorrelation::default();
        values.iter().for_each(|x| sums.take(*x));
        sums
    }

    #[test]
    fn the_autocorrelation_is_its_definition() {
        let wave: Vec<f64> = (0..200).map(|i| 1e3 + libm::sin(0.3 * f64::from(i)) + f64::from(i % 7)).collect();
        for values in [vec![1.0, 2.0, 4.0, -3.0], vec![1e6 + 1.0, 1e6 - 1.0, 1e6 + 2.0], vec![0.5, -0.5], wave] {
            let mean = values.iter().sum::<f64>() / values.len() as f64;
            let c: Vec<f64> = values.iter().map(|x| x - mean).collect();
            let variance: f64 = c.iter().map(|c| c * c).sum();
            let sums = taken::<5>(&values);
            for lag in 1..=5 {
                let covariance: f64 = (lag..c.len()).map(|i| c[i - lag] * c[i]).sum();
                match sums.at(lag) {
                    Some(found) => assert!((found - covariance / variance).abs() < 1e-9, "{lag} of {values:?}"),
                    None => assert!(values.len() <= lag),
                }
            }
            // The sum of the values rounds by a few last digits of the largest.
            let most = values.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
            assert!((sums.mean().expect("some") - mean).abs() < 4.0 * f64::EPSILON * most, "{values:?}");
        }
    }

    #[test]
    fn what_cannot_be_said_is_none() {
        let none = taken::<1>(&[]);
        assert_eq!((none.mean(), none.at(1), none.band()), (None, None, None));
        let one = taken::<1>(&[3.0]);
        assert_eq!((one.mean(), one.at(1), one.band()), (Some(3.0), None, Some(1.96)));
        assert_eq!(taken::<1>(&[3.0, 3.0]).at(1), None, "equal values have no correlation");
        assert_eq!(taken::<1>(&[3.0, 4.0, 2.0]).at(2), None, "a lag that was not asked for");
    }
}
