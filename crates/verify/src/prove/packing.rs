//! Boxes that must not collide in a region that is too small for them together.
//!
//! The rule speaks only of objects whose solid is their box: asset parts may leave room (a chair under a table), so an
//! object with a `category`, or with the name of a piece of furniture, is left out unless every solid is its box.
//!
//! Boxes that do not collide overlap by at most the contact tolerance along some direction. Made smaller by half of
//! that on every side they do not overlap at all: along a unit vector u a box then reaches less far by half the
//! tolerance times Σ|uᵢ|, which is at least 1. So their volumes add up, and must fit into the region, made larger by its
//! own tolerance. If all of them are cut by one horizontal plane, so do the areas of the cuts.

use super::interval::Interval;
use super::problem::{Affine, Problem};
use super::state::{Conflict, EventId, Rule, State, What};
use super::tape::{Claim, Term};

/// A box that may stand in a region, by terms.
#[derive(Clone, Copy, Debug)]
pub(super) struct Member<T> {
    /// That it is inside.
    pub inside: Claim,
    pub size: [T; 3],
    pub bottom: T,
    pub top: T,
    /// Height of its up axis: 1 where it stands upright.
    pub up: T,
}

/// A rectangular region and the boxes that may stand in it.
#[derive(Clone, Debug)]
pub(super) struct Group<T> {
    pub size: [T; 3],
    pub members: Vec<Member<T>>,
    /// Pairs of members that may overlap all the same, sorted.
    pub excepted: Vec<(usize, usize)>,
    /// That nothing else may.
    pub apart: Claim,
}

/// The groups of a problem.
#[derive(Clone, Debug, Default)]
pub(super) struct Packing {
    groups: Vec<Group<Affine>>,
    /// How far boxes may overlap, and stick out of a region on each side (metres).
    contact: f64,
}

/// How far from upright a box may be to have a footprint here: the sine of the tilt.
const TILT: f64 = 0.01;

impl Packing {
    /// Groups in terms of a problem.
    pub fn new(groups: &[Group<Term>], problem: &Problem, contact: f64) -> Self {
        let at = |term: Term| problem.terms[term.0 as usize];
        let all = |terms: [Term; 3]| Some([at(terms[0])?, at(terms[1])?, at(terms[2])?]);
        let group = |group: &Group<Term>| {
            let member = |m: &Member<Term>| {
                Some(Member {
                    inside: m.inside,
                    size: all(m.size)?,
                    bottom: at(m.bottom)?,
                    top: at(m.top)?,
                    up: at(m.up)?,
                })
            };
            let members = group.members.iter().map(member).collect::<Option<Vec<_>>>()?;
            Some(Group { size: all(group.size)?, members, excepted: group.excepted.clone(), apart: group.apart })
        };
        Self { groups: groups.iter().filter_map(group).collect(), contact }
    }

    /// A conflict where the boxes that are known to be in a region are too much for it.
    pub fn check(&self, state: &mut State) -> Result<(), Conflict> {
        for group in &self.groups {
            let inside: Vec<usize> =
                (0..group.members.len()).filter(|&i| state.is_true(group.members[i].inside)).collect();
            state.work += group.members.len() as u64;
            if inside.is_empty() {
                continue;
            }
            if !state.is_true(group.apart) {
                continue;
            }
            // Only those that keep clear of all the others count; whoever may overlap another is left out.
            let mut count: Vec<usize> = Vec::new();
            for &i in &inside {
                if group.excepted.is_empty() || count.iter().all(|&k| group.excepted.binary_search(&(k, i)).is_err()) {
                    count.push(i);
                }
            }
            let reasons = [state.verdict_why[group.apart.index()]];
            state.work += count.len() as u64 * 8;
            self.volumes(group, &count, &reasons, state)?;
            self.areas(group, &count, &reasons, state)?;
        }
        Ok(())
    }

