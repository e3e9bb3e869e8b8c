//! The real robot's log, replayed with the settings that the chapter tries in turn, against an independent replay's
//! numbers.
//!
//! The reference was computed by a program that shares no code with this one; both round in their own order, so they
//! agree to 10⁻⁶ and not to the bit.

use estimate::drive::{BySensor, Course, Replay, Settings, Summary};
use robot_log::{Log, parse};

fn plaza() -> Log {
    parse(include_str!("../../../content/logs/plaza1.csv")).expect("the log is sound")
}

fn replayed(settings: Settings) -> Summary {
    let drive = plaza().drive;
    let course = Course::new(&drive, settings).expect("sound settings");
    let mut replay = Replay::new(&course);
    while replay.take(&drive, &course).expect("a sound row").is_some() {}
    replay.summary(&course)
}

/// The numbers of one row of the reference: used and refused, RMSE and worst error, NIS per output, mean of ν/√S and
/// lag 1, ε, and the final [x, y, θ].
struct Reference {
    counts: [u32; 2],
    errors: [f64; 2],
    innovations: Option<[f64; 3]>,
    epsilon: Option<f64>,
    pose: [f64; 3],
}

fn assert_meets(settings: Settings, reference: &Reference) {
    let found = replayed(settings);
    let near = |name: &str, found: f64, expected: f64| {
        assert!((found - expected).abs() < 1e-6, "{name}: {found} against {expected} with {settings:?}");
    };
    assert_eq!([found.used, found.refused], reference.counts, "{settings:?}");
    near("rmse", found.rmse.expect("there is a truth"), reference.errors[0]);
    near("worst", found.worst.expect("there is a truth"), reference.errors[1]);
    match reference.innovations {
        None => assert_eq!((found.nis, found.mean_innovation, found.lag1), (None, None, None)),
        Some([nis, mean, lag1]) => {
            near("nis", found.nis.expect("sightings were used"), nis);
            near("mean innovation", found.mean_innovation.expect("sightings were used"), mean);
            near("lag 1", found.lag1.expect("sightings were used"), lag1);
        }
    }
    assert_eq!(found.epsilon.is_some(), reference.epsilon.is_some());
    if let (Some(found), Some(expected)) = (found.epsilon, reference.epsilon) {
        near("epsilon", found, expected);
    }
    for (i, expected) in reference.pose.into_iter().enumerate() {
        near("final state", found.x[i], expected);
    }
}

#[test]
fn the_log_has_the_rows_that_its_notice_says() {
    let Log { drive, count } = plaza();
    assert_eq!(count, 15_123);
    assert_eq!((drive.landmarks.len(), drive.truth.poses().len(), drive.rows.len()), (4, 1933, 13_186));
}

#[test]
fn dead_reckoning_meets_the_reference() {
    assert_meets(
        Settings { sightings: false, ..Settings::default() },
        &Reference {
            counts: [0, 0],
            errors: [1.972405133, 4.411414428],
            innovations: None,
            epsilon: None,
            pose: [-1.231074134, 46.365827224, -0.387209386],
        },
    );
}

#[test]
fn raw_ranges_meet_the_reference() {
    assert_meets(
        Settings::default(),
        &Reference {
            counts: [3529, 0],
            errors: [3.472916746, 9.545768581],
            innovations: Some([12.793313313, 2.627121766, 0.361740195]),
            epsilon: None,
            pose: [-3.247598325, 51.322558945, -0.305842423],
        },
    );
}

#[test]
fn raw_ranges_with_a_gate_meet_the_reference() {
    assert_meets(
        Settings { gate: BySensor::all(Some(0.999)), ..Settings::default() },
        &Reference {
            counts: [1481, 2048],
            errors: [8.901160071, 28.988208637],
            innovations: Some([1.697151430, 0.152826045, 0.297909314]),
            epsilon: None,
            pose: [-1.513115469, 48.706373309, -0.336782540],
        },
    );
}

#[test]
fn calibrated_ranges_meet_the_reference() {
    let calibrated = Settings { scale: 0.069, ..Settings::default() };
    assert_meets(
        calibrated,
        &Reference {
            counts: [3529, 0],
            errors: [0.366308386, 1.735936434],
            innovations: Some([0.814794255, 0.048866201, -0.009464274]),
            epsilon: None,
            pose: [-4.936272870, 47.003442633, -0.371830407],
        },
    );
    assert_meets(
        Settings { gate: BySensor::all(Some(0.999)), ..calibrated },
        &Reference {
            counts: [3528, 1],
            errors: [0.366348337, 1.735936434],
            innovations: Some([0.812201472, 0.048147606, -0.010430903]),
            epsilon: None,
            pose: [-4.955356755, 46.870176634, -0.387527295],
        },
    );
}

#[test]
fn a_learned_scale_meets_the_reference() {
    let learning = Settings { learn: true, ..Settings::default() };
    assert_meets(
        learning,
        &Reference {
            counts: [3529, 0],
            errors: [0.366646474, 1.802262355],
            innovations: Some([0.811642113, 0.012109045, -0.010872128]),
            epsilon: Some(0.070128279),
            pose: [-4.961204184, 46.943034364, -0.373430604],
        },
    );
    assert_meets(
        Settings { gate: BySensor::all(Some(0.999)), ..learning },
        &Reference {
            counts: [3527, 2],
            errors: [0.367997840, 1.801316503],
            innovations: Some([0.807041519, 0.011107150, -0.012413021]),
            epsilon: Some(0.070116160),
            pose: [-4.979744058, 46.811432669, -0.388993084],
        },
    );
}
