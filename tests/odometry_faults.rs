//! Verdicts on logs whose odometry reads distances or turns too long or too short by a share, as wheels of another size
//! or another base do. Natively only.

use chapter_tests::planted::{Log, WORLDS, judged};
use estimate::drive::{Event, Fault, Fitted, Size, Standing, Suspect, Verdict};

/// A sound log of the world that moves by odometry, which then reads so many times the distances and the turns.
fn reads(n: u64, [far, much]: [f64; 2]) -> Log {
    let world = WORLDS.iter().find(|world| world.odometry).expect("a world of odometry");
    let mut log = world.sound(9000 + n, n.is_multiple_of(2));
    for row in &mut log.drive.rows {
        if let Event::Odometry { distance, turn } = &mut row.event {
            (*distance, *turn) = (far * *distance, much * *turn);
        }
    }
    log
}

#[test]
fn odometry_that_reads_too_much_or_too_little_is_named_with_its_shares() {
    // Wheels of another radius, another base, and both.
    for (n, read) in [[1.05, 1.05], [1.0, 0.8], [0.94, 1.15], [1.06, 1.0]].into_iter().enumerate() {
        let log = reads(n as u64, read);
        let judgement = judged(&log).expect("a verdict");
        let first = &judgement.suspects[0];
        assert_eq!((first.fault, first.standing), (Fault::Odometry, Standing::Sure), "{n}: {first:?}");
        for (size, read) in first.sizes.iter().zip(read) {
            let (share, sigma) = (1.0 / read - 1.0, size.sigma);
            assert!((size.value - share).abs() < 4.0 * sigma && sigma < 0.04, "{n}: {size:?} {share}");
        }
        // Mended so, nothing of the kind is left.
        let again =
            judged(&reads(n as u64, [0, 1].map(|i| read[i] * (1.0 + first.sizes[i].value)))).expect("a verdict");
        let left = again.suspects.iter().find(|it| it.fault == Fault::Odometry).expect("it was looked for");
        assert_eq!(left.standing, Standing::Cleared, "{n}: {left:?}");
    }
}

/// Twice as far, in feet for metres, and of another radius far from one: beyond the first step up.
#[test]
fn odometry_in_another_unit_is_found_from_far_away() {
    for (n, read) in [(0, [3.28, 1.0]), (1, [0.5, 1.0])] {
        let judgement = judged(&reads(n, read)).expect("a verdict");
        let first = &judgement.suspects[0];
        assert_eq!(first.fault, Fault::Odometry, "{n}: {first:?}");
        assert!((first.sizes[0].value - (1.0 / read[0] - 1.0)).abs() < 0.05, "{n}: {first:?}");
    }
}

#[test]
fn a_robot_that_drives_straight_on_has_a_share_of_distances_alone() {
    let mut log = reads(0, [1.0, 1.0]);
    for row in &mut log.drive.rows {
        if let Event::Odometry { turn, .. } = &mut row.event {
            *turn = 0.0;
        }
    }
    let judgement = judged(&log).expect("a verdict");
    let odometry = judgement.suspects.iter().find(|it| it.fault == Fault::Odometry).expect("it was looked for");
    assert_eq!(odometry.sizes.len(), 1);
}

/// Noise of the sensor makes turns look larger: the likeliest factor is the smaller by that, and says so.
#[test]
fn noise_in_the_turns_that_are_read_is_counted_by_the_size() {
    let (mut within, mut told) = (0, 0);
    for n in 0..8 {
        let log = reads(20 + n, [1.0, 0.85]);
        let judgement = judged(&log).expect("a verdict");
        let first = &judgement.suspects[0];
        let [_, turned] = first.sizes[..] else { panic!("{n}: {first:?}") };
        // Half of its own ± is said, and more.
        told += i32::from(first.dilution.is_some());
        assert!(2.0 * turned.sigma > first.dilution.unwrap_or(0.0), "{n}: {first:?}");
        within += i32::from((turned.value - (1.0 / 0.85 - 1.0)).abs() < 2.0 * turned.sigma);
    }
    assert!(within >= 7 && told >= 5, "{within} of 8 within two of the ±, {told} said");
}

