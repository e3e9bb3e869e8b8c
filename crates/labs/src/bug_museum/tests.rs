use super::*;
use crate::true_path::{sensor_covariance, squares};
use estimate::kf::Gaussian;
use estimate::landmarks::RangeBearing;
use estimate::{Localizer, Unicycle};
use filters::MeasurementModel;
use filters::consistency::nis;
use geom::Ellipse;
use nalgebra::Matrix2;

fn at(params: MuseumParams, steps: u32) -> BugMuseum {
    BugMuseum::from_state(lab::State { params, step: steps }).expect("within the limit")
}

fn with(bug: Bug) -> MuseumParams {
    MuseumParams { bug, ..MuseumParams::default() }
}

#[test]
fn without_a_bug_the_filter_has_the_bits_of_the_core_s_ekf() {
    let mut lab = at(MuseumParams::default(), 0);
    let mut ekf = Localizer::new(&Gaussian { x: lab.filter.x, p: squares(BUG_MUSEUM.p0_sigma) });
    let input = Matrix2::from_diagonal(&Vector2::from(BUG_MUSEUM.u_sigma.map(|s| s * s)));
    let (model, w) = (RangeBearing { map: &BUG_MUSEUM.landmarks }, sensor_covariance(&BUG_MUSEUM.sensor));
    let mut used = 0;
    for k in 0..BUG_MUSEUM.steps {
        let (tick, mut noise) = (BUG_MUSEUM.course.tick(k), lab.noise.clone());
        let [ahead, turn] = BUG_MUSEUM.u_sigma.map(|sigma| sigma * noise.normal());
        let v = Unicycle::process_covariance(&ekf.pose(), &input);
        ekf.predict(&Vector2::new(tick.ds + ahead, tick.dtheta + turn), &v).expect("finite");
        lab.step().expect("within the limit");
        if let Some(seen) = lab.readings.back().expect("one a step") {
            let (j, y) = (seen.landmark as usize, Vector2::new(seen.range, seen.bearing));
            let (expected, h) = model.linearized(&ekf.pose(), j).expect("clear of the landmarks");
            let s = filters::linear::innovation_covariance(&h, ekf.covariance(), &w);
            if nis(&model.residual(&y, &expected), &s).expect("positive definite") <= BUG_MUSEUM.gate {
                ekf.update(&model, &estimate::Sighting { j, y }, &w).expect("positive definite");
                used += 1;
            }
        }
        assert_eq!((ekf.pose().to_vector(), *ekf.covariance()), (lab.filter.x, lab.filter.p), "step {k}");
    }
    assert!(used > 100, "{used}");
}

#[test]
fn the_drive_and_its_readings_are_the_same_with_every_bug() {
    let right = at(MuseumParams::default(), 100);
    for bug in Bug::ALL {
        let wrong = at(with(bug), 100);
        assert_eq!((right.truth, &right.readings), (wrong.truth, &wrong.readings), "{bug:?}");
        assert_ne!(right.digest(), wrong.digest(), "{bug:?}");
    }
}

#[test]
fn a_bug_does_what_it_says() {
    let at = |bug| at(with(bug), BUG_MUSEUM.steps);
    assert!(at(Bug::UnwrappedHeading).filter.x[2] > 9.0 * core::f64::consts::PI, "five laps");
    let asymmetry = |bug| at(bug).figures()[13];
    assert_eq!(asymmetry(Bug::None), 0.0);
    assert!((1e-18..1e-12).contains(&asymmetry(Bug::Asymmetric)), "{}", asymmetry(Bug::Asymmetric));
    assert!(at(Bug::ShortForm).figures()[12] < 0.0, "a covariance that is none");
    let [once, twice] = [Bug::None, Bug::Twice].map(|bug| at(bug).seen.step.len());
    assert_eq!(twice, 2 * once, "each reading of the run is there twice");
    let refused = |bug| at(bug).seen.used.iter().filter(|used| *used == 0.0).count();
    assert!(refused(Bug::None) > 0 && refused(Bug::OpenGate) == 0);
    let late = BugMuseum::new(with(Bug::Late)).and_then(|mut lab| lab.run(2).map(|()| lab)).expect("within the limit");
    assert!(late.last.is_empty() && late.readings.iter().any(Option::is_some), "nothing has come yet");
}

