//! Requests with their scores, as a report for machines and a table for spreadsheets.

use super::annotations::{AnnotatedRequest, Measure};
use super::fate::{Fate, LayoutProgram, sentence};
use super::plausible::Plausible;
use super::relations::Thresholds;
use super::scene::ScoredScene;
use super::score::{AnnotationVerdict, is_judged, judge};
use super::table::Table;
use crate::score::Share;
use scenelang_base::FileId;
use scenelang_lang::Program;
use scenelang_layout::Layout;
use serde_json::{Map, Value, json};
use std::fmt::Write;

/// The value of `format`.
const FORMAT: &str = "scenelang.sceneeval/1";
/// The columns of the table for spreadsheets, before and after those of the four measures.
const COLUMNS: [&str; 2] =
    ["id,difficulty,layout,objects", "supported,not_colliding,in_bounds,navigability,accessibility,unjudged"];

/// What there is to score for a request.
#[derive(Clone, Copy, Debug)]
pub struct Made<'a> {
    pub layout: &'a Layout,
    /// Its program, the main file of it and that file's text, where there is one.
    pub program: Option<(&'a Program, FileId, &'a str)>,
    /// Whether all that must hold does, where that was judged.
    pub holds: Option<bool>,
}

/// An annotation that does not hold.
#[derive(Clone, Debug, PartialEq)]
pub struct Miss {
    /// What it counts for.
    pub measure: Measure,
    /// The annotation as written.
    pub annotation: String,
    /// The sentence of the request that it most likely comes from.
    pub sentence: String,
    /// How many fulfil it.
    pub found: usize,
    /// How many were asked for.
    pub wanted: usize,
    /// Whether an object that it names is not there at all.
    pub absent: bool,
    /// Where it got lost; `None` where there is no program to tell by.
    pub fate: Option<Fate>,
    /// Statements of the program about it.
    pub statements: Vec<String>,
}

/// A request, scored.
#[derive(Clone, Debug, PartialEq)]
pub struct Case {
    pub id: String,
    /// As the benchmark has it.
    pub difficulty: String,
    /// Whether there is a layout, and whether all that must hold in it does; the second is `None` where that was not
    /// judged.
    pub layout: Option<Option<bool>>,
    /// Why there is no layout.
    pub trouble: Option<String>,
    /// How many annotations hold, by measure.
    pub shares: [Share; 4],
    /// The same by the thresholds of the benchmark alone.
    pub published: [Share; 4],
    /// Those that do not.
    pub misses: Vec<Miss>,
    /// Annotations that are not judged.
    pub unjudged: Vec<String>,
    /// What is plausible about the layout.
    pub plausible: Plausible,
}

