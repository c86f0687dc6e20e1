//! Options of `scenelang mcp`.

use clap::Args as ClapArgs;
use std::path::PathBuf;

/// `scenelang mcp`
#[derive(ClapArgs, Debug)]
pub struct Mcp {
    /// The workspace: what is outside it is neither read nor written
    #[arg(value_name = "FOLDER", default_value = ".")]
    pub folder: PathBuf,
    /// Let tools write files; without it, what they make is kept in memory, where all tools see it
    #[arg(long)]
    pub write: bool,
    /// A call takes at most so long
    #[arg(long, value_name = "SECONDS", default_value = "60", value_parser = super::seconds)]
    pub time: f64,
}
