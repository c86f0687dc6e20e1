//! What a program leaves open: an instance of it whose positions, sizes, orientations, variables and draws are unknowns,
//! each in the widest domain that a layout file may use, and what is known of predicates that need geometry.
//!
//! Nothing is assumed about what the layout may choose. A predicate without a formula of its own is an open verdict
//! with *consequences*: claims that hold in every instance. Each is argued where it stands; if one of them were wrong,
//! proofs would be.

use super::interval::Interval;
use super::tape::{Claim, Term, implies, open, range, unknown};
use crate::builtins::Call;
use crate::eval::{Cause, EvalError, Oracle, Scratch, Value, Values};
use crate::eval::{Truth, rectangle};
use crate::number::{Algebra, Logic};
use crate::tolerances::Options;
use crate::vector::{M3, V3};
use crate::world::{Body, Room, Thing, World};
use rustc_hash::{FxHashMap, FxHashSet};
use scenelang_lang::program::{
    Node, NodeId, ObjectId, ObjectProperty, Owner, Pinned, Program, RegionId, RegionProperty, Unit, VariableKind,
};
use scenelang_layout::Prism;
use scenelang_layout::file::LARGEST;
use std::collections::BTreeSet;
use std::rc::Rc;

/// Rounding of what holds exactly (unit vectors, equations of a frame).
pub(crate) const EXACT: f64 = 1e-9;
/// Any distance between things that a layout can name (metres).
pub(crate) const ANY: Interval = Interval { lo: -4.0 * LARGEST, hi: 4.0 * LARGEST };

/// The unknowns of a program, and what is known of them.
pub(crate) struct Unknowns<'p> {
    program: &'p Program,
    pub options: Options,
    pub world: Rc<World<Term>>,
    /// Claims that hold in every instance.
    pub always: Vec<Claim>,
    /// Those of them that are equations of frames: too far from linear to be of use to linear reasoning.
    pub curved: Vec<Claim>,
    /// Statements that fix the orientation of an object for good.
    pub turned: FxHashMap<ObjectId, usize>,
    /// Statements that a region's frame rests on: its orientation, and that it is a rectangle at all.
    pub framed: FxHashMap<RegionId, Vec<usize>>,
    /// Regions that are rectangles: an assigned `scale` without assigned `vertices` forbids an outline.
    rectangles: FxHashSet<RegionId>,
    /// By the first component of a rotation: whose orientation it is.
    owners: FxHashMap<Term, Owner>,
    /// Cosine and sine of the yaw of a region.
    yaws: Vec<[Term; 2]>,
    terms: FxHashMap<String, Term>,
    claims: FxHashMap<String, Claim>,
    frames: FxHashMap<(ObjectId, RegionId), [[Term; 3]; 2]>,
}

impl<'p> Unknowns<'p> {
    /// The unknowns of a program of which only some statements count, and only some objects are spoken of.
    pub fn new(
        program: &'p Program,
        options: &Options,
        counts: &dyn Fn(usize) -> bool,
        objects: &BTreeSet<ObjectId>,
    ) -> Self {
        let mut world = World::nowhere(program, options);
        let mut own = Self {
            program,
            options: *options,
            world: Rc::new(world.clone()),
            always: Vec::new(),
            curved: Vec::new(),
            turned: FxHashMap::default(),
            framed: FxHashMap::default(),
            rectangles: FxHashSet::default(),
            owners: FxHashMap::default(),
            yaws: Vec::new(),
            terms: FxHashMap::default(),
            claims: FxHashMap::default(),
            frames: FxHashMap::default(),
        };
        let turns = own.pinned_turns(counts);
        for &id in objects {
            let turn = turns.get(&Owner::Object(id));
            if let Some((statement, _)) = turn {
                own.turned.insert(id, *statement);
            }
            let (rot, axes) = match turn {
                Some((_, rot)) => (*rot, M3::rotation(*rot)),
                None => (own.angles(Owner::Object(id)), M3(std::array::from_fn(|_| triple(-1.0, 1.0)))),
            };
            let thing = Thing { pos: place(), rot, scale: size(), axes, body: Body::unit() };
            world.objects[id.0 as usize] = Some(thing);
        }
        for index in 0..program.regions.len() {
            let id = RegionId(index as u32);
            let turn = turns.get(&Owner::Region(id));
            let mut rests: Vec<usize> = turn.iter().map(|(statement, _)| *statement).collect();
            let scaled = |property| {
                let of = |p: &&scenelang_lang::program::Pin| p.owner == Owner::Region(id) && p.property == property;
                program.pins.iter().filter(of).map(|p| p.constraint).find(|&c| counts(c))
            };
            if let (Some(statement), false) = (scaled(Pinned::Scale), program.regions[index].has_vertices) {
                own.rectangles.insert(id);
                rests.push(statement);
            }
            own.framed.insert(id, rests);
            let (rot, yaw) = match turn {
                Some((_, rot)) => (*rot, [rot.0[1].cos(), rot.0[1].sin()]),
                // A rectangle turned by half a turn is the same one, and it is all that the frame is used for: so the
                // cosine is not negative.
                None => {
                    let frame = [Interval::new(0.0, 1.0), Interval::new(-1.0, 1.0)].map(unknown);
                    (own.angles(Owner::Region(id)), frame)
                }
            };
            own.yaws.push(yaw);
            world.regions[index] =
                Some(Room { pos: place(), rot, scale: size(), outlined: false, prism: Prism::unit() });
        }
        for (index, variable) in program.variables.iter().enumerate() {
            world.variables[index] = Ok(match variable.kind {
                VariableKind::Number => Value::Number(unknown(Interval::new(-LARGEST, LARGEST))),
                VariableKind::Degree => Value::Number(turn()),
                VariableKind::Bool => {
                    Value::Truth(Truth { margin: Term::constant(0.0), holds: open(), unit: Unit::Metre })
                }
                VariableKind::Vector => Value::Vector(place()),
                VariableKind::Rotation => Value::Rotation(V3(std::array::from_fn(|_| turn()))),
            });
        }
        own.world = Rc::new(world);
        own
    }

