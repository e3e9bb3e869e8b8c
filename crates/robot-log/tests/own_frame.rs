//! A truth in a frame or on a clock of its own: what is asked of it, what is not, and what the answers do.

use robot_log::{Files, Frame, Role};
use std::fmt::Write;

/// What a log is made of besides a healthy drive.
#[derive(Clone, Copy)]
struct Made {
    seed: u64,
    /// The truth's turn, rad, its shift, m, whether its y is mirrored before, and its clock, s.
    turn: f64,
    shift: [f64; 2],
    mirrored: bool,
    clock: f64,
    /// How late the fixes are and the motion is, s.
    late: [f64; 2],
    /// The fixes' standard deviation, m, how far they wander, m, and the part of them that is anywhere.
    sigma: f64,
    wander: f64,
    outliers: f64,
    /// The gyroscope's bias, rad/s, and the scale of the wheels.
    bias: f64,
    scale: f64,
    /// The scale of the truth: its unit.
    unit: f64,
    /// Whether the robot drives straight on.
    straight: bool,
    /// Whether the fixes are in latitude and longitude.
    global: bool,
}

const HEALTHY: Made = Made {
    seed: 1,
    turn: 0.0,
    shift: [0.0; 2],
    mirrored: false,
    clock: 0.0,
    late: [0.0; 2],
    sigma: 0.3,
    wander: 0.0,
    outliers: 0.0,
    bias: 0.0,
    scale: 1.0,
    unit: 1.0,
    straight: false,
    global: false,
};
const TURNED: Made = Made { turn: 0.7, shift: [12.0, -7.0], ..HEALTHY };

struct Draws(u64);

