//! Options of the command line.

mod assets;
mod manual;
mod many;
mod mcp;
mod measure;

pub use assets::{Assets, AssetsCheck, AssetsFormat, AssetsGallery, AssetsImport, AssetsList, AssetsSearch, Furniture};
pub use manual::{Completions, Man, Page};
pub use many::{Batch, BatchCommand, BatchMerge, BatchRun, Sample};
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
    /// Check programs and layouts: what holds, by how much, and what fails
    Check(Check),
    /// Place the objects of a program so that its constraints hold
    Solve(Solve),
    /// Repair a layout by the smallest change: moves, or numbers and constraints to relax
    Repair(Repair),
    /// Write a program from a request in plain words, with a model or without: every clause is accounted for
    Formalize(Formalize),
    /// Build a furnished, verified scene: layout, Unity project, glTF, pictures, a page to look at
    Synth(Synth),
    /// Draw many verified layouts of a program, uniformly, and say how far they are spread
    Sample(Sample),
    /// Make a scene for each line of a manifest; what is done already is kept
    Batch(Batch),
    /// Work on one line of a manifest: `batch` starts it
    #[command(hide = true)]
    BatchLine,
    /// Show a layout in the browser, follow every change, and let objects be dragged
    View(View),
    /// Write a layout as it is in other formats: Unity project, glTF, pictures, a page to look at
    Export(Export),
    /// Write the program and the layout of a GLB or USD file or a Unity project, as the scene stands there now; or of a house of
    /// another system
    Import(Import),
    /// Write programs in the standard form
    Fmt(Fmt),
    /// Write a small commented program to start from
    New(New),
    /// Show what a code, predicate, function or property means, with examples
    Explain(Explain),
    /// List the kinds of things that are known, with their usual sizes
    Categories(Categories),
    /// Look for furniture, and check a folder of your own models
    #[command(subcommand)]
    Assets(Assets),
    /// Print the syntax tree of a program, every byte of it; also of a broken one
    Syntax(Inspect),
    /// Print what the names and expressions of a program mean
    Hir(Inspect),
    /// Print what the statements of a program become
    Constraints(Inspect),
    /// Say what two layouts differ in, and what holds in one but not in the other
    Diff(Diff),
    /// Say what became of each requirement: statements, objects, verdict; and the other way round
    Trace(Trace),
    /// Say what is known of an object: where it is declared, what for, how it stands, what holds of it
    Query(Query),
    /// Serve an editor over standard input and output, by the Language Server Protocol
    Lsp(Lsp),
    /// Serve an assistant over standard input and output, by the Model Context Protocol
    Mcp(Mcp),
    /// Print what a shell needs to complete commands and options
    Completions(Completions),
    /// Print the manual page of a command, or write those of all
    Man(Man),
    /// Print the JSON Schema of a format
    Schema(Schema),
    /// Measure how much of a set of problems is solved, and how fast
    #[command(subcommand)]
    Bench(Bench),
    /// Measure how much of what is asked for becomes part of a program
    #[command(subcommand)]
    Eval(Eval),
}

/// `scenelang check`
#[derive(ClapArgs, Debug)]
pub struct Check {
    /// Programs (`room.scene`), layouts (`room.layout.json`), what `synth` wrote (`room.glb`, `room.usda`, a Unity project),
    /// houses and layouts of AI2-THOR, LayoutVLM and SceneEval (`house.json`), and folders: all programs and layouts below
    #[arg(required = true, value_name = "FILE | FOLDER")]
    pub files: Vec<PathBuf>,
    /// How the report is written; with json, one report per line and file
    #[arg(long, value_enum, default_value_t = Format::Human)]
    pub format: Format,
    /// How much the report for people says
    #[arg(long, value_enum, default_value_t = Verbosity::Full)]
    pub verbosity: Verbosity,
    /// List physical rules that hold, too
    #[arg(long)]
    pub all: bool,
    /// How many violations are explained in full, with the smallest move that repairs them
    #[arg(long, value_name = "all|none|N", default_value = "20", value_parser = explain)]
    pub explain: scenelang_verify::Explain,
    /// With each contradiction in a program, say step by step why it is one
    #[arg(long)]
    pub explain_proof: bool,
    /// Accept only the published core language
    #[arg(long)]
    pub core: bool,
    /// Make the safe fixes in the programs first; of a layout, in its program
    #[arg(long)]
    pub fix: bool,
    /// Check again whenever one of the files changes, until Ctrl-C
    #[arg(long)]
    pub watch: bool,
    /// How many files are judged at once [default: as many as there are processors]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..))]
    pub jobs: Option<u16>,
    /// All of it takes at most so long; what is not judged by then could not be judged (exit 2)
    #[arg(long, value_name = "SECONDS", value_parser = seconds)]
    pub time: Option<f64>,
    /// What is known of a file of another system
    #[command(flatten)]
    pub beside: Beside,
    /// How to judge
    #[command(flatten)]
    pub judging: Judging,
}

