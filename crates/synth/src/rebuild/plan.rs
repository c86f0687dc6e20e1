//! Which formats are made again, and which files no longer belong.

use super::{Known, Manifest, State, why};
use scenelang_base::owned::sum_of;
use scenelang_export::{ExportError, Exporter, OutFile, Scene, parts};
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

/// So many files are named.
const NAMED: usize = 3;

/// What becomes of a format.
#[derive(Clone, Debug)]
pub struct Format {
    pub name: String,
    /// Why it is made again; empty: it is kept.
    pub why: Vec<String>,
    /// Its state afterwards.
    pub state: State,
}

/// What is to be written.
#[derive(Clone, Debug, Default)]
pub struct Planned {
    /// The formats, in order.
    pub formats: Vec<Format>,
    /// Files of those that are made again.
    pub files: Vec<OutFile>,
}

/// Makes the files of the formats that have to be made again. `anew`: all of them. `go_on` is asked before each one, by its
/// name; `None`: it said no.
///
/// # Errors
/// A format cannot hold the scene.
pub fn planned(
    scene: &Scene,
    (folder, known): (&Path, &Known),
    exporters: &[Box<dyn Exporter>],
    anew: Option<&str>,
    go_on: &mut dyn FnMut(&str) -> bool,
) -> Result<Option<Planned>, ExportError> {
    let mut out = Planned::default();
    for exporter in exporters {
        if !go_on(exporter.name()) {
            return Ok(None);
        }
        let mut inputs = parts(scene, exporter.shows());
        inputs.insert("options".into(), format!("{exporter:?}"));
        inputs.insert("scenelang".into(), env!("CARGO_PKG_VERSION").to_owned());
        let key = exporter.key();
        let states = known.formats.get(&key).map_or(&[][..], Vec::as_slice);
        let same = states.iter().find(|state| state.inputs == inputs);
        let why = match (anew, same) {
            (Some(why), _) => vec![why.to_owned()],
            (None, Some(state)) if state.is_there(folder) => {
                out.formats.push(Format { name: key, why: Vec::new(), state: state.clone() });
                continue;
            }
            (None, Some(state)) => touched(folder, state),
            (None, None) => match states.last() {
                None => vec!["it was not written before".to_owned()],
                Some(before) => why::of_format(&before.inputs, &inputs),
            },
        };
        let files = exporter.files(scene)?;
        let names = files.iter().map(|file| name(&file.path)).collect();
        let sum = sum_of(files.iter().map(|file| file.bytes.as_slice()));
        let state = State { inputs, files: names, sum, converged: false };
        out.formats.push(Format { name: key, why, state });
        out.files.extend(files);
    }
    Ok(Some(out))
}

/// What is said of files that are not as they were written.
fn touched(folder: &Path, state: &State) -> Vec<String> {
    let is_missing = |file: &&String| !folder.join(file.as_str()).is_file();
    let missing: Vec<&str> = state.files.iter().filter(is_missing).map(String::as_str).collect();
    vec![match missing.as_slice() {
        [] => "its files were changed since they were written".to_owned(),
        [one] => format!("{one} is missing"),
        some if some.len() <= NAMED => format!("{} are missing", some.join(", ")),
        many => format!("{} and {} more are missing", many[..NAMED].join(", "), many.len() - NAMED),
    }]
}

/// A path as the manifest has it.
fn name(path: &Path) -> String {
    path.components().map(|part| part.as_os_str().to_string_lossy()).collect::<Vec<_>>().join("/")
}

/// The names of files, as the manifest has them.
pub fn own_names(files: &[OutFile]) -> Vec<String> {
    files.iter().map(|file| name(&file.path)).collect()
}

impl Manifest {
    /// What is known of a scene after formats were planned, and the files that no longer belong to it.
    pub fn after(&self, stem: &str, now: Known, formats: &[Format]) -> (Known, Vec<PathBuf>) {
        let before = self.scene(stem);
        let mut after = Known { formats: before.formats.clone(), ..now };
        for format in formats {
            after.formats.insert(format.name.clone(), vec![format.state.clone()]);
        }
        let still: BTreeSet<&str> = after.files().chain(self.others(stem)).collect();
        let gone: BTreeSet<&str> = before.files().filter(|file| !still.contains(file)).collect();
        let gone = gone.into_iter().map(PathBuf::from).collect();
        (after, gone)
    }
}
