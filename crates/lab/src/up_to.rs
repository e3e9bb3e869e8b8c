//! A list that holds at most so many entries, of which the last ones are left out where they are empty.

use crate::parameter::Knob;
use crate::shape::{Plain, Shape, put};
use std::array::from_fn;
use std::ops::{Deref, DerefMut};
use std::slice::Iter;

/// `MOST` entries. Outside it is a list of at least `LEAST`: what it lacks is empty, and what is empty at its end is
/// not written. So a state that was kept when there were fewer entries is read, and written, as it was.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct UpTo<T, const LEAST: usize, const MOST: usize>([T; MOST]);

impl<T: Default, const LEAST: usize, const MOST: usize> Default for UpTo<T, LEAST, MOST> {
    fn default() -> Self {
        Self(from_fn(|_| T::default()))
    }
}

impl<T, const LEAST: usize, const MOST: usize> Deref for UpTo<T, LEAST, MOST> {
    type Target = [T; MOST];

    fn deref(&self) -> &[T; MOST] {
        &self.0
    }
}

impl<T, const LEAST: usize, const MOST: usize> DerefMut for UpTo<T, LEAST, MOST> {
    fn deref_mut(&mut self) -> &mut [T; MOST] {
        &mut self.0
    }
}

/// The first entries; of more than `MOST` the rest is left out.
impl<T: Default, const LEAST: usize, const MOST: usize, const N: usize> From<[T; N]> for UpTo<T, LEAST, MOST> {
    fn from(entries: [T; N]) -> Self {
        let mut to = Self::default();
        to.iter_mut().zip(entries).for_each(|(place, entry)| *place = entry);
        to
    }
}

impl<T: Plain + Default + PartialEq, const LEAST: usize, const MOST: usize> Plain for UpTo<T, LEAST, MOST> {
    const SHAPE: Shape = Shape::Between(LEAST, MOST, &T::SHAPE);

    fn write(&self, to: &mut Vec<f64>) {
        let empty = T::default();
        let length = self.0.iter().rposition(|entry| *entry != empty).map_or(0, |last| last + 1).max(LEAST);
        put(to, length as f64);
        self.0[..length].iter().for_each(|entry| entry.write(to));
    }
}

impl<T: Knob + Default + PartialEq, const LEAST: usize, const MOST: usize> Knob for UpTo<T, LEAST, MOST> {
    const LIMITS: [f64; 3] = T::LIMITS;

    fn read(from: &mut Iter<'_, f64>) -> Self {
        let length = from.next().map_or(0, |length| *length as usize);
        let mut to = Self::default();
        to.iter_mut().take(length).for_each(|place| *place = T::read(from));
        to
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    type Row = UpTo<f64, 2, 5>;

    fn written(row: Row) -> Vec<f64> {
        let mut numbers = Vec::new();
        row.write(&mut numbers);
        numbers
    }

    #[test]
    fn what_is_empty_at_the_end_is_not_written_and_comes_back() {
        for (row, numbers) in [
            (Row::default(), vec![2.0, 0.0, 0.0]),
            (Row::from([7.0]), vec![2.0, 7.0, 0.0]),
            (Row::from([0.0, 0.0, 3.0, 0.0]), vec![3.0, 0.0, 0.0, 3.0]),
            (Row::from([1.0; 9]), vec![5.0, 1.0, 1.0, 1.0, 1.0, 1.0]),
        ] {
            assert_eq!(written(row), numbers);
            assert_eq!(Row::read(&mut numbers.iter()), row);
        }
    }
}
