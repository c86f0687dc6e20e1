//! Where rooms stand: those that a door joins share a piece of wall that is wide enough for it, and all stand apart by
//! the thickness of their two walls.
//!
//! Rooms are placed one by one, the one with the most doors first, each where it fits best beside those that stand. A
//! room whose size nobody gave grows where its neighbours do not find room along it. An outline counts by the rectangle
//! around it.

use crate::draft::{Draft, Note, ThingOrigin};

/// The distance of neighbouring rooms: a wall of 3 cm each (metres).
pub const WALL: f64 = 0.06;

/// What remains of the shared wall at the sides of a door, together (metres).
const JAMBS: f64 = 0.2;

/// How often a room may grow, and by how much (metres).
const GROWTH: (usize, f64) = (16, 1.0);

/// More rooms than these are put in a row.
const MOST: usize = 48;

/// How many of the best places of a room are held against its windows.
const LOOKED_AT: usize = 24;

/// A rectangle: its middle, and half its width and depth.
#[derive(Clone, Copy, Debug)]
struct Plot {
    at: [f64; 2],
    half: [f64; 2],
}

impl Plot {
    fn low(&self, axis: usize) -> f64 {
        self.at[axis] - self.half[axis]
    }
    fn high(&self, axis: usize) -> f64 {
        self.at[axis] + self.half[axis]
    }
    /// The distance along an axis; negative where they overlap.
    fn gap(&self, other: &Self, axis: usize) -> f64 {
        (self.low(axis) - other.high(axis)).max(other.low(axis) - self.high(axis))
    }
    fn apart(&self, other: &Self) -> bool {
        self.gap(other, 0).max(self.gap(other, 1)) >= WALL - 1e-6
    }
    /// How long the wall is that they share.
    fn shared(&self, other: &Self) -> f64 {
        let [x, z] = [self.gap(other, 0), self.gap(other, 1)];
        if (x - WALL).abs() < 1e-6 {
            (-z).max(0.0)
        } else if (z - WALL).abs() < 1e-6 {
            (-x).max(0.0)
        } else {
            0.0
        }
    }
}

/// Sets `at` of all rooms, and moves their outlines along. An opening for which no place is found leads to the outside
/// of its first room, and a note says so.
pub fn arrange_rooms(draft: &mut Draft) {
    for opening in &mut draft.openings {
        opening.rooms.retain(|room| *room < draft.rooms.len());
    }
    let mut places = place(draft);
    for _ in 0..GROWTH.0 {
        let unmet = unmet(draft, &places);
        let room = unmet.iter().flat_map(|at| draft.openings[*at].rooms.clone());
        let free = room.filter(|room| !draft.rooms[*room].sized && draft.rooms[*room].outline.is_none());
        let Some(room) = free.max_by_key(|room| (doors(draft, *room), std::cmp::Reverse(*room))) else { break };
        let size = &mut draft.rooms[room].size;
        let along = if size[0] >= size[2] { 0 } else { 2 };
        size[along] += GROWTH.1;
        places = place(draft);
    }
    for at in unmet(draft, &places) {
        let opening = &mut draft.openings[at];
        opening.rooms.truncate(1);
        let words = match &opening.source {
            ThingOrigin::Stated(at) => at.clone(),
            ThingOrigin::Inferred(_) => 0..0,
        };
        let reason = format!("no arrangement was found in which the rooms of `{}` share a wall", opening.name);
        draft.notes.push(Note { at: words, reason });
    }
    for (room, place) in draft.rooms.iter_mut().zip(&places) {
        let middle = outline_box(room.outline.as_deref()).map_or(room.at, |plot| plot.at);
        for point in room.outline.iter_mut().flatten() {
            *point = [0, 1].map(|axis| rounded(point[axis] - middle[axis] + place.at[axis]));
        }
        room.at = place.at.map(rounded);
    }
}

/// Whether the rooms stand as they should: apart, and sharing walls where doors join them.
pub fn is_arranged(draft: &Draft) -> bool {
    let places: Vec<Plot> = (0..draft.rooms.len()).map(|room| plot(draft, room)).collect();
    let apart = |a: usize| (a + 1..places.len()).all(|b| places[a].apart(&places[b]));
    (0..places.len()).all(apart) && unmet(draft, &places).is_empty()
}

fn rounded(metres: f64) -> f64 {
    (metres * 1e4).round() / 1e4
}

