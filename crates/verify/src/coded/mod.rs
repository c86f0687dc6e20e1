//! Formulas as straight-line code, for who judges the same ones a million times: a search.
//!
//! The code is what the evaluator does: it runs once over numbers that note what is done with them (the tape of
//! `prove`), with the poses of upright objects as unknowns and all else as it is in the instance. So a formula keeps
//! its one meaning; only rounding may differ in the last digits. What is no arithmetic is measured on boxes in the
//! middle of it; what takes more geometry than boxes and rooms has no code.

mod measured;

use measured::Measured;
pub use measured::{Block, Flat, blocks, gap, leaning};

use crate::builtins::Call;
use crate::eval::{Cause, EvalError, Oracle, Scratch, Truth, Value, Values, chosen, outline};
use crate::number::Algebra;
use crate::prove::interval::Interval;
use crate::prove::tape::{Claim, Fact, Op, Tape, Term, unknown};
use crate::vector::{M3, V3};
use crate::world::{ObjectInstance, RegionInstance, World};
use rustc_hash::FxHashMap;
use scenelang_lang::Program;
use scenelang_lang::program::{Formula, Node, NodeId, ObjectId, ObjectProperty, RegionId, Unit};
use scenelang_layout::rotation::sin_cos;
use scenelang_layout::{Polygon, Vec3};
use std::sync::Arc;

/// Numbers per object: x, y, z of its position, its yaw (degrees in [0, 360)), the sine and the cosine of that. A decision
/// variable has as many, of which it uses one or three.
pub const INPUTS: usize = 6;
/// At most so many intermediate results.
const TEMPORARIES: usize = 1024;
/// No coordinate is greater (metres).
const FAR: f64 = 1e7;

/// What code works on: the inputs of all objects and decision variables, intermediate results, constants.
#[derive(Clone, Debug, Default)]
pub struct Slots(Vec<f64>);

