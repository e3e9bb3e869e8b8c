//! What the chapter on the Kalman filter says in numbers: what the prose prints comes from [`numbers`], what the
//! chapter checks from [`checks`], what it quotes over many seeds from [`ensembles`], and what was chosen from
//! [`givens`]. Another chapter would have such a crate of its own.

pub mod checks;
pub mod ensembles;
pub mod givens;
pub mod numbers;