/// The rectangle around an outline.
fn outline_box(outline: Option<&[[f64; 2]]>) -> Option<Plot> {
    let outline = outline.filter(|points| !points.is_empty())?;
    let bound = |axis: usize| {
        let along = outline.iter().map(|point| point[axis]);
        along.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), v| (low.min(v), high.max(v)))
    };
    let (x, z) = (bound(0), bound(1));
    Some(Plot { at: [(x.0 + x.1) / 2.0, (z.0 + z.1) / 2.0], half: [(x.1 - x.0) / 2.0, (z.1 - z.0) / 2.0] })
}

/// The rectangle of a room where it stands now.
fn plot(draft: &Draft, room: usize) -> Plot {
    let room = &draft.rooms[room];
    let own = Plot { at: room.at, half: [room.size[0] / 2.0, room.size[2] / 2.0] };
    outline_box(room.outline.as_deref()).unwrap_or(own)
}

/// How many openings join a room with another.
fn doors(draft: &Draft, room: usize) -> usize {
    draft.openings.iter().filter(|o| o.rooms.len() == 2 && o.rooms.contains(&room)).count()
}

/// How much wall the openings between each two rooms need; 0: there is none.
fn needs(draft: &Draft) -> Vec<Vec<f64>> {
    let count = draft.rooms.len();
    let mut needs = vec![vec![0.0; count]; count];
    for opening in &draft.openings {
        if let [a, b] = *opening.rooms.as_slice()
            && a != b
        {
            needs[a][b] += opening.size[0] + JAMBS;
            needs[b][a] = needs[a][b];
        }
    }
    needs
}

/// The openings between rooms that do not share enough wall.
fn unmet(draft: &Draft, places: &[Plot]) -> Vec<usize> {
    let needs = needs(draft);
    let joins = draft.openings.iter().enumerate().filter(|(_, o)| o.rooms.len() == 2 && o.rooms[0] != o.rooms[1]);
    let short = joins.filter(|(_, o)| {
        let (a, b) = (o.rooms[0], o.rooms[1]);
        places[a].shared(&places[b]) < needs[a][b] - 1e-6
    });
    short.map(|(at, _)| at).collect()
}

/// What rooms are lined up by, where there is a choice: their middles, or their edges on one side.
const LINES: [f64; 3] = [0.0, -1.0, 1.0];

/// Places all rooms: lined up in the way that meets the most openings.
fn place(draft: &Draft) -> Vec<Plot> {
    let needs = needs(draft);
    let tried = LINES.map(|line| place_along(draft, &needs, line));
    let best = tried.into_iter().min_by_key(|places| unmet(draft, places).len());
    best.unwrap_or_default()
}

fn place_along(draft: &Draft, needs: &[Vec<f64>], line: f64) -> Vec<Plot> {
    let count = draft.rooms.len();
    let mut places: Vec<Plot> = (0..count).map(|room| plot(draft, room)).collect();
    if count > MOST {
        let mut x = 0.0;
        for place in &mut places {
            place.at = [x + place.half[0], 0.0];
            x += 2.0 * place.half[0] + WALL;
        }
        return places;
    }
    let mut standing: Vec<usize> = Vec::new();
    while standing.len() < count {
        let joined = |room: usize| standing.iter().filter(|other| needs[room][**other] > 0.0).count();
        let left = (0..count).filter(|room| !standing.contains(room));
        let Some(next) = left.max_by_key(|room| (joined(*room), doors(draft, *room), std::cmp::Reverse(*room))) else {
            break;
        };
        places[next].at =
            if standing.is_empty() { [0.0; 2] } else { best(draft, needs, &places, &standing, (next, line)) };
        standing.push(next);
    }
    places
}

