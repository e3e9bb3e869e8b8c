//! A number over many seeds, and the runs behind it.

use estimate::Error;

/// Seeds of an ensemble: 0, 1, 2, ….
pub const SEEDS: u32 = 500;

/// A number over an ensemble.
#[derive(Clone, Debug, PartialEq)]
pub struct Distribution {
    sorted: Vec<f64>,
}

impl Distribution {
    /// The spread of these values.
    pub fn new(values: impl IntoIterator<Item = f64>) -> Self {
        let mut sorted: Vec<f64> = values.into_iter().collect();
        sorted.sort_by(f64::total_cmp);
        Self { sorted }
    }

    /// The value at or below which a share `p` of all lies, by nearest rank: always the value of one run. NaN when
    /// empty.
    pub fn percentile(&self, p: f64) -> f64 {
        let last = self.sorted.len().saturating_sub(1) as f64;
        self.sorted.get(libm::round(p.clamp(0.0, 1.0) * last) as usize).copied().unwrap_or(f64::NAN)
    }

    /// How many values there are.
    pub fn len(&self) -> usize {
        self.sorted.len()
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.sorted.is_empty()
    }

    /// The least.
    pub fn min(&self) -> f64 {
        self.percentile(0.0)
    }

    /// The middle.
    pub fn median(&self) -> f64 {
        self.percentile(0.5)
    }

    /// The greatest.
    pub fn max(&self) -> f64 {
        self.percentile(1.0)
    }

    /// The mean.
    pub fn mean(&self) -> f64 {
        self.sorted.iter().sum::<f64>() / self.sorted.len() as f64
    }

    /// The share of runs at or below `value`.
    pub fn share_below(&self, value: f64) -> f64 {
        self.sorted.iter().filter(|v| **v <= value).count() as f64 / self.sorted.len() as f64
    }
}

/// Each seed's answer, computed on as many threads as the machine offers, in the order of the seeds: nothing depends on
/// how many threads there are.
///
/// # Errors
/// The first error of any seed.
pub fn over_seeds<T: Send>(seeds: u32, run: impl Fn(u32) -> Result<T, Error> + Sync) -> Result<Vec<T>, Error> {
    let threads = std::thread::available_parallelism().map_or(1, |n| n.get() as u32).min(seeds.max(1));
    let start = |t: u32| (u64::from(t) * u64::from(seeds) / u64::from(threads)) as u32;
    let share = |t: u32| start(t)..start(t + 1);
    let parts: Vec<Result<Vec<T>, Error>> = std::thread::scope(|scope| {
        let run = &run;
        let workers: Vec<_> =
            (0..threads).map(|t| scope.spawn(move || share(t).map(run).collect::<Result<Vec<T>, Error>>())).collect();
        // A worker that panicked has broken a promise of the core; it is let through as it is.
        workers.into_iter().map(|w| w.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic))).collect()
    });
    parts.into_iter().collect::<Result<Vec<Vec<T>>, Error>>().map(|parts| parts.into_iter().flatten().collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_percentile_is_the_value_of_one_run() {
        let spread = Distribution::new((0..101).rev().map(f64::from));
        assert_eq!((spread.min(), spread.percentile(0.05), spread.median(), spread.max()), (0.0, 5.0, 50.0, 100.0));
        assert_eq!((spread.mean(), spread.share_below(9.5)), (50.0, 10.0 / 101.0));
        assert!(Distribution::new([]).median().is_nan());
    }

    #[test]
    fn the_seeds_keep_their_order_and_errors_come_through() {
        assert_eq!(over_seeds(7, Ok).expect("no error"), [0, 1, 2, 3, 4, 5, 6]);
        let refused = over_seeds(7, |s| if s == 5 { Err(Error::new(estimate::Code::Limit, "s", "")) } else { Ok(s) });
        assert!(refused.is_err());
    }
}
