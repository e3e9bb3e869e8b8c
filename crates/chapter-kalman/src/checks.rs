//! The chapter's checks: each computes through the public interface of the core what the text claims, beside what the
//! claim is.

pub(crate) mod jacobians;
pub(crate) mod maps;
pub(crate) mod observability;
pub(crate) mod problem9;
pub(crate) mod rail;

use crate::givens::Givens;
use estimate::{Code, Error};
use lab::Check;

/// What computes a check.
pub type CheckFn = fn(&Givens) -> Result<Check, Error>;

/// Every check, in order.
pub const CHECKS: &[CheckFn] = &[
    rail::first_step,
    rail::second_step,
    rail::ranks,
    rail::placed_eigenvalues,
    rail::error_ratio,
    rail::brute_force_gain,
    rail::riccati_limits,
    jacobians::agreement,
    observability::observability_ranks,
    observability::traces,
    maps::linear_slam_stalls,
    maps::range_bearing_slam,
    problem9::problem9,
];

/// Runs every check on the chapter's constants.
///
/// # Errors
/// Whatever the core answers; on these constants, nothing.
pub fn chapter_checks() -> Result<Vec<Check>, Error> {
    let givens = Givens::default();
    CHECKS.iter().map(|check| check(&givens)).collect()
}

/// Runs one check on the chapter's constants.
///
/// # Errors
/// [`Code::Index`] when no check has this number.
pub fn chapter_check(id: u32) -> Result<Check, Error> {
    let at = usize::try_from(id).ok().and_then(|id| id.checked_sub(1));
    match at.and_then(|at| CHECKS.get(at)) {
        Some(check) => check(&Givens::default()),
        None => {
            let message = format!("is the number of no check; they are numbered from 1 to {}", CHECKS.len());
            Err(Error::new(Code::Index, "id", message))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn checks_are_numbered_in_order_and_pass() {
        let checks = chapter_checks().expect("computed");
        assert!(checks.is_sorted_by(|a, b| a.id < b.id));
        assert_eq!(checks.len(), 13);
        for check in checks {
            assert!(check.passed, "{check:?}");
        }
    }

    #[test]
    fn one_check_by_its_number_is_that_check_of_the_thirteen() {
        let all = chapter_checks().expect("computed");
        for check in all {
            assert_eq!(chapter_check(u32::from(check.id)).expect("computed"), check);
        }
        for id in [0, 14, u32::MAX] {
            assert_eq!(chapter_check(id).expect_err("there is none").code, Code::Index);
        }
    }
}
