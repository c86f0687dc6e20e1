//! Differences in what a layout says: objects, regions, values. Each change is told in words and in numbers.

use crate::check::{Checked, measure_in_words};
use scenelang_lang::program::Unit;
use scenelang_layout::{DecisionValue, Layout, Placement, RegionPlacement, Vec3, rotation};
use serde::Serialize;
use serde_json::{Map, Value as Json, json};

/// Distances and angles below this are rounding (metres, degrees).
const NEGLIGIBLE: f64 = 1e-6;

/// Share of a move below which an axis is not worth a word.
const SLIGHT: f64 = 0.05;

/// An object or a region that differs.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ChangedThing {
    pub name: String,
    /// In which ways.
    pub changes: Vec<Change>,
}

/// One way in which something differs.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Change {
    /// Which way.
    pub what: DifferenceKind,
    /// In a few words.
    pub words: String,
    /// How far (metres), by what angle (degrees).
    #[serde(skip_serializing_if = "Option::is_none")]
    pub amount: Option<f64>,
    /// What it was.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub before: Option<Json>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub after: Option<Json>,
}

/// Ways to differ.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum DifferenceKind {
    /// Only the second has it.
    Added,
    /// Only the first has it.
    Removed,
    /// Another place.
    Moved,
    /// Another orientation.
    Turned,
    /// Other extents.
    Resized,
    /// Another floor polygon.
    Reshaped,
    /// Other parts, surface, or whatever else is known of what it is made of.
    Asset,
}

impl DifferenceKind {
    /// As written.
    pub fn as_str(self) -> &'static str {
        match self {
            Self::Added => "added",
            Self::Removed => "removed",
            Self::Moved => "moved",
            Self::Turned => "turned",
            Self::Resized => "resized",
            Self::Reshaped => "reshaped",
            Self::Asset => "asset",
        }
    }
}

/// A value that differs; null where there is none.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Changed {
    /// Name of the variable, or key of the draw.
    pub name: String,
    /// What it was.
    pub before: Json,
    pub after: Json,
}

/// The `asset` members of a layout by object, as written.
pub(super) fn assets(checked: &Checked) -> Map<String, Json> {
    // The layout is the file that was read first.
    let text = checked.sources.iter().next().map_or("", |(_, file)| file.text());
    let document: Json = serde_json::from_str(text.trim_start_matches('\u{feff}')).unwrap_or_default();
    let objects = document["objects"].as_object().into_iter().flatten();
    objects.filter_map(|(name, object)| Some((name.clone(), object.get("asset")?.clone()))).collect()
}

pub(super) fn objects(a: &Layout, b: &Layout, assets: &[Map<String, Json>; 2]) -> Vec<ChangedThing> {
    let nothing = Json::Null;
    both(&a.objects, &b.objects, |name, x, y| {
        let mut changes: Vec<Change> = moved(x.pos, y.pos).into_iter().collect();
        changes.extend(turned(x.rot, y.rot));
        changes.extend(resized(x.scale, y.scale));
        let [before, after] = assets.each_ref().map(|map| map.get(name).unwrap_or(&nothing));
        changes.extend(asset(before, after));
        changes
    })
}

pub(super) fn regions(a: &Layout, b: &Layout) -> Vec<ChangedThing> {
    both(&a.regions, &b.regions, |_, x, y| {
        let ([from, to], [size, other]) = ([x.pos, y.pos], [x.scale, y.scale]);
        match (&x.vertices, &y.vertices) {
            (None, None) => {
                [moved(from, to), turned(x.rot, y.rot), resized(size, other)].into_iter().flatten().collect()
            }
            // With a polygon only the heights of the rest have a say.
            (Some(v), Some(w)) => {
                let level = |p: Vec3| Vec3::new(from.x, p.y, from.z);
                let high = |s: Vec3| Vec3::new(size.x, s.y, size.z);
                let outline = (!same_polygon(v, w)).then(|| reshaped(x, y));
                [moved(from, level(to)), resized(size, high(other)), outline].into_iter().flatten().collect()
            }
            _ => vec![reshaped(x, y)],
        }
    })
}

/// Things of two lists by name.
fn both<N: AsRef<str>, T: Spot>(
    a: &[(N, T)],
    b: &[(N, T)],
    differ: impl Fn(&str, &T, &T) -> Vec<Change>,
) -> Vec<ChangedThing> {
    let find = |list: &'_ [(N, T)], name: &str| list.iter().position(|(n, _)| n.as_ref() == name);
    let mut out = Vec::new();
    let mut add = |name: &str, changes: Vec<Change>| {
        if !changes.is_empty() {
            out.push(ChangedThing { name: name.to_owned(), changes });
        }
    };
    for (name, x) in a {
        match find(b, name.as_ref()) {
            Some(i) => add(name.as_ref(), differ(name.as_ref(), x, &b[i].1)),
            None => add(name.as_ref(), vec![one_sided(DifferenceKind::Removed, x)]),
        }
    }
    for (name, y) in b.iter().filter(|(name, _)| find(a, name.as_ref()).is_none()) {
        add(name.as_ref(), vec![one_sided(DifferenceKind::Added, y)]);
    }
    out
}

