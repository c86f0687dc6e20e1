//! Moves of one object after which all goals hold, the smallest first: down the slopes of the margins, along straight
//! lines and, where that leads nowhere, from places farther off.

use super::DEAR;
use super::stage::Stage;
use crate::pose::half_turn;
use crate::rows::Goal;
use scenelang_lang::program::{ObjectId, Unit};
use scenelang_layout::Vec2;
use scenelang_verify::explain::ObjectMove;

/// Sweeps over the goals that fail, each with a step down its slope.
const SWEEPS: usize = 30;
/// No step down a slope is longer (metres).
const STRIDE: f64 = 1.0;
/// No move goes farther (metres).
const FARTHEST: f64 = 8.0;
/// How far beyond the edge of what holds to aim (metres or degrees).
const BEYOND: f64 = 1e-5;
/// From so many places farther off the slopes are followed.
const STARTS: usize = 10;
/// So many objects that the goals speak of are looked at for places beside them.
const RELATED: usize = 6;
/// How far around an object places are tried (metres).
const RINGS: [f64; 6] = [0.15, 0.4, 0.8, 1.2, 1.6, 2.2];
/// What a metre counts beside what is missing.
const PULL: f64 = 0.05;

/// What is moved out of a way by less than this is moved there step by step (metres).
pub(super) const ASIDE: f64 = 0.4;
/// So much less does a move count that ends better (metres).
const SETTLED: f64 = 1e-6;
/// What is turned by less than this from an axis is square to it (degrees).
const ASKEW: f64 = 0.1;

/// How an object may be moved.
#[derive(Clone, Copy, Debug)]
pub(super) struct Freedom {
    /// From its place.
    pub pos: bool,
    /// About the vertical.
    pub turn: bool,
}

/// Degrees by which the ends of a range of angles are looked for.
const SWEEP: f64 = 10.0;
const HALF_TURN: f64 = 180.0;
/// What is so near to square is meant to be (degrees).
const NEARLY_SQUARE: f64 = 20.0;

/// A move: metres along x, y, z, and degrees.
pub(super) type Move = [f64; 4];

/// Looks for moves of one object, with what goes along with it.
pub(super) struct MoveSearch<'s, 'a> {
    pub(super) stage: &'s mut Stage<'a>,
    /// What is to hold, the cheapest first.
    pub(super) goals: Vec<Goal>,
    /// Where the object has been moved to already.
    pub(super) from: ObjectMove,
    /// What goes along.
    riders: &'s [ObjectId],
    pub(super) freedom: Freedom,
    /// See [`Pose::heft`](crate::Pose::heft).
    per_degree: f64,
    weight: f64,
    /// What must not be exceeded, in [`Stage::work`].
    limit: usize,
    /// Whether asking whether the goals hold is dear.
    pub(super) dear: bool,
    /// Whether what is asked for is about where the object looks: then turns go to the middle of what holds.
    directed: bool,
}

