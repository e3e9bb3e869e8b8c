//! A library of small made-up files as programs write them, each with what is read from it, what it asks, or why it is
//! refused.

use estimate::drive::Event;
use robot_log::{Counting, Error, File, Files, Frame, Role};

/// How a reading of a file is read.
fn read_so(file: &File) -> String {
    let values = file.role().values().iter().zip(file.columns()).zip(file.units());
    let columns: Vec<String> = values
        .filter_map(|((value, column), unit)| {
            let unit = unit.map_or(String::new(), |unit| format!(" [{}]", unit.name));
            Some(format!("{} = {}{unit}", value.name, file.header()[(*column)?]))
        })
        .collect();
    let asks = file.asks();
    let asked = if asks.is_empty() { String::new() } else { format!("; asks: {}", asks.join(" ")) };
    let follows = file.follows();
    let followed = if follows.is_empty() { follows } else { format!("; {follows}") };
    format!("{}: {}{asked}{followed}", file.role().name(), columns.join(", "))
}

/// How a file is read, in one line, and after a bar how it is read once more.
fn told(name: &str, text: &str) -> String {
    let mut files = Files::default();
    files.add(name, text).expect(name);
    let all: Vec<String> = files.files().iter().map(read_so).collect();
    let read = files.read();
    let said = match &read {
        Ok(read) if read.notes.is_empty() => String::new(),
        Ok(read) => format!("; {}", read.notes.join(" ")),
        // Alone it has no motion, which the others of its log have.
        Err(Error { line: 0, .. }) => String::new(),
        Err(error) => format!("; refused: {error}"),
    };
    format!("{}{said}", all.join(" | ")).replace(": ;", ":").trim_end().to_string()
}

const FOLDER: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../tests/logs");

#[test]
fn each_file_of_the_library_is_read_as_it_was_meant_or_asks_or_is_refused() {
    let list = std::fs::read_to_string(format!("{FOLDER}/expected.txt")).expect("the list");
    let mut expected: Vec<(&str, &str)> = Vec::new();
    for block in list.split("\n\n").filter(|block| !block.trim().is_empty()) {
        expected.push(block.trim().split_once("\n    ").expect("a file's name, and a line below it"));
    }
    let there = std::fs::read_dir(FOLDER).expect("the folder").map(|entry| entry.expect("a file").file_name());
    let mut there: Vec<String> = there.map(|name| name.into_string().expect("a name")).collect();
    there.retain(|name| name != "expected.txt");
    there.sort();
    assert_eq!(there, expected.iter().map(|(name, _)| *name).collect::<Vec<_>>(), "one block for each file");
    let mut others = Vec::new();
    for (name, wanted) in expected {
        let bytes = std::fs::read(format!("{FOLDER}/{name}")).expect(name);
        let said = told(name, &String::from_utf8_lossy(&bytes));
        if said != wanted {
            others.push(format!("{name}\n    {said}\n"));
        }
    }
    assert!(others.is_empty(), "as they are read now:\n\n{}", others.join("\n"));
}

fn file(name: &str) -> Files {
    let mut files = Files::default();
    files.add(name, &std::fs::read_to_string(format!("{FOLDER}/{name}")).expect(name)).expect(name);
    files
}