impl Case {
    /// Scores what was made for a request.
    ///
    /// # Errors
    /// The layout has a room whose outline is no simple polygon.
    pub fn of(asked: &AnnotatedRequest, made: &Made<'_>, table: &Table) -> Result<Self, String> {
        let program = made.program.map(|(program, ..)| program);
        let scene = ScoredScene::new(made.layout, program, table)?;
        let source = made.program.map(|(program, main, text)| LayoutProgram::new(program, main, text));
        let (verdicts, unjudged) = judge(asked, &scene, table, &Thresholds::WIDE);
        let miss = |verdict: &AnnotationVerdict<'_>| {
            let told = source.as_ref().map(|source| source.fate(verdict, &scene, table));
            let (fate, statements) = told.map_or((None, Vec::new()), |(fate, all)| (Some(fate), all));
            Miss { fate, statements, ..missed(asked, verdict) }
        };
        Ok(Self {
            layout: Some(made.holds),
            trouble: None,
            shares: shares(&verdicts),
            published: shares(&judge(asked, &scene, table, &Thresholds::PUBLISHED).0),
            misses: verdicts.iter().filter(|verdict| !verdict.holds).map(miss).collect(),
            unjudged: unjudged.into_iter().map(|annotation| annotation.text.clone()).collect(),
            plausible: Plausible::of(&scene, table),
            ..Self::empty(asked)
        })
    }

    /// A request for which there is no layout: nothing of it holds.
    pub fn without(asked: &AnnotatedRequest, trouble: String, table: &Table) -> Self {
        let (judged, unjudged): (Vec<_>, Vec<_>) = asked.annotations.iter().partition(|a| is_judged(a, table));
        let verdict = |annotation| AnnotationVerdict { annotation, holds: false, found: 0, absent: true };
        let verdicts: Vec<AnnotationVerdict<'_>> = judged.into_iter().map(verdict).collect();
        Self {
            trouble: Some(trouble),
            shares: shares(&verdicts),
            published: shares(&verdicts),
            misses: verdicts.iter().map(|verdict| missed(asked, verdict)).collect(),
            unjudged: unjudged.into_iter().map(|annotation| annotation.text.clone()).collect(),
            ..Self::empty(asked)
        }
    }

    fn empty(asked: &AnnotatedRequest) -> Self {
        Self {
            id: asked.id.clone(),
            difficulty: asked.difficulty.clone(),
            layout: None,
            trouble: None,
            shares: Default::default(),
            published: Default::default(),
            misses: Vec::new(),
            unjudged: Vec::new(),
            plausible: Plausible::default(),
        }
    }

    /// Whether there is a layout, and nothing that must hold is known to fail in it.
    pub fn is_good(&self) -> bool {
        self.layout.is_some_and(|holds| holds != Some(false))
    }

    /// What became of its layout, in a word.
    pub fn state(&self) -> &'static str {
        match self.layout {
            None => "none",
            Some(None) => "unjudged",
            Some(Some(true)) => "holds",
            Some(Some(false)) => "violated",
        }
    }

    /// Of its objects: those that are held, those that are in no other, those that are in bounds.
    fn plausibilities(&self) -> [Share; 3] {
        let whole = self.plausible.objects;
        let but = |n: usize| Share { part: whole - n, whole };
        [but(self.plausible.unsupported.len()), but(self.plausible.colliding), but(self.plausible.outside.len())]
    }

    /// The mean over the objects that are stepped up to.
    fn accessibility(&self) -> Option<f64> {
        mean(self.plausible.accessibility.iter().map(|(_, share)| *share))
    }

    fn json(&self) -> Value {
        let miss = |miss: &Miss| {
            json!({
                "measure": miss.measure.name(),
                "annotation": miss.annotation,
                "sentence": miss.sentence,
                "found": miss.found,
                "wanted": miss.wanted,
                "absent": miss.absent,
                "fate": miss.fate.map(Fate::name),
                "statements": miss.statements,
            })
        };
        let plausible = &self.plausible;
        let access: Map<String, Value> =
            plausible.accessibility.iter().map(|(name, share)| (name.clone(), json!(rounded(*share)))).collect();
        json!({
            "id": self.id,
            "difficulty": self.difficulty,
            "layout": self.state(),
            "trouble": self.trouble,
            "scores": scores_json(&self.shares),
            "published": scores_json(&self.published),
            "misses": self.misses.iter().map(miss).collect::<Vec<_>>(),
            "unjudged": self.unjudged,
            "plausibility": {
                "objects": plausible.objects,
                "unsupported": plausible.unsupported,
                "collisions": plausible.collisions,
                "out_of_bounds": plausible.outside,
                "navigability": plausible.navigability.map(rounded),
                "accessibility": access,
            },
        })
    }
}

fn missed(asked: &AnnotatedRequest, verdict: &AnnotationVerdict<'_>) -> Miss {
    Miss {
        measure: verdict.annotation.measure(),
        annotation: verdict.annotation.text.clone(),
        sentence: sentence(&asked.description, verdict.annotation).to_owned(),
        found: verdict.found,
        wanted: verdict.annotation.number,
        absent: verdict.absent,
        fate: None,
        statements: Vec::new(),
    }
}

fn shares(verdicts: &[AnnotationVerdict<'_>]) -> [Share; 4] {
    Measure::ALL.map(|measure| {
        let own = verdicts.iter().filter(|verdict| verdict.annotation.measure() == measure);
        Share { part: own.clone().filter(|verdict| verdict.holds).count(), whole: own.count() }
    })
}

/// All requests, scored.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Scores {
    /// In the order of the file.
    pub cases: Vec<Case>,
    /// Annotations that cannot be read.
    pub unread: Vec<String>,
}

#[derive(Clone, Debug, PartialEq)]
pub struct SummaryRow {
    /// `all`, or a difficulty.
    pub name: String,
    /// How many requests there are, and how many have a layout in which nothing that must hold fails.
    pub good: Share,
    /// How many annotations hold, by measure.
    pub shares: [Share; 4],
    /// The same by the thresholds of the benchmark alone.
    pub published: [Share; 4],
    /// Requests of which every annotation holds.
    pub perfect: Share,
    /// Objects that are held, that are in no other, that are in bounds.
    pub plausible: [Share; 3],
    /// Requests with a layout in which no objects are inside each other.
    pub free: Share,
    /// The mean over requests.
    pub navigability: Option<f64>,
    /// The mean over requests of the mean over objects.
    pub accessibility: Option<f64>,
}

impl Scores {
    /// The summary: all requests, then by difficulty in the order in which the file has them.
    pub fn groups(&self) -> Vec<SummaryRow> {
        let mut names: Vec<&str> = Vec::new();
        for case in &self.cases {
            if !names.contains(&case.difficulty.as_str()) {
                names.push(&case.difficulty);
            }
        }
        let all = SummaryRow::of("all", &self.cases.iter().collect::<Vec<_>>());
        let of = |name: &str| {
            SummaryRow::of(name, &self.cases.iter().filter(|case| case.difficulty == name).collect::<Vec<_>>())
        };
        std::iter::once(all).chain(names.into_iter().map(of)).collect()
    }

