//! The rigid motion that brings a truth onto the fixes: a turn, a shift, and a mirror where the axes have another hand.
//! In the plane least squares has a closed form: the turn is the direction of one sum of products.

use estimate::drive::{Event, Pose, Row, Truth};

/// The most fixes that are compared: of more, as many are taken evenly.
const MOST_FIXES: usize = 2000;
/// Between true poses this far apart in time, s, or three times as far as they usually are, nothing is known.
const GAP: f64 = 2.0;

/// A motion of the plane that keeps distances: x and y are mirrored (y becomes −y) where it is said so, then turned
/// about the origin, then shifted.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rigid {
    /// Whether the axes have another hand.
    pub mirrored: bool,
    /// rad, counter-clockwise.
    pub turn: f64,
    /// m.
    pub shift: [f64; 2],
}

impl Rigid {
    /// Where a place comes to lie.
    pub fn place(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let (sin, cos) = (libm::sin(self.turn), libm::cos(self.turn));
        let y = if self.mirrored { -y } else { y };
        [cos * x - sin * y + self.shift[0], sin * x + cos * y + self.shift[1]]
    }

    /// Where a pose comes to lie, its heading with it.
    pub(crate) fn pose(&self, pose: Pose) -> Pose {
        let [x, y] = self.place([pose.x, pose.y]);
        Pose { x, y, theta: self.turn + if self.mirrored { -pose.theta } else { pose.theta }, ..pose }
    }
}

/// The truth as a path that is asked for places at times.
pub(crate) struct Path<'a> {
    truth: &'a Truth,
    gap: f64,
}

impl<'a> Path<'a> {
    /// `None` of less than three poses.
    pub fn new(truth: &'a Truth) -> Option<Self> {
        let mut apart: Vec<f64> = truth.poses().windows(2).map(|two| two[1].time - two[0].time).collect();
        apart.sort_unstable_by(f64::total_cmp);
        let usual = apart.get(apart.len() / 2).filter(|_| apart.len() > 1)?;
        Some(Self { truth, gap: GAP.max(3.0 * usual) })
    }

    /// The first and the last time.
    pub fn span(&self) -> [f64; 2] {
        let poses = self.truth.poses();
        [poses[0].time, poses[poses.len() - 1].time]
    }

    /// Where the truth is at a time that lies between two poses near one another.
    pub fn at(&self, time: f64) -> Option<[f64; 2]> {
        let poses = self.truth.poses();
        let after = poses.partition_point(|pose| pose.time <= time);
        let (before, next) = (poses.get(after.checked_sub(1)?)?, poses.get(after)?);
        if next.time - before.time > self.gap {
            return None;
        }
        self.truth.position(time)
    }
}

/// A fix: its time and its place.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Fix {
    pub time: f64,
    pub at: [f64; 2],
}

/// The fixes of a log between two times.
pub(crate) fn fixes(rows: &[Row], [from, to]: [f64; 2]) -> Vec<Fix> {
    let within = rows.iter().filter(|row| from <= row.time && row.time <= to);
    let all: Vec<Fix> = within
        .filter_map(|row| match row.event {
            Event::Position { x, y, .. } => Some(Fix { time: row.time, at: [x, y] }),
            _ => None,
        })
        .collect();
    all.iter().step_by(all.len().div_ceil(MOST_FIXES).max(1)).copied().collect()
}

/// The sums over fixes and the truth at their times from which every fit follows.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Sums {
    pub count: f64,
    /// The means of the fixes and of the truth.
    means: [[f64; 2]; 2],
    /// The sums of squares about them.
    squares: [f64; 2],
    /// The sums of scalar and vector products about them, of the truth as it is and mirrored.
    products: [[f64; 2]; 2],
    /// The mean square distance of the fixes from the truth as it is.
    pub same: f64,
}

