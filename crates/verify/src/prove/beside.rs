//! Solids that cannot be on both sides of each other: two that overlap along one axis of the floor are apart along the
//! other, and several that overlap pairwise along one need a row along the other that is long enough for all of them.
//!
//! That they overlap along an axis is known from where each may be: from the walls that they stand at, the zone that they
//! are in, the narrow room.

use super::interval::Interval;
use super::packing::{Between, Packing, PackingRegion, is_upright, known_of, lower, of, short, upper};
use super::passing::{Looks, reasons_of};
use super::problem::{Affine, Problem};
use super::state::{Conflict, EventId, EventKind, Rule, State};
use rustc_hash::FxHashMap;
use std::f64::consts::FRAC_1_SQRT_2;

/// Of more members than this, pairs are not looked at.
pub(super) const MOST_PAIRED: usize = 24;
/// How far a box may be turned off the axes of the world to stand along them here (the sine); it costs as much of its size.
const SKEW: f64 = 2e-5;

/// What of a member is solid along the axes of the floor, at least, and between which heights.
pub(super) struct Extent {
    pub member: usize,
    pub size: [f64; 2],
    /// The radius of a disc about its middle, whichever way it is turned.
    disc: f64,
    pub bottom: f64,
    pub top: f64,
    pub why: Vec<EventId>,
}

/// How two are along one axis, wherever they may be: that decides how they are along the other.
struct Overlap {
    /// How far they are from each other along it, at most; 0 where they overlap.
    off: f64,
    /// The same of their middles.
    middles: f64,
    why: Vec<EventId>,
}

/// What a pair keeps along an axis beyond touching, as extents have it; what of that is a distance of surfaces; and why they
/// are apart along it.
struct Kept {
    beyond: f64,
    space: f64,
    why: Vec<EventId>,
}

type Forced = FxHashMap<(usize, usize), Kept>;

/// What pairs are told to keep is looked for so far beyond touching (metres), in so many steps and parts.
const FARTHEST: f64 = 8.0;
const LEAST_TOLD: f64 = 0.01;
const STEPS: usize = 12;
const PARTS: usize = 8;

