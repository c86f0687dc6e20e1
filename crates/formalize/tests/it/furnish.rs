//! What is added to a request that says little: openings, light, what goes with a thing, the inventory of a kind of room. And
//! what is not: what is asked for with its number, what is ruled out, anything with `--literal`.

use scenelang_formalize::draft::{Draft, OpeningKind, ThingOrigin};
use scenelang_formalize::write::write;
use scenelang_formalize::{Options, read};
use scenelang_lang::{Options as Front, compile_text, nouns};
use std::path::{Path, PathBuf};

fn draft(request: &str) -> Draft {
    read(request, &Options::default()).draft
}

/// How many things of a draft have a category that ends in these words.
fn count(draft: &Draft, noun: &str) -> usize {
    let of = |category: &str| {
        let category = category.replace('_', " ");
        category == noun || category.ends_with(&format!(" {noun}"))
    };
    draft.things.iter().filter(|t| of(&t.category)).map(|t| t.count).sum()
}

fn requests() -> Vec<String> {
    let path: PathBuf = [env!("CARGO_MANIFEST_DIR"), "../../tests/requests/rooms.txt"].iter().collect();
    let text = std::fs::read_to_string(path).expect("the list of requests is there");
    text.lines().filter(|line| !line.is_empty() && !line.starts_with('#')).map(str::to_owned).collect()
}

#[test]
fn every_room_has_a_way_in_and_light_says_why_and_compiles() {
    let all = requests();
    assert!(all.len() >= 40);
    for request in &all {
        let draft = draft(request);
        assert!(draft.openings.iter().any(|o| o.kind == OpeningKind::Door), "{request}: no door");
        let light = |t: &scenelang_formalize::draft::DraftThing| {
            ["light", "lamp", "panel", "chandelier", "spotlight"].iter().any(|l| t.category.ends_with(l))
        };
        assert!(draft.things.iter().any(light), "{request}: no light");
        for thing in &draft.things {
            match &thing.source {
                ThingOrigin::Stated(at) => assert!(!at.is_empty(), "{request}: {}", thing.name),
                ThingOrigin::Inferred(why) => assert!(why.len() > 5, "{request}: {}", thing.name),
            }
        }
        assert!(draft.rooms.iter().all(|r| r.floor.material.is_some() || r.floor.color.is_some()), "{request}");
        let compiled = compile_text("room.scene", Path::new("room.scene"), &write(&draft), Front::default());
        assert!(!compiled.has_errors(), "{request}: {:?}", compiled.diagnostics);
    }
}

/// Rooms narrower than a way, and halls with very many things: a program all the same, and without much work.
#[test]
fn rooms_of_any_size_become_programs() {
    let sides = ["0.01", "0.1", "0.45", "0.8", "1", "4", "60"];
    let kinds = [
        "bedroom with two nightstands",
        "flat",
        "café with six tables",
        "hall with thirty desks, thirty chairs and thirty beds",
    ];
    for (kind, x, z) in
        kinds.iter().flat_map(|kind| sides.iter().map(move |x| (kind, *x, "0.1"))).chain([(&kinds[3], "60", "50")])
    {
        let request = format!("A {kind}. The room is {x} m wide and {z} m long.");
        let program = write(&draft(&request));
        let compiled = compile_text("room.scene", Path::new("room.scene"), &program, Front::default());
        assert!(!compiled.has_errors(), "{request}: {:?}", compiled.diagnostics);
    }
}

