//! Headings that turn the other way round than the robot are asked for their unit, unless it has been said.

use robot_log::Files;

/// A robot that turns to and fro for 200 s, and its compass in degrees: counted clockwise from north or not, with a
/// spread of so many degrees.
fn log(clockwise: bool, spread: f64) -> Files {
    let rate = |time: f64| 0.15 * (0.21 * time).sin() + 0.02;
    let (mut gyro, mut compass) = (String::from("time_s,v,omega\n"), String::from("time_s,compass_deg\n"));
    let (mut theta, mut chance) = (0.0_f64, 7_u32);
    for k in 0..2000 {
        let time = 0.1 * f64::from(k);
        gyro += &format!("{time},1,{}\n", rate(time));
        if k % 5 == 0 {
            chance = chance.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            let off = spread * 3.46 * (f64::from(chance >> 8) / f64::from(1 << 24) - 0.5);
            let counted = if clockwise { 90.0 - theta.to_degrees() } else { theta.to_degrees() } + off;
            compass += &format!("{time},{:.2}\n", counted.rem_euclid(360.0));
        }
        theta += 0.1 * rate(time);
    }
    let mut files = Files::default();
    files.add("wheels.csv", &gyro).expect("few and short");
    files.add("mag.csv", &compass).expect("few and short");
    files.compare();
    files
}

#[test]
fn a_compass_counted_the_other_way_is_asked_for_its_unit_until_that_is_said() {
    for unit in ["deg", "deg from north"] {
        let mut log = log(false, 3.0);
        let asked = log.read().expect_err("the other way").message;
        let words = "mag.csv asks: In which unit is \u{201c}compass_deg\u{201d}? As it was guessed, its headings turn \
                     the other way round than the motion says that the robot does.";
        assert!(asked.starts_with(words), "{asked}");
        assert!(log.set_unit(1, "heading", unit));
        log.compare();
        assert!(log.files()[1].asks().is_empty() && log.read().is_ok(), "{unit}");
        // Another column, or the same once more, is another guess.
        assert!(log.set_column(1, "heading", Some(1)));
        log.compare();
        assert_eq!(log.files()[1].asks().len(), 1, "{unit}");
    }
}

#[test]
fn a_compass_that_turns_with_the_robot_is_not_asked_whatever_its_noise() {
    for spread in [0.0, 1.0, 3.0, 10.0, 40.0] {
        assert!(log(true, spread).files()[1].asks().is_empty(), "{spread}");
    }
    for spread in [0.0, 1.0, 3.0, 10.0] {
        assert_eq!(log(false, spread).files()[1].asks().len(), 1, "{spread}");
    }
}

#[test]
fn a_course_below_0_is_asked_but_for_what_phones_write_where_they_know_none() {
    for (course, asked) in [("-170", 1), ("-1", 0)] {
        let mut files = Files::default();
        let text = format!("time_s,gnss_e_m,gnss_n_m,compass_deg\n0,0,0,10\n1,1,0,{course}\n2,2,0,30\n");
        files.add("gps.csv", &text).expect("few and short");
        let asks = files.files()[0].asks();
        assert_eq!(asks.len(), asked, "{course}: {asks:?}");
    }
}
