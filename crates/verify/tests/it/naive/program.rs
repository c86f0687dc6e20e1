//! A program of random statements: how it is written, and its formulas with quantifiers, names and predicates replaced by
//! what they stand for.

use super::scene::{Chosen, Scene};
use super::term::{Domain, Order, Quantity, Sign, Term};
use std::fmt::Write as _;

/// A predicate of the user's.
#[derive(Clone, Debug)]
pub struct Predicate {
    pub name: &'static str,
    /// Type and name of each.
    pub parameters: Vec<(&'static str, &'static str)>,
    pub body: Term,
}

/// A statement that makes a row of a report.
#[derive(Clone, Debug)]
pub enum Statement {
    Assert(Term),
    Prefer(Term, f64),
    /// An assignment to the property of a thing or a room.
    Pin(Term, Term),
}

#[derive(Clone, Debug, Default)]
pub struct Program {
    pub predicates: Vec<Predicate>,
    /// Type, name, value.
    pub definitions: Vec<(&'static str, &'static str, Term)>,
    pub statements: Vec<Statement>,
    /// Pairs of `allowCollide`.
    pub collide: Vec<(usize, usize)>,
    pub outside: Vec<usize>,
    pub float: Vec<usize>,
}

impl Program {
    /// As it would be written.
    pub fn text(&self, scene: &Scene) -> String {
        let mut out = String::new();
        for (i, thing) in scene.things.iter().enumerate() {
            match &scene.array {
                Some((name, elements)) if elements.contains(&i) => {
                    if elements[0] == i {
                        writeln!(out, "object {name}[{}];", elements.len()).unwrap();
                    }
                }
                _ => writeln!(out, "object {};", thing.name).unwrap(),
            }
            for (property, text) in [("color", thing.color), ("category", thing.category)] {
                if !text.is_empty() {
                    writeln!(out, "{}.{property} <- \"{text}\";", thing.name).unwrap();
                }
            }
            if let Some([w, h, d]) = thing.dimensions {
                writeln!(out, "{}.dimensions <- vec3({w}, {h}, {d});", thing.name).unwrap();
            }
        }
        for room in &scene.rooms {
            writeln!(out, "region {};", room.name).unwrap();
        }
        for (name, value) in &scene.chosen {
            let ty = match value {
                Chosen::Number(_) => "Number",
                Chosen::Degree(_) => "Degree",
                Chosen::Bool(_) => "Bool",
                Chosen::Vector(_) => "Vector3",
                Chosen::Rotation(_) => "Rotation",
            };
            writeln!(out, "{ty} {name};").unwrap();
        }
        for (ty, name, value) in &self.definitions {
            writeln!(out, "{ty} {name};\n{name} <- {value};").unwrap();
        }
        for p in &self.predicates {
            let parameters: Vec<String> = p.parameters.iter().map(|(ty, name)| format!("{ty} {name}")).collect();
            writeln!(out, "predicate {}({}) := {};", p.name, parameters.join(", "), p.body).unwrap();
        }
        let name = |i: &usize| &scene.things[*i].name;
        for (a, b) in &self.collide {
            writeln!(out, "allowCollide({}, {});", name(a), name(b)).unwrap();
        }
        self.outside.iter().for_each(|a| writeln!(out, "allowOutside({});", name(a)).unwrap());
        self.float.iter().for_each(|a| writeln!(out, "allowFloat({});", name(a)).unwrap());
        for statement in &self.statements {
            match statement {
                Statement::Assert(term) => writeln!(out, "assert {term};"),
                Statement::Prefer(term, weight) => writeln!(out, "prefer {term} weight {weight};"),
                Statement::Pin(target, value) => writeln!(out, "{target} <- {value};"),
            }
            .unwrap();
        }
        out
    }
}

/// Replaces names by what they stand for, and numbers the draws of one statement.
pub struct Expansion<'p> {
    pub program: &'p Program,
    pub scene: &'p Scene,
    /// `assert[3]`, `a.pos`: what the keys of draws begin with.
    pub owner: String,
    /// Bounds and keys of the draws so far.
    pub draws: Vec<(String, f64, f64)>,
}

impl<'p> Expansion<'p> {
    pub fn new(program: &'p Program, scene: &'p Scene, owner: &str) -> Self {
        Self { program, scene, owner: owner.to_owned(), draws: Vec::new() }
    }

    fn draw(&mut self, lo: f64, hi: f64) -> Term {
        let before = self.draws.iter().filter(|(key, ..)| key.starts_with(&format!("{}/", self.owner))).count();
        let key = format!("{}/{before}", self.owner);
        self.draws.push((key.clone(), lo, hi));
        Term::Draw(key)
    }

