//! Options of the command line.

mod assets;
mod formats;
mod manual;
mod many;
mod mcp;
mod measure;

pub use assets::{
    Assets, AssetsCheck, AssetsFormat, AssetsGallery, AssetsImport, AssetsList, AssetsQueries, AssetsSearch, Furniture,
};
pub use formats::{Formats, UnityVersion, ViewName};
pub use manual::{Completions, Man, Page};
pub use many::{Batch, BatchCommand, BatchMerge, BatchRun, Sample, Shard};
pub use mcp::Mcp;
pub use measure::{Bench, BenchSolve, Eval, EvalDataset, EvalReport, EvalRequests, EvalRun, EvalSceneEval};

use crate::settings;
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
    /// Check programs and layouts: what holds, what fails, and by how much
    Check(Check),
    /// Find a layout that satisfies a program
    Solve(Solve),
    /// Repair a layout with the smallest change: move objects, or relax numbers and constraints
    Repair(Repair),
    /// Write a program from a request in plain English, with or without a language model, and report which clauses were understood
    Formalize(Formalize),
    /// Build a furnished, verified scene: layout, Unity project, glTF, pictures and a web page
    Synth(Synth),
    /// Draw many verified layouts of a program uniformly at random, and report their distribution
    Sample(Sample),
    /// Make a scene for each line of a manifest; a rerun skips the lines that are finished
    Batch(Batch),
    /// Work on one line of a manifest (started by `batch`)
    #[command(hide = true)]
    BatchLine,
    /// Show a layout in the browser, update it after every change, and edit it by dragging objects
    View(View),
    /// Export a layout to other formats: Unity project, glTF, pictures, a web page, files for simulators
    Export(Export),
    /// Write the program and the layout of a GLB file, a USD file or a Unity project, including the edits made in it, or of a
    /// house from another system
    Import(Import),
    /// Format programs
    Fmt(Fmt),
    /// Write a small commented program as a starting point
    New(New),
    /// Explain a code, keyword, predicate, function, property, setting or command, with examples
    Explain(Explain),
    /// List the known categories of objects with their usual sizes, roles and furniture
    Categories(Categories),
    /// Search for furniture, and check a folder of your own models
    #[command(subcommand)]
    Assets(Assets),
    /// Print the complete syntax tree of a program, even if it has errors
    Syntax(Inspect),
    /// Print what the names in a program refer to, and the types of its expressions
    Hir(Inspect),
    /// Print the formulas that the statements of a program expand to
    Constraints(Inspect),
    /// Compare two layouts: what moved, and what holds in one but not in the other
    Diff(Diff),
    /// Show the statements, objects and results of each requirement, or the requirements of a statement or an object
    Trace(Trace),
    /// Show information about an object: declaration, requirements, pose, constraints and margins
    Query(Query),
    /// Start the language server for an editor, on standard input and output
    Lsp(Lsp),
    /// Start the Model Context Protocol server for an AI assistant, on standard input and output
    Mcp(Mcp),
    /// Print shell completions
    Completions(Completions),
    /// Print the manual page of a command, or write the pages of all commands
    Man(Man),
    /// Print the JSON Schema of a format
    Schema(Schema),
    /// Measure how many problems are solved, and how fast
    #[command(subcommand)]
    Bench(Bench),
    /// Evaluate the translation of requests and the solver on requests with ground truth
    #[command(subcommand)]
    Eval(Eval),
}

