//! Things in rows and circles, and seats at tables that stand so.

use super::relations::AROUND;
use super::{Named, indexed};
use crate::brief::{FactKind, Group, Op, Pattern, Place, Rel};
use crate::compose::clusters::{self, Clusters};
use crate::compose::grid::{self, Grid};
use crate::furnish::kinds;
use crate::write::number;

/// So many form a circle by themselves, with this much between two of them and at least this radius (metres).
const RING: std::ops::RangeInclusive<usize> = 3..=30;
const IN_RING: f64 = 0.3;
const RADIUS: f64 = 1.0;
/// What stands in a group, and has no place of its own in it, is so near to the first (metres).
const IN_GROUP: f64 = 1.0;
/// So many seats at a side of a table are spread evenly; fewer may stand as other furniture lets them.
const MANY_AT_SIDE: usize = 3;

fn thousandths(v: f64) -> f64 {
    (v * 1000.0).round() / 1000.0
}

impl Named<'_> {
    /// A circle around nothing, or half of one: evenly spaced, each turned to the middle.
    fn in_ring(&self, a: usize, half: bool) -> String {
        let (of, n) = (self.name(a), self.counts[a]);
        let (steps, sweep) = if half { (n - 1, 180.0_f64) } else { (n, 360.0) };
        let radius =
            (steps as f64 * (self.sizes[a][0] + IN_RING) / sweep.to_radians() + self.sizes[a][2] / 2.0).max(RADIUS);
        let each = (1..n).map(|i| {
            let turn = sweep * i as f64 / steps as f64;
            let ahead = thousandths(radius * (1.0 - turn.to_radians().cos()));
            let aside = thousandths(radius * turn.to_radians().sin());
            let sign = if aside < 0.0 { '+' } else { '-' };
            format!(
                "{of}[{i}].pos = {of}[0].pos + {of}[0].front * {} {sign} {of}[0].right * {} and {of}[{i}].rot.y = {of}[0].rot.y + {}",
                number(ahead),
                number(aside.abs()),
                number(thousandths(turn))
            )
        });
        each.collect::<Vec<_>>().join(" and ")
    }

    /// Half a circle before what all of them face, each turned to it.
    fn in_arc(&self, a: usize, b: usize) -> String {
        const SWEEP: f64 = 120.0;
        /// Between them and what they face, where stands have room as well (metres).
        const AHEAD: f64 = 1.4;
        let (of, to, n) = (self.name(a), self.name(b), self.counts[a]);
        let spread = (n - 1) as f64 * (self.sizes[a][0] + 2.0 * IN_RING) / SWEEP.to_radians();
        let radius = spread.max(self.sizes[b][2] / 2.0 + self.sizes[a][2] / 2.0 + AHEAD);
        let each = (0..n).map(|i| {
            let turn = SWEEP * (i as f64 / (n - 1) as f64 - 0.5);
            let aside = thousandths(radius * turn.to_radians().sin());
            let sign = if aside < 0.0 { '-' } else { '+' };
            format!(
                "{of}[{i}].pos = {to}.pos + {to}.front * {} {sign} {to}.right * {} and {of}[{i}].rot.y = {to}.rot.y + {}",
                number(thousandths(radius * turn.to_radians().cos())),
                number(aside.abs()),
                number(thousandths(180.0 + turn))
            )
        });
        each.collect::<Vec<_>>().join(" and ")
    }

    /// What all of these face, if it is one thing that stands on the floor.
    fn faced(&self, a: usize) -> Option<usize> {
        let faced = self.brief.facts.iter().find_map(|f| match &f.what {
            FactKind::Rel(Rel::Facing, to) if f.of.contains(&a) && !f.not => to.first().copied(),
            _ => None,
        })?;
        let stands = matches!(self.group(faced), Group::Floor | Group::Table | Group::Storage | Group::Seat);
        (stands && self.counts[faced] == 1).then_some(faced)
    }

    pub(super) fn pattern(&self, a: usize, all: &[usize], pattern: Pattern) -> Option<String> {
        let of = self.name(a);
        let n = self.counts[a];
        let elements = self.elements(a);
        if let Pattern::Opens | Pattern::OpensBy(_) | Pattern::SlidesBy(_) = pattern {
            let opens = self.brief.things[a].has_doors();
            let said = |x: &str| match pattern {
                Pattern::OpensBy(degrees) => format!("opens({x}, {degrees}deg)"),
                Pattern::SlidesBy(centimetres) => format!("slides({x}, {})", number(f64::from(centimetres) / 100.0)),
                _ => format!("opens({x})"),
            };
            return opens.then(|| self.all(a, said));
        }
        // Who works at desks that face each other sits at their outer sides.
        let desks = self.brief.things[a].words.last().is_some_and(|w| w == "desk" || w == "workstation");
        let pattern = if desks && pattern == Pattern::FaceToFace { Pattern::BackToBack } else { pattern };
        if self.brief.things[a].part.is_some() && elements.len() > 1 {
            // Some of several: each with the next.
            let each = |f: &dyn Fn(&str, &str) -> String| {
                elements.windows(2).map(|w| f(&w[1], &w[0])).collect::<Vec<_>>().join(" and ")
            };
            return Some(match pattern {
                Pattern::SideBySide => each(&|x, y| format!("beside({x}, {y})")),
                Pattern::FaceToFace => each(&|x, y| format!("facing({x}, {y}) and facing({y}, {x})")),
                Pattern::BackToBack => each(&|x, y| format!("behind({x}, {y}) and behind({y}, {x})")),
                Pattern::Circle => each(&|x, y| format!("near({x}, {y}, {})", number(AROUND))),
                Pattern::Stacked => each(&|x, y| format!("on({x}, {y})")),
                _ => each(&|x, y| format!("aligned({x}, {y})")),
            });
        }
        if !self.array(a) {
            // Several single things: "range, grill, fryer, left to right".
            let place = all.iter().position(|i| *i == a)?;
            let next = *all.get(place + 1)?;
            return Some(match pattern {
                Pattern::LeftToRight => self.pairs(a, next, &|x, y| format!("seenLeftOf({x}, {y})")),
                Pattern::FaceToFace => self.pairs(a, next, &|x, y| format!("facing({x}, {y}) and facing({y}, {x})")),
                Pattern::SideBySide => self.pairs(a, next, &|x, y| format!("beside({x}, {y})")),
                _ => self.pairs(a, next, &|x, y| format!("aligned({x}, {y})")),
            });
        }
        Some(match pattern {
            Pattern::BackToBack if self.grid(a).is_some_and(|g| g.backs) => {
                let k = self.grid(a)?.columns;
                format!("forall i in 0..{}: behind({of}[{k} + i], {of}[i])", n - k)
            }
            Pattern::FaceToFace if self.grid(a).is_some_and(|g| g.faces) => {
                let k = self.grid(a)?.columns;
                format!("forall i in 0..{k}: facing({of}[i], {of}[{k} + i]) and facing({of}[{k} + i], {of}[i])")
            }
            Pattern::Row | Pattern::Rows(_) | Pattern::LeftToRight if self.grid(a).is_some() => {
                return self.rows(a);
            }
            Pattern::Row if self.wall_row(a).is_some() => self.wall_row(a)?.0,
            Pattern::Row | Pattern::LeftToRight => {
                format!("forall i in 1..{n}: aligned({of}[i], {of}[0]) and parallel({of}[i], {of}[0])")
            }
            Pattern::Rows(Some(rows)) if rows > 1 && n.is_multiple_of(rows) && n > rows => {
                let k = n / rows;
                format!(
                    "forall r in 0..{rows}: forall i in 1..{k}: aligned({of}[{k} * r + i], {of}[{k} * r]) and parallel({of}[{k} * r + i], {of}[{k} * r])"
                )
            }
            Pattern::Rows(_) => format!("forall i in 1..{n}: parallel({of}[i], {of}[0])"),
            Pattern::Groups(groups) => match self.clusters(a) {
                Some(clusters) => clusters.formula(of),
                None if groups > 0 && n.is_multiple_of(groups) && n > groups => {
                    let k = n / groups;
                    format!(
                        "forall g in 0..{groups}: forall i in 1..{k}: near({of}[{k} * g + i], {of}[{k} * g], {IN_GROUP})"
                    )
                }
                None => return None,
            },
            Pattern::Circle => self.circle(a),
            Pattern::Arc if RING.contains(&n) => match self.faced(a) {
                Some(b) => self.in_arc(a, b),
                None => self.in_ring(a, true),
            },
            Pattern::Arc => return None,
            Pattern::Aisle(wide) => return self.parted(a, f64::from(wide) / 100.0),
            Pattern::SideBySide => format!("forall i in 0..{}: beside({of}[i], {of}[i + 1])", n - 1),
            Pattern::BackToBack => format!(
                "forall i in 0..{}: behind({of}[2 * i], {of}[2 * i + 1]) and near({of}[2 * i], {of}[2 * i + 1], 0.1) and angle({of}[2 * i].front, {of}[2 * i + 1].front) >= 175 and abs(dot({of}[2 * i + 1].center - {of}[2 * i].center, {of}[2 * i].right)) <= 0.05",
                n / 2
            ),
            Pattern::FaceToFace => format!(
                "forall i in 0..{}: facing({of}[2 * i], {of}[2 * i + 1]) and facing({of}[2 * i + 1], {of}[2 * i])",
                n / 2
            ),
            Pattern::Stacked => format!("forall i in 1..{n}: on({of}[i], {of}[i - 1])"),
            Pattern::Opens | Pattern::OpensBy(_) | Pattern::SlidesBy(_) => return None,
        })
    }

    /// A circle around something, or around nothing.
    fn circle(&self, a: usize) -> String {
        let (of, n) = (self.name(a), self.counts[a]);
        match self.centre_of(a) {
            Some(b) => {
                let drawn = if self.group(a) == Group::Seat { self.seat_gap(b) } else { AROUND };
                format!("around({of}, {}, {})", self.name(b), number(drawn.max(self.ring(a, b))))
            }
            None if RING.contains(&n) => self.in_ring(a, false),
            None => format!("forall i in 0..{}: near({of}[i], {of}[i + 1], {})", n - 1, number(AROUND)),
        }
    }

    /// Rows that an aisle of so many metres parts in halves; the rows themselves are said elsewhere if their number is.
    fn parted(&self, a: usize, wide: f64) -> Option<String> {
        let (of, n) = (self.name(a), self.counts[a]);
        let grid = self.grid(a).filter(|grid| grid.columns.is_multiple_of(2) && n.is_multiple_of(grid.columns))?;
        let (k, half) = (grid.columns, grid.columns / 2);
        let (left, right) = (half - 1, half);
        let apart =
            format!("forall r in 0..{}: far({of}[{k} * r + {left}], {of}[{k} * r + {right}], {})", n / k, number(wide));
        let told = self.said(a, |w| matches!(w, FactKind::Pattern(Pattern::Rows(_))));
        Some(match self.rows(a).filter(|_| !told) {
            Some(rows) => format!("({rows}) and {apart}"),
            None => apart,
        })
    }

    /// A row at a wall: where each stands from the first, and how they are turned.
    pub fn wall_row(&self, a: usize) -> Option<(String, f64)> {
        let n = self.counts[a];
        let floor = matches!(self.group(a), Group::Seat | Group::Storage | Group::Floor | Group::Table | Group::Bed);
        let row = self.said(a, |w| matches!(w, FactKind::Pattern(Pattern::Row)));
        if !self.array(a) || !floor || !row {
            return None;
        }
        let size = *self.room_sizes.get(self.brief.things[a].room)?;
        let which = self.brief.facts.iter().find_map(|f| match &f.what {
            FactKind::Place(Rel::Against | Rel::Along | Rel::At, Place::Wall, which) if f.of == [a] && !f.not => {
                Some(which)
            }
            _ => None,
        })?;
        let elsewhere = |w: &FactKind| match w {
            FactKind::Place(_, place, _) => !matches!(place, Place::Wall | Place::Row),
            FactKind::Rel(rel, _) => {
                matches!(rel, Rel::On | Rel::In | Rel::Around | Rel::Under | Rel::Between | Rel::Opposite)
            }
            _ => false,
        };
        if self.said(a, elsewhere) {
            return None;
        }
        let gap = self.brief.facts.iter().find_map(|f| match f.what {
            FactKind::Among(_, v) if f.of == [a] => Some(v),
            _ => None,
        });
        let step = self.sizes[a][0] + gap.unwrap_or(0.1);
        let said = which.iter().find_map(|w| super::places::direction(w));
        let along_x = size[0] >= size[2];
        let (axis, sign) = match said {
            Some(side) => side,
            None if which.iter().any(|w| w.starts_with("short") || w == "side") == along_x => ('x', -1.0),
            None if which.iter().any(|w| w == "opposite" || w == "other" || w == "same") => return None,
            None => ('z', 1.0),
        };
        let length = if axis == 'z' { size[0] } else { size[2] };
        if step * n as f64 + 0.3 > length {
            return None;
        }
        let (of, step) = (self.name(a), number(step));
        let (along, across) = if axis == 'z' { ("x", "z") } else { ("z", "x") };
        let text = format!(
            "forall i in 1..{n}: {of}[i].pos.{along} = {of}[0].pos.{along} + i * {step} and {of}[i].pos.{across} = {of}[0].pos.{across}"
        );
        let turned = match (axis, sign > 0.0) {
            ('z', true) => 180.0,
            ('z', false) => 0.0,
            (_, true) => 270.0,
            (_, false) => 90.0,
        };
        Some((text, turned))
    }

    /// The rows of an array, measured from its first element.
    pub fn rows(&self, a: usize) -> Option<String> {
        let grid = self.grid(a)?;
        let (of, n, k) = (self.name(a), self.counts[a], grid.columns);
        let [x, z] = grid.steps.map(number);
        let place = |at: String, r: &str| {
            format!("{at}.pos.x = {of}[0].pos.x + i * {x} and {at}.pos.z = {of}[0].pos.z - {r} * {z}")
        };
        if grid.rows == 1 && self.is_lengthwise(a) {
            return Some(format!(
                "forall i in 0..{n}: {of}[i].pos.x = {of}[0].pos.x and {of}[i].pos.z = {of}[0].pos.z + i * {x}"
            ));
        }
        if grid.rows == 1 {
            return Some(format!(
                "forall i in 0..{n}: {of}[i].pos.x = {of}[0].pos.x + i * {x} and {of}[i].pos.z = {of}[0].pos.z"
            ));
        }
        if k == 1 {
            return Some(format!(
                "forall i in 0..{n}: {of}[i].pos.x = {of}[0].pos.x and {of}[i].pos.z = {of}[0].pos.z - i * {z}"
            ));
        }
        let full = n / k;
        if grid.aisle > 0.0 && n.is_multiple_of(k) {
            let half = k / 2;
            let second = format!(
                "{of}[{k} * r + i].pos.x = {of}[0].pos.x + i * {x} + {} and {of}[{k} * r + i].pos.z = {of}[0].pos.z - r * {z}",
                number(grid.aisle)
            );
            let first = place(format!("{of}[{k} * r + i]"), "r");
            return Some(format!(
                "(forall r in 0..{full}: forall i in 0..{half}: {first}) and forall r in 0..{full}: forall i in {half}..{k}: {second}"
            ));
        }
        let mut out =
            format!("forall r in 0..{full}: forall i in 0..{k}: {}", place(format!("{of}[{k} * r + i]"), "r"));
        if n % k > 0 {
            out = format!(
                "({out}) and forall i in 0..{}: {}",
                n % k,
                place(format!("{of}[{} + i]", k * full), &full.to_string())
            );
        }
        Some(out)
    }

    /// Whether a row in the middle of a room goes along its depth: the room is deeper than it is wide, and the things are as wide as
    /// deep.
    pub(super) fn is_lengthwise(&self, a: usize) -> bool {
        const LONGER: f64 = 1.2;
        const SQUARE: f64 = 0.3;
        let middle = self.said(a, |w| matches!(w, FactKind::Place(_, Place::Middle, _)));
        let [width, _, depth] = self.sizes[a];
        let size = self.room_sizes.get(self.brief.things[a].room);
        middle && (width - depth).abs() < SQUARE && size.is_some_and(|room| room[2] > LONGER * room[0])
    }

    /// As many seats at the one side of a table as at the other: spread evenly, turned to it.
    fn along_sides(&self, a: usize) -> Option<String> {
        let (long, b) = self.brief.facts.iter().find_map(|f| match &f.what {
            FactKind::Rel(rel @ (Rel::LongSide | Rel::ShortSide), to) if f.of == [a] && to.len() == 1 && !f.not => {
                // "Along the long side" is one side.
                let said = self.brief.request.get(f.source.at()).unwrap_or_default().to_lowercase();
                let both = ["each side", "either side", "both", "sides"].iter().any(|side| said.contains(side));
                both.then_some((*rel == Rel::LongSide, to[0]))
            }
            _ => None,
        })?;
        let (n, m) = (self.counts[a], self.counts[b]);
        let ([w, _, d], seat) = (self.sizes[b], self.sizes[a]);
        let wide = long == (w >= d);
        let each = n / (2 * m.max(1));
        let fits = each as f64 * (seat[0] + 0.05) <= if wide { w } else { d };
        if self.group(a) != Group::Seat || !self.array(a) || each < MANY_AT_SIDE || n != 2 * m * each || !fits {
            return None;
        }
        let (of, to) = (self.name(a), if m > 1 { format!("{}[i]", self.name(b)) } else { self.name(b).to_owned() });
        let (along, length, across, depth) =
            if wide { ("right", "x", "front", "z") } else { ("front", "z", "right", "x") };
        let first = if m > 1 { format!("{} * i + ", 2 * each) } else { String::new() };
        let turned = if wide { [180, 0] } else { [270, 90] };
        let place = |side: usize| {
            let (first, sign) = (if side == 0 { first.clone() } else { format!("{first}{each} + ") }, ["+", "-"][side]);
            let turned = match turned[side] {
                0 => String::new(),
                turned => format!(" + {turned}"),
            };
            format!(
                "{of}[{first}j].pos = {to}.pos + {to}.{along} * ({to}.size.{length} * (j * {} - {})) {sign} {to}.{across} * ({to}.size.{depth} / 2 + {}) and {of}[{first}j].rot.y = {to}.rot.y{turned}",
                number(1.0 / each as f64),
                number((each - 1) as f64 * 0.5 / each as f64),
                number(seat[2] / 2.0 + 0.1),
            )
        };
        let tables = if m > 1 { format!("forall i in 0..{m}: ") } else { String::new() };
        Some(format!("{tables}forall j in 0..{each}: {} and {}", place(0), place(1)))
    }

    /// Seats at tables that stand in rows: each at its place, turned to its table.
    pub fn drawn_up(&self, a: usize) -> Option<String> {
        if let Some(along) = self.along_sides(a) {
            return Some(along);
        }
        let (rel, b) = self.brief.facts.iter().find_map(|f| match &f.what {
            FactKind::Rel(rel @ (Rel::Around | Rel::At | Rel::InFrontOf | Rel::Behind | Rel::Near), to)
                if f.of == [a] && to.len() == 1 =>
            {
                Some((*rel, to[0]))
            }
            _ => None,
        })?;
        let (grid, groups) = (self.grid(b), self.clusters(b));
        if grid.is_none() && groups.is_none() {
            return None;
        }
        let in_pairs = grid.is_some_and(|grid| grid.backs || grid.faces);
        let (n, m) = (self.counts[a], self.counts[b]);
        if self.group(a) != Group::Seat || m < 2 || n % m != 0 {
            return None;
        }
        let k = n / m;
        if k > 4 && rel == Rel::Around && !in_pairs && groups.is_none() {
            return Some(self.ring_of_seats(a, b, k));
        }
        let two_behind = k == 2 && matches!(rel, Rel::Behind | Rel::InFrontOf);
        let [w, _, d] = self.sizes[b];
        let seat = self.sizes[a][2];
        let spots = grid::seats(k, rel, [w, d], seat);
        if spots.len() < k || two_behind {
            return None;
        }
        let (of, to) = (self.name(a), self.name(b));
        let places = |sign: f64| -> String {
            let one = |j: usize| {
                let (at, ([x, z], turned)) = (indexed(of, k, j), spots[j]);
                let turned = if sign > 0.0 { turned } else { (turned + 180.0).rem_euclid(360.0) };
                format!(
                    "{at}.pos.x = {to}[i].pos.x + {} and {at}.pos.z = {to}[i].pos.z + {} and {at}.rot = rot(0, {}, 0)",
                    number(sign * x),
                    number(sign * z),
                    number(turned)
                )
                .replace("+ -", "- ")
                .replace(" + 0 ", " ")
            };
            (0..k).map(one).collect::<Vec<_>>().join(" and ")
        };
        // The second line is turned round.
        let turned = match (grid, groups) {
            (Some(grid), _) if in_pairs => Some((grid.columns, if grid.backs { 1.0 } else { -1.0 })),
            (Some(_), _) => None,
            (None, groups) => groups.map(|groups| (groups.firsts(), 1.0)),
        };
        Some(match turned {
            Some((first, sign)) => {
                format!("(forall i in 0..{first}: {}) and forall i in {first}..{m}: {}", places(sign), places(-sign))
            }
            // In front of a desk that is turned round.
            None if k > 2 && rel == Rel::InFrontOf && self.is_taught(b) => {
                format!("forall i in 0..{m}: {}", places(-1.0))
            }
            None => format!("forall i in 0..{m}: {}", places(1.0)),
        })
    }

    /// So many seats around each of several tables: evenly in a circle, turned to it.
    fn ring_of_seats(&self, a: usize, b: usize, k: usize) -> String {
        let (of, to, m) = (self.name(a), self.name(b), self.counts[b]);
        let ([w, _, d], seat) = (self.sizes[b], self.sizes[a]);
        let reach = (w.max(d) / 2.0 + seat[2] / 2.0 + 0.1).max(k as f64 * (seat[0] + 0.12) / std::f64::consts::TAU);
        let (reach, angle) = (number(reach), number(360.0 / k as f64));
        let each = format!("{of}[{k} * i + j]");
        format!(
            "forall i in 0..{m}: forall j in 0..{k}: {each}.pos.x = {to}[i].pos.x + {reach} * sin({angle}deg * j) and {each}.pos.z = {to}[i].pos.z + {reach} * cos({angle}deg * j) and {each}.rot = rot(0, 180deg + {angle}deg * j, 0)"
        )
    }

    /// How the rows of an array are turned.
    pub fn turned(&self, a: usize) -> Option<String> {
        if let Some((_, turned)) = self.wall_row(a) {
            return Some(format!("{}.rot <- rot(0, {}, 0);", self.name(a), number(turned)));
        }
        let (of, n) = (self.name(a), self.counts[a]);
        let two_ways = |k: usize, [first, second]: [u32; 2]| {
            format!(
                "assert (forall i in 0..{k}: {of}[i].rot = rot(0, {first}, 0)) and forall i in {k}..{n}: {of}[i].rot = rot(0, {second}, 0);"
            )
        };
        if let Some(clusters) = self.clusters(a) {
            return Some(two_ways(clusters.firsts(), [0, 180]));
        }
        let grid = self.grid(a)?;
        Some(if grid.backs || grid.faces {
            two_ways(grid.columns, if grid.backs { [0, 180] } else { [180, 0] })
        } else {
            format!("{of}.rot <- rot(0, {}, 0);", if self.is_taught(a) { 180 } else { 0 })
        })
    }

    /// Who sits at a desk in a classroom sees the board, across the desk: it is turned round.
    fn is_taught(&self, a: usize) -> bool {
        let room = self.brief.rooms.get(self.brief.things[a].room).and_then(|room| kinds::of(&room.name));
        room.is_some_and(|kind| kind.is_taught()) && self.group(a) == Group::Table
    }

    /// How an array in rows stands, if nothing else says where.
    pub fn grid(&self, a: usize) -> Option<Grid> {
        let room = self.room_sizes.get(self.brief.things[a].room)?;
        grid::grid(self.brief, &self.sizes, a, Some(*room))
    }

    /// The groups in which an array stands, if nothing else says where each is.
    pub fn clusters(&self, a: usize) -> Option<Clusters> {
        let room = self.room_sizes.get(self.brief.things[a].room)?;
        clusters::clusters(self.brief, self.sizes[a], self.counts[a], a, *room).filter(|_| self.array(a))
    }

    /// Where each of an array stands from the first, and how it is turned, if the request gives its rows or groups.
    pub fn formation(&self, a: usize) -> Vec<[f64; 3]> {
        if let Some(clusters) = self.clusters(a) {
            return clusters.places();
        }
        let told =
            self.said(a, |w| matches!(w, FactKind::Pattern(Pattern::Rows(_) | Pattern::Row | Pattern::Aisle(_))));
        let Some(grid) = self.grid(a).filter(|grid| told && !grid.backs) else { return Vec::new() };
        // Single seats stand as the room has them, unless an aisle runs between them.
        if self.group(a) == Group::Seat && grid.aisle == 0.0 {
            return Vec::new();
        }
        let place = |i: usize| {
            let (row, column) = (i / grid.columns, i % grid.columns);
            let aside = if 2 * column >= grid.columns { grid.aisle } else { 0.0 };
            // The first of two rows that face each other is turned round.
            let yaw = if grid.faces && row == 0 { 180.0 } else { 0.0 };
            [column as f64 * grid.steps[0] + aside, -(row as f64) * grid.steps[1], yaw]
        };
        (0..self.counts[a]).map(place).collect()
    }

    pub(super) fn rows_apart(&self, a: usize, op: Op, v: f64) -> Option<String> {
        let Some(grid) = self.grid(a).filter(|g| g.rows > 1) else {
            // An aisle runs before the front of each; beside each other they may touch.
            let aisles = op == Op::Least && self.array(a) && self.grid(a).is_none();
            return if aisles {
                Some(format!("rackAisles({}, {})", self.name(a), number(v)))
            } else {
                self.among(a, op, v)
            };
        };
        let (of, k, v) = (self.name(a), grid.columns, number(v));
        let test = match op {
            Op::Most => format!("near({of}[i], {of}[i + {k}], {v})"),
            _ => format!("far({of}[i], {of}[i + {k}], {v})"),
        };
        Some(format!("forall i in 0..{}: {test}", self.counts[a] - k))
    }

    /// What a circle is around, if that was said.
    fn centre_of(&self, a: usize) -> Option<usize> {
        self.brief.facts.iter().find_map(|f| match &f.what {
            FactKind::Rel(Rel::Around, to) if f.of.contains(&a) && self.counts[to[0]] == 1 => Some(to[0]),
            _ => None,
        })
    }
}
