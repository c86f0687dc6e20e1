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
