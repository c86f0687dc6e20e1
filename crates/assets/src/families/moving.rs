//! What opens: hollow bodies, and the leaves, lids and drawers that close them.
//!
//! A leaf turns about the outer corner of its front, so that it stays within its own width until it is a quarter open: what
//! stands beside the furniture, or the wall it touches, is never in its way. All open towards +z.

use crate::block::Block;
use crate::mesh::Surface;
use crate::model::BuiltModel;
use scenelang_layout::{Joint, Motion, Vec3};

/// Where a leaf has its hinges, as the object sees its own left and right.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Hung {
    /// On the side of −x.
    Left,
    /// On the side of +x.
    Right,
    /// At its lower edge: it folds down.
    Below,
}

/// How far doors of furniture open (degrees), and how far it is of use.
const OPEN: [f64; 2] = [110.0, 90.0];
/// How far what folds down does.
const DOWN: f64 = 90.0;
/// How far a lid rises, and how far it is of use.
const UP: [f64; 2] = [95.0, 80.0];
/// How far a drawer comes out, as a share of its depth; and how far it is of use (metres at most).
const OUT: f64 = 0.8;
const REACH: f64 = 0.35;
/// More things than this do not open on one piece of furniture: it is absurdly large then, and solid.
pub(super) const MOST: usize = 12;
/// Up to so many drawers have a bottom, two sides and a back of their own; of more, what is behind the front is one block,
/// and of still more the front is part of it.
const BUILT: usize = 3;
const BLOCKS: usize = 7;

impl Block {
    /// Narrower on the side away from the hinges: the inner edge there goes round further than the leaf is wide, and must not
    /// meet what is beside it.
    fn beveled(self, hung: Hung) -> Self {
        const PLAY: f64 = 5e-4;
        let size = self.size();
        let wide = if hung == Hung::Below { size.y } else { size.x };
        let less = (wide.hypot(size.z) - wide + PLAY).min(0.3 * wide);
        match hung {
            Hung::Left => self.x(self.min.x..self.max.x - less),
            Hung::Right => self.x(self.min.x + less..self.max.x),
            Hung::Below => self.y(self.min.y..self.max.y - less),
        }
    }
}

impl BuiltModel {
    /// What was added last, `parts` parts, opens.
    fn joint(&mut self, name: &str, motion: Motion, [axis, anchor]: [Vec3; 2], [most, useful]: [f64; 2], parts: usize) {
        let taken = |joint: &Joint, name: &str| joint.name == name;
        let mut called = name.to_owned();
        let mut count = 1;
        while self.joints.iter().any(|joint| taken(joint, &called)) {
            count += 1;
            called = format!("{name} {count}");
        }
        let end = self.parts.len();
        self.joints.push(Joint {
            name: called.into(),
            motion,
            axis,
            anchor,
            limits: [0.0, most],
            useful: Some(useful),
            handle: None,
            parts: (end - parts..end).collect(),
        });
    }

    /// Says where what was added last is taken hold of.
    pub(super) fn handle_at(&mut self, at: Vec3) {
        if let Some(joint) = self.joints.last_mut() {
            joint.handle = Some(at);
        }
    }

    /// A leaf that fills a box, drawn by hand; its front is the face towards +z.
    pub(super) fn leaf(&mut self, name: &str, b: Block, hung: Hung) {
        let before = self.parts.len();
        let b = b.beveled(hung);
        self.solid(b);
        if self.parts.len() == before {
            return;
        }
        let (axis, x, limits) = match hung {
            Hung::Left => (-Vec3::y(), b.min.x, OPEN),
            Hung::Right => (Vec3::y(), b.max.x, OPEN),
            Hung::Below => (Vec3::x(), b.min.x, [DOWN, DOWN]),
        };
        self.joint(name, Motion::Hinge, [axis, Vec3::new(x, b.min.y, b.max.z)], limits, 1);
        let c = b.center();
        let far = match hung {
            Hung::Left => Vec3::new(b.max.x - 0.1 * b.size().x, c.y, b.max.z),
            Hung::Right => Vec3::new(b.min.x + 0.1 * b.size().x, c.y, b.max.z),
            Hung::Below => Vec3::new(c.x, b.max.y - 0.1 * b.size().y, b.max.z),
        };
        self.handle_at(far);
    }

