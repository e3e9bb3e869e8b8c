//! The files of a log as others write them: the five of a UTIAS MRCLAM data set, or plain tables of motion, sightings,
//! landmarks and truth.

use crate::again::{added, again};
use crate::beside;
use crate::corrections::Corrections;
use crate::error::Error;
use crate::file::File;
use crate::frames::Frame;
use crate::heights;
use crate::log::{MAX_BYTES, Understood};
use crate::other_clock::{Times, spanned};
use crate::parse;
use crate::reading::LogReader;
use crate::receivers;
use crate::role::Role;
use crate::turning;
use crate::wheels::Counting;
use std::collections::HashMap;

/// The most files of a log.
pub const MAX_FILES: usize = 16;

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
    pub(crate) files: Vec<File>,
    /// Whether they have been compared with one another since the last change.
    pub(crate) compared: bool,
    corrections: Corrections,
}

impl Files {
    /// Adds a file, and guesses how it is to be read: by what its columns are called, by its name, and by its numbers.
    ///
    /// # Errors
    /// There are [`MAX_FILES`] files already, or together they are larger than [`MAX_BYTES`]. The fault stands in no
    /// line.
    pub fn add(&mut self, name: &str, text: &str) -> Result<(), Error> {
        let at = added(&self.files);
        let bytes = self.files[..at].iter().map(|file| file.text().len()).sum::<usize>() + text.len();
        let refuse = |message: String| Err(Error::of_all(message).within(at));
        if at == MAX_FILES {
            return refuse(format!("a log has at most {MAX_FILES} files, and these are more"));
        }
        if bytes > MAX_BYTES {
            return refuse(format!("the log has {bytes} bytes; at most {MAX_BYTES} were expected"));
        }
        self.files.insert(at, File::new(name, text));
        beside::same(&mut self.files, at);
        beside::names(&mut self.files, None);
        self.read_again();
        beside::speeds(&mut self.files, None);
        receivers::ask(&mut self.files);
        self.changed();
        Ok(())
    }

    /// Reads tables once more that hold several things.
    fn read_again(&mut self) {
        for new in again(&mut self.files) {
            beside::speeds(&mut self.files, Some(new));
        }
    }

    /// The files in the order in which they were added. Behind them are those that are read once more, as tables are
    /// that hold the motion, ranges or positions besides ([`File::again`]).
    pub fn files(&self) -> &[File] {
        &self.files
    }

    /// Reads a file as another role, its columns guessed anew. Answers whether there is such a file.
    pub fn set_role(&mut self, file: usize, role: Role) -> bool {
        let said = |file: &mut File| {
            file.set_role(role);
            file.source.role_said = true;
        };
        let known = self.files.get_mut(file).map(said).is_some();
        beside::names(&mut self.files, Some(file));
        beside::speeds(&mut self.files, Some(file));
        self.read_again();
        receivers::ask(&mut self.files);
        self.changed();
        known
    }

    /// Reads a value from another column of its file, or from none. Answers whether there are such a value and such a
    /// column.
    pub fn set_column(&mut self, file: usize, value: &str, column: Option<usize>) -> bool {
        let known = self.files.get_mut(file).is_some_and(|file| file.set_column(value, column));
        self.changed();
        known
    }

    /// Reads a value in another unit. Answers whether there is such a value in the file, and such a unit of it.
    pub fn set_unit(&mut self, file: usize, value: &str, unit: &str) -> bool {
        self.changed();
        self.files.get_mut(file).is_some_and(|file| file.set_unit(value, unit))
    }

    /// Reads only the rows of one of several robots of a file, or, by `None`, all of them. Answers whether the file has
    /// several ([`File::several`]), and this one among them.
    pub fn set_only(&mut self, file: usize, only: Option<&str>) -> bool {
        self.changed();
        self.files.get_mut(file).is_some_and(|file| file.set_only(only))
    }

