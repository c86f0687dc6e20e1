//! The physical rules on boxes: in a room, resting on something, no overlap.

use super::{Moved, Span, TOUCHING, Trial};
use crate::penalty;
use scenelang_lang::program::ObjectId;
use scenelang_verify::coded::{self, Block, Flat};

/// So many pairs of blocks are held against each other in a unit of work.
const BLOCKS: u64 = 8;

impl Trial<'_> {
    pub(super) fn bounds(&mut self, i: usize) -> (f64, bool) {
        if self.is_asked(i) {
            return self.bounds_asked(i);
        }
        let span = &self.span[i];
        let clearances = self.rooms.iter().map(|room| room.clearance(span, || self.flat(i)));
        let best = clearances.fold(f64::NEG_INFINITY, f64::max);
        let contact = self.tolerances.contact;
        self.physical(best + contact, contact)
    }

    /// On a floor, or with its feet on tops of one thing. Standing on the edges of several things is left to the search
    /// proper.
    pub(super) fn support(&mut self, i: usize) -> (f64, bool) {
        if self.is_asked(i) {
            return self.support_asked(i);
        }
        let tolerance = self.tolerances.support;
        let target = tolerance.min(self.tolerances.contact);
        let mut off = self.above_floor(i).abs();
        if off > target {
            off = self.nearest_top(i).map_or(off, |(_, top)| off.min(top));
        }
        self.physical(tolerance - off, target)
    }

    /// How far its base is above the nearest floor of where it is.
    pub(super) fn above_floor(&self, i: usize) -> f64 {
        let base = self.span[i].min[1];
        if let Some(floor) = self.floor {
            return base - floor;
        }
        let [x, z] = self.flat(i).at;
        let under = self.rooms.iter().filter(|room| room.depth([x, z]) >= -self.tolerances.contact);
        let nearest = under.map(|room| base - room.floor).min_by(|a, b| a.abs().total_cmp(&b.abs()));
        nearest.unwrap_or(base)
    }

    /// Of the things with tops below (or above) its feet the one with those nearest to its base, and how far they are.
    fn nearest_top(&self, i: usize) -> Option<(usize, f64)> {
        let own = self.flat(i);
        let [x, z] = own.at;
        let mut best: Option<(usize, f64)> = None;
        // What moves in this trial is not in the grid yet. The list of it is elsewhere while it is judged.
        let found = self.near.at([x, z]).map(|there| {
            let moving = (0..self.count()).filter(|j| self.is_moved[*j]);
            let mut found: Vec<usize> = there.iter().copied().chain(moving).collect();
            found.sort_unstable();
            found.dedup();
            found
        });
        let count = found.as_ref().map_or(self.count(), Vec::len);
        for j in (0..count).map(|at| found.as_ref().map_or(at, |found| found[at])) {
            let other = &self.span[j];
            if j == i
                || !(other.min[0]..=other.max[0]).contains(&x)
                || !(other.min[2]..=other.max[2]).contains(&z)
                || !self.is_over(j, x, z)
                || self.is_oblique(j)
            {
                continue;
            }
            let theirs = self.flat(j);
            let off = |foot: &[f64; 2]| self.height_over(i, j, theirs.local(own.point(*foot)));
            let Some(off) = self.feet[i].iter().map(off).try_fold(0.0, |most: f64, off| Some(most.max(off?))) else {
                continue;
            };
            if best.is_none_or(|(_, least)| off < least) {
                best = Some((j, off));
            }
        }
        best
    }

    /// How far the base of one is from the nearest top of another at a point of that one's frame.
    fn height_over(&self, i: usize, j: usize, [u, v]: [f64; 2]) -> Option<f64> {
        let base = self.span[i].min[1] - self.middle(j);
        let covers =
            |block: &&Block| (u - block.at[0]).abs() <= block.half[0] && (v - block.at[2]).abs() <= block.half[2];
        let offs = self.blocks[j].iter().filter(covers).map(|block| (base - block.at[1] - block.half[1]).abs());
        offs.reduce(f64::min)
    }

    /// What it stands on, if that is not a floor.
    pub(super) fn find_seat(&self, i: usize) -> Option<usize> {
        let (support, target) = (self.tolerances.support, self.tolerances.contact);
        let raised = self.rests[i] && self.above_floor(i) > support;
        let top = if raised { self.nearest_top(i) } else { None };
        top.filter(|(_, off)| *off <= support.max(target)).map(|(j, _)| j)
    }

    /// Whether the evaluator is asked for the physical rules of an object.
    fn is_asked(&self, i: usize) -> bool {
        self.asked[i] || self.is_oblique(i)
    }

    pub(super) fn is_over(&self, j: usize, x: f64, z: f64) -> bool {
        let flat = self.flat(j);
        let [u, v] = flat.local([x, z]);
        u.abs() <= flat.half[0] && v.abs() <= flat.half[1]
    }

    /// What overlaps of one of the moved objects cost now.
    pub(super) fn collisions(&mut self, i: usize, moved: &[Moved]) -> f64 {
        let own = self.span[i];
        let mut around = std::mem::take(&mut self.around);
        self.work += 2 + self.near.around(&own, &self.span, &mut around) as u64 / 8;
        around.retain(|&j| !self.is_moved[j]);
        // Of two that move together the first is asked for both.
        let others = moved.iter().map(|(m, ..)| *m).filter(|&m| m > i);
        let sum = around.iter().copied().chain(others).map(|j| self.collision(i, j, &own)).sum();
        self.around = around;
        sum
    }

    /// What it costs that two overlap.
    fn collision(&mut self, i: usize, j: usize, own: &Span) -> f64 {
        if !own.meets(&self.span[j]) || !self.collide[i * self.count() + j] {
            return 0.0;
        }
        // Spans of carved things meet often, and each block is then held against each: a hall of racks is dear.
        self.work += (self.blocks[i].len() * self.blocks[j].len()) as u64 / BLOCKS;
        let gap = self.gap(i, j);
        if gap >= -TOUCHING {
            return 0.0;
        }
        let contact = self.tolerances.contact;
        let found = if self.is_asked(i) || self.is_asked(j) {
            self.collision_asked(i, j)
        } else {
            self.physical(gap + contact, contact - TOUCHING)
        };
        if found == (0.0, true) {
            return 0.0;
        }
        let check = self.numbering.collide(ObjectId(i as u32), ObjectId(j as u32));
        self.note(check, found)
    }

    /// The signed gap of two upright things that may overlap.
    fn gap(&self, i: usize, j: usize) -> f64 {
        let (a, b) = (&self.span[i], &self.span[j]);
        if self.blocks[i].len() > 1 || self.blocks[j].len() > 1 {
            return self.gap_of_blocks((i, &self.flat(i)), (&self.blocks[j], &self.flat(j), self.middle(j)));
        }
        let along = |k: usize| (a.min[k] - b.max[k]).max(b.min[k] - a.max[k]);
        let square = |k: usize| {
            let [.., sin, cos] = self.inputs(k);
            sin == 0.0 || cos == 0.0
        };
        let aside = if square(i) && square(j) { along(0).max(along(2)) } else { self.flat(i).gap(&self.flat(j)) };
        aside.max(along(1))
    }

    /// The signed gap between a thing and blocks that stand somewhere.
    pub(super) fn gap_of_blocks(&self, (i, flat): (usize, &Flat), other: (&[Block], &Flat, f64)) -> f64 {
        coded::gap([(&self.blocks[i], flat, self.middle(i)), other], f64::max)
    }

    /// How high its middle is.
    pub(super) fn middle(&self, i: usize) -> f64 {
        (self.span[i].min[1] + self.span[i].max[1]) / 2.0
    }

    pub(super) fn physical(&self, margin: f64, target: f64) -> (f64, bool) {
        let holds = margin >= -self.tolerances.order;
        (penalty::cost(holds, target - margin), holds)
    }

    /// The rectangle of an object.
    pub fn flat(&self, i: usize) -> Flat {
        let ([w, _, d], inputs) = (self.size[i], self.inputs(i));
        let [x, _, z, _, sin, cos] = inputs;
        if let Some((at, half)) = self.lying(i, &inputs) {
            return Flat { at, turn: [sin, cos], half };
        }
        Flat { at: [x, z], turn: [sin, cos], half: [w / 2.0, d / 2.0] }
    }
}
