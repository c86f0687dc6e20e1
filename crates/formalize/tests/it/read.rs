//! The English reader: phrases and what they become, any text at all, and the thirty requests of the development set.

use crate::support::complaints;
use proptest::prelude::*;
use scenelang_formalize::draft::{Draft, Statement, ThingOrigin};
use scenelang_formalize::read::{BECAME_NOTHING, PURPOSE};
use scenelang_formalize::write::write;
use scenelang_formalize::{Options, read};
use scenelang_lang::program::ConstraintKind;
use scenelang_lang::{Options as Front, compile_text};
use scenelang_verify::prove::{ProveOptions, prove};
use std::ops::Range;
use std::path::{Path, PathBuf};

const LITERAL: Options = Options { literal: true };

/// What comes of a request, with nothing added: things with their numbers, and stated statements.
fn literal(request: &str) -> (Vec<String>, Vec<String>) {
    let draft = read(request, &LITERAL).draft;
    let things = draft.things.iter().filter(|t| matches!(t.source, ThingOrigin::Stated(_)));
    let things = things.map(|t| if t.count > 1 { format!("{} {}", t.count, t.name) } else { t.name.clone() });
    let openings = draft.openings.iter().filter(|o| matches!(o.source, ThingOrigin::Stated(_))).map(|o| o.name.clone());
    let things = things.chain(openings).collect();
    let stated = draft.statements.iter().filter(|s| matches!(s.source, ThingOrigin::Stated(_)));
    (things, stated.map(Statement::line).collect())
}

/// What no table knows is told, and nothing is told of what is known.
#[test]
fn unknown_objects_and_rooms_are_told() {
    for (request, want) in [
        ("A room with a chair and a flurb", Some("unknown object, drawn as a plain box")),
        ("a kitchn with an oven", Some("unknown kind of room; did you mean \"kitchen\"?")),
        ("A kitchen with an oven", None),
        ("A scriptorium with two desks", None),
        ("A large room with a table", None),
    ] {
        let notes: Vec<String> = read(request, &LITERAL).draft.notes.into_iter().map(|n| n.reason).collect();
        match want {
            Some(want) => assert!(notes.iter().any(|n| n.starts_with(want)), "{request}: {notes:?}"),
            None => assert!(!notes.iter().any(|n| n.starts_with("unknown")), "{request}: {notes:?}"),
        }
    }
}

