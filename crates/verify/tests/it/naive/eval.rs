//! What a formula comes to, by the text of the language.

use super::library;
use super::scene::{Chosen, Scene};
use super::solid::Solid;
use super::space::{self, V, cross, distance, dot, euler, length, sub, times};
use super::term::{Order, Quantity, Sign, Term};
use super::value::{Kind, NOISE, Num, Truth, Vector, at_least, compare, same_rotations, same_vectors};

#[derive(Clone, Debug)]
pub enum Value {
    Num(Num),
    Vector(Vector),
    /// An Euler triple.
    Rotation(V),
    Text(&'static str),
    Object(usize),
    Region(usize),
    Objects(Vec<usize>),
    Truth(Truth),
}

/// Why there is no value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Trouble {
    /// Division by zero and the like.
    Error,
    /// Too near to an error to say.
    Unsure,
}

pub type Outcome<T> = Result<T, Trouble>;

/// Everything that formulas are judged in.
pub struct World<'s> {
    pub scene: &'s Scene,
    pub solids: Vec<Vec<Solid>>,
    pub boxes: Vec<Solid>,
    /// Those that a top-level `connects` speaks of.
    pub doors: Vec<usize>,
}

impl<'s> World<'s> {
    pub fn new(scene: &'s Scene) -> Self {
        let solids = scene.things.iter().map(super::scene::Thing::solids).collect();
        let boxes = scene.things.iter().map(super::scene::Thing::cuboid).collect();
        Self { scene, solids, boxes, doors: Vec::new() }
    }

    pub fn value(&self, term: &Term) -> Outcome<Value> {
        Ok(match term {
            Term::Number(x) => Value::Num(Num { x: *x, kind: Kind::Literal, noise: 0.0 }),
            Term::Text(text) => Value::Text(text),
            Term::Object(i) => Value::Object(*i),
            Term::Region(i) => Value::Region(*i),
            Term::Objects(list) => Value::Objects(list.clone()),
            Term::Whole(i) => Value::Num(Num { x: *i as f64, kind: Kind::Literal, noise: 0.0 }),
            Term::Draw(key) => {
                let (_, x) = self.scene.draws.iter().find(|(k, _)| k == key).expect("drawn before");
                Value::Num(Num { kind: Kind::Literal, ..Num::plain(*x) })
            }
            Term::Name(name) => {
                let (_, chosen) = self.scene.chosen.iter().find(|(n, _)| n == name).expect("declared");
                match *chosen {
                    Chosen::Number(x) => Value::Num(Num::plain(x)),
                    Chosen::Degree(x) => Value::Num(Num::degree(x)),
                    Chosen::Bool(p) => Value::Truth(Truth::discrete(p)),
                    Chosen::Vector(v) => Value::Vector(Vector::new(v)),
                    Chosen::Rotation(v) => Value::Rotation(v),
                }
            }
            Term::Property(Some(of), property) => self.property(&self.value(of)?, property),
            Term::Component(of, axis) => match self.value(of)? {
                Value::Vector(v) => Value::Num(Num { x: v.v[*axis], kind: Kind::Plain, noise: v.noise }),
                Value::Rotation(r) => Value::Num(Num::degree(r[*axis].rem_euclid(360.0))),
                other => panic!("no component of {other:?}"),
            },
            Term::Neg(a) => match self.value(a)? {
                Value::Num(a) => Value::Num(Num { x: -a.x, ..a }),
                Value::Vector(a) => Value::Vector(Vector { v: times(a.v, -1.0), ..a }),
                other => panic!("minus {other:?}"),
            },
            Term::Arith(sign, a, b) => arithmetic(*sign, &self.value(a)?, &self.value(b)?)?,
            Term::Each(Quantity::Count, list) => {
                let truths = self.truths(list)?;
                let holding = truths.iter().filter(|t| t.holds == Some(true)).count() as f64;
                let noise = if truths.iter().any(|t| t.holds.is_none()) { f64::INFINITY } else { 0.0 };
                Value::Num(Num { x: holding, kind: Kind::Plain, noise })
            }
            Term::Call(name, arguments) => self.call(name, arguments)?,
            _ => Value::Truth(self.truth(term)?),
        })
    }

    pub fn truths(&self, list: &[Term]) -> Outcome<Vec<Truth>> {
        list.iter().map(|t| self.truth(t)).collect()
    }