/// What else is known of a house or a layout of another system.
#[derive(ClapArgs, Debug, Clone, Default)]
pub struct Beside {
    /// For a house or a layout of another system: how large its models are, as a JSON file in which each has a `boundingBox`
    #[arg(long, value_name = "FILE.json")]
    pub sizes: Option<PathBuf>,
    /// For a layout of LayoutVLM: the room that it belongs to
    #[arg(long, value_name = "FILE.json")]
    pub room: Option<PathBuf>,
}

/// `--explain`
fn explain(text: &str) -> Result<scenelang_verify::Explain, String> {
    use scenelang_verify::Explain;
    match text {
        "all" => Ok(Explain::All),
        "none" => Ok(Explain::First(0)),
        number => number.parse().map(Explain::First).map_err(|_| "it is all, none or a number".to_owned()),
    }
}

/// How a layout is judged. What is not given here comes from `scenelang.toml`.
#[derive(ClapArgs, Debug, Clone, Default)]
pub struct Judging {
    /// What a solid is: the convex parts of its asset, or its box [default: parts]
    #[arg(long, value_enum)]
    pub geometry: Option<Geometry>,
    /// Of what P-OPEN demands that it opens: the doors of rooms and furniture, or the doors of rooms only [default: doors]
    #[arg(long, value_enum)]
    pub opens: Option<Opens>,
    /// Leave out the physical rules (collisions, bounds, support, what opens)
    #[arg(long)]
    pub no_physics: bool,
    /// Apply the physical rules, whatever scenelang.toml says
    #[arg(long, conflicts_with = "no_physics")]
    pub physics: bool,
    /// Thickness of the walls of a room (metres) [default: 0.03]
    #[arg(long, value_name = "METRES", value_parser = settings::measure)]
    pub eta: Option<f64>,
    /// A tolerance, by the name that reports echo: `equal=0.002`; may be given several times
    #[arg(long = "tolerance", value_name = "NAME=VALUE", value_parser = settings::tolerance)]
    pub tolerances: Vec<(String, f64)>,
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
    /// Workflow commands: annotations of a pull request on GitHub
    Github,
}

/// `--verbosity`
#[derive(ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verbosity {
    /// A line for each finding
    Compact,
    /// Each finding with the text it speaks of
    Full,
}

/// `--opens`
#[derive(ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
pub enum Opens {
    /// Doors of rooms, and furniture as far as is of use
    All,
    /// Doors of rooms
    Doors,
    /// Nothing
    None,
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
    /// Replace files that scenelang did not write, or that were edited since
    #[arg(long)]
    pub force: bool,
    /// A layout to start from: its objects stay where they are as far as the constraints let them
    #[arg(long, value_name = "FILE")]
    pub layout: Option<PathBuf>,
    /// Objects, or whole arrays, that stay exactly where --layout has them
    #[arg(long, value_name = "NAME", num_args = 1.., requires = "layout", conflicts_with = "only")]
    pub lock: Vec<String>,
    /// Only these objects, or whole arrays, may move: all others stay where --layout has them
    #[arg(long, value_name = "NAME", num_args = 1.., requires = "layout")]
    pub only: Vec<String>,
    /// All of it takes at most so long; what comes of it then depends on the machine
    #[arg(long, value_name = "SECONDS", value_parser = seconds)]
    pub time: Option<f64>,
    /// The same seed gives the same layout
    #[arg(long, default_value_t = 0)]
    pub seed: u64,
    /// So many layouts that differ in kind: NAME.1.layout.json and so on
    #[arg(long, value_name = "N", conflicts_with = "model", value_parser = clap::value_parser!(u16).range(1..=100))]
    pub alternatives: Option<u16>,
    /// Also say what the layout leaves open: how far each object could still move, and whether it could turn
    #[arg(long)]
    pub free: bool,
    /// How long and on how many threads to search
    #[command(flatten)]
    pub search: Search,
    /// How the result is printed
    #[arg(long, value_enum, default_value_t = Plain::Text)]
    pub format: Plain,
    /// Which model proposes
    #[command(flatten)]
    pub model: Model,
    /// Where furniture comes from
    #[command(flatten)]
    pub furniture: Furniture,
    /// How to judge
    #[command(flatten)]
    pub judging: Judging,
}

