//! One request, several programs, the scores that they have by the definitions.

use scenelang_eval::{Expectation, Score, Share, score};

/// "The study is 4 by 3 m. A dark blue oak desk faces the window, 80 cm from it, two lamps on the desk; chairs around it
/// not closer than 50 cm to the wall; a bin, not beside the desk. No plant."
const TRUTH: &str = r#"{
  "id": "study", "building": "apartment",
  "rooms": [{ "name": "study", "kind": "study", "size": [4, 2.6, 3] }],
  "connections": [{ "kind": "window", "between": ["study", "outside"] }],
  "objects": [
    { "name": "desk", "count": 1, "room": "study", "colour": "dark blue", "material": "oak" },
    { "name": "lamp", "count": 2, "room": "study" },
    { "name": "chair", "count": null, "room": "study" },
    { "name": "window", "count": 1, "room": "study" },
    { "name": "bin", "count": 1, "room": "study" },
    { "name": "plant", "count": 0, "room": "study" }
  ],
  "relations": [
    { "subject": "desk", "relation": "facing", "object": "window" },
    { "subject": "lamp", "relation": "on", "object": "desk" },
    { "subject": "chair", "relation": "around", "object": "desk" },
    { "subject": "bin", "relation": "not_beside", "object": "desk" }
  ],
  "numeric": [
    { "quote": "4 by 3 m", "between": ["study"], "value": 4, "unit": "m" },
    { "quote": "80 cm from it", "between": ["desk", "window"], "value": 0.8, "unit": "m" },
    { "quote": "50 cm to the wall", "between": ["chair", "study"], "value": 50, "unit": "cm" }
  ]
}"#;

fn scored(program: &str) -> Score {
    let expect: Expectation = serde_json::from_str(TRUTH).unwrap();
    score(&expect, program).0
}

/// Precision, recall, counts, texts, mentioned, named, numbers.
fn shares(score: &Score) -> [(usize, usize); 7] {
    score.shares().map(|(_, Share { part, whole })| (part, whole))
}

const ALL: &str = r#"
region study;
study.pos <- vec3(0, 0, 0);
study.scale <- vec3(4, 2.6, 3);
object desk;
desk.color <- "darkblue";
desk.material <- "oak";
object lamp[2];
object chair[3];
object window;
object bin;
assert connects(window, study);
assert facing(desk, window) and gap(desk, window) >= 0.8;
assert forall l in lamp: on(l, desk);
assert around(chair, desk, 0.3);
assert forall c in chair: gap(c, study) >= 50cm;
prefer not beside(bin, desk);
"#;

#[test]
fn all_of_it() {
    let score = scored(ALL);
    assert_eq!(shares(&score), [(5, 5), (5, 5), (5, 5), (2, 2), (4, 4), (4, 4), (3, 3)]);
    // Nothing is missed, and what is softer than it was said is listed.
    assert_eq!(score.misses, ["only a preference: bin not_beside desk"]);
}

#[test]
fn other_words_for_the_same() {
    // Names by category, one lamp to a name, colour and material in `features`, predicates by their meaning.
    let text = r#"
region room;
room.vertices <- polygon(vec3(-1, 0, 0), vec3(3, 0, 0), vec3(3, 0, 3), vec3(-1, 0, 3));
object table;
table.category <- "writing desk";
table.features <- "Oak top, dark blue legs";
object lamp1;
object lamp2;
object seats[2];
seats.category <- "chair";
object window;
object wasteBin;
predicate clings(Object a, Object b) := on(a, b);
assert connects(window, room);
assert dot(table.front, window.center - table.center) > 0 and gap(table, window) >= 2ft;
assert clings(lamp1, table) and clings(lamp2, table);
assert forall s in seats: gap(s, table) <= 0.3;
assert gap(wasteBin, table) > 0.6;
"#;
    let score = scored(text);
    // 2 ft is not 0.8 m; no chair keeps from the wall; `on` is called by way of `clings`.
    assert_eq!(shares(&score), [(5, 5), (5, 5), (5, 5), (2, 2), (4, 4), (1, 4), (1, 3)], "{:?}", score.misses);
    let said: Vec<_> = score.misses.iter().filter(|m| m.starts_with("said otherwise")).collect();
    assert_eq!(said.len(), 3);
}

#[test]
fn too_much_and_too_little() {
    // A plant, a rug, one lamp of two, no bin, no window; the desk is blue.
    let text = r#"
region study;
object desk;
desk.color <- "blue";
object lamp;
object chair[4];
object plant;
object rug;
assert on(lamp, desk);
assert inside(chair[0], study);
"#;
    let score = scored(text);
    // Things: desk, lamp, chair of desk, lamp, chair, plant, rug. Right in number: desk; not lamp, window, bin, plant.
    assert_eq!(shares(&score), [(3, 5), (3, 5), (1, 5), (0, 2), (1, 4), (1, 4), (0, 3)]);
    let all = score.misses.join("\n");
    for line in ["no window", "no bin", "unasked: plant", "unasked: rug", "1 lamp, not 2", "forbidden: plant"] {
        assert!(all.contains(line), "{line} in\n{all}");
    }
    assert!(all.contains("desk is not dark blue") && all.contains("no statement: bin not_beside desk"), "{all}");
}

#[test]
fn the_contrary_is_not_what_was_asked() {
    let score = scored("object bin; object desk; assert beside(bin, desk); assert not around(desk, bin, 1);");
    // Bin and desk are mentioned together, but `beside` is not denied.
    assert_eq!((score.mentioned.part, score.named.part), (1, 0));
}