    /// Names of the objects, regions and variables, in order.
    pub fn program_objects(&self) -> impl Iterator<Item = &'p str> + use<'p> {
        self.program.objects.iter().map(|o| o.name.as_str())
    }
    pub fn program_regions(&self) -> impl Iterator<Item = &'p str> + use<'p> {
        self.program.regions.iter().map(|r| r.name.as_str())
    }
    pub fn program_variables(&self) -> impl Iterator<Item = &'p str> + use<'p> {
        self.program.variables.iter().map(|v| v.name.as_str())
    }

    /// Orientations that a statement pins to a constant; they count as exact.
    fn pinned_turns(&mut self, counts: &dyn Fn(usize) -> bool) -> FxHashMap<Owner, (usize, V3<Term>)> {
        let mut found = FxHashMap::default();
        let mut scratch = Scratch::new();
        for pin in self.program.pins.iter().filter(|p| p.property == Pinned::Rot && counts(p.constraint)) {
            let Some(formula) = pin.values.first() else { continue };
            // Nothing is in the instance yet, so that whatever depends on it has no value.
            let plain = formula.nodes.iter().all(|n| !matches!(n, Node::Draw(_) | Node::BuiltIn(..)));
            let world = Rc::clone(&self.world);
            if plain
                && let Ok(Value::Rotation(rot)) = scratch.evaluate_with(formula, &world, self)
                && rot.0.iter().all(|c| c.known().is_some())
            {
                found.insert(pin.owner, (pin.constraint, rot));
            }
        }
        found
    }

    /// Three unknown angles; only their turns modulo 360 have a say anywhere.
    fn angles(&mut self, owner: Owner) -> V3<Term> {
        let rot = V3(std::array::from_fn(|_| turn()));
        self.owners.insert(rot.0[0], owner);
        rot
    }

    /// What is always true of an unknown orientation: its axes are unit vectors, across each other, by rows too.
    pub fn orientation(&mut self, id: ObjectId) {
        let Some(thing) = &self.world.objects[id.0 as usize] else { return };
        let axes = thing.axes.0.map(|axis| axis.0);
        if axes.iter().flatten().all(|c| c.known().is_some()) {
            return;
        }
        let across = std::array::from_fn(|i| std::array::from_fn(|k| axes[k][i]));
        self.orthonormal(&axes);
        self.orthonormal(&across);
    }

    /// The link between the angles of an object and its axes, for those of which a component is read.
    pub fn angles_turn_axes(&mut self, id: ObjectId) {
        let Some(thing) = &self.world.objects[id.0 as usize] else { return };
        let (axes, turned) = (thing.axes, M3::rotation(thing.rot));
        for (a, b) in axes.0.iter().flat_map(|v| v.0).zip(turned.0.iter().flat_map(|v| v.0)) {
            self.equal(a, b);
        }
    }

    /// What is always true of a region's yaw.
    pub fn yaw(&mut self, id: RegionId) {
        let [c, s] = self.yaws[id.0 as usize];
        if c.known().is_none() {
            self.equal(c * c + s * s, Term::constant(1.0));
        }
    }

    fn equal(&mut self, a: Term, b: Term) {
        if a != b {
            let d = a - b;
            let sides = [d.at_least(-EXACT), (-d).at_least(-EXACT)];
            self.always.extend(sides);
            self.curved.extend(sides);
        }
    }

