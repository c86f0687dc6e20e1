//! From "these cannot all hold" to minimal sets; redundancy; the budget.

use super::companies::{crowds, nominal_sizes};
use super::looks::{alone, few, parts};
use super::model::{Choice, ClaimModel, Common, Given, GivenSource, Rules, regions_of};
use super::outlines;
use super::packing::Packing;
use super::problem::Problem;
use super::refute::Refutation;
use super::turns;
use super::usual::Usual;
use super::words;
use super::{Contradiction, Findings, Proof, ProveOptions, Redundancy};
use rustc_hash::{FxHashMap, FxHashSet};
use scenelang_lang::program::{
    Arg, Arith, BuiltIn, Comparison, ConstraintKind, Formula, Function, Node, NodeId, ObjectId, Owner, Program,
    RegionId,
};
use std::collections::BTreeSet;
use std::sync::atomic::Ordering;

/// So many usual sizes are tried whether a contradiction rests on them.
const MOST_SIZES: usize = 6;
/// So many contradictions are looked for.
const MOST_CONTRADICTIONS: usize = 10;
/// A statement is compared with at most so many others that speak of the same things.
const NEIGHBOURS: usize = 24;
/// The part of the work that one question may take: of all statements, of a smaller set, of one redundancy.
const WHOLE: u64 = 2;
const SMALLER: u64 = 4;
const ONE: u64 = 300;
/// Of what is said of a few things; all of those together may take so much of it.
const FEW: u64 = 20;
const ALL_FEW: u64 = 2;
/// So many statements are looked at without the rules, too.
const MOST_BARE: usize = 12;
/// Of whether a distance is more than any that there can be.
const ANYWHERE: u64 = 60;
/// The part of the work that may go, beside all else, into preferences that can never hold.
const PREFERENCES: u64 = 10;
const PREFERENCE: u64 = 60;
/// The work of a brief search, in sizes of its model: drawing all consequences once takes seven or eight.
const BRIEF: u64 = 10;

/// What is said of more objects than this is not looked at as a whole: its model would take hundreds of megabytes.
pub(super) const LARGEST: usize = 1500;

/// The same for what is said of them, in nodes of formulas; what a built-in means takes more.
pub(super) const MOST_SAID: usize = 500_000;
const BUILT_IN: usize = 4;

/// What a refutation rests on.
pub(super) struct Core {
    statements: Vec<usize>,
    rules: Vec<String>,
    reason: Option<String>,
    proof: Option<Proof>,
}

/// What statements may be about that has nothing to do with why they contradict each other.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Stranger {
    Object(ObjectId),
    Region(RegionId),
}

/// The answers to one program's questions.
pub(super) struct Prover<'a> {
    pub(super) program: &'a Program,
    pub(super) options: &'a ProveOptions,
    common: Common<'a>,
    /// What is taken for granted, if anything is.
    pub(super) usual: Option<&'a Usual>,
    /// Which physical rules count.
    pub(super) rules: Rules,
    pub(super) spent: u64,
    /// Whether some question ended for lack of work.
    pub(super) short: bool,
    /// Whether some question was about more than is looked at.
    too_large: bool,
}

impl<'a> Prover<'a> {
    pub fn new(program: &'a Program, options: &'a ProveOptions, usual: Option<&'a Usual>) -> Self {
        let common = Common::new(program, &options.judging);
        Self { program, options, common, usual, rules: Rules::All, spent: 0, short: false, too_large: false }
    }

