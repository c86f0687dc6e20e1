//! Some statements of a program, and the physical rules about what they speak of, as claims about unknowns.

use super::beside::MOST_PAIRED;
use super::companies::{Company, companies, insides};
use super::conjuncts::{Part, parts};
use super::loosened::{Loosened, truth};
use super::packing::{Between, Core, Member, PackingRegion};
use super::problem::{Problem, reached};
use super::tape::{Claim, Tape, Term, all, any, implies, look, open};
use super::unknowns::{OUT_OF_BOX, Unknowns, is_box};
use super::usual::Usual;
use crate::builtins::{collides_in_proofs, declared, gap_is_in_proofs, path_past_in_proofs, region_in_proofs};
use crate::eval::{Scratch, Value};
use crate::number::{Algebra, Logic};
use crate::rules::{Scope, Support};
use crate::tolerances::Options;
use crate::vector::{M3, V3};
use crate::world::{ObjectInstance, World};
use rustc_hash::FxHashMap;
use scenelang_lang::program::{
    Arg, BuiltIn, Comparison, Formula, Function, Node, NodeId, ObjectId, ObjectProperty, Program, RegionId,
};
use std::collections::BTreeSet;
use std::rc::Rc;

/// Something that is taken as given.
#[derive(Clone, Debug)]
pub(super) struct Given {
    pub claim: Claim,
    pub what: GivenSource,
    /// Statements that its meaning rests on, beside what it says: orientations, rectangles.
    pub premises: Vec<usize>,
    /// Which part of the statement it is.
    pub part: usize,
}

/// Where something given comes from.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum GivenSource {
    /// An index into the constraints of the program.
    Statement(usize),
    /// The contrary of a statement, to see whether the others imply it.
    Contrary(usize),
    /// A physical rule, in words.
    Rule(String),
}

/// Claims, and the tape that they are on.
pub(super) struct ClaimModel {
    pub tape: Tape,
    /// What holds in every instance.
    pub always: Vec<Claim>,
    /// Those of them that linear reasoning leaves out.
    pub curved: Vec<Claim>,
    pub given: Vec<Given>,
    pub groups: Vec<PackingRegion<Term>>,
    /// Angles between directions, each by its number; the contrary of an even one is the next.
    pub angles: Vec<([usize; 2], Term)>,
    /// Ways between the middles of objects over their surfaces.
    pub spans: Vec<([ObjectId; 2], Term)>,
    /// Names of unknowns, where they are wanted.
    pub names: FxHashMap<Term, String>,
}

/// Which physical rules count.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Rules {
    None,
    /// That things stay in regions.
    Bounds,
    All,
}

/// What a model is made of.
#[derive(Clone, Copy)]
pub(super) struct Choice<'a> {
    /// Statements that hold, sorted.
    pub statements: &'a [usize],
    /// One that does not.
    pub contrary: Option<usize>,
    /// Which physical rules count.
    pub rules: Rules,
    /// What is taken for granted, if anything is.
    pub usual: Option<&'a Usual>,
    /// What is asked for less strictly than the program does.
    pub loosened: Option<Loosened>,
}

/// What all models of one program share, whichever of its statements count: it takes a look at every object.
pub(super) struct Common<'a> {
    pub program: &'a Program,
    pub options: &'a Options,
    /// Which rules apply to what, whatever the assets are made of.
    pub scope: Scope,
    /// Instances that lack everything, of unknowns and of floats.
    blank: Rc<World<Term>>,
    pub nowhere: World<f64>,
}

impl<'a> Common<'a> {
    pub fn new(program: &'a Program, options: &'a Options) -> Self {
        Self {
            program,
            options,
            scope: Scope::new(&World::<f64>::nowhere(program, options)),
            blank: Rc::new(World::nowhere(program, options)),
            nowhere: World::nowhere(program, &Options::default()),
        }
    }
}

/// Boxes in one region between which every order is looked at, at most.
const CLOSE_COMPANY: usize = 8;
/// Of a statement about more objects than this it is not looked at what they see of each other.
const MOST_SEEN: usize = 6;
/// Of more objects than this in a region, those are left out that may overlap others.
const CROWD: usize = 400;
/// The sine of how far boxes may be turned off the axes to be looked at so: what the tolerance of `rot = …` leaves open.
const SKEW: f64 = 0.0018;

