//! Things in rows: how many rows and columns, and how far from one to the next.

use crate::brief::{Brief, FactKind, Group, Pattern, Rel, Side};

/// Rows and columns; the first stands at the left of the first row, rows follow towards -z.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Grid {
    pub rows: usize,
    /// Things in a row.
    pub columns: usize,
    /// From one to the next in a row, and from row to row, in metres.
    pub steps: [f64; 2],
    /// What the whole takes, with the things in it (x, z).
    pub takes: [f64; 2],
    /// What the second half of each row is moved aside for an aisle down the middle, in metres.
    pub aisle: f64,
    /// Two rows whose backs touch: the second is turned round.
    pub backs: bool,
    /// Two rows that look at each other: the first is turned round.
    pub faces: bool,
}

/// How far from the walls a grid stays, in metres.
const MARGIN: f64 = 0.9;

/// Between things in a row at the side of an aisle (metres).
const BY_AISLE: f64 = 0.1;

/// Between racks in a row, and from one row to the next, where there is room (metres).
const RACKS: (f64, f64) = (0.02, 2.4);

/// Between workplaces along a conveyor, and between rows of servers (metres).
const AT_LINE: f64 = 0.1;
const COLD_AISLE: f64 = 1.2;
/// Between machines that face each other, where people work at both (metres).
const WORKED_AT: f64 = 1.6;

/// The grid of an array that stands in rows, unless something else says where its elements are: at a wall, on a table.
pub fn grid(brief: &Brief, sizes: &[[f64; 3]], a: usize, room: Option<[f64; 3]>) -> Option<Grid> {
    let n = brief.count(a);
    let rows = brief.facts.iter().find_map(|f| match f.what {
        FactKind::Pattern(Pattern::Rows(rows)) if f.of == [a] => Some(rows.unwrap_or_else(|| spread(n))),
        FactKind::Pattern(Pattern::Row) if f.of == [a] => Some(1),
        _ => None,
    });
    let parted = brief.facts.iter().any(|f| matches!(f.what, FactKind::Pattern(Pattern::Aisle(_))) && f.of == [a]);
    let rows = rows.or_else(|| parted.then(|| halves(n)));
    let said = rows.is_some();
    // "In rows": the last may be shorter.
    let exact = said && !brief.facts.iter().any(|f| f.what == FactKind::Pattern(Pattern::Rows(None)) && f.of == [a]);
    let middle = middle(brief, sizes, a);
    let seats = brief.facts.iter().any(|f| {
        matches!(&f.what, FactKind::Rel(Rel::Around | Rel::At | Rel::InFrontOf | Rel::Near, to) if to == &[a])
            && brief.things[f.of[0]].group == Group::Seat
    });
    // Two benches in the middle with their stools stand one behind the other.
    let centred = brief
        .facts
        .iter()
        .any(|f| f.of == [a] && !f.not && matches!(f.what, FactKind::Place(_, crate::brief::Place::Middle, _)));
    let few = brief.things[a].group == Group::Table && (2..4).contains(&n) && seats && centred;
    // Tables with their seats stand in rows where nothing else is said.
    let rows = match rows {
        Some(rows) => rows,
        None if few => n,
        None if brief.things[a].group == Group::Table && n >= 4 && seats && !crowded(brief, a) => {
            if middle > 0.0 {
                2
            } else {
                spread(n)
            }
        }
        None => return None,
    };
    let hung = matches!(brief.things[a].group, Group::Wall | Group::Ceiling | Group::Top | Group::Screen | Group::Soft);
    if elsewhere(brief, a) || hung || n < 2 || exact && !n.is_multiple_of(rows) || brief.things[a].opening() {
        return None;
    }
    // A row to the left or right of something runs past it.
    let aside = rows == 1
        && brief
            .facts
            .iter()
            .any(|f| f.of == [a] && !f.not && matches!(f.what, FactKind::Rel(Rel::LeftOf | Rel::RightOf, _)));
    let rows = if aside { n } else { rows.min(n) };
    let lay = |rows: usize| lay(brief, sizes, a, room, rows, said, middle);
    // Where nobody says how many rows, there are so many that these fit.
    if said { lay(rows) } else { (rows..=n).find_map(lay) }
}

