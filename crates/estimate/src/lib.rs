//! The chapter's observers and filters, in Choset's letters.
