//! A layout as text: stable, compact, with all that another tool has put into the file kept where it was.
//!
//! Poses are what people edit. So an entry begins with them, on one line, and the parts of an object stand behind them on a
//! line of their own, however long that is.

use super::joints::joint;
use super::json::{Json, JsonNode, Member, find};
use super::{Document, FORMAT};
use crate::{DecisionValue, Layout, Part, Placement, RegionPlacement, Vec3};
use scenelang_base::FileId;
use scenelang_base::door::Door;
use smol_str::SmolStr;
use std::borrow::Cow;
use std::fmt::Write;
use std::io;
use std::path::Path;

/// Up to this column an array or object stays on its line.
const WIDTH: usize = 120;
/// Doubles tell whole numbers below this apart.
const EXACT: f64 = 9e15;

/// What is to be written.
pub(super) enum Out<'a> {
    /// A number, string or word, as it will stand in the file.
    Raw(Cow<'a, str>),
    Array(Vec<Out<'a>>),
    Object(Vec<Pair<'a>>),
    /// An object each of whose members begins a line, however short.
    Open(Vec<Pair<'a>>),
    /// An object whose members fill lines, and a member that stands on one line behind them.
    Entry(Vec<Pair<'a>>, Option<Box<Pair<'a>>>),
}

/// A key as it will stand in the file, and its value.
type Pair<'a> = (Cow<'a, str>, Out<'a>);

/// The text of a layout. With the document it was read from, keys that we do not know stay, at every level and in
/// their place, and so do entries that could not be read; entries that the layout no longer has go.
pub fn to_json(layout: &Layout, previous: Option<&Document>) -> String {
    let old = Old { document: previous, node: previous.map(|d| &d.root) };
    let regions = layout.regions.iter().map(|(n, r)| (n.as_str(), r));
    let objects: Vec<_> = layout.objects.iter().map(|(n, o)| (n, (layout.categories.get(n), o))).collect();
    let objects = objects.iter().map(|(n, o)| (n.as_str(), o));
    let variables = layout.variables.iter().map(|(n, v)| (n.as_str(), v));
    let draws = layout.draws.iter().map(|(n, d)| (n.as_str(), d));
    let root = old.merged(vec![
        ("format", Some(text(FORMAT))),
        ("scene", layout.scene.as_deref().map(text)),
        // The sum of the whole file is for whoever writes it, and that of the old file is wrong now.
        ("written", None),
        ("seed", layout.seed.map(|s| Out::Raw(s.to_string().into()))),
        ("incomplete", layout.incomplete.then(|| Out::Raw("true".into()))),
        ("regions", old.member("regions").block(regions, region)),
        ("objects", old.member("objects").block(objects, object)),
        ("variables", old.member("variables").block(variables, |v, _| value(v))),
        ("draws", old.member("draws").block(draws, |d, _| number(*d))),
    ]);
    let mut out = String::new();
    print(&Out::Open(root), 0, &mut out);
    out.push('\n');
    out
}

/// Writes a layout through a door, whole or not at all.
///
/// # Errors
/// What the file system says; or what [`checked`] says, in which case nothing is written.
pub fn write(door: &Door, path: &Path, layout: &Layout, previous: Option<&Document>) -> io::Result<()> {
    door.write(path, checked(path, layout, previous)?.as_bytes())
}

/// The text of a layout that is to be written to `path`.
///
/// # Errors
/// The layout has a value that no file can hold (a number that is not finite, a size that is not positive).
pub fn checked(path: &Path, layout: &Layout, previous: Option<&Document>) -> io::Result<String> {
    let text = to_json(layout, previous);
    // Never leave a file behind that we would not read.
    if let Some(error) = super::read(&text, FileId(0)).diagnostics.iter().find(|d| d.is_error()) {
        let say = format!("cannot write {}: {}", path.display(), error.message);
        return Err(io::Error::new(io::ErrorKind::InvalidData, say));
    }
    Ok(text)
}

pub(super) fn text<'a>(value: &str) -> Out<'a> {
    Out::Raw(quoted(value).into())
}

fn quoted(text: &str) -> String {
    serde_json::Value::from(text).to_string()
}

/// The shortest text that reads back as the same number.
pub(super) fn number<'a>(value: f64) -> Out<'a> {
    let size = value.abs();
    Out::Raw(if !value.is_finite() {
        "null".into()
    } else if value == 0.0 {
        "0".into()
    } else if (1e-5..1e16).contains(&size) {
        value.to_string().into()
    } else {
        format!("{value:e}").into()
    })
}

pub(super) fn numbers<'a>(values: &[f64]) -> Out<'a> {
    Out::Array(values.iter().map(|v| number(*v)).collect())
}

pub(super) fn triple<'a>(value: &Vec3) -> Out<'a> {
    numbers(value.as_slice())
}

fn value<'a>(value: &DecisionValue) -> Out<'a> {
    match value {
        DecisionValue::Number(n) => number(*n),
        DecisionValue::Bool(b) => Out::Raw(b.to_string().into()),
        DecisionValue::Triple(t) => numbers(t),
    }
}

fn object<'a>((category, placement): &(Option<&SmolStr>, &Placement), old: Old<'a>) -> Out<'a> {
    let asset = old.member("asset");
    let old_parts = asset.member("parts");
    let parts = placement.parts.iter().enumerate().map(|(i, p)| part(p, old_parts.item(i))).collect::<Vec<_>>();
    let old_joints = asset.member("joints");
    let joints = placement.joints.iter().enumerate().map(|(i, j)| joint(j, old_joints.item(i))).collect::<Vec<_>>();
    let asset = asset.merged(vec![
        ("surface", placement.surface.map(number)),
        ("parts", (!parts.is_empty()).then_some(Out::Array(parts))),
        ("joints", (!joints.is_empty()).then_some(Out::Array(joints))),
    ]);
    let mut known = vec![
        ("pos", Some(triple(&placement.pos))),
        ("rot", Some(triple(&placement.rot))),
        ("scale", Some(triple(&placement.scale))),
        ("asset", None),
    ];
    known.extend(category.map(|category| ("category", Some(text(category)))));
    let mut members = old.merged(known);
    if old.member("category").node.is_none() {
        let category = members.iter().position(|(key, _)| key == "\"category\"");
        members[..category.map_or(0, |at| at + 1)].rotate_right(usize::from(category.is_some()));
    }
    let asset = (!asset.is_empty()).then(|| Box::new(("\"asset\"".into(), Out::Object(asset))));
    Out::Entry(members, asset)
}

fn part<'a>(part: &Part, old: Old<'a>) -> Out<'a> {
    let (shape, mut known) = match part {
        Part::Box { pos, size, .. } => ("box", vec![("pos", Some(triple(pos))), ("size", Some(triple(size)))]),
        Part::Cylinder { pos, radius, height, .. } => {
            let extents = [("radius", Some(number(*radius))), ("height", Some(number(*height)))];
            ("cylinder", [("pos", Some(triple(pos)))].into_iter().chain(extents).collect())
        }
        Part::Hull { points } => ("hull", vec![("points", Some(Out::Array(points.iter().map(triple).collect())))]),
    };
    known.insert(0, ("shape", Some(text(shape))));
    if let Part::Box { rot, .. } | Part::Cylinder { rot, .. } = part {
        known.push(("rot", (*rot != Vec3::zeros()).then(|| triple(rot))));
    }
    // What was said of a part of another shape is not about this one.
    let same = matches!(old.member("shape").node, Some(JsonNode { value: Json::Text(s), .. }) if s == shape);
    Out::Object(if same { old } else { Old { node: None, ..old } }.merged(known))
}