impl Slots {
    /// Says where an object is and how it is turned.
    pub fn set(&mut self, id: ObjectId, pos: &Vec3, yaw: f64) {
        let (sin, cos) = sin_cos(yaw);
        self.put(id, [pos.x, pos.y, pos.z, yaw, sin, cos]);
    }
    /// The inputs of an object, all at once: who goes back and forth saves the sine.
    pub fn put(&mut self, id: ObjectId, inputs: [f64; INPUTS]) {
        let at = id.0 as usize * INPUTS;
        self.0[at..at + INPUTS].copy_from_slice(&inputs);
    }
    /// The inputs of an object.
    pub fn get(&self, id: ObjectId) -> [f64; INPUTS] {
        std::array::from_fn(|i| self.0[id.0 as usize * INPUTS + i])
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Do {
    Add,
    Sub,
    Mul,
    Div,
    Sqrt,
    Abs,
    Min,
    Max,
    Sin,
    Cos,
    Atan,
    Wrap,
    /// What is measured, by its index.
    Measure,
}

#[derive(Clone, Copy, Debug)]
struct Step {
    what: Do,
    a: u32,
    b: u32,
}

#[derive(Clone, Copy, Debug)]
enum AtomVerdict {
    Known(bool),
    Bound { slot: u32, bound: f64, strict: bool, contrary: bool },
}

#[derive(Clone, Copy, Debug)]
struct Atom {
    margin: u32,
    verdict: AtomVerdict,
    unit: Unit,
}

/// Steps, one result after the other.
#[derive(Clone, Debug, Default)]
struct Code {
    steps: Vec<Step>,
    /// What is measured, each with the slots of what it asks for.
    measured: Vec<(Measured, Vec<u32>)>,
    /// Where the first result goes.
    first: usize,
}

/// The code of a formula whose root is a truth.
#[derive(Clone, Debug, Default)]
pub struct Coded {
    code: Code,
    /// By node: those truths that are not made of others.
    atoms: Vec<Option<Atom>>,
}

/// The code of a formula whose root is a number, a vector or a rotation.
#[derive(Clone, Debug)]
pub struct CodedValue {
    code: Code,
    parts: Vec<u32>,
}

impl Code {
    fn run(&self, slots: &mut Slots) {
        let slots = &mut slots.0[..];
        for (at, step) in (self.first..).zip(&self.steps) {
            if let Do::Measure = step.what {
                let (what, inputs) = &self.measured[step.a as usize];
                slots[at] = what.of(|i| slots[inputs[i] as usize]);
                continue;
            }
            let a = slots[step.a as usize];
            let b = slots[step.b as usize];
            slots[at] = match step.what {
                Do::Add => a + b,
                Do::Sub => a - b,
                Do::Mul => a * b,
                Do::Div => a / b,
                Do::Sqrt => a.sqrt(),
                Do::Abs => a.abs(),
                Do::Min => Algebra::min(a, b),
                Do::Max => Algebra::max(a, b),
                Do::Sin => sin_cos(a).0,
                Do::Cos => sin_cos(a).1,
                Do::Atan => Algebra::atan2(a, b),
                Do::Wrap => Algebra::wrap(a),
                Do::Measure => slots[at],
            };
        }
    }

    /// Slots that it reads.
    fn reads(&self) -> impl Iterator<Item = u32> + '_ {
        let plain = self.steps.iter().filter(|s| !matches!(s.what, Do::Measure)).flat_map(|s| [s.a, s.b]);
        plain.chain(self.measured.iter().flat_map(|(_, inputs)| inputs.iter().copied()))
    }
}

impl Coded {
    /// Runs it; [`Self::truth`] tells what came of it, until other code runs.
    pub fn run(&self, slots: &mut Slots) {
        self.code.run(slots);
    }
    /// How many steps it takes. A gap takes more the more parts there are.
    pub fn steps(&self) -> usize {
        self.code.steps.len() + self.code.measured.iter().map(|(what, _)| what.steps()).sum::<usize>()
    }
    /// A truth that is not made of others, as of the last run.
    pub fn truth(&self, node: NodeId, slots: &Slots) -> Option<Truth<f64>> {
        let atom = (*self.atoms.get(node.0 as usize)?)?;
        let holds = match atom.verdict {
            AtomVerdict::Known(holds) => holds,
            AtomVerdict::Bound { slot, bound, strict, contrary } => {
                let value = slots.0[slot as usize];
                (if strict { value > bound } else { value >= bound }) != contrary
            }
        };
        Some(Truth { margin: slots.0[atom.margin as usize], holds, unit: atom.unit })
    }
}

impl CodedValue {
    /// Which inputs it reads: whose, and an index into [`Slots::get`]. Decision variables follow the objects in number.
    pub fn reads(&self) -> impl Iterator<Item = (ObjectId, usize)> + '_ {
        let slots = self.code.reads().chain(self.parts.iter().copied());
        let inputs = slots.map(|s| s as usize).filter(|s| *s < self.code.first);
        inputs.map(|s| (ObjectId((s / INPUTS) as u32), s % INPUTS))
    }
    /// Runs it: one number, or three.
    pub fn run(&self, slots: &mut Slots) -> [f64; 3] {
        self.code.run(slots);
        std::array::from_fn(|i| self.parts.get(i).map_or(0.0, |p| slots.0[*p as usize]))
    }
}

/// Writes code for formulas of one program in one instance.
pub struct Coder<'w> {
    plain: &'w World<f64>,
    tape: Tape,
    world: World<Term>,
    /// How many objects and decision variables there are.
    sources: usize,
    /// By the number of an unknown: its slot.
    constants: Vec<f64>,
    known: FxHashMap<u64, u32>,
    /// By the unknown that stands for it: what is measured, and on what.
    measures: FxHashMap<Term, (Measured, Vec<Term>)>,
    scratch: Scratch<Term>,
}

impl<'w> Coder<'w> {
    /// For an instance in which some objects never move, and of the others some stay upright; what speaks of the rest has
    /// no code.
    pub fn new(
        program: &Program,
        plain: &'w World<f64>,
        still: &dyn Fn(ObjectId) -> bool,
        upright: &dyn Fn(ObjectId) -> bool,
    ) -> Self {
        let mut tape = Tape::new();
        Self {
            plain,
            world: tape.record(|| inputs(program, plain, still, upright)),
            tape,
            sources: program.objects.len() + program.variables.len(),
            constants: Vec::new(),
            known: FxHashMap::default(),
            measures: FxHashMap::default(),
            scratch: Scratch::new(),
        }
    }

