//! Which statements are looked at together, where the whole of a program is too much to find its contradictions in.

use super::companies::insides;
use super::minimal::{Thing, things};
use super::model::{Common, regions_of};
use rustc_hash::{FxHashMap, FxHashSet};
use scenelang_lang::program::{BuiltIn, ConstraintKind, Node, ObjectId, Owner, Pinned, Program, RegionId};
use std::collections::{BTreeMap, BTreeSet};

/// Statements in parts that have nothing to do with each other: they share no object, no variable, and no region but
/// such as stand fast, by assigned places and sizes. What is said of those alone goes with every part that speaks of them,
/// or of something that may be in any region; the rest of it is a part of its own.
pub(super) fn parts(common: &Common<'_>, among: &[usize]) -> Vec<Vec<usize>> {
    let program = common.program;
    let pinned = |region: RegionId, property: Pinned| {
        program.pins.iter().any(|p| {
            p.owner == Owner::Region(region) && p.property == property && among.binary_search(&p.constraint).is_ok()
        })
    };
    let fast: Vec<bool> = (0..program.regions.len() as u32)
        .map(|r| [Pinned::Pos, Pinned::Scale].into_iter().all(|p| pinned(RegionId(r), p)))
        .collect();
    let joins = |thing: &Thing| !matches!(thing, Thing::Region(r) if fast[*r as usize]);
    let mut part_of: FxHashMap<Thing, usize> = FxHashMap::default();
    let mut parts: Vec<Vec<usize>> = Vec::new();
    let mut ground = Vec::new();
    for &statement in among {
        let things: Vec<Thing> = things(&program.constraints[statement].formula).into_iter().filter(joins).collect();
        if things.is_empty() {
            ground.push(statement);
            continue;
        }
        // The first part of those that it joins takes in the others.
        let mut joined: Vec<usize> = things.iter().filter_map(|t| part_of.get(t).copied()).collect();
        joined.sort_unstable();
        joined.dedup();
        let own = joined.first().copied().unwrap_or(parts.len());
        if own == parts.len() {
            parts.push(Vec::new());
        }
        for &other in joined.iter().skip(1) {
            let taken = std::mem::take(&mut parts[other]);
            parts[own].extend(taken);
            part_of.values_mut().filter(|p| **p == other).for_each(|p| *p = own);
        }
        parts[own].push(statement);
        part_of.extend(things.into_iter().map(|t| (t, own)));
    }
    parts.retain(|p| !p.is_empty());
    if parts.is_empty() {
        return vec![ground];
    }
    let ground: Vec<(usize, Vec<RegionId>)> =
        ground.into_iter().map(|s| (s, regions_of(&program.constraints[s].formula))).collect();
    let mut apart = vec![true; ground.len()];
    for part in &mut parts {
        let goes_with = ground_of(common, part, &ground);
        for ((ground, goes_with), apart) in ground.iter().zip(goes_with).zip(&mut apart) {
            if goes_with {
                part.push(ground.0);
                *apart = false;
            }
        }
        part.sort_unstable();
    }
    let rest: Vec<usize> = ground.iter().zip(apart).filter(|(_, apart)| *apart).map(|(ground, _)| ground.0).collect();
    parts.extend((!rest.is_empty()).then_some(rest));
    parts
}

/// What several assertions say of one object and of no other, with what is assigned to it: in a large program it is seen here
/// that two of them contradict each other.
pub(super) fn alone(program: &Program, among: &[usize]) -> Vec<Vec<usize>> {
    let mut of: BTreeMap<u32, (Vec<usize>, usize)> = BTreeMap::new();
    for &statement in among {
        let constraint = &program.constraints[statement];
        if let [object] = constraint.formula.objects()[..] {
            let (own, asserted) = of.entry(object.0).or_default();
            own.push(statement);
            *asserted += usize::from(constraint.kind == ConstraintKind::Assert);
        }
    }
    of.into_values().filter(|(_, asserted)| *asserted > 1).map(|(own, _)| own).collect()
}

/// Which of the statements that speak of regions only goes with a part: those of the regions that it speaks of, and of
/// regions that these are compared with.
fn ground_of(common: &Common<'_>, part: &[usize], ground: &[(usize, Vec<RegionId>)]) -> Vec<bool> {
    let formulas = || part.iter().map(|s| &common.program.constraints[*s].formula);
    let looks = |n: &Node| matches!(n, Node::BuiltIn(BuiltIn::Clear | BuiltIn::Reachable, _));
    let inside: FxHashSet<_> = formulas().flat_map(insides).map(|(_, object)| object).collect();
    // P-BOUNDS speaks of all regions where nothing says in which one something is.
    let is_anywhere = |object| common.options.physics && common.scope.bounds(object) && !inside.contains(&object);
    let everywhere = formulas().any(|f| f.nodes.iter().any(looks) || f.objects().into_iter().any(is_anywhere));
    if everywhere {
        return vec![true; ground.len()];
    }
    let mut regions: FxHashSet<RegionId> = formulas().flat_map(regions_of).collect();
    loop {
        let before = regions.len();
        for (_, own) in ground {
            if own.iter().any(|r| regions.contains(r)) {
                regions.extend(own);
            }
        }
        if regions.len() == before {
            break;
        }
    }
    ground.iter().map(|(_, own)| own.is_empty() || own.iter().any(|r| regions.contains(r))).collect()
}