#[test]
fn what_was_asked_and_is_said_is_read() {
    let mut encoders = file("encoders.csv");
    for (name, number) in [("ticks", 1000.0), ("radius", 0.1), ("base", 0.4)] {
        assert!(encoders.set_wheel(0, name, number), "{name}");
    }
    assert!(!encoders.set_wheel(0, "base", 0.0) && !encoders.set_wheel(0, "ticks", f64::NAN));
    assert!(encoders.read().is_err(), "totals or steps?");
    assert!(encoders.set_counting(0, Counting::Total));
    // 440 and 462 ticks of 0.2 pi / 1000 m.
    assert_eq!(encoders.files()[0].follows(), "20 Hz, 0.05 to 0.55 s, 0.283 m of way, turned 0.0055 turns");
    assert_eq!(encoders.read().expect("sound").log.drive.rows.len(), 11, "the first row has none before it");
    assert!(encoders.set_counting(0, Counting::Step));
    assert_eq!(encoders.read().expect("sound").log.drive.rows.len(), 12);

    let mut speeds = file("wheel-speeds.csv");
    assert!(speeds.set_wheel(0, "radius", 0.1) && speeds.set_wheel(0, "base", 0.5));
    let first = speeds.read().expect("sound").log.drive.rows[0].event;
    // Wheels alone turn it, until a gyro does too; fixes beside them do not.
    assert!(speeds.read().expect("sound").wheels);
    let mut beside = speeds.clone();
    beside.add("gps.csv", "t,x,y,sigma\n0.1,1,2,0.5\n0.2,1,2,0.5\n").expect("a file");
    assert!(beside.set_role(1, Role::Sensors) && beside.read().expect("sound").wheels);
    beside.add("gyro.csv", "t,omega\n0.1,0.2\n0.2,0.2\n").expect("a file");
    assert!(!beside.read().expect("sound").wheels);
    // 60 and 62 turns a minute of 0.2 pi m.
    let [left, right] = [60.0, 62.0].map(|turns| turns / 60.0 * core::f64::consts::TAU * 0.1);
    let Event::Velocity { v, omega } = first else { panic!("{first:?}") };
    assert!((v - (left + right) / 2.0).abs() < 1e-15 && (omega - (right - left) / 0.5).abs() < 1e-15);

    let mut fixes = file("east-north-sigma.csv");
    assert!(fixes.set_role(0, Role::Sensors));
    fixes.add("speeds.csv", "t,v,omega\n0,1,0\n").expect("a file");
    let drive = fixes.read().expect("sound").log.drive;
    assert!(drive.truth.poses().is_empty(), "a sensor is never the truth");
    assert!(drive.rows.iter().any(|row| matches!(row.event, Event::Position { sigma: Some(0.8), .. })));

    let mut compass = file("compass.csv");
    assert!(compass.set_unit(0, "heading", "deg from north"));
    compass.add("speeds.csv", "t,v,omega\n0,1,0\n").expect("a file");
    let headings = compass.read().expect("sound").log.drive.rows;
    let Event::Heading { theta, .. } = headings[1].event else { panic!("{headings:?}") };
    assert!((theta - (90.0_f64 - 350.0).to_radians()).abs() < 1e-15, "350 from north is 100 from east: {theta}");

    let mut gyroscope = file("phone-sensor-logger-gyroscope.csv");
    assert!(gyroscope.set_column(0, "omega", Some(2)));
    assert_eq!(gyroscope.files()[0].samples(2), ["0.1000", "0.1600", "0.2100"]);
    assert_eq!(gyroscope.files()[0].follows(), "100 Hz, 0.11 s long, turned 0.0026 turns");
    assert!(gyroscope.read().is_ok());
}

#[test]
fn two_receivers_have_one_origin() {
    let mut files = file("gnss-held.csv");
    files.add("truth.csv", "t,lat,lon\n0,48.1371,11.5754\n1,48.1372,11.5754\n").expect("a file");
    let drive = files.read().expect("sound").log.drive;
    let poses = drive.truth.poses();
    assert_eq!([poses[0].x, poses[0].y], [0.0, 0.0], "the first fix of all");
    // A ten-thousandth of a degree of latitude there is 11.12 m.
    assert!((poses[1].y - 11.12).abs() < 0.005, "{}", poses[1].y);
}

fn with(name: &str, others: &[(&str, &str)]) -> Files {
    let mut files = file(name);
    others.iter().for_each(|(name, text)| files.add(name, text).expect(name));
    files
}

#[test]
fn landmarks_with_names_are_numbered_in_all_files_alike_and_never_among_numbers() {
    let anchors = std::fs::read_to_string(format!("{FOLDER}/uwb-named-anchors.csv")).expect("the anchors");
    let motion = ("wheels.csv", "time,v,omega\n0,1,0\n1,1,0\n");
    let read = with("uwb-named-ranges.csv", &[motion, ("anchors.csv", &anchors)]).read().expect("sound");
    let kitchen = read.log.drive.landmarks.iter().position(|at| at.x == 0.0 && at.y == 0.0).expect("the kitchen");
    let first = read.log.drive.rows.iter().find_map(|row| match row.event {
        Event::Range { landmark, range } => Some((landmark, range)),
        _ => None,
    });
    assert_eq!(first, Some((kitchen, 2.5)));
    assert!(read.notes.iter().any(|note| note.contains("kitchen is 1, hall is 2, A3 is 3")), "{:?}", read.notes);
    let mixed = with("uwb-mixed-ranges.csv", &[motion]).read().expect_err("a number and a name");
    assert_eq!((mixed.line, mixed.column), (3, 5), "{mixed}");
}

