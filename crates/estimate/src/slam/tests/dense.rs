//! The structured filter against one of dense matrices.

use super::*;
use filters::linear::{self, Gain};
use nalgebra::DVector;

/// The same filter with dense matrices: every product written out, the stack in Joseph's form.
struct Dense {
    x: DVector<f64>,
    p: DMatrix<f64>,
}

impl Dense {
    fn of(slam: &EkfSlam) -> Self {
        let (x, p) = slam.belief();
        Self { x: DVector::from_column_slice(x), p }
    }

    fn predict(&mut self, u: &Vector2<f64>, v: &Matrix3<f64>) {
        let n = self.x.len();
        let pose = SE2::new(self.x[0], self.x[1], self.x[2]);
        let (mut f, mut v_all) = (DMatrix::identity(n, n), DMatrix::zeros(n, n));
        f.view_mut((0, 0), (3, 3)).copy_from(&Unicycle.jacobian(&pose, u));
        v_all.view_mut((0, 0), (3, 3)).copy_from(v);
        self.p = &f * &self.p * f.transpose() + v_all;
        self.x.fixed_rows_mut::<3>(0).copy_from(&Unicycle.f(&pose, u).to_vector());
    }

    fn update(&mut self, readings: &[(usize, LandmarkReading)]) {
        let (n, rows) = (self.x.len(), 2 * readings.len());
        let (mut h, mut nu, mut w) = (DMatrix::zeros(rows, n), DVector::zeros(rows), DMatrix::zeros(rows, rows));
        for (i, (j, reading)) in readings.iter().enumerate() {
            let c = 3 + 2 * j;
            let map = [Landmark { id: 0, x: self.x[c], y: self.x[c + 1] }];
            let (model, pose) = (RangeBearing { map: &map }, SE2::new(self.x[0], self.x[1], self.x[2]));
            let block = model.jacobian(&pose, 0).expect("apart");
            h.view_mut((2 * i, 0), (2, 3)).copy_from(&block);
            h.view_mut((2 * i, c), (2, 2)).copy_from(&-block.fixed_columns::<2>(0));
            let z = Vector2::new(reading.range, reading.bearing);
            nu.rows_mut(2 * i, 2).copy_from(&model.residual(&z, &model.h(&pose, 0).expect("apart")));
            w.view_mut((2 * i, 2 * i), (2, 2)).copy_from(&W);
        }
        let Gain { k, p, .. } = linear::gain(&self.p, &h, &w).expect("positive definite");
        self.x += k * nu;
        self.p = p;
    }
}

#[test]
fn the_structured_filter_is_the_dense_one() {
    let (mut slam, mut noise, mut truth) = (slam(), Noise(0.0), SE2::new(0.0, 0.0, 0.3));
    slam.update(&[0, 1, 2].map(|j| reading(&truth, j, &mut noise, true))).expect("founded");
    let mut dense = Dense::of(&slam);
    let v = Matrix3::from_diagonal(&Vector3::new(1e-4, 2e-4, 1e-4));
    for k in 0..60 {
        let u = Vector2::new(0.1, 0.05 * (k % 5) as f64);
        truth = Unicycle.f(&truth, &u);
        slam.predict(&u, &v).expect("finite");
        dense.predict(&u, &v);
        let seen: Vec<usize> = (0..3).filter(|j| k % (j + 2) != 0).collect();
        let readings: Vec<LandmarkReading> = seen.iter().map(|&j| reading(&truth, j, &mut noise, true)).collect();
        if !readings.is_empty() {
            let reports = slam.update(&readings).expect("sound");
            let used = |i: &usize| reports[*i].outcome == Outcome::Matched;
            dense.update(&(0..seen.len()).filter(used).map(|i| (seen[i], readings[i])).collect::<Vec<_>>());
        }
    }
    let (x, p) = slam.belief();
    assert!((DVector::from_column_slice(x) - &dense.x).amax() < 1e-12);
    assert!((&p - dense.p).amax() < 1e-14);
    for (j, landmark) in slam.landmarks().enumerate() {
        let c = 3 + 2 * j;
        assert_eq!((landmark.id, landmark.position.as_slice()), (WORLD[j].id, &x[c..c + 2]));
        assert_eq!(landmark.p, p.fixed_view::<2, 2>(c, c));
    }
}
