//! Latitude and longitude to metres east and north of a point, on the ellipsoid of WGS 84.
//!
//! A fix has its place in space (ECEF), at the height of the ellipsoid; what is east and north of the first one is its
//! part along the tangent plane there. Ten kilometres away the plane is 4 mm shorter than the ground.

/// The equator's radius, m, and the flattening.
const A: f64 = 6_378_137.0;
const F: f64 = 1.0 / 298.257_223_563;

/// The point about which places are.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Origin {
    latitude: f64,
    longitude: f64,
    /// Whether it was said; else it is the first fix.
    said: bool,
}

impl Origin {
    /// The first fix, in degrees.
    pub fn new(latitude: f64, longitude: f64) -> Self {
        Self { latitude, longitude, said: false }
    }

    /// A point that was said, in degrees.
    pub fn said(latitude: f64, longitude: f64) -> Self {
        Self { latitude, longitude, said: true }
    }

    /// What is said of the places about it.
    pub fn note(&self) -> String {
        let first = if self.said { "" } else { "the first fix, " };
        format!("Positions are in metres east and north of {first}{self}.")
    }

    /// Metres east and north of it, of a point in degrees.
    pub fn metres(&self, latitude: f64, longitude: f64) -> [f64; 2] {
        self.local(latitude, longitude, 0.0, 0.0)
    }

    /// The same of a point with a height, seen from the origin at another.
    fn local(&self, latitude: f64, longitude: f64, height: f64, from: f64) -> [f64; 2] {
        let (here, there) = (space(self.latitude, self.longitude, from), space(latitude, longitude, height));
        let d = [there[0] - here[0], there[1] - here[1], there[2] - here[2]];
        let (sin_lat, cos_lat) = libm::sincos(self.latitude.to_radians());
        let (sin_lon, cos_lon) = libm::sincos(self.longitude.to_radians());
        [-sin_lon * d[0] + cos_lon * d[1], -sin_lat * cos_lon * d[0] - sin_lat * sin_lon * d[1] + cos_lat * d[2]]
    }
}

impl core::fmt::Display for Origin {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        let side = |degrees: f64, [plus, minus]: [char; 2]| if degrees < 0.0 { minus } else { plus };
        let (latitude, longitude) = (self.latitude, self.longitude);
        let (north, east) = (side(latitude, ['N', 'S']), side(longitude, ['E', 'W']));
        write!(f, "{:.5}\u{b0} {north}, {:.5}\u{b0} {east}", latitude.abs(), longitude.abs())
    }
}

/// A point in space, m from the earth's centre.
fn space(latitude: f64, longitude: f64, height: f64) -> [f64; 3] {
    let e2 = F * (2.0 - F);
    let (sin_lat, cos_lat) = libm::sincos(latitude.to_radians());
    let (sin_lon, cos_lon) = libm::sincos(longitude.to_radians());
    let n = A / libm::sqrt(1.0 - e2 * sin_lat * sin_lat);
    [(n + height) * cos_lat * cos_lon, (n + height) * cos_lat * sin_lon, (n * (1.0 - e2) + height) * sin_lat]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// MATLAB's documentation of `geodetic2enu` has the first (to its digits); all are of pymap3d 3.2.0.
    #[test]
    fn metres_east_and_north_are_those_of_others() {
        for (from, to, expected) in [
            ([46.017, 7.75, 1673.0], [45.976, 7.658, 4531.0], [-7134.757195979873, -4556.321513845217]),
            ([48.1371, 11.5754, 0.0], [48.1385, 11.575, 0.0], [-29.77015711694415, 155.6702808445894]),
            ([-33.8568, 151.2153, 0.0], [-33.8588, 151.214, 0.0], [-120.29857400212909, -221.84040059805034]),
            ([60.0, 179.9999, 0.0], [60.0, -179.9999, 0.0], [11.160000313940719, 1.686833456112479e-5]),
            ([0.0, 0.0, 0.0], [1e-5, 1e-5, 0.0], [1.1131949079327133, 1.1057427582159383]),
        ] {
            let found = Origin::new(from[0], from[1]).local(to[0], to[1], to[2], from[2]);
            for (found, expected) in found.into_iter().zip(expected) {
                // A double of the earth's radius has steps of a nanometre.
                assert!((found - expected).abs() < 1e-7, "{found} against {expected}");
            }
        }
        assert_eq!(Origin::new(48.0, 11.0).metres(48.0, 11.0), [0.0, 0.0]);
    }
}
