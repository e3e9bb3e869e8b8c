//! Tables as spreadsheets and other programs write them: decimal commas, other line ends, empty files, units that
//! nobody names. Each is read as it was meant, or refused with words that say what to do.

mod opened;

use estimate::drive::Event;
use opened::files;
use robot_log::{Files, Role, Understood};

fn read(of: &[(&str, &str)]) -> Understood {
    files(of).read().expect("sound")
}

/// Rows of a table, one for each of `count` tenths of a second.
fn rows(count: u32, row: impl Fn(f64) -> String) -> String {
    (0..count).map(|i| row(f64::from(i) / 10.0) + "\n").collect()
}

#[test]
fn a_decimal_comma_is_read_where_no_commas_part_the_fields() {
    let of = |text: String| read(&[("velocities.csv", &text)]).log;
    let plain = of(format!("time,v,omega\n{}", rows(20, |t| format!("{t},0.5,-0.25"))));
    for separator in [";", "\t", " ", "; ", ",\t"] {
        let comma = |number: f64| match separator {
            ",\t" => number.to_string(),
            _ => number.to_string().replace('.', ","),
        };
        let body = rows(20, |t| [t, 0.5, -0.25].map(comma).join(separator));
        let mut nameless = files(&[("velocities.csv", &body)]);
        assert!(nameless.set_role(0, Role::Velocities));
        assert_eq!(nameless.read().expect("sound").log, plain, "parted by {separator:?}");
        let head = ["time", "v", "omega"].join(separator);
        assert_eq!(of(format!("{head}\n{body}")), plain, "parted by {separator:?}, with a header");
    }
    let error = files(&[("wheels.csv", "time;v;omega\n1.000,5;1;0\n")]).read().expect_err("a point for thousands");
    assert_eq!((error.line, error.column, error.message.contains("'1.000,5'")), (2, 1, true), "{error}");
}

#[test]
fn a_separator_within_a_quoted_field_parts_nothing() {
    let body = rows(20, |t| format!("\"{t}\" , 0.5,0.1"));
    let plain = read(&[("wheels.csv", &format!("time,v,omega\n{body}"))]).log;
    for head in [r#""time","v, along","omega""#, r#" "time, s" ,v,"omega, ""z""""#] {
        assert_eq!(read(&[("wheels.csv", &format!("{head}\n{body}"))]).log, plain, "{head}");
    }
    let named = files(&[("wheels.csv", &format!("time,v,\"omega, \"\"z\"\"\"\n{body}"))]);
    assert_eq!(named.files()[0].header(), ["time", "v", "omega, \"z\""]);
    let open = files(&[("wheels.csv", &format!("time,v,\"omega, z\n{body}"))]).read().expect_err("not closed");
    assert!(open.message.contains("not closed"), "{open}");
}

#[test]
fn a_carriage_return_alone_ends_a_line() {
    let table = format!("time,v,omega\n{}", rows(20, |t| format!("{t},0.5,0.1")));
    assert_eq!(read(&[("wheels.csv", &table.replace('\n', "\r"))]), read(&[("wheels.csv", &table)]));
    let own = "L,7,3,4\nO,0.5,0.1,0\nR,1,7,4.9\n";
    assert_eq!(read(&[("mine.csv", &own.replace('\n', "\r"))]), read(&[("mine.csv", own)]));
    let error = files(&[("mine.csv", "O,0,0,0\rO,1,x,0\r")]).read().expect_err("a fault in the second line");
    assert_eq!((error.line, error.column), (2, 5), "{error}");
}

#[test]
fn an_empty_file_and_a_table_without_rows_are_named() {
    let motion = ("wheels.csv", "time,v,omega\n0,1,0\n1,1,0\n");
    for text in ["", "\u{feff}", "\r\n \n"] {
        let error = files(&[motion, ("map.csv", text)]).read().expect_err("empty");
        assert_eq!((error.file, error.message.as_str()), (1, "the file is empty"), "{text:?}");
    }
    let mut unused = files(&[motion, ("map.csv", "")]);
    assert!(
        unused.set_role(1, Role::Unused) && unused.read().is_ok(),
        "an empty file that is not used does not matter"
    );
    let error = files(&[("wheels.csv", "time,v,omega\n")]).read().expect_err("no rows");
    assert_eq!((error.file, error.message.as_str()), (0, "the file has no row of numbers"));
    assert!(files(&[motion, ("seen.csv", "time,landmark,range\n")]).read().is_ok(), "a robot may have seen nothing");
}

#[test]
fn a_unit_that_no_name_says_is_asked_where_numbers_are_too_large_for_metres() {
    let body = rows(20, |t| format!("{t},50,4"));
    let mut odometry = files(&[("odo.csv", &format!("time,distance,turn\n{body}"))]);
    let units: Vec<_> = odometry.files()[0].units().iter().map(|unit| unit.map(|unit| unit.name)).collect();
    assert_eq!(units, [Some("s"), None, Some("deg"), None, None], "50 m and 4 rad in a tenth of a second are too much");
    assert_eq!(odometry.files()[0].asks(), ["In which unit is \u{201c}distance\u{201d}?"]);
    assert!(odometry.read().is_err() && odometry.set_unit(0, "distance", "mm"));
    assert_eq!(odometry.files()[0].follows(), "10 Hz, 0 to 1.9 s, 1 m of way, turned 0.222 turns");
    let seen = files(&[("radio.csv", "time,beacon,range\n0,1,2500\n1,1,480\n")]);
    assert_eq!(seen.files()[0].asks(), ["In which unit is \u{201c}range\u{201d}?"]);
}

