//! What opens, on boxes: each movable part at some of its poses is a box, and what is near to one of these bars it. The sweep
//! between these poses, and the walls beside a room's door, are left to the evaluator, which has the last word; a term that
//! it sees differently is asked of it from then on.

use super::evaluator::CLEARANCE;
use super::{RoomBox, Span, Trial};
use scenelang_lang::program::{Formula, Node, NodeId, ObjectId, Unit};
use scenelang_layout::rotation::sin_cos;
use scenelang_layout::{Joint, Motion, Moving, Vec3, convex};
use scenelang_verify::coded::{Block, Flat};
use scenelang_verify::opening::gives_way;
use scenelang_verify::{Surroundings, Truth, World, surroundings};

/// A hinge is looked at in steps of at most so many degrees.
const STEP: f64 = 15.0;
/// An axis that is less than this off the vertical is upright.
const UPRIGHT: f64 = 1e-9;

/// What opens of an object, and which others may be in its way.
#[derive(Clone, Debug)]
pub(super) struct Reach {
    panels: Vec<Panel>,
    /// How far from its position anything of that comes (metres).
    far: f64,
    others: Vec<usize>,
}

/// A movable part at one of its poses: a box in the frame of its object, about whose vertical it may be turned.
#[derive(Clone, Debug)]
struct Panel {
    at: Vec3,
    turn: [f64; 2],
    block: [Block; 1],
}

impl Reach {
    /// By object; `None`: nothing of it opens.
    pub fn of_all(world: &World<f64>, count: usize) -> Vec<Option<Self>> {
        let id = |i: usize| ObjectId(i as u32);
        let of = |i: usize| {
            let body = &world.object(id(i)).ok()?.body;
            let all: Vec<(&Joint, Moving)> = std::iter::zip(body.joints(), body.moving_in_frame()).collect();
            let corner = |(joint, moving): &(&Joint, Moving)| {
                let around = moving.around(joint.limits[1]);
                around.min.abs().sup(&around.max.abs()).norm()
            };
            let far = all.iter().map(corner).reduce(f64::max)?;
            let panels = all.iter().flat_map(|(joint, moving)| panels(joint, moving)).collect();
            let others = (0..count).filter(|&j| !gives_way(world, id(i), id(j))).collect();
            Some(Self { panels, far, others })
        };
        (0..count).map(of).collect()
    }

    /// Whether something of it has to open that is judged on boxes.
    pub fn has_panels(&self) -> bool {
        !self.panels.is_empty()
    }
}

impl Panel {
    fn new(min: Vec3, max: Vec3) -> Self {
        let half = (max - min) / 2.0;
        Self { at: (min + max) / 2.0, turn: [0.0, 1.0], block: [Block::new([0.0; 3], half.into())] }
    }
    /// Where it is, for an object whose rectangle is this one.
    fn flat(&self, own: &Flat) -> Flat {
        let [sin, cos] = own.turn;
        let turn = [sin * self.turn[1] + cos * self.turn[0], cos * self.turn[1] - sin * self.turn[0]];
        let [half, _, deep] = self.block[0].half;
        Flat { at: own.point([self.at.x, self.at.z]), turn, half: [half, deep] }
    }
}

/// The poses of what a joint moves.
fn panels(joint: &Joint, moving: &Moving) -> Vec<Panel> {
    let Some(useful) = joint.useful.filter(|useful| *useful > 0.0) else { return Vec::new() };
    if joint.motion == Motion::Slide {
        let around = moving.around(useful);
        return vec![Panel::new(around.min, around.max)];
    }
    // After a full turn it is where it was, whatever a file says.
    let turn = useful.min(360.0);
    let steps = (turn / STEP).ceil();
    let upright = joint.axis.x.abs() + joint.axis.z.abs() < UPRIGHT * joint.axis.norm();
    let pose = |step: f64| {
        let angle = turn * step / steps;
        if !upright {
            let around = convex::aabb(&moving.opened(angle));
            return Panel::new(around.min, around.max);
        }
        let closed = convex::aabb(moving.bodies());
        let mut panel = Panel::new(closed.min, closed.max);
        let (sin, cos) = sin_cos(angle * joint.axis.y.signum());
        let hinge = Flat { at: [joint.anchor.x, joint.anchor.z], turn: [sin, cos], half: [0.0; 2] };
        [panel.at.x, panel.at.z] = hinge.point([panel.at.x - joint.anchor.x, panel.at.z - joint.anchor.z]);
        panel.turn = [sin, cos];
        panel
    };
    (1..=steps as usize).map(|step| pose(step as f64)).collect()
}

