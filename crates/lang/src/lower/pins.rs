//! Assignments to `pos`, `rot`, `scale`, `vertices`, `dimensions`: rows of the report, and values for who sets them.

use super::{Lowered, Lowerer, Poison, Val};
use crate::ast::StmtKind;
use crate::check::cycles::{circles, report};
use crate::items::{AssignKey, ItemKind, Items, Located, whole_number};
use crate::program::*;
use rustc_hash::{FxHashMap, FxHashSet};
use scenelang_base::{Diagnostic, Span, codes};
use smol_str::{SmolStr, format_smolstr};

impl<'a> Lowerer<'a, '_> {
    /// One row for the statement; it may pin all elements of an array.
    pub(super) fn assignment(&mut self, place: Located<'a>) -> Lowered<()> {
        let StmtKind::Assign { name, index, path, value, .. } = &place.stmt.kind else { return Ok(()) };
        let [property] = path.as_slice() else { return Ok(()) };
        let item = self.items.names.get(&name.text).ok_or(Poison)?;
        let owners: Vec<(Owner, Option<u32>)> = match (item.kind, index) {
            (ItemKind::Region, _) => vec![(Owner::Region(*self.regions.get(&name.text).ok_or(Poison)?), None)],
            (ItemKind::Object, _) => vec![(Owner::Object(self.objects[&name.text][0]), None)],
            (ItemKind::Array(_), Some(i)) => {
                let i = whole_number(place.stmt, *i).ok_or(Poison)? as u32;
                vec![(Owner::Object(self.objects[&name.text][i as usize]), Some(i))]
            }
            (ItemKind::Array(n), None) => {
                (0..n).map(|i| (Owner::Object(self.objects[&name.text][i as usize]), Some(i))).collect()
            }
            (ItemKind::Variable(_), _) => return Ok(()),
        };
        let pinned = match property.text.as_str() {
            "pos" => Pinned::Pos,
            "rot" => Pinned::Rot,
            "scale" | "dimensions" => Pinned::Scale,
            "vertices" => Pinned::Vertices,
            _ => return Ok(()),
        };
        let row = self.program.constraints.len();
        self.in_frame(place, String::new(), |l| {
            let mut members = Vec::new();
            let mut pins = Vec::new();
            for (owner, element) in owners {
                let scale_too = AssignKey { name: name.text.clone(), element, property: "scale".into() };
                if property.text == "dimensions" && l.items.assignments.contains_key(&scale_too) {
                    continue;
                }
                // Each element draws its own random numbers.
                l.f.draw_key = format!("{}.{}", l.owner_name(owner), property.text);
                l.f.draw_count = 0;
                let value = l.lower(*value)?;
                members.push(l.pin_formula(owner, pinned, &value, place)?);
                let values = match &value {
                    Val::Vec(n) | Val::Rot(n) => vec![l.f.b.extract(*n)],
                    Val::Polygon(points) => points.iter().map(|n| l.f.b.extract(*n)).collect(),
                    _ => return Err(Poison),
                };
                pins.push(Pin { owner, property: pinned, values, constraint: row });
            }
            if members.is_empty() {
                return Ok(());
            }
            let root = l.f.b.junction(true, &members, place.stmt.range);
            l.constraint(place, ConstraintKind::Pin, "", root);
            l.program.pins.append(&mut pins);
            Ok(())
        })
    }

    fn owner_name(&self, owner: Owner) -> SmolStr {
        match owner {
            Owner::Object(id) => self.program.objects[id.0 as usize].name.clone(),
            Owner::Region(id) => self.program.regions[id.0 as usize].name.clone(),
        }
    }

    fn pin_formula(&mut self, owner: Owner, pinned: Pinned, value: &Val, place: Located<'a>) -> Lowered<NodeId> {
        let range = place.stmt.range;
        let b = &mut self.f.b;
        let read = match (owner, pinned) {
            (Owner::Object(id), Pinned::Pos) => Node::Object(ObjectProperty::Pos, id),
            (Owner::Object(id), Pinned::Rot) => Node::Object(ObjectProperty::Rot, id),
            (Owner::Object(id), _) => Node::Object(ObjectProperty::Scale, id),
            (Owner::Region(id), Pinned::Pos) => Node::Region(RegionProperty::Pos, id),
            (Owner::Region(id), Pinned::Rot) => Node::Region(RegionProperty::Rot, id),
            (Owner::Region(id), Pinned::Scale) => Node::Region(RegionProperty::Scale, id),
            (Owner::Region(id), Pinned::Vertices) => {
                let Val::Polygon(points) = value else { return Err(Poison) };
                return Ok(b.add(Node::SamePolygon(id, points.iter().copied().collect()), range));
            }
        };
        let (Val::Vec(value) | Val::Rot(value)) = value else { return Err(Poison) };
        let read = b.add(read, range);
        // The polygon says where a region with vertices is; only the heights of its pos and scale count.
        if let (Owner::Region(id), Pinned::Pos | Pinned::Scale) = (owner, pinned)
            && self.program.regions[id.0 as usize].has_vertices
        {
            let l = self.f.b.component(Axis::Y, read, range);
            let r = self.f.b.component(Axis::Y, *value, range);
            return Ok(self.f.b.add(Node::Compare(Comparison::Eq, Unit::Metre, l, r), range));
        }
        Ok(self.f.b.add(Node::Same(read, *value), range))
    }
}

