//! Reading files and folders.

use std::path::Path;

use walkdir::{DirEntry, WalkDir};

use crate::diagnostic::BuildError;

/// The text of a file.
///
/// # Errors
/// [`BuildError::File`] when it cannot be read.
pub fn read(path: &Path) -> Result<String, BuildError> {
    std::fs::read_to_string(path).map_err(BuildError::file(path))
}

/// The files below `folder`, sorted, by their paths from there. The packages of npm are left out.
///
/// # Errors
/// [`BuildError::File`] when a folder cannot be read.
pub fn below(folder: &Path) -> Result<Vec<String>, BuildError> {
    let ours = |entry: &DirEntry| entry.file_name() != "node_modules";
    let mut files = Vec::new();
    for entry in WalkDir::new(folder).follow_links(true).sort_by_file_name().into_iter().filter_entry(ours) {
        let entry = entry.map_err(|e| BuildError::file(folder)(e.into()))?;
        if entry.file_type().is_file() {
            let path = entry.path().strip_prefix(folder).unwrap_or(entry.path());
            files.push(path.to_string_lossy().replace('\\', "/"));
        }
    }
    Ok(files)
}
