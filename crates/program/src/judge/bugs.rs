//! The museum's bugs that are formulas, as programs: the right filter with a line changed.

use crate::World;
use alloc::string::String;
use alloc::vec::Vec;

/// A bug of the museum that is a formula.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Bug {
    /// The innovation of a bearing is not wrapped.
    UnwrappedInnovation,
    /// The heading is not wrapped.
    UnwrappedHeading,
    /// The derivative of a bearing by the heading is taken for −1/ρ².
    WrongDerivative,
    /// FᵀPF for FPFᵀ.
    Transposed,
    /// The bearing's standard deviation is in degrees.
    Degrees,
    /// W holds standard deviations.
    Deviation,
    /// V is that of a step sixteen times as long.
    StepLength,
    /// The gain is scaled by hand, and the short form used with it.
    ShortForm,
    /// P is not made symmetric.
    Asymmetric,
    /// The reading is used twice.
    Twice,
}

/// Those that a linear world can have come last; [`Bug::Asymmetric`] is seen in the digits of a right answer.
const ALL: [Bug; 9] = [
    Bug::UnwrappedInnovation,
    Bug::UnwrappedHeading,
    Bug::WrongDerivative,
    Bug::Degrees,
    Bug::Transposed,
    Bug::Deviation,
    Bug::StepLength,
    Bug::ShortForm,
    Bug::Twice,
];

impl Bug {
    /// Those of a world.
    pub fn of(world: World) -> &'static [Self] {
        if world == World::Robot { &ALL } else { &ALL[4..] }
    }

    /// The museum's word for it.
    pub fn word(self) -> &'static str {
        match self {
            Self::UnwrappedInnovation => "unwrapped-innovation",
            Self::UnwrappedHeading => "unwrapped-heading",
            Self::WrongDerivative => "wrong-derivative",
            Self::Transposed => "transposed",
            Self::Degrees => "degrees",
            Self::Deviation => "deviation",
            Self::StepLength => "step-length",
            Self::ShortForm => "short-form",
            Self::Asymmetric => "asymmetric",
            Self::Twice => "twice",
        }
    }

    pub(super) fn sentence(self) -> &'static str {
        match self {
            Self::UnwrappedInnovation => "the innovation of the bearing is not wrapped: near ±π it is off by a turn.",
            Self::UnwrappedHeading => {
                "the heading is not wrapped: it leaves (−π, π], and where the motion does not wrap it either, it grows \
                 from lap to lap."
            }
            Self::WrongDerivative => "the bearing’s derivative by the heading is −1, and here it is −1/ρ².",
            Self::Transposed => "this computes FᵀPF, and the prediction is FPFᵀ: the transpose goes on the right.",
            Self::Degrees => "the bearing’s σ is in degrees here, and the filter computes in radians.",
            Self::Deviation => "standard deviations stand where the reading’s variances belong: σ for σ².",
            Self::StepLength => "the motion’s noise is that of a step sixteen times as long.",
            Self::ShortForm => {
                "the gain is 1.3 times the optimal one, and the short form, which holds for the optimal gain alone, is \
                 used with it."
            }
            Self::Asymmetric => "P is not symmetric in its last digits.",
            Self::Twice => "the reading is used twice.",
        }
    }
}

/// The right filter's lines; the robot's own begin with a `r`, a linear world's with an `l`.
const RIGHT: [&str; 13] = [
    "rF = jac(f, x)",
    "lxm = F x + G u",
    "rxm = f(x, u)",
    " Pm = F P F' + V",
    "rH = jac(h(xm, l), xm)",
    "lnu = y - H xm",
    "rnu = y - h(xm, l)",
    "rnu[2] = wrap(nu[2])",
    " S = H Pm H' + W",
    " R = (S \\ (H Pm))'",
    " x = xm + R nu",
    "rx[3] = wrap(x[3])",
    " P = sym((I - R H) Pm (I - R H)' + R W R')",
];

/// What stands in the place of a line, or before it where it begins with +. A bug that people write in several ways has
/// several lists.
type Change = (usize, &'static str);

fn changes(bug: Bug) -> &'static [&'static [Change]] {
    match bug {
        Bug::UnwrappedInnovation => &[&[(7, "")]],
        Bug::UnwrappedHeading => {
            &[&[(11, "")], &[(2, "xm = [x[1] + u[1] cos(x[3]); x[2] + u[1] sin(x[3]); x[3] + u[2]]"), (11, "")]]
        }
        Bug::WrongDerivative => &[&[(5, "+H[2, 3] = -1 / h(xm, l)[1]^2")]],
        Bug::Transposed => &[&[(3, "Pm = F' P F + V")]],
        Bug::Degrees => {
            &[&[(3, "+W[2, 2] = W[2, 2] (180 / pi)^2")], &[(8, "S = H Pm H' + [W[1, 1], 0; 0, W[2, 2] (180 / pi)^2]")]]
        }
        Bug::Deviation => &[&[(3, "+W = diag(sqrt(diag(W)))")], &[(8, "S = H Pm H' + diag(sqrt(diag(W)))")]],
        Bug::StepLength => &[&[(3, "Pm = F P F' + 16 V")]],
        Bug::ShortForm => {
            &[&[(10, "+R = 1.3 R"), (12, "P = sym(Pm - R H Pm)")], &[(10, "+R = 1.3 R"), (12, "P = Pm - R H Pm")]]
        }
        Bug::Asymmetric => &[],
        Bug::Twice => &[&[(12, "P = (I - R H) Pm\n@")]],
    }
}

/// The second use of a reading, in each world.
const AGAIN: [&str; 2] = [
    "S2 = H P H' + W\nR2 = (S2 \\ (H P))'\nx = x + R2 (y - H x)\nP = sym((I - R2 H) P)\n",
    "H2 = jac(h, x)\nn2 = y - h(x, l)\nn2[2] = wrap(n2[2])\nS2 = H2 P H2' + W\nR2 = (S2 \\ (H2 P))'\nx = x + R2 n2\n\
     x[3] = wrap(x[3])\nP = sym((I - R2 H2) P)\n",
];

/// The right filter with these changes.
pub(super) fn text(world: World, changes: Option<&[Change]>) -> String {
    let mut text = String::new();
    for (i, line) in RIGHT.iter().enumerate() {
        let (whose, mut line) = line.split_at_checked(1).unwrap_or_default();
        for (at, by) in changes.unwrap_or_default() {
            if *at == i {
                match by.strip_prefix('+') {
                    Some(before) => {
                        text.push_str(before);
                        text.push('\n');
                    }
                    None => line = by,
                }
            }
        }
        let left_out = if world == World::Robot { "l" } else { "r" };
        if whose == left_out || line.is_empty() {
            continue;
        }
        match line.strip_suffix('@') {
            Some(line) => {
                text.push_str(line);
                text.push_str(AGAIN[usize::from(world == World::Robot)]);
            }
            None => {
                text.push_str(line);
                text.push('\n');
            }
        }
    }
    text
}

/// The programs of a bug.
pub(super) fn texts(world: World, bug: Bug) -> Vec<String> {
    changes(bug).iter().map(|changes| text(world, Some(changes))).collect()
}