/// Wheels of two sizes: on each metre the robot turns by an angle that is not read.
fn unequal(mut log: Log, swerve: f64) -> Log {
    for row in &mut log.drive.rows {
        match &mut row.event {
            Event::Odometry { distance, turn } => *turn -= swerve * *distance,
            Event::Velocity { v, omega } => *omega -= swerve * *v,
            _ => {}
        }
    }
    log
}

#[test]
fn wheels_of_two_sizes_are_named_with_the_turn_of_a_metre() {
    for name in ["mower", "car", "compass"] {
        let world = WORLDS.iter().find(|world| world.name == name).expect("a world");
        for (n, swerve) in [(0, 0.04), (1, -0.03)] {
            let log = world.sound(9700 + n, n.is_multiple_of(2));
            let first = judged(&unequal(log.clone(), swerve)).expect("a verdict").suspects.remove(0);
            assert_eq!((first.fault, first.standing), (Fault::UnequalWheels, Standing::Sure), "{name}: {first:?}");
            let size = first.sizes[0];
            assert!((size.value - swerve).abs() < 3.0 * size.sigma && size.sigma < 0.005, "{name}: {size:?}");
            // Mended so, nothing of the kind is left.
            let again = judged(&unequal(log, swerve - size.value)).expect("a verdict");
            let left = again.suspects.iter().find(|it| it.fault == Fault::UnequalWheels);
            assert!(left.is_none_or(|it| it.standing == Standing::Cleared), "{name}: {left:?}");
        }
    }
}

/// At a speed that hardly changes, the turn of a metre is the bias of a second, and the simpler of the two is named.
#[test]
fn a_bias_of_the_turn_rate_is_none_of_the_wheels() {
    for n in 0..4 {
        for name in ["beacons", "camera"] {
            let world = WORLDS.iter().find(|world| world.name == name).expect("a world");
            let mut log = world.sound(9800 + n, n.is_multiple_of(2));
            for row in &mut log.drive.rows {
                if let Event::Velocity { omega, .. } = &mut row.event {
                    *omega += 0.04;
                }
            }
            let judgement = judged(&log).expect("a verdict");
            assert_eq!(judgement.suspects[0].fault, Fault::Bias, "{name} {n}: {:?}", judgement.suspects[0]);
            assert!(judgement.suspects.iter().all(|it| it.fault != Fault::UnequalWheels), "{name} {n}");
        }
    }
}

/// Where no gyro reads a turn rate, none has a bias: at any speed it is the wheels.
#[test]
fn of_two_wheels_alone_no_bias_is_looked_for() {
    for (n, swerve) in [(0, 0.04), (1, -0.03)] {
        let world = WORLDS.iter().find(|world| world.name == "beacons").expect("a world");
        let log = unequal(world.sound(9700 + n, n.is_multiple_of(2)), swerve);
        let mut verdict = Verdict::new(&log.drive, log.settings).expect("readings").by_wheels();
        while verdict.step(&log.drive).expect("a step") {}
        let suspects = verdict.found().suspects;
        assert!(suspects.iter().all(|it| it.fault != Fault::Bias || it.number == Some(Fitted::Offset)), "{suspects:?}");
        assert_eq!(suspects[0].fault, Fault::UnequalWheels, "{:?}", suspects[0]);
        assert!((suspects[0].sizes[0].value - swerve).abs() < 3.0 * suspects[0].sizes[0].sigma, "{:?}", suspects[0]);
    }
}

/// What the verdict names first of two wheels that read these speeds and turn rates of a sound log.
fn by_wheels(log: &Log) -> Suspect {
    let mut verdict = Verdict::new(&log.drive, log.settings).expect("readings").by_wheels();
    while verdict.step(&log.drive).expect("a step") {}
    verdict.found().suspects.remove(0)
}

