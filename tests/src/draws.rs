//! How property tests draw: from a fixed seed, so that two runs of one commit agree. PROPTEST_RNG_SEED=7 looks
//! elsewhere, and a release (RELEASE=1) draws five times as many cases.
//!
//! proptest does without the standard library here, and so without regular expressions: with it, it would ask
//! num-traits for `std`, and nalgebra would be compiled twice, once with other digits.

use proptest::prelude::*;
use proptest::test_runner::RngSeed;

/// The configuration of a property test with this many cases on an ordinary day.
pub fn cases(daily: u32) -> ProptestConfig {
    let given = |name| std::env::var(name).ok().filter(|text| !text.is_empty());
    let seed = given("PROPTEST_RNG_SEED").map_or(1, |text| text.parse().expect("PROPTEST_RNG_SEED is a whole number"));
    let cases = if given("RELEASE").is_some() { 5 * daily } else { daily };
    ProptestConfig { cases, failure_persistence: None, rng_seed: RngSeed::Fixed(seed), ..ProptestConfig::default() }
}

/// A character as files hold it: mostly one of `usual`, often any of Unicode, sometimes one that readers of text fall
/// over.
#[allow(dead_code, reason = "not every file of tests draws texts")]
pub fn character(usual: &'static str) -> impl Strategy<Value = char> {
    let awkward = [
        '\u{feff}',
        '\0',
        '\u{2028}',
        '\u{2029}',
        '\u{85}',
        '\u{b}',
        '\u{c}',
        '\u{a0}',
        '\u{200b}',
        '\u{fffd}',
        '\r',
        '\n',
        '\t',
        '"',
        '\u{1f600}',
    ];
    prop_oneof![
        4 => prop::sample::select(usual.chars().collect::<Vec<_>>()),
        2 => any::<char>(),
        2 => prop::sample::select(awkward.to_vec()),
    ]
}

/// A text of such characters, at most `most` of them.
#[allow(dead_code, reason = "not every file of tests draws texts")]
pub fn text(usual: &'static str, most: usize) -> impl Strategy<Value = String> {
    prop::collection::vec(character(usual), 0..=most).prop_map(|characters| characters.into_iter().collect())
}

/// A sound text with up to three such characters put in, each anywhere.
#[allow(dead_code, reason = "not every file of tests draws texts")]
pub fn spoilt(sound: &'static str) -> impl Strategy<Value = String> {
    let places = prop::collection::vec((0..=sound.chars().count(), character("0,\n")), 1..=3);
    places.prop_map(move |mut places| {
        // From the last place on, so that each is still where it was.
        places.sort_by_key(|(place, _)| core::cmp::Reverse(*place));
        let mut text: Vec<char> = sound.chars().collect();
        for (place, awkward) in places {
            text.insert(place, awkward);
        }
        text.into_iter().collect()
    })
}
