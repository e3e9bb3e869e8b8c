//! The places of landmarks that stand in the rows of their sightings.

use crate::cells::Cells;
use crate::error::Error;
use crate::gathering::Gathering;
use estimate::Landmark;
use std::collections::BTreeMap;

/// Places of one landmark that are farther apart, m, are not one.
const APART: f64 = 0.01;

/// Where the rows of sightings say that landmarks are.
#[derive(Clone, Debug, Default)]
pub(crate) struct Placed {
    places: BTreeMap<u32, [f64; 2]>,
}

impl Placed {
    /// Takes the place of the landmark `id`, if the row has one.
    ///
    /// # Errors
    /// An earlier row has it elsewhere.
    pub fn take(&mut self, cells: Cells<'_>, id: u32) -> Result<(), Error> {
        let Some((x, y)) = cells.given("landmark x")?.zip(cells.given("landmark y")?) else { return Ok(()) };
        let [first_x, first_y] = *self.places.entry(id).or_insert([x, y]);
        if libm::hypot(x - first_x, y - first_y) <= APART {
            return Ok(());
        }
        let message = format!(
            "the landmark is at ({x}, {y}) here, and at ({first_x}, {first_y}) in an earlier row; one that stays where \
             it is was expected"
        );
        Err(cells.place("landmark x").refuse(message))
    }

    /// Places the landmarks of a log that has no list of them; what is to be said of it.
    ///
    /// # Errors
    /// There are more than a log has.
    pub fn onto(self, to: &mut Gathering) -> Result<Option<String>, Error> {
        if self.places.is_empty() {
            return Ok(None);
        }
        if to.has_landmarks() {
            return Ok(Some(
                "Landmarks are where their list has them: the places beside their sightings are not read.".into(),
            ));
        }
        let place = to.end();
        self.places.into_iter().try_for_each(|(id, [x, y])| to.landmark(place, Landmark { id, x, y }))?;
        Ok(None)
    }
}
