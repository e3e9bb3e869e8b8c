//! The Picture: a prediction, the states that explain a reading, and the two ways of stepping onto them (§8.2.2–8.2.4).

use crate::lab::{Digest, Lab};
use crate::shapes::{Belief2, EllipseShape, pair, rows};
use estimate::kf::Gaussian;
use estimate::{Code, Error, validate};
use filters::Update;
use filters::covariance::symmetric;
use geom::{AffineSet, Ellipse};
use nalgebra::{Matrix1, Matrix2, RowVector2, Vector1, Vector2};
use numerics::Spd;
use serde::Serialize;

/// The shortest half-axis: a thinner ellipse would be a line on the screen.
const MIN_AXIS: f64 = 0.05;
/// The longest half-axis.
const MAX_AXIS: f64 = 10.0;
/// How far prediction and reading may lie from the origin.
const REACH: f64 = 100.0;
/// The largest W.
const MAX_NOISE: f64 = 100.0;

/// What the reader can change. The covariance is given by its axes, so that no drag can make it invalid.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(rename_all = "camelCase")]
pub struct PictureParams {
    /// x̂⁻, the prediction: m, m/s.
    pub mean: [f64; 2],
    /// Half the ellipse's first axis.
    pub semi_major: f64,
    /// Half the ellipse's second axis; may be the longer one.
    pub semi_minor: f64,
    /// Angle of the first axis, radians.
    pub angle: f64,
    /// y, the reading.
    pub reading: f64,
    /// W, the reading's variance; 0 for a perfect sensor.
    pub noise: f64,
    /// Turn of the sensor, radians: H = [−sin, cos], so 0 measures the velocity and −π/2 the position.
    pub tilt: f64,
}

impl Default for PictureParams {
    /// The first hand-checked step: x̂⁻ = [4, 4], P⁻ = [1.7 1.05; 1.05 2.1], y = 2.7, W = 0.5.
    fn default() -> Self {
        let e = Ellipse::from_covariance(&Matrix2::new(1.7, 1.05, 1.05, 2.1), 1.0);
        Self {
            mean: [4.0, 4.0],
            semi_major: e.semi_major,
            semi_minor: e.semi_minor,
            angle: e.angle,
            reading: 2.7,
            noise: 0.5,
            tilt: 0.0,
        }
    }
}

/// A step from the prediction, in both metrics.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Foot {
    /// Where it leads.
    pub at: [f64; 2],
    /// HΔx − ν, with the innovation against the line it should land on: zero when it does.
    pub residual: f64,
    /// aᵀΔx for the unit vector a along the line: zero when the step is perpendicular.
    pub euclidean: f64,
    /// aᵀP⁻¹Δx: zero when the step is perpendicular in the metric of the covariance.
    pub mahalanobis: f64,
    /// ‖Δx‖ in that metric: how many ellipses away the step leads.
    pub distance: f64,
    /// The equidistant ellipse through that point.
    pub ellipse: EllipseShape,
}

/// The picture.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(rename_all = "camelCase")]
pub struct PictureFrame {
    /// Always 0: nothing here goes by steps.
    pub step: u32,
    /// The parameters.
    pub params: PictureParams,
    /// x̂⁻ and P⁻.
    pub predicted: Belief2,
    /// x̂⁺ and P⁺.
    pub posterior: Belief2,
    /// H, its one row.
    #[serde(rename = "H")]
    pub h: [f64; 2],
    /// The unit vector along Ω.
    pub along: [f64; 2],
    /// ν.
    pub innovation: f64,
    /// S = HP⁻Hᵀ + W.
    #[serde(rename = "S")]
    pub s: f64,
    /// R, the gain.
    #[serde(rename = "R")]
    pub r: [f64; 2],
    /// Hx̂⁻, the output that the prediction expects.
    pub expected_output: f64,
    /// HP⁻Hᵀ, its variance.
    pub expected_variance: f64,
    /// y*.
    pub most_likely_output: f64,
    /// The perpendicular foot on Ω.
    pub euclidean_foot: Foot,
    /// The Mahalanobis foot on Ω.
    pub mahalanobis_foot: Foot,
    /// The Kalman update: the Mahalanobis foot on Ω*.
    pub update: Foot,
    /// P⁻ by rows.
    #[serde(rename = "P")]
    pub p: [[f64; 2]; 2],
}

/// The lab. It has no steps: [`Lab::run`] counts them and changes nothing else.
#[derive(Debug)]
pub struct Picture {
    frame: PictureFrame,
    digest: Digest,
    steps: u32,
}

