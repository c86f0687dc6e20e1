//! Homes of several rooms: as many rooms as are asked for, in a plan that people would build. What holds for every plan is tested
//! on many requests made of the same few rooms.

use scenelang_formalize::draft::{Draft, OpeningKind, ThingOrigin};
use scenelang_formalize::write::write;
use scenelang_formalize::{Options, read};
use scenelang_lang::{Options as Front, compile_text};
use std::path::Path;

/// How far two rooms are apart that share a wall (metres).
const WALL: f64 = 0.06;

fn draft(request: &str) -> Draft {
    read(request, &Options::default()).draft
}

/// How many rooms of a draft have a kind that ends so.
fn count(draft: &Draft, kind: &str) -> usize {
    draft.rooms.iter().filter(|room| room.kind.ends_with(kind)).count()
}

/// The gap of two rooms along an axis; negative where they overlap.
fn gap(draft: &Draft, a: usize, b: usize, axis: usize) -> f64 {
    let (a, b) = (&draft.rooms[a], &draft.rooms[b]);
    (a.at[axis] - b.at[axis]).abs() - (a.size[2 * axis] + b.size[2 * axis]) / 2.0
}

/// How long the wall is that two rooms share.
fn shared(draft: &Draft, a: usize, b: usize) -> f64 {
    let [x, z] = [gap(draft, a, b, 0), gap(draft, a, b, 1)];
    let next = |gap: f64| (gap - WALL).abs() < 2e-3;
    if next(x) {
        -z
    } else if next(z) {
        -x
    } else {
        0.0
    }
}

fn doors(draft: &Draft) -> Vec<Vec<usize>> {
    let doors = draft.openings.iter().filter(|o| o.kind == OpeningKind::Door);
    doors.map(|o| o.rooms.clone()).collect()
}

fn is(draft: &Draft, room: usize, kinds: &[&str]) -> bool {
    kinds.iter().any(|kind| draft.rooms[room].kind.ends_with(kind))
}

/// Rooms that one gets to from outside without going through a bedroom or a bathroom; a bathroom that only a bedroom leads to
/// is reached with it.
fn reached(draft: &Draft) -> Vec<bool> {
    const PRIVATE: [&str; 4] = ["bedroom", "bathroom", "kids room", "home office"];
    let doors = doors(draft);
    let mut out = vec![false; draft.rooms.len()];
    doors.iter().filter(|rooms| rooms.len() == 1).for_each(|rooms| out[rooms[0]] = true);
    for _ in 0..out.len() {
        for door in doors.iter().filter(|rooms| rooms.len() == 2) {
            for (from, to) in [(door[0], door[1]), (door[1], door[0])] {
                let own = is(draft, to, &["bathroom"])
                    && doors.iter().filter(|rooms| rooms.contains(&to)).count() == 1
                    && is(draft, from, &["bedroom"]);
                out[to] |= out[from] && (!is(draft, from, &PRIVATE) || own);
            }
        }
    }
    out
}

/// What a plan must be like, whatever was asked for.
fn is_sound(request: &str, draft: &Draft) {
    let n = draft.rooms.len();
    let name = |room: usize| &draft.rooms[room].name;
    for a in 0..n {
        for b in a + 1..n {
            let apart = gap(draft, a, b, 0).max(gap(draft, a, b, 1));
            assert!(apart >= WALL - 1e-3, "{request}: {} and {} overlap", name(a), name(b));
        }
    }
    for door in doors(draft).iter().filter(|rooms| rooms.len() == 2) {
        let wall = shared(draft, door[0], door[1]);
        assert!(wall >= 0.9, "{request}: {} and {} share {wall:.2} m", name(door[0]), name(door[1]));
    }
    assert!(doors(draft).iter().any(|rooms| rooms.len() == 1), "{request}: no front door");
    let missed: Vec<&String> =
        reached(draft).iter().zip(0..).filter(|(r, _)| !**r).map(|(_, room)| name(room)).collect();
    assert!(missed.is_empty(), "{request}: no way to {missed:?}; doors {:?}", doors(draft));
    for window in draft.openings.iter().filter(|o| o.kind == OpeningKind::Window) {
        let Some([x, _, z, _]) = draft.place_of(&window.name) else {
            panic!("{request}: {} has no place", window.name)
        };
        let inside = |room: usize| {
            let r = &draft.rooms[room];
            (x - r.at[0]).abs() < r.size[0] / 2.0 + 0.2 && (z - r.at[1]).abs() < r.size[2] / 2.0 + 0.2
        };
        let others: Vec<usize> = (0..n).filter(|room| *room != window.rooms[0] && inside(*room)).collect();
        assert!(others.is_empty(), "{request}: {} is in the wall to {}", window.name, name(others[0]));
    }
}