    /// The code of a truth; `None`: not all of it has code.
    pub fn truth(&mut self, formula: &Formula) -> Option<Coded> {
        let (code, missing) = self.partly(formula);
        missing.is_empty().then_some(code)
    }

    /// The code of as many truths that a truth is made of as have code, and the others. Those are truths that are not
    /// themselves made of others.
    pub fn partly(&mut self, formula: &Formula) -> (Coded, Vec<NodeId>) {
        let _ = self.evaluate(formula);
        let (mut found, mut missing) = (Vec::new(), Vec::new());
        for id in atoms(formula) {
            match self.scratch.value(id) {
                Ok(Value::Truth(truth)) => found.push((id, truth)),
                _ => missing.push(id),
            }
        }
        let mut code = Draft::new(self.sources);
        let mut atoms = vec![None; formula.nodes.len()];
        for (node, truth) in found {
            atoms[node.0 as usize] = self.atom(&mut code, truth);
            if atoms[node.0 as usize].is_none() {
                missing.push(node);
            }
        }
        (Coded { code: code.code, atoms }, missing)
    }

    fn evaluate(&mut self, formula: &Formula) -> Result<Value<Term>, EvalError> {
        let Self { plain, tape, world, measures, scratch, .. } = self;
        tape.record(|| scratch.evaluate_with(formula, world, &mut Boxes { plain, measures }))
    }

    fn atom(&mut self, code: &mut Draft, truth: Truth<Term>) -> Option<Atom> {
        let margin = self.emit(code, truth.margin)?;
        let contrary = truth.holds.is_contrary();
        let fact = self.tape.facts[truth.holds.index()].clone();
        let verdict = match fact {
            Fact::True => AtomVerdict::Known(truth.holds == Claim::TRUE),
            Fact::Atom { term, bound, strict } => {
                AtomVerdict::Bound { slot: self.emit(code, term)?, bound: f64::from_bits(bound), strict, contrary }
            }
            _ => return None,
        };
        Some(Atom { margin, verdict, unit: truth.unit })
    }

    /// The code of a number, a vector or a rotation; `None`: it has none.
    pub fn value(&mut self, formula: &Formula) -> Option<CodedValue> {
        let parts = match self.evaluate(formula).ok()? {
            Value::Number(n) => vec![n],
            Value::Vector(v) | Value::Rotation(v) => v.0.to_vec(),
            Value::Truth(_) => return None,
        };
        let mut code = Draft::new(self.sources);
        let parts = parts.into_iter().map(|p| self.emit(&mut code, p)).collect::<Option<Vec<u32>>>()?;
        Some(CodedValue { code: code.code, parts })
    }

    /// Room for all that the code written so far works on.
    pub fn slots(&self) -> Slots {
        let mut slots = vec![0.0; self.sources * INPUTS + TEMPORARIES];
        slots.extend(&self.constants);
        let mut slots = Slots(slots);
        for (id, body) in self.plain.bodies() {
            if let Ok(thing) = self.plain.object(id) {
                slots.set(id, &body.pos, thing.rot.0[1]);
            }
        }
        let first = self.sources - self.plain.variables.len();
        for (id, value) in self.plain.values() {
            slots.put(ObjectId((first + id.0 as usize) as u32), variable(&value));
        }
        slots
    }

