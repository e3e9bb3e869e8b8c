//! Parameters of labs as JSON has them.

use lab::Shape;
use serde_json::Value;

/// Appends the numbers of a parameter, every one of which must be there.
pub fn read(shape: &Shape, value: &Value, to: &mut Vec<f64>) -> Option<()> {
    match shape {
        Shape::Number | Shape::Whole => to.push(value.as_f64()?),
        Shape::Flag => to.push(f64::from(value.as_bool()?)),
        Shape::Word(words) => to.push(words.iter().position(|word| value == word)? as f64),
        Shape::Maybe(_) if value.is_null() => to.push(0.0),
        Shape::Maybe(inner) => {
            to.push(1.0);
            read(inner, value, to)?;
        }
        Shape::Exactly(n, entry) => {
            let entries = value.as_array().filter(|entries| entries.len() == *n)?;
            entries.iter().try_for_each(|each| read(entry, each, to))?;
        }
        Shape::Between(_, most, entry) => {
            let entries = value.as_array().filter(|entries| entries.len() <= *most)?;
            to.push(entries.len() as f64);
            entries.iter().try_for_each(|each| read(entry, each, to))?;
        }
        Shape::Each(names, inner) => {
            let of = |name| if value.is_object() { value.get(name) } else { Some(value) };
            names.iter().try_for_each(|name| read(inner, of(name)?, to))?;
        }
        Shape::Text => lab::Plain::write(value.as_str()?, to),
        Shape::List(_) | Shape::Record(..) | Shape::Sparse(..) => return None,
    }
    Some(())
}