    /// Says which frame a truth is in. Answers whether there is such a file, and that is asked of it
    /// ([`File::is_foreign`], [`File::own`]).
    pub fn set_frame(&mut self, file: usize, frame: Frame) -> bool {
        self.compare();
        self.files.get_mut(file).is_some_and(|file| file.set_frame(frame))
    }

    /// Says what is added to the times of a file, s. Answers whether there is such a file, and that may be said of it
    /// ([`File::other_clock`]).
    pub fn set_clock_shift(&mut self, file: usize, seconds: f64) -> bool {
        self.compare();
        let said = self.files.get_mut(file).is_some_and(|file| file.set_clock_shift(seconds));
        // A truth is compared by its times.
        self.compared = false;
        said
    }

    /// Says a number of a file's wheels: `ticks` of a turn, `radius` or `base` in metres. Answers whether there is such
    /// a file of encoders, such a number, and whether it is above 0.
    pub fn set_wheel(&mut self, file: usize, name: &str, number: f64) -> bool {
        self.changed();
        self.files.get_mut(file).is_some_and(|file| file.set_wheel(name, number))
    }

    /// Says how a file's encoders count. Answers whether there is such a file of encoders.
    pub fn set_counting(&mut self, file: usize, counting: Counting) -> bool {
        self.changed();
        self.files.get_mut(file).is_some_and(|file| file.set_counting(counting))
    }

    /// Says where the origin of places in metres lies beside latitudes and longitudes ([`File::is_foreign`],
    /// [`File::is_beside`]): at a latitude and a longitude in degrees. A log has one such origin: where another file
    /// has one, it moves too. Answers whether there is such a file and such a place.
    pub fn set_origin(&mut self, file: usize, latitude: f64, longitude: f64) -> bool {
        let (there, at) = (latitude.abs() <= 90.0 && longitude.abs() <= 360.0, Frame::At([latitude, longitude]));
        let said = there && self.set_frame(file, at);
        if said {
            self.files.iter_mut().filter(|file| file.origin().is_some()).for_each(|file| _ = file.set_frame(at));
        }
        said
    }

    /// Reads the log otherwise than the files have it, from now on. Answers whether it can be read so.
    pub fn correct(&mut self, corrections: Corrections) -> bool {
        let sound = corrections.is_sound();
        if sound {
            self.corrections = corrections;
        }
        sound
    }

    /// What is read otherwise.
    pub fn corrections(&self) -> &Corrections {
        &self.corrections
    }

    fn changed(&mut self) {
        self.compared = false;
        beside::frames(&mut self.files);
    }

    /// The log that the files make. A truth with a frame or a clock of its own is asked for that, once it has been
    /// compared ([`Files::compare`]).
    ///
    /// # Errors
    /// As [`parse`](crate::parse), naming the file; a value that a role needs has no column; a file is empty; a name in
    /// its header is too long, or its quotes are not closed; a file is a log of another program, or asks something
    /// ([`File::asks`]). Where no file has the robot's motion, the fault is of all together, and the message says what
    /// each was read as.
    pub fn read(&self) -> Result<Understood, Error> {
        for (at, file) in self.files.iter().enumerate() {
            file.check().map_err(|e| e.within(at))?;
        }
        // What no answer mends comes first: a file that is missing, a row that is wrong.
        if !self.files.iter().any(File::may_move) {
            return Err(self.without_motion());
        }
        let asked = self.files.iter().enumerate().find_map(|(at, file)| Some((at, file.asks().first()?.clone())));
        if let Some((at, ask)) = asked {
            for (at, file) in self.files.iter().enumerate() {
                file.fault().map_or(Ok(()), |fault| Err(fault.within(at)))?;
            }
            return Err(Error::of_all(format!("{} asks: {ask}", self.files[at].name())).within(at));
        }
        let (reading, _) = self.gathered(false)?;
        // One file in the book's own format is refused at its last row; several have no row that stands for all of
        // them.
        let only_log = matches!(self.files.as_slice(), [file] if file.role() == Role::Log);
        if !only_log && !reading.to.has_motion() {
            return Err(self.without_motion());
        }
        let own = self.files.iter().find(|file| file.frame() == Some(Frame::Own)).and_then(File::own);
        let mut read = reading.finish(own, self.corrections.kept)?;
        (read.wheels, read.base) = beside::wheels(&self.files);
        let course = beside::course(&self.files);
        read.course = course.is_some();
        read.notes.extend(course.map(beside::course_note));
        let corrected = self.corrections.onto(&mut read.log.drive, &read.landmarks);
        read.notes.extend(corrected);
        read.corrections = self.corrections.clone();
        read.notes.extend(heights::note(&self.files, &read.log.drive));
        read.notes.extend(beside::note(&self.files));
        read.notes.extend(turning::note(&self.files));
        read.notes.extend(turning::units(&self.files));
        read.notes.extend(beside::origins(&self.files));
        let unused = self.files.iter().filter(|file| file.role() == Role::Unused);
        read.notes.extend(unused.map(|file| format!("{}.", file.unused())));
        Ok(read)
    }