#[test]
fn a_day_and_its_order_are_said_and_a_quaternion_is_of_length_1() {
    let mut days = file("date-time-ambiguous.csv");
    assert!(days.read().is_err() && days.set_unit(0, "day", "day, month, year"));
    let span = days.read().expect("sound").log.drive.span().expect("rows");
    assert_eq!(span[1] - span[0], 31.0 * 86_400.0 + 2.0, "from the fifth of January to the fifth of February");
    let mut turned = with("imu-with-place.csv", &[("wheels.csv", "time,v,omega\n0,1,0\n1,1,0\n")]);
    assert!(turned.set_role(0, Role::Sensors));
    assert!(turned.read().expect_err("0.1² + 0.9² is not 1").message.contains("squared length"));
    assert!(turned.set_column(0, "heading", Some(1)) && turned.set_unit(0, "heading", "quaternion"));
    assert!(turned.read().expect_err("x of a place").message.contains("no x, y, z and w"));
}

#[test]
fn a_fix_that_is_written_again_was_measured_once_and_so_was_the_course_beside_it() {
    let mut phone = file("phone-dashboard.csv");
    assert!(phone.set_column(0, "time", Some(0)) && phone.set_column(0, "omega", Some(8)));
    let drive = phone.read().expect("sound").log.drive;
    let times = |is: fn(&Event) -> bool| {
        let rows = drive.rows.iter().filter(|row| is(&row.event));
        rows.map(|row| ((row.time - drive.rows[0].time) * 10.0).round()).collect::<Vec<_>>()
    };
    assert_eq!(times(|event| matches!(event, Event::Position { .. })), [0.0, 4.0, 8.0]);
    assert_eq!(times(|event| matches!(event, Event::Heading { .. })), [0.0, 4.0, 8.0]);
    assert_eq!(times(|event| matches!(event, Event::Velocity { .. })).len(), 12);
}

#[test]
fn what_is_left_out_of_one_file_leaves_the_others_whole() {
    let ranges = ("ranges.csv", "time,landmark,range\n0.1,7,5\n0.2,8,6\n0.3,9,7\n");
    let landmarks = ("landmarks.csv", "landmark,x,y\n7,3,4\n8,0,6\n9,7,0\n");
    let mut log = with("gnss-held.csv", &[ranges, landmarks]);
    assert!(log.set_frame(2, Frame::Same));
    let read = log.read().expect("sound");
    let seen: Vec<(usize, f64)> = (read.log.drive.rows.iter())
        .filter_map(|row| if let Event::Range { landmark, range } = row.event { Some((landmark, range)) } else { None })
        .collect();
    assert_eq!(seen, [(0, 5.0), (1, 6.0), (2, 7.0)]);
    assert_eq!(read.log.drive.rows.iter().filter(|row| matches!(row.event, Event::Position { .. })).count(), 2);
}

#[test]
fn words_above_the_numbers_are_passed_over_and_tell_columns_of_one_name_apart() {
    let mut timer = file("lap-timer.csv");
    assert!(timer.set_column(0, "v", Some(11)));
    assert_eq!(timer.files()[0].units()[1].map(|unit| unit.name), Some("m/s"));
    let read = timer.read().expect("sound");
    assert_eq!(read.log.drive.rows.iter().filter(|row| matches!(row.event, Event::Speed { .. })).count(), 12);
    assert!(read.notes.iter().any(|note| note == "lap-timer.csv: 5 lines of words above the numbers left out."));
    // A line of names that lacks one is refused in its place, as ever.
    let mut short = Files::default();
    short.add("wheels.csv", "time,v,omega\n0,1,0,5\n1,1,0,5\n").expect("a file");
    assert_eq!(short.read().expect_err("a name is missing").line, 2);
}

#[test]
fn a_simulator_s_axes_are_asked_one_by_one() {
    let mut files = file("simulator-axes.csv");
    assert!(files.set_role(0, Role::Sensors));
    let asks = files.files()[0].asks().join(" ");
    for wanted in
        ["the speed: \u{201c}velx\u{201d} or \u{201c}vely\u{201d}", "x: \u{201c}posx\u{201d} or \u{201c}gpsx\u{201d}"]
    {
        assert!(asks.contains(wanted), "{asks}");
    }
    assert!(!asks.contains("turn rate"), "yaw_vel is: {asks}");
}

#[test]
fn lists_of_ranges_are_rows_each_with_its_anchor() {
    let (motion, anchors) =
        (("wheels.csv", "time,v,omega\n0,1,0\n1,1,0\n"), ("anchors.csv", "id,x,y\n7,0,0\n9,3,0\n12,0,4\n"));
    let mut files = with("uwb-lists.csv", &[motion, anchors]);
    assert!(files.read().is_err() && files.set_unit(0, "range", "mm"));
    assert_eq!(files.files()[0].follows(), "5 Hz, 0.4 s long, ranges 1.25 \u{2026} 3.04 m to 3 landmarks");
    let ranges = files.read().expect("sound").log.drive.rows.iter().filter(|row| !row.event.is_motion()).count();
    assert_eq!(ranges, 3 + 2 + 2);
}