/// `scenelang repair`
#[derive(ClapArgs, Debug)]
pub struct Repair {
    /// The layout
    #[arg(value_name = "FILE.layout.json")]
    pub layout: PathBuf,
    /// Repair only this: a line of the program, or an id as in the report (`room.scene:12:1`, `P-COLLIDE:a:b`)
    #[arg(long, value_name = "LINE | ID")]
    pub constraint: Option<String>,
    /// Say what could be done and write nothing
    #[arg(long)]
    pub dry_run: bool,
    /// Make this change, by its number [default: the first, if it only moves things]
    #[arg(long, value_name = "N", conflicts_with = "dry_run", value_parser = clap::value_parser!(u16).range(1..))]
    pub apply: Option<u16>,
    /// How the alternatives are written
    #[arg(long, value_enum, default_value_t = Plain::Text)]
    pub format: Plain,
    /// Where the repaired layout goes [default: in place of the old one]
    #[arg(short, long, value_name = "FILE")]
    pub output: Option<PathBuf>,
    /// Replace files that scenelang did not write, or that were edited since
    #[arg(long)]
    pub force: bool,
    /// All of it takes at most so long; what is found then depends on the machine
    #[arg(long, value_name = "SECONDS", value_parser = seconds)]
    pub time: Option<f64>,
    /// How to judge
    #[command(flatten)]
    pub judging: Judging,
}

/// How much `solve` and `synth` may spend on the search for a layout.
#[derive(ClapArgs, Debug, Clone)]
pub struct Search {
    /// The search uses at most so many threads [default: as many as there are cores]; the result does not depend on it
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..))]
    threads: Option<u16>,
    /// N times the usual work before the search gives up
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = clap::value_parser!(u64).range(1..=1000))]
    pub effort: u64,
    /// How much of the work may go into preferences once all that must hold does, in percent: 0 leaves them as they come
    #[arg(long, value_name = "PERCENT", default_value_t = scenelang_solve::QUALITY, value_parser = clap::value_parser!(u8).range(0..=100))]
    pub quality: u8,
}

impl Search {
    /// How many threads may search; 0: as many as there are cores.
    pub fn threads(&self) -> usize {
        self.threads.map_or(0, usize::from)
    }
}

/// A language model that proposes moves, for `solve` and `synth`. What is not given here comes from `scenelang.toml`.
#[derive(ClapArgs, Debug, Clone, Default)]
pub struct Model {
    /// A language model that proposes moves: openai, anthropic, gemini, deepseek, ollama, compatible; `configured` is the
    /// one that scenelang.toml names; `replay:FILE` plays a recorded conversation; `none` [env: SCENELANG_MODEL]
    /// [default: none]
    #[arg(long, value_name = "PROVIDER:NAME")]
    pub model: Option<String>,
    /// Where the model is, in place of the provider's own address
    #[arg(long, value_name = "URL")]
    pub base_url: Option<String>,
    /// The most requests to the model [default: 100]
    #[arg(long, value_name = "N")]
    pub max_calls: Option<u64>,
    /// The most tokens, read and written [default: 500000]
    #[arg(long, value_name = "N")]
    pub max_tokens: Option<u64>,
    /// Use no network: the model's answers come from the cache or not at all
    #[arg(long)]
    pub offline: bool,
    /// Write the conversation with the model to a file
    #[arg(long, value_name = "FILE")]
    pub record: Option<PathBuf>,
}

/// `scenelang formalize`
#[derive(ClapArgs, Debug)]
pub struct Formalize {
    /// The request: "a meeting room with a long table and eight chairs around it"
    #[arg(value_name = "REQUEST", required_unless_present_any = ["file", "from_brief"], conflicts_with = "file")]
    pub request: Option<String>,
    /// A file with the request; `-` is standard input
    #[arg(short, long, value_name = "FILE")]
    pub file: Option<PathBuf>,
    /// Print what was understood as JSON (the schema `brief`), and write no program
    #[arg(long, conflicts_with_all = ["output", "explain", "from_brief"])]
    pub brief: bool,
    /// Go on from what `--brief` printed; `-` is standard input
    #[arg(long, value_name = "FILE.json", conflicts_with_all = ["request", "file"])]
    pub from_brief: Option<PathBuf>,
    /// Exit with 1 if a word of the request became nothing, or what it demands became a preference
    #[arg(long)]
    pub strict: bool,
    /// The program to write [default: standard output]
    #[arg(short, long, value_name = "FILE.scene")]
    pub output: Option<PathBuf>,
    /// Replace files that scenelang did not write, or that were edited since
    #[arg(long)]
    pub force: bool,
    /// Add nothing that the request does not say
    #[arg(long)]
    pub literal: bool,
    /// Do not try to furnish the room: faster, but perhaps more is asked than there is room for
    #[arg(long)]
    pub untried: bool,
    /// All of it takes at most so long: the trial whether there is a layout ends in time
    #[arg(long, value_name = "SECONDS", value_parser = seconds)]
    pub time: Option<f64>,
    /// List clause by clause what became of it
    #[arg(long)]
    pub explain: bool,
    /// How the outcome is written
    #[arg(long, value_enum, default_value_t = SummaryFormat::Human)]
    pub format: SummaryFormat,
    /// Which model reads
    #[command(flatten)]
    pub model: Model,
}

