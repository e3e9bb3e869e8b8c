//! Builds the site from content/, the labs and the compiled sources.
