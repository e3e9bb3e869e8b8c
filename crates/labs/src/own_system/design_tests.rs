//! What an engineer relies on: the limit of a slow filter, continuous time, nine states, a start for each state.

use super::*;
use estimate::RiccatiLimit;
use estimate::Verdict::{No, Undecided, Yes};
use estimate::dynamic;
use lab::UpTo;

fn with(change: impl FnOnce(&mut OwnParams)) -> OwnParams {
    let mut params = OwnParams::default();
    change(&mut params);
    params
}

fn open(params: OwnParams) -> OwnFrame {
    OwnSystem::new(params).expect("a sound system").frame()
}

/// A height, its speed and the bias of the accelerometer, a hundred times a second.
fn height() -> OwnParams {
    with(|p| {
        p.states = 3;
        p.f = [[1.0, 0.01, -0.00005], [0.0, 1.0, -0.01], [0.0, 0.0, 1.0]].map(UpTo::from).into();
        p.g = [[0.00005], [0.01], [0.0]].map(UpTo::from).into();
        p.h[0] = [1.0].into();
        p.v = [[1e-10, 2e-8, 0.0], [2e-8, 4e-6, 0.0], [0.0, 0.0, 1e-8]].map(UpTo::from).into();
        p.w[0] = [0.25].into();
        p.period = 0.01;
    })
}

/// F = [1e20 0.1; 0 1] and H = [1 0] with noise of the second state.
#[test]
fn a_badly_scaled_system_is_said_to_be_that() {
    let frame = open(with(|p| {
        p.f = [[1e20, 0.1], [0.0, 1.0]].map(UpTo::from).into();
        p.h[0] = [1.0].into();
        p.v = [[0.0, 0.0], [0.0, 1.0]].map(UpTo::from).into();
    }));
    assert_eq!((frame.observable, frame.detectable, frame.noise.reachable), (Undecided, Undecided, Undecided));
    assert!(frame.badly_scaled && frame.limit == RiccatiLimit::Undecided);
    assert!(!open(with(|p| p.h[0] = [0.0, 1.0].into())).badly_scaled);
}

/// Neither the turn nor the state beside it gives to the other; the reading is of both.
#[test]
fn a_turn_beside_a_state_that_dies_out_is_observed() {
    let [c, s] = [libm::cos(0.07), libm::sin(0.07)];
    for (cos, sin, alone) in [(c, s, 0.9), (0.99755, 0.06994, 0.9), (c, s, 0.5)] {
        let turn = |noise: f64| {
            open(with(|p| {
                p.states = 3;
                p.f = [[cos, sin, 0.0], [-sin, cos, 0.0], [0.0, 0.0, alone]].map(UpTo::from).into();
                p.h[0] = [1.0, 0.0, 1.0].into();
                p.v = [[noise, 0.0, 0.0], [0.0, noise, 0.0], [0.0, 0.0, 0.02]].map(UpTo::from).into();
                p.w[0] = [0.04].into();
            }))
        };
        let frame = turn(1e-3);
        assert_eq!((frame.observable, frame.detectable), (Yes, Yes), "{cos} {alone}");
        assert!(frame.limit == RiccatiLimit::FromEveryStart && !frame.badly_scaled, "{cos} {alone}");
        assert!(frame.eigenvalues.iter().all(|one| !one.fixed), "every one is moved by a gain");
        let still = turn(0.0);
        assert_eq!((still.observable, still.noise.reachable, still.noise.unreached.len()), (Yes, No, 2), "{cos}");
    }
}

/// Without noise each reading counts for ever, whatever gain is looked at.
#[test]
fn a_covariance_falls_as_an_average_under_every_gain_on_show() {
    for gain in [GainBy::Filter, GainBy::Hand, GainBy::Placement] {
        let frame = open(with(|p| {
            p.gain = gain;
            p.v = [[0.0, 0.0], [0.0, 0.0]].map(UpTo::from).into();
            p.w[0] = [1.0].into();
        }));
        assert!(frame.doubled.averages && frame.limit == RiccatiLimit::FromLargeStart, "{gain:?}");
        assert!(!open(with(|p| p.gain = gain)).doubled.averages);
    }
}