fn region<'a>(region: &RegionPlacement, old: Old<'a>) -> Out<'a> {
    let vertices = region.vertices.as_ref().map(|v| Out::Array(v.iter().map(|p| numbers(p)).collect()));
    let members = old.merged(vec![
        ("pos", Some(triple(&region.pos))),
        ("rot", Some(triple(&region.rot))),
        ("scale", Some(triple(&region.scale))),
        ("vertices", vertices),
    ]);
    Out::Entry(members, None)
}

/// What stood at this place of the document before, if anything.
#[derive(Clone, Copy)]
pub(super) struct Old<'a> {
    document: Option<&'a Document>,
    node: Option<&'a JsonNode>,
}

impl<'a> Old<'a> {
    fn members(self) -> &'a [Member] {
        self.node.and_then(JsonNode::members).unwrap_or_default()
    }
    fn member(self, key: &str) -> Self {
        Self { node: find(self.members(), key).map(|m| &m.node), ..self }
    }
    fn item(self, index: usize) -> Self {
        Self { node: self.node.and_then(JsonNode::items).and_then(|items| items.get(index)), ..self }
    }
    fn source(self, range: scenelang_base::TextRange) -> Cow<'a, str> {
        self.document.and_then(|d| d.text.get(range.bytes())).unwrap_or("null").into()
    }
    /// A value as it was, numbers and strings to the letter.
    fn kept(self, node: &'a JsonNode) -> Out<'a> {
        match &node.value {
            Json::Array(items) => Out::Array(items.iter().map(|n| self.kept(n)).collect()),
            Json::Object(members) => {
                Out::Object(members.iter().map(|m| (self.source(m.key_range), self.kept(&m.node))).collect())
            }
            _ => Out::Raw(self.source(node.range)),
        }
    }

    /// A new value, spelt as it was wherever it says the same as before.
    fn as_written(self, new: Out<'a>, before: &'a JsonNode) -> Out<'a> {
        match (new, &before.value) {
            (Out::Array(items), Json::Array(old)) if items.len() == old.len() => {
                Out::Array(items.into_iter().zip(old).map(|(item, old)| self.as_written(item, old)).collect())
            }
            (Out::Raw(raw), Json::Number(old))
                if old.abs() < EXACT && raw.parse::<f64>().is_ok_and(|new| new == *old) =>
            {
                Out::Raw(self.source(before.range))
            }
            (Out::Raw(raw), Json::Text(old)) if raw == quoted(old) => Out::Raw(self.source(before.range)),
            (new, _) => new,
        }
    }

    /// The members as they were, with known ones replaced or (`None`) left out, and new ones at the end.
    pub(super) fn merged(self, known: Vec<(&str, Option<Out<'a>>)>) -> Vec<Pair<'a>> {
        let mut known: Vec<(&str, Option<Out<'a>>)> = known;
        let mut out = Vec::new();
        for member in self.members() {
            match known.iter().position(|(key, _)| *key == member.key) {
                Some(i) => {
                    let new = known.remove(i).1.map(|new| self.as_written(new, &member.node));
                    out.extend(new.map(|new| (self.source(member.key_range), new)));
                }
                None => out.push((self.source(member.key_range), self.kept(&member.node))),
            }
        }
        out.extend(known.into_iter().filter_map(|(key, new)| Some((quoted(key).into(), new?))));
        out
    }

    /// The entries of a block: in the old order, new ones at the end. An empty block that was not there stays away.
    fn block<'t, T: 't>(
        self,
        entries: impl Iterator<Item = (&'t str, &'t T)>,
        show: fn(&T, Old<'a>) -> Out<'a>,
    ) -> Option<Out<'a>> {
        let mut new: Vec<(&str, Option<&T>)> = entries.map(|(name, entry)| (name, Some(entry))).collect();
        let index: std::collections::HashMap<&str, usize> =
            new.iter().enumerate().map(|(i, (name, _))| (*name, i)).collect();
        let mut out = Vec::new();
        for member in self.members() {
            let old = Self { node: Some(&member.node), ..self };
            match index.get(member.key.as_str()).and_then(|&i| new[i].1.take()) {
                Some(entry) => {
                    out.push((self.source(member.key_range), self.as_written(show(entry, old), &member.node)));
                }
                None if !self.understood(member) => out.push((self.source(member.key_range), self.kept(&member.node))),
                None => {}
            }
        }
        let nothing = Self { node: None, ..self };
        out.extend(new.into_iter().filter_map(|(name, entry)| Some((quoted(name).into(), show(entry?, nothing)))));
        (!out.is_empty() || self.node.is_some()).then_some(Out::Open(out))
    }

    fn understood(self, member: &Member) -> bool {
        self.document.is_some_and(|d| d.understood.binary_search(&member.key_range.start).is_ok())
    }
}

/// Prints a value that starts at some column of a line indented by `indent`.
fn print(value: &Out<'_>, indent: usize, out: &mut String) {
    let mut line = String::new();
    // One column is left for the comma after it.
    if fits(value, (WIDTH - 1).saturating_sub(column(out)), &mut line) {
        out.push_str(&line);
        return;
    }
    let inner = " ".repeat(indent + 2);
    match value {
        Out::Raw(raw) => out.push_str(raw),
        Out::Array(items) => {
            out.push('[');
            for (i, item) in items.iter().enumerate() {
                out.push_str(if i == 0 { "\n" } else { ",\n" });
                out.push_str(&inner);
                print(item, indent + 2, out);
            }
            let _ = write!(out, "\n{}]", &inner[2..]);
        }
        Out::Object(members) | Out::Open(members) => {
            out.push('{');
            for (i, (key, member)) in members.iter().enumerate() {
                out.push_str(if i == 0 { "\n" } else { ",\n" });
                let _ = write!(out, "{inner}{key}: ");
                print(member, indent + 2, out);
            }
            let _ = write!(out, "\n{}}}", &inner[2..]);
        }
        Out::Entry(members, last) => entry(members, last.as_deref(), &inner, out),
    }
}

/// Prints the members of an entry, as many on a line as there is room for, and the last one on a line of its own.
fn entry(members: &[Pair<'_>], last: Option<&Pair<'_>>, inner: &str, out: &mut String) {
    out.push('{');
    for (i, (key, member)) in members.iter().enumerate() {
        let (mut text, separator) = (format!("{key}: "), if i == 0 { "" } else { "," });
        // Room for a space, and for the comma or brace that follows.
        let room = (WIDTH - 4).saturating_sub(column(out));
        let on_this_line = fits(member, room, &mut text);
        out.push_str(separator);
        if on_this_line {
            let _ = write!(out, " {text}");
        } else {
            let _ = write!(out, "\n{inner}{key}: ");
            print(member, inner.len(), out);
        }
    }
    if let Some((key, member)) = last {
        out.push_str(if members.is_empty() { "\n" } else { ",\n" });
        let mut text = String::new();
        fits(member, usize::MAX, &mut text);
        let _ = write!(out, "{inner}{key}: {text}");
    }
    out.push_str(" }");
}

/// How many characters stand on the last line.
fn column(text: &str) -> usize {
    text.len() - text.rfind('\n').map_or(0, |i| i + 1)
}

/// Whether a value fits into so many columns, and what it looks like then.
fn fits(value: &Out<'_>, room: usize, out: &mut String) -> bool {
    match value {
        Out::Raw(raw) => out.push_str(raw),
        Out::Array(items) => {
            out.push('[');
            for (i, item) in items.iter().enumerate() {
                out.push_str(if i == 0 { "" } else { ", " });
                if !fits(item, room, out) {
                    return false;
                }
            }
            out.push(']');
        }
        Out::Open(members) if !members.is_empty() => return false,
        Out::Entry(_, Some(_)) => return false,
        Out::Object(members) | Out::Open(members) | Out::Entry(members, None) => {
            out.push('{');
            for (i, (key, member)) in members.iter().enumerate() {
                out.push_str(if i == 0 { " " } else { ", " });
                let _ = write!(out, "{key}: ");
                if !fits(member, room, out) {
                    return false;
                }
            }
            out.push_str(if members.is_empty() { "}" } else { " }" });
        }
    }
    out.len() <= room
}
