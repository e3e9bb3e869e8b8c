//! Files of other programs that are no table: how each is known, and how a table is got out of it.

use crate::table::LOOKED_AT;
use crate::{markup, trajectory};

/// Why a file is refused that is a log of another program, with the way to a table.
pub(crate) fn refusal(name: &str, text: &str) -> Option<String> {
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let name = name.to_lowercase();
    let ends = |ending: &str| name.ends_with(ending) && text.chars().take(4000).any(|c| matches!(c, '\0' | '\u{fffd}'));
    let (what, way) = if text.starts_with("ULog") || ends(".ulg") {
        ("a ULog of PX4", "`ulog2csv FILE` (of `pip install pyulog`) writes a CSV of each topic")
    } else if text.starts_with("#ROSBAG") || ends(".bag") {
        ("a bag of ROS 1", "`rostopic echo -b FILE -p /odom > odom.csv` writes a CSV of a topic")
    } else if text.contains("MCAP0\r\n") && text.find("MCAP0") < Some(4) || ends(".mcap") {
        ("a bag of ROS 2 (MCAP)", "PlotJuggler opens it and saves topics as CSV")
    } else if text.starts_with("SQLite format 3") || ends(".db3") {
        ("a database, as a bag of ROS 2 is one", "PlotJuggler opens the bag and saves topics as CSV")
    } else if text.starts_with("PK\u{3}\u{4}") || ends(".xlsx") || ends(".ods") || ends(".zip") {
        ("a spreadsheet or an archive", "save its table as CSV")
    } else if ends(".bin") || ends(".tlog") {
        ("a log of ArduPilot", "`mavlogdump.py --format csv --types GPS FILE > gps.csv` writes a CSV of a message")
    } else if is_echo(text) {
        let way = "`ros2 topic echo --csv TOPIC > FILE`, of ROS 1 `rostopic echo -p TOPIC > FILE`, writes one";
        ("what `ros2 topic echo` prints", way)
    } else {
        markup::refusal(text).or_else(|| trajectory::refusal(text.lines().take(LOOKED_AT)))?
    };
    Some(format!("the file is {what}, and a table of text was expected: {way}"))
}

/// Whether a text is messages of ROS as they are printed: names and values one below the other.
fn is_echo(text: &str) -> bool {
    let mut lines = text.lines().map(str::trim).filter(|line| !line.is_empty() && *line != "---");
    let begins = lines.next().is_some_and(|first| first.ends_with(':') && !first.contains([',', ';', '\t', ' ']));
    begins && lines.take(8).any(|line| line.starts_with("stamp:"))
}
