//! Boxes that must not collide in a region that is too small for them together.
//!
//! The rule speaks only of objects whose solid is their box: asset parts may leave room (a chair under a table), so an
//! object with a `category`, or with the name of a piece of furniture, is left out unless every solid is its box.
//!
//! Boxes that do not collide overlap by at most the contact tolerance along some direction. Made smaller by half of
//! that on every side they do not overlap at all: along a unit vector u a box then reaches less far by half the
//! tolerance times Σ|uᵢ|, which is at least 1. So their volumes add up, and must fit into the region, made larger by its
//! own tolerance. If all of them are cut by one horizontal plane, so do the areas of the cuts; and no point of the floor
//! is in two of the cuts (`probes`), nor within half of the distance that they keep from each other.

use super::interval::Interval;
use super::placing::{MadeOf, Placing, conjuncts};
use super::probes::{self, ProbeBox};
use super::problem::{self, Affine, Problem, Var};
use super::state::{Conflict, EventId, EventKind, Rule, State};
use super::tape::{Claim, Term};
use rustc_hash::FxHashMap;
use std::cell::{OnceCell, RefCell};
use std::collections::BTreeSet;
use std::f64::consts::PI;

/// A box that may stand in a region, by terms.
#[derive(Clone, Copy, Debug)]
pub(super) struct Member<T> {
    pub inside: Claim,
    pub size: [T; 3],
    pub bottom: T,
    pub top: T,
    /// Whether its solid is its whole box.
    pub whole: bool,
    /// A box about its middle axis that is solid for sure.
    pub core: Option<Core<T>>,
    /// Height of its up axis: 1 where it stands upright.
    pub up: T,
    /// Its centre: x and z.
    pub at: [T; 2],
    /// Cosine and sine of its turn, where it stands upright.
    pub turn: [T; 2],
}

/// Width and depth of a box inside another, and from which height to which it reaches.
#[derive(Clone, Copy, Debug)]
pub(super) struct Core<T> {
    pub size: [T; 2],
    pub bottom: T,
    pub top: T,
}

/// What two members keep between them.
#[derive(Clone, Copy, Debug)]
pub(super) struct Between<T> {
    pub pair: (usize, usize),
    /// A distance of their surfaces, or of their centres.
    pub length: T,
    pub of_centres: bool,
}

/// A rectangular region and the boxes that may stand in it.
#[derive(Clone, Debug)]
pub(super) struct PackingRegion<T> {
    pub size: [T; 3],
    /// Its middle: x and z.
    pub at: [T; 2],
    /// Whether it is unturned.
    pub straight: bool,
    pub between: Vec<Between<T>>,
    pub members: Vec<Member<T>>,
    /// Pairs of members that may overlap all the same, sorted.
    pub excepted: Vec<(usize, usize)>,
    /// That nothing else may.
    pub apart: Claim,
}

/// The groups of a problem.
#[derive(Clone, Debug, Default)]
pub(super) struct Packing {
    groups: Vec<PackingRegion<Affine>>,
    /// What holds, taken apart.
    holding: Vec<Claim>,
    /// By group and member: what is said of it alone, once somebody asks.
    placings: OnceCell<Vec<Vec<Placing>>>,
    /// What was tried already: by group, member, kind and points.
    tried: RefCell<FxHashMap<Vec<u64>, bool>>,
    /// What does not fit, in words, as found last.
    said: RefCell<Option<String>>,
    /// How far boxes may overlap, and stick out of a region on each side (metres).
    contact: f64,
}

/// How far from upright a box may be to have a footprint here: the sine of the tilt.
const TILT: f64 = 0.01;
/// What is said of each alone counts for at most so many members.
const MOST_PLACED: usize = 60;
/// Where things take less than this part of the floor, it is not looked at closely.
const WORTH_A_LOOK: f64 = 0.4;
/// So many sizes, and so many distances, are tried.
const MOST_LENGTHS: usize = 4;

