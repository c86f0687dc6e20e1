//! Traceability: from each requirement to the statements that answer it, the objects they speak of and the verdict; and
//! from each object back.
//!
//! A requirement is a sentence of `@req`. One whose only bearers are predicates, variables or imports has no statement:
//! nothing is declared for it, nothing asked.

use crate::report::model::JudgedWith;
use crate::report::{Report, statement_id};
use rustc_hash::FxHashMap;
use scenelang_base::{SourceMap, Span};
use scenelang_lang::Compiled;
use scenelang_lang::ast::{Stmt, StmtKind, TypeWord};
use scenelang_lang::parse::parse_file;
use scenelang_lang::program::{ConstraintKind, ObjectId, Program};
use serde::{Deserialize, Serialize};
use std::collections::{BTreeMap, BTreeSet};

/// What a trace calls itself.
const FORMAT: &str = "scenelang.trace/1";

/// What begins a requirement that no request states: a reason of the tool that wrote the program.
const INFERRED: &str = "inferred: ";

/// What became of the requirements of a program.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Trace {
    /// `scenelang.trace/1`
    pub format: String,
    /// The program.
    pub file: String,
    /// The layout that was judged; `None`: there is none.
    pub layout: Option<String>,
    /// How many requirements have which verdict.
    pub summary: Summary,
    /// In the order of the program, each once.
    pub requirements: Vec<Requirement>,
    /// Objects and regions in the order of the program; an array is one object.
    pub objects: Vec<TracedThing>,
    /// Statements that answer no requirement.
    pub untraced: Vec<Statement>,
    /// The settings file by which the layout was judged, where that makes a difference.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub judged_with: Option<JudgedWith>,
}

/// How many requirements have which verdict.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Summary {
    /// All of them.
    pub requirements: usize,
    /// Those among them that no request states.
    pub inferred: usize,
    /// Every statement holds.
    pub holds: usize,
    /// A statement that must hold fails.
    pub fails: usize,
    /// A preference is not met.
    pub unmet: usize,
    /// A statement cannot be judged.
    pub unknown: usize,
    /// There is no layout to judge.
    pub not_judged: usize,
    /// There is nothing to judge: it is answered by what is declared or said to be.
    pub declared: usize,
    /// There is no statement.
    pub none: usize,
}

/// What became of a requirement.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Verdict {
    /// Every statement holds.
    Holds,
    /// A statement that must hold fails.
    Fails,
    /// A preference is not met.
    Unmet,
    /// A statement cannot be judged.
    Unknown,
    /// There is no layout to judge.
    NotJudged,
    /// There is nothing to judge: it is answered by what is declared or said to be.
    Declared,
    /// There is no statement.
    None,
}

#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Requirement {
    /// The sentence, or the reason.
    pub text: String,
    /// Whether it is a reason: no request states it.
    pub inferred: bool,
    /// What became of it.
    pub verdict: Verdict,
    /// Objects and regions declared for it.
    pub declares: Vec<String>,
    pub statements: Vec<Statement>,
}

#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Statement {
    /// As in reports: `room.scene:12:1`.
    pub id: String,
    pub kind: StatementKind,
    /// As written, on one line.
    pub text: String,
    /// The objects that it speaks of; an array of which it speaks as a whole by its name. An assignment may also speak of
    /// a region.
    pub objects: Vec<String>,
    /// Whether it holds; `None`: it cannot be judged, or there is no layout, or there is nothing to judge.
    pub satisfied: Option<bool>,
    /// By how much it holds (> 0) or fails (< 0).
    pub margin: Option<f64>,
    /// Unit of the margin, `m` or `deg`.
    pub unit: Option<String>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum StatementKind {
    Assert,
    Prefer,
    /// What the layout is held to: an assignment to a place or a size.
    Pin,
    /// `allowCollide`, `allowOutside`, `allowFloat`
    Allow,
    /// Any other property: a colour, a category.
    Property,
}

