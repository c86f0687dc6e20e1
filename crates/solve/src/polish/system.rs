//! The equations of a polish, and their solution by damped least squares (Levenberg and Marquardt).

use super::{Entity, K, Slope, Unknown, numbers, rules_after, touched_objects, with_numbers};
use crate::checks::Check;
use crate::merit::Merit;
use crate::pose::Pose;
use crate::state::State;
use nalgebra::{DMatrix, DVector};
use scenelang_lang::program::ObjectId;
use scenelang_verify::vector::V3;
use scenelang_verify::{Dual, Number, Scratch, World, gap, rules};

/// Pairs further apart than this are not looked at (metres).
const NEAR: f64 = 0.25;
/// What solids keep between them where they are pushed apart (metres).
const APART: f64 = 2e-5;
/// Longest step of a length (metres) and of an angle (degrees).
const STEP: [f64; 2] = [1.0, 40.0];

/// A residual: its value and its slopes by unknowns.
struct Row {
    value: f64,
    weight: f64,
    slopes: Vec<(usize, f64)>,
}

/// The residuals of some checks as functions of some unknowns.
pub(super) struct System<'s, 'a> {
    state: &'s State<'a>,
    world: &'s mut World<Slope>,
    scratch: &'s mut Scratch<Slope>,
    /// What is to be found.
    pub unknowns: Vec<Unknown>,
    /// By unknown.
    pub values: Vec<f64>,
    /// Work done.
    pub work: u64,
    /// Checks, each with the unknowns that it depends on.
    checks: Vec<(usize, Vec<usize>)>,
}

impl<'s, 'a> System<'s, 'a> {
    /// For a state and a world of slopes that agrees with it.
    pub fn new(
        state: &'s State<'a>,
        world: &'s mut World<Slope>,
        scratch: &'s mut Scratch<Slope>,
        unknowns: Vec<Unknown>,
    ) -> Self {
        let mut system = Self { state, world, scratch, unknowns, values: Vec::new(), work: 0, checks: Vec::new() };
        system.values = system.unknowns.iter().map(|u| system.start(u)).collect();
        system.find_checks();
        system
    }

    fn start(&self, unknown: &Unknown) -> f64 {
        let of = |pose: Pose| match unknown.index {
            0..3 => pose.pos[unknown.index],
            3..6 => pose.rot[unknown.index - 3],
            i => pose.scale[i - 6],
        };
        match unknown.entity {
            Entity::Object(id) => of(self.state.pose(id)),
            Entity::Region(id) => of(self.state.region_pose(id)),
            Entity::Variable(id) => self.state.world.variable(id).map_or(0.0, |v| numbers(v)[unknown.index]),
        }
    }

    fn find_checks(&mut self) {
        let state = self.state;
        let frame = state.frame;
        // Which unknowns each moved object depends on.
        let mut moved: Vec<(ObjectId, Vec<usize>)> = Vec::new();
        let mut checks: Vec<(usize, Vec<usize>)> = Vec::new();
        let mut add = |check: usize, by: &[usize]| match checks.iter_mut().find(|(c, _)| *c == check) {
            Some((_, list)) => list.extend(by.iter().filter(|u| !list.contains(u)).copied().collect::<Vec<_>>()),
            None => checks.push((check, by.to_vec())),
        };
        for (index, unknown) in self.unknowns.iter().enumerate() {
            for object in touched_objects(state, unknown.entity) {
                match moved.iter_mut().find(|(o, _)| *o == object) {
                    Some((_, list)) => list.push(index),
                    None => moved.push((object, vec![index])),
                }
            }
            let terms = match unknown.entity {
                Entity::Object(_) => continue,
                Entity::Region(id) => &frame.terms_of_region[id.0 as usize],
                Entity::Variable(id) => &frame.terms_of_variable[id.0 as usize],
            };
            terms.iter().for_each(|&t| add(t, &[index]));
        }
        for (object, by) in &moved {
            frame.terms_of[object.0 as usize].iter().for_each(|&t| add(t, by));
            let Some(scope) = &frame.scope else { continue };
            if scope.bounds(*object) && !frame.program.regions.is_empty() {
                add(state.numbering.bounds(*object), by);
            }
            let span = state.span(*object);
            let near = state.placed().filter(|o| scope.collide(*object, *o) && state.span(*o).distance(span) < NEAR);
            near.for_each(|other| add(state.numbering.collide(*object, other), by));
        }
        checks.retain(|(c, _)| frame.terms.get(*c).is_none_or(|t| !t.walks && state.is_active(*c)));
        self.checks = checks;
    }