impl Packing {
    /// Groups in terms of a problem; `given` holds in it.
    pub fn new(groups: &[PackingRegion<Term>], problem: &Problem, given: &[Claim], contact: f64) -> Self {
        let at = |term: Term| problem.terms[term.0 as usize];
        let all = |terms: [Term; 3]| Some([at(terms[0])?, at(terms[1])?, at(terms[2])?]);
        let both = |terms: [Term; 2]| Some([at(terms[0])?, at(terms[1])?]);
        let group = |group: &PackingRegion<Term>| {
            let member = |m: &Member<Term>| {
                Some(Member {
                    inside: m.inside,
                    size: all(m.size)?,
                    bottom: at(m.bottom)?,
                    top: at(m.top)?,
                    whole: m.whole,
                    core: match m.core {
                        Some(core) => {
                            Some(Core { size: both(core.size)?, bottom: at(core.bottom)?, top: at(core.top)? })
                        }
                        None => None,
                    },
                    up: at(m.up)?,
                    at: both(m.at)?,
                    turn: both(m.turn)?,
                })
            };
            let members = group.members.iter().map(member).collect::<Option<Vec<_>>>()?;
            let between =
                |b: &Between<Term>| Some(Between { pair: b.pair, length: at(b.length)?, of_centres: b.of_centres });
            Some(PackingRegion {
                size: all(group.size)?,
                at: both(group.at)?,
                straight: group.straight,
                between: group.between.iter().filter_map(between).collect(),
                members,
                excepted: group.excepted.clone(),
                apart: group.apart,
            })
        };
        let groups: Vec<PackingRegion<Affine>> = groups.iter().filter_map(group).collect();
        let holding = if groups.is_empty() { Vec::new() } else { conjuncts(problem, given) };
        Self { groups, holding, contact, ..Self::default() }
    }

    /// What is said of a member alone.
    fn placing(&self, problem: &Problem, (group, member): (usize, usize)) -> &Placing {
        let plain = |t: Affine| {
            let free = t.var != 0 && problem.kinds[t.var as usize] == problem::UnknownKind::Free;
            (free && !t.minus && t.add == Interval::point(0.0)).then_some(t.var)
        };
        let all = || {
            let made_of: Vec<MadeOf> = self.holding.iter().filter_map(|c| MadeOf::new(problem, *c)).collect();
            let of_member = |group: &PackingRegion<Affine>, m: &Member<Affine>| {
                let own: [Option<Var>; 4] = [m.at[0], m.at[1], m.turn[0], m.turn[1]].map(plain);
                let placed = own[..2].iter().all(Option::is_some) && group.straight;
                if placed { Placing::new(problem, &made_of, own, group.at.map(plain)) } else { Placing::default() }
            };
            let of_group = |group: &PackingRegion<Affine>| {
                let few = group.members.len() <= MOST_PLACED;
                group.members.iter().map(|m| if few { of_member(group, m) } else { Placing::default() }).collect()
            };
            self.groups.iter().map(of_group).collect()
        };
        &self.placings.get_or_init(all)[group][member]
    }

    /// What did not fit, in words.
    pub fn reason(&self) -> Option<String> {
        self.said.take()
    }

    /// A conflict where the boxes that are known to be in a region are too much for it.
    pub fn check(&self, problem: &Problem, state: &mut State) -> Result<(), Conflict> {
        for (index, group) in self.groups.iter().enumerate() {
            let inside: Vec<usize> =
                (0..group.members.len()).filter(|&i| state.is_true(group.members[i].inside)).collect();
            state.work += group.members.len() as u64;
            if inside.is_empty() {
                continue;
            }
            if state.is_true(group.apart) {
                // Only those that keep clear of all the others count; whoever may overlap another is left out.
                let mut count: Vec<usize> = Vec::new();
                for &i in inside.iter().filter(|i| group.members[**i].core.is_some()) {
                    let apart = |k: &usize| group.excepted.binary_search(&(*k, i)).is_err();
                    if group.excepted.is_empty() || count.iter().all(apart) {
                        count.push(i);
                    }
                }
                let reasons = [state.verdict_why[group.apart.index()]];
                state.work += count.len() as u64 * 8;
                self.volumes(group, &count, &reasons, state)?;
                if let Some((upright, plane)) = self.cut_by_one_plane(group, &count, state) {
                    let why = [&reasons[..], &plane].concat();
                    self.areas(group, &upright, &why, 0.0, state)?;
                    self.probes(problem, index, &upright, &why, None, state)?;
                }
            }
            self.spaced(problem, index, &inside, state)?;
        }
        Ok(())
    }

    fn volumes(
        &self,
        group: &PackingRegion<Affine>,
        count: &[usize],
        reasons: &[EventId],
        state: &mut State,
    ) -> Result<(), Conflict> {
        let room = group.size.map(|s| of(state, s) + Interval::point(2.0 * self.contact));
        let room = room[0] * room[1] * room[2];
        let mut sum = Interval::point(0.0);
        let mut why = reasons.to_vec();
        for &i in count.iter().filter(|i| group.members[**i].whole) {
            let member = &group.members[i];
            let size = member.size.map(|s| smaller(of(state, s), self.contact));
            sum = sum + size[0] * size[1] * size[2];
            why.push(state.verdict_why[member.inside.index()]);
            why.extend(member.size.iter().map(|s| lower(state, *s)));
        }
        why.extend(group.size.iter().map(|s| upper(state, *s)));
        if sum.lo > room.hi { Err(Conflict(state.event(EventKind::Conflict(Rule::Packing), &why))) } else { Ok(()) }
    }