impl Sums {
    /// Of the fixes, and of the truth whose stamps are shifted by `delay`; `None` where less than three are known.
    pub fn new(fixes: &[Fix], path: &Path<'_>, delay: f64) -> Option<Self> {
        let pairs = || fixes.iter().filter_map(|fix| Some((fix.at, path.at(fix.time - delay)?)));
        let (mut count, mut means, mut apart) = (0.0, [[0.0; 2]; 2], 0.0);
        for (fix, truth) in pairs() {
            count += 1.0;
            for i in 0..2 {
                means[0][i] += fix[i];
                means[1][i] += truth[i];
                apart += (fix[i] - truth[i]) * (fix[i] - truth[i]);
            }
        }
        if count < 3.0 {
            return None;
        }
        let means = means.map(|sums| sums.map(|sum| sum / count));
        let (mut squares, mut products) = ([0.0; 2], [[0.0; 2]; 2]);
        for (fix, truth) in pairs() {
            let [f, p] = [[fix, means[0]], [truth, means[1]]].map(|[at, mean]| [at[0] - mean[0], at[1] - mean[1]]);
            squares[0] += f[0] * f[0] + f[1] * f[1];
            squares[1] += p[0] * p[0] + p[1] * p[1];
            for (sums, y) in products.iter_mut().zip([p[1], -p[1]]) {
                sums[0] += p[0] * f[0] + y * f[1];
                sums[1] += p[0] * f[1] - y * f[0];
            }
        }
        Some(Self { count, means, squares, products, same: apart / count })
    }

    fn product(&self, mirrored: bool) -> [f64; 2] {
        self.products[usize::from(mirrored)]
    }

    /// The mean square distance once the truth has been turned and shifted.
    pub fn rigid(&self, mirrored: bool) -> f64 {
        let [along, across] = self.product(mirrored);
        ((self.squares[0] + self.squares[1] - 2.0 * libm::hypot(along, across)) / self.count).max(0.0)
    }

    /// That once it has been shifted alone.
    pub fn shifted(&self) -> f64 {
        ((self.squares[0] + self.squares[1] - 2.0 * self.products[0][0]) / self.count).max(0.0)
    }

    /// That once it has been stretched as well.
    pub fn stretched(&self, mirrored: bool) -> f64 {
        let [along, across] = self.product(mirrored);
        ((self.squares[0] - (along * along + across * across) / self.squares[1]) / self.count).max(0.0)
    }

    /// The mean square distance of the truth from its middle.
    pub fn spread(&self) -> f64 {
        self.squares[1] / self.count
    }

    /// The motion of least squares; of a shift alone where `turns` is false.
    pub fn motion(&self, mirrored: bool, turns: bool) -> Rigid {
        let [along, across] = self.product(mirrored);
        let turn = if turns { libm::atan2(across, along) } else { 0.0 };
        let middle = Rigid { mirrored, turn, shift: [0.0; 2] }.place(self.means[1]);
        Rigid { mirrored, turn, shift: [self.means[0][0] - middle[0], self.means[0][1] - middle[1]] }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_motion_of_least_squares_is_found_to_the_last_digits_mirrored_or_not() {
        let pose = |i: i32| {
            let t = f64::from(i) / 10.0;
            Pose { time: t, x: 3.0 * libm::sin(0.3 * t) + 0.1 * t, y: 5.0 * libm::cos(0.21 * t), theta: 0.0 }
        };
        let poses: Vec<Pose> = (0..600).map(pose).collect();
        let truth = Truth::new(poses.clone());
        let path = Path::new(&truth).expect("poses");
        for (mirrored, turn) in [(false, -0.7), (true, 2.4), (false, 3.1)] {
            let wanted = Rigid { mirrored, turn, shift: [120.0, -7.0] };
            let fix = |pose: &Pose| Fix { time: pose.time + 1.5, at: wanted.place([pose.x, pose.y]) };
            let fixes: Vec<Fix> = poses.iter().map(fix).collect();
            let sums = Sums::new(&fixes, &path, 1.5).expect("pairs");
            let found = sums.motion(mirrored, true);
            assert!((found.turn - turn).abs() < 1e-9 && (found.shift[0] - 120.0).abs() < 1e-7, "{found:?}");
            assert!(sums.rigid(mirrored) < 1e-9 && sums.rigid(!mirrored) > 0.5);
            assert!((sums.stretched(mirrored) - sums.rigid(mirrored)).abs() < 1e-9);
        }
    }
}