#[test]
fn constants_within_a_hundredth() {
    for (distance, found) in [("0.8", 1), ("0.807", 1), ("80cm", 1), ("31.5in", 1), ("0.81", 0), ("0.79", 0)] {
        let text = format!("object desk; object window; assert gap(desk, window) >= {distance};");
        assert_eq!(scored(&text).numbers.part, found, "{distance}");
    }
    // A constant of the library's is nobody's statement: `beside` measures half a metre.
    assert_eq!(scored("object chair; object bin; assert beside(chair, bin);").numbers.part, 0);
    // Nor is one about something else.
    assert_eq!(scored("object desk; object bin; assert bin.pos.x > 0.8;").numbers.part, 0);
}

#[test]
fn nothing() {
    for text in ["object desk; assert", "object desk; assert lamp.pos.x > 1;"] {
        let score = scored(text);
        assert_eq!(shares(&score), [(0, 0), (0, 5), (0, 5), (0, 2), (0, 4), (0, 4), (0, 3)], "{text}");
    }
}

#[test]
fn pairs_are_the_likeliest_ones() {
    // Two windows, one of them in the right room and of the right number; a desk lamp is a lamp rather than a desk.
    let truth = r#"{
      "id": "", "rooms": [{ "name": "hall" }, { "name": "kitchen" }],
      "objects": [
        { "name": "desk", "count": 1, "room": "hall" },
        { "name": "lamp", "count": 1, "room": "hall", "colour": "red" },
        { "name": "table", "count": 1, "room": "kitchen" },
        { "name": "side_table", "count": 2, "room": "hall" }
      ],
      "relations": [{ "subject": "table", "relation": "near", "object": "kitchen" }], "numeric": [] }"#;
    let expect: Expectation = serde_json::from_str(truth).unwrap();
    let text = "region hall; region kitchen; object deskLamp; deskLamp.color <- \"red\"; object desk;
        object table2; object table[2]; table[0].category <- \"side table\"; table[1].category <- \"side table\";
        assert inside(table2, kitchen) and inside(table[0], hall);";
    let (score, _) = score(&expect, text);
    assert_eq!(shares(&score), [(4, 4), (4, 4), (4, 4), (1, 1), (1, 1), (0, 1), (0, 0)], "{:?}", score.misses);
}

/// Statements that say to come from the request: what is wrong with each, if anything.
#[test]
fn what_is_wrong() {
    let program = |statement: &str| {
        let things = "region study; study.scale <- vec3(4, 2.6, 3); object desk; object lamp[2]; object chair[3];
            object window; object bin; object globe;";
        format!("{things}\n@req(\"some words\")\n{statement};")
    };
    for (statement, want) in [
        ("assert forall l in lamp: on(l, desk)", None),
        ("assert on(desk, lamp[0])", Some("the reverse was requested")),
        ("assert forall l in lamp: not on(l, desk)", Some("the contrary was requested")),
        ("assert beside(bin, desk)", Some("the contrary was requested")),
        ("assert not beside(bin, desk)", None),
        ("assert forall l in lamp: under(l, desk)", Some("the opposite was requested")),
        ("assert near(globe, desk, 1)", Some("of globe, which was not requested")),
        ("assert looksAt(window, desk)", None),
        ("assert near(bin, lamp[0], 1)", None),
    ] {
        let score = scored(&program(statement));
        let why = score.misses.iter().find(|miss| miss.starts_with("wrong: "));
        assert_eq!((score.wrong.part, score.wrong.whole), (usize::from(want.is_some()), 1), "{statement}: {why:?}");
        assert!(want.is_none_or(|want| why.is_some_and(|why| why.ends_with(want))), "{statement}: {why:?}");
    }
    let inferred = program("assert on(desk, lamp[0])").replace("some words", "inferred: it is usual");
    assert_eq!(scored(&inferred).wrong, Share { part: 0, whole: 0 });
}

#[test]
fn what_is_only_preferred() {
    let text = ALL.replace("assert around(", "prefer around(");
    let score = scored(&text);
    assert_eq!((score.weakened.part, score.weakened.whole), (2, 4), "{:?}", score.misses);
    assert_eq!(scored(ALL).weakened.part, 1, "the bin is only preferred there");
}

/// Two rooms and a hall; the door between the rooms is asked for, one to the hall is not.
#[test]
fn ways_between_rooms() {
    let truth = r#"{ "id": "flat", "rooms": [{ "name": "kitchen" }, { "name": "bedroom" }, { "name": "hall" }],
        "connections": [{ "kind": "door", "between": ["kitchen", "bedroom"] }],
        "objects": [{ "name": "bed", "count": 1, "room": "bedroom" }], "relations": [], "numeric": [] }"#;
    let expect: Expectation = serde_json::from_str(truth).unwrap();
    let program = |statement: &str| {
        let rooms = "region kitchen; region bedroom; region hall; object bed; object door;";
        score(&expect, &format!("{rooms}\n@req(\"some words\")\nassert {statement};")).0
    };
    for (statement, connections, wrong) in [
        ("connects(door, bedroom, kitchen)", 1, 0),
        ("connects(door, kitchen, hall)", 0, 1),
        ("inside(bed, bedroom)", 0, 0),
        ("inside(bed, kitchen)", 0, 1),
    ] {
        let score = program(statement);
        assert_eq!((score.connections.part, score.wrong.part), (connections, wrong), "{statement}: {:?}", score.misses);
    }
}