    /// Those of members that stand upright, if one horizontal plane cuts the solid of all of them; and why it does.
    fn cut_by_one_plane(
        &self,
        group: &PackingRegion<Affine>,
        count: &[usize],
        state: &State,
    ) -> Option<(Vec<usize>, Vec<EventId>)> {
        let upright: Vec<usize> = count.iter().copied().filter(|&i| is_upright(state, &group.members[i])).collect();
        let cores: Vec<Core<Affine>> = upright.iter().filter_map(|&i| group.members[i].core).collect();
        if upright.is_empty() || cores.len() < upright.len() {
            return None;
        }
        let mut why = Vec::new();
        // One plane cuts all: where the highest bottom is below the lowest top; or where any two are together higher than
        // the region, so that their heights overlap (and intervals that overlap pairwise have a point in common).
        let bottom = cores.iter().map(|core| of(state, core.bottom).hi).fold(f64::NEG_INFINITY, f64::max);
        let top = cores.iter().map(|core| of(state, core.top).lo).fold(f64::INFINITY, f64::min);
        if bottom < top - 4.0 * self.contact {
            why.extend(cores.iter().flat_map(|core| [upper(state, core.bottom), lower(state, core.top)]));
        } else {
            let mut heights: Vec<f64> = upright.iter().map(|&i| inner(state, &group.members[i], 1)).collect();
            heights.sort_by(f64::total_cmp);
            let room = of(state, group.size[1]).hi + 4.0 * self.contact;
            let whole = upright.iter().all(|&i| group.members[i].whole);
            if !whole || heights.len() > 1 && heights[0] + heights[1] <= room {
                return None;
            }
            why.push(upper(state, group.size[1]));
        }
        Some((upright, why))
    }

    fn areas(
        &self,
        group: &PackingRegion<Affine>,
        upright: &[usize],
        reasons: &[EventId],
        around: f64,
        state: &mut State,
    ) -> Result<(), Conflict> {
        // With what each keeps free around it they fit into the floor with as much around that.
        let margin = Interval::point(2.0 * self.contact + 2.0 * around);
        let room = [0, 2].map(|i| of(state, group.size[i]) + margin);
        let mut sum = Interval::point(0.0);
        let mut why = reasons.to_vec();
        for &i in upright {
            let member = &group.members[i];
            let size = footprint(state, member).map(|size| smaller(Interval::from(size), self.contact));
            let round = Interval::point(PI) * Interval::point(around) * Interval::point(around);
            sum = sum + size[0] * size[1] + (size[0] + size[1]) * Interval::point(2.0 * around) + round;
            why.extend(known_of(state, member));
        }
        why.extend([upper(state, group.size[0]), upper(state, group.size[2])]);
        let full = sum.lo > (room[0] * room[1]).hi;
        if full {
            let floor = of(state, group.size[0]).hi * of(state, group.size[2]).hi;
            let covers: f64 = upright.iter().map(|&i| footprint(state, &group.members[i])).map(|[w, d]| w * d).sum();
            let what = things(upright.len(), None);
            let say = match around {
                0.0 => format!("{what} cover {} m², but the floor has only {} m²", short(covers), short(floor)),
                _ => format!("{what} that keep {} m between them do not fit on the floor", short(2.0 * around)),
            };
            *self.said.borrow_mut() = Some(say);
        }
        if full { Err(Conflict(state.event(EventKind::Conflict(Rule::Packing), &why))) } else { Ok(()) }
    }

