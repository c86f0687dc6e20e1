//! Random statements about a scene, of every kind that the language has; thresholds lie near what is measured.

use super::eval::{Value, World};
use super::program::{Expansion, Predicate, Program, Statement};
use super::scene::{Chosen, Scene};
use super::term::{Domain, Order, Quantity, Sign, Term};
use crate::dice::Dice;

/// Makes terms about a scene.
pub struct Speaker<'s> {
    pub dice: &'s mut Dice,
    pub scene: &'s Scene,
    pub program: Program,
    /// Names that stand for objects where a term is made.
    bound: Vec<String>,
}

const ORDERS: [Order; 6] = [Order::Eq, Order::Ne, Order::Lt, Order::Le, Order::Gt, Order::Ge];
const SIGNS: [Sign; 4] = [Sign::Plus, Sign::Minus, Sign::Times, Sign::Over];
const OFF: [f64; 13] = [0.0, 0.0, 0.0005, -0.0005, 0.001, -0.001, 0.0015, -0.0015, 0.05, -0.05, 0.5, -0.5, 3.0];

pub fn program(dice: &mut Dice, scene: &Scene) -> Program {
    let mut speaker = Speaker { dice, scene, program: Program::default(), bound: Vec::new() };
    speaker.definitions();
    for _ in 0..3 + speaker.dice.below(6) {
        let statement = speaker.statement();
        speaker.program.statements.push(statement);
    }
    speaker.pins();
    speaker.allowances();
    speaker.program
}

