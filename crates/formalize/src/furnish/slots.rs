//! Where the parts of a group are, in the frame of the thing that they go with: metres to its right and to its front,
//! a height, a turn. No statement is written here.

use super::groups::{Along, Where};

/// Height of a part's base.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Level {
    /// The floor that the other thing stands on.
    Floor,
    /// The top of the other thing.
    Top,
    /// So far above the base of the other thing.
    At(f64),
    /// Under the ceiling.
    Ceiling,
    /// On the wall behind the other thing, so far above its top.
    Above(f64),
}

/// A place for one part.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Slot {
    /// To the right of the other thing's middle.
    pub x: f64,
    /// To its front.
    pub z: f64,
    /// Height of the base.
    pub level: Level,
    /// Turn, in degrees.
    pub yaw: f64,
}

/// What the place of a part depends on.
pub struct Sizes {
    /// Of the thing it goes with.
    pub of: [f64; 3],
    pub own: [f64; 3],
    /// Whether the other thing is round or oval, seen from above.
    pub round: bool,
}

/// L-shaped desks and sofas are at least so deep; others have low tables and chairs so far before them (metres).
pub const BENT: f64 = 1.2;
const LOW: f64 = 0.6;
const BEFORE_SEATS: f64 = 0.42;
const AT_DESKS: f64 = 0.05;

/// The group of what stands around a low table there.
pub const CORNER_TABLE: &str = "corner table";

/// Whether a part stands in the corner of what it goes with: a low table in that of a sofa.
pub fn in_corner(at: &Where, sizes: &Sizes) -> bool {
    matches!(at, Where::Front(gap, ..) if *gap < 0.0) && sizes.of[2] >= BENT && sizes.own[1] < LOW
}

