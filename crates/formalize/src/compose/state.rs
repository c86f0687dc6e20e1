//! What is said → statements of the language: calls of the standard library's predicates, one statement for each thing said.

mod gaps;
mod places;
mod relations;
mod rows;
mod said;

use crate::brief::{Brief, Dim, Fact, FactKind, Group, Op, Place, Rel, Side};
use crate::draft::{Note, Statement, ThingOrigin};
use crate::write::number;
pub(super) use relations::ACROSS;

/// More elements than this are not listed one by one.
const LISTED: usize = 12;

/// Names and counts that statements speak of.
pub struct Named<'a> {
    /// What was read.
    pub brief: &'a Brief,
    /// Names of things; of an opening that there are several of, one for each.
    pub names: Vec<Vec<String>>,
    /// How many of each.
    pub counts: Vec<usize>,
    pub rooms: Vec<String>,
    /// Sizes of things.
    pub sizes: Vec<[f64; 3]>,
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
    for (k, fact) in named.brief.facts.iter().enumerate() {
        let texts = named.fact(k, fact);
        if texts.is_empty() {
            out.notes
                .push(Note { at: fact.source.at(), reason: "no predicate expresses this for a single object".into() });
        }
        // Nobody softened it, and it is weaker than it was said all the same.
        let weak = |text: &String| text.starts_with("prefer ");
        if !fact.soft && fact.source.reason().is_none() && !texts.is_empty() && texts.iter().all(weak) {
            let reason = "kept as a preference: as a requirement it would contradict another part of the request";
            out.notes.push(Note { at: fact.source.at(), reason: reason.into() });
        }
        // Of what nobody asked for nobody said anything either.
        let why = fact.of.iter().map(|of| &named.brief.things[*of].source).find(|source| source.reason().is_some());
        for text in texts {
            out.push(text, why.unwrap_or(&fact.source).clone());
        }
    }
    super::usual::usual(named, &mut out);
    out
}

impl Stated {
    /// Adds a statement, once.
    #[expect(clippy::needless_pass_by_value, reason = "callers make the text for this call")]
    pub fn push(&mut self, text: String, source: ThingOrigin) {
        let statement = Statement::new(&text, source);
        let known = |s: &Statement| s.text == statement.text && s.demand == statement.demand;
        if !self.statements.iter().any(known) {
            self.statements.push(statement);
        }
    }

    /// Adds what the request does not say.
    pub fn infer(&mut self, text: String, why: &str) {
        self.push(text, ThingOrigin::Inferred(why.into()));
    }
}