impl ClaimModel {
    /// With the names of its unknowns if it is to be told about.
    pub fn new(common: &Common<'_>, choice: Choice<'_>, named: bool) -> Self {
        let mut tape = Tape::new();
        let model = tape.record(|| Self::noted(common, choice, named));
        Self { tape, ..model }
    }

    /// The same, without the tape that is written meanwhile.
    fn noted(common: &Common<'_>, choice: Choice<'_>, named: bool) -> Self {
        let Common { program, options, scope, .. } = common;
        let counts = |statement: usize| choice.statements.binary_search(&statement).is_ok();
        let formulas = choice.statements.iter().chain(&choice.contrary).map(|s| &program.constraints[*s].formula);
        let objects: BTreeSet<ObjectId> = formulas.flat_map(Formula::objects).collect();
        let mut unknowns = Unknowns::new(program, &common.blank, choice.usual, &counts, &objects);
        if let Some(Loosened::Size { region, axis, to }) = choice.loosened {
            unknowns.resize(region, axis, to);
        }
        let mut builder = Builder { program, options, scope, given: Vec::new(), objects, loosened: choice.loosened };
        for &statement in choice.statements {
            builder.statement(&mut unknowns, statement, false);
        }
        if let Some(statement) = choice.contrary {
            builder.statement(&mut unknowns, statement, true);
        }
        builder.spaces(&mut unknowns);
        builder.paths(&mut unknowns);
        let mut groups = Vec::new();
        if choice.rules != Rules::None && options.physics {
            builder.bounds(&mut unknowns, choice.statements);
        }
        if choice.rules == Rules::All && options.physics {
            builder.collisions(&mut unknowns);
            if let Some(usual) = choice.usual {
                builder.grounded(&mut unknowns, usual);
                builder.middles(&mut unknowns);
            }
            builder.sights(&mut unknowns);
            groups = builder.groups(&mut unknowns, companies(common, choice.usual, choice.statements));
        }
        builder.seen_lengths(&mut unknowns, choice.statements);
        unknowns.shared_frames(&builder.objects);
        let angles = unknowns.directions(&builder.objects);
        builder.frames(&mut unknowns, &groups);
        let names = if named { unknowns.names() } else { FxHashMap::default() };
        let (always, curved, spans) = (unknowns.always, unknowns.curved, unknowns.spans);
        Self { tape: Tape::default(), always, curved, given: builder.given, groups, angles, spans, names }
    }

    /// As equations.
    pub fn problem(&self) -> Problem {
        let roots: Vec<Claim> = self.always.iter().copied().chain(self.given.iter().map(|g| g.claim)).collect();
        let mut wanted = wanted(&self.groups);
        wanted.extend(self.angles.iter().map(|(_, angle)| *angle));
        wanted.extend(self.spans.iter().map(|(_, span)| *span));
        Problem::new(&self.tape, &roots, &wanted, &self.curved)
    }
}

fn wanted(groups: &[PackingRegion<Term>]) -> Vec<Term> {
    let core = |c: &Core<Term>| [c.size[0], c.size[1], c.bottom, c.top];
    let member = |m: &Member<Term>| {
        let own = [m.bottom, m.top, m.up].into_iter().chain(m.size).chain(m.at).chain(m.turn);
        own.chain(m.core.iter().flat_map(core)).collect::<Vec<_>>()
    };
    let group = |g: &PackingRegion<Term>| {
        let own = g.size.into_iter().chain(g.at).chain(g.between.iter().map(|b| b.length));
        let own = own.chain(g.fronts.iter().map(|(_, angle)| *angle));
        let pairs = g.pairs.iter().flat_map(|(_, off)| *off);
        own.chain(pairs).chain(g.members.iter().flat_map(member)).collect::<Vec<_>>()
    };
    groups.iter().flat_map(group).collect()
}

struct Builder<'a> {
    program: &'a Program,
    options: &'a Options,
    scope: &'a Scope,
    given: Vec<Given>,
    /// The objects that are spoken of.
    objects: BTreeSet<ObjectId>,
    loosened: Option<Loosened>,
}

