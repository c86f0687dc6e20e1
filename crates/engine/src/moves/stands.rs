//! What things stand on: a chair stands on the floor, and not on a desk, unless a statement says so.
//!
//! What a kind of thing stands on is known by its noun (`std/nouns.txt`). Small things stand on anything, and so does what
//! is far smaller than its kind: a lamp of 40 cm is no floor lamp.

use super::stage::Stage;
use crate::rows::{Goal, row_of};
use scenelang_lang::nouns::{self, Stands};
use scenelang_lang::program::{Axis, Formula, Node, NodeId, ObjectId, ObjectProperty, Program};
use scenelang_layout::Vec2;
use scenelang_verify::World;
use scenelang_verify::rules::{Support, support};

/// Roles of what may stand on anything, whatever its noun says.
const ANYWHERE: [&str; 4] = ["item", "device", "decor", "screen"];
/// Roles of what other things stand on, as they do on a floor.
const LIKE_FLOOR: [&str; 2] = ["carpet", "divider"];
/// What is lower than this is like a floor, too: a pallet, a mat (metres).
pub(super) const LOW: f64 = 0.25;
/// So many objects of goals are asked whether they are where they belong.
const SPOKEN_OF: usize = 6;
/// What is lower than this part of what its kind usually measures need not stand where its kind does.
const PART: f64 = 0.5;

/// Whether an object is of a kind that stands on the floor.
pub(super) fn is_floor_kind(program: &Program, id: ObjectId, height: f64) -> bool {
    let object = &program.objects[id.0 as usize];
    let Some(noun) = nouns::ending(&object.category) else { return false };
    let stands = matches!(noun.stands, Stands::Floor | Stands::Back);
    stands && !ANYWHERE.contains(&object.role.as_str()) && height >= PART * noun.size[1]
}

/// The height of the floor under a point: the highest that is not above it.
fn floor_below(world: &World<f64>, at: Vec2, lowest: f64) -> f64 {
    let tolerance = world.options.tolerances.support;
    let prisms = world.prisms().filter(|(_, prism)| prism.polygon.contains(at)).map(|(_, prism)| prism.floor);
    let floors = prisms.filter(|floor| *floor <= lowest + tolerance);
    floors.max_by(f64::total_cmp).unwrap_or(0.0)
}

impl Stage<'_> {
    /// Whether an object belongs on the floor: it is of a kind that stands there, and no statement speaks of its height.
    pub fn belongs_on_floor(&mut self, id: ObjectId) -> bool {
        if let Some(known) = self.grounded.get(&id) {
            return *known;
        }
        let height = self.home(id).map_or(0.0, |home| home.scale.y);
        let found = self.scope.support(id) == Support::Rests
            && is_floor_kind(self.program, id, height)
            && !self.index.of_object(id).iter().any(|&i| {
                let goal = Goal::Row(row_of(self.program, i));
                self.is_about_height(goal, id) || gives_height(&self.program.constraints[i].formula, id)
            });
        self.grounded.insert(id, found);
        found
    }

    /// Whether things stand on an object as they do on a floor.
    pub fn is_like_floor(&self, id: ObjectId) -> bool {
        LIKE_FLOOR.contains(&self.role(id)) || self.home(id).is_some_and(|home| home.scale.y < LOW)
    }

    /// How far what belongs on the floor is above it, if it is, with everything else as things are on the stage.
    pub fn drop_to_floor(&mut self, id: ObjectId) -> Option<f64> {
        if !self.belongs_on_floor(id) {
            return None;
        }
        if let Some(Some(carrier)) = self.carrier_before(id)
            && self.is_like_floor(carrier)
        {
            return None;
        }
        let body = &self.world().object(id).ok()?.body;
        let (lowest, center) = (body.lowest(), body.obb.center);
        let far = lowest - floor_below(self.world(), Vec2::new(center.x, center.z), lowest);
        (far > self.world().options.tolerances.support).then_some(far)
    }

    /// How many of the objects that goals speak of belong on the floor and are not there.
    pub fn misplaced(&mut self, goals: &[Goal]) -> usize {
        let mut objects = self.objects_of_all(goals);
        objects.truncate(SPOKEN_OF);
        objects.into_iter().filter(|id| self.drop_to_floor(*id).is_some()).count()
    }

    /// By how much an object is off what it rests on, within the tolerance: what makes it exact.
    pub fn off_rest(&self, id: ObjectId) -> Option<(f64, Option<ObjectId>)> {
        if self.scope.support(id) != Support::Rests {
            return None;
        }
        let rest = support::rest(self.world(), id, &self.around(id)).ok()?;
        rest.truth(&self.world().options.tolerances).holds.then_some((rest.nearest - rest.lowest, rest.carrier))
    }
}

/// Whether a statement compares the height of an object's place with something.
fn gives_height(formula: &Formula, object: ObjectId) -> bool {
    use ObjectProperty::{Center, Pos};
    let is_height = |node: &NodeId| match formula.node(*node) {
        Node::Component(Axis::Y, of) => matches!(formula.node(*of), Node::Object(Pos | Center, id) if *id == object),
        _ => false,
    };
    formula.nodes.iter().any(|node| match node {
        Node::Compare(_, _, a, b) => is_height(a) || is_height(b),
        _ => false,
    })
}
