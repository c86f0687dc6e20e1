//! What is known of the objects of a scene: where each is declared and what for, how it stands, what it rests on, what of it
//! opens, and every constraint that speaks of it with its verdict.

mod rests;

pub use rests::{On, RestsOn};

use crate::Checked;
use crate::check::Subject;
use crate::report::model::{JudgedWith, RowKind, SourceSpan};
use crate::report::{place, statement_id};
use crate::tolerances::Options;
use crate::world::World;
use scenelang_base::suggest::nearest;
use scenelang_base::{SourceMap, Span};
use scenelang_lang::ast::{StmtKind, TypeWord};
use scenelang_lang::parse::parse_file;
use scenelang_lang::program::{Constraint, ConstraintKind, ObjectId, Program};
use serde::Serialize;
use std::collections::BTreeMap;

/// What the answer calls itself.
const FORMAT: &str = "scenelang.query/1";

/// What is known of the objects of a scene.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Query {
    /// `scenelang.query/1`
    pub format: String,
    /// The scene, as it was named.
    pub file: String,
    /// Whether there is a layout by which it was judged.
    pub judged: bool,
    /// The objects asked for, else all; elements of an array one by one.
    pub objects: Vec<Object>,
    /// The settings file by which it was judged, where that makes a difference.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub judged_with: Option<JudgedWith>,
}

#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Object {
    /// As in the layout: `lamp`, `chair[0]`.
    pub name: String,
    /// What the program says it is, or empty.
    pub category: String,
    /// The statement that declares it.
    pub declared: Declared,
    /// `@req` sentences of the declaration.
    pub requirements: Vec<String>,
    /// How it stands; `None`: the layout has no place for it, or there is none.
    pub pose: Option<Pose>,
    /// How many of its constraints have which verdict.
    pub constraints: Counts,
    /// All the rest, of objects that were asked for by name.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub details: Option<Details>,
}

#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Declared {
    /// Where it is.
    pub span: SourceSpan,
    /// As written, on one line.
    pub text: String,
}

/// How an object stands.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Pose {
    /// Centre of its bottom face (metres).
    pub pos: [f64; 3],
    /// Its Euler triple (degrees).
    pub rot: [f64; 3],
    /// Its extents (metres).
    pub size: [f64; 3],
}

/// How many constraints that speak of an object have which verdict.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Counts {
    pub holds: usize,
    /// They must hold, and do not.
    pub fails: usize,
    /// Preferences that are not met.
    pub unmet: usize,
    /// They cannot be judged, or there is no layout.
    pub unjudged: usize,
}

/// What is known of an object beside how it stands.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Details {
    /// What it rests on; `None`: it has no place.
    pub rests_on: Option<RestsOn>,
    /// What of it opens, as it stands closed.
    pub joints: Vec<Opens>,
    /// Every constraint that speaks of it: stated ones, then physical rules. That it is inside of no other thing is not
    /// listed for each of them.
    pub constraints: Vec<QueryRow>,
}

/// A movable part.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Opens {
    /// What it is called.
    pub name: String,
    /// `hinge` or `slide`.
    pub motion: String,
    /// From where to where it moves (degrees or metres); 0 is closed.
    pub limits: [f64; 2],
    /// How far it has to open to be of use; `None`: nobody demands that it does.
    pub useful: Option<f64>,
}

/// A constraint with its verdict.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct QueryRow {
    /// As in reports: `room.scene:12:1`, `P-SUPPORT:lamp`.
    pub id: String,
    pub kind: RowKind,
    /// The statement as written, or the rule in words.
    pub text: String,
    /// The verdict; `None`: it cannot be judged, or there is no layout.
    pub satisfied: Option<bool>,
    /// By how much it holds (> 0) or fails (< 0).
    pub margin: Option<f64>,
    /// Unit of the margin, `m` or `deg`.
    pub unit: Option<String>,
    /// What was measured.
    pub message: String,
    /// `@req` sentences that the statement answers.
    pub requirements: Vec<String>,
}

/// Answers what is known of the objects that a name stands for, an object (`chair[2]`) or an array (`chair`); without a name,
/// how all objects stand. `None`: the program does not compile, and nothing is known.
///
/// # Errors
/// There is no such object; a sentence, with a name that may be meant.
pub fn query(checked: &Checked, name: Option<&str>) -> Result<Option<Query>, String> {
    let Some(program) = &checked.program else { return Ok(None) };
    let asked = match name {
        Some(name) => named(program, name)?,
        None => (0..program.objects.len() as u32).map(ObjectId).collect(),
    };
    let mut of_object = vec![Vec::new(); program.objects.len()];
    let rows = rows(checked, program);
    for (index, (objects, _)) in rows.iter().enumerate() {
        objects.iter().for_each(|id| of_object[id.0 as usize].push(index));
    }
    let declarations = declarations(program, &checked.sources);
    let builder = Builder { checked, program, declarations, rows, of_object };
    // What has a say in how the rules are judged beside these changes nothing in what carries what.
    let options = Options { tolerances: checked.report.tolerances, eta: checked.report.eta, ..Options::default() };
    let layout = checked.layout.as_ref();
    let world = layout.filter(|_| name.is_some()).map(|layout| World::<f64>::new(program, layout, &options));
    Ok(Some(Query {
        format: FORMAT.to_owned(),
        file: checked.report.file.clone(),
        judged: layout.is_some(),
        objects: asked.into_iter().map(|id| builder.object(id, name.is_some(), world.as_ref())).collect(),
        judged_with: checked.report.judged_with.clone(),
    }))
}

