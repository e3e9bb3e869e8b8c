//! A program in the letters of another notation: only names change, so comments, blanks and faults stay where they are.

use crate::fault::Faults;
use crate::token::{Kind, tokens};
use crate::words::Words;
use crate::world::{Letter, Notation, World};
use alloc::string::String;
use alloc::vec::Vec;

/// What a world gives: each name, what it is, and its rows and columns, "n×p".
pub fn given(world: World, notation: Notation) -> Vec<(&'static str, &'static str, String)> {
    let found = crate::world_sizes(world);
    let mut all = Vec::new();
    for letter in world.letters() {
        let mut size = Words::default();
        found.say(World::shape_of(*letter), &mut size);
        all.push((notation.letter(*letter), letter.meaning(), size.0));
    }
    if world == World::Robot {
        all.push(("l", "the landmark that is sighted", String::from("2×1")));
    }
    all
}

/// The text with the letters of `from` turned into those of `to`. A name of the reader's own that would become one of
/// them gets a number.
pub fn relettered(text: &str, world: World, [from, to]: [Notation; 2]) -> String {
    let mut names = world.names(from);
    let tokens = tokens(text, &mut names, &mut Faults::new(text));
    let used = |id: usize| tokens.iter().any(|token| token.kind == Kind::Name(id));
    // What is taken in the new letters: by what the world gives, and by what the text makes of the quantities.
    let mut taken: Vec<&str> = Vec::new();
    for letter in Letter::ALL {
        let own = names.iter().position(|name| name == from.letter(letter));
        if world.letters().contains(&letter) || own.is_some_and(used) {
            taken.push(to.letter(letter));
        }
    }
    let mut renamed: Vec<String> = Vec::new();
    for (id, name) in names.iter().enumerate() {
        let base = name.trim_end_matches(['⁻', '⁺']);
        let marks = name.get(base.len()..).unwrap_or_default();
        let letter = Letter::ALL.into_iter().find(|letter| from.letter(*letter) == base);
        let mut new = String::from(letter.map_or(base, |letter| to.letter(letter)));
        new.push_str(marks);
        if letter.is_none() && used(id) && taken.contains(&base) {
            let free = |number: &u32| !names.contains(&numbered(base, *number, marks));
            new = numbered(base, (2..).find(free).unwrap_or(2), marks);
        }
        renamed.push(new);
    }
    let part = |from: usize, to: usize| text.get(from..to).unwrap_or_default();
    let (mut written, mut at) = (String::new(), 0);
    for token in &tokens {
        let Kind::Name(id) = token.kind else { continue };
        if renamed[id] != names[id] {
            written.push_str(part(at, token.place.from));
            written.push_str(&renamed[id]);
            at = token.place.to;
        }
    }
    written.push_str(part(at, text.len()));
    written
}

fn numbered(base: &str, number: u32, marks: &str) -> String {
    let mut name = String::from(base);
    name.push(char::from_digit(number % 10, 10).unwrap_or('2'));
    name.push_str(marks);
    name
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Program;
    use crate::judge::{Outcome, judge};

    const ALL: [Notation; 3] = [Notation::Choset, Notation::Thrun, Notation::Common];

    #[test]
    fn a_right_filter_stays_right_in_all_letters_and_comes_back() {
        let joseph = "# R is the gain\nx = F x + G u\nP = F P F' + V\nR = P H' / (H P H' + W)\nx = x + R (y - H x)\n\
                      A = I - R H\nP = A P A' + R W R'";
        for (world, text) in [(World::Linear, joseph), (World::Robot, &crate::judge::right(World::Robot))] {
            for to in ALL {
                let other = relettered(text, world, [Notation::Choset, to]);
                let verdict = judge(&Program::new(&other, world, to));
                assert_eq!(verdict.outcome, Outcome::Right, "{other}\n{verdict:?}");
                let back = relettered(&other, world, [to, Notation::Choset]);
                assert_eq!(judge(&Program::new(&back, world, Notation::Choset)).outcome, Outcome::Right, "{back}");
            }
        }
        let thrun = relettered(joseph, World::Linear, [Notation::Choset, Notation::Thrun]);
        assert!(thrun.starts_with("# R is the gain\nmu = A mu + B u\nSigma = A Sigma A' + R\n"), "{thrun}");
        assert!(thrun.contains("A2 = I - K C"), "{thrun}");
    }

    #[test]
    fn what_is_no_program_keeps_its_faults_in_place() {
        let text = "x = F x + (\nP⁻ = $ F P";
        let other = relettered(text, World::Linear, [Notation::Choset, Notation::Thrun]);
        assert_eq!(other, "mu = A mu + (\nSigma⁻ = $ A Sigma");
    }

    #[test]
    fn what_a_world_gives_is_named_with_its_size() {
        let all = |world, notation| {
            let mut words = String::new();
            for (name, _, size) in given(world, notation) {
                words.extend([name, " ", &size, ", "]);
            }
            words
        };
        let linear = "x n×1, P n×n, u m×1, y p×1, V n×n, W p×p, F n×n, G n×m, H p×n, ";
        assert_eq!(all(World::Linear, Notation::Choset), linear);
        assert_eq!(all(World::Robot, Notation::Thrun), "mu 3×1, Sigma 3×3, u 2×1, z 2×1, R 3×3, Q 2×2, l 2×1, ");
    }
}