    /// The slot of a number; steps that it needs are added.
    fn emit(&mut self, code: &mut Draft, root: Term) -> Option<u32> {
        // Arguments first, without recursion: formulas may be deep.
        let mut open = vec![root];
        while let Some(&term) = open.last() {
            if code.slots.contains_key(&term) {
                open.pop();
                continue;
            }
            let op = self.tape.ops[term.0 as usize];
            let mut arguments = Vec::with_capacity(2);
            let measure = self.measures.get(&term);
            match measure {
                Some((_, on)) => arguments.extend(on),
                None => for_each_argument(op, |t| arguments.push(t)),
            }
            let missing: Vec<Term> = arguments.iter().copied().filter(|t| !code.slots.contains_key(t)).collect();
            if !missing.is_empty() {
                open.extend(missing);
                continue;
            }
            let at = |t: Term| code.slots[&t];
            let step = |what, a: u32, b: u32| Some(Step { what, a, b });
            let step = match op {
                Op::Constant(bits) => {
                    let slot = self.constant(f64::from_bits(bits));
                    code.slots.insert(term, slot);
                    None
                }
                Op::Unknown(number) => match measure {
                    Some((what, on)) => {
                        code.code.measured.push((what.clone(), on.iter().map(|t| at(*t)).collect()));
                        step(Do::Measure, code.code.measured.len() as u32 - 1, 0)
                    }
                    None => {
                        code.slots.insert(term, number - 1);
                        None
                    }
                },
                Op::Add(a, b) => step(Do::Add, at(a), at(b)),
                Op::Sub(a, b) => step(Do::Sub, at(a), at(b)),
                Op::Scale(a, by) => step(Do::Mul, at(a), self.constant(f64::from_bits(by))),
                Op::Mul(a, b) => step(Do::Mul, at(a), at(b)),
                Op::Div(a, b) => step(Do::Div, at(a), at(b)),
                Op::Square(a) => step(Do::Mul, at(a), at(a)),
                Op::Sqrt(a) => step(Do::Sqrt, at(a), at(a)),
                Op::Abs(a) => step(Do::Abs, at(a), at(a)),
                Op::Min(a, b) => step(Do::Min, at(a), at(b)),
                Op::Max(a, b) => step(Do::Max, at(a), at(b)),
                Op::Sin(a) => step(Do::Sin, at(a), at(a)),
                Op::Cos(a) => step(Do::Cos, at(a), at(a)),
                Op::Atan(a, b) => step(Do::Atan, at(a), at(b)),
                Op::Wrap(a) => step(Do::Wrap, at(a), at(a)),
                Op::Indicator(_) => return None,
            };
            if let Some(step) = step {
                if code.code.steps.len() >= TEMPORARIES {
                    return None;
                }
                code.slots.insert(term, (code.code.first + code.code.steps.len()) as u32);
                code.code.steps.push(step);
            }
        }
        code.slots.get(&root).copied()
    }

    fn constant(&mut self, value: f64) -> u32 {
        let first = self.sources * INPUTS + TEMPORARIES;
        let constants = &mut self.constants;
        *self.known.entry(value.to_bits()).or_insert_with(|| {
            constants.push(value);
            (first + constants.len() - 1) as u32
        })
    }
}

/// The inputs of a decision variable with a value.
pub fn variable(value: &Value<f64>) -> [f64; INPUTS] {
    let [a, b, c] = match value {
        Value::Number(n) => [*n, 0.0, 0.0],
        Value::Vector(v) | Value::Rotation(v) => v.0,
        Value::Truth(truth) => [f64::from(u8::from(truth.holds)), 0.0, 0.0],
    };
    [a, b, c, 0.0, 0.0, 0.0]
}

