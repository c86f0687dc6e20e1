//! The equations, and their solution by damped least squares (Levenberg and Marquardt).
//!
//! Plain numbers say which checks miss something, and whether a step is one for the better; slopes are taken only of
//! these.

use super::{Entity, K, Slope, Unknown, Worlds, lift, numbers, rules_after, touched_objects, with_numbers};
use crate::problem::pose::Pose;
use nalgebra::{DMatrix, DVector};
use scenelang_engine::Mirror;
use scenelang_engine::candidate::Candidate;
use scenelang_engine::frame::checks::Check;
use scenelang_engine::penalty::Penalty;
use scenelang_lang::program::ObjectId;
use scenelang_verify::vector::V3;
use scenelang_verify::{Algebra, Dual, Number, Scratch, World};

/// Steps at most.
const STEPS: usize = 25;
/// Longest step of a length (metres) and of an angle (degrees).
const STEP: [f64; 2] = [1.0, 40.0];
/// How often a step is shortened before the search ends.
const TRIES: usize = 4;

/// A residual: its value and its slopes by unknowns.
struct Row {
    value: f64,
    weight: f64,
    slopes: Vec<(usize, f64)>,
}

/// A check among the equations.
struct Equation {
    check: usize,
    /// The unknowns that it depends on.
    by: Vec<usize>,
    /// How many residuals it has at the current values.
    missing: usize,
}

/// The residuals of some checks as functions of some unknowns.
pub(super) struct System<'s, 'a> {
    state: &'s Candidate<'a>,
    worlds: &'s mut Worlds,
    /// What is to be found.
    pub unknowns: Vec<Unknown>,
    /// By unknown.
    pub values: Vec<f64>,
    /// Work done.
    pub work: u64,
    entities: Vec<Entity>,
    equations: Vec<Equation>,
    /// Rules that follow the unknowns, in order.
    rules: Vec<usize>,
}

impl<'s, 'a> System<'s, 'a> {
    /// For a state and worlds that agree with it.
    pub fn new(state: &'s Candidate<'a>, worlds: &'s mut Worlds, unknowns: Vec<Unknown>) -> Self {
        let mut entities: Vec<Entity> = unknowns.iter().map(|u| u.entity).collect();
        entities.dedup();
        let mut rules: Vec<usize> = entities.iter().flat_map(|e| rules_after(state, *e)).copied().collect();
        rules.sort_unstable();
        rules.dedup();
        let (values, equations, work) = (Vec::new(), Vec::new(), 0);
        let mut system = Self { state, worlds, unknowns, values, work, entities, equations, rules };
        system.values = system.unknowns.iter().map(|u| system.start(u)).collect();
        system.find_equations();
        system
    }

    fn start(&self, unknown: &Unknown) -> f64 {
        let of = |pose: Pose| match unknown.index {
            0..3 => pose.pos[unknown.index],
            i => pose.scale[i - 6],
        };
        match unknown.entity {
            Entity::Object(id) => of(self.state.pose(id)),
            Entity::Region(id) => of(self.state.region_pose(id)),
            Entity::Variable(id) => self.state.world().variable(id).map_or(0.0, |v| numbers(v)[unknown.index]),
        }
    }

    fn find_equations(&mut self) {
        let state = self.state;
        let frame = state.frame;
        // Which unknowns each moved object depends on.
        let mut moved: Vec<(ObjectId, Vec<usize>)> = Vec::new();
        let mut place_of = vec![usize::MAX; state.numbering.len()];
        let mut equations: Vec<Equation> = Vec::new();
        let mut add = |check: usize, by: &[usize]| {
            if place_of[check] == usize::MAX {
                place_of[check] = equations.len();
                equations.push(Equation { check, by: by.to_vec(), missing: 0 });
            } else {
                let list = &mut equations[place_of[check]].by;
                by.iter().for_each(|u| {
                    if !list.contains(u) {
                        list.push(*u);
                    }
                });
            }
        };
        for &entity in &self.entities {
            let own: Vec<usize> = (0..self.unknowns.len()).filter(|&u| self.unknowns[u].entity == entity).collect();
            for object in touched_objects(state, entity) {
                match moved.iter_mut().find(|(o, _)| *o == object) {
                    Some((_, list)) => list.extend(&own),
                    None => moved.push((object, own.clone())),
                }
            }
            let terms = match entity {
                Entity::Object(_) => continue,
                Entity::Region(id) => frame.index.of_region(id),
                Entity::Variable(id) => frame.index.of_variable(id),
            };
            terms.iter().for_each(|&t| add(t, &own));
        }
        for (object, by) in &moved {
            frame.index.of_object(*object).iter().for_each(|&t| add(t, by));
        }
        equations.retain(|e| frame.terms.get(e.check).is_none_or(|t| !t.walks && state.is_active(e.check)));
        self.equations = equations;
    }