/// An object, or a region.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct TracedThing {
    pub name: String,
    /// `object` or `region`.
    pub kind: String,
    /// The requirements that it was declared for, or that speak of it: indices into [`Trace::requirements`].
    pub requirements: Vec<usize>,
    /// Ids of the statements that speak of it, with or without a requirement.
    pub statements: Vec<String>,
    /// Whether all statements hold that must; `None`: one cannot be judged, or there is none to judge.
    pub satisfied: Option<bool>,
}

impl Trace {
    /// 1 if a requirement fails or has no statement, else 0. That something cannot be judged its report says.
    pub fn exit_code(&self) -> u8 {
        u8::from(self.summary.fails > 0 || self.summary.none > 0)
    }
}

/// Traces a program called `name`. `judged`: the report on a layout of it, and the layout's name.
pub fn trace(name: &str, compiled: &Compiled, judged: Option<(&str, &Report)>) -> Trace {
    let mut builder = Builder::new(name, compiled, judged.map(|(_, report)| report));
    for (file, source) in compiled.sources.iter() {
        for (offset, stmt) in &parse_file(source.text()).statements {
            builder.statement(stmt, stmt.range.shifted(*offset).in_file(file));
        }
    }
    builder.finish(name, judged.map(|(layout, _)| layout.to_owned()))
}

struct Builder<'a> {
    name: &'a str,
    sources: &'a SourceMap,
    program: Option<&'a Program>,
    judged: Option<&'a Report>,
    /// Constraints and permissions by where they begin.
    constraints: BTreeMap<(u32, u32), usize>,
    permissions: BTreeMap<(u32, u32), usize>,
    rows: BTreeMap<&'a str, usize>,
    /// How many elements the arrays have.
    arrays: FxHashMap<&'a str, usize>,
    requirements: Vec<Requirement>,
    numbers: BTreeMap<String, usize>,
    things: Vec<TracedThing>,
    all: Vec<Statement>,
    untraced: Vec<Statement>,
}

impl<'a> Builder<'a> {
    fn new(name: &'a str, compiled: &'a Compiled, judged: Option<&'a Report>) -> Self {
        let program = compiled.program.as_ref();
        let start = |span: &Span| (span.file.0, span.range.start);
        let spans = program.into_iter().flat_map(|program| &program.constraints).map(|c| start(&c.span));
        let stated = program.into_iter().flat_map(|program| &program.allow.stated).map(|a| start(&a.span));
        let rows = judged.into_iter().flat_map(|report| &report.constraints);
        Self {
            name,
            sources: &compiled.sources,
            program,
            judged,
            constraints: spans.zip(0..).collect(),
            permissions: stated.zip(0..).collect(),
            rows: rows.zip(0..).map(|(row, index)| (row.id.as_str(), index)).collect(),
            arrays: program.map(elements).unwrap_or_default(),
            requirements: Vec::new(),
            numbers: BTreeMap::new(),
            things: Vec::new(),
            all: Vec::new(),
            untraced: Vec::new(),
        }
    }

    fn statement(&mut self, stmt: &Stmt, span: Span) {
        let numbers: Vec<usize> = stmt.requirements.iter().map(|(text, _)| self.number(text)).collect();
        if let StmtKind::Declare { ty: ty @ (TypeWord::Object | TypeWord::Region), name, .. } = &stmt.kind {
            for number in &numbers {
                self.requirements[*number].declares.push(name.text.to_string());
            }
            self.things.push(TracedThing {
                name: name.text.to_string(),
                kind: if *ty == TypeWord::Object { "object" } else { "region" }.into(),
                requirements: numbers,
                statements: Vec::new(),
                satisfied: None,
            });
            return;
        }
        let Some(statement) = self.stated(stmt, span) else { return };
        for number in &numbers {
            self.requirements[*number].statements.push(statement.clone());
        }
        if numbers.is_empty() && statement.kind != StatementKind::Property && statement.kind != StatementKind::Pin {
            self.untraced.push(statement.clone());
        }
        self.all.push(statement);
    }

