//! Drafts for the tests, and what the front end and the prover say of programs.

use scenelang_formalize::draft::{Draft, DraftRoom, DraftThing, Opening, OpeningKind, Statement, Surface, ThingOrigin};
use scenelang_lang::{Options, compile_text};
use std::path::Path;

/// Errors and warnings of a program, one a line.
pub fn complaints(program: &str) -> Vec<String> {
    let compiled = compile_text("room.scene", Path::new("room.scene"), program, Options::default());
    compiled.diagnostics.iter().map(|d| format!("{} {}", d.code, d.message)).collect()
}

/// The bytes of some words of a request.
pub fn stated(request: &str, words: &str) -> ThingOrigin {
    let at = request.find(words).unwrap_or_else(|| panic!("no {words:?} in {request:?}"));
    ThingOrigin::Stated(at..at + words.len())
}

pub fn room(name: &str, size: [f64; 2]) -> DraftRoom {
    DraftRoom {
        name: name.into(),
        kind: name.into(),
        at: [0.0; 2],
        size: [size[0], 2.7, size[1]],
        sized: true,
        rows: [0.0; 2],
        outline: None,
        floor: Surface::default(),
        walls: Surface::default(),
        source: ThingOrigin::Inferred("a test".into()),
    }
}

pub fn opening(name: &str, kind: OpeningKind, rooms: &[usize]) -> Opening {
    Opening {
        name: name.into(),
        kind,
        category: None,
        rooms: rooms.to_vec(),
        size: if kind == OpeningKind::Door { [0.9, 2.1, 0.06] } else { [1.5, 1.2, 0.06] },
        look: Default::default(),
        source: ThingOrigin::Inferred("a test".into()),
    }
}

pub fn thing(name: &str, category: &str, room: Option<usize>) -> DraftThing {
    DraftThing {
        name: name.into(),
        category: category.into(),
        count: 1,
        room,
        size: None,
        look: Default::default(),
        formation: Vec::new(),
        source: ThingOrigin::Inferred("a test".into()),
    }
}

pub fn statement(text: &str, source: ThingOrigin) -> Statement {
    Statement::new(text, source)
}

/// Two rooms, openings of each kind, an array, a note.
pub fn office() -> Draft {
    let request = "A meeting room of 6 x 5 m with an oak floor and off-white walls opens onto a small hall. \
        Six dark green chairs with armrests stand around an oval table. A \"vintage\" lamp hangs over it. \
        There is a window. It should feel cosy.";
    let from = |words: &str| stated(request, words);
    let mut draft = Draft { request: request.into(), ..Draft::default() };
    let mut meeting = room("meetingRoom", [6.0, 5.0]);
    meeting.kind = "meeting room".into();
    meeting.floor.material = Some("oak".into());
    meeting.walls.color = Some("off-white".into());
    meeting.source = from("meeting room");
    let mut hall = room("hall", [2.5, 3.0]);
    hall.source = from("small hall");
    draft.rooms = vec![meeting, hall];
    let mut door = opening("door", OpeningKind::Door, &[0, 1]);
    door.source = from("opens onto");
    let mut window = opening("window", OpeningKind::Window, &[0]);
    window.source = from("window");
    draft.openings = vec![door, window];
    let mut table = thing("table", "conference_table", Some(0));
    table.size = Some([2.4, 0.75, 1.2]);
    table.look.features = vec!["oval".into()];
    table.source = from("oval table");
    let mut chair = thing("chair", "chair", Some(0));
    chair.count = 6;
    chair.look.color = Some("dark green".into());
    chair.look.features = vec!["with armrests".into()];
    chair.source = from("Six dark green chairs");
    let mut lamp = thing("lamp", "pendant_lamp", Some(0));
    lamp.look.color = Some("brushed gold".into());
    lamp.look.features = vec!["\"vintage\"".into()];
    lamp.source = from("lamp");
    let bench = DraftThing {
        source: ThingOrigin::Inferred("a hall has somewhere to sit".into()),
        ..thing("bench", "bench", Some(1))
    };
    draft.things = vec![table, chair, lamp, bench];
    draft.statements = vec![
        statement("assert around(chair, table, 0.5);", from("around")),
        statement("assert ceilingMounted(lamp, meetingRoom) and above(lamp, table)", from("hangs")),
        statement("assert againstWall(bench, hall);", ThingOrigin::Inferred("a bench stands at a wall".into())),
        statement("assert forall o in objects: o.rot.x = 0;", ThingOrigin::Inferred("nothing lies on its side".into())),
    ];
    let cosy = request.find("It should").expect("it is there");
    draft.notes = vec![scenelang_formalize::draft::Note {
        at: cosy..request.len(),
        reason: "nothing that can be measured is said".into(),
    }];
    draft
}

/// The texts of the requests of the repository.
pub fn requests() -> Vec<String> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/requests");
    let mut files: Vec<_> = ["development", "aside"]
        .iter()
        .flat_map(|folder| std::fs::read_dir(root.join(folder)).expect("the folder of requests"))
        .map(|entry| entry.expect("an entry").path())
        .filter(|path| path.extension().is_some_and(|e| e == "txt"))
        .collect();
    files.sort();
    assert!(files.len() >= 50, "{}", files.len());
    files.iter().map(|path| std::fs::read_to_string(path).expect("a request")).collect()
}
