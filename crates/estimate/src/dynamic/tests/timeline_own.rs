//! Sensors of a time line that read a function of a caller's own.

use super::*;
use alloc::rc::Rc;
use alloc::string::ToString;
use alloc::vec;

const MEMORY: Memory = Memory { window: 100.0, capacity: 100 };

fn cart() -> Continuous {
    let (a, b) = (dmatrix![0.0, 1.0; 0.0, 0.0], DMatrix::zeros(2, 0));
    Continuous::new(a, b, dmatrix![0.0, 0.0; 0.0, 0.1]).expect("sound")
}

fn start() -> Belief {
    belief_from(dvector![1.0, 1.0], dmatrix![1.0, 0.2; 0.2, 0.5]).expect("sound")
}

fn sensor<H>(name: &str, h: H, w: f64, delay: f64) -> Sensor<H> {
    Sensor { name: name.into(), h, w: dmatrix![w], delay, gate: None }
}

fn own(h: impl Fn(&[f64]) -> Result<Vec<f64>, Error> + 'static) -> OwnOutput<Error> {
    OwnOutput { outputs: 1, h: Rc::new(h), jacobian: None, angles: vec![] }
}

/// The direction of the cart from a mast one metre beside the rail's start, and its speed.
fn mast_and_wheel() -> Vec<Sensor<AnyOutput<Error>>> {
    let mast = OwnOutput { angles: vec![0], ..own(|x| Ok(vec![libm::atan2(-1.0, -x[0])])) };
    let wheel = AnyOutput::Linear(dmatrix![0.0, 1.0]);
    vec![sensor("mast", AnyOutput::Own(mast), 0.01, 0.5), sensor("wheel", wheel, 0.04, 0.0)]
}

#[test]
fn a_function_that_is_a_matrix_corrects_as_the_matrix_does_to_the_last_bit() {
    let row = OwnOutput {
        jacobian: Some(Rc::new(|_: &[f64]| Ok(dmatrix![0.5, -1.0]))),
        ..own(|x| Ok(vec![0.5 * x[0] - x[1]]))
    };
    let mut by_function =
        Timeline::new(cart(), &start(), 0.0, MEMORY, vec![sensor("a", row, 0.3, 0.2)]).expect("sound");
    let matrix = sensor("a", dmatrix![0.5, -1.0], 0.3, 0.2);
    let mut by_matrix = Timeline::new(cart(), &start(), 0.0, MEMORY, vec![matrix]).expect("sound");
    for (t, y) in [(1.0, -0.7), (3.0, 0.4), (2.0, -0.1)] {
        let placed = by_function.reading("a", t, &[Some(y)], 0).expect("finite");
        assert_eq!(placed, by_matrix.reading("a", t, &[Some(y)], 0).expect("finite"));
    }
    assert_eq!(by_function.at(4.0), by_matrix.at(4.0));
    assert_eq!(by_function.statistics(), by_matrix.statistics());
}

/// The third comes last, and is linearized about another belief then: the answer is that of the sorted readings.
#[test]
fn what_comes_late_has_the_function_asked_again_and_leaves_the_sorted_readings_bits() {
    let readings = [("wheel", 1.0, 1.1), ("mast", 2.0, -2.4), ("wheel", 1.75, 0.8), ("mast", 3.0, -2.6)];
    let told = |order: [usize; 4]| {
        let mut line = Timeline::new(cart(), &start(), 0.0, MEMORY, mast_and_wheel()).expect("sound");
        for (name, t, y) in order.map(|i| readings[i]) {
            line.reading(name, t, &[Some(y)], 0).expect("finite");
        }
        (line.at(4.0).expect("finite"), line.statistics())
    };
    let sorted = told([0, 1, 2, 3]);
    for order in [[3, 2, 1, 0], [1, 0, 3, 2], [2, 3, 0, 1], [0, 3, 1, 2]] {
        assert_eq!(told(order), sorted);
    }
}

#[test]
fn the_innovation_of_an_angle_goes_the_short_way_round() {
    let mut line = Timeline::new(cart(), &start(), 0.0, MEMORY, mast_and_wheel()).expect("sound");
    // The mast sees the cart at −135°; +179° is 46° away, across the half turn.
    let expected = libm::atan2(-1.0, -1.0);
    let y = core::f64::consts::PI - 0.02;
    let placed = line.reading("mast", 0.5, &[Some(y)], 0).expect("finite");
    let innovation = placed.judged.expect("placed").innovation[0];
    assert!((innovation - (y - expected - 2.0 * core::f64::consts::PI)).abs() < 1e-12, "{innovation}");
}

#[test]
fn a_function_that_fails_or_answers_nonsense_leaves_the_time_line() {
    let bad = |answer: fn(f64) -> Result<Vec<f64>, Error>| {
        let h = own(move |x| if x[0] < 0.0 { answer(x[0]) } else { Ok(vec![x[0]]) });
        let mut line = Timeline::new(cart(), &start(), 0.0, MEMORY, vec![sensor("a", h, 0.01, 0.0)]).expect("sound");
        line.reading("a", 2.0, &[Some(2.0)], 0).expect("in front");
        let before = (line.at(3.0), line.statistics(), line.len());
        // So far back that the replayed cart stands behind the mast.
        let error = line.reading("a", 1.0, &[Some(-50.0)], 0).expect_err("behind");
        assert_eq!((line.at(3.0), line.statistics(), line.len()), before);
        (error.code, error.argument.to_string())
    };
    let own_error = |_| Err(Error::new(Code::Limit, "mine", "is behind the mast"));
    assert_eq!(bad(own_error), (Code::Limit, "mine".into()));
    assert_eq!(bad(|_| Ok(vec![f64::NAN])), (Code::NotFinite, "h(x)[0]".into()));
    assert_eq!(bad(|x| Ok(vec![x, x])), (Code::Shape, "h(x)".into()));
}

#[test]
fn an_own_sensor_s_sizes_and_angles_are_checked_by_name() {
    let made = |output, w: DMatrix<f64>| {
        let sensor = Sensor { name: "a".into(), h: output, w, delay: 0.0, gate: None };
        let error = Timeline::new(cart(), &start(), 0.0, MEMORY, vec![sensor]).expect_err("unsound");
        (error.code, error.argument.to_string())
    };
    let angle = OwnOutput { angles: vec![1], ..own(|x| Ok(vec![x[0]])) };
    assert_eq!(made(angle, dmatrix![1.0]), (Code::Index, "sensors.a.angles[0]".into()));
    assert_eq!(made(own(|x| Ok(vec![x[0]])), DMatrix::identity(2, 2)), (Code::Shape, "sensors.a.W".into()));
}
