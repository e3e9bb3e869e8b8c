use super::*;
use nalgebra::{dmatrix, dvector};

fn belief() -> Belief {
    let p = dmatrix![0.09, 0.01, 0.0; 0.01, 0.04, -0.02; 0.0, -0.02, 0.05];
    Belief { x: dvector![1.5, 2.0, 0.4], p }
}

fn map() -> Vec<Landmark> {
    vec![Landmark { id: 3, x: 6.0, y: 6.0 }, Landmark { id: 8, x: 0.0, y: 6.0 }]
}

fn both(gate: Option<f64>) -> EkfLocalizer {
    let w = dmatrix![0.01, 0.0; 0.0, 0.001];
    EkfLocalizer::new(belief(), map(), w, gate, SensorKind::RangeBearing).expect("sound")
}

fn reading(landmark: Option<u32>) -> LandmarkReading {
    let (dx, dy) = (1.6 - 0.0, 2.1 - 6.0);
    LandmarkReading { range: numerics::hypot(dx, dy), bearing: Some(libm::atan2(dy, dx) - 0.35), landmark }
}

#[test]
fn a_reading_without_an_id_is_associated_with_its_landmark() {
    let (mut named, mut found) = (both(Some(9.21)), both(Some(9.21)));
    let answer = named.update(reading(Some(8))).expect("pd");
    assert!(answer.accepted && answer.landmark == 8);
    assert_eq!(found.update(reading(None)).expect("pd"), answer);
    assert_eq!(named, found);
    assert_ne!(named, both(Some(9.21)));
}

#[test]
fn the_gate_holds_in_both_cases() {
    let mut ekf = both(Some(9.21));
    let answer = ekf.update(reading(Some(3))).expect("pd");
    assert!(!answer.accepted && answer.chi2 > 9.21);
    let odd = LandmarkReading { range: 0.5, bearing: Some(2.0), landmark: None };
    assert!(!ekf.update(odd).expect("pd").accepted);
    assert_eq!(ekf, both(Some(9.21)));
    assert!(both(None).update(reading(Some(3))).expect("pd").accepted);
}

#[test]
fn a_log_replayed_is_its_steps_one_by_one() {
    let v = dmatrix![0.01, 0.0, 0.0; 0.0, 0.01, 0.0; 0.0, 0.0, 0.01];
    let log = [0.0, 0.2, -0.1].map(|d| Logged { u: [d, 0.1], reading: reading(Some(8)) });
    let (mut at_once, mut in_turn) = (both(Some(9.21)), both(Some(9.21)));
    let poses = at_once.replay(log.into_iter(), v.clone()).expect("sound");
    for (logged, pose) in log.iter().zip(poses) {
        in_turn.predict(DVector::from_column_slice(&logged.u), v.clone()).expect("sound");
        in_turn.update(logged.reading).expect("sound");
        assert_eq!(in_turn.belief().x.as_slice(), pose);
    }
    assert_eq!(at_once, in_turn);

    let mut broken = log;
    broken[2].reading.range = -1.0;
    let refused = at_once.replay(broken.into_iter(), v.clone()).expect_err("a negative range");
    assert_eq!((refused.code, refused.argument.as_ref()), (Code::Limit, "log[2].range"));
    broken[2].reading.range = 1e308;
    let refused = at_once.replay(broken.into_iter(), v.clone()).expect_err("a vast range");
    assert_eq!((refused.code, refused.argument.as_ref()), (Code::NotFinite, "log[2].range"));
    broken[1].u[0] = 1e200;
    let refused = at_once.replay(broken.into_iter(), v.clone()).expect_err("a vast step");
    assert_eq!((refused.code, refused.argument.as_ref()), (Code::NotFinite, "log[1].u"));
    let vast = 1e308 * DMatrix::identity(3, 3);
    let refused = at_once.replay(log.into_iter(), vast).expect_err("a vast noise");
    assert_eq!((refused.code, refused.argument.as_ref()), (Code::NotFinite, "V"));
    assert_eq!(at_once.replay([].into_iter(), v).expect_err("no step").code, Code::Limit);
    assert_eq!(at_once, in_turn);
}

