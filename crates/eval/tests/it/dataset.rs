//! The dataset: its shape, its words, its ground truth.

use scenelang_eval::dataset::{DatasetScene, SCHEMA, Statistics, parse, scene, skeleton, solved};
use scenelang_solve::Stop;
use std::collections::{BTreeMap, BTreeSet};

const SEED: u64 = 7;

fn scenes() -> Vec<DatasetScene> {
    (0..50).map(|number| scene(SEED, number)).collect()
}

#[test]
fn it_is_about_as_large_as_the_published_one() {
    let scenes = scenes();
    let statistics = Statistics::of(&scenes);
    let [number, rooms, objects, relations, words, sentence, kinds] = statistics.counts;
    assert_eq!([number, rooms], [50.0, 75.0]);
    // Within a tenth of the published numbers.
    let pairs = [(objects, 2032.0), (relations, 1837.0), (words, 508.4), (sentence, 28.5), (kinds, 36.8)];
    let off = pairs.iter().filter(|(own, published)| (own / published - 1.0f64).abs() > 0.1);
    assert_eq!(off.count(), 0, "ours and the published ones: {pairs:?}");
    for building in ["apartment", "mall", "office", "restaurant", "school"] {
        for rooms in [1, 2] {
            assert_eq!(statistics.shares.get(&format!("{building}, {rooms} room(s)")), Some(&5));
        }
    }
}

/// What is left of two requests without what is filled in is never the same, whatever the seed.
#[test]
fn no_two_requests_share_a_skeleton() {
    let mut seen: BTreeMap<String, (u64, u64)> = BTreeMap::new();
    for (seed, number) in [SEED, 8].into_iter().flat_map(|seed| (0..500).map(move |n| (seed, n))) {
        let bare = skeleton(seed, number);
        // How many things there are in a list is no difference.
        let bare = bare.replace("_, _", "_").replace("_ and _", "_");
        if let Some(other) = seen.insert(bare, (seed, number)) {
            panic!("{:?} and {other:?} share a skeleton", (seed, number));
        }
    }
}

#[test]
fn a_skeleton_is_the_request_without_what_is_filled_in() {
    for number in 0..20 {
        let (request, skeleton) = (scene(SEED, number).request, skeleton(SEED, number));
        assert!(skeleton.matches('_').count() > 15, "{skeleton}");
        assert!(!request.contains(['_', '{', '}', '|']), "{request}");
        let mut rest = request.as_str();
        assert_eq!(request.matches("\n\n").count(), skeleton.matches("\n\n").count());
        for paragraph in skeleton.split("\n\n") {
            let first = paragraph.split('_').next().unwrap_or("").trim();
            let at = rest.find(first).unwrap_or_else(|| panic!("{first:?} is not in {rest}"));
            rest = &rest[at..];
        }
    }
}

#[test]
fn each_line_is_as_the_schema_says_and_is_read_again() {
    let schema: serde_json::Value = serde_json::from_str(SCHEMA).unwrap();
    let schema = jsonschema::draft202012::options().build(&schema).unwrap();
    for scene in scenes() {
        let line = scene.line().unwrap();
        let value = serde_json::from_str(&line).unwrap();
        if let Some(error) = schema.iter_errors(&value).next() {
            panic!("{}: {error}", scene.id);
        }
        let again = parse(&line).unwrap();
        assert_eq!(again.line().unwrap(), line);
        let other = line.replacen("scenelang.dataset/1", "scenelang.dataset/2", 1);
        assert!(parse(&other).unwrap_err().contains("its format is"));
    }
}

/// What a request says is what the ground truth has: each thing, each sentence, each room.
#[test]
fn requests_say_what_is_true() {
    for scene in scenes() {
        let lower = scene.request.to_lowercase();
        for room in &scene.rooms {
            assert!(lower.contains(&room.kind) && (5..=15).contains(&room.attributes.len()), "{}", room.kind);
            let said = room.attributes.values().filter(|value| scene.request.contains(value.as_str())).count();
            assert_eq!(said, room.attributes.len(), "{}", scene.id);
        }
        for object in &scene.objects {
            // "shelf", "shelves": the beginning of the noun.
            let stem = &object.noun[..object.noun.len() - 1];
            assert!(lower.contains(stem), "{}: {}", scene.id, object.noun);
            object.look.iter().for_each(|word| assert!(lower.contains(word.as_str()), "{}: {word}", scene.id));
        }
        let names: BTreeSet<&str> = scene.objects.iter().map(|object| object.name.as_str()).collect();
        assert_eq!(names.len(), scene.objects.len(), "{}: a name is used twice", scene.id);
        for relation in &scene.relations {
            assert!(scene.request.contains(&relation.sentence), "{}: {}", scene.id, relation.sentence);
            assert!(names.contains(relation.subject.as_str()), "{}: {}", scene.id, relation.subject);
            for formula in &relation.formulas {
                assert!(scene.program.contains(&format!("assert {formula};")), "{}: {formula}", scene.id);
            }
        }
        assert!(scene.expected().is_ok_and(|e| e.objects.len() == scene.objects.len()), "{}", scene.id);
    }
}

#[test]
fn programs_compile_and_have_what_the_scene_has() {
    for number in 0..200 {
        let scene = scene(SEED + 1, number);
        let program = scenelang_eval::correctness::compiled(&scene.program);
        let program = program.unwrap_or_else(|why| panic!("{}: {why}\n{}", scene.id, scene.program));
        let things: usize = scene.things() + scene.connections.len();
        assert_eq!(program.objects.len(), things, "{}", scene.id);
    }
}

/// A scene depends on its number alone, and what it holds is what a check of its layout says.
#[test]
fn a_scene_is_laid_out() {
    let one = solved(SEED, 0, &Stop::default()).unwrap();
    assert!(one.holds(), "{:?}", one.held);
    let held = one.held.unwrap();
    assert_eq!(held.relations, [one.instances(); 2]);
    let text = one.layout.clone().unwrap().to_string();
    let layout = scenelang_layout::file::read(&text, scenelang_base::FileId(0)).layout;
    let program = scenelang_eval::correctness::compiled(&one.program).unwrap();
    let again = scenelang_eval::correctness::satisfied(&program, &layout);
    assert_eq!([again.all.part, again.all.whole], held.all);
    assert_eq!(solved(SEED, 0, &Stop::default()).unwrap().line().unwrap(), one.line().unwrap());
    // A layout in which something is amiss is not said to be good.
    let mut amiss = layout;
    amiss.objects.pop();
    let less = scenelang_eval::correctness::satisfied(&program, &amiss);
    assert!(less.all.part < less.all.whole && less.stated.whole == again.stated.whole, "{less:?}");
}
