//! Two tables with positions: one may be the track that the other is held against, and that is asked.

mod opened;

use opened::files;
use robot_log::{Files, Role};
use std::fmt::Write;

const WHEELS: (&str, &str) = ("wheels.csv", "t,v,omega\n0,1,0\n1,1,0\n2,1,0\n");

/// Latitudes and longitudes, with a σ where one is said.
fn fixes(sigma: Option<&str>) -> String {
    let mut text = format!("time_s,latitude,longitude{}\n", if sigma.is_some() { ",accuracy_m" } else { "" });
    for i in 0..3 {
        let own = sigma.map(|sigma| format!(",{sigma}")).unwrap_or_default();
        let _ = writeln!(text, "{i},48.137{i},11.576{i}{own}");
    }
    text
}

fn asked(log: &Files) -> Vec<String> {
    log.files().iter().filter(|file| !file.asks().is_empty()).map(|file| file.name().to_string()).collect()
}

#[test]
fn of_two_tables_with_positions_that_which_may_be_the_truth_is_asked() {
    let [with, without, exact] = [fixes(Some("0.5")), fixes(None), fixes(Some("0.02"))];
    // Of the same text one would be left out.
    let other = without.replace("11.", "12.");
    for (others, wanted) in [
        // Without a σ, called so, with a much smaller σ.
        (vec![("gnss.csv", &with), ("t4.csv", &without)], vec!["t4.csv"]),
        (vec![("log_rtk.csv", &without), ("gnss.csv", &other)], vec!["log_rtk.csv"]),
        (vec![("one.csv", &with), ("two.csv", &exact)], vec!["two.csv"]),
        // Nothing tells them apart.
        (vec![("one.csv", &without), ("two.csv", &other)], vec!["one.csv", "two.csv"]),
        // Two receivers of one kind, and one alone.
        (vec![("one.csv", &with), ("two.csv", &with.replace("0.5", "0.4"))], vec![]),
        (vec![("log_rtk.csv", &without)], vec![]),
        // A truth is known.
        (vec![("gnss.csv", &with), ("t4.csv", &without), ("truth.csv", &other)], vec![]),
    ] {
        let all: Vec<_> =
            [WHEELS].into_iter().chain(others.iter().map(|(name, text)| (*name, text.as_str()))).collect();
        assert_eq!(asked(&files(&all)), wanted, "{others:?}");
    }
}

#[test]
fn an_answer_stays_and_answers_for_the_others() {
    let [with, without] = [fixes(Some("0.5")), fixes(None)];
    let mut log = files(&[WHEELS, ("gnss.csv", &with), ("t4.csv", &without)]);
    let words = &log.files()[2].asks()[0];
    assert_eq!(words, "Are its positions the true track, or what a sensor read? gnss.csv has positions, too.");
    assert_eq!(log.files()[2].answers(), [Role::Truth, Role::Sensors]);
    assert!(log.set_role(2, Role::Truth));
    assert!(log.read().is_ok_and(|read| read.log.drive.truth.position(1.0).is_some()));
    assert!(log.set_role(2, Role::Undecided));
    assert_eq!(asked(&log), ["t4.csv"], "the reader has taken the answer back");
    assert!(log.set_role(2, Role::Sensors));
    assert!(asked(&log).is_empty() && log.read().is_ok());
    log.add("notes.csv", "t,temperature\n0,20\n").expect("a table");
    assert!(asked(&log).is_empty(), "it was said");

    let mut log = files(&[WHEELS, ("one.csv", &without), ("two.csv", &without.replace("11.", "12."))]);
    assert_eq!(asked(&log).len(), 2);
    assert!(log.set_role(2, Role::Truth));
    assert!(asked(&log).is_empty(), "{:?}", asked(&log));
    assert_eq!(log.files()[1].role(), Role::Sensors);
}
