//! The filter as it runs while the robot drives, with each of the three ways to take a reading that comes late; and the
//! smoother, which has all of them at the times at which they were measured.

use super::drive::{Drive, Model, model, start};
use super::plan::{Plan, ticks};
use super::{LateCost, Way};
use estimate::Error;
use estimate::dynamic::{Belief, System, kalman_smooth};
use estimate::kf::Gaussian;
use filters::consistency::nees;
use nalgebra::{DMatrix, DVector, Matrix1, Matrix2, RowVector2, U2, Vector1, Vector2};
use sim::scenarios::THREE_SENSORS;

/// What the filter makes of a reading when it comes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Judged {
    /// Its place in the plan.
    pub reading: usize,
    pub innovation: f64,
    /// S.
    pub s: f64,
}

/// A run of the filter.
#[derive(Clone, Debug, Default)]
pub(super) struct Followed {
    /// The belief at each tick, as it was known then.
    pub live: Vec<Gaussian<U2>>,
    pub judged: Vec<Judged>,
}

/// The belief before all readings.
pub(super) fn first() -> Gaussian<U2> {
    let variances = Vector2::from(THREE_SENSORS.p0_sigma.map(|sigma| sigma * sigma));
    Gaussian { x: start(), p: Matrix2::from_diagonal(&variances) }
}

/// Filters a drive, tick by tick. A reading is put at the tick at which it comes, or, to go back, at the one at which
/// it was measured; from there the ticks up to the present are filtered anew.
///
/// # Errors
/// Whatever the core answers.
pub(super) fn follow(drive: &Drive, plan: &Plan, way: Way) -> Result<Followed, Error> {
    let mut run = Run { drive, plan, model: model()?, kept: vec![first()], placed: vec![Vec::new()] };
    let (mut next, mut judged) = (0, Vec::new());
    let mut live = run.kept.clone();
    for now in 1..=THREE_SENSORS.ticks {
        run.placed.push(Vec::new());
        let (mut from, first) = (now, next);
        while let Some(one) = plan.readings.get(next).filter(|one| one.came == now) {
            let place = if way == Way::GoBack { one.measured } else { now };
            if way != Way::Drop || one.measured == now {
                run.placed[place].push(next);
                from = from.min(place);
            }
            next += 1;
        }
        run.kept.truncate(from);
        for tick in from..=now {
            run.tick(tick, &mut |one| {
                if one.reading >= first {
                    judged.push(one);
                }
            })?;
        }
        live.extend(run.kept.last());
    }
    Ok(Followed { live, judged })
}

struct Run<'a> {
    drive: &'a Drive,
    plan: &'a Plan,
    model: &'a Model,
    /// The belief at each tick so far, as it is known now.
    kept: Vec<Gaussian<U2>>,
    /// The readings that are placed at each tick.
    placed: Vec<Vec<usize>>,
}

impl Run<'_> {
    /// Predicts from the tick before, and takes the readings placed here, the sensors as they are listed.
    fn tick(&mut self, tick: usize, tell: &mut dyn FnMut(Judged)) -> Result<(), Error> {
        let Model { f, g, v } = self.model;
        let u = Vector1::new(self.drive.inputs[tick - 1]);
        let mut belief = self.kept[tick - 1].predicted(f, v, Some((g, &u)))?;
        let readings = &self.plan.readings;
        self.placed[tick].sort_by_key(|i| (readings[*i].sensor, readings[*i].measured));
        for &reading in &self.placed[tick] {
            let one = readings[reading];
            let y = Vector1::new(self.drive.readings[one.measured][one.sensor]);
            let w = Matrix1::new(THREE_SENSORS.sigma[one.sensor] * THREE_SENSORS.sigma[one.sensor]);
            let (corrected, update) = belief.corrected(&y, &RowVector2::new(1.0, 0.0), &w)?;
            belief = corrected;
            tell(Judged { reading, innovation: update.innovation[0], s: update.s[0] });
        }
        self.kept.push(belief);
        Ok(())
    }
}

/// What a run costs from the settled time on.
///
/// # Errors
/// None with a covariance that can be factored.
pub(super) fn cost(drive: &Drive, live: &[Gaussian<U2>]) -> Result<LateCost, Error> {
    let (mut squares, mut sum, mut count) = (0.0, 0.0, 0.0);
    for (state, belief) in drive.states.iter().zip(live).skip(ticks(THREE_SENSORS.settled)) {
        let error = belief.x - state;
        squares += error[0] * error[0];
        sum += nees(&error, &belief.p)?;
        count += 1.0;
    }
    Ok(LateCost { rms: (squares / count).sqrt(), nees: sum / count })
}

/// The best track afterwards, at every tick but the first.
///
/// # Errors
/// Whatever the core answers.
pub(super) fn smoothed(drive: &Drive, plan: &Plan) -> Result<Vec<Belief>, Error> {
    let Model { f, g, v } = model()?;
    let dynamic = |m: &Matrix2<f64>| DMatrix::from_column_slice(2, 2, m.as_slice());
    let h = DMatrix::from_fn(3, 2, |_, j| if j == 0 { 1.0 } else { 0.0 });
    let w = DMatrix::from_fn(3, 3, |i, j| if i == j { THREE_SENSORS.sigma[i] * THREE_SENSORS.sigma[i] } else { 0.0 });
    let system = System::new(dynamic(f), DMatrix::from_column_slice(2, 1, g.as_slice()), h, dynamic(v), w)?;
    let Gaussian { x, p } = first();
    let belief = Belief { x: DVector::from_column_slice(x.as_slice()), p: dynamic(&p) };
    let mut rows = vec![vec![None; 3]; THREE_SENSORS.ticks];
    for one in &plan.readings {
        rows[one.measured - 1][one.sensor] = Some(drive.readings[one.measured][one.sensor]);
    }
    let inputs: Vec<Vec<f64>> = drive.inputs.iter().map(|u| vec![*u]).collect();
    kalman_smooth(&system, &belief, &inputs, &rows)
}