/// `scenelang check`
#[derive(ClapArgs, Debug)]
pub struct Check {
    /// Programs (`room.scene`), layouts (`room.layout.json`), exported scenes (`room.glb`, `room.usda`, a Unity project), houses
    /// and layouts from AI2-THOR, LayoutVLM and SceneEval (`house.json`), and folders that contain programs and layouts
    #[arg(required = true, value_name = "FILE | FOLDER")]
    pub files: Vec<PathBuf>,
    /// The output format; json prints one report per file, each on one line
    #[arg(long, value_enum, default_value_t = Format::Human)]
    pub format: Format,
    /// How detailed the human-readable report is
    #[arg(long, value_enum, default_value_t = Verbosity::Full)]
    pub verbosity: Verbosity,
    /// Also list the statements and physical rules that hold, with their margins
    #[arg(long)]
    pub all: bool,
    /// How many violations to explain in full, with the smallest move that repairs them
    #[arg(long, value_name = "all|none|N", default_value = "20", value_parser = explain)]
    pub explain: scenelang_verify::Explain,
    /// Explain each contradiction in a program step by step
    #[arg(long)]
    pub explain_proof: bool,
    /// Accept only the published core language
    #[arg(long)]
    pub core: bool,
    /// Apply the safe fixes to the programs first; for a layout, to its program
    #[arg(long)]
    pub fix: bool,
    /// Apply the safe fixes and those that may change the meaning of the program, such as "did you mean"; review the changes afterwards
    #[arg(long)]
    pub unsafe_fixes: bool,
    /// Check again whenever a file changes, until Ctrl-C
    #[arg(long)]
    pub watch: bool,
    /// How many files to check in parallel [default: the number of processors]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..))]
    pub jobs: Option<u16>,
    /// The time limit for everything; if some files are not checked in time, the exit code is 2
    #[arg(long, value_name = "SECONDS", value_parser = seconds, allow_negative_numbers = true)]
    pub time: Option<f64>,
    /// Additional information about a file from another system
    #[command(flatten)]
    pub beside: Beside,
    /// How to judge
    #[command(flatten)]
    pub judging: Judging,
}

/// What else is known of a house or a layout of another system.
#[derive(ClapArgs, Debug, Clone, Default)]
pub struct Beside {
    /// For a house or a layout from another system: a JSON file with a `boundingBox` for each model
    #[arg(long, value_name = "FILE.json")]
    pub sizes: Option<PathBuf>,
    /// For a LayoutVLM layout: the room it belongs to
    #[arg(long, value_name = "FILE.json")]
    pub room: Option<PathBuf>,
}

/// `--explain`
fn explain(text: &str) -> Result<scenelang_verify::Explain, String> {
    use scenelang_verify::Explain;
    match text {
        "all" => Ok(Explain::All),
        "none" => Ok(Explain::First(0)),
        number => number.parse().map(Explain::First).map_err(|_| "expected all, none or a number".to_owned()),
    }
}

/// How a layout is checked. What is not given here comes from `scenelang.toml`.
#[derive(ClapArgs, Debug, Clone, Default)]
pub struct Judging {
    /// The shape of objects for collisions and clearances: the convex parts of their assets, or their bounding boxes [default: parts]
    #[arg(long, value_enum)]
    pub geometry: Option<Geometry>,
    /// Which doors the rule P-OPEN checks: those of rooms and furniture, those of rooms only, or none [default: all]
    #[arg(long, value_enum)]
    pub opens: Option<Opens>,
    /// Do not check the physical rules (collisions, bounds, support, doors that open)
    #[arg(long)]
    pub no_physics: bool,
    /// Check the physical rules, even if scenelang.toml switches them off
    #[arg(long, conflicts_with = "no_physics")]
    pub physics: bool,
    /// Thickness of the walls of a room (metres) [default: 0.03]
    #[arg(long, value_name = "METRES", value_parser = settings::measure)]
    pub eta: Option<f64>,
    /// Override a tolerance, such as `equal=0.002` (for the names, see `tolerances` in a report); may be given several times
    #[arg(long = "tolerance", value_name = "NAME=VALUE", value_parser = settings::tolerance)]
    pub tolerances: Vec<(String, f64)>,
}

/// `--format`
#[derive(ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// Human-readable text
    Human,
    /// One JSON report per line
    Json,
    /// SARIF 2.1.0, for code scanning
    Sarif,
    /// JUnit XML, for build servers
    Junit,
    /// Workflow commands, which annotate a pull request on GitHub
    Github,
}

