//! From a program and a number to a verified layout.

use crate::dice::{Dice, seed_of};
use crate::moves::Mover;
use crate::tally::Tally;
use crate::{chain, whole};
use scenelang_base::FileId;
use scenelang_engine::candidate::Candidate;
use scenelang_lang::Program;
use scenelang_layout::{Layout, Placement, file as layout_file};
use scenelang_solve::{Ground, Options, Placed, Problem, Stop, draws, solve};
use scenelang_synth::furnish;
use scenelang_verify::check::check;
use std::ops::ControlFlow;
use std::sync::OnceLock;

/// How many layouts chains begin at, where all samples have the same draws. Each is looked for when the first sample needs it.
pub const STARTS: usize = 32;
/// Layouts drawn as a whole to see how many of them are good.
pub const PILOT: usize = 20_000;
/// Fewer good ones than this are too few to draw all samples so.
pub const ENOUGH: usize = 10;
/// A sample is drawn as a whole at most so many times longer than one takes on average, before a chain makes it.
const PATIENCE: f64 = 20.0;
/// Layouts drawn as a whole for one sample, where each has its own draws.
pub const TRIES: usize = 2_000;
/// Numbers are cut to multiples of this (metres and degrees), where everything still holds.
const STEP: f64 = 1e-6;

/// How samples are drawn.
#[derive(Clone, Debug)]
pub struct Settings {
    /// Fixes all of them.
    pub seed: u64,
    /// Tolerances, η, what a solid is, whether the physical rules apply.
    pub judge: scenelang_verify::Options,
    /// How many times the usual work the solver may do to find where to begin.
    pub effort: u64,
    /// The work that it may do, in its own units; 0: as much as is usual.
    pub budget: u64,
    /// What the `scene` member of the layouts says.
    pub scene: String,
    /// Whether samples may be drawn as a whole where that is possible; else chains make them all.
    pub whole: bool,
    /// Set from elsewhere, it ends the work.
    pub stop: Stop,
}

/// A layout, verified, or why there is none. Each has the counts of what was tried for it.
#[derive(Clone, Debug)]
pub struct Drawn {
    /// Its number.
    pub index: u64,
    pub seed: u64,
    /// What `rand` and `oneOf` gave it.
    pub draws: Vec<(String, f64)>,
    /// What came of it.
    pub result: Result<Sample, Missing>,
    /// Moves, refusals.
    pub tally: Tally,
}

/// A verified layout.
#[derive(Clone, Debug)]
pub struct Sample {
    /// Where everything is.
    pub layout: Layout,
    /// The same on one line, as it is stored.
    pub line: String,
    /// Whether it was drawn as a whole, and not by a chain.
    pub whole: bool,
}

/// Why there is no layout.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Missing {
    /// For these draws the solver found none.
    NoLayout,
    /// What was found did not stand the check.
    Unverified,
    /// It was asked to end.
    Stopped,
}

/// A layout that chains begin at.
struct Start<'a> {
    ground: Ground<'a>,
    mover: Mover,
}

/// Draws samples of one program.
pub struct Sampler<'a> {
    program: &'a Program,
    settings: Settings,
    /// What chains begin at a solution of; `None`: the draws of a sample decide where its things can be.
    shared: Option<Problem<'a>>,
    /// The solutions, as far as they were needed; of one that is not found, the first takes the place.
    starts: Vec<OnceLock<Option<Start<'a>>>>,
    /// Which part of layouts drawn as a whole is good; `None`: too few are.
    pub rate: Option<f64>,
}

impl<'a> Sampler<'a> {
    /// Of a program without errors. `None`: there are no draws, and the solver finds no layout; or it was asked to end.
    pub fn new(program: &'a Program, settings: Settings) -> Option<Self> {
        let mut sampler = Self { program, settings, shared: None, starts: Vec::new(), rate: None };
        if !program.draws_of_places().is_empty() {
            return Some(sampler);
        }
        sampler.shared = Some(sampler.problem(sampler.settings.seed));
        sampler.starts.resize_with(STARTS, OnceLock::new);
        sampler.start_of(0)?;
        sampler.rate = sampler.pilot();
        Some(sampler)
    }

