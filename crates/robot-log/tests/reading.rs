//! What a sound log becomes, and that no mangled one is taken for another.

use estimate::Landmark;
use estimate::drive::{Event, Motion};
use proptest::prelude::*;

#[path = "../../../tests/src/draws.rs"]
mod draws;
use robot_log::{Files, Role, parse};

const SOUND: &str = "\
# a drive past one landmark
L,7,3.0,4.0
G,0.0,0.0,0.0,0.1
O,0.5,0.1,0.02
R,0.5,7,4.9
O,1.0,0.2,0.03
B,1.0,7,4.8,0.9
";

#[test]
fn a_log_is_its_rows_in_the_order_of_time() {
    let log = parse(SOUND).expect("sound");
    assert_eq!(log.drive.landmarks, [Landmark { id: 7, x: 3.0, y: 4.0 }]);
    assert_eq!((log.count, log.drive.motion, log.drive.span()), (6, Motion::Odometry, Some([0.5, 1.0])));
    assert_eq!(log.drive.truth.poses()[0].theta, 0.1);
    let events: Vec<Event> = log.drive.rows.iter().map(|row| row.event).collect();
    assert_eq!(
        events,
        [
            Event::Odometry { distance: 0.1, turn: 0.02 },
            Event::Range { landmark: 0, range: 4.9 },
            Event::Odometry { distance: 0.2, turn: 0.03 },
            Event::RangeBearing { landmark: 0, range: 4.8, bearing: 0.9 },
        ]
    );
}

#[test]
fn odometry_is_driven_evenly_in_rows_of_its_own_and_in_tables() {
    let rows = parse(&SOUND.replace("O,", "D,")).expect("sound").drive;
    assert_eq!(rows, estimate::drive::Drive { motion: Motion::EvenOdometry, ..parse(SOUND).expect("sound").drive });
    let mut files = robot_log::Files::default();
    files.add("odometry.csv", "time_s,distance_m,dtheta_rad\n0.5,0.1,0.02\n1.0,0.2,0.03\n").expect("short");
    let read = files.read().expect("sound").log.drive;
    assert_eq!(read.motion, Motion::EvenOdometry);
    assert_eq!(read.rows[1].event, Event::Odometry { distance: 0.2, turn: 0.03 });
}

/// A table of speeds and turn rates at these times.
fn rates(times: impl Iterator<Item = f64>) -> estimate::drive::Drive {
    let rows: Vec<String> = times.map(|time| format!("{time},0.5,0.1\n")).collect();
    let mut files = robot_log::Files::default();
    files.add("motion.csv", &format!("time_s,v_mps,omega_radps\n{}", rows.concat())).expect("short");
    let read = files.read().expect("sound");
    let held = read.notes.iter().any(|note| note.contains("is held until the next"));
    assert_eq!(held, read.log.drive.motion == Motion::Velocity, "what is held is said: {:?}", read.notes);
    read.log.drive
}

#[test]
fn rates_change_evenly_in_rows_of_their_own_and_in_tables_of_equal_steps() {
    let held = "V,0,0.5,0.1\nS,1,0.7\nT,1,0.2\n";
    let even = parse(&held.replace("V,", "VE,").replace("S,", "SE,").replace("T,", "TE,")).expect("sound").drive;
    assert_eq!(even, estimate::drive::Drive { motion: Motion::EvenVelocity, ..parse(held).expect("sound").drive });
    // Ten a second, each a little late, and now and then one is lost.
    let jitter = |k: u32| 0.1 * f64::from(k) + 0.02 * f64::from(k * k % 7) / 7.0;
    assert_eq!(rates((0..200).filter(|k| k % 25 != 7).map(jitter)).motion, Motion::EvenVelocity);
}

#[test]
fn rates_that_are_written_when_they_change_are_held() {
    let mut time = 0.0;
    let changes = (0..60).map(|k: u32| {
        time += [0.3, 4.0, 1.1, 0.2, 7.5, 2.6, 0.4][(k * k % 7) as usize];
        time
    });
    assert_eq!(rates(changes).motion, Motion::Velocity);
    // A command holds for 1 to 4 s, as chance has it.
    let (mut time, mut seed) = (0.0, 7_u32);
    let holds = (0..90).map(|_| {
        seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        time += 1.0 + 3.0 * f64::from(seed) / f64::from(u32::MAX);
        time
    });
    assert_eq!(rates(holds).motion, Motion::Velocity);
    // A stick is written ten times a second while it moves, and held for seconds then.
    let stick = (0..40).flat_map(|k| (0..12).map(move |i| 6.0 * f64::from(k) + 0.1 * f64::from(i)));
    let held = rates(stick);
    assert_eq!(held.motion, Motion::Velocity);
    assert_eq!(estimate::drive::gaps_and_end(&held.rows, held.motion), [], "what is not written has not changed");
    // In the book's own format the letter says it.
    let own = "VE,0,1,0\nVE,0.1,1,0\nVE,0.2,1,0\nVE,9,1,0\nVE,9.1,1,0\nVE,30,1,0\n";
    let mut files = robot_log::Files::default();
    files.add("own.csv", own).expect("short");
    assert_eq!(files.read().expect("sound").log.drive.motion, Motion::EvenVelocity);
}