/// `--verbosity`
#[derive(ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verbosity {
    /// One line per finding
    Compact,
    /// Each finding with the source text it refers to
    Full,
}

/// `--opens`
#[derive(ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
pub enum Opens {
    /// The doors of rooms, and the doors and drawers of furniture that must open to be usable
    All,
    /// Doors of rooms
    Doors,
    /// Nothing
    None,
}

/// `--geometry`
#[derive(ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
pub enum Geometry {
    /// Convex parts, if the layout has them
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
    /// The output file [default: the program's name with .layout.json]
    #[arg(short, long, value_name = "FILE")]
    pub output: Option<PathBuf>,
    /// Overwrite files that scenelang did not write or that were edited
    #[arg(long)]
    pub force: bool,
    /// A layout to start from; its objects stay where they are if the constraints allow it
    #[arg(long, value_name = "FILE")]
    pub layout: Option<PathBuf>,
    /// Objects or whole arrays that must stay exactly where they are in --layout
    #[arg(long, value_name = "NAME", num_args = 1.., requires = "layout", conflicts_with = "only")]
    pub lock: Vec<String>,
    /// The only objects or whole arrays that may move; all others stay where they are in --layout
    #[arg(long, value_name = "NAME", num_args = 1.., requires = "layout")]
    pub only: Vec<String>,
    /// The time limit for everything; the result then depends on the speed of the machine
    #[arg(long, value_name = "SECONDS", value_parser = seconds, allow_negative_numbers = true)]
    pub time: Option<f64>,
    /// The random seed; the same seed gives the same layout
    #[arg(long, default_value_t = 0, value_parser = seed, allow_negative_numbers = true)]
    pub seed: u64,
    /// Find this many substantially different layouts: NAME.1.layout.json and so on
    #[arg(long, value_name = "N", conflicts_with = "model", value_parser = clap::value_parser!(u16).range(1..=100))]
    pub alternatives: Option<u16>,
    /// Also report how far each object could still move, and whether it could turn
    #[arg(long)]
    pub free: bool,
    /// The effort of the search, and its threads
    #[command(flatten)]
    pub search: SearchOptions,
    /// The output format
    #[arg(long, value_enum, default_value_t = Plain::Text)]
    pub format: Plain,
    /// The language model
    #[command(flatten)]
    pub model: ModelOptions,
    /// The sources of furniture
    #[command(flatten)]
    pub furniture: Furniture,
    /// How to judge
    #[command(flatten)]
    pub judging: Judging,
}

/// The name of an object. After an option that takes several names a file would be one of them.
fn no_file(text: &str) -> Result<String, String> {
    if text.to_lowercase().ends_with(".json") {
        return Err(
            "this is a file; write it before the option, as in `scenelang repair FILE.layout.json --lock NAME`".into(),
        );
    }
    Ok(text.to_owned())
}

/// `scenelang repair`
#[derive(ClapArgs, Debug)]
#[command(override_usage = "scenelang repair <FILE.layout.json> [OPTIONS]")]
pub struct Repair {
    /// The layout
    #[arg(value_name = "FILE.layout.json")]
    pub layout: PathBuf,
    /// Repair only this violation: a line of the program, or an id from the report (`room.scene:12:1`, `P-COLLIDE:a:b`)
    #[arg(long, value_name = "LINE | ID")]
    pub constraint: Option<String>,
    /// Objects or whole arrays that must stay exactly where they are
    #[arg(long, value_name = "NAME", num_args = 1.., value_parser = no_file)]
    pub lock: Vec<String>,
    /// List the possible repairs without writing anything
    #[arg(long)]
    pub dry_run: bool,
    /// The number of the repair to apply [default: the first one, if it only moves objects]
    #[arg(long, value_name = "N", conflicts_with = "dry_run", value_parser = clap::value_parser!(u16).range(1..))]
    pub apply: Option<u16>,
    /// The output format
    #[arg(long, value_enum, default_value_t = Plain::Text)]
    pub format: Plain,
    /// The output file [default: the layout itself]
    #[arg(short, long, value_name = "FILE")]
    pub output: Option<PathBuf>,
    /// Overwrite files that scenelang did not write or that were edited
    #[arg(long)]
    pub force: bool,
    /// The time limit for everything; the result then depends on the speed of the machine
    #[arg(long, value_name = "SECONDS", value_parser = seconds, allow_negative_numbers = true)]
    pub time: Option<f64>,
    /// How to judge
    #[command(flatten)]
    pub judging: Judging,
}

