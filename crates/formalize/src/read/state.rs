//! What is said → statements of the language: calls of the standard library's predicates, one statement for each thing said.

use super::chunk::Pattern;
use super::lexicon::{Group, Rel};
use super::measure::{Dim, Op};
use super::noun::Place;
use super::scene::{Fact, Scene, Side, What};
use crate::draft::{Note, Source, Statement};
use crate::write::number;

/// How far "near" reaches, in metres.
const NEAR: f64 = 1.0;
/// How far a seat is from its table.
const DRAWN_UP: f64 = 0.4;
/// How far "around" reaches, for what is no seat.
const AROUND: f64 = 1.2;
/// More elements than this are not listed one by one.
const LISTED: usize = 12;

/// Names and counts that statements speak of.
pub struct Named<'a> {
    /// What was read.
    pub scene: &'a Scene,
    /// Names of things; of an opening that there are several of, one for each.
    pub names: Vec<Vec<String>>,
    /// How many of each.
    pub counts: Vec<usize>,
    /// Names of rooms.
    pub rooms: Vec<String>,
    /// Sizes of things.
    pub sizes: Vec<[f64; 3]>,
    /// Sizes of rooms.
    pub room_sizes: Vec<[f64; 3]>,
}

/// Statements, and what could not be said.
#[derive(Default)]
pub struct Stated {
    /// In the order of the text; the inferred ones last.
    pub statements: Vec<Statement>,
    /// What became none.
    pub notes: Vec<Note>,
}

/// All statements of what was read.
pub fn state(named: &Named) -> Stated {
    let mut out = Stated::default();
    for (k, fact) in named.scene.facts.iter().enumerate() {
        let texts = named.fact(k, fact);
        if texts.is_empty() {
            out.notes.push(Note { at: fact.at.clone(), reason: "no predicate says this of one thing alone".into() });
        }
        // Of what nobody asked for nobody said anything either.
        let why = fact.of.iter().find_map(|of| named.scene.items[*of].inferred.clone());
        for text in texts {
            out.push(text, why.clone().map_or(Source::Stated(fact.at.clone()), Source::Inferred));
        }
    }
    super::usual::usual(named, &mut out);
    out
}

impl Stated {
    /// Adds a statement, once.
    pub fn push(&mut self, text: String, source: Source) {
        if !self.statements.iter().any(|s| s.text == text) {
            self.statements.push(Statement { text, source });
        }
    }

    /// Adds what the request does not say.
    pub fn infer(&mut self, text: String, why: &str) {
        self.push(text, Source::Inferred(why.into()));
    }
}

