//! What a log's robot has read beside its motion.

use estimate::drive::Event;

/// What readings are called, by their rows.
pub(crate) const READ: [(&str, fn(&Event) -> bool); 3] = [
    ("positions", |event| matches!(event, Event::Position { .. })),
    ("headings", |event| matches!(event, Event::Heading { .. })),
    ("ranges", |event| matches!(event, Event::Range { .. } | Event::RangeBearing { .. })),
];

/// A robot's own readings are missed where they are away for longer than this, s, besides ten usual steps.
pub(crate) const MISSED: f64 = 5.0;