impl Builder<'_> {
    fn statement(&mut self, unknowns: &mut Unknowns<'_>, index: usize, contrary: bool) {
        let formula = &self.program.constraints[index].formula;
        let objects = formula.objects();
        // Spaces and ways are in some region.
        let looks = |n: &Node| matches!(n, Node::BuiltIn(BuiltIn::Clear | BuiltIn::Reachable, _));
        let regions = if formula.nodes.iter().any(looks) { unknowns.regions() } else { regions_of(formula) };
        let mut premises = rests(unknowns, &objects, &regions);
        if formula.nodes.iter().any(|n| matches!(n, Node::BuiltIn(BuiltIn::Reachable, _))) {
            // A path may lead through any door.
            let doors: Vec<ObjectId> = unknowns.world.allow.doors.iter().map(|door| door.object).collect();
            premises.extend(rests(unknowns, &doors, &[]));
        }
        if !infinite_ones_are_compared(formula) {
            return;
        }
        if self.loosened.is_some_and(|l| l.replaces(self.program, index)) {
            return;
        }
        let altered = self.loosened.and_then(|l| l.altered(formula, index));
        let formula = altered.as_ref().unwrap_or(formula);
        let world = Rc::clone(&unknowns.world);
        let mut scratch = Scratch::new();
        let claim = match scratch.evaluate_with(formula, &world, unknowns) {
            Ok(Value::Truth(truth)) => truth.holds,
            // It has no value in any layout; that is told where a layout is judged.
            _ => return,
        };
        for (id, node) in formula.nodes.iter().enumerate() {
            let Node::Call(Function::Angle, args) = node else { continue };
            let [p, q, angle] = [args[0], args[1], NodeId(id as u32)].map(|n| scratch.value(n));
            if let (Ok(Value::Vector(p)), Ok(Value::Vector(q)), Ok(Value::Number(angle))) = (p, q, angle) {
                unknowns.angles.push(([p, q], angle));
            }
        }
        unknowns.sighted(formula, &scratch);
        for object in objects_of_angles(formula) {
            unknowns.angles_turn_axes(object);
        }
        if contrary {
            self.given.push(Given { claim: claim.negated(), what: GivenSource::Contrary(index), premises, part: 0 });
            return;
        }
        let loosened = self.loosened.filter(|l| l.statement() == Some(index));
        for (part, Part { nodes, .. }) in parts(formula).into_iter().enumerate() {
            let holds = |id: &NodeId| match loosened {
                Some(loosened) => loosened.claim(formula, &scratch, *id),
                None => truth(&scratch, *id),
            };
            // What has no value is not needed: something before it does not hold.
            let claim = nodes.iter().map(holds).collect::<Option<Vec<Claim>>>().map_or(claim, |own| all(&own));
            self.given.push(Given { claim, what: GivenSource::Statement(index), premises: premises.clone(), part });
        }
    }

    fn name(&self, object: ObjectId) -> &str {
        &self.program.objects[object.0 as usize].name
    }

    /// P-BOUNDS of what is spoken of: one of the regions holds it.
    fn bounds(&mut self, unknowns: &mut Unknowns<'_>, statements: &[usize]) {
        let regions: Vec<RegionId> = (0..self.program.regions.len() as u32).map(RegionId).collect();
        if regions.is_empty() {
            return;
        }
        let scope = self.scope;
        // What is said to be in a region is in one.
        let said: BTreeSet<ObjectId> =
            statements.iter().flat_map(|s| insides(&self.program.constraints[*s].formula)).map(|(_, o)| o).collect();
        let speaks = |o: &&ObjectId| scope.bounds(**o) && !said.contains(o);
        for &object in self.objects.clone().iter().filter(speaks) {
            let holds: Vec<Claim> = regions.iter().map(|r| region_in_proofs(unknowns, object, *r)).collect();
            let premises = rests(unknowns, &[object], &regions);
            let name = self.name(object);
            let what = GivenSource::Rule(match regions.as_slice() {
                [one] => format!("P-BOUNDS keeps `{name}` in `{}`", self.program.regions[one.0 as usize].name),
                _ => format!("P-BOUNDS keeps `{name}` in a region"),
            });
            self.given.push(Given { claim: any(&holds), what, premises, part: 0 });
        }
    }

    /// P-COLLIDE of pairs whose gap is spoken of. The rule is that they do not collide: the rounding that its verdict
    /// allows beyond that is no room to build in.
    fn collisions(&mut self, unknowns: &mut Unknowns<'_>) {
        let scope = self.scope;
        let objects: Vec<ObjectId> = self.objects.iter().copied().collect();
        for (i, &a) in objects.iter().enumerate() {
            for &b in &objects[i + 1..] {
                if !gap_is_in_proofs(unknowns, a, b) || !scope.collide(a, b) {
                    continue;
                }
                let claim = collides_in_proofs(unknowns, a, b).negated();
                let what =
                    GivenSource::Rule(format!("P-COLLIDE keeps `{}` and `{}` apart", self.name(a), self.name(b)));
                self.given.push(Given { claim, what, premises: rests(unknowns, &[a, b], &[]), part: 0 });
            }
        }
    }

    /// Spaces that are said to be free: boxes that are spoken of are not in them.
    fn spaces(&mut self, unknowns: &mut Unknowns<'_>) {
        for (free, owner, space) in std::mem::take(&mut unknowns.spaces) {
            for &other in self.objects.iter().filter(|o| **o != owner) {
                let Some(solid) = unknowns.solid_of(other) else { continue };
                let mut apart = unknowns.apart_along_axes([&space, &solid], SKEW);
                if let Some(square) = square_in(&solid) {
                    apart = all(&[apart, unknowns.apart_along_axes([&space, &square], SKEW)]);
                }
                let (of, name) = (self.name(owner), self.name(other));
                let what = GivenSource::Rule(format!("`{name}` is not in the free space beside `{of}`"));
                let premises = rests(unknowns, &[owner, other], &[]);
                self.given.push(Given { claim: implies(free, apart), what, premises, part: 0 });
            }
        }
    }

    /// Paths that are said to be there: they lead past what stands in the room.
    fn paths(&mut self, unknowns: &mut Unknowns<'_>) {
        let doors: Vec<ObjectId> = unknowns.world.allow.doors.iter().map(|door| door.object).collect();
        for (open, ends, width) in std::mem::take(&mut unknowns.paths) {
            for &other in self.objects.clone().iter().filter(|o| !ends.contains(o)) {
                let [from, to, name] = [ends[0], ends[1], other].map(|id| self.name(id));
                let what = format!("`{name}` is in the way from `{from}` to `{to}`");
                let spoken: Vec<ObjectId> = ends.iter().chain(&doors).copied().chain([other]).collect();
                let premises = rests(unknowns, &spoken, &unknowns.regions());
                for past in path_past_in_proofs(unknowns, ends, width, other) {
                    let (claim, what) = (implies(open, past), GivenSource::Rule(what.clone()));
                    self.given.push(Given { claim, what, premises: premises.clone(), part: 0 });
                }
            }
        }
    }

    /// Where things are taken as usual: no thing's middle is in the solid of another of which a claim says that it is over
    /// or under it.
    fn middles(&mut self, unknowns: &mut Unknowns<'_>) {
        let scope = self.scope;
        let contact = Term::constant(self.options.tolerances.contact + 2.0 * self.options.tolerances.order);
        let objects: Vec<ObjectId> = self.objects.iter().copied().collect();
        if objects.len() > CROWD {
            return;
        }
        for (&a, &b) in objects.iter().flat_map(|a| objects.iter().map(move |b| (a, b))) {
            if a == b {
                continue;
            }
            let (thing, other) = (unknowns.thing(a), unknowns.thing(b));
            let between = thing.center() - other.center();
            let before = look(|tape| tape.ops.len());
            let off = [0, 2].map(|axis| between.dot(other.axes.0[axis]).abs());
            // What is new is in nobody's claim.
            if off.iter().any(|t| t.0 as usize >= before) {
                continue;
            }
            // What is over or under the other is no farther from its middle, along the axes of the world, than it reaches.
            let reach = other.reach();
            let within = [0, 1].map(|i| (other.scale.0[2 * i].scale(0.5) - off[i]).at_least(-1e-5));
            let near = [0, 2].map(|i| (reach.0[i] - between.0[i].abs()).at_least(-1e-4));
            if other.axes.0[1].0[1].known() == Some(1.0) {
                unknowns.always.push(implies(all(&within), all(&near)));
            }
            if !scope.collide(a, b) {
                continue;
            }
            let solids = [a, b].map(|o| unknowns.solid_of(o));
            let [Some(own), Some(other)] = solids else { continue };
            // A square in the disc in its footprint, turned as the other is.
            let square = own.scale.0[0].min(own.scale.0[2]).scale(0.35);
            let heights = |t: &ObjectInstance<Term>| [t.pos.0[1], t.pos.0[1] + t.scale.0[1]];
            let ([low, high], [bottom, top]) = (heights(&own), heights(&other));
            let mut ways = vec![(low - top + contact).at_least(0.0), (bottom - high + contact).at_least(0.0)];
            for (off, axis) in off.into_iter().zip([0, 2]) {
                ways.push((off - other.scale.0[axis].scale(0.5) - square + contact).at_least(0.0));
            }
            let what = GivenSource::Rule(format!("P-COLLIDE keeps `{}` and `{}` apart", self.name(a), self.name(b)));
            self.given.push(Given { claim: any(&ways), what, premises: rests(unknowns, &[a, b], &[]), part: 0 });
        }
    }

    /// P-COLLIDE of things of which one faces the other.
    fn sights(&mut self, unknowns: &mut Unknowns<'_>) {
        let contact = self.options.tolerances.contact + 2.0 * self.options.tolerances.order;
        for sight in unknowns.sights.clone() {
            let [a, b] = sight.0;
            let apart = if self.scope.collide(a, b) { unknowns.apart_in_sight(sight, contact) } else { None };
            if let Some(claim) = apart {
                let what =
                    GivenSource::Rule(format!("P-COLLIDE keeps `{}` and `{}` apart", self.name(a), self.name(b)));
                self.given.push(Given { claim, what, premises: rests(unknowns, &[a, b], &[]), part: 0 });
            }
        }
    }

    /// Distances in terms of what things see of each other, where a statement says what one sees of the other.
    fn seen_lengths(&self, unknowns: &mut Unknowns<'_>, statements: &[usize]) {
        let mut pairs: BTreeSet<(ObjectId, ObjectId)> = BTreeSet::new();
        for formula in statements.iter().map(|s| &self.program.constraints[*s].formula) {
            let sees = |node: &Node| match node {
                Node::Object(ObjectProperty::Front | ObjectProperty::Right, id) => Some(*id),
                _ => None,
            };
            let objects = formula.objects();
            if objects.len() <= MOST_SEEN {
                let by: BTreeSet<ObjectId> = formula.nodes.iter().filter_map(sees).collect();
                pairs.extend(by.iter().flat_map(|b| objects.iter().filter(move |a| *a != b).map(|a| (*a, *b))));
            }
        }
        pairs.into_iter().for_each(|(a, b)| unknowns.seen_lengths(a, b));
    }

    /// Where things are taken as usual: each stands on a floor, or on something that the program compares its base with.
    fn grounded(&mut self, unknowns: &mut Unknowns<'_>, usual: &Usual) {
        let scope = self.scope;
        let regions: Vec<RegionId> = (0..self.program.regions.len() as u32).map(RegionId).collect();
        let off = self.options.tolerances.support + OUT_OF_BOX;
        for &id in &self.objects.clone() {
            let Some(carriers) = &usual.carriers[id.0 as usize] else { continue };
            if scope.support(id) != Support::Rests || !carriers.iter().all(|c| self.objects.contains(c)) {
                continue;
            }
            let thing = unknowns.thing(id);
            let bottom = (thing.center() - thing.reach()).0[1];
            let mut heights: Vec<Term> = regions.iter().map(|r| unknowns.room(*r).pos.0[1]).collect();
            if regions.is_empty() || !scope.bounds(id) {
                heights.push(Term::constant(0.0));
            }
            heights.sort_by_key(|t| t.0);
            heights.dedup();
            let rests_on = |h: &Term| all(&[(bottom - *h).at_least(-off), (*h - bottom).at_least(-off)]);
            let mut ways: Vec<Claim> = heights.iter().map(rests_on).collect();
            // A carrier may have boards below its top.
            ways.extend(carriers.iter().map(|c| {
                let carrier = unknowns.thing(*c);
                let [base, top] =
                    [carrier.center() - carrier.reach(), carrier.center() + carrier.reach()].map(|p| p.0[1]);
                all(&[(bottom - base).at_least(-off), (top - bottom).at_least(-off)])
            }));
            let claim = any(&ways);
            let what = GivenSource::Rule(format!("`{}` stands on the floor", self.name(id)));
            let spoken: Vec<ObjectId> = carriers.iter().copied().chain([id]).collect();
            self.given.push(Given { claim, what, premises: rests(unknowns, &spoken, &regions), part: 0 });
        }
    }

    /// Boxes of known size that are said to be in one region, for each rectangular region of known size.
    fn groups(&mut self, unknowns: &mut Unknowns<'_>, companies: Vec<Company>) -> Vec<PackingRegion<Term>> {
        let scope = self.scope;
        let mut groups = Vec::new();
        let mut apart = None;
        let mut spoken = Vec::new();
        for Company { region, objects, full } in companies {
            let apart = *apart.get_or_insert_with(open);
            if full && objects.len() <= CLOSE_COMPANY {
                let whole: Vec<ObjectId> =
                    objects.iter().copied().filter(|o| is_box(self.program, self.options, *o)).collect();
                for (i, &a) in whole.iter().enumerate() {
                    for &b in whole[i + 1..].iter().filter(|b| scope.collide(a, **b)) {
                        let orders = unknowns.beside(a, b, SKEW);
                        unknowns.always.push(implies(apart, orders));
                    }
                }
                spoken.extend(whole);
            }
            // Of a crowd only those count that keep clear of everything: to list who may overlap whom would take long.
            let objects = if objects.len() > CROWD {
                let excepted = scope.excepted();
                objects.into_iter().filter(|o| !excepted.contains(o)).collect()
            } else {
                objects
            };
            let pairs: Vec<(usize, usize)> = if objects.len() > CROWD {
                Vec::new()
            } else {
                (0..objects.len()).flat_map(|i| (i + 1..objects.len()).map(move |k| (i, k))).collect()
            };
            let overlap = |(i, k): &(usize, usize)| !scope.collide(objects[*i], objects[*k]);
            let excepted = pairs.iter().copied().filter(overlap).collect();
            let between =
                pairs.iter().flat_map(|&pair| unknowns.between(pair, objects[pair.0], objects[pair.1])).collect();
            let members: Vec<Member<Term>> =
                objects.iter().map(|o| unknowns.member(self.program, self.options, *o, region)).collect();
            // That it is inside goes without saying only where all is pinned.
            let known = std::iter::zip(&objects, &members).filter(|(_, m)| m.inside == Claim::TRUE);
            spoken.extend(known.map(|(o, _)| *o));
            let room = unknowns.room(region);
            let near = if objects.len() > MOST_PAIRED { &[][..] } else { &pairs };
            let offsets = near.iter().map(|&(i, k)| {
                let between = unknowns.thing(objects[i]).center() - unknowns.thing(objects[k]).center();
                ((i, k), [between.0[0], between.0[2]])
            });
            let pairs = offsets.collect();
            let fronts = unknowns.fronts(&objects);
            groups.push(PackingRegion {
                pairs,
                fronts,
                size: room.scale.0,
                at: [room.pos.0[0], room.pos.0[2]],
                straight: unknowns.is_straight(region),
                between,
                members,
                excepted,
                apart,
            });
        }
        if let Some(claim) = apart {
            let what = GivenSource::Rule("P-COLLIDE keeps boxes from overlapping".to_owned());
            let regions: Vec<RegionId> = (0..self.program.regions.len() as u32).map(RegionId).collect();
            let premises = if spoken.is_empty() { Vec::new() } else { rests(unknowns, &spoken, &regions) };
            self.given.push(Given { claim, what, premises, part: 0 });
        }
        groups
    }

    /// What is always true of the orientations that claims came to speak of.
    fn frames(&mut self, unknowns: &mut Unknowns<'_>, groups: &[PackingRegion<Term>]) {
        let roots: Vec<Claim> = unknowns.always.iter().copied().chain(self.given.iter().map(|g| g.claim)).collect();
        let (_, terms) = look(|tape| reached(tape, &roots, &wanted(groups)));
        let is_reached = |term: &Term| terms.get(term.0 as usize).copied().unwrap_or(false);
        for &id in &self.objects {
            if unknowns.axes(id).iter().any(is_reached) {
                unknowns.orientation(id);
            }
        }
        for index in 0..self.program.regions.len() {
            unknowns.yaw(RegionId(index as u32));
        }
    }
}

