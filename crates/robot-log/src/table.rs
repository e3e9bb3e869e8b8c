//! A file of numbers in columns, which commas, semicolons, tabs or blanks part.

use crate::error::Error;
use crate::fields::{Field, Line, is_comment, is_none};
use crate::names::is_unit;
use crate::nested::{BELOW, nested};
use crate::ros;
use crate::separator::{MAX_COLUMNS, Separator, is_number, numbers, separator, split, unquoted};
use crate::trajectory;
use core::ops::Range;

/// The rows whose numbers are looked at to find out what they are.
pub(crate) const LOOKED_AT: usize = 200;

/// The longest name of a column in bytes: what is longer is no header.
const MAX_NAME: usize = 200;

/// A table before its rows are read: its separator, and what its columns are called.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Table {
    separator: Separator,
    /// What the columns are called: by the line above the numbers, by the last comment above them, or by their number.
    pub names: Vec<String>,
    /// Whether units stand below the names.
    pub units: bool,
    /// Columns that hold nothing: their names are heads of those behind them.
    pub heads: Vec<usize>,
    /// Whether they have no other name than their number.
    pub nameless: bool,
    /// Lines up to the first row.
    skipped: u32,
    /// How many of these are neither names nor comments: they say something about the file, or units.
    pub words: usize,
    /// The line of a last row that may be cut, and is not read.
    pub cut: Option<u32>,
    /// What is wrong with the header.
    pub fault: Option<Error>,
}

impl Table {
    /// The table that a text begins with; `None` of a text that has no line but comments.
    pub fn new(text: &str) -> Option<Self> {
        let text = text.strip_prefix('\u{feff}').unwrap_or(text);
        let (mut comment, mut first) = ("", None);
        for (i, line) in text.lines().enumerate() {
            match line.trim() {
                "" => {}
                // Spreadsheets say in a first line what parts the fields of the others.
                line if is_sep(line) => {}
                line if is_comment(line) => comment = line.trim_start_matches('#'),
                line => {
                    first = Some((i as u32, line));
                    break;
                }
            }
        }
        let (above, line) = behind_preamble(text, first?);
        let separator = separator(line);
        let found: Vec<(usize, &str)> = split(line, separator).take(MAX_COLUMNS + 1).collect();
        let fields: Vec<&str> = found.iter().map(|(_, field)| unquoted(field)).collect();
        let (rows, second) = first_row(text, above, fields.len(), separator);
        if is_header(&fields, second, separator) {
            let fault = found.iter().find_map(|(at, field)| {
                let message = name_fault(field)?;
                Some(Error::new(above + 1, line[..*at].chars().count() as u32 + 1, message))
            });
            // Within quotes a quote is written twice.
            let names = fields.into_iter().map(|name| beginning(name).replace("\"\"", "\"")).collect();
            let below = text.lines().take(rows as usize).skip(above as usize + 1).filter(|line| !is_empty(line));
            let below: Vec<&str> = below.collect();
            let units = below.iter().any(|line| split(line, separator).any(|(_, word)| is_unit(unquoted(word))));
            let names = apart(names, below, separator, units);
            let words = text.lines().take(rows as usize).filter(|line| !is_empty(line) && !is_sep(line)).count()
                - 1
                - usize::from(units);
            let (heads, nameless, skipped, cut) = (Vec::new(), false, rows, None);
            let mut table = Self { separator, names, units, heads, nameless, skipped, words, cut, fault };
            if let Some((names, heads)) = nested(&table.names, &table.empty(text)) {
                (table.names, table.heads) = (names, heads);
            }
            return Some(table);
        }
        let named: Option<Vec<String>> = [Separator::Char(','), Separator::Char(';'), Separator::Char('\t')]
            .into_iter()
            .map(|separator| split(comment, separator).map(|(_, name)| name.to_string()).collect())
            .chain([wide(comment), split(comment, Separator::Blanks).map(|(_, name)| name.to_string()).collect()])
            .find(|names: &Vec<String>| names.len() == fields.len() && names.iter().all(|name| !name.is_empty()))
            .or_else(|| ros::names(&fields))
            .or_else(|| trajectory::names(text.lines().skip(above as usize).take(LOOKED_AT)));
        let nameless = named.is_none();
        let named = named.unwrap_or_else(|| (1..=fields.len()).map(|i| format!("column {i}")).collect());
        // Numbers have no blanks in them, so that tabs among blanks are blanks too.
        let numbers = fields.iter().all(|field| is_number(field));
        let separator = if separator == Separator::Char('\t') && numbers { Separator::Blanks } else { separator };
        Some(Self {
            separator,
            names: named,
            units: false,
            heads: Vec::new(),
            nameless,
            skipped: above,
            words: 0,
            cut: None,
            fault: None,
        })
    }

