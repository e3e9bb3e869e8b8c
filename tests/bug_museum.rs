//! What 500 seeds say of each bug in the museum. Natively only.

use chapter_kalman::ensembles::{Distribution, FIGURES, PANELS, SEEDS, Sight, Symptoms, bands, diagnosed, museum_runs};
use labs::Bug;
use labs::bug_museum::MuseumParams;

/// The seeds of the bands, which are none of those that are judged by them.
const CALIBRATION: (u32, u32) = (100_000, 4000);
/// The seeds that a symptom table is made of, when other ones are diagnosed with it.
const TABLE: u32 = 10_000;

/// The first of the seeds that the figure and the page's table count over.
fn counted() -> u32 {
    MuseumParams::default().seed
}

fn symptoms(bug: Bug, first: u32) -> Symptoms {
    Symptoms::of(&museum_runs([bug, Bug::None], first, SEEDS).expect("computed"))
}

#[test]
fn the_bands_are_those_of_4000_right_runs() {
    let runs = museum_runs([Bug::None; 2], CALIBRATION.0, CALIBRATION.1).expect("computed");
    for i in 0..FIGURES {
        let spread = Distribution::new(runs.iter().map(|run| run[i]));
        let variance = runs.iter().map(|run| (run[i] - spread.mean()).powi(2)).sum::<f64>() / runs.len() as f64;
        let (band, pooled) = bands(i);
        let expected = [0.005, 0.025, 0.975, 0.995].map(|p| spread.percentile(p));
        // They are written down to six digits.
        let near = |a: f64, b: f64| (a - b).abs() <= 1e-5 * b.abs();
        assert!(band.into_iter().zip(expected).all(|(a, b)| near(a, b)), "figure {i}: {band:?}, {expected:?}");
        assert!(near(pooled[0], spread.mean()) && near(pooled[1], variance.sqrt()), "figure {i}: {pooled:?}");
    }
}

/// 5 % of right runs leave a 95 % band, with a standard error of 1 % over 500 seeds.
#[test]
fn a_right_filter_leaves_its_bands_as_often_as_chance_allows() {
    let right = symptoms(Bug::None, counted());
    for (i, beyond) in right.beyond.into_iter().enumerate().take(FIGURES - 1) {
        let share = beyond[0] + beyond[1];
        assert!((0.02..=0.08).contains(&share), "figure {i}: {share}");
    }
    assert_eq!(right.beyond[FIGURES - 1], [0.0; 2], "its covariance is symmetric to the last bit");
    assert!((0..PANELS.len()).all(|panel| right.panel(panel) == Sight::Invisible), "{:?}", right.sight);
}

/// The percentage of seeds whose mean NEES leaves its 95 % band, below and above. Recorded, within three standard
/// errors of a share of 500.
#[test]
fn the_mean_nees_leaves_its_band_as_recorded() {
    for (bug, below, above) in NEES {
        let [low, high] = symptoms(bug, counted()).beyond[3].map(|share| 100.0 * share);
        let near = |found: f64, recorded: f64| {
            let p = (recorded / 100.0_f64).clamp(0.005, 0.995);
            (found - recorded).abs() <= 300.0 * (p * (1.0 - p) / f64::from(SEEDS)).sqrt()
        };
        assert!(near(low, below) && near(high, above), "{bug:?}: {low} {high}");
    }
}

const NEES: [(Bug, f64, f64); 14] = [
    (Bug::None, 3.0, 3.0),
    (Bug::UnwrappedInnovation, 1.0, 4.0),
    (Bug::UnwrappedHeading, 23.0, 20.0),
    (Bug::FrozenJacobian, 0.0, 90.0),
    (Bug::WrongDerivative, 0.0, 99.0),
    (Bug::Transposed, 0.0, 94.0),
    (Bug::Degrees, 6.0, 4.0),
    (Bug::Deviation, 99.0, 0.0),
    (Bug::StepLength, 100.0, 0.0),
    (Bug::ShortForm, 0.0, 100.0),
    (Bug::Asymmetric, 3.0, 3.0),
    (Bug::Twice, 0.0, 86.0),
    (Bug::OpenGate, 0.0, 100.0),
    (Bug::Late, 0.0, 100.0),
];

