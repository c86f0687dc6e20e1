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
use super::pierce;
use super::placing::{MadeOf, Placing, conjuncts, follow};
use super::probes::{self, ProbeBox};
use super::problem::{self, Affine, Problem, Var, VariableFormula};
use super::state::{Conflict, EventId, EventKind, Rule, State};
use super::tape::{Claim, Term};
use rustc_hash::{FxHashMap, FxHashSet};
use scenelang_lang::program::{ObjectId, Program};
use std::cell::{OnceCell, RefCell};
use std::collections::BTreeSet;
use std::f64::consts::PI;
use std::rc::Rc;

/// A box that may stand in a region, by terms.
#[derive(Clone, Copy, Debug)]
pub(super) struct Member<T> {
    pub object: ObjectId,
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
    /// How far the centre of the first of a pair is from that of the second, along x and z; sorted by pair.
    pub pairs: Vec<((usize, usize), [T; 2])>,
    /// The angles between the fronts of pairs that claims speak of.
    pub fronts: Vec<((usize, usize), T)>,
    pub members: Vec<Member<T>>,
    /// Pairs of members that may overlap all the same, sorted.
    pub excepted: Vec<(usize, usize)>,
    /// That nothing else may.
    pub apart: Claim,
}

/// At least so many of some claims hold, each of which says of a member that it is in the region.
#[derive(Clone, Debug)]
struct Counted {
    claim: Claim,
    least: usize,
    members: Vec<usize>,
}

/// The groups of a problem.
#[derive(Debug)]
pub(super) struct Packing<'p> {
    program: &'p Program,
    /// By group.
    counted: Vec<Vec<Counted>>,
    pub(super) groups: Vec<PackingRegion<Affine>>,
    /// What holds, taken apart.
    holding: Vec<Claim>,
    /// What of it can be looked at by itself, once somebody asks.
    made_of: OnceCell<Vec<MadeOf>>,
    /// By group and member: what is said of it alone, once somebody asks.
    placings: OnceCell<Vec<Vec<Placing>>>,
    /// What was tried already: by group, member, kind and points.
    tried: RefCell<FxHashMap<Vec<u64>, bool>>,
    /// Points that were guessed already.
    guessed: RefCell<FxHashMap<Vec<u64>, Vec<probes::Points>>>,
    /// Which of the claims are about how two are off each other, once somebody asks.
    pub(super) told: RefCell<FxHashMap<[Var; 2], Rc<[usize]>>>,
    /// Members that are turned alike and were looked at already, by group.
    pub(super) alike: RefCell<FxHashSet<(usize, Vec<usize>)>>,
    /// What does not fit, in words, as found last.
    said: RefCell<Option<String>>,
    /// How far boxes may overlap, and stick out of a region on each side (metres).
    pub contact: f64,
}

/// How far from upright a box may be to have a footprint here: the sine of the tilt.
const TILT: f64 = 0.01;
/// What is said of each alone counts for at most so many members.
const MOST_PLACED: usize = 60;
/// Where things take less than this part of the floor, it is not looked at closely.
const WORTH_A_LOOK: f64 = 0.4;
/// Where much of the floor is free, no more members than this are looked at closely.
const MOST_PIERCED: usize = 12;
/// So many sizes, and so many distances, are tried.
const MOST_LENGTHS: usize = 4;

