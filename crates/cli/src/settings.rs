//! How files are judged: the settings of their workspace, and the options that take precedence over them.

use crate::args::{Geometry, Judging, Opens};
use scenelang_analysis::FileSettings;
use scenelang_base::door::Door;
use scenelang_base::{Diagnostic, SourceMap};
use scenelang_lang::sources::Loader;
use scenelang_verify::Tolerances;
use scenelang_verify::settings::{Settings, measure as in_range, unknown};
use std::path::{Path, PathBuf};

/// Settings that cannot be used, and why; places refer to `sources`.
pub struct Refused {
    pub sources: SourceMap,
    pub diagnostics: Vec<Diagnostic>,
}

pub fn find(door: &Door, loader: &dyn Loader) -> FileSettings {
    FileSettings::of(door, loader, |path| shown(path).display().to_string())
}

/// How the file of a door is judged, and its settings as they are.
///
/// # Errors
/// The settings file cannot be read or has errors.
pub fn all(judging: &Judging, door: &Door) -> Result<(scenelang_analysis::Judging, Settings), Refused> {
    let found = find(door, door);
    if found.is_broken() {
        return Err(Refused { sources: found.sources, diagnostics: found.diagnostics });
    }
    Ok((found.judging(&given(judging)), found.settings))
}

/// What the command line says.
pub fn given(judging: &Judging) -> Settings {
    Settings {
        physics: (judging.physics || judging.no_physics).then_some(judging.physics),
        geometry: judging.geometry.map(|geometry| match geometry {
            Geometry::Parts => scenelang_layout::Geometry::Parts,
            Geometry::Box => scenelang_layout::Geometry::Box,
        }),
        opens: judging.opens.map(|opens| match opens {
            Opens::All => scenelang_verify::Opens::All,
            Opens::Doors => scenelang_verify::Opens::Doors,
            Opens::None => scenelang_verify::Opens::None,
        }),
        eta: judging.eta,
        tolerances: judging.tolerances.clone(),
        ..Settings::default()
    }
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