/// Circles among assigned properties: `a.pos <- b.pos + …; b.pos <- a.pos + …;`.
pub(super) fn cycles(program: &Program, items: &Items<'_>) -> Vec<Diagnostic> {
    let name = |owner: Owner, property: Pinned| {
        let owner = match owner {
            Owner::Object(id) => &program.objects[id.0 as usize].name,
            Owner::Region(id) => &program.regions[id.0 as usize].name,
        };
        let property = match property {
            Pinned::Pos => "pos",
            Pinned::Rot => "rot",
            Pinned::Scale => "scale",
            Pinned::Vertices => "vertices",
        };
        format_smolstr!("{owner}.{property}")
    };
    let assigned: FxHashSet<SmolStr> = program.pins.iter().map(|p| name(p.owner, p.property)).collect();
    let place = |n: &SmolStr| {
        let (base, property) = n.rsplit_once('.')?;
        let (base, element) = match base.split_once('[') {
            Some((b, i)) => (b, i.trim_end_matches(']').parse().ok()),
            None => (base, None),
        };
        let find = |p: &str| items.assignments.get(&AssignKey { name: base.into(), element, property: p.into() });
        let a = find(property).or_else(|| find("dimensions"))?;
        a.place.span(a.target)
    };
    let mut order = Vec::new();
    let mut edges: Vec<Vec<SmolStr>> = Vec::new();
    // Elements assigned by the name of their array share its place; the number tells them apart.
    let mut defined: FxHashMap<SmolStr, (Span, usize)> = FxHashMap::default();
    for pin in &program.pins {
        let mut reads = Vec::new();
        for node in pin.values.iter().flat_map(|f| &f.nodes) {
            for (owner, property) in reads_of(node) {
                let n = name(owner, property);
                if assigned.contains(&n) && !reads.contains(&n) {
                    reads.push(n);
                }
            }
        }
        let n = name(pin.owner, pin.property);
        if let Some(span) = place(&n)
            && !reads.is_empty()
        {
            defined.insert(n.clone(), (span, order.len()));
            order.push(n);
            edges.push(reads);
        }
    }
    let found = circles(&order, |n| defined.get(n).copied(), |(_, i)| &edges[i]);
    found.iter().filter_map(|c| report(c, |(span, _)| Some(span), codes::E0204, "properties")).collect()
}

/// The pinnable properties that a node depends on.
fn reads_of(node: &Node) -> Vec<(Owner, Pinned)> {
    use Pinned::{Pos, Rot, Scale, Vertices};
    let of = |owner: Owner, list: &[Pinned]| list.iter().map(|p| (owner, *p)).collect();
    match node {
        Node::Object(p, id) => of(
            Owner::Object(*id),
            match p {
                ObjectProperty::Pos => &[Pos],
                ObjectProperty::Scale => &[Scale],
                ObjectProperty::Rot | ObjectProperty::Front | ObjectProperty::Right | ObjectProperty::Up => &[Rot],
                _ => &[Pos, Rot, Scale],
            },
        ),
        Node::Region(p, id) => of(
            Owner::Region(*id),
            match p {
                RegionProperty::Pos | RegionProperty::Floor => &[Pos],
                RegionProperty::Rot => &[Rot],
                RegionProperty::Scale => &[Scale],
                RegionProperty::Ceiling => &[Pos, Scale],
                RegionProperty::Area => &[Scale, Vertices],
                RegionProperty::Center => &[Pos, Rot, Scale, Vertices],
            },
        ),
        Node::BuiltIn(_, args) => args
            .iter()
            .flat_map(|a| match a {
                Arg::Object(id) => of(Owner::Object(*id), &[Pos, Rot, Scale]),
                Arg::Region(id) => of(Owner::Region(*id), &[Pos, Rot, Scale, Vertices]),
                _ => Vec::new(),
            })
            .collect(),
        _ => Vec::new(),
    }
}