    fn orthonormal(&mut self, rows: &[[Term; 3]; 3]) {
        for row in rows {
            self.equal(V3(*row).dot(V3(*row)), Term::constant(1.0));
        }
        for [i, k] in [[0, 1], [0, 2], [1, 2]] {
            self.equal(V3(rows[i]).dot(V3(rows[k])), Term::constant(0.0));
        }
    }

    /// An object.
    pub fn thing(&self, id: ObjectId) -> Thing<Term> {
        self.world.objects[id.0 as usize].clone().expect("every object that is spoken of is there")
    }

    /// A region.
    pub fn room(&self, id: RegionId) -> Room<Term> {
        self.world.regions[id.0 as usize].clone().expect("every region is there")
    }

    /// A horizontal vector in the frame of a region: along its right and its front.
    pub fn framed(&mut self, region: RegionId, x: Term, z: Term) -> [Term; 2] {
        let [c, s] = self.yaws[region.0 as usize];
        let own = [c * x - s * z, s * x + c * z];
        if c.known().is_none() {
            // The way back holds too, and tells more of x and z than the way there.
            self.equal(c * own[0] + s * own[1], x);
            self.equal(c * own[1] - s * own[0], z);
        }
        own
    }

    /// Right and front of a region, seen by the axes of an object: rows of an orthonormal matrix.
    fn frame(&mut self, object: ObjectId, region: RegionId) -> [[Term; 3]; 2] {
        if let Some(known) = self.frames.get(&(object, region)) {
            return *known;
        }
        let axes = self.thing(object).axes;
        let seen: [[Term; 2]; 3] = std::array::from_fn(|k| self.framed(region, axes.0[k].0[0], axes.0[k].0[2]));
        let mut rows = [[0, 1, 2].map(|k| seen[k][0]), [0, 1, 2].map(|k| seen[k][1])];
        if self.yaws[region.0 as usize][0].known().is_none() {
            let whole = [
                [0, 1, 2].map(|_| unknown(Interval::new(-1.0, 1.0))),
                [0, 1, 2].map(|_| unknown(Interval::new(-1.0, 1.0))),
            ];
            for (own, seen) in whole.iter().flatten().zip(rows.iter().flatten()) {
                self.equal(*own, *seen);
            }
            rows = whole;
            let height = axes.0.map(|axis| axis.0[1]);
            let matrix = [rows[0], height, rows[1]];
            self.orthonormal(&matrix);
            self.orthonormal(&std::array::from_fn(|i| std::array::from_fn(|k| matrix[k][i])));
        }
        self.frames.insert((object, region), rows);
        rows
    }

    /// How far an object is from the side walls and from the end walls of a rectangular region, at least.
    pub fn wall_distances(&mut self, object: ObjectId, region: RegionId) -> [Term; 2] {
        let (thing, room) = (self.thing(object), self.room(region));
        let rows = self.frame(object, region);
        let between = thing.center() - room.pos;
        let at = self.framed(region, between.0[0], between.0[2]);
        [0, 1].map(|i| {
            let reach = |k: usize| rows[i][k].abs() * thing.scale.0[k].scale(0.5);
            room.scale.0[2 * i].scale(0.5) - at[i].abs() - (reach(0) + reach(1) + reach(2))
        })
    }

    /// An open verdict from which these follow.
    pub fn open(&mut self, name: String, consequences: &[Claim]) -> Claim {
        if let Some(known) = self.claims.get(&name) {
            return *known;
        }
        let claim = open();
        self.claims.insert(name, claim);
        self.always.extend(consequences.iter().map(|c| implies(claim, *c)));
        claim
    }

    /// A measure by its name, made at its first use; the flag says that it was.
    pub fn term(&mut self, name: String, domain: Interval) -> (Term, bool) {
        if let Some(known) = self.terms.get(&name) {
            return (*known, false);
        }
        let term = unknown(domain);
        self.terms.insert(name, term);
        (term, true)
    }

    /// Whether a measure is spoken of.
    pub fn knows(&self, name: &str) -> bool {
        self.terms.contains_key(name)
    }

    /// Whether a region is a rectangle in every instance.
    pub fn is_rectangle(&self, region: RegionId) -> bool {
        self.rectangles.contains(&region)
    }

    /// A built-in of which nothing is known but that the same question has the same verdict.
    pub fn of_unknown(&mut self, call: &Call<'_, Term>) -> Result<Value<Term>, EvalError> {
        if !call.built_in.is_predicate() {
            return Ok(Value::Number(unknown(ANY)));
        }
        let question = call.question()?;
        Ok(Value::Truth(claimed(self.open(question, &[]))))
    }

    /// The axes of a rotation: of an object, or of an angle that is known.
    fn axes_of(&self, rot: V3<Term>) -> Option<M3<Term>> {
        match self.owners.get(&rot.0[0]) {
            Some(Owner::Object(id)) => Some(self.thing(*id).axes),
            Some(Owner::Region(_)) => None,
            None => rot.0.iter().all(|c| c.known().is_some()).then(|| M3::rotation(rot)),
        }
    }

