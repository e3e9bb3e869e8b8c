//! The hash of a run.

/// A hash of the bits of the numbers a run computes, in their order: for each, a multiplication by an odd constant and
/// a fold of the high half into the low one. Both can be undone, so that two runs that differ in one number never agree
/// at it. It works on whole words, because a replay hashes thousands of numbers between two pictures.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Digest(u64);

impl Default for Digest {
    fn default() -> Self {
        Self(0xcbf2_9ce4_8422_2325)
    }
}

impl Digest {
    /// 2⁶⁴ over the golden ratio.
    const FACTOR: u64 = 0x9e37_79b9_7f4a_7c15;

    /// Mixes the bits of every number into the hash.
    #[inline(never)]
    pub fn take(&mut self, numbers: &[f64]) {
        for number in numbers {
            let mixed = (self.0 ^ number.to_bits()).wrapping_mul(Self::FACTOR);
            self.0 = mixed ^ (mixed >> 32);
        }
    }

    /// The hash so far.
    pub fn value(self) -> u64 {
        self.0
    }
}
