//! Odometry that is written as poses: from one to the next the robot has driven an arc.

mod opened;

use estimate::drive::{Event, Row};
use opened::files;
use robot_log::{Files, Role};

fn rows(files: &Files) -> Vec<Row> {
    files.read().expect("sound").log.drive.rows
}

fn roles(files: &Files) -> Vec<Role> {
    files.files().iter().map(|file| file.role()).collect()
}

const STEPS: &str = "0,0,0,0\n1,1,0,0\n2,1.5,0,0\n3,1,0,0\n";

#[test]
fn poses_that_are_called_odometry_s_are_the_way_between_them() {
    for head in [
        "time_s,odom_x_m,odom_y_m,odom_yaw_rad",
        "t,wheel_odom_x,wheel_odom_y,wheel_odom_theta",
        "t,dr_x,dr_y,dr_heading_rad",
        "t,x_odom,y_odom,yaw_odom",
        "/odom/header/stamp/sec,/odom/pose/pose/position/x,/odom/pose/pose/position/y,/odom/yaw",
    ] {
        let log = files(&[("run.csv", &format!("{head}\n{STEPS}"))]);
        assert_eq!((roles(&log), log.files()[0].asks()), (vec![Role::Reckoned], vec![]), "{head}");
        assert_eq!((log.files()[0].columns()[..4].to_vec(), log.unread(0)), ((0..4).map(Some).collect(), vec![]));
        let way = |row: &Row| if let Event::Odometry { distance, .. } = row.event { distance } else { f64::NAN };
        assert_eq!(rows(&log).iter().map(way).collect::<Vec<_>>(), [1.0, 0.5, -0.5], "{head}");
    }
    // What a filter has made is asked about, and a speed of its own says more.
    let filtered = files(&[("run.csv", &format!("t,filtered_odom_pose_x,filtered_odom_pose_y,yaw\n{STEPS}"))]);
    assert_eq!(roles(&filtered), [Role::Undecided]);
    let twist = files(&[("run.csv", "t,odom_x,odom_y,odom_yaw,odom_speed,odom_yaw_rate\n0,0,0,0,1,0\n1,1,0,0,1,0\n")]);
    assert_eq!(roles(&twist), [Role::Velocities]);
}

#[test]
fn poses_of_odometry_beside_other_sensors_are_read_once_more() {
    let table = "time_s,odom_x_m,odom_y_m,odom_yaw_rad,nav_x_mm,nav_y_mm,nav_heading_deg\n\
                 0,0,0,0,,,\n0.5,,,,31203,14599,66.8\n1,1,0,0,,,\n1.5,,,,32203,14599,66.9\n2,2,0,0.1,,,\n";
    let mut log = files(&[("agv.csv", table)]);
    assert_eq!(roles(&log), [Role::Sensors, Role::Reckoned]);
    assert_eq!(log.files()[1].name(), "agv.csv, its motion");
    assert_eq!(log.files()[0].asks(), ["In which unit is \u{201c}nav_heading_deg\u{201d}?"]);
    assert!(log.set_unit(0, "heading", "deg") && log.unread(0).is_empty());
    let read = rows(&log);
    let count = |is: fn(&Event) -> bool| read.iter().filter(|row| is(&row.event)).count();
    assert_eq!(count(|event| matches!(event, Event::Odometry { .. })), 2);
    assert_eq!(count(|event| matches!(event, Event::Position { x, .. } if (x - 31.703).abs() < 1.0)), 2);
    assert_eq!(count(|event| matches!(event, Event::Heading { .. })), 2);
    // One of the three is missing.
    let mut faulty = files(&[("agv.csv", &table.replace("2,2,0,0.1", "2,2,0,"))]);
    assert!(faulty.set_unit(0, "heading", "deg"));
    assert_eq!(faulty.read().expect_err("no heading").line, 6);
    // A gyro of the same table turns the robot, and a true place is the truth.
    let gyro = files(&[("agv.csv", "t,odom_x,odom_y,odom_yaw,gyro_z\n0,0,0,0,0.1\n1,1,0,0,0.1\n2,3,0,0,0.1\n")]);
    assert_eq!(roles(&gyro), [Role::Sensors, Role::Reckoned]);
    let read = rows(&gyro);
    assert!(read.iter().any(|row| row.event == Event::Speed { v: 2.0 }), "{read:?}");
    assert!(!read.iter().any(|row| matches!(row.event, Event::Odometry { .. })), "{read:?}");
    let truth = files(&[("sim.csv", "t,odom_x,odom_y,odom_yaw,true_x,true_y\n0,0,0,0,5,5\n1,1,0,0,6,5\n")]);
    assert_eq!(roles(&truth), [Role::Truth, Role::Reckoned]);
    assert!(truth.read().is_ok());
    // Another file of speeds drives alone.
    let twist = ("twist.csv", "t,v,omega\n0,1,0\n1,1,0\n");
    assert_eq!(roles(&files(&[("agv.csv", table), twist])), [Role::Sensors, Role::Velocities]);
}

