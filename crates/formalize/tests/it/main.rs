//! What a draft is as a program.

mod arrange;
mod support;
mod write;
