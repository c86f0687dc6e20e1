//! What a program leaves open: an instance of it whose positions, sizes, orientations, variables and draws are unknowns,
//! each in the widest domain that a layout file may use, and what is known of predicates that need geometry.
//!
//! Nothing is assumed about what the layout may choose. A predicate without a formula of its own is an open verdict
//! with *consequences*: claims that hold in every instance. Each is argued where it stands; if one of them were wrong,
//! proofs would be.

use super::interval::Interval;
use super::sights::Sight;
use super::tape::{Claim, Term, implies, open, range, unknown};
use super::usual::{Usual, carries_on_top, core_of};
use crate::builtins::Call;
use crate::eval::{Cause, EvalError, Oracle, Scratch, Value, Values};
use crate::eval::{Truth, rectangle};
use crate::number::{Algebra, Logic};
use crate::tolerances::Options;
use crate::vector::{M3, V3};
use crate::world::{Body, ObjectInstance, RegionInstance, World};
use rustc_hash::{FxHashMap, FxHashSet};
use scenelang_lang::library::furniture_size;
use scenelang_lang::program::{
    ConstraintKind, DrawId, Formula, Node, NodeId, ObjectId, ObjectProperty, Owner, Pinned, Program, RegionId,
    RegionProperty, Unit, VariableKind,
};
use scenelang_layout::file::LARGEST;
use scenelang_layout::{Geometry, Prism};
use std::collections::BTreeSet;
use std::rc::Rc;

/// Rounding of what holds exactly (unit vectors, equations of a frame).
pub(crate) const EXACT: f64 = 1e-9;
/// Where things are taken as usual: of its height, the part that a support surface is above the base, at least.
const LOWEST_SURFACE: f64 = 0.1;
/// How far the parts of an asset may stick out of its box, both of a pair together, and then some (metres).
pub(crate) const OUT_OF_BOX: f64 = 2.2e-3;
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
    /// Statements that fix an object's orientation for good; where things are taken as usual, its place and size, too.
    pub rests: FxHashMap<ObjectId, Vec<usize>>,
    /// What is taken for granted, if anything is.
    pub usual: Option<&'p Usual>,
    /// Statements that a region's frame rests on: its orientation, and that it is a rectangle at all.
    pub framed: FxHashMap<RegionId, Vec<usize>>,
    /// Regions that are rectangles: an assigned `scale` without assigned `vertices` forbids an outline.
    rectangles: FxHashSet<RegionId>,
    /// By the components of a rotation: whose orientation it is.
    owners: FxHashMap<[Term; 3], Owner>,
    /// Cosine and sine of the yaw of a region.
    yaws: Vec<[Term; 2]>,
    terms: FxHashMap<String, Term>,
    claims: FxHashMap<String, Claim>,
    frames: FxHashMap<(ObjectId, RegionId), [[Term; 3]; 2]>,
    /// Pairs of objects with the length of a way from the middle of one to that of the other, by way of their surfaces: the
    /// gap between them, and half a diagonal of each. Such lengths satisfy the triangle inequality.
    pub spans: Vec<([ObjectId; 2], Term)>,
    /// A point of the solid of each object that a gap is asked of.
    points: FxHashMap<ObjectId, V3<Term>>,
    /// Spaces beside objects, with the claims that they are free.
    pub spaces: Vec<(Claim, ObjectId, ObjectInstance<Term>)>,
    /// Claims that there is a path, with its ends and its width.
    pub paths: Vec<(Claim, [ObjectId; 2], Term)>,
    /// Directions with the angles between them that claims speak of.
    pub angles: Vec<([V3<Term>; 2], Term)>,
    /// Objects of which a component of the rotation is read.
    turned: FxHashSet<ObjectId>,
    /// Things of which one is in a direction from the other that claims speak of.
    pub sights: Vec<Sight>,
}

/// What statements pin, with the statements.
type Pins = FxHashMap<(Owner, Pinned), (usize, V3<Term>)>;

/// Objects that are turned alike, because statements say that they are.
struct Alike {
    /// By object: the first of those that are turned like it, or a number of its own.
    groups: Vec<usize>,
    links: Vec<(usize, usize)>,
    /// By group: its turn.
    turns: FxHashMap<usize, (V3<Term>, M3<Term>)>,
}

