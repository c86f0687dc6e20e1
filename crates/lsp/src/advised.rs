//! Repair by a language model: it is asked about what is to be repaired and nothing else, and its moves are judged one by one
//! before any counts.

use crate::dispatch::Fault;
use crate::jobs::Job;
use scenelang_lang::Program;
use scenelang_lang::program::ObjectId;
use scenelang_layout::Layout;
use scenelang_solve::{
    Bounds, Concern, ModelProposer, Move, Options, Placed, Pose, Problem, Proposal, Proposer, Relaxer, Selector, Steps,
    TermSubject, View, solve_with,
};
use scenelang_verify::check::Subject;
use scenelang_verify::explain::RowRef;
use scenelang_verify::report::model::RowKind;
use std::ops::ControlFlow;

/// What a language model makes of the layout, the moves that less is violated with; `None`: there is no model. Nobody else
/// moves anything here: whoever asks for a repair does not ask for another room.
///
/// # Errors
/// Nobody wants it any more.
pub fn advised(job: &Job, layout: &Layout, targets: &[RowRef]) -> Result<Option<Layout>, Fault> {
    let (mut model, asking) = match job.advisers.model(&job.llm, &job.progress) {
        Ok(Some(asked)) => asked,
        Ok(None) => return Ok(None),
        Err(error) => {
            job.progress.log(&format!("the language model cannot be asked: {error}"));
            return Ok(None);
        }
    };
    let program = &job.compiled.program;
    let problem = Problem { program, start: layout.clone(), placed: Placed::All };
    let options = Options {
        batch: asking.batch,
        polish: 0.0,
        judge: job.judging.options,
        stop: job.stop.clone(),
        ..Options::default()
    };
    let mut heard = Heard { model: ModelProposer::new(&mut model, asking), last: Vec::new(), taken: Vec::new() };
    let mut only = Only { program, targets };
    let (mut relaxer, mut bounds) = (Still, Still);
    let steps = Steps { rounds: asking.rounds, proposers_only: true, ..Steps::default() };
    let mut steps = Steps {
        proposers: vec![&mut heard],
        selector: Some(&mut only),
        relaxer: Some(&mut relaxer),
        bounds: Some(&mut bounds),
        ..steps
    };
    let mut watch = |_| if job.stop.is_set() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) };
    solve_with(&problem, &options, &mut steps, &mut watch);
    drop(steps);
    if let Some(error) = &heard.model.tally().failed {
        job.progress.log(&format!("the language model stopped before it was done: {error}"));
    }
    if job.stop.is_set() {
        return Err(Fault::Cancelled);
    }
    let mut after = layout.clone();
    for Move { object, pos, rot } in heard.taken {
        let name = program.objects.get(object.0 as usize).map(|o| &o.name);
        if let Some((_, placed)) = after.objects.iter_mut().find(|(own, _)| name == Some(own)) {
            (placed.pos, placed.rot) = (pos, rot);
        }
    }
    Ok(Some(after))
}

/// A model, and what was taken of that which it said: the frame makes numbers round that the layout should have as they are.
struct Heard<'m> {
    model: ModelProposer<'m>,
    last: Vec<Proposal>,
    taken: Vec<Move>,
}

impl Proposer for Heard<'_> {
    fn propose(&mut self, view: &View<'_>, batch: &[Concern], round: usize) -> Vec<Proposal> {
        self.last = self.model.propose(view, batch, round);
        self.last.clone()
    }

    fn judged(&mut self, taken: &[bool]) {
        for (proposal, _) in self.last.iter().zip(taken).filter(|(_, taken)| **taken) {
            self.taken.extend(proposal.moves.iter().copied());
        }
        self.model.judged(taken);
    }
}

/// Takes up nothing but what is to be repaired.
struct Only<'a> {
    program: &'a Program,
    targets: &'a [RowRef],
}

impl Selector for Only<'_> {
    fn select(&mut self, _: &View<'_>, unsatisfied: &[Concern], k: usize) -> Vec<usize> {
        let named = |id: &ObjectId| self.program.objects.get(id.0 as usize).map(|o| &o.name);
        let is = |target: &RowRef, what: &TermSubject| match (target.subject, what) {
            (Subject::Statement(index), TermSubject::Stated(stated)) => index == *stated,
            (Subject::Pair(a, b), TermSubject::Collision(x, y)) => {
                let pair = [named(&a), named(&b)];
                pair == [Some(x), Some(y)] || pair == [Some(y), Some(x)]
            }
            (Subject::Object(a), TermSubject::Bounds(x)) => target.kind == RowKind::Bounds && named(&a) == Some(x),
            (Subject::Part(a, _), TermSubject::Open(x, _)) => named(&a) == Some(x),
            (Subject::Object(a), TermSubject::Support(x)) => target.kind == RowKind::Support && named(&a) == Some(x),
            _ => false,
        };
        let wanted = |concern: &Concern| self.targets.iter().any(|target| is(target, &concern.what));
        let found = unsatisfied.iter().enumerate().filter(|(_, concern)| wanted(concern));
        found.map(|(index, _)| index).take(k).collect()
    }
}

/// Moves nothing.
struct Still;

impl Relaxer for Still {
    fn relax(&mut self, _: &View<'_>) -> Vec<Proposal> {
        Vec::new()
    }
}

impl Bounds for Still {
    fn enforce(&mut self, _: &View<'_>, _: ObjectId) -> Option<Pose> {
        None
    }
}
