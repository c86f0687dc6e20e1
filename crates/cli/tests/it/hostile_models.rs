//! Settings and models of strangers.
