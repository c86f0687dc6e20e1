//! Why a disc does not get through: the narrowest place on the widest way, and what it is between.
//!
//! The widest disc that passes is found by bisection. Where ways of greater width end, two things that block stand just
//! that far apart; of all pairs that do, the one is meant without whose gap there is no way of that width.

use super::free::{Floor, Ground, Obstacle};
use super::{COARSE, NEAR};
use scenelang_lang::program::{ObjectId, RegionId};
use scenelang_layout::Vec2;
use scenelang_layout::planar::{depth_in_convex, edges, nearest_of_segments, nearest_on_segment};
use std::ops::RangeInclusive;
use std::sync::{Arc, Mutex, PoisonError};

/// The radius of the widest disc is found to this (metres).
const PRECISION: f64 = 2e-4;
/// Two things are as far apart as the disc is wide if it is by no more than this (metres): rounding, and the corners of
/// what should be arcs.
const FIT: f64 = 2e-3;
/// So many pairs are asked whether they are the one.
const MOST: usize = 12;

/// The narrowest place on the widest way.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Bottleneck {
    /// Diameter of the widest disc that passes (metres).
    pub width: f64,
    /// What it is between, in the order of [`Self::at`].
    pub between: [Blocker; 2],
    /// Their nearest points (world x, z).
    pub at: [Vec2; 2],
    /// Where the disc cannot even stand near one end, that end: 0 or 1.
    pub end: Option<usize>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Blocker {
    Object(ObjectId),
    Wall(RegionId),
    /// A side of the opening of a door.
    Door(ObjectId),
    /// The edge of the floor, where no region is near.
    Edge,
}

/// A place where two things that block come near each other.
pub(super) struct Gap {
    /// Metres.
    pub width: f64,
    /// What blocks, by index into [`Ground::obstacles`].
    pub between: [usize; 2],
    /// Their nearest points.
    pub at: [Vec2; 2],
}

/// The narrowest place on the widest way between two footprints, which is known not to be wide enough for a disc of
/// `radius`; with the end beside which it is, if it is an end. `None`: there is no way at all.
pub(super) fn find(tried: &Tried, ends: [&[Vec2]; 2], radius: f64) -> Option<(Gap, Option<usize>)> {
    let ground = &tried.ground;
    let (mut passes, mut fails) = (FIT, radius);
    if fails <= passes || !Try::new(tried, ends, passes, None).is_way() {
        return None;
    }
    // Nearly always the widest disc is as wide as two things are apart.
    let apart = gaps(&ground.obstacles, 0.0..=2.0 * fails);
    let mut halves: Vec<f64> = apart.iter().map(|gap| gap.width / 2.0).collect();
    halves.sort_by(f64::total_cmp);
    halves.dedup_by(|a, b| *a - *b < PRECISION / 4.0);
    while fails - passes > PRECISION {
        let radius = next_radius(&halves, passes, fails);
        if Try::new(tried, ends, radius, None).is_way() {
            passes = radius;
        } else {
            fails = radius;
        }
    }
    let last = Try::new(tried, ends, passes, None);
    let beyond = Try::new(tried, ends, fails, None);
    // Where a disc that is a hair wider has no place near an end at all, that place is the bottleneck.
    let end = (0..2).find(|&i| beyond.pieces[i].is_empty());
    if let Some(i) = end {
        let place = last.common().and_then(|piece| last.place(ends[i], piece))?;
        let gap = beside(ground, place)?;
        return Some((Gap { width: 2.0 * passes, ..gap }, end));
    }
    let width = 2.0 * passes;
    let mut gaps = gaps(&ground.obstacles, width - FIT..=width + FIT);
    gaps.sort_by(|a, b| (a.width - width).abs().total_cmp(&(b.width - width).abs()).then(a.between.cmp(&b.between)));
    gaps.truncate(MOST);
    let separates = |gap: &&Gap| {
        // A hair's breadth within the gap; with it closed there is no way of nearly that width.
        let [p, q] = gap.at;
        !Try::new(tried, ends, passes - 2.0 * FIT, Some([p, q])).is_way()
    };
    let which = gaps.iter().position(|gap| separates(&gap)).unwrap_or(0);
    (!gaps.is_empty()).then(|| (gaps.swap_remove(which), None))
}