/// What rooms of a kind have in their walls, and beside it.
#[test]
fn rooms_have_the_doors_and_the_cloth_of_their_kind() {
    let categories =
        |draft: &Draft| -> Vec<String> { draft.openings.iter().filter_map(|o| o.category.clone()).collect() };
    for (request, door) in [
        ("A garage.", "garage door"),
        ("A warehouse with racks.", "garage door"),
        ("A hotel room with twin beds.", "bathroom"),
        ("A studio apartment.", "bathroom"),
    ] {
        let found = categories(&draft(request));
        assert!(found.iter().any(|category| category.contains(door)), "{request}: {found:?}");
    }
    for request in ["A living room.", "A classroom.", "A home office."] {
        assert!(categories(&draft(request)).is_empty(), "{request}");
    }
    for (request, curtains) in [("A bedroom.", true), ("A hotel room.", true), ("A laboratory.", false)] {
        assert_eq!(count(&draft(request), "curtain") > 0, curtains, "{request}");
    }
    let literal = read("A garage.", &Options { literal: true }).draft;
    assert!(categories(&literal).is_empty());
}

/// Numbers of one kind are bounded, and so is their sum: the program can be judged, and what was lowered is listed.
#[test]
fn a_crowd_is_bounded_and_said() {
    let kinds = ["chairs", "desks", "lamps", "crates", "plants"];
    let request =
        format!("A hall. {}", kinds.map(|kind| format!("There are 1e300 {kind} and 300 more {kind}.")).join(" "));
    for request in
        [request, "A hall with 399 crates.".into(), "A hall with 300 chairs and 300 crates and 300 desks.".into()]
    {
        let draft = draft(&request);
        let placed: usize = draft.things.iter().map(|thing| thing.count).sum();
        assert!(placed <= 900, "{placed}: {request}");
        assert!(draft.notes.iter().any(|note| note.reason.contains("guidelines")), "{request}: {:?}", draft.notes);
        let compiled = compile_text("room.scene", Path::new("room.scene"), &write(&draft), Front::default());
        assert!(!compiled.has_errors(), "{request}: {:?}", compiled.diagnostics);
    }
    assert!(
        draft("A hall with 300 chairs and 300 crates and 300 desks.").notes.iter().any(|n| n.reason.contains("800"))
    );
}

/// Request, noun, how many there are of it.
#[test]
fn what_is_asked_for_keeps_its_number() {
    for (request, noun, number) in [
        ("A bedroom with a bed and a lamp.", "lamp", 1),
        ("A bedroom with two nightstands.", "nightstand", 2),
        ("A living room with three armchairs and a table.", "table", 1),
        ("A kitchen with a table and two chairs.", "chair", 2),
        ("A classroom for twenty students without a blackboard.", "blackboard", 0),
        ("A living room with no rug.", "rug", 0),
        ("A bathroom with a shower and no bathtub.", "bathtub", 0),
        ("An office with a desk.", "desk", 1),
        ("A gym with six treadmills and a locker area.", "locker", 3),
        ("An office for six people with a plant in each corner.", "plant", 4),
    ] {
        assert_eq!(count(&draft(request), noun), number, "{request}");
    }
}

/// Request, what is added, how many at least.
#[test]
fn what_goes_with_a_thing_is_added() {
    for (request, noun, least) in [
        ("A bedroom with a double bed and a desk.", "nightstand", 2),
        ("A bedroom with a double bed and a desk.", "office chair", 1),
        ("A bedroom with a double bed and a desk.", "wardrobe", 1),
        ("A dining room.", "dining chair", 6),
        ("A dining room for eight people.", "chair", 8),
        ("A living room with a sofa.", "coffee table", 1),
        ("A home office.", "monitor", 1),
        ("A restaurant.", "restaurant chair", 16),
        ("A classroom for twenty students.", "student desk", 20),
    ] {
        let found = count(&draft(request), noun);
        assert!(found >= least, "{request}: {found} of {noun}");
    }
    let objects = |request: &str| draft(request).things.iter().map(|t| t.count).sum::<usize>();
    assert!(objects("A living room.") >= 30, "{}", objects("A living room."));
    assert!(objects("A small living room.") < objects("A large living room."));
    assert!(objects("An office for two people.") < objects("An open-plan office for twelve people."));
}

