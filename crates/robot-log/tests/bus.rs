//! A car's bus: signals with rates of their own in one table, numbers that say that there is no value, stamps that are
//! called by their clock.

use estimate::drive::{Event, Row};
use robot_log::{Files, Role};

fn read(text: &str) -> (Vec<Row>, Vec<String>) {
    let mut files = Files::default();
    files.add("can.csv", text).expect("a file");
    let read = files.read().expect("sound");
    (read.log.drive.rows, read.notes)
}

fn speeds(rows: &[Row]) -> Vec<f64> {
    let speed = |event: &Event| match *event {
        Event::Speed { v } | Event::Velocity { v, .. } => Some(v),
        _ => None,
    };
    rows.iter().filter_map(|row| speed(&row.event)).collect()
}

/// Rows at 50 Hz, in every fifth of which there is a speed: what `v` gives.
fn table(v: impl Fn(usize) -> String) -> String {
    let row = |k: usize| {
        let speed = if k.is_multiple_of(5) { v(k / 5) } else { String::new() };
        format!("{:.2},{speed},{:.1}\n", 0.02 * k as f64, 10.0 * (0.01 * k as f64).sin())
    };
    format!("time [s],VehSpd [km/h],YawRate [deg/s]\n{}", (0..1000).map(row).collect::<String>())
}

#[test]
fn a_table_with_a_rate_for_each_signal_is_read_as_sensors() {
    let (rows, _) = read(&table(|k| format!("{:.2}", 36.0 + 0.1 * k as f64)));
    assert_eq!((speeds(&rows).len(), rows.len()), (200, 1000));
    assert!((speeds(&rows)[0] - 10.0).abs() < 1e-12);
    // One that is missing once is a fault of its row, as before.
    let missing = |k: usize| format!("{k},{},0.1\n", if k == 7 { "" } else { "1" });
    let mut files = Files::default();
    let text = format!("time_s,v,omega\n{}", (0..100).map(missing).collect::<String>());
    files.add("wheels.csv", &text).expect("a file");
    assert_eq!(files.files()[0].role(), Role::Velocities);
    assert_eq!(files.read().expect_err("a number is missing").line, 9);
}

#[test]
fn a_number_far_beyond_all_others_says_that_there_is_no_value() {
    for (odd, kinds) in [("655.35", 1), ("-655.36", 1), ("655.34", 2)] {
        let text = table(|k| match k {
            50..80 if kinds == 2 && k.is_multiple_of(2) => "655.35".into(),
            50..80 => odd.into(),
            _ => format!("{:.2}", 36.0 + 0.1 * k as f64),
        });
        let (rows, notes) = read(&text);
        let mut files = Files::default();
        files.add("can.csv", &text).expect("a file");
        let follows = files.files()[0].follows();
        assert!(follows.contains("v 10 \u{2026} 15.5 m/s"), "{follows}");
        assert_eq!(speeds(&rows).len(), 170, "{odd}");
        assert!(speeds(&rows).iter().all(|v| *v < 20.0));
        let said = notes.iter().find(|note| note.contains("as a bus writes where a sensor has no value"));
        assert!(said.is_some_and(|note| note.starts_with("The speed of 30 rows is left out: 182.0")), "{notes:?}");
        // What is held meanwhile is said, as of any gap.
        assert!(notes.iter().any(|note| note.starts_with("No speed from 4.9 to 8 s after the first row")), "{notes:?}");
    }
}

#[test]
fn what_may_be_a_speed_is_kept() {
    type Speeds = fn(usize) -> f64;
    let kept: [(&str, Speeds); 4] = [
        ("a car that accelerates", |k| 36.0 + k as f64),
        ("one that begins to move", |k| if k < 90 { 0.0 } else { 400.0 }),
        ("a plane", |k| if k < 90 { 200.0 } else { 500.0 }),
        ("noise", |k| if k < 190 { 36.0 } else { 300.0 + k as f64 }),
    ];
    for (what, v) in kept {
        let (rows, notes) = read(&table(|k| format!("{:.2}", v(k))));
        assert_eq!(speeds(&rows).len(), 200, "{what}: {notes:?}");
    }
}

#[test]
fn stamps_are_known_by_the_name_of_their_clock() {
    for (name, unit) in [("unix_ms", "ms"), ("epoch", "ms"), ("posix_ms", "ms"), ("unixtime", "ms")] {
        let mut files = Files::default();
        let text = format!("{name},lat,lon\n1764230400000,48.1,11.5\n1764230401000,48.1,11.5\n");
        files.add("gnss.csv", &text).expect("a file");
        let file = &files.files()[0];
        assert_eq!((file.role(), file.units()[0].map(|it| it.name)), (Role::Sensors, Some(unit)), "{name}");
    }
    let mut files = Files::default();
    files.add("gnss.csv", "tick_of,lat,lon\n1,48.1,11.5\n2,48.1,11.5\n").expect("a file");
    files.add("wheels.csv", "t,v,omega\n0,1,0\n1,1,0\n").expect("a file");
    let notes = files.read().expect("sound").notes;
    let said = "none of its columns is known for the time of its rows. If one is, say what the file is read as";
    assert!(notes.iter().any(|note| note.contains(said)), "{notes:?}");
}