impl Lab for Picture {
    const NAME: &'static str = "picture";
    type Params = PictureParams;
    type Frame = PictureFrame;

    fn new(params: PictureParams) -> Result<Self, Error> {
        for mean in params.mean {
            within(mean, (-REACH, REACH), "mean")?;
        }
        within(params.semi_major, (MIN_AXIS, MAX_AXIS), "semiMajor")?;
        within(params.semi_minor, (MIN_AXIS, MAX_AXIS), "semiMinor")?;
        within(params.reading, (-REACH, REACH), "reading")?;
        within(params.noise, (0.0, MAX_NOISE), "noise")?;
        validate::finite(params.angle, "angle")?;
        validate::finite(params.tilt, "tilt")?;
        let frame = picture(params)?;
        let mut digest = Digest::default();
        for foot in [&frame.euclidean_foot, &frame.mahalanobis_foot, &frame.update] {
            digest.take(&foot.at);
            digest.take(&[foot.distance]);
        }
        digest.take(frame.posterior.p.iter().flatten());
        digest.take(&[frame.innovation, frame.s, frame.most_likely_output]);
        Ok(Self { frame, digest, steps: 0 })
    }

    fn params(&self) -> &PictureParams {
        &self.frame.params
    }

    fn steps(&self) -> u32 {
        self.steps
    }

    fn advance(&mut self) -> Result<(), Error> {
        self.steps += 1;
        Ok(())
    }

    fn frame(&self) -> PictureFrame {
        self.frame.clone()
    }

    fn digest(&self) -> u64 {
        self.digest.value()
    }
}

fn within(value: f64, (least, most): (f64, f64), argument: &'static str) -> Result<(), Error> {
    if (least..=most).contains(&validate::finite(value, argument)?) {
        Ok(())
    } else {
        Err(Error::new(Code::Limit, argument, "is out of the picture's reach"))
    }
}

fn picture(params: PictureParams) -> Result<PictureFrame, Error> {
    let x = Vector2::from(params.mean);
    let turn = rotation(params.angle);
    let axes = Vector2::new(params.semi_major * params.semi_major, params.semi_minor * params.semi_minor);
    let p = symmetric(turn * Matrix2::from_diagonal(&axes) * turn.transpose());
    let sensor = rotation(params.tilt);
    let (along, h) = (sensor.column(0).into_owned(), RowVector2::new(sensor[(0, 1)], sensor[(1, 1)]));
    let (y, w) = (Vector1::new(params.reading), Matrix1::new(params.noise));

    let predicted = Gaussian { x, p };
    let (posterior, Update { innovation, s, k, .. }) = predicted.corrected(&y, &h, &w)?;
    let expected = Gaussian { x: h * x, p: h * p * h.transpose() };
    let most_likely = expected.product(&Gaussian { x: y, p: w })?.x;
    let no_foot = || Error::new(Code::InnovationNotPositiveDefinite, "semiMinor", "leaves no foot on the line");
    let (omega, omega_star) = (AffineSet { h, y }, AffineSet { h, y: most_likely });
    let metric = Spd::new(p).ok_or_else(no_foot)?;
    let foot = |set: &AffineSet<_, _>, at: Vector2<f64>| {
        let step = at - x;
        let scaled = metric.solve(&step);
        let distance = step.dot(&scaled).max(0.0).sqrt();
        Foot {
            at: pair(&at),
            residual: -set.residual(&at)[0],
            euclidean: along.dot(&step),
            mahalanobis: along.dot(&scaled),
            distance,
            ellipse: Ellipse::from_covariance(&p, distance).into(),
        }
    };
    Ok(PictureFrame {
        step: 0,
        params,
        predicted: (&predicted).into(),
        posterior: (&posterior).into(),
        h: [h[0], h[1]],
        along: pair(&along),
        innovation: innovation[0],
        s: s[0],
        r: pair(&k),
        expected_output: expected.x[0],
        expected_variance: expected.p[0],
        most_likely_output: most_likely[0],
        euclidean_foot: foot(&omega, omega.euclidean_foot(&x).ok_or_else(no_foot)?),
        mahalanobis_foot: foot(&omega, omega.mahalanobis_foot(&p, &x).ok_or_else(no_foot)?),
        update: foot(&omega_star, omega_star.mahalanobis_foot(&p, &x).ok_or_else(no_foot)?),
        p: rows(&p),
    })
}