#[test]
fn there_is_a_place_for_each_of_so_many_people() {
    for (request, noun, n) in [
        ("An open-plan office for eight.", "desk", 8),
        ("A dining room with a round table for six.", "chair", 6),
        ("A meeting room for ten people.", "chair", 10),
        ("A classroom for sixteen students.", "chair", 16),
        ("An office for five developers.", "desk", 5),
        ("An office for a staff of four.", "desk", 4),
        // One bin is at one of the desks.
        ("An office for a team of five with a printer corner and a bin.", "desk", 5),
        // Plants in the corners keep them, and take no desks away.
        ("An office for six people with a plant in each corner.", "desk", 6),
    ] {
        assert!(count(&draft(request), noun).abs_diff(n) <= 1, "{request}: {}", count(&draft(request), noun));
    }
}

#[test]
fn literally_nothing_is_added() {
    for request in requests() {
        let draft = read(&request, &Options { literal: true }).draft;
        assert!(draft.things.iter().all(|t| matches!(t.source, ThingOrigin::Stated(_))), "{request}");
        // What the request itself speaks of stays, and so do the doors between its rooms.
        let said = request.contains("window") || draft.rooms.len() > 1;
        assert!(draft.openings.is_empty() || said, "{request}");
    }
}

#[test]
fn the_nouns_of_the_requests_are_known() {
    let mut names = Vec::new();
    for set in ["development", "aside"] {
        let folder: PathBuf = [env!("CARGO_MANIFEST_DIR"), "../../tests/requests", set].iter().collect();
        let mut files: Vec<PathBuf> = std::fs::read_dir(folder).unwrap().map(|e| e.unwrap().path()).collect();
        files.sort();
        for file in files.iter().filter(|f| f.extension().is_some_and(|e| e == "json")) {
            let truth: serde_json::Value = serde_json::from_str(&std::fs::read_to_string(file).unwrap()).unwrap();
            let objects = truth["objects"].as_array().unwrap();
            names.extend(objects.iter().filter_map(|o| o["name"].as_str()).map(str::to_owned));
        }
    }
    names.sort();
    names.dedup();
    let unknown: Vec<&String> = names.iter().filter(|name| nouns::ending(name).is_none()).collect();
    let share = 1.0 - unknown.len() as f64 / names.len() as f64;
    assert!(share >= 0.95, "{:.1} % of {}; unknown: {unknown:?}", 100.0 * share, names.len());
}

/// Request, noun, how many of it there are at least, how wide one is at most.
#[test]
fn plain_words_mean_what_they_do_in_their_room() {
    for (request, noun, n, width) in [
        ("A hotel room with twin beds.", "twin bed", 2, 1.1),
        ("A hospital ward with four beds.", "hospital bed", 4, 1.1),
        ("A dentist's waiting room.", "waiting chair", 6, 0.7),
        ("A dentist's waiting room.", "reception desk", 1, 2.5),
        ("A living room for a family of five with a piano.", "sofa", 1, 2.6),
        ("A living room for a family of five with a piano.", "armchair", 2, 1.0),
        ("A warehouse with racks.", "rack", 6, 3.0),
        ("A kitchen with an island and three stools.", "kitchen counter", 1, 3.0),
        ("A small bar.", "bar stool", 3, 0.5),
    ] {
        let draft = draft(request);
        assert!(count(&draft, noun) >= n, "{request}: {noun} {}", count(&draft, noun));
        let of = draft.things.iter().find(|t| t.category.replace('_', " ").ends_with(noun));
        assert!(of.and_then(|t| t.size).is_some_and(|size| size[0] <= width), "{request}: {of:?}");
    }
}

#[test]
fn who_a_room_is_for_is_no_thing_in_it() {
    for request in ["A private office for a lawyer.", "A nursery for a newborn."] {
        let draft = draft(request);
        assert!(draft.things.iter().all(|t| t.category != "lawyer" && t.category != "newborn"), "{request}");
    }
}

