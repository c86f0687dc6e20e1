//! The report as a value: what `--format json` writes, and what the other formats and the exporters read.
//!
//! Field order is the order in the file. Lengths are metres, angles degrees; an infinite margin is `None` (`null`).

use scenelang_base::{Code, codes, plain};
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
    /// How much of what the guidelines ask holds, where the program has any.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub design: Option<Design>,
    /// All stated constraints in source order, judged or not; then physical ones: those that fail, or, on request, all
    /// (those that cannot be judged among them).
    pub constraints: Vec<Row>,
    /// How many rows of physical rules are counted and not listed.
    #[serde(default, skip_serializing_if = "Unlisted::is_nothing")]
    pub unlisted: Unlisted,
    /// Findings about the files themselves.
    pub diagnostics: Vec<Finding>,
    /// Fixes that were made before the file was judged (`check --fix`).
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub fixed: Vec<Fixed>,
    /// The settings file by which it was judged, where that makes a difference.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub judged_with: Option<JudgedWith>,
    /// The program's permissions to collide, each with what it hides. Only `check` measures it.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub permissions: Vec<Permission>,
    /// Tolerances in force.
    pub tolerances: crate::Tolerances,
    /// Thickness of the walls of a room (metres).
    pub eta: f64,
}

/// An `allowCollide` and what it hides.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Permission {
    /// The statement as written, blanks folded.
    pub text: String,
    /// The pair that is deepest inside each other; `None`: none is, or too much is in one place to say.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub hides: Option<Overlap>,
    /// Whether all pairs were measured.
    pub complete: bool,
}

/// Two objects inside each other.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Overlap {
    /// The two.
    pub objects: [String; 2],
    /// How deep they are inside each other (metres).
    pub depth: f64,
    /// How many other pairs there are that the statement permits.
    pub others: usize,
}

/// The settings file that makes a judgement another than the usual one.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct JudgedWith {
    /// What the file is called.
    pub file: String,
    /// What it changes: "physics off".
    pub changes: Vec<String>,
}

impl JudgedWith {
    /// The same in a line.
    pub fn in_words(&self) -> String {
        plain::line(&format!("checked with {}: {}", self.file, self.changes.join(", "))).into_owned()
    }
}

/// How a room keeps to the guidelines of `std/guidelines.scene`. They are preferences too, and counted among these.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Design {
    /// The weight of those that hold, as a share of the weight of all: 0 to 1.
    pub figure: f64,
    /// How many there are, one for each thing that a guideline speaks of.
    pub guidelines: Tally,
}

/// How many rows there are of each kind, and how many of them hold.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Summary {
    /// `assert` statements.
    pub assertions: Tally,
    /// `prefer` statements.
    pub preferences: Tally,
    /// Physical rules: pairs for collision, objects for bounds and support, movable parts for what opens.
    pub physical: Tally,
    /// Assignments to `pos`, `rot`, `scale`, `vertices`.
    pub pins: Tally,
}

impl Summary {
    /// The count of a kind of statement.
    pub fn stated(&mut self, kind: RowKind) -> &mut Tally {
        match kind {
            RowKind::Prefer => &mut self.preferences,
            RowKind::Pin => &mut self.pins,
            _ => &mut self.assertions,
        }
    }
}

/// Rows that are counted and not listed: there may be millions.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Unlisted {
    /// Those that fail, by less than those of the same rule that are listed.
    pub failing: usize,
    /// Those that hold, where all that holds was asked for.
    pub holding: usize,
}

impl Unlisted {
    /// Whether all rows are listed.
    pub fn is_nothing(&self) -> bool {
        *self == Self::default()
    }
    /// What fails and is not listed, in a sentence.
    pub fn failing_in_words(&self) -> Option<String> {
        let Self { failing, .. } = self;
        let rules = if *failing == 1 { "rule fails" } else { "rules fail" };
        (*failing > 0).then(|| format!("{failing} more physical {rules}; those that fail by the most are listed"))
    }
    /// What holds and is not listed, in a sentence.
    pub fn holding_in_words(&self) -> Option<String> {
        (self.holding > 0).then(|| format!("{} more physical rules hold, which are too many to list", self.holding))
    }
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
    /// Takes back what was added.
    pub fn remove(&mut self, satisfied: Option<bool>) {
        self.total -= 1;
        self.satisfied -= usize::from(satisfied == Some(true));
    }
}

/// What kind of constraint a row is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum RowKind {
    Assert,
    Prefer,
    /// An assignment that the layout must agree with.
    Pin,
    /// P-COLLIDE, of a pair.
    Collision,
    /// P-BOUNDS, of an object.
    Bounds,
    /// P-SUPPORT, of an object.
    Support,
    /// P-OPEN, of a movable part of an object.
    Open,
}

impl RowKind {
    pub const ALL: [Self; 7] =
        [Self::Assert, Self::Prefer, Self::Pin, Self::Collision, Self::Bounds, Self::Support, Self::Open];

