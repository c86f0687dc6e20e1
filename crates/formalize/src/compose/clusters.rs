//! Desks and tables in groups: in each, two lines with their backs to each other, so that one sits at their outer sides. The
//! groups stand beside and behind each other with ways between them.

use crate::brief::{Brief, FactKind, Group, Pattern};

/// Groups of the elements of an array. The first lines of all groups come first, then the second ones.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Clusters {
    groups: usize,
    /// How many stand in the first and in the second line of a group.
    lines: [usize; 2],
    /// How many groups stand beside each other.
    across: usize,
    /// From one to the next in a line, and from the first line to the second (metres).
    steps: [f64; 2],
    /// From group to group, beside and behind each other (metres).
    apart: [f64; 2],
}

/// Between two of a group, and between groups beside each other (metres).
const JOINT: f64 = 0.02;
const WAY: f64 = 1.0;
/// Between groups behind each other: seats at both, and a way between them (metres).
const SEATS_AND_WAY: f64 = 2.0;
/// What a room keeps free at its sides and before a board (metres).
const SIDES: f64 = 1.2;
const AHEAD: f64 = 2.0;

/// The groups of an array of desks or tables that is said to stand so, if its room has room for them.
pub fn clusters(brief: &Brief, size: [f64; 3], n: usize, a: usize, room: [f64; 3]) -> Option<Clusters> {
    let groups = said(brief, a)?;
    if groups == 0 || !n.is_multiple_of(groups) || n / groups < 2 || brief.things[a].group != Group::Table {
        return None;
    }
    let each = n / groups;
    let first = each.div_ceil(2);
    let [w, _, d] = size;
    let steps = [w + JOINT, d + JOINT].map(|v| (v * 100.0).ceil() / 100.0);
    let whole = [first as f64 * steps[0], 2.0 * steps[1]];
    let apart = [whole[0] + WAY, whole[1] + SEATS_AND_WAY].map(|v| (v * 10.0).ceil() / 10.0);
    let [wide, deep] = [room[0] - SIDES, room[2] - AHEAD];
    let takes = |across: usize| {
        let take = |count: usize, k: usize| (count - 1) as f64 * apart[k] + whole[k];
        [take(across, 0), take(groups.div_ceil(across), 1)]
    };
    // Full rows of groups first, then what leaves most of the room free in its tighter direction.
    let spare = |across: usize| {
        let [w, d] = takes(across);
        (wide - w).min(deep - d)
    };
    let fits = (1..=groups).filter(|across| spare(*across) >= 0.0);
    let better = |a: &usize, b: &usize| {
        let full = |across: usize| groups.is_multiple_of(across);
        full(*a).cmp(&full(*b)).then(spare(*a).total_cmp(&spare(*b)))
    };
    let across = fits.max_by(better)?;
    Some(Clusters { groups, lines: [first, each - first], across, steps, apart })
}

/// In how many groups an array is said to stand.
pub fn said(brief: &Brief, a: usize) -> Option<usize> {
    brief.facts.iter().find_map(|f| match f.what {
        FactKind::Pattern(Pattern::Groups(groups)) if f.of == [a] && !f.not => Some(groups),
        _ => None,
    })
}

impl Clusters {
    /// How many stand in the first lines.
    pub fn firsts(&self) -> usize {
        self.groups * self.lines[0]
    }

    /// Where each stands from the first (x and z in metres), and how it is turned (degrees).
    pub fn places(&self) -> Vec<[f64; 3]> {
        let of_line = |line: usize| {
            let each = self.lines[line];
            (0..self.groups * each).map(move |i| {
                let (group, at) = (i / each, i % each);
                let beside = (group % self.across) as f64 * self.apart[0] + at as f64 * self.steps[0];
                let behind = (group / self.across) as f64 * self.apart[1] + line as f64 * self.steps[1];
                [beside, -behind, 180.0 * line as f64]
            })
        };
        of_line(0).chain(of_line(1)).map(|place| place.map(|v| (v * 1000.0).round() / 1000.0)).collect()
    }

