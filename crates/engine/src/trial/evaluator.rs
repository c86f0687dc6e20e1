//! Truths that have no code: judged by the evaluator itself, on an instance that follows the layout. A term pays for
//! its own truths of this kind, and the rest of the program goes on as code.
//!
//! A path over the floor takes thousands of times as long as anything else. A term that asks for one beside other things
//! counts it as there until all else holds, and only then has it looked for.

use super::lean::Lean;
use super::swing;
use super::{Clear, Judge, Moved, Span, Trial};
use crate::Mirror;
use crate::penalty::{Penalty, Truths};
use crate::pose::Pose;
use scenelang_lang::program::{Formula, Node, NodeId, ObjectId, Unit, VariableId};
use scenelang_layout::Vec3;
use scenelang_verify::coded::{Coded, Slots, atoms};
use scenelang_verify::{Scratch, Surroundings, Truth, Value, World, cone, surroundings};
use std::marker::PhantomData;

/// What a look for a path over the floor takes.
const PATH: u64 = 150_000;
/// Of several paths over one floor each takes such a part of that.
const SHARED: u64 = 20;
/// What a sweep of the movable parts of a thing takes.
const SWING: u64 = 10_000;
/// More room than this before what opens is as good as this (metres).
pub(super) const CLEARANCE: f64 = 0.01;
/// Objects without a place wait this far below everything, each on a level of its own (metres).
const LIMBO: f64 = -1e5;
/// How a truth without code is judged.
#[derive(Clone, Debug)]
pub(super) enum Leaf {
    /// By the evaluator; these nodes are needed.
    Evaluated(Vec<NodeId>),
    /// As what opens of an object, on boxes.
    Swing(usize),
    /// As free space beside a thing, on boxes.
    Space(Clear),
    /// By the evaluator, but only once all else holds; until then this is taken for granted.
    Path(Vec<NodeId>, bool),
}

/// What a term looks at beside its own objects.
#[derive(Clone, Copy, Debug)]
pub(super) enum Dependence {
    /// The space beside a thing.
    Space(Clear),
    /// What the movable parts of a thing reach.
    Swing(usize),
    /// The line of sight between two things.
    Sight(usize, usize),
}

/// A term of which some truths have no code.
#[derive(Clone, Debug)]
pub struct Mixed {
    code: Coded,
    leaves: Vec<(NodeId, Leaf)>,
    /// `None`: everything.
    looks: Option<Vec<Dependence>>,
    /// What judging it takes.
    price: u64,
}

impl Mixed {
    pub(super) fn new(
        formula: &Formula,
        code: Coded,
        missing: &[NodeId],
        clear: impl Fn(&Node, &Formula) -> Option<Clear>,
        has_panels: impl Fn(usize) -> bool,
        objects: usize,
    ) -> Self {
        let mut looks = Some(Vec::new());
        let mut price = 3 + code.steps() as u64 / 8;
        let leaf = |&node: &NodeId| {
            if let Some(clear) = clear(formula.node(node), formula) {
                price += 4 + objects as u64 / 8;
                looks.iter_mut().for_each(|l| l.push(Dependence::Space(clear)));
                return (node, Leaf::Space(clear));
            }
            let nodes = cone(formula, node);
            let around: Vec<Surroundings> = nodes.iter().map(|n| surroundings(formula, formula.node(*n))).collect();
            if around.iter().any(Surroundings::is_path) {
                return (node, Leaf::Path(nodes, true));
            }
            price += 10 + nodes.len() as u64;
            let mut swings = 0;
            for seen in around {
                match seen {
                    Surroundings::Nothing | Surroundings::Path { .. } => {}
                    Surroundings::Sight { from, to } => {
                        price += objects as u64;
                        looks.iter_mut().for_each(|l| l.push(Dependence::Sight(from.0 as usize, to.0 as usize)));
                    }
                    Surroundings::Swing { owner } => {
                        swings += 1;
                        looks.iter_mut().for_each(|l| l.push(Dependence::Swing(owner.0 as usize)));
                    }
                    Surroundings::Space { .. } => {
                        price += 8 * objects as u64;
                        looks = None;
                    }
                }
            }
            match swing::opens(formula, node).filter(|owner| has_panels(*owner)) {
                Some(owner) => (node, Leaf::Swing(owner)),
                None => {
                    price += SWING * swings;
                    (node, Leaf::Evaluated(nodes))
                }
            }
        };
        let leaves = missing.iter().map(leaf).collect();
        Self { code, leaves, looks, price }
    }

    /// One of which nothing is code.
    pub fn whole(formula: &Formula, objects: usize) -> Self {
        Self::new(formula, Coded::default(), &atoms(formula), |_, _| None, |_| false, objects)
    }

    /// Whether some of it is judged on boxes.
    pub fn is_rough(&self) -> bool {
        self.leaves.iter().any(|(_, leaf)| matches!(leaf, Leaf::Swing(_) | Leaf::Space(_)))
    }

    /// Whether it asks for paths.
    pub fn walks(&self) -> bool {
        self.leaves.iter().any(|(_, leaf)| matches!(leaf, Leaf::Path(..)))
    }

