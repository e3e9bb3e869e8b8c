//! Files that are no log, each refused where it is wrong.

mod opened;

use opened::files;
use robot_log::{Error, Files};

/// Refused in this file at this line and character, with these words.
fn assert_refused(files: &Files, file: usize, at: [u32; 2], words: &str) {
    let error: Error = files.read().expect_err(words);
    assert_eq!((error.file, [error.line, error.column]), (file, at), "{error}");
    assert!(error.message.contains(words), "{error}");
}

#[test]
fn a_header_that_is_cut_off_or_endless_is_refused_at_its_name() {
    let cut = "\"time\",\"v\",\"ome";
    assert_refused(&files(&[("cut.csv", cut)]), 0, [1, 12], "quotes of the column's name are not closed");
    assert_refused(&files(&[("cut.csv", "# one\ntime;'v\n0;1\n")]), 0, [2, 6], "not closed");
    let long = format!("time,v,{}\n0,1,2\n", "å".repeat(5_000_000));
    assert_refused(&files(&[("long.csv", &long)]), 0, [1, 8], "more than 200 bytes");
    // A name may be as long as 200 bytes, and may end within a letter of two bytes when it is cut.
    let fits = format!("time,v,omega,{}\n0,1,2,3\n", "a".repeat(200));
    assert!(files(&[("fits.csv", &fits)]).read().is_ok());
    let odd = format!("time,v,omega,a{}\n0,1,2,3\n", "å".repeat(200));
    assert_refused(&files(&[("odd.csv", &odd)]), 0, [1, 14], "more than 200 bytes");
}

#[test]
fn unix_times_in_small_units_are_named() {
    for (time, unit) in [("1790000000000", "milli"), ("1790000000000000", "micro"), ("1790000000000000000", "nano")] {
        let text = format!("O,{time},0.1,0\n");
        assert_refused(&files(&[("mine.csv", &text)]), 0, [1, 3], &format!("looks like a Unix time in {unit}seconds"));
    }
    assert_refused(&files(&[("mine.csv", "O,9e99,0.1,0\n")]), 0, [1, 3], "times within 1e11 s were expected");
}

#[test]
fn too_many_files_are_refused() {
    let mut files = Files::default();
    for i in 0..robot_log::MAX_FILES {
        files.add(&format!("{i}"), "O,0,0,0\n").expect("few");
    }
    let error = files.add("one more", "").expect_err("too many");
    assert_eq!((error.file, error.line), (robot_log::MAX_FILES, 0), "{error}");
    assert!(error.message.contains("at most 16 files"), "{error}");
    assert_eq!(files.files().len(), robot_log::MAX_FILES);
}

#[test]
fn beside_a_counter_of_milliseconds_the_digits_of_a_clock_are_asked_for() {
    // Two seconds over a minute's end: as one number the clock's digits would jump by 42 s.
    let rows = [(123_859_000, 59_000), (123_859_500, 59_500), (123_900_000, 60_000), (123_900_500, 60_500)];
    let row = |(clock, millis): &(u32, u32)| format!("260314,{clock},13958375{millis}.25,0.1,2.0,51.0,13.7\n");
    let text =
        format!("date,time,millis,yawrate,speed,latitude,longitude\n{}", rows.iter().map(row).collect::<String>());
    let mut files = Files::default();
    files.add("car.csv", &text).expect("a table");
    assert!(files.files()[0].asks()[0].contains("“time” or “millis”"), "{:?}", files.files()[0].asks());
    assert!(files.set_column(0, "time", Some(2)));
    let drive = files.read().expect("a log").log.drive;
    assert_eq!(drive.span().map(|[first, last]| last - first), Some(1.5));
}

#[test]
fn a_laser_scan_and_printed_messages_are_refused_with_the_reason() {
    let of = |name: &str| {
        let text = std::fs::read_to_string(format!("{}/../../tests/logs/{name}", env!("CARGO_MANIFEST_DIR")));
        files(&[(name, &text.expect(name))]).read().expect_err(name).message
    };
    assert!(of("scan.csv").contains("scan.csv is not used: a laser scan does not say which landmark it saw"));
    assert!(of("echo.yaml").contains("`ros2 topic echo --csv TOPIC > FILE`"));
}