/// The object of which a truth says that all opens as far as is of use.
pub(super) fn opens(formula: &Formula, node: NodeId) -> Option<usize> {
    match (surroundings(formula, formula.node(node)), formula.node(node)) {
        (Surroundings::Swing { owner }, Node::BuiltIn(_, args)) if args.len() == 1 => Some(owner.0 as usize),
        _ => None,
    }
}

impl Trial<'_> {
    /// The upright box around everything that what opens of an object can reach.
    pub(super) fn swing_span(&self, i: usize) -> Option<Span> {
        let reach = self.reaches[i].as_ref()?;
        let [x, y, z, ..] = self.inputs(i);
        let at = [x, y, z];
        Some(Span { min: at.map(|c| c - reach.far), max: at.map(|c| c + reach.far) })
    }

    /// Whether all that opens of an object does, on boxes.
    pub(super) fn panels_open(&mut self, i: usize) -> Truth<f64> {
        let mut margin = CLEARANCE;
        if let (Some(reach), Some(around)) = (&self.reaches[i], self.swing_span(i)) {
            let bars = |&j: &usize| !self.away[j] && self.span[j].meets(&around) && !self.goes_along(j, i);
            let near: Vec<usize> = reach.others.iter().copied().filter(bars).collect();
            let (own, y) = (self.flat(i), self.inputs(i)[1]);
            let walls: Vec<&RoomBox> = match self.doors.contains(&i) {
                true => Vec::new(),
                false => self.rooms.iter().filter(|room| room.depth(own.at) >= 0.0).collect(),
            };
            for panel in &reach.panels {
                let (flat, middle) = (panel.flat(&own), y + panel.at.y);
                let span = flat_span(&flat, middle, panel.block[0].half[1]);
                for room in &walls {
                    margin = margin.min(room.aside(&span, || flat));
                }
                for &j in near.iter().filter(|&&j| self.span[j].meets(&span)) {
                    margin = margin.min(self.gap_of_blocks((j, &self.flat(j)), (&panel.block, &flat, middle)));
                }
            }
            self.work += (reach.panels.len() * (1 + near.len())) as u64;
        }
        let margin = margin + self.tolerances.contact;
        Truth { margin, holds: margin >= -self.tolerances.order, unit: Unit::Metre }
    }

    /// Whether something is in an object or stands on top of it, and so is moved by what opens rather than in its way.
    fn goes_along(&self, j: usize, i: usize) -> bool {
        let ([x, _, z, ..], own, span) = (self.inputs(j), &self.span[i], &self.span[j]);
        let middle = self.middle(j);
        let stands = (span.min[1] - own.max[1]).abs() <= self.tolerances.support;
        self.is_over(i, x, z) && (stands || own.min[1] < middle && middle < own.max[1])
    }
}

/// The upright box around a rectangle.
fn flat_span(flat: &Flat, middle: f64, half: f64) -> Span {
    let ([sin, cos], [w, d], [x, z]) = (flat.turn.map(f64::abs), flat.half, flat.at);
    let (rx, rz) = (cos * w + sin * d, sin * w + cos * d);
    Span { min: [x - rx, middle - half, z - rz], max: [x + rx, middle + half, z + rz] }
}