    /// Everything.
    pub fn findings(mut self) -> Findings {
        let mut contradictions = outlines::impossible(self.program, &self.options.judging);
        contradictions.extend(turns::impossible(self.program, &self.options.judging));
        let mut findings = Findings { contradictions, ..Findings::default() };
        let known = |i: &usize| findings.contradictions.iter().any(|found| found.statements.contains(i));
        let mut open: Vec<usize> =
            (0..self.program.constraints.len()).filter(|i| self.is_hard(*i) && !known(i)).collect();
        // Crowded regions by themselves, then everything, again and again without what was found; single objects last, in case
        // they were lost among the rest.
        let mut looks: Vec<(Vec<usize>, u64)> =
            crowds(&self.common, self.usual, &open).into_iter().rev().map(|look| (look, SMALLER)).collect();
        let (mut is_last, mut least) = (false, 0);
        if self.is_too_large(open.iter().copied()) {
            // What has nothing to do with the rest can be looked at by itself.
            looks.splice(0..0, parts(&self.common, &open).into_iter().rev().map(|part| (part, SMALLER)));
        }
        while findings.contradictions.len() < MOST_CONTRADICTIONS && !open.is_empty() {
            let (among, part, last) = match looks.pop() {
                _ if is_last && self.left() < least => break,
                Some((few, part)) => (few, part, false),
                None if is_last => break,
                None => (open.clone(), WHOLE, true),
            };
            let fresh = among.iter().all(|s| open.binary_search(s).is_ok());
            match if fresh { self.contradiction(&among, part) } else { None } {
                Some(found) => {
                    open.retain(|i| !found.statements.contains(i));
                    findings.contradictions.push(found);
                }
                None if last => {
                    (looks, is_last) = (self.small_looks(&open), true);
                    let (few, one) = (self.options.work / ALL_FEW, self.options.work / FEW);
                    least = self.left().saturating_sub(few).max(one);
                }
                None => {}
            }
        }
        findings.contradictions.sort_by(|a, b| a.statements.cmp(&b.statements));
        if self.options.redundant && findings.contradictions.is_empty() {
            self.redundancies(&mut findings);
        }
        findings.work_spent = self.spent;
        self.words(&mut findings.contradictions);
        findings.complete = !self.short && !self.is_stopped();
        findings.too_large = self.too_large;
        if self.options.redundant && findings.contradictions.is_empty() {
            findings.unsatisfiable = self.unsatisfiable();
        }
        findings
    }

    /// What is said of single objects, and of a few, each with the part of the work that it may take.
    fn small_looks(&self, open: &[usize]) -> Vec<(Vec<usize>, u64)> {
        let of_few = few(self.program, open).into_iter().rev().map(|look| (look, FEW));
        of_few.chain(alone(self.program, open).into_iter().map(|look| (look, SMALLER))).collect()
    }

    /// Preferences that cannot hold together with what is asserted around them. Those of the library are not looked at:
    /// a room may go against many guidelines, and nobody wrote them for it.
    fn unsatisfiable(&mut self) -> Vec<Contradiction> {
        let hard: Vec<usize> = (0..self.program.constraints.len()).filter(|&i| self.is_hard(i)).collect();
        let own = |i: &usize| !self.is_hard(*i) && self.program.constraints[*i].guideline.is_none();
        let preferences: Vec<usize> = (0..self.program.constraints.len()).filter(own).collect();
        let neighbours = Neighbours::new(self.program, &hard);
        self.spent = self.options.work - self.options.work / PREFERENCES;
        let mut found = Vec::new();
        for preference in preferences {
            let mut among = neighbours.of(self.program, preference);
            among.push(preference);
            among.sort_unstable();
            let set = self.minimal(&among, PREFERENCE);
            found.extend(set.filter(|set| set.statements.contains(&preference)));
        }
        self.words(&mut found);
        found
    }

    /// See [`super::relax`].
    pub fn relaxed(mut self, rank: &dyn Fn(usize) -> Option<usize>) -> Vec<usize> {
        let hard: Vec<usize> = (0..self.program.constraints.len()).filter(|&i| self.is_hard(i)).collect();
        let mut looks = crowds(&self.common, self.usual, &hard);
        looks.extend(parts(&self.common, &hard));
        let mut given_up = Vec::new();
        for mut among in looks {
            among.retain(|s| !given_up.contains(s));
            // Where nothing can be given up, it does not matter what contradicts.
            if !among.iter().any(|s| rank(*s).is_some()) || self.is_too_large(among.iter().copied()) {
                continue;
            }
            let model = self.model(self.whole(&among), false);
            let mut problem = model.problem();
            // What is no longer asked of the model.
            let mut without = Vec::new();
            while let Some(core) = self.brief(&model, &mut problem, &without) {
                match self.weakest(core, rank) {
                    Ok(weakest) => {
                        given_up.push(weakest);
                        without.push(weakest);
                    }
                    Err(core) if core.iter().all(|s| without.contains(s)) => break,
                    Err(core) => without.extend(core),
                }
            }
        }
        given_up
    }