/// Whether the rooms with pipes that more than one room leads to, or a hall, are next to each other.
fn pipes_together(draft: &Draft) -> bool {
    let wet: Vec<usize> = (0..draft.rooms.len()).filter(|room| is(draft, *room, &["kitchen", "bathroom"])).collect();
    let own = |room: usize| {
        let bedroom = |o: &Vec<usize>| o.contains(&room) && o.iter().any(|other| is(draft, *other, &["bedroom"]));
        is(draft, room, &["bathroom"]) && doors(draft).iter().any(bedroom)
    };
    let wet: Vec<usize> = wet.into_iter().filter(|room| !own(*room)).collect();
    let Some((first, rest)) = wet.split_first() else { return true };
    let mut group = vec![*first];
    for _ in rest {
        for room in rest {
            if !group.contains(room) && group.iter().any(|other| shared(draft, *other, *room) >= 0.5) {
                group.push(*room);
            }
        }
    }
    group.len() == wet.len()
}

/// Request, kind, how many rooms of it.
#[test]
fn as_many_rooms_as_are_asked_for() {
    let cases: &[(&str, &[(&str, usize)])] = &[
        ("A flat with two bedrooms.", &[("bedroom", 2), ("kitchen", 1), ("bathroom", 1), ("living room", 1)]),
        ("A two-bedroom flat with a kitchen.", &[("bedroom", 2), ("kitchen", 1), ("flat", 0)]),
        ("A four-room apartment with two bathrooms.", &[("bedroom", 3), ("living room", 1), ("bathroom", 2)]),
        ("An office with three meeting rooms.", &[("office", 1), ("meeting room", 3)]),
        ("A flat.", &[("living room", 1), ("kitchen", 1), ("bathroom", 1), ("bedroom", 1), ("hall", 1), ("flat", 0)]),
        ("A house for a family of four.", &[("bedroom", 1), ("kids room", 2), ("house", 0)]),
        ("Two bedrooms and a bathroom.", &[("bedroom", 2), ("bathroom", 1)]),
        ("A flat with two bedrooms, each with its own bathroom, and a kitchen.", &[("bedroom", 2), ("bathroom", 2)]),
    ];
    for (request, rooms) in cases {
        let draft = draft(request);
        let kinds: Vec<&String> = draft.rooms.iter().map(|room| &room.kind).collect();
        for (kind, n) in *rooms {
            assert_eq!(count(&draft, kind), *n, "{request}: {kind} of {kinds:?}");
        }
        assert!(draft.notes.is_empty(), "{request}: {:?}", draft.notes);
        is_sound(request, &draft);
    }
}

#[test]
fn a_bathroom_of_its_own_is_joined_to_its_bedroom() {
    let draft = draft("A flat with two bedrooms, each with its own bathroom, a kitchen and a living room.");
    let mut bedrooms = Vec::new();
    for room in (0..draft.rooms.len()).filter(|room| is(&draft, *room, &["bathroom"])) {
        let with: Vec<Vec<usize>> = doors(&draft).into_iter().filter(|rooms| rooms.contains(&room)).collect();
        assert_eq!(with.len(), 1, "{with:?}");
        bedrooms.extend(with[0].iter().copied().filter(|other| is(&draft, *other, &["bedroom"])));
    }
    bedrooms.dedup();
    assert_eq!(bedrooms.len(), 2, "{bedrooms:?}");
}