impl<'p> Packing<'p> {
    /// Groups in terms of a problem; `given` holds in it.
    pub fn new(
        program: &'p Program,
        groups: &[PackingRegion<Term>],
        problem: &Problem,
        [always, given]: [&[Claim]; 2],
        contact: f64,
    ) -> Self {
        let at = |term: Term| problem.terms[term.0 as usize];
        let all = |terms: [Term; 3]| Some([at(terms[0])?, at(terms[1])?, at(terms[2])?]);
        let both = |terms: [Term; 2]| Some([at(terms[0])?, at(terms[1])?]);
        let group = |group: &PackingRegion<Term>| {
            let member = |m: &Member<Term>| {
                Some(Member {
                    object: m.object,
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
                fronts: group.fronts.iter().filter_map(|(pair, angle)| Some((*pair, at(*angle)?))).collect(),
                pairs: group.pairs.iter().filter_map(|(pair, off)| Some((*pair, both(*off)?))).collect(),
                members,
                excepted: group.excepted.clone(),
                apart: group.apart,
            })
        };
        let groups: Vec<PackingRegion<Affine>> = groups.iter().filter_map(group).collect();
        let holding = if groups.is_empty() { Vec::new() } else { follow(problem, always, conjuncts(problem, given)) };
        let counted = groups.iter().map(|group| counted(problem, group)).collect();
        Self {
            program,
            counted,
            groups,
            holding,
            made_of: OnceCell::new(),
            placings: OnceCell::new(),
            tried: RefCell::default(),
            guessed: RefCell::default(),
            told: RefCell::default(),
            alike: RefCell::default(),
            said: RefCell::default(),
            contact,
        }
    }

    /// What holds, with what it is made of.
    pub(super) fn made_of(&self, problem: &Problem) -> &[MadeOf] {
        self.made_of.get_or_init(|| self.holding.iter().filter_map(|c| MadeOf::new(problem, *c)).collect())
    }

    /// What is said of a member alone.
    pub(super) fn placing(&self, problem: &Problem, (group, member): (usize, usize)) -> &Placing {
        let plain = |t: Affine| {
            let free = t.var != 0 && problem.kinds[t.var as usize] == problem::UnknownKind::Free;
            (free && !t.minus && t.add == Interval::point(0.0)).then_some(t.var)
        };
        let all = || {
            let made_of = self.made_of(problem);
            let of_member = |group: &PackingRegion<Affine>, m: &Member<Affine>| {
                let own: [Option<Var>; 4] = [m.at[0], m.at[1], m.turn[0], m.turn[1]].map(plain);
                let placed = own[..2].iter().all(Option::is_some) && group.straight;
                if placed { Placing::new(problem, made_of, own, group.at.map(plain)) } else { Placing::default() }
            };
            let of_group = |group: &PackingRegion<Affine>| {
                let few = group.members.len() <= MOST_PLACED;
                group.members.iter().map(|m| if few { of_member(group, m) } else { Placing::default() }).collect()
            };
            self.groups.iter().map(of_group).collect()
        };
        &self.placings.get_or_init(all)[group][member]
    }

    /// Notes what does not fit.
    pub(super) fn say(&self, what: String) {
        *self.said.borrow_mut() = Some(what);
    }

    /// Nothing of what was noted is why.
    pub(super) fn unsaid(&self) {
        self.said.take();
    }

    /// The name of a member.
    pub(super) fn name(&self, group: &PackingRegion<Affine>, member: usize) -> &'p str {
        &self.program.objects[group.members[member].object.0 as usize].name
    }