/// What closes the way where there is none of any width: as few objects as will do, the nearest to an end first, without
/// which a disc of `radius` gets through or, where it never does, one of any width; as indices into [`Ground::obstacles`].
/// The objects at the ends are none of them. Empty: the walls close it.
pub(super) fn closing(ground: &Ground, ends: [&[Vec2]; 2], own: [ObjectId; 2], radius: f64) -> Vec<usize> {
    let far = |i: usize| {
        let to = |end: &[Vec2]| nearest_points(end, &ground.obstacles[i].outline).map_or(0.0, |(p, q)| (q - p).norm());
        ends.iter().map(|end| to(end)).fold(f64::INFINITY, f64::min)
    };
    let may = |i: &usize| ground.obstacles[*i].object.is_some_and(|id| !own.contains(&id));
    let mut near: Vec<(f64, usize)> = (0..ground.obstacles.len()).filter(may).map(|i| (far(i), i)).collect();
    near.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
    let near: Vec<usize> = near.into_iter().map(|(_, i)| i).collect();
    let opens =
        |without: &[usize], radius: f64| Try::new(&Tried::new(ground.without(without)), ends, radius, None).is_way();
    let Some(radius) = [radius, FIT].into_iter().find(|radius| opens(&near, *radius)) else { return Vec::new() };
    // Without more of them there is a way all the more.
    let (mut closed, mut open) = (0, near.len());
    while open - closed > 1 {
        let middle = usize::midpoint(closed, open);
        if opens(&near[..middle], radius) {
            open = middle;
        } else {
            closed = middle;
        }
    }
    let mut found = near[..open].to_vec();
    // The last of them is needed; of the others those that are not are put back, the farthest first.
    for i in near[..open.saturating_sub(1)].iter().rev().take(MOST) {
        let fewer: Vec<usize> = found.iter().copied().filter(|other| other != i).collect();
        if opens(&fewer, radius) {
            found = fewer;
        }
    }
    found
}

/// The radius to try next: it halves the number of gaps between things that may be the one (half their widths, sorted), then
/// comes close to the last of them from both sides, and halves what remains if that was not it.
fn next_radius(gaps: &[f64], passes: f64, fails: f64) -> f64 {
    let close = PRECISION / 4.0;
    let open: Vec<f64> = gaps.iter().copied().filter(|gap| gap - close > passes && gap - close < fails).collect();
    let Some(last) = open.last() else { return f64::midpoint(passes, fails) };
    // Round corners are inscribed, so that a disc that is a little wider gets through as well.
    let beyond = open[(open.len() - 1) / 2] + FIT;
    if open.len() > 1 && beyond < fails {
        beyond
    } else if last + close < fails {
        last + close
    } else {
        last - close
    }
}

/// The radius of a disc, and a gap that is closed for it.
type Trial = (f64, Option<[Vec2; 2]>);

/// The ground, and the floors on it for discs that were tried: many ways are barred at the same places.
#[derive(Debug)]
pub(super) struct Tried {
    pub ground: Ground,
    floors: Mutex<Vec<(Trial, Arc<Floor>)>>,
}

impl Tried {
    pub fn new(ground: Ground) -> Self {
        Self { ground, floors: Mutex::default() }
    }
    fn floor(&self, radius: f64, further: Option<[Vec2; 2]>) -> Arc<Floor> {
        let mut floors = self.floors.lock().unwrap_or_else(PoisonError::into_inner);
        let key = (radius, further);
        if let Some((_, floor)) = floors.iter().find(|(known, _)| *known == key) {
            return Arc::clone(floor);
        }
        let floor = Arc::new(self.ground.free(radius, COARSE, further.as_ref().map(<[Vec2; 2]>::as_slice)));
        floors.push((key, Arc::clone(&floor)));
        floor
    }
}

/// A disc of some radius set out between two ends.
struct Try {
    floor: Arc<Floor>,
    reach: f64,
    /// On which pieces of the floor each end is.
    pieces: [Vec<usize>; 2],
}

