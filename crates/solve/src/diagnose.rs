//! Where not all can hold, as far as the search can tell: few statements without which the rest holds.
//!
//! Whatever is named has a witness, a layout in which all else holds. It begins with what the best layout violates. Then
//! statements are demanded again, one at a time, each time from the layout found last; and other statements around are
//! tried in their stead. What comes of it is minimal as far as a small search can tell. Nothing is proved by it.

use crate::pipeline::finish;
use crate::pipeline::solve;
use crate::problem::setup::Setup;
use crate::problem::{Options, Outcome, Placed, Problem, TermSubject, Unsatisfied};
use scenelang_engine::limit::Limit;
use scenelang_lang::Program;
use scenelang_lang::program::{ConstraintKind, Formula, Node, NodeId, ObjectId, Owner};
use scenelang_layout::Layout;
use std::ops::ControlFlow;

/// The part of the budget that all of it may take, beside that of the search.
const SHARE: f64 = 0.25;
/// Work that one question may take: at least, and for each object.
const QUESTION: [u64; 2] = [1_000_000, 40_000];
/// How often what a search leaves violated is given up, too, before there is a layout in which the rest holds.
const ROUNDS: usize = 6;
/// How many statements around are tried in place of what was found.
const OTHERS: usize = 12;
/// How many other first layouts are looked at.
const VARIANTS: u64 = 2;

/// Few statements in the way, and a layout in which all the others hold.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Diagnosis {
    /// Indices into [`Program::constraints`], sorted.
    pub statements: Vec<usize>,
    /// The layout: all violated in it are these.
    pub witness: Layout,
}

/// What came of all the questions, and the work that they took.
pub(crate) struct DiagnosisOutcome {
    /// The diagnosis, if there is one.
    pub found: Option<Diagnosis>,
    /// Work done.
    pub work: u64,
}

/// Looks for few statements in the way, from a layout that violates some.
pub(crate) fn diagnose(
    problem: &Problem<'_>,
    options: &Options,
    setup: &Setup<'_>,
    limit: &Limit,
    (best, violated): (&Layout, &[Unsatisfied]),
) -> DiagnosisOutcome {
    let budget = (options.budget as f64 * SHARE) as u64;
    let mut search = Search { problem, options, setup, limit, budget, work: 0, found: None };
    search.establish(best, violated);
    search.shrink();
    search.exchange();
    search.vary();
    DiagnosisOutcome { found: search.found, work: search.work }
}

struct Search<'s, 'a> {
    problem: &'s Problem<'a>,
    options: &'s Options,
    setup: &'s Setup<'a>,
    limit: &'s Limit,
    budget: u64,
    work: u64,
    found: Option<Diagnosis>,
}

impl Search<'_, '_> {
    fn is_over(&self) -> bool {
        self.work >= self.budget || self.limit.is_over()
    }

    fn count(&self) -> usize {
        self.found.as_ref().map_or(usize::MAX, |f| f.statements.len())
    }

    /// Gives up what is violated until the rest holds.
    fn establish(&mut self, best: &Layout, violated: &[Unsatisfied]) {
        if self.learn(best, violated) {
            return;
        }
        let mut removed = self.statements(violated);
        let (mut from, mut violated) = (best.clone(), violated.to_vec());
        for _ in 0..ROUNDS {
            let physical = violated.iter().all(|u| !matches!(u.what, TermSubject::Stated(_)));
            let more = if physical { self.speaking_of(&violated) } else { self.statements(&violated) };
            let before = removed.len();
            removed.extend(more);
            removed.sort_unstable();
            removed.dedup();
            if physical && removed.len() == before || self.is_over() {
                return;
            }
            let outcome = self.ask(&removed, &from);
            if self.found.is_some() {
                return;
            }
            (from, violated) = (outcome.layout, outcome.unsatisfied);
        }
    }

    /// Demands statements again, one at a time: what the program fixes first, and of the rest what is said first.
    fn shrink(&mut self) {
        let Some(found) = &self.found else { return };
        let mut order = found.statements.clone();
        order.sort_by_key(|s| (self.setup.frame.program.constraints[*s].kind != ConstraintKind::Pin, *s));
        for statement in order {
            let Some(found) = self.found.as_ref().filter(|f| f.statements.len() > 1) else { return };
            if self.is_over() {
                return;
            }
            if found.statements.contains(&statement) {
                let removed: Vec<usize> = found.statements.iter().copied().filter(|s| *s != statement).collect();
                let from = found.witness.clone();
                self.ask(&removed, &from);
            }
        }
    }

    /// Tries single statements around in place of several.
    fn exchange(&mut self) {
        let Some(found) = self.found.clone() else { return };
        for statement in self.around(&found.statements) {
            if self.count() == 1 || self.is_over() {
                return;
            }
            self.ask(&[statement], &found.witness);
        }
    }

