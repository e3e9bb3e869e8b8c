//! The smoother, beside what one correction of all states at once makes of a log.

use super::filter::systems;
use super::*;

/// A log with gaps, and with readings of which a part is missing.
fn log_of(system: &System, rows: usize) -> (Vec<Vec<f64>>, Vec<Vec<Option<f64>>>) {
    let wave = |a: f64, k: usize, i: usize| 3.0 * libm::sin(a * (k * k + 3 * i) as f64);
    let us = (0..rows).map(|k| (0..system.g.ncols()).map(|i| wave(0.3, k, i)).collect());
    let read = |k: usize, i: usize| k % 5 != 1 && k % 7 != 4 && !(k + i).is_multiple_of(3);
    let ys = (0..rows).map(|k| (0..system.h.nrows()).map(|i| read(k, i).then(|| wave(1.7, k, i))).collect());
    (us.collect(), ys.collect())
}

/// The states of all rows in one vector, corrected once by all readings.
fn all_at_once(system: &System, belief: &Belief, us: &[Vec<f64>], ys: &[Vec<Option<f64>>]) -> Belief {
    let (n, p, rows) = (system.f.nrows(), system.h.nrows(), ys.len());
    let (mut x, mut cov) = (DVector::zeros(n * rows), DMatrix::zeros(n * rows, n * rows));
    let mut one = belief.clone();
    for (k, u) in us.iter().enumerate() {
        one.predict(&system.f, &system.v, Some((&system.g, &DVector::from_column_slice(u)))).expect("finite");
        x.rows_mut(k * n, n).copy_from(&one.x);
        cov.view_mut((k * n, k * n), (n, n)).copy_from(&one.p);
        for j in 0..k {
            let before = cov.view(((k - 1) * n, j * n), (n, n)).into_owned();
            let between = &system.f * before;
            cov.view_mut((k * n, j * n), (n, n)).copy_from(&between);
            cov.view_mut((j * n, k * n), (n, n)).copy_from(&between.transpose());
        }
    }
    let there: Vec<(usize, f64)> = ys.iter().flatten().enumerate().filter_map(|(i, y)| y.map(|y| (i, y))).collect();
    let h = DMatrix::from_fn(there.len(), n * rows, |i, j| {
        let (row, output) = (there[i].0 / p, there[i].0 % p);
        if j / n == row { system.h[(output, j % n)] } else { 0.0 }
    });
    let w = DMatrix::from_fn(there.len(), there.len(), |i, j| {
        let (i, j) = (there[i].0, there[j].0);
        if i / p == j / p { system.w[(i % p, j % p)] } else { 0.0 }
    });
    let y = DVector::from_iterator(there.len(), there.iter().map(|(_, y)| *y));
    Gaussian { x, p: cov }.corrected(&y, &h, &w).expect("positive definite").0
}

#[test]
fn the_track_is_that_of_all_readings_at_once() {
    for (system, belief) in systems() {
        let (us, ys) = log_of(&system, 12);
        let (n, whole) = (belief.x.len(), all_at_once(&system, &belief, &us, &ys));
        let track = kalman_smooth(&system, &belief, &us, &ys).expect("positive definite");
        for (k, found) in track.iter().enumerate() {
            let exact = whole.p.view((k * n, k * n), (n, n));
            assert!((&found.x - whole.x.rows(k * n, n)).amax() < 1e-11, "row {k}: {}", found.x);
            assert!((&found.p - exact).amax() < 1e-11 * exact.amax(), "row {k}: {}", found.p);
        }
    }
}

#[test]
fn a_smoothed_covariance_is_symmetric_and_never_above_the_filter_s() {
    for (system, belief) in systems() {
        // Known to nothing, to a metre, to a micrometre.
        for scale in [1e12, 1.0, 1e-12] {
            let belief = Gaussian { p: &belief.p * scale, ..belief.clone() };
            let (us, ys) = log_of(&system, 60);
            let track = kalman_smooth(&system, &belief, &us, &ys).expect("positive definite");
            let mut filter = KalmanFilter::new(&system, &belief).expect("sizes fit");
            for (k, found) in track.iter().enumerate() {
                filter.step_partly(&us[k], &ys[k]).expect("positive definite");
                assert_eq!(found.p, found.p.transpose());
                let above = &filter.belief().p - &found.p;
                let rounding = 1e-13 * filter.belief().p.amax();
                assert!(filters::covariance::positive_when_raised(&above, rounding), "row {k} from {scale}: {above}");
                assert!(validate::covariance(found.p.clone(), found.x.len(), "P").is_ok());
            }
            assert_eq!(track.last(), Some(&filter.belief()));
        }
    }
}

