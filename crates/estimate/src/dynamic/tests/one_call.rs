//! A filter whose step or sensor is another for one call, and one that is kept and gone on with.

use super::filter::systems;
use crate::dynamic::{Bound, Conditioning, Continuous, Discrete, KalmanFilter, System};
use crate::error::Code;
use nalgebra::{DMatrix, dmatrix, dvector};

#[test]
fn a_step_and_a_sensor_of_one_call_are_those_of_a_filter_that_has_them() {
    let continuous = Continuous::new(dmatrix![0.0, 1.0; 0.0, -0.1], dmatrix![0.0; 1.0], dmatrix![0.0, 0.0; 0.0, 0.2]);
    let continuous = continuous.expect("sound");
    let (h, w) = (dmatrix![1.0, 0.0; 0.3, 1.0], dmatrix![0.5, 0.1; 0.1, 0.4]);
    let (rail, belief) = systems().swap_remove(1);
    let mut one = KalmanFilter::new(&rail, &belief).expect("sound");
    for (k, dt) in [0.1, 0.35, 2.0].into_iter().enumerate() {
        let step = continuous.discretize(dt).expect("finite");
        let Discrete { f, g, v } = step.clone();
        let other = System::new(f, g, h.clone(), v, w.clone()).expect("sound");
        let mut twin = KalmanFilter::new(&other, &one.belief()).expect("sound");
        let y = [Some(k as f64), (k != 1).then_some(0.5)];
        twin.step_partly(&[0.3], &y).expect("sound");
        one.predict_over(&[0.3], step).expect("sound");
        one.update_by(&y, h.clone(), w.clone()).expect("sound");
        assert_eq!(one.belief(), twin.belief());
        assert_eq!(one.last(), twin.last());
        assert_eq!(one.last().expect("read").s.nrows(), if k == 1 { 1 } else { 2 });
    }
    // The system is its own again.
    let mut twin = KalmanFilter::new(&rail, &one.belief()).expect("sound");
    one.step(&[0.1], &[1.0]).expect("sound");
    twin.step(&[0.1], &[1.0]).expect("sound");
    assert_eq!(one.belief(), twin.belief());
}

#[test]
fn what_does_not_fit_is_named_and_the_filter_stays() {
    let (rail, belief) = systems().swap_remove(1);
    let mut filter = KalmanFilter::new(&rail, &belief).expect("sound");
    let eye = DMatrix::<f64>::identity(2, 2);
    let step = || Discrete { f: eye.clone(), g: dmatrix![0.0; 1.0], v: eye.clone() };
    for (step, argument) in [
        (Discrete { f: dmatrix![1.0], ..step() }, "F"),
        (Discrete { g: DMatrix::zeros(2, 2), ..step() }, "G"),
        (Discrete { v: dmatrix![1.0], ..step() }, "V"),
    ] {
        let error = filter.predict_over(&[0.0], step).expect_err("refused");
        assert_eq!((error.code, error.argument.as_ref()), (Code::Shape, argument));
    }
    assert_eq!(filter.predict_over(&[], step()).expect_err("no input").argument, "u");
    let y = [Some(1.0)];
    for (h, w, argument) in
        [(dmatrix![1.0], dmatrix![1.0], "H"), (dmatrix![1.0, 0.0], eye.clone(), "W"), (eye.clone(), eye.clone(), "y")]
    {
        let error = filter.update_by(&y, h, w).expect_err("refused");
        assert_eq!((error.code, error.argument.as_ref()), (Code::Shape, argument));
    }
    assert_eq!(filter.belief(), belief);
}

/// A prior of 10¹⁴ beside a reading of 10⁻¹⁰ loses digits; one of 10⁷ is carried along.
#[test]
fn a_filter_that_is_kept_goes_on_to_the_last_bit() {
    for (system, belief) in systems() {
        for scale in [1.0, 1e7, 1e14] {
            let mut belief = belief.clone();
            belief.p *= scale;
            let system = System { w: &system.w * (1.0 / scale), ..system.clone() };
            let (m, p) = (system.g.ncols(), system.h.nrows());
            let mut filter = KalmanFilter::new(&system, &belief).expect("sound");
            for k in 0..12 {
                let state = filter.state();
                let mut resumed = KalmanFilter::from_state(state).expect("sound");
                let (u, y) = (vec![0.1; m], vec![f64::from(k); p]);
                resumed.step(&u, &y).expect("sound");
                filter.step(&u, &y).expect("sound");
                assert_eq!(resumed.belief(), filter.belief());
                assert_eq!(resumed.last(), filter.last());
                assert_eq!(resumed.conditioned(), filter.conditioned());
                assert_eq!(resumed.log_likelihood(), filter.log_likelihood());
                assert_eq!(resumed.state().conditioning.bound(), filter.state().conditioning.bound());
            }
        }
    }
}

#[test]
fn a_state_that_does_not_fit_is_refused() {
    let (rail, belief) = systems().swap_remove(1);
    let mut filter = KalmanFilter::new(&rail, &belief).expect("sound");
    filter.step(&[0.1], &[2.0]).expect("sound");
    type Spoil = fn(&mut crate::dynamic::FilterState);
    let spoilt: [(Spoil, &str); 6] = [
        (|it| it.belief.x = dvector![1.0], "belief"),
        (|it| it.log_likelihood = Some(f64::NAN), "logLikelihood"),
        (|it| it.conditioning = Conditioning::resumed(Bound::Carried(dmatrix![1.0]), false), "rounding"),
        (|it| it.last.as_mut().expect("read").nis = Some(f64::INFINITY), "nis"),
        (|it| it.last.as_mut().expect("read").s = DMatrix::zeros(2, 2), "S"),
        (|it| it.last.as_mut().expect("read").r = dmatrix![1.0], "R"),
    ];
    for (spoil, argument) in spoilt {
        let mut state = filter.state();
        spoil(&mut state);
        assert_eq!(KalmanFilter::from_state(state).expect_err("refused").argument, argument);
    }
}
