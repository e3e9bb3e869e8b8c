//! The programs that a reader's may begin as: the chapter's, those of the museum's bugs that are formulas, and those of
//! the exercises. All are in Choset's letters.

use super::params::FilterWorld;
use lab::words;

words! {
    /// The program that a text begins as.
    pub enum Begin {
        /// The chapter's algorithm.
        Kalman = "kalman",
        /// An empty box.
        Empty = "empty",
        /// The algorithm in Joseph's form.
        Joseph = "joseph",
        /// In the short form.
        Short = "short",
        /// An observer with a gain of one's own.
        Observer = "observer",
        /// Without W.
        Forget = "forget",
        /// The robot's extended filter.
        Ekf = "ekf",
        /// The innovation of a bearing is not wrapped.
        UnwrappedInnovation = "unwrapped-innovation",
        /// The heading is not wrapped.
        UnwrappedHeading = "unwrapped-heading",
        /// The bearing's derivative by the heading is −1/ρ².
        WrongDerivative = "wrong-derivative",
        /// FᵀPF for FPFᵀ.
        Transposed = "transposed",
        /// The bearing's σ is in degrees.
        Degrees = "degrees",
        /// σ for σ².
        Deviation = "deviation",
        /// V of a step sixteen times as long.
        StepLength = "step-length",
        /// The short form with a gain scaled by hand.
        ShortForm = "short-form",
        /// P is not made symmetric.
        Asymmetric = "asymmetric",
        /// A reading is used twice.
        Twice = "twice",
        /// Exercise: fill in the update.
        Fill = "fill",
        /// Exercise: a form that does not break.
        Change = "change",
        /// Exercise: a fixed gain under which the error dies out, and its covariance.
        Fixed = "fixed",
        /// Exercise: no gain.
        Information = "information",
        /// Exercise: mend it.
        MendFirst = "mend-1",
        /// Exercise: mend it.
        MendSecond = "mend-2",
        /// Exercise: mend it.
        MendThird = "mend-3",
        /// Exercise: the extended filter from f and h alone.
        Extend = "extend",
        /// Exercise: two readings in turn.
        Sequential = "sequential",
    }
}

/// The steps before the last of the chapter's algorithm.
macro_rules! kalman {
    ($last:literal) => {
        concat!("x = F x + G u\nP = F P F' + V\nnu = y - H x\nS = H P H' + W\nR = P H' inv(S)\nx = x + R nu\n", $last)
    };
}

/// The robot's filter.
const EKF: &str = "F = jac(f, x)\nx = f(x, u)\nP = F P F' + V\nH = jac(h, x)\nnu = y - h(x, l)\nnu[2] = wrap(nu[2])\n\
                   S = H P H' + W\nR = P H' inv(S)\nx = x + R nu\nx[3] = wrap(x[3])\nP = sym(P - R H P)";

impl Begin {
    /// Its world.
    pub fn world(self) -> FilterWorld {
        use Begin::*;
        match self {
            Kalman | Empty | Joseph | Short | Observer | Forget | Fill | Change | Fixed | Information | MendFirst
            | MendSecond | Sequential => FilterWorld::Linear,
            _ => FilterWorld::Robot,
        }
    }

    /// Its text.
    pub fn text(self) -> String {
        let Some((right, wrong)) = self.change() else { return self.whole().into() };
        // By hand: a search in a string would be the figure's only one, and a kilobyte of its module.
        let (mut text, mut rest) = (String::new(), EKF.chars());
        loop {
            if let Some(behind) = rest.as_str().strip_prefix(right) {
                text.push_str(wrong);
                rest = behind.chars();
            } else if let Some(c) = rest.next() {
                text.push(c);
            } else {
                return text;
            }
        }
    }