impl Packing<'_> {
    /// Conflicts and bounds from pairs and rows of members that do not overlap, for `reasons`.
    pub(super) fn beside(
        &self,
        problem: &Problem,
        group: &PackingRegion<Affine>,
        count: &[usize],
        reasons: &[EventId],
        state: &mut State,
    ) -> Result<(), Conflict> {
        if group.members.len() > MOST_PAIRED {
            return Ok(());
        }
        let extents: Vec<Extent> = count.iter().filter_map(|&i| self.extent(group, i, state)).collect();
        state.work += (extents.len() * extents.len()) as u64;
        for axis in [0, 1] {
            let mut forced = Forced::default();
            for (n, a) in extents.iter().enumerate() {
                for b in &extents[..n] {
                    if let Some(overlap) = self.overlaps(group, [a, b], 1 - axis, state) {
                        let kept = self.kept_beside(problem, group, [a, b], axis, overlap, state);
                        self.apart(group, [a, b], axis, &kept, reasons, state)?;
                        forced.insert((b.member.min(a.member), b.member.max(a.member)), kept);
                    }
                }
            }
            self.rows(group, &extents, &forced, axis, reasons, state)?;
        }
        self.passing(problem, group, &extents, reasons, state)
    }

    fn extent(&self, group: &PackingRegion<Affine>, index: usize, state: &State) -> Option<Extent> {
        let member = &group.members[index];
        let core = member.core.filter(|_| is_upright(state, member) && of(state, member.up).lo >= 1.0)?;
        let [w, d] = core.size.map(|s| of(state, s).lo);
        let turn = member.turn.map(|t| of(state, t));
        let turned = |i: usize| turn[i].magnitude() <= SKEW;
        let size = match [turned(1), turned(0)] {
            [true, _] => [w - SKEW * d, d - SKEW * w],
            [_, true] => [d - SKEW * w, w - SKEW * d],
            // A square in the disc in it.
            _ => [w.min(d) * FRAC_1_SQRT_2; 2],
        };
        let mut why: Vec<EventId> = known_of(state, member).collect();
        why.extend(member.turn.iter().flat_map(|t| [lower(state, *t), upper(state, *t)]));
        why.extend([upper(state, core.bottom), lower(state, core.top)]);
        let (bottom, top) = (of(state, core.bottom).hi, of(state, core.top).lo);
        let disc = (w.min(d) - self.contact) / 2.0;
        Some(Extent { member: index, size: size.map(|s| s - self.contact), disc, bottom, top, why })
    }

    /// How two that overlap in height are along an axis wherever they may be, if they overlap there or are nearer than they
    /// are to be.
    fn overlaps(
        &self,
        group: &PackingRegion<Affine>,
        [a, b]: [&Extent; 2],
        axis: usize,
        state: &State,
    ) -> Option<Overlap> {
        let margin = 2.0 * self.contact;
        let pair = (b.member.min(a.member), b.member.max(a.member));
        // What is not at one height only keeps the distance that it is told to.
        let (space, _) = self.space(group, [a, b], state);
        let in_height = vertical(a, b) + margin < 0.0;
        if !in_height && space <= margin || group.excepted.binary_search(&pair).is_ok() {
            return None;
        }
        let off = group.off(pair)?[axis];
        let least = (a.size[axis] + b.size[axis]) / 2.0;
        let [p, q] = [a, b].map(|e| group.members[e.member].at[axis]);
        let of_pair = of(state, off).magnitude() - least;
        let of_each = (of(state, p) - of(state, q)).magnitude() - least;
        let middles = of_pair.min(of_each) + least;
        let mut why = [&a.why[..], &b.why].concat();
        if of_pair <= of_each {
            why.extend([lower(state, off), upper(state, off)]);
        } else {
            why.extend([p, q].iter().flat_map(|t| [lower(state, *t), upper(state, *t)]));
        }
        let nearest = of_pair.min(of_each);
        if nearest < 0.0 {
            return Some(Overlap { off: 0.0, middles, why });
        }
        (nearest < space - margin).then_some(Overlap { off: nearest, middles, why })
    }

    /// How far two are apart along an axis beyond touching, whichever side they are on: of a distance of their surfaces what
    /// is left where they are off each other along the other axis, or what claims about the two of them leave.
    fn kept_beside(
        &self,
        problem: &Problem,
        group: &PackingRegion<Affine>,
        [a, b]: [&Extent; 2],
        axis: usize,
        overlap: Overlap,
        state: &mut State,
    ) -> Kept {
        let pair = (b.member.min(a.member), b.member.max(a.member));
        let (space, of_space) = self.space(group, [a, b], state);
        let least = (a.size[axis] + b.size[axis]) / 2.0;
        // What discs in them keep counts, too, where it is not known how they are turned.
        let discs = a.disc + b.disc + space;
        let discs = (discs * discs - overlap.middles * overlap.middles).max(0.0).sqrt() - least;
        let left = (space * space - overlap.off * overlap.off).max(0.0).sqrt();
        let beyond = left.max(discs);
        let mut why = overlap.why;
        let told = self.told_apart(problem, group, pair, axis, least, state);
        if let Some((told, of_told)) =
            told.filter(|(told, _)| overlap.off == 0.0 && *told > beyond + 3.0 * self.contact)
        {
            why.extend(of_told);
            return Kept { beyond: told, space: told, why };
        }
        why.extend(of_space.filter(|_| space > 0.0));
        Kept { beyond, space: left, why }
    }

    /// How far beyond `least` two are apart along an axis by what claims say of how they are off each other, on both sides.
    fn told_apart(
        &self,
        problem: &Problem,
        group: &PackingRegion<Affine>,
        pair: (usize, usize),
        axis: usize,
        least: f64,
        state: &mut State,
    ) -> Option<(f64, Vec<EventId>)> {
        let off = group.off(pair)?[axis];
        let told = self.told_of(problem, &[off], state);
        if told.is_empty() {
            return None;
        }
        let mut looks = Looks::new(problem);
        let mut is_excluded = |part: Interval| looks.exclude(state, &told, &[(off, part)]);
        let mut excludes = |from: f64, to: f64| {
            let step = (to - from) / PARTS as f64;
            (0..PARTS).all(|i| {
                let (lo, hi) = (from + step * i as f64, from + step * (i + 1) as f64);
                let hi = if i + 1 == PARTS { to } else { hi };
                is_excluded(Interval::new(lo, hi)) && is_excluded(Interval::new(-hi, -lo))
            })
        };
        // Where they touch or overlap they are not, anyway.
        let from = (least - 4.0 * self.contact).max(0.0);
        let (mut lo, mut hi) = (from, from + FARTHEST);
        // Mostly nothing is said that keeps them apart at all.
        if !excludes(from, least + LEAST_TOLD) {
            state.work += looks.work;
            return None;
        }
        for _ in 0..STEPS {
            let mid = (lo + hi) / 2.0;
            if excludes(from, mid) { lo = mid } else { hi = mid }
        }
        state.work += looks.work;
        let mut why = reasons_of(&told, state);
        why.extend(state.why[off.var as usize]);
        (lo > least).then_some((lo - least, why))
    }

    /// Two that overlap otherwise are apart along an axis, on the side that is left.
    fn apart(
        &self,
        group: &PackingRegion<Affine>,
        [a, b]: [&Extent; 2],
        axis: usize,
        kept: &Kept,
        reasons: &[EventId],
        state: &mut State,
    ) -> Result<(), Conflict> {
        let pair = (b.member.min(a.member), b.member.max(a.member));
        let Some(off) = group.off(pair).map(|off| off[axis]) else { return Ok(()) };
        let space = kept.space;
        let least = (a.size[axis] + b.size[axis]) / 2.0 + kept.beyond;
        let between = of(state, off);
        let mut why = [reasons, &kept.why[..]].concat();
        if between.lo > -least && between.hi < least {
            why.extend([lower(state, off), upper(state, off)]);
            let [a, b] = [pair.0, pair.1].map(|i| self.name(group, i));
            let say = if space > 0.0 {
                format!("`{a}` and `{b}` are nearer than {} m wherever they stand", short(space))
            } else {
                format!("`{a}` and `{b}` overlap wherever they stand")
            };
            self.say(say);
            return Err(Conflict(state.event(EventKind::Conflict(Rule::Packing), &why)));
        }
        let whole = if between.lo > -least && between.lo < least {
            why.push(lower(state, off));
            Interval::from(least)
        } else if between.hi < least && between.hi > -least {
            why.push(upper(state, off));
            Interval::to(-least)
        } else {
            return Ok(());
        };
        state.bound(off.var, off.solve(whole), &why)
    }

    /// How far two that overlap in height and along an axis keep apart along the other beyond touching.
    fn space(&self, group: &PackingRegion<Affine>, [a, b]: [&Extent; 2], state: &State) -> (f64, Option<EventId>) {
        let pair = (b.member.min(a.member), b.member.max(a.member));
        // Seen from above it is less between what is at different heights.
        let vertical = vertical(a, b).max(0.0);
        let kept = group.between.iter().filter(|b| b.pair == pair && !b.of_centres);
        let most = kept.map(|b| (of(state, b.length).lo, b)).max_by(|a, b| a.0.total_cmp(&b.0));
        match most {
            Some((space, between)) if space > vertical + 3.0 * self.contact => {
                let flat = (space * space - vertical * vertical).sqrt();
                ((flat - 3.0 * self.contact).max(0.0), Some(lower(state, between.length)))
            }
            _ => (0.0, None),
        }
    }

    /// Members of which any two overlap along the other axis stand in a row along this one.
    fn rows(
        &self,
        group: &PackingRegion<Affine>,
        extents: &[Extent],
        forced: &Forced,
        axis: usize,
        reasons: &[EventId],
        state: &mut State,
    ) -> Result<(), Conflict> {
        for seed in 0..extents.len() {
            let mut row: Vec<&Extent> = vec![&extents[seed]];
            for other in extents.iter().filter(|e| e.member != extents[seed].member) {
                let pair = |e: &Extent| (e.member.min(other.member), e.member.max(other.member));
                if row.iter().all(|e| forced.contains_key(&pair(e))) {
                    row.push(other);
                }
            }
            if row.len() > 2 {
                self.row(group, &row, forced, axis, reasons, state)?;
            }
        }
        Ok(())
    }

    fn row(
        &self,
        group: &PackingRegion<Affine>,
        row: &[&Extent],
        forced: &Forced,
        axis: usize,
        reasons: &[EventId],
        state: &mut State,
    ) -> Result<(), Conflict> {
        let pairs = || {
            let n = row.len();
            (0..n)
                .flat_map(move |i| (i + 1..n).map(move |k| (row[i].member, row[k].member)))
                .map(|(a, b)| (a.min(b), a.max(b)))
        };
        let kept = || pairs().filter_map(|pair| forced.get(&pair));
        let space = kept().map(|kept| kept.space).fold(f64::INFINITY, f64::min);
        let beyond = kept().map(|kept| kept.beyond).fold(f64::INFINITY, f64::min);
        let at = |e: &&Extent| of(state, group.members[e.member].at[axis]);
        let (lo, hi) =
            row.iter().map(at).fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), i| (l.min(i.lo), h.max(i.hi)));
        let mut sizes: Vec<f64> = row.iter().map(|e| e.size[axis]).collect();
        sizes.sort_by(f64::total_cmp);
        let gaps = (row.len() - 1) as f64;
        // From the middle of the first to that of the last, if the two longest are these.
        let ends = (sizes[row.len() - 1] + sizes[row.len() - 2]) / 2.0;
        let needed = sizes.iter().sum::<f64>() - ends + gaps * beyond;
        // Some pairs keep more than others: from the first to the last it is no shorter than the least tree through all.
        let pair = |a: &Extent, b: &Extent| forced.get(&(a.member.min(b.member), a.member.max(b.member)));
        let tree = |of: &dyn Fn(&Extent, &Extent, &Kept) -> f64| {
            least_tree(row.len(), &|i, k| pair(row[i], row[k]).map_or(0.0, |kept| of(row[i], row[k], kept)))
        };
        let through = tree(&|a, b, kept| (a.size[axis] + b.size[axis]) / 2.0 + kept.beyond);
        let is_uneven = through > needed + 3.0 * self.contact;
        let needed = needed.max(through);
        if needed <= hi - lo + 1e-9 {
            return Ok(());
        }
        let mut why = reasons.to_vec();
        why.extend(row.iter().flat_map(|e| e.why.iter().copied()));
        why.extend(kept().flat_map(|kept| &kept.why));
        for e in row {
            let at = group.members[e.member].at[axis];
            why.extend([lower(state, at), upper(state, at)]);
        }
        let members: Vec<usize> = row.iter().map(|e| e.member).collect();
        // In words, what the boxes need.
        let whole: Vec<f64> = row.iter().map(|e| self.reach(group, e.member, axis, state)).collect();
        let least = whole.iter().copied().fold(f64::INFINITY, f64::min);
        let most = whole.iter().copied().fold(0.0, f64::max);
        // A row whose units touch keeps a few millimetres, which nobody asked for.
        const TOUCHING: f64 = 0.03;
        let said = if space > TOUCHING { space + 3.0 * self.contact } else { 0.0 };
        let kept = if is_uneven {
            tree(&|_, _, kept| kept.space + 3.0 * self.contact * f64::from(kept.space > 0.0))
        } else {
            gaps * said
        };
        let need = whole.iter().sum::<f64>() + kept;
        let ends = std::iter::zip(row, &whole).map(|(e, whole)| (at(e), whole / 2.0));
        let (first, last) = ends.fold((f64::INFINITY, f64::NEG_INFINITY), |(first, last), (at, half)| {
            (first.min(at.lo - half), last.max(at.hi + half))
        });
        let there = last - first;
        let each = if most - least < 0.005 { format!(" of {} m", short(most)) } else { String::new() };
        let keep = match said > 0.0 {
            true => format!(" {} m apart", short(said)),
            false if is_uneven && kept > 0.0 => format!(" with {} m between some of them", short(kept)),
            false => String::new(),
        };
        let what = self.things(group, &members);
        if need > there + 0.004 {
            self.say(format!(
                "{what}{each} in one row{keep} need {} m, but there is only room for {} m",
                short(need),
                short(there)
            ));
        } else {
            self.say(format!("{what} do not fit beside each other{keep}"));
        }
        Err(Conflict(state.event(EventKind::Conflict(Rule::Packing), &why)))
    }

    /// How far the box of an upright member reaches along an axis.
    fn reach(&self, group: &PackingRegion<Affine>, index: usize, axis: usize, state: &State) -> f64 {
        let member = &group.members[index];
        let [w, d] = [0, 2].map(|k| of(state, member.size[k]).lo);
        match of(state, member.turn[1]).magnitude() <= SKEW {
            true => [w, d][axis],
            false if of(state, member.turn[0]).magnitude() <= SKEW => [d, w][axis],
            false => w.min(d),
        }
    }
}

