//! What a reader of the late readings can change.

use lab::{params, words};

words! {
    /// What is done with a reading that comes after it was measured.
    pub enum Way {
        /// It is taken as a reading of the moment in which it comes.
        AsNew = "as-new",
        /// It is not used.
        Drop = "drop",
        /// It is put where it was measured, and what follows is replayed.
        GoBack = "go-back",
    }
}

words! {
    /// How the robot drives.
    pub enum Course {
        /// At one speed, but for noise.
        Steady = "steady",
        /// Its commanded speed is a cosine, so that it turns back twice.
        ToAndFro = "to-and-fro",
    }
}

impl Way {
    /// All ways, as they are listed.
    pub const ALL: [Self; 3] = [Self::AsNew, Self::Drop, Self::GoBack];
}

params! {
    /// What the reader can change. The drive and the noise of every reading follow from the seed and the course alone.
    pub struct LateParams {
        /// What is done with a reading that comes late.
        pub way: Way = (Way::AsNew);
        /// How long after it was measured a reading of the camera comes.
        pub delay: f64 = 0.6, from 0.0 to 2.0 by 0.05 in "s";
        /// Readings of the sonar a second; 0 for none.
        pub sonar_rate: f64 = 5.0, from 0.0 to 5.0 by 0.25 in "1/s";
        /// Readings of the laser a second; 0 for none.
        pub laser_rate: f64 = 0.5, from 0.0 to 5.0 by 0.25 in "1/s";
        /// Readings of the camera a second; 0 for none.
        pub camera_rate: f64 = 1.0, from 0.0 to 5.0 by 0.25 in "1/s";
        /// The times between which nothing is measured; none where there is no gap.
        pub gap: Option<[f64; 2]> = None, from 0.0 to 20.0 by 0.05 in "s";
        /// The reading of the camera that the reader has in hand, from 0 on.
        pub picked: u32 = 9, from 0.0 to 99.0 by 1.0;
        /// How long after it was measured that one comes; as all others where none is given.
        pub own_delay: Option<f64> = None, from 0.0 to 10.0 by 0.05 in "s";
        /// Whether that one is taken out of the run.
        pub removed: bool = false;
        /// How the robot drives.
        pub course: Course = (Course::Steady);
        /// Whether the best track afterwards is shown, of all readings at the times at which they were measured.
        pub smooth: bool = false;
        /// Fixes all noise.
        pub seed: u32 = 1;
    }
}
