//! Several tables with positions, none of which is called true: one may be the track that the others are held against,
//! as of a better receiver, and taken for fixes it would be fused with them in silence. So that is asked.

use crate::file::File;
use crate::names::Name;
use crate::question::Question;
use crate::role::Role;
use crate::row;

/// Words of a file's or a column's name that speak for a track that others are held against.
const BETTER: [&str; 14] = [
    "rtk",
    "ppk",
    "ref",
    "reference",
    "ground",
    "survey",
    "tachymeter",
    "tachy",
    "leica",
    "prism",
    "tracker",
    "ins",
    "sbet",
    "base",
];
/// A receiver that claims a σ so many times as small is a better one.
const TIMES: f64 = 5.0;

/// Asks of the tables with positions that may be the true track, where there are several and none is known to be.
pub(crate) fn ask(files: &mut [File]) {
    // What was asked before another file was known is asked anew.
    for file in files.iter_mut().filter(|file| file.source.among_several && !file.source.role_said) {
        file.set_role(Role::Sensors);
        file.source.among_several = false;
    }
    if files.iter().any(|file| file.role() == Role::Truth || may_be_true(file)) {
        return;
    }
    let guessed = |file: &&File| file.role() == Role::Sensors && file.has_positions() && !file.source.role_said;
    let with: Vec<usize> = (0..files.len()).filter(|at| guessed(&&files[*at])).collect();
    let [first, _, ..] = with.as_slice() else { return };
    for at in better(files, &with) {
        let other = with.iter().find(|it| **it != at).unwrap_or(first);
        let words = format!(
            "Are its positions the true track, or what a sensor read? {} has positions, too.",
            files[*other].name()
        );
        let file = &mut files[at];
        file.set_role(Role::Undecided);
        file.source.undecided = Some(Question { words, answers: &[Role::Truth, Role::Sensors] });
        file.source.among_several = true;
    }
}

/// Whether it is asked already whether a file is the truth.
fn may_be_true(file: &File) -> bool {
    file.role() == Role::Undecided && file.answers().contains(&Role::Truth)
}

/// Which of them may be the track that the others are held against: those that are called so, else those without a σ,
/// else one with a much smaller one.
fn better(files: &[File], with: &[usize]) -> Vec<usize> {
    let those = |of: &dyn Fn(&File) -> bool| with.iter().copied().filter(|at| of(&files[*at])).collect::<Vec<_>>();
    let sigma = |file: &File| file.source.column("sigma").is_some();
    [those(&is_called_so), those(&|file| !sigma(file))].into_iter().find(|found| !found.is_empty()).unwrap_or_else(
        || {
            let claimed = |at: &usize| files[*at].claimed().map(|sigma| (sigma, *at));
            let mut claims: Vec<(f64, usize)> = with.iter().filter_map(claimed).collect();
            claims.sort_by(|a, b| a.0.total_cmp(&b.0));
            match claims.as_slice() {
                [(least, at), (next, _), ..] if TIMES * least < *next => vec![*at],
                _ => Vec::new(),
            }
        },
    )
}

fn is_called_so(file: &File) -> bool {
    let stem = file.name().split('.').next().unwrap_or_default();
    let read = ["x", "latitude"].into_iter().filter_map(|value| file.source.column(value));
    Name::new(stem).has_one(&BETTER) || { read }.any(|at| file.source.names[at].has_one(&BETTER))
}

impl File {
    /// Whether it has positions, as it is read.
    fn has_positions(&self) -> bool {
        ["x", "latitude"].iter().any(|value| self.source.column(value).is_some())
    }

    /// A σ that its positions bring, m: that of a middle row.
    fn claimed(&self) -> Option<f64> {
        let at = self.source.role.index("sigma")?;
        let samples = self.samples(self.source.columns[at]?);
        let value = row::number(samples.get(samples.len() / 2)?)?;
        Some(self.source.units[at]?.factor * value).filter(|sigma| *sigma > 0.0)
    }
}
