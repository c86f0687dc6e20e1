//! Moves of one object after which a goal holds, the smallest first: down the margin's slope, and along straight lines.

use super::DEAR;
use super::moves::Step;
use super::stage::{Goal, Stage};
use scenelang_lang::program::ObjectId;

/// Steps down a slope.
const DESCENT: usize = 24;
/// No step down a slope is longer (metres).
const STRIDE: f64 = 1.0;
/// No move goes farther (metres).
const FARTHEST: f64 = 8.0;
/// How far beyond the edge of what holds to aim (metres or degrees).
const BEYOND: f64 = 1e-5;

/// How an object may be moved.
#[derive(Clone, Copy, Debug)]
pub(super) struct Freedom {
    /// From its place.
    pub pos: bool,
    /// About the vertical.
    pub turn: bool,
}

/// A move: metres along x, y, z, and degrees.
type Move = [f64; 4];

/// Looks for moves of one object.
pub(super) struct Search<'s, 'a> {
    stage: &'s mut Stage<'a>,
    goal: Goal,
    object: ObjectId,
    /// Where the object has been moved to already.
    from: Step,
    /// Metres that a degree moves the farthest point of its footprint.
    per_degree: f64,
    /// How hard it is to move: 1 for what is small, up to 2 for what is large.
    weight: f64,
    /// What must not be exceeded, in [`Stage::work`].
    limit: usize,
    /// Whether asking whether the goal holds is dear.
    dear: bool,
}

impl<'s, 'a> Search<'s, 'a> {
    pub fn new(stage: &'s mut Stage<'a>, goal: Goal, from: Step, limit: usize) -> Option<Self> {
        let half = stage.layout().object(from.object).ok()?.body.obb.half;
        let per_degree = half.x.hypot(half.z).max(0.1).to_radians();
        let volume = 8.0 * half.x * half.y * half.z;
        let weight = 1.0 + volume / (1.0 + volume);
        let dear = stage.cost(goal) > DEAR;
        Some(Self { stage, goal, object: from.object, from, per_degree, weight, limit, dear })
    }

    /// How far the farthest point of the object travels at most (metres); of what is large it counts up to twice, since
    /// one would rather move the nightstand than the bed.
    pub fn cost(&self, step: &Step) -> f64 {
        let [x, y, z] = step.by;
        (x.hypot(y).hypot(z) + step.turn.abs() * self.per_degree) * self.weight
    }

    /// All that was found, rounded to what can be said; the smallest first.
    pub fn run(mut self, freedom: Freedom) -> Vec<(f64, Step)> {
        const PLANE: [bool; 4] = [true, false, true, false];
        const SPACE: [bool; 4] = [true, true, true, false];
        const TURN: [bool; 4] = [false, false, false, true];
        let masks: &[[bool; 4]] = match (freedom.pos, freedom.turn, self.dear) {
            (true, _, true) => &[PLANE],
            (true, true, false) => &[PLANE, SPACE, TURN, [true; 4]],
            (true, false, false) => &[PLANE, SPACE],
            (false, true, _) => &[TURN],
            (false, false, _) => &[],
        };
        let mut found: Vec<Move> = Vec::new();
        for mask in masks {
            found.extend(self.descend(*mask));
        }
        let mut lines: Vec<Move> = Vec::new();
        if freedom.pos {
            for axis in [0, 2, 1] {
                for sign in [1.0, -1.0] {
                    let mut line = [0.0; 4];
                    line[axis] = sign;
                    lines.push(line);
                }
            }
            lines.extend(self.own_axes());
            // On the floor nobody walks higher or lower.
            lines.retain(|line| line[1] == 0.0 || !self.dear);
        }
        for line in lines {
            found.extend(self.along(line));
        }
        if freedom.turn && !self.dear {
            found.extend([90.0, -90.0, 180.0].map(|turn| [0.0, 0.0, 0.0, turn]).into_iter().filter(|m| self.holds(m)));
        }
        // What was found is put into words even if nothing more may be looked for.
        self.limit += if self.dear { 24 * self.stage.cost(self.goal) } else { 0 };
        let tidy: Vec<Move> = found.into_iter().map(|m| self.tidied(m)).collect();
        let mut out: Vec<(f64, Step)> = Vec::new();
        for step in tidy.iter().map(|m| self.step(m)) {
            if !out.iter().any(|(_, other)| *other == step) {
                out.push((self.cost(&step), step));
            }
        }
        out.sort_by(|a, b| a.0.total_cmp(&b.0));
        out
    }

    fn step(&self, m: &Move) -> Step {
        let by = std::array::from_fn(|i| self.from.by[i] + m[i]);
        Step { object: self.object, by, turn: self.from.turn + m[3], with: None }
    }

    /// So often a length is halved: to the tenth of a millimetre or, where that is dear, to some centimetres.
    fn halvings(&self) -> usize {
        if self.dear { 5 } else { 14 }
    }

