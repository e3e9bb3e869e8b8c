//! What is said of files that were opened together: what is there twice, what has another clock, what ends early.

use robot_log::{Files, Understood};

/// A boat that drives on for a minute, with fixes and a compass that end, begin and are shifted as a test says.
fn speeds() -> String {
    (0..600)
        .map(|i| format!("{:.1},1.5,0.01\n", f64::from(i) / 10.0))
        .fold("time,v,omega\n".into(), |all, row| all + &row)
}

fn fixes(until: f64) -> String {
    let times = (0..300).map(|i| f64::from(i) / 5.0).take_while(|t| *t < until);
    times
        .map(|t| format!("{t:.1},{:.3},{:.3},0.5\n", 1.5 * t, (0.7 * t).sin()))
        .fold("time,x,y,sigma\n".into(), |all, row| all + &row)
}

fn compass(from: f64) -> String {
    let row = |i: i32| format!("{:.1},{:.4}\n", from + f64::from(i) / 10.0, 0.001 * f64::from(i));
    (0..600).map(row).fold("time,heading_rad\n".into(), |all, row| all + &row)
}

fn read(of: &[(&str, &str)]) -> Understood {
    let mut files = Files::default();
    of.iter().for_each(|(name, text)| files.add(name, text).expect(name));
    files.read().expect("sound")
}

fn said(of: &[(&str, &str)], words: &str) -> bool {
    read(of).notes.iter().any(|note| note.contains(words))
}

#[test]
fn a_file_under_two_names_is_left_out_and_so_are_readings_that_are_there_twice() {
    let (motion, gps) = (speeds(), fixes(60.0));
    let once = [("speed.csv", &*motion), ("gps.csv", &*gps)];
    assert!(!said(&once, "are left out"), "{:?}", read(&once).notes);
    let copy = [once[0], once[1], ("gps (1).csv", &*gps)];
    assert!(said(&copy, "gps (1).csv is not used: it is the same as gps.csv."), "{:?}", read(&copy).notes);
    assert_eq!(read(&copy).log.drive, read(&once).log.drive);
    // One that another program has written anew is another file.
    let anew = gps.replace("0,", "00,");
    let twice = [once[0], once[1], ("gps (1).csv", &*anew)];
    assert!(said(&twice, "300 of 600 positions have the time and the values of another"), "{:?}", read(&twice).notes);
    // So are rows that one file has twice, wherever they stand.
    let doubled = format!("{gps}{}", gps.split_once('\n').expect("a header").1);
    assert!(said(&[once[0], ("gps.csv", &doubled)], "300 of 600 positions"));
    let events = |of: &[(&str, &str)]| read(of).log.drive.rows.iter().map(|row| row.event).collect::<Vec<_>>();
    for copied in [&twice[..], &[once[0], ("gps.csv", &*doubled)]] {
        assert_eq!(events(copied), events(&once));
    }
    // Four in three hundred may have been read twice.
    let few: String = gps.lines().take(5).skip(1).flat_map(|line| [line, "\n"]).collect();
    assert_eq!(events(&[once[0], ("gps.csv", &format!("{gps}{few}"))]).len(), events(&once).len() + 4);
}

#[test]
fn a_log_whose_times_are_all_the_same_is_looked_through_at_once() {
    let row = |i: u32| format!("5,{i},0,0.5\n");
    let stuck = (0..100_000).map(row).fold(String::from("time,x,y,sigma\n"), |all, row| all + &row);
    assert!(!said(&[("speed.csv", &*speeds()), ("gps.csv", &stuck)], "are left out"));
}

#[test]
fn a_sensor_of_another_clock_is_said_though_others_have_the_motion_s() {
    let (motion, gps) = (speeds(), fixes(60.0));
    let of = |compass: &str| {
        said(
            &[("speed.csv", &*motion), ("gps.csv", &*gps), ("compass.csv", compass)],
            "The headings of compass.csv are all",
        )
    };
    assert!(of(&compass(86_400.0)) && of(&compass(-86_400.0)) && !of(&compass(0.0)));
}

#[test]
fn a_sensor_that_ends_early_is_said_to() {
    let motion = speeds();
    let of = |until: f64| read(&[("speed.csv", &*motion), ("gps.csv", &*fixes(until))]).notes;
    let notes = of(20.0);
    let words = "The last of the positions is 19.8 s after the first row, and the log goes on to 59.9 s: ";
    assert!(notes.iter().any(|note| note.starts_with(words)), "{notes:?}");
    assert!(of(58.0).iter().all(|note| !note.starts_with("The last of")), "{:?}", of(58.0));
}

#[test]
fn a_buoy_is_a_landmark() {
    let ranges = "timestamp_ms,buoy,range_m\n1000,B1,36.1\n2000,B2,82.5\n3000,B1,35.0\n";
    let buoys = "buoy,x_m,y_m\nB1,-30,20\nB2,80,-20\n";
    let log = read(&[("speed.csv", &*speeds()), ("ranges.csv", ranges), ("buoys.csv", buoys)]).log;
    assert_eq!(log.drive.landmarks.len(), 2);
    assert_eq!(log.drive.rows.iter().filter(|row| !row.event.is_motion()).count(), 3);
}

#[test]
fn positions_that_begin_long_after_the_motion_are_said_where_no_truth_is() {
    let motion = speeds();
    let late: String = fixes(60.0)
        .lines()
        .enumerate()
        .filter(|(i, _)| *i == 0 || *i > 100)
        .fold(String::new(), |all, (_, line)| all + line + "\n");
    let words = "The first position is read 20.0 s after the first row: the estimate begins there";
    assert!(said(&[("speed.csv", &*motion), ("gps.csv", &late)], words));
    assert!(!said(&[("speed.csv", &*motion), ("gps.csv", &fixes(60.0))], "The first position is read"));
    let truth = "time_s,true_x,true_y,true_theta\n0,0,0,0\n30,30,0,0\n60,60,0,0\n";
    assert!(!said(&[("speed.csv", &*motion), ("gps.csv", &late), ("truth.csv", truth)], "The first position is read"));
}
