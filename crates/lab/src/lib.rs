//! What every experiment stands on: one declaration for what it takes and what it hands out, and its run.
//!
//! A lab's parameters (`params!`), its frame (`record!`) and the words of its choices (`words!`) are declared once.
//! From the declaration come the Rust type, its limits and defaults, its TypeScript with the doc comments, and its
//! [`Shape`], by which one function for all labs reads and writes its values. A new parameter is one line in its
//! declaration, and its use in the lab.
//!
//! A lab is a function of its parameters (the seed is one) and its step, to the last bit; see [`Lab`].

mod check;
mod declare;
mod digest;
mod experiment;
mod figure;
mod interface;
mod known;
mod lab;
mod log_summary;
mod number;
mod parameter;
pub mod series;
mod shape;
mod shown;
mod text;
mod typescript;
mod up_to;
mod written;

pub use check::Check;
pub use declare::camel_case;
pub use digest::Digest;
pub use experiment::{Experiment, Kind, open};
pub use figure::Figure;
pub use interface::{About, Interface};
pub use known::{INTERFACES, OF_THE_CORE};
pub use lab::{Lab, MAX_STEP, State};
pub use log_summary::INTERFACES as LOG_INTERFACES;
pub use number::{Listing, Number};
pub use parameter::{Knob, Parameter, Params, bounds};
pub use series::{Series, Track, Tracks, WINDOW};
pub use shape::{Field, Plain, Shape, put};
pub use shown::Shown;
pub use text::Text;
pub use typescript::{LONGEST, class, written};
pub use up_to::UpTo;
pub use written::{Written, is_plain};