    /// Steps towards less, at most so many.
    pub fn solve(&mut self, iterations: usize) {
        let mut rows = self.rows();
        let mut sum = total(&rows);
        let mut damping = 1e-3;
        for _ in 0..iterations {
            if sum < 1e-14 {
                break;
            }
            let (matrix, right) = self.normal(&rows);
            let before = self.values.clone();
            let mut better = false;
            for _ in 0..4 {
                let Some(step) = solve_damped(&matrix, &right, damping) else { break };
                for ((value, unknown), (old, s)) in
                    self.values.iter_mut().zip(&self.unknowns).zip(before.iter().zip(step.iter()))
                {
                    let longest = STEP[usize::from(unknown.angle)];
                    *value = old + s.clamp(-longest, longest);
                }
                let next = self.rows();
                let next_sum = total(&next);
                if next_sum < sum * (1.0 - 1e-4) {
                    (rows, sum, better) = (next, next_sum, true);
                    damping = (damping * 0.2).max(1e-9);
                    break;
                }
                damping *= 8.0;
            }
            if !better {
                self.values = before;
                break;
            }
        }
    }

    /// JᵀWJ and -JᵀWr.
    fn normal(&self, rows: &[Row]) -> (DMatrix<f64>, DVector<f64>) {
        let n = self.unknowns.len();
        let (mut matrix, mut right) = (DMatrix::zeros(n, n), DVector::zeros(n));
        for row in rows {
            for &(i, s) in &row.slopes {
                right[i] -= row.weight * s * row.value;
                for &(j, t) in &row.slopes {
                    matrix[(i, j)] += row.weight * s * t;
                }
            }
        }
        (matrix, right)
    }

    /// All residuals at the current values.
    fn rows(&mut self) -> Vec<Row> {
        let mut rows = Vec::new();
        let all: Vec<usize> = (0..self.unknowns.len()).collect();
        let at_once = all.len() <= K;
        self.seed(&all, if at_once { &all } else { &[] });
        for index in 0..self.checks.len() {
            let (check, by) = std::mem::take(&mut self.checks[index]);
            let first = rows.len();
            if at_once {
                let found = self.residuals(check);
                self.add(&mut rows, check, &found, &all);
            } else {
                for chunk in by.chunks(K) {
                    self.seed(chunk, chunk);
                    let found = self.residuals(check);
                    if rows.len() == first {
                        self.add(&mut rows, check, &found, chunk);
                    } else {
                        for (row, found) in rows[first..].iter_mut().zip(&found) {
                            row.slopes.extend(slopes(found, chunk));
                        }
                    }
                    self.seed(chunk, &[]);
                }
            }
            self.checks[index] = (check, by);
        }
        rows
    }

    fn add(&self, rows: &mut Vec<Row>, check: usize, found: &[Slope], unknowns: &[usize]) {
        let weight = self.state.weight[check];
        rows.extend(found.iter().map(|r| Row { value: r.value, weight, slopes: slopes(r, unknowns).collect() }));
    }