/// Phrase, things, pieces of statements. One a line, in `read.txt`.
#[test]
fn phrases_become_statements() {
    let (mut seen, mut wrong) = (0, Vec::new());
    for line in include_str!("read.txt").lines().filter(|l| !l.starts_with('#') && !l.is_empty()) {
        let mut columns = line.split(" => ");
        let (request, things) = (columns.next().unwrap(), columns.next().unwrap());
        let (got, statements) = literal(request);
        if got.join(", ") != things {
            wrong.push(format!("{request} => {}, not {things}", got.join(", ")));
        }
        for want in columns.next().unwrap_or("").split(" & ").filter(|w| !w.is_empty()) {
            if !statements.iter().any(|s| s.contains(want)) {
                wrong.push(format!("{request}: no `{want}` in {statements:?}"));
            }
        }
        seen += 1;
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
    assert!(seen > 30);
}

/// What is taken back in the same breath is not said, nor is what was said before it a mere wish.
#[test]
fn what_is_mended_is_not_said() {
    for (request, gone, said) in [
        ("The counter is near the door — sorry, not near it, far from it: at least 4 m.", "near(", "assert far("),
        ("A plant stands near the door, no, far from it.", "near(", "assert far("),
        ("A plant stands near the door and far from the window.", "far(plant, door", "assert near("),
    ] {
        let (_, statements) = literal(request);
        assert!(statements.iter().any(|s| s.contains(said)), "{request}: {statements:?}");
        let is_left = |s: &String| s.contains(gone) || s.starts_with("prefer");
        assert!(!statements.iter().any(is_left), "{request}: {statements:?}");
    }
}

/// Counts and sizes that are not taken as they are, and what is said of each.
#[test]
fn what_is_not_taken_as_it_is_said() {
    for (request, want) in [
        ("A room with -3 chairs", "cannot be negative: this is read as 3"),
        ("A room with minus 3 chairs", "cannot be negative: this is read as 3"),
        ("A room with a table -2 m long", "cannot be negative: this is read as 2"),
        ("A room with 2.5 tables", "2.5 is read as 2"),
        ("A room with half a bed", "whole numbers: this is read as 1"),
        ("A hall with 5000 chairs", "5000 is too many"),
        ("A hall with 200000 chairs", "200000 is too many"),
        ("A hall with 50 tables, each with 10 chairs", "500 is too many"),
        ("A hall of 900 m by 10 m with a table", "900 m is read as 500 m"),
        ("A room of 0 m by 4 m with a bed", "not used"),
        ("A room with 0 beds and a desk", ""),
        ("A room with 3 chairs and 1.5 m of free space", ""),
        ("A table 2-3 m long with 2-3 chairs", ""),
    ] {
        let notes: Vec<String> = read(request, &LITERAL).draft.notes.into_iter().map(|n| n.reason).collect();
        let odd = ["negative", "whole numbers", "too many", "is read as", "not used"];
        let notes: Vec<String> = notes.into_iter().filter(|n| n != BECAME_NOTHING && n != PURPOSE).collect();
        let found: Vec<&String> = notes.iter().filter(|n| odd.iter().any(|o| n.contains(o))).collect();
        match want {
            "" => assert!(found.is_empty(), "{request}: {notes:?}"),
            want => assert!(found.iter().any(|n| n.contains(want)), "{request}: {notes:?}"),
        }
    }
}

#[test]
fn rooms_and_their_sizes() {
    for (request, want) in [
        ("A kitchen of 4 by 3 m, 2.5 m high, with a stove.", "kitchen 4 2.5 3"),
        ("the office is 6x5m, ceiling 2.8. a desk in the middle", "office 6 2.8 5"),
        ("A living room (20 ft by 15 ft) with a sofa", "livingRoom 6.096 2.6 4.572"),
        ("My bedroom is 4 m wide and 5 m deep and has a bed.", "bedroom 4 2.6 5"),
        ("The board room is 9.5 metres long and 6 metres wide. A table.", "boardRoom 6 2.8 9.5"),
        ("A corridor, 8 m wide, 24 m long, 4.5 m tall, with a bench.", "corridor 8 4.5 24"),
        ("Evacuation study, gymnasium: 20 m wide, 15 m long, 7 m high. A mat.", "gymnasium 20 7 15"),
        ("At the end of the beer cellar, a vaulted room of twelve metres by seven, a kettle.", "cellar 12 2.8 7"),
        ("A dining room, 4.2 m square, with a table", "diningRoom 4.2 2.6 4.2"),
        ("2.1 Newsroom. The newsroom is to be 14 m by 9 m (ceiling 3.4 m). A desk.", "newsroom 14 3.4 9"),
        ("Changing room, 7 m * 5 m\n- a bench", "changingRoom 7 2.8 5"),
        ("A shop, 48 square metres, with two shelves", "shop 7.407 3.2 6.481"),
    ] {
        let draft = read(request, &LITERAL).draft;
        let [w, h, d] = draft.rooms[0].size;
        assert_eq!(format!("{} {w} {h} {d}", draft.rooms[0].name), want, "{request}");
        assert!(draft.rooms.len() == 1, "{request}");
    }
    let two = read("Kitchen: a stove.\n\nBedroom: a bed. A door connects the kitchen and the bedroom.", &LITERAL).draft;
    assert_eq!(two.rooms.iter().map(|r| r.name.as_str()).collect::<Vec<_>>(), ["kitchen", "bedroom"]);
    assert_eq!(two.openings.iter().map(|o| o.rooms.clone()).collect::<Vec<_>>(), [[0, 1]]);
    assert_eq!(two.things.iter().map(|t| t.room).collect::<Vec<_>>(), [Some(0), Some(1)]);
}

#[test]
fn looks_are_carried() {
    let draft = read("A dark green velvet sofa with armrests and three chairs (white, oak).", &LITERAL).draft;
    let looks: Vec<_> = draft.things.iter().map(|t| (t.look.color.as_deref(), t.look.material.as_deref())).collect();
    assert_eq!(looks, [(Some("dark green"), Some("velvet")), (Some("white"), Some("oak"))]);
    assert_eq!(draft.things[0].look.features, ["with armrests"]);
}

/// Looks that are said in more than a word, by a part, or by another thing.
#[test]
fn looks_in_several_words() {
    for (request, thing, want) in [
        ("A neatly rolled towel on a bench.", 0, "neatly rolled"),
        ("A room with a steel frame desk.", 0, "steel frame"),
        ("A desk with a glass top stands by the wall.", 0, "with a glass top"),
        ("Three spindle back chairs.", 0, "spindle back"),
        ("A floor to ceiling cabinet.", 0, "floor to ceiling"),
        ("A sideboard with four drawers stands against the wall.", 0, "with four drawers"),
        ("A bench with a cup on its padded top.", 0, "padded top"),
        ("A bed draped in linen.", 0, "draped in linen"),
        ("A 55-inch TV on the wall.", 0, "55-inch"),
        ("A two_seat sofa.", 0, "two-seat"),
        ("A round oak table and a matching stool.", 1, "oak"),
    ] {
        let draft = read(request, &LITERAL).draft;
        let look = &draft.things[thing].look;
        let all = look.features.iter().chain(&look.material).map(String::as_str).collect::<Vec<_>>().join(", ");
        assert!(all.contains(want), "{request}: {all}");
    }
    let screen = read("A 55-inch TV on the wall.", &LITERAL).draft.things[0].size;
    assert!(screen.is_none_or(|[w, h, _]| (w - 1.218).abs() < 0.01 && (h - 0.685).abs() < 0.01), "{screen:?}");
}

#[test]
fn what_is_not_understood_is_noted() {
    let request = "A desk by the wall. Colourless green ideas dream furiously upwards.";
    let reading = read(request, &LITERAL);
    assert_eq!((reading.understood, reading.clauses), (1, 2));
    assert!(
        reading.draft.notes.iter().any(|n| request[n.at.clone()].contains("dream furiously")),
        "{:?}",
        reading.draft.notes
    );
    let ruled_out = read("A bedroom with a bed and no television.", &LITERAL);
    assert_eq!(ruled_out.absent.iter().map(|a| a.0.as_str()).collect::<Vec<_>>(), ["television"]);
    for other in ["椅子四つとテーブル", "🍕🍕🍕", "", "\n\n\n", "Ein Tisch mit vier Stühlen steht mitten im Zimmer."]
    {
        let reading = read(other, &Options::default());
        assert_eq!(reading.understood, 0, "{other}");
        assert!(reading.draft.things.is_empty(), "{other}");
    }
}

#[test]
fn little_is_filled_up_unless_it_is_to_be_literal() {
    let full = read("A bedroom", &Options::default()).draft;
    assert!(full.things.iter().any(|t| t.category.contains("bed")));
    assert!(full.things.iter().all(|t| matches!(&t.source, ThingOrigin::Inferred(why) if !why.is_empty())));
    assert!(read("A bedroom", &LITERAL).draft.things.is_empty());
    let said = read("A bedroom with a bed, a desk, a chair and a lamp", &Options::default()).draft;
    let stated = said.things.iter().filter(|t| matches!(t.source, ThingOrigin::Stated(_)));
    assert_eq!(stated.map(|t| t.count).collect::<Vec<_>>(), [1, 1, 1, 1]);
    assert!(said.things.len() > 8, "{:?}", said.things);
    for noun in ["bed", "desk", "chair", "lamp"] {
        let of = said.things.iter().filter(|t| t.category == noun || t.category.ends_with(&format!("_{noun}")));
        assert_eq!(of.count(), 1, "{noun}");
    }
}

/// The requests of the development set.
fn development() -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/requests/development");
    let mut files: Vec<PathBuf> =
        std::fs::read_dir(folder).expect("the set is there").flatten().map(|f| f.path()).collect();
    files.retain(|f| f.extension().is_some_and(|e| e == "txt"));
    files.sort();
    files
}