#[test]
fn what_stands_at_walls_has_a_place_to_begin_with() {
    for request in ["A bedroom.", "A kitchen with an island and three stools.", "A hotel room with twin beds."] {
        let draft = draft(request);
        assert!(draft.guided, "{request}");
        let standing = ["bed", "wardrobe", "kitchen_counter", "kitchen_island", "stool", "desk"];
        for thing in draft.things.iter().filter(|t| standing.iter().any(|s| t.category.ends_with(s))) {
            for i in 0..thing.count {
                let name = if thing.count > 1 { format!("{}[{i}]", thing.name) } else { thing.name.clone() };
                assert!(draft.place_of(&name).is_some(), "{request}: {name}");
            }
        }
    }
    let literal = read("A bedroom with a bed.", &Options { literal: true }).draft;
    assert!(!literal.guided && literal.places.is_empty() && !write(&literal).contains("import"));
}

/// "With only a bed": openings and light are added, and nothing else.
#[test]
fn a_room_with_only_what_is_asked_for_gets_no_furniture() {
    for (request, want) in [
        ("A bedroom with only a bed.", &["bed"][..]),
        ("The room contains only a table and four chairs.", &["table", "chair"]),
        ("There is only a desk in the office.", &["desk"]),
    ] {
        let draft = draft(request);
        let own = draft.things.iter().filter(|t| !t.category.ends_with("light") && !t.category.ends_with("panel"));
        let own: Vec<&str> = own.map(|t| t.category.as_str()).collect();
        assert_eq!(own, want, "{request}");
        assert!(draft.things.len() > want.len(), "{request}: no light");
        assert!(draft.openings.iter().any(|o| o.kind == OpeningKind::Door), "{request}: no door");
        assert!(draft.notes.is_empty(), "{request}: {:?}", draft.notes);
    }
    // Of these "only" is not known to be said of the room: furniture is added, or there is a note on the word.
    for request in [
        "A bedroom with only a bed near the window.",
        "A bedroom with only one window.",
        "A bedroom with only a window.",
        "A bedroom with a desk with only a lamp on it.",
        "A bedroom, ideally with only a bed.",
        "A bedroom with not only a bed.",
    ] {
        assert!(count(&draft(request), "wardrobe") > 0, "{request}");
    }
}

/// How far things of one category are from the nearest of another at most (metres, middle to middle); `None`: not all have a
/// place.
fn far(draft: &Draft, noun: &str, from: &str) -> Option<f64> {
    let name = |noun: &str| draft.things.iter().find(|t| t.category == noun).map(|t| (t.name.clone(), t.count));
    let places = |noun: &str| -> Option<Vec<[f64; 4]>> {
        let (name, n) = name(noun)?;
        let element = |i: usize| if n > 1 { format!("{name}[{i}]") } else { name.clone() };
        (0..n).map(|i| draft.place_of(&element(i))).collect()
    };
    let (things, others) = (places(noun)?, places(from)?);
    let nearest = |p: &[f64; 4]| others.iter().map(|o| (p[0] - o[0]).hypot(p[2] - o[2])).fold(f64::INFINITY, f64::min);
    Some(things.iter().map(nearest).fold(0.0, f64::max))
}

#[test]
fn what_is_asked_for_stands_with_what_it_goes_with() {
    for (request, noun, from, most) in [
        ("A meeting room with ten chairs.", "chair", "conference_table", 2.6),
        ("A classroom with twelve chairs.", "chair", "student_desk", 0.7),
        ("A restaurant with 30 seats.", "seat", "restaurant_table", 0.9),
        ("A barber shop with three chairs.", "barber_chair", "styling_counter", 1.2),
        ("A kitchen with four chairs.", "chair", "kitchen_table", 1.2),
        ("A kitchen with a fridge, a stove and a sink.", "stove", "kitchen_counter", 1.8),
        ("A living room with a sofa and two armchairs.", "armchair", "coffee_table", 1.5),
        ("A living room with a sofa, a coffee table and a TV.", "coffee_table", "sofa", 1.4),
        ("A reception area with a desk, a sofa and two armchairs for visitors.", "armchair", "coffee_table", 1.5),
        ("A bedroom with a double bed and two nightstands.", "nightstand", "double_bed", 1.5),
        ("An office with a desk and two chairs.", "chair", "desk", 1.4),
        ("A conference room with a large table and 12 chairs.", "chair", "conference_table", 2.6),
        ("A kitchen with a dining table with four chairs.", "chair", "dining_table", 1.3),
        ("A restaurant with a bar with six stools.", "bar_stool", "bar", 2.0),
    ] {
        let draft = draft(request);
        let far = far(&draft, noun, from);
        assert!(far.is_some_and(|far| far <= most), "{request}: {noun} to {from}: {far:?}");
    }
}