    /// Whether two orientations are the same.
    fn same_turn(&mut self, a: V3<Term>, b: V3<Term>) -> Claim {
        let tolerance = self.options.tolerances.angle;
        let name = format!("same {:?} {:?}", a.0, b.0);
        let (Some(x), Some(y)) = (self.axes_of(a), self.axes_of(b)) else { return self.open(name, &[]) };
        if let Some(angle) = x.angle(&y).known()
            && (angle - tolerance).abs() > EXACT
        {
            return Claim::constant(angle < tolerance);
        }
        // Turned by an angle t, a unit vector moves by 2·sin(t/2), which is less than t; so no component moves more.
        let moved = tolerance.to_radians() + EXACT;
        let pairs = x.0.iter().flat_map(|v| v.0).zip(y.0.iter().flat_map(|v| v.0));
        let follow: Vec<Claim> =
            pairs.flat_map(|(p, q)| [(p - q).at_least(-moved), (q - p).at_least(-moved)]).collect();
        self.open(name, &follow)
    }
}

impl Oracle<Term> for Unknowns<'_> {
    fn ask(
        &mut self,
        node: &Node,
        id: NodeId,
        values: &Values<Term>,
        world: &World<Term>,
    ) -> Result<Value<Term>, EvalError> {
        let truth = |holds: Claim| Value::Truth(claimed(holds));
        Ok(match node {
            Node::Object(ObjectProperty::Surface, object) => {
                let (surface, new) =
                    self.term(format!("surface {object:?}"), Interval::new(-LARGEST * 4.0, LARGEST * 4.0));
                if new {
                    // A surface that an asset declares is one of its own: somewhere from its base to its top.
                    let thing = self.thing(*object);
                    let (center, reach) = (thing.center().0[1], thing.reach().0[1]);
                    self.always.push((surface - (center - reach)).at_least(-EXACT));
                    self.always.push((center + reach - surface).at_least(-EXACT));
                }
                Value::Number(surface)
            }
            Node::Region(property, region) => {
                let exact = rectangle(world, *property, *region).map_err(|cause| EvalError { cause, node: id })?;
                if self.rectangles.contains(region) {
                    return Ok(exact);
                }
                // Of an outline that is not known only the heights are.
                let far = Interval::new(-LARGEST, LARGEST);
                match (property, exact) {
                    (RegionProperty::Center, Value::Vector(center)) => {
                        let x = self.term(format!("center x {region:?}"), far).0;
                        let z = self.term(format!("center z {region:?}"), far).0;
                        Value::Vector(V3([x, center.0[1], z]))
                    }
                    _ => Value::Number(
                        self.term(format!("area {region:?}"), Interval::new(0.0, 4.0 * LARGEST * LARGEST)).0,
                    ),
                }
            }
            Node::Draw(draw) => {
                let name = format!("draw {draw:?}");
                if let Some(known) = self.terms.get(&name) {
                    return Ok(Value::Number(*known));
                }
                let stated = &self.program.draws[draw.0 as usize];
                let mut bound = |formula| match Scratch::new().evaluate_with(formula, world, self) {
                    Ok(Value::Number(n)) => range(n),
                    _ => Interval::ALL,
                };
                let (lo, hi) = (bound(&stated.lo), bound(&stated.hi));
                Value::Number(self.term(name, Interval::new(lo.lo - EXACT, hi.hi + EXACT)).0)
            }
            Node::BuiltIn(built_in, args) => {
                Call { built_in: *built_in, args, values, world, node: id }.bounds(self)?
            }
            Node::Same(a, b) => match (values[a.0 as usize]?, values[b.0 as usize]?) {
                (Value::Rotation(a), Value::Rotation(b)) => truth(self.same_turn(a, b)),
                _ => return Err(EvalError { cause: Cause::Refused, node: id }),
            },
            // A pinned outline, or what only geometry could tell.
            _ => truth(open()),
        })
    }
}

/// A verdict without a margin.
pub(crate) fn claimed(holds: Claim) -> Truth<Term> {
    Truth { margin: Term::constant(0.0), holds, unit: Unit::Metre }
}

fn triple(lo: f64, hi: f64) -> V3<Term> {
    V3(std::array::from_fn(|_| unknown(Interval::new(lo, hi))))
}

/// Any place that a layout can name.
fn place() -> V3<Term> {
    triple(-LARGEST, LARGEST)
}

/// Any size that a layout can name: more than 0.
fn size() -> V3<Term> {
    triple(f64::from_bits(1), LARGEST)
}

/// Any angle, as it is read: in [0, 360).
fn turn() -> Term {
    unknown(Interval::new(0.0, 360f64.next_down()))
}
