//! Two things that are to be farther from each other than the floor allows, and things for which it has no place at all.
//!
//! If one comes within a distance of a point wherever it stands, and the other within another distance of the same point,
//! they are no farther from each other than both together.

use super::packing::{Between, Packing, PackingRegion, is_upright, known_of, lower, of, short, upper};
use super::probes::{self, ProbeBox};
use super::problem::{Affine, Problem};
use super::state::{Conflict, EventId, EventKind, Rule, State};

/// So many steps to the least distance from a point.
const STEPS: usize = 10;
/// Of more members than this no two are looked at.
const MOST: usize = 24;

impl Packing<'_> {
    /// A conflict where two upright members cannot be as far from each other as they are told to.
    pub(super) fn too_far(
        &self,
        problem: &Problem,
        index: usize,
        inside: &[usize],
        state: &mut State,
    ) -> Result<(), Conflict> {
        let group = &self.groups[index];
        let floor = [0, 2].map(|i| of(state, group.size[i]).hi);
        if group.members.len() > MOST || !group.straight || floor.iter().any(|f| !f.is_finite()) {
            return Ok(());
        }
        for between in group.between.iter().filter(|b| !b.of_centres) {
            let pair = [between.pair.0, between.pair.1];
            let Some(apart) = self.apart_seen_from_above(group, between, state) else { continue };
            let diagonal =
                |i: usize| [0, 2].map(|k| of(state, group.members[i].size[k]).lo).into_iter().fold(0.0, f64::hypot);
            let whole = floor[0].hypot(floor[1]);
            if !pair.iter().all(|i| inside.contains(i)) || apart < whole - diagonal(pair[0]) - diagonal(pair[1]) {
                continue;
            }
            let Some(first) = self.nearest(problem, (index, pair[0]), apart, state) else { continue };
            let left = apart - first - 3.0 * self.contact;
            if left <= 0.0 || !self.comes_within(problem, (index, pair[1]), left, state) {
                continue;
            }
            let mut why: Vec<EventId> = vec![lower(state, between.length)];
            for i in pair {
                let heights = group.members[i].core.iter().flat_map(|core| [core.bottom, core.top]);
                why.extend(heights.flat_map(|t| [lower(state, t), upper(state, t)]));
                why.extend(self.placed(problem, (index, i), state));
            }
            let [a, b] = pair.map(|i| self.name(group, i));
            let [w, d] = floor.map(short);
            self.say(format!(
                "`{a}` and `{b}` cannot be {} m apart on a floor of {w} × {d} m",
                short(of(state, between.length).lo)
            ));
            return Err(Conflict(state.event(EventKind::Conflict(Rule::Packing), &why)));
        }
        Ok(())
    }

    /// The distance that two keep, seen from above, if both are solid about their middles.
    fn apart_seen_from_above(
        &self,
        group: &PackingRegion<Affine>,
        between: &Between<Affine>,
        state: &State,
    ) -> Option<f64> {
        let [a, b] = [between.pair.0, between.pair.1].map(|i| &group.members[i]);
        let (p, q) = (a.core?, b.core?);
        let upright = [a, b].iter().all(|m| is_upright(state, m) && of(state, m.up).lo >= 1.0);
        let above = |p: Affine, q: Affine| of(state, p).hi - of(state, q).lo;
        let height = above(p.bottom, q.top).max(above(q.bottom, p.top)).max(0.0);
        let length = of(state, between.length).lo;
        (upright && length > height).then(|| (length * length - height * height).sqrt())
    }

    /// How near a member comes to the middle of the floor wherever it stands, if that is less than `most`.
    fn nearest(&self, problem: &Problem, member: (usize, usize), most: f64, state: &mut State) -> Option<f64> {
        if !self.comes_within(problem, member, most, state) {
            return None;
        }
        let (mut lo, mut hi) = (0.0, most);
        for _ in 0..STEPS {
            let mid = (lo + hi) / 2.0;
            if self.comes_within(problem, member, mid, state) { hi = mid } else { lo = mid }
        }
        Some(hi)
    }

    fn comes_within(&self, problem: &Problem, (index, i): (usize, usize), distance: f64, state: &mut State) -> bool {
        let group = &self.groups[index];
        let floor = [0, 2].map(|i| of(state, group.size[i]).hi + 2.0 * self.contact);
        let kind = self.kind(group, &group.members[i], Some((2.0 * distance, false)), state);
        self.covers(problem, (index, i), floor, &kind, &vec![[0.0; 2]], state)
    }

    /// A conflict where statements about a member alone leave it no place in its region.
    pub(super) fn nowhere(
        &self,
        problem: &Problem,
        index: usize,
        inside: &[usize],
        state: &mut State,
    ) -> Result<(), Conflict> {
        let group = &self.groups[index];
        let floor = [0, 2].map(|i| of(state, group.size[i]).hi + 2.0 * self.contact);
        if !group.straight || floor.iter().any(|f| !f.is_finite()) {
            return Ok(());
        }
        for &i in inside {
            let member = &group.members[i];
            if of(state, member.up).lo < 1.0 || self.placing(problem, (index, i)).claims.is_empty() {
                continue;
            }
            let kind: ProbeBox = self.kind(group, member, None, state);
            if !self.covers(problem, (index, i), floor, &kind, &probes::Points::new(), state) {
                continue;
            }
            let why = self.placed(problem, (index, i), state);
            self.unsaid();
            return Err(Conflict(state.event(EventKind::Conflict(Rule::Packing), &why)));
        }
        Ok(())
    }

    /// What it rests on where a member stands in its region.
    fn placed(&self, problem: &Problem, (index, i): (usize, usize), state: &State) -> Vec<EventId> {
        let (group, member) = (&self.groups[index], &self.groups[index].members[i]);
        let mut why: Vec<EventId> = known_of(state, member).collect();
        why.extend(member.turn.iter().flat_map(|t| [lower(state, *t), upper(state, *t)]));
        why.extend(self.placing(problem, (index, i)).reasons(state));
        why.extend([upper(state, group.size[0]), upper(state, group.size[2])]);
        why
    }
}