#[test]
fn a_room_with_much_empty_floor_is_smaller_than_usual_and_keeps_its_furniture() {
    let area = |draft: &Draft| draft.rooms[0].size[0] * draft.rooms[0].size[2];
    for (request, usual) in
        [("A living room.", 6.2 * 5.2), ("A kindergarten room.", 8.0 * 6.5), ("A laboratory.", 8.0 * 6.6)]
    {
        let made = draft(request);
        assert!(area(&made) < 0.95 * usual && area(&made) > 0.6 * usual, "{request}: {}", area(&made));
        assert_eq!(draft(request).rooms[0].size, made.rooms[0].size);
    }
    // What is said is kept.
    for (request, said) in [("A living room of 8 by 6 m.", 48.0), ("A spacious living room.", 1.3 * 6.2 * 5.2)] {
        assert!(area(&draft(request)) >= said - 1e-9, "{request}: {}", area(&draft(request)));
    }
}

#[test]
fn small_things_stand_on_what_carries_such_things() {
    for (request, thing, carrier) in [
        ("A break room with a coffee machine.", "coffeeMachine", "kitchenette"),
        ("A study with a laptop.", "laptop", "desk"),
        ("An office with a printer.", "printer", "printerTable"),
        ("A bedroom with a table lamp.", "tableLamp", "nightstand[0]"),
        ("A lab with a microscope and a centrifuge.", "centrifuge", "labBench[0]"),
        ("A living room with a record player.", "recordPlayer", "sideboard"),
        ("A waiting room with magazines.", "magazine[1]", "receptionDesk"),
    ] {
        let draft = read(request, &Options::default()).draft;
        let fixed = format!("{thing}.pos = {carrier}.pos");
        let statements: Vec<&str> = draft.statements.iter().map(|s| s.text.as_str()).collect();
        assert!(statements.iter().any(|s| s.contains(&fixed)), "{request}: no {fixed} in {statements:#?}");
        let floor = format!("onFloor({thing},");
        assert!(!statements.iter().any(|s| s.contains(&floor)), "{request}: {floor}");
    }
    // Where it is said, it is where it is said.
    let draft = read("A study with a laptop on the floor.", &Options::default()).draft;
    assert!(!draft.statements.iter().any(|s| s.text.contains("laptop.pos = desk")), "{:?}", draft.statements);
}

#[test]
fn sofas_that_face_each_other_stand_across_one_table() {
    for request in [
        "A living room with two sofas facing each other and a coffee table.",
        "A lounge with two couches facing each other.",
    ] {
        let draft = draft(request);
        assert_eq!(count(&draft, "coffee table"), 1, "{request}");
        let seats = if request.contains("sofas") { "sofa" } else { "couch" };
        let place = |i: usize| draft.place_of(&format!("{seats}[{i}]")).unwrap_or_else(|| panic!("{request}: {i}"));
        let ([x, _, z, yaw], [u, _, w, turned]) = (place(0), place(1));
        let (sin, cos) = yaw.to_radians().sin_cos();
        let (ahead, aside) = ((u - x) * sin + (w - z) * cos, (u - x) * cos - (w - z) * sin);
        assert!((1.8..3.2).contains(&ahead) && aside.abs() < 1e-3, "{request}: {ahead} {aside}");
        assert!(((turned - yaw).rem_euclid(360.0) - 180.0).abs() < 1e-6, "{request}: {yaw} {turned}");
    }
}