/// So many rows of an array, if the room has place for them. `said`: somebody says that there are rows; `middle`: how deep is what
/// stands between them.
fn lay(
    brief: &Brief,
    sizes: &[[f64; 3]],
    a: usize,
    room: Option<[f64; 3]>,
    rows: usize,
    said: bool,
    middle: f64,
) -> Option<Grid> {
    let n = brief.count(a);
    let columns = n.div_ceil(rows);
    let [mut beside, mut behind] = steps(brief, sizes, a);
    // Who works at desks that face each other sits between them and their backs: the desks are back to back.
    let desks = brief.things[a].words.last().is_some_and(|w| w == "desk" || w == "workstation");
    let told = |pattern: Pattern| brief.facts.iter().any(|f| f.what == FactKind::Pattern(pattern) && f.of == [a]);
    let faced = rows == 2 && told(Pattern::FaceToFace);
    let backs = rows == 2 && told(Pattern::BackToBack) || faced && desks;
    let faces = faced && !desks;
    if backs {
        behind = 0.02;
    }
    let is_rack = brief.things[a].words.last().is_some_and(|word| word == "rack");
    if faces && brief.things[a].group == Group::Floor && !is_rack {
        behind = behind.max(WORKED_AT);
    }
    if !said && middle > 0.0 {
        // What stands in the middle of the room stands between the rows.
        behind = behind.max(middle + 2.2);
    }
    let [w, _, d] = sizes[a];
    let wide = brief.facts.iter().find_map(|f| match f.what {
        FactKind::Pattern(Pattern::Aisle(wide)) if f.of == [a] => Some(f64::from(wide) / 100.0),
        _ => None,
    });
    if wide.is_some() {
        beside = beside.min(BY_AISLE);
    }
    let aisle = wide.filter(|_| columns.is_multiple_of(2)).map_or(0.0, |wide| (wide + 0.02 - beside).max(0.0));
    let takes = |b: f64, h: f64| [columns as f64 * (w + b) - b + aisle, rows as f64 * (d + h) - h];
    let mut whole = takes(beside, behind);
    if let Some([rw, _, rd]) = room {
        // As wide as the room lets it be.
        if columns > 1 && whole[0] > rw - MARGIN {
            beside = ((rw - MARGIN - aisle - w * columns as f64) / (columns - 1) as f64).max(0.02);
        }
        if rows > 1 && whole[1] > rd - MARGIN {
            behind = ((rd - MARGIN - d * rows as f64) / (rows - 1) as f64).max(0.02);
        }
        whole = takes(beside, behind);
        let part = if said { 1.0 } else { 0.8 };
        if whole[0] > rw * part || whole[1] > rd * part {
            return None;
        }
    }
    let round = |v: f64| (v * 100.0).ceil() / 100.0;
    Some(Grid { rows, columns, steps: [round(w + beside), round(d + behind)], takes: whole, aisle, backs, faces })
}

/// Whether the request says where an array stands otherwise than in rows.
fn elsewhere(brief: &Brief, a: usize) -> bool {
    brief.facts.iter().any(|f| {
        !f.not
            && f.of.contains(&a)
            && match &f.what {
                FactKind::Place(_, place, _) => !matches!(place, crate::brief::Place::Middle),
                FactKind::Rel(rel, _) => !matches!(
                    rel,
                    Rel::Facing
                        | Rel::InFrontOf
                        | Rel::LeftOf
                        | Rel::RightOf
                        | Rel::Behind
                        | Rel::Far
                        | Rel::Perpendicular
                        | Rel::Opposite
                ),
                _ => false,
            }
    })
}

