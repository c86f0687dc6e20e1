//! Each feature as a function of a program with `$0` where the cursor is, and the answer beside it: one file for each.

#![allow(clippy::unwrap_used, clippy::needless_pass_by_value, reason = "a test that cannot go on fails")]

mod across;
mod actions;
mod calls;
mod colors;
mod completion;
mod diagnostics;
mod fixture;
mod folding;
mod format;
mod hints;
mod hover;
mod moving;
mod navigation;
mod rename;
mod signature;
mod spoken;
mod symbols;
mod tokens;