#[test]
fn a_pose_that_nobody_calls_odometry_s_is_asked_about_with_three_answers() {
    for name in ["track.csv", "odom.csv"] {
        let mut log = files(&[(name, &format!("t,x,y,theta\n{STEPS}"))]);
        let answers = [Role::Truth, Role::Sensors, Role::Reckoned];
        assert_eq!((roles(&log), log.files()[0].answers()), (vec![Role::Undecided], &answers[..]), "{name}");
        assert!(log.read().expect_err("it asks").message.contains("what the robot has reckoned of its way?"));
        assert!(log.set_role(0, Role::Reckoned));
        assert_eq!(rows(&log).len(), 3, "{name}");
    }
    let mut tum = files(&[("vo.txt", "# timestamp tx ty tz qx qy qz qw\n0 0 0 0 0 0 0 1\n1 1 0 0 0 0 0 1\n")]);
    assert!(tum.files()[0].answers().contains(&Role::Reckoned) && tum.set_role(0, Role::Reckoned));
    assert_eq!(rows(&tum)[0].event, Event::Odometry { distance: 1.0, turn: 0.0 });
    let place = files(&[("track.csv", "t,x,y\n0,0,0\n1,1,0\n")]);
    assert_eq!(place.files()[0].answers(), [Role::Truth, Role::Sensors]);
}

#[test]
fn odometry_that_begins_anew_makes_no_way_and_that_is_said() {
    let row = |i: u32| format!("{:.1},{:.1},0,0\n", f64::from(i) / 10.0, f64::from(i % 60) / 10.0);
    let text = format!("t,odom_x,odom_y,odom_yaw\n{}", (0..100).map(row).collect::<String>());
    let log = files(&[("run.csv", &text)]);
    let read = log.read().expect("sound");
    assert_eq!(read.log.drive.rows.len(), 98);
    let note = "run.csv: the pose jumps at line 62, as where odometry begins anew: no way is taken from the row before \
                to that one.";
    assert!(read.notes.iter().any(|it| it == note), "{:?}", read.notes);
}

/// Odometry that begins anew where it was switched on before turns at once: its place says nothing of that.
#[test]
fn a_heading_that_begins_anew_makes_no_turn() {
    let at = |k: u32| 0.02 * f64::from(if k < 60 { k } else { k - 60 });
    let yaw: String = (0..100).map(|k| format!("{},0,0,{}\n", f64::from(k) * 0.05, at(k))).collect();
    let parts = |theta: f64| format!("0,0,{},{}", (theta / 2.0).sin(), (theta / 2.0).cos());
    let four: String = (0..100).map(|k| format!("{},0,0,{}\n", f64::from(k) * 0.05, parts(at(k)))).collect();
    let named = "odom.orientation.x,odom.orientation.y,odom.orientation.z,odom.orientation.w";
    for table in
        [format!("t,odom_x,odom_y,odom_yaw_rad\n{yaw}"), format!("t,odom.position.x,odom.position.y,{named}\n{four}")]
    {
        let log = files(&[("run.csv", &table)]);
        assert_eq!(roles(&log), [Role::Reckoned]);
        let turn = |row: &Row| if let Event::Odometry { turn, .. } = row.event { turn } else { f64::NAN };
        let turned: f64 = rows(&log).iter().map(turn).sum();
        assert!((turned - 0.02 * 98.0).abs() < 1e-9, "{turned}");
        let notes = log.read().expect("sound").notes;
        assert!(notes.iter().any(|note| note.contains("the pose jumps at line 62,")), "{notes:?}");
    }
}
