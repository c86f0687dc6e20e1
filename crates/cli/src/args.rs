//! Options of the command line.

use clap::{Args as ClapArgs, Parser, Subcommand, ValueEnum};
use std::path::PathBuf;

/// Scenes as programs: check, solve and build 3D scenes from their requirements.
#[derive(Parser, Debug)]
#[command(name = "scenelang", version, about, propagate_version = true, max_term_width = 100)]
pub struct Args {
    /// What to do.
    #[command(subcommand)]
    pub command: Command,
}

/// The commands.
#[derive(Subcommand, Debug)]
pub enum Command {
    /// Check programs and layouts: what holds, by how much, and what fails
    Check(Check),
    /// Place the objects of a program so that its constraints hold
    Solve(Solve),
    /// Build a furnished, verified scene: layout, Unity project, glTF, pictures, a page to look at
    Synth(Synth),
    /// Write programs in the standard form
    Fmt(Fmt),
    /// Write a small commented program to start from
    New(New),
    /// Show the page of a code: what it says, why, an example, what to do
    Explain(Explain),
    /// Print what the statements of a program become
    Constraints(Constraints),
}

/// `scenelang check`
#[derive(ClapArgs, Debug)]
pub struct Check {
    /// Programs (`room.scene`) and layouts (`room.layout.json`)
    #[arg(required = true, value_name = "FILE")]
    pub files: Vec<PathBuf>,
    /// How the report is written; with json, one report per line and file
    #[arg(long, value_enum, default_value_t = Format::Human)]
    pub format: Format,
    /// List physical rules that hold, too
    #[arg(long)]
    pub all: bool,
    /// With each contradiction in a program, say step by step why it is one
    #[arg(long)]
    pub explain_proof: bool,
    /// Accept only the published core language
    #[arg(long)]
    pub core: bool,
    /// How to judge
    #[command(flatten)]
    pub judging: Judging,
}

/// How a layout is judged.
#[derive(ClapArgs, Debug, Clone, Copy)]
pub struct Judging {
    /// What a solid is: the convex parts of its asset, or its box
    #[arg(long, value_enum, default_value_t = Geometry::Parts)]
    pub geometry: Geometry,
    /// Leave out the physical rules (collisions, bounds, support)
    #[arg(long)]
    pub no_physics: bool,
}

/// `--format`
#[derive(ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// For people
    Human,
    /// One JSON report per line
    Json,
    /// SARIF 2.1.0, for code scanning
    Sarif,
    /// JUnit XML, for build servers
    Junit,
}

/// `--geometry`
#[derive(ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
pub enum Geometry {
    /// Convex parts where the layout gives them
    Parts,
    /// Bounding boxes
    Box,
}

/// `scenelang solve`
#[derive(ClapArgs, Debug)]
pub struct Solve {
    /// The program
    #[arg(value_name = "FILE.scene")]
    pub scene: PathBuf,
    /// Where the layout goes [default: the program's name with .layout.json]
    #[arg(short, long, value_name = "FILE")]
    pub output: Option<PathBuf>,
    /// A layout to start from: its objects stay where they are as far as the constraints let them
    #[arg(long, value_name = "FILE")]
    pub layout: Option<PathBuf>,
    /// The same seed gives the same layout
    #[arg(long, default_value_t = 0)]
    pub seed: u64,
    /// How to judge
    #[command(flatten)]
    pub judging: Judging,
}

/// `scenelang synth`
#[derive(ClapArgs, Debug)]
pub struct Synth {
    /// A program, or a request in plain words
    #[arg(value_name = "FILE.scene | REQUEST")]
    pub request: String,
    /// The folder to write to
    #[arg(short, long, value_name = "FOLDER", default_value = "out")]
    pub output: PathBuf,
    /// The same seed gives the same scene
    #[arg(long, default_value_t = 0)]
    pub seed: u64,
    /// How the summary is written
    #[arg(long, value_enum, default_value_t = SummaryFormat::Human)]
    pub format: SummaryFormat,
    /// Shaders that the Unity materials are for
    #[arg(long, value_enum, default_value_t = Pipeline::Builtin)]
    pub pipeline: Pipeline,
}

/// `synth --format`
#[derive(ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
pub enum SummaryFormat {
    /// A table
    Human,
    /// A JSON object
    Json,
}

/// `synth --pipeline`
#[derive(ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
pub enum Pipeline {
    /// Unity's built-in render pipeline
    Builtin,
    /// The Universal Render Pipeline
    Urp,
}

/// `scenelang fmt`
#[derive(ClapArgs, Debug)]
pub struct Fmt {
    /// Programs; `-` reads standard input and writes standard output
    #[arg(required = true, value_name = "FILE")]
    pub files: Vec<PathBuf>,
    /// Change nothing; exit 1 if a file is not in the standard form
    #[arg(long)]
    pub check: bool,
    /// Longest line (characters)
    #[arg(long, default_value_t = 100, value_parser = clap::value_parser!(u16).range(40..=400))]
    pub width: u16,
}

/// `scenelang new`
#[derive(ClapArgs, Debug)]
pub struct New {
    /// The file to write; one that is there already is left alone
    #[arg(value_name = "FILE.scene")]
    pub file: PathBuf,
}

/// `scenelang explain`
#[derive(ClapArgs, Debug)]
pub struct Explain {
    /// A code such as E0201
    pub code: String,
}

/// `scenelang constraints`
#[derive(ClapArgs, Debug)]
pub struct Constraints {
    /// The program
    #[arg(value_name = "FILE.scene")]
    pub file: PathBuf,
}