impl Draws {
    /// Between 0 and 1.
    fn share(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// Nearly normal: the sum of twelve.
    fn normal(&mut self) -> f64 {
        (0..12).map(|_| self.share()).sum::<f64>() - 6.0
    }
}

/// The wheels, the positions and the truth of 200 s.
fn files(made: Made) -> Files {
    let (step, mut draws) = (0.01, Draws(made.seed.wrapping_mul(77)));
    let v = |t: f64| 0.8 + 0.3 * libm::sin(t / 4.6) + 0.15 * libm::sin(t / 1.16);
    let omega = |t: f64| {
        let turns = 0.22 * libm::sin(t / 3.0) + 0.18 * libm::sin(t / 7.5) + 0.06;
        if made.straight { 0.0 } else { turns }
    };
    let v = |t: f64| if made.straight { 5.0 } else { v(t) };
    let mut path = vec![[5.0, 4.0, -1.1]];
    for i in 0..20_000 {
        let (t, [x, y, theta]) = (step * f64::from(i), path[path.len() - 1]);
        let (heading, way) = (theta + omega(t) * step / 2.0, v(t) * step);
        path.push([x + way * libm::cos(heading), y + way * libm::sin(heading), theta + omega(t) * step]);
    }
    let at = |t: f64| path[(t / step).round().clamp(0.0, 20_000.0) as usize];
    let mut wheels = String::from("time_s,vx,wz\n");
    for t in (0..4000).map(|i| 0.05 * f64::from(i)) {
        let then = t - made.late[1];
        let (along, turning) = (made.scale * v(then) + 0.04 * draws.normal(), omega(then) + 0.02 * draws.normal());
        writeln!(wheels, "{t:.3},{along:.4},{:.5}", turning + made.bias).expect("text");
    }
    let header = if made.global { "time_s,latitude,longitude\n" } else { "time_s,x,y\n" };
    let (mut gps, mut wander) = (String::from(header), [0.0; 2]);
    for t in (1..480).map(|i| 0.4 * f64::from(i)) {
        let [x, y, _] = at(t - made.late[0]);
        wander = wander.map(|w| 0.99 * w + made.wander * libm::sqrt(1.0 - 0.99 * 0.99) * draws.normal());
        let far = if draws.share() < made.outliers { 10.0 } else { 0.0 };
        let off = [0, 1].map(|i| wander[i] + (made.sigma + far) * draws.normal());
        let [x, y] = [x + off[0], y + off[1]];
        // A degree at a latitude of 50 degrees, m.
        let [x, y] = if made.global { [50.0 + y / 111_229.0, 8.0 + x / 71_696.0] } else { [x, y] };
        writeln!(gps, "{t:.3},{x:.8},{y:.8}").expect("text");
    }
    let mut truth = String::from("time_s,mocap_x_m,mocap_y_m\n");
    for t in (0..2000).map(|i| 0.1 * f64::from(i)) {
        let ([x, y, _], sin, cos) = (at(t), libm::sin(made.turn), libm::cos(made.turn));
        let y = if made.mirrored { -y } else { y };
        let [x, y] = [cos * x - sin * y + made.shift[0], sin * x + cos * y + made.shift[1]].map(|it| it * made.unit);
        writeln!(truth, "{:.3},{x:.4},{y:.4}", t + made.clock).expect("text");
    }
    let mut files = Files::default();
    for (name, text) in [("odo.csv", wheels), ("gps.csv", gps), ("truth.csv", truth)] {
        files.add(name, &text).expect(name);
    }
    assert_eq!(files.files()[2].role(), Role::Truth);
    files.compare();
    files
}

fn asked(made: Made) -> String {
    files(made).files()[2].asks().join(" ")
}

/// The root of the mean square distance of the fixes from the truth, m.
fn distance(files: &Files) -> f64 {
    let drive = files.read().expect("sound").log.drive;
    let apart = |row: &estimate::drive::Row| match (row.event, drive.truth.position(row.time)) {
        (estimate::drive::Event::Position { x, y, .. }, Some(at)) => Some((x - at[0]).powi(2) + (y - at[1]).powi(2)),
        _ => None,
    };
    let apart: Vec<f64> = drive.rows.iter().filter_map(apart).collect();
    (apart.iter().sum::<f64>() / apart.len() as f64).sqrt()
}

#[test]
fn a_healthy_log_is_asked_nothing_nor_one_with_the_faults_of_its_sensors() {
    for seed in 1..=30 {
        assert_eq!(asked(Made { seed, ..HEALTHY }), "", "seed {seed}");
    }
    for seed in 1..=5 {
        let seeded = Made { seed, ..HEALTHY };
        let faults = [
            ("late fixes", Made { late: [0.4, 0.0], ..seeded }),
            ("very late fixes", Made { late: [1.5, 0.0], ..seeded }),
            ("late motion", Made { late: [0.0, 0.6], ..seeded }),
            ("outliers", Made { outliers: 0.05, ..seeded }),
            ("fixes that wander", Made { wander: 1.5, ..seeded }),
            ("fixes that wander, less noise", Made { wander: 2.0, sigma: 0.1, ..seeded }),
            ("bias", Made { bias: 0.03, ..seeded }),
            ("scale", Made { scale: 1.07, ..seeded }),
            ("a straight way, late", Made { late: [0.4, 0.0], straight: true, ..seeded }),
            ("a straight way, a clock", Made { clock: 1.0, straight: true, ..seeded }),
        ];
        for (fault, made) in faults {
            assert_eq!(asked(made), "", "{fault}, seed {seed}");
        }
    }
    // In feet it is not brought onto the positions by any turn or shift.
    assert_eq!(asked(Made { unit: 3.280_84, ..HEALTHY }), "");
}

#[test]
fn a_truth_in_another_frame_is_asked_and_turned_and_shifted() {
    for seed in 1..=5 {
        let mut log = files(Made { seed, ..TURNED });
        let asks = log.files()[2].asks().join(" ");
        assert!(asks.starts_with("Turned by \u{2212}40."), "{asks}");
        assert!(
            asks.contains("the truth lies on the positions, 0.4") && asks.contains("its frame another one"),
            "{asks}"
        );
        assert!(log.read().expect_err("it asks").message.contains("truth.csv asks: Turned by"));
        assert!(!log.set_frame(2, Frame::Moved) && !log.set_frame(1, Frame::Own));
        assert!(log.set_frame(2, Frame::Own));
        let own = *log.files()[2].own().expect("found");
        let frame = own.frame.expect("turned");
        assert!((frame.turn + 0.7).abs() < 4.0 * own.sigmas[0] && own.sigmas[0] < 0.01, "{own:?}");
        assert_eq!((own.delay, frame.mirrored), (0.0, false));
        let back = frame.place([12.0, -7.0]);
        assert!(back.iter().all(|at| at.abs() < 0.2), "{back:?}");
        assert!((distance(&log) - 0.3 * 2.0_f64.sqrt()).abs() < 0.05, "{}", distance(&log));
        let read = log.read().expect("sound");
        let pose = read.log.drive.truth.poses()[0];
        assert!(
            (pose.x - 5.0).abs() < 0.2 && (pose.theta + 1.1).abs() < 0.1,
            "its heading is turned with it: {pose:?}"
        );
        assert!(
            read.notes.iter().any(|note| note.starts_with("The truth is turned by \u{2212}40.")),
            "{:?}",
            read.notes
        );
        assert!(log.set_frame(2, Frame::Same));
        assert!(distance(&log) > 10.0);
        assert_eq!(log.files()[2].frame(), Some(Frame::Same));
    }
}

#[test]
fn a_small_turn_a_shift_alone_a_quarter_and_a_mirror_are_told_apart() {
    let small = asked(Made { turn: 0.07, shift: [0.5, -0.8], ..HEALTHY });
    assert!(small.starts_with("Turned by \u{2212}4."), "{small}");
    let shifted = asked(Made { shift: [3.0, 2.0], ..HEALTHY });
    assert!(shifted.starts_with("Shifted by \u{2212}") && !shifted.contains("urned by"), "{shifted}");
    let quarter = asked(Made { turn: core::f64::consts::FRAC_PI_2, ..HEALTHY });
    assert!(quarter.starts_with("Turned by \u{2212}90.") || quarter.starts_with("Turned by \u{2212}89."), "{quarter}");
    let mut mirror = files(Made { mirrored: true, ..TURNED });
    let asks = mirror.files()[2].asks().join(" ");
    assert!(asks.starts_with("Mirrored (its y against itself), turned by"), "{asks}");
    assert!(mirror.set_frame(2, Frame::Own));
    assert!((distance(&mirror) - 0.3 * 2.0_f64.sqrt()).abs() < 0.05);
    let pose = mirror.read().expect("sound").log.drive.truth.poses()[0];
    assert!((pose.theta + 1.1).abs() < 0.1, "{pose:?}");
    // Neither fixes that wander nor far ones hide a frame.
    let wander = asked(Made { wander: 1.5, ..TURNED });
    assert!(wander.starts_with("Turned by"), "{wander}");
    let far = asked(Made { turn: 0.07, shift: [0.5, -0.8], outliers: 0.05, ..HEALTHY });
    assert!(far.starts_with("Turned by"), "{far}");
}

#[test]
fn a_clock_of_its_own_is_one_that_the_motion_tells_too() {
    for clock in [1.5, -0.8, 3.2] {
        let mut log = files(Made { clock, ..HEALTHY });
        let asks = log.files()[2].asks().join(" ");
        assert!(asks.contains("is its clock another one") && !asks.contains("hifted by"), "{clock}: {asks}");
        assert!(asks.contains(if clock > 0.0 { " s earlier, the truth lies" } else { " s later, the truth lies" }));
        assert!(log.set_frame(2, Frame::Own));
        let own = *log.files()[2].own().expect("found");
        assert!((own.delay + clock).abs() < 4.0 * own.sigmas[2] && own.sigmas[2] < 0.05, "{own:?}");
        assert!(own.frame.is_none());
        assert!((distance(&log) - 0.3 * 2.0_f64.sqrt()).abs() < 0.05);
    }
    let both = asked(Made { clock: 1.5, ..TURNED });
    assert!(both.starts_with("1.") && both.contains(" s earlier, turned by \u{2212}40."), "{both}");
    assert!(both.contains("are its frame and its clock others"), "{both}");
    // Late fixes of a turned truth are no clock: the frame is found as late as they are.
    let late = files(Made { late: [1.0, 0.0], ..TURNED });
    let own = late.files()[2].own().expect("a frame");
    assert_eq!(own.delay, 0.0);
    assert!((own.frame.expect("turned").turn + 0.7).abs() < 4.0 * own.sigmas[0], "{own:?}");
}

/// The origin of the truth is at 50 and 8 degrees. That the fixes are late moves it no more than their noise does.
#[test]
fn a_truth_in_metres_beside_latitudes_is_moved_onto_all_fixes_or_counted_from_an_origin_that_is_said() {
    for (seed, late) in [(1, 0.0), (2, 0.4), (3, -0.2), (4, 1.5)] {
        let mut log = files(Made { global: true, late: [late, 0.0], seed, ..HEALTHY });
        let first = |log: &Files| {
            let drive = log.read().expect("sound").log.drive;
            let fixes = drive.rows.iter().filter_map(|row| match row.event {
                estimate::drive::Event::Position { x, y, .. } => Some([x, y]),
                _ => None,
            });
            (fixes.take(1).last().expect("a fix"), drive.truth.poses()[0])
        };
        assert!(!log.set_origin(2, 91.0, 8.0) && !log.set_origin(1, 50.0, 8.0) && log.set_origin(2, 50.0, 8.0));
        let (fix, pose) = first(&log);
        assert!((pose.x - 5.0).abs() < 1e-4 && (pose.y - 4.0).abs() < 1e-4, "it stays where it is: {pose:?}");
        assert_eq!(log.files()[2].frame(), Some(Frame::At([50.0, 8.0])));
        let notes = log.read().expect("sound").notes;
        assert!(
            notes.iter().any(|it| it.ends_with("east and north of 50.00000\u{b0} N, 8.00000\u{b0} E.")),
            "{notes:?}"
        );
        assert!(log.set_frame(2, Frame::Moved));
        let (none, moved) = first(&log);
        assert_eq!(none, [0.0, 0.0], "the first fix is the origin");
        let off = [moved.x - (5.0 - fix[0]), moved.y - (4.0 - fix[1])];
        assert!(off.iter().all(|off| off.abs() < 0.1), "{seed}: {off:?}");
        let notes = log.read().expect("sound").notes;
        let sigma = "no surer than the standard deviation of that, 0.0";
        assert!(notes.iter().any(|it| it.starts_with("The truth is moved by") && it.contains(sigma)), "{notes:?}");
    }
}

#[test]
fn a_truth_in_metres_beside_latitudes_may_be_moved_or_turned_onto_the_fixes() {
    let mut log = files(Made { global: true, ..TURNED });
    let asks = log.files()[2].asks();
    assert!(
        asks[0].starts_with("Its places are in metres") && asks[1].starts_with("Turned by \u{2212}40."),
        "{asks:?}"
    );
    assert!(log.set_frame(2, Frame::Moved) && log.files()[2].asks().is_empty());
    assert!(distance(&log) > 5.0, "a turn is left");
    assert!(log.set_frame(2, Frame::Own));
    assert!((distance(&log) - 0.3 * 2.0_f64.sqrt()).abs() < 0.05, "{}", distance(&log));
}

#[test]
fn without_fixes_nothing_is_asked() {
    let mut log = files(TURNED);
    assert!(log.set_role(1, Role::Unused));
    log.compare();
    assert!(log.files()[2].asks().is_empty() && log.read().is_ok());
    assert!(!log.set_frame(2, Frame::Own));
}
