//! How files are judged: the nearest `scenelang.toml` above them, and the options that take precedence over it.

use crate::args::{Geometry, Judging};
use scenelang_base::{Code, Diagnostic, SourceFile, SourceMap, codes};
use scenelang_lang::sources::{Loader, plain};
use scenelang_layout::file::decode;
use scenelang_verify::settings::{FILE, Settings, measure as in_range, read, unknown};
use scenelang_verify::{Options, Tolerances};
use std::io::ErrorKind;
use std::path::{Path, PathBuf};

/// Settings that cannot be used, and why; places refer to `sources`.
pub struct Refused {
    pub sources: SourceMap,
    pub diagnostics: Vec<Diagnostic>,
}

/// The verifier's options for a file or folder, and the warnings that are not to be reported.
///
/// # Errors
/// The settings file cannot be read or has errors.
pub fn options(judging: &Judging, path: &Path, loader: &dyn Loader) -> Result<(Options, Vec<Code>), Refused> {
    all(judging, path, loader).map(|(options, settings)| (options, settings.allow))
}

/// The verifier's options for a file or folder, and the settings as they are.
///
/// # Errors
/// The settings file cannot be read or has errors.
pub fn all(judging: &Judging, path: &Path, loader: &dyn Loader) -> Result<(Options, Settings), Refused> {
    let mut options = Options::default();
    let settings = above(path, loader)?;
    settings.apply(&mut options);
    given(judging).apply(&mut options);
    Ok((options, settings))
}

/// What the command line says.
fn given(judging: &Judging) -> Settings {
    Settings {
        physics: (judging.physics || judging.no_physics).then_some(judging.physics),
        geometry: judging.geometry.map(|geometry| match geometry {
            Geometry::Parts => scenelang_layout::Geometry::Parts,
            Geometry::Box => scenelang_layout::Geometry::Box,
        }),
        eta: judging.eta,
        tolerances: judging.tolerances.clone(),
        ..Settings::default()
    }
}

/// The settings file in the folder of `path` or the nearest one above.
fn above(path: &Path, loader: &dyn Loader) -> Result<Settings, Refused> {
    let whole = std::path::absolute(path).unwrap_or_else(|_| path.to_path_buf());
    for folder in whole.ancestors().skip(1) {
        let file = folder.join(FILE);
        let name = shown(&file).display().to_string();
        let refused = |d: Diagnostic| Refused { sources: SourceMap::new(), diagnostics: vec![d] };
        let text = match loader.load(&file) {
            Ok(bytes) => decode(bytes).map_err(|d| refused(*d))?,
            Err(e) if matches!(e.kind(), ErrorKind::NotFound | ErrorKind::NotADirectory) => continue,
            Err(e) => {
                let say = format!("cannot read {name}: {}", plain(&e));
                return Err(refused(Diagnostic::without_place(codes::E0001, say)));
            }
        };
        let mut sources = SourceMap::new();
        let id = sources.add(SourceFile::new(name, &file, text));
        return read(sources.get(id).text(), id).map_err(|diagnostics| Refused { sources, diagnostics });
    }
    Ok(Settings::default())
}

/// A path as seen from where we are, if it is below.
fn shown(path: &Path) -> PathBuf {
    let here = std::env::current_dir().unwrap_or_default();
    path.strip_prefix(here).unwrap_or(path).to_path_buf()
}

/// A number of metres or degrees, for an option.
pub fn measure(text: &str) -> Result<f64, String> {
    in_range(text.parse().unwrap_or(f64::NAN))
}

/// `NAME=VALUE`, for an option.
pub fn tolerance(text: &str) -> Result<(String, f64), String> {
    let (name, value) = text.split_once('=').ok_or("a tolerance is written NAME=VALUE")?;
    if !Tolerances::NAMES.contains(&name) {
        return Err(unknown("tolerance", name, &Tolerances::NAMES));
    }
    measure(value).map(|value| (name.to_owned(), value)).map_err(|why| format!("`{name}` {why}"))
}
