//! What a reader sets who writes a filter.

use super::programs::Begin;
use lab::{Written, params, words};
use program::{Notation, World};

/// The longest program of a reader's own, in bytes: a link carries it.
pub const MOST_BYTES: usize = 2000;

words! {
    /// Whose letters a program is in.
    pub enum Letters {
        /// R is the gain, V and W are the noise.
        Choset = "choset",
        /// K is the gain, R and Q are the noise.
        Thrun = "thrun",
        /// K is the gain, Q and R are the noise.
        Common = "common",
    }
}

impl From<Letters> for Notation {
    fn from(letters: Letters) -> Self {
        [Self::Choset, Self::Thrun, Self::Common][letters as usize]
    }
}

words! {
    /// The world that a filter is for.
    pub enum FilterWorld {
        /// The rail robot with its position sensor.
        Linear = "linear",
        /// The museum's stadium, where a robot sights landmarks.
        Robot = "robot",
    }
}

impl From<FilterWorld> for World {
    fn from(world: FilterWorld) -> Self {
        [Self::Linear, Self::Robot][world as usize]
    }
}

params! {
    /// A program, its letters, and the seed of the world that it runs in.
    pub struct WriteParams {
        /// The program that the text begins as; it says which world the filter is for.
        pub begin: Begin = (Begin::Kalman);
        /// The reader's own text, of at most 2000 bytes; null where the program is as it began.
        pub text: Option<Written<MOST_BYTES>> = None;
        /// Whose letters the text is in.
        pub notation: Letters = (Letters::Choset);
        /// Fixes all noise.
        pub seed: u32 = 1;
    }
}