/// Errors of the front end, and contradictions.
fn faults(draft: &Draft) -> Vec<String> {
    let text = write(draft);
    let compiled = compile_text("room.scene", Path::new("room.scene"), &text, Front::default());
    let Some(program) = compiled.program.as_ref().filter(|_| !compiled.diagnostics.iter().any(|d| d.is_error())) else {
        return complaints(&text);
    };
    let options = ProveOptions { redundant: false, ..ProveOptions::default() };
    // "A rug in the middle against the wall" contradicts itself, and so does its program.
    let is_said = |i: &&usize| {
        let constraint = &program.constraints[**i];
        let asserted = constraint.text.contains('(') && !constraint.text.contains("<-");
        asserted && constraint.requirements.iter().any(|text| !text.starts_with("inferred"))
    };
    let contradictions = prove(program, &options).contradictions;
    let own = contradictions.iter().filter(|c| c.statements.iter().filter(is_said).count() < 2);
    own.map(|c| format!("{:?}", c.statements)).collect()
}

/// The warnings for the program of a draft, and what was added to it as a preference that can never hold.
fn warnings(draft: &Draft) -> Vec<String> {
    let compiled = compile_text("room.scene", Path::new("room.scene"), &write(draft), Front::default());
    let program = compiled.program.expect("it compiles");
    let proved = prove(&program, &ProveOptions { usual: true, ..ProveOptions::default() });
    let constraints = proved.unsatisfiable.iter().flat_map(|c| &c.statements).map(|i| &program.constraints[*i]);
    let added = constraints.filter(|constraint| {
        let is_preference = matches!(constraint.kind, ConstraintKind::Prefer { .. });
        is_preference && constraint.requirements.iter().all(|text| text.starts_with("inferred"))
    });
    let warnings = compiled.diagnostics.iter().map(|found| format!("{}: {}", found.code, found.message));
    warnings.chain(added.map(|constraint| constraint.text.to_string())).collect()
}