/// Something with a place and extents.
trait Spot {
    fn spot(&self) -> (Vec3, Vec3);
}

impl Spot for Placement {
    fn spot(&self) -> (Vec3, Vec3) {
        (self.pos, self.scale)
    }
}

impl Spot for RegionPlacement {
    fn spot(&self) -> (Vec3, Vec3) {
        (self.pos, self.scale)
    }
}

fn one_sided(what: DifferenceKind, thing: &impl Spot) -> Change {
    let (pos, scale) = thing.spot();
    let value = Some(json!({ "pos": numbers(pos), "scale": numbers(scale) }));
    let (before, after) = if what == DifferenceKind::Removed { (value, None) } else { (None, value) };
    Change { what, words: format!("{} at {}", size(scale), point(pos)), amount: None, before, after }
}

fn moved(from: Vec3, to: Vec3) -> Option<Change> {
    let by = to - from;
    let distance = by.norm();
    (distance > NEGLIGIBLE).then(|| Change {
        what: DifferenceKind::Moved,
        words: direction(by),
        amount: Some(distance),
        before: Some(json!(numbers(from))),
        after: Some(json!(numbers(to))),
    })
}

/// `0.50 m east, 0.14 m south`, the longest way first: north is +z, as in the moves that `check` suggests.
fn direction(by: Vec3) -> String {
    let mut ways: Vec<(f64, &str)> = [(by.x, "east", "west"), (by.y, "up", "down"), (by.z, "north", "south")]
        .into_iter()
        .map(|(way, more, less)| (way.abs(), if way > 0.0 { more } else { less }))
        .filter(|(way, _)| *way >= SLIGHT * by.norm())
        .collect();
    ways.sort_by(|a, b| b.0.total_cmp(&a.0));
    ways.iter().map(|(way, word)| format!("{} {word}", metres(*way))).collect::<Vec<_>>().join(", ")
}

fn turned(from: Vec3, to: Vec3) -> Option<Change> {
    let [a, b] = [from, to].map(rotation::matrix);
    let angle = rotation::angle_between(&a, &b);
    if angle <= NEGLIGIBLE {
        return None;
    }
    let degrees = measure_in_words(angle, Unit::Degree);
    let upright = |r: &nalgebra::Matrix3<f64>| r[(1, 1)] > 1.0 - 1e-9;
    let words = match (upright(&a), upright(&b)) {
        // Both stand: about y. From +z towards +x is the way of a clock's hands, seen from above.
        (true, true) if angle > 180.0 - NEGLIGIBLE => "half a turn".to_owned(),
        (true, true) if rotation::triple(&(b * a.transpose())).y > 0.0 => {
            format!("{degrees} clockwise, seen from above")
        }
        (true, true) => format!("{degrees} anticlockwise, seen from above"),
        (true, false) => format!("{degrees}, now tilted"),
        (false, true) => format!("{degrees}, now upright"),
        (false, false) => degrees,
    };
    let (before, after) = (Some(json!(numbers(from))), Some(json!(numbers(to))));
    Some(Change { what: DifferenceKind::Turned, words, amount: Some(angle), before, after })
}

fn resized(from: Vec3, to: Vec3) -> Option<Change> {
    ((to - from).amax() > NEGLIGIBLE).then(|| Change {
        what: DifferenceKind::Resized,
        words: format!("{}, was {}", size(to), size(from)),
        amount: None,
        before: Some(json!(numbers(from))),
        after: Some(json!(numbers(to))),
    })
}

fn reshaped(x: &RegionPlacement, y: &RegionPlacement) -> Change {
    let corners = |r: &RegionPlacement| r.vertices.as_ref().map_or(4, Vec::len);
    let words = match (corners(x), corners(y)) {
        (a, b) if a == b => format!("a different outline with {b} corners"),
        (a, b) => format!("an outline with {b} corners, was {a}"),
    };
    Change {
        what: DifferenceKind::Reshaped,
        words,
        amount: None,
        before: Some(json!(x.vertices)),
        after: Some(json!(y.vertices)),
    }
}

/// Whether two outlines are the same up to their first corner and their winding.
fn same_polygon(a: &[[f64; 2]], b: &[[f64; 2]]) -> bool {
    let n = a.len();
    let near = |p: [f64; 2], q: [f64; 2]| (p[0] - q[0]).hypot(p[1] - q[1]) <= NEGLIGIBLE;
    n == b.len()
        && (0..n).any(|start| {
            (0..n).all(|i| near(a[i], b[(start + i) % n])) || (0..n).all(|i| near(a[i], b[(start + n - i) % n]))
        })
}