    /// Which columns hold nothing in the first rows.
    fn empty(&self, text: &str) -> Vec<bool> {
        let mut empty = vec![true; self.names.len()];
        for line in self.lines(text).filter_map(Result::ok).take(LOOKED_AT) {
            empty.iter_mut().zip(&line.fields).for_each(|(empty, field)| *empty &= field.text.is_empty());
        }
        empty
    }

    /// The lines of numbers; `text` must be the one that the table was made of.
    pub fn lines<'t>(&self, text: &'t str) -> impl Iterator<Item = Result<Line<'t>, Error>> + use<'t> {
        self.lines_within(text, 0..u32::MAX)
    }

    /// Those of them whose numbers are within these.
    pub fn lines_within<'t>(
        &self,
        text: &'t str,
        within: Range<u32>,
    ) -> impl Iterator<Item = Result<Line<'t>, Error>> + use<'t> {
        let separator = self.separator;
        let columns = self.names.len();
        let rows = self.rows(text).filter(move |(number, _)| within.contains(number));
        rows.map(move |(number, line)| {
            let column = |byte: usize| line[..byte].chars().count() as u32 + 1;
            let found = split(line, separator).take(MAX_COLUMNS + 1);
            let fields: Vec<Field<'t>> =
                found.map(|(at, text)| Field { text: unquoted(text), column: column(at) }).collect();
            let end = column(line.trim_end().len());
            if fields.len() != columns {
                let found = fields.len();
                let column = fields.get(columns).map_or(end, |extra| extra.column);
                return Err(Error::new(number, column, format!("the row has {found} fields; {columns} were expected")));
            }
            Ok(Line { number, fields, end })
        })
    }

    /// What stands in a column, each with the number of its line.
    pub fn column<'t>(&self, text: &'t str, at: usize) -> impl Iterator<Item = (u32, &'t str)> + use<'t> {
        let separator = self.separator;
        self.rows(text).filter_map(move |(number, line)| Some((number, unquoted(split(line, separator).nth(at)?.1))))
    }

    /// The lines below the header that are neither blank nor comments, with their numbers.
    fn rows<'t>(&self, text: &'t str) -> impl Iterator<Item = (u32, &'t str)> + use<'t> {
        let (skipped, cut) = (self.skipped, self.cut);
        let text = text.strip_prefix('\u{feff}').unwrap_or(text);
        let numbered = text.lines().enumerate().map(|(i, line)| (i as u32 + 1, line));
        numbered.filter(move |(number, line)| *number > skipped && Some(*number) != cut && !is_empty(line))
    }
}

/// Where the names stand, and their line: the first one, but where loggers write about the file above them. Then it has
/// few fields, and the rows further down have as many as the names.
fn behind_preamble<'t>(text: &'t str, first: (u32, &'t str)) -> (u32, &'t str) {
    let all = || text.lines().enumerate().filter(|(_, line)| !is_empty(line)).take(LOOKED_AT);
    let Some((_, row)) = all().last() else { return first };
    let separator = separator(row);
    let count = |line: &str| split(line, separator).take(MAX_COLUMNS + 1).count();
    let columns = count(row);
    if separator == Separator::Blanks || columns < 4 || 2 * count(first.1) >= columns || numbers(row, separator) == 0 {
        return first;
    }
    all().find(|(_, line)| count(line) == columns).map_or(first, |(i, line)| (i as u32, line))
}

