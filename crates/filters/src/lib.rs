//! The sister volume's filters, in Thrun's letters.