/// `scenelang synth`
#[derive(ClapArgs, Debug)]
pub struct Synth {
    /// A request in plain words, or a program
    #[arg(value_name = "REQUEST | FILE.scene")]
    pub request: String,
    /// Of a request: add nothing that it does not say
    #[arg(long)]
    pub literal: bool,
    /// The folder to write to
    #[arg(short, long, value_name = "FOLDER", default_value = "out")]
    pub output: PathBuf,
    /// Replace files that scenelang did not write, or that were edited since
    #[arg(long)]
    pub force: bool,
    /// What becomes of scenes that were edited
    #[command(flatten)]
    pub edits: Edits,
    /// The same seed gives the same scene
    #[arg(long, default_value_t = 0)]
    pub seed: u64,
    /// The layout takes at most so long, and a request before it; what comes of it then depends on the machine
    #[arg(long, value_name = "SECONDS", value_parser = seconds)]
    pub time: Option<f64>,
    /// How long and on how many threads to search
    #[command(flatten)]
    pub search: Search,
    /// How the summary is written
    #[arg(long, value_enum, default_value_t = SummaryFormat::Human)]
    pub format: SummaryFormat,
    /// Which formats are written beside program, layout and report
    #[command(flatten)]
    pub formats: Formats,
    /// Shaders that the Unity materials are for
    #[arg(long, value_enum, default_value_t = Pipeline::Builtin)]
    pub pipeline: Pipeline,
    /// Which model proposes
    #[command(flatten)]
    pub model: Model,
    /// Where furniture comes from
    #[command(flatten)]
    pub furniture: Furniture,
}

/// `scenelang view`
#[derive(ClapArgs, Debug)]
pub struct View {
    /// A program, whose layout is beside it, or a layout
    #[arg(value_name = "FILE.scene | FILE.layout.json")]
    pub file: PathBuf,
    /// The port on this machine [default: any that is free]
    #[arg(long, value_name = "N", default_value_t = 0, hide_default_value = true)]
    pub port: u16,
    /// Open no browser: print the address only
    #[arg(long)]
    pub no_open: bool,
}

/// `scenelang export`
#[derive(ClapArgs, Debug)]
pub struct Export {
    /// The layout, or the program beside it
    #[arg(value_name = "FILE.layout.json")]
    pub layout: PathBuf,
    /// The folder to write to
    #[arg(short, long, value_name = "FOLDER", default_value = "out")]
    pub output: PathBuf,
    /// Replace files that scenelang did not write, or that were edited since
    #[arg(long)]
    pub force: bool,
    /// What becomes of scenes that were edited
    #[command(flatten)]
    pub edits: Edits,
    /// Which formats
    #[command(flatten)]
    pub formats: Formats,
    /// Write this object alone as a robot, in the format `urdf`; other formats as well only if they are named
    #[arg(long, value_name = "NAME")]
    pub object: Option<String>,
    /// Also write `mjcf`, load it in MuJoCo, and say what overlaps and how far things move in two seconds. It needs Python
    /// with the package mujoco; SCENELANG_PYTHON names which
    #[arg(long = "try")]
    pub trial: bool,
    /// How the outcome is written
    #[arg(long, value_enum, default_value_t = SummaryFormat::Human)]
    pub format: SummaryFormat,
}

/// `scenelang import`
#[derive(ClapArgs, Debug)]
pub struct Import {
    /// What `synth` or `export` wrote, edited or not: `room.glb`, `room.usda`, or the folder of a Unity project; or a house or a
    /// layout of AI2-THOR, LayoutVLM or SceneEval: `house.json`
    #[arg(value_name = "FILE | PROJECT")]
    pub scene: PathBuf,
    /// What is known of a file of another system
    #[command(flatten)]
    pub beside: Beside,
    /// The folder to write to
    #[arg(short, long, value_name = "FOLDER")]
    pub output: PathBuf,
    /// Replace files that scenelang did not write, or that were edited since
    #[arg(long)]
    pub force: bool,
}