/// A sound log whose motion reads what this makes of it.
fn read_as(n: u64, made: impl Fn([f64; 2]) -> [f64; 2]) -> Log {
    let world = WORLDS.iter().find(|world| world.name == "compass").expect("a world");
    let mut log = world.sound(9750 + n, false);
    for row in &mut log.drive.rows {
        if let Event::Velocity { v, omega } = &mut row.event {
            [*v, *omega] = made([*v, *omega]);
        }
    }
    log
}

fn is_near(size: &Size, wanted: f64) -> bool {
    (size.value - wanted).abs() < 3.0 * size.sigma && size.sigma < 0.02
}

/// One wheel that is larger than it was said turns the robot aside, and makes ways and turns larger by half of that: no
/// base is accused of it.
#[test]
fn of_one_wheel_alone_both_wheels_are_told_after_the_turn_of_a_metre() {
    let (base, larger) = (1.0, 0.05);
    let log = read_as(0, |[v, omega]| {
        let [left, right] = [v - 0.5 * base * omega, (v + 0.5 * base * omega) / (1.0 + larger)];
        [0.5 * (left + right), (right - left) / base]
    });
    let turned = by_wheels(&log);
    assert_eq!(turned.fault, Fault::UnequalWheels, "{turned:?}");
    assert!((turned.sizes[0].value - larger / base).abs() < 3.0 * turned.sizes[0].sigma + 0.003, "{turned:?}");
    let left = by_wheels(&unequal(log, -turned.sizes[0].value));
    assert_eq!(left.fault, Fault::WheelSize, "{left:?}");
    assert!(is_near(&left.sizes[0], 0.5 * larger), "{left:?}");
}

/// Another size of both wheels, another distance between them, and both.
#[test]
fn of_two_wheels_their_size_and_their_distance_are_told_apart() {
    for (n, [far, much]) in [(1, [1.05, 1.05]), (2, [1.0, 0.92]), (3, [1.06, 0.95])] {
        let first = by_wheels(&read_as(n, |[v, omega]| [v / far, omega / much]));
        let wanted: (_, &[f64]) = match [far, much] {
            [1.0, _] => (Fault::TurnScale, &[much]),
            _ if far == much => (Fault::WheelSize, &[far]),
            _ => (Fault::Odometry, &[far, much]),
        };
        assert_eq!(first.fault, wanted.0, "{n}: {first:?}");
        assert!(first.sizes.iter().zip(wanted.1).all(|(size, by)| is_near(size, by - 1.0)), "{n}: {first:?}");
    }
}

/// Each of three lengths makes up for a part of another: by themselves none comes right.
#[test]
fn ranges_and_ways_that_are_off_are_told_together() {
    for (n, [scale, offset, far]) in [(0, [0.04, 0.0, 0.05]), (1, [-0.03, 0.1, -0.06]), (2, [0.04, -0.1, 0.06])] {
        let mut log = reads(n, [1.0 / (1.0 + far), 1.0]);
        for row in &mut log.drive.rows {
            if let Event::Range { range, .. } = &mut row.event {
                *range = (1.0 + scale) * *range + offset;
            }
        }
        let first = judged(&log).expect("a verdict").suspects.remove(0);
        assert_eq!(first.fault, Fault::Lengths, "{n}: {first:?}");
        for (size, by) in first.sizes.iter().zip([scale, offset, far]) {
            assert!((size.value - by).abs() < 3.0 * size.sigma, "{n}: {size:?} {by}");
        }
        assert!([0, 2].iter().all(|i| first.sizes[*i].sigma < 0.015), "{n}: {first:?}");
    }
    // Where one alone is off, it alone is named.
    let alone = judged(&reads(5, [0.95, 1.0])).expect("a verdict").suspects.remove(0);
    assert_eq!(alone.fault, Fault::Odometry, "{alone:?}");
}
