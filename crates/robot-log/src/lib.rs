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
//! | `D,t,distance,turn` | odometry since the `D` row before, driven evenly on the way from there; m, rad |
//! | `O,t,distance,turn` | odometry since the `O` row before, driven at `t`; m, rad |
//! | `V,t,v,omega` | a velocity: a speed and a turn rate in one row; m/s, rad/s |
//! | `S,t,v` | a speed, held until the next `S` or `V` row; m/s |
//! | `T,t,omega` | a turn rate, held until the next `T` or `V` row; rad/s |
//! | `VE,t,v,omega` and `SE,t,v` and `TE,t,omega` | the same, of rates that change evenly until the next row |
//! | `R,t,id,range` | a range to a landmark; m |
//! | `B,t,id,range,bearing` | a range and a bearing, from the robot's nose to the landmark, counter-clockwise; m, rad |
//! | `P,t,x,y[,sigma]` | a fix of the position, with its own standard deviation if it has one; m |
//! | `H,t,theta[,sigma]` | a heading (compass, course), with its own standard deviation if it has one; rad |
//!
//! A log moves by `D` rows, by `O` rows, by held rows (`V`, `S`, `T`) or by even ones (`VE`, `SE`, `TE`), and by one
//! kind alone. Rows may stand in any order: [`parse`] answers them by time, at equal times motion before readings, then
//! by line. What a log says is an [`estimate::drive::Drive`], which [`estimate::drive::Replay`] filters: from the first
//! true pose on, else from the first fix, else from the first row. Rows of held motion before that say what is held,
//! and others are skipped.
//!
//! [`Files`] reads what others write: tables of motion, sensors, sightings, landmarks and truth in their units, among
//! them the five files of a UTIAS MRCLAM data set and what ROS, PX4, ArduPilot and phones export. How a file is read is
//! guessed where that is certain, asked where it is not, shown, and can be corrected.
//!
//! # Example
//! ```
//! use estimate::drive::Event;
//! let log = robot_log::parse("L,7,3.0,4.0\nO,0.5,0.1,0.02\nR,0.5,7,4.9\n")?;
//! assert_eq!(log.drive.landmarks[0].id, 7);
//! assert_eq!(log.drive.rows[1].event, Event::Range { landmark: 0, range: 4.9 });
//! let car = robot_log::parse("S,0,10.5\nT,0,-0.04\nP,0.1,1.06,0.01,2.5\nH,0.1,-0.004\n")?;
//! assert_eq!(car.drive.rows[2].event, Event::Position { x: 1.06, y: 0.01, sigma: Some(2.5) });
//! # Ok::<(), robot_log::Error>(())
//! ```

mod again;
mod alignment;
mod alone;
mod axes;
mod beside;
mod binary;
mod cells;
mod clock;
mod clocks;
mod columns;
mod compared;
mod corrections;
mod counter;
mod cut;
mod ended;
mod error;
mod evidence;
mod fields;
mod file;
mod files;
mod frames;
mod gathering;
mod guess;
mod headed;
mod heading;
mod heights;
mod holds;
mod jumps;
mod lag;
mod landmarks;
mod lists;
mod log;
mod markup;
mod names;
mod nested;
mod no_value;
mod notes;
mod opposite;
mod order;
mod other_clock;
mod own;
mod parse;
mod placed;
mod quaternion;
mod question;
mod reading;
mod receivers;
mod reckoned;
mod role;
mod ros;
mod row;
mod sampled;
mod sensed;
mod separator;
mod several;
mod shown;
mod sigma;
mod source;
mod stamp;
mod stamps;
mod table;
mod trajectory;
mod true_names;
mod turning;
mod twice;
mod unit;
mod vocabulary;
mod way;
mod wgs84;
mod wheels;
mod wide;

pub use alignment::Rigid;
pub use corrections::Corrections;
pub use error::Error;
pub use file::File;
pub use files::{Files, MAX_FILES};
pub use frames::Frame;
pub use log::{Log, MAX_BYTES, MAX_LANDMARKS, MAX_ROWS, Understood};
pub use other_clock::OtherClock;
pub use own::Own;
pub use parse::parse;
pub use role::{Quantity, Role, Value};
pub use row::MAX_TIME;
pub use unit::{Unit, units_of};
pub use wheels::{Counting, WHEEL_NUMBERS, Wheels};