/// A box along the axes of the world in an upright one of which the turn is not known: a square in the disc in it.
fn square_in(thing: &ObjectInstance<Term>) -> Option<ObjectInstance<Term>> {
    let is_upright = thing.axes.0[1].0[1].known() == Some(1.0);
    let side = thing.scale.0[0].min(thing.scale.0[2]).scale(0.707);
    let is_turned = thing.axes.0[0].0.iter().any(|c| c.known().is_none());
    let axes = M3([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(|axis| V3(axis.map(Term::constant))));
    let scale = V3([side, thing.scale.0[1], side]);
    (is_upright && is_turned).then(|| ObjectInstance { axes, scale, ..thing.clone() })
}

/// Statements that what is known of objects and regions rests on, whatever is said of them.
fn rests(unknowns: &Unknowns<'_>, objects: &[ObjectId], regions: &[RegionId]) -> Vec<usize> {
    let of_objects = objects.iter().filter_map(|o| unknowns.rests.get(o));
    of_objects.chain(regions.iter().filter_map(|r| unknowns.framed.get(r))).flatten().copied().collect()
}

pub(super) fn regions_of(formula: &Formula) -> Vec<RegionId> {
    let mut out = Vec::new();
    for node in &formula.nodes {
        match node {
            Node::Region(_, id) | Node::SamePolygon(id, _) => out.push(*id),
            Node::BuiltIn(_, args) => {
                out.extend(args.iter().filter_map(|a| if let Arg::Region(id) = a { Some(*id) } else { None }));
            }
            _ => {}
        }
    }
    out.sort_unstable();
    out.dedup();
    out
}

/// Objects of which a component of the rotation is read.
fn objects_of_angles(formula: &Formula) -> Vec<ObjectId> {
    let of = |node: &Node| match node {
        Node::Component(_, of) => match formula.node(*of) {
            Node::Object(ObjectProperty::Rot, id) => Some(*id),
            _ => None,
        },
        _ => None,
    };
    let mut out: Vec<ObjectId> = formula.nodes.iter().filter_map(of).collect();
    out.sort_unstable();
    out.dedup();
    out
}

/// Some measures may be infinite, as a walk is where no way leads. Reasoning knows finite numbers only, and takes a long
/// one instead; that is the same wherever such a measure is compared, by order, with something that has none in it.
fn infinite_ones_are_compared(formula: &Formula) -> bool {
    let mut infinite = vec![false; formula.nodes.len()];
    for (index, node) in formula.nodes.iter().enumerate() {
        let mut own = false;
        node.for_each_child(|child| own |= infinite[child.0 as usize]);
        let may_be = |node: &Node| matches!(node, Node::BuiltIn(built_in, _) if declared(*built_in).may_be_infinite);
        match node {
            node if may_be(node) => infinite[index] = true,
            Node::Compare(op, _, a, b) => {
                let ordered = !matches!(op, Comparison::Eq | Comparison::Ne);
                let both = infinite[a.0 as usize] && infinite[b.0 as usize];
                if own && (!ordered || both || !(may_be(formula.node(*a)) || may_be(formula.node(*b)))) {
                    return false;
                }
            }
            _ => infinite[index] = own,
        }
    }
    true
}

impl Unknowns<'_> {
    /// The components of an object's axes.
    fn axes(&self, id: ObjectId) -> Vec<Term> {
        let thing = self.world.objects[id.0 as usize].as_ref();
        thing.map_or(Vec::new(), |t| t.axes.0.iter().flat_map(|v| v.0).collect())
    }

    fn member(&mut self, program: &Program, options: &Options, id: ObjectId, region: RegionId) -> Member<Term> {
        let inside = region_in_proofs(self, id, region);
        let thing = self.thing(id);
        let (center, reach) = (thing.center(), thing.reach());
        let (bottom, top) = (center.0[1] - reach.0[1], center.0[1] + reach.0[1]);
        let size = thing.scale.0;
        let whole = is_box(program, options, id);
        let core = self.solid_of(id).map(|solid| {
            let bottom = if whole { bottom } else { solid.pos.0[1] };
            let top = if whole { top } else { solid.pos.0[1] + solid.scale.0[1] };
            Core { size: [solid.scale.0[0], solid.scale.0[2]], bottom, top }
        });
        let at = [center.0[0], center.0[2]];
        let turn = [thing.axes.0[0].0[0], thing.axes.0[2].0[0]];
        Member { object: id, inside, size, bottom, top, whole, core, up: thing.axes.0[1].0[1], at, turn }
    }

    /// The distances between two members of a group that claims speak of.
    fn between(&mut self, pair: (usize, usize), a: ObjectId, b: ObjectId) -> Vec<Between<Term>> {
        let mut found = Vec::new();
        if gap_is_in_proofs(self, a, b) {
            found.push(Between { pair, length: crate::builtins::gap_in_proofs(self, a, b), of_centres: false });
        }
        for (a, b) in [(a, b), (b, a)] {
            let (x, y) = (self.thing(a).center(), self.thing(b).center());
            let before = look(|tape| tape.ops.len());
            let length = (x - y).length();
            // A new one is in nobody's claim.
            if (length.0 as usize) < before {
                found.push(Between { pair, length, of_centres: true });
            }
        }
        found
    }

    /// If both boxes stand along the axes of the world, up to `skew`, they are apart along one of these.
    ///
    /// Each holds a box along the axes whose extents are less than its own by `skew` times the other two; these are apart
    /// along an axis, since boxes along the axes are (or overlap along each by more than the two overlap). And how far a
    /// box reaches along an axis is at most its extent there and `skew` times the others.
    fn beside(&mut self, a: ObjectId, b: ObjectId, skew: f64) -> Claim {
        self.apart_along_axes([&self.thing(a), &self.thing(b)], skew)
    }

    /// The same of two boxes.
    fn apart_along_axes(&self, things: [&ObjectInstance<Term>; 2], skew: f64) -> Claim {
        let along = |claims: &mut Vec<Claim>, c: Term| {
            claims.push(any(&[
                all(&[c.at_least(-skew), (-c).at_least(-skew)]),
                c.at_least(1.0 - skew),
                (-c).at_least(1.0 - skew),
            ]));
        };
        let mut straight = Vec::new();
        for thing in things {
            thing.axes.0.iter().flat_map(|v| v.0).for_each(|c| along(&mut straight, c));
        }
        let tolerances = &self.options.tolerances;
        let contact = Term::constant(tolerances.contact + 2.0 * tolerances.order);
        let [x, y] = things;
        let extents = |t: &ObjectInstance<Term>| t.scale.0[0] + t.scale.0[1] + t.scale.0[2];
        let slack = (extents(x) + extents(y)).scale(skew) + contact;
        let (between, reach) = (x.center() - y.center(), x.reach() + y.reach());
        let ways: Vec<Claim> = (0..3)
            .flat_map(|i| [between.0[i], -between.0[i]].map(|d| (d - reach.0[i] + slack).at_least(0.0)))
            .collect();
        implies(all(&straight), any(&ways))
    }

    /// Names of unknowns, for people.
    fn names(&self) -> FxHashMap<Term, String> {
        let mut out = FxHashMap::default();
        let mut note = |terms: [Term; 3], name: String| {
            for (term, axis) in terms.into_iter().zip(["x", "y", "z"]) {
                out.insert(term, format!("{name}.{axis}"));
            }
        };
        let objects = self.program_objects().zip(&self.world.objects);
        for (object, thing) in objects.filter_map(|(name, thing)| Some((name, thing.as_ref()?))) {
            note(thing.pos.0, format!("{object}.pos"));
            note(thing.scale.0, format!("{object}.scale"));
            note(thing.rot.0, format!("{object}.rot"));
            for (axis, name) in thing.axes.0.iter().zip(["right", "up", "front"]) {
                note(axis.0, format!("{object}.{name}"));
            }
        }
        for (region, room) in self.program_regions().zip(self.world.regions.iter().flatten()) {
            note(room.pos.0, format!("{region}.pos"));
            note(room.scale.0, format!("{region}.scale"));
            note(room.rot.0, format!("{region}.rot"));
        }
        for (index, object) in self.program_objects().enumerate() {
            if let Some(surface) = self.surface_known(ObjectId(index as u32)) {
                out.insert(surface, format!("{object}.surface"));
            }
        }
        for (variable, value) in self.program_variables().zip(&self.world.variables) {
            match value {
                Ok(Value::Number(n)) => drop(out.insert(*n, variable.to_owned())),
                Ok(Value::Vector(v) | Value::Rotation(v)) => {
                    for (term, axis) in v.0.into_iter().zip(["x", "y", "z"]) {
                        out.insert(term, format!("{variable}.{axis}"));
                    }
                }
                _ => {}
            }
        }
        out
    }
}