    pub fn expand(&mut self, term: &Term, bound: &[(String, Term)]) -> Term {
        let mut both = |a: &Term, b: &Term| [self.expand(a, bound), self.expand(b, bound)].map(Box::new);
        match term {
            Term::Name(name) => self.named(name, bound),
            Term::Element(array, index) => {
                let Term::Whole(index) = whole(&self.expand(index, bound)) else { panic!("no index: {index}") };
                let (_, elements) = self.scene.array.as_ref().filter(|(name, _)| name == array).expect("the array");
                Term::Object(elements[index])
            }
            Term::Property(of, property) => {
                let of = of.as_ref().expect("only filters have none");
                Term::Property(Some(Box::new(self.expand(of, bound))), property)
            }
            Term::Component(of, axis) => self.expand(of, bound).component(*axis),
            Term::Call(name, arguments) => {
                let arguments: Vec<Term> = arguments.iter().map(|a| self.expand(a, bound)).collect();
                let Some(p) = self.program.predicates.iter().find(|p| p.name == name) else {
                    return Term::Call(name.clone(), arguments);
                };
                let bound: Vec<_> = p.parameters.iter().map(|(_, name)| (*name).to_owned()).zip(arguments).collect();
                Term::Inner(Box::new(self.expand(&p.body, &bound)))
            }
            Term::Set(domain) => Term::Objects(self.domain(domain)),
            Term::Rand(lo, hi) => self.draw(*lo, *hi),
            Term::Neg(a) => Term::Neg(Box::new(self.expand(a, bound))),
            Term::Not(a) => Term::not(self.expand(a, bound)),
            Term::Arith(sign, a, b) => {
                let [a, b] = both(a, b);
                Term::Arith(*sign, a, b)
            }
            Term::Compare(order, a, b) => {
                let [a, b] = both(a, b);
                Term::Compare(*order, a, b)
            }
            Term::And(a, b) => {
                let [a, b] = both(a, b);
                Term::And(a, b)
            }
            Term::Or(a, b) => {
                let [a, b] = both(a, b);
                Term::Or(a, b)
            }
            Term::Implies(a, b) => {
                let [a, b] = both(a, b);
                Term::Implies(a, b)
            }
            Term::Quantified(quantity, variable, domain, body) => {
                let over: Vec<Term> = match domain {
                    Domain::Range(from, to) => (*from..*to).map(Term::Whole).collect(),
                    _ => self.domain(domain).into_iter().map(Term::Object).collect(),
                };
                let mut instances = Vec::new();
                for value in over {
                    let mut inner = vec![(variable.clone(), value)];
                    inner.extend_from_slice(bound);
                    instances.push(self.expand(body, &inner));
                }
                Term::Each(*quantity, instances)
            }
            other => other.clone(),
        }
    }

    fn named(&mut self, name: &str, bound: &[(String, Term)]) -> Term {
        if let Some((_, value)) = bound.iter().find(|(n, _)| n == name) {
            return value.clone();
        }
        if let Some((_, _, value)) = self.program.definitions.iter().find(|(_, n, _)| *n == name) {
            // One draw, however often the variable is used.
            let mut own = Expansion::new(self.program, self.scene, name);
            let value = own.expand(value, &[]);
            for draw in own.draws {
                if !self.draws.contains(&draw) {
                    self.draws.push(draw);
                }
            }
            return value;
        }
        if let Some(i) = self.scene.things.iter().position(|t| t.name == name) {
            return Term::Object(i);
        }
        if let Some(i) = self.scene.rooms.iter().position(|r| r.name == name) {
            return Term::Region(i);
        }
        match &self.scene.array {
            Some((array, elements)) if array == name => Term::Objects(elements.clone()),
            _ => Term::name(name),
        }
    }

    fn domain(&self, domain: &Domain) -> Vec<usize> {
        match domain {
            Domain::All => (0..self.scene.things.len()).collect(),
            Domain::Array(name) => {
                let (_, elements) = self.scene.array.as_ref().filter(|(n, _)| n == name).expect("the array");
                elements.clone()
            }
            Domain::Where(of, condition) => {
                self.domain(of).into_iter().filter(|i| self.passes(*i, condition)).collect()
            }
            Domain::Range(..) => unreachable!("a range holds no objects"),
        }
    }

    /// Whether an object passes a filter.
    fn passes(&self, i: usize, condition: &Term) -> bool {
        let text = |term: &Term| match term {
            Term::Property(None, "color") => self.scene.things[i].color,
            Term::Property(None, "category") => self.scene.things[i].category,
            Term::Text(text) => text,
            _ => unreachable!("filters read text"),
        };
        match condition {
            Term::Compare(Order::Eq, a, b) => text(a) == text(b),
            Term::Compare(Order::Ne, a, b) => text(a) != text(b),
            Term::Not(a) => !self.passes(i, a),
            Term::And(a, b) => self.passes(i, a) && self.passes(i, b),
            Term::Or(a, b) => self.passes(i, a) || self.passes(i, b),
            Term::Truth(p) => *p,
            _ => unreachable!("filters are static"),
        }
    }
}

/// An index, computed.
fn whole(term: &Term) -> Term {
    let value = |t: &Term| match whole(t) {
        Term::Whole(i) => i,
        _ => unreachable!("an index is whole"),
    };
    match term {
        Term::Number(x) => Term::Whole(*x as usize),
        Term::Arith(Sign::Plus, a, b) => Term::Whole(value(a) + value(b)),
        other => other.clone(),
    }
}

/// The conjuncts of a statement that stand at its top level: under `and` and `forall`, in no predicate of the user's.
pub fn conjuncts<'t>(term: &'t Term, out: &mut Vec<&'t Term>) {
    match term {
        Term::And(a, b) => {
            conjuncts(a, out);
            conjuncts(b, out);
        }
        Term::Each(Quantity::Forall, list) => list.iter().for_each(|t| conjuncts(t, out)),
        _ => out.push(term),
    }
}