/// A speed's variance falls as 1/k³ beside its place's 1/k, which no doubling tells from rest.
#[test]
fn without_noise_the_limit_is_zero_and_never_reached() {
    let still = |f: [[f64; 2]; 2]| {
        open(with(|p| {
            p.f = f.map(UpTo::from).into();
            p.h[0] = [1.0, 0.0].into();
            p.v = [[0.0, 0.0], [0.0, 0.0]].map(UpTo::from).into();
            p.w[0] = [0.5].into();
        }))
    };
    let frame = still([[1.0, 1.0], [0.0, 1.0]]);
    assert_eq!(frame.limit_p, Some(vec![vec![0.0; 2]; 2]), "{frame:?}");
    assert!(frame.doubled.averages && frame.settled.is_none() && frame.spectral_radius == 1.0, "{frame:?}");
    assert_eq!(frame.k, [[0.0], [0.0]]);
    // What grows by itself has to be followed, and what is never seen stays uncertain.
    for f in [[[1.1, 1.0], [0.0, 1.0]], [[1.0, 0.0], [0.0, 1.0]]] {
        assert_ne!(still(f).limit_p, Some(vec![vec![0.0; 2]; 2]), "{f:?}");
    }
}

/// The place is read without noise and only the turns of the speed hide: the speed's error keeps its size.
#[test]
fn a_reading_without_noise_may_leave_an_error_on_the_circle() {
    for start in [0.0, 0.5, 1.0] {
        let frame = open(with(|p| {
            p.v = [[0.0015625, 0.00625], [0.00625, 0.025]].map(UpTo::from).into();
            (p.w[0], p.h[0]) = ([0.0].into(), [1.0, 0.0].into());
            (p.period, p.start) = (0.5, start);
        }));
        assert_eq!(frame.limit, RiccatiLimit::FromLargeStart, "{start}");
        assert!(
            frame.doubled.averages && frame.doubled.converged && frame.noise.stabilizable == estimate::Verdict::Yes
        );
        assert_eq!((frame.decay[0].steps, frame.decay[0].seconds), (None, None), "{:?}", frame.eigenvalues);
        assert!((frame.k[0][0] - 1.0).abs() < 1e-15 && (frame.k[1][0] - 4.0).abs() < 1e-14, "{:?}", frame.k);
        let limit = frame.limit_p.expect("the noise of a step");
        assert!((limit[0][0] - 0.0015625).abs() < 1e-18 && (limit[1][1] - 0.025).abs() < 1e-16, "{limit:?}");
        assert_eq!(frame.slowly, start > 0.0);
    }
}

#[test]
fn a_bias_that_only_its_sum_shows_grows_and_has_no_time_constant() {
    let frame = open(with(|p| {
        p.f = [[1.0, 0.0], [0.0, 1.0]].map(UpTo::from).into();
        p.h[0] = [1.0, 1.0].into();
        p.v = [[5e-4, 0.0], [0.0, 5e-6]].map(UpTo::from).into();
        p.w[0] = [0.04].into();
        p.period = 1.0;
    }));
    assert!(!frame.doubled.converged && frame.doubled.gain_converged && frame.limit_p.is_none(), "{frame:?}");
    assert_eq!(frame.limit, estimate::RiccatiLimit::None);
    let slowest = &frame.decay[0];
    assert_eq!((slowest.steps, slowest.seconds), (None, None), "{frame:?}");
}