    /// The statements of a refutation of a model, if a brief search finds one.
    fn brief(&mut self, model: &ClaimModel, problem: &mut Problem, without: &[usize]) -> Option<Vec<usize>> {
        let most = (BRIEF * size(model)).min(self.options.work.saturating_sub(self.spent));
        self.search(
            model,
            problem,
            &|g| matches!(&g.what, GivenSource::Statement(s) if without.contains(s)),
            most,
            false,
        )
        .map(|core| core.statements)
    }

    /// Of a set that cannot hold together the statement of the highest rank without which a brief search refutes the rest
    /// no more; or the set, if there is no such statement.
    fn weakest(&mut self, mut core: Vec<usize>, rank: &dyn Fn(usize) -> Option<usize>) -> Result<usize, Vec<usize>> {
        loop {
            let model = self.model(self.whole(&core), false);
            match self.brief(&model, &mut model.problem(), &[]) {
                Some(next) if next.len() < core.len() => core = next,
                _ => break,
            }
        }
        while let Some(weakest) = core.iter().copied().filter(|s| rank(*s).is_some()).max_by_key(|s| (rank(*s), *s)) {
            let rest: Vec<usize> = core.iter().copied().filter(|s| *s != weakest).collect();
            let model = self.model(self.whole(&rest), false);
            match self.brief(&model, &mut model.problem(), &[]) {
                Some(smaller) => core = smaller,
                None => return Ok(weakest),
            }
        }
        Err(core)
    }

