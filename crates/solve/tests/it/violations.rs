//! One violation of each kind in furnished rooms: what is offered to repair it, in the order in which it is offered, and what
//! is said of contradictions (`studio/cases.txt` and its like). None of it takes a search.

use scenelang_base::{FileId, SourceFile, SourceMap};
use scenelang_lang::compile_main;
use scenelang_lang::program::ObjectId;
use scenelang_lang::sources::Loader;
use scenelang_layout::{Layout, Placement, Vec3, file};
use scenelang_solve::repair::told::title;
use scenelang_solve::repair::{Alternative, Damaged, How, RepairOptions, Text, Which, repair};
use scenelang_verify::rules::support;
use scenelang_verify::{Options, World, check};
use std::path::Path;

/// A room in which all holds, and cases that damage it.
struct Room {
    file: &'static str,
    scene: &'static str,
    layout: &'static str,
    cases: &'static str,
    /// How many objects there are.
    objects: usize,
}

const ROOMS: [Room; 4] = [
    Room {
        file: "studio.scene",
        scene: include_str!("studio/studio.scene"),
        layout: include_str!("studio/studio.layout.json"),
        cases: include_str!("studio/cases.txt"),
        objects: 17,
    },
    Room {
        file: "clinic.scene",
        scene: include_str!("clinic/clinic.scene"),
        layout: include_str!("clinic/clinic.layout.json"),
        cases: include_str!("clinic/cases.txt"),
        objects: 17,
    },
    Room {
        file: "staffroom.scene",
        scene: include_str!("staffroom/staffroom.scene"),
        layout: include_str!("staffroom/staffroom.layout.json"),
        cases: include_str!("staffroom/cases.txt"),
        objects: 16,
    },
    Room {
        file: "hotel.scene",
        scene: include_str!("hotel/hotel.scene"),
        layout: include_str!("hotel/hotel.layout.json"),
        cases: include_str!("hotel/cases.txt"),
        objects: 16,
    },
];

/// A way to damage the room, and what is to be offered.
#[derive(Default)]
struct Case {
    title: String,
    /// Statements that are added to the program.
    added: String,
    /// Where objects are put, and the yaw to which they are turned.
    moved: Vec<(String, Option<Vec3>, Option<f64>)>,
    /// The sizes of objects that are added.
    sizes: Vec<(String, Vec3)>,
    /// The choices, as an editor names them, and the members of a contradiction.
    offered: Vec<String>,
}

fn cases(room: &Room) -> Vec<Case> {
    let mut out: Vec<Case> = Vec::new();
    for line in room.cases.lines().map(str::trim).filter(|line| !line.is_empty() && !line.starts_with("//")) {
        if let Some(title) = line.strip_prefix("# ") {
            out.push(Case { title: title.to_owned(), ..Case::default() });
            continue;
        }
        let case = out.last_mut().expect("a case begins with its title");
        if let Some(statement) = line.strip_prefix("+ ") {
            case.added += &format!("{statement}\n");
        } else if line.starts_with("- ") || line.starts_with("! ") {
            case.offered.push(line.to_owned());
        } else if let Some((name, yaw)) = line.split_once(" turned ") {
            case.moved.push((name.to_owned(), None, Some(yaw.parse().expect("degrees"))));
        } else {
            let (name, place) = line.split_once(" at ").expect("NAME at X Y Z");
            let (place, size) = place.split_once(" sized ").map_or((place, None), |(place, size)| (place, Some(size)));
            let numbers = |text: &str| -> Vec3 {
                Vec3::from_iterator(text.split(' ').map(|n| n.parse::<f64>().expect("metres")))
            };
            case.sizes.extend(size.map(|size| (name.to_owned(), numbers(size))));
            case.moved.push((name.to_owned(), Some(numbers(place)), None));
        }
    }
    out
}

struct Memory(String);

impl Loader for Memory {
    fn load(&self, _: &Path) -> std::io::Result<Vec<u8>> {
        Ok(self.0.as_bytes().to_vec())
    }
}

fn layout(room: &Room) -> Layout {
    let read = file::read(room.layout, FileId(0));
    assert!(read.diagnostics.is_empty(), "{:?}", read.diagnostics);
    read.layout
}

fn is_move(alternative: &Alternative) -> bool {
    alternative.how == How::Moves
}