    /// The rows of all files, and which of them and when those of each were; `as_written`, a truth is not moved.
    pub(crate) fn gathered(&self, as_written: bool) -> Result<(LogReader, Vec<Times>), Error> {
        let mut reading = LogReader::new(self.barcodes()?, as_written);
        reading.origin = self.files.iter().find_map(File::origin);
        let gyro = turning::gyro(&self.files);
        let mut times = vec![Times::default(); self.files.len()];
        for (i, file) in self.files.iter().enumerate() {
            times[i].rows[0] = reading.to.rows().len();
            match file.role() {
                Role::Log => parse::gather(file.text(), i, &mut reading.to)?,
                Role::Unused | Role::Undecided | Role::Barcodes => {}
                role => {
                    let before = reading.taken();
                    reading.begin_file(gyro.is_some_and(|gyro| gyro != i) && turning::drives(file));
                    file.rows(i, |row| reading.take(role, row))?;
                    if reading.taken() == before {
                        let (name, role) = (file.name(), role.name());
                        reading.say(vec![format!("{name}: read as {role}, it has no row that says anything.")]);
                    }
                    let shared = file.again.is_some() || self.files.iter().any(|it| it.again() == Some(i));
                    times[i].all = reading.end_file(file.name(), file.words(), shared);
                    reading.say(file.notes());
                }
            }
            let rows = &reading.to.rows()[times[i].rows[0]..];
            times[i].motion = spanned(rows);
            times[i].rows[1] = times[i].rows[0] + rows.len();
        }
        Ok((reading, times))
    }

    /// No file has the robot's motion: what each was read as instead.
    fn without_motion(&self) -> Error {
        let read = self.files.iter().map(|file| match file.role() {
            Role::Log => format!("{} has no rows of motion", file.name()),
            Role::Sensors => format!("{} has neither speeds nor turn rates", file.name()),
            Role::Unused => file.unused(),
            Role::Undecided => format!("what {} is has to be said", file.name()),
            role => format!("{} is read as {}", file.name(), role.name()),
        });
        let read = read.collect::<Vec<_>>().join(", ");
        Error::of_all(format!(
            "the robot's motion is missing: {read}; a file of velocities, of odometry or of encoders was expected"
        ))
    }

    /// The landmark that carries each barcode, where a file says so.
    fn barcodes(&self) -> Result<Option<HashMap<u32, u32>>, Error> {
        let mut carried = None;
        for (i, file) in self.files.iter().enumerate().filter(|(_, file)| file.role() == Role::Barcodes) {
            let carried = carried.get_or_insert_with(HashMap::new);
            file.rows(i, |row| {
                carried.insert(row.whole("barcode")?, row.whole("landmark")?);
                Ok(())
            })?;
        }
        Ok(carried)
    }
}
