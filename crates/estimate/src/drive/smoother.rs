//! The best track afterwards: the states of a replay in the light of all its readings (Rauch, Tung and Striebel 1965).

use crate::drive::course::Course;
use crate::drive::filter::Filter;
use crate::drive::learned::{Moved, Rolling};
use crate::drive::replay::{Replay, Taken};
use crate::drive::row::{Drive, Event};
use crate::drive::statistics::Errors;
use crate::drive::step::Step;
use crate::drive::summary::{Summary, Withheld};
use crate::ekf::Localizer;
use crate::error::{Code, Error};
use crate::gap::{Gap, Linear};
use alloc::format;
use alloc::vec::Vec;
use filters::{Ekf, MotionModel};
use geom::SE2;
use nalgebra::Matrix3;
use numerics::hypot;

/// So many steps are kept at a time: a replay is taken up again from the state before them.
const BLOCK: usize = 1024;

/// The smoothed pose at a row of motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SmoothedPose {
    /// The row's index.
    pub row: usize,
    /// When it was measured, s.
    pub time: f64,
    /// The pose.
    pub pose: SE2,
    /// Its covariance.
    pub p: Matrix3<f64>,
}

/// A smoothed replay.
///
/// Along the replay's own linearization, and with C = P Fᵀ P̄⁻¹ the gain by which the state before a step would be
/// corrected if the state after it were read, x(all) = x + C (x⁺(all) − x̄⁺) and P(all) = P + C (P⁺(all) − P̄⁺) Cᵀ. F
/// is that of all steps from one row to the next that is asked for or has a reading. The last state is the filter's, to
/// the last bit.
///
/// # Example
/// ```
/// use estimate::drive::{Course, Drive, Event, Motion, Replay, Row, Settings, Smoothed, Truth};
/// let (drives, fix) = (Event::Velocity { v: 1.0, omega: 0.0 }, |x| Event::Position { x, y: 0.0, sigma: None });
/// let rows = [(0.0, drives), (0.0, fix(0.0)), (5.0, drives), (10.0, drives), (10.0, fix(12.0))];
/// let rows = rows.map(|(time, event)| Row::new(time, event)).to_vec();
/// let drive = Drive { landmarks: Vec::new(), truth: Truth::default(), rows, motion: Motion::Velocity };
/// let course = Course::new(&drive, Settings { sigma_distance: 0.5, ..Settings::default() })?;
/// let mut replay = Replay::new(&course);
/// while replay.take(&drive, &course)?.is_some() {}
/// let smoothed = Smoothed::new(&drive, &course, &replay, 1)?;
/// // The fix says that the robot was faster; half-way, about half of that is known.
/// assert!(smoothed.track[1].pose.x() > 5.5 && smoothed.track[2].pose == replay.pose());
/// # Ok::<(), estimate::Error>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Smoothed {
    /// Poses at every so many rows of motion, by time.
    pub track: Vec<SmoothedPose>,
    errors: Errors,
    withheld: Errors,
}

impl Smoothed {
    /// Smooths what `replay` has taken of `drive`, and keeps the pose at every `stride`th row of motion.
    ///
    /// It replays the drive twice, keeping one state in every 1024 rows and what happened within 1024 rows: for a
    /// million rows it needs less than 2 MB beside its track.
    ///
    /// # Errors
    /// [`Code::InnovationNotPositiveDefinite`](crate::Code::InnovationNotPositiveDefinite), naming the row, where a P̄
    /// cannot be factored, or [`Code::NotFinite`](crate::Code::NotFinite).
    pub fn new(drive: &Drive, course: &Course, replay: &Replay, stride: usize) -> Result<Self, Error> {
        let asked = Asked { drive, course, steps: replay.steps(), stride: stride.max(1) };
        match &replay.filter {
            Filter::Three(last) => {
                smoothed(&asked, last, |it| if let Filter::Three(of) = it { Some(of) } else { None })
            }
            Filter::Six(last) => smoothed(&asked, last, |it| if let Filter::Six(of) = it { Some(of) } else { None }),
        }
    }

    fn take<X: Moved<N>, const N: usize>(&mut self, done: &Done<X, N>, smoothed: &Ekf<X, N>) {
        let pose = smoothed.x.pose();
        let far = |[x, y]: [f64; 2]| hypot(pose.x() - x, pose.y() - y);
        if let Some(truth) = done.truth {
            self.errors.take(far(truth));
        }
        if let Some(fix) = done.fix {
            self.withheld.take(far(fix));
        }
        if done.kept {
            let p = smoothed.p.fixed_view::<3, 3>(0, 0).into_owned();
            self.track.push(SmoothedPose { row: done.taken.row, time: done.taken.time, pose, p });
        }
    }

    /// The same summary with what the smoothed track says.
    #[must_use]
    pub fn told(&self, summary: Summary) -> Summary {
        let (rms_smoothed, worst_smoothed) = (self.withheld.rmse(), self.withheld.worst());
        let withheld = summary.withheld.map(|withheld| Withheld { rms_smoothed, worst_smoothed, ..withheld });
        Summary { rmse_smoothed: self.errors.rmse(), withheld, ..summary }
    }
}

/// What is smoothed.
struct Asked<'a> {
    drive: &'a Drive,
    course: &'a Course,
    steps: usize,
    stride: usize,
}

