//! What is judged again when an object moves: the verdict is that of judging everything, and so it is after the move is
//! taken back.

use crate::given::{judged, layout};
use scenelang_engine::{Batch, Live};
use scenelang_lang::compile_text;
use scenelang_lang::program::{ObjectId, Program};
use scenelang_layout::{Joint, Layout, Motion, Part, Placement, Vec3};
use scenelang_verify::{CheckVerdict, Detail, Explain, Opens, Options, check};
use std::path::Path;

const WORKSHOP: &str = include_str!("../../../../examples/workshop-safety.scene");
const BLOCKED: &str = include_str!("workshop-blocked.txt");

/// Everything that a move may or may not change: pairs, sides, supports, ways, sights, free space, mounts, doors,
/// containers, quantifiers, preferences, values that cannot be judged.
const ROOM: &str = r#"
region room;
region hall;
object table; object lamp; object chair[4]; object shelf; object box; object apple; object clock; object door; object sign;
assert forall c in chair: near(c, table, 0.6) or gap(c, shelf) > 0.2;
assert count(c in chair: c.pos.x > 0) >= 1;
assert on(lamp, table);
assert inside(apple, box);
assert wallMounted(clock, room);
assert connects(door, room, hall);
assert clear(shelf, front, 0.8);
assert visible(chair[0], clock);
assert reachable(chair[1], door, 0.6);
assert walkDistance(chair[2], shelf) <= 6;
assert not collides(chair[0], chair[1]);
assert 1 / (chair[3].pos.x - lamp.pos.x) < 100;
assert 1 / (chair[3].pos.x - chair[3].pos.x) < 100;
assert leftOf(shelf, table) implies facing(chair[2], table);
assert abs(table.pos.x - room.center.x) < 0.5;
assert forall i in 0..4: forall j in 0..4: i < j implies gap(chair[i], chair[j]) >= 0.2;
assert forall i in 0..4: forall j in 0..4: i >= j or not collides(chair[i], chair[j]) or gap(chair[j], box) < 1;
allowOutside(sign);
allowCollide(chair[2], table);
prefer chair[3].rot.y = 90 weight 3;
prefer distance(lamp, sign) > 2;
"#;

/// A small generator (xorshift), so that the rooms are the same everywhere.
struct Dice(u64);

impl Dice {
    fn unit(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }
}

/// A verdict as text, to the last digit.
fn said(verdict: &CheckVerdict) -> String {
    format!("{:#?}", (&verdict.rows, &verdict.summary, &verdict.diagnostics))
}

/// The margins and verdicts of the statements of a layout, of which `batch` has judged others before.
fn same_margins(program: &Program, batch: &mut Batch<'_>, layout: &Layout, options: &Options) {
    for (index, object) in program.objects.iter().enumerate() {
        if let Some(placed) = layout.object(&object.name) {
            batch.put(ObjectId(index as u32), placed.pos, placed.rot);
        }
    }
    let rows = check(program, layout, options).rows;
    let mut stated = rows.iter().filter(|row| row.kind.rule().is_none());
    for (index, truth) in batch.judge().enumerate() {
        let row = stated.next().expect("a row for each statement");
        let margin = truth.filter(|truth| truth.margin.is_finite()).map(|truth| truth.margin.to_bits());
        assert_eq!(margin, row.margin.map(|(margin, _)| margin.to_bits()), "statement {index}: {}", row.text);
        assert_eq!(truth.map(|truth| truth.holds), row.satisfied, "statement {index}: {}", row.text);
    }
    assert!(stated.next().is_none());
}

/// Makes a thing of a body and a leaf before it, which opens to its front.
fn hinge(thing: &mut Placement) {
    let [w, h, d] = thing.scale.into();
    let slab = |z: f64, deep: f64| Part::Box {
        pos: Vec3::new(0.0, h / 2.0, z),
        size: Vec3::new(w, h, deep),
        rot: Vec3::zeros(),
    };
    thing.parts = vec![slab(-d / 4.0, d / 2.0), slab(d / 4.0, d / 2.0)];
    thing.joints = vec![Joint {
        name: "leaf".into(),
        motion: Motion::Hinge,
        axis: -Vec3::y(),
        anchor: Vec3::new(-w / 2.0, 0.0, d / 2.0),
        limits: [0.0, 110.0],
        useful: Some(90.0),
        handle: None,
        parts: vec![1],
    }];
}