    fn volumes(
        &self,
        group: &Group<Affine>,
        count: &[usize],
        reasons: &[EventId],
        state: &mut State,
    ) -> Result<(), Conflict> {
        let room = group.size.map(|s| of(state, s) + Interval::point(2.0 * self.contact));
        let room = room[0] * room[1] * room[2];
        let mut sum = Interval::point(0.0);
        let mut why = reasons.to_vec();
        for &i in count {
            let member = &group.members[i];
            let size = member.size.map(|s| smaller(of(state, s), self.contact));
            sum = sum + size[0] * size[1] * size[2];
            why.push(state.verdict_why[member.inside.index()]);
            why.extend(member.size.iter().map(|s| lower(state, *s)));
        }
        why.extend(group.size.iter().map(|s| upper(state, *s)));
        if sum.lo > room.hi { Err(Conflict(state.event(What::Conflict(Rule::Packing), &why))) } else { Ok(()) }
    }

    fn areas(
        &self,
        group: &Group<Affine>,
        count: &[usize],
        reasons: &[EventId],
        state: &mut State,
    ) -> Result<(), Conflict> {
        let upright: Vec<usize> = count
            .iter()
            .copied()
            .filter(|&i| of(state, group.members[i].up).lo >= (1.0 - TILT * TILT).sqrt())
            .collect();
        if upright.is_empty() {
            return Ok(());
        }
        let mut why = reasons.to_vec();
        // One plane cuts all: where the highest bottom is below the lowest top; or where any two are together higher than
        // the region, so that their heights overlap (and intervals that overlap pairwise have a point in common).
        let bottom = upright.iter().map(|&i| of(state, group.members[i].bottom).hi).fold(f64::NEG_INFINITY, f64::max);
        let top = upright.iter().map(|&i| of(state, group.members[i].top).lo).fold(f64::INFINITY, f64::min);
        if bottom < top - 4.0 * self.contact {
            for &i in &upright {
                why.extend([upper(state, group.members[i].bottom), lower(state, group.members[i].top)]);
            }
        } else {
            let mut heights: Vec<f64> = upright.iter().map(|&i| inner(state, &group.members[i], 1)).collect();
            heights.sort_by(f64::total_cmp);
            let room = of(state, group.size[1]).hi + 4.0 * self.contact;
            if heights.len() > 1 && heights[0] + heights[1] <= room {
                return Ok(());
            }
            why.push(upper(state, group.size[1]));
        }
        let room = [0, 2].map(|i| of(state, group.size[i]) + Interval::point(2.0 * self.contact));
        let mut sum = Interval::point(0.0);
        for &i in &upright {
            let member = &group.members[i];
            let size = [0, 2].map(|k| smaller(Interval::from(inner(state, member, k)), self.contact));
            sum = sum + size[0] * size[1];
            why.push(state.verdict_why[member.inside.index()]);
            why.push(lower(state, member.up));
            for s in member.size {
                why.extend([lower(state, s), upper(state, s)]);
            }
        }
        why.extend([upper(state, group.size[0]), upper(state, group.size[2])]);
        let full = sum.lo > (room[0] * room[1]).hi;
        if full { Err(Conflict(state.event(What::Conflict(Rule::Packing), &why))) } else { Ok(()) }
    }
}

fn of(state: &State, term: Affine) -> Interval {
    term.of(state.domain[term.var as usize])
}

fn lower(state: &State, term: Affine) -> EventId {
    state.why[term.var as usize][usize::from(term.minus)]
}

fn upper(state: &State, term: Affine) -> EventId {
    state.why[term.var as usize][usize::from(!term.minus)]
}

/// A size less the tolerance, if anything is left of it.
fn smaller(size: Interval, contact: f64) -> Interval {
    (size - Interval::point(contact)).max(Interval::point(0.0))
}

/// An extent of an upright box of the same yaw inside a box that is tilted by little: each extent less the sine of the
/// tilt times the others, at least.
fn inner(state: &State, member: &Member<Affine>, axis: usize) -> f64 {
    let up = of(state, member.up).lo.min(1.0);
    let tilt = (Interval::point(1.0) - Interval::point(up).square()).sqrt().hi;
    let others: f64 = (0..3).filter(|k| *k != axis).map(|k| of(state, member.size[k]).hi).sum();
    if tilt == 0.0 {
        return of(state, member.size[axis]).lo;
    }
    (Interval::point(of(state, member.size[axis]).lo) - Interval::point(others) * Interval::point(tilt)).lo
}
