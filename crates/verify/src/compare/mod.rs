//! What two layouts differ in: where things are, what they are made of, and what holds.

mod things;
mod verdicts;

pub use things::{Change, Changed, ChangedThing, DifferenceKind};
pub use verdicts::{ComparedVerdict, Difference, Turn};

use crate::check::Checked;
use crate::report::exit_code;
use crate::report::model::JudgedWith;
use scenelang_layout::Layout;
use serde::Serialize;

/// The value of [`Comparison::format`].
pub const FORMAT: &str = "scenelang.diff/1";

/// What differs between two judged layouts, by name in the order of the first, then what only the second has.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Comparison {
    /// [`FORMAT`].
    pub format: &'static str,
    /// The first layout.
    pub before: Judgement,
    /// The second layout.
    pub after: Judgement,
    /// Whether geometry, values and verdicts are the same; margins may differ where the programs do.
    pub equal: bool,
    /// Objects that differ.
    pub objects: Vec<ChangedThing>,
    /// Regions that differ.
    pub regions: Vec<ChangedThing>,
    /// Decision variables that differ.
    pub variables: Vec<Changed>,
    /// Draws that differ.
    pub draws: Vec<Changed>,
    /// Constraints whose verdict or margin differs.
    pub constraints: Vec<Difference>,
}

/// A layout and how it was judged.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Judgement {
    /// Its name.
    pub file: String,
    /// The exit code of its report.
    pub exit: u8,
    /// The settings file by which it was judged, where that makes a difference.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub judged_with: Option<JudgedWith>,
}

impl Comparison {
    /// 0: equal, 1: they differ, 2: one of them could not be judged.
    pub fn exit_code(&self) -> u8 {
        if self.before.exit == 2 || self.after.exit == 2 { 2 } else { u8::from(!self.equal) }
    }
}

/// Compares two judged layouts. A margin counts as changed beyond `threshold` (metres or degrees).
pub fn compare(before: &Checked, after: &Checked, threshold: f64) -> Comparison {
    let nothing = Layout::default();
    let layouts = [before, after].map(|c| c.layout.as_ref().unwrap_or(&nothing));
    let assets = [before, after].map(things::assets);
    let [a, b] = layouts;
    let objects = things::objects(a, b, &assets);
    let regions = things::regions(a, b);
    let variables = things::values(&a.variables, &b.variables, things::value);
    let draws = things::values(&a.draws, &b.draws, |draw| (*draw).into());
    let constraints = verdicts::differences(before, after, threshold);
    let equal = objects.is_empty()
        && regions.is_empty()
        && variables.is_empty()
        && draws.is_empty()
        && constraints.iter().all(|c| c.what.is_margin_only());
    let judgement = |Checked { report, .. }: &Checked| Judgement {
        file: report.file.clone(),
        exit: exit_code(report),
        judged_with: report.judged_with.clone(),
    };
    Comparison {
        format: FORMAT,
        before: judgement(before),
        after: judgement(after),
        equal,
        objects,
        regions,
        variables,
        draws,
        constraints,
    }
}