impl Named<'_> {
    /// The room of a thing, by name.
    pub fn room(&self, item: usize) -> &str {
        self.rooms.get(self.brief.things[item].room).map_or("", String::as_str)
    }

    /// The set, or the one.
    pub fn name(&self, item: usize) -> &str {
        self.names[item].first().map_or("", String::as_str)
    }

    fn array(&self, item: usize) -> bool {
        self.counts[item] > 1 && !self.brief.things[item].opening() && self.brief.things[item].part.is_none()
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
            if to.len() == n {
                let each = to.iter().enumerate().map(|(i, t)| f(&format!("{of}[{i}]"), t));
                return each.collect::<Vec<_>>().join(" and ");
            }
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

    /// A formula for each element of `a`, with some one of `b`.
    fn some(&self, a: usize, b: usize, f: &dyn Fn(&str, &str) -> String) -> String {
        if self.array(a) && self.array(b) {
            return format!("forall a in {}: exists b in {}: {}", self.name(a), self.name(b), f("a", "b"));
        }
        self.pairs(a, b, f)
    }

    /// A formula for each element of `b`, with the one of `a`, or with some of them.
    fn each(&self, a: usize, b: usize, f: &dyn Fn(&str, &str) -> String) -> String {
        if !self.array(a) {
            return self.every(a, b, f);
        }
        let one = |y: &str| format!("exists a in {}: {}", self.name(a), f("a", y));
        if self.array(b) {
            format!("forall b in {}: {}", self.name(b), one("b"))
        } else {
            self.elements(b).iter().map(|y| format!("({})", one(y))).collect::<Vec<_>>().join(" and ")
        }
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

    /// Whether a fact says something of a thing, or of some of several.
    pub fn said(&self, item: usize, f: impl Fn(&FactKind) -> bool) -> bool {
        let of = |i: &usize| *i == item || self.brief.whole(*i) == item;
        self.brief.facts.iter().any(|fact| !fact.not && fact.of.iter().any(of) && f(&fact.what))
    }

    /// The statements of one fact.
    fn fact(&self, k: usize, fact: &Fact) -> Vec<String> {
        let mut out = Vec::new();
        let verb = if fact.soft { "prefer" } else { "assert" };
        for of in &fact.of {
            match &fact.what {
                // On a wall between two things: near both, too.
                FactKind::Rel(Rel::Between, to)
                    if !fact.not && matches!(self.group(*of), Group::Wall | Group::Screen) =>
                {
                    out.extend(self.between(*of, to).map(|t| format!("{verb} {t};")));
                    for to in to {
                        out.push(format!("{verb} {};", self.every(*of, *to, &|a, b| format!("near({a}, {b}, 2)"))));
                    }
                }
                FactKind::Rel(rel, to) if *rel == Rel::Between => {
                    // "in the corner between the window and the door": it tells which corner.
                    let corner = self.said(*of, |w| matches!(w, FactKind::Place(_, Place::Corner, _)));
                    let verb = if corner { "prefer" } else { verb };
                    out.extend(self.between(*of, to).map(|t| not(verb, &t, fact.not)))
                }
                FactKind::Rel(rel, to) => {
                    for to in to {
                        self.rel(fact, *of, *rel, *to, &mut out);
                    }
                }
                FactKind::Place(rel, place, _) if fact.not => {
                    out.extend(self.not_at(*of, *rel, *place).map(|t| format!("{verb} {t};")));
                }
                FactKind::Place(rel, place, which) => self.place(k, *of, *rel, *place, which, verb, &mut out),
                FactKind::Gap(op, v, to) => {
                    for to in to {
                        out.push(format!("{verb} {};", self.gap(*of, *to, *op, *v, [fact.subject, fact.object])));
                    }
                }
                FactKind::Among(op, v) => out.extend(self.among(*of, *op, *v).map(|t| format!("{verb} {t};"))),
                FactKind::Rows(op, v) => out.extend(self.rows_apart(*of, *op, *v).map(|t| format!("{verb} {t};"))),
                FactKind::Wall(op, v) => {
                    let room = self.room(*of);
                    out.push(format!("{verb} {};", self.all(*of, |a| compared(&format!("gap({a}, {room})"), *op, *v))));
                }
                FactKind::Alone(v) => out.push(self.alone(*of, *v)),
                FactKind::Clear(side, v) => out.push(format!("{verb} {};", self.clear(*of, *side, *v))),
                FactKind::Size(dim, op, v) => {
                    let axis = match dim {
                        Dim::Height | Dim::Ceiling | Dim::Elevation => "y",
                        Dim::Depth => "z",
                        _ => "x",
                    };
                    out.push(format!("{verb} {};", self.all(*of, |a| compared(&format!("{a}.size.{axis}"), *op, *v))));
                }
                FactKind::Height(op, v) => {
                    // What stands on the floor is meant otherwise: its top, or another thing altogether.
                    let floor = matches!(self.group(*of), Group::Seat | Group::Table | Group::Bed | Group::Floor)
                        && !self.said(*of, |w| {
                            matches!(w, FactKind::Place(_, Place::Wall | Place::Ceiling, _))
                                || matches!(w, FactKind::Rel(Rel::Mounted | Rel::Hang | Rel::Above | Rel::On, _))
                        });
                    let verb = if floor && *v > 0.05 { "prefer" } else { verb };
                    out.push(format!("{verb} {};", self.all(*of, |a| compared(&format!("{a}.bottom"), *op, *v))))
                }
                FactKind::Path(v, to) => {
                    for to in to {
                        out.push(format!(
                            "{verb} {};",
                            self.every(*of, *to, &|a, b| format!("reachable({a}, {b}, {})", number(*v)))
                        ));
                    }
                }
                FactKind::Pattern(pattern) => {
                    out.extend(self.pattern(*of, &fact.of, *pattern).map(|t| format!("{verb} {t};")))
                }
            }
        }
        out.dedup();
        out
    }

    fn group(&self, item: usize) -> Group {
        self.brief.things[item].group
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
