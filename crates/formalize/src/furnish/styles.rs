//! Styles that a request names for a room, from `data/styles.txt`: what they make of walls, floor, wood and colours.

use std::collections::HashMap;
use std::sync::OnceLock;

/// Finishes that go together.
#[derive(Clone, Debug, Default)]
pub struct Style {
    /// "art deco".
    pub name: &'static str,
    /// What else it is called.
    pub also: Vec<&'static str>,
    /// Places whose name means it: "castle".
    pub rooms: Vec<&'static str>,
    /// Material and colour; empty: what the other says.
    pub walls: (&'static str, &'static str),
    pub floor: (&'static str, &'static str),
    /// What wooden furniture is made of.
    pub wood: &'static str,
    /// Colours of textiles and of what else stands out, in turn.
    pub colors: Vec<&'static str>,
}

/// All styles, in the order of the table.
pub fn all() -> &'static [Style] {
    static STYLES: OnceLock<Vec<Style>> = OnceLock::new();
    STYLES.get_or_init(|| parse(include_str!("../../data/styles.txt")))
}

/// The style that is called so: "art deco", "Art-Deco".
pub fn named(name: &str) -> Option<&'static Style> {
    static NAMES: OnceLock<HashMap<String, &'static Style>> = OnceLock::new();
    let names = NAMES.get_or_init(|| {
        all()
            .iter()
            .flat_map(|style| style.also.iter().chain([&style.name]).map(move |name| (plain(name), style)))
            .collect()
    });
    names.get(&plain(name)).copied()
}

/// The style that is meant by the name of a place: "castle dungeon".
pub fn of_place(place: &str) -> Option<&'static Style> {
    let place = format!(" {} ", plain(place));
    all().iter().find(|style| style.rooms.iter().any(|name| place.contains(&format!(" {} ", plain(name)))))
}

/// The most words that a style's name has.
pub fn longest() -> usize {
    static LONGEST: OnceLock<usize> = OnceLock::new();
    let words = |style: &'static Style| style.also.iter().chain([&style.name]).map(|name| name.split(' ').count());
    *LONGEST.get_or_init(|| all().iter().flat_map(words).max().unwrap_or(1))
}

/// A name without hyphens and capitals.
fn plain(name: &str) -> String {
    name.to_lowercase().replace('-', " ")
}

fn parse(text: &'static str) -> Vec<Style> {
    let mut out: Vec<Style> = Vec::new();
    for line in text.lines().map(str::trim).filter(|line| !line.is_empty() && !line.starts_with('#')) {
        if let Some(name) = line.strip_prefix('[').and_then(|rest| rest.strip_suffix(']')) {
            out.push(Style { name, ..Style::default() });
            continue;
        }
        let (Some(style), Some((key, value))) = (out.last_mut(), line.split_once(": ")) else { continue };
        let list = || value.split(',').map(str::trim).collect::<Vec<_>>();
        match (key, &list()[..]) {
            ("also", names) => style.also = names.to_vec(),
            ("rooms", names) => style.rooms = names.to_vec(),
            ("colors", colors) => style.colors = colors.to_vec(),
            ("wood", [wood]) => style.wood = wood,
            ("walls", [material, color]) => style.walls = (material, color),
            ("walls", [one]) if crate::colors::known(one).is_some() => style.walls = ("", one),
            ("walls", [one]) => style.walls = (one, ""),
            ("floor", [material, color]) => style.floor = (material, color),
            ("floor", [material]) => style.floor = (material, ""),
            _ => {}
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::read::lexicon::get;
    use std::collections::HashSet;

    #[test]
    fn every_style_is_whole_and_no_name_stands_for_two() {
        let mut names = HashSet::new();
        for style in all() {
            for name in style.also.iter().chain([&style.name]) {
                assert!(names.insert(plain(name)), "{name}");
            }
            assert!(style.walls != ("", "") && !style.floor.0.is_empty() && style.colors.len() >= 3, "{style:?}");
            let colors = style.colors.iter().chain([&style.walls.1, &style.floor.1]).filter(|color| !color.is_empty());
            for color in colors {
                assert!(crate::colors::known(color).is_some(), "{}: {color}", style.name);
            }
            for material in [style.walls.0, style.floor.0, style.wood].into_iter().filter(|name| !name.is_empty()) {
                assert!(get().is_look(material), "{}: {material}", style.name);
            }
        }
    }
}