    /// Upright members that keep distances from each other: the more they keep, the fewer of them.
    fn spaced(&self, problem: &Problem, index: usize, inside: &[usize], state: &mut State) -> Result<(), Conflict> {
        let group = &self.groups[index];
        for of_centres in [false, true] {
            let kept = |b: &&Between<Affine>| b.of_centres == of_centres && of(state, b.length).lo > 2.0 * self.contact;
            let pairs: Vec<(&Between<Affine>, f64)> =
                group.between.iter().filter(kept).map(|b| (b, of(state, b.length).lo)).collect();
            let mut lengths: Vec<f64> = pairs.iter().map(|(_, l)| *l).collect();
            lengths.sort_by(|a, b| b.total_cmp(a));
            lengths.dedup();
            for least in lengths.into_iter().take(MOST_LENGTHS) {
                let known: FxHashMap<(usize, usize), &Between<Affine>> =
                    pairs.iter().filter(|(_, l)| *l >= least).map(|(b, _)| (b.pair, *b)).collect();
                let mut some: Vec<usize> = Vec::new();
                for &i in inside {
                    if some.iter().all(|k| known.contains_key(&(*k, i))) {
                        some.push(i);
                    }
                }
                if some.len() < 2 {
                    continue;
                }
                let upright: Vec<usize> =
                    some.iter().copied().filter(|&i| is_upright(state, &group.members[i])).collect();
                let cut =
                    if of_centres { Some((upright, Vec::new())) } else { self.cut_by_one_plane(group, &some, state) };
                let Some((upright, mut why)) = cut else { continue };
                // Between boxes that one plane cuts the distance is that of their footprints; of centres at different
                // heights it is less seen from above.
                let mut space = least;
                if of_centres {
                    let center = |i: usize| of(state, group.members[i].bottom) + of(state, group.members[i].top);
                    let ends = upright.iter().map(|&i| center(i).scale(0.5));
                    let (lo, hi) =
                        ends.fold((f64::INFINITY, f64::NEG_INFINITY), |(lo, hi), c| (lo.min(c.lo), hi.max(c.hi)));
                    if hi - lo >= space {
                        continue;
                    }
                    space = (space * space - (hi - lo) * (hi - lo)).sqrt();
                    let heights = upright.iter().flat_map(|&i| [group.members[i].bottom, group.members[i].top]);
                    why.extend(heights.flat_map(|t| [lower(state, t), upper(state, t)]));
                }
                for (n, &i) in upright.iter().enumerate() {
                    why.extend(upright[..n].iter().filter_map(|k| known.get(&(*k, i))).map(|b| lower(state, b.length)));
                }
                if !of_centres {
                    self.areas(group, &upright, &why, space / 2.0, state)?;
                }
                self.probes(problem, index, &upright, &why, Some((space, of_centres)), state)?;
            }
        }
        Ok(())
    }

    /// A conflict where there is a set of points, fewer than members, of which each member covers one.
    fn probes(
        &self,
        problem: &Problem,
        index: usize,
        upright: &[usize],
        reasons: &[EventId],
        space: Option<(f64, bool)>,
        state: &mut State,
    ) -> Result<(), Conflict> {
        let group = &self.groups[index];
        let floor = [0, 2].map(|i| of(state, group.size[i]).hi + 2.0 * self.contact);
        if upright.len() < 2 || floor.iter().any(|f| !f.is_finite()) {
            return Ok(());
        }
        // The largest first: where some of them fit, more of them may not.
        let mut order: Vec<(usize, ProbeBox)> =
            upright.iter().map(|&i| (i, self.kind(group, &group.members[i], space, state))).collect();
        // Where much of the floor is free there is no need to look closely.
        if order.iter().map(|(_, kind)| kind.taken()).sum::<f64>() < WORTH_A_LOOK * floor[0] * floor[1] {
            return Ok(());
        }
        let side = |k: &ProbeBox| k.core[0].min(k.core[1]) + 2.0 * k.space;
        order.sort_by(|(_, a), (_, b)| side(b).total_cmp(&side(a)));
        let last = |n: &usize| *n == order.len() || side(&order[*n].1) < side(&order[n - 1].1) - 1e-9;
        let counts: Vec<usize> = (2..=order.len()).filter(last).collect();
        for count in counts.into_iter().rev().take(MOST_LENGTHS) {
            let (some, smallest) = (&order[..count], order[count - 1].1);
            for points in probes::guesses(floor, &smallest, count) {
                let one =
                    |(i, kind): &(usize, ProbeBox)| self.covers(problem, (index, *i), floor, kind, &points, state);
                if !some.iter().all(one) {
                    continue;
                }
                let mut why = reasons.to_vec();
                for (i, _) in some {
                    why.extend(known_of(state, &group.members[*i]));
                    why.extend(group.members[*i].turn.iter().flat_map(|t| [lower(state, *t), upper(state, *t)]));
                    why.extend(self.placing(problem, (index, *i)).reasons(state));
                }
                why.extend([upper(state, group.size[0]), upper(state, group.size[2])]);
                let [w, d] = [0, 2].map(|i| short(of(state, group.size[i]).hi));
                let sizes = some.iter().map(|(i, _)| [0, 2].map(|k| short(of(state, group.members[*i].size[k]).lo)));
                let sizes: BTreeSet<[String; 2]> = sizes.collect();
                let what = things(count, (sizes.len() == 1).then(|| sizes.into_iter().next()).flatten());
                let apart = match space {
                    Some((length, true)) => format!(", their centres {} m apart", short(length)),
                    Some((length, false)) => format!(" {} m apart", short(length)),
                    None => String::new(),
                };
                let fit = points.len();
                let say = format!("{what} do not fit on a floor of {w} × {d} m{apart}: at most {fit} fit");
                *self.said.borrow_mut() = Some(say);
                return Err(Conflict(
                    state.event(EventKind::Conflict(Rule::Beside { fit: points.len() as u32 }), &why),
                ));
            }
        }
        Ok(())
    }

