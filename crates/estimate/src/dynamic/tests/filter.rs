//! The filter that keeps its belief.

use super::*;

/// The rail robot with a position sensor, with two outputs, without an input; a system of three states; a point in the
/// plane.
pub fn systems() -> Vec<(System, Belief)> {
    let (sys, belief) = position_sensor();
    let (rail, belief) = (system_of(&sys), belief_of(&belief));
    let both = System { h: DMatrix::identity(2, 2), w: dmatrix![0.5, 0.1; 0.1, 0.4], ..rail.clone() };
    let free = System { g: DMatrix::zeros(2, 0), ..rail.clone() };
    let three = System::new(
        dmatrix![1.0, 0.5, 0.125; 0.0, 1.0, 0.5; 0.0, 0.0, 0.9],
        dmatrix![0.0, 0.1; 0.5, 0.0; 0.0, 1.0],
        dmatrix![1.0, 0.0, 0.0; 0.0, 0.0, 1.0],
        DMatrix::identity(3, 3) * 0.01,
        dmatrix![0.2, 0.0; 0.0, 0.3],
    );
    let wide = belief_from(dvector![1.0, -2.0, 0.5], DMatrix::identity(3, 3)).expect("sound");
    let (t, i) = (0.5 * DMatrix::identity(2, 2), DMatrix::<f64>::identity(4, 4));
    let mut f = i.clone();
    f.view_mut((0, 2), (2, 2)).copy_from(&t);
    let plane = System::new(f, DMatrix::zeros(4, 0), i.rows(0, 2).into(), &i * 0.1, t).expect("sound");
    let point = belief_from(dvector![0.0, 1.0, -1.0, 0.5], i).expect("sound");
    vec![(plane, point), (rail, belief.clone()), (both, belief.clone()), (free, belief), (three.expect("sound"), wide)]
}

#[test]
fn the_filter_with_its_belief_inside_is_kalman_step_to_the_last_bit() {
    for (system, mut belief) in systems() {
        let (m, p) = (system.g.ncols(), system.h.nrows());
        let mut stepped = KalmanFilter::new(&system, &belief).expect("sizes fit");
        let mut halves = stepped.clone();
        let mut sum = 0.0;
        assert_eq!((halves.nis(), halves.log_likelihood()), (None, Some(0.0)));
        for k in 0..50 {
            let u = DVector::from_fn(m, |i, _| libm::sin(f64::from(k) + i as f64));
            let y = DVector::from_fn(p, |i, _| 3.0 * libm::cos(f64::from(k * k) - i as f64));
            let step = kalman_step(&system, &belief, &u, &y).expect("S is positive");
            stepped.step(u.as_slice(), y.as_slice()).expect("S is positive");
            halves.predict(u.as_slice()).expect("finite");
            assert_eq!(halves.belief(), step.predicted);
            halves.update(y.as_slice()).expect("S is positive");
            sum += log_density(&step.innovation, &step.s).expect("regular");
            let nis = filters::consistency::nis(&step.innovation, &step.s).expect("regular");
            for filter in [&stepped, &halves] {
                assert_eq!((filter.belief(), filter.x()), (step.posterior.clone(), step.posterior.x.as_slice()));
                assert_eq!(filter.log_likelihood(), Some(sum));
                assert!((filter.nis().expect("regular") / nis - 1.0).abs() < 1e-12);
            }
            belief = step.posterior;
        }
    }
}

