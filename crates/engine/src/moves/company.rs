//! What goes along when an object is moved: the chairs that are drawn up to a table, and what statements keep beside it. Who
//! pushes a table takes its chairs along, and with a sofa goes the coffee table before it.

use super::DEAR;
use super::choice::{Judged, keep};
use super::finder::{Attempt, FAR, MoveFinder};
use super::flaws::Sense;
use crate::rows::Goal;
use scenelang_lang::program::ObjectId;
use scenelang_verify::check::Subject;
use scenelang_verify::rules::Support;

/// So many objects go along at most, what they carry not counted.
const MOST: usize = 6;
/// So often what is left behind is asked for.
const ROUNDS: usize = 2;

impl MoveFinder<'_> {
    /// The best move of an object: with the chairs that are drawn up to it; alone; and with what statements keep beside it,
    /// where it leaves that behind, or goes far or where it is awkward so as not to.
    pub(super) fn object(&mut self, attempt: &Attempt<'_>) -> Option<Judged> {
        let near = |best: &Option<Judged>| best.as_ref().is_some_and(|b| b.is_sound() && b.cost <= FAR);
        let (mut best, began) = (None, self.stage.work);
        let mut company = self.drawn_up(attempt);
        self.leaving.clear();
        if !company.is_empty() {
            let limit = self.half_way(attempt.limit);
            best = self.besides(|finder| finder.with_company(&Attempt { limit, ..attempt.clone() }, &company));
            if near(&best) {
                return best;
            }
        }
        let limit = attempt.limit + (self.stage.work - began);
        keep(&mut best, self.with_company(&Attempt { limit, ..attempt.clone() }, &[]));
        for _ in 0..ROUNDS {
            if near(&best) {
                break;
            }
            let before = company.len();
            let leaving = std::mem::take(&mut self.leaving);
            company.extend(leaving.iter().flat_map(|judged| self.left_behind(attempt, judged)));
            company.sort_unstable();
            company.dedup();
            if company.len() == before || company.len() > MOST {
                break;
            }
            // Whoever was looked at first may have left nothing.
            let limit = self.half_way(attempt.limit).max(self.share());
            let found = self.besides(|finder| finder.with_company(&Attempt { limit, ..attempt.clone() }, &company));
            keep(&mut best, found);
        }
        if best.as_ref().is_none_or(|b| b.harm() != (0, 0)) {
            let found = self.besides(|finder| finder.with_its_table(attempt));
            keep(&mut best, found);
        }
        best
    }

    /// Looks for something besides: what that takes is not missing for other objects.
    fn besides<T>(&mut self, look: impl FnOnce(&mut Self) -> T) -> T {
        let before = self.stage.work;
        let found = look(self);
        self.limit += self.stage.work - before;
        found
    }

    /// A move of the table to which a chair is drawn up, with all its chairs: what has slid out of a corner is pushed back as
    /// a whole.
    fn with_its_table(&mut self, attempt: &Attempt<'_>) -> Option<Judged> {
        self.stage.set(attempt.steps);
        let found = {
            let sense = Sense::new(self.stage.program, self.stage.world());
            let objects = self.stage.world().bodies().map(|(id, _)| id);
            objects.map(|id| (id, sense.drawn_up(id))).find(|(_, seats)| seats.contains(&attempt.object))
        };
        let (table, seats) = found?;
        let all = seats.iter().chain([&table]);
        if seats.len() > MOST || all.into_iter().any(|id| !self.may_go_along(attempt, *id)) {
            return None;
        }
        let limit = self.half_way(attempt.limit).max(self.share());
        self.with_company(&Attempt { object: table, limit, ..attempt.clone() }, &seats)
    }

    /// The chairs that are drawn up to an object, where no goal is about them.
    fn drawn_up(&mut self, attempt: &Attempt<'_>) -> Vec<ObjectId> {
        self.stage.set(attempt.steps);
        let seats = Sense::new(self.stage.program, self.stage.world()).drawn_up(attempt.object);
        if seats.len() > MOST || seats.iter().any(|id| self.is_meant(attempt, *id)) {
            return Vec::new();
        }
        let stays = seats.iter().any(|id| !self.may_go_along(attempt, *id));
        if stays { Vec::new() } else { seats }
    }

    /// What a move leaves behind that belongs to the object, or runs into: what the statements that it breaks speak of, and
    /// what it comes to overlap though a statement keeps both together.
    fn left_behind(&self, attempt: &Attempt<'_>, judged: &Judged) -> Vec<ObjectId> {
        let object = attempt.object;
        let mut found: Vec<ObjectId> = Vec::new();
        for row in &judged.does.breaks {
            match row.subject {
                Subject::Statement(_)
                    if self.stage.cost(Goal::Row(*row)) <= DEAR && self.stage.is_about(row, object) =>
                {
                    found.extend(self.stage.spoken_of(&[Goal::Row(*row)], object));
                }
                Subject::Pair(a, b) => {
                    let pair = [a, b];
                    let other = pair.into_iter().find(|id| *id != object).filter(|_| pair.contains(&object));
                    found.extend(other.filter(|id| self.stage.are_related(object, *id)));
                }
                _ => {}
            }
        }
        found.retain(|id| !self.is_meant(attempt, *id) && self.may_go_along(attempt, *id));
        found
    }

    /// Whether cheap goals speak of an object: then it is one of two that are to be moved apart or together.
    fn is_meant(&self, attempt: &Attempt<'_>, id: ObjectId) -> bool {
        let cheap = attempt.goals.iter().filter(|goal| self.stage.cost(**goal) <= DEAR).copied();
        self.stage.objects_of_all(&cheap.collect::<Vec<_>>()).contains(&id)
    }

    /// Whether an object may be moved because another one is.
    fn may_go_along(&self, attempt: &Attempt<'_>, id: ObjectId) -> bool {
        let pinned = || self.stage.pins(id, attempt.free).iter().any(Option::is_some);
        // What hangs on a wall stays there.
        let stands = self.stage.scope.support(id) != Support::Mounted;
        stands && !self.stage.is_fitting(id) && !self.locked.contains(&id) && !pinned()
    }

    /// Half of the work that is left up to a limit.
    fn half_way(&self, limit: usize) -> usize {
        self.stage.work + limit.saturating_sub(self.stage.work) / 2
    }
}
