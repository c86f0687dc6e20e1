//! The proposer of the published algorithm: a language model that is told the layout, the batch and the whole set, and
//! answers with new poses. What it says is never believed: the frame judges each proposal before it counts.

mod hybrid;
mod prompt;

use crate::external::steps::Proposer;
use crate::external::view::{Concern, Move, Proposal, View};
pub use hybrid::{Finisher, Hybrid, hybrid};
use prompt::{Moved, ProposedMoves};
use scenelang_llm::{Error, Message, Model, Request, Role, plain, typed};

/// Seeds that every provider takes: 31 bits.
const SEEDS: u64 = 0x7fff_ffff;

/// How a model is asked; the defaults are the published ones.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Asking {
    /// k: how many violated constraints are taken up in a round.
    pub batch: usize,
    /// T: at most so many rounds in one solve.
    pub rounds: usize,
    /// How freely the model chooses; `None`: as its provider likes.
    pub temperature: Option<f64>,
    /// At most so many tokens in an answer, those of thinking included.
    pub max_output: u64,
    /// Fixes the model's choices as far as its provider offers that.
    pub seed: u64,
}

impl Default for Asking {
    fn default() -> Self {
        Self { batch: 3, rounds: 5, temperature: Some(0.7), max_output: 16_000, seed: 0 }
    }
}

/// What came of asking.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Tally {
    /// Rounds in which the model was asked.
    pub rounds: usize,
    /// Moves that it proposed.
    pub proposed: usize,
    /// Those that were made.
    pub taken: usize,
    /// Why it was not asked on, or had no usable answer last.
    pub failed: Option<Error>,
}

/// A language model as a proposer.
pub struct ModelProposer<'m> {
    model: &'m mut dyn Model,
    asking: Asking,
    tally: Tally,
    /// The moves of the last answer that can be made at all, as the frame was given them.
    last: Vec<String>,
    /// What to tell the model of its last answer.
    refused: Vec<String>,
    over: bool,
}

impl<'m> ModelProposer<'m> {
    /// A proposer that asks `model`.
    pub fn new(model: &'m mut dyn Model, asking: Asking) -> Self {
        Self { model, asking, tally: Tally::default(), last: Vec::new(), refused: Vec::new(), over: false }
    }

    /// What came of it so far.
    pub fn tally(&self) -> &Tally {
        &self.tally
    }

    fn request(&self, view: &View<'_>, batch: &[Concern]) -> Request {
        Request {
            messages: vec![
                Message::new(Role::System, prompt::RULES),
                Message::new(Role::User, prompt::describe(view, batch, &self.refused)),
            ],
            schema: prompt::schema(),
            temperature: self.asking.temperature,
            // Asked the same again, the model is to say something else, and the cache to know the difference.
            seed: Some((self.asking.seed.wrapping_mul(1000).wrapping_add(self.tally.rounds as u64)) & SEEDS),
            max_output: self.asking.max_output,
        }
    }

    /// The moves of an answer that can be made; why the others cannot is remembered.
    fn possible(&mut self, view: &View<'_>, moves: &[Moved]) -> Vec<Move> {
        let mut out: Vec<Move> = Vec::new();
        for moved in moves {
            let name = &moved.object;
            let why = match view.object(name) {
                None => format!("there is no object `{}`", plain(name, 60)),
                Some(id) if !view.is_movable(id) => format!("{name} is fixed"),
                Some(id) if out.iter().any(|m| m.object == id) => format!("{name} was moved twice"),
                Some(id) => {
                    out.push(Move { object: id, pos: moved.pos.vector(), rot: moved.rot.vector() });
                    continue;
                }
            };
            // An answer is bounded by bytes; what it is told of itself should be so, too.
            if self.refused.len() < view.program().objects.len() {
                self.refused.push(why);
            }
        }
        out
    }
}

impl Proposer for ModelProposer<'_> {
    fn propose(&mut self, view: &View<'_>, batch: &[Concern], _round: usize) -> Vec<Proposal> {
        self.last.clear();
        // The frame may begin anew; the model is asked T times in all.
        if self.over || self.tally.rounds >= self.asking.rounds {
            return Vec::new();
        }
        self.tally.rounds += 1;
        let request = self.request(view, batch);
        self.refused.clear();
        let answer = match typed::<ProposedMoves>(self.model, &request) {
            Ok(answer) => answer,
            Err(error) => {
                // Of an answer that is no answer the next may be better; what else is wrong stays wrong.
                self.over = !matches!(error, Error::Malformed(_) | Error::CutShort | Error::Declined(_));
                self.tally.failed = Some(error);
                return Vec::new();
            }
        };
        self.tally.failed = None;
        self.tally.proposed += answer.moves.len();
        let moves = self.possible(view, &answer.moves);
        self.last = moves.iter().map(|m| view.name(m.object).to_owned()).collect();
        // All together as it was meant; where that is refused, each by itself.
        let each = moves.iter().map(|m| Proposal { moves: vec![*m] });
        let all = Proposal { moves: moves.clone() };
        if moves.len() > 1 { std::iter::once(all).chain(each).collect() } else { each.collect() }
    }

    fn judged(&mut self, taken: &[bool]) {
        let n = self.last.len();
        let together = n > 1 && taken.first() == Some(&true);
        let each = &taken[taken.len().saturating_sub(n)..];
        for (name, &taken) in self.last.iter().zip(each) {
            if together || taken {
                self.tally.taken += 1;
            } else {
                self.refused
                    .push(format!("the new position of {name} repairs nothing, or violates a constraint that holds"));
            }
        }
    }
}

#[cfg(test)]
mod tests;