    /// One of the layouts that chains begin at.
    fn start_of(&self, which: usize) -> Option<&Start<'a>> {
        let problem = self.shared.as_ref()?;
        let found = |which: usize| {
            let start = self.starts.get(which)?;
            start.get_or_init(|| self.start(problem, self.settings.seed, which as u64)).as_ref()
        };
        found(which).or_else(|| found(0))
    }

    /// Sizes and parts, with the draws of a seed.
    fn problem(&self, seed: u64) -> Problem<'a> {
        let start = furnish(self.program, draws(self.program, seed), None, &self.settings.judge).layout;
        Problem { program: self.program, start, placed: Placed::None }
    }

    fn options(&self, seed: u64, variant: u64) -> Options {
        Options {
            seed,
            variant,
            judge: self.settings.judge,
            effort: self.settings.effort,
            budget: self.settings.budget,
            // Samples are uniform: what is preferred has no say in them.
            polish: 0.0,
            diagnose: false,
            threads: 1,
            stop: self.settings.stop.clone(),
            ..Options::default()
        }
    }

    /// A solved layout.
    fn start(&self, problem: &Problem<'a>, seed: u64, variant: u64) -> Option<Start<'a>> {
        let options = self.options(seed, variant);
        let outcome = solve(problem, &options, &mut |_| ControlFlow::Continue(()));
        if !outcome.converged {
            return None;
        }
        let placed = Problem { program: self.program, start: outcome.layout, placed: Placed::All };
        let ground = Ground::new(&placed, &options);
        let mut state = ground.candidate();
        if state.hard().0 > 0 {
            return None;
        }
        let mover = Mover::new(&state);
        drop(state);
        Some(Start { ground, mover })
    }

    /// Which part of layouts drawn as a whole is good, if that is enough of them.
    fn pilot(&self) -> Option<f64> {
        let start = self.start_of(0)?;
        let mut state = start.ground.candidate();
        if !self.settings.whole || !whole::is_possible(&state) {
            return None;
        }
        let mut dice = Dice::new(self.settings.seed);
        let mut tally = Tally::new(self.program);
        let mut found = 0;
        for tried in 1..=PILOT {
            found += usize::from(whole::draw(&start.mover, &mut state, &mut dice, &mut tally));
            // Many good ones need not be counted to the last.
            if found == 10 * ENOUGH {
                return Some(found as f64 / tried as f64);
            }
            if tried % 256 == 0 && self.settings.stop.is_set() {
                return None;
            }
        }
        (found >= ENOUGH).then_some(found as f64 / PILOT as f64)
    }

    /// One sample. The same number gives the same sample, whoever asks and in whatever order.
    pub fn sample(&self, index: u64) -> Drawn {
        let seed = seed_of(self.settings.seed, index);
        let mut tally = Tally::new(self.program);
        let result = self.drawn(seed, &mut tally);
        Drawn { index, seed, draws: draws(self.program, seed), result, tally }
    }

    fn drawn(&self, seed: u64, tally: &mut Tally) -> Result<Sample, Missing> {
        if self.settings.stop.is_set() {
            return Err(Missing::Stopped);
        }
        let mut dice = Dice::new(seed);
        if self.has_usual_shapes(seed)
            && let Some(start) = self.start_of(dice.below(self.starts.len()))
        {
            let tries = self.rate.map_or(0, |rate| (PATIENCE / rate) as usize);
            return self.from(start, tries, seed, &mut dice, tally);
        }
        let problem = self.problem(seed);
        if let Some(sample) = self.without_start(&problem, seed, &mut dice, tally) {
            return sample;
        }
        let start = self.start(&problem, seed, 0).ok_or(match self.settings.stop.is_set() {
            true => Missing::Stopped,
            false => Missing::NoLayout,
        })?;
        self.from(&start, 0, seed, &mut dice, tally)
    }

    /// Whether things have the sizes and parts with the draws of a seed that they have where chains begin.
    fn has_usual_shapes(&self, seed: u64) -> bool {
        let Some(shared) = &self.shared else { return false };
        let alike = |a: &Placement, b: &Placement| {
            a.scale == b.scale && a.parts == b.parts && a.surface == b.surface && a.joints == b.joints
        };
        self.program.draws.is_empty()
            || std::iter::zip(&shared.start.objects, &self.problem(seed).start.objects)
                .all(|((_, a), (_, b))| alike(a, b))
    }

    /// Drawn as a whole, where that is possible before anything was solved.
    fn without_start(
        &self,
        problem: &Problem<'a>,
        seed: u64,
        dice: &mut Dice,
        tally: &mut Tally,
    ) -> Option<Result<Sample, Missing>> {
        let ground = Ground::new(problem, &self.options(seed, 0));
        let mut state = ground.candidate();
        if !self.settings.whole || !whole::is_possible(&state) {
            return None;
        }
        let mover = Mover::new(&state);
        (0..TRIES)
            .any(|_| whole::draw(&mover, &mut state, dice, tally))
            .then(|| self.verified(&ground, &state, seed, true))
    }

    fn from(
        &self,
        start: &Start<'a>,
        tries: usize,
        seed: u64,
        dice: &mut Dice,
        tally: &mut Tally,
    ) -> Result<Sample, Missing> {
        let mut state = start.ground.candidate();
        let whole = (0..tries).any(|_| whole::draw(&start.mover, &mut state, dice, tally));
        if !whole {
            chain::run(&start.mover, &mut state, dice, tally, &self.settings.stop).ok_or(Missing::Stopped)?;
        }
        self.verified(&start.ground, &state, seed, whole)
    }

    /// As it will be stored, read again and judged.
    fn verified(&self, ground: &Ground<'a>, state: &Candidate<'_>, seed: u64, whole: bool) -> Result<Sample, Missing> {
        for step in [Some(STEP), None] {
            let mut layout = ground.layout(state, step);
            layout.scene = Some(self.settings.scene.clone());
            layout.seed = Some(seed);
            layout.draws = draws(self.program, seed);
            let Ok(value) = serde_json::from_str::<serde_json::Value>(&layout_file::to_json(&layout, None)) else {
                continue;
            };
            let line = value.to_string();
            let read = layout_file::read(&line, FileId(0));
            let is_read = read.usable && !read.diagnostics.iter().any(|d| d.is_error());
            if is_read && holds(self.program, &read.layout, &self.settings.judge) {
                return Ok(Sample { layout: read.layout, line, whole });
            }
        }
        Err(Missing::Unverified)
    }
}

/// Whether all that must hold does, by the judgement of `scenelang check`.
pub fn holds(program: &Program, layout: &Layout, judge: &scenelang_verify::Options) -> bool {
    let mut options = *judge;
    options.detail.all = false;
    options.detail.sentences = false;
    options.detail.bars = false;
    let verdict = check(program, layout, &options);
    let counts = [verdict.summary.assertions, verdict.summary.physical, verdict.summary.pins];
    counts.iter().all(|count| count.total == count.satisfied) && !verdict.diagnostics.iter().any(|d| d.is_error())
}
