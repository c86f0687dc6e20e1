//! The joints of an asset, read and written: what of an object can be opened.

use super::json::{JsonNode, find};
use super::read::Reader;
use super::write::{Old, Out, number, numbers, text, triple};
use crate::{Joint, Motion, Part};
use scenelang_base::codes;
use smol_str::SmolStr;

/// An axis shorter than this has no direction.
const SHORTEST: f64 = 1e-6;
/// More joints than this no object has.
const MOST: usize = 64;

impl Reader<'_, '_> {
    /// The joints of an object, which has these parts; all are read before giving up, so that all errors are told.
    pub(super) fn joints(&mut self, node: &JsonNode, name: &str, parts: &[Part]) -> Option<Vec<Joint>> {
        let what = format!("`joints` of `{name}`");
        let Some(items) = node.items() else { return self.wrong(node, &what, "an array") };
        if items.len() > MOST {
            self.error(codes::E0505, node.range, format!("{what} has {} entries, more than {MOST}", items.len()));
            return None;
        }
        let mut taken: Vec<usize> = Vec::new();
        let mut names: Vec<SmolStr> = Vec::new();
        let read: Vec<Option<Joint>> =
            items.iter().map(|item| self.joint(item, name, parts.len(), &mut taken, &mut names)).collect();
        read.into_iter().collect()
    }

    /// One joint. `taken` are the parts that move already, `names` the names that are given already.
    fn joint(
        &mut self,
        node: &JsonNode,
        name: &str,
        parts: usize,
        taken: &mut Vec<usize>,
        names: &mut Vec<SmolStr>,
    ) -> Option<Joint> {
        let owner = format!("a joint of `{name}`");
        let what = |key: &str| format!("`{key}` of {owner}");
        let members = self.members(node, &owner)?;
        let called = self.required(node, members, "name", &owner).and_then(|n| self.joint_name(n, &owner, names));
        let motion = self.required(node, members, "motion", &owner).and_then(|n| {
            let said = self.text(n, &what("motion"))?;
            let motion = [Motion::Hinge, Motion::Slide].into_iter().find(|motion| motion.name() == said);
            if motion.is_none() {
                let say = format!("{} is \"hinge\" or \"slide\", not {said:?}", what("motion"));
                self.error(codes::E0504, n.range, say);
            }
            motion
        });
        let moved = self.required(node, members, "parts", &owner).and_then(|n| self.moved(n, &owner, parts, taken));
        let axis = self.required(node, members, "axis", &owner).and_then(|n| {
            let axis = self.triple(n, &what("axis"))?;
            if axis.norm() < SHORTEST {
                self.error(codes::E0505, n.range, format!("{} has no direction", what("axis")));
                return None;
            }
            Some(axis)
        });
        let anchor = self.required(node, members, "anchor", &owner).and_then(|n| self.triple(n, &what("anchor")));
        let limits = self.required(node, members, "limits", &owner).and_then(|n| self.limits(n, &what("limits")));
        let useful = find(members, "useful").map(|m| self.useful(&m.node, &what("useful"), limits));
        let handle = find(members, "handle").map(|m| self.triple(&m.node, &what("handle")));
        Some(Joint {
            name: called?,
            motion: motion?,
            axis: axis?,
            anchor: anchor?,
            limits: limits?,
            useful: useful.map_or(Some(None), |read| read.map(Some))?,
            handle: handle.map_or(Some(None), |read| read.map(Some))?,
            parts: moved?,
        })
    }

    fn joint_name(&mut self, node: &JsonNode, owner: &str, names: &mut Vec<SmolStr>) -> Option<SmolStr> {
        let name = SmolStr::from(self.text(node, &format!("`name` of {owner}"))?);
        if name.trim().is_empty() || names.contains(&name) {
            let wrong = if names.contains(&name) { "is already the name of another joint" } else { "is empty" };
            self.error(codes::E0505, node.range, format!("`name` of {owner} {wrong}"));
            return None;
        }
        names.push(name.clone());
        Some(name)
    }

    /// Which parts move: at least one, each in one joint only.
    fn moved(&mut self, node: &JsonNode, owner: &str, parts: usize, taken: &mut Vec<usize>) -> Option<Vec<usize>> {
        let what = format!("`parts` of {owner}");
        let Some(items) = node.items() else { return self.wrong(node, &what, "an array of indices of parts") };
        if items.is_empty() {
            self.error(codes::E0505, node.range, format!("{what} names no part"));
            return None;
        }
        let mut found = Vec::with_capacity(items.len());
        for item in items {
            let index = self.number(item, &what)?;
            if index.fract() != 0.0 || !(0.0..parts as f64).contains(&index) {
                let say = format!("{what} takes indices of its {parts} parts, counted from 0, not {index}");
                self.error(codes::E0505, item.range, say);
                return None;
            }
            let index = index as usize;
            if taken.contains(&index) {
                self.error(
                    codes::E0505,
                    item.range,
                    format!("part {index} of {owner} already moves with another joint"),
                );
                return None;
            }
            taken.push(index);
            found.push(index);
        }
        Some(found)
    }

    fn limits(&mut self, node: &JsonNode, what: &str) -> Option<[f64; 2]> {
        let Some([low, high]) = node.items() else { return self.wrong(node, what, "two numbers") };
        let (low, high) = (self.length(low, what)?, self.length(high, what)?);
        if low > 0.0 || high <= 0.0 {
            let say = format!("{what} must be the minimum opening, at most 0, and the maximum opening, greater than 0");
            self.error(codes::E0505, node.range, say);
            return None;
        }
        Some([low, high])
    }

    fn useful(&mut self, node: &JsonNode, what: &str, limits: Option<[f64; 2]>) -> Option<f64> {
        let useful = self.extent(node, what)?;
        if let Some([_, high]) = limits
            && useful > high
        {
            self.error(codes::E0505, node.range, format!("{what} exceeds the maximum opening, {high}"));
            return None;
        }
        Some(useful)
    }
}

/// A joint as it is written.
pub(super) fn joint<'a>(joint: &Joint, old: Old<'a>) -> Out<'a> {
    let parts: Vec<f64> = joint.parts.iter().map(|index| *index as f64).collect();
    Out::Object(old.merged(vec![
        ("name", Some(text(&joint.name))),
        ("motion", Some(text(joint.motion.name()))),
        ("parts", Some(numbers(&parts))),
        ("axis", Some(triple(&joint.axis))),
        ("anchor", Some(triple(&joint.anchor))),
        ("limits", Some(numbers(&joint.limits))),
        ("useful", joint.useful.map(number)),
        ("handle", joint.handle.as_ref().map(triple)),
    ]))
}