    /// Begins anew from other first layouts.
    fn vary(&mut self) {
        for variant in 1..=VARIANTS {
            if self.count() <= 2 || self.is_over() {
                return;
            }
            let problem = Problem { placed: self.problem.placed.clone(), ..self.problem.clone() };
            let options = Options { variant: self.options.variant + variant, ..self.question() };
            let outcome = solve(&problem, &options, &mut |_| ControlFlow::Continue(()));
            self.work += outcome.work.max(1);
            if self.learn(&outcome.layout, &outcome.unsatisfied) {
                self.shrink();
            }
        }
    }

    fn question(&self) -> Options {
        let [least, each] = QUESTION;
        let most = least + each * self.setup.frame.program.objects.len() as u64;
        Options {
            budget: most.min(self.budget.saturating_sub(self.work)).max(1),
            time: self.limit.left(),
            diagnose: false,
            polish: 0.0,
            ..self.options.clone()
        }
    }

    /// Searches, from a layout, for one in which all but some statements hold.
    fn ask(&mut self, removed: &[usize], from: &Layout) -> Outcome {
        let program = without(self.problem.program, removed);
        let problem = Problem { program: &program, start: from.clone(), placed: Placed::All };
        let mut outcome = solve(&problem, &self.question(), &mut |_| ControlFlow::Continue(()));
        self.work += outcome.work.max(1);
        // By the whole program, of which more may hold than was asked for.
        outcome.unsatisfied = finish::unsatisfied(self.setup, &outcome.layout, &self.options.judge).0;
        let all = outcome.unsatisfied.clone();
        self.learn(&outcome.layout, &all);
        outcome.unsatisfied.retain(|u| !matches!(u.what, TermSubject::Stated(s) if removed.contains(&s)));
        outcome
    }

    /// Remembers a layout in which only statements are violated, if those are fewer than ever. Whether they are.
    fn learn(&mut self, layout: &Layout, violated: &[Unsatisfied]) -> bool {
        let statements = finish::in_the_way(self.setup, violated);
        let fewer = !statements.is_empty() && statements.len() < self.count();
        if fewer {
            self.found = Some(Diagnosis { statements, witness: layout.clone() });
        }
        fewer
    }

    /// Statements that must hold and are violated.
    fn statements(&self, violated: &[Unsatisfied]) -> Vec<usize> {
        let stated = violated.iter().filter_map(|u| match u.what {
            TermSubject::Stated(index) => Some(index),
            _ => None,
        });
        stated.filter(|s| self.is_hard(*s)).collect()
    }

    fn is_hard(&self, statement: usize) -> bool {
        !matches!(self.setup.frame.program.constraints[statement].kind, ConstraintKind::Prefer { .. })
    }

    /// Statements that must hold and speak of objects that violate a physical rule.
    fn speaking_of(&self, violated: &[Unsatisfied]) -> Vec<usize> {
        let program = self.setup.frame.program;
        let mut objects: Vec<ObjectId> = Vec::new();
        for each in violated {
            let names = match &each.what {
                TermSubject::Stated(_) => continue,
                TermSubject::Collision(a, b) => vec![a, b],
                TermSubject::Bounds(a) | TermSubject::Support(a) => vec![a],
                TermSubject::Open(a, met) => std::iter::once(a).chain(met).collect(),
            };
            let ids = self.setup.frame.objects().filter(|id| names.iter().any(|n| *n == self.setup.frame.name(*id)));
            objects.extend(ids);
        }
        let speaks = |s: &usize| program.constraints[*s].formula.objects().iter().any(|o| objects.contains(o));
        (0..program.constraints.len()).filter(|s| self.is_hard(*s)).filter(speaks).collect()
    }

    /// Statements that must hold and share objects with these: assertions first, then what the program fixes; of each
    /// those that share most.
    fn around(&self, statements: &[usize]) -> Vec<usize> {
        let program = self.setup.frame.program;
        let objects: Vec<Vec<ObjectId>> =
            statements.iter().map(|s| program.constraints[*s].formula.objects()).collect();
        let region = |s: usize| program.pins.iter().any(|p| p.constraint == s && matches!(p.owner, Owner::Region(_)));
        let mut found: Vec<(bool, usize, usize)> = Vec::new();
        for s in (0..program.constraints.len()).filter(|s| self.is_hard(*s) && !region(*s)) {
            let own = program.constraints[s].formula.objects();
            let shared = objects.iter().filter(|list| list.iter().any(|o| own.contains(o))).count();
            if shared > 1 {
                found.push((program.constraints[s].kind == ConstraintKind::Pin, statements.len() - shared, s));
            }
        }
        found.sort_unstable();
        found.into_iter().take(OTHERS).map(|(_, _, s)| s).collect()
    }
}

/// The program without some of its statements; indices stay as they are.
fn without(program: &Program, removed: &[usize]) -> Program {
    let mut program = program.clone();
    for &statement in removed {
        let says_nothing = Formula { nodes: vec![Node::Truth(true)], ranges: Vec::new(), root: NodeId(0) };
        program.constraints[statement].formula = says_nothing;
    }
    program.pins.retain(|pin| !removed.contains(&pin.constraint));
    program
}
