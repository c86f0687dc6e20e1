//! What comes from outside of the solver: steps in place of its own, what they see, and language models among them.

pub(crate) mod model;
pub(crate) mod steps;
pub(crate) mod view;
