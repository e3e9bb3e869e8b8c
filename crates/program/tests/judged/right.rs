//! Right filters in forms of their own.

use program::{Notation, World};

use Notation::{Choset, Common, Thrun};
use World::{Linear, Robot};

pub const RIGHT: [(&str, World, Notation, &str); 22] = [
    (
        "the chapter's seven lines",
        Linear,
        Choset,
        "x = F x + G u\nP = F P Fᵀ + V\nν = y − H x\nS = H P Hᵀ + W\nR = P Hᵀ S⁻¹\nx = x + R ν\nP = P − R H P",
    ),
    (
        "the same with marks on the names",
        Linear,
        Choset,
        "x̂⁻ = F x̂ + G u\nP⁻ = F P Fᵀ + V\nν = y − H x̂⁻\nS = H P⁻ Hᵀ + W\nR = P⁻ Hᵀ S⁻¹\nx̂ = x̂⁻ + R ν\n\
         P = P⁻ − R H P⁻",
    ),
    (
        "Joseph's form",
        Linear,
        Choset,
        "x = F x + G u\nP = F P F' + V\nS = H P H' + W\nR = P H' / S\nx = x + R (y - H x)\nA = I - R H\n\
         P = A P A' + R W R'",
    ),
    (
        "Joseph's form, symmetric",
        Linear,
        Choset,
        "x = F x + G u\nP = F P F' + V\nR = P H' / (H P H' + W)\nx = x + R (y - H x)\n\
         P = sym((I - R H) P (I - R H)' + R W R')",
    ),
    (
        "the information form",
        Linear,
        Choset,
        "x = F x + G u\nP = F P F' + V\nL = inv(P) + H' inv(W) H\nq = P \\ x + H' (W \\ y)\nP = inv(L)\nx = P q",
    ),
    (
        "the gain of the information form",
        Linear,
        Choset,
        "x = F x + G u\nM = F P F' + V\nP = inv(inv(M) + H' (W \\ H))\nR = P H' W⁻¹\nx = x + R (y - H x)",
    ),
    (
        "two readings, one after the other",
        Linear,
        Choset,
        "x = F x + G u\nP = F P F' + V\na = H[1, :]\nk = P a' / (a P a' + W[1, 1])\nx = x + k (y[1] - a x)\n\
         P = P - k a P\n\
         b = H[2, :]\nk = P b' / (b P b' + W[2, 2])\nx = x + k (y[2] - b x)\nP = P - k b P\nw = eye(2) y",
    ),
    (
        "a square root by chol",
        Linear,
        Choset,
        "x = F x + G u\nL = chol(F P F' + V)\nB = H L\nS = B B' + W\nK = L B' / S\nx = x + K (y - H x)\n\
         C = chol(I - B' (S \\ B))\nP = (L C) (L C)'",
    ),
    (
        "a solve in the place of an inverse",
        Linear,
        Choset,
        "x = F x + G u\nP = F P F' + V\nS = H P H' + W\nT = S \\ (H P)\nx = x + T' (y - H x)\nP = P - (H P)' T",
    ),
    (
        "the gain of a stacked least squares",
        Linear,
        Choset,
        "m0 = F x + G u\nM = F P F' + V\nA = [eye(n); H]\nB = [M, zeros(n, p); zeros(p, n), W]\n\
         P = inv(A' (B \\ A))\n\
         x = P A' (B \\ [m0; y])",
    ),
    (
        "the joint covariance of state and reading",
        Linear,
        Choset,
        "x = F x + G u\nP = F P F' + V\nJ = [P, P H'; H P, H P H' + W]\nC = P H'\nK = C / (H C + W)\n\
         x = x + K y - K H x\nP = J[1:n, 1:n] - K C'",
    ),
    (
        "in two lines",
        Linear,
        Choset,
        "x = F x + G u + (F P F' + V) H' / (H (F P F' + V) H' + W) (y - H (F x + G u))\n\
         P = inv(inv(F P F' + V) + H' / W H)",
    ),
    (
        "Thrun's letters",
        Linear,
        Thrun,
        "μ = A μ + B u\nΣ = A Σ Aᵀ + R\nK = Σ Cᵀ (C Σ Cᵀ + Q)⁻¹\nμ = μ + K (z − C μ)\nΣ = (I − K C) Σ",
    ),
    (
        "filterpy's letters in numpy",
        Linear,
        Common,
        "x = F @ x + B @ u\nP = F @ P @ F.T + Q\ny = z - H @ x\nPHT = P @ H.T\nS = H @ PHT + R\n\
         SI = np.linalg.inv(S)\n\
         K = PHT @ SI\nx = x + K @ y\nI_KH = np.eye(n) - K @ H\nP = I_KH @ P @ I_KH.T + K @ R @ K.T",
    ),
    (
        "MATLAB",
        Linear,
        Common,
        "x = F*x + B*u;\nP = F*P*F' + Q;\nK = P*H'/(H*P*H' + R);   % the gain\nx = x + K*(z - H*x);\n\
         P = (eye(size(P, 1)) - K*H)*P;",
    ),
    (
        "Julia",
        Linear,
        Common,
        "x = F * x + B * u\nP = Symmetric(F * P * F' + Q)\nK = P * H' / Symmetric(H * P * H' + R)\n\
         x += K * (z - H * x)\n\
         P = Symmetric((I - K * H) * P)",
    ),
    (
        "the gain as an observer's",
        Linear,
        Choset,
        "M = F P F' + V\nK = M H' / (H M H' + W)\nx = (I - K H) (F x + G u) + K y\nP = M - K (H M H' + W) K'",
    ),
    (
        "the robot, with jac",
        Robot,
        Choset,
        "F = jac(f, x)\nx = f(x, u)\nP = F P F' + V\nH = jac(h, x)\nnu = y - h(x, l)\nnu[2] = wrap(nu[2])\n\
         S = H P H' + W\n\
         R = P H' / S\nx = x + R nu\nx[3] = wrap(x[3])\nP = P - R H P",
    ),
    (
        "the robot, derivatives by hand",
        Robot,
        Choset,
        "c = cos(x[3])\ns = sin(x[3])\nF = [1, 0, -u[1] s; 0, 1, u[1] c; 0, 0, 1]\nx = x + [u[1] c; u[1] s; u[2]]\n\
         P = F P F' + V\nd = x[1:2] - l\nr = norm(d)\nH = [d[1]/r, d[2]/r, 0; -d[2]/r^2, d[1]/r^2, -1]\n\
         nu = [y[1] - r; wrap(y[2] - atan2(d[2], d[1]) + x[3])]\nK = P H' inv(H P H' + W)\nx = x + K nu\n\
         x = [x[1]; x[2]; wrap(x[3])]\nP = (I - K H) P (I - K H)' + K W K'",
    ),
    (
        "the robot's readings one by one, at one linearization",
        Robot,
        Choset,
        "F = jac(f, x)\nm0 = f(x, u)\nP = F P F' + V\nH = jac(h(m0, l), m0)\ne = y - h(m0, l)\n\
         e[2] = wrap(e[2])\nx = m0\n\
         a = H[1, :]\nk = P a' / (a P a' + W[1, 1])\nx = x + k (e[1] - a (x - m0))\nP = P - k a P\na = H[2, :]\n\
         k = P a' / (a P a' + W[2, 2])\nx = x + k (e[2] - a (x - m0))\nP = P - k a P\nx[3] = wrap(x[3])",
    ),
    (
        "the robot in Thrun's letters",
        Robot,
        Thrun,
        "A = jac(f, mu)\nmu = f(mu, u)\nSigma = A Sigma A' + R\nC = jac(h, mu)\nd = z - h(mu, l)\n\
         d = [d[1]; wrap(d[2])]\n\
         K = Sigma C' / (C Sigma C' + Q)\nmu = mu + K d\nmu[3] = wrap(mu[3])\nSigma = sym((I - K C) Sigma)",
    ),
    (
        "the robot by information",
        Robot,
        Choset,
        "F = jac(f, x)\nx = f(x, u)\nP = F P F' + V\nH = jac(h, x)\nnu = y - h(x, l)\nnu[2] = wrap(nu[2])\n\
         P = inv(inv(P) + H' inv(W) H)\nx = x + P H' inv(W) nu\nx[3] = wrap(x[3])",
    ),
];