/// How much `solve` and `synth` may spend on the search for a layout.
#[derive(ClapArgs, Debug, Clone)]
pub struct SearchOptions {
    /// The maximum number of threads; the result does not depend on it [default: the number of cores]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..))]
    threads: Option<u16>,
    /// Search N times as long as usual before giving up
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = clap::value_parser!(u64).range(1..=1000))]
    pub effort: u64,
    /// The work to spend on preferences once all hard constraints hold: 0 is none, 100 is five times the default
    #[arg(long, value_name = "PERCENT", default_value_t = scenelang_solve::QUALITY, value_parser = clap::value_parser!(u8).range(0..=100))]
    pub quality: u8,
}

impl SearchOptions {
    /// How many threads may search; 0: as many as there are cores.
    pub fn threads(&self) -> usize {
        self.threads.map_or(0, usize::from)
    }
}

/// A language model that proposes moves, for `solve` and `synth`. What is not given here comes from `scenelang.toml`.
#[derive(ClapArgs, Debug, Clone, Default)]
pub struct ModelOptions {
    /// The language model to use: openai, anthropic, gemini, deepseek, ollama or compatible, each with `:NAME`;
    /// `configured` for the one in scenelang.toml; `replay:FILE` for a recorded conversation; `none` [env: SCENELANG_MODEL]
    /// [default: none]
    #[arg(long, value_name = "PROVIDER:NAME")]
    pub model: Option<String>,
    /// The URL of the model, instead of the default URL of its provider
    #[arg(long, value_name = "URL")]
    pub base_url: Option<String>,
    /// The maximum number of requests to the model [default: 100]
    #[arg(long, value_name = "N")]
    pub max_calls: Option<u64>,
    /// The maximum number of tokens, input and output together [default: 500000]
    #[arg(long, value_name = "N")]
    pub max_tokens: Option<u64>,
    /// Do not use the network: take the model's answers from the cache only
    #[arg(long)]
    pub offline: bool,
    /// Record the conversation with the model in a file
    #[arg(long, value_name = "FILE")]
    pub record: Option<PathBuf>,
}

/// `scenelang formalize`
#[derive(ClapArgs, Debug)]
pub struct Formalize {
    /// The request: "a meeting room with a long table and eight chairs around it"
    #[arg(value_name = "REQUEST", required_unless_present_any = ["file", "from_brief"], conflicts_with = "file")]
    pub request: Option<String>,
    /// A file with the request; `-` reads standard input
    #[arg(short, long, value_name = "FILE")]
    pub file: Option<PathBuf>,
    /// Print what was understood as JSON (schema `brief`), without writing a program
    #[arg(long, conflicts_with_all = ["output", "explain", "from_brief"])]
    pub brief: bool,
    /// Continue from the output of `--brief`; `-` reads standard input
    #[arg(long, value_name = "FILE.json", conflicts_with_all = ["request", "file"])]
    pub from_brief: Option<PathBuf>,
    /// Exit with 1 if a word of the request was not used, or a requirement became a preference
    #[arg(long)]
    pub strict: bool,
    /// The output file [default: standard output]
    #[arg(short, long, value_name = "FILE.scene")]
    pub output: Option<PathBuf>,
    /// Overwrite files that scenelang did not write or that were edited
    #[arg(long)]
    pub force: bool,
    /// Add nothing that is not in the request
    #[arg(long)]
    pub literal: bool,
    /// Do not check whether a layout exists; faster, but the program may ask for more than fits
    #[arg(long)]
    pub untried: bool,
    /// The time limit for everything, including checking whether a layout exists
    #[arg(long, value_name = "SECONDS", value_parser = seconds, allow_negative_numbers = true)]
    pub time: Option<f64>,
    /// Show how each clause of the request was understood
    #[arg(long)]
    pub explain: bool,
    /// The output format
    #[arg(long, value_enum, default_value_t = SummaryFormat::Human)]
    pub format: SummaryFormat,
    /// The language model
    #[command(flatten)]
    pub model: ModelOptions,
}

