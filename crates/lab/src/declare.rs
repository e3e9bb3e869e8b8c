//! The macros by which a lab declares what it takes and what it hands out.

use crate::text::Text;

/// Declares plain structs: each field has a doc comment and a type that is [`Plain`](crate::Plain). TypeScript calls a
/// field by its name in camelCase, or by the name in `#[name = "…"]`. Their interfaces are the constant `INTERFACES`.
#[macro_export]
macro_rules! record {
    ($($(#[doc = $about:literal])+ $(#[derive($($derived:ident),*)])?
     pub struct $name:ident {
         $($(#[doc = $doc:literal])+ $(#[name = $key:literal])? pub $field:ident: $type:ty,)*
     })+) => {
        $(
            $(#[doc = $about])+
            #[derive(Clone, Debug, PartialEq $($(, $derived)*)?)]
            pub struct $name { $($(#[doc = $doc])+ pub $field: $type,)* }
            $crate::described! {
                $(#[doc = $about])+
                $name as stringify!($name); &[], &[];
                { $($(#[doc = $doc])+ $field: $type as $crate::name!($field $($key)?);)* }
            }
        )+
        /// The interfaces of these records.
        pub const INTERFACES: &[$crate::About] = &[$(<$name as $crate::Interface>::ABOUT),+];
    };
}

/// Declares a lab's parameters: `name: type = default, from least to greatest by step in "unit"`. The default is one
/// token, or stands in parentheses. A number without limits may be any finite one, a whole number any below 2³².
#[macro_export]
macro_rules! params {
    ($(#[doc = $about:literal])+ pub struct $name:ident {
        $($(#[doc = $doc:literal])+ pub $field:ident: $type:ty = $default:tt
          $(, from $least:tt to $greatest:tt by $step:tt $(in $unit:literal)?)?;)*
    }) => {
        $(#[doc = $about])+
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct $name { $($(#[doc = $doc])+ pub $field: $type,)* }
        impl Default for $name {
            fn default() -> Self {
                Self { $($field: $default,)* }
            }
        }
        $crate::described! {
            $(#[doc = $about])+
            $name as stringify!($name); <$name as $crate::Params>::PARAMETERS, &[$(stringify!($default)),*];
            { $($(#[doc = $doc])+ $field: $type as $crate::name!($field);)* }
        }
        impl $crate::Params for $name {
            const PARAMETERS: &'static [$crate::Parameter] = &[$(
                $crate::Parameter::of::<$type>($crate::name!($field))
                $(.within([$least, $greatest, $step], concat!($($unit)?), {
                    const BOUNDS: &$crate::Text<64> =
                        &$crate::bounds([$least, $greatest], concat!($($unit)?));
                    BOUNDS.as_str()
                }))?,
            )*];

            fn read(from: &mut core::slice::Iter<'_, f64>) -> Self {
                Self { $($field: <$type as $crate::Knob>::read(from),)* }
            }
        }
    };
}

/// Declares a choice: each variant with the word that stands for it outside. The first is the default.
#[macro_export]
macro_rules! words {
    ($(#[doc = $about:literal])+ pub enum $name:ident {
        $($(#[doc = $doc:literal])+ $variant:ident = $word:literal,)+
    }) => {
        $(#[doc = $about])+
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum $name { $($(#[doc = $doc])+ $variant,)+ }
        $crate::worded! { $name { $($variant = $word,)+ } }
        impl Default for $name {
            fn default() -> Self {
                [$(Self::$variant),+][0]
            }
        }
    };
}

/// The words for the variants of an enum that is declared elsewhere.
#[macro_export]
macro_rules! worded {
    ($name:ident { $($variant:ident = $word:literal,)+ }) => {
        impl $crate::Plain for $name {
            const SHAPE: $crate::Shape = $crate::Shape::Word(&[$($word),+]);

            fn write(&self, to: &mut Vec<f64>) {
                let all = [$($name::$variant),+];
                $crate::put(to, all.iter().position(|other| other == self).unwrap_or(0) as f64);
            }
        }
        impl $crate::Knob for $name {
            const LIMITS: [f64; 3] = [0.0, 0.0, 0.0];

            fn read(from: &mut core::slice::Iter<'_, f64>) -> Self {
                let all = [$($name::$variant),+];
                all[(from.next().map_or(0, |index| *index as usize)).min(all.len() - 1)]
            }
        }
    };
}

/// Describes a struct that is declared elsewhere, or by one of the macros above.
#[macro_export]
macro_rules! described {
    ($(#[doc = $about:literal])+ $name:ident as $alias:expr; $parameters:expr, $defaults:expr;
     { $($(#[doc = $doc:literal])+ $field:ident: $type:ty as $key:expr;)* }) => {
        impl $crate::Plain for $name {
            const SHAPE: $crate::Shape = $crate::Shape::Record($alias, &[$(
                $crate::Field { name: $key, shape: <$type as $crate::Plain>::SHAPE },
            )*]);

            fn write(&self, to: &mut Vec<f64>) {
                $($crate::Plain::write(&self.$field, to);)*
            }
        }
        impl $crate::Interface for $name {
            const ABOUT: $crate::About = $crate::About {
                shape: <$name as $crate::Plain>::SHAPE,
                record: concat!($($about),+),
                fields: &[$(concat!($($doc),+)),*],
                parameters: $parameters,
                defaults: $defaults,
            };
        }
    };
}

/// The name of a field outside: the one given, else its own in camelCase.
#[macro_export]
macro_rules! name {
    ($field:ident) => {{
        const NAME: &$crate::Text<40> = &$crate::camel_case(stringify!($field));
        NAME.as_str()
    }};
    ($field:ident $key:literal) => {
        $key
    };
}

/// `snake_case` as camelCase.
pub const fn camel_case(name: &str) -> Text<40> {
    let (bytes, mut text, mut i) = (name.as_bytes(), Text::new(), 0);
    while i < bytes.len() {
        if bytes[i] == b'_' && i + 1 < bytes.len() {
            i += 1;
            text.put_byte(bytes[i].to_ascii_uppercase());
        } else {
            text.put_byte(bytes[i]);
        }
        i += 1;
    }
    text
}