    /// What a statement asks for; `None`: nothing.
    fn stated(&self, stmt: &Stmt, span: Span) -> Option<Statement> {
        let program = self.program?;
        let at = (span.file.0, span.range.start);
        let (kind, mut objects) = match &stmt.kind {
            StmtKind::Assert { .. } | StmtKind::Prefer { .. } | StmtKind::Assign { .. } => {
                match (self.constraints.get(&at).map(|index| &program.constraints[*index]), &stmt.kind) {
                    (Some(constraint), _) => {
                        let kind = match constraint.kind {
                            ConstraintKind::Assert => StatementKind::Assert,
                            ConstraintKind::Prefer { .. } => StatementKind::Prefer,
                            ConstraintKind::Pin => StatementKind::Pin,
                        };
                        (kind, named(program, &self.arrays, constraint.formula.objects()))
                    }
                    (None, StmtKind::Assign { path, .. }) if !path.is_empty() => (StatementKind::Property, Vec::new()),
                    _ => return None,
                }
            }
            StmtKind::Allow { .. } => {
                let permission = &program.allow.stated[*self.permissions.get(&at)?];
                (StatementKind::Allow, named(program, &self.arrays, permission.arguments.concat()))
            }
            _ => return None,
        };
        // An assignment speaks of what it assigns to; also of a region, and of the whole array.
        if let StmtKind::Assign { name, index: None, path, .. } = &stmt.kind
            && !path.is_empty()
            && !objects.iter().any(|object| *object == name.text)
        {
            objects.insert(0, name.text.to_string());
        }
        let id = statement_id(self.name, self.sources, span);
        let row = self.rows.get(id.as_str()).zip(self.judged).map(|(index, report)| &report.constraints[*index]);
        Some(Statement {
            kind,
            text: self.sources.text(span).split_whitespace().collect::<Vec<_>>().join(" "),
            objects,
            satisfied: row.and_then(|row| row.satisfied),
            margin: row.and_then(|row| row.margin),
            unit: row.and_then(|row| row.unit.clone()),
            id,
        })
    }

    /// The number of a requirement.
    fn number(&mut self, sentence: &str) -> usize {
        let text = sentence.split_whitespace().collect::<Vec<_>>().join(" ");
        *self.numbers.entry(text).or_insert_with_key(|text| {
            let (inferred, text) = match text.strip_prefix(INFERRED) {
                Some(reason) => (true, reason),
                None => (false, text.as_str()),
            };
            self.requirements.push(Requirement {
                text: text.to_owned(),
                inferred,
                verdict: Verdict::None,
                declares: Vec::new(),
                statements: Vec::new(),
            });
            self.requirements.len() - 1
        })
    }

