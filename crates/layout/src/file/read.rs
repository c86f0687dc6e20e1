//! From the tree to a [`Layout`], with every check that needs no program.

use super::json::{Findings, Json, JsonNode, Member, find};
use crate::convex::{MAX_HULL_POINTS, parts_fill_box};
use crate::{Convex, DecisionValue, Layout, Part, Placement, Polygon, RegionPlacement, Vec3};
use scenelang_base::suggest::nearest;
use scenelang_base::{Code, TextRange, codes};
use smol_str::SmolStr;
use std::collections::BTreeMap;

/// What a layout file calls itself.
pub const FORMAT: &str = "scenelang.layout/1";

/// Lengths and angles beyond this are errors.
pub const LARGEST: f64 = 1e6;

/// How far a region may be tilted, in degrees: as much as two rotations may differ and be equal.
const TILT: f64 = 0.1;

/// Members of a layout, of an object and of a region.
const TOP: &[&str] = &["format", "scene", "seed", "incomplete", "written", "objects", "regions", "variables", "draws"];
const OBJECT: &[&str] = &["category", "pos", "rot", "scale", "asset"];
const REGION: &[&str] = &["pos", "rot", "scale", "vertices"];
const PLACE: &[&str] = &["pos", "scale"];

/// What other formats call them.
const SYNONYMS: &[(&str, &str)] = &[
    ("position", "pos"),
    ("translation", "pos"),
    ("location", "pos"),
    ("rotation", "rot"),
    ("orientation", "rot"),
    ("yaw", "rot"),
    ("size", "scale"),
    ("dimensions", "scale"),
    ("extents", "scale"),
    ("polygon", "vertices"),
    ("outline", "vertices"),
    ("rooms", "regions"),
    ("program", "scene"),
];

