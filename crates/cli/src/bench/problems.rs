//! Which problems there are, and which family each belongs to.

use std::path::{Path, PathBuf};

/// A problem file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Case {
    /// The program.
    pub path: PathBuf,
    /// Its name without the ending.
    pub name: String,
    /// The first words of the name, up to the first that has a digit: `free-yaw-n20-s3` is of `free-yaw`.
    pub family: String,
}

/// The programs that are named or lie below the folders that are, each folder in the order of its names.
///
/// # Errors
/// A sentence: something cannot be read.
pub fn below(paths: &[PathBuf]) -> Result<Vec<Case>, String> {
    let mut out = Vec::new();
    for path in paths {
        if path.is_dir() {
            collect(path, &mut out)?;
        } else {
            out.push(case(path));
        }
    }
    Ok(out)
}

fn collect(folder: &Path, out: &mut Vec<Case>) -> Result<(), String> {
    let failed =
        |e: std::io::Error| format!("cannot read {}: {}", folder.display(), scenelang_lang::sources::plain(&e));
    let entries = std::fs::read_dir(folder).map_err(failed)?;
    let mut paths = entries.map(|entry| entry.map(|e| e.path())).collect::<Result<Vec<_>, _>>().map_err(failed)?;
    paths.sort();
    for path in paths {
        if path.is_dir() {
            collect(&path, out)?;
        } else if path.extension().is_some_and(|e| e == "scene") {
            out.push(case(&path));
        }
    }
    Ok(())
}

fn case(path: &Path) -> Case {
    let name = path.file_stem().map_or_else(String::new, |stem| stem.to_string_lossy().into_owned());
    let words: Vec<&str> = name.split('-').take_while(|word| !word.contains(|c: char| c.is_ascii_digit())).collect();
    let family = if words.is_empty() { name.clone() } else { words.join("-") };
    Case { path: path.to_owned(), name, family }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_family_is_the_words_before_the_numbers() {
        for (file, family) in [
            ("a/free-yaw-n20-d30-s3.scene", "free-yaw"),
            ("rf-n10-d20-k1-s0.scene", "rf"),
            ("kitchen.scene", "kitchen"),
            ("3-chairs.scene", "3-chairs"),
        ] {
            assert_eq!(case(Path::new(file)).family, family, "{file}");
        }
    }

    #[test]
    fn folders_are_searched_in_order_and_other_files_are_left_alone() {
        let folder = tempfile::tempdir().unwrap();
        std::fs::create_dir(folder.path().join("b")).unwrap();
        for file in ["c.scene", "b/d.scene", "a.scene", "a.layout.json"] {
            std::fs::write(folder.path().join(file), "").unwrap();
        }
        let found = below(&[folder.path().to_owned()]).unwrap();
        let names: Vec<&str> = found.iter().map(|c| c.name.as_str()).collect();
        assert_eq!(names, ["a", "d", "c"]);
        assert!(below(&[folder.path().join("none")]).is_ok_and(|cases| cases.len() == 1), "said when it is opened");
    }
}
