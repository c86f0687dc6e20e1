//! Zones that are left: what is not to be inside one goes out of it as a whole, though it is not inside as soon as a leg is out.

use super::search::{Move, MoveSearch};
use super::stage::Stage;
use crate::Pose;
use crate::rows::Goal;
use scenelang_lang::program::{Node, ObjectId, RegionId};
use scenelang_layout::planar::{depth_in_convex, edges};
use scenelang_layout::{Prism, Vec2, inside_clearance};

/// How far one goes to get out (metres), and in what steps.
const FARTHEST: f64 = 4.0;
const STEP: f64 = 0.01;
/// What overlaps by less than this is out (metres), and to this it is brought.
const OUT: f64 = 0.01;
const APART: f64 = 1e-6;

impl Stage<'_> {
    /// The zones that goals speak of, in which an object is as the layout has it.
    fn zones_of(&self, goals: &[Goal], object: ObjectId) -> Vec<RegionId> {
        let Some(home) = self.home(object) else { return Vec::new() };
        let mut found: Vec<RegionId> = Vec::new();
        for (_, formula, from) in goals.iter().filter_map(|goal| self.formula(*goal)) {
            for id in scenelang_verify::cone(formula, from) {
                let Node::BuiltIn(built_in, args) = formula.node(id) else { continue };
                found.extend(built_in.contained(args).filter(|(own, _)| *own == object).map(|(_, region)| region));
            }
        }
        found.sort_unstable();
        found.dedup();
        let tolerance = self.world().options.tolerances.contact;
        let holds = |prism: &Prism| inside_clearance(&home.obb(), prism).least() >= -tolerance;
        found.retain(|id| self.world().prisms().any(|(other, prism)| other == *id && holds(prism)));
        found
    }

    /// Of the zones in which an object was, those that it has left in part, as things are on the stage.
    fn left_in_part(&self, zones: &[RegionId], object: ObjectId, by: f64) -> bool {
        let Some(pose) = self.pose(object) else { return false };
        let tolerance = self.world().options.tolerances.contact;
        let mut prisms = self.world().prisms().filter(|(id, _)| zones.contains(id));
        prisms.any(|(_, prism)| inside_clearance(&pose.obb(), prism).least() < -tolerance && overlaps(&pose, prism, by))
    }

    /// How many of the objects that were moved stand half in a zone that they were to leave.
    pub fn half_out(&self, moved: &[ObjectId], goals: &[Goal]) -> usize {
        let half = |id: &&ObjectId| {
            let zones = self.zones_of(goals, **id);
            !zones.is_empty() && self.left_in_part(&zones, **id, OUT)
        };
        moved.iter().filter(half).count()
    }
}

impl MoveSearch<'_, '_> {
    /// A move that goes on in its direction until the object is out of the zone that it leaves.
    pub(super) fn wholly_out(&mut self, m: Move) -> Option<Move> {
        let long = m[0].hypot(m[2]);
        if self.dear || long < APART {
            return None;
        }
        let zones = self.stage.zones_of(&self.goals, self.from.object);
        if zones.is_empty() {
            return None;
        }
        self.put(&m);
        if !self.stage.left_in_part(&zones, self.from.object, APART) {
            return None;
        }
        let count = (FARTHEST / STEP) as usize;
        let at = |i: usize| {
            let by = STEP * i as f64 / long;
            [m[0] + m[0] * by, m[1], m[2] + m[2] * by, m[3]]
        };
        let out = (1..count).map(at).find(|further| {
            self.put(further);
            !self.stage.left_in_part(&zones, self.from.object, APART)
        })?;
        self.holds(&out).then_some(out)
    }
}

/// Whether the footprint of an object and a region have more than an edge in common.
fn overlaps(pose: &Pose, prism: &Prism, by: f64) -> bool {
    let footprint = pose.obb().footprint();
    let within = |p: &Vec2| prism.polygon.clearance_of_point(*p).value > by;
    let middle = pose.center();
    let points = edges(&footprint).flat_map(|(a, b)| [a, (a + b) / 2.0]).chain([Vec2::new(middle.x, middle.z)]);
    points.into_iter().any(|p| within(&p))
        || prism.polygon.corners().iter().any(|corner| depth_in_convex(&footprint, *corner) > by)
}
