//! Which boxes of known size are said to be in one region of known size, so that they may be too many for it.

use super::model::Common;
use super::unknowns::is_box;
use super::usual::Usual;
use crate::eval::{Value, cone};
use rustc_hash::FxHashMap;
use scenelang_lang::program::{Formula, Node, NodeId, ObjectId, Owner, Pinned, RegionId};
use std::collections::BTreeSet;

/// Boxes of known size in a rectangular region of known size.
pub(super) struct Company {
    pub region: RegionId,
    pub objects: Vec<ObjectId>,
    /// Whether they take up much of it.
    pub full: bool,
}

/// The companies that statements make.
pub(super) fn companies(common: &Common<'_>, usual: Option<&Usual>, statements: &[usize]) -> Vec<Company> {
    let Common { program, options, scope, .. } = common;
    let mut sizes = nominal_sizes(common, statements);
    let mut said: BTreeSet<(RegionId, ObjectId)> = BTreeSet::new();
    for &index in statements {
        said.extend(insides(&program.constraints[index].formula));
        said.extend(counted_insides(&program.constraints[index].formula));
    }
    if program.regions.len() == 1 && options.physics {
        let all = statements.iter().flat_map(|s| program.constraints[*s].formula.objects());
        said.extend(all.filter(|o| scope.bounds(*o)).map(|o| (RegionId(0), o)));
    }
    for &(_, object) in &said {
        if let Some(size) = usual.and_then(|usual| usual.size[object.0 as usize]) {
            sizes.insert(Owner::Object(object), size);
        }
    }
    let mut out = Vec::new();
    for region in (0..program.regions.len() as u32).map(RegionId) {
        let Some(room) = sizes.get(&Owner::Region(region)) else { continue };
        let objects: Vec<ObjectId> = said
            .range((region, ObjectId(0))..=(region, ObjectId(u32::MAX)))
            .map(|(_, object)| *object)
            .filter(|o| sizes.contains_key(&Owner::Object(*o)) && (usual.is_some() || is_box(program, options, *o)))
            .collect();
        let footprint = |o: &ObjectId| sizes.get(&Owner::Object(*o)).map_or(0.0, |s| s[0] * s[2]);
        let full = objects.iter().map(footprint).sum::<f64>() >= 0.5 * room[0] * room[2];
        if objects.len() > 1 {
            out.push(Company { region, objects, full });
        }
    }
    out
}

/// The statements about each company that takes up much of its region: worth a look of their own.
pub(super) fn crowds(common: &Common<'_>, usual: Option<&Usual>, statements: &[usize]) -> Vec<Vec<usize>> {
    let full = companies(common, usual, statements).into_iter().filter(|c| c.full);
    full.map(|company| {
        let about = |s: &usize| {
            let objects = common.program.constraints[*s].formula.objects();
            objects.iter().all(|o| company.objects.binary_search(o).is_ok())
        };
        statements.iter().copied().filter(about).collect()
    })
    .collect()
}

/// Sizes that statements assign as constants.
pub(super) fn nominal_sizes(common: &Common<'_>, statements: &[usize]) -> FxHashMap<Owner, [f64; 3]> {
    let mut out = FxHashMap::default();
    for pin in common
        .program
        .pins
        .iter()
        .filter(|p| p.property == Pinned::Scale && statements.binary_search(&p.constraint).is_ok())
    {
        if let Some(Ok(Value::Vector(size))) = pin.values.first().map(|f| crate::eval::evaluate(f, &common.nowhere)) {
            out.insert(pin.owner, size.0);
        }
    }
    out
}

/// What a formula says at its top level to be inside a region.
pub(super) fn insides(formula: &Formula) -> Vec<(RegionId, ObjectId)> {
    let mut out = Vec::new();
    let mut open = vec![formula.root];
    while let Some(id) = open.pop() {
        match formula.node(id) {
            Node::And(parts) => open.extend(parts.iter().copied()),
            Node::BuiltIn(built_in, args) => {
                out.extend(built_in.contained(args).map(|(object, region)| (region, object)));
            }
            _ => {}
        }
    }
    out
}

/// What a formula counts that is inside a region.
fn counted_insides(formula: &Formula) -> Vec<(RegionId, ObjectId)> {
    let ids = (0..formula.nodes.len() as u32).map(NodeId);
    let counts = ids.filter(|id| matches!(formula.node(*id), Node::Count(_) | Node::AtLeast(..)));
    let contained = counts.flat_map(|id| cone(formula, id)).filter_map(|id| match formula.node(id) {
        Node::BuiltIn(built_in, args) => built_in.contained(args).map(|(object, region)| (region, object)),
        _ => None,
    });
    contained.collect()
}
