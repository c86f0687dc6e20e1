//! Things that keep a distance from each other and stand within a distance of one and the same thing: only so many do.
//!
//! Seen from above, their middles are points in a circle. How small a circle can be that holds so many points that are as
//! far from each other is known (Graham, Melissen, Fodor). Where the one in the middle keeps them off, they are in a ring, and
//! any two of them are seen from there at an angle.

use super::packing::{Packing, PackingRegion, is_upright, known_of, lower, of, short, upper};
use super::problem::Affine;
use super::state::{Conflict, EventId, EventKind, Rule, State};
use std::f64::consts::TAU;

/// The radius of the smallest circle that holds 2, 3, … points at distances of at least 1, rounded down.
#[expect(clippy::approx_constant, reason = "some of them are roots, all of them are rounded down")]
const SMALLEST: [f64; 12] =
    [0.5, 0.57735, 0.70710, 0.85065, 1.0, 1.0, 1.15238, 1.30656, 1.40650, 1.46190, 1.51480, 1.61803];
/// Of more members than this, rings are not looked for.
const MOST_RINGED: usize = 40;
/// So many distances are tried.
const MOST_LENGTHS: usize = 6;

/// A member within a distance of the one in the middle.
struct Near {
    member: usize,
    /// From middle to middle, seen from above.
    length: f64,
    /// The distance that is said.
    said: f64,
    why: Vec<EventId>,
    /// At least so far.
    off: Kept,
}

/// A distance that two members keep.
struct Kept {
    length: f64,
    said: f64,
    why: Vec<EventId>,
}

/// The angle, at least, at which two points of a ring are seen from its middle that are so far from each other.
fn angle([inner, outer]: [f64; 2], apart: f64) -> f64 {
    if inner <= 0.0 || inner > outer {
        return 0.0;
    }
    // The cosine is greatest where each of the two is at one of the edges of the ring.
    let cosine = |a: f64, b: f64| (a * a + b * b - apart * apart) / (2.0 * a * b);
    let most = cosine(inner, inner).max(cosine(inner, outer)).max(cosine(outer, outer));
    most.clamp(-1.0, 1.0).acos()
}