#[test]
fn a_table_of_rates_beside_held_rows_is_held_as_they_are() {
    let mut files = robot_log::Files::default();
    files.add("book.csv", "S,0,0.1\nS,1,0.1\nS,2,0.1\n").expect("short");
    files.add("gyro.csv", "time_s,omega_radps\n0,0.1\n1,0.2\n2,0.1\n").expect("short");
    assert_eq!(files.read().expect("sound").log.drive.motion, Motion::Velocity);
}

#[test]
fn at_one_time_motion_comes_before_sightings_and_lines_keep_their_order() {
    let log = parse("R,1,7,1\nR,1,7,2\nV,1,0,0\nL,7,0,0\nV,-0.0,1,1\nR,0,7,3\n").expect("sound");
    let kinds: Vec<(f64, f64)> = log
        .drive
        .rows
        .iter()
        .map(|row| match row.event {
            Event::Range { range, .. } => (row.time, range),
            _ => (row.time, 0.0),
        })
        .collect();
    assert_eq!(kinds, [(0.0, 0.0), (0.0, 3.0), (1.0, 0.0), (1.0, 1.0), (1.0, 2.0)]);
}

#[test]
fn a_byte_order_mark_blanks_and_line_ends_of_either_kind_change_nothing() {
    let plain = parse(SOUND).expect("sound");
    let windows = format!("\u{feff}{}", SOUND.replace('\n', "\r\n"));
    let spaced = SOUND.replace(',', " ,\t").replace('\n', "  \n\n \t\n");
    for text in [windows.as_str(), spaced.as_str(), SOUND.trim_end()] {
        assert_eq!(parse(text).as_ref(), Ok(&plain), "{text:?}");
    }
}

/// A sound log with `n` steps, and each of its lines.
fn lines(n: usize) -> Vec<String> {
    let mut lines: Vec<String> = SOUND.lines().map(String::from).collect();
    for k in 0..n {
        lines.push(format!("O,{}.25,0.1,-0.0{}", k + 2, k % 10));
        lines.push(format!("R,{}.5,7,{}.5", k + 2, 4 + k % 3));
    }
    lines
}

#[test]
fn a_byte_order_mark_behind_a_comment_is_a_fault_with_its_place() {
    let error = parse("# c\n\u{feff}L,1,0,0\nO,0,1,0\n").expect_err("no row begins with a mark");
    assert_eq!((error.line, error.column), (2, 1));
}