#[test]
fn every_program_compiles_and_nothing_contradicts() {
    let files = development();
    assert_eq!(files.len(), 30);
    for file in files {
        let request = std::fs::read_to_string(&file).unwrap();
        for literal in [false, true] {
            let reading = read(&request, &Options { literal });
            assert_eq!(faults(&reading.draft), Vec::<String>::new(), "{}", file.display());
            if !literal {
                assert_eq!(warnings(&reading.draft), Vec::<String>::new(), "{}", file.display());
            }
            // Of so many clauses something came: of fewer, all.
            let used = |at: &Range<usize>| {
                reading.words.iter().any(|word| word.used && at.start <= word.at.start && word.at.end <= at.end)
            };
            let read = reading.read.iter().filter(|(at, _)| used(at)).count();
            assert!(read * 10 >= reading.clauses * 7, "{}: {read} of {}", file.display(), reading.clauses);
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 24, ..ProptestConfig::default() })]

    #[test]
    fn any_text_is_read(text in "\\PC{0,300}") {
        let reading = read(&text, &Options::default());
        prop_assert!(reading.understood <= reading.clauses);
        for note in &reading.draft.notes {
            prop_assert!(text.get(note.at.clone()).is_some());
        }
    }

    #[test]
    fn words_in_any_order_make_programs(words in proptest::collection::vec(proptest::sample::select(WORDS), 1..40)) {
        let text = words.join(" ");
        let reading = read(&text, &Options::default());
        prop_assert_eq!(faults(&reading.draft), Vec::<String>::new(), "{}", text);
    }
}

#[test]
fn a_room_does_not_shrink_below_what_lies_in_it() {
    let text = "a kitchen with a rug of 5 by 4 m in the middle";
    for text in [text, "chair rug in the middle 5 by 4 m kitchen"] {
        assert_eq!(faults(&read(text, &Options::default()).draft), Vec::<String>::new(), "{text}");
    }
}

#[test]
fn any_noun_may_be_the_last_word() {
    for noun in scenelang_lang::nouns::all() {
        let name = noun.name.replace('_', " ");
        for text in [format!("A warehouse with a {name}"), format!("{name} {name}")] {
            let reading = read(&text, &Options { literal: true });
            assert!(!reading.draft.rooms.is_empty(), "{text}");
        }
    }
}

#[test]
fn only_what_the_request_says_may_contradict() {
    let draft = read("A kitchen with a rug in the middle against the wall.", &Options::default()).draft;
    assert_eq!(faults(&draft), Vec::<String>::new());
    let mut draft = read("A kitchen with a rug.", &Options::default()).draft;
    let inferred = ThingOrigin::Inferred("as usual".into());
    draft.statements.push(Statement::new("assert rug.pos.y = 0;", inferred.clone()));
    draft.statements.push(Statement::new("assert rug.pos.y = 1;", inferred));
    assert_eq!(faults(&draft).len(), 1);
}

/// Words that mean something to the reader, to be shuffled.
const WORDS: &[&str] = &[
    "a",
    "the",
    "two",
    "each",
    "no",
    "chair",
    "tables",
    "desk",
    "sofa",
    "lamp",
    "door",
    "window",
    "kitchen",
    "bedroom",
    "on",
    "under",
    "between",
    "next to",
    "in front of",
    "behind",
    "around",
    "facing",
    "against the wall",
    "in the corner",
    "with",
    "and",
    ",",
    ".",
    ":",
    "\n-",
    "it",
    "them",
    "at least 2 m",
    "1.2 m wide",
    "5 by 4 m",
    "white",
    "oak",
    "in a row",
    "not",
    "keep",
    "free",
    "hangs",
    "holds",
    "from",
    "in the middle",
    "leads to",
    "(",
    ")",
    "of",
    "rug",
    "clock",
    "six",
    "apart",
    "in two rows",
];

#[test]
fn much_text_takes_its_time_and_no_more() {
    let many = "A table with four chairs stands next to the sofa. ".repeat(20_000);
    let reading = read(&many, &LITERAL);
    assert!(reading.draft.notes.iter().any(|n| n.reason.contains("too long")));
    let one_word = "x".repeat(1 << 20);
    assert_eq!(read(&one_word, &LITERAL).understood, 0);
    let signs = "(((".repeat(300_000);
    assert_eq!(read(&signs, &LITERAL).clauses, 0);
}