    /// Steps towards less.
    pub fn solve(&mut self) {
        let mut sum = self.measure();
        let mut damping = 1e-3;
        for _ in 0..STEPS {
            if sum < 1e-14 || self.state.limit.is_over() {
                break;
            }
            let (matrix, right) = self.normal();
            let before = self.values.clone();
            let mut better = false;
            for _ in 0..TRIES {
                let Some(step) = solve_damped(&matrix, &right, damping) else { break };
                let unknowns = self.unknowns.iter().zip(before.iter().zip(step.iter()));
                for (value, (unknown, (old, s))) in self.values.iter_mut().zip(unknowns) {
                    let longest = STEP[usize::from(unknown.angle)];
                    *value = old + s.clamp(-longest, longest);
                }
                let next = self.measure();
                if next < sum * (1.0 - 1e-4) {
                    // What is nearly nothing less is not worth another step.
                    better = next < sum * (1.0 - 1e-3) || sum > 1e-4;
                    sum = next;
                    damping = (damping * 0.2).max(1e-9);
                    break;
                }
                self.values.clone_from(&before);
                damping *= 8.0;
            }
            if !better {
                break;
            }
        }
    }

    /// The weighted sum of squares at the current values.
    fn measure(&mut self) -> f64 {
        self.work += 30 * (self.entities.len() + self.rules.len()) as u64;
        for index in 0..self.entities.len() {
            let entity = self.entities[index];
            match entity {
                Entity::Object(id) => {
                    let pose = with_numbers(&self.state.pose(id), self.own(entity));
                    self.worlds.plain.set(id, pose.constant());
                }
                Entity::Region(id) => {
                    let pose = with_numbers(&self.state.region_pose(id), self.own(entity));
                    self.worlds.plain.set_region(id, pose.constant());
                }
                Entity::Variable(id) => {
                    let Ok(old) = self.state.world().variable(id) else { continue };
                    let mut parts = numbers(old);
                    self.own(entity).for_each(|(i, v)| parts[i] = v);
                    self.worlds.plain.set_variable(id, lift(parts, old));
                }
            }
        }
        for &rule in &self.rules {
            follow(self.state, rule, &mut self.worlds.plain);
        }
        let mut sum = 0.0;
        let mut found: Vec<f64> = Vec::new();
        for equation in &mut self.equations {
            found.clear();
            self.work += residuals(
                self.state,
                equation.check,
                self.worlds.plain.world(),
                &mut self.worlds.scratch.0,
                &mut found,
            );
            equation.missing = found.len();
            sum += self.state.weight[equation.check] * found.iter().map(|r| r * r).sum::<f64>();
        }
        sum
    }

