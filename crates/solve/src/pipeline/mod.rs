//! The whole procedure: set up, place, relax, repair; again from another placement if need be; then preferences.

pub(crate) mod batches;
pub(crate) mod bounds;
pub(crate) mod finish;
pub(crate) mod place;
pub(crate) mod portfolio;
pub(crate) mod preferences;
pub(crate) mod propose;
pub(crate) mod regions;
pub(crate) mod relax;
pub(crate) mod rounds;
pub(crate) mod select;
pub(crate) mod stay;
pub(crate) mod tidy;

use crate::diagnose;
use crate::external::steps::Steps;
use crate::problem::limit::Limit;
use crate::problem::setup::{Setup, setup};
use crate::problem::sound::sound;
use crate::problem::{End, Options, Outcome, Phase, Problem, Progress, QUALITY};
use crate::search::least_squares::Polisher;
use crate::search::local::LocalSearch;
use crate::search::state::State;
use crate::search::{Best, Search};
use portfolio::Member;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;
use scenelang_lang::program::RegionId;
use std::ops::ControlFlow;
use std::time::{Duration, Instant};

/// How much earlier an object is placed for each time it was in trouble.
const TROUBLE: f64 = 0.3;
/// How much larger open regions are made when a placement fails.
const GROWTH: f64 = 1.4;
/// The part of the time that the search has, if there is to be a diagnosis.
const SEARCHING: f64 = 0.8;
/// How often what is found is judged before it is handed out.
const JUDGED: u32 = 4;
/// The same for ways, by how long it takes just to look for them: to say why one is barred takes longer than that.
const PATHS_JUDGED: u32 = 14;
/// The part of the budget that the local search has where the older search may have to go on.
const LOCAL: f64 = 0.85;
/// The part of the budget for the first size of the open regions, and how much more each larger one has.
const SIZES: [f64; 2] = [0.03, 1.5];
/// More objects than these are not placed one by one after a local search: that alone would take longer than the search.
const MANY: usize = 150;

/// Lays out a scene. `progress` may end the search at any time: the best layout so far is then the outcome.
///
/// The same problem, options and seed give the same outcome, to the byte, unless `progress` ends the search.
pub fn solve(
    problem: &Problem<'_>,
    options: &Options,
    progress: &mut dyn FnMut(Progress) -> ControlFlow<()>,
) -> Outcome {
    solve_with(problem, options, &mut Steps::default(), progress)
}

