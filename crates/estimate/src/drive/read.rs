//! What a row of a log says to a filter.

use crate::drive::course::Course;
use crate::drive::row::Event;
use crate::reading::Reading;
use core::f64::consts::PI;
use geom::wrap;
use nalgebra::Matrix2;

/// The reading of a row; `None` of a row of motion.
pub(crate) fn reading(course: &Course, event: &Event) -> Option<Reading> {
    let s = course.settings();
    Some(match *event {
        Event::Position { x, y, sigma } => {
            let sigma = s.of_fix(sigma);
            let w = Matrix2::identity() * (sigma * sigma);
            match course.antenna() {
                [0.0, 0.0] => Reading::Position { x, y, w },
                at => Reading::Antenna { x, y, at, w },
            }
        }
        Event::Heading { theta, sigma } => {
            let sigma = s.of_heading(sigma);
            let theta = if s.heading_offset == 0.0 { theta } else { wrap(theta - s.heading_offset) };
            Reading::Heading { theta, w: sigma * sigma }
        }
        Event::Range { landmark, range } => Reading::Range {
            landmark: Some(course.seen(landmark)),
            range: course.range_to(landmark, range),
            w: s.sigma_range * s.sigma_range,
        },
        Event::RangeBearing { landmark, range, bearing } => {
            let w = Matrix2::new(s.sigma_range * s.sigma_range, 0.0, 0.0, s.sigma_bearing * s.sigma_bearing);
            // A log has the bearing from the robot's nose.
            let bearing = if course.otherwise().clockwise { -bearing } else { bearing };
            let bearing = wrap(bearing - s.bearing_offset + PI);
            Reading::RangeBearing {
                landmark: Some(course.seen(landmark)),
                range: course.range_to(landmark, range),
                bearing,
                w,
            }
        }
        Event::Odometry { .. } | Event::Velocity { .. } | Event::Speed { .. } | Event::TurnRate { .. } => return None,
    })
}
