//! A gyro beside wheels: its turn rates are taken and theirs are not, and their way becomes a speed.

mod opened;

use estimate::drive::{Event, Row};
use opened::files;
use robot_log::{Counting, Files, Role};

const GYRO: (&str, &str) = ("gyro.csv", "time_s,gyro_z_radps\n0.05,0.3\n0.15,0.31\n0.25,0.32\n");

fn rows(files: &Files) -> Vec<Row> {
    files.read().expect("sound").log.drive.rows
}

fn speeds(rows: &[Row]) -> Vec<[f64; 2]> {
    let speed = |row: &Row| if let Event::Speed { v } = row.event { Some([row.time, v]) } else { None };
    rows.iter().filter_map(speed).collect()
}

fn turns(rows: &[Row]) -> Vec<f64> {
    let turn = |row: &Row| if let Event::TurnRate { omega } = row.event { Some(omega) } else { None };
    rows.iter().filter_map(turn).collect()
}

#[test]
fn of_two_turn_rates_the_gyro_s_is_taken_and_it_is_said() {
    let twist = ("wheels.csv", "time_s,v_mps,omega_radps\n0,1,0.2\n0.1,1.1,0.2\n0.2,1.2,0.2\n");
    let mut both = files(&[twist, GYRO]);
    let read = rows(&both);
    assert_eq!(speeds(&read), [[0.0, 1.0], [0.1, 1.1], [0.2, 1.2]]);
    assert_eq!(turns(&read), [0.3, 0.31, 0.32]);
    assert_eq!(read.len(), 6, "no row has both");
    let notes = both.read().expect("sound").notes;
    assert!(notes.iter().any(|note| note.starts_with("The turn rate is that of gyro.csv alone")), "{notes:?}");
    // Without it the wheels turn the robot again.
    assert!(both.set_role(1, Role::Unused));
    let wheels = rows(&both);
    assert!(wheels.iter().all(|row| matches!(row.event, Event::Velocity { omega: 0.2, .. })), "{wheels:?}");
}

#[test]
fn a_gyro_that_says_its_axis_and_its_unit_alone_turns_the_robot() {
    let speed = ("wheels.csv", "time_s,v_mps\n0,1\n0.1,1.1\n0.2,1.2\n");
    let one = files(&[speed, ("gyro.csv", "time_s,z_rad_s\n0.05,0.3\n0.15,0.31\n0.25,0.32\n")]);
    assert_eq!(turns(&rows(&one)), [0.3, 0.31, 0.32]);
    // Of three axes the reader says which one points up.
    let three = files(&[speed, ("gyro.csv", "time_s,x_rad_s,y_rad_s,z_rad_s\n0.05,0,0,0.3\n0.15,0,0,0.31\n")]);
    let asked = three.files()[1].asks();
    assert!(asked.iter().any(|it| it.contains("turn rate")), "{asked:?}");
    // A height is no turn, and a height's rate is none either.
    let climb = files(&[speed, ("lift.csv", "time_s,z,z_mps,z_rad\n0.05,0.3,0.1,0\n0.15,0.31,0.1,0\n")]);
    assert_eq!(climb.files()[1].role(), Role::Unused);
}

#[test]
fn encoders_beside_a_gyro_read_the_way_that_they_count_as_a_speed() {
    let ticks = "time_s,left_ticks,right_ticks\n0,0,0\n0.1,100,110\n0.1,110,120\n0.3,200,220\n";
    let mut both = files(&[("encoders.csv", ticks), GYRO]);
    for (name, number) in [("ticks", 1000.0), ("radius", 0.1), ("base", 0.4)] {
        assert!(both.set_wheel(0, name, number), "{name}");
    }
    assert!(both.set_counting(0, Counting::Total));
    let (read, tick) = (rows(&both), core::f64::consts::TAU / 1000.0 * 0.1);
    assert_eq!(turns(&read), [0.3, 0.31, 0.32]);
    // Of the two rows at one time the second is driven with the next.
    let found = speeds(&read);
    // A mean over a step stands in its middle, but for the first.
    let wanted = [[0.0, 105.0 * tick / 0.1], [0.2, 105.0 * tick / 0.2]];
    assert_eq!(found.len(), wanted.len(), "{found:?}");
    for (found, wanted) in found.iter().zip(wanted) {
        assert!((found[0] - wanted[0]).abs() < 1e-12 && (found[1] - wanted[1]).abs() < 1e-9, "{found:?}, {wanted:?}");
    }
    // A gyro that writes what changes is held, and the wheels with it: each from the beginning of its step.
    let uneven = ("gyro.csv", "time_s,omega_radps\n0,0.3\n0.01,0.31\n0.2,0.32\n0.9,0.3\n");
    let mut held = files(&[("encoders.csv", ticks), uneven]);
    for (name, number) in [("ticks", 1000.0), ("radius", 0.1), ("base", 0.4)] {
        assert!(held.set_wheel(0, name, number), "{name}");
    }
    assert!(held.set_counting(0, Counting::Total));
    let times: Vec<f64> = speeds(&rows(&held)).into_iter().map(|[time, _]| time).collect();
    assert_eq!(times, [0.0, 0.1]);
    // By themselves they say the way and the turn of each step.
    assert!(both.set_role(1, Role::Unused));
    assert!(rows(&both).iter().all(|row| matches!(row.event, Event::Odometry { .. })));
}

