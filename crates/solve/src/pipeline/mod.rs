//! The whole procedure: set up, search, judge; again with larger open regions if need be. Proposers from outside have
//! their rounds before the search.

pub(crate) mod bounds;
pub(crate) mod finish;
pub(crate) mod place;
pub(crate) mod portfolio;
pub(crate) mod regions;
pub(crate) mod rounds;
pub(crate) mod select;
pub(crate) mod stay;

use crate::diagnose;
use crate::external::steps::Steps;
use crate::problem::pose::Pose;
use crate::problem::setup::{Setup, setup};
use crate::problem::sound::sound;
use crate::problem::{End, Options, Outcome, Phase, Problem, Progress, QUALITY};
use crate::search::local::LocalSearch;
use crate::search::{Best, Search};
use portfolio::Member;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;
use scenelang_engine::Instant;
use scenelang_engine::candidate::Candidate;
use scenelang_engine::limit::Limit;
use scenelang_lang::program::{ObjectId, RegionId};
use std::ops::ControlFlow;
use std::time::Duration;

/// What is said where the time limit has ended something.
const TIME_IS_OVER: &str = "the time limit was reached; the result depends on the speed of the machine";
/// How much larger open regions are made when a placement fails.
const GROWTH: f64 = 1.4;
/// The part of the time that the search has, if there is to be a diagnosis.
const SEARCHING: f64 = 0.8;
/// How often what is found is judged before it is handed out.
const JUDGED: u32 = 4;
/// The same for ways, by how long it takes just to look for them: to say why one is barred takes longer than that.
const PATHS_JUDGED: u32 = 14;
/// The part of the budget for a search in which things stand upright, where the program may be taken to ask otherwise.
const UPRIGHT: f64 = 0.5;
/// The part of the budget for the first size of the open regions, and how much more each larger one has.
const SIZES: [f64; 2] = [0.03, 1.5];
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
        iterations: 0,
        work: 0,
        is_over: false,
        is_cut: false,
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
            "the budget of {} units of work is used up; a larger budget or effort (`--effort` on the command line) allows more",
            options.budget
        )),
        End::Time => warnings.push(TIME_IS_OVER.to_owned()),
        End::Solved if run.is_cut => warnings.push(TIME_IS_OVER.to_owned()),
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

/// The layout of a local search as that of the search proper.
fn show(local: &LocalSearch<'_>, state: &mut Candidate<'_>) {
    let changes = local.trial.changes();
    if state.attempt(&changes, f64::INFINITY).is_some() {
        state.keep();
    }
}

/// How long it takes to judge a layout in which ways over the floor are looked for.
fn judging(state: &mut Candidate<'_>, local: &LocalSearch<'_>) -> Duration {
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
    iterations: usize,
    work: u64,
    /// Whether there is nothing more to try.
    is_over: bool,
    /// Whether the time ended a search, be it only that for preferences and round numbers.
    is_cut: bool,
}