#[test]
fn sightings_of_unknown_landmarks_ask_for_the_list_of_barcodes() {
    let of = [
        ("odometry.csv", "t,v,omega\n0,1,0\n1,1,0\n"),
        ("seen.csv", "t,id,range\n0.5,63,2\n"),
        ("landmarks.csv", "id,x,y\n6,1,2\n"),
    ];
    let error = files(&of).read().expect_err("63 is a barcode");
    assert_eq!((error.file, error.line, error.column), (1, 2, 5));
    assert!(error.message.contains("no landmark 63") && error.message.contains("barcodes"), "{error}");
}

#[test]
fn times_that_cannot_belong_together_are_noted() {
    let motion = ("odometry.csv", "t,v,omega\n0,1,0\n1,1,0\n");
    let truth = ("truth.csv", "t,x,y,theta\n1700000000,0,0,0\n1700000001,1,0,0\n");
    let notes = read(&[motion, truth]).notes;
    assert!(
        notes.len() == 1 && notes[0].starts_with("The true positions are all before the motion or after it"),
        "{notes:?}"
    );
    let seen = ("seen.csv", "t,id,range\n-5,6,2\n-4,6,2\n");
    let notes = read(&[motion, seen, ("landmarks.csv", "id,x,y\n6,1,2\n")]).notes;
    assert!(notes.len() == 1 && notes[0].starts_with("The ranges of seen.csv are all before the motion"), "{notes:?}");
    let notes = read(&[("odometry.csv", "t,v,omega\n0.05,0,0.01\n0.05,0.1,0.01\n")]).notes;
    assert!(notes.len() == 1 && notes[0].contains("the same time"), "{notes:?}");
    assert!(read(&[motion]).notes.is_empty());
}

#[test]
fn swapped_columns_are_known_by_their_names_and_corrected_without_names() {
    let named = read(&[("wheels.csv", "omega,time,v\n0.1,0,0.5\n0.1,1,0.5\n")]).log;
    let mut files = files(&[("odometry.csv", "0.1,0,0.5\n0.1,1,0.5\n")]);
    assert!(files.set_role(0, Role::Velocities));
    for (value, column) in [("time", 1), ("v", 2), ("omega", 0)] {
        assert!(files.set_column(0, value, Some(column)));
    }
    assert_eq!(files.read().expect("sound").log, named);
    assert_eq!(named.drive.rows[1].event, Event::Velocity { v: 0.5, omega: 0.1 });
}

#[test]
fn tabs_part_a_table_whose_numbers_have_decimal_commas_and_whose_days_are_dates() {
    let heads = [
        "Datum\tUhrzeit\tGeschwindigkeit (m/s)\tDrehrate (rad/s)\tBemerkung",
        "Datum\tUhrzeit\tGeschwindigkeit, m/s\tDrehrate, rad/s\tBemerkung, frei",
    ];
    for head in heads {
        let mut text = format!("{head}\n");
        for i in 0..6 {
            text += &format!("13.05.2026\t12:00:0{i},5\t0,{i}5\t0,0{i}\tgut, oder\n");
        }
        let mut files = Files::default();
        files.add("fahrt.txt", &text).expect("small");
        let file = &files.files()[0];
        assert_eq!(file.header(), head.split('\t').collect::<Vec<_>>());
        assert_eq!(file.asks(), Vec::<String>::new());
        let read = files.read().expect("sound");
        assert_eq!(read.log.drive.rows[3].event, Event::Velocity { v: 0.35, omega: 0.03 });
        assert_eq!(read.log.drive.rows[1].time - read.log.drive.rows[0].time, 1.0);
    }
}

#[test]
fn what_a_spreadsheet_writes_for_no_number_is_a_missing_value() {
    let words = ["#N/A", "#NV", "#WERT!", "n/a", "-", "#DIV/0!", "#NAME?", "#N/D", "###", ""];
    for word in words {
        // In the first row as well, and at its beginning.
        let text = format!("x,time,v,omega,y\n{word},0,0.5,{word},{word}\n1,1,0.5,0.1,2\n{word},2,0.5,{word},{word}\n");
        let mut files = Files::default();
        files.add("gps.csv", &text).expect("small");
        assert!(files.set_role(0, Role::Sensors));
        let rows = files.read().expect(word).log.drive.rows;
        let events: Vec<Event> = rows.iter().map(|row| row.event).collect();
        let speed = Event::Speed { v: 0.5 };
        let fix = Event::Position { x: 1.0, y: 2.0, sigma: None };
        assert_eq!(events, [speed, Event::Velocity { v: 0.5, omega: 0.1 }, fix, speed], "{word}");
        // A value that a row needs is missing, whatever is written for it.
        let mut wheels = Files::default();
        wheels.add("wheels.csv", &format!("time,v,omega\n0,0.5,0\n1,{word},0\n")).expect("small");
        let refused = wheels.read().expect_err(word);
        assert_eq!((refused.line, refused.message.as_str()), (3, "v is missing; a number was expected"), "{word}");
        // And a table without names begins with a row of numbers all the same.
        let mut nameless = Files::default();
        nameless.add("rows.csv", &format!("0,0.5,{word}\n1,0.5,0.1\n2,0.5,0.1\n")).expect("small");
        assert_eq!(nameless.files()[0].header()[0], "column 1", "{word}");
    }
}
