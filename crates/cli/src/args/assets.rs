//! Options of `scenelang assets`.

use super::Plain;
use clap::{Args as ClapArgs, Subcommand, ValueEnum};
use std::path::PathBuf;

/// `scenelang assets`
#[derive(Subcommand, Debug)]
pub enum Assets {
    /// Say what the furniture library draws for some words, and which models of a folder fit them
    Search(AssetsSearch),
    /// List the models of a folder
    List(AssetsList),
    /// Say what is wrong with the models of a folder
    Check(AssetsCheck),
    /// Bring the models of a folder to metres, base and front, and write them with their cards as a catalogue
    Import(AssetsImport),
    /// Write a page with every family of the furniture library, in three sizes, closed and open
    Gallery(AssetsGallery),
}

/// `scenelang assets search`
#[derive(ClapArgs, Debug)]
pub struct AssetsSearch {
    /// What is looked for: "oak dining table"
    pub words: String,
    /// The size that is wanted, in metres [default: the usual one]
    #[arg(long, value_name = "WxHxD", value_parser = crate::assets::size)]
    pub size: Option<[f64; 3]>,
    /// A folder of GLB and OBJ files, or one of objathor
    #[arg(long = "in", value_name = "FOLDER")]
    pub folder: Option<PathBuf>,
    /// How many models are shown
    #[arg(long, value_name = "N", default_value_t = 5, value_parser = clap::value_parser!(u16).range(1..))]
    pub most: u16,
    /// How they are written
    #[arg(long, value_enum, default_value_t = Plain::Text)]
    pub format: Plain,
}

/// `scenelang assets list`
#[derive(ClapArgs, Debug)]
pub struct AssetsList {
    /// A folder of GLB and OBJ files, or one of objathor
    #[arg(value_name = "FOLDER")]
    pub folder: PathBuf,
    /// How they are written
    #[arg(long, value_enum, default_value_t = Plain::Text)]
    pub format: Plain,
}

/// `scenelang assets check`
#[derive(ClapArgs, Debug)]
pub struct AssetsCheck {
    /// A folder of GLB and OBJ files, or one of objathor
    #[arg(value_name = "FOLDER")]
    pub folder: PathBuf,
    /// How the report is written; with json, one report per line and model
    #[arg(long, value_enum, default_value_t = AssetsFormat::Human)]
    pub format: AssetsFormat,
}

/// `scenelang assets import`
#[derive(ClapArgs, Debug)]
pub struct AssetsImport {
    /// A folder of GLB and OBJ files, or one of objathor
    #[arg(value_name = "FOLDER")]
    pub folder: PathBuf,
    /// The folder to write to
    #[arg(short, long, value_name = "CATALOGUE")]
    pub output: PathBuf,
    /// Replace files that scenelang did not write, or that were edited since
    #[arg(long)]
    pub force: bool,
    /// How the report is written
    #[arg(long, value_enum, default_value_t = Plain::Text)]
    pub format: Plain,
}

/// `scenelang assets gallery`
#[derive(ClapArgs, Debug)]
pub struct AssetsGallery {
    /// Only these families [default: all]
    #[arg(value_name = "FAMILY")]
    pub families: Vec<String>,
    /// The page to write
    #[arg(short, long, value_name = "FILE.html", default_value = "gallery.html")]
    pub output: PathBuf,
    /// Replace a file that is there already
    #[arg(long)]
    pub force: bool,
}

/// `--format` of `scenelang assets check`
#[derive(ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
pub enum AssetsFormat {
    /// For people
    Human,
    /// One JSON report per line
    Json,
    /// SARIF 2.1.0, for code scanning
    Sarif,
}

/// Where furniture comes from, for `solve` and `synth`. What is not given here comes from `scenelang.toml`.
#[derive(ClapArgs, Debug, Clone, Default)]
pub struct Furniture {
    /// A folder of your own models, which is asked before the furniture library; may be given more than once
    #[arg(long, value_name = "FOLDER")]
    pub assets: Vec<PathBuf>,
    /// Who makes models of what no folder has: meshy, tripo, hunyuan, `hunyuan:URL`, `command:PROGRAM`; `none` [default: the
    /// one that your own config.toml names, else none]
    #[arg(long, value_name = "GENERATOR")]
    pub generator: Option<String>,
    /// The most models that are made in a run [default: 20]
    #[arg(long, value_name = "N")]
    pub max_models: Option<u64>,
}
