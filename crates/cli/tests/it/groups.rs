//! Each group of the library in a small program, solved from ten seeds.

use crate::support::scenelang;
use std::fs;

const ROOM: &str = "region room;\nroom.pos <- vec3(0, 0, 0);\nroom.scale <- vec3(6, 2.7, 5);\n";

/// A name and what stands in the room.
const GROUPS: [(&str, &str); 13] = [
    (
        "bed",
        r#"object bed;
bed.category <- "double bed";
object ns[2];
ns.category <- "nightstand";
assert againstWall(bed,room) and onFloor(bed,room) and (forall n in ns: onFloor(n,room)) and bedSet(bed,ns);"#,
    ),
    (
        "counter",
        r#"object counter;
counter.category <- "counter";
object stool[3];
stool.category <- "bar stool";
counter.scale <- vec3(2.4,1.05,0.6);
assert (forall o in objects: onFloor(o,room)) and counterSet(counter,stool);"#,
    ),
    (
        "desk",
        r#"object desk;
desk.category <- "desk";
object chair;
chair.category <- "office chair";
assert againstWall(desk,room) and onFloor(desk,room) and onFloor(chair,room) and deskSet(desk,chair);"#,
    ),
    (
        "dining",
        r#"object table;
table.category <- "dining table";
object chair[6];
chair.category <- "dining chair";
assert forall c in chair: onFloor(c, room);
assert onFloor(table, room);
assert diningSet(table, chair);"#,
    ),
    (
        "dining4",
        r#"object table;
table.category <- "table";
object chair[4];
chair.category <- "chair";
assert forall c in chair: onFloor(c, room);
assert onFloor(table, room);
assert diningSet(table, chair);"#,
    ),
    (
        "display",
        r#"object case[4];
case.category <- "display case";
case.scale <- vec3(0.6,1.2,0.4);
assert (forall o in objects: onFloor(o,room)) and displayRow(case,room);"#,
    ),
    (
        "kitchen",
        r#"object unit[3];
unit.category <- "kitchen cabinet";
object stove;
stove.category <- "stove";
object fridge;
fridge.category <- "refrigerator";
assert (forall o in objects: onFloor(o,room)) and kitchenRun(objects,room);"#,
    ),
    (
        "racks",
        r#"object rack[6];
rack.category <- "storage rack";
rack.scale <- vec3(2,2,0.6);
assert (forall o in objects: onFloor(o,room)) and rackAisles(rack,1.0);"#,
    ),
    (
        "reception",
        r#"object counter;
counter.category <- "reception counter";
object chair;
chair.category <- "office chair";
counter.scale <- vec3(2,1.1,0.7);
assert (forall o in objects: onFloor(o,room)) and receptionSet(counter,chair);"#,
    ),
    (
        "rows",
        r#"object seat[12];
seat.category <- "chair";
object screen;
screen.category <- "tv stand";
assert againstWall(screen,room) and (forall o in objects: onFloor(o,room)) and rowsBefore(seat,screen);"#,
    ),
    (
        "screen",
        r#"object sofa;
sofa.category <- "sofa";
object tv;
tv.category <- "tv stand";
assert (forall o in objects: onFloor(o,room)) and screenBefore(sofa,tv);"#,
    ),
    (
        "sofa",
        r#"object sofa;
sofa.category <- "sofa";
object ct;
ct.category <- "coffee table";
object ac[2];
ac.category <- "armchair";
object tv;
tv.category <- "tv stand";
assert againstWall(sofa,room) and (forall o in objects: onFloor(o,room)) and seatingGroup(sofa,ct) and armchairsAt(ac,ct) and screenBefore(sofa,tv);"#,
    ),
    (
        "ward",
        r#"object bed;
bed.category <- "hospital bed";
object locker;
locker.category <- "bedside cabinet";
object chair;
chair.category <- "visitor chair";
locker.scale <- vec3(0.45,0.8,0.45);
assert againstWall(bed,room) and (forall o in objects: onFloor(o,room)) and wardBay(bed,locker,chair);"#,
    ),
];

#[test]
fn every_group_is_solved_from_ten_seeds() {
    let folder = tempfile::tempdir().unwrap();
    for (name, things) in GROUPS {
        let file = format!("{name}.scene");
        fs::write(folder.path().join(&file), format!("{ROOM}{things}\n")).unwrap();
        for seed in 0..10 {
            let ended = scenelang(folder.path(), ["solve", &file, "--force", "--seed", &seed.to_string()]);
            assert_eq!(ended.code, 0, "{name}, seed {seed}: {}{}", ended.stdout, ended.stderr);
        }
    }
}

#[test]
fn a_program_may_have_groups_of_its_own() {
    let folder = tempfile::tempdir().unwrap();
    let own = "object t;\nobject c[2];\npredicate diningSet(Objects s, Object b) := forall x in s: near(x, b, 0.5);\n\
               predicate balanced(Object a) := a.pos.x > 0;\nassert diningSet(c, t) and balanced(t);\n";
    fs::write(folder.path().join("own.scene"), own).unwrap();
    let ended = scenelang(folder.path(), ["check", "own.scene"]);
    assert_eq!((ended.code, ended.stdout.as_str()), (0, "own.scene: no problems found\n"));
}
