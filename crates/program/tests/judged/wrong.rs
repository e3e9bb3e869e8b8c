//! Wrong filters, none of them in the museum, and what is said of each.

use program::{Notation, World};

use Notation::{Choset, Common, Thrun};
use World::{Linear, Robot};

pub const WRONG: [(&str, World, Notation, &str, &str); 22] = [
    (
        "P is not predicted",
        Linear,
        Choset,
        "x = F x + G u\nS = H P H' + W\nR = P H' / S\nx = x + R (y - H x)\nP = P - R H P",
        "In line 2, ",
    ),
    (
        "V is forgotten",
        Linear,
        Choset,
        "x = F x + G u\nP = F P F'\nS = H P H' + W\nR = P H' / S\nx = x + R (y - H x)\nP = P - R H P",
        "In line 3, ",
    ),
    (
        "W is forgotten in S",
        Linear,
        Choset,
        "x = F x + G u\nP = F P F' + V\nnu = y - H x\nS = H P H' + 0 W + 1e-9 I\nR = P H' / S\nx = x + R nu\n\
         P = P - R H P",
        "nu is right. In line 4, ",
    ),
    (
        "W is twice as large",
        Linear,
        Choset,
        "x = F x + G u\nP = F P F' + V\nS = H P H' + 2 W\nR = P H' / S\nx = x + R (y - H x)\nP = P - R H P",
        "In line 3, ",
    ),
    (
        "the innovation has the other sign",
        Linear,
        Choset,
        "x = F x + G u\nP = F P F' + V\nnu = H x - y\nS = H P H' + W\nR = P H' / S\nx = x + R nu\nP = P - R H P",
        "In line 3, ",
    ),
    (
        "the correction is subtracted",
        Linear,
        Choset,
        "x = F x + G u\nP = F P F' + V\nnu = y - H x\nS = H P H' + W\nR = P H' / S\nx = x - R nu\nP = P - R H P",
        "nu, S and R are right",
    ),
    (
        "the innovation of the old estimate",
        Linear,
        Choset,
        "nu = y - H x\nx = F x + G u\nP = F P F' + V\nS = H P H' + W\nR = P H' / S\nx = x + R nu\nP = P - R H P",
        "In line 1, ",
    ),
    (
        "the gain of the old covariance",
        Linear,
        Choset,
        "S = H P H' + W\nR = P H' / S\nx = F x + G u\nP = F P F' + V\nx = x + R (y - H x)\nP = P - R H P",
        "In line 1, ",
    ),
    (
        "the input is forgotten",
        Linear,
        Choset,
        "x = F x\nP = F P F' + V\nnu = y - H x\nS = H P H' + W\nR = P H' / S\nx = x + R nu\nP = P - R H P",
        "In line 3, ",
    ),
    (
        "the covariance grows by the update",
        Linear,
        Choset,
        "x = F x + G u\nP = F P F' + V\nS = H P H' + W\nR = P H' / S\nx = x + R (y - H x)\nP = P + R H P",
        "x is right in all cases",
    ),
    (
        "the covariance keeps its prediction",
        Linear,
        Choset,
        "x = F x + G u\nP = F P F' + V\nS = H P H' + W\nR = P H' / S\nx = x + R (y - H x)\nP = P",
        "x is right in all cases",
    ),
    (
        "Joseph's form without its second part",
        Linear,
        Choset,
        "x = F x + G u\nP = F P F' + V\nS = H P H' + W\nR = P H' / S\nx = x + R (y - H x)\n\
         P = (I - R H) P (I - R H)'",
        "x is right in all cases",
    ),
    (
        "half of the gain",
        Linear,
        Choset,
        "x = F x + G u\nP = F P F' + V\nS = H P H' + W\nR = 0.5 P H' / S\nx = x + R (y - H x)\nP = P - R H P",
        "S is right. In line 4, ",
    ),
    (
        "F on the wrong side, of a power",
        Linear,
        Choset,
        "x = F x + G u\nP = F F P F' F' + V\nS = H P H' + W\nR = P H' / S\nx = x + R (y - H x)\nP = P - R H P",
        "In line 3, ",
    ),
    (
        "the covariances are exchanged in their roles",
        Linear,
        Choset,
        "x = F x + G u\nP = F P F' + H' W H\nS = H P H' + H V H'\nR = P H' / S\nx = x + R (y - H x)\nP = P - R H P",
        "In line 3, ",
    ),
    (
        "only the diagonal of P is kept",
        Linear,
        Common,
        "x = F x + B u\nP = F P F' + Q\nK = P H' / (H P H' + R)\nx = x + K (z - H x)\nP = diag(diag(P - K H P))",
        "x is right in all cases",
    ),
    (
        "the prediction of the mean is left out",
        Linear,
        Thrun,
        "Σ = A Σ A' + R\nK = Σ C' / (C Σ C' + Q)\nμ = μ + K (z - C μ)\nΣ = Σ - K C Σ",
        "Sigma is right in all cases",
    ),
    (
        "only the first reading is used",
        Linear,
        Choset,
        "x = F x + G u\nP = F P F' + V\na = H[1, :]\nk = P a' / (a P a' + W[1, 1])\nx = x + k (y[1] - a x)\n\
         P = P - k a P\nw = eye(2) y",
        "and a right filter has",
    ),
    (
        "an observer with a fixed gain",
        Linear,
        Choset,
        "x = F x + G u\nP = F P F' + V\nK = 0.3 H'\nx = x + K (y - H x)\nP = (I - K H) P (I - K H)' + K W K'",
        "and a right filter has",
    ),
    (
        "H of the old pose",
        Robot,
        Choset,
        "F = jac(f, x)\nH = jac(h, x)\nx = f(x, u)\nP = F P F' + V\nnu = y - h(x, l)\nnu[2] = wrap(nu[2])\n\
         S = H P H' + W\nR = P H' / S\nx = x + R nu\nx[3] = wrap(x[3])\nP = P - R H P",
        "nu is right. In line 7, ",
    ),
    (
        "F of the new pose",
        Robot,
        Choset,
        "x = f(x, u)\nF = jac(f, x)\nP = F P F' + V\nH = jac(h, x)\nnu = y - h(x, l)\nnu[2] = wrap(nu[2])\n\
         S = H P H' + W\nR = P H' / S\nx = x + R nu\nx[3] = wrap(x[3])\nP = P - R H P",
        "nu is right. In line 7, ",
    ),
    (
        "the bearing from the robot",
        Robot,
        Choset,
        "F = jac(f, x)\nx = f(x, u)\nP = F P F' + V\nd = l - x[1:2]\nr = norm(d)\nH = jac(h, x)\n\
         nu = [y[1] - r; wrap(y[2] - atan2(d[2], d[1]) + x[3])]\nS = H P H' + W\nR = P H' / S\nx = x + R nu\n\
         x[3] = wrap(x[3])\nP = P - R H P",
        "In line 7, ",
    ),
];
