use super::*;

fn with(params: TuneParams) -> Tune {
    Tune::new(params).expect("sound parameters")
}

#[test]
fn the_truth_is_sealed_until_the_reader_commits() {
    let open = with(TuneParams::default()).frame();
    assert!(open.fit.is_none() && open.verdict.is_none());
    let fitted = with(TuneParams { fit: true, ..Default::default() }).frame();
    assert!(fitted.fit.is_some() && fitted.verdict.is_none());
    let committed = with(TuneParams { committed: true, ..Default::default() }).frame();
    let (fit, verdict) = (committed.fit.expect("beside the truth"), committed.verdict.expect("committed"));
    assert_eq!(Some(fit), fitted.fit);
    assert_eq!(verdict.nees.len(), committed.innovations.len());
    assert!(verdict.lacking > 0.0 && verdict.log_likelihood < fit.log_likelihood);
}

/// At the truth the innovations are white and as large as S says; with V and W a hundredth, or a hundredfold, they are
/// not.
#[test]
fn the_panels_tell_right_noise_from_wrong() {
    let base = TuneParams { length: 1000, ..Default::default() };
    let [log_q, log_w] = with(base).log.truth;
    let right = with(TuneParams { log_q, log_w, ..base }).frame();
    let band = right.mean_nis_band.last().expect("the last reading");
    let mean = |frame: &TuneFrame| *frame.mean_nis.last().expect("readings");
    assert_eq!((band.readings, right.mean_nis.len(), right.autocorrelation.len()), (1000, 1000, 20));
    assert!((band.low..band.high).contains(&mean(&right)), "{} {band:?}", mean(&right));
    assert!((right.beyond - 0.0455).abs() < 0.025, "{}", right.beyond);
    // Of twenty lags one in twenty is expected outside, and five are hardly ever.
    let outside =
        |frame: &TuneFrame| frame.autocorrelation.iter().filter(|r| r.abs() > frame.autocorrelation_band).count();
    assert!(outside(&right) < 5, "{:?}", right.autocorrelation);
    let small = with(TuneParams { log_q: log_q - 1.0, log_w: log_w - 1.0, ..base }).frame();
    assert!(mean(&small) > 5.0 && small.beyond > 0.3);
    let smooth = with(TuneParams { log_q: -2.0, log_w: log_w + 0.5, ..base }).frame();
    assert!(smooth.autocorrelation[0] > 0.3, "a filter that trusts its motion leaves innovations alike");
}

#[test]
fn the_fit_is_the_top_of_the_map() {
    for seed in 1..6 {
        let lab = with(TuneParams { fit: true, seed, ..Default::default() });
        let fit = lab.frame().fit.expect("looked for");
        let map: Vec<f64> = (0..40).flat_map(|row| lab.likelihood_row(row, 40, 30).expect("within limits")).collect();
        let highest = map.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        assert!(fit.log_likelihood > highest && fit.log_likelihood < highest + 1.0, "{seed}: {fit:?} {highest}");
        // And the map is the likelihood that the frame shows at the same place.
        let (column, row) = (7, 25);
        let middle = |i: f64, of: f64| 2.0 * (2.0 * (i + 0.5) / of - 1.0);
        let (log_q, log_w) = (middle(7.0, 30.0), middle(25.0, 40.0));
        let there = with(TuneParams { log_q, log_w, seed, ..Default::default() }).frame().log_likelihood;
        assert_eq!(map[row * 30 + column].to_bits(), there.to_bits());
    }
}

#[test]
fn a_longer_log_tells_more() {
    let width =
        |length| with(TuneParams { length, fit: true, ..Default::default() }).frame().fit.and_then(|fit| fit.region);
    let [short, long] = [100, 1000].map(|length| width(length).expect("inside").semi_major);
    // As 1/√N, roughly.
    assert!((2.0..5.0).contains(&(short / long)), "{short} {long}");
}

#[test]
fn a_change_that_leaves_the_log_is_as_a_new_lab() {
    let changed = TuneParams { log_q: 0.5, fit: true, ..Default::default() };
    for params in [changed, TuneParams { length: 50, ..changed }, TuneParams { seed: 8, committed: true, ..changed }] {
        let mut lab = with(TuneParams::default());
        lab.run(3).expect("counts");
        lab.set(params).expect("sound");
        assert_eq!((lab.digest(), lab.steps(), lab.frame()), (with(params).digest(), 3, with(params).frame()));
        assert_eq!(lab.set(TuneParams { log_q: 9.0, ..params }).expect_err("beyond").code, Code::Limit);
        assert_eq!(lab.params(), &params);
    }
}

#[test]
fn a_shorter_log_is_the_beginning_of_a_longer_one() {
    let [short, long] = [20, 300].map(|length| with(TuneParams { length, ..Default::default() }).frame());
    assert_eq!(short.innovations, long.innovations[..20]);
    assert_eq!(short.mean_nis, long.mean_nis[..20]);
}

#[test]
fn a_parameter_or_a_row_out_of_bounds_is_refused_by_name() {
    let base = TuneParams::default();
    for (params, code, argument) in [
        (TuneParams { log_q: 2.1, ..base }, Code::Limit, "logQ"),
        (TuneParams { log_w: f64::NAN, ..base }, Code::NotFinite, "logW"),
        (TuneParams { length: 19, ..base }, Code::Limit, "length"),
        (TuneParams { length: 1001, ..base }, Code::Limit, "length"),
    ] {
        let error = Tune::new(params).expect_err(argument);
        assert_eq!((error.code, error.argument.as_ref()), (code, argument));
    }
    let lab = with(base);
    for (row, rows, columns, argument) in
        [(5, 5, 5, "row"), (0, 0, 5, "rows"), (0, 201, 5, "rows"), (0, 5, 201, "columns")]
    {
        let error = lab.likelihood_row(row, rows, columns).expect_err(argument);
        assert_eq!((error.code, error.argument.as_ref()), (Code::Limit, argument));
    }
    assert_eq!(lab.likelihood_row(199, 200, 200).expect("within limits").len(), 200);
}
