//! The one diagnostic type for every surface: terminal, JSON, SARIF, editor.
//!
//! A diagnostic is a value. It is generic over what a place is (`P`): the compiler speaks of places relative to
//! statements, so that an edit above does not change them; everything past the compiler uses absolute [`Span`]s.

use crate::{Code, Span};

/// How bad it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Severity {
    /// Cannot be judged, or is proved impossible.
    Error,
    /// Suspicious, but judged all the same.
    Warning,
}

impl Severity {
    /// As written in reports.
    pub fn as_str(self) -> &'static str {
        match self {
            Self::Error => "error",
            Self::Warning => "warning",
        }
    }
}

/// A place with a sentence about it.
#[derive(Clone, Debug, PartialEq)]
pub struct Label<P = Span> {
    /// Where.
    pub place: P,
    /// What is there; may be empty for the primary label.
    pub message: String,
}

/// Whether a fix may be applied without asking.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Applicability {
    /// Keeps the meaning, or can only mean this.
    Safe,
    /// A good guess that a person should look at.
    Unsafe,
}

/// One replacement of text.
#[derive(Clone, Debug, PartialEq)]
pub struct Edit<P = Span> {
    /// What is replaced (empty: insert).
    pub place: P,
    pub text: String,
}

/// A set of edits that repairs what the diagnostic says.
#[derive(Clone, Debug, PartialEq)]
pub struct Fix<P = Span> {
    /// In the imperative: "write `:=`".
    pub title: String,
    /// The edits, not overlapping.
    pub edits: Vec<Edit<P>>,
    /// Whether it may be applied without asking.
    pub applicability: Applicability,
}

/// A finding: code, severity, sentence, places, notes, fixes.
#[derive(Clone, Debug, PartialEq)]
pub struct Diagnostic<P = Span> {
    /// Stable code, with a page of its own.
    pub code: Code,
    /// How bad.
    pub severity: Severity,
    /// One plain sentence, without a full stop.
    pub message: String,
    /// Where it is; `None` only where there is no text at all (a missing file).
    pub primary: Option<Label<P>>,
    /// Other places that belong to it.
    pub related: Vec<Label<P>>,
    /// What it means, or what to do next.
    pub notes: Vec<String>,
    /// Ways to repair it.
    pub fixes: Vec<Fix<P>>,
}

impl<P> Diagnostic<P> {
    /// A diagnostic with the severity of its code.
    pub fn new(code: Code, place: P, message: impl Into<String>) -> Self {
        Self {
            code,
            severity: code.severity(),
            message: message.into(),
            primary: Some(Label { place, message: String::new() }),
            related: Vec::new(),
            notes: Vec::new(),
            fixes: Vec::new(),
        }
    }
    /// A diagnostic about something that has no text (a file that is not there).
    pub fn without_place(code: Code, message: impl Into<String>) -> Self {
        Self {
            code,
            severity: code.severity(),
            message: message.into(),
            primary: None,
            related: Vec::new(),
            notes: Vec::new(),
            fixes: Vec::new(),
        }
    }
    /// Says something at the primary place.
    pub fn label(mut self, message: impl Into<String>) -> Self {
        if let Some(primary) = &mut self.primary {
            primary.message = message.into();
        }
        self
    }
    /// Adds another place.
    pub fn related(mut self, place: P, message: impl Into<String>) -> Self {
        self.related.push(Label { place, message: message.into() });
        self
    }
    /// Adds a note.
    pub fn note(mut self, note: impl Into<String>) -> Self {
        self.notes.push(note.into());
        self
    }
    /// Adds a fix that replaces one place.
    pub fn fix(
        mut self,
        applicability: Applicability,
        title: impl Into<String>,
        place: P,
        text: impl Into<String>,
    ) -> Self {
        let edits = vec![Edit { place, text: text.into() }];
        self.fixes.push(Fix { title: title.into(), edits, applicability });
        self
    }
    /// Whether it is an error.
    pub fn is_error(&self) -> bool {
        self.severity == Severity::Error
    }
    /// The same diagnostic with its places translated.
    pub fn map_places<Q>(self, mut f: impl FnMut(P) -> Q) -> Diagnostic<Q> {
        Diagnostic {
            code: self.code,
            severity: self.severity,
            message: self.message,
            primary: self.primary.map(|l| Label { place: f(l.place), message: l.message }),
            related: self.related.into_iter().map(|l| Label { place: f(l.place), message: l.message }).collect(),
            notes: self.notes,
            fixes: self
                .fixes
                .into_iter()
                .map(|x| Fix {
                    title: x.title,
                    applicability: x.applicability,
                    edits: x.edits.into_iter().map(|e| Edit { place: f(e.place), text: e.text }).collect(),
                })
                .collect(),
        }
    }
}
