//! What of the innovations does not look like noise is said beside "no fault". Natively only.

use chapter_tests::planted::{Log, WORLDS, judged};
use estimate::drive::{BySensor, Event, Noise};

fn noise(log: &Log) -> Noise {
    judged(log).expect("a verdict").noise
}

/// The middle fifth of the log, seconds.
fn middle(log: &Log) -> [f64; 2] {
    let [from, to] = log.drive.span().expect("rows");
    [from + 0.4 * (to - from), from + 0.6 * (to - from)]
}

#[test]
fn the_innovations_of_a_sound_log_look_like_noise() {
    let all =
        (0..WORLDS.len()).flat_map(|world| (0..6).map(move |n| WORLDS[world].sound(5200 + n, n.is_multiple_of(2))));
    let strange: Vec<Noise> = all.map(|log| noise(&log)).filter(|it| *it != Noise::default()).collect();
    assert!(strange.len() <= 2, "{} of {}: {strange:?}", strange.len(), 6 * WORLDS.len());
}

#[test]
fn a_minute_that_is_wrong_stands_out() {
    for (world, n) in [0, 2, 4].into_iter().flat_map(|world| (0..3).map(move |n| (world, n))) {
        let mut log = WORLDS[world].sound(5300 + n, false);
        let ([from, to], s) = (middle(&log), log.settings);
        let mut side = 1.0;
        for row in log.drive.rows.iter_mut().filter(|row| (from..to).contains(&row.time)) {
            if let Event::Range { range: value, .. } | Event::Position { x: value, .. } = &mut row.event {
                side = -side;
                *value += 2.5 * side * if log.drive.landmarks.is_empty() { s.sigma_fix } else { s.sigma_range };
            }
        }
        let start = log.drive.rows[0].time;
        let found = noise(&log).nis.expect("it stands out");
        assert!(found.there > 2.0 * found.elsewhere, "{world} {n}: {found:?}");
        let within = found.times[0] > from - start - 5.0 && found.times[1] < to - start + 5.0;
        assert!(within, "{world} {n}: {found:?} of {from} {to}");
    }
}

#[test]
fn errors_that_are_alike_from_one_reading_to_the_next_are_correlated() {
    for n in 0..3 {
        let mut log = WORLDS[2].sound(5400 + n, false);
        let (sigma, mut drift, mut count) = (log.settings.sigma_fix, 0.0_f64, 0_u32);
        for row in &mut log.drive.rows {
            if let Event::Position { x, y, .. } = &mut row.event {
                count += 1;
                drift = 2.0 * sigma * libm::sin(f64::from(count) * 0.6);
                (*x, *y) = (*x + drift, *y - drift);
            }
        }
        log.settings.gate = BySensor::all(None);
        let found = noise(&log).correlated;
        assert!(found.is_some_and(|it| it.by > 0.2 && it.by > 5.0 * it.chance), "{n}: {found:?} {drift}");
    }
}