    /// Statements with the rules, and with what is usual.
    pub(super) fn whole<'s>(&self, statements: &'s [usize]) -> Choice<'s>
    where
        'a: 's,
    {
        Choice { statements, contrary: None, rules: self.rules, usual: self.usual, loosened: None }
    }

    fn is_hard(&self, statement: usize) -> bool {
        !matches!(self.program.constraints[statement].kind, ConstraintKind::Prefer { .. })
    }

    fn is_stopped(&self) -> bool {
        self.options.cancel.as_ref().is_some_and(|c| c.load(Ordering::Relaxed))
    }

    /// The size that a statement assigns, if it is a constant.
    pub(super) fn size_of(&self, statement: usize) -> Option<[f64; 3]> {
        let sizes = nominal_sizes(&self.common, &[statement]);
        sizes.into_values().next()
    }

    pub(super) fn left(&self) -> u64 {
        self.options.work.saturating_sub(self.spent)
    }

    /// Whether a choice cannot be, in a part of the work.
    fn refute(&mut self, choice: Choice<'_>, part: u64, tell: bool) -> Option<Core> {
        let most = (self.options.work / part).min(self.left());
        if most == 0 || self.is_stopped() {
            self.short = true;
            return None;
        }
        if self.is_too_large(choice.statements.iter().copied().chain(choice.contrary)) {
            (self.short, self.too_large) = (true, true);
            return None;
        }
        let model = self.model(choice, tell);
        self.search(&model, &mut model.problem(), &|_| false, most, tell)
    }

    /// Whether statements say more, or of more objects, than is looked at.
    fn is_too_large(&self, mut statements: impl Iterator<Item = usize>) -> bool {
        let mut objects = FxHashSet::default();
        let mut said = 0;
        statements.any(|s| {
            let formula = &self.program.constraints[s].formula;
            if self.program.objects.len() > LARGEST {
                objects.extend(formula.objects());
            }
            let built_in = |node: &&Node| matches!(node, Node::BuiltIn(..));
            said += formula.nodes.len() + BUILT_IN * formula.nodes.iter().filter(built_in).count();
            objects.len() > LARGEST || said > MOST_SAID
        })
    }

    pub(super) fn model(&mut self, choice: Choice<'_>, named: bool) -> ClaimModel {
        if self.program.objects.len() > LARGEST {
            // Before a part is looked at, all objects are.
            self.spent += self.program.objects.len() as u64;
        }
        let model = ClaimModel::new(&self.common, choice, named);
        // Making the model is work, too.
        self.spent += size(&model);
        model
    }

    /// Whether what a model says cannot be, without what is left out of it, by so much work.
    /// Rows that the search makes stay in the problem: they only name sums.
    pub(super) fn search(
        &mut self,
        model: &ClaimModel,
        problem: &mut Problem,
        is_left_out: &dyn Fn(&Given) -> bool,
        most: u64,
        tell: bool,
    ) -> Option<Core> {
        let tolerances = &self.options.judging.tolerances;
        let given: Vec<&Given> = model.given.iter().filter(|g| !is_left_out(g)).collect();
        let claims: Vec<_> = given.iter().map(|g| g.claim).collect();
        let contact = tolerances.contact + 2.0 * tolerances.order;
        let packing = Packing::new(self.program, &model.groups, problem, [&model.always, &claims], contact);
        let cancel = self.options.cancel.as_deref();
        let mut search = Refutation::new(std::mem::take(problem), model, &packing, most, cancel);
        search.told = tell.then(Vec::new);
        let used = search.refute(&model.always, &claims);
        self.spent += search.state.work;
        self.short |= search.state.work >= most;
        let told = search.told.take();
        let full = search.is_full;
        *problem = search.problem;
        let used = used?;
        let reason = if full { packing.reason() } else { None };
        let mut core = Core { statements: Vec::new(), rules: Vec::new(), reason, proof: None };
        for index in used {
            let given = given[index];
            match &given.what {
                GivenSource::Statement(statement) => core.statements.push(*statement),
                GivenSource::Rule(rule) => core.rules.push(rule.clone()),
                GivenSource::Contrary(_) => {}
            }
            core.statements.extend(&given.premises);
        }
        core.statements.sort_unstable();
        core.statements.dedup();
        core.rules.sort();
        core.rules.dedup();
        core.proof = told.map(|told| words::proof(self.program, model, problem, &told));
        Some(core)
    }

    /// A minimal set among these that cannot hold together, if one is found: one that rests on usual sizes or shapes only where
    /// there is no other, and one that rests on things being upright only where any other is more than twice as large.
    fn contradiction(&mut self, among: &[usize], part: u64) -> Option<Contradiction> {
        let found = self.minimal(among, part)?;
        let Some(usual) = self.usual.take() else { return Some(found) };
        let strictly = self.minimal(if found.as_usual { among } else { &found.statements }, part);
        self.usual = Some(usual);
        let assumes = !found.sizes.is_empty() || found.shapes;
        let is_better = |other: &Contradiction| assumes || other.statements.len() <= 2 * found.statements.len();
        Some(strictly.filter(is_better).unwrap_or(found))
    }

    /// Where the rules make it too long a search, what the statements say by themselves may do.
    fn minimal(&mut self, among: &[usize], part: u64) -> Option<Contradiction> {
        let found = self.minimal_with(among, part);
        if found.is_some() || part != FEW && among.len() > MOST_BARE {
            return found;
        }
        self.rules = Rules::None;
        let found = self.minimal_with(among, part.max(FEW));
        self.rules = Rules::All;
        found
    }

    fn minimal_with(&mut self, among: &[usize], part: u64) -> Option<Contradiction> {
        let mut core = self.refute(self.whole(among), part, false)?;
        // Small first: a core of a core is often smaller, and costs little.
        while let Some(next) = self.refute(self.whole(&core.statements), SMALLER, false) {
            let done = next.statements.len() >= core.statements.len();
            core = next;
            if done {
                break;
            }
        }
        core = self.without_strangers(core);
        // Without any one of them there is no refutation: the last first, so that what was said first is kept.
        let mut tried: FxHashSet<usize> = FxHashSet::default();
        while let Some(&statement) = core.statements.iter().rev().find(|s| !tried.contains(*s)) {
            tried.insert(statement);
            let rest: Vec<usize> = core.statements.iter().copied().filter(|s| *s != statement).collect();
            if let Some(smaller) = self.refute(self.whole(&rest), SMALLER, false) {
                core = smaller;
            }
        }
        if core.statements.is_empty() {
            return None;
        }
        // As few rules as can be, too.
        for rules in [Rules::None, Rules::Bounds] {
            if core.reason.is_some() || core.rules.is_empty() {
                break;
            }
            let fewer = Choice { rules, ..self.whole(&core.statements) };
            if let Some(other) = self.refute(fewer, SMALLER, false) {
                core = other;
            }
        }
        let told = if self.options.explain { self.refute(self.whole(&core.statements), SMALLER, true) } else { None };
        let as_usual = self.usual.is_some() && {
            let strictly = Choice { usual: None, ..self.whole(&core.statements) };
            self.refute(strictly, SMALLER, false).is_none()
        };
        let Core { statements, rules, reason, proof } = core;
        let mut definitions: Vec<usize> =
            statements.iter().flat_map(|s| self.program.constraints[*s].definitions.iter().copied()).collect();
        definitions.sort_unstable();
        definitions.dedup();
        let proof = told.map_or(proof, |t| t.proof);
        let sizes = if as_usual { self.sizes(&statements) } else { Vec::new() };
        let shapes = as_usual && self.rests_on_shapes(&statements);
        Some(Contradiction {
            statements,
            definitions,
            rules,
            reason,
            as_usual,
            sizes,
            shapes,
            proof,
            parts: Vec::new(),
        })
    }

    /// A core without all that is said of some objects and regions. One statement after the other, that may not come off:
    /// what is left of what is said of a door may only make the search longer.
    fn without_strangers(&mut self, mut core: Core) -> Core {
        let speaks = |program: &Program, s: usize, owner: Stranger| {
            let formula = &program.constraints[s].formula;
            match owner {
                Stranger::Object(id) => formula.objects().contains(&id),
                Stranger::Region(id) => regions_of(formula).contains(&id),
            }
        };
        let mut owners: BTreeSet<Stranger> = BTreeSet::new();
        for &s in &core.statements {
            let formula = &self.program.constraints[s].formula;
            owners.extend(formula.objects().into_iter().map(Stranger::Object));
            owners.extend(regions_of(formula).into_iter().map(Stranger::Region));
        }
        for owner in owners {
            let rest: Vec<usize> =
                core.statements.iter().copied().filter(|s| !speaks(self.program, *s, owner)).collect();
            // A single statement comes off below.
            if rest.is_empty() || rest.len() + 1 >= core.statements.len() {
                continue;
            }
            if let Some(smaller) = self.refute(self.whole(&rest), SMALLER, false) {
                core = smaller;
            }
        }
        core
    }

    /// Whether a set of statements is refuted only by what of furniture is solid, or by where its surface is.
    fn rests_on_shapes(&mut self, statements: &[usize]) -> bool {
        let Some(usual) = self.usual else { return false };
        let any = Usual { shapes: false, ..usual.clone() };
        self.refute(Choice { usual: Some(&any), ..self.whole(statements) }, SMALLER, false).is_none()
    }

    /// The usual sizes without which a set of statements is not refuted: of the objects that they speak of.
    fn sizes(&mut self, statements: &[usize]) -> Vec<(ObjectId, [f64; 3])> {
        let Some(usual) = self.usual else { return Vec::new() };
        let spoken = |s: &usize| self.program.constraints[*s].formula.objects();
        let objects: BTreeSet<ObjectId> = statements.iter().flat_map(spoken).collect();
        let sized = |id: ObjectId| usual.size[id.0 as usize].map(|size| (id, size));
        let mut left: Vec<(ObjectId, [f64; 3])> = objects.into_iter().filter_map(sized).collect();
        // Each is tried while they are few; of many it is not known which of them matter.
        if left.len() > MOST_SIZES {
            return Vec::new();
        }
        let mut without = usual.clone();
        for (id, _) in std::mem::take(&mut left) {
            let size = without.size[id.0 as usize].take();
            let choice = Choice { usual: Some(&without), ..self.whole(statements) };
            if self.refute(choice, SMALLER, false).is_none() {
                without.size[id.0 as usize] = size;
                left.extend(size.map(|size| (id, size)));
            }
        }
        left
    }

    /// Whether an upper bound of a distance, or a comparison of heights, holds wherever things stand in a room of the size that
    /// it has.
    fn fits_always(&mut self, statement: usize) -> bool {
        let formula = &self.program.constraints[statement].formula;
        if self.usual.is_none() || !bounds_a_distance(formula) && !compares_heights(formula) {
            return false;
        }
        let (objects, is_pin) = (formula.objects(), |c: usize| self.program.constraints[c].kind == ConstraintKind::Pin);
        let speaks = |owner: Owner| match owner {
            Owner::Object(id) => objects.contains(&id),
            Owner::Region(_) => true,
        };
        let pins = self.program.pins.iter().filter(|p| speaks(p.owner) && is_pin(p.constraint));
        let mut pins: Vec<usize> = pins.map(|p| p.constraint).collect();
        pins.sort_unstable();
        pins.dedup();
        // How high a thing of a usual size reaches is for the program to say.
        let unsized_ones = self.usual.filter(|_| compares_heights(formula)).map(without_sizes);
        let usual = unsized_ones.as_ref().or(self.usual);
        let choice = Choice { contrary: Some(statement), rules: Rules::Bounds, usual, ..self.whole(&pins) };
        self.refute(choice, ANYWHERE, false).is_some()
    }

    /// Whether others imply a comparison of heights where things are upright and stand on something, whatever sizes are usual.
    fn as_usual(&mut self, compares_heights: bool, statement: usize, others: &[usize]) -> Option<Core> {
        let unsized_ones = without_sizes(self.usual.filter(|_| compares_heights)?);
        let usual = Some(&unsized_ones);
        let choice = Choice { contrary: Some(statement), rules: Rules::Bounds, usual, ..self.whole(others) };
        self.refute(choice, ANYWHERE, false)
    }

    fn redundancies(&mut self, findings: &mut Findings) {
        let hard: Vec<usize> = (0..self.program.constraints.len()).filter(|&i| self.is_hard(i)).collect();
        let neighbours = Neighbours::new(self.program, &hard);
        let mut flagged: FxHashSet<usize> = FxHashSet::default();
        // The last first: of equal statements the first stays.
        for &statement in hard.iter().rev() {
            let constraint = &self.program.constraints[statement];
            if constraint.kind != ConstraintKind::Assert || is_partial(&constraint.formula) {
                continue;
            }
            let alone = Choice { contrary: Some(statement), rules: Rules::None, usual: None, ..self.whole(&[]) };
            if self.refute(alone, ONE, false).is_some() || self.fits_always(statement) {
                findings.always.push(statement);
                flagged.insert(statement);
                continue;
            }
            let others: Vec<usize> =
                neighbours.of(self.program, statement).into_iter().filter(|s| !flagged.contains(s)).collect();
            if others.is_empty() {
                continue;
            }
            let choice = Choice { contrary: Some(statement), rules: Rules::None, usual: None, ..self.whole(&others) };
            let heights = compares_heights(&constraint.formula);
            let found = self.refute(choice, ONE, false).or_else(|| self.as_usual(heights, statement, &others));
            if let Some(core) = found
                && core.statements.iter().any(|s| *s != statement)
            {
                flagged.insert(statement);
                findings.redundant.push(Redundancy { statement, by: core.statements });
            }
        }
        findings.always.sort_unstable();
        findings.redundant.sort_by_key(|r| r.statement);
    }
}