    /// The leaf of a door in a wall, which may open to the back.
    pub(super) fn swing(&mut self, leaf: Block, hung: Hung, outward: bool) {
        self.leaf("leaf", leaf, hung);
        if let Some(joint) = self.joints.last_mut().filter(|_| outward) {
            (joint.axis, joint.anchor.z) = (-joint.axis, leaf.min.z);
        }
    }

    /// A casement of a window: a leaf that nobody has to be able to open.
    pub(super) fn casement(&mut self, b: Block, hung: Hung) {
        self.leaf("casement", b, hung);
        if let Some(joint) = self.joints.last_mut() {
            joint.useful = None;
        }
    }

    /// The part that was added last is a lid, which turns up about the upper edge of its back.
    pub(super) fn lid(&mut self, name: &str, b: Block) {
        self.lid_of(name, b, 1);
    }

    /// The same of the last so many parts, which fill a box.
    pub(super) fn lid_of(&mut self, name: &str, b: Block, parts: usize) {
        self.joint(name, Motion::Hinge, [-Vec3::x(), Vec3::new(b.min.x, b.max.y, b.min.z)], UP, parts);
        self.handle_at(Vec3::new(b.center().x, b.max.y, b.max.z));
    }

    /// A drawer: `front` is what closes it, its box goes back to `back`. One of `count` on this piece of furniture.
    pub(super) fn drawer(&mut self, front: Block, back: f64, count: usize, s: &Surface) {
        let before = self.parts.len();
        self.solid(front);
        let deep = front.min.z - back;
        if self.parts.len() == before || deep <= 0.02 {
            return;
        }
        let size = front.size();
        // It keeps clear of the body, which is no thicker than this.
        let (beside, below) = (0.02_f64.min(0.06 * size.x), 0.02_f64.min(0.12 * size.y));
        let tray =
            front.inset(beside, 0.0, 0.0).y(front.min.y + below..front.max.y - 0.2 * size.y).z(back..front.min.z);
        let wall = 0.012_f64.min(0.1 * tray.size().x).min(0.2 * tray.size().y).min(0.1 * deep);
        let bottom = tray.y(tray.min.y..tray.min.y + wall);
        let sides = [tray.x(tray.min.x..tray.min.x + wall), tray.x(tray.max.x - wall..tray.max.x)];
        let above = |b: Block| b.y(tray.min.y + wall..tray.max.y);
        let end = above(tray).z(tray.min.z..tray.min.z + wall).x(tray.min.x + wall..tray.max.x - wall);
        if count > BLOCKS {
            self.parts.truncate(before);
            self.solid(tray.z(tray.min.z..front.max.z));
            self.mesh.crisp(tray, s);
        } else if count <= BUILT {
            self.board(bottom, s);
            for side in sides {
                self.board(above(side), s);
            }
            self.board(end, s);
        } else {
            self.solid(tray);
            for board in [bottom, above(sides[0]), above(sides[1]), end] {
                self.mesh.crisp(board, s);
            }
        }
        let added = self.parts.len() - before;
        let most = OUT * deep;
        let anchor = Vec3::new(front.center().x, front.center().y, front.max.z);
        self.joint("drawer", Motion::Slide, [Vec3::z(), anchor], [most, REACH.min(0.75 * most)], added);
        self.handle_at(anchor);
    }

    /// A hollow body that is open to +z: two sides, a top, a bottom and a back, as thick as `wall`; `foot` is how thick the
    /// bottom is besides. Returns the cavity.
    pub(super) fn shell(&mut self, b: Block, wall: f64, foot: f64, s: &Surface) -> Block {
        let inner = b.inset(wall, 0.0, 0.0).y(b.min.y + foot + wall..b.max.y - wall).z(b.min.z + wall..b.max.z);
        for side in [b.x(b.min.x..inner.min.x), b.x(inner.max.x..b.max.x)] {
            self.board(side.y(b.min.y + foot..b.max.y), s);
        }
        let between = b.x(inner.min.x..inner.max.x);
        self.solid(b.y(b.min.y..b.min.y + foot));
        self.board(between.y(b.min.y + foot..inner.min.y), s);
        self.board(between.y(inner.max.y..b.max.y), s);
        self.board(between.y(inner.min.y..inner.max.y).z(b.min.z..inner.min.z), s);
        inner
    }
}
