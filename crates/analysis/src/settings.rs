//! The settings of a workspace: the file that counts, what it says, and what that changes.

use scenelang_base::door::Door;
use scenelang_base::{Code, Diagnostic, SourceFile, SourceMap};
use scenelang_lang::sources::{Loader, decode, unreadable};
use scenelang_verify::Options;
use scenelang_verify::report::model::JudgedWith;
use scenelang_verify::settings::{Settings, read};
use std::io::ErrorKind;
use std::path::{Path, PathBuf};

/// How files are judged, and what is not told of.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Judging {
    /// Tolerances, η, what a solid is, whether the physical rules apply.
    pub options: Options,
    /// Warnings that are not reported.
    pub allow: Vec<Code>,
    /// The settings file that makes it another than the usual one.
    pub with: Option<JudgedWith>,
}

/// The settings that count for a file.
#[derive(Debug, Default)]
pub struct FileSettings {
    /// Where they are, if there are any.
    pub file: Option<PathBuf>,
    /// Their text, for places.
    pub sources: SourceMap,
    /// What they say; nothing, where they have errors.
    pub settings: Settings,
    /// What is wrong with them. By settings with errors nothing is judged.
    pub diagnostics: Vec<Diagnostic>,
}

impl FileSettings {
    /// The nearest settings that count for the file of a door, read from `loader`; `called`: what a file is called in
    /// messages.
    pub fn of(door: &Door, loader: &dyn Loader, called: impl Fn(&Path) -> String) -> Self {
        for file in door.settings() {
            let name = called(file);
            let bytes = match loader.load(file) {
                Ok(bytes) => bytes,
                Err(e) if matches!(e.kind(), ErrorKind::NotFound | ErrorKind::NotADirectory) => continue,
                Err(e) => {
                    let diagnostics = vec![unreadable(&format!("read {name}"), &e)];
                    let mut sources = SourceMap::new();
                    sources.add(SourceFile::new(name, file, ""));
                    return Self { file: Some(file.clone()), sources, diagnostics, ..Self::default() };
                }
            };
            let mut sources = SourceMap::new();
            let (settings, diagnostics) = match decode(&name, file, bytes, &mut sources) {
                Err(refused) => (Settings::default(), vec![refused.1]),
                Ok(id) => match read(sources.get(id).text(), id) {
                    Ok(settings) => (settings, Vec::new()),
                    Err(found) => (Settings::default(), found),
                },
            };
            return Self { file: Some(file.clone()), sources, settings, diagnostics };
        }
        Self::default()
    }

    /// Whether they cannot be used. Then nothing is judged.
    pub fn is_broken(&self) -> bool {
        !self.diagnostics.is_empty()
    }

    /// How files are judged by them, where `given` (the options of a command) says nothing else.
    pub fn judging(&self, given: &Settings) -> Judging {
        let mut options = Options::default();
        self.settings.apply(&mut options);
        given.apply(&mut options);
        let changes = self.settings.changes(&options);
        let named = self.sources.iter().next().map(|(_, file)| file.name().to_owned());
        let with = named.filter(|_| !changes.is_empty()).map(|file| JudgedWith { file, changes });
        Judging { options, allow: self.settings.allow.clone(), with }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::fs;

    fn found(text: &[u8]) -> FileSettings {
        let folder = tempfile::tempdir().unwrap();
        fs::write(folder.path().join("scenelang.toml"), text).unwrap();
        let door = Door::of(&folder.path().join("room.scene"));
        FileSettings::of(&door, &door, |path| path.file_name().unwrap().to_string_lossy().into_owned())
    }

    #[test]
    fn what_differs_from_the_usual_is_named() {
        let with =
            |text: &str, given: &Settings| found(text.as_bytes()).judging(given).with.map(|w| w.changes.join(", "));
        let none = Settings::default();
        assert_eq!(with("physics = true\neta = 0.03", &none), None);
        assert_eq!(
            with("physics = false\neta = 0.1\n[tolerances]\nequal = 0.01\n[lints]\nallow = [\"W0203\"]", &none)
                .unwrap(),
            "physics off, eta 0.1, equal 0.01, W0203 silenced"
        );
        let given = Settings { physics: Some(true), ..Settings::default() };
        assert_eq!(with("physics = false", &given), None, "an option has the last word");
    }

    #[test]
    fn settings_that_cannot_be_read_are_broken() {
        assert!(found(b"physics = 1").is_broken());
        assert!(found(b"\xff\xfe").is_broken());
        assert!(!found(b"").is_broken());
    }
}