    /// The formula that puts an array there: for each line, full rows of groups, and the rest of them.
    pub fn formula(&self, of: &str) -> String {
        let number = crate::write::number;
        let [x, z] = self.apart;
        let (full, rest) = (self.groups / self.across, self.groups % self.across);
        let mut parts = Vec::new();
        for (line, each) in self.lines.into_iter().enumerate().filter(|(_, each)| *each > 0) {
            let begin = line * self.firsts();
            let mut rows = |loops: &str, groups: usize, first: usize, row: &str, behind: f64| {
                let first = if first > 0 { format!("{first} + ") } else { String::new() };
                let at = format!("{of}[{first}{row}{each} * c + i]");
                let down = if row.is_empty() { String::new() } else { format!(" - r * {}", number(z)) };
                let behind = behind + line as f64 * self.steps[1];
                let behind = if behind > 0.0 { format!(" - {}", number(behind)) } else { String::new() };
                parts.push(format!(
                    "({loops}forall c in 0..{groups}: forall i in 0..{each}: {at}.pos.x = {of}[0].pos.x + c * {} + i * {} and {at}.pos.z = {of}[0].pos.z{down}{behind})",
                    number(x),
                    number(self.steps[0])
                ));
            };
            let in_row = each * self.across;
            match full {
                1 => rows("", self.across, begin, "", 0.0),
                _ => rows(&format!("forall r in 0..{full}: "), self.across, begin, &format!("{in_row} * r + "), 0.0),
            }
            if rest > 0 {
                rows("", rest, begin + in_row * full, "", full as f64 * z);
            }
        }
        parts.join(" and ")
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use scenelang_verify::prove::{ProveOptions, prove};

    fn of(groups: usize, lines: [usize; 2], across: usize) -> Clusters {
        Clusters { groups, lines, across, steps: [1.5, 0.75], apart: [4.0, 3.5] }
    }

    #[test]
    fn each_has_a_place_of_its_own() {
        let places = of(5, [2, 1], 2).places();
        assert_eq!(places.len(), 15);
        for (i, a) in places.iter().enumerate() {
            assert!(
                places[..i].iter().all(|b| (a[0] - b[0]).abs() >= 1.5 || (a[1] - b[1]).abs() >= 0.75),
                "{places:?}"
            );
        }
        assert_eq!(places[10], [0.0, -0.75, 180.0]);
        assert_eq!(places[8], [0.0, -7.0, 0.0]);
    }

    /// What the formula says is where the places are.
    #[test]
    fn the_formula_says_the_places() {
        let contradicts = |clusters: &Clusters, moved: f64| {
            let places = clusters.places();
            let at = |(i, [x, z, _]): (usize, &[f64; 3])| {
                let x = if i + 1 == places.len() { x + moved } else { *x };
                format!("assert desk[{i}].pos.x = {x} and desk[{i}].pos.z = {z};\n")
            };
            let said: String = places.iter().enumerate().map(at).collect();
            let source = format!("object desk[{}];\nassert {};\n{said}", places.len(), clusters.formula("desk"));
            let path = std::path::Path::new("room.scene");
            let compiled =
                scenelang_lang::compile_text("room.scene", path, &source, scenelang_lang::Options::default());
            assert!(!compiled.has_errors(), "{source}\n{:?}", compiled.diagnostics);
            let options = ProveOptions { redundant: false, ..ProveOptions::default() };
            !prove(&compiled.program.unwrap(), &options).contradictions.is_empty()
        };
        for clusters in [of(3, [2, 2], 3), of(4, [2, 2], 2), of(5, [2, 1], 2), of(3, [1, 1], 1)] {
            assert!(!contradicts(&clusters, 0.0), "{clusters:?}");
            assert!(contradicts(&clusters, 0.1), "{clusters:?}");
        }
    }
}