/// The first line below the names that has a number in it, and how many stand above it; units may stand between. Where
/// there is none so near, the next line.
fn first_row(text: &str, above: u32, columns: usize, separator: Separator) -> (u32, &str) {
    let below = || text.lines().enumerate().skip(above as usize + 1).filter(|(_, line)| !is_empty(line)).take(4);
    let whole = |line: &str| split(line, separator).take(MAX_COLUMNS + 1).count() == columns;
    let near = below().take_while(|(_, line)| whole(line)).find(|(_, line)| numbers(line, separator) > 0);
    near.map_or_else(|| (above + 1, below().next().map_or("", |(_, line)| line)), |(i, line)| (i as u32, line))
}

/// Columns of one name are told apart by the words that stand below it: a unit, a device. A line of units says each
/// column's.
fn apart(names: Vec<String>, below: Vec<&str>, separator: Separator, units: bool) -> Vec<String> {
    if below.is_empty() {
        return names;
    }
    let words: Vec<Vec<&str>> =
        below.iter().map(|line| split(line, separator).map(|(_, word)| word).collect()).collect();
    let alone = |name: &String| names.iter().filter(|other| *other == name).take(2).count() == 1;
    let told = |(i, name): (usize, &String)| {
        let said: Vec<&str> =
            words.iter().filter_map(|line| line.get(i).copied()).filter(|it| !it.is_empty()).collect();
        if said.is_empty() || (alone(name) && !units) {
            name.clone()
        } else {
            format!("{name}{BELOW}{}", said.join(", "))
        }
    };
    names.iter().enumerate().map(told).collect()
}

/// Whether a line names columns: it is no row of numbers, and in the line after it a number stands below a word.
/// Without such a line any word will do: rows may have words in them too, as the frames of ROS.
fn is_header(fields: &[&str], second: &str, separator: Separator) -> bool {
    if fields.iter().all(|field| is_number(field)) {
        return false;
    }
    let below: Vec<&str> = split(second, separator).take(MAX_COLUMNS + 1).map(|(_, field)| unquoted(field)).collect();
    let full = |field: &str| !is_none(field) && is_number(field);
    below.len() != fields.len()
        || numbers(second, separator) == 0
        || fields.iter().zip(&below).any(|(above, below)| !is_number(above) && full(below))
}

fn is_sep(line: &str) -> bool {
    line.trim().len() == 5 && line.trim().starts_with("sep=")
}

fn is_empty(line: &str) -> bool {
    let line = line.trim();
    line.is_empty() || is_comment(line)
}

/// The names of columns that stand two blanks or more apart, so that a name may have blanks in it.
fn wide(comment: &str) -> Vec<String> {
    let parts = comment.split("  ").flat_map(|part| part.split('\t')).map(str::trim);
    parts.filter(|part| !part.is_empty()).map(String::from).collect()
}

/// What is wrong with the name of a column.
fn name_fault(field: &str) -> Option<String> {
    if field.len() > MAX_NAME {
        return Some(format!("the name of a column has more than {MAX_NAME} bytes; a table begins with short names"));
    }
    let open = |quote: char| field.strip_prefix(quote).is_some_and(|field| !field.ends_with(quote));
    (open('"') || open('\'')).then(|| "the quotes of the column's name are not closed".into())
}

/// As much of a name as a column has.
fn beginning(name: &str) -> &str {
    let end = (0..=MAX_NAME.min(name.len())).rev().find(|end| name.is_char_boundary(*end));
    &name[..end.unwrap_or(0)]
}