    /// Gives the entities of some unknowns their values, differentiated by those of `by`; rules follow.
    fn seed(&mut self, unknowns: &[usize], by: &[usize]) {
        let mut done: Vec<Entity> = Vec::with_capacity(4);
        let mut rules: Vec<usize> = Vec::new();
        for &index in unknowns {
            let entity = self.unknowns[index].entity;
            if done.contains(&entity) {
                continue;
            }
            done.push(entity);
            let own = (0..self.unknowns.len()).filter(|&u| self.unknowns[u].entity == entity);
            let own: Vec<(usize, usize)> = own.map(|u| (u, self.unknowns[u].index)).collect();
            let slope = |u: usize, value: f64| match by.iter().position(|b| *b == u) {
                Some(place) => Dual::unknown(value, place),
                None => Dual::constant(value),
            };
            let lift = |pose: &Pose| {
                let mut numbers: [V3<Slope>; 3] = pose.constant();
                own.iter().for_each(|&(u, i)| numbers[i / 3].0[i % 3] = slope(u, numbers[i / 3].0[i % 3].value));
                numbers
            };
            let plain = || own.iter().map(|&(u, i)| (i, self.values[u]));
            match entity {
                Entity::Object(id) => {
                    let [pos, rot, scale] = lift(&with_numbers(&self.state.pose(id), plain()));
                    self.world.place(id, pos, rot, scale);
                }
                Entity::Region(id) => {
                    let [pos, rot, scale] = lift(&with_numbers(&self.state.region_pose(id), plain()));
                    self.world.place_region(id, pos, rot, scale);
                }
                Entity::Variable(id) => {
                    let Ok(old) = self.state.world.variable(id) else { continue };
                    let mut parts = numbers(old).map(Slope::constant);
                    own.iter().for_each(|&(u, i)| parts[i] = slope(u, self.values[u]));
                    self.world.set_variable(id, super::lift(parts, old));
                }
            }
            rules.extend(rules_after(self.state, entity));
        }
        rules.sort_unstable();
        rules.dedup();
        for rule in rules {
            self.follow(rule);
        }
    }

    fn follow(&mut self, index: usize) {
        let rule = &self.state.frame.rules.list[index];
        if let Some([pos, rot, scale]) = rule.apply(self.world).filter(|_| self.state.is_placed(rule.owner)) {
            self.world.place(rule.owner, pos, rot, scale);
        }
    }

    /// What a check misses, with slopes.
    fn residuals(&mut self, index: usize) -> Vec<Slope> {
        let mut out = Vec::new();
        let tolerances = self.world.options.tolerances;
        match self.state.numbering.check(index) {
            Check::Term(t) => {
                let formula = &self.state.frame.terms[t].formula;
                self.work += 3 * formula.nodes.len() as u64;
                if self.scratch.evaluate(formula, self.world).is_ok() {
                    Merit { formula, values: self.scratch, tolerances: &tolerances }.residuals(&mut out);
                }
            }
            Check::Collide(a, b) => {
                self.work += 100;
                if let (Ok(x), Ok(y)) = (self.world.object(a), self.world.object(b)) {
                    let gap = gap(x, y);
                    out.extend((gap.value < 0.0).then(|| Slope::constant(APART) - gap));
                }
            }
            Check::Bounds(id) => {
                self.work += 50;
                if let Ok(truth) = rules::bounds::object(self.world, id) {
                    let missing = Slope::constant(tolerances.contact) - truth.margin;
                    out.extend((missing.value > 0.0).then_some(missing));
                }
            }
            Check::Support(_) => {}
        }
        out.retain(|r| r.value.is_finite() && r.slope.iter().all(|s| s.is_finite()));
        out
    }
}

fn slopes<'r>(residual: &'r Slope, unknowns: &'r [usize]) -> impl Iterator<Item = (usize, f64)> + 'r {
    unknowns.iter().copied().zip(residual.slope).filter(|(_, s)| *s != 0.0)
}

fn total(rows: &[Row]) -> f64 {
    rows.iter().map(|r| r.weight * r.value * r.value).sum()
}

/// The step of a damped system; `None` where it has no solution.
fn solve_damped(matrix: &DMatrix<f64>, right: &DVector<f64>, damping: f64) -> Option<DVector<f64>> {
    let mut damped = matrix.clone();
    for i in 0..damped.nrows() {
        damped[(i, i)] += damping * matrix[(i, i)] + 1e-9;
    }
    damped.cholesky().map(|c| c.solve(right))
}
