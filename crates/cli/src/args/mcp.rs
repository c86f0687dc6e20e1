//! Options of `scenelang mcp`.

use clap::Args as ClapArgs;
use std::path::PathBuf;

/// `scenelang mcp`
#[derive(ClapArgs, Debug)]
pub struct Mcp {
    /// The workspace; files outside it are neither read nor written
    #[arg(value_name = "FOLDER", default_value = ".")]
    pub folder: PathBuf,
    /// Allow tools to write files; by default, their results are kept in memory, where all tools can see them
    #[arg(long)]
    pub write: bool,
    /// The time limit for a call
    #[arg(long, value_name = "SECONDS", default_value = "60", value_parser = super::seconds)]
    pub time: f64,
}