impl Alike {
    /// Groups by statements that count; each by itself unless things are taken as usual.
    fn new(program: &Program, usual: bool, counts: &dyn Fn(usize) -> bool) -> Self {
        let objects = program.objects.len();
        let mut own = Self {
            groups: (0..objects + program.variables.len()).collect(),
            links: Vec::new(),
            turns: FxHashMap::default(),
        };
        let stated = program.constraints.iter().enumerate().filter(|(i, _)| usual && counts(*i));
        for (index, constraint) in stated {
            let formula = &constraint.formula;
            let mut open = vec![formula.root];
            while let Some(id) = open.pop() {
                let turn = |id: NodeId| match formula.node(id) {
                    Node::Object(ObjectProperty::Rot, object) => Some(object.0 as usize),
                    Node::Variable(variable) => Some(objects + variable.0 as usize),
                    _ => None,
                };
                match formula.node(id) {
                    Node::And(parts) => open.extend(parts.iter().copied()),
                    Node::Same(a, b) => {
                        if let (Some(a), Some(b)) = (turn(*a), turn(*b)) {
                            own.links.push((a, index));
                            own.links.push((b, index));
                            let (a, b) = (own.groups[a], own.groups[b]);
                            own.groups.iter_mut().filter(|g| **g == a.max(b)).for_each(|g| *g = a.min(b));
                        }
                    }
                    _ => {}
                }
            }
        }
        own
    }
    fn group(&self, id: ObjectId) -> usize {
        self.groups[id.0 as usize]
    }
    /// One of a group is turned so, by a statement.
    fn pin(&mut self, id: ObjectId, statement: usize, rot: V3<Term>) {
        self.links.push((id.0 as usize, statement));
        self.turns.insert(self.group(id), (rot, M3::rotation(rot)));
    }
    /// The statements that turn objects like this one.
    fn statements(&self, id: ObjectId) -> impl Iterator<Item = usize> {
        let own = self.group(id);
        self.links.iter().filter(move |(of, _)| self.groups[*of] == own).map(|(_, statement)| *statement)
    }
}

/// A turn of which nothing is known, or nothing but that it is upright.
fn free_turn(upright: bool) -> (V3<Term>, M3<Term>) {
    if !upright {
        return (V3(std::array::from_fn(|_| turn())), M3(std::array::from_fn(|_| triple(-1.0, 1.0))));
    }
    let (zero, one) = (Term::constant(0.0), Term::constant(1.0));
    let [c, s] = [(); 2].map(|()| unknown(Interval::new(-1.0, 1.0)));
    let axes = M3([V3([c, zero, -s]), V3([zero, one, zero]), V3([s, zero, c])]);
    (V3([zero, turn(), zero]), axes)
}

impl<'p> Unknowns<'p> {
    /// The unknowns of a program of which only some statements count, and only some objects are spoken of.
    /// `blank`: an instance that lacks everything.
    pub fn new(
        program: &'p Program,
        blank: &Rc<World<Term>>,
        usual: Option<&'p Usual>,
        counts: &dyn Fn(usize) -> bool,
        objects: &BTreeSet<ObjectId>,
    ) -> Self {
        let mut world = World::clone(blank);
        let mut own = Self {
            program,
            options: blank.options,
            world: Rc::clone(blank),
            always: Vec::new(),
            curved: Vec::new(),
            rests: FxHashMap::default(),
            usual,
            framed: FxHashMap::default(),
            rectangles: FxHashSet::default(),
            owners: FxHashMap::default(),
            yaws: Vec::new(),
            terms: FxHashMap::default(),
            claims: FxHashMap::default(),
            frames: FxHashMap::default(),
            spans: Vec::new(),
            points: FxHashMap::default(),
            spaces: Vec::new(),
            paths: Vec::new(),
            angles: Vec::new(),
            turned: FxHashSet::default(),
            sights: Vec::new(),
        };
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
        let pins = own.pinned(counts);
        let mut alike = Alike::new(program, usual.is_some(), counts);
        for id in objects.iter().filter(|_| usual.is_some()) {
            if let Some((statement, rot)) = pins.get(&(Owner::Object(*id), Pinned::Rot)) {
                alike.pin(*id, *statement, *rot);
            }
        }
        for &id in objects {
            let owner = Owner::Object(id);
            let thing = own.thing_of(id, &pins, &mut alike);
            let pinned = [Pinned::Rot, Pinned::Pos, Pinned::Scale].into_iter();
            let mut rests: Vec<usize> = pinned.filter_map(|p| pins.get(&(owner, p))).map(|(s, _)| *s).collect();
            rests.extend(alike.statements(id));
            own.rests.insert(id, rests);
            world.objects[id.0 as usize] = Some(thing);
        }
        for index in 0..program.regions.len() {
            world.regions[index] = Some(own.room_of(RegionId(index as u32), &pins, counts));
        }
        own.world = Rc::new(world);
        own
    }

