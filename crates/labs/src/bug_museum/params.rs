//! What a visitor of the museum can change.

use lab::{Plain, Shape, params, words};

words! {
    /// A bug that real code has had.
    pub enum Bug {
        /// None: the filter is right.
        None = "none",
        /// The innovation of a bearing is not wrapped: near ±π it is off by a turn.
        UnwrappedInnovation = "unwrapped-innovation",
        /// The heading of the mean is not wrapped, and the innovation is by one turn at most.
        UnwrappedHeading = "unwrapped-heading",
        /// The Jacobians are computed once: F at the first estimate, H of a landmark where it is first sighted.
        FrozenJacobian = "frozen-jacobian",
        /// The derivative of a bearing by the heading is taken for −1/ρ², where it is −1.
        WrongDerivative = "wrong-derivative",
        /// The covariance is predicted as FᵀPF + V instead of FPFᵀ + V.
        Transposed = "transposed",
        /// The bearing's standard deviation is given in degrees and taken for radians.
        Degrees = "degrees",
        /// W holds standard deviations where variances belong.
        Deviation = "deviation",
        /// V is that of a step sixteen times as long.
        StepLength = "step-length",
        /// The gain is scaled by hand, and the covariance updated by (I − RH)P, which holds for the optimal gain alone.
        ShortForm = "short-form",
        /// The covariance is updated by (I − RH)P and never made symmetric again.
        Asymmetric = "asymmetric",
        /// Each reading is used twice.
        Twice = "twice",
        /// The gate is so wide that it refuses nothing.
        OpenGate = "open-gate",
        /// A reading is used two steps late, as if it were new.
        Late = "late",
    }
}

impl Bug {
    /// All of them, without [`Bug::None`].
    pub const ALL: [Self; 13] = [
        Self::UnwrappedInnovation,
        Self::UnwrappedHeading,
        Self::FrozenJacobian,
        Self::WrongDerivative,
        Self::Transposed,
        Self::Degrees,
        Self::Deviation,
        Self::StepLength,
        Self::ShortForm,
        Self::Asymmetric,
        Self::Twice,
        Self::OpenGate,
        Self::Late,
    ];

    /// The word that stands for it outside.
    pub fn word(self) -> &'static str {
        match Self::SHAPE {
            Shape::Word(words) => words[self as usize],
            _ => "",
        }
    }
}

params! {
    /// What the reader can change. The drive and its readings follow from the seed alone.
    pub struct MuseumParams {
        /// The bug in the filter.
        pub bug: Bug = (Bug::None);
        /// Another one beside it.
        pub second: Bug = (Bug::None);
        /// Draws bugs by lot instead, and hides which: of thirteen numbers in a row from 1, 14, 27, … on, each draws
        /// another bug. 0 takes the two above.
        pub lot: u32 = 0;
        /// Whether the lot draws two bugs at once.
        pub pair: bool = false;
        /// What the reader says the hidden bug is.
        pub guess: Bug = (Bug::None);
        /// What the reader says the other one is, of two.
        pub second_guess: Bug = (Bug::None);
        /// Whether the reader has committed to these names: only then does the frame hold the answer.
        pub committed: bool = false;
        /// How many hidden bugs the reader has named in a row.
        pub named: u32 = 0;
        /// Whether a step is the whole run of the next seed, up to 500 of them, and not a step of one run. The panels
        /// then show the first.
        pub many: bool = false;
        /// Fixes all noise.
        pub seed: u32 = 1;
    }
}