/// The places of the parts of one kind.
pub fn slots(at: &Where, sizes: &Sizes, shelf: &[f64]) -> Vec<Slot> {
    let ([width, height, depth], [w, _, d]) = (sizes.of, sizes.own);
    let slot = |x: f64, z: f64, level: Level, yaw: f64| Slot { x, z, level, yaw };
    let beside = |gap: f64, along: Along, left: f64, yaw: f64| {
        let (w, d) = if (yaw / 90.0).round() as i64 % 2 == 0 { (w, d) } else { (d, w) };
        let z = match along {
            Along::Backs => (d - depth) / 2.0,
            Along::Middle => 0.0,
            Along::Fronts => (depth - d) / 2.0,
        };
        slot(-left * (width / 2.0 + gap + w / 2.0), z, Level::Floor, yaw)
    };
    match *at {
        // What is no deeper than usual has no corner to stand in.
        Where::Front(gap, yaw, _) if gap < 0.0 && depth < BENT => {
            let gap = if sizes.own[1] < LOW { BEFORE_SEATS } else { AT_DESKS };
            vec![slot(0.0, depth / 2.0 + gap + d / 2.0, Level::Floor, yaw)]
        }
        Where::Front(gap, yaw, x) => vec![slot(x * width / 2.0, depth / 2.0 + gap + d / 2.0, Level::Floor, yaw)],
        Where::Back(gap, yaw) => vec![slot(0.0, -depth / 2.0 - gap - d / 2.0, Level::Floor, yaw)],
        Where::Side(gap, along, left, yaw) => vec![beside(gap, along, left, yaw)],
        Where::Sides(gap, along) => vec![beside(gap, along, 1.0, 0.0), beside(gap, along, -1.0, 0.0)],
        Where::Row(n, gap) | Where::RowBehind(n, gap) => {
            // Behind it there is room beyond its ends.
            let beyond = if matches!(at, Where::RowBehind(..)) { 0.25 } else { 0.0 };
            let most = in_row(width + beyond, w);
            let n = if n == 0 { most } else { n.min(most) };
            let step = width / n as f64;
            let z = depth / 2.0 + gap + d / 2.0;
            let (z, yaw) = if matches!(at, Where::RowBehind(..)) { (-z, 0.0) } else { (z, 180.0) };
            (0..n).map(|i| slot(step * (i as f64 + 0.5) - width / 2.0, z, Level::Floor, yaw)).collect()
        }
        Where::Top(x, z, yaw) => {
            // A turned thing takes as much as its diagonal.
            let turned = yaw.to_radians();
            let (across, along) = (
                (w * turned.cos()).abs() + (d * turned.sin()).abs(),
                (w * turned.sin()).abs() + (d * turned.cos()).abs(),
            );
            if across > width || along > depth {
                return Vec::new();
            }
            vec![slot(x * (width - across) / 2.0, z * (depth - along) / 2.0, Level::Top, yaw)]
        }
        Where::Board(board, x, n) => {
            let Some(y) = shelf.get(board) else { return Vec::new() };
            let free = width - 0.06;
            let step = w + 0.004;
            let n = n.min((free / step) as usize);
            let middle = x * (free - step * n as f64) / 2.0;
            let first = middle - step * (n as f64 - 1.0) / 2.0;
            (0..n).map(|i| slot(first + step * i as f64, 0.0, Level::At(*y), 0.0)).collect()
        }
        Where::Around(n, gap) | Where::LongSides(n, gap) if sizes.round => circle(n, gap, sizes),
        Where::Around(n, gap) => around(n, gap, sizes, true),
        Where::LongSides(n, gap) => around(n, gap, sizes, false),
        Where::Outside(n, gap) => outside(n, gap, sizes),
        Where::Under(_, _, z) => vec![slot(0.0, z, Level::Floor, 0.0)],
        Where::Over => {
            // One light for each so much of a long table, but a chandelier alone.
            let n = if w < SINGLE { (width / LIT).ceil().clamp(1.0, 4.0) } else { 1.0 };
            let at = |i: usize| slot(((i as f64 + 0.5) / n - 0.5) * width, 0.0, Level::Ceiling, 0.0);
            (0..n as usize).map(at).collect()
        }
        Where::Above(gap, x) => vec![slot(x * width / 2.0, (d - depth) / 2.0, Level::Above(height + gap), 0.0)],
        Where::Enclose(_, behind) => vec![slot(0.0, (INSIDE - behind) / 2.0, Level::Floor, 0.0)],
    }
}

/// One pendant lamp lights this length of a table (metres); a lamp as wide as the second hangs alone.
const LIT: f64 = 1.5;
const SINGLE: f64 = 0.6;
/// Who works at what is fenced in has so much room before it (metres).
const INSIDE: f64 = 1.0;
/// What is as deep is no single panel.
pub const THIN: f64 = 0.5;
/// The thickness of a fence, and the width of the way in through its front.
const FENCE: f64 = 0.05;
const GATE: f64 = 0.9;

/// The size of a fence around a thing, as far from its sides and its back as is said.
pub fn enclosure([w, h, d]: [f64; 3], beside: f64, behind: f64, high: f64) -> [f64; 3] {
    [w + 2.0 * beside, high.max((h + 0.1).min(1.8)), d + behind + INSIDE]
}

/// What a fence of a size consists of, as place and size in its frame: the furniture library draws it so.
pub fn fences([w, h, d]: [f64; 3]) -> Vec<([f64; 2], [f64; 3])> {
    let (x, z) = ((w - FENCE) / 2.0, (d - FENCE) / 2.0);
    let half = (w - GATE) / 2.0;
    let side = |x: f64| ([x, 0.0], [FENCE, h, d - 2.0 * FENCE]);
    let front = |sign: f64| ([sign * (w - half) / 2.0, z], [half, h, FENCE]);
    vec![([0.0, -z], [w, h, FENCE]), side(-x), side(x), front(-1.0), front(1.0)]
}