/// The same with steps from outside in place of the solver's own, or before them.
pub fn solve_with(
    problem: &Problem<'_>,
    options: &Options,
    steps: &mut Steps<'_>,
    progress: &mut dyn FnMut(Progress) -> ControlFlow<()>,
) -> Outcome {
    let options = &options.budgeted(problem.program.objects.len());
    let whole = Limit::new(options.time, &options.stop);
    let part = if options.diagnose { SEARCHING } else { 1.0 };
    let limit = Limit::new(options.time.map(|time| time.mul_f64(part)), &options.stop);
    let cleaned = sound(problem);
    let problem = cleaned.as_ref().map_or(problem, |(problem, _)| problem);
    let mut setup = setup(problem, options);
    setup.warnings.extend(cleaned.iter().flat_map(|(_, said)| said.iter().cloned()));
    let setup = setup;
    let mut run = Run {
        limit,
        setup: &setup,
        problem,
        options,
        best: None,
        bonus: vec![0.0; setup.frame.program.objects.len()],
        iterations: 0,
        work: 0,
        is_over: false,
    };
    let mut attempt = 0;
    let (mut state, mut end) = loop {
        let (state, going) = run.attempt(attempt, steps, progress);
        attempt += 1;
        let end = if run.best.as_ref().is_some_and(|b| b.hard.0 == 0) {
            End::Solved
        } else if going.is_break() || run.limit.is_asked() {
            End::Asked
        } else if run.limit.is_late() {
            End::Time
        } else if run.work >= options.budget {
            End::Budget
        } else if run.is_over || steps.proposers_only || setup.frame.objects().all(|id| !setup.frame.is_movable(id)) {
            End::Exhausted
        } else {
            continue;
        };
        break (state, end);
    };
    if let Some(best) = &run.best {
        state = run.at(&best.snapshot, state);
    }
    let judging = Instant::now();
    let (mut layout, (mut unsatisfied, mut constraints)) = finish::layout(&setup, &state, &options.judge);
    // What is found is judged again, here and by whoever asked for it: there must be time for that.
    let whole = whole.earlier(JUDGED * judging.elapsed());
    let converged = finish::is_soft(&setup, &unsatisfied);
    if end == End::Solved && !converged {
        end = End::Exhausted;
    }
    let mut warnings = setup.warnings.clone();
    match end {
        End::Budget => warnings.push(format!(
            "the budget of {} units of work is spent; a larger budget or effort (`--effort` on the command line) allows more",
            options.budget
        )),
        End::Time => warnings.push("the time is over; what was found by then depends on the machine".to_owned()),
        End::Solved | End::Exhausted | End::Asked => {}
    }
    let mut in_the_way = finish::in_the_way(&setup, &unsatisfied);
    let (iterations, mut work) = (run.iterations, run.work);
    if options.diagnose && !steps.proposers_only && !converged && end != End::Asked {
        let answer = diagnose::diagnose(problem, options, &setup, &whole, (&layout, &unsatisfied));
        work += answer.work;
        if let Some(found) = answer.found.filter(|f| f.statements != in_the_way) {
            (unsatisfied, constraints) = finish::unsatisfied(&setup, &found.witness, &options.judge);
            (layout, in_the_way) = (found.witness, found.statements);
        }
    }
    Outcome { layout, converged, end, constraints, in_the_way, iterations, work, unsatisfied, warnings }
}

/// What the local search came to.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Locally {
    /// All holds.
    Holds,
    /// It saw nothing violated, but something is: a part is no box, or a thing stands otherwise than it knows.
    Nearly,
    /// It could not be made to hold with all the work that was allowed.
    Failed,
    /// Not all of it can be judged or moved there.
    Not,
}

/// The layout of a local search as that of the search proper.
fn show(local: &LocalSearch<'_>, state: &mut State<'_>) {
    let changes = local.changes();
    if state.attempt(&changes, f64::INFINITY).is_some() {
        state.keep();
    }
}

/// How long it takes to judge a layout in which ways over the floor are looked for.
fn judging(state: &mut State<'_>, local: &LocalSearch<'_>) -> Duration {
    show(local, state);
    let begun = Instant::now();
    state.look_at_ways();
    begun.elapsed()
}

/// What attempts share.
struct Run<'r, 'a> {
    limit: Limit,
    setup: &'r Setup<'a>,
    problem: &'r Problem<'a>,
    options: &'r Options,
    best: Option<Best>,
    bonus: Vec<f64>,
    iterations: usize,
    work: u64,
    /// Whether there is nothing more to try.
    is_over: bool,
}

impl<'r, 'a> Run<'r, 'a> {
    /// One placement with its repair; if that succeeds, preferences.
    fn attempt(
        &mut self,
        attempt: u64,
        steps: &mut Steps<'_>,
        progress: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> (State<'r>, ControlFlow<()>) {
        let mut search = self.search(attempt);
        let going = self.run(&mut search, attempt, steps, progress);
        if self.best.is_none() && search.best.is_none() {
            // Ended before there was a layout to speak of: nothing is left out all the same.
            place::anywhere(&mut search, &self.setup.given);
            search.note();
        }
        self.work = search.state.work;
        let better = |new: &Best, old: &Option<Best>| {
            old.as_ref().is_none_or(|old| Best::is_better((new.hard, new.soft), (old.hard, old.soft)))
        };
        if let Some(new) = search.best.take().filter(|new| better(new, &self.best)) {
            self.best = Some(new);
        }
        (search.state, going)
    }

    fn search(&self, attempt: u64) -> Search<'r> {
        let mut state = State::new(&self.setup.frame, self.setup.world.clone());
        state.work = self.work;
        state.limit = self.limit.clone();
        let polisher = Polisher::new(&state);
        let mut chance = self.chance(attempt);
        let priority = place::priorities(&self.setup.frame, &self.bonus, &mut chance);
        Search { state, polisher, chance, options: self.options, priority, best: None }
    }