impl Speaker<'_> {
    fn definitions(&mut self) {
        if self.dice.chance(30) {
            let value = if self.dice.chance(50) { Term::Rand(0.5, 2.0) } else { self.number(2) };
            // A bare literal would be of no type.
            let value = Term::arith(Sign::Plus, value, Term::name("a").of("pos").component(0));
            self.program.definitions.push(("Number", "k", value));
        }
        if self.dice.chance(20) {
            let value = self.degree(1);
            self.program.definitions.push(("Degree", "tilt", value));
        }
        if self.dice.chance(40) {
            self.bound = vec!["x".to_owned(), "y".to_owned()];
            let inner = self.truth(2);
            let body = Term::or(inner, Term::compare(Order::Le, self.number(1), Term::name("far")));
            self.bound.clear();
            let parameters = vec![("Object", "x"), ("Object", "y"), ("Number", "far")];
            self.program.predicates.push(Predicate { name: "close", parameters, body });
        }
    }

    fn statement(&mut self) -> Statement {
        let term = match self.dice.below(12) {
            0 => self.top_level(),
            1..5 => self.truth(0),
            5..9 => self.truth(1),
            9 | 10 => self.truth(2),
            _ => self.truth(3),
        };
        if self.dice.chance(15) { Statement::Prefer(term, self.dice.one(&[1.0, 2.5])) } else { Statement::Assert(term) }
    }

    /// What lifts physical rules where it is asserted.
    fn top_level(&mut self) -> Term {
        let mounted = |dice: &mut Dice| dice.one(&["wallMounted", "ceilingMounted"]);
        let simple = match self.dice.below(4) {
            0 | 1 => Term::call("inside", self.two()),
            2 => match self.region() {
                Some(r) => Term::call(mounted(self.dice), [self.object(), r]),
                None => Term::call("inside", self.two()),
            },
            _ => match (self.region(), self.region()) {
                (Some(r), Some(s)) if r != s && self.dice.chance(50) => Term::call("connects", [self.object(), r, s]),
                (Some(r), _) => Term::call("connects", [self.object(), r]),
                _ => Term::call("inside", self.two()),
            },
        };
        match (self.dice.below(6), &self.scene.array) {
            (0, _) => Term::and(simple, self.truth(0)),
            (1, _) => Term::not(simple),
            (2, Some((array, _))) => {
                let body = Term::call("inside", [Term::name("x"), Term::name("a")]);
                Term::quantified(Quantity::Forall, "x", Domain::Array(array.clone()), body)
            }
            _ => simple,
        }
    }

    /// Assignments to what can be assigned.
    fn pins(&mut self) {
        for (i, thing) in self.scene.things.iter().enumerate() {
            if thing.name.contains('[') && !self.dice.chance(30) {
                continue;
            }
            let own = match &self.scene.array {
                Some((array, elements)) if elements.contains(&i) => {
                    Term::Element(array.clone(), Box::new(Term::Number((i - elements[0]) as f64)))
                }
                _ => Term::name(&thing.name),
            };
            let vector = |v: [f64; 3], name: &str| Term::call(name, v.map(Term::number));
            let near = |dice: &mut Dice, v: [f64; 3]| {
                let k = dice.below(3);
                let off = dice.one(&OFF);
                [0, 1, 2].map(|i| ((v[i] + if i == k { off } else { 0.0 }) * 1e4).round() / 1e4)
            };
            if self.dice.chance(12) {
                let value = vector(near(self.dice, thing.pos), "vec3");
                self.program.statements.push(Statement::Pin(own.clone().of("pos"), value));
            }
            if self.dice.chance(12) {
                let value = vector(near(self.dice, thing.rot), "rot");
                self.program.statements.push(Statement::Pin(own.clone().of("rot"), value));
            }
            if thing.dimensions.is_none() && self.dice.chance(12) {
                // A size of 0 or less is refused in the program already.
                let value = vector(near(self.dice, thing.scale).map(|side| side.abs().max(1e-4)), "vec3");
                self.program.statements.push(Statement::Pin(own.of("scale"), value));
            }
        }
    }

    fn allowances(&mut self) {
        let n = self.scene.things.len();
        for a in 0..n {
            if self.dice.chance(10) {
                self.program.outside.push(a);
            }
            if self.dice.chance(10) {
                self.program.float.push(a);
            }
        }
        if self.dice.chance(20) {
            let (a, b) = (self.dice.below(n), self.dice.below(n));
            if a != b {
                self.program.collide.push((a, b));
            }
        }
    }

    fn object(&mut self) -> Term {
        if !self.bound.is_empty() && self.dice.chance(60) {
            return Term::Name(self.dice.one(&self.bound));
        }
        let i = self.dice.below(self.scene.things.len());
        match &self.scene.array {
            Some((array, elements)) if elements.contains(&i) => {
                Term::Element(array.clone(), Box::new(Term::Number((i - elements[0]) as f64)))
            }
            _ => Term::name(&self.scene.things[i].name),
        }
    }

    /// Two that are not the same, as far as can be seen.
    fn two(&mut self) -> [Term; 2] {
        let a = self.object();
        for _ in 0..20 {
            let b = self.object();
            if a != b {
                return [a, b];
            }
        }
        [Term::name("a"), Term::name("b")]
    }

    fn region(&mut self) -> Option<Term> {
        (!self.scene.rooms.is_empty()).then(|| Term::name(&self.dice.one(&self.scene.rooms).name))
    }

    fn axis(&mut self) -> usize {
        self.dice.below(3)
    }

    fn literal(&mut self) -> Term {
        let x = self.dice.between(-3.0, 3.0);
        Term::number(x)
    }

    fn number(&mut self, depth: usize) -> Term {
        if depth == 0 || self.dice.chance(40) {
            return self.leaf();
        }
        let sign = self.dice.one(&SIGNS);
        match self.dice.below(12) {
            0..4 => Term::arith(sign, self.number(depth - 1), self.read(depth - 1)),
            4 => Term::arith(sign, self.number(depth - 1), self.literal()),
            5 => Term::Neg(Box::new(self.number(depth - 1))),
            6 => Term::call("abs", [self.number(depth - 1)]),
            7 => {
                let list = (0..2 + self.dice.below(2)).map(|_| self.number(depth - 1)).collect::<Vec<_>>();
                Term::call(self.dice.one(&["min", "max"]), list)
            }
            8 => Term::call("sqrt", [self.read(depth - 1)]),
            9 => Term::call(self.dice.one(&["sin", "cos"]), [self.degree(depth - 1)]),
            10 => Term::arith(Sign::Over, self.degree(depth - 1), self.degree(0)),
            _ => self.count(depth - 1),
        }
    }

    /// A number that is no constant: an error in one of those is the front end's business.
    fn read(&mut self, depth: usize) -> Term {
        let term = self.number(depth);
        if term.is_constant() { self.object().of("pos").component(0) } else { term }
    }

    fn leaf(&mut self) -> Term {
        let axis = self.axis();
        match self.dice.below(18) {
            0..4 => self.object().of("pos").component(axis),
            4 => self.vector(1).component(axis),
            5 => self.object().of(self.dice.one(&["top", "bottom", "surface"])),
            6 => Term::call("distance", [self.placed(), self.placed()]),
            7 => Term::call("length", [self.vector(1)]),
            8 => Term::call("dot", [self.vector(1), self.vector(0)]),
            9 | 10 => {
                let two = self.two();
                Term::call("gap", two)
            }
            11 | 12 => match self.region() {
                Some(r) => Term::call("gap", [self.object(), r]),
                None => self.literal(),
            },
            13 => match self.region() {
                Some(r) => Term::call("gap", [self.vector(1), r]),
                None => self.literal(),
            },
            14 => match self.region() {
                Some(r) => r.of(self.dice.one(&["floor", "ceiling", "area"])),
                None => self.literal(),
            },
            15 if !self.scene.chosen.is_empty() => Term::name("n"),
            16 if self.program.definitions.iter().any(|d| d.1 == "k") => Term::name("k"),
            17 if self.bound.is_empty() => {
                let lo = self.dice.between(0.0, 2.0);
                Term::Rand(lo, lo + 1.0)
            }
            _ => self.object().of(self.dice.one(&["scale", "size", "dimensions"])).component(axis),
        }
    }

    fn placed(&mut self) -> Term {
        match self.dice.below(4) {
            0 => self.vector(1),
            1 => self.region().unwrap_or_else(|| Term::name("a")),
            _ => self.object(),
        }
    }

    fn degree(&mut self, depth: usize) -> Term {
        if depth == 0 || self.dice.chance(50) {
            let axis = self.axis();
            return match self.dice.below(8) {
                0 if !self.scene.chosen.is_empty() => Term::name("turn"),
                1 if self.program.definitions.iter().any(|d| d.1 == "tilt") => Term::name("tilt"),
                2 => {
                    let two = [self.vector(1), self.vector(0)];
                    Term::call("angle", two)
                }
                3 => Term::call("angle", [self.rotation(), self.rotation()]),
                4 => self.rotation().component(axis),
                _ => self.object().of("rot").component(axis),
            };
        }
        match self.dice.below(6) {
            0 => Term::arith(Sign::Plus, self.degree(depth - 1), self.degree(depth - 1)),
            1 => Term::arith(Sign::Minus, self.degree(depth - 1), self.degree(depth - 1)),
            2 => Term::arith(Sign::Times, self.number(0), self.degree(depth - 1)),
            3 => Term::arith(Sign::Over, self.degree(depth - 1), Term::Number(2.0)),
            4 => Term::call(self.dice.one(&["min", "max"]), [self.degree(depth - 1), Term::Number(45.0)]),
            _ => Term::call("abs", [Term::Neg(Box::new(self.degree(depth - 1)))]),
        }
    }

    fn vector(&mut self, depth: usize) -> Term {
        if depth == 0 || self.dice.chance(50) {
            return match self.dice.below(8) {
                0 if !self.scene.chosen.is_empty() => Term::name("v"),
                1 => match self.region() {
                    Some(r) => r.of(self.dice.one(&["pos", "scale", "center"])),
                    None => self.object().of("center"),
                },
                2 => Term::call("vec3", [self.literal(), self.literal(), self.literal()]),
                _ => {
                    let list = ["pos", "center", "front", "right", "up", "min", "max", "size", "scale"];
                    self.object().of(self.dice.one(&list))
                }
            };
        }
        match self.dice.below(7) {
            0 => Term::arith(Sign::Plus, self.vector(depth - 1), self.vector(depth - 1)),
            1 => Term::arith(Sign::Minus, self.vector(depth - 1), self.vector(depth - 1)),
            2 => Term::arith(Sign::Times, self.vector(depth - 1), self.number(0)),
            3 => Term::arith(Sign::Times, self.number(0), self.vector(depth - 1)),
            4 => Term::arith(Sign::Over, self.vector(depth - 1), self.read(0)),
            5 => Term::call("cross", [self.vector(depth - 1), self.vector(depth - 1)]),
            _ => Term::call("normalize", [self.vector(depth - 1)]),
        }
    }

    fn rotation(&mut self) -> Term {
        match self.dice.below(5) {
            0 if !self.scene.chosen.is_empty() => Term::name("r"),
            1 => Term::call("rot", [self.literal(), self.literal(), self.literal()]),
            2 => Term::call("rot", [Term::Number(0.0), self.degree(0), Term::Number(0.0)]),
            _ => self.object().of("rot"),
        }
    }

    /// A domain of objects.
    fn domain(&mut self) -> Domain {
        let whole = match &self.scene.array {
            Some((array, _)) if self.dice.chance(40) => Domain::Array(array.clone()),
            _ => Domain::All,
        };
        if !self.dice.chance(35) {
            return whole;
        }
        let test = |dice: &mut Dice| {
            let (property, text) = if dice.chance(50) {
                ("color", dice.one(&["red", "blue", ""]))
            } else {
                ("category", dice.one(&["chair", "table", "sofa"]))
            };
            let order = dice.one(&[Order::Eq, Order::Eq, Order::Ne]);
            Term::compare(order, Term::Property(None, property), Term::Text(text))
        };
        let condition = match self.dice.below(5) {
            0 => Term::and(test(self.dice), test(self.dice)),
            1 => Term::or(test(self.dice), test(self.dice)),
            2 => Term::not(test(self.dice)),
            _ => test(self.dice),
        };
        Domain::Where(Box::new(whole), Box::new(condition))
    }

    fn quantified(&mut self, quantity: Quantity, depth: usize) -> Term {
        if let Some((array, elements)) = self.scene.array.clone().filter(|_| self.dice.chance(20)) {
            let last = elements.len() - 1;
            let (i, next) = (Term::name("i"), Term::arith(Sign::Plus, Term::name("i"), Term::Number(1.0)));
            let pair = [Term::Element(array.clone(), Box::new(i)), Term::Element(array, Box::new(next))];
            let [a, b] = pair;
            let body = match self.dice.below(3) {
                0 => Term::compare(Order::Lt, a.of("pos").component(0), b.of("pos").component(0)),
                1 => Term::call("beside", [a, b]),
                _ => Term::compare(Order::Ge, Term::call("gap", [a, b]), Term::Number(0.1)),
            };
            return Term::quantified(quantity, "i", Domain::Range(0, last), body);
        }
        let variable = ["o", "q", "s"][self.bound.len().min(2)].to_owned();
        if self.bound.contains(&variable) {
            return self.truth(0);
        }
        let domain = self.domain();
        self.bound.push(variable.clone());
        let mut body = self.truth(depth.min(1));
        if self.dice.chance(25) {
            // Two that differ: then normalize of the way between is safe.
            let other = Term::name(&self.dice.one(&self.scene.things).name);
            if !matches!(&other, Term::Name(n) if n.contains('[')) {
                body = Term::implies(Term::compare(Order::Ne, Term::name(&variable), other), body);
            }
        }
        self.bound.pop();
        Term::quantified(quantity, &variable, domain, body)
    }

    fn count(&mut self, depth: usize) -> Term {
        match self.quantified(Quantity::Count, depth) {
            counted @ Term::Quantified(Quantity::Count, ..) => counted,
            _ => Term::Number(1.0),
        }
    }

    /// A comparison with a number near the value, where it can be known.
    fn near(&mut self, term: Term, degrees: bool) -> Term {
        let mut order = self.dice.one(&ORDERS);
        let known = self.bound.is_empty().then(|| self.measured(&term)).flatten();
        let x = match known {
            Some(x) if x.abs() < 1e5 => {
                let off = self.dice.one(&OFF) * if degrees { 100.0 } else { 1.0 };
                let around = if degrees && self.dice.chance(20) { 360.0 } else { 0.0 };
                ((x + off) * 1e4).round() / 1e4 + around
            }
            _ => self.dice.between(-1.0, 3.0) * if degrees { 60.0 } else { 1.0 },
        };
        let (mut a, mut b) = (term, Term::number(x));
        if self.dice.chance(20) {
            (a, b) = (b, a);
        }
        if matches!((&a, &b), (Term::Number(_) | Term::Neg(_), Term::Number(_) | Term::Neg(_))) {
            order = Order::Le;
        }
        Term::compare(order, a, b)
    }

    fn measured(&self, term: &Term) -> Option<f64> {
        let mut expansion = Expansion::new(&self.program, self.scene, "assert[0]");
        let term = expansion.expand(term, &[]);
        if !expansion.draws.is_empty() {
            return None;
        }
        match World::new(self.scene).value(&term) {
            Ok(Value::Num(n)) => Some(n.x),
            _ => None,
        }
    }

    pub fn truth(&mut self, depth: usize) -> Term {
        if depth == 0 {
            return self.atom();
        }
        match self.dice.below(12) {
            0 | 1 => Term::and(self.truth(depth - 1), self.truth(depth - 1)),
            2 | 3 => Term::or(self.truth(depth - 1), self.truth(depth - 1)),
            4 => Term::implies(self.truth(depth - 1), self.truth(depth - 1)),
            5 => Term::not(self.truth(depth - 1)),
            6 => self.quantified(Quantity::Forall, depth - 1),
            7 => self.quantified(Quantity::Exists, depth - 1),
            8 => {
                let n = self.dice.below(self.scene.things.len() + 1) as f64;
                let (count, order) = (self.count(depth - 1), self.dice.one(&ORDERS));
                if self.dice.chance(20) {
                    Term::compare(order, Term::Number(n), count)
                } else {
                    Term::compare(order, count, Term::Number(n))
                }
            }
            9 => {
                let order = self.dice.one(&[Order::Eq, Order::Ne]);
                Term::compare(order, self.truth(depth - 1), self.truth(depth - 1))
            }
            _ => self.atom(),
        }
    }

    fn atom(&mut self) -> Term {
        let equal = self.dice.one(&[Order::Eq, Order::Ne]);
        match self.dice.below(24) {
            0..6 => {
                let number = self.number(2);
                self.near(number, false)
            }
            6 | 7 => {
                let degree = self.degree(1);
                self.near(degree, true)
            }
            8 => {
                let order = self.dice.one(&ORDERS);
                Term::compare(order, self.number(1), self.number(1))
            }
            9 => {
                let order = self.dice.one(&ORDERS);
                Term::compare(order, self.degree(1), self.degree(1))
            }
            10 => Term::compare(equal, self.vector(1), self.vector(1)),
            11 => Term::compare(equal, self.rotation(), self.rotation()),
            12 => Term::compare(equal, self.object().of("color"), self.text()),
            13 => Term::compare(equal, self.object(), self.object()),
            14 if self.scene.chosen.iter().any(|(_, c)| matches!(c, Chosen::Bool(_))) => Term::name("p"),
            15 if !self.program.predicates.is_empty() && self.bound.is_empty() => {
                let [a, b] = self.two();
                let far = if self.dice.chance(20) { Term::Rand(0.5, 2.0) } else { self.number(0) };
                Term::call("close", [a, b, far])
            }
            16 | 17 => match self.region() {
                Some(r) => {
                    let list = [
                        "inside",
                        "inside",
                        "onFloor",
                        "againstWall",
                        "inCorner",
                        "centeredIn",
                        "wallMounted",
                        "ceilingMounted",
                    ];
                    Term::call(self.dice.one(&list), [self.object(), r])
                }
                None => Term::Truth(self.dice.chance(50)),
            },
            18 => {
                let two = self.two();
                Term::call(self.dice.one(&["inside", "collides", "visible"]), two)
            }
            19 => match self.region() {
                Some(r) => Term::call("connects", [self.object(), r]),
                None => Term::Truth(self.dice.chance(50)),
            },
            20 => {
                let side = Term::name(self.dice.one(&["front", "behind", "left", "right", "above"]));
                let depth = Term::Number(self.dice.between(0.1, 2.0));
                Term::call("clear", [self.object(), side, depth])
            }
            21 => match self.dice.below(3) {
                0 => {
                    let [a, b] = self.two();
                    Term::call(self.dice.one(&["near", "far"]), [a, b, Term::Number(self.dice.between(0.0, 2.0))])
                }
                1 => Term::call("between", [self.object(), self.object(), self.object()]),
                _ => {
                    // Itself among them would be a gap to itself.
                    let set = match &self.scene.array {
                        Some((array, _)) => Term::Set(Domain::Array(array.clone())),
                        None => Term::name("a"),
                    };
                    let around = Term::name("b");
                    Term::call("around", [set, around, Term::Number(self.dice.between(0.0, 3.0))])
                }
            },
            _ => {
                let list = [
                    "leftOf",
                    "rightOf",
                    "inFrontOf",
                    "behind",
                    "above",
                    "below",
                    "within",
                    "under",
                    "facing",
                    "aligned",
                    "parallel",
                    "beside",
                    "on",
                    "over",
                    "restsOn",
                    "looksAt",
                    "seenLeftOf",
                    "seenRightOf",
                ];
                let two = self.two();
                Term::call(self.dice.one(&list), two)
            }
        }
    }

    fn text(&mut self) -> Term {
        if self.dice.chance(50) { Term::Text(self.dice.one(&["red", "blue", ""])) } else { self.object().of("color") }
    }
}
