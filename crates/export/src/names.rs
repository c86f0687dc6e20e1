//! Names from object names: of files, safe on every system, and of things in formats that know only plain identifiers.
//! Each once.

use std::collections::{BTreeMap, BTreeSet};

/// Hands out file stems.
#[derive(Debug, Default)]
pub(crate) struct Stems {
    taken: BTreeSet<String>,
}

impl Stems {
    /// A stem for a name: `chair[0]` becomes `chair_0`. Names that differ only by case, or only in letters that file
    /// systems mind, get numbers.
    pub fn take(&mut self, name: &str) -> String {
        let mut stem = String::new();
        for c in name.chars() {
            if c.is_ascii_alphanumeric() || c == '-' {
                stem.push(c);
            } else if !stem.ends_with('_') && c != ']' {
                stem.push('_');
            }
        }
        if reserved(&stem) || stem.is_empty() {
            stem.push('_');
        }
        let mut candidate = stem.clone();
        let mut n = 2;
        while !self.taken.insert(candidate.to_ascii_lowercase()) {
            candidate = format!("{stem}-{n}");
            n += 1;
        }
        candidate
    }
}

/// Hands out identifiers: ASCII letters, digits and single underscores, a letter first.
#[derive(Debug, Default)]
pub(crate) struct Identifiers {
    taken: BTreeSet<String>,
    /// The number to be tried next, by identifier.
    next: BTreeMap<String, usize>,
}

impl Identifiers {
    /// An identifier for a name: `chair[0]` becomes `chair_0`, `office/wall2` `office_wall2`. What would be the same for two
    /// names gets numbers, also where only the case differs.
    pub fn take(&mut self, name: &str) -> String {
        let mut out = String::new();
        for c in name.chars() {
            if c.is_ascii_alphanumeric() {
                out.push(c);
            } else if !out.is_empty() && !out.ends_with('_') {
                out.push('_');
            }
        }
        out.truncate(out.trim_end_matches('_').len());
        if !out.starts_with(|c: char| c.is_ascii_alphabetic()) {
            out.insert_str(0, "n_");
            out.truncate(out.trim_end_matches('_').len());
        }
        let next = self.next.entry(out.to_ascii_lowercase()).or_insert(2);
        let mut candidate = out.clone();
        while !self.taken.insert(candidate.to_ascii_lowercase()) {
            candidate = format!("{out}_{next}");
            *next += 1;
        }
        candidate
    }
}

/// Names that Windows keeps for devices.
fn reserved(stem: &str) -> bool {
    let lower = stem.to_ascii_lowercase();
    ["con", "prn", "aux", "nul"].contains(&lower.as_str())
        || (lower.len() == 4 && (lower.starts_with("com") || lower.starts_with("lpt")))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn stems_are_safe_and_unique_where_case_does_not_count() {
        let mut stems = Stems::default();
        let taken: Vec<String> =
            ["chair[0]", "chair[10]", "Chair[0]", "con", "lämp", "l_mp", "灯", "chair_0"].map(|n| stems.take(n)).into();
        assert_eq!(taken, ["chair_0", "chair_10", "Chair_0-2", "con_", "l_mp", "l_mp-2", "_", "chair_0-3"]);
    }

    #[test]
    fn identifiers_are_plain_and_unique() {
        let mut names = Identifiers::default();
        let taken: Vec<String> =
            ["chair[0]", "a/wall2", "Chair_0", "__model__", "3d", "灯", "", "chair_0_2", "l\"<x>\n"]
                .map(|n| names.take(n))
                .into();
        assert_eq!(taken, ["chair_0", "a_wall2", "Chair_0_2", "model", "n_3d", "n", "n_2", "chair_0_2_2", "l_x"]);
    }
}