    pub fn truth(&self, term: &Term) -> Outcome<Truth> {
        Ok(match term {
            Term::Truth(p) => Truth::discrete(*p),
            Term::Not(a) => self.truth(a)?.not(),
            Term::And(a, b) => self.both(self.truth(a)?, b)?,
            Term::Or(a, b) => self.either(self.truth(a)?, b)?,
            Term::Implies(a, b) => self.either(self.truth(a)?.not(), b)?,
            Term::Inner(a) => self.truth(a)?,
            Term::Each(Quantity::Forall, list) => {
                list.iter().try_fold(Truth::discrete(true), |all, next| self.both(all, next))?
            }
            Term::Each(Quantity::Exists, list) => {
                list.iter().try_fold(Truth::discrete(false), |one, next| self.either(one, next))?
            }
            Term::Compare(order, a, b) => self.comparison(*order, a, b)?,
            _ => match self.value(term)? {
                Value::Truth(truth) => truth,
                other => panic!("no truth: {other:?}"),
            },
        })
    }

    /// The right side is skipped where a discrete left side decides.
    fn both(&self, left: Truth, right: &Term) -> Outcome<Truth> {
        if left.is_discrete() && left.holds == Some(false) {
            return Ok(left);
        }
        Ok(left.and(self.beside(left, right)?))
    }
    fn either(&self, left: Truth, right: &Term) -> Outcome<Truth> {
        if left.is_discrete() && left.holds == Some(true) {
            return Ok(left);
        }
        Ok(left.or(self.beside(left, right)?))
    }
    /// Where the left side's margin is open, it may be infinite, and then an error on the right is skipped.
    fn beside(&self, left: Truth, right: &Term) -> Outcome<Truth> {
        let open = |trouble| if left.noise.is_infinite() { Trouble::Unsure } else { trouble };
        self.truth(right).map_err(open)
    }

    fn comparison(&self, order: Order, a: &Term, b: &Term) -> Outcome<Truth> {
        match (a, b) {
            (Term::Each(Quantity::Count, list), Term::Number(n)) if n.fract() == 0.0 => {
                return self.counted(order, list, *n as usize);
            }
            (Term::Number(n), Term::Each(Quantity::Count, list)) if n.fract() == 0.0 => {
                let turned = match order {
                    Order::Lt => Order::Gt,
                    Order::Le => Order::Ge,
                    Order::Gt => Order::Lt,
                    Order::Ge => Order::Le,
                    same => same,
                };
                return self.counted(turned, list, *n as usize);
            }
            _ => {}
        }
        let counted = |t: &Term| matches!(t, Term::Each(Quantity::Count, _));
        // The text gives the margin of a count against a whole number alone.
        let rough = counted(a) || counted(b);
        let equal = match (self.value(a)?, self.value(b)?) {
            (Value::Num(a), Value::Num(b)) if rough => return Ok(compare(order, a, b).rough()),
            (Value::Num(a), Value::Num(b)) => return Ok(compare(order, a, b)),
            (Value::Vector(a), Value::Vector(b)) => same_vectors(a, b),
            (Value::Rotation(a), Value::Rotation(b)) => same_rotations(a, b),
            (Value::Text(a), Value::Text(b)) => Truth::discrete(a == b),
            (Value::Object(a), Value::Object(b)) => Truth::discrete(a == b),
            (Value::Truth(a), Value::Truth(b)) => a.iff(b),
            (a, b) => panic!("{a:?} and {b:?} do not compare"),
        };
        Ok(if order == Order::Ne { equal.not() } else { equal })
    }

    fn counted(&self, order: Order, list: &[Term], n: usize) -> Outcome<Truth> {
        let truths = self.truths(list)?;
        Ok(match order {
            Order::Ge => at_least(n, &truths),
            Order::Gt => at_least(n + 1, &truths),
            Order::Lt => at_least(n, &truths).not(),
            Order::Le => at_least(n + 1, &truths).not(),
            Order::Eq => at_least(n, &truths).and(at_least(n + 1, &truths).not()),
            Order::Ne => at_least(n, &truths).and(at_least(n + 1, &truths).not()).not(),
        })
    }