#[test]
fn an_outlier_is_refused_by_the_right_filter() {
    let lab = at(MuseumParams::default(), BUG_MUSEUM.steps);
    let far = lab.seen.nis.iter().zip(lab.seen.used.iter()).filter(|(nis, _)| *nis > 50.0);
    let (count, used) = far.fold((0, 0.0), |(count, sum), (_, used)| (count + 1, sum + used));
    assert!(count > 2 && used == 0.0, "{count} {used}");
}

/// Any two bugs together, far beyond a run: every number that is recorded is one, up to the figures that have none.
#[test]
fn any_two_bugs_run_on_and_keep_their_memory() {
    for (i, bug) in Bug::ALL.into_iter().enumerate() {
        for second in Bug::ALL.into_iter().skip(i) {
            let lab = at(MuseumParams { bug, second, ..MuseumParams::default() }, 1200);
            assert!(numerics::all_finite(lab.filter.x.iter().chain(lab.filter.p.iter())), "{bug:?} {second:?}");
            let frame = lab.frame();
            assert_eq!((frame.series.step.len(), frame.figures.len()), (lab::WINDOW, FIGURES));
            let Ellipse { semi_major, semi_minor, angle } = frame.ellipse;
            assert!(numerics::all_finite(&[semi_major, semi_minor, angle]), "{bug:?} {second:?}: {:?}", frame.ellipse);
        }
    }
}

#[test]
fn what_the_lot_has_drawn_is_in_the_frame_once_the_reader_has_committed() {
    for lot in 1..200 {
        let hidden = MuseumParams { lot, pair: lot % 2 == 0, guess: Bug::Late, ..MuseumParams::default() };
        let [bug, second] = bugs(&hidden);
        assert!(bug != Bug::None && bug != second && (second == Bug::None) == (lot % 2 == 1), "{bug:?} {second:?}");
        let lab = at(hidden, 30);
        let frame = lab.frame();
        assert_eq!((frame.answer, frame.params), (None, hidden));
        let open = at(MuseumParams { bug, second, ..MuseumParams::default() }, 30);
        assert_eq!(open.digest(), lab.digest(), "the same run as with the switches");
        let named = |guess, second_guess| {
            let params = MuseumParams { guess, second_guess, committed: true, ..hidden };
            at(params, 1).frame().answer.expect("committed").right
        };
        assert!(named(bug, second) && (!hidden.pair || named(second, bug)));
        assert!(!named(Bug::None, second) && (!hidden.pair || !named(bug, bug)));
    }
    let mut drawn: Vec<Bug> = (1..200).map(|lot| bugs(&MuseumParams { lot, ..MuseumParams::default() })[0]).collect();
    drawn.sort_by_key(|bug| *bug as u8);
    drawn.dedup();
    assert_eq!(drawn.len(), Bug::ALL.len(), "the lot draws every bug");
    for deck in [0, 5, 330_382_098] {
        let lots = deck * 13 + 1..=deck * 13 + 13;
        let mut cards: Vec<Bug> = lots.map(|lot| bugs(&MuseumParams { lot, ..MuseumParams::default() })[0]).collect();
        cards.sort_by_key(|bug| *bug as u8);
        assert_eq!(cards, Bug::ALL, "deck {deck} has each bug once");
    }
    let open = MuseumParams { bug: Bug::Late, committed: true, ..MuseumParams::default() };
    assert_eq!(at(open, 1).frame().answer, None, "there was no lot");
}