impl Try {
    fn new(tried: &Tried, ends: [&[Vec2]; 2], radius: f64, further: Option<[Vec2; 2]>) -> Self {
        let floor = tried.floor(radius.max(0.0), further);
        let reach = radius.max(0.0) + NEAR;
        Self { pieces: ends.map(|end| floor.pieces_near(end, reach, COARSE)), floor, reach }
    }
    /// A piece of the floor on which both ends are.
    fn common(&self) -> Option<usize> {
        self.pieces[0].iter().copied().find(|piece| self.pieces[1].contains(piece))
    }
    /// Some place near an end, on a piece.
    fn place(&self, end: &[Vec2], piece: usize) -> Option<Vec2> {
        self.floor.places(end, self.reach, COARSE)[piece].some()
    }
    fn is_way(&self) -> bool {
        self.common().is_some()
    }
}

/// Pairs that stand so far apart (metres) and have nothing else in between.
fn gaps(obstacles: &[Obstacle], widths: RangeInclusive<f64>) -> Vec<Gap> {
    let spans: Vec<[Vec2; 2]> = obstacles.iter().map(|o| span(&o.outline)).collect();
    let mut order: Vec<usize> = (0..obstacles.len()).collect();
    order.sort_by(|&i, &j| spans[i][0].x.total_cmp(&spans[j][0].x).then(i.cmp(&j)));
    let reach = *widths.end();
    let mut found = Vec::new();
    for (place, &i) in order.iter().enumerate() {
        for &j in order[place + 1..].iter().take_while(|&&j| spans[j][0].x <= spans[i][1].x + reach) {
            if spans[j][0].y > spans[i][1].y + reach || spans[i][0].y > spans[j][1].y + reach {
                continue;
            }
            let between = [i.min(j), i.max(j)];
            let [a, b] = between.map(|k| &obstacles[k].outline);
            let Some((p, q)) = nearest_points(a, b) else { continue };
            let (gap, middle) = ((q - p).norm(), (p + q) / 2.0);
            let free = |o: &Obstacle| -depth_in_convex(&o.outline, middle) >= gap / 2.0 - FIT;
            if widths.contains(&gap) && obstacles.iter().all(free) {
                found.push(Gap { width: gap, between, at: [p, q] });
            }
        }
    }
    found
}

/// The least and the greatest corner of the upright rectangle around an outline.
fn span(outline: &[Vec2]) -> [Vec2; 2] {
    let low = outline.iter().fold(Vec2::repeat(f64::INFINITY), |m, p| m.inf(p));
    [low, outline.iter().fold(Vec2::repeat(f64::NEG_INFINITY), |m, p| m.sup(p))]
}

/// The nearest points of two outlines.
fn nearest_points(a: &[Vec2], b: &[Vec2]) -> Option<(Vec2, Vec2)> {
    let pairs = edges(a).flat_map(|(p, q)| edges(b).map(move |(r, s)| nearest_of_segments([&p, &q], [&r, &s])));
    pairs.min_by(|x, y| (x.1 - x.0).norm_squared().total_cmp(&(y.1 - y.0).norm_squared()))
}

/// What a disc at a place is between: what is nearest to it, and what is nearest on its other side.
fn beside(ground: &Ground, place: Vec2) -> Option<Gap> {
    let nearest = |outline: &[Vec2]| {
        let points = edges(outline).map(|(a, b)| nearest_on_segment(&place, &a, &b));
        points.min_by(|p, q| (p - place).norm_squared().total_cmp(&(q - place).norm_squared()))
    };
    let mut near: Vec<(f64, usize, Vec2)> = ground
        .obstacles
        .iter()
        .enumerate()
        .filter_map(|(i, o)| nearest(&o.outline).map(|p| ((p - place).norm(), i, p)))
        .collect();
    near.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
    let (_, first, p) = *near.first()?;
    // Two walls that meet in a corner touch the disc as well; the other side is where it is squeezed.
    let across = |q: Vec2| (p - place).dot(&(q - place));
    let touching = near.iter().skip(1).take_while(|(d, ..)| *d <= near[0].0 + FIT);
    let (_, second, q) = *touching.min_by(|a, b| across(a.2).total_cmp(&across(b.2))).or(near.get(1))?;
    Some(Gap { width: (q - p).norm(), between: [first, second], at: [p, q] })
}
