//! Faithfulness: which annotations a layout fulfils.

use super::annotations::{AnnotatedRequest, Annotation, How, Says};
use super::places::{RoomRelation, kind};
use super::relations::{Relation, Thresholds, surround};
use super::scene::{ScoredObject, ScoredScene};
use super::shape::Shape;
use super::table::Table;

/// Above this a relation holds.
const THRESHOLD: f64 = 0.5;

/// What was found of an annotation.
#[derive(Clone, Debug, PartialEq)]
pub struct AnnotationVerdict<'a> {
    /// What is asked for.
    pub annotation: &'a Annotation,
    /// Whether it is there.
    pub holds: bool,
    /// How many there are that fulfil it.
    pub found: usize,
    /// Whether no object has one of its names.
    pub absent: bool,
}

/// The verdicts on a request's annotations by some thresholds, and those annotations that are not judged: sizes, which only compare, and
/// relations that the table does not have.
pub fn judge<'a>(
    asked: &'a AnnotatedRequest,
    scene: &ScoredScene,
    table: &Table,
    thresholds: &Thresholds,
) -> (Vec<AnnotationVerdict<'a>>, Vec<&'a Annotation>) {
    let (mut verdicts, mut unjudged) = (Vec::new(), Vec::new());
    for annotation in &asked.annotations {
        match verdict(annotation, scene, table, thresholds) {
            Some(verdict) => verdicts.push(verdict),
            None => unjudged.push(annotation),
        }
    }
    (verdicts, unjudged)
}

/// Whether an annotation can be judged.
pub fn is_judged(annotation: &Annotation, table: &Table) -> bool {
    match &annotation.says {
        Says::Attribute(_, adjective) => !table.has("sizes", adjective),
        Says::Between { relation, .. } => relation_of(relation, table).is_some(),
        Says::Count(_) | Says::Place { .. } => true,
    }
}

/// The geometry of a word for a relation between objects.
pub fn relation_of(word: &str, table: &Table) -> Option<Relation> {
    match table.lookups().relation(word) {
        Some(answer) => answer.and_then(Relation::of),
        None => table.find("between", word).and_then(Relation::of),
    }
}

fn verdict<'a>(
    annotation: &'a Annotation,
    scene: &ScoredScene,
    table: &Table,
    thresholds: &Thresholds,
) -> Option<AnnotationVerdict<'a>> {
    if !is_judged(annotation, table) {
        return None;
    }
    let wanted = annotation.number;
    let called = |name| scene.called(name, table).collect::<Vec<&ScoredObject>>();
    let (found, absent, holds) = match &annotation.says {
        Says::Count(name) => {
            let found = called(name).len();
            (found, found == 0, annotation.how.holds(found, wanted))
        }
        Says::Attribute(name, adjective) => {
            let all = called(name);
            let found = all.iter().filter(|thing| thing.looks.carries(adjective)).count();
            // More of them than asked for do no harm.
            let enough = annotation.how == How::Equal && found >= wanted;
            (found, all.is_empty(), enough || annotation.how.holds(found, wanted))
        }
        Says::Between { relation, reference, targets } => {
            let relation = relation_of(relation, table)?;
            let references = called(reference);
            let absent = references.is_empty() || targets.iter().any(|name| called(name).is_empty());
            if relation == Relation::Surround {
                let round = targets.first().map(|name| called(name)).unwrap_or_default();
                let round: Vec<&Shape> = round.iter().map(|thing| &thing.shape).collect();
                let found = references.iter().filter(|thing| surround(&round, &thing.shape) > THRESHOLD).count();
                (found, absent, found >= 1)
            } else {
                let holds = |target: &&ScoredObject| {
                    let others = references.iter().filter(|reference| !std::ptr::eq(**reference, *target));
                    others.into_iter().any(|other| relation.score(&target.shape, &other.shape, thresholds) > THRESHOLD)
                };
                let found = targets.iter().map(|name| called(name).iter().filter(|t| holds(t)).count()).sum();
                (found, absent, found >= wanted)
            }
        }
        Says::Place { relation, name, element } => {
            let place = RoomRelation::of(relation, element, table);
            let openings = scene.openings(kind(element));
            let all = called(name);
            let holds =
                |thing: &&&ScoredObject| place.score(&thing.shape, &scene.rooms, &openings, thresholds) > THRESHOLD;
            let found = all.iter().filter(holds).count();
            (found, all.is_empty(), found >= wanted)
        }
    };
    Some(AnnotationVerdict { annotation, holds, found, absent })
}