    /// How many misses have each fate; the last are those of which it is not known.
    pub fn fates(&self) -> [(&'static str, usize); 4] {
        let misses = || self.cases.iter().flat_map(|case| &case.misses);
        let of = |fate: Option<Fate>| misses().filter(|miss| miss.fate == fate).count();
        let [unread, misread, unsatisfied] = Fate::ALL.map(|fate| (fate.name(), of(Some(fate))));
        [unread, misread, unsatisfied, ("not known", of(None))]
    }

    /// Everything.
    pub fn json(&self) -> Value {
        let groups: Map<String, Value> = self.groups().iter().map(|group| (group.name.clone(), group.json())).collect();
        let fates: Map<String, Value> =
            self.fates().into_iter().map(|(n, count)| (n.to_owned(), json!(count))).collect();
        json!({
            "format": FORMAT,
            "summary": groups,
            "misses": fates,
            "unread": self.unread,
            "requests": self.cases.iter().map(Case::json).collect::<Vec<_>>(),
        })
    }

    /// A row for each request, as comma-separated values. Of each measure it has how many hold, and how many there are.
    pub fn csv(&self) -> String {
        let [before, after] = COLUMNS;
        let measures = Measure::ALL.map(|measure| format!("{0},{0}_of", measure.name())).join(",");
        let mut out = format!("{before},{measures},{after}\n");
        for case in &self.cases {
            let shares = case.shares.map(|share| format!("{},{}", share.part, share.whole)).join(",");
            let [held, apart, within] = case.plausibilities().map(|share| share.part);
            let number = |value: Option<f64>| value.map_or_else(String::new, |v| format!("{v:.4}"));
            let difficulty = quoted(&case.difficulty);
            let _ = writeln!(
                out,
                "{},{difficulty},{},{},{shares},{held},{apart},{within},{},{},{}",
                case.id,
                case.state(),
                case.plausible.objects,
                number(case.plausible.navigability),
                number(case.accessibility()),
                case.unjudged.len(),
            );
        }
        out
    }
}

impl SummaryRow {
    fn of(name: &str, cases: &[&Case]) -> Self {
        let count = |of: &dyn Fn(&Case) -> bool| Share {
            part: cases.iter().filter(|case| of(case)).count(),
            whole: cases.len(),
        };
        let sum = |of: &dyn Fn(&Case) -> Share| {
            let add = |a: Share, b: Share| Share { part: a.part + b.part, whole: a.whole + b.whole };
            cases.iter().map(|case| of(case)).fold(Share::default(), add)
        };
        let laid = cases.iter().filter(|case| case.layout.is_some());
        Self {
            name: name.to_owned(),
            good: count(&Case::is_good),
            shares: std::array::from_fn(|n| sum(&|case| case.shares[n])),
            published: std::array::from_fn(|n| sum(&|case| case.published[n])),
            perfect: count(&|case| case.layout.is_some() && case.misses.is_empty()),
            plausible: std::array::from_fn(|n| sum(&|case| case.plausibilities()[n])),
            free: Share {
                part: laid.clone().filter(|case| case.plausible.collisions.is_empty()).count(),
                whole: laid.count(),
            },
            navigability: mean(cases.iter().filter_map(|case| case.plausible.navigability)),
            accessibility: mean(cases.iter().filter_map(|case| case.accessibility())),
        }
    }

    fn json(&self) -> Value {
        let pair = |share: Share| json!([share.part, share.whole]);
        json!({
            "good": pair(self.good),
            "scores": scores_json(&self.shares),
            "published": scores_json(&self.published),
            "perfect": pair(self.perfect),
            "supported": pair(self.plausible[0]),
            "not_colliding": pair(self.plausible[1]),
            "in_bounds": pair(self.plausible[2]),
            "free_of_collisions": pair(self.free),
            "navigability": self.navigability.map(rounded),
            "accessibility": self.accessibility.map(rounded),
        })
    }
}

/// How many hold of how many, by measure.
fn scores_json(shares: &[Share; 4]) -> Value {
    let one = |(measure, share): (Measure, &Share)| (measure.name().to_owned(), json!([share.part, share.whole]));
    Value::Object(Measure::ALL.into_iter().zip(shares).map(one).collect())
}

fn mean(values: impl Iterator<Item = f64>) -> Option<f64> {
    let (sum, n) = values.fold((0.0, 0_usize), |(sum, n), value| (sum + value, n + 1));
    (n > 0).then(|| sum / n as f64)
}

/// To four digits.
fn rounded(value: f64) -> f64 {
    (value * 1e4).round() / 1e4
}

/// A field of comma-separated values.
fn quoted(text: &str) -> String {
    let plain = !text.contains([',', '"', '\n', '\r']);
    if plain { text.to_owned() } else { format!("\"{}\"", text.replace('"', "\"\"")) }
}