    /// An object whose pins are known.
    fn thing_of(&mut self, id: ObjectId, pins: &Pins, alike: &mut Alike) -> ObjectInstance<Term> {
        let index = id.0 as usize;
        let pinned = |property| pins.get(&(Owner::Object(id), property)).map(|(_, value)| *value);
        let upright = self.usual.is_some_and(|usual| usual.upright[index]);
        let (rot, axes) = match pinned(Pinned::Rot) {
            Some(rot) => (rot, M3::rotation(rot)),
            None => *alike.turns.entry(alike.group(id)).or_insert_with(|| free_turn(upright)),
        };
        if pinned(Pinned::Rot).is_none() {
            self.owners.insert(rot.0, Owner::Object(id));
        }
        let known = self.usual.and_then(|usual| usual.size[index]);
        let scale = pinned(Pinned::Scale).or(known.map(|s| V3(s.map(Term::constant)))).unwrap_or_else(size);
        ObjectInstance { pos: pinned(Pinned::Pos).unwrap_or_else(place), rot, scale, axes, body: Body::unit() }
    }

    /// A region whose pins are known.
    fn room_of(&mut self, id: RegionId, pins: &Pins, counts: &dyn Fn(usize) -> bool) -> RegionInstance<Term> {
        let owner = Owner::Region(id);
        let pinned = |property| pins.get(&(owner, property)).map(|(_, value)| *value);
        let mut rests: Vec<usize> = [Pinned::Rot, Pinned::Pos, Pinned::Scale]
            .into_iter()
            .filter_map(|property| pins.get(&(owner, property)))
            .map(|(statement, _)| *statement)
            .collect();
        let of = |p: &&scenelang_lang::program::Pin| p.owner == owner && p.property == Pinned::Scale;
        let scaled = self.program.pins.iter().filter(of).map(|p| p.constraint).find(|&c| counts(c));
        if let (Some(statement), false) = (scaled, self.program.regions[id.0 as usize].has_vertices) {
            self.rectangles.insert(id);
            rests.push(statement);
        }
        self.framed.insert(id, rests);
        let zero = Term::constant(0.0);
        let unturned = self.usual.is_some_and(|usual| usual.unturned[id.0 as usize]);
        let (rot, yaw) = match pinned(Pinned::Rot) {
            Some(rot) => (rot, [rot.0[1].cos(), rot.0[1].sin()]),
            None if unturned => (V3([zero; 3]), [Term::constant(1.0), zero]),
            // A rectangle turned by half a turn is the same one, and it is all that the frame is used for: so the
            // cosine is not negative.
            None => {
                let frame = [Interval::new(0.0, 1.0), Interval::new(-1.0, 1.0)].map(unknown);
                (self.angles(owner), frame)
            }
        };
        self.yaws.push(yaw);
        let (mut pos, mut scale) = (place(), size());
        if self.usual.is_some_and(|usual| usual.on_the_ground[id.0 as usize]) {
            pos.0[1] = zero;
        }
        if self.usual.is_some_and(|usual| usual.origin == Some(id)) {
            (pos.0[0], pos.0[2]) = (zero, zero);
        }
        // Beside an outline only the heights of place and size count.
        let counts = if self.program.regions[id.0 as usize].has_vertices { 1..2 } else { 0..3 };
        for (own, property) in [(&mut pos, Pinned::Pos), (&mut scale, Pinned::Scale)] {
            if let Some(V3(value)) = pinned(property) {
                counts.clone().for_each(|axis| own.0[axis] = value[axis]);
            }
        }
        RegionInstance { pos, rot, scale, outlined: false, prism: Prism::unit() }
    }

