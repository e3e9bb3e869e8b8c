//! The labs' TypeScript: every type that a lab takes or hands out.

use crate::declare::{Plain, Text, Type, written};
use crate::{BenchFrame, BenchParams, HookFrame, HookParams, PictureFrame, PictureParams, ProbeFrame, ProbeParams};

/// What the labs take and hand out.
const ROOTS: &[Type] = &[
    BenchParams::TYPE,
    BenchFrame::TYPE,
    HookParams::TYPE,
    HookFrame::TYPE,
    ProbeParams::TYPE,
    ProbeFrame::TYPE,
    PictureParams::TYPE,
    PictureFrame::TYPE,
];

/// The interfaces of all labs, with their doc comments, limits and defaults. `Vector` and `Matrix` are not among them.
pub const TYPESCRIPT: &str = ALL.as_str();

const ALL: &Text<20_000> = &written(ROOTS);