proptest! {
    #![proptest_config(draws::cases(2000))]

    #[test]
    fn no_text_makes_the_parser_panic(text in draws::text("LGORVB#,.-0123456789 \n", 200)) {
        let _ = parse(&text);
    }

    /// What is read of a spoilt log is said to be where it is in the text.
    #[test]
    fn a_spoilt_log_is_read_or_refused_at_a_place_that_it_has(text in draws::spoilt(SOUND)) {
        if let Err(error) = parse(&text) {
            let line = (error.line as usize).checked_sub(1).and_then(|above| text.split('\n').nth(above));
            let width = line.map(|line| line.chars().count());
            prop_assert!(width.is_some_and(|width| (1..=width + 1).contains(&(error.column as usize))), "{error}");
        }
    }

    /// Behind comments and blank lines, where a log begins for its reader.
    #[test]
    fn no_text_behind_a_comment_makes_the_parser_panic(
        head in prop::sample::select(vec!["# c\n", "\n", " \r\n", "L,1,0,0\n"]),
        mark in draws::character("LO#,"),
        text in draws::text("LGORVB#,.-0123456789 \n", 60),
    ) {
        let _ = parse(&format!("{head}{mark}{text}"));
    }

    #[test]
    fn no_bytes_read_as_text_make_the_parser_panic(bytes in prop::collection::vec(any::<u8>(), 0..300)) {
        let _ = parse(&String::from_utf8_lossy(&bytes));
    }

    /// A log cut anywhere but at a line's end or inside its last number is refused, and what is read is a part of the
    /// whole.
    #[test]
    fn a_truncated_log_is_a_part_of_the_whole_or_refused(n in 1_usize..20, cut in 0_usize..400) {
        let whole = lines(n).join("\n");
        let cut = cut.min(whole.len());
        let Ok(part) = parse(&whole[..cut]) else { return Ok(()) };
        let all = parse(&whole).expect("sound");
        prop_assert!(part.drive.rows.len() <= all.drive.rows.len());
        // All but the last row, whose last number may have lost digits.
        for row in &part.drive.rows[..part.drive.rows.len() - 1] {
            prop_assert!(all.drive.rows.contains(row));
        }
    }

    #[test]
    fn line_ends_may_be_mixed(n in 0_usize..20, ends in prop::collection::vec(any::<bool>(), 60)) {
        let lines = lines(n);
        let mixed: String = lines.iter().zip(&ends).map(|(line, crlf)| format!("{line}{}", if *crlf { "\r\n\
            " } else { "\n" })).collect();
        prop_assert_eq!(parse(&mixed), parse(&lines.join("\n")));
    }

    /// A file in UTF-16, read as bytes and as text, is refused.
    #[test]
    fn a_log_in_utf_16_is_refused(n in 0_usize..5, big in any::<bool>()) {
        let units = lines(n).join("\n").encode_utf16().collect::<Vec<u16>>();
        let bytes: Vec<u8> = {
            let bytes = |unit: u16| if big { unit.to_be_bytes() } else { unit.to_le_bytes() };
            units.into_iter().flat_map(bytes).collect()
        };
        prop_assert!(parse(&String::from_utf8_lossy(&bytes)).is_err());
    }

    /// Two neighbouring columns of an `R` row in each other's place: an id that is no whole number, or no landmark.
    #[test]
    fn swapped_columns_of_a_range_are_refused(n in 1_usize..20) {
        let mut lines = lines(n);
        let last = lines.pop().expect("a range");
        let fields: Vec<&str> = last.split(',').collect();
        lines.push([fields[0], fields[2], fields[1], fields[3]].join(","));
        let error = parse(&lines.join("\n")).expect_err("swapped");
        prop_assert_eq!(error.line as usize, lines.len());
    }
}

#[test]
fn heights_of_landmarks_are_said_beside_ranges() {
    let notes = |z: &str, ranges: &str| {
        let mut files = Files::default();
        files.add("odometry.csv", "time_s,distance_m,turn_rad\n0,0,0\n1,0.5,0.1\n2,0.5,0\n").expect("motion");
        files.add("anchors.csv", &format!("anchor,x,y,z\n1,1,2,{z}\n2,4,5,{z}\n")).expect("places");
        files.add("uwb.csv", &format!("time_s,anchor,range\n{ranges}")).expect("ranges");
        let notes = files.read().expect("sound").notes;
        notes.into_iter().any(|note| note.starts_with("anchors.csv: z is not read, and ranges are taken as level"))
    };
    let ranges = "1,1,2.5\n2,2,6.5\n";
    assert_eq!([notes("7", ranges), notes("0.0", ranges)], [true, false]);
}

#[test]
fn a_covariance_of_the_yaw_is_the_variance_of_a_heading() {
    let mut files = Files::default();
    let speeds: String = (0..9).map(|i| format!("{},1,0.1\n", 0.1 * f64::from(i))).collect();
    files.add("twist.csv", &format!("time,v,omega\n{speeds}")).expect("a table");
    let poses =
        "time,x,y,yaw,cov_xx,cov_yy,cov_yawyaw\n0,1,2,0.3,0.0025,0.0025,0.0004\n0.5,1.5,2,0.35,0.01,0.01,0.0009\n";
    files.add("amcl_pose.csv", poses).expect("a table");
    assert!(files.set_role(1, Role::Sensors));
    let rows = files.read().expect("sound").log.drive.rows;
    let sigmas = |of: fn(&Event) -> Option<f64>| rows.iter().filter_map(|row| of(&row.event)).collect::<Vec<_>>();
    assert_eq!(sigmas(|it| if let Event::Position { sigma, .. } = it { *sigma } else { None }), [0.05, 0.1]);
    assert_eq!(sigmas(|it| if let Event::Heading { sigma, .. } = it { *sigma } else { None }), [0.02, 0.03]);
}
