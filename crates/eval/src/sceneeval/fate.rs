//! Where an annotation got lost that a layout does not fulfil: on the way from the request to the program, or from the
//! program to the layout.

use super::annotations::{Annotation, Says};
use super::names::words;
use super::places::{RoomRelation, is_opening, kind};
use super::scene::ScoredScene;
use super::score::{AnnotationVerdict, relation_of};
use super::table::Table;
use crate::told::{ProgramOutline, Statement};
use scenelang_base::FileId;
use scenelang_lang::Program;
use scenelang_lang::program::Constraint;
use std::collections::BTreeSet;

/// So many statements are named.
const NAMED: usize = 3;

/// Where it got lost.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fate {
    /// No statement of the program has it.
    Unread,
    /// A statement about it says something else.
    Misread,
    /// A statement says it, and it does not hold in the layout, or the benchmark measures it in another way.
    Unsatisfied,
}

impl Fate {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::Unread, Self::Misread, Self::Unsatisfied];

    /// In words.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Unread => "not read",
            Self::Misread => "read wrongly",
            Self::Unsatisfied => "not satisfied",
        }
    }
}

/// The program of a layout, as far as fates go.
pub struct LayoutProgram<'a> {
    program: &'a Program,
    main: FileId,
    told: ProgramOutline,
}

impl<'a> LayoutProgram<'a> {
    /// `text` is the main file of the program.
    pub fn new(program: &'a Program, main: FileId, text: &str) -> Self {
        Self { program, main, told: ProgramOutline::new(program, main, text) }
    }

    /// What became of an annotation that does not hold, and the statements that are about it.
    pub fn fate(&self, verdict: &AnnotationVerdict<'_>, scene: &ScoredScene, table: &Table) -> (Fate, Vec<String>) {
        let named = |name: &str| self.named(name, scene, table);
        let annotation = verdict.annotation;
        match &annotation.says {
            Says::Count(name) => self.counted(annotation, &named(name)),
            Says::Attribute(name, adjective) => {
                let said = scene.things.iter().any(|thing| thing.looks.carries(adjective));
                let objects = self.declared(&named(name));
                (if said && !objects.is_empty() { Fate::Misread } else { Fate::Unread }, objects)
            }
            Says::Between { relation, reference, targets } => {
                let geometry = relation_of(relation, table).map_or("", |relation| relation.name());
                let targets: BTreeSet<usize> = targets.iter().flat_map(|name| named(name)).collect();
                let references = named(reference);
                // Of things of one name, a statement about each of them with something else says nothing.
                let among = references.iter().all(|id| targets.contains(id));
                let about = |of: &BTreeSet<usize>| {
                    let related = |id: &usize| references.iter().any(|r| r != id && of.contains(r));
                    of.iter().any(|id| targets.contains(id) && related(id)) && (!among || of.is_subset(&targets))
                };
                self.stated(table.said(geometry), &about, None)
            }
            Says::Place { relation, name, element } => {
                let targets: BTreeSet<usize> = named(name).into_iter().collect();
                let said = table.said(RoomRelation::of(relation, element, table).name());
                if is_opening(element) {
                    let kind = kind(element);
                    let is = |id: &usize| self.program.objects[*id].category.split_whitespace().last() == Some(kind);
                    let about = |of: &BTreeSet<usize>| of.iter().any(|id| targets.contains(id)) && of.iter().any(is);
                    return self.stated(said, &about, None);
                }
                let about = |of: &BTreeSet<usize>| !of.is_empty() && of.is_subset(&targets);
                let others: Vec<&String> =
                    RoomRelation::ALL.iter().flat_map(|place| table.said(place.name())).collect();
                self.stated(said, &about, Some(&others))
            }
        }
    }

    /// The objects of the program that a name means.
    fn named(&self, name: &str, scene: &ScoredScene, table: &Table) -> Vec<usize> {
        let names: BTreeSet<&str> = scene.called(name, table).map(|thing| thing.looks.name.as_str()).collect();
        let objects = self.program.objects.iter().enumerate();
        objects.filter(|(_, object)| names.contains(object.name.as_str())).map(|(i, _)| i).collect()
    }

    fn counted(&self, annotation: &Annotation, objects: &[usize]) -> (Fate, Vec<String>) {
        let fate = match objects.len() {
            0 => Fate::Unread,
            n if annotation.how.holds(n, annotation.number) => Fate::Unsatisfied,
            _ => Fate::Misread,
        };
        (fate, self.declared(objects))
    }

    /// How some objects are declared, arrays once.
    fn declared(&self, objects: &[usize]) -> Vec<String> {
        let mut out: Vec<String> = Vec::new();
        for id in objects {
            let object = &self.program.objects[*id];
            let line = match &object.array {
                None => format!("object {}", object.name),
                Some((array, _)) => {
                    let own = |o: &&scenelang_lang::program::Object| o.array.as_ref().is_some_and(|(a, _)| a == array);
                    format!("object {array}[{}]", self.program.objects.iter().filter(own).count())
                }
            };
            if !out.contains(&line) && out.len() < NAMED {
                out.push(line);
            }
        }
        out
    }