/// An instance whose numbers are inputs of the code, but for what never moves.
fn inputs(
    program: &Program,
    plain: &World<f64>,
    still: &dyn Fn(ObjectId) -> bool,
    upright: &dyn Fn(ObjectId) -> bool,
) -> World<Term> {
    let mut world = World::<Term>::nowhere(program, &plain.options);
    for index in 0..program.objects.len() as u32 {
        let id = ObjectId(index);
        let inputs = [
            unknown(Interval::new(-FAR, FAR)),
            unknown(Interval::new(-FAR, FAR)),
            unknown(Interval::new(-FAR, FAR)),
            unknown(Interval::new(0.0, 360.0)),
            unknown(Interval::new(-1.0, 1.0)),
            unknown(Interval::new(-1.0, 1.0)),
        ];
        let Ok(thing) = plain.object(id) else { continue };
        let upright = upright(id) && thing.rot.0[0] == 0.0 && thing.rot.0[2] == 0.0;
        let [x, y, z, yaw, sin, cos] = inputs;
        let (zero, one) = (Term::constant(0.0), Term::constant(1.0));
        let lift = |v: &V3<f64>| V3(v.0.map(Term::constant));
        let (pos, rot, axes) = if still(id) {
            (lift(&thing.pos), lift(&thing.rot), M3(thing.axes.0.map(|axis| lift(&axis))))
        } else if upright {
            let axes = M3([V3([cos, zero, -sin]), V3([zero, one, zero]), V3([sin, zero, cos])]);
            (V3([x, y, z]), V3([zero, yaw, zero]), axes)
        } else {
            continue;
        };
        world.objects[index as usize] =
            Some(ObjectInstance { pos, rot, scale: lift(&thing.scale), axes, body: thing.body.clone() });
    }
    for index in 0..program.regions.len() as u32 {
        let Ok(room) = plain.region(RegionId(index)) else { continue };
        let lift = |v: &V3<f64>| V3(v.0.map(Term::constant));
        world.regions[index as usize] = Some(RegionInstance {
            pos: lift(&room.pos),
            rot: lift(&room.rot),
            scale: lift(&room.scale),
            outlined: room.outlined,
            prism: room.prism.clone(),
        });
    }
    for (to, from) in world.variables.iter_mut().zip(&plain.variables) {
        let [a, b, c, ..]: [Term; INPUTS] = std::array::from_fn(|_| unknown(Interval::new(-FAR, FAR)));
        *to = from.and_then(|value| match value {
            Value::Number(_) => Ok(Value::Number(a)),
            Value::Vector(_) => Ok(Value::Vector(V3([a, b, c]))),
            Value::Rotation(_) => Ok(Value::Rotation(V3([a, b, c]))),
            // What is true or false is no arithmetic: the evaluator is asked.
            Value::Truth(_) => Err(Cause::Refused),
        });
    }
    world
}

/// The truths that a truth is made of, which are not themselves made of others.
pub fn atoms(formula: &Formula) -> Vec<NodeId> {
    let mut open = vec![formula.root];
    let mut seen = vec![false; formula.nodes.len()];
    let mut found = Vec::new();
    while let Some(id) = open.pop() {
        if std::mem::replace(&mut seen[id.0 as usize], true) {
            continue;
        }
        match formula.node(id) {
            Node::And(parts) | Node::Or(parts) | Node::AtLeast(_, parts) => open.extend(parts.iter()),
            Node::Not(part) => open.push(*part),
            Node::Iff(a, b) => open.extend([a, b]),
            _ => found.push(id),
        }
    }
    found
}

/// Code that is being written.
struct Draft {
    code: Code,
    slots: FxHashMap<Term, u32>,
}

impl Draft {
    fn new(objects: usize) -> Self {
        Self { code: Code { first: objects * INPUTS, ..Code::default() }, slots: FxHashMap::default() }
    }
}

fn for_each_argument(op: Op, mut f: impl FnMut(Term)) {
    match op {
        Op::Constant(_) | Op::Unknown(_) | Op::Indicator(_) => {}
        Op::Scale(a, _) | Op::Square(a) | Op::Sqrt(a) | Op::Abs(a) | Op::Sin(a) | Op::Cos(a) | Op::Wrap(a) => f(a),
        Op::Add(a, b)
        | Op::Sub(a, b)
        | Op::Mul(a, b)
        | Op::Div(a, b)
        | Op::Min(a, b)
        | Op::Max(a, b)
        | Op::Atan(a, b) => {
            f(a);
            f(b);
        }
    }
}

/// What can be told of boxes and rooms.
pub(crate) struct Boxes<'w, 'c> {
    plain: &'w World<f64>,
    measures: &'c mut FxHashMap<Term, (Measured, Vec<Term>)>,
}

impl Boxes<'_, '_> {
    /// A number that is measured when the code runs.
    fn measure(&mut self, what: Measured, on: Vec<Term>) -> Term {
        let term = unknown(Interval::new(-FAR, FAR));
        self.measures.insert(term, (what, on));
        term
    }

