//! What of the box of a piece of furniture is solid whatever the piece looks like, as the table `std/solids.txt` says: it is
//! made from the assets that `solve` gives to furniture.

use crate::library::{usual_size, words};
use rustc_hash::FxHashMap;
use std::sync::OnceLock;

/// A box about the middle axis of a thing that is solid.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Solid {
    /// From which to which part of the height it reaches.
    pub heights: [f64; 2],
    /// What it has of the width and the depth.
    pub plan: Plan,
}

/// What of a width or a depth is solid.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Plan {
    /// All but so much at each side (metres).
    Edge(f64),
    /// A part of it, in the middle.
    Part(f64),
}

impl Plan {
    /// What is solid of an extent (metres).
    pub fn of(self, extent: f64) -> f64 {
        match self {
            Self::Edge(edge) => (extent - 2.0 * edge).max(0.0),
            Self::Part(part) => extent * part,
        }
    }
}

/// How far from the usual size width and depth, and the height, may be, by the word that begins a row.
const RANGES: [(&str, f64, f64); 4] = [("usual", 1.3, 1.3), ("wide", 2.0, 2.0), ("long", 5.0, 1.5), ("any", 8.0, 8.0)];
/// Words before a noun that say nothing about its shape.
pub const PLAIN: [&str; 16] = [
    "big", "black", "blue", "brown", "gray", "green", "grey", "large", "metal", "new", "oak", "old", "red", "small",
    "white", "wooden",
];

/// By category: for each range that has one, what is solid.
type Table = FxHashMap<&'static str, [Option<Solid>; 4]>;

fn table() -> &'static Table {
    static TABLE: OnceLock<Table> = OnceLock::new();
    TABLE.get_or_init(|| {
        let mut table = Table::default();
        let mut row = None;
        for line in include_str!("../std/solids.txt").lines().filter(|line| !line.starts_with('#')) {
            let nouns = match line.split_once(':') {
                Some((head, nouns)) => {
                    row = parsed(head);
                    nouns
                }
                None => line,
            };
            if let Some((range, solid)) = row {
                for noun in nouns.split(',').map(str::trim).filter(|noun| !noun.is_empty()) {
                    table.entry(noun).or_default()[range] = Some(solid);
                }
            }
        }
        table
    })
}

/// The head of a row: range, from, to, plan.
fn parsed(head: &str) -> Option<(usize, Solid)> {
    let words: Vec<&str> = head.split_whitespace().collect();
    let &[range, from, to, plan] = words.as_slice() else { return None };
    let range = RANGES.iter().position(|(name, ..)| *name == range)?;
    let plan = match plan.strip_suffix('%') {
        Some(percent) => Plan::Part(percent.parse::<f64>().ok()? / 100.0),
        None => Plan::Edge(plan.parse().ok()?),
    };
    Some((range, Solid { heights: [from.parse().ok()?, to.parse().ok()?], plan }))
}

/// What is solid of a thing of a category and a size (metres); nothing is known of most.
pub fn solid_of(category: &str, size: [f64; 3]) -> Option<Solid> {
    let words = words(category);
    let plain = words.iter().take_while(|word| PLAIN.contains(&word.as_str())).count();
    let noun = words[plain..].join(" ");
    let find = |noun: &str| Some((table().get(noun)?, usual_size(noun)?));
    let (rows, usual) =
        find(&noun).or_else(|| find(noun.strip_suffix('s')?)).or_else(|| find(noun.strip_suffix("es")?))?;
    let factors: Vec<f64> = std::iter::zip(size, usual).map(|(s, u)| (s / u).max(u / s) - 1e-9).collect();
    let fits = |(_, plan, height): &(&str, f64, f64)| factors[0].max(factors[2]) <= *plan && factors[1] <= *height;
    // What is said of a narrower range says more.
    RANGES.iter().zip(rows).filter(|(range, _)| fits(range)).find_map(|(_, solid)| *solid)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_solid_depends_on_the_kind_and_on_the_size() {
        let crate_ = solid_of("crate", [0.8, 0.8, 0.8]).unwrap();
        assert_eq!(crate_, Solid { heights: [0.0, 1.0], plan: Plan::Edge(0.0) });
        assert_eq!(solid_of("white wooden crates", [0.8, 0.8, 0.8]), Some(crate_));
        let table = solid_of("table", [1.4, 0.75, 0.8]).unwrap();
        assert!(table.heights[0] > 0.9, "only its top: {table:?}");
        let bed = |h: f64| solid_of("bed", [1.6, h, 2.0]).unwrap().heights;
        assert!(bed(0.95)[1] > bed(1.8)[1] && bed(0.95)[0] == 0.0);
        assert_eq!(solid_of("bed", [16.0, 0.9, 2.0]), None, "of such beds nobody has seen one");
        assert_eq!(solid_of("gizmo", [1.0; 3]), None);
    }

    #[test]
    fn every_row_is_read() {
        let heads = include_str!("../std/solids.txt").lines().filter(|l| !l.starts_with('#'));
        for head in heads.filter_map(|line| line.split_once(':')) {
            assert!(parsed(head.0).is_some(), "{}", head.0);
        }
        assert!(table().len() > 1000, "{}", table().len());
    }
}
