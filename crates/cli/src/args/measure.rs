//! Options of the commands that measure: `scenelang bench` and `scenelang eval`.

use super::{ModelOptions, Plain, SummaryFormat, seconds};
use clap::{Args as ClapArgs, Subcommand};
use std::path::PathBuf;

/// `scenelang bench`
#[derive(Subcommand, Debug)]
pub enum Bench {
    /// Solve problems and print a table: share solved, constraints satisfied, time to the first complete solution
    Solve(BenchSolve),
}

/// `scenelang bench solve`
#[derive(ClapArgs, Debug)]
pub struct BenchSolve {
    /// Programs, or folders that contain programs
    #[arg(required = true, value_name = "FILE | FOLDER")]
    pub paths: Vec<PathBuf>,
    /// Solve each problem with this many seeds: 0, 1, …
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = clap::value_parser!(u64).range(1..))]
    pub seeds: u64,
    /// How many problems to solve in parallel; with more than one, the times are less reliable
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = clap::value_parser!(u16).range(1..))]
    pub threads: u16,
    /// Stop a run after this time; by default, after the solver's own budget of work
    #[arg(long, value_name = "SECONDS", value_parser = seconds, allow_negative_numbers = true)]
    pub time: Option<f64>,
    /// The output format
    #[arg(long, value_enum, default_value_t = Plain::Text)]
    pub format: Plain,
    /// Also write the result to this file, as JSON
    #[arg(short, long, value_name = "FILE")]
    pub output: Option<PathBuf>,
    /// Overwrite files that scenelang did not write or that were edited
    #[arg(long)]
    pub force: bool,
    /// Write the layouts to this folder, for an independent checker: PROBLEM.sSEED.layout.json
    #[arg(long, value_name = "FOLDER")]
    pub layouts: Option<PathBuf>,
}

/// `scenelang eval`
#[derive(Subcommand, Debug)]
pub enum Eval {
    /// Read requests without a model, and compare the programs with the ground truth: objects, properties, relations, measures
    Requests(EvalRequests),
    /// Make programs and layouts for the requests of SceneEval-500, or use existing ones, and score them against its
    /// annotations
    Sceneeval(EvalSceneEval),
    /// Generate requests with ground truth from a grammar: a program, a layout, a long request and a one-sentence
    /// request for each scene
    Dataset(EvalDataset),
    /// Measure a suite: how much of its requests is understood, and what share of its relations holds after each
    /// iteration
    Run(EvalRun),
    /// Write a report on the results of a suite, with plots, next to the published figures
    Report(EvalReport),
}

/// `scenelang eval dataset`
#[derive(ClapArgs, Debug)]
pub struct EvalDataset {
    /// How many scenes
    #[arg(long, value_name = "N", default_value_t = 50, value_parser = clap::value_parser!(u64).range(1..=10_000))]
    pub scenes: u64,
    /// The random seed; the same seed gives the same dataset
    #[arg(long, value_name = "N", default_value_t = 7, value_parser = clap::value_parser!(u64).range(..1 << 53))]
    pub seed: u64,
    /// The output folder: dataset.jsonl, statistics.json, and the request, ground truth, program and layout of each
    /// scene
    #[arg(short, long, value_name = "FOLDER")]
    pub output: PathBuf,
    /// How many scenes to work on in parallel; the result does not depend on it [default: the number of cores]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..))]
    pub jobs: Option<u16>,
    /// Overwrite files that scenelang did not write or that were edited
    #[arg(long)]
    pub force: bool,
    /// The output format
    #[arg(long, value_enum, default_value_t = SummaryFormat::Human)]
    pub format: SummaryFormat,
}