impl<'r, 'a> Run<'r, 'a> {
    /// One search.
    fn attempt(
        &mut self,
        attempt: u64,
        steps: &mut Steps<'_>,
        progress: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> (Candidate<'r>, ControlFlow<()>) {
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
        let mut state = Candidate::new(&self.setup.frame, self.setup.world.clone());
        state.work = self.work;
        state.limit = self.limit.clone();
        Search { state, chance: self.chance(attempt), options: self.options, best: None }
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
        let given = &self.setup.given;
        if steps.is_default() {
            self.local(search, attempt, given);
        } else {
            self.advised(search, attempt, steps, progress)?;
        }
        if search.state.hard().0 == 0 {
            stay::put_back(search, given);
        }
        search.note();
        // A larger room may hold what a smaller one does not, and what leans may fit where what is upright does not.
        self.is_over = !self.setup.frame.has_open_regions() && (attempt > 0 || !self.may_lean());
        ControlFlow::Continue(())
    }

    /// Whether the program speaks of the tilt of something that can be moved.
    fn may_lean(&self) -> bool {
        let frame = &self.setup.frame;
        frame.objects().any(|id| frame.tilts[id.0 as usize] && frame.is_movable(id))
    }

    /// A first layout, what proposers from outside make of it, and, unless only they are to be heard, the local search from
    /// there.
    fn advised(
        &mut self,
        search: &mut Search<'_>,
        attempt: u64,
        steps: &mut Steps<'_>,
        progress: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> ControlFlow<()> {
        if steps.placer.is_none() && self.setup.frame.objects().any(|id| self.has_no_place(id)) {
            let (mut first, given) = self.begin(search, attempt, &self.setup.given, 0);
            first.local.search(&mut first.chance, 0, &self.limit, &given);
            show(&first.local, &mut search.state);
        }
        place::initial(search, steps, &self.setup.given);
        progress(search.progress(Phase::PhysicsRelaxation, self.iterations))?;
        search.outside_relax(steps);
        search.note();
        search.outside_rounds(steps, &mut self.iterations, progress)?;
        if !steps.proposers_only {
            let here: Vec<(ObjectId, Option<Pose>)> =
                self.setup.frame.objects().map(|id| (id, Some(search.state.pose(id)))).collect();
            self.local(search, attempt, &here);
        }
        ControlFlow::Continue(())
    }

    fn has_no_place(&self, id: ObjectId) -> bool {
        !self.setup.given.iter().any(|(given, _)| *given == id)
    }

    /// A local search in which some objects have a place, and which these are.
    fn begin(
        &self,
        search: &mut Search<'_>,
        attempt: u64,
        given: &[(ObjectId, Option<Pose>)],
        which: u64,
    ) -> (Member<'r>, Vec<bool>) {
        let mut is_given = vec![false; self.setup.frame.program.objects.len()];
        let mut world = search.state.world().clone();
        for id in self.setup.frame.objects() {
            let known = given.iter().find(|(o, _)| *o == id);
            is_given[id.0 as usize] = known.is_some();
            let fixed = self.setup.frame.fixed(id).pos;
            let pose = known.and_then(|(_, pose)| *pose).unwrap_or_else(|| {
                let mut home = search.state.home(id);
                (0..3).filter(|&axis| !fixed[axis]).for_each(|axis| home.pos[axis] = 0.0);
                home
            });
            let [pos, rot, scale] = pose.constant();
            world.place(id, pos, rot, scale);
        }
        let mut local = LocalSearch::new(&self.setup.frame, &world, search.state.numbering, attempt > 0);
        local.remember_homes(&is_given);
        (Member { local, chance: self.chance(which << 48) }, is_given)
    }

    /// The local search, and its layout in the search proper.
    fn local(&mut self, search: &mut Search<'_>, attempt: u64, from: &[(ObjectId, Option<Pose>)]) {
        let (mut first, mut given) = self.begin(search, attempt, from, 0);
        let share = match (self.setup.frame.has_open_regions(), attempt) {
            (true, _) => SIZES[0] * SIZES[1].powi(attempt as i32),
            (false, 0) if self.may_lean() => UPRIGHT,
            (false, _) => 1.0,
        };
        let left = self.options.budget.saturating_sub(search.state.work);
        // With nothing to change, looking once is enough.
        let frame = &self.setup.frame;
        let may_change = frame.objects().any(|id| frame.is_movable(id)) || !frame.program.variables.is_empty();
        let budget = if may_change { left.min((self.options.budget as f64 * share) as u64) } else { left.min(1) };
        let mut limit = self.limit.clone();
        if limit.left().is_some() && !self.setup.frame.walks.is_empty() {
            first.local.search(&mut first.chance, 0, &limit, &given);
            limit = limit.earlier(PATHS_JUDGED * judging(&mut search.state, &first.local));
        }
        let threads = self.options.threads();
        let another = || {
            let (other, _) = self.begin(search, attempt, from, 1);
            Member { local: other.local.of_another_kind(), ..other }
        };
        let (Member { mut local, mut chance }, mut solved) =
            portfolio::search(first, another, budget, &limit, &given, threads);
        if solved {
            local.move_less(&mut chance, &limit, &given);
        }
        let is_new = from.is_empty();
        let mut for_preferences = (self.options.budget as f64 * self.options.polish) as u64;
        loop {
            if solved {
                let begun = local.trial.work;
                let preferences = for_preferences.min(budget.saturating_sub(begun));
                let quality = self.options.polish * 100.0 / f64::from(QUALITY);
                local.improve_preferences(&mut chance, (preferences, quality), &limit, !is_new);
                for_preferences = for_preferences.saturating_sub(local.trial.work - begun);
            }
            if solved && is_new {
                local.tidy(&mut chance, &limit);
            }
            show(&local, &mut search.state);
            let holds = solved && search.state.hard().0 == 0;
            // What was thought to hold may not: it is judged otherwise from then on, and one goes on from here.
            let over = limit.is_over() || local.trial.work >= budget;
            if !solved || holds || over || !local.trial.doubt(&search.state.failing()) {
                break;
            }
            given.fill(true);
            solved = local.search(&mut chance, budget - local.trial.work, &limit, &given);
            if !solved {
                local.restore_best();
            }
        }
        search.state.work += local.trial.work;
        self.is_cut |= limit.is_over();
    }

    /// The random numbers of an attempt.
    fn chance(&self, attempt: u64) -> ChaCha8Rng {
        let mut chance = ChaCha8Rng::seed_from_u64(self.options.seed);
        chance.set_stream(attempt + (self.options.variant << 32));
        chance
    }

    /// A state that shows a layout.
    fn at(&self, snapshot: &crate::search::Snapshot, old: Candidate<'r>) -> Candidate<'r> {
        let chance = ChaCha8Rng::seed_from_u64(self.options.seed);
        let mut search = Search { state: old, chance, options: self.options, best: None };
        search.restore(snapshot);
        search.state
    }
}
