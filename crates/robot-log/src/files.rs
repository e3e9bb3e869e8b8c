//! The files of a log as others write them: the five of a UTIAS MRCLAM data set, or plain tables of motion, sightings,
//! landmarks and truth.

use crate::error::Error;
use crate::guess;
use crate::log::{MAX_BYTES, Understood};
use crate::parse;
use crate::reading::{Cells, Reading};
use crate::role::{ANGLES, LENGTHS, Role, TIMES, Units};
use crate::source::Source;
use std::collections::HashMap;

/// The most files of a log.
pub const MAX_FILES: usize = 16;

/// A file of a log, and how it is read.
#[derive(Clone, Debug, PartialEq)]
pub struct File {
    name: String,
    text: String,
    source: Source,
}

impl File {
    /// Its name.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// What it is read as.
    pub fn role(&self) -> Role {
        self.source.role
    }

    /// What its columns are called; none of a file that is no table.
    pub fn header(&self) -> &[String] {
        self.source.table.as_ref().map_or(&[], |table| &table.names)
    }

    /// For each value of its role the column that it is read from.
    pub fn columns(&self) -> &[Option<usize>] {
        &self.source.columns
    }

    /// Its units.
    pub fn units(&self) -> &Units {
        &self.source.units
    }
}

/// The files of one log.
///
/// # Example
/// ```
/// let mut files = robot_log::Files::default();
/// files.add("wheels.csv", "time_ms,v,omega\n0,0.5,0\n100,0.5,0.1\n")?;
/// let read = files.read()?;
/// assert_eq!(read.log.drive.span(), Some([0.0, 0.1]));
/// # Ok::<(), robot_log::Error>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Files {
    files: Vec<File>,
}

impl Files {
    /// Adds a file, and guesses how it is to be read: by what its columns are called, by its name, and by its numbers.
    ///
    /// # Errors
    /// There are [`MAX_FILES`] files already, or together they are larger than [`MAX_BYTES`]. The fault stands in no
    /// line.
    pub fn add(&mut self, name: &str, text: &str) -> Result<(), Error> {
        let at = self.files.len();
        let bytes = self.files.iter().map(|file| file.text.len()).sum::<usize>() + text.len();
        let refuse = |message: String| Err(Error::of_all(message).within(at));
        if at == MAX_FILES {
            return refuse(format!("a log has at most {MAX_FILES} files, and these are more"));
        }
        if bytes > MAX_BYTES {
            return refuse(format!("the log has {bytes} bytes; at most {MAX_BYTES} were expected"));
        }
        // Some spreadsheets end a line with a carriage return alone.
        let text = if text.contains('\n') { text.to_string() } else { text.replace('\r', "\n") };
        let source = guess::guess(name, &text);
        self.files.push(File { name: name.to_string(), text, source });
        Ok(())
    }

    /// The files in the order in which they were added.
    pub fn files(&self) -> &[File] {
        &self.files
    }

    /// Reads a file as another role, its columns guessed anew. Answers whether there is such a file.
    pub fn set_role(&mut self, file: usize, role: Role) -> bool {
        let Some(file) = self.files.get_mut(file) else { return false };
        file.source.role = role;
        file.source.columns = guess::columns(role, file.source.table.as_ref().map_or(&[], |table| &table.names));
        true
    }

    /// Reads a value from another column of its file, or from none. Answers whether there are such a value and such a
    /// column.
    pub fn set_column(&mut self, file: usize, value: &str, column: Option<usize>) -> bool {
        let Some(file) = self.files.get_mut(file) else { return false };
        let Some(at) = file.role().values().iter().position(|it| it.name == value) else { return false };
        if column.is_some_and(|column| column >= file.header().len()) {
            return false;
        }
        file.source.columns[at] = column;
        true
    }