fn follow(scene: &str, mut layout: Layout, moves: usize, dice: &mut Dice) {
    let compiled = compile_text("room.scene", Path::new("room.scene"), scene, scenelang_lang::Options::default());
    let program = compiled.program.unwrap_or_else(|| panic!("{:?}", compiled.diagnostics));
    let detail = Detail { explain: Explain::First(0), ..Detail::default() };
    let options = Options { detail, opens: Opens::All, ..Options::default() };
    let mut live = Live::new(&program, &layout, &options);
    let mut batch = Batch::new(&program, &layout, &options);
    let mut home = said(&live.verdict());
    assert_eq!(home, said(&check(&program, &layout, &options)));
    let mut kept = layout.clone();
    let names: Vec<_> = layout.objects.iter().map(|(name, _)| name.clone()).collect();
    for _ in 0..moves {
        let name = &names[(dice.unit() * names.len() as f64) as usize];
        let place = &mut layout.objects.iter_mut().find(|(n, _)| n == name).unwrap().1;
        // A nudge, a leap, onto something, a turn.
        match (dice.unit() * 4.0) as u32 {
            0 => place.pos += Vec3::new(0.2 * dice.unit() - 0.1, 0.0, 0.2 * dice.unit() - 0.1),
            1 => place.pos = Vec3::new(6.0 * dice.unit() - 3.0, 0.0, 5.0 * dice.unit() - 2.5),
            2 => place.pos.y = [0.0, 0.75, 0.3, 1.8][(dice.unit() * 4.0) as usize],
            _ => place.rot.y = (dice.unit() * 8.0).floor() * 45.0,
        }
        let (pos, rot) = (place.pos, place.rot);
        let id = program.objects.iter().position(|o| o.name == *name).unwrap();
        assert!(live.place(ObjectId(id as u32), pos, rot) > 0);
        let now = said(&live.verdict());
        same_margins(&program, &mut batch, &layout, &options);
        assert_eq!(now, said(&check(&program, &layout, &options)), "after {name} went to {pos:?}");
        match (dice.unit() * 5.0) as u32 {
            0 => {
                live.keep();
                (home, kept) = (now, layout.clone());
            }
            1 => {
                live.undo();
                assert_eq!(said(&live.verdict()), home, "after {name} went back");
                layout = kept.clone();
            }
            _ => {}
        }
    }
    live.undo();
    assert_eq!(said(&live.verdict()), home);
    assert_eq!(live.undo(), 0, "nothing has moved");
}

/// A layout with places only, as the solver would give it.
fn placed(scene: &str, short: &str) -> Layout {
    judged(scene, &layout(short), &Options::default()).layout.expect("it can be read")
}

#[test]
fn a_verdict_follows_what_moves() {
    let mut dice = Dice(3);
    let mut text = "region room 0 0 0 | 6 2.6 5\nregion hall 0 0 5.06 | 6 2.6 5\n".to_owned();
    text += "object table 0 0 0 | 1.4 0.75 0.8\nobject lamp 0 0.75 0 | 0.2 0.4 0.2\nobject shelf 2 0 2 | 1 1.8 0.4\n";
    text += "object box -2 0 2 | 0.5 0.5 0.5\nobject apple -2 0.1 2 | 0.1 0.1 0.1\nobject clock 0 1.8 -2.47 | 0.3 0.3 0.06\n";
    text += "object door 1 0 2.53 | 0.9 2.1 0.06\nobject sign 4 0 0 | 0.5 1 0.1\n";
    for i in 0..4 {
        text += &format!("object chair[{i}] {} 0 {} | 0.45 0.9 0.45\n", i as f64 - 1.5, -1.2);
    }
    follow(ROOM, placed(ROOM, &text), 100, &mut dice);
    // The door and the shelf open.
    let mut opening = placed(ROOM, &text);
    for (_, thing) in opening.objects.iter_mut().filter(|(name, _)| ["door", "shelf"].contains(&name.as_str())) {
        hinge(thing);
    }
    follow(ROOM, opening, 100, &mut dice);
    // Something is missing: what it could make hold cannot be judged.
    let without: String = text.lines().filter(|l| !l.contains("shelf")).map(|l| format!("{l}\n")).collect();
    follow(ROOM, placed(ROOM, &without), 40, &mut dice);
    follow(WORKSHOP, placed(WORKSHOP, BLOCKED), 10, &mut dice);
}

#[test]
fn what_is_not_there_cannot_be_moved() {
    let scene = "object a; object b; assert a.pos.x > 0;";
    let compiled = compile_text("room.scene", Path::new("room.scene"), scene, scenelang_lang::Options::default());
    let program = compiled.program.unwrap();
    let mut live = Live::new(&program, &placed(scene, "object a 1 0 0"), &Options::default());
    assert_eq!(live.place(ObjectId(1), Vec3::zeros(), Vec3::zeros()), 0);
}
