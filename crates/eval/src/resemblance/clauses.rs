//! What is compared: objects with names and descriptions, and constraints as sentences, of the ground truth and of a program.

use crate::dataset::DatasetScene;
use crate::told::ProgramOutline;
use scenelang_lang::program::{ConstraintKind, Object};
use scenelang_lang::{Options, compile_text, library};
use serde::{Deserialize, Serialize};
use std::path::Path;

/// An object.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Described {
    /// What it is called.
    pub name: String,
    /// What it is, with how it looks.
    pub description: String,
}

/// A constraint of the ground truth.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Clause {
    /// In words.
    pub sentence: String,
    /// The names of its objects.
    pub names: Vec<String>,
}

/// What a program says, for the comparison.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Sayings {
    /// Its objects, each instance for itself; doors and windows are connections and not among them.
    pub objects: Vec<Described>,
    /// Its constraints in words.
    pub sentences: Vec<String>,
}

/// The ground truth of a scene: each object for itself, each relation in the words of the request.
pub fn of_scene(scene: &DatasetScene) -> (Vec<Described>, Vec<Clause>) {
    let noun = |name: &str| scene.objects.iter().find(|object| object.name == name).map(|object| object.noun.clone());
    let objects = scene.objects.iter().flat_map(|object| {
        let one = Described { name: object.noun.clone(), description: object.description.clone() };
        std::iter::repeat_n(one, object.count as usize)
    });
    let clauses = scene.relations.iter().map(|relation| Clause {
        sentence: relation.sentence.clone(),
        names: [&relation.subject, &relation.object].into_iter().filter_map(|name| noun(name)).collect(),
    });
    (objects.collect(), clauses.collect())
}

/// What a program says; nothing, where it does not compile. Of its statements those count that a request states.
pub fn of_program(text: &str) -> Sayings {
    let compiled = compile_text("a.scene", Path::new("a.scene"), text, Options::default());
    let good = !compiled.has_errors();
    let Some(program) = compiled.program.as_ref().filter(|_| good) else { return Sayings::default() };
    let is_link = |object: &Object| matches!(called(object).as_str(), "door" | "window");
    let objects = program.objects.iter().filter(|object| !is_link(object)).map(|object| {
        let name = called(object);
        let words = [object.color.as_str(), &object.material, &name, &object.features];
        let description: Vec<&str> = words.into_iter().filter(|word| !word.is_empty()).collect();
        Described { description: description.join(" "), name }
    });
    let noun = |name: &str| {
        let own = |o: &&Object| o.array.as_ref().map_or(&*o.name, |(array, _)| array) == name;
        program.objects.iter().find(own).map_or_else(|| library::words(name).join(" "), called)
    };
    let told = ProgramOutline::new(program, compiled.main, text);
    let asked = told.statements.iter().zip(&program.constraints);
    let asked = asked.filter(|(s, c)| s.stated && c.kind == ConstraintKind::Assert);
    let mut sentences: Vec<String> = asked
        .flat_map(|(statement, _)| &statement.written.arguments)
        .map(|(predicate, denied, of)| sentence(predicate, *denied, &of.iter().map(|n| noun(n)).collect::<Vec<_>>()))
        .collect();
    // What is said of each of an array, element by element, is one sentence.
    let mut seen = std::collections::BTreeSet::new();
    sentences.retain(|sentence| seen.insert(sentence.clone()));
    Sayings { objects: objects.collect(), sentences }
}

/// What an object is called: its category, else its name.
fn called(object: &Object) -> String {
    if !object.category.is_empty() {
        return object.category.clone();
    }
    let name = object.array.as_ref().map_or(object.name.as_str(), |(array, _)| array.as_str());
    library::words(name).join(" ")
}

/// A call of a predicate in words.
fn sentence(predicate: &str, denied: bool, of: &[String]) -> String {
    let [a, b] = [0, 1].map(|i| of.get(i).map_or("", String::as_str));
    let is = match predicate {
        "againstWall" | "backToWall" => "stands against a wall of",
        "inCorner" => "stands in a corner of",
        "centeredIn" => "stands in the middle of",
        "wallMounted" => "hangs on a wall of",
        "ceilingMounted" => "hangs from the ceiling of",
        "on" | "restsOn" => "stands on",
        "around" => "stand around",
        "beside" => "stands beside",
        "near" => "stands near",
        "far" => "is apart from",
        "inFrontOf" => "stands in front of",
        "behind" => "stands behind",
        "leftOf" | "seenLeftOf" => "is to the left of",
        "rightOf" | "seenRightOf" => "is to the right of",
        "above" => "hangs above",
        "below" | "under" => "is under",
        "facing" | "looksAt" => "faces",
        "inRow" => "stand in a row",
        "clear" => "has free space in front of it",
        "connects" => "leads into",
        "inside" => "is in",
        other => return [a, &library::words(other).join(" "), b].join(" ").trim().to_owned(),
    };
    let is = if denied { format!("not: {is}") } else { is.to_owned() };
    let article = |noun: &str| if noun.is_empty() { String::new() } else { format!("the {noun}") };
    [article(a), is, article(b)].join(" ").trim().to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_program_in_words() {
        let made = of_program(
            "region study; study.pos <- vec3(0, 0, 0); study.scale <- vec3(4, 2.6, 3);
             object desk; desk.color <- \"navy\"; desk.material <- \"oak\";
             object lamp[2]; lamp.category <- \"desk lamp\"; object door;
             @req(\"the lamps are on the desk\") assert forall l in lamp: on(l, desk);
             @req(\"at the wall\") assert againstWall(desk, study) and not inCorner(desk, study);
             @req(\"inferred: a door\") assert connects(door, study);
             assert gap(lamp[0], lamp[1]) > 0.1;",
        );
        let objects: Vec<(&str, &str)> =
            made.objects.iter().map(|o| (o.name.as_str(), o.description.as_str())).collect();
        assert_eq!(objects, [("desk", "navy oak desk"), ("desk lamp", "desk lamp"), ("desk lamp", "desk lamp")]);
        let wanted = [
            "the desk lamp stands on the desk",
            "the desk stands against a wall of the study",
            "the desk not: stands in a corner of the study",
        ];
        assert_eq!(made.sentences, wanted);
        assert_eq!(of_program("object"), Sayings::default());
    }
}