/// `scenelang synth`
#[derive(ClapArgs, Debug)]
pub struct Synth {
    /// A request in plain English, or a program
    #[arg(value_name = "REQUEST | FILE.scene")]
    pub request: String,
    /// For a request: add nothing that is not in it
    #[arg(long)]
    pub literal: bool,
    /// The output folder
    #[arg(short, long, value_name = "FOLDER", default_value = "out")]
    pub output: PathBuf,
    /// Overwrite files that scenelang did not write or that were edited
    #[arg(long)]
    pub force: bool,
    /// How to treat edited scenes
    #[command(flatten)]
    pub edits: Edits,
    /// The random seed; the same seed gives the same scene
    #[arg(long, default_value_t = 0, value_parser = seed, allow_negative_numbers = true)]
    pub seed: u64,
    /// The time limit for reading the request and finding a layout; the result then depends on the speed of the machine
    #[arg(long, value_name = "SECONDS", value_parser = seconds, allow_negative_numbers = true)]
    pub time: Option<f64>,
    /// The effort of the search, and its threads
    #[command(flatten)]
    pub search: SearchOptions,
    /// The output format
    #[arg(long, value_enum, default_value_t = SummaryFormat::Human)]
    pub format: SummaryFormat,
    /// The formats to write besides program, layout and report
    #[command(flatten)]
    pub formats: Formats,
    /// The render pipeline for the Unity materials
    #[arg(long, value_enum, default_value_t = Pipeline::Builtin)]
    pub pipeline: Pipeline,
    /// Rerun this stage and all later ones, even if nothing has changed
    #[arg(long, value_name = "STAGE", value_enum)]
    pub from: Option<StageName>,
    /// Stop after this stage
    #[arg(long, value_name = "STAGE", value_enum, default_value_t = StageName::Export, hide_default_value = true)]
    pub until: StageName,
    /// Print what is rebuilt for each stage and object, and why
    #[arg(long)]
    pub explain_rebuild: bool,
    /// The language model
    #[command(flatten)]
    pub model: ModelOptions,
    /// The sources of furniture
    #[command(flatten)]
    pub furniture: Furniture,
}

/// `synth --from`, `synth --until`: a stage
#[derive(ValueEnum, Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum StageName {
    /// The program is written and compiled
    Program,
    /// Every object gets a size and its parts
    Assets,
    /// Every object gets a position
    Layout,
    /// The exported files are written
    Export,
}

/// `scenelang view`
#[derive(ClapArgs, Debug)]
pub struct View {
    /// A layout, or a program with its layout beside it
    #[arg(value_name = "FILE.scene | FILE.layout.json")]
    pub file: PathBuf,
    /// The local port [default: any free port]
    #[arg(long, value_name = "N", default_value_t = 0, hide_default_value = true)]
    pub port: u16,
    /// Print the address without opening a browser
    #[arg(long)]
    pub no_open: bool,
    /// Select the object that each line of standard input names, and stop at its end: how the language server shows a room
    #[arg(long, hide = true)]
    pub follow: bool,
}