/// Between the middles of seats in a row there is as much as a seat takes, or an elbow, and so much more (metres).
const ELBOWS: f64 = 0.18;
/// So much of the last one may be beyond the end.
const BEYOND: f64 = 0.05;

/// How many seats of a width have room in a row along a side.
pub fn in_row(side: f64, seat: f64) -> usize {
    ((side + BEYOND) / (seat.max(0.4) + ELBOWS)).floor().max(1.0) as usize
}

/// How long a side is that so many seats of a width have room at in a row.
pub fn row(n: usize, seat: f64) -> f64 {
    n as f64 * (seat.max(0.4) + ELBOWS) - BEYOND + 1e-6
}

/// What is taken on one level around a thing: centre, half extents, height.
#[derive(Clone, Copy, Debug)]
pub struct Taken {
    level: Level,
    centre: [f64; 2],
    half: [f64; 2],
    height: f64,
}

/// Between what stands on a sideboard and the picture above it (metres).
const BELOW_PICTURE: f64 = 0.05;

impl Taken {
    /// By a part at a place.
    pub fn by(slot: &Slot, own: [f64; 3]) -> Self {
        let (sin, cos) = slot.yaw.to_radians().sin_cos();
        let half = [(own[0] * cos).abs() + (own[2] * sin).abs(), (own[0] * sin).abs() + (own[2] * cos).abs()];
        Self { level: slot.level, centre: [slot.x, slot.z], half: half.map(|v| v / 2.0), height: own[1] }
    }

    /// Raises what hangs above a thing, whose top is at `surface`, so that it clears what stands there on the top.
    pub fn raise(&self, slot: &mut Slot, own: [f64; 3], surface: f64) {
        let Level::Above(y) = slot.level else { return };
        if self.level == Level::Top && self.overlaps(&Self::by(slot, own)) {
            slot.level = Level::Above(y.max(surface + self.height + BELOW_PICTURE));
        }
    }

    /// Whether two are in each other's way.
    pub fn meets(&self, other: &Self) -> bool {
        let level = match (self.level, other.level) {
            (Level::At(a), Level::At(b)) => (a - b).abs() < 0.02,
            (a, b) => std::mem::discriminant(&a) == std::mem::discriminant(&b),
        };
        level && self.overlaps(other)
    }

    /// Whether what stands on a top reaches what hangs above it.
    pub fn reaches(&self, hung: &Self, surface: f64) -> bool {
        matches!(hung.level, Level::Above(y) if y < surface + self.height + BELOW_PICTURE / 2.0) && self.overlaps(hung)
    }

    fn overlaps(&self, other: &Self) -> bool {
        (0..2).all(|k| (self.centre[k] - other.centre[k]).abs() < self.half[k] + other.half[k] + 0.005)
    }
}

/// Between seats at a round table, measured along its edge (metres).
const ELBOW: f64 = 0.1;

/// The diameter of a round table that so many seats of a width have room at.
pub fn diameter(n: usize, seat: f64) -> f64 {
    (n as f64 * (seat + ELBOW + 0.1) / std::f64::consts::PI * 20.0).ceil() / 20.0
}

/// Directions in which seats at an oval table are equally far from each other, the first at one of its far ends.
fn directions(n: usize, a: f64, b: f64) -> Vec<f64> {
    use std::f64::consts::TAU;
    const STEPS: usize = 720;
    let from = if a > b { TAU / 4.0 } else { 0.0 };
    let angle = |step: usize| from + TAU * step as f64 / STEPS as f64;
    if (a - b).abs() < 1e-9 {
        return (0..n).map(|i| TAU * i as f64 / n as f64).collect();
    }
    let at = |angle: f64| (a * angle.sin(), b * angle.cos());
    let length = |step: usize| {
        let ((x, z), (u, v)) = (at(angle(step)), at(angle(step + 1)));
        (u - x).hypot(v - z)
    };
    let all: f64 = (0..STEPS).map(length).sum();
    let (mut out, mut gone) = (Vec::new(), 0.0);
    for step in 0..STEPS {
        if out.len() < n && gone >= all * out.len() as f64 / n as f64 - 1e-9 {
            out.push(angle(step));
        }
        gone += length(step);
    }
    out
}

