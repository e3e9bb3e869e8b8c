//! Trajectories of poses as programs of visual odometry write them, rows of numbers without a name: those of the TUM
//! benchmark, `timestamp tx ty tz qx qy qz qw`, and those of KITTI, the three upper rows of a pose's matrix.

/// What the columns of a TUM trajectory are called.
const TUM: [&str; 8] = ["timestamp", "tx", "ty", "tz", "qx", "qy", "qz", "qw"];
/// How far the squared length of a direction may be from 1, and how small a part of a turn is none.
const NEAR_ONE: f64 = 0.02;
const SMALL: f64 = 0.05;

/// The rows of so many numbers; `None` where there are not two of them.
fn rows<'t, const N: usize>(lines: impl Iterator<Item = &'t str>) -> Option<Vec<[f64; N]>> {
    let row = |line: &str| -> Option<[f64; N]> {
        let numbers: Option<Vec<f64>> = line.split_whitespace().map(|field| field.parse().ok()).collect();
        numbers?.try_into().ok()
    };
    let rows: Vec<[f64; N]> = lines.filter_map(row).collect();
    (rows.len() >= 2).then_some(rows)
}

fn is_direction(parts: &[f64]) -> bool {
    (parts.iter().map(|part| part * part).sum::<f64>() - 1.0).abs() < NEAR_ONE
}

/// The names of a TUM trajectory's columns, if the rows are those of one: eight numbers, the last four a quaternion
/// whose w stands last.
pub(crate) fn names<'t>(lines: impl Iterator<Item = &'t str>) -> Option<Vec<String>> {
    let rows = rows::<8>(lines)?;
    // Of a robot that turns about the vertical alone, x and y are 0: others write w first.
    let w_first = rows.iter().all(|row| row[5].abs() < SMALL && row[6].abs() < SMALL)
        && rows.iter().any(|row| row[4].abs() > SMALL);
    let later = rows.windows(2).all(|pair| pair[0][0] <= pair[1][0]);
    let sound = later && !w_first && rows.iter().all(|row| is_direction(&row[4..]));
    sound.then(|| TUM.map(String::from).to_vec())
}

/// Why rows of KITTI's poses are refused, with the way to a table.
pub(crate) fn refusal<'t>(lines: impl Iterator<Item = &'t str> + Clone) -> Option<(&'static str, &'static str)> {
    let lines = lines.filter(|line| !line.trim().is_empty());
    // Another table is known by its first line.
    let first = lines.clone().next().filter(|line| line.split_whitespace().count() == 12)?;
    let turned = |row: &[f64; 12]| [0, 4, 8].iter().all(|at| is_direction(&row[*at..at + 3]));
    let all = first.split_whitespace().all(|field| field.parse::<f64>().is_ok());
    (all && rows::<12>(lines)?.iter().all(turned)).then_some((
        "poses of KITTI, without their times",
        "`paste -d ' ' times.txt FILE | awk 'BEGIN {OFS=\",\"; print \"t,x,y,theta\"} {print $1, $13, -$5, atan2(-$4, \
         $12)}' > track.csv` puts the sequence\u{2019}s times beside them and takes the camera\u{2019}s way on the \
         ground",
    ))
}

/// Whether a quaternion is tilted so far that the heading of its axis of x may not be the robot's: by more than 60°.
pub(crate) fn is_tilted([x, y, z, w]: [f64; 4]) -> bool {
    let square = x * x + y * y + z * z + w * w;
    square > 0.0 && w * w + z * z - x * x - y * y < 0.5 * square
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn eight_numbers_with_a_quaternion_at_the_end_are_of_tum_and_one_whose_w_is_first_is_not() {
        let (sin, cos) = libm::sincos(0.2);
        let of = |turn: [f64; 4], at: f64| format!("{at} 1 2 0 {} {} {} {}", turn[0], turn[1], turn[2], turn[3]);
        let known = |turn: [f64; 4]| names([of(turn, 0.0), of(turn, 0.1)].iter().map(String::as_str)).is_some();
        assert!(known([0.0, 0.0, sin, cos]) && known([0.0, 0.0, 0.0, 1.0]));
        assert!(!known([cos, 0.0, 0.0, sin]), "w, x, y, z");
        assert!(!known([1.0, 1.0, 0.0, 0.0]), "no quaternion");
        let back = [of([0.0, 0.0, 0.0, 1.0], 0.1), of([0.0, 0.0, 0.0, 1.0], 0.0)];
        assert!(names(back.iter().map(String::as_str)).is_none(), "no times");
    }

    #[test]
    fn a_camera_that_looks_ahead_is_tilted_and_a_robot_on_a_slope_is_not() {
        // Its z points ahead and its x to the right.
        assert!(is_tilted([-0.5, 0.5, -0.5, 0.5]));
        let (sin, cos) = libm::sincos(0.2);
        assert!(!is_tilted([0.0, 0.0, sin, cos]) && !is_tilted([sin, 0.0, 0.0, cos]) && !is_tilted([0.0; 4]));
    }
}
