//! What there is to judge: the files named, and those below the folders named.

use scenelang_export::embedded::{Carrier, carrier};
use std::path::{Path, PathBuf};

/// Something to judge.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum JudgeTarget {
    /// A program or a layout.
    File(PathBuf),
    /// A GLB file, a USD file or a Unity project.
    Carrier(PathBuf, Carrier),
    /// A folder without anything to judge in it.
    Empty(PathBuf),
}

impl JudgeTarget {
    /// What it is called in messages.
    pub fn path(&self) -> &Path {
        match self {
            Self::File(path) | Self::Carrier(path, _) | Self::Empty(path) => path,
        }
    }
}

/// The targets in the order named; those of a folder in the order of their names.
pub fn find(paths: &[PathBuf]) -> Vec<JudgeTarget> {
    paths.iter().flat_map(|path| of_one(path)).collect()
}

fn of_one(path: &Path) -> Vec<JudgeTarget> {
    if let Some(kind) = carrier(path) {
        return vec![JudgeTarget::Carrier(path.to_path_buf(), kind)];
    }
    if !path.is_dir() {
        return vec![JudgeTarget::File(path.to_path_buf())];
    }
    let mut files = Vec::new();
    below(path, &mut files);
    if files.is_empty() { vec![JudgeTarget::Empty(path.to_path_buf())] } else { files }
}

/// Programs and layouts below a folder. What is hidden, made by build tools, or a Unity project is passed over; links to
/// folders are not followed, since they may lead in circles.
fn below(folder: &Path, files: &mut Vec<JudgeTarget>) {
    let Ok(entries) = std::fs::read_dir(folder) else { return };
    let mut entries: Vec<_> = entries.flatten().collect();
    entries.sort_by_key(std::fs::DirEntry::file_name);
    for entry in entries {
        let name = entry.file_name().to_string_lossy().into_owned();
        if name.starts_with('.') {
            continue;
        }
        // `./room.scene` would look odd in a report.
        let path = if folder == Path::new(".") { PathBuf::from(&name) } else { entry.path() };
        if entry.file_type().is_ok_and(|kind| kind.is_dir()) {
            if name != "target" && name != "node_modules" && carrier(&path).is_none() {
                below(&path, files);
            }
        } else if name.ends_with(".scene") || name.ends_with(".layout.json") {
            files.push(JudgeTarget::File(path));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn folders_are_searched_in_order_but_not_everywhere() {
        let folder = tempfile::tempdir().unwrap();
        for file in [
            "b.scene",
            "a/z.layout.json",
            "a/other.json",
            "a/deep/er/x.scene",
            ".git/h.scene",
            "target/t.scene",
            "node_modules/n.scene",
            "unity/Assets/u.scene",
            "unity/ProjectSettings/p.txt",
            "empty/readme.md",
        ] {
            let path = folder.path().join(file);
            std::fs::create_dir_all(path.parent().unwrap()).unwrap();
            std::fs::write(path, "").unwrap();
        }
        let found = find(&[folder.path().to_path_buf()]);
        let names: Vec<_> = found.iter().map(|t| t.path().strip_prefix(folder.path()).unwrap().to_owned()).collect();
        assert_eq!(names, ["a/deep/er/x.scene", "a/z.layout.json", "b.scene"].map(PathBuf::from));
        let empty = folder.path().join("empty");
        assert_eq!(find(std::slice::from_ref(&empty)), [JudgeTarget::Empty(empty)]);
        let unity = folder.path().join("unity");
        assert_eq!(find(std::slice::from_ref(&unity)), [JudgeTarget::Carrier(unity, Carrier::Unity)]);
    }
}