/// What can be seen of each bug, panel by panel: `*` in more than half of the single runs, `o` over 500 seeds, `-` not
/// at all, which is to say that chance explains the mean over 500 seeds, and the runs on either side of the band.
const SIGHTS: [(Bug, &str); 13] = [
    //                          map, error, NEES, NIS, mean, correlation, covariance
    (Bug::UnwrappedInnovation, "ooo*oo*"),
    (Bug::UnwrappedHeading, "*oo*oo*"),
    (Bug::FrozenJacobian, "***oooo"),
    (Bug::WrongDerivative, "****oo*"),
    (Bug::Transposed, "o**oooo"),
    (Bug::Degrees, "*oo*-*o"),
    (Bug::Deviation, "o***-*o"),
    (Bug::StepLength, "o***-**"),
    (Bug::ShortForm, "o**ooo*"),
    (Bug::Asymmetric, "------*"),
    (Bug::Twice, "oo**-*o"),
    (Bug::OpenGate, "******o"),
    (Bug::Late, "****oo*"),
];

#[test]
fn what_can_be_seen_of_a_bug_is_as_recorded_and_every_bug_can_be_seen_somewhere() {
    for (bug, recorded) in SIGHTS {
        let symptoms = symptoms(bug, counted());
        let sights: String = (0..PANELS.len())
            .map(|panel| match symptoms.panel(panel) {
                Sight::Invisible => '-',
                Sight::InMany => 'o',
                Sight::InOne => '*',
            })
            .collect();
        assert_eq!(sights, recorded, "{bug:?}");
        assert!(sights.contains('*'), "{bug:?}: every bug shows in some panel of most single runs");
    }
}

/// The page's symptom table, whose numbers are generated, has a dash where a bug is invisible, and nowhere else.
#[test]
fn the_table_of_the_page_has_a_dash_where_a_bug_is_invisible() {
    let page = include_str!("../content/kalman/18-wrong.md");
    for (bug, recorded) in SIGHTS {
        let cell = format!("museum.{}.", bug.word());
        let row = page.lines().find(|line| line.starts_with('|') && line.contains(&cell)).expect("a row for each bug");
        let cells: Vec<&str> = row.trim_matches('|').split('|').map(str::trim).skip(1).collect();
        assert_eq!(cells.len(), PANELS.len(), "{bug:?}");
        for ((shown, sight), (panel, _)) in cells.into_iter().zip(recorded.chars()).zip(PANELS) {
            let number = format!("{{{{number {cell}{panel} side.0}}}}");
            assert_eq!(shown, if sight == '-' { "–" } else { &number }, "{bug:?} {panel}");
        }
    }
}

/// Blind: a program that knows the symptom table alone, made of other seeds, names the bug of a run, and of five runs
/// together.
#[test]
fn the_bugs_are_told_apart_by_their_panels_alone() {
    let all: Vec<Bug> = [Bug::None].into_iter().chain(Bug::ALL).collect();
    let table: Vec<(Bug, Symptoms)> = all.iter().map(|bug| (*bug, symptoms(*bug, TABLE))).collect();
    for (together, least, mean) in [(1, 0.6, 0.88), (5, 0.9, 0.98)] {
        let mut sum = 0.0;
        for bug in &all {
            let runs = museum_runs([*bug, Bug::None], counted(), SEEDS).expect("computed");
            let groups: Vec<_> = runs.chunks_exact(together).collect();
            let named = groups.iter().filter(|some| diagnosed(&table, some) == Some(*bug)).count();
            let share = named as f64 / groups.len() as f64;
            println!("{bug:?}: {share:.3} of {} named from {together}", groups.len());
            assert!(share > least, "{bug:?}: {share} from {together}");
            sum += share;
        }
        let rate = sum / all.len() as f64;
        println!("from {together}: {rate:.3} of all");
        assert!(rate > mean, "{rate} from {together}");
    }
}