/// How long an oval table of a depth is that so many seats of a width have room at.
pub fn oval(n: usize, seat: f64, depth: f64) -> f64 {
    2.0 * n as f64 * (seat + ELBOW) / std::f64::consts::PI - depth
}

/// Seats equally far from each other around a round or an oval table, turned to its edge.
fn circle(n: usize, gap: f64, sizes: &Sizes) -> Vec<Slot> {
    let ([width, _, depth], [.., d]) = (sizes.of, sizes.own);
    let n = n.min(capacity(sizes.of, sizes.own, true));
    let round = |v: f64| (v * 1000.0).round() / 1000.0;
    let off = gap + d / 2.0;
    directions(n, width / 2.0 + off, depth / 2.0 + off)
        .into_iter()
        .map(|angle| {
            let (sin, cos) = angle.sin_cos();
            let (a, b) = (width / 2.0, depth / 2.0);
            // The edge of an oval is square to this direction.
            let (nx, nz) = (sin * b, cos * a);
            let long = nx.hypot(nz).max(1e-9);
            let (nx, nz) = (nx / long, nz / long);
            let yaw = round((nx.atan2(nz).to_degrees() + 180.0).rem_euclid(360.0)).rem_euclid(360.0);
            Slot { x: round(a * sin + nx * off), z: round(b * cos + nz * off), level: Level::Floor, yaw }
        })
        .collect()
}

/// How many seats of a width have room at a side.
fn room_at(side: f64, seat: f64) -> usize {
    ((side - 0.06) / (seat + 0.08)).floor().max(0.0) as usize
}

/// The most seats that a table of this size has room for.
pub fn capacity(table: [f64; 3], seat: [f64; 3], round: bool) -> usize {
    if round {
        return ((std::f64::consts::PI * (table[0] + table[2]) / 2.0) / (seat[0] + ELBOW) + 1e-6).floor().max(2.0)
            as usize;
    }
    let (long, short) = (table[0].max(table[2]), table[0].min(table[2]));
    2 * room_at(long, seat[0]).max(1) + 2 * usize::from(short >= seat[0] + 0.15)
}

/// From the middle of a seat to that of the next, where two sit side by side (metres).
const ABREAST: f64 = 0.64;

/// Seats spread evenly at the sides of a table, turned to it.
fn around(n: usize, gap: f64, sizes: &Sizes, ends: bool) -> Vec<Slot> {
    let ([width, _, depth], [w, _, d]) = (sizes.of, sizes.own);
    let turned = depth > width;
    let (long, short) = (width.max(depth), width.min(depth));
    let most = room_at(long, w).max(1);
    let free_ends = if ends && short >= w + 0.15 { 2 } else { 0 };
    let n = n.min(2 * most + free_ends);
    let at_ends = if n >= 6 || n > 2 * most || most < 2 && n > 2 { free_ends.min(n.saturating_sub(2)) } else { 0 };
    let (one, other) = ((n - at_ends).div_ceil(2), (n - at_ends) / 2);
    let reach = short / 2.0 + gap + d / 2.0;
    let mut out = Vec::new();
    let mut place = |along: f64, across: f64, yaw: f64| {
        // The long side along the front or along the sides of the table.
        let (x, z, yaw) = if turned { (across, along, 90.0 + yaw) } else { (along, across, yaw) };
        out.push(Slot { x, z, level: Level::Floor, yaw: yaw.rem_euclid(360.0) });
    };
    for (count, sign) in [(one, 1.0), (other, -1.0)] {
        // Two at a short side sit as far apart as it allows.
        let step = if count == 2 { (long / 2.0).max(ABREAST.min(long - w)) } else { long / count as f64 };
        for i in 0..count {
            let along = step * (i as f64 - (count as f64 - 1.0) / 2.0);
            place(along, sign * reach, if sign > 0.0 { 180.0 } else { 0.0 });
        }
    }
    for sign in [1.0, -1.0].into_iter().take(at_ends) {
        let out_there = sign * (long / 2.0 + gap + d / 2.0);
        let yaw = if turned == (sign > 0.0) { 90.0 } else { 270.0 };
        place(out_there, 0.0, yaw);
    }
    out
}