    fn finish(mut self, name: &str, layout: Option<String>) -> Trace {
        let mut summary = Summary { requirements: self.requirements.len(), ..Summary::default() };
        for requirement in &mut self.requirements {
            requirement.verdict = verdict(requirement, layout.is_some());
            summary.inferred += usize::from(requirement.inferred);
            *match requirement.verdict {
                Verdict::Holds => &mut summary.holds,
                Verdict::Fails => &mut summary.fails,
                Verdict::Unmet => &mut summary.unmet,
                Verdict::Unknown => &mut summary.unknown,
                Verdict::NotJudged => &mut summary.not_judged,
                Verdict::Declared => &mut summary.declared,
                Verdict::None => &mut summary.none,
            } += 1;
        }
        let (mut spoken, mut answered) = (FxHashMap::default(), FxHashMap::default());
        for statement in &self.all {
            for name in spoken_of(statement) {
                spoken.entry(name).or_insert_with(Vec::new).push(statement);
            }
        }
        for (number, requirement) in self.requirements.iter().enumerate() {
            for name in requirement.statements.iter().flat_map(spoken_of) {
                answered.entry(name).or_insert_with(Vec::new).push(number);
            }
        }
        for thing in &mut self.things {
            let own = spoken.get(thing.name.as_str()).map_or(&[][..], Vec::as_slice);
            let judged: Vec<Option<bool>> = own.iter().filter(|s| s.kind.is_hard()).map(|s| s.satisfied).collect();
            thing.satisfied = match judged.as_slice() {
                [] => None,
                all if all.contains(&Some(false)) => Some(false),
                all if all.contains(&None) => None,
                _ => Some(true),
            };
            thing.statements = own.iter().map(|s| s.id.clone()).collect();
            let mut numbers: BTreeSet<usize> = thing.requirements.iter().copied().collect();
            numbers.extend(answered.get(thing.name.as_str()).into_iter().flatten());
            thing.requirements = numbers.into_iter().collect();
        }
        Trace {
            format: FORMAT.into(),
            file: name.to_owned(),
            layout,
            summary,
            requirements: self.requirements,
            objects: self.things,
            untraced: self.untraced,
            judged_with: self.judged.and_then(|report| report.judged_with.clone()),
        }
    }
}

impl StatementKind {
    /// Whether a layout is judged by it, and must satisfy it.
    fn is_hard(self) -> bool {
        matches!(self, Self::Assert | Self::Pin)
    }
}

fn verdict(requirement: &Requirement, judged: bool) -> Verdict {
    let has = |wanted: Option<bool>, hard: bool| {
        let of_kind = |kind: StatementKind| if hard { kind.is_hard() } else { kind == StatementKind::Prefer };
        requirement.statements.iter().any(|s| of_kind(s.kind) && s.satisfied == wanted)
    };
    let any = requirement.statements.iter().any(|s| s.kind.is_hard() || s.kind == StatementKind::Prefer);
    match () {
        () if requirement.statements.is_empty() && requirement.declares.is_empty() => Verdict::None,
        () if !any => Verdict::Declared,
        () if !judged => Verdict::NotJudged,
        () if has(Some(false), true) => Verdict::Fails,
        () if has(None, true) || has(None, false) => Verdict::Unknown,
        () if has(Some(false), false) => Verdict::Unmet,
        () => Verdict::Holds,
    }
}

/// The objects and regions that a statement speaks of, as they are declared, each once.
fn spoken_of(statement: &Statement) -> BTreeSet<&str> {
    statement.objects.iter().map(|name| name.split_once('[').map_or(name.as_str(), |(array, _)| array)).collect()
}

/// How many elements the arrays of a program have.
fn elements(program: &Program) -> FxHashMap<&str, usize> {
    let mut arrays = FxHashMap::default();
    for (name, _) in program.objects.iter().filter_map(|object| object.array.as_ref()) {
        *arrays.entry(name.as_str()).or_insert(0) += 1;
    }
    arrays
}

/// Objects by name, sorted as declared, each once; all elements of an array by its name. `arrays`: how many these are.
fn named(program: &Program, arrays: &FxHashMap<&str, usize>, mut ids: Vec<ObjectId>) -> Vec<String> {
    ids.sort_unstable();
    ids.dedup();
    let array = |id: &ObjectId| program.objects[id.0 as usize].array.as_ref().map(|(name, _)| name.as_str());
    let mut spoken: FxHashMap<&str, usize> = FxHashMap::default();
    for name in ids.iter().filter_map(array) {
        *spoken.entry(name).or_insert(0) += 1;
    }
    let mut out: Vec<String> = Vec::new();
    for id in &ids {
        let object = &program.objects[id.0 as usize];
        let whole = array(id).filter(|name| arrays.get(name) == spoken.get(name));
        let name = whole.map_or_else(|| object.name.to_string(), ToString::to_string);
        if out.last() != Some(&name) {
            out.push(name);
        }
    }
    out
}