#[test]
fn the_gain_of_a_slow_filter_is_its_limit_and_not_that_of_step_1000() {
    let frame = open(height());
    assert!(frame.doubled.converged && !frame.doubled.depends_on_start && frame.settled.is_none(), "{frame:?}");
    let system = &OwnSystem::new(height()).expect("sound").known.system.clone();
    let at_1000 = dynamic::steady_state_gain(system, DMatrix::identity(3, 3), 1000, 0.0).expect("runs").r;
    assert!((at_1000[2] / frame.k[2][0] - 1.0).abs() > 0.5, "{at_1000} {:?}", frame.k);
    // Single steps lead there too, a hundred thousand of them.
    let later = dynamic::steady_state_gain(system, DMatrix::identity(3, 3), 100_000, 0.0).expect("runs").r;
    (0..3).for_each(|i| assert!((later[i] / frame.k[i][0] - 1.0).abs() < 1e-9, "{later} {:?}", frame.k));
}

#[test]
fn a_run_is_as_long_as_its_slowest_error_and_the_plots_keep_one_of_several_steps() {
    let frame = open(height());
    let slowest = frame.decay[0].steps.expect("dies out");
    let left = libm::pow(frame.spectral_radius, slowest);
    assert!((left - 0.05).abs() < 1e-12 && frame.run_length >= slowest as u32, "{left} {}", frame.run_length);
    let seconds = frame.decay[0].seconds.expect("a step's length is known");
    assert!((libm::exp(-0.01 / seconds) - frame.spectral_radius).abs() < 1e-12);
    let mut lab = OwnSystem::new(OwnParams { every: 26, ..height() }).expect("sound");
    lab.run(frame.run_length).expect("runs");
    let all = lab.frame().series.step;
    assert_eq!(all.iter().take(3).collect::<Vec<_>>(), [0.0, 26.0, 52.0]);
    // An eigenvalue of 1 says nothing of how long a run should be.
    assert_eq!(open(with(|p| p.h[0] = [0.0, 1.0].into())).run_length, 40);
}

#[test]
fn a_system_in_continuous_time_is_the_one_that_it_is_over_a_step() {
    let params = with(|p| {
        p.f = [[0.0, 1.0], [0.0, 0.0]].map(UpTo::from).into();
        p.g = [[0.0], [1.0]].map(UpTo::from).into();
        p.v = [[0.0, 0.0], [0.0, 3.0]].map(UpTo::from).into();
        (p.continuous, p.period) = (true, 0.5);
    });
    let frame = open(params);
    assert_eq!(frame.f, [[1.0, 0.5], [0.0, 1.0]]);
    assert_eq!((frame.g, frame.v), (vec![vec![0.125], vec![0.5]], vec![vec![0.125, 0.375], vec![0.375, 1.5]]));
    let error = OwnSystem::new(OwnParams { period: 0.0, ..params }).expect_err("no length of a step");
    assert_eq!((error.code, error.argument.as_ref()), (estimate::Code::Limit, "period"));
    let error =
        OwnSystem::new(with(|p| (p.continuous, p.period, p.v[0][0]) = (true, 0.5, -1.0))).expect_err("negative");
    assert_eq!(error.argument, "v");
}

#[test]
fn each_state_has_a_start_of_its_own_and_there_may_be_nine() {
    let frame = open(with(|p| (p.start, p.spread) = (2.0, [3.0, 0.5].into())));
    assert_eq!(frame.p, [[6.0, 0.0], [0.0, 1.0]]);
    let nine = open(with(|p| {
        (p.states, p.inputs, p.readings) = (9, 0, 8);
        (0..9).for_each(|i| (p.f[i][i], p.v[i][i]) = (0.9, 0.1));
        (0..8).for_each(|i| (p.h[i][i], p.w[i][i]) = (1.0, 1.0));
    }));
    assert_eq!((nine.k.len(), nine.k[0].len(), nine.eigenvalues.len()), (9, 8, 9));
    assert_eq!((nine.series.truth.len(), nine.series.gain[8].len(), nine.movable), (9, 8, 8));
}