/// The best place for a room beside those that stand.
fn best(
    draft: &Draft,
    needs: &[Vec<f64>],
    places: &[Plot],
    standing: &[usize],
    (room, line): (usize, f64),
) -> [f64; 2] {
    let half = places[room].half;
    let mut found: Vec<([f64; 3], [f64; 2])> = Vec::new();
    for at in candidates(&needs[room], places, standing, half) {
        let here = Plot { at, half };
        if !standing.iter().all(|other| here.apart(&places[*other])) {
            continue;
        }
        let met = standing.iter().filter(|other| {
            let needed = needs[room][**other];
            needed > 0.0 && here.shared(&places[**other]) >= needed - 1e-6
        });
        let met = met.count() as f64;
        let all = || standing.iter().map(|other| places[*other]).chain([here]);
        let span = |axis: usize| {
            let high = all().map(|p| p.high(axis)).fold(f64::NEG_INFINITY, f64::max);
            high - all().map(|p| p.low(axis)).fold(f64::INFINITY, f64::min)
        };
        // Little ground first; then lines near the others' lines.
        let lines = |plot: &Plot| [0, 1].map(|axis| plot.at[axis] + line * plot.half[axis]);
        let off = |other: &Plot| {
            let ([x, z], [u, v]) = (lines(&here), lines(other));
            (x - u).abs() + (z - v).abs()
        };
        let far: f64 = standing.iter().map(|other| off(&places[*other])).sum();
        found.push(([-met, rounded(span(0) * span(1)), rounded(far)], at));
    }
    found.sort_by(|(a, _), (b, _)| a.partial_cmp(b).unwrap_or(std::cmp::Ordering::Equal));
    let most_met = found.first().map_or(0.0, |(score, _)| score[0]);
    let good = found.iter().take_while(|(score, _)| score[0] == most_met).take(LOOKED_AT);
    // Of the best, one that leaves the windows and outer doors their walls.
    let lit = |at: [f64; 2]| {
        let mut all: Vec<(usize, Plot)> = standing.iter().map(|other| (*other, places[*other])).collect();
        all.push((room, Plot { at, half }));
        all.iter().filter(|(own, plot)| has_outer_wall(draft, *own, plot, &all)).count()
    };
    let chosen = good.enumerate().max_by_key(|(order, (_, at))| (lit(*at), std::cmp::Reverse(*order)));
    let beyond = standing.iter().map(|other| places[*other].high(0)).fold(0.0, f64::max);
    chosen.map_or([beyond + WALL + half[0], 0.0], |(_, (_, at))| *at)
}

/// Places that touch a standing room: in line with it, next to what touches it too, or just far enough along what a
/// door joins with the new room.
fn candidates(needs: &[f64], places: &[Plot], standing: &[usize], half: [f64; 2]) -> Vec<[f64; 2]> {
    let mut out = Vec::new();
    for other in standing.iter().map(|other| places[*other]) {
        let near = |third: &usize| {
            let third = &places[*third];
            other.gap(third, 0).max(other.gap(third, 1)) <= 2.0 * WALL
        };
        let thirds: Vec<usize> = standing.iter().copied().filter(|third| needs[*third] > 0.0 || near(third)).collect();
        for (across, side) in [(0, 1.0), (1, 1.0), (0, -1.0), (1, -1.0)] {
            let along = 1 - across;
            let fixed = other.at[across] + side * (other.half[across] + WALL + half[across]);
            let mut offsets = vec![other.at[along], other.low(along) + half[along], other.high(along) - half[along]];
            for third in &thirds {
                let (plot, needed) = (places[*third], needs[*third]);
                offsets.push(plot.low(along) - WALL - half[along]);
                offsets.push(plot.high(along) + WALL + half[along]);
                if needed > 0.0 {
                    offsets.push(plot.low(along) + needed - half[along]);
                    offsets.push(plot.high(along) - needed + half[along]);
                }
            }
            for offset in offsets {
                let mut at = [0.0; 2];
                (at[across], at[along]) = (fixed, offset);
                out.push(at);
            }
        }
    }
    out
}

/// Whether a room with openings to the outside has a free piece of outer wall for the widest of them.
fn has_outer_wall(draft: &Draft, room: usize, plot: &Plot, all: &[(usize, Plot)]) -> bool {
    let outer = draft.openings.iter().filter(|opening| opening.rooms == [room]);
    let Some(widest) = outer.map(|opening| opening.size[0] + JAMBS).reduce(f64::max) else { return true };
    let free = |across: usize, side: f64| {
        let along = 1 - across;
        let wall = Plot {
            at: if across == 0 {
                [plot.at[0] + side * (plot.half[0] + WALL), plot.at[1]]
            } else {
                [plot.at[0], plot.at[1] + side * (plot.half[1] + WALL)]
            },
            half: if across == 0 { [WALL, plot.half[1]] } else { [plot.half[0], WALL] },
        };
        let mut taken: Vec<(f64, f64)> = all
            .iter()
            .filter(|(other, p)| *other != room && p.gap(&wall, 0) < 0.0 && p.gap(&wall, 1) < 0.0)
            .map(|(_, p)| (p.low(along), p.high(along)))
            .collect();
        taken.sort_by(|a, b| a.0.total_cmp(&b.0));
        let (mut run, mut from) = (0.0_f64, plot.low(along));
        for (low, high) in taken.into_iter().chain([(plot.high(along), plot.high(along))]) {
            run = run.max(low - from);
            from = from.max(high);
        }
        run
    };
    [(0, 1.0), (0, -1.0), (1, 1.0), (1, -1.0)].into_iter().any(|(across, side)| free(across, side) >= widest)
}