    /// So many members, by what they are, if that is the same.
    pub(super) fn things(&self, group: &PackingRegion<Affine>, members: &[usize]) -> String {
        let what = |i: &usize| {
            let object = &self.program.objects[group.members[*i].object.0 as usize];
            let name = object.array.as_ref().map_or(object.name.as_str(), |(array, _)| array.as_str());
            if object.category.is_empty() { name } else { object.category.as_str() }
        };
        let first = members.first().map(what).unwrap_or_default();
        let same =
            members.iter().all(|i| what(i) == first) && first.chars().all(|c| c.is_ascii_lowercase() || c == ' ');
        let many = if same && !first.is_empty() { plural(first) } else { "objects".to_owned() };
        format!("{} {many}", members.len())
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
            self.counts(problem, index, state)?;
            if inside.is_empty() {
                continue;
            }
            self.nowhere(problem, index, &inside, state)?;
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
                let cuts: Vec<(Vec<usize>, Vec<EventId>)> = match self.cut_by_one_plane(group, &count, state) {
                    Some(cut) => vec![cut],
                    None => self.planes(group, &count, state),
                };
                self.beside(problem, group, &count, &reasons, state)?;
                for (upright, plane) in &cuts {
                    let why = [&reasons[..], plane].concat();
                    self.areas(group, upright, &why, 0.0, state)?;
                }
                for (upright, plane) in &cuts {
                    let why = [&reasons[..], plane].concat();
                    self.turned_alike(problem, index, upright, &why, state)?;
                }
                for (upright, plane) in cuts {
                    let why = [&reasons[..], &plane].concat();
                    self.probes(problem, index, (&upright, upright.len()), &why, None, state)?;
                }
            }
            self.spaced(problem, index, &inside, state)?;
            self.too_far(problem, index, &inside, state)?;
            let apart = state.is_true(group.apart).then(|| state.verdict_why[group.apart.index()]);
            self.rings(group, apart, state)?;
        }
        Ok(())
    }

    /// Of members that are counted in a region at least so many are in it, whichever they are.
    fn counts(&self, problem: &Problem, index: usize, state: &mut State) -> Result<(), Conflict> {
        let group = &self.groups[index];
        for Counted { claim, least, members } in &self.counted[index] {
            if !state.is_true(*claim) || !state.is_true(group.apart) || *least < 2 {
                continue;
            }
            let excepted =
                |i: &usize| members.iter().any(|k| group.excepted.binary_search(&(*i.min(k), *i.max(k))).is_ok());
            let (some, others): (Vec<usize>, Vec<usize>) =
                members.iter().copied().partition(|i| group.members[*i].core.is_some() && !excepted(i));
            let Some(least) = least.checked_sub(others.len()).filter(|least| *least > 1) else { continue };
            let Some((upright, plane)) = self.cut_by_one_plane(group, &some, state) else { continue };
            if upright.len() < some.len() {
                continue;
            }
            state.work += some.len() as u64 * 8;
            let mut why = plane;
            why.extend([*claim, group.apart].map(|claim| state.verdict_why[claim.index()]));
            // The smallest of them need the least.
            let area = |i: &usize| footprint(state, &group.members[*i]).into_iter().product::<f64>();
            let mut smallest = upright.clone();
            smallest.sort_by(|a, b| area(a).total_cmp(&area(b)));
            smallest.truncate(least);
            for &i in &upright {
                why.extend(known_of(state, &group.members[i]));
            }
            self.areas(group, &smallest, &why, 0.0, state)?;
            self.probes(problem, index, (&upright, least), &why, None, state)?;
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

    /// Members that one plane cuts, where none cuts all of them: at a few heights, the most each.
    fn planes(&self, group: &PackingRegion<Affine>, count: &[usize], state: &State) -> Vec<(Vec<usize>, Vec<EventId>)> {
        let upright = count.iter().copied().filter(|&i| is_upright(state, &group.members[i]));
        let heights = upright.filter_map(|i| {
            let core = group.members[i].core?;
            Some((i, of(state, core.bottom).hi + 2.0 * self.contact, of(state, core.top).lo - 2.0 * self.contact))
        });
        let heights: Vec<(usize, f64, f64)> = heights.collect();
        let mut sets: Vec<Vec<usize>> = Vec::new();
        for (_, level, _) in &heights {
            let cut = heights.iter().filter(|(_, from, to)| from <= level && level < to);
            let cut: Vec<usize> = cut.map(|(i, ..)| *i).collect();
            if cut.len() > 1 && !sets.contains(&cut) {
                sets.push(cut);
            }
        }
        sets.sort_by_key(|set| std::cmp::Reverse(set.len()));
        sets.truncate(MOST_LENGTHS);
        let with_reasons = |set: Vec<usize>| {
            let cores = set.iter().filter_map(|&i| group.members[i].core);
            let why = cores.flat_map(|core| [upper(state, core.bottom), lower(state, core.top)]).collect();
            (set, why)
        };
        sets.into_iter().map(with_reasons).collect()
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
        let mut sum = Interval::point(0.0);
        let mut why = reasons.to_vec();
        // Where all of them may be, along each axis: in the region, or in less of it.
        let room = [0, 1].map(|axis| {
            let whole = of(state, group.size[2 * axis]);
            let part = self.part(group, upright, axis, state);
            if part >= whole.hi || !group.straight {
                why.push(upper(state, group.size[2 * axis]));
                return whole + margin;
            }
            for &i in upright {
                let member = &group.members[i];
                why.extend([lower(state, member.at[axis]), upper(state, member.at[axis])]);
                why.extend(member.turn.iter().flat_map(|t| [lower(state, *t), upper(state, *t)]));
            }
            Interval::point(part) + margin
        });
        for &i in upright {
            let member = &group.members[i];
            let size = footprint(state, member).map(|size| smaller(Interval::from(size), self.contact));
            let round = Interval::point(PI) * Interval::point(around) * Interval::point(around);
            sum = sum + size[0] * size[1] + (size[0] + size[1]) * Interval::point(2.0 * around) + round;
            why.extend(known_of(state, member));
        }
        let full = sum.lo > (room[0] * room[1]).hi;
        if full {
            let [x, z] = room.map(|side| (side - margin).hi);
            let floor = of(state, group.size[0]).hi * of(state, group.size[2]).hi;
            let boxes = upright.iter().map(|&i| [0, 2].map(|k| of(state, group.members[i].size[k]).lo));
            let covers: f64 = boxes.map(|[w, d]| w * d).sum();
            let what = self.things(group, upright);
            let say = match around {
                0.0 if x * z < floor - 0.005 => format!(
                    "{what} cover {} m², but they have only {} m² of the floor ({} × {} m)",
                    short(covers),
                    short(x * z),
                    short(x),
                    short(z)
                ),
                0.0 => format!("{what} cover {} m², but the floor has only {} m²", short(covers), short(floor)),
                _ => format!("{what} that keep {} m between them do not fit on the floor", short(2.0 * around)),
            };
            self.say(say);
        }
        if full { Err(Conflict(state.event(EventKind::Conflict(Rule::Packing), &why))) } else { Ok(()) }
    }

    /// How long the part of the floor is, along an axis, that the solids of some may be in.
    fn part(&self, group: &PackingRegion<Affine>, some: &[usize], axis: usize, state: &State) -> f64 {
        let ends = some.iter().map(|&i| {
            let member = &group.members[i];
            let [w, d] = footprint(state, member);
            let [c, s] = member.turn.map(|t| of(state, t).magnitude().min(1.0));
            let reach = if axis == 0 { c * w + s * d } else { s * w + c * d }.min(w.hypot(d)) / 2.0;
            let at = of(state, member.at[axis]);
            [at.lo - reach, at.hi + reach]
        });
        let [lo, hi] = ends.fold([f64::INFINITY, f64::NEG_INFINITY], |[l, h], [a, b]| [l.min(a), h.max(b)]);
        hi - lo
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
                self.probes(problem, index, (&upright, upright.len()), &why, Some((space, of_centres)), state)?;
            }
        }
        Ok(())
    }

    /// A conflict where there is a set of points of which each member covers one, and which is smaller than the number of
    /// members that are there at least.
    fn probes(
        &self,
        problem: &Problem,
        index: usize,
        (upright, least): (&[usize], usize),
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
        // Where much of the floor is free there is no need to look closely, unless things may not stand everywhere.
        let loose = order.iter().map(|(_, kind)| kind.taken()).sum::<f64>() < WORTH_A_LOOK * floor[0] * floor[1];
        let placed = |(i, _): &(usize, ProbeBox)| !self.placing(problem, (index, *i)).claims.is_empty();
        if loose {
            // Of those that are told where to stand, the ones of one size: of others the places seldom have points in common.
            order.retain(placed);
            let alike = |a: &ProbeBox, b: &ProbeBox| (0..2).all(|i| (a.core[i] - b.core[i]).abs() < 1e-9);
            let count = |kind: &ProbeBox| order.iter().filter(|(_, other)| alike(kind, other)).count();
            let most = order.iter().map(|(_, kind)| count(kind)).max();
            let kind = order.iter().find(|(_, kind)| Some(count(kind)) == most).map(|(_, kind)| *kind);
            order.retain(|(_, other)| kind.as_ref().is_some_and(|kind| alike(kind, other)));
        }
        let missing = upright.len() - least;
        if order.len() < missing + 2 || loose && order.len() > MOST_PIERCED {
            return Ok(());
        }
        let side = |k: &ProbeBox| k.core[0].min(k.core[1]) + 2.0 * k.space;
        order.sort_by(|(_, a), (_, b)| side(b).total_cmp(&side(a)));
        let last = |n: &usize| *n == order.len() || side(&order[*n].1) < side(&order[n - 1].1) - 1e-9;
        let counts: Vec<usize> = (missing + 2..=order.len()).filter(last).collect();
        for count in counts.into_iter().rev().take(MOST_LENGTHS) {
            let (some, smallest) = (&order[..count], order[count - 1]);
            let fewer = count - missing;
            let mut guesses = if loose { Vec::new() } else { probes::guesses(floor, &smallest.1, fewer) };
            let general = guesses.len();
            if count <= MOST_PIERCED && some.iter().all(placed) {
                guesses.extend(self.pierced(problem, (index, smallest.0), floor, &smallest.1, fewer, state));
            }
            for (guess, points) in guesses.into_iter().enumerate() {
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
                let what = self.things(group, &some.iter().map(|(i, _)| *i).collect::<Vec<usize>>()[..fewer]);
                let each = match sizes.into_iter().collect::<Vec<_>>().as_slice() {
                    [[w, d]] => format!(" of {w} × {d} m"),
                    _ => String::new(),
                };
                let there = if guess < general { "" } else { " where they are to stand" };
                let apart = match space {
                    Some((length, true)) => format!(", their centres {} m apart", short(length)),
                    Some((length, false)) => format!(" {} m apart", short(length)),
                    None => String::new(),
                };
                let fit = points.len();
                let say = match (some, space) {
                    ([(a, _), (b, _)], Some(_)) => {
                        let [a, b] = [a, b].map(|i| self.name(group, *i));
                        format!("`{a}` and `{b}` cannot be so far apart on a floor of {w} × {d} m")
                    }
                    _ => format!("{what}{each} do not fit{apart} on a floor of {w} × {d} m{there}: at most {fit} fit"),
                };
                self.say(say);
                return Err(Conflict(
                    state.event(EventKind::Conflict(Rule::Beside { fit: points.len() as u32 }), &why),
                ));
            }
        }
        Ok(())
    }

    /// Guesses of points by where a member may stand.
    pub(super) fn pierced(
        &self,
        problem: &Problem,
        (index, member): (usize, usize),
        floor: [f64; 2],
        kind: &ProbeBox,
        fewer: usize,
        state: &mut State,
    ) -> Vec<probes::Points> {
        let (group, placing) = (&self.groups[index], self.placing(problem, (index, member)));
        let kind =
            ProbeBox { turns: if kind.turns == probes::ANY_TURN { probes::WHOLE_TURN } else { kind.turns }, ..*kind };
        let numbers = floor.into_iter().chain(kind.size).chain(kind.core).chain([kind.space]).chain(kind.turns);
        let key = [index, member, fewer].map(|n| n as u64).into_iter().chain(numbers.map(f64::to_bits)).collect();
        if let Some(known) = self.guessed.borrow().get(&key) {
            return known.clone();
        }
        let at = group.at.map(|t| if t.var == 0 { t.add.lo } else { 0.0 });
        let mut values = Vec::new();
        let mut may_be = |cell: &probes::Cell| placing.may_be(problem, at, cell, &mut values);
        let found = pierce::guesses(floor, &kind, fewer, &mut may_be, &mut state.work);
        self.guessed.borrow_mut().insert(key, found.clone());
        found
    }

    /// A member as a thing that covers points.
    pub(super) fn kind(
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

    pub(super) fn covers(
        &self,
        problem: &Problem,
        (index, member): (usize, usize),
        floor: [f64; 2],
        kind: &ProbeBox,
        points: &probes::Points,
        state: &mut State,
    ) -> bool {
        let (group, placing) = (&self.groups[index], self.placing(problem, (index, member)));
        if !placing.claims.iter().all(|claim| state.is_true(*claim)) {
            return false;
        }
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

pub(super) fn is_upright(state: &State, member: &Member<Affine>) -> bool {
    of(state, member.up).lo >= (1.0 - TILT * TILT).sqrt()
}

/// Width and depth of what of an upright member is solid, at least.
fn footprint(state: &State, member: &Member<Affine>) -> [f64; 2] {
    match member.core {
        Some(core) if !member.whole => core.size.map(|s| of(state, s).lo),
        _ => [0, 2].map(|k| inner(state, member, k)),
    }
}

/// What is counted in a group: of how many of its members statements say that some number of them are in the region.
fn counted(problem: &Problem, group: &PackingRegion<Affine>) -> Vec<Counted> {
    let parts = |claim: Claim| conjuncts(problem, &[claim]).into_iter().collect::<BTreeSet<Claim>>();
    let inside: Vec<BTreeSet<Claim>> = group.members.iter().map(|m| parts(m.inside)).collect();
    let of_fact = |(fact, verdict): (usize, &VariableFormula)| {
        let VariableFormula::AtLeast(least, claims) = verdict else { return None };
        if claims.len() > MOST_PLACED {
            return None;
        }
        let member = |claim: &Claim| {
            let said = parts(*claim);
            inside.iter().position(|parts| !parts.is_empty() && parts.is_subset(&said))
        };
        let found: Vec<usize> = claims.iter().filter_map(member).collect();
        let least = (*least as usize).checked_sub(claims.len() - found.len())?;
        let different = found.iter().collect::<BTreeSet<_>>().len() == found.len();
        (least > 1 && different).then_some(Counted { claim: Claim(2 * fact as u32), least, members: found })
    };
    problem.verdicts.iter().enumerate().filter_map(of_fact).collect()
}

/// More than one of a noun.
fn plural(noun: &str) -> String {
    let consonant = |end: &str| end.strip_suffix('y').is_some_and(|rest| !rest.ends_with(['a', 'e', 'i', 'o', 'u']));
    match noun {
        "person" => "people".to_owned(),
        _ if noun.ends_with("shelf") => format!("{}ves", &noun[..noun.len() - 1]),
        _ if consonant(noun) => format!("{}ies", &noun[..noun.len() - 1]),
        _ if noun.ends_with(['s', 'x', 'z']) || noun.ends_with("ch") || noun.ends_with("sh") => format!("{noun}es"),
        _ => format!("{noun}s"),
    }
}

/// Metres as people write them; the last digit may owe itself to a tolerance.
pub(super) fn short(value: f64) -> String {
    let text = format!("{:.2}", value);
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

/// The events behind the place and the size of a member.
pub(super) fn known_of(state: &State, member: &Member<Affine>) -> impl Iterator<Item = EventId> {
    let sizes = member.size.map(|s| [lower(state, s), upper(state, s)]);
    let inside = state.is_true(member.inside).then(|| state.verdict_why[member.inside.index()]);
    inside.into_iter().chain([lower(state, member.up)]).chain(sizes.into_iter().flatten())
}

pub(super) fn of(state: &State, term: Affine) -> Interval {
    term.of(state.domain[term.var as usize])
}

pub(super) fn lower(state: &State, term: Affine) -> EventId {
    state.why[term.var as usize][usize::from(term.minus)]
}

pub(super) fn upper(state: &State, term: Affine) -> EventId {
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