#[test]
fn the_first_choice_is_what_a_person_would_do() {
    let mut wrong = Vec::new();
    for (room, case) in ROOMS.iter().flat_map(|room| cases(room).into_iter().map(move |case| (room, case))) {
        let name = &case.title;
        let text = Memory(format!("{}{}", room.scene, case.added));
        let path = Path::new(room.file);
        let mut sources = SourceMap::new();
        let main = sources.add(SourceFile::new(room.file, path, &text.0));
        let compiled = compile_main(main, scenelang_lang::Options::default(), &text, sources);
        let program = compiled.program.unwrap_or_else(|| panic!("{name}: {:?}", compiled.diagnostics));
        let mut hurt = layout(room);
        for (added, size) in &case.sizes {
            let (_, like) = hurt.objects.iter().find(|(_, o)| o.rot.y == 0.0).expect("something is not turned");
            let placed = Placement { scale: *size, parts: Vec::new(), ..like.clone() };
            hurt.objects.push((added.as_str().into(), placed));
        }
        for (moved, pos, yaw) in &case.moved {
            let (_, placed) = hurt.objects.iter_mut().find(|(n, _)| n == moved).unwrap_or_else(|| panic!("{moved}"));
            placed.pos = pos.unwrap_or(placed.pos);
            placed.rot.y = yaw.unwrap_or(placed.rot.y);
        }
        let source = Text {
            name: room.file,
            path,
            compile: scenelang_lang::Options::default(),
            loader: &text,
            sources: &compiled.sources,
        };
        let asked = Damaged { program: &program, layout: &hurt, text: Some(source) };
        // No search is paid for.
        let options = RepairOptions { budget: 0, ..RepairOptions::default() };
        let found = repair(&asked, &Which::All, &options).unwrap_or_else(|_| panic!("{name}: cannot be judged"));
        let statements = found.contradiction.iter().flat_map(|c| &c.statements);
        let members = statements.map(|i| format!("! {}", program.constraints[*i].text));
        let titles = found.alternatives.iter().map(|a| format!("- {}", title(&program, &compiled.sources, a)));
        let offered: Vec<String> = members.chain(titles).collect();
        if offered != case.offered {
            wrong.push(format!("# {name}\n{}", offered.join("\n")));
        }
        for choice in found.alternatives.iter().filter(|a| is_move(a)) {
            let after = check(&program, &choice.layout, &Options::default());
            let fails: Vec<&str> =
                after.rows.iter().filter(|r| r.satisfied != Some(true)).map(|r| r.text.as_str()).collect();
            assert!(fails.is_empty(), "{name}: {fails:?}");
            let carriers = |layout: &Layout| {
                let world = World::<f64>::new(&program, layout, &Options::default());
                let moved = choice.moves.iter().map(|m| m.object);
                moved
                    .map(|id| {
                        let rest = support::rest(&world, id, &support::others(&world, id)).ok()?;
                        let holds = rest.truth(&Options::default().tolerances).holds;
                        holds.then_some(rest.carrier)
                    })
                    .collect::<Vec<_>>()
            };
            let (before, now) = (carriers(&hurt), carriers(&choice.layout));
            // It stands on what it stood on, or on the floor, or on what it is to stand on.
            let called = |id: ObjectId| program.objects[id.0 as usize].name.as_str();
            let asked =
                |(own, on): (ObjectId, ObjectId)| text.0.contains(&format!("on({}, {})", called(own), called(on)));
            for ((moved, before), now) in choice.moves.iter().zip(&before).zip(&now) {
                let fits = match (before, now) {
                    (None, _) | (Some(_), Some(None)) => true,
                    (Some(_), Some(Some(on))) => before == now || asked((moved.object, *on)),
                    (Some(_), None) => false,
                };
                assert!(fits, "{name}: {before:?} {now:?}");
            }
        }
    }
    assert!(wrong.is_empty(), "these are offered:\n{}", wrong.join("\n\n"));
}

#[test]
fn the_rooms_themselves_hold() {
    for room in &ROOMS {
        let path = Path::new(room.file);
        let compiled = scenelang_lang::compile_text(room.file, path, room.scene, scenelang_lang::Options::default());
        let program = compiled.program.expect("it compiles");
        assert_eq!(program.objects.len(), room.objects, "{}", room.file);
        let verdict = check(&program, &layout(room), &Options::default());
        assert!(verdict.rows.iter().all(|row| row.satisfied == Some(true)), "{}", room.file);
        // Each case damages it.
        let cases = cases(room);
        assert!(cases.len() >= 10 && cases.iter().all(|case| !case.offered.is_empty()), "{}", room.file);
    }
}
