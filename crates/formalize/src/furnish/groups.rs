//! What goes with a thing, from `data/groups.txt`: chairs with a table, a lamp on a nightstand, books on a shelf.

use std::collections::BTreeMap;
use std::sync::OnceLock;

/// How a thing lies along the side that another stands at.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Along {
    /// Backs flush.
    Backs,
    Middle,
    /// Fronts flush.
    Fronts,
}

/// Where a part of a group is, seen from what it goes with. Distances are gaps in metres.
#[derive(Clone, Debug, PartialEq)]
pub enum Where {
    /// Before its front; turned by so much.
    Front(f64, f64, f64),
    /// Behind its back; turned by so much.
    Back(f64, f64),
    /// At its left (1) or right (-1) side; turned by so much.
    Side(f64, Along, f64, f64),
    /// At both sides.
    Sides(f64, Along),
    /// In a row before its front, turned to it: so many, or as many as there is room for.
    Row(usize, f64),
    /// The same behind its back.
    RowBehind(usize, f64),
    /// On top: shares of the free width and depth from the middle, and a turn.
    Top(f64, f64, f64),
    /// On a board of a shelf, counted from below; a share of the free width.
    Board(usize, f64, usize),
    /// So many around it, at its long sides before its short ones.
    Around(usize, f64),
    /// At its long sides only.
    LongSides(usize, f64),
    /// At the outer sides of a U, which is open at its front.
    Outside(usize, f64),
    /// Flat under it, so much wider and deeper.
    Under(f64, f64, f64),
    /// From the ceiling, over its middle.
    Over,
    /// On the wall behind it, so far above its top.
    Above(f64, f64),
    /// All around it, so far from its sides and its back: only what is asked for.
    Enclose(f64, f64),
}

impl Where {
    /// Whether people sit there, on more than one side of a table.
    pub fn is_around(&self) -> bool {
        matches!(self, Self::Around(..) | Self::LongSides(..) | Self::Outside(..))
    }
}

/// No room is so large (m²): such a part is there only if the request names it.
pub const IF_ASKED: f64 = 900.0;

#[derive(Clone, Debug, PartialEq)]
pub struct GroupPart {
    pub noun: &'static str,
    pub at: Where,
    /// Only in rooms of at least so many square metres.
    pub least: f64,
    /// Its size, where it is not the usual one.
    pub size: Option<[f64; 3]>,
}

/// The parts that go with a thing of this name in rooms that are dressed so (`office`, `school`; empty: as homes are): the
/// longest ending of the name that the table has, one for such rooms before one for all.
pub fn of(name: &str, dress: &str) -> &'static [GroupPart] {
    listed(name, dress).unwrap_or_default()
}

/// The same, or `None` if the table does not contain the name. A loft bed is in the table without any parts.
pub fn listed(name: &str, dress: &str) -> Option<&'static [GroupPart]> {
    let groups = all();
    let words: Vec<&str> = name.split([' ', '_']).collect();
    let found = (0..words.len()).find_map(|from| {
        let end = words[from..].join(" ");
        groups.get(format!("{end} @ {dress}").as_str()).or_else(|| groups.get(end.as_str()))
    });
    found.map(Vec::as_slice)
}

/// Whether visitors sit across from who works at such a thing.
pub fn is_visited(name: &str, dress: &str) -> bool {
    of(name, dress).iter().any(|part| matches!(part.at, Where::RowBehind(..)))
}

/// Whether people sit at all sides of such a thing but its front.
pub fn is_open_to_front(name: &str, dress: &str) -> bool {
    of(name, dress).iter().any(|part| matches!(part.at, Where::Outside(..)))
}

/// Whether what goes with such a thing continues along the next wall.
pub fn turns_corner(name: &str, dress: &str) -> bool {
    of(name, dress).iter().any(|part| matches!(part.at, Where::Side(_, Along::Backs, _, yaw) if yaw != 0.0))
}

fn all() -> &'static BTreeMap<String, Vec<GroupPart>> {
    static GROUPS: OnceLock<BTreeMap<String, Vec<GroupPart>>> = OnceLock::new();
    GROUPS.get_or_init(|| parse(include_str!("../../data/groups.txt")))
}

fn parse(text: &'static str) -> BTreeMap<String, Vec<GroupPart>> {
    let mut out: BTreeMap<String, Vec<GroupPart>> = BTreeMap::new();
    let mut names: Vec<String> = Vec::new();
    for line in text.lines().map(str::trim).filter(|line| !line.is_empty() && !line.starts_with('#')) {
        if let Some(list) = line.strip_prefix('[').and_then(|rest| rest.strip_suffix(']')) {
            let (list, dress) = list.split_once('@').unwrap_or((list, ""));
            let key = |(name, dress): (&str, &str)| match dress {
                "" => name.to_owned(),
                _ => format!("{name} @ {dress}"),
            };
            let dresses: Vec<&str> = dress.split(',').map(str::trim).collect();
            let named = list.split(',').map(str::trim);
            names = named.flat_map(|name| dresses.iter().map(move |dress| (name, *dress))).map(key).collect();
            names.iter().for_each(|name| out.entry(name.clone()).or_default().clear());
        } else if let Some(part) = part(line) {
            names.iter().for_each(|name| out.entry(name.clone()).or_default().push(part.clone()));
        }
    }
    out
}

