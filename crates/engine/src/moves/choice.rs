//! Moves that were judged: which of two is better, and which are offered as choices.

use super::stage::Consequences;
use scenelang_lang::program::ObjectId;
use scenelang_verify::explain::ObjectMove;
use scenelang_verify::report::model::RowKind;
use std::cmp::Reverse;

/// So many choices are offered.
const CHOICES: usize = 3;
/// What a flaw counts (metres): so much farther does one go to avoid it.
const FLAW: f64 = 3.0;
/// What a second direction counts (metres): who can push something along a wall does not push it away from that as well.
/// What goes farther than this (metres) is carried, and has no directions.
const DIRECTION: f64 = 0.1;
const PUSHED: f64 = 1.0;
/// What it counts that a move cannot be said in millimetres (metres).
const ODD: f64 = 0.1;
/// A choice costs at most so many times what the first one costs, and so much more (metres): nobody moves a wardrobe
/// across the room where a chair can be pushed aside.
const FARTHER: (f64, f64) = (3.0, 0.5);

/// A move with what it does.
#[derive(Clone, Debug)]
pub(super) struct Judged {
    pub cost: f64,
    pub steps: Vec<ObjectMove>,
    pub does: Consequences,
    /// Of what is wanted, how much does not hold.
    pub open: usize,
    /// How much it makes awkward that was not.
    pub flaws: usize,
    /// Whether it moves a door or a window.
    pub fitting: bool,
    /// How many objects go along that it does not carry.
    pub company: usize,
    /// Whether it only turns an object, and that is what the rows are about.
    pub directed: bool,
}

impl Judged {
    /// How much that must hold is broken or left as it is; then how many preferences are broken.
    pub fn harm(&self) -> (usize, usize) {
        let (hard, soft) = self.does.harm();
        (hard + self.open, soft)
    }

    /// Whether nobody has a reason to look for another one.
    pub fn is_sound(&self) -> bool {
        self.harm() == (0, 0) && self.flaws == 0
    }

    /// What it costs with what is awkward about it.
    fn price(&self) -> f64 {
        let pushed = |step: &&ObjectMove| step.with.is_none() && step.by[0].hypot(step.by[2]) <= PUSHED;
        let ways = self
            .steps
            .iter()
            .filter(pushed)
            .map(|step| [step.by[0], step.by[2]].iter().filter(|by| **by != 0.0).count().saturating_sub(1));
        let odd = |step: &&ObjectMove| step.by.iter().any(|by| (by * 1e3 - (by * 1e3).round()).abs() > 1e-6);
        let odd = self.steps.iter().filter(|step| step.with.is_none()).filter(odd).count();
        self.cost + FLAW * self.flaws as f64 + DIRECTION * ways.sum::<usize>() as f64 + ODD * odd as f64
    }

    /// Less harm first, then what leaves doors and windows alone, then what repairs more, then turns that are asked for,
    /// then the one that is smaller and less awkward.
    pub fn better_than(&self, other: &Self) -> bool {
        let hard = |j: &Self| j.does.repairs.iter().filter(|row| row.kind != RowKind::Prefer).count();
        let key = |j: &Self| (j.harm(), j.fitting, Reverse(hard(j)), !j.directed);
        key(self) < key(other) || key(self) == key(other) && self.price() < other.price()
    }

    /// What is moved by itself, and whether it is only turned. Of moves of the same kind one is enough.
    fn kind(&self) -> Vec<(ObjectId, bool)> {
        let own = self.steps.iter().filter(|step| step.with.is_none());
        let mut kind: Vec<(ObjectId, bool)> = own.map(|step| (step.object, is_turn(step))).collect();
        kind.sort_unstable();
        kind
    }
}

/// Keeps the better one.
pub(super) fn keep(best: &mut Option<Judged>, new: Option<Judged>) {
    if let Some(new) = new.filter(|new| best.as_ref().is_none_or(|b| new.better_than(b))) {
        *best = Some(new);
    }
}

/// Whether a step turns its object where it stands.
pub(super) fn is_turn(step: &ObjectMove) -> bool {
    step.by == [0.0; 3]
}

/// What is offered beside the best move: others that do no harm and are no more awkward, each of its own kind. Where the best one does harm, there
/// are none.
pub(super) fn choose(best: Judged, others: Vec<Judged>) -> Vec<Judged> {
    let most = FARTHER.0 * best.price() + FARTHER.1;
    let mut choices = vec![best];
    if choices[0].harm() != (0, 0) {
        return choices;
    }
    let best = choices[0].clone();
    // What can be turned need not be moved as well.
    let turned = |other: &Judged| best.directed && other.kind().iter().any(|(id, _)| *id == best.steps[0].object);
    // Nobody carries a sofa and its table across the room where one lamp can be moved.
    let carries = |other: &Judged| {
        let far = |step: &ObjectMove| step.with.is_none() && step.by[0].hypot(step.by[2]) > PUSHED;
        other.company > best.company && other.steps.iter().any(far)
    };
    let fits = |other: &Judged| {
        other.price() <= most
            && other.fitting <= best.fitting
            && other.flaws <= best.flaws
            && !turned(other)
            && !carries(other)
    };
    let mut others: Vec<Judged> = others.into_iter().filter(fits).collect();
    while choices.len() < CHOICES {
        others.retain(|other| choices.iter().all(|known| known.kind() != other.kind()));
        let mut next = None;
        others.iter().for_each(|other| keep(&mut next, Some(other.clone())));
        let Some(next) = next else { break };
        choices.push(next);
    }
    choices
}