/// P(k+1 | k) after so many steps, from the start of these parameters.
fn stepped(params: &OwnParams, steps: usize) -> DMatrix<f64> {
    let known = OwnSystem::new(*params).expect("sound").known;
    dynamic::steady_state_gain(&known.system, known.p0.clone(), steps, 0.0).expect("runs").p
}

/// Constants of which only the start tells one from a walk: their P comes to rest. What a reading tells by itself falls
/// on.
#[test]
fn a_constant_beside_a_walk_comes_to_rest_and_one_by_itself_does_not() {
    let beside = |f: [f64; 3], h: [[f64; 3]; 2], v: [f64; 3], start: f64| {
        with(|p| {
            (p.states, p.inputs, p.start) = (3, 0, start);
            (0..3).for_each(|i| (p.f[i], p.v[i]) = (UpTo::default(), UpTo::default()));
            (0..3).for_each(|i| (p.f[i][i], p.v[i][i]) = (f[i], v[i]));
            (p.readings, p.h[0], p.h[1]) = (if h[1] == [0.0; 3] { 1 } else { 2 }, h[0].into(), h[1].into());
            p.w = [[0.2, 0.0], [0.0, 0.2]].map(UpTo::from).into();
        })
    };
    let sum = [[1.0; 3], [0.0; 3]];
    for params in [
        beside([0.9, 1.0, 1.0], sum, [0.1, 0.001, 0.0], 1.0),
        beside([0.9, 1.0, 1.0], sum, [0.1, 0.01, 0.0], 1.0),
        beside([1.0, 0.9, 1.0], sum, [0.0, 0.1, 0.001], 2.0),
        beside([1.0, 0.5, 1.0], [[1.0, 0.0, 1.0], [0.0; 3]], [0.0, 0.1, 0.001], 1.0),
    ] {
        let frame = open(params);
        assert!(!frame.slowly && !frame.doubled.averages && frame.doubled.depends_on_start, "{frame:?}");
        let limit = frame.limit_p.expect("a limit");
        let far = stepped(&params, 20_000);
        (0..3).for_each(|i| assert!((far[(i, i)] - limit[i][i]).abs() < 1e-9, "{far} {limit:?}"));
        // It is within a hundredth of its limit after as many steps as are said, and not before.
        let off = |steps: f64| {
            let p = stepped(&params, steps as usize + 1);
            (0..3).map(|i| (p[(i, i)] / far[(i, i)] - 1.0).abs()).fold(0.0, f64::max)
        };
        let near = frame.near.expect("it comes near");
        assert!(near > 1.0 && near < 1000.0 && off(near) <= 0.01 && off(0.0) > 0.01, "{near} {}", off(near));
    }
    let params = beside([0.9, 0.5, 1.0], sum, [0.1, 0.001, 0.0], 1.0);
    let [one, two] = [4000, 8000].map(|steps| stepped(&params, steps)[(2, 2)]);
    assert!((one / two - 2.0).abs() < 0.1, "each reading counts: {one} {two}");
    let frame = open(params);
    assert!(frame.slowly || frame.near.is_none() && frame.doubled.averages, "{frame:?}");
}

#[test]
fn rates_that_are_given_as_a_step_are_asked_about_until_they_are_ticked() {
    let motor = |continuous: bool| {
        open(with(|p| {
            (p.states, p.inputs, p.continuous, p.period) = (3, 0, continuous, 0.005);
            p.f = [[0.0, 1.0, 0.0], [0.0, -10.0, 5.0], [0.0, -1.0, -20.0]].map(UpTo::from).into();
            p.v = [[0.0, 0.0, 0.0], [0.0, 0.5, 0.0], [0.0, 0.0, 0.2]].map(UpTo::from).into();
            (p.h[0], p.w[0]) = ([1.0].into(), [1e-4].into());
        }))
    };
    assert!(motor(false).looks_like_rates && !motor(true).looks_like_rates);
    assert!(!open(OwnParams::default()).looks_like_rates && !open(height()).looks_like_rates);
}
