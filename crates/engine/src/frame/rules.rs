//! Rules: what the program fixes of an object, given everything else. Its pins, and equations used as assignments.
//!
//! A search that moves a table need not find out that its chairs have to follow: an equation such as
//! `chair.pos.x = table.pos.x + 0.4` is obeyed, not searched for. So rows and grids move as one.

use crate::Reads;
use rustc_hash::FxHashSet;
use scenelang_lang::Program;
use scenelang_lang::program::{Formula, ObjectId, Owner, Pinned, RegionId, VariableId};
use scenelang_verify::vector::V3;
use scenelang_verify::{Number, Value, World, evaluate};

/// What a rule sets.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Sets {
    /// The position: the formula's value.
    Pos,
    /// The rotation: the formula's value.
    Rot,
    /// The yaw: the formula's value.
    Yaw,
    /// The extents: the formula's value.
    Scale,
    /// One coordinate: the formula's value, which changes by so much per metre, becomes 0.
    Axis(usize, f64),
    /// The position: the formula's value, a vector that changes by so much per metre, becomes 0.
    Shift(f64),
}

/// Sets something of an object, given everything else.
#[derive(Clone, Debug)]
pub struct Rule {
    /// Whose.
    pub owner: ObjectId,
    pub sets: Sets,
    /// By which value.
    pub formula: Formula,
    /// What it depends on, the owner itself not counted.
    pub reads: Reads,
}

/// Which properties of an object are set by rules.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Fixed {
    /// Coordinates.
    pub pos: [bool; 3],
    /// The rotation (of an equation: at least the yaw).
    pub rot: bool,
    /// The extents.
    pub scale: bool,
}

impl Fixed {
    /// Whether nothing is left to choose about where it is and how it is turned.
    pub fn is_all(&self) -> bool {
        self.rot && self.pos == [true; 3]
    }
}

impl Rule {
    pub fn new(owner: ObjectId, sets: Sets, formula: Formula) -> Self {
        let mut reads = Reads::of(&formula);
        reads.objects.retain(|o| *o != owner);
        Self { owner, sets, formula, reads }
    }

    /// The owner's position, rotation and extents as the rule wants them; `None` where it has no value.
    pub fn apply<N: Number>(&self, world: &World<N>) -> Option<[V3<N>; 3]> {
        let thing = world.object(self.owner).ok()?;
        let (mut pos, mut rot, mut scale) = (thing.pos, thing.rot, thing.scale);
        match (self.sets, evaluate(&self.formula, world).ok()?) {
            (Sets::Pos, Value::Vector(v)) => pos = v,
            (Sets::Rot, Value::Rotation(v)) => rot = v,
            (Sets::Scale, Value::Vector(v)) => scale = v,
            (Sets::Yaw, Value::Number(n)) => rot.0[1] = n.wrap(),
            (Sets::Axis(axis, per), Value::Number(n)) => pos.0[axis] = pos.0[axis] - n.scale(1.0 / per),
            (Sets::Shift(per), Value::Vector(v)) => pos = pos - v.map(|c| c.scale(1.0 / per)),
            _ => return None,
        }
        Some([pos, rot, scale])
    }

    fn marks(&self, fixed: &mut Fixed) {
        match self.sets {
            Sets::Pos | Sets::Shift(_) => fixed.pos = [true; 3],
            Sets::Axis(axis, _) => fixed.pos[axis] = true,
            Sets::Rot | Sets::Yaw => fixed.rot = true,
            Sets::Scale => fixed.scale = true,
        }
    }
}

/// The pins of objects as rules. Those of regions are obeyed before the search.
pub fn pins(program: &Program) -> Vec<Rule> {
    let of_object = program.pins.iter().filter_map(|pin| {
        let (Owner::Object(id), Some(formula)) = (pin.owner, pin.values.first()) else { return None };
        let sets = match pin.property {
            Pinned::Pos => Sets::Pos,
            Pinned::Rot => Sets::Rot,
            Pinned::Scale => Sets::Scale,
            Pinned::Vertices => return None,
        };
        Some(Rule::new(id, sets, formula.clone()))
    });
    of_object.collect()
}

/// Something that a rule can read.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum RuleSource {
    Object(ObjectId),
    Region(RegionId),
    /// A decision variable.
    Variable(VariableId),
}

