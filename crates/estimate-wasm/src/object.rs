//! What a class of the module holds.
//!
//! JavaScript can call a method of one class on an object of another. All classes therefore hold the same Rust type,
//! which says what it is: such a call finds a sound object, and is refused.

use crate::errors::Thrown;
use estimate::{Code, Error};
use std::any::Any;
use std::cell::RefCell;

/// An object behind a shared reference: arguments are decoded before it is borrowed, so that a getter of a caller's
/// object which calls back into it finds it free.
pub(crate) struct Held {
    class: &'static str,
    inner: RefCell<Box<dyn Any>>,
}

impl Held {
    pub fn new(class: &'static str, inner: impl Any) -> Self {
        Self { class, inner: RefCell::new(Box::new(inner)) }
    }

    /// What `f` answers of the object, which must be of this class.
    pub fn read<T: Any, A>(&self, class: &'static str, f: impl FnOnce(&T) -> A) -> Result<A, Thrown> {
        self.is(class)?;
        let inner = self.inner.try_borrow().map_err(|_| busy())?;
        inner.downcast_ref().map(f).ok_or_else(|| foreign(self.class, class))
    }

    /// What `f` answers, which may change the object.
    pub fn write<T: Any, A, E>(&self, class: &'static str, f: impl FnOnce(&mut T) -> Result<A, E>) -> Result<A, Thrown>
    where
        Thrown: From<E>,
    {
        self.is(class)?;
        let mut inner = self.inner.try_borrow_mut().map_err(|_| busy())?;
        let object = inner.downcast_mut().ok_or_else(|| foreign(self.class, class))?;
        Ok(f(object)?)
    }

    /// Refuses an object of another class.
    pub fn is(&self, class: &'static str) -> Result<(), Thrown> {
        if self.class == class { Ok(()) } else { Err(foreign(self.class, class)) }
    }
}

#[cold]
fn foreign(found: &str, wanted: &str) -> Thrown {
    let message = ["is an object of the class ", found, "; this is a method of ", wanted].concat();
    Error::new(Code::Type, "this", message).into()
}

/// What a call from within a call is told.
#[cold]
fn busy() -> Thrown {
    Error::new(Code::Type, "this", "is in the middle of a call").into()
}