/// `scenelang eval run`
#[derive(ClapArgs, Debug)]
pub struct EvalRun {
    /// The suite: a JSON file with its name, the number of scenes of the dataset, and the seed
    #[arg(long, value_name = "FILE")]
    pub suite: PathBuf,
    /// The output folder: a file for each scene, and figures.json; scenes that already have a result are not measured
    /// again
    #[arg(short, long, value_name = "FOLDER", default_value = "results")]
    pub output: PathBuf,
    /// Compute similarity from the vectors of a model instead of from letters; one JSON object per line: {"text": …,
    /// "vector": […]}
    #[arg(long, value_name = "FILE.jsonl")]
    pub embeddings: Option<PathBuf>,
    /// Only write the texts for which `--embeddings` needs vectors, one JSON object per line
    #[arg(long, value_name = "FILE.jsonl", conflicts_with = "embeddings")]
    pub texts: Option<PathBuf>,
    /// Also show the model a picture of each scene from above and ask how well it matches the request; the model must accept pictures
    #[arg(long)]
    pub pictures: bool,
    /// How many scenes to measure in parallel; the figures do not depend on it [default: the number of cores]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..))]
    pub jobs: Option<u16>,
    /// Overwrite files that scenelang did not write or that were edited
    #[arg(long)]
    pub force: bool,
    /// The output format
    #[arg(long, value_enum, default_value_t = SummaryFormat::Human)]
    pub format: SummaryFormat,
    /// Which model is asked directly for layouts
    #[command(flatten)]
    pub model: ModelOptions,
}

/// `scenelang eval report`
#[derive(ClapArgs, Debug)]
pub struct EvalReport {
    /// The output folder of `scenelang eval run`
    #[arg(value_name = "FOLDER", default_value = "results")]
    pub results: PathBuf,
    /// Write a Markdown file, and the plots to images/ beside it; without this option and --html, the text is printed
    #[arg(short, long, value_name = "FILE.md")]
    pub output: Option<PathBuf>,
    /// Write a single HTML page that contains the plots
    #[arg(long, value_name = "FILE.html")]
    pub html: Option<PathBuf>,
    /// Overwrite files that scenelang did not write or that were edited
    #[arg(long)]
    pub force: bool,
}

/// `scenelang eval requests`
#[derive(ClapArgs, Debug)]
pub struct EvalRequests {
    /// A folder with requests, NAME.txt, and their ground truth, NAME.expect.json
    #[arg(value_name = "FOLDER")]
    pub folder: PathBuf,
    /// Score existing programs, NAME.scene, instead of reading the requests
    #[arg(long, value_name = "FOLDER")]
    pub programs: Option<PathBuf>,
    /// Let the reader add the usual contents of rooms; they are not in the ground truth, so precision falls
    #[arg(long, conflicts_with = "programs")]
    pub expand: bool,
    /// Score the programs without trying to find layouts for them
    #[arg(long, conflicts_with = "programs")]
    pub untried: bool,
    /// Write the programs to this folder, as NAME.scene
    #[arg(short, long, value_name = "FOLDER", conflicts_with = "programs")]
    pub output: Option<PathBuf>,
    /// Overwrite files that scenelang did not write or that were edited
    #[arg(long)]
    pub force: bool,
    /// For this many requests, the worst first, show what was missed
    #[arg(long, value_name = "N", default_value_t = 3)]
    pub worst: usize,
    /// The output format
    #[arg(long, value_enum, default_value_t = SummaryFormat::Human)]
    pub format: SummaryFormat,
}

/// `scenelang eval sceneeval`
#[derive(ClapArgs, Debug)]
pub struct EvalSceneEval {
    /// The benchmark file: requests with counts, attributes and relations
    #[arg(long, value_name = "FILE.csv")]
    pub annotations: PathBuf,
    /// Use only requests with an even or an odd ID, or with these IDs, separated by commas
    #[arg(long, value_name = "even | odd | LIST", value_delimiter = ',')]
    pub ids: Vec<String>,
    /// Score existing layouts, ID.layout.json, instead of making new ones
    #[arg(long, value_name = "FOLDER")]
    pub layouts: Option<PathBuf>,
    /// The output folder: ID.scene, ID.layout.json, report.json, summary.csv
    #[arg(short, long, value_name = "FOLDER")]
    pub output: PathBuf,
    /// Keep programs and layouts from an earlier run, and make only the missing ones
    #[arg(long, conflicts_with = "layouts")]
    pub resume: bool,
    /// Overwrite files that scenelang did not write or that were edited
    #[arg(long)]
    pub force: bool,
    /// How many requests to work on in parallel; the result does not depend on it [default: the number of cores]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..))]
    pub jobs: Option<u16>,
    /// For this many requests, those with the most failures first, show what was missed
    #[arg(long, value_name = "N", default_value_t = 3)]
    pub worst: usize,
    /// The output format
    #[arg(long, value_enum, default_value_t = SummaryFormat::Human)]
    pub format: SummaryFormat,
    /// Which model is asked what names and words of relations mean, instead of the table
    #[command(flatten)]
    pub model: ModelOptions,
}