    /// Whether it can change though none of its objects moves.
    pub fn looks_around(&self) -> bool {
        self.looks.as_ref().is_none_or(|looks| !looks.is_empty())
    }
}

/// The instance that follows the layout.
pub(super) struct Instance {
    mirror: Mirror<f64>,
    scratch: Scratch<f64>,
    truths: Vec<(NodeId, Truth<f64>)>,
}

impl Instance {
    pub fn new(mut world: World<f64>) -> Self {
        world.options.detail.clearance = CLEARANCE;
        let all: Vec<ObjectId> = world.bodies().map(|(id, _)| id).collect();
        let mut mirror = Mirror::new(world);
        all.into_iter().for_each(|id| mirror.moved(id));
        Self { mirror, scratch: Scratch::new(), truths: Vec::new() }
    }

    /// The instance, as it was when it was last brought up to date.
    pub fn world(&self) -> &World<f64> {
        self.mirror.world()
    }

    /// A decision variable has changed.
    pub fn set_variable(&mut self, id: VariableId, value: Value<f64>) {
        self.mirror.set_variable(id, value);
    }

    /// An object has moved.
    pub fn moved(&mut self, i: usize) {
        self.mirror.moved(ObjectId(i as u32));
    }
}

/// Truths of code that has run, and those that were found otherwise.
pub(super) struct KnownTruths<'r> {
    code: &'r Coded,
    slots: &'r Slots,
    others: &'r [(NodeId, Truth<f64>)],
}

impl Truths<f64> for KnownTruths<'_> {
    fn truth(&self, node: NodeId) -> Option<Truth<f64>> {
        let other = self.others.iter().find(|(n, _)| *n == node).map(|(_, truth)| *truth);
        other.or_else(|| self.code.truth(node, self.slots))
    }
}