    fn property(&self, of: &Value, property: &str) -> Value {
        let vector = |v: V| Value::Vector(Vector::new(v));
        let number = |x: f64| Value::Num(Num::plain(x));
        match of {
            Value::Object(i) => {
                let thing = &self.scene.things[*i];
                match property {
                    "pos" => vector(thing.pos),
                    "rot" => Value::Rotation(thing.rot),
                    "scale" | "size" => vector(thing.scale),
                    "dimensions" => vector(thing.dimensions.unwrap_or(thing.scale)),
                    "center" => vector(thing.center()),
                    "right" => vector(thing.axis(0)),
                    "up" => vector(thing.axis(1)),
                    "front" => vector(thing.axis(2)),
                    "min" => vector(thing.span().0),
                    "max" => vector(thing.span().1),
                    "bottom" => number(thing.span().0[1]),
                    "top" => number(thing.span().1[1]),
                    // Only things that stand upright are given one.
                    "surface" => match thing.surface.filter(|_| thing.has_parts()) {
                        Some(height) => number(thing.pos[1] + height),
                        None => number(thing.span().1[1]),
                    },
                    "color" => Value::Text(thing.color),
                    "category" => Value::Text(thing.category),
                    _ => panic!("no property {property}"),
                }
            }
            Value::Region(i) => {
                let room = &self.scene.rooms[*i];
                match property {
                    "pos" => vector(room.pos),
                    "rot" => Value::Rotation([0.0, room.yaw, 0.0]),
                    "scale" => vector(room.scale),
                    "floor" => number(room.floor()),
                    "ceiling" => number(room.ceiling()),
                    "area" => number(super::flat::area(&room.polygon())),
                    "center" => vector(room.center()),
                    _ => panic!("no property {property}"),
                }
            }
            other => panic!("no property {property} of {other:?}"),
        }
    }

    /// The point that `distance` measures from.
    fn place(&self, value: &Value) -> Vector {
        match value {
            Value::Object(i) => Vector::new(self.scene.things[*i].center()),
            Value::Region(i) => Vector::new(self.scene.rooms[*i].center()),
            Value::Vector(v) => *v,
            other => panic!("{other:?} is nowhere"),
        }
    }

    fn call(&self, name: &str, arguments: &[Term]) -> Outcome<Value> {
        let values =
            arguments.iter().filter(|_| name != "clear").map(|a| self.value(a)).collect::<Outcome<Vec<_>>>()?;
        let numbers: Vec<Num> =
            values.iter().filter_map(|v| if let Value::Num(n) = v { Some(*n) } else { None }).collect();
        let vectors: Vec<Vector> =
            values.iter().filter_map(|v| if let Value::Vector(v) = v { Some(*v) } else { None }).collect();
        let number =
            |x: f64, noise: f64| Value::Num(Num { x, kind: Kind::Plain, noise: noise + NOISE * (1.0 + x.abs()) });
        Ok(match name {
            "vec3" => Value::Vector(Vector {
                v: [numbers[0].x, numbers[1].x, numbers[2].x],
                noise: numbers.iter().map(|n| n.noise).sum(),
            }),
            "rot" => Value::Rotation([numbers[0].x, numbers[1].x, numbers[2].x]),
            "abs" => Value::Num(Num { x: numbers[0].x.abs(), ..numbers[0] }),
            "min" | "max" => {
                let pick = if name == "min" { f64::min } else { f64::max };
                let x = numbers.iter().map(|n| n.x).reduce(pick).expect("two or more");
                let noise = numbers.iter().map(|n| n.noise).fold(0.0, f64::max);
                let typed = numbers.iter().map(|n| n.kind).find(|k| *k != Kind::Literal);
                Value::Num(Num { x, kind: typed.unwrap_or(Kind::Literal), noise })
            }
            "sqrt" => {
                let Num { x, noise, .. } = numbers[0];
                if x.abs() <= noise {
                    return Err(Trouble::Unsure);
                }
                if x < 0.0 {
                    return Err(Trouble::Error);
                }
                number(x.sqrt(), noise / x.sqrt())
            }
            "sin" => number(numbers[0].x.to_radians().sin(), numbers[0].noise),
            "cos" => number(numbers[0].x.to_radians().cos(), numbers[0].noise),
            "length" => number(length(vectors[0].v), vectors[0].noise),
            "normalize" => {
                let (size, noise) = (sized(vectors[0])?, vectors[0].noise);
                Value::Vector(Vector { v: times(vectors[0].v, 1.0 / size), noise: noise / size + NOISE })
            }
            "dot" => number(dot(vectors[0].v, vectors[1].v), product_noise(vectors[0], vectors[1])),
            "cross" => {
                let noise = product_noise(vectors[0], vectors[1]);
                Value::Vector(Vector { v: cross(vectors[0].v, vectors[1].v), noise: noise + NOISE })
            }
            "angle" => match (&values[0], &values[1]) {
                (Value::Rotation(a), Value::Rotation(b)) => {
                    Value::Num(Num { noise: 1e-5, ..Num::degree(space::turn_between(&euler(*a), &euler(*b))) })
                }
                _ => {
                    let noise = vectors[0].noise / sized(vectors[0])? + vectors[1].noise / sized(vectors[1])?;
                    let x = space::angle(vectors[0].v, vectors[1].v);
                    // Where the cosine is flat, little remains of the angle.
                    let noise = noise * 60.0 + if !(0.01..179.99).contains(&x) { 1e-4 } else { 1e-8 };
                    Value::Num(Num { noise, ..Num::degree(x) })
                }
            },
            "distance" => {
                let (a, b) = (self.place(&values[0]), self.place(&values[1]));
                number(distance(a.v, b.v), a.noise + b.noise)
            }
            "gap" => Value::Num(self.gap(&values[0], &values[1])),
            "clear" => self.clear(arguments)?,
            _ => Value::Truth(library::predicate(self, name, &values)),
        })
    }
}