fn rotation(angle: f64) -> Matrix2<f64> {
    let (s, c) = libm::sincos(angle);
    Matrix2::new(c, -s, s, c)
}

/// The ellipse that `P` of a picture draws, kept here so that a test can hold it to the given axes.
#[cfg(test)]
fn drawn(frame: &PictureFrame) -> EllipseShape {
    crate::shapes::ellipse_of(&Matrix2::new(frame.p[0][0], frame.p[0][1], frame.p[1][0], frame.p[1][1]))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(params: PictureParams) -> PictureFrame {
        Picture::new(params).expect("in reach").frame()
    }

    #[test]
    fn the_default_is_the_first_hand_checked_step() {
        let frame = of(PictureParams::default());
        let near = |a: f64, b: f64| (a - b).abs() < 1e-14;
        assert!(near(frame.p[0][0], 1.7) && near(frame.p[0][1], 1.05) && near(frame.p[1][1], 2.1));
        assert!(near(frame.posterior.x[0], 3.475) && near(frame.posterior.x[1], 2.95));
        assert!(near(frame.most_likely_output, 2.95) && near(frame.mahalanobis_foot.at[0], 3.35));
        assert_eq!(frame.euclidean_foot.at, [4.0, 2.7]);
    }

    #[test]
    fn the_update_is_the_filter_s_and_each_foot_is_perpendicular_in_its_metric() {
        for (angle, tilt) in [(0.3, 0.0), (-1.2, 0.7), (2.0, -1.5)] {
            let frame = of(PictureParams { angle, tilt, semi_minor: 0.4, ..PictureParams::default() });
            for i in 0..2 {
                assert!((frame.update.at[i] - frame.posterior.x[i]).abs() < 1e-13);
            }
            assert!(frame.euclidean_foot.euclidean.abs() < 1e-13 && frame.euclidean_foot.mahalanobis.abs() > 1e-3);
            for foot in [&frame.mahalanobis_foot, &frame.update] {
                assert!(foot.mahalanobis.abs() < 1e-12 && foot.residual.abs() < 1e-13);
            }
            assert!(frame.mahalanobis_foot.distance < frame.euclidean_foot.distance);
        }
    }

    #[test]
    fn without_noise_the_two_lines_meet() {
        let frame = of(PictureParams { noise: 0.0, ..PictureParams::default() });
        assert!((frame.most_likely_output - 2.7).abs() < 1e-15);
        assert!((frame.update.at[0] - frame.mahalanobis_foot.at[0]).abs() < 1e-14);
    }

    #[test]
    fn on_a_round_belief_the_two_feet_meet() {
        let frame = of(PictureParams { semi_major: 1.5, semi_minor: 1.5, tilt: 0.4, ..PictureParams::default() });
        for i in 0..2 {
            assert!((frame.euclidean_foot.at[i] - frame.mahalanobis_foot.at[i]).abs() < 1e-14);
        }
    }

    #[test]
    fn axes_may_change_places_and_the_ellipse_stays_what_it_is() {
        let frame = of(PictureParams { semi_major: 0.5, semi_minor: 2.0, angle: 0.0, ..PictureParams::default() });
        let e = drawn(&frame);
        assert!((e.semi_major - 2.0).abs() < 1e-15 && (e.semi_minor - 0.5).abs() < 1e-15);
        assert!((e.angle - core::f64::consts::FRAC_PI_2).abs() < 1e-15);
    }

    #[test]
    fn what_is_out_of_reach_is_refused_by_name() {
        let default = PictureParams::default();
        let refused = |params| Picture::new(params).expect_err("refused");
        assert_eq!(refused(PictureParams { semi_minor: 0.0, ..default }).argument, "semiMinor");
        assert_eq!(refused(PictureParams { semi_major: 11.0, ..default }).argument, "semiMajor");
        assert_eq!(refused(PictureParams { noise: -0.1, ..default }).code, Code::Limit);
        assert_eq!(refused(PictureParams { mean: [0.0, 101.0], ..default }).argument, "mean");
        assert_eq!(refused(PictureParams { reading: f64::NAN, ..default }).code, Code::NotFinite);
        assert_eq!(refused(PictureParams { tilt: f64::INFINITY, ..default }).argument, "tilt");
    }

    #[test]
    fn steps_change_nothing() {
        let mut picture = Picture::new(PictureParams::default()).expect("in reach");
        let before = (picture.frame(), picture.digest());
        picture.run(10).expect("within the limit");
        assert_eq!((picture.frame(), picture.digest()), before);
        assert_eq!(picture.steps(), 10);
    }
}