impl Named<'_> {
    /// The room of a thing, by name.
    pub fn room(&self, item: usize) -> &str {
        self.rooms.get(self.scene.items[item].room).map_or("", String::as_str)
    }

    /// The set, or the one.
    pub fn name(&self, item: usize) -> &str {
        self.names[item].first().map_or("", String::as_str)
    }

    fn array(&self, item: usize) -> bool {
        self.counts[item] > 1 && !self.scene.items[item].opening()
    }

    /// Names of its elements, no more than a few.
    pub fn elements(&self, item: usize) -> Vec<String> {
        if self.array(item) {
            (0..self.counts[item].min(LISTED)).map(|i| format!("{}[{i}]", self.name(item))).collect()
        } else {
            self.names[item].clone()
        }
    }

    /// A formula for each element.
    pub fn all(&self, item: usize, f: impl Fn(&str) -> String) -> String {
        if self.array(item) {
            format!("forall a in {}: {}", self.name(item), f("a"))
        } else {
            self.elements(item).iter().map(|e| f(e)).collect::<Vec<_>>().join(" and ")
        }
    }

    /// Which element of `b` each of `a` goes with: as many of one for each of the other, or whatever fits.
    pub fn pairs(&self, a: usize, b: usize, f: &dyn Fn(&str, &str) -> String) -> String {
        let (n, m) = (self.counts[a], self.counts[b]);
        let (of, to) = (self.name(a), self.name(b));
        if !self.array(a) && !self.array(b) {
            let (of, to) = (self.elements(a), self.elements(b));
            return of
                .iter()
                .enumerate()
                .map(|(i, x)| f(x, &to[i * to.len() / of.len().max(1) % to.len()]))
                .collect::<Vec<_>>()
                .join(" and ");
        }
        if self.array(a) && !self.array(b) {
            let to = self.elements(b);
            let one = |x: &str| {
                if to.len() == 1 {
                    f(x, &to[0])
                } else {
                    format!("({})", to.iter().map(|t| f(x, t)).collect::<Vec<_>>().join(" or "))
                }
            };
            return format!("forall a in {of}: {}", one("a"));
        }
        if !self.array(a) {
            return self
                .elements(a)
                .iter()
                .map(|x| format!("(exists b in {to}: {})", f(x, "b")))
                .collect::<Vec<_>>()
                .join(" and ");
        }
        if a == b {
            return format!("forall a in {of}: exists b in {of}: a != b and {}", f("a", "b"));
        }
        if n % m == 0 {
            let k = n / m;
            return match k {
                1 => format!("forall i in 0..{m}: {}", f(&format!("{of}[i]"), &format!("{to}[i]"))),
                2..=4 => {
                    let each: Vec<String> = (0..k).map(|j| f(&indexed(of, k, j), &format!("{to}[i]"))).collect();
                    format!("forall i in 0..{m}: {}", each.join(" and "))
                }
                _ => format!(
                    "forall i in 0..{m}: forall j in 0..{k}: {}",
                    f(&format!("{of}[{k} * i + j]"), &format!("{to}[i]"))
                ),
            };
        }
        if n < m {
            return format!("forall i in 0..{n}: {}", f(&format!("{of}[i]"), &format!("{to}[i]")));
        }
        format!("forall a in {of}: exists b in {to}: {}", f("a", "b"))
    }

    /// A formula for each element of both.
    fn every(&self, a: usize, b: usize, f: &dyn Fn(&str, &str) -> String) -> String {
        let inner = |x: &str| -> String {
            if self.array(b) {
                format!("forall b in {}: {}", self.name(b), f(x, "b"))
            } else {
                self.elements(b).iter().map(|y| f(x, y)).collect::<Vec<_>>().join(" and ")
            }
        };
        if self.array(a) {
            format!("forall a in {}: {}", self.name(a), inner("a"))
        } else if self.array(b) {
            self.elements(a).iter().map(|x| format!("({})", inner(x))).collect::<Vec<_>>().join(" and ")
        } else {
            self.elements(a).iter().map(|x| inner(x)).collect::<Vec<_>>().join(" and ")
        }
    }

    /// Whether another fact says something of a thing.
    pub fn said(&self, item: usize, f: impl Fn(&What) -> bool) -> bool {
        self.scene.facts.iter().any(|fact| !fact.not && fact.of.contains(&item) && f(&fact.what))
    }

    /// The statements of one fact.
    fn fact(&self, k: usize, fact: &Fact) -> Vec<String> {
        let mut out = Vec::new();
        let verb = if fact.soft { "prefer" } else { "assert" };
        for of in &fact.of {
            match &fact.what {
                What::Rel(rel, to) if *rel == Rel::Between => {
                    out.extend(self.between(*of, to).map(|t| not(verb, &t, fact.not)))
                }
                What::Rel(rel, to) => {
                    for to in to {
                        self.rel(*of, *rel, *to, verb, fact.not, &mut out);
                    }
                }
                What::Place(rel, place, which) => self.place(k, *of, *rel, *place, which, verb, &mut out),
                What::Gap(op, v, to) => {
                    for to in to {
                        out.push(format!("{verb} {};", self.gap(*of, *to, *op, *v)));
                    }
                }
                What::Among(op, v) => out.extend(self.among(*of, *op, *v).map(|t| format!("{verb} {t};"))),
                What::Rows(op, v) => out.extend(self.rows_apart(*of, *op, *v).map(|t| format!("{verb} {t};"))),
                What::Wall(op, v) => {
                    let room = self.room(*of);
                    out.push(format!("{verb} {};", self.all(*of, |a| compared(&format!("gap({a}, {room})"), *op, *v))));
                }
                What::Alone(v) => out.push(self.alone(*of, *v)),
                What::Clear(side, v) => out.push(format!("{verb} {};", self.clear(*of, *side, *v))),
                What::Size(dim, op, v) => {
                    let axis = match dim {
                        Dim::Height | Dim::Ceiling => "y",
                        Dim::Depth => "z",
                        _ => "x",
                    };
                    out.push(format!("{verb} {};", self.all(*of, |a| compared(&format!("{a}.size.{axis}"), *op, *v))));
                }
                What::Height(op, v) => {
                    out.push(format!("{verb} {};", self.all(*of, |a| compared(&format!("{a}.bottom"), *op, *v))))
                }
                What::Path(v, to) => {
                    for to in to {
                        out.push(format!(
                            "{verb} {};",
                            self.every(*of, *to, &|a, b| format!("reachable({a}, {b}, {})", number(*v)))
                        ));
                    }
                }
                What::Pattern(pattern) => {
                    out.extend(self.pattern(*of, &fact.of, *pattern).map(|t| format!("{verb} {t};")))
                }
            }
        }
        out.dedup();
        out
    }

    fn group(&self, item: usize) -> Group {
        self.scene.items[item].group
    }

    fn rel(&self, a: usize, rel: Rel, b: usize, verb: &str, denied: bool, out: &mut Vec<String>) {
        let (ga, gb) = (self.group(a), self.group(b));
        let call = |p: &'static str| move |x: &str, y: &str| format!("{p}({x}, {y})");
        let far = |d: f64| move |x: &str, y: &str| format!("{}({x}, {y}, {})", "near", number(d));
        let pairs = |f: &dyn Fn(&str, &str) -> String| self.pairs(a, b, f);
        let m = self.counts[b];
        if denied {
            let p = predicate(rel);
            let f = |x: &str, y: &str| match p {
                "near" => format!("not near({x}, {y}, {})", number(NEAR)),
                p => format!("not {p}({x}, {y})"),
            };
            out.push(format!("{verb} {};", self.every(a, b, &f)));
            return;
        }
        let seat_at = ga == Group::Seat && matches!(gb, Group::Table);
        match rel {
            Rel::Around => self.around(a, b, verb, out),
            Rel::At if seat_at => self.around(a, b, verb, out),
            Rel::At => out.push(format!("{verb} {};", pairs(&far(if ga == Group::Seat { DRAWN_UP } else { NEAR })))),
            Rel::In if matches!(gb, Group::Door | Group::Window) => out.push(format!("{verb} {};", pairs(&far(NEAR)))),
            Rel::On => {
                if matches!(gb, Group::Wall | Group::Door | Group::Window) {
                    // On a door, on a window: as near as it can be.
                    out.push(format!("{verb} {};", pairs(&far(0.3))));
                } else {
                    out.push(format!("{verb} {};", pairs(&call("on"))));
                }
            }
            Rel::In => {
                let fits = (0..3).all(|i| self.sizes[a][i] < self.sizes[b][i] - 0.01)
                    && !matches!(gb, Group::Seat | Group::Flat | Group::Table);
                if fits {
                    out.push(format!("{verb} {};", pairs(&call("inside"))));
                    out.push(format!("allowCollide({}, {});", self.name(a), self.name(b)));
                    out.push(format!("allowFloat({});", self.name(a)));
                } else {
                    out.push(format!("{verb} {};", pairs(&call("on"))));
                }
            }
            Rel::Under
                if matches!(gb, Group::Wall | Group::Window | Group::Screen | Group::Ceiling) || self.hangs(b) =>
            {
                out.push(format!("{verb} {};", pairs(&call("below"))));
            }
            Rel::Under => {
                out.push(format!("{verb} {};", pairs(&call("under"))));
                out.push(format!("allowCollide({}, {});", self.name(a), self.name(b)));
            }
            Rel::Beside => {
                let both = self.counts[a] == 2 * m;
                if both && self.array(a) && a != b {
                    let side = |x: &str, i: usize, y: &str| {
                        format!("beside({x}, {y}) and {}({x}, {y})", if i == 0 { "leftOf" } else { "rightOf" })
                    };
                    let text = if m == 1 {
                        (0..2)
                            .map(|i| side(&format!("{}[{i}]", self.name(a)), i, self.name(b)))
                            .collect::<Vec<_>>()
                            .join(" and ")
                    } else {
                        let (of, to) = (self.name(a), format!("{}[i]", self.name(b)));
                        format!(
                            "forall i in 0..{m}: {}",
                            (0..2).map(|j| side(&indexed(of, 2, j), j, &to)).collect::<Vec<_>>().join(" and ")
                        )
                    };
                    out.push(format!("{verb} {text};"));
                } else if self.counts[a] > 2 && m == 1 {
                    // Three things have no room at two sides.
                    out.push(format!("{verb} {};", pairs(&far(NEAR))));
                } else {
                    out.push(format!("{verb} {};", pairs(&call("beside"))));
                }
            }
            Rel::InFrontOf | Rel::Behind => {
                out.push(format!("{verb} {};", pairs(&call(predicate(rel)))));
                if ga == Group::Seat && matches!(gb, Group::Table) {
                    let d = if self.said(a, |w| matches!(w, What::Gap(..))) { None } else { Some(DRAWN_UP) };
                    if let Some(d) = d {
                        out.push(format!("{verb} {};", pairs(&far(d))));
                    }
                    out.push(format!("{verb} {};", pairs(&call("facing"))));
                }
            }
            Rel::Near => out.push(format!("{verb} {};", pairs(&far(NEAR)))),
            Rel::Against | Rel::Along => {
                out.push(format!("{verb} {};", pairs(&far(if rel == Rel::Against { 0.1 } else { 0.5 }))))
            }
            Rel::Facing if self.grid(a).is_some() => {
                let (of, to) = (self.name(a), self.elements(b));
                let to = to.first().map_or("", String::as_str);
                out.push(format!("{verb} exists a in {of}: facing(a, {to});"));
                out.push(format!("{verb} forall a in {of}: dot({to}.center - a.center, a.front) >= 0;"));
            }
            Rel::Facing => out.push(format!("{verb} {};", pairs(&call("facing")))),
            Rel::Opposite => {
                let front = !self.scene.items[b].opening();
                let f = |x: &str, y: &str| {
                    if front {
                        format!("facing({x}, {y}) and inFrontOf({x}, {y})")
                    } else {
                        format!("facing({x}, {y})")
                    }
                };
                out.push(format!("{verb} {};", pairs(&f)));
            }
            Rel::Far => {
                let room = self.room_sizes.get(self.scene.items[a].room).copied().unwrap_or([6.0; 3]);
                let d = (room[0].min(room[2]) / 3.0).clamp(0.5, 2.0);
                out.push(format!(
                    "{verb} {};",
                    self.every(a, b, &|x, y| format!("far({x}, {y}, {})", number((d * 10.0).floor() / 10.0)))
                ));
            }
            Rel::Perpendicular => {
                out.push(format!("{verb} {};", pairs(&|x, y| format!("abs(dot({x}.front, {y}.front)) <= 0.1"))))
            }
            Rel::Visible => out.push(format!("{verb} {};", self.every(a, b, &call("visible")))),
            Rel::Reachable => {
                out.push(format!("{verb} {};", self.every(a, b, &|x, y| format!("reachable({x}, {y}, 0.8)"))))
            }
            Rel::Mounted | Rel::Hang => {
                out.push(format!("{verb} {};", pairs(&far(0.1))));
                out.push(format!("allowFloat({});", self.name(a)));
            }
            Rel::LeftOf | Rel::RightOf | Rel::Above | Rel::Parallel | Rel::Aligned => {
                out.push(format!("{verb} {};", pairs(&call(predicate(rel)))))
            }
            Rel::Between | Rel::From | Rel::Of | Rel::To | Rel::Than => {}
        }
    }

    /// Whether a thing hangs: nothing can be under it in the sense of "pushed under".
    fn hangs(&self, item: usize) -> bool {
        self.said(item, |w| {
            matches!(w, What::Place(_, Place::Wall, _))
                && !matches!(self.group(item), Group::Table | Group::Bed | Group::Seat)
        }) && self.scene.facts.iter().any(|f| {
            f.of.contains(&item) && matches!(f.what, What::Place(Rel::Mounted | Rel::On | Rel::Hang, Place::Wall, _))
        })
    }

    /// Things around one, or around each of several.
    fn around(&self, a: usize, b: usize, verb: &str, out: &mut Vec<String>) {
        let (n, m) = (self.counts[a], self.counts[b]);
        let (of, to) = (self.name(a), self.name(b));
        let seat = self.group(a) == Group::Seat;
        let gap = self.scene.facts.iter().find_map(|f| match &f.what {
            What::Gap(_, v, t) if f.of.contains(&a) && t.contains(&b) => Some(*v),
            _ => None,
        });
        let d = gap.map_or(if seat { DRAWN_UP } else { AROUND }, |v| v + 0.3);
        if m == 1 && n > 1 {
            out.push(format!("{verb} around({of}, {to}, {});", number(d)));
        } else if m > 1 && n % m == 0 && n > m && n / m <= 8 {
            // Each table has its own: at its four sides in turn.
            let k = n / m;
            let sides: &[&str] = match k {
                2 => &["leftOf", "rightOf"],
                3 => &["leftOf", "rightOf", "inFrontOf"],
                4 => &["leftOf", "rightOf", "inFrontOf", "behind"],
                _ => &["inFrontOf", "behind", "inFrontOf", "behind", "leftOf", "rightOf", "inFrontOf", "behind"],
            };
            let each: Vec<String> = (0..k).map(|j| format!("{}({}, {to}[i])", sides[j], indexed(of, k, j))).collect();
            out.push(format!("{verb} forall i in 0..{m}: {};", each.join(" and ")));
            out.push(format!("{verb} {};", self.pairs(a, b, &|x, y| format!("near({x}, {y}, {})", number(d)))));
        } else {
            out.push(format!("{verb} {};", self.pairs(a, b, &|x, y| format!("near({x}, {y}, {})", number(d)))));
        }
        if seat {
            out.push(format!(
                "{} {};",
                if m > 1 { "prefer" } else { verb },
                self.pairs(a, b, &|x, y| format!("facing({x}, {y})"))
            ));
        }
    }

    fn between(&self, a: usize, to: &[usize]) -> Option<String> {
        let f = |x: &str, y: &str, z: &str| format!("between({x}, {y}, {z})");
        match to {
            [b] if self.counts[*b] > 1 => {
                let e = self.elements(*b);
                if self.array(a) && self.array(*b) {
                    let n = self.counts[a].min(self.counts[*b] - 1);
                    let (of, to) = (self.name(a), self.name(*b));
                    return Some(format!("forall i in 0..{n}: between({of}[i], {to}[i], {to}[i + 1])"));
                }
                Some(self.all(a, |x| f(x, &e[0], &e[1])))
            }
            [b, c, ..] => {
                let (b, c) = (self.elements(*b), self.elements(*c));
                Some(self.all(a, |x| f(x, &b[0], &c[0])))
            }
            _ => None,
        }
    }

    fn gap(&self, a: usize, b: usize, op: Op, v: f64) -> String {
        match op {
            Op::Least => self.every(a, b, &|x, y| format!("far({x}, {y}, {})", number(v))),
            Op::Most => self.pairs(a, b, &|x, y| format!("near({x}, {y}, {})", number(v))),
            Op::Equal => self.pairs(a, b, &|x, y| format!("abs(gap({x}, {y}) - {}) <= 0.05", number(v))),
        }
    }

    fn among(&self, a: usize, op: Op, v: f64) -> Option<String> {
        if !self.array(a) {
            return None;
        }
        let of = self.name(a);
        let n = self.counts[a];
        Some(match op {
            Op::Least => format!("forall a in {of}: forall b in {of}: a != b implies far(a, b, {})", number(v)),
            Op::Most => format!("forall i in 0..{}: near({of}[i], {of}[i + 1], {})", n - 1, number(v)),
            Op::Equal => format!("forall i in 0..{}: abs(gap({of}[i], {of}[i + 1]) - {}) <= 0.05", n - 1, number(v)),
        })
    }

    /// Nothing else so near. What was put near it is left out.
    fn alone(&self, a: usize, v: f64) -> String {
        let kin: Vec<usize> = (0..self.counts.len()).filter(|i| *i != a && self.kin(a, *i)).collect();
        let except: String = kin.iter().flat_map(|i| self.elements(*i)).map(|e| format!(" and o != {e}")).collect();
        let v = number(v);
        if self.array(a) {
            let of = self.name(a);
            return format!("prefer forall a in {of}: forall o in objects: o != a{except} implies far(o, a, {v});");
        }
        let of = self.name(a);
        format!("assert forall o in objects: o != {of}{except} implies far(o, {of}, {v});")
    }

    /// Whether two things are said to be near each other, or above one another.
    fn kin(&self, a: usize, b: usize) -> bool {
        let flat = matches!(self.group(b), Group::Flat | Group::Ceiling | Group::Wall | Group::Door | Group::Window);
        flat || self.scene.facts.iter().any(|f| match &f.what {
            What::Rel(rel, to) => {
                !f.not
                    && *rel != Rel::Far
                    && (f.of.contains(&a) && to.contains(&b) || f.of.contains(&b) && to.contains(&a))
            }
            _ => false,
        })
    }

    fn clear(&self, a: usize, side: Side, v: f64) -> String {
        let v = number(v);
        let door = self.group(a) == Group::Door;
        let sides: &[&str] = match side {
            Side::Front => &["front"],
            Side::Behind => &["behind"],
            Side::Left => &["left"],
            Side::Right => &["right"],
            Side::Above => &["above"],
            Side::Around if door => &["front", "behind"],
            Side::Around => &["left", "right"],
        };
        // A door's front is whichever side the solver gives it.
        let outer = door && self.scene.items[a].beyond.is_none();
        let sides: &[&str] = if door && !outer { &["front", "behind"] } else { sides };
        self.all(a, |x| sides.iter().map(|s| format!("clear({x}, {s}, {v})")).collect::<Vec<_>>().join(" and "))
    }

    fn pattern(&self, a: usize, all: &[usize], pattern: Pattern) -> Option<String> {
        let of = self.name(a);
        let n = self.counts[a];
        if !self.array(a) {
            // Several single things: "range, grill, fryer, left to right".
            let place = all.iter().position(|i| *i == a)?;
            let next = *all.get(place + 1)?;
            return Some(match pattern {
                Pattern::LeftToRight => self.pairs(a, next, &|x, y| format!("leftOf({x}, {y})")),
                Pattern::FaceToFace => self.pairs(a, next, &|x, y| format!("facing({x}, {y}) and facing({y}, {x})")),
                Pattern::SideBySide => self.pairs(a, next, &|x, y| format!("beside({x}, {y})")),
                _ => self.pairs(a, next, &|x, y| format!("aligned({x}, {y})")),
            });
        }
        Some(match pattern {
            Pattern::Row | Pattern::Rows(_) | Pattern::LeftToRight if self.grid(a).is_some() => {
                return self.rows(a);
            }
            Pattern::Row | Pattern::LeftToRight => {
                format!("forall i in 1..{n}: aligned({of}[i], {of}[0]) and parallel({of}[i], {of}[0])")
            }
            Pattern::Rows(rows) if rows > 1 && n.is_multiple_of(rows) && n > rows => {
                let k = n / rows;
                format!(
                    "forall r in 0..{rows}: forall i in 1..{k}: aligned({of}[{k} * r + i], {of}[{k} * r]) and parallel({of}[{k} * r + i], {of}[{k} * r])"
                )
            }
            Pattern::Rows(_) => format!("forall i in 1..{n}: parallel({of}[i], {of}[0])"),
            Pattern::Circle => {
                let around = self.centre_of(a);
                match around {
                    Some(b) => format!("around({of}, {}, {})", self.name(b), number(AROUND)),
                    None => format!("forall i in 0..{}: near({of}[i], {of}[i + 1], {})", n - 1, number(AROUND)),
                }
            }
            Pattern::SideBySide => format!("forall i in 0..{}: beside({of}[i], {of}[i + 1])", n - 1),
            Pattern::BackToBack => format!(
                "forall i in 0..{}: behind({of}[2 * i], {of}[2 * i + 1]) and near({of}[2 * i], {of}[2 * i + 1], 0.1) and angle({of}[2 * i].front, {of}[2 * i + 1].front) >= 175",
                n / 2
            ),
            Pattern::FaceToFace => format!(
                "forall i in 0..{}: facing({of}[2 * i], {of}[2 * i + 1]) and facing({of}[2 * i + 1], {of}[2 * i])",
                n / 2
            ),
            Pattern::Stacked => format!("forall i in 1..{n}: on({of}[i], {of}[i - 1])"),
        })
    }

    /// The rows of an array, measured from its first element.
    pub fn rows(&self, a: usize) -> Option<String> {
        let grid = self.grid(a)?;
        let (of, n, k) = (self.name(a), self.counts[a], grid.columns);
        let [x, z] = grid.steps.map(number);
        let place = |at: String, r: &str| {
            format!("{at}.pos.x = {of}[0].pos.x + i * {x} and {at}.pos.z = {of}[0].pos.z - {r} * {z}")
        };
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

    /// Seats at tables that stand in rows: each at its place, turned to its table.
    pub fn drawn_up(&self, a: usize) -> Option<String> {
        let (rel, b) = self.scene.facts.iter().find_map(|f| match &f.what {
            What::Rel(rel @ (Rel::Around | Rel::At | Rel::InFrontOf | Rel::Behind | Rel::Near), to)
                if f.of == [a] && to.len() == 1 =>
            {
                Some((*rel, to[0]))
            }
            _ => None,
        })?;
        self.grid(b)?;
        let (n, m) = (self.counts[a], self.counts[b]);
        if self.group(a) != Group::Seat || m < 2 || n % m != 0 {
            return None;
        }
        let k = n / m;
        let two_behind = k == 2 && matches!(rel, Rel::Behind | Rel::InFrontOf);
        let places = super::grid::seats(k, rel != Rel::Behind);
        if places.len() < k || two_behind {
            return None;
        }
        let (of, to) = (self.name(a), self.name(b));
        let [w, _, d] = self.sizes[b];
        let seat = self.sizes[a][2];
        let each: Vec<String> = (0..k)
            .map(|j| {
                let (at, (share, turned)) = (indexed(of, k, j), places[j]);
                let [x, z] = [share[0] * (w / 2.0 + seat / 2.0 + 0.1), share[1] * (d / 2.0 + seat / 2.0 + 0.1)];
                format!(
                    "{at}.pos.x = {to}[i].pos.x + {} and {at}.pos.z = {to}[i].pos.z + {} and {at}.rot = rot(0, {}, 0)",
                    number(x),
                    number(z),
                    number(turned)
                )
                .replace("+ -", "- ")
                .replace(" + 0 ", " ")
            })
            .collect();
        Some(format!("forall i in 0..{m}: {}", each.join(" and ")))
    }

    /// How an array in rows stands, if nothing else says where.
    pub fn grid(&self, a: usize) -> Option<super::grid::Grid> {
        let room = self.room_sizes.get(self.scene.items[a].room)?;
        super::grid::grid(self.scene, &self.sizes, a, Some(*room))
    }

    fn rows_apart(&self, a: usize, op: Op, v: f64) -> Option<String> {
        let Some(grid) = self.grid(a).filter(|g| g.rows > 1) else { return self.among(a, op, v) };
        let (of, k, v) = (self.name(a), grid.columns, number(v));
        let test = match op {
            Op::Most => format!("near({of}[i], {of}[i + {k}], {v})"),
            _ => format!("far({of}[i], {of}[i + {k}], {v})"),
        };
        Some(format!("forall i in 0..{}: {test}", self.counts[a] - k))
    }

    /// What a circle is around, if that was said.
    fn centre_of(&self, a: usize) -> Option<usize> {
        self.scene.facts.iter().find_map(|f| match &f.what {
            What::Rel(Rel::Around, to) if f.of.contains(&a) && self.counts[to[0]] == 1 => Some(to[0]),
            _ => None,
        })
    }

    // ---- Places ----

    #[allow(clippy::too_many_arguments)]
    fn place(&self, k: usize, a: usize, rel: Rel, place: Place, which: &[String], verb: &str, out: &mut Vec<String>) {
        let room = self.room(a);
        let group = self.group(a);
        let opening = self.scene.items[a].opening();
        // What things stand behind cannot have its back at a wall.
        let behind =
            self.scene.facts.iter().any(|f| !f.not && matches!(&f.what, What::Rel(Rel::Behind, to) if to.contains(&a)));
        let verb = if behind && place == Place::Wall && !opening { "prefer" } else { verb };
        let mut say = |text: String| out.push(format!("{verb} {text};"));
        match place {
            Place::Wall if opening => {
                if let Some(text) = self.side(a, which) {
                    say(text);
                }
            }
            Place::Wall => {
                let up = matches!(group, Group::Wall | Group::Screen | Group::Drape)
                    || matches!(rel, Rel::Mounted | Rel::Hang)
                    || rel == Rel::On && !matches!(group, Group::Table | Group::Seat | Group::Bed)
                    || group == Group::Ceiling;
                say(self.all(a, |x| {
                    if up { format!("wallMounted({x}, {room})") } else { format!("againstWall({x}, {room})") }
                }));
                if let Some(text) = self.wall(k, a, which) {
                    say(text);
                }
            }
            Place::Corner if self.counts[a] <= 4 && !matches!(group, Group::Ceiling | Group::Top) => {
                say(self.all(a, |x| format!("inCorner({x}, {room})")));
                if let Some(text) = self.side(a, which) {
                    say(text);
                }
            }
            Place::Corner => say(self.all(a, |x| format!("gap({x}, {room}) <= 0.5"))),
            Place::Ceiling => say(self.all(a, |x| format!("ceilingMounted({x}, {room})"))),
            Place::Floor => say(self.all(a, |x| format!("onFloor({x}, {room})"))),
            Place::Middle if opening => {}
            Place::Middle if self.counts[a] == 1 => say(format!("centeredIn({}, {room})", self.name(a))),
            Place::Middle => {
                let size = self.room_sizes.get(self.scene.items[a].room).copied().unwrap_or([6.0; 3]);
                let half = self.grid(a).map_or(0.0, |g| {
                    (g.steps[0] * (g.columns - 1) as f64).hypot(g.steps[1] * (g.rows - 1) as f64) / 2.0 + 0.6
                });
                let reach = number(((size[0].min(size[2]) / 3.0).max(half) * 10.0).ceil() / 10.0);
                say(self.all(a, |x| {
                    format!(
                        "length(vec3({x}.center.x - {room}.center.x, 0, {x}.center.z - {room}.center.z)) <= {reach}"
                    )
                }));
            }
            Place::Side | Place::End | Place::Back | Place::Front | Place::Head | Place::Foot => {
                let mut which = which.to_vec();
                match place {
                    Place::Back => which.push("back".into()),
                    Place::Front => which.push("front".into()),
                    _ => {}
                }
                if let Some(text) = self.side(a, &which) {
                    say(text);
                }
            }
            Place::Row | Place::Circle => {}
        }
    }

    /// At which wall: its back is to it.
    fn wall(&self, k: usize, a: usize, which: &[String]) -> Option<String> {
        let size = self.room_sizes.get(self.scene.items[a].room).copied().unwrap_or([6.0, 2.7, 5.0]);
        for w in which {
            match (direction(w), w.as_str()) {
                (Some((axis, sign)), _) => {
                    let test = if sign > 0.0 { "<= -0.9" } else { ">= 0.9" };
                    return Some(self.all(a, |x| format!("{x}.front.{axis} {test}")));
                }
                (_, "long" | "longer" | "longest" | "short" | "shorter" | "side") => {
                    let along_x = size[0] >= size[2];
                    let long = w.starts_with("long");
                    let axis = if w == "side" || along_x != long { "x" } else { "z" };
                    return Some(self.all(a, |x| format!("abs({x}.front.{axis}) >= 0.9")));
                }
                (_, "opposite" | "other" | "same" | "opposing") => {
                    let other = self.scene.facts[..k].iter().rev().find(|f| {
                        !f.of.contains(&a)
                            && matches!(f.what, What::Place(_, Place::Wall, _))
                            && self.scene.items[f.of[0]].room == self.scene.items[a].room
                    })?;
                    let b = self.elements(other.of[0]).first()?.clone();
                    let test = if w == "same" { ">= 0.9" } else { "<= -0.9" };
                    return Some(self.all(a, |x| format!("dot({x}.front, {b}.front) {test}")));
                }
                _ => {}
            }
        }
        None
    }

    /// In which part of the room.
    fn side(&self, a: usize, which: &[String]) -> Option<String> {
        let room = self.room(a);
        let size = self.room_sizes.get(self.scene.items[a].room).copied().unwrap_or([6.0, 2.7, 5.0]);
        let tests: Vec<(char, f64)> = which.iter().filter_map(|w| direction(w)).collect();
        if tests.is_empty() {
            return None;
        }
        Some(self.all(a, |x| {
            let each: Vec<String> = tests
                .iter()
                .map(|(axis, sign)| {
                    let reach = if self.scene.items[a].opening() {
                        if *axis == 'x' { size[0] / 2.0 - 0.3 } else { size[2] / 2.0 - 0.3 }
                    } else {
                        0.0
                    };
                    if *sign > 0.0 {
                        format!("{x}.center.{axis} >= {room}.center.{axis} + {}", number(reach))
                    } else {
                        format!("{x}.center.{axis} <= {room}.center.{axis} - {}", number(reach))
                    }
                })
                .collect();
            each.join(" and ").replace(" + 0 ", " ").replace(" - 0 ", " ")
        }))
    }
}

