//! Things that are turned alike, whichever way that is: units of one run, seats that look the same way. In each sector of
//! turns they stand along one wall, or in one row, and only so many of them fit.

use super::packing::{Packing, PackingRegion, known_of, of, short, upper};
use super::probes::{self, ProbeBox};
use super::problem::{Affine, Problem};
use super::state::{Conflict, EventId, EventKind, Rule, State};

/// So many sectors, the first about 0, and how far apart (degrees) those are that count as turned alike.
const SECTORS: usize = 24;
const ALIKE: f64 = 10.0;
/// Of more members than this it is not looked at.
const MOST: usize = 16;

/// How far apart, at most, the fronts of two are (degrees), with the reason.
type Angle = (f64, Vec<EventId>);

impl Packing<'_> {
    /// A conflict where members that are turned alike do not fit, whichever way they are turned.
    pub(super) fn turned_alike(
        &self,
        problem: &Problem,
        index: usize,
        upright: &[usize],
        reasons: &[EventId],
        state: &mut State,
    ) -> Result<(), Conflict> {
        let group = &self.groups[index];
        // Where it is known how they are turned, they need no sectors; where nothing is said of where each stands, all fit.
        let is_open = |i: &usize| {
            let turn = group.members[*i].turn.map(|t| of(state, t));
            let is_upright = of(state, group.members[*i].up).lo >= 1.0;
            is_upright
                && probes::turns(turn[0], turn[1]).is_none()
                && !self.placing(problem, (index, *i)).claims.is_empty()
        };
        let open: Vec<usize> = upright.iter().copied().filter(is_open).collect();
        if open.len() < 2 || open.len() > MOST || !group.straight {
            return Ok(());
        }
        let mut why = reasons.to_vec();
        let mut some = vec![open[0]];
        let mut within = 0.0f64;
        for &i in &open[1..] {
            let angles: Option<Vec<Angle>> = some.iter().map(|k| angle(group, [*k, i], state)).collect();
            if let Some(angles) = angles {
                for (degrees, of_angle) in angles {
                    within = within.max(degrees);
                    why.extend(of_angle);
                }
                some.push(i);
            }
        }
        if some.len() < 2 || !self.alike.borrow_mut().insert((index, some.clone())) {
            return Ok(());
        }
        let Some(fit) = self.fit_in_sectors(problem, index, &some, within, state) else { return Ok(()) };
        for &i in &some {
            why.extend(known_of(state, &group.members[i]));
            why.extend(self.placing(problem, (index, i)).reasons(state));
        }
        why.extend([upper(state, group.size[0]), upper(state, group.size[2])]);
        let [w, d] = [0, 2].map(|i| short(of(state, group.size[i]).hi));
        let widths: f64 = some.iter().map(|&i| of(state, group.members[i].size[0]).lo).sum();
        self.say(format!(
            "{}, which are {} m wide in total, do not fit beside each other where the program requires them to stand on a floor of {w} × {d} m: at most {fit} fit",
            self.things(group, &some),
            short(widths)
        ));
        Err(Conflict(state.event(EventKind::Conflict(Rule::Beside { fit: fit as u32 }), &why)))
    }

    /// How many fit in the sector where most fit, if that is always fewer than there are.
    fn fit_in_sectors(
        &self,
        problem: &Problem,
        index: usize,
        some: &[usize],
        within: f64,
        state: &mut State,
    ) -> Option<usize> {
        let group = &self.groups[index];
        let floor = [0, 2].map(|i| of(state, group.size[i]).hi + 2.0 * self.contact);
        if floor.iter().any(|f| !f.is_finite()) {
            return None;
        }
        let step = 360.0 / SECTORS as f64;
        let mut fit = 0;
        for sector in 0..SECTORS {
            let middle = step * sector as f64;
            let reach = step / 2.0 + within;
            let turns = [middle - reach, middle + reach].map(f64::to_radians);
            let kind = |own: &Self, i: usize| ProbeBox { turns, ..own.kind(group, &group.members[i], None, state) };
            let kinds: Vec<ProbeBox> = some.iter().map(|&i| kind(self, i)).collect();
            let all_cover = |points: &probes::Points, state: &mut State| {
                std::iter::zip(some, &kinds)
                    .all(|(&i, kind)| self.covers(problem, (index, i), floor, kind, points, state))
            };
            // One that cannot be turned so is enough.
            let excluded = std::iter::zip(some, &kinds)
                .take(1)
                .any(|(&i, kind)| self.covers(problem, (index, i), floor, kind, &Vec::new(), state));
            if excluded {
                continue;
            }
            let smallest = (0..some.len()).min_by(|&a, &b| {
                let side = |k: &ProbeBox| k.core[0].min(k.core[1]);
                side(&kinds[a]).total_cmp(&side(&kinds[b]))
            })?;
            let guesses = self.pierced(problem, (index, some[smallest]), floor, &kinds[smallest], some.len(), state);
            let found = guesses.into_iter().find(|points| points.len() < some.len() && all_cover(points, state))?;
            fit = fit.max(found.len());
        }
        (fit > 0).then_some(fit)
    }
}

/// How far apart the fronts of two members are at most, if they are alike.
fn angle(group: &PackingRegion<Affine>, [a, b]: [usize; 2], state: &State) -> Option<Angle> {
    if group.members[a].turn == group.members[b].turn {
        return Some((0.0, Vec::new()));
    }
    let pair = (a.min(b), a.max(b));
    let known = group.fronts.iter().filter(|(own, _)| *own == pair).map(|(_, angle)| *angle);
    let best = known.min_by(|p, q| of(state, *p).hi.total_cmp(&of(state, *q).hi))?;
    let most = of(state, best).hi;
    (most <= ALIKE).then(|| (most, vec![upper(state, best)]))
}