/// How many of so many people sit at the closed side of a table like a U: about a third, so that as many sit at both arms.
fn at_closed_side(n: usize) -> usize {
    let third = (0.3 * n as f64).round() as usize;
    (third + (n - third) % 2).clamp(n.min(2), n)
}

/// The width and depth of a table like a U with seats of a width for so many people at its outer sides (metres).
pub fn horseshoe(n: usize, seat: f64) -> [f64; 2] {
    let closed = at_closed_side(n);
    [row(closed, seat).max(2.4), row((n - closed).div_ceil(2), seat).max(1.8)]
}

/// Seats at the outer sides of a table like a U, which is open at its front.
fn outside(n: usize, gap: f64, sizes: &Sizes) -> Vec<Slot> {
    let ([width, _, depth], [.., d]) = (sizes.of, sizes.own);
    let closed = at_closed_side(n);
    let along = |length: f64, i: usize, n: usize| length * ((i as f64 + 0.5) / n as f64 - 0.5);
    let seat = |x: f64, z: f64, yaw: f64| Slot { x, z, level: Level::Floor, yaw };
    let off = gap + d / 2.0;
    let mut out: Vec<Slot> = (0..closed).map(|i| seat(along(width, i, closed), -depth / 2.0 - off, 0.0)).collect();
    for (sign, n) in [(-1.0, (n - closed).div_ceil(2)), (1.0, (n - closed) / 2)] {
        let yaw = if sign < 0.0 { 90.0 } else { 270.0 };
        out.extend((0..n).map(|i| seat(sign * (width / 2.0 + off), along(depth, i, n), yaw)));
    }
    out
}

/// Shelves that the furniture library draws as racks or as gondolas, with goods in them: nothing else finds room there.
const STOCKED: [&str; 17] = [
    "display",
    "drying",
    "gondola",
    "grocery",
    "heavy",
    "industrial",
    "market",
    "medicine",
    "merchandise",
    "pharmacy",
    "product",
    "retail",
    "shop",
    "storage",
    "store",
    "supermarket",
    "warehouse",
];

/// Heights of the boards of a shelf that the furniture library draws, from below.
pub fn boards(noun: &str, height: f64, width: f64) -> Vec<f64> {
    if noun.split([' ', '_']).any(|word| STOCKED.contains(&word)) {
        return Vec::new();
    }
    let (from, each) = match noun.rsplit([' ', '_']).next().unwrap_or(noun) {
        "bookshelf" | "bookcase" => (0.0, 0.36),
        "shelf" if height >= 0.4 || height >= width => (0.06 * height, 0.42),
        _ => return Vec::new(),
    };
    let thick = if from == 0.0 { 0.025_f64.min(0.08 * width).min(0.08 * height) } else { 0.025_f64.min(0.06 * height) };
    let rows = ((height / each).round() as usize).clamp(1, 6);
    let step = (height - from - thick) / rows as f64;
    (0..=rows).map(|i| from + thick + step * i as f64).collect()
}