/// An element of an array by the index of its partner.
fn indexed(of: &str, k: usize, j: usize) -> String {
    match j {
        0 if k == 1 => format!("{of}[i]"),
        0 => format!("{of}[{k} * i]"),
        j => format!("{of}[{k} * i + {j}]"),
    }
}

fn not(verb: &str, text: &str, denied: bool) -> String {
    match (denied, text.strip_prefix("forall a in ").and_then(|t| t.split_once(": "))) {
        (false, _) => format!("{verb} {text};"),
        (true, Some((set, formula))) => format!("{verb} forall a in {set}: not {formula};"),
        (true, None) => format!("{verb} not {text};"),
    }
}

fn compared(what: &str, op: Op, v: f64) -> String {
    let v = number(v);
    match op {
        Op::Least => format!("{what} >= {v}"),
        Op::Most => format!("{what} <= {v}"),
        Op::Equal => format!("abs({what} - {v}) <= 0.02"),
    }
}

/// The predicate of the standard library.
fn predicate(rel: Rel) -> &'static str {
    match rel {
        Rel::On => "on",
        Rel::Under => "under",
        Rel::Above => "above",
        Rel::Beside => "beside",
        Rel::LeftOf => "leftOf",
        Rel::RightOf => "rightOf",
        Rel::InFrontOf => "inFrontOf",
        Rel::Behind => "behind",
        Rel::Facing | Rel::Opposite => "facing",
        Rel::Parallel => "parallel",
        Rel::Aligned => "aligned",
        Rel::Visible => "visible",
        _ => "near",
    }
}

/// Compass and plan: north and back are +z, east and right +x.
fn direction(word: &str) -> Option<(char, f64)> {
    let word = word.strip_suffix("ern").unwrap_or(word);
    Some(match word {
        "north" | "back" | "rear" | "far" | "upper" | "top" | "farthest" | "furthest" => ('z', 1.0),
        "south" | "front" | "near" | "lower" | "bottom" | "entrance" => ('z', -1.0),
        "east" | "right" | "right-hand" => ('x', 1.0),
        "west" | "left" | "left-hand" => ('x', -1.0),
        _ => return None,
    })
}