#[test]
fn a_speed_that_encoders_count_is_the_one_that_the_robot_had_then() {
    // v = 1 + sin(t)/2, whose way is t + (1 - cos(t))/2, counted five times a second.
    let (mut ticks, mut gyro) =
        (String::from("time_s,left_ticks,right_ticks\n"), String::from("time_s,gyro_z_radps\n"));
    for i in 0..100 {
        let t = 0.2 * f64::from(i);
        let count = libm::round(1e5 * (t + (1.0 - libm::cos(t)) / 2.0));
        ticks += &format!("{t:.1},{count},{count}\n");
        (0..10).for_each(|j| gyro += &format!("{:.2},0.1\n", t + 0.02 * f64::from(j)));
    }
    let mut both = files(&[("encoders.csv", &ticks), ("gyro.csv", &gyro)]);
    for (name, number) in [("ticks", 1e5 * core::f64::consts::TAU), ("radius", 1.0), ("base", 0.4)] {
        assert!(both.set_wheel(0, name, number), "{name}");
    }
    assert!(both.set_counting(0, Counting::Total));
    let found = speeds(&rows(&both));
    assert_eq!(found.len(), 99);
    for [time, speed] in &found[1..] {
        assert!((speed - (1.0 + libm::sin(*time) / 2.0)).abs() < 2e-3, "{speed} at {time}");
    }
}

#[test]
fn a_table_of_a_left_and_a_right_wheel_is_known_by_its_name_or_by_those_of_its_columns() {
    for (name, head, asks) in [
        ("drive.csv", "time_s,v_left_mps,v_right_mps", "the distance between the wheels"),
        ("wheels.csv", "time,s_right,s_left", "unit"),
        ("odom.csv", "time,left,right", "unit"),
    ] {
        let read = files(&[(name, &format!("{head}\n0,1,1.1\n0.1,1,1.2\n"))]);
        let file = &read.files()[0];
        assert_eq!(file.role(), Role::Encoders, "{name}");
        assert!(file.asks().iter().any(|ask| ask.contains(asks)), "{name}: {:?}", file.asks());
    }
    let stereo = files(&[("camera.csv", "time,left_image,right_image\n0,1,1\n0.1,2,2\n")]);
    assert_eq!(stereo.files()[0].role(), Role::Unused);
}

/// A table of two wheels' speeds, a gyro and a receiver, with these names of the wheels.
fn shared([left, right]: [&str; 2]) -> Files {
    let rows = "0,1,1.2,,,,\n0.01,,,20,,,\n0.02,,,,48.1,11.5,0.02\n0.1,1.2,1.4,,,,\n0.11,,,21,,,\n";
    files(&[("mower.csv", &format!("t_s,{left},{right},gyro_z_dps,lat_deg,lon_deg,rtk_sigma_m\n{rows}"))])
}

#[test]
fn wheels_beside_a_gyro_and_a_receiver_in_one_table_are_its_speed() {
    for names in [
        ["v_left_mps", "v_right_mps"],
        ["left_mps", "right_mps"],
        ["left_wheel_speed_mps", "right_wheel_speed_mps"],
        ["wheel_left_mps", "wheel_right_mps"],
        ["wheel_speed_l_mps", "wheel_speed_r_mps"],
        ["vl_mps", "vr_mps"],
        ["v_l", "v_r"],
        ["vel_l", "vel_r"],
        ["speed_l", "speed_r"],
        ["wl_rads", "wr_rads"],
        ["omega_l", "omega_r"],
        ["left_ticks", "right_ticks"],
        ["vitesse_gauche", "vitesse_droite"],
    ] {
        let mut log = shared(names);
        let roles: Vec<_> = log.files().iter().map(|file| (file.name(), file.role(), file.again())).collect();
        let wanted = [("mower.csv", Role::Sensors, None), ("mower.csv, its motion", Role::Encoders, Some(0))];
        assert_eq!(roles, wanted, "{names:?}");
        assert!(log.files()[0].asks().is_empty(), "{names:?}: {:?}", log.files()[0].asks());
        assert_eq!(
            (log.files()[0].columns()[7], log.unread(0)),
            (Some(6), vec![]),
            "{names:?}: its σ, and all is read"
        );
        for value in ["left", "right"] {
            assert!(log.set_unit(1, value, "m/s"), "{names:?}");
        }
        assert!(log.set_wheel(1, "base", 0.5));
        assert_eq!(speeds(&rows(&log)), [[0.0, 1.1], [0.1, 1.2999999999999998]], "{names:?}");
        assert_eq!(turns(&rows(&log)), [20_f64.to_radians(), 21_f64.to_radians()], "{names:?}");
        let notes = log.read().expect("sound").notes;
        let leave = "To turn by the wheels, choose no column (\u{2013}) for the turn rate of mower.csv.";
        assert!(notes.iter().any(|note| note.ends_with(leave)), "{notes:?}");
        // As it says.
        assert!(log.set_column(0, "omega", None));
        let first = rows(&log)[0].event;
        assert!(matches!(first, Event::Velocity { omega, .. } if (omega - 0.4).abs() < 1e-12), "{first:?}");
    }
}