    /// As written in the report.
    pub fn as_str(self) -> &'static str {
        match self {
            Self::Assert => "assert",
            Self::Prefer => "prefer",
            Self::Pin => "pin",
            Self::Collision => "collision",
            Self::Bounds => "bounds",
            Self::Support => "support",
            Self::Open => "open",
        }
    }
    /// What a violation of it is called, unless it has a better name.
    pub fn code(self) -> Code {
        match self {
            Self::Assert => codes::V0101,
            Self::Collision => codes::V0102,
            Self::Bounds => codes::V0103,
            Self::Support => codes::V0104,
            Self::Open => codes::V0107,
            Self::Pin => codes::V0105,
            Self::Prefer => codes::V0106,
        }
    }
    /// The physical rule, or `None` for a stated constraint.
    pub fn rule(self) -> Option<&'static str> {
        match self {
            Self::Collision => Some("P-COLLIDE"),
            Self::Bounds => Some("P-BOUNDS"),
            Self::Support => Some("P-SUPPORT"),
            Self::Open => Some("P-OPEN"),
            Self::Assert | Self::Prefer | Self::Pin => None,
        }
    }
}

/// One constraint and its verdict.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Row {
    /// `room.scene:12:1` for a statement; for a physical rule `P-COLLIDE:a:b` (names sorted), `P-BOUNDS:a`, `P-OPEN:a/door`.
    pub id: String,
    pub kind: RowKind,
    /// `P-COLLIDE`, `P-BOUNDS`, `P-SUPPORT`, `P-OPEN`; `None` for a stated constraint.
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
    pub span: Option<SourceSpan>,
    /// Weight of a preference.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub weight: Option<f64>,
    /// `@req` sentences that the statement answers.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub requirements: Vec<String>,
    /// The guideline that it is an instance of.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub guideline: Option<String>,
    /// Why it fails, where it does.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub explanation: Option<Explanation>,
}

/// Why a row fails, and what would repair it. Of violations beyond the first ones only what was measured.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Explanation {
    /// Both sides of the comparison that decided; of a rule or a built-in predicate what was measured, and what it may
    /// be at worst.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub measured: Option<Measured>,
    /// The objects of the deciding instance.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub objects: Vec<Whereabouts>,
    /// Rows that hold, and would fail or come nearest to it under the smallest move that repairs this one: their ids.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub opposing: Vec<String>,
    /// A move after which the row holds; the one that breaks least and, of these, the smallest.
    #[serde(default, rename = "move", skip_serializing_if = "Option::is_none")]
    pub repair: Option<Move>,
    /// Moves after which the row holds and that break nothing, the best first: each moves another object, or turns one
    /// instead of moving it.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub choices: Vec<Move>,
    /// Where all objects of the row are pinned, the rows of these assignments.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub pinned: Vec<String>,
}

/// Both sides of a comparison: a number each, or three. `null` is infinite: there is no way to walk.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Measured {
    /// What was found.
    pub left: Option<Quantity>,
    /// What it was compared with.
    pub right: Option<Quantity>,
    /// `m` (plain numbers, too) or `deg`.
    pub unit: String,
}

/// A number, or the three of a vector or a rotation.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(untagged)]
pub enum Quantity {
    Number(f64),
    /// x, y and z.
    Triple([f64; 3]),
}

/// Where an object is.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Whereabouts {
    pub name: String,
    /// Centre of its bottom face (metres).
    pub pos: [f64; 3],
    /// Its Euler triple (degrees).
    pub rot: [f64; 3],
    /// Its extents (metres).
    pub size: [f64; 3],
    /// The same in words.
    pub text: String,
}

/// A move that repairs a row.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Move {
    /// The object that is moved first, or alone.
    pub object: String,
    /// Along x, y, z (metres).
    pub by: [f64; 3],
    /// Added to its `rot.y` (degrees).
    pub turn: f64,
    /// What else is moved: what goes along because it rests on the object, or must be moved as well.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub also: Vec<FurtherMove>,
    /// Ids of rows that hold now and fail after it.
    pub breaks: Vec<String>,
    /// Ids of other rows that fail now and hold after it. Version 0.1 called them `mends`.
    #[serde(alias = "mends")]
    pub repairs: Vec<String>,
    /// The same in words.
    pub text: String,
}

/// A further object that is moved.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct FurtherMove {
    /// Its name.
    pub object: String,
    /// Along x, y, z (metres).
    pub by: [f64; 3],
    /// Added to its `rot.y` (degrees).
    pub turn: f64,
}

impl Row {
    /// Whether it is a hard constraint that fails.
    pub fn is_violation(&self) -> bool {
        self.satisfied == Some(false) && self.kind != RowKind::Prefer
    }
}

/// A place: file, and start and end as 1-based `[line, column]` (columns count code points, the end is exclusive).
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct SourceSpan {
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
    pub span: Option<SourceSpan>,
    /// Other places that belong to it.
    pub related: Vec<Related>,
    /// What it means, or what to do next.
    pub notes: Vec<String>,
    /// Ways to repair it.
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
    pub span: SourceSpan,
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
    pub span: SourceSpan,
    pub text: String,
}