#[test]
fn what_is_said_of_rooms_that_there_are_several_of_is_said_of_each() {
    let things = |request: &str, noun: &str| -> Vec<usize> {
        let draft = draft(request);
        let in_room = |room: usize| {
            let own = draft.things.iter().filter(|t| t.room == Some(room) && t.category.ends_with(noun));
            own.filter(|t| matches!(t.source, ThingOrigin::Stated(_))).map(|t| t.count).sum()
        };
        (0..draft.rooms.len()).filter(|room| is(&draft, *room, &["bedroom"])).map(in_room).collect()
    };
    assert_eq!(things("A flat with two bedrooms. Each bedroom has two desks.", "desk"), [2, 2]);
    assert_eq!(things("A flat with two bedrooms. The second bedroom has a piano.", "piano").iter().sum::<usize>(), 1);
}

#[test]
fn connections_that_are_asked_for_hold() {
    for (request, a, b) in [
        (
            "A flat with a living room, a kitchen and a bedroom. The kitchen opens into the living room.",
            "kitchen",
            "living room",
        ),
        (
            "A house with a kitchen, a dining room and two bedrooms. A door between the kitchen and the dining room.",
            "kitchen",
            "dining room",
        ),
    ] {
        let draft = draft(request);
        let joins = |rooms: &Vec<usize>| {
            rooms.len() == 2 && rooms.iter().any(|r| is(&draft, *r, &[a])) && rooms.iter().any(|r| is(&draft, *r, &[b]))
        };
        assert!(doors(&draft).iter().any(joins), "{request}: {:?}", doors(&draft));
        is_sound(request, &draft);
    }
}

/// Requests of two to seven rooms.
fn many() -> Vec<String> {
    const MORE: [&str; 7] =
        ["a bathroom", "two bedrooms", "a kitchen", "a dining room", "a hall", "a home office", "a bedroom"];
    let mut out = Vec::new();
    for pick in 0..1_usize << MORE.len() {
        let chosen: Vec<&str> = (0..MORE.len()).filter(|k| pick >> k & 1 == 1).map(|k| MORE[k]).collect();
        let twice = chosen.contains(&"two bedrooms") && chosen.contains(&"a bedroom");
        if (1..=5).contains(&chosen.len()) && !twice {
            out.push(format!("A home with a living room, {}.", chosen.join(" and ")));
        }
    }
    out
}

#[test]
fn every_plan_is_one_that_people_would_build() {
    let all = many();
    assert!(all.len() > 60, "{}", all.len());
    for request in all.iter().step_by(4) {
        let draft = draft(request);
        is_sound(request, &draft);
        assert!(pipes_together(&draft), "{request}: pipes far apart");
        for room in &draft.rooms {
            let [w, _, d] = room.size;
            let (long, short, area) = (w.max(d), w.min(d), w * d);
            let (least, most, side) = match room.kind.as_str() {
                "bedroom" => (9.5, 18.0, 2.4),
                "bathroom" => (3.9, 7.4, 1.5),
                "kitchen" => (7.0, 13.5, 2.0),
                "living room" => (18.0, 33.0, 3.0),
                "hall" => (1.5, 25.0, 1.1),
                _ => (6.0, 22.0, 2.0),
            };
            let at = format!("{request}: {} is {w} by {d} m", room.name);
            assert!(area >= least && area <= most && short >= side, "{at}");
            assert!(room.kind == "hall" || long / short <= 2.6, "{at}");
        }
    }
}

#[test]
fn a_stated_size_is_never_changed() {
    let draft = draft("A flat with a living room of 6 by 4.5 m, two bedrooms and a kitchen.");
    let living = draft.rooms.iter().find(|room| room.kind == "living room").expect("there is one");
    assert_eq!([living.size[0], living.size[2]], [6.0, 4.5]);
    is_sound("a living room of 6 by 4.5 m", &draft);
}

#[test]
fn homes_compile_and_literally_nothing_is_added() {
    let request = "A flat with two bedrooms and a kitchen.";
    let text = write(&draft(request));
    let compiled = compile_text("room.scene", Path::new("room.scene"), &text, Front::default());
    assert!(!compiled.has_errors(), "{:?}", compiled.diagnostics);
    let literal = read(request, &Options { literal: true }).draft;
    let kinds: Vec<&str> = literal.rooms.iter().map(|room| room.kind.as_str()).collect();
    assert_eq!(kinds, ["bedroom", "kitchen", "bedroom"]);
    assert!(literal.things.is_empty());
}