    /// The gap of two things; `None`: not both are upright.
    pub(crate) fn gap(&mut self, a: &ObjectInstance<Term>, b: &ObjectInstance<Term>) -> Option<Term> {
        let mut on = upright(a)?;
        on.extend(upright(b)?);
        Some(self.measure(Measured::Gap([blocks(&a.body), blocks(&b.body)]), on))
    }

    /// The horizontal clearance of a thing in a room of any outline.
    pub(crate) fn clearance(&mut self, thing: &ObjectInstance<Term>, room: &RegionInstance<Term>) -> Option<Term> {
        let [x, _, z, sin, cos] = upright(thing)?[..] else { return None };
        let half = thing.body.obb.half;
        Some(self.measure(Measured::Clearance(outline_of(room), [half.x, half.z]), vec![x, z, sin, cos]))
    }

    /// How deep a point is in a room.
    pub(crate) fn depth(&mut self, point: &V3<Term>, room: &RegionInstance<Term>) -> Term {
        self.measure(Measured::Depth(outline_of(room)), vec![point.0[0], point.0[2]])
    }
}

fn outline_of(room: &RegionInstance<Term>) -> Arc<Polygon> {
    Arc::new(room.prism.polygon.clone())
}

/// x, y, z of the centre of a box, and sine and cosine of its yaw; `None`: it is not upright.
fn upright(thing: &ObjectInstance<Term>) -> Option<Vec<Term>> {
    let [zero, one] = [0.0, 1.0].map(Term::constant);
    let [center, turn] = [thing.center().0, thing.axes.0[2].0];
    let is_upright = thing.axes.0[1].0 == [zero, one, zero];
    is_upright.then(|| vec![center[0], center[1], center[2], turn[0], turn[2]])
}

