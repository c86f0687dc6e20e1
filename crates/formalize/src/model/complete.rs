//! Hidden constraints: what nobody says and the world needs. That solids do not overlap, that things rest on something
//! and stay in their region, are rules of the language; here is what must be said of single objects: what hangs, what
//! lies under others, what needs room before it, where a thing stands that nothing is said of.

use super::ask::{Asker, COMPLETE, Trouble};
use super::constrain::statements;
use super::divide::SentenceNumbers;
use super::sentences::Sentences;
use crate::draft::{Draft, Statement, ThingOrigin};

/// Statements that complete those of a region. None of them is the request's.
pub(super) fn complete(
    asker: &mut Asker<'_>,
    sentences: &Sentences,
    part: &SentenceNumbers,
    room: usize,
    draft: &mut Draft,
    given: &[Statement],
) -> Result<Vec<Statement>, Trouble> {
    let mut added = statements(asker, COMPLETE, sentences, part, room, draft, given)?;
    for statement in &mut added {
        if let ThingOrigin::Stated(_) = statement.source {
            statement.source = ThingOrigin::Inferred("needed for a complete room".into());
        }
    }
    Ok(added)
}