    fn run(
        &mut self,
        search: &mut Search<'_>,
        attempt: u64,
        steps: &mut Steps<'_>,
        progress: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> ControlFlow<()> {
        let known = |id: RegionId| {
            let name = &self.setup.frame.program.regions[id.0 as usize].name;
            self.problem.placed.region(id) && self.problem.start.region(name).is_some()
        };
        regions::arrange(search, GROWTH.powi(attempt as i32), &known);
        progress(search.progress(Phase::InitialPlacement, self.iterations))?;
        let is_open = self.setup.frame.has_open_regions();
        let again = is_open && self.setup.frame.is_all_local();
        let locally =
            if (attempt == 0 || again) && steps.is_default() { self.local(search, attempt) } else { Locally::Not };
        if locally == Locally::Holds {
            stay::put_back(search, &self.setup.given);
            search.note();
            return ControlFlow::Continue(());
        }
        if locally == Locally::Failed {
            // A larger room may hold what a smaller one does not.
            self.is_over = !is_open;
            return ControlFlow::Continue(());
        }
        let many = self.setup.frame.program.objects.len() > MANY;
        let spent = search.state.work as f64 >= LOCAL * self.options.budget as f64;
        if search.best.is_some() && (search.is_late() || many && spent) {
            return ControlFlow::Continue(());
        }
        if locally == Locally::Not {
            place::initial(search, steps, &self.setup.given);
            progress(search.progress(Phase::PhysicsRelaxation, self.iterations))?;
            if !search.outside_relax(steps) {
                relax::relax(search);
            }
            search.note();
        }
        search.outside_rounds(steps, &mut self.iterations, progress)?;
        let rounds = if steps.proposers_only { 0 } else { self.options.rounds };
        let solved = search.repair(rounds, steps, &mut self.iterations, progress)?;
        if let Some(best) = search.best.as_ref().map(|b| b.snapshot.clone()) {
            search.restore(&best);
        }
        if solved {
            self.finish(search, progress)?;
        } else {
            for check in search.state.failing() {
                for id in search.state.objects_of(check) {
                    self.bonus[id.0 as usize] += TROUBLE;
                }
            }
        }
        ControlFlow::Continue(())
    }

    /// The local search, where it can judge all that must hold.
    fn local(&self, search: &mut Search<'_>, attempt: u64) -> Locally {
        let mut given = vec![false; self.setup.frame.program.objects.len()];
        let mut world = search.state.world().clone();
        for id in self.setup.frame.objects() {
            let known = self.setup.given.iter().find(|(o, _)| *o == id);
            given[id.0 as usize] = known.is_some();
            let fixed = self.setup.frame.fixed(id).pos;
            let pose = known.and_then(|(_, pose)| *pose).unwrap_or_else(|| {
                let mut home = search.state.home(id);
                (0..3).filter(|&axis| !fixed[axis]).for_each(|axis| home.pos[axis] = 0.0);
                home
            });
            let [pos, rot, scale] = pose.constant();
            world.place(id, pos, rot, scale);
        }
        let numbering = search.state.numbering;
        let member = |which: u64| {
            let mut local = LocalSearch::new(&self.setup.frame, &world, numbering)?;
            local.remember_homes(&given);
            Some(Member { local, chance: self.chance(which << 48) })
        };
        let Some(mut first) = member(0) else { return Locally::Not };
        let is_all = self.setup.frame.is_all_local();
        let share = match (is_all, self.setup.frame.has_open_regions()) {
            (true, true) => SIZES[0] * SIZES[1].powi(attempt as i32),
            (true, false) => 1.0,
            (false, _) => LOCAL,
        };
        let left = self.options.budget.saturating_sub(search.state.work);
        let budget = left.min((self.options.budget as f64 * share) as u64);
        let mut limit = self.limit.clone();
        if limit.left().is_some() && !self.setup.frame.walks.is_empty() {
            first.local.search(&mut first.chance, 0, &limit, &given);
            limit = limit.earlier(PATHS_JUDGED * judging(&mut search.state, &first.local));
        }
        let threads = self.options.threads();
        let another = || member(1).map(|other| Member { local: other.local.of_another_kind(), ..other });
        let (Member { mut local, mut chance }, mut solved) =
            portfolio::search(first, another, budget, &limit, &given, threads);
        if solved {
            local.move_less(&mut chance, &limit, &given);
        }
        let mut for_preferences = (self.options.budget as f64 * self.options.polish) as u64;
        let holds = loop {
            if solved {
                let begun = local.work;
                let preferences = for_preferences.min(budget.saturating_sub(begun));
                let quality = self.options.polish * 100.0 / f64::from(QUALITY);
                local.improve_preferences(&mut chance, (preferences, quality), &limit, !self.setup.given.is_empty());
                for_preferences = for_preferences.saturating_sub(local.work - begun);
            }
            if solved && self.setup.given.is_empty() {
                local.tidy(&mut chance, &limit);
            }
            show(&local, &mut search.state);
            let holds = solved && search.state.hard().0 == 0;
            // What was thought to hold may not: it is judged otherwise from then on, and one goes on from here.
            let over = limit.is_over() || local.work >= budget;
            if !solved || holds || over || !local.doubt(&search.state.failing()) {
                break holds;
            }
            given.fill(true);
            solved = local.search(&mut chance, budget - local.work, &limit, &given);
            if !solved {
                local.restore_best();
            }
        };
        search.state.work += local.work;
        if holds {
            return Locally::Holds;
        }
        search.note();
        if solved {
            return Locally::Nearly;
        }
        if is_all {
            return Locally::Failed;
        }
        self.setup.frame.objects().for_each(|id| search.state.banish(id));
        Locally::Not
    }

    /// The random numbers of an attempt.
    fn chance(&self, attempt: u64) -> ChaCha8Rng {
        let mut chance = ChaCha8Rng::seed_from_u64(self.options.seed);
        chance.set_stream(attempt + (self.options.variant << 32));
        chance
    }

    /// Improves a layout in which everything holds.
    fn finish(
        &self,
        search: &mut Search<'_>,
        progress: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> ControlFlow<()> {
        progress(search.progress(Phase::Preferences, self.iterations))?;
        let spent = search.state.work as f64 / self.options.budget as f64;
        preferences::improve(search, (spent + self.options.polish).min(1.0), !self.setup.given.is_empty());
        if !self.setup.given.is_empty() {
            stay::put_back(search, &self.setup.given);
            search.best = None;
        }
        for id in self.setup.frame.objects().filter(|id| self.setup.frame.is_movable(*id)) {
            if search.is_late() {
                break;
            }
            // Who is where somebody wanted it stays there to the last digit.
            if !self.setup.given.contains(&(id, Some(search.state.pose(id)))) {
                tidy::object(&mut search.state, id);
            }
        }
        search.note();
        ControlFlow::Continue(())
    }

    /// A state that shows a layout.
    fn at(&self, snapshot: &crate::search::Snapshot, old: State<'r>) -> State<'r> {
        let polisher = Polisher::new(&old);
        let chance = ChaCha8Rng::seed_from_u64(self.options.seed);
        let mut search =
            Search { state: old, polisher, chance, options: self.options, priority: Vec::new(), best: None };
        search.restore(snapshot);
        search.state
    }
}
