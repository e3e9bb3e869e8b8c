//! A robot's log: what its wheels counted, what its sensors read, where its landmarks stand and, if it is known, where
//! it was.
//!
//! The file is plain text, UTF-8, one row a line, fields parted by commas. A line that begins with `#` is a comment, a
//! blank line is skipped, lines end in LF or CRLF.
//!
//! | row | meaning, units |
//! |---|---|
//! | `L,id,x,y` | a landmark at a known place; the id is a whole number; m |
//! | `G,t,x,y,theta` | the truth, where it is known; s, m, rad |
//! | `O,t,distance,turn` | odometry since the `O` row before; m, rad |
//! | `V,t,v,omega` | a velocity, held until the next `V` row; m/s, rad/s |
//! | `R,t,id,range` | a range to a landmark; m |
//! | `B,t,id,range,bearing` | a range and a bearing, from the robot's nose to the landmark, counter-clockwise; m, rad |
//!
//! A log moves by `O` rows or by `V` rows, not by both. Rows may stand in any order: [`parse`] answers them by time, at
//! equal times motion before sightings, then by line. What a log says is an [`estimate::drive::Drive`], which
//! [`estimate::drive::Replay`] filters.
//!
//! [`Files`] reads what others write: tables of motion, sightings, landmarks and truth with or without a header, in
//! their units, among them the five files of a UTIAS MRCLAM data set. How a file is read is guessed and can be
//! corrected.
//!
//! # Example
//! ```
//! use estimate::drive::Event;
//! let log = robot_log::parse("L,7,3.0,4.0\nO,0.5,0.1,0.02\nR,0.5,7,4.9\n")?;
//! assert_eq!(log.drive.landmarks[0].id, 7);
//! assert_eq!(log.drive.rows[1].event, Event::Range { landmark: 0, range: 4.9 });
//! # Ok::<(), robot_log::Error>(())
//! ```

mod error;
mod fields;
mod files;
mod gathering;
mod guess;
mod log;
mod parse;
mod reading;
mod role;
mod row;
mod source;
mod table;

pub use error::Error;
pub use files::{File, Files, MAX_FILES};
pub use log::{Log, MAX_BYTES, MAX_LANDMARKS, MAX_ROWS, Understood};
pub use parse::parse;
pub use role::{ANGLES, LENGTHS, Quantity, Role, TIMES, Units, Value};
