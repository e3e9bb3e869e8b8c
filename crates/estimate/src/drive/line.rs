//! A straight line through points: what a range's error says of its scale and its offset.

/// The line y = slope · x + offset with the least squared distances to its points, along y.
///
/// Through (true range, range read less true range) its slope is the radio's ε, and its value at 0 the radio's offset.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Line {
    /// y for each x.
    pub slope: f64,
    /// y at x = 0.
    pub offset: f64,
    /// R²: the share of the variance of y that the line explains, 0 to 1.
    pub r2: f64,
}

/// The sums that a [`Line`] is found from; constant memory however many points there are.
///
/// # Example
/// ```
/// let mut points = estimate::drive::Points::default();
/// [(10.0, 1.7), (20.0, 2.4), (30.0, 3.1)].into_iter().for_each(|(x, y)| points.take(x, y));
/// let line = points.line().expect("two or more places");
/// assert!((line.slope - 0.07).abs() < 1e-12 && (line.offset - 1.0).abs() < 1e-12 && line.r2 > 0.999);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Points {
    count: u32,
    /// The first point: the sums are over the others' distance from it, which costs no digits where all points are far
    /// from 0.
    first: [f64; 2],
    sum: [f64; 2],
    xx: f64,
    xy: f64,
    yy: f64,
}

impl Points {
    /// Takes a point.
    pub fn take(&mut self, x: f64, y: f64) {
        if self.count == 0 {
            self.first = [x, y];
        }
        self.count += 1;
        let (x, y) = (x - self.first[0], y - self.first[1]);
        self.sum[0] += x;
        self.sum[1] += y;
        self.xx += x * x;
        self.xy += x * y;
        self.yy += y * y;
    }

    /// The line. `None` where all points have one x, or where the sums have no digits left.
    pub fn line(&self) -> Option<Line> {
        if self.count < 2 {
            return None;
        }
        let n = f64::from(self.count);
        let [x, y] = self.sum.map(|sum| sum / n);
        let (xx, xy, yy) = (self.xx - n * x * x, self.xy - n * x * y, self.yy - n * y * y);
        let slope = xy / xx;
        let offset = self.first[1] + y - slope * (self.first[0] + x);
        let r2 = if yy > 0.0 { (slope * xy / yy).clamp(0.0, 1.0) } else { 0.0 };
        // Where all x are one, rounding leaves a little of either sign.
        let apart = xx > 1e-12 * self.xx;
        (apart && slope.is_finite() && offset.is_finite()).then_some(Line { slope, offset, r2 })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn line(points: &[(f64, f64)]) -> Option<Line> {
        let mut sums = Points::default();
        points.iter().for_each(|(x, y)| sums.take(*x, *y));
        sums.line()
    }

    #[test]
    fn the_residuals_of_the_line_have_no_slope_and_no_mean() {
        let points: Vec<(f64, f64)> =
            (0..50).map(|i| (1e4 + f64::from(i), libm::cos(f64::from(i)) + 0.07 * f64::from(i))).collect();
        let Line { slope, offset, r2 } = line(&points).expect("apart");
        let off = |&(x, y): &(f64, f64)| y - slope * x - offset;
        let mean = points.iter().map(off).sum::<f64>() / 50.0;
        let lean = points.iter().map(|p| off(p) * (p.0 - 1e4)).sum::<f64>() / 50.0;
        assert!(mean.abs() < 1e-9 && lean.abs() < 1e-7, "{mean} {lean}");
        let y = points.iter().map(|p| p.1).sum::<f64>() / 50.0;
        let unexplained = points.iter().map(|p| off(p) * off(p)).sum::<f64>()
            / points.iter().map(|p| (p.1 - y) * (p.1 - y)).sum::<f64>();
        assert!((r2 - (1.0 - unexplained)).abs() < 1e-9);
    }

    #[test]
    fn points_above_one_another_have_no_line() {
        assert_eq!(line(&[]), None);
        assert_eq!(line(&[(1.0, 2.0)]), None);
        assert_eq!(line(&[(0.1, 2.0), (0.1, 3.0), (0.1, 4.0)]), None);
        let level = line(&[(0.0, 2.0), (1.0, 2.0)]).expect("apart");
        assert_eq!((level.slope, level.offset, level.r2), (0.0, 2.0, 0.0), "nothing to explain");
    }
}