/// The member that was meant by a key which is none.
fn meant(key: &str, known: &[&'static str]) -> Option<&'static str> {
    if known.contains(&key) {
        return None;
    }
    let synonym = SYNONYMS.iter().find(|(other, ours)| other.eq_ignore_ascii_case(key) && known.contains(ours));
    synonym.map(|(_, ours)| *ours).or_else(|| nearest(key, known.iter().copied()))
}

/// What the members of a document say.
pub(super) struct DocumentMembers {
    pub layout: Layout,
    /// Whether this is a layout at all.
    pub usable: bool,
    /// Starts of those members of the blocks that were understood, sorted.
    pub understood: Vec<u32>,
}

pub(super) fn document(text: &str, root: &JsonNode, findings: &mut Findings) -> DocumentMembers {
    let mut reader = Reader { text, findings, understood: Vec::new() };
    let (layout, usable) = reader.document(root).unwrap_or_default();
    let mut understood = reader.understood;
    understood.sort_unstable();
    DocumentMembers { layout, usable, understood }
}

/// The categories that objects are given. Anything else under that key is kept like an unknown member.
fn categories(members: &[Member]) -> BTreeMap<SmolStr, SmolStr> {
    let objects = find(members, "objects").and_then(|m| m.node.members()).unwrap_or_default();
    let category = |object: &Member| match &find(object.node.members()?, "category")?.node.value {
        Json::Text(category) => Some((SmolStr::new(&object.key), SmolStr::new(category))),
        _ => None,
    };
    objects.iter().filter_map(category).collect()
}

pub(super) struct Reader<'a, 'f> {
    text: &'a str,
    findings: &'f mut Findings,
    understood: Vec<u32>,
}

impl Reader<'_, '_> {
    pub(super) fn error(&mut self, code: Code, at: TextRange, message: impl Into<String>) {
        self.findings.add(code, at, message);
    }
    /// Says that a value is of the wrong type, unless an error in it has been reported.
    pub(super) fn wrong<T>(&mut self, node: &JsonNode, what: &str, wanted: &str) -> Option<T> {
        if !node.is_spoilt() {
            self.error(codes::E0504, node.range, format!("{what} must be {wanted}, not {}", node.kind()));
        }
        None
    }

    fn document(&mut self, root: &JsonNode) -> Option<(Layout, bool)> {
        let Some(members) = root.members() else {
            if !root.is_spoilt() {
                let at = TextRange { end: root.range.end.min(root.range.start + 1), ..root.range };
                self.error(codes::E0502, at, format!("a layout file must be a JSON object, not {}", root.kind()));
            }
            return None;
        };
        if !self.format(root, members) {
            return None;
        }
        self.unread(members, TOP, "the layout");
        let layout = Layout {
            scene: find(members, "scene").and_then(|m| self.text(&m.node, "`scene`")),
            seed: find(members, "seed").and_then(|m| self.seed(&m.node)),
            incomplete: find(members, "incomplete").and_then(|m| self.truth(&m.node, "`incomplete`")).unwrap_or(false),
            objects: self.block(members, "objects", Self::object),
            categories: categories(members),
            regions: self.block(members, "regions", Self::region),
            variables: self.block(members, "variables", Self::variable),
            draws: self
                .block(members, "draws", |r, m| r.number(&m.node, &format!("the draw `{}`", m.key)))
                .into_iter()
                .map(|(name, value)| (name.into(), value))
                .collect(),
        };
        Some((layout, true))
    }

    /// Whether to read on: it calls itself a layout, or looks like one.
    fn format(&mut self, root: &JsonNode, members: &[Member]) -> bool {
        match find(members, "format").map(|m| &m.node) {
            Some(JsonNode { value: Json::Text(format), .. }) if format == FORMAT => true,
            Some(JsonNode { value: Json::Text(_), range }) => {
                self.error(codes::E0502, *range, format!("this is not a layout of the format {FORMAT:?}"));
                false
            }
            Some(node) => {
                let _: Option<()> = self.wrong(node, "`format`", "a string");
                true
            }
            None => {
                let at = TextRange::new(root.range.start as usize, root.range.start as usize + 1);
                self.error(codes::E0502, at, format!("a layout file must contain `\"format\": {FORMAT:?}`"));
                find(members, "objects").is_some() || find(members, "regions").is_some()
            }
        }
    }

    fn block<T>(
        &mut self,
        members: &[Member],
        key: &str,
        read: fn(&mut Self, &Member) -> Option<T>,
    ) -> Vec<(SmolStr, T)> {
        let Some(block) = find(members, key) else { return Vec::new() };
        let Some(entries) = block.node.members() else {
            return self.wrong(&block.node, &format!("`{key}`"), "an object").unwrap_or_default();
        };
        let mut out = Vec::with_capacity(entries.len());
        for entry in entries {
            if let Some(value) = read(self, entry) {
                self.understood.push(entry.key_range.start);
                out.push((SmolStr::new(&entry.key), value));
            }
        }
        out
    }

    /// A value of the wrong type is left out: whether that is an error depends on the program.
    fn variable(&mut self, member: &Member) -> Option<DecisionValue> {
        match &member.node.value {
            Json::Number(n) => Some(DecisionValue::Number(*n)),
            Json::Bool(b) => Some(DecisionValue::Bool(*b)),
            Json::Array(items) => {
                let numbers: Option<Vec<f64>> = items
                    .iter()
                    .map(|n| match n.value {
                        Json::Number(n) => Some(n),
                        _ => None,
                    })
                    .collect();
                numbers?.try_into().ok().map(DecisionValue::Triple)
            }
            _ => None,
        }
    }

    fn object(&mut self, member: &Member) -> Option<Placement> {
        let name = &member.key;
        let members = self.members(&member.node, name)?;
        self.unread(members, OBJECT, &format!("`{name}`"));
        let place = self.place(member, members);
        let asset = match find(members, "asset") {
            Some(asset) => Some(self.members(&asset.node, &format!("{name}.asset"))?),
            None => None,
        };
        let surface = match asset.and_then(|a| find(a, "surface")) {
            Some(m) => Some(self.length(&m.node, &format!("`surface` of `{name}`"))?),
            None => None,
        };
        let given = asset.and_then(|a| find(a, "parts"));
        let parts = match given {
            Some(m) => {
                let what = format!("`parts` of `{name}`");
                let Some(items) = m.node.items() else { return self.wrong(&m.node, &what, "an array") };
                // All are read before giving up, so that all errors are told.
                let parts: Vec<Option<Part>> = items.iter().map(|n| self.part(n, name)).collect();
                parts.into_iter().collect::<Option<Vec<Part>>>()?
            }
            None => Vec::new(),
        };
        let joints = match asset.and_then(|a| find(a, "joints")) {
            Some(m) => self.joints(&m.node, name, &parts)?,
            None => Vec::new(),
        };
        let [pos, rot, scale] = place?;
        let placement = Placement { pos, rot, scale, parts, surface, joints };
        if let Some(m) = given
            && !parts_fill_box(&placement)
        {
            let say = format!("the parts of `{name}` do not fill its box, so the box is used instead");
            self.error(codes::W0501, m.key_range, say);
        }
        Some(placement)
    }

    fn region(&mut self, member: &Member) -> Option<RegionPlacement> {
        let name = &member.key;
        let members = self.members(&member.node, name)?;
        self.unread(members, REGION, &format!("`{name}`"));
        let place = self.place(member, members);
        if let (Some([_, rot, _]), Some(m)) = (place, find(members, "rot")) {
            let off = |degrees: f64| (degrees - 360.0 * (degrees / 360.0).round()).abs();
            if off(rot.x) > TILT + 1e-9 || off(rot.z) > TILT + 1e-9 {
                self.error(
                    codes::E0511,
                    m.node.range,
                    format!("the region `{name}` can be rotated only about the y axis"),
                );
                return None;
            }
        }
        let vertices = match find(members, "vertices") {
            Some(m) => Some(self.vertices(&m.node, name)?),
            None => None,
        };
        let [pos, rot, scale] = place?;
        Some(RegionPlacement { pos, rot, scale, vertices })
    }

    /// Warns of members that nothing reads and that are called nearly like one that is absent. Others belong to other tools.
    /// What must be there is missed elsewhere, and told there.
    fn unread(&mut self, members: &[Member], known: &[&'static str], owner: &str) {
        for member in members {
            let Some(key) = meant(&member.key, known) else { continue };
            if find(members, key).is_none() && !matches!(key, "pos" | "scale" | "format") {
                let say = format!("`{}` in {owner} is not read; did you mean `{key}`?", member.key);
                self.error(codes::W0506, member.key_range, say);
            }
        }
    }

    /// `pos`, `rot` and `scale` of an object or region; all are looked at before giving up.
    fn place(&mut self, owner: &Member, members: &[Member]) -> Option<[Vec3; 3]> {
        let missing: Vec<&str> = ["pos", "scale"].into_iter().filter(|k| find(members, k).is_none()).collect();
        if !missing.is_empty() {
            // A member that nothing reads, under another name: `position`.
            let is_like = |m: &&Member| meant(&m.key, PLACE).is_some_and(|key| missing.contains(&key));
            let like = members.iter().find(is_like).map_or(String::new(), |m| format!("; `{}` is not read", m.key));
            let named: Vec<String> = missing.iter().map(|key| format!("`{key}`")).collect();
            let say = format!("`{}` has no {}{like}", owner.key, named.join(" and no "));
            self.error(codes::E0503, owner.key_range, say);
        }
        let what = |key: &str| format!("`{key}` of `{}`", owner.key);
        let pos = find(members, "pos").and_then(|m| self.triple(&m.node, &what("pos")));
        let rot = self.rot(members, &owner.key);
        let scale = find(members, "scale").and_then(|m| self.extents(&m.node, &what("scale")));
        Some([pos?, rot?, scale?])
    }

    fn rot(&mut self, members: &[Member], name: &str) -> Option<Vec3> {
        match find(members, "rot") {
            Some(m) => self.triple(&m.node, &format!("`rot` of `{name}`")),
            None => Some(Vec3::zeros()),
        }
    }

    fn vertices(&mut self, node: &JsonNode, name: &str) -> Option<Vec<[f64; 2]>> {
        let what = format!("`vertices` of `{name}`");
        let Some(items) = node.items() else { return self.wrong(node, &what, "an array of pairs [x, z]") };
        let mut vertices = Vec::with_capacity(items.len());
        for item in items {
            let Some([x, z]) = item.items() else {
                return self.wrong(item, &format!("a vertex of `{name}`"), "two numbers [x, z]");
            };
            vertices.push([self.length(x, &what)?, self.length(z, &what)?]);
        }
        match Polygon::new(&vertices) {
            Ok(_) => Some(vertices),
            Err(why) => {
                self.error(codes::E0508, node.range, why.to_string());
                None
            }
        }
    }

    fn part(&mut self, node: &JsonNode, name: &str) -> Option<Part> {
        let members = self.members(node, &format!("a part of `{name}`"))?;
        let owner = format!("a part of `{name}`");
        let what = |key: &str| format!("`{key}` of {owner}");
        let shape = self.required(node, members, "shape", &owner)?;
        let kind = match &shape.value {
            Json::Text(kind) => kind.as_str(),
            _ => return self.wrong(shape, &what("shape"), "a string"),
        };
        match kind {
            "box" => {
                let pos = self.required(node, members, "pos", &owner).and_then(|n| self.triple(n, &what("pos")));
                let size = self.required(node, members, "size", &owner).and_then(|n| self.extents(n, &what("size")));
                let rot = self.rot(members, name);
                Some(Part::Box { pos: pos?, size: size?, rot: rot? })
            }
            "cylinder" => {
                let pos = self.required(node, members, "pos", &owner).and_then(|n| self.triple(n, &what("pos")));
                let mut extent =
                    |key| self.required(node, members, key, &owner).and_then(|n| self.extent(n, &what(key)));
                let (radius, height) = (extent("radius"), extent("height"));
                let rot = self.rot(members, name);
                Some(Part::Cylinder { pos: pos?, radius: radius?, height: height?, rot: rot? })
            }
            "hull" => {
                let points = self.required(node, members, "points", &owner)?;
                let Some(items) = points.items() else { return self.wrong(points, &what("points"), "an array") };
                let read: Option<Vec<Vec3>> = items.iter().map(|n| self.triple(n, &what("points"))).collect();
                let part = Part::Hull { points: read? };
                if Convex::from_part(&part).is_none() {
                    let say = format!("a hull needs 4 to {MAX_HULL_POINTS} points that are not all in one plane");
                    self.error(codes::E0505, points.range, say);
                    return None;
                }
                Some(part)
            }
            _ => {
                let say = format!("the shape of a part is \"box\", \"cylinder\" or \"hull\", not {kind:?}");
                self.error(codes::E0504, shape.range, say);
                None
            }
        }
    }

    /// A member that must be there; if not, that is said at the brace around it.
    pub(super) fn required<'n>(
        &mut self,
        node: &JsonNode,
        members: &'n [Member],
        key: &str,
        owner: &str,
    ) -> Option<&'n JsonNode> {
        let found = find(members, key).map(|m| &m.node);
        if found.is_none() {
            let brace = TextRange::new(node.range.start as usize, node.range.start as usize + 1);
            self.error(codes::E0503, brace, format!("{owner} has no `{key}`"));
        }
        found
    }

    pub(super) fn members<'n>(&mut self, node: &'n JsonNode, what: &str) -> Option<&'n [Member]> {
        match node.members() {
            Some(members) => Some(members),
            None => self.wrong(node, &format!("`{what}`"), "an object"),
        }
    }

    pub(super) fn text(&mut self, node: &JsonNode, what: &str) -> Option<String> {
        match &node.value {
            Json::Text(text) => Some(text.clone()),
            _ => self.wrong(node, what, "a string"),
        }
    }

    fn seed(&mut self, node: &JsonNode) -> Option<u64> {
        let Json::Number(number) = node.value else { return self.wrong(node, "`seed`", "a whole number") };
        // Digits are read as such, since a double holds only 53 bits; `7.0` and `7e0` are whole numbers too.
        let digits = self.text[node.range.bytes()].parse::<u64>().ok();
        let whole = number >= 0.0 && number.fract() == 0.0 && number < 9e15;
        let seed = digits.or(whole.then_some(number as u64));
        if seed.is_none() {
            self.error(codes::E0505, node.range, "`seed` takes a whole number from 0 to 18446744073709551615");
        }
        seed
    }

    fn truth(&mut self, node: &JsonNode, what: &str) -> Option<bool> {
        let Json::Bool(truth) = node.value else { return self.wrong(node, what, "true or false") };
        Some(truth)
    }

    pub(super) fn number(&mut self, node: &JsonNode, what: &str) -> Option<f64> {
        match node.value {
            Json::Number(number) => Some(number),
            _ => self.wrong(node, what, "a number"),
        }
    }

    /// A number of metres or degrees, not absurd.
    pub(super) fn length(&mut self, node: &JsonNode, what: &str) -> Option<f64> {
        let number = self.number(node, what)?;
        if number.abs() > LARGEST {
            self.error(codes::E0505, node.range, format!("{what} must not exceed a million"));
            return None;
        }
        Some(number)
    }

    /// A length that is more than nothing.
    pub(super) fn extent(&mut self, node: &JsonNode, what: &str) -> Option<f64> {
        let number = self.length(node, what)?;
        if number <= 0.0 {
            self.error(codes::E0505, node.range, format!("{what} must be greater than 0"));
            return None;
        }
        Some(number)
    }

    pub(super) fn triple(&mut self, node: &JsonNode, what: &str) -> Option<Vec3> {
        self.three(node, what, Self::length)
    }

    fn extents(&mut self, node: &JsonNode, what: &str) -> Option<Vec3> {
        self.three(node, what, Self::extent)
    }

    fn three(
        &mut self,
        node: &JsonNode,
        what: &str,
        read: fn(&mut Self, &JsonNode, &str) -> Option<f64>,
    ) -> Option<Vec3> {
        match node.items() {
            Some(items @ [_, _, _]) => {
                let is_plain = |n: &JsonNode| matches!(n.value, Json::Number(x) if x.abs() <= LARGEST);
                let mut component = |n: &JsonNode, axis: &str| match is_plain(n) {
                    true => read(self, n, what),
                    false => read(self, n, &format!("the {axis} component of {what}")),
                };
                let read: Vec<Option<f64>> =
                    items.iter().zip(["x", "y", "z"]).map(|(n, axis)| component(n, axis)).collect();
                Some(Vec3::new(read[0]?, read[1]?, read[2]?))
            }
            Some(items) if !node.is_spoilt() => {
                let say = format!("{what} must have three numbers, not {}", items.len());
                self.error(codes::E0504, node.range, say);
                None
            }
            _ => self.wrong(node, what, "three numbers"),
        }
    }
}
