//! Each program that a text may begin as is what it is meant to be, and a text of the reader's own takes its place.

use super::*;
use lab::{Knob, Plain, Shape, Written};

const BUGS: [(Begin, &str); 9] = [
    (Begin::UnwrappedInnovation, "unwrapped-innovation"),
    (Begin::UnwrappedHeading, "unwrapped-heading"),
    (Begin::WrongDerivative, "wrong-derivative"),
    (Begin::Transposed, "transposed"),
    (Begin::Degrees, "degrees"),
    (Begin::Deviation, "deviation"),
    (Begin::StepLength, "step-length"),
    (Begin::ShortForm, "short-form"),
    (Begin::Twice, "twice"),
];

fn written(begin: Begin, text: Option<&str>) -> WriteFrame {
    let text = text.map(|text| Written::new(text).expect("it fits"));
    WriteFilter::at((), WriteParams { begin, text, ..WriteParams::default() }, 30).expect("a run").frame()
}

#[test]
fn each_program_is_what_it_begins_as() {
    for begin in [Begin::Kalman, Begin::Joseph, Begin::Short, Begin::Ekf, Begin::Asymmetric] {
        let frame = written(begin, None);
        assert_eq!(frame.outcome, Verdict::Right, "{begin:?} {:?}", frame.sentences);
        assert!(frame.stopped.is_none());
        // Beside the right filter, whose form is another, to rounding.
        let off = |(a, b): (&f64, &f64)| (a - b).abs() < 1e-9;
        assert!(frame.estimate.iter().zip(&frame.right).all(off), "{begin:?}");
    }
    assert!(written(Begin::Kalman, None).breaks && !written(Begin::Joseph, None).breaks);
    for (begin, bug) in BUGS {
        let frame = written(begin, None);
        assert_eq!((frame.outcome, frame.bug), (Verdict::Bug, Some(bug)), "{:?}", frame.sentences);
        assert!(frame.line.is_some());
    }
    let asymmetric = written(Begin::Asymmetric, None);
    assert!(
        asymmetric.sentences.iter().any(|said| said.contains("“P is not symmetric”")),
        "{:?}",
        asymmetric.sentences
    );
    for begin in [Begin::Forget, Begin::Observer, Begin::MendFirst, Begin::MendSecond, Begin::MendThird, Begin::Fixed] {
        assert_eq!(written(begin, None).outcome, Verdict::Wrong, "{begin:?}");
    }
    for begin in [Begin::Empty, Begin::Fill, Begin::Extend, Begin::Information, Begin::Sequential] {
        let frame = written(begin, None);
        assert_ne!(frame.outcome, Verdict::Right, "{begin:?} {:?}", frame.sentences);
    }
}

#[test]
fn a_heading_that_is_not_wrapped_is_said_to_do_what_it_does() {
    let greatest = |text| {
        let params = WriteParams { begin: Begin::UnwrappedHeading, text, ..WriteParams::default() };
        let mut lab = WriteFilter::new(params).expect("a lab");
        let mut greatest = 0.0_f64;
        for _ in 0..240 {
            lab.step().expect("within the limit");
            greatest = greatest.max(lab.frame().estimate[2].abs());
        }
        let said = lab.frame().sentences.join(" ");
        assert!(said.contains("where the motion does not wrap it either, it grows from lap to lap"), "{said}");
        greatest
    };
    let pi = core::f64::consts::PI;
    assert!(greatest(None) > 9.0 * pi, "five laps");
    // Where f wraps, only the last correction can carry it beyond ±π.
    let wrapping = Begin::Ekf.text().replace("x[3] = wrap(x[3])\n", "");
    let most = greatest(Some(Written::new(&wrapping).expect("it fits")));
    assert!(most > pi && most < 1.1 * pi, "{most}");
}

#[test]
fn no_line_of_a_program_is_longer_than_its_box() {
    let Shape::Word(words) = Begin::SHAPE else { panic!("Begin is a word") };
    for (i, word) in words.iter().enumerate() {
        let text = Begin::read(&mut [i as f64].iter()).text();
        assert!(text.lines().all(|line| line.len() <= 42), "{word}: {text}");
    }
}