#[test]
fn a_refused_step_names_its_argument_and_leaves_the_filter_as_it_was() {
    let (system, belief) = rail();
    let mut filter = KalmanFilter::new(&system, &belief).expect("sizes fit");
    filter.step(&[0.1], &[2.7]).expect("S is positive");
    let before = format!("{filter:?}");
    let mut refused = |call: &dyn Fn(&mut KalmanFilter) -> Result<(), Error>, code: Code, argument: &str| {
        let error = call(&mut filter).expect_err("refused");
        assert_eq!((error.code, error.argument.as_ref()), (code, argument));
        assert_eq!(format!("{filter:?}"), before);
    };
    refused(&|f| f.predict(&[]), Code::Shape, "u");
    refused(&|f| f.predict(&[f64::NAN]), Code::NotFinite, "u");
    refused(&|f| f.update(&[1.0, 2.0]), Code::Shape, "y");
    refused(&|f| f.step(&[0.0], &[f64::INFINITY]), Code::NotFinite, "y");
    // The prediction succeeds and the correction overflows: neither is kept.
    refused(&|f| f.step(&[1e308], &[-1.7e308]), Code::NotFinite, "y");
    let blind = System { w: dmatrix![0.0], h: dmatrix![0.0, 0.0], ..system };
    let error = KalmanFilter::new(&blind, &belief).expect("sizes fit").update(&[0.0]).expect_err("S is 0");
    assert_eq!((error.code, error.argument.as_ref()), (Code::InnovationNotPositiveDefinite, "W"));
    let narrow = belief_from(dvector![1.0], dmatrix![1.0]).expect("sound");
    assert_eq!(KalmanFilter::new(&blind, &narrow).expect_err("one state").argument, "belief");
}

/// The parts that are there are a reading of a sensor that has only their rows.
#[test]
fn a_reading_with_parts_missing_is_one_of_the_rows_that_are_there() {
    for (system, belief) in systems() {
        let p = system.h.nrows();
        let whole = KalmanFilter::new(&system, &belief).expect("sizes fit");
        let all: Vec<Option<f64>> = (0..p).map(|i| Some(1.5 - i as f64)).collect();
        let (mut partly, mut entire) = (whole.clone(), whole.clone());
        partly.update_partly(&all).expect("S is positive");
        entire.update(&all.iter().flatten().copied().collect::<Vec<_>>()).expect("S is positive");
        assert_eq!(format!("{partly:?}"), format!("{entire:?}"));
        partly.update_partly(&vec![None; p]).expect("nothing is read");
        assert_eq!((partly.belief(), partly.log_likelihood()), (entire.belief(), entire.log_likelihood()));
        assert_eq!(partly.nis(), None);
        for i in 0..p {
            let rows = |m: &DMatrix<f64>| m.rows(i, 1).into_owned();
            let narrow = System { h: rows(&system.h), w: rows(&system.w).columns(i, 1).into(), ..system.clone() };
            let mut alone = KalmanFilter::new(&narrow, &belief).expect("sizes fit");
            let mut partly = whole.clone();
            let one: Vec<_> = (0..p).map(|j| all[j].filter(|_| i == j)).collect();
            alone.step(&vec![0.2; system.g.ncols()], &[1.5 - i as f64]).expect("S is positive");
            partly.step_partly(&vec![0.2; system.g.ncols()], &one).expect("S is positive");
            assert_eq!((partly.belief(), partly.nis()), (alone.belief(), alone.nis()));
            assert_eq!(partly.log_likelihood(), alone.log_likelihood());
        }
    }
}

#[test]
fn a_refused_part_of_a_reading_leaves_the_filter_as_it_was() {
    let (system, belief) = systems().remove(0);
    let mut filter = KalmanFilter::new(&system, &belief).expect("sizes fit");
    filter.step(&[], &[0.4, -0.4]).expect("S is positive");
    let before = format!("{filter:?}");
    for (y, code) in [
        (vec![None], Code::Shape),
        (vec![None; 3], Code::Shape),
        (vec![None, Some(f64::NAN)], Code::NotFinite),
        (vec![Some(f64::INFINITY), None], Code::NotFinite),
    ] {
        for step in [KalmanFilter::update_partly, |f: &mut KalmanFilter, y: &[Option<f64>]| f.step_partly(&[], y)] {
            let mut moved = filter.clone();
            let error = step(&mut moved, &y).expect_err("refused");
            assert_eq!((error.code, error.argument.as_ref()), (code, "y"));
            assert_eq!(format!("{moved:?}"), before);
        }
    }
}