/// How far the elements of an array stand from each other at least, side by side and one behind the other (metres).
fn steps(brief: &Brief, sizes: &[[f64; 3]], a: usize) -> [f64; 2] {
    // Racks stand end to end, with an aisle before each row.
    let thing = &brief.things[a];
    let is_rack = thing.group == Group::Storage || thing.words.last().is_some_and(|word| word == "rack");
    // Between the benches of a laboratory stand their sinks.
    let is_bench = thing.group == Group::Table && thing.head().ends_with("bench");
    let (mut beside, mut behind) = if is_rack { RACKS } else { (if is_bench { 0.7 } else { 0.5 }, 0.8) };
    // Along a conveyor workplaces stand close to each other, and between servers is a cold aisle.
    let is_conveyor = |to: &usize| {
        let last = brief.things[*to].words.last();
        last.is_some_and(|word| word == "conveyor" || word == "belt")
    };
    let at_line = |f: &crate::brief::Fact| {
        f.of.contains(&a)
            && matches!(&f.what, FactKind::Rel(Rel::InFrontOf | Rel::Behind, to) if to.iter().any(is_conveyor))
    };
    if brief.facts.iter().any(at_line) {
        beside = AT_LINE;
    }
    if is_rack && thing.words.iter().any(|word| word == "server") {
        behind = COLD_AISLE;
    }
    // Between racks is what is said, be it less than usual.
    if is_rack && brief.facts.iter().any(|f| f.of.contains(&a) && matches!(f.what, FactKind::Rows(..))) {
        behind = 0.0;
    }
    for f in &brief.facts {
        let own = f.of.contains(&a);
        match &f.what {
            FactKind::Among(_, v) if own => (beside, behind) = (beside.max(*v + 0.02), behind.max(*v + 0.02)),
            FactKind::Rows(_, v) if own => behind = behind.max(*v + 0.02),
            FactKind::Clear(Side::Behind | Side::Front, v) if own => behind = behind.max(*v + 0.1),
            // Seats take their place: between the rows, or at the sides.
            FactKind::Rel(rel, to) if to.contains(&a) && brief.things[f.of[0]].group == Group::Seat => {
                let seat = sizes[f.of[0]];
                match rel {
                    Rel::Around | Rel::At => {
                        (beside, behind) = (beside.max(2.0 * seat[0] + 0.8), behind.max(2.0 * seat[2] + 0.6))
                    }
                    Rel::InFrontOf | Rel::Behind | Rel::Near => behind = behind.max(seat[2] + 0.65),
                    Rel::Beside => beside = beside.max(seat[0] + 0.5),
                    _ => {}
                }
                for g in brief.facts.iter().filter(|g| g.of == f.of) {
                    if let FactKind::Clear(_, v) = g.what {
                        behind = behind.max(seat[2] + v + 0.5);
                    }
                }
            }
            _ => {}
        }
    }
    [beside, behind]
}

/// Rows for so many that an aisle parts in halves.
fn halves(n: usize) -> usize {
    let most = (n as f64).sqrt().ceil() as usize;
    (2..=most).rev().find(|r| n.is_multiple_of(2 * r)).unwrap_or_else(|| spread(n))
}

/// Rows for so many: about as many as columns, full ones if it can be.
fn spread(n: usize) -> usize {
    let most = (n as f64).sqrt().floor() as usize;
    (2..=most).rev().find(|r| n.is_multiple_of(*r)).unwrap_or(2)
}

/// How deep the largest thing is that stands in the middle of the room; 0: nothing does.
fn middle(brief: &Brief, sizes: &[[f64; 3]], a: usize) -> f64 {
    let room = brief.things[a].room;
    let there =
        brief.facts.iter().filter(|f| !f.not && matches!(f.what, FactKind::Place(_, crate::brief::Place::Middle, _)));
    let items = there.flat_map(|f| f.of.iter()).filter(|o| **o != a && brief.things[**o].room == room);
    items.map(|o| sizes[*o][0].max(sizes[*o][2])).fold(0.0, f64::max)
}

/// Whether something is said of where each of them is.
fn crowded(brief: &Brief, a: usize) -> bool {
    brief.facts.iter().any(|f| match &f.what {
        FactKind::Gap(..) | FactKind::Pattern(_) => f.of.contains(&a),
        _ => false,
    })
}

/// Where the seats of a table or desk of this width and depth are: from its middle, and how they are turned. The front of a table
/// is +z.
pub fn seats(each: usize, rel: Rel, [w, d]: [f64; 2], seat: f64) -> Vec<([f64; 2], f64)> {
    let away = |half: f64| half + seat / 2.0 + 0.1;
    let (x, z) = (away(w / 2.0), away(d / 2.0));
    let along = |j: usize, of: usize| ((2 * j + 1) as f64 / of as f64 - 1.0) * w / 2.0;
    let is_long = w >= 1.5 * d;
    match (each, rel) {
        (1, Rel::Behind) => vec![([0.0, -z], 0.0)],
        (1, _) => vec![([0.0, z], 180.0)],
        // All on one side.
        (3.., Rel::InFrontOf) => (0..each).map(|j| ([along(j, each), z], 180.0)).collect(),
        (3.., Rel::Behind) => (0..each).map(|j| ([along(j, each), -z], 0.0)).collect(),
        (2, _) => vec![([-x, 0.0], 90.0), ([x, 0.0], -90.0)],
        (4, _) if is_long => {
            (0..4).map(|j| ([along(j % 2, 2), if j < 2 { z } else { -z }], if j < 2 { 180.0 } else { 0.0 })).collect()
        }
        (3 | 4, _) => vec![([-x, 0.0], 90.0), ([x, 0.0], -90.0), ([0.0, z], 180.0), ([0.0, -z], 0.0)],
        _ => Vec::new(),
    }
}
