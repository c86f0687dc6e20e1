//! Differences in what holds, and by how much. Statements are found again by their text, so that a program whose lines
//! have moved is no difference; physical rules by their names.

use crate::check::Checked;
use crate::report::model::{Row, RowKind};
use serde::Serialize;
use std::collections::HashMap;

/// A constraint whose verdict or margin differs.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Difference {
    /// Its id in the second report, or in the first where only that has it.
    pub id: String,
    pub kind: RowKind,
    /// As written, or the rule in words.
    pub text: String,
    pub what: Turn,
    /// Unit of the margins.
    pub unit: Option<String>,
    /// In the first; `None`: not listed there. A physical rule is listed only where it fails.
    pub before: Option<ComparedVerdict>,
    /// In the second, likewise.
    pub after: Option<ComparedVerdict>,
}

#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct ComparedVerdict {
    /// `None`: cannot be judged.
    pub satisfied: Option<bool>,
    /// `None`: a discrete fact, or it cannot be judged.
    pub margin: Option<f64>,
}

/// How a verdict differs.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub enum Turn {
    /// It failed.
    #[serde(rename = "begins to hold")]
    Begins,
    /// It held.
    #[serde(rename = "ceases to hold")]
    Ceases,
    /// The verdict is the same.
    #[serde(rename = "margin grows")]
    Grows,
    /// The verdict is the same.
    #[serde(rename = "margin shrinks")]
    Shrinks,
    /// Only the second program has it.
    #[serde(rename = "added")]
    Added,
    /// Only the first program has it.
    #[serde(rename = "removed")]
    Removed,
    /// It could not.
    #[serde(rename = "can be judged")]
    Judged,
    /// It could.
    #[serde(rename = "cannot be judged")]
    Unjudged,
}

impl Turn {
    /// As written.
    pub fn as_str(self) -> &'static str {
        match self {
            Self::Begins => "begins to hold",
            Self::Ceases => "ceases to hold",
            Self::Grows => "margin grows",
            Self::Shrinks => "margin shrinks",
            Self::Added => "added",
            Self::Removed => "removed",
            Self::Judged => "can be judged",
            Self::Unjudged => "cannot be judged",
        }
    }
    /// Whether the verdict itself is the same.
    pub fn is_margin_only(self) -> bool {
        matches!(self, Self::Grows | Self::Shrinks)
    }
}

/// What finds a row again in another report: kind and text, and which of several equal ones.
type Key<'a> = (RowKind, &'a str, usize);

fn keyed(checked: &Checked) -> Vec<(Key<'_>, &Row)> {
    let mut seen: HashMap<(RowKind, &str), usize> = HashMap::new();
    checked
        .report
        .constraints
        .iter()
        .map(|row| {
            let text = if row.rule.is_some() { row.id.as_str() } else { row.text.as_str() };
            let count = seen.entry((row.kind, text)).or_default();
            *count += 1;
            ((row.kind, text, *count), row)
        })
        .collect()
}

pub(super) fn differences(before: &Checked, after: &Checked, threshold: f64) -> Vec<Difference> {
    let (a, b) = (keyed(before), keyed(after));
    let [in_a, in_b] = [&a, &b].map(|rows| rows.iter().copied().collect::<HashMap<Key<'_>, &Row>>());
    let pairs = a.iter().map(|(key, row)| (Some(*row), in_b.get(key).copied()));
    let new = b.iter().filter(|(key, _)| !in_a.contains_key(key)).map(|(_, row)| (None, Some(*row)));
    pairs
        .chain(new)
        .filter_map(|(x, y)| {
            let row = y.or(x)?;
            let what = match (x, y) {
                (Some(x), Some(y)) => turn(x, y, threshold)?,
                // A rule that is not listed holds, if there is what it speaks of.
                (Some(x), None) if x.rule.is_some() && knows(after, x) => Turn::Begins,
                (Some(_), None) => Turn::Removed,
                (None, _) if row.rule.is_some() && knows(before, row) => Turn::Ceases,
                (None, _) => Turn::Added,
            };
            let side = |row: &Row| ComparedVerdict { satisfied: row.satisfied, margin: row.margin };
            Some(Difference {
                id: row.id.clone(),
                kind: row.kind,
                text: row.text.clone(),
                what,
                unit: row.unit.clone().or_else(|| x?.unit.clone()),
                before: x.map(side),
                after: y.map(side),
            })
        })
        .collect()
}

/// Whether a program was judged that has the objects of a row.
fn knows(checked: &Checked, row: &Row) -> bool {
    let Some(program) = &checked.program else { return false };
    row.objects.iter().all(|name| program.objects.iter().any(|o| o.name == *name))
}

fn turn(x: &Row, y: &Row, threshold: f64) -> Option<Turn> {
    match (x.satisfied, y.satisfied) {
        (Some(true), Some(false)) => Some(Turn::Ceases),
        (Some(false), Some(true)) => Some(Turn::Begins),
        (Some(_), None) => Some(Turn::Unjudged),
        (None, Some(_)) => Some(Turn::Judged),
        _ => {
            let by = y.margin? - x.margin?;
            (by.abs() > threshold).then_some(if by > 0.0 { Turn::Grows } else { Turn::Shrinks })
        }
    }
}