impl<'s, 'a> MoveSearch<'s, 'a> {
    pub fn new(
        stage: &'s mut Stage<'a>,
        goals: &[Goal],
        (from, riders): (ObjectMove, &'s [ObjectId]),
        freedom: Freedom,
        limit: usize,
    ) -> Option<Self> {
        let (per_degree, weight) = stage.home(from.object)?.heft();
        let mut goals = goals.to_vec();
        goals.sort_by_key(|goal| stage.cost(*goal));
        let dear = goals.iter().any(|goal| stage.cost(*goal) > DEAR);
        Some(Self { stage, goals, from, riders, freedom, per_degree, weight, limit, dear, directed: false })
    }

    /// For goals that are about where the object looks.
    pub fn directed(self, directed: bool) -> Self {
        Self { directed, ..self }
    }

    /// How far the farthest point of the object travels at most (metres), by its weight.
    pub(super) fn cost(&self, step: &ObjectMove) -> f64 {
        let [x, y, z] = step.by;
        (x.hypot(y).hypot(z) + step.turn.abs() * self.per_degree) * self.weight
    }

    /// What was found from where the object is, rounded to what can be said; the smallest first.
    pub fn near(mut self) -> Vec<(f64, ObjectMove)> {
        let mut found: Vec<Move> = Vec::new();
        if self.from.by != [0.0; 3] && self.holds(&[0.0; 4]) {
            found.push([0.0; 4]);
        }
        for mask in self.masks() {
            found.extend(self.descend([0.0; 4], *mask));
        }
        let mut lines: Vec<Move> = Vec::new();
        if self.freedom.pos {
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
        if self.freedom.turn && !self.dear {
            let turns: Vec<Move> = self.turns().into_iter().skip(1).map(|turn| [0.0, 0.0, 0.0, turn]).collect();
            found.extend(turns.into_iter().filter(|m| self.holds(m)));
        }
        if self.directed {
            let turns: Vec<Move> = found.iter().filter(|m| m[..3] == [0.0; 3]).copied().collect();
            found.retain(|m| m[..3] != [0.0; 3]);
            found.extend(turns.into_iter().map(|m| self.straightened(m)));
        }
        self.in_words(found)
    }

    /// A turn to the middle of the angles around it at which the goals hold, or to what is square near that: who turns a
    /// chair to its desk does not stop as soon as that is barely so.
    fn straightened(&mut self, turn: Move) -> Move {
        let at = |by: f64| [0.0, 0.0, 0.0, turn[3] + by];
        let mut ends = [0.0_f64; 2];
        for (end, sign) in ends.iter_mut().zip([1.0, -1.0]) {
            while end.abs() < HALF_TURN && self.holds(&at(*end + sign * SWEEP)) {
                *end += sign * SWEEP;
            }
            if end.abs() >= HALF_TURN {
                // It may look anywhere.
                return turn;
            }
            let inside = *end;
            // From beyond the end back to it.
            let part = self.least(0.0, 1.0, &|t| at(inside + sign * SWEEP * (1.0 - t)));
            *end = inside + sign * SWEEP * (1.0 - part);
        }
        let middle = turn[3] + (ends[0] + ends[1]) / 2.0;
        let yaw = self.stage.home(self.from.object).map_or(0.0, |home| home.rot.y + self.from.turn);
        let square = 90.0 * ((yaw + middle) / 90.0).round() - yaw;
        let straight = if (square - middle).abs() <= NEARLY_SQUARE { square } else { middle.round() };
        // The shorter way round.
        let straight = [0.0, 0.0, 0.0, half_turn(straight)];
        if straight[3] != 0.0 && self.holds(&straight) { straight } else { turn }
    }

    /// What was found from places farther off.
    pub fn far(mut self) -> Vec<(f64, ObjectMove)> {
        let mut ranked: Vec<(f64, Move)> = Vec::new();
        // What bars a way is not moved out of it by a hand's breadth: that was tried.
        let barred = self.is_barred();
        for start in self.starts() {
            if self.spent() {
                break;
            }
            if barred && start[0].hypot(start[2]) < ASIDE {
                continue;
            }
            let missing = self.missing(&start);
            ranked.push((missing + PULL * self.cost(&self.step(&start)), start));
        }
        ranked.sort_by(|a, b| a.0.total_cmp(&b.0));
        let Some(mask) = self.masks().iter().max_by_key(|m| m.iter().filter(|f| **f).count()).copied() else {
            return Vec::new();
        };
        let starts = ranked.into_iter().take(STARTS);
        let found: Vec<Move> = starts.filter_map(|(_, start)| self.descend(start, mask)).collect();
        self.in_words(found)
    }

    fn masks(&self) -> &'static [[bool; 4]] {
        const PLANE: [bool; 4] = [true, false, true, false];
        const SPACE: [bool; 4] = [true, true, true, false];
        const TURN: [bool; 4] = [false, false, false, true];
        match (self.freedom.pos, self.freedom.turn, self.dear) {
            (true, _, true) => &[PLANE],
            (true, true, false) => &[PLANE, SPACE, TURN, [true; 4]],
            (true, false, false) => &[PLANE, SPACE],
            (false, true, _) => &[TURN],
            (false, false, _) => &[],
        }
    }

    /// Moves in few and round numbers, the smallest first.
    fn in_words(mut self, mut found: Vec<Move>) -> Vec<(f64, ObjectMove)> {
        found.sort_by(|a, b| self.cost(&self.step(a)).total_cmp(&self.cost(&self.step(b))));
        // What was found is put into words even if nothing more may be looked for.
        let times = if self.dear { 1 } else { found.len() };
        self.limit += 24 * times * self.goals.iter().map(|goal| self.stage.cost(*goal)).sum::<usize>();
        let mut out: Vec<(f64, ObjectMove)> = Vec::new();
        found.iter().for_each(|m| self.say(*m, &mut out));
        // What is better to look at comes after that: to find it may take all that is left.
        for m in found {
            let better = [self.wholly_out(m), self.squared(m)];
            better.into_iter().flatten().for_each(|m| self.say(m, &mut out));
        }
        out.sort_by(|a, b| a.0.total_cmp(&b.0));
        out
    }

    /// Whether a dear goal fails in the layout, as a way over the floor that is barred does.
    pub(super) fn is_barred(&mut self) -> bool {
        let dear: Vec<Goal> = self.goals.iter().copied().filter(|goal| self.stage.cost(*goal) > DEAR).collect();
        dear.into_iter().any(|goal| !self.stage.holds_at_home(goal))
    }

    /// A move in few and round numbers, also as one that goes on for the last centimetres, if that is not among others.
    fn say(&mut self, m: Move, out: &mut Vec<(f64, ObjectMove)>) {
        let tidy = self.tidied(m);
        let tidy = self.put_down(tidy);
        let plain = self.step(&tidy);
        let cost = self.cost(&plain);
        // Whoever goes so far goes the last centimetres for nothing.
        let settled = self.settled(tidy).map(|m| (cost - SETTLED, self.step(&m)));
        for (cost, step) in settled.into_iter().chain([(cost, plain)]) {
            if !out.iter().any(|(_, other)| *other == step) {
                out.push((cost, step));
            }
        }
    }

    /// A move that ends square to the axes, near one that does not quite: what is put elsewhere is put there straight.
    fn squared(&mut self, m: Move) -> Option<Move> {
        if m[3] == 0.0 || m[..3] == [0.0; 3] || self.dear || self.spent() {
            return None;
        }
        let yaw = self.stage.home(self.from.object)?.rot.y + self.from.turn + m[3];
        let off = 90.0 * (yaw / 90.0).round() - yaw;
        if off.abs() < 1e-9 || off.abs() > NEARLY_SQUARE {
            return None;
        }
        let straight = [m[0], m[1], m[2], m[3] + off];
        if self.holds(&straight) {
            return Some(straight);
        }
        const PLANE: [bool; 4] = [true, false, true, false];
        // Not shortened: that would turn it back.
        self.follow(straight, PLANE)
    }

    /// Places around where the object is, and beside and on top of what the goals speak of; turned by quarters.
    fn starts(&mut self) -> Vec<Move> {
        let Some(home) = self.stage.home(self.from.object) else { return Vec::new() };
        let own = home.scale / 2.0;
        let here: [f64; 3] = std::array::from_fn(|i| home.pos[i] + self.from.by[i]);
        let mut places = vec![[0.0; 3]];
        if self.freedom.pos {
            for radius in RINGS {
                for (x, z) in [
                    (1.0, 0.0),
                    (-1.0, 0.0),
                    (0.0, 1.0),
                    (0.0, -1.0),
                    (0.7, 0.7),
                    (0.7, -0.7),
                    (-0.7, 0.7),
                    (-0.7, -0.7),
                ] {
                    places.push([radius * x, 0.0, radius * z]);
                }
            }
            let reach = own.x.min(own.z);
            let grounded = self.stage.belongs_on_floor(self.from.object);
            for other in self.stage.spoken_of(&self.goals, self.from.object).into_iter().take(RELATED) {
                let Ok(thing) = self.stage.world().object(other) else { continue };
                let (at, sides, half) = (thing.pos.0, [0, 2].map(|i| thing.axes.0[i].0), thing.body.obb.half);
                if !grounded {
                    places.push([at[0] - here[0], at[1] + 2.0 * half.y - here[1], at[2] - here[2]]);
                }
                for (side, half) in sides.into_iter().zip([half.x, half.z]) {
                    for far in [0.02, 0.5].into_iter().flat_map(|gap| [half + reach + gap, -half - reach - gap]) {
                        places.push([at[0] + far * side[0] - here[0], 0.0, at[2] + far * side[2] - here[2]]);
                    }
                }
            }
        }
        let turns = self.turns();
        places.iter().flat_map(|[x, y, z]| turns.iter().map(move |turn| [*x, *y, *z, *turn])).collect()
    }

    /// By how much it is turned: not at all, by quarters, and where it stands askew to the axes by what makes it square.
    fn turns(&self) -> Vec<f64> {
        const QUARTERS: [f64; 4] = [0.0, 90.0, -90.0, 180.0];
        let Some(home) = self.stage.home(self.from.object).filter(|_| self.freedom.turn) else { return vec![0.0] };
        let yaw = home.rot.y + self.from.turn;
        let square = 90.0 * (yaw / 90.0).round() - yaw;
        let askew = QUARTERS.iter().map(|turn| turn + square).filter(|_| square.abs() > ASKEW);
        QUARTERS.into_iter().chain(askew).collect()
    }

    /// How much is missing after a move, in metres.
    fn missing(&mut self, m: &Move) -> f64 {
        self.put(m);
        let mut sum = 0.0;
        for i in 0..self.goals.len() {
            let goal = self.goals[i];
            if self.stage.cost(goal) > DEAR {
                continue;
            }
            sum += match self.stage.truth(goal) {
                Some(t) if t.holds => 0.0,
                Some(t) if t.margin.is_finite() => {
                    0.1 + -t.margin * if t.unit == Unit::Degree { self.per_degree } else { 1.0 }
                }
                _ => 1.0,
            };
        }
        sum
    }

    pub(super) fn step(&self, m: &Move) -> ObjectMove {
        let by = std::array::from_fn(|i| self.from.by[i] + m[i]);
        ObjectMove { object: self.from.object, by, turn: self.from.turn + m[3], with: None }
    }

    /// So often a length is halved: to the tenth of a millimetre or, where that is dear, to some centimetres.
    fn halvings(&self) -> usize {
        if self.dear { 5 } else { 14 }
    }

    pub(super) fn spent(&self) -> bool {
        self.stage.has_spent(self.limit)
    }

    pub(super) fn put(&mut self, m: &Move) {
        let step = self.step(m);
        self.stage.put_with(&step, self.riders);
    }

    pub(super) fn holds(&mut self, m: &Move) -> bool {
        if self.spent() {
            return false;
        }
        self.put(m);
        (0..self.goals.len()).all(|i| self.stage.truth(self.goals[i]).is_some_and(|t| t.holds))
    }

    /// Whether all goals hold that are not dear.
    pub(super) fn holds_cheaply(&mut self, m: &Move) -> bool {
        self.put(m);
        let cheap: Vec<Goal> = self.goals.iter().copied().filter(|goal| self.stage.cost(*goal) <= DEAR).collect();
        cheap.into_iter().all(|goal| self.stage.truth(goal).is_some_and(|t| t.holds))
    }

    /// Follows the slopes of what fails, and takes back what is not needed.
    fn descend(&mut self, start: Move, mask: [bool; 4]) -> Option<Move> {
        let found = self.follow(start, mask)?;
        Some(self.shortened(found))
    }

    /// Follows the slopes of what fails until all goals hold: each step goes as far as the slope says it takes.
    fn follow(&mut self, start: Move, mask: [bool; 4]) -> Option<Move> {
        let mut at = start;
        let mut blind = 0.1;
        for _ in 0..SWEEPS {
            let mut fine = true;
            for i in 0..self.goals.len() {
                if self.spent() {
                    return None;
                }
                let goal = self.goals[i];
                // What is dear is looked at only where all else holds.
                if !fine && self.stage.cost(goal) > DEAR {
                    break;
                }
                self.put(&at);
                let truth = self.stage.truth(goal)?;
                if truth.holds {
                    continue;
                }
                fine = false;
                let mut parts = self.stage.failing_parts(goal);
                if parts.len() <= 1 {
                    parts = vec![goal];
                }
                for part in parts {
                    let margin = if part == goal { truth.margin } else { self.stage.truth(part)?.margin };
                    if part != goal && margin >= 0.0 {
                        continue;
                    }
                    let slope = self.stage.slope(part, (self.from.object, self.riders))?;
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
                    self.put(&at);
                }
            }
            if fine {
                return Some(at);
            }
        }
        None
    }

    /// The first place along a line where the goals hold.
    fn along(&mut self, line: Move) -> Option<Move> {
        let at = |t: f64| line.map(|c| c * t);
        let (first, factor) = if self.dear { (0.1, 2.0) } else { (0.02, 1.5) };
        let (mut low, mut high) = (0.0, first);
        // Nothing is moved out of all rooms to clear a path.
        while self.dear && !self.is_indoors(&at(high)) || !self.holds(&at(high)) {
            (low, high) = (high, high * factor);
            if high > FARTHEST || self.spent() {
                return None;
            }
        }
        Some(at(self.least(low, high, &at)))
    }

    /// Whether the object is over the floor of some room after a move, if there are rooms.
    fn is_indoors(&self, m: &Move) -> bool {
        let Some(home) = self.stage.home(self.from.object) else { return false };
        let [x, z] = [0, 2].map(|i| home.pos[i] + self.from.by[i] + m[i]);
        let mut rooms = self.stage.world().prisms().peekable();
        rooms.peek().is_none() || rooms.any(|(_, prism)| prism.polygon.contains(Vec2::new(x, z)))
    }

    /// The least number between two with which a move does, `high` being one.
    fn least(&mut self, mut low: f64, mut high: f64, at: &dyn Fn(f64) -> Move) -> f64 {
        for _ in 0..self.halvings() {
            let middle = (low + high) / 2.0;
            if self.holds(&at(middle)) {
                high = middle;
            } else {
                low = middle;
            }
        }
        high
    }

    /// The directions of the object's own sides, where they are not the world's.
    fn own_axes(&self) -> Vec<Move> {
        let Ok(thing) = self.stage.world().object(self.from.object) else { return Vec::new() };
        let sides = [0, 2].map(|axis| thing.axes.0[axis].0);
        let flat = |[x, _, z]: [f64; 3]| {
            let length = x.hypot(z);
            (length > 0.1 && x.abs().min(z.abs()) > 1e-3 * length).then(|| [x / length, 0.0, z / length, 0.0])
        };
        sides.into_iter().filter_map(flat).flat_map(|m| [m, m.map(|c| -c)]).collect()
    }

    /// A shorter move on the way to one after which the goals hold; then with less of each of its numbers.
    fn shortened(&mut self, whole: Move) -> Move {
        let part = self.least(0.0, 1.0, &|t| whole.map(|c| c * t));
        let mut m = whole.map(|c| c * part);
        if self.goals.len() == 1 {
            return m;
        }
        for axis in [0, 2, 1, 3] {
            if m[axis] != 0.0 {
                let less = |t: f64| std::array::from_fn(|i| if i == axis { m[i] * t } else { m[i] });
                let part = self.least(0.0, 1.0, &less);
                m[axis] *= part;
            }
        }
        m
    }

    /// The same in fewer and rounder numbers, as far as the goals still hold.
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
            // All to the nearest, all farther, then some of each: the fewer digits, the better it can be said and done.
            let apart: Vec<usize> = (0..4).filter(|&i| (nearest[i] - farther[i]).abs() > 1e-9).collect();
            let every = (1_usize << apart.len()) - 1;
            let some = if self.dear { 0 } else { every.saturating_sub(1) };
            for which in [0, every].into_iter().chain(1..=some) {
                let mut round = nearest;
                for (_, &i) in apart.iter().enumerate().filter(|(bit, _)| which >> bit & 1 == 1) {
                    round[i] = farther[i];
                }
                if round.iter().any(|c| *c != 0.0) && self.holds(&round) {
                    return round.map(|c| c + 0.0);
                }
                if every == 0 {
                    break;
                }
            }
        }
        m
    }
}
