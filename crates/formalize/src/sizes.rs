//! How large things usually are, by their names: from a table of our own, else from that of the language.

use crate::brief::Group;
use crate::furnish::kinds;
use scenelang_lang::library::usual_size;
use scenelang_lang::nouns;

/// The usual height of a sill (metres).
pub const SILL: f64 = 0.9;
/// What nothing is known of.
const UNKNOWN: [f64; 3] = [0.5, 0.5, 0.5];

/// The usual size of a thing of this name.
pub fn usual(group: Group, words: &[String]) -> [f64; 3] {
    let name = words.join(" ");
    // "A velvet reading chair" is a reading chair.
    let stands = matches!(group, Group::Seat | Group::Table | Group::Storage | Group::Bed | Group::Floor);
    let known = (0..words.len().saturating_sub(1)).find_map(|from| nouns::noun(&words[from..].join(" ")));
    if let Some(noun) = known.filter(|noun| stands || noun.name == name.replace(' ', "_") && is_meant(&name)) {
        return noun.size;
    }
    if let Some(size) = own_size(words) {
        return size;
    }
    let size = usual_size(&name).unwrap_or(match group {
        Group::Seat => [0.5, 0.85, 0.5],
        Group::Table => [1.4, 0.8, 0.7],
        Group::Storage => [0.9, 1.6, 0.42],
        Group::Bed => [1.2, 0.6, 2.05],
        Group::Wall => [0.6, 0.5, 0.06],
        Group::Ceiling => [0.4, 0.4, 0.4],
        Group::Top => [0.25, 0.25, 0.25],
        Group::Screen => [1.2, 0.75, 0.12],
        Group::Flat => [1.6, 0.012, 1.1],
        Group::Soft => [0.45, 0.15, 0.4],
        Group::Drape => [1.4, 1.8, 0.1],
        Group::Door => [0.95, 2.08, 0.12],
        Group::Window => [1.2, 1.3, 0.12],
        Group::Floor => UNKNOWN,
    });
    match group {
        Group::Screen => [size[0], size[1], size[2].min(0.26)],
        // "espresso machine" is no machine tool.
        Group::Top => [size[0].min(0.6), size[1].min(0.6), size[2].min(0.5)],
        Group::Wall => [size[0], size[1].min(2.0), size[2].min(0.35)],
        _ => size,
    }
}

/// Whether some kind of room has a plain noun that stands for this one.
fn is_meant(name: &str) -> bool {
    kinds::all().iter().any(|kind| kind.means.iter().any(|(_, meant)| *meant == name))
}

/// What the language has no category for.
fn own_size(words: &[String]) -> Option<[f64; 3]> {
    let find = |key: &str| {
        include_str!("../data/sizes.txt").lines().find_map(|line| {
            let mut parts = line.split_whitespace();
            if parts.next() != Some(key) {
                return None;
            }
            let mut next = || parts.next().and_then(|n| n.parse().ok());
            Some([next()?, next()?, next()?])
        })
    };
    (0..words.len()).find_map(|skip| {
        find(&words[skip..].join("_"))
            .filter(|_| skip == 0 || usual_size(&words.join("_")).is_none() || skip + 1 < words.len())
    })
}