/// What `export` and `synth` do where they would write over an exported scene that was edited since.
#[derive(ClapArgs, Debug, Clone, Copy, Default)]
pub struct Edits {
    /// Go on from the exported scene (GLB, USD, Unity project) as it stands there now, with what was edited in it
    #[arg(long, conflicts_with = "overwrite")]
    pub take: bool,
    /// Write over exported scenes that were edited, and lose what was changed in them
    #[arg(long)]
    pub overwrite: bool,
}

/// Which formats `export` and `synth` write.
#[derive(ClapArgs, Debug, Clone, Default)]
pub struct Formats {
    /// Only these formats: unity, glb, plan, picture, preview, which are the usual ones, and mjcf, usd, usdz, sdf, obj;
    /// separated by commas
    #[arg(long, value_name = "FORMATS", value_delimiter = ',', value_parser = crate::formats::name)]
    pub only: Vec<String>,
    /// All formats, not only the usual ones
    #[arg(long, conflicts_with = "only")]
    pub all_formats: bool,
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
    /// A code such as E0201, or a word of the language such as near, gap or surface
    #[arg(value_name = "WORD")]
    pub word: String,
}

/// `scenelang categories`
#[derive(ClapArgs, Debug)]
pub struct Categories {
    /// Only those with this in their name
    pub word: Option<String>,
    /// How they are written
    #[arg(long, value_enum, default_value_t = Plain::Text)]
    pub format: Plain,
}

/// `scenelang syntax`, `scenelang hir`, `scenelang constraints`
#[derive(ClapArgs, Debug)]
pub struct Inspect {
    /// The program; `-` reads standard input
    #[arg(value_name = "FILE.scene")]
    pub file: PathBuf,
    /// How it is written
    #[arg(long, value_enum, default_value_t = Plain::Text)]
    pub format: Plain,
}

/// `--format` of the commands that show what becomes of a program
#[derive(ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
pub enum Plain {
    /// For people
    Text,
    /// A JSON object on one line
    Json,
}

/// `scenelang diff`
#[derive(ClapArgs, Debug)]
pub struct Diff {
    /// The first layout; a GLB file or Unity project that `synth` wrote will do
    #[arg(value_name = "A")]
    pub before: PathBuf,
    /// The second layout
    #[arg(value_name = "B")]
    pub after: PathBuf,
    /// How the differences are written
    #[arg(long, value_enum, default_value_t = SummaryFormat::Human)]
    pub format: SummaryFormat,
    /// Margins that differ by no more than this are not listed (metres or degrees)
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
    /// The layout whose verdict is told [default: the one beside the program, if there is one]
    #[arg(value_name = "FILE.layout.json")]
    pub layout: Option<PathBuf>,
    /// Where each line begins
    #[arg(long, value_enum, default_value_t = By::Requirement)]
    pub by: By,
    /// How the trace is written
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
    /// A program, judged by the layout beside it if there is one; a layout, a GLB or USD file or a Unity project
    #[arg(value_name = "SCENE")]
    pub scene: PathBuf,
    /// The object, `chair[2]`, or all elements of an array, `chair`; without it, a table of all objects
    #[arg(long, value_name = "NAME")]
    pub object: Option<String>,
    /// How the answer is written
    #[arg(long, value_enum, default_value_t = SummaryFormat::Human)]
    pub format: SummaryFormat,
    /// How to judge
    #[command(flatten)]
    pub judging: Judging,
}

/// `scenelang lsp`
#[derive(ClapArgs, Debug)]
pub struct Lsp {
    /// Write the session down, a message a line
    #[arg(long, value_name = "FILE", conflicts_with = "replay")]
    pub record: Option<PathBuf>,
    /// Serve the client of a recorded session instead of standard input
    #[arg(long, value_name = "FILE")]
    pub replay: Option<PathBuf>,
    /// What editors pass; the server speaks over standard input and output in any case
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
    if (0.001..=1e6).contains(&seconds) { Ok(seconds) } else { Err("it is a number of seconds above 0".to_owned()) }
}

fn schema_names() -> clap::builder::PossibleValuesParser {
    scenelang_verify::schemas::ALL.iter().map(|(name, _)| *name).collect::<Vec<_>>().into()
}
