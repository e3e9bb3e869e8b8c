/** How many seeds what is counted over many runs is counted over, as `SEEDS` in crates/labs/src/ensemble.rs says. */
export const SEEDS = 500