    /// A member as a thing that covers points.
    fn kind(
        &self,
        group: &PackingRegion<Affine>,
        member: &Member<Affine>,
        space: Option<(f64, bool)>,
        state: &State,
    ) -> ProbeBox {
        let less = |size: f64| smaller(Interval::from(size), self.contact).lo;
        let size = [0, 2].map(|k| less(inner(state, member, k)));
        let known = group.straight && of(state, member.up).lo >= 1.0;
        let turns = probes::turns(of(state, member.turn[0]), of(state, member.turn[1])).filter(|_| known);
        let turns = turns.unwrap_or(probes::ANY_TURN);
        let space = space.map(|(length, of_centres)| (length / 2.0, of_centres)).unwrap_or_default();
        match space {
            (radius, true) => ProbeBox { size, core: [0.0; 2], space: radius, turns },
            (space, false) => ProbeBox { size, core: footprint(state, member).map(less), space, turns },
        }
    }

    fn covers(
        &self,
        problem: &Problem,
        (index, member): (usize, usize),
        floor: [f64; 2],
        kind: &ProbeBox,
        points: &probes::Points,
        state: &mut State,
    ) -> bool {
        let (group, placing) = (&self.groups[index], self.placing(problem, (index, member)));
        let whole = !placing.claims.is_empty() && kind.turns == probes::ANY_TURN;
        let kind = ProbeBox { turns: if whole { probes::WHOLE_TURN } else { kind.turns }, ..*kind };
        let who = if placing.claims.is_empty() { 0 } else { member as u64 + 1 };
        let numbers = floor.into_iter().chain(kind.size).chain(kind.core).chain([kind.space]).chain(kind.turns);
        let key: Vec<u64> = [index as u64, who]
            .into_iter()
            .chain(numbers.chain(points.iter().flatten().copied()).map(f64::to_bits))
            .collect();
        if let Some(known) = self.tried.borrow().get(&key) {
            return *known;
        }
        let at = group.at.map(|t| if t.var == 0 { t.add.lo } else { 0.0 });
        let mut values = Vec::new();
        let mut may_be = |cell: &probes::Cell| placing.may_be(problem, at, cell, &mut values);
        let covers = probes::covers_one(floor, &kind, points, &mut may_be, &mut state.work);
        self.tried.borrow_mut().insert(key, covers);
        covers
    }
}

fn is_upright(state: &State, member: &Member<Affine>) -> bool {
    of(state, member.up).lo >= (1.0 - TILT * TILT).sqrt()
}

/// Width and depth of what of an upright member is solid, at least.
fn footprint(state: &State, member: &Member<Affine>) -> [f64; 2] {
    match member.core {
        Some(core) if !member.whole => core.size.map(|s| of(state, s).lo),
        _ => [0, 2].map(|k| inner(state, member, k)),
    }
}

/// So many things, of one size in words or of several.
fn things(count: usize, size: Option<[String; 2]>) -> String {
    match size {
        Some([w, d]) => format!("{count} objects of {w} × {d} m"),
        None => format!("{count} objects"),
    }
}

/// Metres as people write them; the last digit may owe itself to a tolerance.
fn short(value: f64) -> String {
    let text = format!("{:.2}", value);
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

/// The events behind the place and the size of a member.
fn known_of(state: &State, member: &Member<Affine>) -> impl Iterator<Item = EventId> {
    let sizes = member.size.map(|s| [lower(state, s), upper(state, s)]);
    let first = [state.verdict_why[member.inside.index()], lower(state, member.up)];
    first.into_iter().chain(sizes.into_iter().flatten())
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
