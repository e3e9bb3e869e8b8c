//! What the columns of `ros2 topic echo --csv` are called, which writes no names: they follow from the message.

/// The names of a message's fields, if a row without names has as many columns as one that is known, and the name of a
/// frame where that message has one.
pub(crate) fn names(row: &[&str]) -> Option<Vec<String>> {
    let is_text = |field: &&str| !field.is_empty() && field.parse::<f64>().is_err();
    let texts: Vec<usize> = (0..row.len()).filter(|i| is_text(&row[*i])).collect();
    let stamp = ["header.stamp.sec", "header.stamp.nanosec", "header.frame_id"];
    let point = |of: &str| ["x", "y", "z"].map(|axis| format!("{of}.{axis}"));
    let turned = |of: &str| ["x", "y", "z", "w"].map(|axis| format!("{of}.{axis}"));
    let spread = |of: &str, count: usize| (0..count).map(|i| format!("{of}covariance.{i}")).collect::<Vec<_>>();
    let mut names: Vec<String> = stamp.map(String::from).to_vec();
    match (row.len(), texts.as_slice()) {
        // nav_msgs/Odometry
        (89, [2, 3]) => {
            names.push("child_frame_id".into());
            names.extend(point("pose.pose.position"));
            names.extend(turned("pose.pose.orientation"));
            names.extend(spread("pose.", 36));
            names.extend(point("twist.twist.linear"));
            names.extend(point("twist.twist.angular"));
            names.extend(spread("twist.", 36));
        }
        // sensor_msgs/Imu
        (40, [2]) => {
            names.extend(turned("orientation"));
            names.extend(spread("orientation_", 9));
            names.extend(point("angular_velocity"));
            names.extend(spread("angular_velocity_", 9));
            names.extend(point("linear_acceleration"));
            names.extend(spread("linear_acceleration_", 9));
        }
        // sensor_msgs/NavSatFix
        (18, [2]) => {
            names.extend(["status.status", "status.service", "latitude", "longitude", "altitude"].map(String::from));
            names.extend(spread("position_", 9));
            names.push("position_covariance_type".into());
        }
        // geometry_msgs/TwistStamped
        (9, [2]) => {
            names.extend(point("twist.linear"));
            names.extend(point("twist.angular"));
        }
        // geometry_msgs/PoseStamped
        (10, [2]) => {
            names.extend(point("pose.position"));
            names.extend(turned("pose.orientation"));
        }
        _ => return None,
    }
    Some(names)
}