#[test]
fn from_the_last_reading_on_the_track_is_the_filter_s_to_the_last_bit() {
    for (system, belief) in systems() {
        let (us, mut ys) = log_of(&system, 20);
        let none = vec![None; system.h.nrows()];
        ys[13..].fill(none.clone());
        let last = ys.iter().rposition(|y| *y != none).expect("something is read");
        let track = kalman_smooth(&system, &belief, &us, &ys).expect("positive definite");
        let mut filter = KalmanFilter::new(&system, &belief).expect("sizes fit");
        for (k, found) in track.iter().enumerate() {
            filter.step_partly(&us[k], &ys[k]).expect("positive definite");
            assert_eq!(*found == filter.belief(), k >= last, "row {k}");
        }
        // Without any reading there is nothing to smooth by.
        let blind = kalman_smooth(&system, &belief, &us, &vec![none; 20]).expect("finite");
        let mut filter = KalmanFilter::new(&system, &belief).expect("sizes fit");
        for (found, u) in blind.iter().zip(&us) {
            filter.predict(u).expect("finite");
            assert_eq!(*found, filter.belief());
        }
    }
}

/// The speed of what was read twice is known at the start too, however little was known before: P − C P̄ Cᵀ, multiplied
/// out, would have lost it in the rounding of 10²⁰.
#[test]
fn a_vast_prior_is_forgotten() {
    let one = dmatrix![1.0, 1.0; 0.0, 1.0];
    let system =
        System::new(one, DMatrix::zeros(2, 0), dmatrix![1.0, 0.0], DMatrix::identity(2, 2) * 1e-4, dmatrix![1.0])
            .expect("sound");
    let belief = belief_from(dvector![0.0, 0.0], DMatrix::identity(2, 2) * 1e10).expect("sound");
    let ys: Vec<_> = (0..10).map(|k| vec![Some(f64::from(k))]).collect();
    let track = kalman_smooth(&system, &belief, &[], &ys).expect("positive definite");
    // By the smoother's equations with 80 digits.
    let between = -0.054_906_988_571_452_53;
    let exact = dmatrix![0.346_075_146_369_264_3, between; between, 0.012_408_015_190_036_383];
    assert!((&track[0].p - &exact).amax() < 1e-6 * exact.amax(), "{}", track[0].p);
    assert!(track[0].x[0].abs() < 1e-6 && (track[0].x[1] - 0.999_999_999_992_027_7).abs() < 1e-6, "{}", track[0].x);
}

#[test]
fn what_cannot_be_smoothed_is_refused_by_name_and_row() {
    let (system, belief) = position_sensor();
    let (system, belief) = (system_of(&system), belief_of(&belief));
    let (us, ys) = log_of(&system, 8);
    let refused = |system: &System, belief: &Belief, us: &[Vec<f64>], ys: &[Vec<Option<f64>>]| {
        let error = kalman_smooth(system, belief, us, ys).expect_err("refused");
        (error.code, error.argument.to_string(), error.message.to_string())
    };
    let short = |(code, argument, _): (Code, String, String)| (code, argument);
    assert_eq!(short(refused(&system, &belief, &[], &[])), (Code::Limit, "ys".into()));
    assert_eq!(short(refused(&system, &belief, &us[1..], &ys)), (Code::Shape, "us".into()));
    let mut bent = us.clone();
    bent[3] = vec![];
    assert_eq!(short(refused(&system, &belief, &bent, &ys)), (Code::Shape, "us[3]".into()));
    let mut bent = ys.clone();
    bent[5] = vec![Some(f64::NAN)];
    assert_eq!(short(refused(&system, &belief, &us, &bent)), (Code::NotFinite, "ys[5]".into()));
    bent[5] = vec![None, None];
    assert_eq!(short(refused(&system, &belief, &us, &bent)), (Code::Shape, "ys[5]".into()));
    // Nothing moves by itself, and where it starts is known: no row can tell anything about the one before.
    let still = System { v: DMatrix::zeros(2, 2), ..system };
    let known = Gaussian { p: DMatrix::zeros(2, 2), ..belief };
    let (code, argument, message) = refused(&still, &known, &us, &ys);
    assert_eq!((code, argument.as_str()), (Code::InnovationNotPositiveDefinite, "V"));
    assert!(message.contains("at row 7"), "{message}");
}
