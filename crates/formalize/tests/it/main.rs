//! What a draft is as a program.

mod arrange;
mod read;
mod support;
mod write;
