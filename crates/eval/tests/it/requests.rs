//! The requests of `tests/requests`: their ground truth speaks of what is there, in the words of the request.

use scenelang_eval::Expectation;
use scenelang_eval::requests::{EvalRequest, Reading, read_folder};
use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

/// Words that relations have beside the predicates of the library: built-in ones, and one that is not there.
const MORE: [&str; 4] = ["inside", "perpendicular", "reachable_from", "visible_from"];

fn cases(set: &str) -> Vec<(PathBuf, String, Expectation)> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/requests").join(set);
    let mut paths: Vec<_> = fs::read_dir(folder).unwrap().map(|e| e.unwrap().path()).collect();
    paths.retain(|p| p.extension().is_some_and(|e| e == "txt"));
    paths.sort();
    let read = |path: PathBuf| {
        let truth = fs::read_to_string(path.with_extension("expect.json")).unwrap();
        let text = fs::read_to_string(&path).unwrap();
        let expect = serde_json::from_str(&truth).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
        (path, text, expect)
    };
    paths.into_iter().map(read).collect()
}

#[test]
fn six_of_every_building_in_each_set() {
    for set in ["development", "aside"] {
        let cases = cases(set);
        for building in ["apartment", "mall", "office", "restaurant", "school"] {
            assert_eq!(cases.iter().filter(|(_, _, e)| e.building == building).count(), 6, "{building} in {set}");
        }
        let words: Vec<usize> = cases.iter().map(|(_, text, _)| text.split_whitespace().count()).collect();
        assert!(words.iter().any(|n| *n < 40) && words.iter().filter(|n| **n > 450).count() >= 2, "{words:?}");
    }
}

#[test]
fn ground_truth_is_well_formed() {
    let library = fs::read_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join("../lang/std")).unwrap();
    let library: String =
        library.map(|e| fs::read_to_string(e.unwrap().path()).unwrap()).collect::<Vec<_>>().join("\n");
    let mut wrong = Vec::new();
    for (path, text, e) in ["development", "aside", "last", "fresh"].into_iter().flat_map(cases) {
        let mut must = |is: bool, what: String| {
            if !is {
                wrong.push(format!("{}: {what}", path.display()));
            }
        };
        let rooms: BTreeSet<&str> = e.rooms.iter().map(|r| r.name.as_str()).collect();
        let names: BTreeSet<&str> = e.objects.iter().map(|o| o.name.as_str()).chain(rooms.iter().copied()).collect();
        must(names.len() == e.objects.len() + e.rooms.len(), "a name is used twice".to_owned());
        for connection in &e.connections {
            let known = |n: &String| n == "outside" || rooms.contains(n.as_str());
            must(connection.between.len() == 2 && connection.between.iter().all(known), connection.kind.clone());
        }
        for object in &e.objects {
            must(rooms.contains(object.room.as_str()), format!("the room of {}", object.name));
            let said = [&object.colour, &object.material].into_iter().flatten().flat_map(|t| t.split(' '));
            let lower = text.to_lowercase();
            said.for_each(|w| must(lower.contains(&w.to_lowercase()), format!("{w} of {}", object.name)));
        }
        for relation in &e.relations {
            let both = relation.subject.all().iter().chain(relation.object.all());
            both.for_each(|n| must(names.contains(n.as_str()), format!("{n} in {}", relation.relation)));
            let word = relation.relation.trim_start_matches("not_");
            let known = MORE.contains(&word) || library.contains(&format!("predicate {word}("));
            must(known, format!("no predicate {word}"));
        }
        for number in &e.numeric {
            must(text.contains(&number.quote), format!("not in the text: {}", number.quote));
            must(number.between.iter().all(|n| names.contains(n.as_str())), format!("things of {}", number.quote));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn the_reader_reads_the_development_set_well_enough() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/requests/development");
    let reader = |request: EvalRequest<'_>| {
        // What is added to a room is in no request.
        let options = scenelang_formalize::Options { literal: true };
        let made = scenelang_formalize::formalize(request.text, &options, None).map_err(|e| e.to_string())?;
        Ok(Reading { program: made.program, ..Reading::default() })
    };
    let all = read_folder(&folder, &reader, |_, _| ()).unwrap();
    assert_eq!(all.cases.len(), 30);
    let bad: Vec<_> = all.cases.iter().filter(|c| c.contradictions != Some(0)).map(|c| &c.name).collect();
    assert!(bad.is_empty(), "these do not compile, or contradict themselves: {bad:?}");
    let means = all.means();
    for (name, least) in [("precision", 0.90), ("recall", 0.90), ("mentioned", 0.75)] {
        let mean = means.iter().find(|m| m.0 == name).and_then(|m| m.1);
        assert!(mean.is_some_and(|m| m >= least), "{name}: {mean:?}, at least {least} is asked for");
    }
}

/// Longer requests take longer than a test should.
const MOST_WORDS: usize = 200;

/// The requests for one kind of building, so that they are tried side by side.
fn have_layouts(building: &str) {
    let mut without = Vec::new();
    for (path, text, expect) in cases("development") {
        if expect.building == building && text.split_whitespace().count() <= MOST_WORDS {
            let mut draft = scenelang_formalize::read(&text, &scenelang_formalize::Options::default()).draft;
            let tried = scenelang_synth::rehearse(&mut draft, &scenelang_solve::Stop::default(), &mut |_| ());
            if tried != scenelang_synth::Tried::Holds {
                without.push(path);
            }
        }
    }
    assert!(without.is_empty(), "no layout was found for {without:?}");
}

mod programs_of_the_development_set_have_layouts {
    use super::have_layouts;

    #[test]
    fn apartments() {
        have_layouts("apartment");
    }

    #[test]
    fn malls() {
        have_layouts("mall");
    }

    #[test]
    fn offices() {
        have_layouts("office");
    }

    #[test]
    fn restaurants() {
        have_layouts("restaurant");
    }

    #[test]
    fn schools() {
        have_layouts("school");
    }
}
