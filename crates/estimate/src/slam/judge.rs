//! What becomes of a sighting: matched, rejected, or the first of a new landmark.

use super::EkfSlam;
use super::sighting::{Expected, LandmarkReading, Outcome, Report};
use crate::blame::Blame;
use crate::error::{Code, Error};
use alloc::vec::Vec;
use filters::association::{Association, Candidate, Rule, associate};
use nalgebra::{Matrix2, Vector2};

impl EkfSlam {
    /// What a sighting of this landmark is expected to be, [ρ, β], and the covariance S (2×2) of its innovation: the
    /// gate about it is {z : (z − ẑ)ᵀS⁻¹(z − ẑ) ≤ gate}.
    ///
    /// # Errors
    /// [`Code::Index`] for a number that is not in the map, [`Code::AtLandmark`] where the estimate stands on the
    /// landmark.
    pub fn expected_sighting(&self, id: u32) -> Result<(Vector2<f64>, Matrix2<f64>), Error> {
        let unknown = || Error::new(Code::Index, "landmark", "is not in the map");
        let j = self.index(id).ok_or_else(unknown)?;
        let expected = self.expected(j, &LandmarkReading { range: 0.0, bearing: 0.0, landmark: None })?;
        Ok((-expected.innovation, expected.s))
    }

    /// What is expected of landmark `j` at the present estimate.
    pub(super) fn expected(&self, j: usize, reading: &LandmarkReading) -> Result<Expected, filters::Error> {
        Expected::new(&self.x, &self.p, j, reading, &self.w)
    }

    /// What becomes of a reading; its expectation, when it is matched.
    pub(super) fn judged(
        &self,
        reading: &LandmarkReading,
        taken: &[usize],
        blame: Blame,
    ) -> Result<(Report, Option<Expected>), Error> {
        reading.check().map_err(|e| blame.field(e))?;
        self.associated(reading, taken).map_err(|e| blame.step(e.into()))
    }

    fn associated(
        &self,
        reading: &LandmarkReading,
        taken: &[usize],
    ) -> Result<(Report, Option<Expected>), filters::Error> {
        let weigh = |j| -> Result<Candidate<2>, filters::Error> {
            let e = self.expected(j, reading)?;
            Candidate::new(j, e.innovation, e.s, Rule::MaximumLikelihood)
        };
        let known = reading.landmark.and_then(|id| self.index(id));
        let association = match (reading.landmark, known) {
            (Some(_), Some(j)) => {
                let candidate = weigh(j)?;
                let within = candidate.d2 <= self.thresholds.gate;
                if within { Association::Matched(candidate) } else { Association::Rejected(candidate) }
            }
            (Some(_), None) => Association::New,
            (None, _) => {
                let (mut candidates, mut barred) = (Vec::with_capacity(self.len()), Vec::new());
                for j in 0..self.len() {
                    match weigh(j) {
                        Ok(candidate) if taken.contains(&j) => barred.push(candidate),
                        Ok(candidate) => candidates.push(candidate),
                        // A landmark under the robot has no bearing to compare with.
                        Err(filters::Error::AtFeature) => {}
                        Err(e) => return Err(e),
                    }
                }
                associate(&candidates, &barred, self.thresholds)
            }
        };
        Ok(match association {
            Association::Matched(c) => (self.report(Outcome::Matched, &c), Some(self.expected(c.j, reading)?)),
            Association::Rejected(c) => (self.report(Outcome::Rejected, &c), None),
            Association::New => {
                let landmark = reading.landmark.or_else(|| self.free_id(&[], &[]));
                (Report { outcome: Outcome::Founded, landmark, evidence: None }, None)
            }
        })
    }

    fn report(&self, outcome: Outcome, c: &Candidate<2>) -> Report {
        Report { outcome, landmark: Some(self.ids[c.j]), evidence: Some((c.innovation, c.s, c.d2)) }
    }
}