/// `coffee table | front 0.4 180 | >=12 | 1.1 0.42 0.6`
fn part(line: &'static str) -> Option<GroupPart> {
    let mut columns = line.split('|').map(str::trim);
    let noun = columns.next()?;
    let mut words = columns.next()?.split_whitespace();
    let head = words.next()?;
    let rest: Vec<&str> = words.collect();
    let n = |i: usize| rest.get(i).and_then(|w| w.parse::<f64>().ok());
    let along = match rest.get(1) {
        Some(&"backs") => Along::Backs,
        Some(&"fronts") => Along::Fronts,
        _ => Along::Middle,
    };
    let at = match head {
        "front" => Where::Front(n(0)?, n(1).unwrap_or(180.0), n(2).unwrap_or(0.0)),
        "behind" => Where::Back(n(0)?, n(1).unwrap_or(0.0)),
        "left" => Where::Side(n(0)?, along, 1.0, n(2).unwrap_or(0.0)),
        "right" => Where::Side(n(0)?, along, -1.0, n(2).unwrap_or(0.0)),
        "row" => Where::Row(n(0)? as usize, n(1)?),
        "rowbehind" => Where::RowBehind(n(0)? as usize, n(1)?),
        "sides" => Where::Sides(n(0)?, along),
        "top" => Where::Top(n(0)?, n(1)?, n(2).unwrap_or(0.0)),
        "board" => Where::Board(n(0)? as usize, n(1)?, n(2).map_or(1, |n| n as usize)),
        "around" => Where::Around(n(0)? as usize, n(1)?),
        "outside" => Where::Outside(n(0)? as usize, n(1)?),
        "longsides" => Where::LongSides(n(0)? as usize, n(1)?),
        "under" => Where::Under(n(0)?, n(1)?, n(2).unwrap_or(0.0)),
        "over" => Where::Over,
        "enclose" => Where::Enclose(n(0)?, n(1)?),
        "above" => Where::Above(n(0)?, n(1).unwrap_or(0.0)),
        _ => return None,
    };
    let mut part = GroupPart { noun, at, least: 0.0, size: None };
    for column in columns.filter(|column| !column.is_empty()) {
        let numbers: Vec<f64> = column.split_whitespace().filter_map(|n| n.parse().ok()).collect();
        match (column.strip_prefix(">="), &numbers[..]) {
            (Some(area), _) => part.least = area.trim().parse().ok()?,
            (None, [w, h, d]) => part.size = Some([*w, *h, *d]),
            _ => return None,
        }
    }
    Some(part)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_line_is_read() {
        let text = include_str!("../../data/groups.txt");
        let lines = text.lines().map(str::trim).filter(|l| !l.is_empty() && !l.starts_with(['#', '[']));
        for line in lines {
            assert!(part(line).is_some(), "{line}");
        }
    }

    #[test]
    fn no_name_is_listed_twice() {
        let mut seen = std::collections::BTreeSet::new();
        for line in include_str!("../../data/groups.txt").lines().map(str::trim).filter(|l| l.starts_with('[')) {
            let (names, dresses) =
                line.trim_matches(['[', ']']).split_once('@').unwrap_or((line.trim_matches(['[', ']']), ""));
            for name in names.split(',').map(str::trim) {
                for dress in dresses.split(',').map(str::trim) {
                    assert!(seen.insert((name, dress)), "{name} @ {dress}: the later list would hide the earlier one");
                }
            }
        }
    }

    /// What only homes and hotels have lying about.
    const HOMELY: [&str; 7] = ["vase", "photo frame", "figurine", "candle", "fruit bowl", "table lamp", "throw"];

    /// How rooms are dressed where people live.
    const AT_HOME: [&str; 6] = ["", "hotel", "study", "corner kitchen", "bay kitchen", "galley kitchen"];

    #[test]
    fn only_homes_are_dressed_as_homes_are() {
        let dresses: Vec<&str> = super::super::kinds::all().iter().map(|kind| kind.dress).collect();
        let mut odd = Vec::new();
        for kind in super::super::kinds::all().iter().filter(|kind| !AT_HOME.contains(&kind.dress)) {
            for line in &kind.lines {
                let lies = |part: &&GroupPart| matches!(part.at, Where::Top(..) | Where::Board(..));
                for part in of(line.noun, kind.dress).iter().filter(lies) {
                    let set = ["cafe table", "altar", "candle stand"].contains(&line.noun)
                        || ["food", "pizza", "wine"].contains(&kind.dress);
                    let allowed = set && ["vase", "candle"].contains(&part.noun)
                        || kind.dress == "library" && part.noun == "table lamp";
                    if !allowed && HOMELY.contains(&part.noun) {
                        odd.push(format!("{}: {} has a {}", kind.name, line.noun, part.noun));
                    }
                }
            }
        }
        assert!(odd.is_empty(), "{odd:#?}");
        for name in all().keys().filter_map(|name| name.split_once(" @ ")) {
            assert!(dresses.contains(&name.1), "no room is dressed as {}", name.1);
        }
    }

    #[test]
    fn the_longest_name_counts() {
        assert!(of("dining_table", "").iter().any(|part| part.noun.contains("chair")));
        assert!(of("coffee table", "").iter().all(|part| !["chair", "dining chair"].contains(&part.noun)));
        assert!(of("quux", "").is_empty());
    }
}