impl Trial<'_> {
    /// Brings the instance up to date.
    pub(super) fn follow(&mut self) {
        let Self { instance, slots, away, scale, leans, .. } = self;
        instance.mirror.follow(|id| {
            let i = id.0 as usize;
            let [x, y, z, yaw, ..] = slots.get(id);
            let waits = Vec3::new(0.0, LIMBO * (1.0 + 0.01 * i as f64), 0.0);
            let pos = if away[i] { waits } else { Vec3::new(x, y, z) };
            let [tilt, roll] = leans[i].as_ref().map_or([0.0; 2], Lean::angles);
            Some(Pose { pos, rot: Vec3::new(tilt, yaw, roll), scale: Vec3::from(scale[i]) })
        });
    }

    /// From now on a term is asked of the evaluator.
    pub(super) fn ask_evaluator(&mut self, t: usize) {
        let mixed = Mixed::whole(&self.frame.terms[t].formula, self.count());
        if mixed.looks_around() && !self.onlookers.contains(&t) {
            self.onlookers.push(t);
        }
        self.judges[t] = Judge::Mixed(mixed);
        self.begin_to_follow();
    }

    /// From now on the instance follows the layout.
    pub(super) fn begin_to_follow(&mut self) {
        if !std::mem::replace(&mut self.follows, true) {
            (0..self.count()).for_each(|i| self.instance.moved(i));
        }
    }

    /// Whether a term that asks for paths holds, by the evaluator.
    pub(super) fn evaluate_path(&mut self, t: usize) -> bool {
        self.work += PATH;
        let formula = &self.frame.terms[t].formula;
        matches!(self.instance.scratch.evaluate(formula, self.instance.mirror.world()), Ok(Value::Truth(truth)) if truth.holds)
    }

    /// What a term costs of which some truths have no code, and whether it holds.
    pub(super) fn mixed(&mut self, t: usize) -> (f64, bool) {
        let mut found = (0.0, true);
        self.mixed_with(t, |penalty| found = penalty.both());
        found
    }

    /// Judges such a term, and asks something of what came of it.
    pub(super) fn mixed_with(&mut self, t: usize, ask: impl FnOnce(&Penalty<'_, f64, KnownTruths<'_>>)) {
        let judge = std::mem::replace(&mut self.judges[t], Judge::Absent);
        if let Judge::Mixed(mixed) = &judge {
            let formula = &self.frame.terms[t].formula;
            self.work += mixed.price;
            let mut truths = std::mem::take(&mut self.instance.truths);
            truths.clear();
            for (node, leaf) in &mixed.leaves {
                truths.extend(self.truth_of(formula, leaf).map(|truth| (*node, truth)));
            }
            mixed.code.run(&mut self.slots);
            let values = KnownTruths { code: &mixed.code, slots: &self.slots, others: &truths };
            ask(&Penalty { formula, values: &values, tolerances: &self.tolerances, numbers: PhantomData });
            self.instance.truths = truths;
        }
        self.judges[t] = judge;
    }

    /// A truth that has no code; `None`: nothing can be measured.
    fn truth_of(&mut self, formula: &Formula, leaf: &Leaf) -> Option<Truth<f64>> {
        match leaf {
            Leaf::Path(_, holds) => Some(Truth::discrete(*holds)),
            Leaf::Space(clear) => {
                let (cost, holds) = self.lack_of_space(clear);
                let margin = if holds { self.tolerances.contact } else { -cost };
                Some(Truth { margin, holds, unit: Unit::Metre })
            }
            Leaf::Swing(owner) => Some(self.panels_open(*owner)),
            Leaf::Evaluated(nodes) => self.evaluated(formula, nodes),
        }
    }

    fn evaluated(&mut self, formula: &Formula, nodes: &[NodeId]) -> Option<Truth<f64>> {
        self.follow();
        let instance = &mut self.instance;
        match instance.scratch.evaluate_cone(formula, nodes, instance.mirror.world()) {
            Ok(Value::Truth(truth)) => Some(truth),
            _ => None,
        }
    }

    /// Whether something that moved may change what a term sees.
    pub(super) fn is_seen(&self, t: usize, moved: &[Moved]) -> bool {
        let meets = |space: Span| moved.iter().any(|(m, _, old)| space.meets(old) || space.meets(&self.span[*m]));
        match &self.judges[t] {
            Judge::Clear(clear) => self.space_span(clear).is_some_and(meets),
            Judge::Mixed(Mixed { looks: Some(looks), .. }) => {
                looks.iter().filter_map(|look| self.span_of(look)).any(meets)
            }
            Judge::Mixed(_) => true,
            _ => false,
        }
    }

    fn span_of(&self, look: &Dependence) -> Option<Span> {
        match look {
            Dependence::Space(clear) => self.space_span(clear),
            Dependence::Swing(i) => self.swing_span(*i),
            Dependence::Sight(a, b) => {
                // A little more than the segment between the centres: what comes nearer than the tolerance counts.
                let ends = [*a, *b].map(|i| {
                    let [x, y, z, ..] = self.inputs(i);
                    [x, y + self.size[i][1] / 2.0, z]
                });
                let contact = 2.0 * self.tolerances.contact;
                let end = |k: usize, pick: fn(f64, f64) -> f64| pick(ends[0][k], ends[1][k]);
                Some(Span {
                    min: std::array::from_fn(|k| end(k, f64::min) - contact),
                    max: std::array::from_fn(|k| end(k, f64::max) + contact),
                })
            }
        }
    }

    /// Takes all paths for granted.
    pub fn trust_paths(&mut self) {
        for at in 0..self.path_terms.len() {
            if let Judge::Mixed(mixed) = &mut self.judges[self.path_terms[at]] {
                for (_, leaf) in &mut mixed.leaves {
                    if let Leaf::Path(_, holds) = leaf {
                        *holds = true;
                    }
                }
            }
        }
    }

    /// Looks for the paths that terms ask for beside other things. Whether all of these terms hold that must.
    pub fn find_paths(&mut self, late: &dyn Fn() -> bool) -> bool {
        let mut all = true;
        for at in 0..self.path_terms.len() {
            if late() {
                return false;
            }
            let term = self.path_terms[at];
            let found = self.find_paths_of(term);
            all &= found || !self.is_demanded(term) && !self.frame.terms[term].is_hard();
        }
        all
    }

    /// The same of one term. Where it holds without them they are not looked for.
    pub fn find_paths_of(&mut self, t: usize) -> bool {
        self.assume(t, |_| false);
        let mut found = self.mixed(t);
        if !found.1 {
            self.work += PATH;
            self.follow();
            let formula = &self.frame.terms[t].formula;
            let instance = &mut self.instance;
            let mut holds = Vec::new();
            if let Judge::Mixed(mixed) = &self.judges[t] {
                for (_, leaf) in &mixed.leaves {
                    if let Leaf::Path(nodes, _) = leaf {
                        let truth = instance.scratch.evaluate_cone(formula, nodes, instance.mirror.world());
                        holds.push(matches!(truth, Ok(Value::Truth(truth)) if truth.holds));
                    }
                }
            }
            self.assume(t, |at| holds[at]);
            found = self.mixed(t);
        } else {
            // It may come to need them when something moves.
            self.assume(t, |_| true);
        }
        self.set(t, found.0, found.1);
        found.1
    }

    /// Calls something while the paths that preferences ask for are those that there are.
    pub fn with_paths<T>(&mut self, ask: impl FnOnce(&Self) -> T) -> T {
        let before = self.work;
        for at in 0..self.path_preferences.len() {
            self.find_paths_of(self.path_preferences[at]);
        }
        // The floor is the same for all of them.
        self.work = before + (self.work - before).min(PATH) + (self.work - before) / SHARED;
        let found = ask(self);
        for at in 0..self.path_preferences.len() {
            let t = self.path_preferences[at];
            self.assume(t, |_| true);
            let (cost, holds) = self.mixed(t);
            self.set(t, cost, holds);
        }
        found
    }

    fn assume(&mut self, t: usize, says: impl Fn(usize) -> bool) {
        let Judge::Mixed(mixed) = &mut self.judges[t] else { return };
        let paths =
            mixed.leaves.iter_mut().filter_map(|(_, leaf)| if let Leaf::Path(_, h) = leaf { Some(h) } else { None });
        paths.enumerate().for_each(|(at, holds)| *holds = says(at));
    }
}