fn size(model: &ClaimModel) -> u64 {
    (model.tape.ops.len() + model.tape.facts.len()) as u64
}

/// Which statements speak of the same things.
struct Neighbours {
    by_thing: FxHashMap<Thing, Vec<usize>>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) enum Thing {
    Object(u32),
    Region(u32),
    Variable(u32),
    Draw(u32),
}

impl Neighbours {
    fn new(program: &Program, among: &[usize]) -> Self {
        let mut by_thing: FxHashMap<Thing, Vec<usize>> = FxHashMap::default();
        for &statement in among {
            for thing in things(&program.constraints[statement].formula) {
                by_thing.entry(thing).or_default().push(statement);
            }
        }
        Self { by_thing }
    }

    /// Others that speak of something that a statement speaks of, or that those speak of; nearest first, sorted.
    fn of(&self, program: &Program, statement: usize) -> Vec<usize> {
        let mut found: Vec<usize> = Vec::new();
        let mut seen: FxHashSet<usize> = FxHashSet::from_iter([statement]);
        let mut front = vec![statement];
        for _ in 0..3 {
            let mut next = Vec::new();
            for at in front {
                for thing in things(&program.constraints[at].formula) {
                    let Some(list) = self.by_thing.get(&thing) else { continue };
                    // Of something that everything speaks of (the room) only the nearest.
                    let here = list.partition_point(|s| *s < statement);
                    let near = &list[here.saturating_sub(NEIGHBOURS)..(here + NEIGHBOURS).min(list.len())];
                    next.extend(near.iter().copied().filter(|s| seen.insert(*s)));
                }
            }
            next.sort_by_key(|s| s.abs_diff(statement));
            found.extend(&next);
            front = next;
            if found.len() >= NEIGHBOURS {
                break;
            }
        }
        found.truncate(NEIGHBOURS);
        found.sort_unstable();
        found
    }
}