    /// The numbers of an entity at the current values.
    fn own(&self, entity: Entity) -> impl Iterator<Item = (usize, f64)> + '_ {
        let all = self.unknowns.iter().zip(&self.values);
        all.filter(move |(u, _)| u.entity == entity).map(|(u, v)| (u.index, *v))
    }

    /// JᵀWJ and -JᵀWr at the current values.
    fn normal(&mut self) -> (DMatrix<f64>, DVector<f64>) {
        let rows = self.rows();
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

    /// The residuals at the current values, with their slopes.
    fn rows(&mut self) -> Vec<Row> {
        let mut rows: Vec<Row> = Vec::new();
        let all: Vec<usize> = (0..self.unknowns.len()).collect();
        let at_once = all.len() <= K;
        self.seed(&all, if at_once { &all } else { &[] });
        let mut found: Vec<Slope> = Vec::new();
        for index in (0..self.equations.len()).filter(|&e| self.equations[e].missing > 0).collect::<Vec<_>>() {
            if self.state.limit.is_over() {
                break;
            }
            let check = self.equations[index].check;
            let by = if at_once { all.clone() } else { self.equations[index].by.clone() };
            let (first, weight) = (rows.len(), self.state.weight[check]);
            for chunk in by.chunks(K) {
                if !at_once {
                    self.seed(chunk, chunk);
                }
                found.clear();
                self.work += 4 * residuals(
                    self.state,
                    check,
                    self.worlds.slopes.world(),
                    &mut self.worlds.scratch.1,
                    &mut found,
                );
                if rows.len() == first {
                    rows.extend(found.iter().map(|r| Row { value: r.value, weight, slopes: Vec::new() }));
                }
                for (row, found) in rows[first..].iter_mut().zip(&found) {
                    row.slopes.extend(slopes(found, chunk));
                }
                if !at_once {
                    self.seed(chunk, &[]);
                }
            }
        }
        rows
    }

    /// Gives the entities of some unknowns their values, differentiated by those of `by`; rules follow.
    fn seed(&mut self, unknowns: &[usize], by: &[usize]) {
        let mut entities: Vec<Entity> = unknowns.iter().map(|&u| self.unknowns[u].entity).collect();
        entities.dedup();
        let mut rules: Vec<usize> = Vec::new();
        self.work += 100 * entities.len() as u64;
        for &entity in &entities {
            let own: Vec<(usize, usize)> = (0..self.unknowns.len())
                .filter(|&u| self.unknowns[u].entity == entity)
                .map(|u| (u, self.unknowns[u].index))
                .collect();
            let slope = |u: usize, value: f64| match by.iter().position(|b| *b == u) {
                Some(place) => Dual::unknown(value, place),
                None => Dual::constant(value),
            };
            let lifted = |pose: &Pose| {
                let mut numbers: [V3<Slope>; 3] = pose.constant();
                own.iter().for_each(|&(u, i)| numbers[i / 3].0[i % 3] = slope(u, numbers[i / 3].0[i % 3].value));
                numbers
            };
            match entity {
                Entity::Object(id) => {
                    let pose = lifted(&with_numbers(&self.state.pose(id), self.own(entity)));
                    self.worlds.slopes.set(id, pose);
                }
                Entity::Region(id) => {
                    let pose = lifted(&with_numbers(&self.state.region_pose(id), self.own(entity)));
                    self.worlds.slopes.set_region(id, pose);
                }
                Entity::Variable(id) => {
                    let Ok(old) = self.state.world().variable(id) else { continue };
                    let mut parts = numbers(old).map(Slope::constant);
                    own.iter().for_each(|&(u, i)| parts[i] = slope(u, self.values[u]));
                    self.worlds.slopes.set_variable(id, lift(parts, old));
                }
            }
            rules.extend(rules_after(self.state, entity));
        }
        rules.sort_unstable();
        rules.dedup();
        for rule in rules {
            follow(self.state, rule, &mut self.worlds.slopes);
        }
    }
}

/// Obeys a rule in a world.
fn follow<N: Number>(state: &Candidate<'_>, index: usize, mirror: &mut Mirror<N>) {
    let rule = &state.frame.rules.list[index];
    if let Some(pose) = rule.apply(mirror.world()).filter(|_| state.is_placed(rule.owner)) {
        mirror.set(rule.owner, pose);
    }
}

/// What a check misses in a world; the work of finding it.
fn residuals<N: Number>(
    state: &Candidate<'_>,
    index: usize,
    world: &World<N>,
    scratch: &mut Scratch<N>,
    out: &mut Vec<N>,
) -> u64 {
    let tolerances = &world.options.tolerances;
    let work = match state.numbering.check(index) {
        Check::Term(t) => {
            let formula = &state.frame.terms[t].formula;
            if scratch.evaluate(formula, world).is_ok() {
                Penalty { formula, values: scratch, tolerances, numbers: std::marker::PhantomData }.residuals(out);
            }
            formula.nodes.len() as u64
        }
        // Nothing is placed yet where sizes and regions are looked for.
        Check::Collide(..) | Check::Bounds(_) | Check::Support(_) => 1,
    };
    out.retain(|r| r.value().is_finite());
    work
}

fn slopes<'r>(residual: &'r Slope, unknowns: &'r [usize]) -> impl Iterator<Item = (usize, f64)> + 'r {
    unknowns.iter().copied().zip(residual.slope).filter(|(_, s)| *s != 0.0 && s.is_finite())
}

/// The step of a damped system; `None` where it has no solution.
fn solve_damped(matrix: &DMatrix<f64>, right: &DVector<f64>, damping: f64) -> Option<DVector<f64>> {
    let mut damped = matrix.clone();
    for i in 0..damped.nrows() {
        damped[(i, i)] += damping * matrix[(i, i)] + 1e-9;
    }
    damped.cholesky().map(|c| c.solve(right))
}