/// How far one is above the other, at most; less than 0 where they overlap in height.
fn vertical(a: &Extent, b: &Extent) -> f64 {
    (a.bottom - b.top).max(b.bottom - a.top)
}

/// The sum of the edges of the least tree through so many points.
fn least_tree(points: usize, length: &dyn Fn(usize, usize) -> f64) -> f64 {
    let mut nearest: Vec<f64> = (0..points).map(|i| length(0, i)).collect();
    let (mut left, mut sum): (Vec<usize>, f64) = ((1..points).collect(), 0.0);
    while let Some(next) = (0..left.len()).min_by(|i, k| nearest[left[*i]].total_cmp(&nearest[left[*k]])) {
        let at = left.swap_remove(next);
        sum += nearest[at];
        for &i in &left {
            nearest[i] = nearest[i].min(length(at, i));
        }
    }
    sum
}

impl PackingRegion<Affine> {
    /// How far the centre of the first of a pair is from that of the second, along the axes of the floor.
    pub(super) fn off(&self, pair: (usize, usize)) -> Option<[Affine; 2]> {
        let at = self.pairs.binary_search_by_key(&pair, |(pair, _)| *pair).ok()?;
        Some(self.pairs[at].1)
    }

    /// What is known of the way between two members.
    pub(super) fn ways(&self, a: usize, b: usize) -> impl Iterator<Item = &Between<Affine>> {
        self.between.iter().filter(move |between| between.pair == (a.min(b), a.max(b)))
    }
}