pub(super) fn things(formula: &Formula) -> Vec<Thing> {
    let mut out: Vec<Thing> = formula.objects().into_iter().map(|o| Thing::Object(o.0)).collect();
    out.extend(regions_of(formula).into_iter().map(|r| Thing::Region(r.0)));
    for node in &formula.nodes {
        match node {
            Node::Variable(v) => out.push(Thing::Variable(v.0)),
            Node::Draw(d) | Node::Choice(d, _) => out.push(Thing::Draw(d.0)),
            _ => {}
        }
    }
    out
}

/// Whether a formula says of distances between things that they are no more than a number.
fn bounds_a_distance(formula: &Formula) -> bool {
    let mut open = vec![formula.root];
    while let Some(id) = open.pop() {
        match formula.node(id) {
            Node::And(parts) => open.extend(parts.iter().copied()),
            Node::Compare(Comparison::Le | Comparison::Lt, _, a, b) => {
                let measure = match formula.node(*a) {
                    Node::BuiltIn(BuiltIn::Gap, args) => args.iter().all(|a| matches!(a, Arg::Object(_))),
                    Node::Call(Function::Distance, _) => true,
                    _ => false,
                };
                if !measure || !matches!(formula.node(*b), Node::Number(_)) {
                    return false;
                }
            }
            _ => return false,
        }
    }
    true
}