/// Rules in an order in which each comes after those that it depends on.
pub struct Rules {
    pub list: Vec<Rule>,
    /// By object.
    pub fixed: Vec<Fixed>,
    /// By object: its own rules.
    pub own: Vec<Vec<usize>>,
}

impl Rules {
    /// Puts rules in order.
    pub fn new(rules: Vec<Rule>, objects: usize) -> Self {
        let mut own: Vec<Vec<usize>> = vec![Vec::new(); objects];
        rules.iter().enumerate().for_each(|(i, r)| own[r.owner.0 as usize].push(i));
        // Depth first, without recursion. A circle of properties is an error of the front end; one of owners only (a.rot
        // reads b.pos, b.pos reads a.scale) is broken where it closes.
        let mut order: Vec<usize> = Vec::with_capacity(rules.len());
        let mut state = vec![0u8; rules.len()];
        for start in 0..rules.len() {
            let mut stack = vec![(start, false)];
            while let Some((rule, done)) = stack.pop() {
                if done {
                    order.push(rule);
                } else if state[rule] == 0 {
                    state[rule] = 1;
                    stack.push((rule, true));
                    let before = rules[rule].reads.objects.iter().flat_map(|o| &own[o.0 as usize]);
                    // What turns an object comes before what shifts it by its own corners.
                    let same = own[rules[rule].owner.0 as usize].iter();
                    let same = same.filter(|&&r| rank(&rules[r]) < rank(&rules[rule]));
                    stack.extend(before.chain(same).filter(|&&b| state[b] == 0).map(|&b| (b, false)));
                }
            }
        }
        let mut slots: Vec<Option<Rule>> = rules.into_iter().map(Some).collect();
        let list: Vec<Rule> = order.iter().filter_map(|&i| slots[i].take()).collect();
        let mut fixed = vec![Fixed::default(); objects];
        let mut own = vec![Vec::new(); objects];
        for (index, rule) in list.iter().enumerate() {
            rule.marks(&mut fixed[rule.owner.0 as usize]);
            own[rule.owner.0 as usize].push(index);
        }
        Self { list, fixed, own }
    }

    /// Rules that must be obeyed again when something changes, in order.
    pub fn after(&self, start: RuleSource) -> Vec<usize> {
        let mut changed: FxHashSet<RuleSource> = FxHashSet::default();
        changed.insert(start);
        let mut found = Vec::new();
        for (index, rule) in self.list.iter().enumerate() {
            let reads = &rule.reads;
            let objects = reads.objects.iter().map(|o| RuleSource::Object(*o));
            let regions = reads.regions.iter().map(|r| RuleSource::Region(*r));
            let mut all = objects.chain(regions).chain(reads.variables.iter().map(|v| RuleSource::Variable(*v)));
            // An object's own move may upset a coordinate that is set in relation to the rest of it.
            let relative = matches!(rule.sets, Sets::Axis(..) | Sets::Shift(_));
            if relative && changed.contains(&RuleSource::Object(rule.owner)) || all.any(|s| changed.contains(&s)) {
                changed.insert(RuleSource::Object(rule.owner));
                found.push(index);
            }
        }
        found
    }

    /// Whether an object's place depends on another one's.
    pub fn depends(&self, object: ObjectId, on: ObjectId) -> bool {
        let mut open = vec![object];
        let mut seen: FxHashSet<ObjectId> = FxHashSet::default();
        while let Some(next) = open.pop() {
            if next == on {
                return true;
            }
            if seen.insert(next) {
                open.extend(self.own[next.0 as usize].iter().flat_map(|&r| self.list[r].reads.objects.iter().copied()));
            }
        }
        false
    }

    /// Objects that an object's rules read.
    pub fn sources(&self, id: ObjectId) -> Vec<ObjectId> {
        let mut list: Vec<ObjectId> =
            self.own[id.0 as usize].iter().flat_map(|&r| self.list[r].reads.objects.iter().copied()).collect();
        list.sort_unstable();
        list.dedup();
        list
    }
}

/// Sizes, then turns, then positions.
fn rank(rule: &Rule) -> u8 {
    match rule.sets {
        Sets::Scale => 0,
        Sets::Rot | Sets::Yaw => 1,
        _ => 2,
    }
}