#[test]
fn in_an_ensemble_a_step_is_the_run_of_a_seed() {
    let one = at(MuseumParams { seed: 5, ..with(Bug::Twice) }, BUG_MUSEUM.steps);
    let many = at(MuseumParams { seed: 5, many: true, ..with(Bug::Twice) }, 30);
    assert_eq!((many.filter, many.figures()), (one.filter, one.figures()), "the panels show the first");
    let runs: Vec<Figures> = (5..35).map(|seed| museum_run([Bug::Twice, Bug::None], seed).expect("computed")).collect();
    assert_eq!((many.seeds.count, many.seeds.shares()), (30, Symptoms::of(&runs).beyond));
    for (i, figure) in many.frame().figures.iter().enumerate() {
        assert!(figure.runs.iter().eq(runs.iter().map(|run| run[i])), "figure {i}");
        assert_eq!(figure.counts.iter().sum::<u32>(), 30);
        let within: u32 = figure.counts[10..20].iter().sum();
        let [below, above] = figure.beyond;
        // A value at an end of the band may count to either side of it.
        assert!((f64::from(within) - 30.0 * (1.0 - below - above)).abs() < 1.5, "figure {i}: {:?}", figure.counts);
    }
    let mut full = at(MuseumParams { many: true, ..MuseumParams::default() }, SEEDS);
    let counted = (full.seeds.clone(), full.digest());
    full.run(50).expect("within the limit");
    assert_eq!(
        (full.seeds.clone(), full.digest(), full.step),
        (counted.0, counted.1, SEEDS + 50),
        "there are 500 seeds"
    );
}

#[test]
fn a_state_is_all_it_takes() {
    for bug in [Bug::None, Bug::Late, Bug::FrozenJacobian, Bug::UnwrappedHeading] {
        let lab = at(MuseumParams { seed: 9, ..with(bug) }, 300);
        let mut again = BugMuseum::from_state(lab::State { step: 120, ..lab.state() }).expect("a state of its own");
        again.run(180).expect("within the limit");
        assert_eq!(again.digest(), lab.digest());
    }
}

#[test]
fn on_the_scale_of_a_figure_the_band_is_the_middle_third_and_farther_is_farther() {
    for (i, [least, low, high, greatest]) in bands::BANDS.into_iter().enumerate().take(FIGURES - 1) {
        let width = high - low;
        let values = [
            -1e300,
            low - 9.0 * width,
            low - width,
            least,
            low,
            0.5 * (low + high),
            high,
            greatest,
            high + width,
            1e300,
        ];
        let places = values.map(|value| scale::place(i, value));
        assert!(places.is_sorted() && places[0] >= 0.0 && places[9] <= 3.0, "figure {i}: {places:?}");
        for (at, expected) in [(2, 0.5), (4, 1.0), (5, 1.5), (6, 2.0), (8, 2.5)] {
            assert!((places[at] - expected).abs() < 1e-9, "figure {i}: {places:?}");
        }
    }
    assert_eq!([0.0, 1e-17].map(|value| scale::place(FIGURES - 1, value)), [1.5, 3.0], "a band without width");
    assert_eq!([f64::NAN, f64::INFINITY, f64::NEG_INFINITY].map(|value| scale::place(0, value)), [3.0, 3.0, 0.0]);
}

/// What the question "A colleague's filter" says of the bug.
#[test]
fn standard_deviations_for_variances_leave_a_sixth_of_the_nis_and_bearings_alike() {
    let mean = |bug, figure: usize| {
        let runs = museum_runs([bug, Bug::None], 0, 100).expect("sound");
        runs.iter().map(|figures| figures[figure]).sum::<f64>() / runs.len() as f64
    };
    for figure in [5, 6] {
        let part = mean(Bug::Deviation, figure) / mean(Bug::None, figure);
        assert!((1.0 / 7.0..1.0 / 5.0).contains(&part), "figure {figure}: {part}");
    }
    assert!(mean(Bug::Deviation, 11) > 0.15, "{}", mean(Bug::Deviation, 11));
    // What the wrong answers say: of a longer step's V the signs alternate, and degrees leave the ranges' NIS right.
    assert!(mean(Bug::StepLength, 11) < 0.0, "{}", mean(Bug::StepLength, 11));
    let range = mean(Bug::Degrees, 5) / mean(Bug::None, 5);
    assert!((range - 1.0).abs() < 0.2, "{range}");
}
