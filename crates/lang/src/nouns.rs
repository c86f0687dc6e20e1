//! What is known of things by their names, from `std/nouns.txt`: usual size, what they stand on, whether they have a front,
//! how much room their use takes, how often rooms have them. For programs and for whoever writes them.

use std::sync::OnceLock;

/// What a thing stands on, or hangs from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stands {
    Floor,
    /// The floor, with its back at a wall.
    Back,
    Wall,
    Ceiling,
    /// The top of another thing.
    Top,
    /// A seat or a bed.
    Soft,
    /// The floor, under other things.
    Flat,
    /// The inside of another thing.
    Inside,
    /// An opening of a wall.
    Opening,
}

/// What is known of a noun.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Noun {
    /// In the singular, in small letters, with underscores between words.
    pub name: &'static str,
    /// Usual width, height and depth in metres.
    pub size: [f64; 3],
    pub stands: Stands,
    /// Whether one side is its front.
    pub front: bool,
    /// How many metres of floor before it are used.
    pub access: f64,
    /// 1: seldom in rooms; 2: in its kind of room; 3: in most rooms.
    pub often: u8,
}

/// All nouns, by name.
pub fn all() -> &'static [Noun] {
    static NOUNS: OnceLock<Vec<Noun>> = OnceLock::new();
    NOUNS.get_or_init(|| {
        let mut rows: Vec<Noun> = include_str!("../std/nouns.txt").lines().filter_map(row).collect();
        rows.sort_by_key(|noun| noun.name);
        rows
    })
}

/// The noun of this name, blanks or underscores between its words.
pub fn noun(name: &str) -> Option<&'static Noun> {
    let key = name.trim().to_lowercase().replace(' ', "_");
    let find = |key: &str| all().binary_search_by_key(&key, |noun| noun.name).ok().map(|i| &all()[i]);
    find(&key).or_else(|| find(key.strip_suffix('s')?)).or_else(|| find(key.strip_suffix("es")?))
}

/// The longest noun that ends a name: "oak dining table" is a dining table.
pub fn ending(name: &str) -> Option<&'static Noun> {
    let words: Vec<&str> = name.split([' ', '_']).filter(|word| !word.is_empty()).collect();
    (0..words.len()).find_map(|from| noun(&words[from..].join("_")))
}

fn row(line: &'static str) -> Option<Noun> {
    let mut fields = line.split('#').next()?.split_whitespace();
    let name = fields.next()?;
    let mut number = || fields.next()?.parse::<f64>().ok();
    let size = [number()?, number()?, number()?];
    let stands = match fields.next()? {
        "floor" => Stands::Floor,
        "back" => Stands::Back,
        "wall" => Stands::Wall,
        "ceiling" => Stands::Ceiling,
        "top" => Stands::Top,
        "soft" => Stands::Soft,
        "flat" => Stands::Flat,
        "inside" => Stands::Inside,
        "opening" => Stands::Opening,
        _ => return None,
    };
    let front = fields.next()? == "front";
    Some(Noun { name, size, stands, front, access: fields.next()?.parse().ok()?, often: fields.next()?.parse().ok()? })
}

/// A noun with "a" or "an" before it.
pub fn with_article(noun: &str) -> String {
    let vowel = noun.starts_with(['a', 'e', 'i', 'o', 'u', 'A', 'E', 'I', 'O']);
    let an = vowel && !["uni", "uti", "use", "one"].iter().any(|start| noun.starts_with(start));
    format!("{} {noun}", if an { "an" } else { "a" })
}

/// The plural of a noun of one or several words.
pub fn plural(noun: &str) -> String {
    let cut = |n: usize, ending: &str| format!("{}{ending}", &noun[..noun.len() - n]);
    let before = noun.chars().rev().nth(1).unwrap_or(' ');
    if noun.ends_with("shelf") {
        cut(1, "ves")
    } else if ["s", "x", "ch", "sh"].iter().any(|e| noun.ends_with(e)) {
        cut(0, "es")
    } else if noun.ends_with('y') && !"aeiou".contains(before) {
        cut(1, "ies")
    } else {
        cut(0, "s")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_row_is_read_once_and_sorted_in_its_block() {
        let text = include_str!("../std/nouns.txt");
        let mut before = "";
        for line in text.lines() {
            if line.is_empty() || line.starts_with('#') {
                before = "";
                continue;
            }
            let noun = row(line).unwrap_or_else(|| panic!("{line}"));
            assert!(noun.size.iter().all(|x| (0.001..=30.0).contains(x)), "{line}");
            assert!((1..=3).contains(&noun.often) && (0.0..=2.0).contains(&noun.access), "{line}");
            assert!(before < noun.name, "{before} before {line}");
            before = noun.name;
        }
        assert!(all().len() >= 1500, "{}", all().len());
        assert!(all().windows(2).all(|pair| pair[0].name != pair[1].name));
    }

    #[test]
    fn nouns_are_found_by_their_ends() {
        assert_eq!(noun("chairs"), noun("chair"));
        assert_eq!(ending("old oak dining table").map(|n| n.name), Some("dining_table"));
        assert!(noun("car").is_some_and(|n| n.size[2] > 3.0));
        assert_eq!(ending("quux"), None);
    }
}