#[test]
fn wheels_are_no_speed_beside_a_speed_and_no_motion_beside_another_file_s() {
    let both = "t_s,speed_mps,v_l,v_r,gyro_z_dps,lat,lon\n0,1,0.9,1.1,2,48.1,11.5\n1,1,0.9,1.1,2,48.1,11.5\n";
    let log = files(&[("mower.csv", both)]);
    assert_eq!((log.files().len(), log.files()[0].columns()[1], log.unread(0)), (1, Some(1), vec![2, 3]));
    let mut log = shared(["v_l", "v_r"]);
    log.add("gyro.csv", GYRO.1).expect("a file");
    assert_eq!(log.files().len(), 3, "a gyro says no speed");
    log.add("twist.csv", "time_s,v_mps,omega_radps\n0,1,0.2\n0.1,1.1,0.2\n").expect("a file");
    let roles: Vec<Role> = log.files().iter().map(|file| file.role()).collect();
    assert_eq!(roles, [Role::Sensors, Role::Sensors, Role::Velocities]);
    // Without a receiver the gyro is read too, and without a gyro the receiver is.
    for (head, row, again) in [("gyro_z_dps", "0,1,1,2", Role::Encoders), ("lat,lon", "0,1,1,48.1,11.5", Role::Sensors)]
    {
        let log = files(&[("agv.csv", &format!("t_s,left_mps,right_mps,{head}\n{row}\n"))]);
        assert_eq!((log.files().len(), log.files()[1].role(), log.unread(0)), (2, again, vec![]), "{head}");
    }
}

/// A place in metres beside wheels may be anybody's: it is asked whose, and neither it nor a gyro is passed over.
#[test]
fn a_place_beside_wheels_is_asked_about() {
    for (header, more, roles) in [
        ("t,v_left,v_right,gyro_z,x,y", ",0.1,2,3", [Role::Sensors, Role::Encoders]),
        ("t,v_left,v_right,x,y", ",2,3", [Role::Encoders, Role::Sensors]),
    ] {
        let rows = (0..40).map(|k| format!("{},1,1.1{more}\n", f64::from(k) * 0.1));
        let mut files = Files::default();
        files.add("all.csv", &format!("{header}\n{}", rows.collect::<String>())).expect("a table");
        let asked = files.files().iter().position(|file| file.role() == Role::Undecided).expect("a question");
        assert!(files.files()[asked].asks()[0].starts_with("Are x and y the true position, or what a sensor read?"));
        files.set_role(asked, Role::Sensors);
        let read: Vec<Role> = files.files().iter().map(|file| file.role()).collect();
        assert_eq!(read, roles, "{header}");
    }
}

/// A gyro in rad/s whose column says degrees turns 57 times too little.
#[test]
fn a_gyro_in_another_unit_than_its_wheels_is_said() {
    let gyro = |unit: &str, times: f64| {
        let rate = |k: u32| times * if k % 100 < 50 { 0.4 } else { -0.3 };
        let rows: String = (0..400).map(|k| format!("{},{}\n", f64::from(k) * 0.02, rate(k))).collect();
        format!("time_s,gyro_z_{unit}\n{rows}")
    };
    let left = |k: u32| 1.0 - 0.5 * if k % 40 < 20 { 0.4 } else { -0.3 };
    let rows: String = (0..160).map(|k| format!("{},{},1\n", f64::from(k) * 0.05, left(k))).collect();
    let wheels = format!("t,v_left_mps,v_right_mps\n{rows}");
    let said = |gyro: &str| {
        let mut both = files(&[("gyro.csv", gyro), ("wheels.csv", &wheels)]);
        assert!(both.set_wheel(1, "base", 0.5));
        let notes = both.read().expect("sound").notes;
        notes.into_iter().find(|note| note.contains("another unit"))
    };
    assert_eq!(said(&gyro("radps", 1.0)), None);
    assert_eq!(said(&gyro("dps", 180.0 / core::f64::consts::PI)), None);
    let wrong = said(&gyro("dps", 1.0)).expect("it is said");
    assert!(wrong.starts_with("gyro.csv turns by 0.36"), "{wrong}");
    assert!(wrong.contains("\u{b0} in a second as a rule, and wheels.csv by 20"), "{wrong}");
}
