//! Options of the commands that tell of the command line itself.

use clap::{Args as ClapArgs, ValueEnum};
use clap_complete::Shell;
use std::path::PathBuf;

/// `scenelang completions`
#[derive(ClapArgs, Debug)]
pub struct Completions {
    /// The shell
    #[arg(value_name = "SHELL")]
    pub shell: Shell,
}

/// `scenelang man`
#[derive(ClapArgs, Debug)]
pub struct Man {
    /// The command, such as `check` or `bench solve` [default: scenelang itself]
    #[arg(value_name = "COMMAND", conflicts_with = "output")]
    pub command: Vec<String>,
    /// Write the pages of all commands into this folder
    #[arg(short, long, value_name = "FOLDER")]
    pub output: Option<PathBuf>,
    /// Overwrite files that scenelang did not write or that were edited
    #[arg(long, requires = "output")]
    pub force: bool,
    /// The output format
    #[arg(long, value_enum, default_value_t = Page::Man)]
    pub format: Page,
}

/// `man --format`
#[derive(ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
pub enum Page {
    /// For `man`
    Man,
    /// Markdown, as in the book
    Markdown,
}