/// `scenelang export`
#[derive(ClapArgs, Debug)]
pub struct Export {
    /// The layout, or the program beside it
    #[arg(value_name = "FILE.layout.json")]
    pub layout: PathBuf,
    /// The output folder
    #[arg(short, long, value_name = "FOLDER", default_value = "out")]
    pub output: PathBuf,
    /// Overwrite files that scenelang did not write or that were edited
    #[arg(long)]
    pub force: bool,
    /// How to treat edited scenes
    #[command(flatten)]
    pub edits: Edits,
    /// The formats to write
    #[command(flatten)]
    pub formats: Formats,
    /// Export only this object as a robot, in the format `urdf`; other formats only if they are named
    #[arg(long, value_name = "NAME")]
    pub object: Option<String>,
    /// Also write `mjcf`, load it in MuJoCo, and report what overlaps, how far objects move in two seconds, and how far
    /// joints open. This needs Python with the package mujoco; SCENELANG_PYTHON sets the interpreter
    #[arg(long = "try")]
    pub trial: bool,
    /// The output format
    #[arg(long, value_enum, default_value_t = SummaryFormat::Human)]
    pub format: SummaryFormat,
    /// Print for each format whether it is rebuilt, and why
    #[arg(long)]
    pub explain_rebuild: bool,
}

/// `scenelang import`
#[derive(ClapArgs, Debug)]
pub struct Import {
    /// An exported scene, edited or not: `room.glb`, `room.usda`, or the folder of a Unity project; or a house or a layout from
    /// AI2-THOR, LayoutVLM or SceneEval: `house.json`
    #[arg(value_name = "FILE | PROJECT")]
    pub scene: PathBuf,
    /// Additional information about a file from another system
    #[command(flatten)]
    pub beside: Beside,
    /// The output folder
    #[arg(short, long, value_name = "FOLDER")]
    pub output: PathBuf,
    /// Overwrite files that scenelang did not write or that were edited
    #[arg(long)]
    pub force: bool,
}

/// What `export` and `synth` do where they would write over an exported scene that was edited since.
#[derive(ClapArgs, Debug, Clone, Copy, Default)]
pub struct Edits {
    /// Continue from the exported scene (GLB, USD, Unity project), with the edits made in it
    #[arg(long, conflicts_with = "overwrite")]
    pub take: bool,
    /// Overwrite edited scenes and discard the edits
    #[arg(long)]
    pub overwrite: bool,
}

/// `synth --format`, `export --format`, `diff --format`, `eval --format`, `trace --format`, `query --format`
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
    /// Do not change files; exit with 1 if a file is not formatted
    #[arg(long)]
    pub check: bool,
    /// The maximum line length, in characters
    #[arg(long, default_value_t = 100, value_parser = clap::value_parser!(u16).range(40..=400))]
    pub width: u16,
}

/// `scenelang new`
#[derive(ClapArgs, Debug)]
pub struct New {
    /// The file to write; its name must end in `.scene`
    #[arg(value_name = "FILE.scene")]
    pub file: PathBuf,
    /// Overwrite the file if it exists
    #[arg(long)]
    pub force: bool,
}

/// `scenelang explain`
#[derive(ClapArgs, Debug)]
pub struct Explain {
    /// A code (E0201), a predicate, function or property (near, gap, surface), a setting (eta) or a command (solve)
    #[arg(value_name = "WORD", required = true)]
    pub words: Vec<String>,
    /// Also write the drawings of what the words mean, NAME.svg, into this folder
    #[arg(long, value_name = "FOLDER")]
    pub drawings: Option<PathBuf>,
    /// Overwrite files that scenelang did not write or that were edited
    #[arg(long, requires = "drawings")]
    pub force: bool,
}

/// `scenelang categories`
#[derive(ClapArgs, Debug)]
pub struct Categories {
    /// List only categories that contain this word
    pub word: Option<String>,
    /// Also write a picture of each listed category, CATEGORY.png, into this folder
    #[arg(long, value_name = "FOLDER")]
    pub pictures: Option<PathBuf>,
    /// Overwrite files that scenelang did not write or that were edited
    #[arg(long, requires = "pictures")]
    pub force: bool,
    /// The output format
    #[arg(long, value_enum, default_value_t = Plain::Text)]
    pub format: Plain,
}

/// `scenelang syntax`, `scenelang hir`, `scenelang constraints`
#[derive(ClapArgs, Debug)]
pub struct Inspect {
    /// The program; `-` reads standard input
    #[arg(value_name = "FILE.scene")]
    pub file: PathBuf,
    /// The output format
    #[arg(long, value_enum, default_value_t = Plain::Text)]
    pub format: Plain,
}

