//! What can be proved of a program without a layout: that statements contradict each other, that one is implied by
//! others, that one always holds. Sound, not complete: what is reported is proved, and much is not.
//!
//! A formula keeps its one meaning: the evaluator runs over unknowns (`tape`, `unknowns`) and leaves equations
//! (`problem`). A refutation (`refute`) joins narrowing of intervals (`narrow`, `state`), linear reasoning (`simplex`,
//! with inequalities for what is not linear in `cuts`), sums of volumes and areas (`packing`), and cases. Whatever it
//! uses is remembered, so that a contradiction is first small, and then made minimal by leaving out one statement after
//! the other (`minimal`).
//!
//! All of it is counted as work, never timed; the same program has the same findings everywhere.

mod beside;
mod companies;
mod conjuncts;
mod cuts;
mod framed;
pub(crate) mod interval;
mod looks;
mod loosened;
mod minimal;
mod model;
mod narrow;
mod outlines;
mod packing;
mod passing;
mod pierce;
mod placing;
mod probes;
mod problem;
mod reason;
mod refute;
mod relations;
mod rings;
mod sights;
mod simplex;
mod state;
pub(crate) mod tape;
mod too_far;
mod turned;
mod turns;
pub(crate) mod unknowns;
mod usual;
mod words;

use crate::tolerances::Options;
use scenelang_base::{Diagnostic, TextRange};
use scenelang_lang::program::{ObjectId, Program};
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

/// How to look for proofs.
#[derive(Clone, Debug)]
pub struct ProveOptions {
    /// Tolerances, what a solid is, and whether the physical rules count.
    pub judging: Options,
    /// How much work may be done in all. A step is a look at one part of one formula.
    pub work: u64,
    /// Whether findings come with their proof.
    pub explain: bool,
    /// Whether to look, where there is no contradiction, for what is implied by others or always holds.
    pub redundant: bool,
    /// Whether rooms are taken to be unturned, and things to be upright, on a floor and of their usual sizes, where the
    /// program does not say otherwise: as `solve` takes them. A [`Contradiction`] says whether it rests on that.
    pub usual: bool,
    /// Set from elsewhere, it ends the search; what was proved until then is kept.
    pub cancel: Option<Arc<AtomicBool>>,
}

/// Work enough for rooms and houses, little enough not to be waited for.
pub const WORK: u64 = 3_000_000;
/// The work where nothing else is left to do: after a search that found no layout, and where a person asks about a program
/// alone.
pub const DEAR: u64 = 4 * WORK;

impl Default for ProveOptions {
    fn default() -> Self {
        Self { judging: Options::default(), work: WORK, explain: false, redundant: true, usual: false, cancel: None }
    }
}

/// What was proved.
#[derive(Clone, Debug, Default)]
pub struct Findings {
    /// Statements that cannot hold together: minimal sets, no two of which share a statement.
    pub contradictions: Vec<Contradiction>,
    /// Preferences that can never hold, each with the statements that rule it out: minimal sets.
    pub unsatisfiable: Vec<Contradiction>,
    /// Statements implied by others.
    pub redundant: Vec<Redundancy>,
    /// Statements that hold in every layout: indices into [`Program::constraints`].
    pub always: Vec<usize>,
    /// The work that it took.
    pub work_spent: u64,
    /// Whether the search came to its end; if not, more work might find more.
    pub complete: bool,
    /// Whether something was left out because it says too much, or speaks of too many objects.
    pub too_large: bool,
}

/// A minimal set of statements that cannot hold together.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Contradiction {
    /// Indices into [`Program::constraints`], in their order: assertions and assignments.
    pub statements: Vec<usize>,
    /// Of statements of which some parts, joined by `and`, do without the others: these parts, as ranges from the start of
    /// the statement.
    pub parts: Vec<(usize, Vec<TextRange>)>,
    /// Assignments to variables that these were made with: indices into [`Program::definitions`]. They are members too,
    /// though whether the set is contradictory without one of them is not tried: without it there is another program.
    pub definitions: Vec<usize>,
    /// Physical rules that take part, in words.
    pub rules: Vec<String>,
    /// The one reason, in words, where there is one: what is too large for what.
    pub reason: Option<String>,
    /// Whether it rests on what is usual: something tilted, turned, stacked or of another size may satisfy the program.
    pub as_usual: bool,
    /// Objects, and the usual sizes (metres) of theirs that it rests on.
    pub sizes: Vec<(ObjectId, [f64; 3])>,
    /// Whether it rests on what of furniture is solid, and where its surface is.
    pub shapes: bool,
    /// Why, if that was asked for.
    pub proof: Option<Proof>,
}

/// A statement that others imply.
#[derive(Clone, Debug, PartialEq)]
pub struct Redundancy {
    /// An index into [`Program::constraints`].
    pub statement: usize,
    /// Others that imply it.
    pub by: Vec<usize>,
}

/// A chain of reasoning that ends in the impossible.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Proof {
    /// The steps, in order.
    pub steps: Vec<ProofStep>,
}

#[derive(Clone, Debug, PartialEq)]
pub struct ProofStep {
    /// How many suppositions it stands under.
    pub depth: usize,
    /// A sentence.
    pub text: String,
}

/// Looks for what can be proved of a program.
pub fn prove(program: &Program, options: &ProveOptions) -> Findings {
    let usual = options.usual.then(|| usual::Usual::of(program));
    let mut findings = minimal::Prover::new(program, options, usual.as_ref()).findings();
    if usual.is_some() && findings.contradictions.is_empty() {
        findings.contradictions = framed::contradictions(program, options);
    }
    findings
}

/// Larger programs take too long to look at closely.
const FEW_OBJECTS: usize = 20;

/// The same of a program that somebody waits for: where the usual work ends without a contradiction and there are few
/// objects, all that `solve` proves, so that both say the same. Some proofs are shorter where nothing is taken as usual.
pub fn prove_closely(program: &Program, options: &ProveOptions) -> Findings {
    let mut findings = prove(program, options);
    for (usual, work) in [(false, options.work), (options.usual, DEAR)] {
        if !findings.contradictions.is_empty() || program.objects.len() > FEW_OBJECTS {
            break;
        }
        let more = ProveOptions { usual, work, redundant: false, ..options.clone() };
        findings.contradictions = prove(program, &more).contradictions;
    }
    findings
}

/// Statements of a program to give up so that, as far as is looked, the others do not contradict each other: of each
/// contradiction the one of the highest `rank` (of equal ones the last); one of no rank stays.
///
/// It looks at each part of the program that has nothing to do with the others by itself, and at no part again that
/// has no contradiction. Where parts share a region, that it stands at one place for all of them is known by its assigned
/// place and size; that they want it turned in different ways is not seen here.
pub fn relax(program: &Program, options: &ProveOptions, rank: &dyn Fn(usize) -> Option<usize>) -> Vec<usize> {
    minimal::Prover::new(program, options, None).relaxed(rank)
}

impl Findings {
    /// As diagnostics, in the order of their places.
    pub fn diagnostics(&self, program: &Program) -> Vec<Diagnostic> {
        words::diagnostics(self, program)
    }
}
