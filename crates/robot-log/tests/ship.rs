//! A ship's log: its rate of turn in degrees a minute, which side it counts to, and its speed through the water.

use estimate::drive::Event;
use robot_log::Files;

fn motion(header: &str) -> Files {
    let mut files = Files::default();
    files.add("ship.csv", &format!("{header}\n0,2,30\n1,2,-60\n2,2,0\n")).expect("a file");
    files
}

/// The speeds and turn rates that are read, m/s and rad/s.
fn read(files: &Files) -> Vec<[f64; 2]> {
    let drive = files.read().expect("sound").log.drive;
    let of = |event: &Event| if let Event::Velocity { v, omega } = *event { Some([v, omega]) } else { None };
    drive.rows.iter().filter_map(|row| of(&row.event)).collect()
}

#[test]
fn a_rate_of_turn_is_asked_for_its_unit_and_its_side() {
    for name in ["ROT", "rot_deg_min", "rate_of_turn"] {
        let mut files = motion(&format!("time_s,STW,{name}"));
        let asked = ["STW", name].map(|name| format!("In which unit is \u{201c}{name}\u{201d}?"));
        assert_eq!(files.files()[0].asks(), asked);
        assert!(files.set_unit(0, "v", "kn") && files.set_unit(0, "omega", "deg/min clockwise"));
        let [first, second, third] = read(&files)[..] else { panic!("three rows") };
        assert_eq!(first, [2.0 * 1852.0 / 3600.0, -(30.0_f64 / 60.0).to_radians()], "{name}");
        assert_eq!((second[1], third[1].abs()), ((1.0_f64).to_radians(), 0.0));
    }
}

#[test]
fn degrees_a_minute_are_known_by_a_turn_rate_s_name() {
    for name in ["yaw_rate_deg_min", "yaw rate [deg/min]", "yawrate (degrees/min)"] {
        let files = motion(&format!("time_s,speed,{name}"));
        assert!(files.files()[0].asks().is_empty(), "{name}: {:?}", files.files()[0].asks());
        assert_eq!(read(&files)[0], [2.0, 0.5_f64.to_radians()], "{name}");
    }
}