/// `--format` of the commands that show what becomes of a program
#[derive(ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
pub enum Plain {
    /// Human-readable text
    Text,
    /// A JSON object on one line
    Json,
}

/// `scenelang diff`
#[derive(ClapArgs, Debug)]
pub struct Diff {
    /// The first layout, or a GLB file or Unity project that `synth` wrote
    #[arg(value_name = "A")]
    pub before: PathBuf,
    /// The second layout
    #[arg(value_name = "B")]
    pub after: PathBuf,
    /// The output format
    #[arg(long, value_enum, default_value_t = SummaryFormat::Human)]
    pub format: SummaryFormat,
    /// Do not list margins that differ by less than this (metres or degrees)
    #[arg(long, default_value = "0.001", value_parser = settings::measure)]
    pub threshold: f64,
    /// How to judge
    #[command(flatten)]
    pub judging: Judging,
}

/// `scenelang trace`
#[derive(ClapArgs, Debug)]
pub struct Trace {
    /// The program; `-` reads standard input
    #[arg(value_name = "FILE.scene")]
    pub file: PathBuf,
    /// The layout to check [default: the one beside the program, if it exists]
    #[arg(value_name = "FILE.layout.json")]
    pub layout: Option<PathBuf>,
    /// How to group the output
    #[arg(long, value_enum, default_value_t = By::Requirement)]
    pub by: By,
    /// The output format
    #[arg(long, value_enum, default_value_t = SummaryFormat::Human)]
    pub format: SummaryFormat,
    /// How to judge
    #[command(flatten)]
    pub judging: Judging,
}

/// `trace --by`
#[derive(ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
pub enum By {
    /// From each requirement to its statements and their objects
    Requirement,
    /// From each object to its statements and their requirements
    Object,
}

/// `scenelang query`
#[derive(ClapArgs, Debug)]
pub struct Query {
    /// A program with its layout beside it, a layout, a GLB or USD file, or a Unity project
    #[arg(value_name = "SCENE")]
    pub scene: PathBuf,
    /// An object, such as `chair[2]`, or an array, such as `chair` [default: a table of all objects]
    #[arg(long, value_name = "NAME")]
    pub object: Option<String>,
    /// The output format
    #[arg(long, value_enum, default_value_t = SummaryFormat::Human)]
    pub format: SummaryFormat,
    /// How to judge
    #[command(flatten)]
    pub judging: Judging,
}

/// `scenelang lsp`
#[derive(ClapArgs, Debug)]
pub struct Lsp {
    /// Record the session in a file, one message per line
    #[arg(long, value_name = "FILE", conflicts_with = "replay")]
    pub record: Option<PathBuf>,
    /// Replay the client of a recorded session instead of reading standard input
    #[arg(long, value_name = "FILE")]
    pub replay: Option<PathBuf>,
    /// Ignored; accepted because some editors pass it. The server always uses standard input and output
    #[arg(long, hide = true)]
    pub stdio: bool,
}

/// `scenelang schema`
#[derive(ClapArgs, Debug)]
pub struct Schema {
    /// The format
    #[arg(value_parser = schema_names())]
    pub name: String,
}

/// A time limit.
fn seconds(text: &str) -> Result<f64, String> {
    let seconds: f64 = text.parse().unwrap_or(f64::NAN);
    if (0.001..=1e6).contains(&seconds) {
        Ok(seconds)
    } else {
        Err("expected a number of seconds greater than 0".to_owned())
    }
}

/// `--seed`
fn seed(text: &str) -> Result<u64, String> {
    text.parse().map_err(|_| format!("expected a whole number from 0 to {}", u64::MAX))
}

fn schema_names() -> clap::builder::PossibleValuesParser {
    scenelang_verify::schemas::ALL.iter().map(|(name, _)| *name).collect::<Vec<_>>().into()
}
