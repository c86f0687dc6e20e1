//! What an exporter is, the list of them, and the one function that writes their files.

use crate::loss::Lost;
use crate::{Scene, Shows, glb, mjcf, obj, picture, plan, preview, report, sdf, unity, usd};
use scenelang_base::door::Door;
use std::fmt;
use std::path::{Path, PathBuf};

/// A file to be written.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct OutFile {
    /// Relative to the output folder, `/` between the parts.
    pub path: PathBuf,
    /// Its content.
    pub bytes: Vec<u8>,
}

impl OutFile {
    pub fn new(path: impl Into<PathBuf>, bytes: impl Into<Vec<u8>>) -> Self {
        Self { path: path.into(), bytes: bytes.into() }
    }
}

/// Writes a scene in one format. The same scene gives the same bytes.
pub trait Exporter: fmt::Debug {
    /// Its name on the command line: `unity`.
    fn name(&self) -> &'static str;
    /// Its files.
    ///
    /// # Errors
    /// The scene has something that the format cannot say.
    fn files(&self, scene: &Scene) -> Result<Vec<OutFile>, ExportError>;
    /// What its files in a folder are known by, if one exporter can write several sets beside each other.
    fn key(&self) -> String {
        self.name().to_owned()
    }
    /// Which parts of the scene its files show: nothing else changes a byte of them.
    fn shows(&self) -> Shows {
        Shows::All
    }
    /// What of the scene is not in them.
    fn lost(&self, scene: &Scene) -> Vec<Lost> {
        let _ = scene;
        Vec::new()
    }
}

/// Why nothing, or not everything, was written.
#[derive(Debug)]
pub enum ExportError {
    /// The format cannot hold this scene; why.
    Format(&'static str, String),
    /// The file system refused; the message names the path.
    Write(std::io::Error),
}

impl fmt::Display for ExportError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Format(exporter, why) => write!(f, "{exporter}: {why}"),
            Self::Write(error) => error.fmt(f),
        }
    }
}

impl std::error::Error for ExportError {}

/// The exporters that run unless others are asked for, with their usual options, in the order in which they run.
pub fn exporters() -> Vec<Box<dyn Exporter>> {
    vec![
        Box::new(unity::Unity::default()),
        Box::new(glb::Glb),
        Box::new(plan::Plan),
        Box::new(picture::Picture::default()),
        Box::new(preview::Preview),
    ]
}

/// All exporters: the usual ones, then those that run only when they are asked for.
pub fn all_exporters() -> Vec<Box<dyn Exporter>> {
    let further: [Box<dyn Exporter>; 6] = [
        Box::new(mjcf::Mjcf),
        Box::new(usd::Usd),
        Box::new(usd::Usdz),
        Box::new(sdf::Sdf),
        Box::new(obj::Obj),
        Box::new(report::Report),
    ];
    exporters().into_iter().chain(further).collect()
}

/// Writes what some exporters make of a scene below `dir`, and says which files. Nothing is written unless all
/// exporters succeed; each file is written whole or not at all.
///
/// # Errors
/// The first exporter that fails, or the first file that cannot be written.
pub fn write_all(scene: &Scene, dir: &Path, exporters: &[Box<dyn Exporter>]) -> Result<Vec<PathBuf>, ExportError> {
    let mut files = Vec::new();
    for exporter in exporters {
        files.extend(exporter.files(scene)?);
    }
    let door = Door::within(dir);
    let mut written = Vec::with_capacity(files.len());
    for file in files {
        let path = dir.join(&file.path);
        door.write(&path, &file.bytes).map_err(ExportError::Write)?;
        written.push(path);
    }
    Ok(written)
}
