//! Verdicts on logs whose turn rates read too much or too little by a share, and on such whose bearings are counted
//! clockwise. Natively only.

use chapter_tests::planted::{Log, WORLDS, judged};
use estimate::drive::{Event, Fault, Fitted, Row, Standing, Suspect};

/// A sound log of a world, whose rows are then changed.
fn spoiled(world: &str, n: u64, spoil: impl Fn(&mut Event)) -> Log {
    let world = WORLDS.iter().find(|it| it.name == world).expect("a world");
    let mut log = world.sound(9200 + n, n.is_multiple_of(2));
    log.drive.rows.iter_mut().for_each(|row| spoil(&mut row.event));
    log
}

fn turns(world: &str, n: u64, times: f64) -> Log {
    spoiled(world, n, |event| {
        if let Event::Velocity { omega, .. } | Event::TurnRate { omega } = event {
            *omega *= times;
        }
    })
}

fn of(log: &Log, fault: Fault) -> Suspect {
    judged(log).expect("a verdict").suspects.into_iter().find(|it| it.fault == fault).expect("it was looked for")
}

#[test]
fn turn_rates_that_read_too_much_or_too_little_are_named_with_their_share() {
    for (n, (world, times)) in
        [("beacons", 1.1), ("beacons", 0.9), ("camera", 1.2), ("car", 0.94), ("compass", 1.12)].into_iter().enumerate()
    {
        let n = n as u64;
        let first = judged(&turns(world, n, times)).expect("a verdict").suspects.remove(0);
        assert_eq!((first.fault, first.standing), (Fault::TurnScale, Standing::Sure), "{world} {times}: {first:?}");
        let [size] = first.sizes[..] else { panic!("one share: {first:?}") };
        assert!((size.value - (1.0 / times - 1.0)).abs() < 3.0 * size.sigma, "{world}: {size:?}");
        let left = of(&turns(world, n, times * (1.0 + size.value)), Fault::TurnScale);
        assert_eq!(left.standing, Standing::Cleared, "{world}: {left:?}");
    }
}

#[test]
fn turn_rates_in_another_unit_are_found_from_far_away() {
    let first = judged(&turns("compass", 0, 0.25)).expect("a verdict").suspects.remove(0);
    assert_eq!(first.fault, Fault::TurnScale, "{first:?}");
    assert!((first.sizes[0].value - 3.0).abs() < 0.2, "{first:?}");
}

#[test]
fn bearings_that_are_counted_clockwise_are_named() {
    for n in 0..4 {
        let mirror = |event: &mut Event| {
            if let Event::RangeBearing { bearing, .. } = event {
                *bearing = -*bearing;
            }
        };
        let first = judged(&spoiled("camera", n, mirror)).expect("a verdict").suspects.remove(0);
        assert_eq!((first.fault, first.standing), (Fault::MirroredBearings, Standing::Sure), "{n}: {first:?}");
        let sound = of(&spoiled("camera", n, |_| {}), Fault::MirroredBearings);
        assert_eq!(sound.standing, Standing::Cleared, "{n}: {sound:?}");
    }
}

/// The log with its turn rates late by so much, speeds and turn rates in rows of their own.
fn late_turns(log: &Log, by: f64) -> Log {
    let mut log = log.clone();
    let parted = |row: &Row| match row.event {
        Event::Velocity { v, omega } => {
            vec![
                Row { event: Event::Speed { v }, ..*row },
                Row { event: Event::TurnRate { omega }, time: row.time + by, ..*row },
            ]
        }
        _ => vec![*row],
    };
    log.drive.rows = log.drive.rows.iter().flat_map(parted).collect();
    log.drive.rows.sort_by(|a, b| a.time.total_cmp(&b.time));
    log
}

#[test]
fn a_turn_rate_that_is_late_is_named_where_positions_are_all_that_is_read() {
    for n in 0..4 {
        let world = WORLDS.iter().find(|it| it.name == "car").expect("a world").even();
        let log = late_turns(&world.sound(9400 + n, n.is_multiple_of(2)), 0.3);
        let first = judged(&log).expect("a verdict").suspects.remove(0);
        assert_eq!((first.fault, first.number), (Fault::Clock, Some(Fitted::DelayTurn)), "{n}: {first:?}");
        let size = first.sizes[0];
        assert!((size.value - 0.3).abs() < 3.0 * size.sigma, "{n}: {size:?}");
    }
}