/// The objects that a name stands for.
fn named(program: &Program, name: &str) -> Result<Vec<ObjectId>, String> {
    let objects = (0..).map(ObjectId).zip(&program.objects);
    let found: Vec<ObjectId> = objects.filter(|(_, object)| object.is_meant_by(name)).map(|(id, _)| id).collect();
    if !found.is_empty() {
        return Ok(found);
    }
    if program.regions.iter().any(|region| region.name == name) {
        return Err(format!("`{name}` is a region; only objects can be queried"));
    }
    let arrays = program.objects.iter().filter_map(|object| object.array.as_ref().map(|(array, _)| array.as_str()));
    let known: Vec<&str> = program.objects.iter().map(|object| object.name.as_str()).chain(arrays).collect();
    let near = nearest(name, known).map_or_else(String::new, |near| format!("; did you mean `{near}`?"));
    Err(format!("the program has no object `{name}`{near}"))
}

/// The statement of each declaration, by where the declared name stands.
fn declarations(program: &Program, sources: &SourceMap) -> BTreeMap<Span, Span> {
    let mut files: Vec<_> = program.objects.iter().map(|object| object.span.file).collect();
    files.sort_unstable();
    files.dedup();
    let mut out = BTreeMap::new();
    for file in files {
        for (offset, stmt) in &parse_file(sources.get(file).text()).statements {
            if let StmtKind::Declare { ty: TypeWord::Object, name, .. } = &stmt.kind {
                let at = |range: scenelang_base::TextRange| range.shifted(*offset).in_file(file);
                out.insert(at(name.range), at(stmt.range));
            }
        }
    }
    out
}

/// All rows, each with the objects that it speaks of. Pairs that are not inside of each other are left out.
fn rows(checked: &Checked, program: &Program) -> Vec<(Vec<ObjectId>, QueryRow)> {
    if checked.layout.is_none() {
        let name = checked.report.file.as_str();
        return program.constraints.iter().map(|c| (c.formula.objects(), stated(c, name, &checked.sources))).collect();
    }
    let judged = checked.verdict.rows.iter().zip(&checked.report.constraints);
    let told = judged.filter(|(row, _)| row.kind != RowKind::Collision || row.satisfied != Some(true));
    told.map(|(judged, row)| {
        let objects = match judged.subject {
            Subject::Statement(index) => program.constraints[index].formula.objects(),
            Subject::Pair(a, b) => vec![a, b],
            Subject::Object(id) | Subject::Part(id, _) => vec![id],
        };
        let row = QueryRow {
            id: row.id.clone(),
            kind: row.kind,
            text: row.text.clone(),
            satisfied: row.satisfied,
            margin: row.margin,
            unit: row.unit.clone(),
            message: judged.measured.clone(),
            requirements: row.requirements.clone(),
        };
        (objects, row)
    })
    .collect()
}

/// A constraint that nobody has judged.
fn stated(constraint: &Constraint, name: &str, sources: &SourceMap) -> QueryRow {
    QueryRow {
        id: statement_id(name, sources, constraint.span),
        kind: match constraint.kind {
            ConstraintKind::Assert => RowKind::Assert,
            ConstraintKind::Prefer { .. } => RowKind::Prefer,
            ConstraintKind::Pin => RowKind::Pin,
        },
        text: constraint.text.clone(),
        satisfied: None,
        margin: None,
        unit: None,
        message: String::new(),
        requirements: constraint.requirements.clone(),
    }
}

struct Builder<'a> {
    checked: &'a Checked,
    program: &'a Program,
    declarations: BTreeMap<Span, Span>,
    rows: Vec<(Vec<ObjectId>, QueryRow)>,
    /// By object: which rows speak of it.
    of_object: Vec<Vec<usize>>,
}

impl Builder<'_> {
    fn object(&self, id: ObjectId, in_full: bool, world: Option<&World<f64>>) -> Object {
        let object = &self.program.objects[id.0 as usize];
        let sources = &self.checked.sources;
        let span = *self.declarations.get(&object.span).unwrap_or(&object.span);
        let placement = self.checked.layout.as_ref().and_then(|layout| layout.object(&object.name));
        let own: Vec<&QueryRow> = self.of_object[id.0 as usize].iter().map(|&index| &self.rows[index].1).collect();
        let details = || Details {
            rests_on: world.and_then(|world| rests::on(self.checked, self.program, world, id)),
            joints: placement.into_iter().flat_map(|p| &p.joints).map(opens).collect(),
            constraints: own.iter().map(|row| (*row).clone()).collect(),
        };
        Object {
            name: object.name.to_string(),
            category: object.category.clone(),
            declared: Declared { span: place(sources, span), text: on_a_line(sources.text(span)) },
            requirements: object.requirements.iter().map(|text| on_a_line(text)).collect(),
            pose: placement.map(|p| Pose { pos: p.pos.into(), rot: p.rot.into(), size: p.scale.into() }),
            constraints: counts(&own),
            details: in_full.then(details),
        }
    }
}

fn opens(joint: &scenelang_layout::Joint) -> Opens {
    Opens {
        name: joint.name.to_string(),
        motion: joint.motion.name().to_owned(),
        limits: joint.limits,
        useful: joint.useful,
    }
}

fn counts(rows: &[&QueryRow]) -> Counts {
    let mut out = Counts::default();
    for row in rows {
        *match row.satisfied {
            Some(true) => &mut out.holds,
            Some(false) if row.kind == RowKind::Prefer => &mut out.unmet,
            Some(false) => &mut out.fails,
            None => &mut out.unjudged,
        } += 1;
    }
    out
}

fn on_a_line(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}