    fn spent(&self) -> bool {
        self.stage.has_spent(self.limit)
    }

    fn try_out(&mut self, m: &Move) -> Option<(bool, f64)> {
        let step = self.step(m);
        self.stage.put(&step);
        self.stage.truth(self.goal).map(|t| (t.holds, t.margin))
    }

    fn holds(&mut self, m: &Move) -> bool {
        !self.spent() && self.try_out(m).is_some_and(|(holds, _)| holds)
    }

    /// Follows the slope of the margin until the goal holds: each step goes as far as the slope says it takes.
    fn descend(&mut self, mask: [bool; 4]) -> Option<Move> {
        let mut at: Move = [0.0; 4];
        let mut blind = 0.1;
        for _ in 0..DESCENT {
            if self.spent() {
                return None;
            }
            let (holds, margin) = self.try_out(&at)?;
            if holds {
                return Some(self.shortened(at));
            }
            let slope = self.stage.slope(self.goal, self.object)?;
            // A degree counts as the way it moves the object's outline.
            let unit = [1.0, 1.0, 1.0, self.per_degree];
            let way: Move = std::array::from_fn(|i| if mask[i] { slope[i] / unit[i] } else { 0.0 });
            let square: f64 = way.iter().map(|c| c * c).sum();
            if square < 1e-12 {
                return None;
            }
            let far = if margin.is_finite() { (BEYOND - margin) / square.sqrt() } else { blind };
            // A goal without a measure says where to go, not how far.
            blind *= 2.0;
            let far = far.min(STRIDE.max(blind / 4.0)) / square.sqrt();
            at = std::array::from_fn(|i| at[i] + way[i] * far / unit[i]);
            if at[..3].iter().any(|c| c.abs() > FARTHEST) || at[3].abs() > 360.0 {
                return None;
            }
        }
        None
    }

    /// The first place along a line where the goal holds.
    fn along(&mut self, line: Move) -> Option<Move> {
        let at = |t: f64| line.map(|c| c * t);
        let (first, factor) = if self.dear { (0.1, 2.0) } else { (0.02, 1.5) };
        let (mut low, mut high) = (0.0, first);
        while !self.holds(&at(high)) {
            (low, high) = (high, high * factor);
            if high > FARTHEST || self.spent() {
                return None;
            }
        }
        for _ in 0..self.halvings() {
            let middle = (low + high) / 2.0;
            if self.holds(&at(middle)) {
                high = middle;
            } else {
                low = middle;
            }
        }
        Some(at(high))
    }

    /// The directions of the object's own sides, where they are not the world's.
    fn own_axes(&self) -> Vec<Move> {
        let Ok(thing) = self.stage.world().object(self.object) else { return Vec::new() };
        let sides = [0, 2].map(|axis| thing.axes.0[axis].0);
        let flat = |[x, _, z]: [f64; 3]| {
            let length = x.hypot(z);
            (length > 0.1 && x.abs().min(z.abs()) > 1e-3 * length).then(|| [x / length, 0.0, z / length, 0.0])
        };
        sides.into_iter().filter_map(flat).flat_map(|m| [m, m.map(|c| -c)]).collect()
    }

    /// A shorter move on the way to one after which the goal holds.
    fn shortened(&mut self, whole: Move) -> Move {
        let at = |t: f64| whole.map(|c| c * t);
        let (mut low, mut high) = (0.0, 1.0);
        for _ in 0..self.halvings() {
            let middle = (low + high) / 2.0;
            if self.holds(&at(middle)) {
                high = middle;
            } else {
                low = middle;
            }
        }
        at(high)
    }

    /// The same in fewer and rounder numbers, as far as the goal still holds.
    fn tidied(&mut self, mut m: Move) -> Move {
        let mut order = [0, 1, 2, 3];
        order.sort_by(|&i, &j| m[i].abs().total_cmp(&m[j].abs()).then(i.cmp(&j)));
        for i in order {
            let fewer: Move = std::array::from_fn(|k| if k == i { 0.0 } else { m[k] });
            if m[i] != 0.0 && fewer.iter().any(|c| *c != 0.0) && self.holds(&fewer) {
                m = fewer;
            }
        }
        // Centimetres and whole degrees first, to either side; then finer.
        for digits in [100.0, 1000.0, 10_000.0] {
            let turn = digits / 100.0;
            let grid = [digits, digits, digits, turn];
            let nearest: Move = std::array::from_fn(|i| (m[i] * grid[i]).round() / grid[i]);
            let farther: Move = std::array::from_fn(|i| {
                // What is round already stays: 0.07 times 100 is a hair more than 7.
                let scaled = m[i].abs() * grid[i];
                (scaled - 1e-6).ceil().copysign(m[i]) / grid[i]
            });
            for round in [nearest, farther] {
                if round.iter().any(|c| *c != 0.0) && self.holds(&round) {
                    return round.map(|c| c + 0.0);
                }
            }
        }
        m
    }
}
