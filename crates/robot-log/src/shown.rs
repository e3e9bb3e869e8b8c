//! What a page shows of a file besides its values: the columns that are not read, as a value that was dropped shows
//! there, and what answers the question of what the file is.

use crate::file::File;
use crate::files::Files;
use crate::quaternion;
use crate::role::Role;
use crate::unit::QUATERNION;

impl Files {
    /// The columns of a file from which nothing is read, neither as what it is nor where it is read once more; none of
    /// a file that is another read once more.
    pub fn unread(&self, file: usize) -> Vec<usize> {
        let files = self.files();
        let Some(read) = files.get(file).filter(|it| it.again().is_none()) else { return Vec::new() };
        let says = |it: &&File| it.again() == Some(file) && !matches!(it.role(), Role::Undecided | Role::Unused);
        let again: Vec<Vec<usize>> = files.iter().filter(says).map(File::unread).collect();
        let mut unread = read.unread();
        unread.retain(|column| again.iter().all(|left| left.contains(column)));
        unread
    }
}

impl File {
    /// The columns from which nothing is read, in their order; none of a file that is no table or is not used.
    pub fn unread(&self) -> Vec<usize> {
        let source = &self.source;
        if source.table.is_none() || matches!(source.role, Role::Log | Role::Undecided | Role::Unused) {
            return Vec::new();
        }
        let mut read: Vec<usize> = source.columns.iter().flatten().copied().collect();
        // A quaternion is read from four columns, of which one is chosen, and ranges from all that are like the first.
        let turned =
            source.columns.iter().zip(&source.units).filter(|(_, unit)| unit.is_some_and(|it| it.name == QUATERNION));
        let turned = turned.filter_map(|(column, _)| quaternion::columns(&source.names, (*column)?));
        read.extend(turned.flatten().collect::<Vec<_>>());
        if source.role == Role::Ranges {
            read.extend(source.ranges().into_iter().map(|(_, at)| at));
        }
        read.extend(source.several.iter().map(|several| several.column));
        // A head names the columns behind it and holds nothing itself.
        let heads = source.table.as_ref().map_or(&[][..], |table| &table.heads);
        (0..self.header().len()).filter(|at| !read.contains(at) && !heads.contains(at)).collect()
    }

    /// The roles that the question of what the file is names as its answers; none where it is not asked, or where any
    /// may be one.
    pub fn answers(&self) -> &'static [Role] {
        self.source.undecided.as_ref().map_or(&[], |asked| asked.answers)
    }
}