/// So many things are few, and so many sets of few things are looked at.
const FEW: usize = 6;
const MOST_SETS: usize = 200;

/// What is said of a few things among themselves: of those that one assertion speaks of, of those that two assertions about
/// a common thing do, and of the members of an array. Whatever else is said in a large program, two or three statements that
/// contradict each other are seen here. Things that are said to be alike, or to stand in one room, are not related by that.
pub(super) fn few(program: &Program, among: &[usize]) -> Vec<Vec<usize>> {
    let objects: Vec<BTreeSet<ObjectId>> =
        among.iter().map(|s| program.constraints[*s].formula.objects().into_iter().collect()).collect();
    let asserted = |n: &usize| program.constraints[among[*n]].kind == ConstraintKind::Assert;
    let related: BTreeSet<&BTreeSet<ObjectId>> =
        (0..among.len()).filter(asserted).map(|n| &objects[n]).filter(|set| (1..=FEW).contains(&set.len())).collect();
    let mut sets: Vec<BTreeSet<ObjectId>> = related.iter().map(|set| (*set).clone()).collect();
    // Where two pairs have a thing in common, a third may close the triangle.
    for (n, a) in related.iter().enumerate() {
        for b in related.iter().skip(n + 1).filter(|b| a.len() > 1 && b.len() > 1 && !a.is_disjoint(b)) {
            let both: BTreeSet<ObjectId> = a.union(b).copied().collect();
            let closes = |c: &&&BTreeSet<ObjectId>| c.is_subset(&both) && !c.is_subset(a) && !c.is_subset(b);
            if both.len() <= FEW && related.iter().any(|c| closes(&c)) && sets.len() < MOST_SETS {
                sets.push(both);
            }
        }
    }
    let mut arrays: BTreeMap<&str, BTreeSet<ObjectId>> = BTreeMap::new();
    for id in objects.iter().flatten() {
        if let Some((array, _)) = &program.objects[id.0 as usize].array {
            arrays.entry(array.as_str()).or_default().insert(*id);
        }
    }
    sets.extend(arrays.into_values().filter(|set| set.len() > 1));
    sets.truncate(MOST_SETS);
    let mut looks: Vec<Vec<usize>> = Vec::new();
    for set in sets {
        let about = |n: &usize| objects[*n].is_subset(&set);
        let relates = |n: &usize| objects[*n].len() > 1 || !asserted(n);
        let own: Vec<usize> = (0..among.len()).filter(about).collect();
        // Without what is said of each alone, where it stands and what it is near to, that is less to look through.
        let relations: Vec<usize> = own.iter().copied().filter(relates).collect();
        for look in [relations, own] {
            let look: Vec<usize> = look.into_iter().map(|n| among[n]).collect();
            let asserted = look.iter().filter(|s| program.constraints[**s].kind == ConstraintKind::Assert).count();
            if asserted > 0 && look.len() < among.len() && !looks.contains(&look) {
                looks.push(look);
            }
        }
    }
    looks.sort_by_key(Vec::len);
    looks
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::prove::ProveOptions;
    use scenelang_lang::{Options, compile_text};
    use std::fmt::Write;
    use std::path::Path;

    /// The most statements that are looked at together in a house of so many rooms, with a thing in each.
    fn largest_part(rooms: usize) -> usize {
        let mut text = String::new();
        for i in 0..rooms {
            let x = 5 * i;
            write!(text, "region room{i}; room{i}.pos <- vec3({x}, 0, 0); room{i}.scale <- vec3(4, 2.6, 4);").unwrap();
            write!(text, "object box{i}; box{i}.dimensions <- vec3(1, 1, 1); assert inside(box{i}, room{i});").unwrap();
        }
        let compiled = compile_text("house.scene", Path::new("house.scene"), &text, Options::default());
        let program = compiled.program.unwrap();
        let all: Vec<usize> = (0..program.constraints.len()).collect();
        let options = ProveOptions::default();
        parts(&Common::new(&program, &options.judging), &all).iter().map(Vec::len).max().unwrap()
    }

    #[test]
    fn a_part_is_no_larger_where_there_are_more_rooms() {
        assert!(largest_part(1) > 2);
        assert_eq!(largest_part(2), largest_part(30));
    }
}