#[test]
fn an_observer_is_known_by_its_numbers() {
    let frame = written(Begin::Observer, None);
    let observer = frame.observer.expect("its gain is fixed");
    assert!((observer.gain[0] - 0.5).abs() < 1e-12 && (observer.gain[1] - 0.3).abs() < 1e-12);
    assert!(observer.honest && observer.radius < 0.9, "{observer:?}");
    assert!(frame.sentences.iter().any(|said| said.contains("fixed gain [0.5; 0.3]")), "{:?}", frame.sentences);
    let still = written(Begin::Fixed, None).observer.expect("its gain is zero");
    assert!(still.radius >= 1.0, "{still:?}");
    assert!(written(Begin::Kalman, None).observer.is_none());
}

#[test]
fn an_own_text_takes_its_place_and_faults_stop_the_run() {
    let frame = written(Begin::Kalman, Some("x = F x + (\nP = q"));
    assert_eq!(frame.outcome, Verdict::Refused);
    assert!(frame.faults.len() >= 2, "{:?}", frame.faults);
    assert!(frame.stopped.is_some());
    let frame = written(Begin::Empty, Some("x = 1e9 F x\nP = V"));
    assert!(frame.stopped.is_some_and(|fault| fault.message.contains("left every bound")));
    assert!(frame.series.step.len() < 30);
}

#[test]
fn a_program_that_does_not_run_leaves_truth_and_right_filter_where_they_are() {
    let beside = |begin: Begin, text| {
        let WriteFrame { truth, right, right_ellipse, sighted, tracks, nees, ellipse, used, stopped, .. } =
            written(begin, text);
        (
            (truth, right, format!("{right_ellipse:?}"), sighted, tracks.truth.x),
            (nees, ellipse, used),
            stopped.is_some(),
        )
    };
    for (running, others) in [
        (Begin::Kalman, [(Begin::Fill, None), (Begin::Empty, None), (Begin::Empty, Some("x = 1e9 F x\nP = V"))]),
        (Begin::Ekf, [(Begin::Extend, None), (Begin::Ekf, Some("x = x + (")), (Begin::Ekf, Some("x = 1e9 x\nP = V"))]),
    ] {
        let (as_it_is, (nees, ..), stopped) = beside(running, None);
        assert!(nees.is_some() && !stopped);
        for (begin, text) in others {
            let (world, said, stopped) = beside(begin, text);
            assert!(stopped, "{begin:?} {text:?}");
            assert_eq!(world, as_it_is, "{begin:?} {text:?}");
            assert_eq!(said, (None, None, false), "{begin:?} {text:?}: nothing is said of it");
        }
    }
}

#[test]
fn a_text_for_another_count_of_states_is_refused_at_its_place() {
    let text = "x = F x + G u\nP = F P F' + V\nR = P H' / (H P H' + W)\nx = x + R (y - H x)\nP = (eye(4) - R H) P";
    let frame = written(Begin::Empty, Some(text));
    let [fault] = &frame.faults[..] else { panic!("one fault: {:?}", frame.faults) };
    assert_eq!((frame.outcome, fault.line, fault.column), (Verdict::Refused, 5, 6));
    assert!(fault.message.contains("eye(4) is 4×4 and R H is 2×2"), "{fault:?}");
    // Two readings are the judge's to give: the run alone ends.
    let frame = written(Begin::Sequential, None);
    assert!(frame.faults.is_empty() && frame.stopped.is_some(), "{:?}", frame.faults);
}

#[test]
fn letters_change_and_come_back() {
    let lab = WriteFilter::new(WriteParams { notation: Letters::Thrun, ..WriteParams::default() }).expect("a lab");
    assert!(lab.frame().text.starts_with("mu = A mu + B u\nSigma = A Sigma A' + R\n"));
    assert_eq!(lab.frame().outcome, Verdict::Right);
    assert_eq!(lab.text_in(Letters::Choset), Begin::Kalman.text());
}