    /// What a bug of the museum has in the place of a part of the robot's filter.
    fn change(self) -> Option<(&'static str, &'static str)> {
        Some(match self {
            Self::UnwrappedInnovation => ("nu[2] = wrap(nu[2])\n", ""),
            Self::WrongDerivative => ("nu = y", "H[2, 3] = -1 / norm(x[1:2] - l)^2\nnu = y"),
            Self::Transposed => ("F P F' + V", "F' P F + V"),
            Self::Degrees => ("S = H", "W[2, 2] = (180 / pi)^2 W[2, 2]\nS = H"),
            Self::Deviation => ("+ W", "+ chol(W)"),
            Self::StepLength => ("+ V", "+ 16 V"),
            Self::ShortForm => ("R = P", "R = 1.3 P"),
            Self::Asymmetric => ("sym(P - R H P)", "P - R H P"),
            Self::Twice => {
                let again = "P = sym(P - R H P)\nH = jac(h, x)\nnu = y - h(x, l)\nnu[2] = wrap(nu[2])\n\
                             S = H P H' + W\nR = P H' inv(S)\nx = x + R nu\nx[3] = wrap(x[3])\nP = sym(P - R H P)";
                ("P = sym(P - R H P)", again)
            }
            // H at the pose before the motion.
            Self::MendThird => {
                ("x = f(x, u)\nP = F P F' + V\nH = jac(h, x)", "H = jac(h, x)\nx = f(x, u)\nP = F P F' + V")
            }
            _ => return None,
        })
    }

    fn whole(self) -> &'static str {
        match self {
            Self::Empty => "",
            Self::Kalman | Self::Change => kalman!("P = P - R H P"),
            Self::Joseph => kalman!("P = (I - R H) P (I - R H)' + R W R'"),
            Self::Short => kalman!("P = (I - R H) P"),
            Self::Observer => {
                "x = F x + G u\nP = F P F' + V\nK = [0.5; 0.3]  # yours\nx = x + K (y - H x)\n\
                 P = (I - K H) P (I - K H)' + K W K'"
            }
            Self::Forget => {
                "x = F x + G u\nP = F P F' + V\nnu = y - H x\nS = H P H'  # without W\nR = P H' inv(S)\nx = x + R nu\n\
                 P = P - R H P"
            }
            Self::Fill => {
                "x = F x + G u\nP = F P F' + V\n# four lines are missing:\n# nu, S, R and the new x\nP = P - R H P"
            }
            Self::Fixed => {
                "x = F x + G u\nP = F P F' + V\nK = [0; 0]  # choose\nx = x + K (y - H x)\n# and P after the reading"
            }
            Self::Information => {
                "x = F x + G u\nP = F P F' + V\n# the inverse of P grows by H' inv(W) H;\n# no gain is needed"
            }
            Self::MendFirst => {
                "nu = y - H x\nx = F x + G u\nP = F P F' + V\nS = H P H' + W\nR = P H' inv(S)\nx = x + R nu\n\
                 P = P - R H P"
            }
            // As in the museum: no line wraps the heading, and the innovation is taken back by one turn at most.
            Self::UnwrappedHeading => {
                "F = jac(f, x)\nx = [f(x, u)[1:2]; x[3] + u[2]]\nP = F P F' + V\nH = jac(h, x)\nnu = y - h(x, l)\n\
                 nu[2] = nu[2] + x[3] - wrap(x[3])\nt = (nu[2] - wrap(nu[2])) / (2 pi) # turns\n\
                 t = (abs(t + 1) - abs(t - 1)) / 2 # one\nnu[2] = nu[2] - 2 pi t\nS = H P H' + W\n\
                 R = P H' inv(S)\nx = x + R nu\nP = sym(P - R H P)"
            }
            Self::MendSecond => kalman!("P = (I - R H) P (I - R H)'"),
            Self::Extend => {
                "# f(x, u) moves the robot,\n# h(x, l) is what it reads of l;\n# jac(f, x) is the derivative"
            }
            Self::Sequential => {
                "two = eye(2) y  # of independent noises\nx = F x + G u\nP = F P F' + V\n\
                 # first y[1] with H[1, :] and W[1, 1],\n# then the other: nothing is inverted"
            }
            _ => EKF,
        }
    }
}
