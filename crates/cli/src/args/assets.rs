//! Options of `scenelang assets`.

use super::Plain;
use clap::{Args as ClapArgs, Subcommand, ValueEnum};
use std::path::PathBuf;

/// `scenelang assets`
#[derive(Subcommand, Debug)]
pub enum Assets {
    /// Show what the furniture library draws for a description, and which models in a folder match it
    Search(AssetsSearch),
    /// List the models in a folder
    List(AssetsList),
    /// Check the models in a folder
    Check(AssetsCheck),
    /// Normalise the unit, base and front of the models in a folder, and write them with their cards as a catalogue
    Import(AssetsImport),
    /// Print the search queries of a program in the published form, as input for computing features
    Queries(AssetsQueries),
    /// Write a web page that shows every family of the furniture library in three sizes, closed and open
    Gallery(AssetsGallery),
}

/// `scenelang assets search`
#[derive(ClapArgs, Debug)]
pub struct AssetsSearch {
    /// The description: "oak dining table"
    pub words: String,
    /// The requested size, in metres [default: the usual size]
    #[arg(long, value_name = "WxHxD", value_parser = crate::assets::size)]
    pub size: Option<[f64; 3]>,
    /// A folder of GLB and OBJ files, or an objathor folder
    #[arg(long = "in", value_name = "FOLDER")]
    pub folder: Option<PathBuf>,
    /// How many models to show
    #[arg(long, value_name = "N", default_value_t = 5, value_parser = clap::value_parser!(u16).range(1..))]
    pub most: u16,
    /// The output format
    #[arg(long, value_enum, default_value_t = Plain::Text)]
    pub format: Plain,
}

/// `scenelang assets list`
#[derive(ClapArgs, Debug)]
pub struct AssetsList {
    /// A folder of GLB and OBJ files, or an objathor folder
    #[arg(value_name = "FOLDER")]
    pub folder: PathBuf,
    /// The output format
    #[arg(long, value_enum, default_value_t = Plain::Text)]
    pub format: Plain,
}

/// `scenelang assets check`
#[derive(ClapArgs, Debug)]
pub struct AssetsCheck {
    /// A folder of GLB and OBJ files, or an objathor folder
    #[arg(value_name = "FOLDER")]
    pub folder: PathBuf,
    /// The output format; with json, one report per line and model
    #[arg(long, value_enum, default_value_t = AssetsFormat::Human)]
    pub format: AssetsFormat,
}

/// `scenelang assets import`
#[derive(ClapArgs, Debug)]
pub struct AssetsImport {
    /// A folder of GLB and OBJ files, or an objathor folder
    #[arg(value_name = "FOLDER")]
    pub folder: PathBuf,
    /// The folder to write to
    #[arg(short, long, value_name = "CATALOGUE")]
    pub output: PathBuf,
    /// Overwrite files that scenelang did not write or that were edited
    #[arg(long)]
    pub force: bool,
    /// The output format
    #[arg(long, value_enum, default_value_t = Plain::Text)]
    pub format: Plain,
}

/// `scenelang assets queries`
#[derive(ClapArgs, Debug)]
pub struct AssetsQueries {
    /// The programs
    #[arg(value_name = "FILE.scene", required = true)]
    pub files: Vec<PathBuf>,
    /// The output format; json gives the file `queries.json` for features
    #[arg(long, value_enum, default_value_t = Plain::Text)]
    pub format: Plain,
}

/// `scenelang assets gallery`
#[derive(ClapArgs, Debug)]
pub struct AssetsGallery {
    /// Show only these families [default: all]
    #[arg(value_name = "FAMILY")]
    pub families: Vec<String>,
    /// The page to write
    #[arg(short, long, value_name = "FILE.html", default_value = "gallery.html")]
    pub output: PathBuf,
    /// Overwrite an existing file
    #[arg(long)]
    pub force: bool,
}

/// `--format` of `scenelang assets check`
#[derive(ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
pub enum AssetsFormat {
    /// Human-readable text
    Human,
    /// One JSON report per line
    Json,
    /// SARIF 2.1.0, for code scanning
    Sarif,
}

/// Where furniture comes from, for `solve` and `synth`. What is not given here comes from `scenelang.toml`.
#[derive(ClapArgs, Debug, Clone, Default)]
pub struct Furniture {
    /// A folder of your own models, which takes precedence over the furniture library; may be given several times
    #[arg(long, value_name = "FOLDER")]
    pub assets: Vec<PathBuf>,
    /// The generator for models that are not found in any --assets folder: meshy, tripo, hunyuan, `hunyuan:URL`, `gradio:URL/FUNCTION`, `command:PROGRAM` or `none`
    /// [default: the one in your own config.toml, or none]
    #[arg(long, value_name = "GENERATOR")]
    pub generator: Option<String>,
    /// The maximum number of models to generate in one run [default: 20]
    #[arg(long, value_name = "N")]
    pub max_models: Option<u64>,
}