/// What is usual, except for sizes.
fn without_sizes(usual: &Usual) -> Usual {
    Usual { size: vec![None; usual.size.len()], ..usual.clone() }
}

/// Whether a formula only compares heights of things, by order.
fn compares_heights(formula: &Formula) -> bool {
    use scenelang_lang::program::{Axis, ObjectProperty, RegionProperty};
    let is_height = |id: NodeId| {
        let nodes = crate::eval::cone(formula, id);
        let whole = |n: &NodeId| match formula.node(*n) {
            Node::Object(property, _) => matches!(property, ObjectProperty::Top | ObjectProperty::Bottom),
            Node::Region(property, _) => matches!(property, RegionProperty::Floor | RegionProperty::Ceiling),
            Node::Number(_) | Node::Arith(Arith::Add | Arith::Sub, ..) => true,
            Node::Component(Axis::Y, of) => {
                matches!(formula.node(*of), Node::Object(ObjectProperty::Pos | ObjectProperty::Center, _))
            }
            _ => false,
        };
        let part_of =
            |n: &NodeId| nodes.iter().any(|m| matches!(formula.node(*m), Node::Component(Axis::Y, of) if of == n));
        nodes.iter().all(|n| whole(n) || part_of(n))
    };
    match formula.root_node() {
        Node::Compare(op, _, a, b) => {
            !matches!(op, Comparison::Eq | Comparison::Ne)
                && !formula.objects().is_empty()
                && is_height(*a)
                && is_height(*b)
        }
        _ => false,
    }
}

/// Whether a formula may have no value somewhere: then it does not hold there, whatever it says.
fn is_partial(formula: &Formula) -> bool {
    formula.nodes.iter().any(|node| match node {
        Node::Arith(Arith::Div, _, by) => !matches!(formula.node(*by), Node::Number(n) if *n != 0.0),
        Node::Call(function, _) => matches!(function, Function::Sqrt | Function::Normalize | Function::Angle),
        _ => false,
    })
}
