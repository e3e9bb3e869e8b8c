//! What the lab answers of systems whose answers are known.

use super::analysis::wanted;
use super::*;
use estimate::Verdict::{No, Yes};
use estimate::{Code, Complex, RiccatiLimit};
use lab::UpTo;

fn open(params: OwnParams) -> OwnFrame {
    OwnSystem::new(params).expect("a sound system").frame()
}

fn with(change: impl FnOnce(&mut OwnParams)) -> OwnParams {
    let mut params = OwnParams::default();
    change(&mut params);
    params
}

#[test]
fn the_system_it_opens_with_has_a_limit() {
    let frame = open(OwnParams::default());
    assert_eq!((frame.observable, frame.detectable, frame.noise.reachable), (Yes, Yes, Yes));
    assert_eq!((frame.limit, frame.rank.rank, frame.movable), (RiccatiLimit::FromEveryStart, 2, 2));
    assert!(frame.settled.is_some_and(|step| step < 200) && frame.spectral_radius < 1.0);
}

#[test]
fn a_velocity_sensor_leaves_the_position_unseen_and_its_eigenvalue_fixed() {
    let frame = open(with(|p| p.h[0] = [0.0, 1.0].into()));
    assert_eq!((frame.observable, frame.detectable, frame.limit), (No, No, RiccatiLimit::None));
    assert_eq!(frame.rank.directions, [[1.0, 0.0]]);
    let fixed: Vec<_> = frame.eigenvalues.iter().filter(|l| l.fixed).collect();
    assert!(fixed.len() == 1 && (fixed[0].re - 1.0).abs() < 1e-12, "{fixed:?}");
    assert_eq!((frame.movable, frame.settled), (1, None));
}

#[test]
fn a_bias_beside_a_value_is_seen_only_in_their_sum() {
    let params = with(|p| {
        p.f = [[1.0, 0.0], [0.0, 1.0]].map(UpTo::from).into();
        p.h[0] = [1.0, 1.0].into();
        p.v = [[0.1]].map(UpTo::from).into();
    });
    let frame = open(params);
    let [direction] = &frame.rank.directions[..] else { panic!("{:?}", frame.rank) };
    assert!((direction[0] - 1.0).abs() < 1e-12 && (direction[1] + 1.0).abs() < 1e-12, "{direction:?}");
    assert_eq!(frame.noise.unreached, [[0.0, 1.0]]);
    assert_eq!(frame.limit, RiccatiLimit::DependsOnStart);
}

#[test]
fn poles_that_are_placed_are_the_eigenvalues_and_a_conjugate_follows() {
    let params = with(|p| {
        p.gain = GainBy::Placement;
        p.poles[0] = [0.4, 0.3];
    });
    let frame = open(params);
    assert_eq!(frame.placed, Some(true));
    for (found, im) in frame.eigenvalues.iter().zip([0.3, -0.3]) {
        assert!((found.re - 0.4).abs() < 1e-12 && (found.im - im).abs() < 1e-12, "{found:?}");
    }
    assert_eq!(wanted(&[[0.5, 0.0], [0.2, 0.3], [0.1, 0.0], [0.0, 0.0]], 2), [0.5, 0.2].map(Complex::from));
}

#[test]
fn with_the_filter_s_limit_as_gain_by_hand_the_run_comes_to_the_filter_s() {
    let filter = open(OwnParams::default());
    let by_hand = with(|p| {
        p.gain = GainBy::Hand;
        (0..2).for_each(|i| p.k[i][0] = filter.k[i][0]);
    });
    let run = |params| {
        let mut lab = OwnSystem::new(params).expect("sound");
        lab.run(400).expect("runs");
        lab.frame()
    };
    let (one, other) = (run(OwnParams::default()), run(by_hand));
    assert_eq!(one.truth, other.truth);
    for i in 0..2 {
        assert!((one.estimate[i] - other.estimate[i]).abs() < 1e-9);
        assert!((one.p[i][i] - other.p[i][i]).abs() < 1e-9);
    }
    assert_eq!(one.series.step.len(), lab::WINDOW);
}

#[test]
fn the_estimate_is_off_by_about_what_the_filter_claims() {
    let mean: f64 = (0..200)
        .map(|seed| {
            let mut lab = OwnSystem::new(with(|p| p.seed = seed)).expect("sound");
            lab.run(60).expect("runs");
            let frame = lab.frame();
            let off = frame.truth[0] - frame.estimate[0];
            off * off / frame.p[0][0]
        })
        .sum::<f64>()
        / 200.0;
    // The mean of 200 χ² with one degree of freedom has a standard deviation of 0.1.
    assert!((mean - 1.0).abs() < 0.3, "{mean}");
}

#[test]
fn a_fault_names_the_matrix_it_is_in() {
    let blamed = |change: fn(&mut OwnParams)| {
        let error = OwnSystem::new(with(change)).expect_err("refused");
        (error.code, error.argument.to_string())
    };
    assert_eq!(blamed(|p| p.v[0][1] = 0.5), (Code::NotSymmetric, "v".into()));
    assert_eq!(blamed(|p| p.w[0][0] = -1.0), (Code::NotPositiveSemidefinite, "w".into()));
    assert_eq!(blamed(|p| p.f[1][0] = f64::NAN), (Code::NotFinite, "f[1][0]".into()));
    let without_noise = |p: &mut OwnParams| (p.v, p.w, p.start) = (Entries::default(), Entries::default(), 0.0);
    assert_eq!(blamed(without_noise), (Code::InnovationNotPositiveDefinite, "w".into()));
}

#[test]
fn an_unstable_system_without_a_useful_gain_stops_and_says_so() {
    let params = with(|p| {
        p.f[0][0] = 3.0;
        p.gain = GainBy::Hand;
    });
    let mut lab = OwnSystem::new(params).expect("sound");
    lab.run(1000).expect("stands still");
    assert!(lab.frame().diverged && lab.steps() == 1000);
}