fn asset(before: &Json, after: &Json) -> Option<Change> {
    if before == after {
        return None;
    }
    let keys = |asset: &Json| asset.as_object().map(|o| o.keys().cloned().collect::<Vec<_>>()).unwrap_or_default();
    let mut names = keys(before);
    names.extend(keys(after).into_iter().filter(|k| before.get(k).is_none()));
    names.retain(|key| before.get(key) != after.get(key));
    let words = match (before, after) {
        (Json::Null, _) => "added".to_owned(),
        (_, Json::Null) => "removed".to_owned(),
        _ => format!("different {}", names.join(", ")),
    };
    Some(Change { what: DifferenceKind::Asset, words, amount: None, before: None, after: None })
}

pub(super) fn values<N: AsRef<str>, T>(a: &[(N, T)], b: &[(N, T)], json: impl Fn(&T) -> Json) -> Vec<Changed> {
    let find = |list: &[(N, T)], name: &str| {
        list.iter().find(|(n, _)| n.as_ref() == name).map_or(Json::Null, |(_, value)| json(value))
    };
    let new = b.iter().filter(|(name, _)| !a.iter().any(|(n, _)| n.as_ref() == name.as_ref()));
    a.iter()
        .chain(new)
        .map(|(name, _)| name.as_ref())
        .map(|name| Changed { name: name.to_owned(), before: find(a, name), after: find(b, name) })
        .filter(|c| !same_value(&c.before, &c.after))
        .collect()
}

fn same_value(a: &Json, b: &Json) -> bool {
    match (a, b) {
        (Json::Array(a), Json::Array(b)) => a.len() == b.len() && a.iter().zip(b).all(|(a, b)| same_value(a, b)),
        _ => match (a.as_f64(), b.as_f64()) {
            (Some(a), Some(b)) => (a - b).abs() <= NEGLIGIBLE,
            _ => a == b,
        },
    }
}

pub(super) fn value(value: &DecisionValue) -> Json {
    match value {
        DecisionValue::Number(number) => json!(number),
        DecisionValue::Bool(truth) => json!(truth),
        DecisionValue::Triple(triple) => json!(triple),
    }
}

fn numbers(v: Vec3) -> [f64; 3] {
    [v.x, v.y, v.z]
}

fn metres(distance: f64) -> String {
    format!("{} m", measure_in_words(distance, Unit::Metre))
}

fn point(p: Vec3) -> String {
    let [x, y, z] = numbers(p).map(|n| measure_in_words(n, Unit::Metre));
    format!("({x}, {y}, {z})")
}

fn size(s: Vec3) -> String {
    format!("{:.2} × {:.2} × {:.2} m", s.x, s.y, s.z)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn directions_are_those_of_the_world() {
        for (by, wanted) in [
            ([0.5, 0.0, 0.0], "0.5 m east"),
            ([-0.5, 0.0, -1.0], "1 m south, 0.5 m west"),
            ([0.01, 1.0, 0.2], "1 m up, 0.2 m north"),
            ([0.0, -0.0005, 0.0], "0.0005 m down"),
        ] {
            assert_eq!(direction(Vec3::from(by)), wanted);
        }
    }

    #[test]
    fn turns_are_told_as_seen() {
        for (from, to, wanted) in [
            ([0.0, 0.0, 0.0], [0.0, 30.0, 0.0], Some("30° clockwise, seen from above")),
            ([0.0, 30.0, 0.0], [0.0, 10.0, 0.0], Some("20° anticlockwise, seen from above")),
            ([0.0, 350.0, 0.0], [0.0, 10.0, 0.0], Some("20° clockwise, seen from above")),
            ([0.0, 0.0, 0.0], [0.0, 360.0, 0.0], None),
            ([0.0, 0.0, 0.0], [0.0, 180.0, 0.0], Some("half a turn")),
            ([0.0, 0.0, 0.0], [90.0, 0.0, 0.0], Some("90°, now tilted")),
        ] {
            assert_eq!(turned(Vec3::from(from), Vec3::from(to)).map(|c| c.words).as_deref(), wanted);
        }
    }

    #[test]
    fn outlines_are_the_same_from_any_corner_in_either_winding() {
        let a = [[0.0, 0.0], [4.0, 0.0], [4.0, 3.0], [0.0, 3.0]];
        let b = [[4.0, 3.0], [4.0, 0.0], [0.0, 0.0], [0.0, 3.0]];
        assert!(same_polygon(&a, &b));
        let mut c = b;
        c[0][0] = 4.1;
        assert!(!same_polygon(&a, &c) && !same_polygon(&a, &b[..3]));
    }
}