    /// The fate of what one of some predicates would say. `about`: whether a statement with these objects is about it;
    /// `others`: only those that call one of these can have been meant to say it.
    fn stated(
        &self,
        said: &[String],
        about: &dyn Fn(&BTreeSet<usize>) -> bool,
        others: Option<&[&String]>,
    ) -> (Fate, Vec<String>) {
        let calls = |statement: &Statement, name: &String| statement.written.calls.contains(name);
        let (mut says, mut misses) = (Vec::new(), Vec::new());
        for (constraint, statement) in self.program.constraints.iter().zip(&self.told.statements) {
            let own = constraint.span.file == self.main && constraint.guideline.is_none() && statement.asks;
            let objects = || constraint.formula.objects().iter().map(|o| o.0 as usize).collect();
            if !own || !about(&objects()) {
                continue;
            }
            if said.iter().any(|name| calls(statement, name)) {
                says.push(text(constraint));
            } else if statement.stated && others.is_none_or(|others| others.iter().any(|name| calls(statement, name))) {
                misses.push(text(constraint));
            }
        }
        let (fate, mut statements) = match (says.is_empty(), misses.is_empty()) {
            (false, _) => (Fate::Unsatisfied, says),
            (true, false) => (Fate::Misread, misses),
            (true, true) => (Fate::Unread, Vec::new()),
        };
        statements.truncate(NAMED);
        (fate, statements)
    }
}

fn text(constraint: &Constraint) -> String {
    let keyword = match constraint.kind {
        scenelang_lang::program::ConstraintKind::Prefer { .. } => "prefer",
        _ => "assert",
    };
    format!("{keyword} {}", constraint.text)
}

/// The sentence of a request that an annotation most likely comes from: the first that has most of its words.
pub fn sentence<'a>(request: &'a str, annotation: &Annotation) -> &'a str {
    let wanted: BTreeSet<String> = annotation.words().into_iter().flat_map(words).collect();
    let mut best = ("", 0);
    let mut rest = request;
    while !rest.is_empty() {
        let ends = rest.char_indices().find(|(i, c)| {
            matches!(c, '.' | '!' | '?' | ';') && rest[i + c.len_utf8()..].starts_with(char::is_whitespace)
        });
        let (sentence, after) = rest.split_at(ends.map_or(rest.len(), |(i, c)| i + c.len_utf8()));
        let there: BTreeSet<String> = words(sentence).into_iter().collect();
        let common = wanted.intersection(&there).count();
        if common > best.1 || best.0.is_empty() {
            best = (sentence.trim(), common);
        }
        rest = after;
    }
    best.0
}

#[cfg(test)]
mod tests {
    use super::super::annotations::read;
    use super::super::relations::Thresholds;
    use super::super::score::judge;
    use super::*;
    use scenelang_lang::{Options, compile_text};
    use scenelang_layout::file;
    use std::path::Path;

    const PROGRAM: &str = r#"
region study;
@req("a desk") object desk;
@req("two lamps") object lamp[2];
@req("a lamp on the desk") assert forall l in lamp: beside(l, desk);
@req("the desk in the corner") assert inCorner(desk, study);
@req("the desk against the wall") assert centeredIn(desk, study);
"#;
    const LAYOUT: &str = r#"{ "format": "scenelang.layout/1", "objects": {
        "desk": { "pos": [0, 0, 0], "scale": [1, 0.7, 0.6] },
        "lamp[0]": { "pos": [1, 0, 0], "scale": [0.2, 0.4, 0.2] },
        "lamp[1]": { "pos": [-1, 0, 0], "scale": [0.2, 0.4, 0.2] } },
        "regions": { "study": { "pos": [0, 0, 0], "scale": [6, 2.6, 6] } } }"#;

    #[test]
    fn where_it_got_lost() {
        let compiled = compile_text("a.scene", Path::new("a.scene"), PROGRAM, Options::default());
        let program = compiled.program.unwrap_or_else(|| panic!("{:?}", compiled.diagnostics));
        let layout = file::read(LAYOUT, compiled.main).layout;
        let table = Table::new();
        let scene = ScoredScene::new(&layout, Some(&program), &table).unwrap();
        let source = LayoutProgram::new(&program, compiled.main, PROGRAM);
        let rows = "ID,Description,ObjCount,ObjAttr,OORel,OARel,Difficulty\n\
            1,x,\"eq,1,lamp;eq,1,sofa\",\"eq,1,desk,oak\",\"eq,1,on,0,desk,lamp;eq,1,facing,0,lamp,lamp\",\
            \"eq,1,corner,desk,room;eq,1,against,desk,wall;eq,1,near,desk,door\",easy\n";
        let asked = read(rows).unwrap().requests.remove(0);
        let (verdicts, unjudged) = judge(&asked, &scene, &table, &Thresholds::WIDE);
        assert!(unjudged.is_empty());
        let found: Vec<_> = verdicts
            .iter()
            .filter(|verdict| !verdict.holds)
            .map(|verdict| (verdict.annotation.text.as_str(), source.fate(verdict, &scene, &table).0))
            .collect();
        let want = [
            ("eq,1,lamp", Fate::Misread),
            ("eq,1,sofa", Fate::Unread),
            ("eq,1,desk,oak", Fate::Unread),
            ("eq,1,on,0,desk,lamp", Fate::Misread),
            ("eq,1,facing,0,lamp,lamp", Fate::Unread),
            ("eq,1,corner,desk,room", Fate::Unsatisfied),
            ("eq,1,against,desk,wall", Fate::Misread),
            ("eq,1,near,desk,door", Fate::Unread),
        ];
        assert_eq!(found, want);
    }

    #[test]
    fn the_sentence_of_an_annotation() {
        let rows = "ID,Description,ObjCount,ObjAttr,OORel,OARel,Difficulty\n1,x,\"eq,1,floor_lamp\",,,,easy\n";
        let asked = read(rows).unwrap().requests.remove(0);
        let of = |request| sentence(request, &asked.annotations[0]);
        assert_eq!(
            of("A study, 3.5 m wide. Two lamps stand on the floor! Nothing else."),
            "Two lamps stand on the floor!"
        );
        assert_eq!(of("A study."), "A study.");
        assert_eq!(of(""), "");
    }
}