/// What a step of the replay did.
struct Done<X, const N: usize> {
    taken: Taken,
    /// The rows behind it, itself included.
    rows: u32,
    /// F and V, where the estimate moved.
    moved: Option<Linear<N>>,
    /// The belief after the motion, and after the reading.
    predicted: Ekf<X, N>,
    after: Ekf<X, N>,
    /// The true position at a row of motion.
    truth: Option<[f64; 2]>,
    /// A fix that was withheld.
    fix: Option<[f64; 2]>,
    /// Whether the pose is kept.
    kept: bool,
}

impl<X, const N: usize> Done<X, N> {
    /// Whether the smoothed state is asked for here, or a reading corrected the estimate.
    fn stops(&self) -> bool {
        let corrected = self.taken.judged.is_some_and(|judged| judged.used);
        corrected || self.kept || self.truth.is_some() || self.fix.is_some()
    }
}

/// A replay at a step, and how many rows of motion it has behind it.
#[derive(Clone, Copy)]
struct Mark {
    replay: Replay,
    motions: usize,
}

impl Mark {
    /// Counts a step that was taken, and answers whether it is a row of motion.
    fn count(&mut self, step: &Step, taken: &Taken) -> bool {
        let motion = step.event.is_motion() && step.counts && !taken.early;
        self.motions += usize::from(motion);
        motion
    }

    /// Goes over the next step.
    fn pass(&mut self, Asked { drive, course, .. }: &Asked<'_>) -> Result<(), Error> {
        if let Some(step) = course.step(drive, self.replay.steps()) {
            let taken = self.replay.step(drive, course, &step)?;
            self.count(&step, &taken);
        }
        Ok(())
    }

    /// Takes the next step. `of` answers the localizer of the filter.
    fn take<X: Moved<N>, const N: usize>(
        &mut self,
        asked: &Asked<'_>,
        of: impl Fn(&Filter) -> Option<&Localizer<X, N>>,
    ) -> Result<Option<Done<X, N>>, Error>
    where
        Rolling: MotionModel<X, N, 2>,
    {
        let Asked { drive, course, stride, .. } = *asked;
        let belief = |replay: &Replay| of(&replay.filter).map(|localizer| localizer.filter);
        let (Some(step), Some(before)) = (course.step(drive, self.replay.steps()), belief(&self.replay)) else {
            return Ok(None);
        };
        let moved = self.replay.moved(course, &step);
        self.replay.advance(&step, moved.as_ref())?;
        let predicted = belief(&self.replay);
        let taken = self.replay.read(drive, course, &step)?;
        self.replay.pass(&step);
        let (Some(predicted), Some(after)) = (predicted, belief(&self.replay)) else { return Ok(None) };
        let moved = moved.map(|it| Linear { f: it.rolling.jacobian(&before.x, &it.u), v: it.process(&before.x) });
        let motion = self.count(&step, &taken);
        let kept = motion && (self.motions - 1).is_multiple_of(stride);
        let truth = drive.truth.position(step.time).filter(|_| motion);
        let fix = match step.event {
            Event::Position { x, y, .. } => taken.withheld.map(|_| [x, y]),
            _ => None,
        };
        Ok(Some(Done { taken, rows: self.replay.rows(), moved, predicted, after, truth, fix, kept }))
    }
}

fn smoothed<X: Moved<N>, const N: usize>(
    asked: &Asked<'_>,
    last: &Localizer<X, N>,
    of: impl Fn(&Filter) -> Option<&Localizer<X, N>>,
) -> Result<Smoothed, Error>
where
    Rolling: MotionModel<X, N, 2>,
{
    let mut mark = Mark { replay: Replay::new(asked.course), motions: 0 };
    let mut marks = Vec::with_capacity(asked.steps / BLOCK + 1);
    for step in 0..asked.steps {
        if step % BLOCK == 0 {
            marks.push(mark);
        }
        mark.pass(asked)?;
    }
    let mut answer = Smoothed::default();
    let mut gap = Gap::new(&last.filter);
    let mut block = Vec::with_capacity(BLOCK);
    for (i, mut mark) in marks.into_iter().enumerate().rev() {
        for _ in 0..BLOCK.min(asked.steps - i * BLOCK) {
            block.extend(mark.take(asked, &of)?);
        }
        while let Some(done) = block.pop() {
            if done.stops() {
                gap.close(&done.after, &done.predicted).map_err(|e| refused(e, done.rows, done.taken.time))?;
                answer.take(&done, gap.smoothed());
            }
            if let Some(moved) = &done.moved {
                gap.widen(moved);
            }
        }
    }
    answer.track.reverse();
    Ok(answer)
}

/// Why the smoother cannot go back to the row that was measured at `time`; `row` counts the rows of motion and readings
/// as they are replayed, from 1.
#[cold]
fn refused(error: filters::Error, row: u32, time: f64) -> Error {
    let at = format!("row {row} of the replay, measured at {time} s");
    let (code, message) = match error {
        filters::Error::InnovationNotPositiveDefinite => {
            (Code::InnovationNotPositiveDefinite, format!("cannot be factored behind {at}"))
        }
        _ => (Code::NotFinite, format!("leaves the range of numbers at {at}")),
    };
    Error::new(code, "P", message)
}