#[test]
fn a_range_sensor_refuses_a_bearing() {
    let new = |w| EkfLocalizer::new(belief(), map(), w, None, SensorKind::Range);
    let mut ekf = new(dmatrix![0.01]).expect("sound");
    assert_eq!((ekf.sensor(), both(None).sensor()), (SensorKind::Range, SensorKind::RangeBearing));
    let refused = ekf.update(reading(Some(8))).expect_err("a bearing");
    assert_eq!((refused.code, refused.argument.as_ref()), (Code::Type, "bearing"));
    let answer = ekf.update(LandmarkReading { bearing: None, ..reading(Some(8)) }).expect("pd");
    assert_eq!((answer.innovation.len(), answer.s.shape()), (1, (1, 1)));
    assert_eq!(new(dmatrix![0.01, 0.0; 0.0, 0.01]).expect_err("2 × 2").code, Code::Shape);
    let refused = both(None).update(LandmarkReading { bearing: None, ..reading(None) }).expect_err("no bearing");
    assert_eq!((refused.code, refused.argument.as_ref()), (Code::Type, "bearing"));
}

#[test]
fn the_culprit_is_named_and_nothing_changes() {
    let blame = |e: Error| (e.code, e.argument.to_string());
    let w = dmatrix![0.01, 0.0; 0.0, 0.001];
    let new = |belief, map, w, gate| {
        blame(EkfLocalizer::new(belief, map, w, gate, SensorKind::RangeBearing).expect_err("refused"))
    };
    let twins = vec![map()[0], map()[0]];
    assert_eq!(new(belief(), twins, w.clone(), None), (Code::Index, "landmarks[1].id".into()));
    let lost = vec![Landmark { id: 1, x: 0.0, y: f64::NAN }];
    assert_eq!(new(belief(), lost, w.clone(), None), (Code::NotFinite, "landmarks[0].y".into()));
    assert_eq!(new(belief(), vec![], w.clone(), None), (Code::Limit, "landmarks".into()));
    let many = (0..=1000).map(|id| Landmark { id, x: 0.0, y: 0.0 }).collect();
    assert_eq!(new(belief(), many, w.clone(), None), (Code::Limit, "landmarks".into()));
    assert_eq!(new(belief(), map(), -w.clone(), None), (Code::NotPositiveSemidefinite, "W".into()));
    assert_eq!(new(belief(), map(), w.clone(), Some(0.0)), (Code::Limit, "gate".into()));
    let small = Belief { x: dvector![0.0], p: dmatrix![1.0] };
    assert_eq!(new(small, map(), w, None), (Code::Shape, "belief.x".into()));

    let mut ekf = both(None);
    let mut update = |r: LandmarkReading| blame(ekf.update(r).expect_err("refused"));
    assert_eq!(update(LandmarkReading { range: -0.1, ..reading(None) }), (Code::Limit, "range".into()));
    assert_eq!(update(LandmarkReading { range: f64::NAN, ..reading(None) }), (Code::NotFinite, "range".into()));
    assert_eq!(update(LandmarkReading { range: 1e308, ..reading(None) }), (Code::NotFinite, "range".into()));
    assert_eq!(update(LandmarkReading { range: 1e308, ..reading(Some(8)) }), (Code::NotFinite, "range".into()));
    assert_eq!(update(reading(Some(4))), (Code::Index, "landmark".into()));
    let predict = |ekf: &mut EkfLocalizer, u, v| blame(ekf.predict(u, v).expect_err("refused"));
    assert_eq!(predict(&mut ekf, dvector![1.0], DMatrix::zeros(3, 3)), (Code::Shape, "u".into()));
    assert_eq!(predict(&mut ekf, dvector![1.0, 0.0], DMatrix::zeros(2, 2)), (Code::Shape, "V".into()));
    for far in [1e200, 1e308] {
        let refused = predict(&mut ekf, dvector![far, 0.0], DMatrix::zeros(3, 3));
        assert_eq!(refused, (Code::NotFinite, "u".into()));
    }
    assert_eq!(ekf, both(None));

    let here = vec![Landmark { id: 1, x: 1.5, y: 2.0 }];
    let w = dmatrix![0.01, 0.0; 0.0, 0.001];
    let mut ekf = EkfLocalizer::new(belief(), here, w, None, SensorKind::RangeBearing).expect("sound");
    assert_eq!(ekf.update(reading(None)).expect_err("on it").code, Code::AtLandmark);
    assert_eq!(ekf.belief(), belief());
    // Another landmark can still be sighted from there.
    let w = dmatrix![0.01, 0.0; 0.0, 0.001];
    let two = vec![Landmark { id: 1, x: 1.5, y: 2.0 }, Landmark { id: 8, x: 0.0, y: 6.0 }];
    let mut ekf = EkfLocalizer::new(belief(), two, w, None, SensorKind::RangeBearing).expect("sound");
    assert_eq!(ekf.update(reading(None)).expect("the other").landmark, 8);
}
