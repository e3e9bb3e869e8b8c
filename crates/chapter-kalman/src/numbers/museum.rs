//! Numbers of the museum of bugs over 500 seeds.

use crate::ensembles::{FIGURES, PANELS, SEEDS, Symptoms, diagnosed, museum_runs};
use estimate::Error;
use lab::Listing;
use labs::Bug;
use labs::bug_museum::MuseumParams;
use sim::scenarios::BUG_MUSEUM;

/// The first seed of the runs that a symptom table is made of, when others are diagnosed with it.
const TABLE: u32 = 10_000;
/// Figures whose mean the text tells: 0 is the position's RMS error, 3 NEES, 4 NIS, 10 and 11 the autocorrelation of
/// ranges and of bearings.
const TOLD: [(Bug, usize); 8] = [
    (Bug::None, 0),
    (Bug::OpenGate, 0),
    (Bug::Deviation, 3),
    (Bug::Deviation, 4),
    (Bug::Twice, 10),
    (Bug::Twice, 11),
    (Bug::StepLength, 10),
    (Bug::StepLength, 11),
];
/// Runs that are diagnosed together.
const TOGETHER: usize = 5;

/// The constants.
pub(super) fn constants(to: &mut Listing) {
    let constants = BUG_MUSEUM;
    to.by("sim::scenarios::BUG_MUSEUM", None)
        .add("const.museum.straight", f64::from(constants.course.straight) * constants.course.ds, "a straight, m")
        .add("const.museum.lap", f64::from(constants.course.lap()), "ticks of a lap")
        .add("const.museum.ds", constants.course.ds, "driven in a tick, m")
        .vector(
            "const.museum.landmark",
            constants.landmarks.iter().flat_map(|at| [at.x, at.y]).collect::<Vec<_>>().iter(),
            "the landmarks, m",
        )
        .vector("const.museum.u", constants.u_sigma.iter(), "noise of the input in a tick, standard deviation: m, rad")
        .vector("const.museum.p0", constants.p0_sigma.iter(), "first uncertainty, standard deviation: m, m, rad")
        .add("const.museum.gate", constants.gate, "the gate on χ²")
        .add("museum.steps", f64::from(constants.steps), "steps of a run")
        .add("museum.laps", f64::from(constants.steps / constants.course.lap()), "laps of a run")
        .add("museum.reach", constants.sensor.reach, "how far the sensor reaches, m")
        .add("museum.range.sigma", constants.sensor.range_sigma, "one sigma of a range, m")
        .add("museum.bearing.sigma", constants.sensor.bearing_sigma, "one sigma of a bearing, rad")
        .add("museum.outliers", 100.0 * constants.outliers, "readings that are wrong, per cent")
        .add("museum.bugs", Bug::ALL.len() as f64, "the bugs");
}

pub(super) fn list(to: &mut Listing) -> Result<(), Error> {
    let all: Vec<Bug> = [Bug::None].into_iter().chain(Bug::ALL).collect();
    let runs = |first: u32| -> Result<Vec<_>, Error> {
        all.iter().map(|bug| museum_runs([*bug, Bug::None], first, SEEDS)).collect()
    };
    // Those that the figure counts over, so that both say the same.
    let judged = runs(MuseumParams::default().seed)?;
    to.by("labs::bug_museum::Symptoms", None);
    for (bug, runs) in all.iter().zip(&judged) {
        // A share below the band is negative.
        let beyond = Symptoms::of(runs).beyond.map(|[below, above]| if below > above { -below } else { above });
        for (panel, figures) in PANELS {
            let further = |most: f64, &i: &usize| if beyond[i].abs() > most.abs() { beyond[i] } else { most };
            let most = 100.0 * figures.iter().fold(0.0, further);
            let about = "runs whose most telling figure of this panel is above a right filter's 95 % band, per cent; \
                         negative: below it";
            to.add(format!("museum.{}.{panel}", bug.word()), most, about);
        }
    }
    for (bug, figure) in TOLD {
        let runs = all.iter().zip(&judged).find(|(other, _)| **other == bug).map_or(&[][..], |(_, runs)| runs);
        let mean = runs.iter().map(|run| run[figure]).sum::<f64>() / runs.len() as f64;
        let id = format!("museum.{}.mean.{figure}", bug.word());
        to.add(id, mean, "the figure's mean over all runs");
    }
    let table: Vec<_> = all.iter().copied().zip(runs(TABLE)?.iter().map(|runs| Symptoms::of(runs))).collect();
    to.by("labs::bug_museum::diagnosed", None);
    for (name, together) in [("one", 1), ("five", TOGETHER)] {
        let share = |bug: Bug, runs: &[[f64; FIGURES]]| {
            let groups = runs.chunks_exact(together);
            groups.clone().filter(|some| diagnosed(&table, some) == Some(bug)).count() as f64 / groups.len() as f64
        };
        let shares: Vec<f64> = all.iter().zip(&judged).map(|(bug, runs)| 100.0 * share(*bug, runs)).collect();
        let mean = shares.iter().sum::<f64>() / shares.len() as f64;
        let least = shares.iter().copied().fold(100.0, f64::min);
        to.add(format!("museum.told.{name}"), mean, "filters named rightly by the symptom table alone, per cent").add(
            format!("museum.told.{name}.least"),
            least,
            "the same of the bug that is named least often",
        );
    }
    Ok(())
}