impl Oracle<Term> for Boxes<'_, '_> {
    fn ask(
        &mut self,
        node: &Node,
        id: NodeId,
        values: &Values<Term>,
        world: &World<Term>,
    ) -> Result<Value<Term>, EvalError> {
        let fail = |cause: Cause| EvalError { cause, node: id };
        let none = || fail(Cause::Refused);
        match node {
            Node::Object(ObjectProperty::Surface, object) => {
                let thing = world.object(*object).map_err(fail)?;
                let top = thing.center().0[1] + thing.reach().0[1];
                Ok(Value::Number(
                    thing.body.surface.map_or(top, |height| {
                        (thing.pos + thing.axes.turn_constant(&Vec3::new(0.0, height, 0.0))).0[1]
                    }),
                ))
            }
            Node::Region(property, region) => match outline(self.plain, *property, *region).map_err(fail)? {
                Value::Number(n) => Ok(Value::Number(Term::constant(n))),
                Value::Vector(v) => Ok(Value::Vector(V3(v.0.map(Term::constant)))),
                _ => Err(none()),
            },
            Node::Draw(draw) => Ok(Value::Number(Term::constant(self.plain.draw(*draw).map_err(fail)?))),
            Node::Choice(draw, list) => chosen(self.plain.draw(*draw).map_err(fail)?, list, values),
            Node::BuiltIn(built_in, args) => {
                Call { built_in: *built_in, args, values, world, node: id }.fast(self)?.ok_or_else(none)
            }
            _ => Err(none()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Options;
    use scenelang_lang::program::Arg;
    use scenelang_lang::{Options as Reading, compile_text};
    use scenelang_layout::{Layout, Placement};
    use std::path::Path;

    const SCENE: &str = "
region room;
room.pos <- vec3(0, 0, 0);
room.scale <- vec3(6, 3, 5);
region ell;
ell.pos <- vec3(0, 0, 0);
ell.scale <- vec3(6, 3, 5);
ell.vertices <- polygon(vec3(-3, 0, -2.5), vec3(3, 0, -2.5), vec3(3, 0, 0), vec3(0, 0, 0), vec3(0, 0, 2.5), vec3(-3, 0, 2.5));
object a;
object b;
assert inside(a, ell) and gap(b, ell) > 0.1;
assert gap(a, b) <= 0.3 or collides(a, b);
assert againstWall(b, ell) or inCorner(b, room) or near(a, b, 1);
assert inside(a, b) or a.bottom = b.top;
assert dot(a.center - b.center, b.right) >= b.size.x / 2 + abs(dot(a.right, b.right)) * a.size.x / 2;
assert distance(a, b) <= 1.5 and not (a.pos.x < b.pos.z) and angle(a.front, b.front) <= 30;
assert length(vec3(a.center.x - b.center.x, 0, 1)) = min(a.max.x, sqrt(abs(b.pos.z))) implies a.rot.y = 90;
assert a.pos.x > 0 and b.pos.x > 0.5 or max(a.pos.x, 2 / (1 + abs(b.pos.x))) > 1;
";

    #[test]
    fn code_says_what_the_evaluator_says() {
        let compiled = compile_text("s.scene", Path::new("s.scene"), SCENE, Reading::default());
        let program = compiled.program.as_ref().unwrap_or_else(|| panic!("{:?}", compiled.diagnostics));
        let thing = |pos: [f64; 3], yaw: f64, scale: [f64; 3]| Placement {
            pos: pos.into(),
            rot: Vec3::new(0.0, yaw, 0.0),
            scale: scale.into(),
            parts: Vec::new(),
            surface: None,
            joints: Vec::new(),
        };
        let mut checked = 0;
        for i in 0..200 {
            let wave = |k: f64| 2.5 * (k * f64::from(i)).sin();
            let yaw = |k: i32| if i % 2 == 0 { f64::from(i * k % 4 * 90) } else { f64::from(i * 37 * k % 360) };
            let a = thing([wave(1.3), 0.8 * f64::from(i % 2), wave(0.7)], yaw(1), [0.5, 0.4, 0.8]);
            let b = thing([wave(0.37), 0.0, wave(2.1)], yaw(3), [1.0, 0.8, 0.6]);
            let layout =
                Layout { objects: vec![("a".into(), a.clone()), ("b".into(), b.clone())], ..Layout::default() };
            let room = scenelang_layout::RegionPlacement {
                pos: Vec3::zeros(),
                rot: Vec3::zeros(),
                scale: Vec3::new(6.0, 3.0, 5.0),
                vertices: None,
            };
            let corners = [[-3.0, -2.5], [3.0, -2.5], [3.0, 0.0], [0.0, 0.0], [0.0, 2.5], [-3.0, 2.5]];
            let ell = scenelang_layout::RegionPlacement { vertices: Some(corners.to_vec()), ..room.clone() };
            let layout = Layout { regions: vec![("room".into(), room), ("ell".into(), ell)], ..layout };
            let world = World::<f64>::new(program, &layout, &Options::default());
            let mut coder = Coder::new(program, &world, &|_| false, &|_| true);
            for constraint in &program.constraints {
                let formula = &constraint.formula;
                let Some(code) = coder.truth(formula) else { continue };
                let mut slots = coder.slots();
                code.run(&mut slots);
                let mut scratch = Scratch::new();
                let _ = scratch.evaluate(formula, &world);
                for index in 0..formula.nodes.len() as u32 {
                    let (Some(coded), Ok(Value::Truth(plain))) =
                        (code.truth(NodeId(index), &slots), scratch.get(NodeId(index)))
                    else {
                        continue;
                    };
                    // How far outside something is they may see differently.
                    let room =
                        |node: &Node| matches!(node, Node::BuiltIn(_, args) if matches!(args[..], [_, Arg::Region(_)]));
                    let rooms =
                        matches!(formula.node(NodeId(index)), Node::BuiltIn(..)) || formula.nodes.iter().any(room);
                    let inside = rooms && plain.margin < 0.0;
                    assert_eq!(coded.holds, plain.holds, "{formula:?} {layout:?}");
                    assert!(inside || (coded.margin - plain.margin).abs() < 1e-9, "{coded:?} {plain:?} {formula:?}");
                    checked += 1;
                }
            }
        }
        assert!(checked > 1000, "{checked}");
    }
}