impl Packing<'_> {
    pub(super) fn rings(
        &self,
        group: &PackingRegion<Affine>,
        apart: Option<EventId>,
        state: &mut State,
    ) -> Result<(), Conflict> {
        if group.between.is_empty() || group.members.len() > MOST_RINGED {
            return Ok(());
        }
        for hub in 0..group.members.len() {
            let mut near: Vec<Near> =
                (0..group.members.len()).filter_map(|i| self.near(group, hub, i, apart, state)).collect();
            if near.len() < 3 {
                continue;
            }
            near.sort_by(|a, b| a.length.total_cmp(&b.length));
            state.work += (near.len() * near.len()) as u64;
            self.ring(group, hub, &near, apart, state)?;
        }
        Ok(())
    }

    fn ring(
        &self,
        group: &PackingRegion<Affine>,
        hub: usize,
        near: &[Near],
        apart: Option<EventId>,
        state: &mut State,
    ) -> Result<(), Conflict> {
        let n = near.len();
        let kept: Vec<Vec<Kept>> = (0..n)
            .map(|i| (0..i).map(|k| self.kept(group, [near[k].member, near[i].member], apart, state)).collect())
            .collect();
        let mut lengths: Vec<f64> = kept.iter().flatten().map(|k| k.length).filter(|l| *l > 0.0).collect();
        lengths.sort_by(|a, b| b.total_cmp(a));
        lengths.dedup_by(|a, b| (*a - *b).abs() < 1e-9);
        for least in lengths.into_iter().take(MOST_LENGTHS) {
            let mut some: Vec<usize> = Vec::new();
            for i in 0..n {
                if some.iter().all(|&k| kept[i][k].length >= least - 1e-9) {
                    some.push(i);
                }
                let count = some.len();
                if some.last() != Some(&i) || count < 2 {
                    continue;
                }
                let (inner, outer) =
                    (some.iter().map(|&k| near[k].off.length).fold(near[i].length, f64::min), near[i].length);
                let in_circle = SMALLEST.get(count - 2).is_none_or(|smallest| outer >= (least - 1e-6) * smallest);
                let in_ring = count as f64 * angle([inner, outer], least - 1e-6) <= TAU + 1e-6;
                if in_circle && in_ring {
                    continue;
                }
                let mut why: Vec<EventId> = some.iter().flat_map(|&k| near[k].why.iter().copied()).collect();
                if in_circle {
                    why.extend(some.iter().flat_map(|&k| near[k].off.why.iter().copied()));
                }
                for (m, &p) in some.iter().enumerate() {
                    why.extend(some[..m].iter().flat_map(|&q| kept[p][q].why.iter().copied()));
                }
                let members: Vec<usize> = (0..n)
                    .filter(|&m| {
                        some.contains(&m)
                            || some.iter().all(|&k| {
                                let (p, q) = (m.max(k), m.min(k));
                                kept[p][q].length >= least - 1e-9
                            })
                    })
                    .map(|m| near[m].member)
                    .collect();
                let (within, hub) = (near[i].said, self.name(group, hub));
                let said = some.iter().enumerate().flat_map(|(m, &p)| some[..m].iter().map(move |&q| (p, q)));
                let said = said.map(|(p, q)| kept[p][q].said).fold(f64::INFINITY, f64::min);
                let keep = if said > 0.0 { format!("{} m apart ", short(said)) } else { String::new() };
                let what = self.things(group, &members);
                self.say(format!(
                    "{what} {keep}do not fit within {} m of `{hub}`: at most {} fit",
                    short(within),
                    count - 1
                ));
                return Err(Conflict(state.event(EventKind::Conflict(Rule::Beside { fit: count as u32 - 1 }), &why)));
            }
        }
        Ok(())
    }

    /// A member within a distance of another: of their surfaces, or of their centres.
    fn near(
        &self,
        group: &PackingRegion<Affine>,
        hub: usize,
        member: usize,
        apart: Option<EventId>,
        state: &State,
    ) -> Option<Near> {
        if hub == member {
            return None;
        }
        let both = [&group.members[hub], &group.members[member]];
        let half = |i: usize| [0, 2].map(|k| of(state, both[i].size[k]).hi).into_iter().fold(0.0, f64::hypot) / 2.0;
        let of_way = |b: &super::packing::Between<Affine>| {
            let said = of(state, b.length).hi;
            let length = if b.of_centres { said } else { said.max(0.0) + half(0) + half(1) + 3.0 * self.contact };
            let mut why = vec![upper(state, b.length)];
            if !b.of_centres {
                let sizes = both.iter().flat_map(|m| [m.size[0], m.size[2]]);
                why.extend(sizes.map(|s| upper(state, s)));
                why.extend(both.iter().map(|m| lower(state, m.up)));
            }
            (length, said, why)
        };
        let upright = both.iter().all(|m| is_upright(state, m) && of(state, m.up).lo >= 1.0);
        let ways = group.ways(hub, member).filter(|b| b.of_centres || upright).map(of_way);
        let nearest = ways.filter(|(length, ..)| length.is_finite()).min_by(|a, b| a.0.total_cmp(&b.0));
        let (length, said, why) = nearest?;
        Some(Near { member, length, said, why, off: self.kept(group, [hub, member], apart, state) })
    }

    /// The distance between the middles of two members, seen from above, at least.
    fn kept(&self, group: &PackingRegion<Affine>, pair: [usize; 2], apart: Option<EventId>, state: &State) -> Kept {
        let both = pair.map(|i| &group.members[i]);
        let mut best = Kept { length: 0.0, said: 0.0, why: Vec::new() };
        for b in group.ways(pair[0], pair[1]).filter(|b| b.of_centres) {
            let center = |i: usize| (of(state, both[i].bottom) + of(state, both[i].top)).scale(0.5);
            let (said, off) = (of(state, b.length).lo, (center(0) - center(1)).magnitude());
            let length = (said * said - off * off).max(0.0).sqrt();
            if said > 0.0 && length > best.length {
                let heights = both.iter().flat_map(|m| [m.bottom, m.top]);
                let why = heights.flat_map(|t| [lower(state, t), upper(state, t)]).chain([lower(state, b.length)]);
                best = Kept { length, said, why: why.collect() };
            }
        }
        // Discs in what is solid of both, at one height.
        let cores = both.map(|m| m.core.filter(|_| is_upright(state, m) && of(state, m.up).lo >= 1.0));
        // In words, it is the distance of the surfaces that counts, where one is known.
        let surfaces = group.ways(pair[0], pair[1]).filter(|b| !b.of_centres).map(|b| of(state, b.length).lo);
        let surfaces = surfaces.fold(0.0, f64::max);
        if surfaces > 0.0 {
            best.said = surfaces;
        }
        let [Some(p), Some(q)] = cores else { return best };
        let over = |a: &super::packing::Core<Affine>, b: &super::packing::Core<Affine>| {
            of(state, a.bottom).hi < of(state, b.top).lo - 4.0 * self.contact
        };
        if !over(&p, &q) || !over(&q, &p) {
            return best;
        }
        let round = |c: &super::packing::Core<Affine>| {
            c.size.map(|s| of(state, s).lo).into_iter().fold(f64::INFINITY, f64::min) / 2.0
        };
        let excepted = group.excepted.binary_search(&(pair[0].min(pair[1]), pair[0].max(pair[1]))).is_ok();
        let touch = apart.filter(|_| !excepted).map(|why| (0.0, why));
        let ways = group.ways(pair[0], pair[1]).filter(|b| !b.of_centres);
        let ways = ways.map(|b| (of(state, b.length).lo, lower(state, b.length))).filter(|(l, _)| *l > 0.0);
        for (space, because) in ways.chain(touch) {
            let length = space + round(&p) + round(&q) - 4.0 * self.contact;
            if length > best.length {
                let mut why: Vec<EventId> = both.iter().flat_map(|m| known_of(state, m)).collect();
                why.extend([p, q].iter().flat_map(|c| [upper(state, c.bottom), lower(state, c.top)]));
                why.push(because);
                best = Kept { length, said: surfaces, why };
            }
        }
        best
    }
}