    /// Gives a region another extent along an axis than the program does.
    pub fn resize(&mut self, region: RegionId, axis: usize, to: f64) {
        if let Some(room) = &mut Rc::make_mut(&mut self.world).regions[region.0 as usize] {
            room.scale.0[axis] = Term::constant(to);
        }
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

    /// Orientations that a statement pins to a constant; they count as exact. Where things are taken as usual, places
    /// and sizes do, too.
    fn pinned(&mut self, counts: &dyn Fn(usize) -> bool) -> Pins {
        let mut found = FxHashMap::default();
        let mut scratch = Scratch::new();
        let exact = |p: Pinned| p == Pinned::Rot || self.usual.is_some() && p != Pinned::Vertices;
        let pins: Vec<_> = self.program.pins.iter().filter(|p| exact(p.property) && counts(p.constraint)).collect();
        for pin in pins {
            let Some(formula) = pin.values.first() else { continue };
            // Nothing is in the instance yet, so that whatever depends on it has no value.
            let plain = formula.nodes.iter().all(|n| n.draw().is_none() && !matches!(n, Node::BuiltIn(..)));
            let world = Rc::clone(&self.world);
            if plain
                && let Ok(Value::Rotation(value) | Value::Vector(value)) = scratch.evaluate_with(formula, &world, self)
                && value.0.iter().all(|c| c.known().is_some_and(f64::is_finite))
                && (pin.property != Pinned::Scale || value.0.iter().all(|c| c.known().is_some_and(|c| c > 0.0)))
            {
                found.insert((pin.owner, pin.property), (pin.constraint, value));
            }
        }
        // An orientation that is asserted is as good as one that is assigned.
        let asserted = self.program.constraints.iter().enumerate().filter(|(i, _)| self.usual.is_some() && counts(*i));
        for (index, constraint) in asserted.filter(|(_, c)| c.kind == ConstraintKind::Assert) {
            for (object, rot) in turned_to(&constraint.formula) {
                let rot = V3(rot.map(Term::constant));
                found.entry((Owner::Object(object), Pinned::Rot)).or_insert((index, rot));
            }
        }
        found
    }

    /// Three unknown angles; only their turns modulo 360 have a say anywhere.
    fn angles(&mut self, owner: Owner) -> V3<Term> {
        let rot = V3(std::array::from_fn(|_| turn()));
        self.owners.insert(rot.0, owner);
        rot
    }

    /// What is always true of an unknown orientation: its axes are unit vectors, across each other, by rows too.
    pub fn orientation(&mut self, id: ObjectId) {
        let Some(thing) = &self.world.objects[id.0 as usize] else { return };
        let axes = thing.axes.0.map(|axis| axis.0);
        if axes.iter().flatten().all(|c| c.known().is_some()) {
            return;
        }
        if axes[1][1].known() == Some(1.0) {
            // Upright: a circle, and the square around which it lies.
            let (c, s) = (axes[0][0], axes[2][0]);
            self.equal(c * c + s * s, Term::constant(1.0));
            let sum = c.abs() + s.abs();
            self.always.push(sum.at_least(1.0 - EXACT));
            self.always.push((-sum).at_least(-std::f64::consts::SQRT_2 - EXACT));
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
        self.turned.insert(id);
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

    /// The directions between which claims know angles, by numbers, the contrary of an even one the next; with those
    /// angles, and the right angles between the axes of an object. Of upright things whose turns are read, an angle is no
    /// more than the turns differ by, one way round or the other.
    pub fn directions(&mut self, objects: &BTreeSet<ObjectId>) -> Vec<([usize; 2], Term)> {
        if self.angles.is_empty() {
            return Vec::new();
        }
        let mut known: Vec<([Term; 3], usize)> = Vec::new();
        let mut number = |v: V3<Term>| {
            let first = v.0.iter().find(|c| c.known() != Some(0.0));
            let (v, contrary) = if first.is_some_and(|c| c.is_contrary()) { (-v, 1) } else { (v, 0) };
            let found = known.iter().find(|(k, _)| *k == v.0).map(|(_, n)| *n);
            let at = found.unwrap_or_else(|| {
                known.push((v.0, 2 * known.len()));
                2 * (known.len() - 1)
            });
            at + contrary
        };
        let mut edges: Vec<([usize; 2], Term)> = Vec::new();
        for ([p, q], angle) in self.angles.clone() {
            edges.push(([number(p), number(q)], angle));
        }
        let mut turns: FxHashMap<usize, (Term, bool)> = FxHashMap::default();
        for &id in objects {
            let thing = self.thing(id);
            let axes = thing.axes.0.map(&mut number);
            for [i, k] in [[0, 1], [0, 2], [1, 2]] {
                edges.push(([axes[i], axes[k]], Term::constant(90.0)));
            }
            let is_level = [0, 2].iter().all(|i| thing.rot.0[*i].known() == Some(0.0));
            if is_level && thing.axes.0[1].0[1].known() == Some(1.0) {
                let ahead = thing.rot.0[1];
                let is_read = ahead.known().is_some() || self.turned.contains(&id);
                for (axis, quarters) in [(axes[2], 0.0), (axes[0], 1.0), (axes[2] ^ 1, 2.0), (axes[0] ^ 1, 3.0)] {
                    turns.insert(axis, (ahead + Term::constant(90.0 * quarters), is_read));
                }
            }
        }
        let fixed: Vec<(V3<Term>, usize)> =
            known.iter().filter(|(v, _)| v.iter().all(|c| c.known().is_some())).map(|(v, n)| (V3(*v), *n)).collect();
        for (i, (p, a)) in fixed.iter().enumerate() {
            edges.extend(fixed[..i].iter().map(|(q, b)| ([*a, *b], p.angle(*q))));
        }
        for ([p, q], angle) in &edges[..self.angles.len()] {
            let (Some((p, reads_p)), Some((q, reads_q))) = (turns.get(p), turns.get(q)) else { continue };
            // It is what they differ by, the shorter way round: of turns that an assignment makes large, not all ways are here.
            let is_near = *reads_p && *reads_q && range(*p - *q).magnitude() < 900.0;
            let ways = [-720.0, -360.0, 0.0, 360.0, 720.0].map(|whole| (*p - *q + Term::constant(whole)).abs());
            self.always.extend(ways.map(|apart| (apart - *angle).at_least(-1e-6)));
            if let Some(shortest) = ways.into_iter().reduce(Term::min).filter(|_| is_near) {
                self.always.push((*angle - shortest).at_least(-1e-6));
            }
        }
        edges
    }

    pub fn thing(&self, id: ObjectId) -> ObjectInstance<Term> {
        self.world.objects[id.0 as usize].clone().expect("every object that is spoken of is there")
    }

    /// The same, if it is spoken of.
    pub fn thing_spoken_of(&self, id: ObjectId) -> Option<ObjectInstance<Term>> {
        self.world.objects[id.0 as usize].clone()
    }

    pub fn room(&self, id: RegionId) -> RegionInstance<Term> {
        self.world.regions[id.0 as usize].clone().expect("every region is there")
    }

    /// A box that is solid for sure: that of the object, or a part of it about its middle axis.
    pub fn solid_of(&self, id: ObjectId) -> Option<ObjectInstance<Term>> {
        let thing = self.thing(id);
        if is_box(self.program, &self.options, id) {
            return Some(thing);
        }
        if !self.usual.is_some_and(|usual| usual.shapes && usual.upright[id.0 as usize]) {
            return None;
        }
        let [Some(w), Some(h), Some(d)] = thing.scale.0.map(Term::known) else { return None };
        let ([w, d], [from, to]) = core_of(&self.program.objects[id.0 as usize], [w, h, d])?;
        let mut pos = thing.pos;
        pos.0[1] = pos.0[1] + Term::constant(from);
        Some(ObjectInstance { pos, scale: V3([w, to - from, d].map(Term::constant)), ..thing })
    }

    /// Whether a region's walls are along the axes of the world.
    pub fn is_straight(&self, id: RegionId) -> bool {
        self.yaws[id.0 as usize].map(Term::known) == [Some(1.0), Some(0.0)]
    }

    /// The height of an object's support surface.
    pub fn surface(&mut self, id: ObjectId) -> Term {
        let (surface, new) = self.term(format!("surface {id:?}"), Interval::new(-LARGEST * 4.0, LARGEST * 4.0));
        if new {
            // A surface that an asset declares is one of its own: somewhere from its base to its top.
            let thing = self.thing(id);
            let (center, reach) = (thing.center().0[1], thing.reach().0[1]);
            let (height, program) = (thing.scale.0[1], self.program);
            let least = match self.usual {
                Some(usual) if !usual.shapes => Term::constant(0.0),
                Some(_) if carries_on_top(&program.objects[id.0 as usize]) => height,
                Some(_) => height.scale(LOWEST_SURFACE),
                None => Term::constant(0.0),
            };
            self.always.push((surface - (center - reach) - least).at_least(-EXACT));
            self.always.push((center + reach - surface).at_least(-EXACT));
        }
        surface
    }

    /// The height of an object's support surface, if it is spoken of.
    pub fn surface_known(&self, id: ObjectId) -> Option<Term> {
        self.terms.get(&format!("surface {id:?}")).copied()
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
        self.wall_distances_of(&self.thing(object), object, region)
    }

    /// The same of a box that is turned as an object is.
    pub fn wall_distances_of(&mut self, thing: &ObjectInstance<Term>, object: ObjectId, region: RegionId) -> [Term; 2] {
        let room = self.room(region);
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

    /// Some point of the solid of an object: it is in its box.
    pub fn point_of(&mut self, id: ObjectId) -> V3<Term> {
        if let Some(known) = self.points.get(&id) {
            return *known;
        }
        let (thing, point) = (self.thing(id), place());
        let (center, reach) = (thing.center(), thing.reach());
        for i in 0..3 {
            let off = (point.0[i] - center.0[i]).abs();
            self.always.push((reach.0[i] - off).at_least(-OUT_OF_BOX));
        }
        self.points.insert(id, point);
        point
    }

    /// Whether a measure is spoken of.
    pub fn knows(&self, name: &str) -> bool {
        self.terms.contains_key(name)
    }

    /// All regions.
    pub fn regions(&self) -> Vec<RegionId> {
        (0..self.program.regions.len() as u32).map(RegionId).collect()
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

    /// One of several values: between the least and the greatest of them. The same choice among the same known numbers is
    /// one measure.
    fn choice(&mut self, draw: DrawId, list: &[NodeId], values: &Values<Term>) -> Result<Value<Term>, EvalError> {
        let all = list.iter().map(|id| values[id.0 as usize]).collect::<Result<Vec<_>, _>>()?;
        let numbers: Option<Vec<Term>> =
            all.iter().map(|value| if let Value::Number(n) = value { Some(*n) } else { None }).collect();
        Ok(match (all[0], numbers) {
            (_, Some(numbers)) => {
                let around =
                    numbers.iter().map(|n| range(*n)).reduce(|a, b| Interval::new(a.lo.min(b.lo), a.hi.max(b.hi)));
                let around = around.unwrap_or(Interval::ALL);
                match numbers.iter().map(|n| n.known()).collect::<Option<Vec<f64>>>() {
                    Some(known) => Value::Number(self.term(format!("choice {draw:?} {known:?}"), around).0),
                    None => Value::Number(unknown(around)),
                }
            }
            (Value::Vector(_), _) => Value::Vector(place()),
            (Value::Rotation(_), _) => Value::Rotation(V3(std::array::from_fn(|_| turn()))),
            _ => Value::Truth(claimed(open())),
        })
    }

    /// The axes of a rotation: of an object, or of an angle that is known.
    fn axes_of(&self, rot: V3<Term>) -> Option<M3<Term>> {
        match self.owners.get(&rot.0) {
            Some(Owner::Object(id)) => Some(self.thing(*id).axes),
            Some(Owner::Region(_)) => None,
            None => [0, 2].iter().all(|i| rot.0[*i].known().is_some()).then(|| M3::rotation(rot)),
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
            Node::Object(ObjectProperty::Surface, object) => Value::Number(self.surface(*object)),
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
            Node::Choice(draw, list) => self.choice(*draw, list, values)?,
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

/// What a formula says at its top level of orientations: that they are the same as one of numbers (degrees).
fn turned_to(formula: &Formula) -> Vec<(ObjectId, [f64; 3])> {
    let number = |id: NodeId| match formula.node(id) {
        Node::Number(n) => Some(*n),
        Node::Neg(of) => match formula.node(*of) {
            Node::Number(n) => Some(-n),
            _ => None,
        },
        _ => None,
    };
    let (mut open, mut found) = (vec![formula.root], Vec::new());
    while let Some(id) = open.pop() {
        match formula.node(id) {
            Node::And(parts) => open.extend(parts.iter().copied()),
            Node::Same(a, b) => {
                for (a, b) in [(a, b), (b, a)] {
                    if let (Node::Object(ObjectProperty::Rot, object), Node::Rotation([x, y, z])) =
                        (formula.node(*a), formula.node(*b))
                        && let (Some(x), Some(y), Some(z)) = (number(*x), number(*y), number(*z))
                    {
                        found.push((*object, [x, y, z]));
                    }
                }
            }
            _ => {}
        }
    }
    found
}

/// Whether the solid of an object is its box for sure: it is asked to be, or nothing says what kind of thing it is.
pub(crate) fn is_box(program: &Program, options: &Options, object: ObjectId) -> bool {
    let object = &program.objects[object.0 as usize];
    options.geometry == Geometry::Box || object.category.is_empty() && furniture_size(&object.name).is_none()
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