fn product_noise(a: Vector, b: Vector) -> f64 {
    a.noise * (1.0 + length(b.v)) + b.noise * (1.0 + length(a.v))
}

/// The length of what must not be the zero vector.
fn sized(v: Vector) -> Outcome<f64> {
    let size = length(v.v);
    if size == 0.0 && v.noise <= 1e-9 {
        return Err(Trouble::Error);
    }
    if size <= v.noise * 1e4 { Err(Trouble::Unsure) } else { Ok(size) }
}

fn arithmetic(sign: Sign, a: &Value, b: &Value) -> Outcome<Value> {
    let divisor = |n: &Num| {
        if n.x == 0.0 && n.noise <= 1e-9 {
            return Err(Trouble::Error);
        }
        if n.x.abs() <= n.noise * 1e3 { Err(Trouble::Unsure) } else { Ok(()) }
    };
    Ok(match (sign, a, b) {
        (Sign::Plus | Sign::Minus, Value::Vector(a), Value::Vector(b)) => {
            let v = if sign == Sign::Plus { space::add(a.v, b.v) } else { sub(a.v, b.v) };
            Value::Vector(Vector { v, noise: a.noise + b.noise })
        }
        (Sign::Times, Value::Vector(v), Value::Num(k)) | (Sign::Times, Value::Num(k), Value::Vector(v)) => {
            let noise = v.noise * (1.0 + k.x.abs()) + k.noise * (1.0 + length(v.v));
            Value::Vector(Vector { v: times(v.v, k.x), noise })
        }
        (Sign::Over, Value::Vector(v), Value::Num(k)) => {
            divisor(k)?;
            let noise = v.noise / k.x.abs() + k.noise * length(v.v) / k.x / k.x;
            Value::Vector(Vector { v: [0, 1, 2].map(|i| v.v[i] / k.x), noise })
        }
        (_, Value::Num(a), Value::Num(b)) => {
            let (x, noise) = match sign {
                Sign::Plus => (a.x + b.x, a.noise + b.noise),
                Sign::Minus => (a.x - b.x, a.noise + b.noise),
                Sign::Times => (a.x * b.x, a.noise * (1.0 + b.x.abs()) + b.noise * (1.0 + a.x.abs())),
                Sign::Over => {
                    divisor(b)?;
                    (a.x / b.x, a.noise / b.x.abs() + b.noise * (a.x / b.x / b.x).abs())
                }
            };
            let kind = match (sign, a.kind, b.kind) {
                (_, Kind::Literal, Kind::Literal) => Kind::Literal,
                (Sign::Over, Kind::Degree, Kind::Degree) => Kind::Plain,
                (_, Kind::Degree, _) | (_, _, Kind::Degree) => Kind::Degree,
                _ => Kind::Plain,
            };
            Value::Num(Num { x, kind, noise: noise + 1e-15 * x.abs() })
        }
        (sign, a, b) => panic!("{a:?} {sign:?} {b:?}"),
    })
}
