//! Files that are opened together.

use robot_log::Files;

/// The files of a log, each by its name and its text.
pub fn files(all: &[(&str, &str)]) -> Files {
    let mut files = Files::default();
    all.iter().for_each(|(name, text)| files.add(name, text).expect(name));
    files
}