    /// Reads a file in another unit of time, length or angle. Answers whether there are such a file and such a unit.
    pub fn set_unit(&mut self, file: usize, unit: &str) -> bool {
        let Some(file) = self.files.get_mut(file) else { return false };
        let units = &mut file.source.units;
        let named = |all: &[(&'static str, f64)]| all.iter().map(|(name, _)| *name).find(|name| *name == unit);
        if let Some(time) = named(&TIMES) {
            units.time = time;
        } else if let Some(length) = named(&LENGTHS) {
            units.length = length;
        } else if let Some(angle) = ANGLES.into_iter().find(|name| *name == unit) {
            units.angle = angle;
        } else {
            return false;
        }
        true
    }

    /// The log that the files make.
    ///
    /// # Errors
    /// As [`parse`](crate::parse), naming the file; a value that a role needs has no column; a file is empty; a name in
    /// its header is too long, or its quotes are not closed. Where no
    /// file has the robot's motion, the fault is of all together, and the message says what each was read as.
    pub fn read(&self) -> Result<Understood, Error> {
        let empty = |file: &File| file.text.trim_matches([' ', '\n', '\r', '\t', '\u{feff}']).is_empty();
        if let Some(at) = self.files.iter().position(|file| file.role() != Role::Unused && empty(file)) {
            return Err(Error::new(1, 1, "the file is empty").within(at));
        }
        // A table whose header is wrong may be used for nothing, and that would be said instead.
        let header = |file: &File| file.source.table.as_ref().and_then(|table| table.fault.clone());
        if let Some((at, fault)) = self.files.iter().enumerate().find_map(|(at, file)| Some((at, header(file)?))) {
            return Err(fault.within(at));
        }
        let moves = |file: &File| matches!(file.role(), Role::Log | Role::Velocities | Role::Odometry);
        if !self.files.iter().any(moves) {
            return Err(self.without_motion());
        }
        let mut reading = Reading::new(self.barcodes()?);
        for (i, file) in self.files.iter().enumerate() {
            match file.role() {
                Role::Log => parse::gather(&file.text, i, &mut reading.to)?,
                Role::Unused | Role::Barcodes => {}
                role => file.rows(i, |row| reading.take(role, row))?,
            }
        }
        // One file in the book's own format is refused at its last row; several have no row that stands for all of
        // them.
        if self.files.len() > 1 && !reading.to.has_motion() {
            return Err(self.without_motion());
        }
        let mut read = reading.finish()?;
        let unused = self.files.iter().filter(|file| file.role() == Role::Unused);
        read.notes.extend(unused.map(|file| format!("{} is not used.", file.name)));
        Ok(read)
    }

    /// No file has the robot's motion: what each was read as instead.
    fn without_motion(&self) -> Error {
        let read = self.files.iter().map(|file| match file.role() {
            Role::Log => format!("{} has no O rows and no V rows", file.name),
            Role::Unused => format!("{} is not used", file.name),
            role => format!("{} is read as {}", file.name, role.name()),
        });
        let read = read.collect::<Vec<_>>().join(", ");
        Error::of_all(format!(
            "the robot's motion is missing: {read}; a file of velocities or of odometry was expected"
        ))
    }

    /// The landmark that carries each barcode, where a file says so.
    fn barcodes(&self) -> Result<Option<HashMap<u32, u32>>, Error> {
        let mut carried = None;
        for (i, file) in self.files.iter().enumerate().filter(|(_, file)| file.role() == Role::Barcodes) {
            let carried = carried.get_or_insert_with(HashMap::new);
            file.rows(i, |row| {
                carried.insert(row.whole(1)?, row.whole(0)?);
                Ok(())
            })?;
        }
        Ok(carried)
    }
}

impl File {
    /// Hands over each row, its values known by their index in the role.
    fn rows(&self, index: usize, mut take: impl FnMut(Cells<'_>) -> Result<(), Error>) -> Result<(), Error> {
        let source = &self.source;
        let refuse = |message: String| Error::new(1, 1, message).within(index);
        let Some(table) = &source.table else { return Err(refuse("the file has no row of numbers".into())) };
        for (value, column) in source.role.values().iter().zip(&source.columns) {
            if column.is_none() && !value.optional {
                let role = source.role.name();
                return Err(refuse(format!("no column has been chosen for {}, which {role} need", value.name)));
            }
        }
        let mut none = matches!(source.role, Role::Velocities | Role::Odometry);
        for line in table.lines(&self.text) {
            none = false;
            let line = line.map_err(|e| e.within(index))?;
            parse::check_text(&line).map_err(|e| e.within(index))?;
            take(Cells { file: index, line: &line, source })?;
        }
        if none { Err(refuse("the file has no row of numbers".into())) } else { Ok(()) }
    }
}
