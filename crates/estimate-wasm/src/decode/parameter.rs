//! The parameters of labs, by the shapes that they declare.

use super::Arg;
use estimate::{Code, Error};
use lab::{Parameter, Shape};

impl Arg<'_> {
    /// Appends the numbers of a lab's parameter, or of a part of it.
    pub fn shaped(&self, p: &Parameter, shape: &'static Shape, to: &mut Vec<f64>) -> Result<(), Error> {
        match shape {
            Shape::Number => to.push(self.number()?),
            Shape::Whole => to.push(f64::from(self.whole(p.least as u32, p.greatest as u32)?)),
            Shape::Flag => to.push(f64::from(self.boolean()?)),
            Shape::Word(words) => to.push(self.word(words)? as f64),
            Shape::Maybe(_) if self.is_null() => to.push(0.0),
            Shape::Maybe(value) => {
                to.push(1.0);
                self.shaped(p, value, to)?;
            }
            Shape::Exactly(n, entry) => {
                for i in 0..self.of_length(*n)? {
                    self.entry(i)?.shaped(p, entry, to)?;
                }
            }
            Shape::Between(least, most, entry) => {
                let length = self.length()?;
                if !(*least..=*most).contains(&(length as usize)) {
                    let message = format!("has {length} entries; it must have from {least} to {most}");
                    return Err(self.refuse(Code::Shape, message));
                }
                to.push(f64::from(length));
                for i in 0..length {
                    self.entry(i)?.shaped(p, entry, to)?;
                }
            }
            Shape::Each(names, value) => self.each(p, names, value, to)?,
            #[cfg(feature = "filter")]
            Shape::Text => {
                let most = p.greatest as usize;
                let text = self.text_of(most)?;
                if text.len() > most {
                    return Err(self.refuse(Code::Limit, format!("is longer than {most} bytes")));
                }
                if !lab::is_plain(&text) {
                    return Err(self.refuse(Code::Type, "has a control character"));
                }
                lab::Plain::write(text.as_str(), to);
            }
            _ => {
                return Err(self.wrong_type("a parameter"));
            }
        }
        Ok(())
    }

    /// The length of an array of so many entries.
    fn of_length(&self, n: usize) -> Result<u32, Error> {
        let length = self.length()?;
        match length as usize == n {
            true => Ok(length),
            false => Err(self.refuse(Code::Shape, format!("has {length} entries; it must have {n}"))),
        }
    }

    /// The numbers of an array of so many.
    #[cfg(feature = "log")]
    pub fn exactly<const N: usize>(&self) -> Result<[f64; N], Error> {
        let mut numbers = [0.0; N];
        for i in 0..self.of_length(N)? {
            numbers[i as usize] = self.entry(i)?.number()?;
        }
        Ok(numbers)
    }

    /// What each entry of an array of at most so many is read as.
    #[cfg(feature = "log")]
    pub fn every<T>(&self, most: usize, read: impl Fn(&Arg<'_>) -> Result<T, Error>) -> Result<Vec<T>, Error> {
        let length = self.length()?;
        if length as usize > most {
            return Err(self.refuse(Code::Limit, format!("has {length} entries; at most {most} are read")));
        }
        (0..length).map(|i| read(&self.entry(i)?)).collect()
    }

    /// Appends a value for each of the names: those of an object that has some of them, else one for all. What the
    /// object leaves out is nothing, null or 0.
    fn each(
        &self,
        p: &Parameter,
        names: &'static [&'static str],
        shape: &'static Shape,
        to: &mut Vec<f64>,
    ) -> Result<(), Error> {
        if !self.value.is_object() {
            return names.iter().try_for_each(|_| self.shaped(p, shape, to));
        }
        self.only(names.iter().copied())?;
        for name in names {
            let field = self.field(name)?;
            if field.is_undefined() { to.push(0.0) } else { field.shaped(p, shape, to)? }
        }
        Ok(())
    }
}
