//! The report as a value: what `--format json` writes, and what the other formats and the exporters read.
//!
//! Field order is the order in the file. Lengths are metres, angles degrees; an infinite margin is `None` (`null`).

use serde::{Deserialize, Serialize};

/// The value of [`Report::format`].
pub const FORMAT: &str = "scenelang.report/1";

/// What was found about one file.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Report {
    /// [`FORMAT`].
    pub format: String,
    /// The file judged, as it was named.
    pub file: String,
    /// Whether all holds and nothing stood in the way of judging it: exit code 0.
    pub ok: bool,
    /// How many of each kind hold.
    pub summary: Summary,
    /// All stated constraints in source order, judged or not; then physical ones: those that fail, or, on request, all
    /// (those that cannot be judged among them).
    pub constraints: Vec<Row>,
    /// Findings about the files themselves.
    pub diagnostics: Vec<Finding>,
    /// Fixes that were made before the file was judged (`check --fix`).
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub fixed: Vec<Fixed>,
    /// Tolerances in force.
    pub tolerances: crate::Tolerances,
    /// Thickness of the walls of a room (metres).
    pub eta: f64,
}

/// How many rows there are of each kind, and how many of them hold.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Summary {
    /// `assert` statements.
    pub assertions: Tally,
    /// `prefer` statements.
    pub preferences: Tally,
    /// Physical rules: pairs for collision, objects for bounds and support.
    pub physical: Tally,
    /// Assignments to `pos`, `rot`, `scale`, `vertices`.
    pub pins: Tally,
}

/// A count with the part of it that holds.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Tally {
    /// All.
    pub total: usize,
    /// Those that hold. What cannot be judged does not.
    pub satisfied: usize,
}

impl Tally {
    /// Counts one more.
    pub fn add(&mut self, satisfied: Option<bool>) {
        self.total += 1;
        self.satisfied += usize::from(satisfied == Some(true));
    }
}

/// What kind of constraint a row is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Kind {
    /// `assert`.
    Assert,
    /// `prefer`.
    Prefer,
    /// An assignment that the layout must agree with.
    Pin,
    /// P-COLLIDE, of a pair.
    Collision,
    /// P-BOUNDS, of an object.
    Bounds,
    /// P-SUPPORT, of an object.
    Support,
}

impl Kind {
    /// As written in the report.
    pub fn as_str(self) -> &'static str {
        match self {
            Self::Assert => "assert",
            Self::Prefer => "prefer",
            Self::Pin => "pin",
            Self::Collision => "collision",
            Self::Bounds => "bounds",
            Self::Support => "support",
        }
    }
    /// The physical rule, or `None` for a stated constraint.
    pub fn rule(self) -> Option<&'static str> {
        match self {
            Self::Collision => Some("P-COLLIDE"),
            Self::Bounds => Some("P-BOUNDS"),
            Self::Support => Some("P-SUPPORT"),
            Self::Assert | Self::Prefer | Self::Pin => None,
        }
    }
}

/// One constraint and its verdict.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Row {
    /// `room.scene:12:1` for a statement, `P-COLLIDE:a:b` (names sorted) for a physical rule.
    pub id: String,
    /// What kind.
    pub kind: Kind,
    /// `P-COLLIDE`, `P-BOUNDS`, `P-SUPPORT`; `None` for a stated constraint.
    pub rule: Option<String>,
    /// `V01…` where it fails, else `None`.
    pub code: Option<String>,
    /// The verdict; `None`: cannot be judged.
    pub satisfied: Option<bool>,
    /// By how much it holds (> 0) or fails (< 0); `None` for discrete facts and what cannot be judged.
    pub margin: Option<f64>,
    /// Unit of the margin, `m` or `deg`.
    pub unit: Option<String>,
    /// Names of the objects of the deciding instance.
    pub objects: Vec<String>,
    /// The statement as written, or the rule in words.
    pub text: String,
    /// What was measured.
    pub message: String,
    /// The statement; for a physical rule the declaration of its first object.
    pub span: Option<Place>,
    /// Weight of a preference.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub weight: Option<f64>,
    /// `@req` sentences that the statement answers.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub requirements: Vec<String>,
}

impl Row {
    /// Whether it is a hard constraint that fails.
    pub fn is_violation(&self) -> bool {
        self.satisfied == Some(false) && self.kind != Kind::Prefer
    }
}

/// A place: file, and start and end as 1-based `[line, column]` (columns count code points, the end is exclusive).
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Place {
    /// Name of the file.
    pub file: String,
    /// First line and column.
    pub start: [u32; 2],
    /// Line and column one past the last character.
    pub end: [u32; 2],
}

/// A diagnostic as the report shows it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Finding {
    /// `E0301`, `W0501`, …
    pub code: String,
    /// `error` or `warning`.
    pub severity: String,
    /// One sentence.
    pub message: String,
    /// Where; `None` where there is no text (a missing file).
    pub span: Option<Place>,
    /// Other places that belong to it.
    pub related: Vec<Related>,
    /// What it means, or what to do next.
    pub notes: Vec<String>,
    /// Ways to mend it.
    pub fixes: Vec<Remedy>,
}

/// A fix that was made.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Fixed {
    /// Name of the file.
    pub file: String,
    /// The line of the finding, in the text as it was when the fix was made.
    pub line: u32,
    /// The code of the finding.
    pub code: String,
    /// In the imperative.
    pub title: String,
}

/// Another place of a finding.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Related {
    /// What is there.
    pub message: String,
    /// Where.
    pub span: Place,
}

/// A fix: a set of replacements.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Remedy {
    /// In the imperative.
    pub title: String,
    /// `safe` or `unsafe`.
    pub applicability: String,
    /// The replacements, not overlapping.
    pub edits: Vec<Replacement>,
}

/// One replacement of text.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Replacement {
    /// What is replaced; empty: insert.
    pub span: Place,
    /// By what.
    pub text: String,
}