/// Whether a place on a board of a bookcase is beside its books. They begin at the left on every other board and at the right
/// on the others (`bookshelf` in the families of assets). Of other furniture it always is.
pub fn is_beside_books(noun: &str, slot: &Slot, own: f64, (board, boards): (usize, usize), width: f64) -> bool {
    // The last board is the top.
    if !noun.ends_with("bookshelf") && !noun.ends_with("bookcase") || board + 1 >= boards {
        return true;
    }
    let books = if board + 2 == boards { 0.45 } else { 0.85 };
    let end = if board.is_multiple_of(2) { slot.x } else { -slot.x };
    end - own / 2.0 >= (width / 2.0 - 0.025) * (2.0 * books - 1.0) - 1e-6
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn seats_of_a_horseshoe_look_into_it_and_have_room() {
        for n in 4..30 {
            let [w, d] = horseshoe(n, 0.46);
            let sizes = Sizes { of: [w, 0.75, d], own: [0.46, 0.9, 0.5], round: false };
            let seats = outside(n, 0.03, &sizes);
            assert_eq!(seats.len(), n);
            for (i, slot) in seats.iter().enumerate() {
                let front = [slot.yaw.to_radians().sin(), slot.yaw.to_radians().cos()];
                assert!(front[0] * slot.x + front[1] * slot.z < -0.3, "{n} {slot:?}");
                let taken = Taken::by(slot, sizes.own);
                assert!(!seats[..i].iter().any(|other| taken.meets(&Taken::by(other, sizes.own))), "{n} {slot:?}");
            }
        }
    }

    #[test]
    fn seats_look_at_their_table_from_all_sides() {
        for of in [[1.6, 0.75, 0.9], [0.9, 0.75, 1.6], [0.8, 0.75, 0.8]] {
            for n in 1..9 {
                let sizes = Sizes { of, own: [0.46, 0.9, 0.5], round: false };
                for slot in around(n, 0.03, &sizes, true) {
                    let front = [slot.yaw.to_radians().sin(), slot.yaw.to_radians().cos()];
                    let ahead = -(front[0] * slot.x + front[1] * slot.z);
                    assert!(ahead > 0.3, "{of:?} {n} {slot:?}");
                }
            }
        }
    }

    #[test]
    fn seats_at_a_round_table_are_at_equal_angles_and_look_at_its_middle() {
        for n in 2..9 {
            let d = diameter(n, 0.46);
            let sizes = Sizes { of: [d, 0.75, d], own: [0.46, 0.9, 0.5], round: true };
            let slots = slots(&Where::Around(n, 0.02), &sizes, &[]);
            assert_eq!(slots.len(), n);
            for (i, slot) in slots.iter().enumerate() {
                assert!((slot.x.hypot(slot.z) - d / 2.0 - 0.27).abs() < 0.002, "{n} {slot:?}");
                let front = [slot.yaw.to_radians().sin(), slot.yaw.to_radians().cos()];
                assert!((front[0] * slot.z - front[1] * slot.x).abs() < 0.003, "{n} {slot:?}");
                let next = &slots[(i + 1) % n];
                let turn = (next.yaw - slot.yaw).rem_euclid(360.0);
                assert!((turn - 360.0 / n as f64).abs() < 0.01, "{n} {slot:?} {next:?}");
            }
        }
    }

    #[test]
    fn a_globe_stands_beside_the_books() {
        let at = |x: f64| Slot { x, z: 0.0, level: Level::At(1.6), yaw: 0.0 };
        let fits = |x: f64, board: usize| is_beside_books("bookcase", &at(x), 0.26, (board, 7), 0.9);
        assert!(fits(-0.2, 5) && !fits(0.2, 5) && !fits(-0.2, 3) && fits(0.2, 6));
        assert!(is_beside_books("shelf", &at(0.2), 0.26, (5, 7), 0.9));
    }

    #[test]
    fn boards_are_in_the_shelf() {
        let heights = boards("bookshelf", 1.9, 0.9);
        assert_eq!(heights.len(), 6);
        assert!((heights[5] - 1.9).abs() < 1e-9);
        assert!(boards("wardrobe", 2.0, 1.0).is_empty());
        // A rack with goods in it.
        assert!(boards("storage shelf", 2.0, 1.8).is_empty() && boards("warehouse_shelf", 2.0, 1.8).is_empty());
    }
}
