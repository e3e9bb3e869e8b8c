//! Names of columns that stand below another's. Some exports of ROS write `position,x,y,z,orientation,x,y,z,w`, where
//! the columns of `position` and `orientation` are empty and the others go by names that occur twice.

/// Between the name of a column and the words below it, where these say its unit or tell it from others of its name.
pub(crate) const BELOW: &str = " · ";

/// The names, each behind those that it stands below, as in `orientation.w`, and the columns of these heads. `empty`
/// says which columns hold nothing. `None` where no name occurs twice.
pub(crate) fn nested(names: &[String], empty: &[bool]) -> Option<(Vec<String>, Vec<usize>)> {
    let full = |i: &usize| !empty[*i];
    let twice = |i: usize| (0..i).filter(full).any(|j| names[j] == names[i]);
    if !(0..names.len()).filter(full).any(twice) || !empty.contains(&true) {
        return None;
    }
    let (mut path, mut below) = (Vec::<&str>::new(), false);
    let mut named = Vec::with_capacity(names.len());
    for (name, empty) in names.iter().zip(empty) {
        if *empty {
            if below {
                path.clear();
            }
            path.push(name);
            below = false;
            named.push(name.clone());
        } else {
            below = true;
            named.push(path.iter().copied().chain([name.as_str()]).collect::<Vec<_>>().join("."));
        }
    }
    Some((named, (0..names.len()).filter(|i| empty[*i]).collect()))
}

#[cfg(test)]
mod tests {
    use super::nested;

    #[test]
    fn a_name_that_occurs_twice_has_those_above_it() {
        let names = ["t", "pose", "position", "x", "y", "orientation", "x", "y", "w"].map(String::from);
        let empty = [false, true, true, false, false, true, false, false, false];
        let (told, heads) = nested(&names, &empty).expect("x occurs twice");
        assert_eq!(heads, [1, 2, 5]);
        assert_eq!(told[3..5], ["pose.position.x", "pose.position.y"]);
        assert_eq!(told[6..], ["orientation.x", "orientation.y", "orientation.w"]);
        assert_eq!(told[0], "t");
        assert_eq!(nested(&names[..5], &empty[..5]), None, "no name occurs twice");
        assert_eq!(nested(&names, &[false; 9]), None, "none is above another");
    }
}
