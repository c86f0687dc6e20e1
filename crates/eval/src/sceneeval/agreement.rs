//! Scores of boxes are those of SceneEval's own geometry code, where a copy of it is (`SCENELANG_SCENEEVAL`: the folder of its repository).

use super::places::RoomRelation;
use super::relations::{Relation, Thresholds, surround};
use super::scene::ScoredRoom;
use super::shape::Shape;
use scenelang_layout::{Placement, Polygon, Vec3};
use serde_json::{Value, json};
use std::io::Write;
use std::path::Path;
use std::process::{Command, Stdio};

/// How far a score may be off.
const CLOSE: f64 = 1e-3;
/// Cases of each kind.
const CASES: usize = 40;
const HEIGHT: f64 = 2.6;
/// An L: the corner at 1 | 0.5 points inwards.
const OUTLINE: [[f64; 2]; 6] = [[-3.0, -2.5], [3.0, -2.5], [3.0, 0.5], [1.0, 0.5], [1.0, 2.5], [-3.0, 2.5]];

/// Numbers that are the same each time.
struct Dice(u64);

impl Dice {
    fn between(&mut self, low: f64, high: f64) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        low + (high - low) * (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }

    /// A box within so many metres of the origin along x and z; a third of them are square to the room.
    fn placement(&mut self, reach: [f64; 2], highest: f64) -> Placement {
        let mut at = |reach: f64| self.between(-reach, reach);
        let (x, z) = (at(reach[0]), at(reach[1]));
        let scale = Vec3::new(self.between(0.3, 1.8), self.between(0.1, 1.2), self.between(0.3, 1.2));
        let turn = self.between(-270.0, 270.0);
        let yaw = if turn.abs() < 90.0 { (turn / 90.0).round() * 90.0 } else { turn };
        let pos = Vec3::new(x, self.between(0.0, highest).max(0.0), z);
        Placement { pos, rot: Vec3::new(0.0, yaw, 0.0), scale, parts: Vec::new(), surface: None, joints: Vec::new() }
    }
}

fn told(boxes: &[Placement]) -> Value {
    let one = |b: &Placement| json!({ "pos": b.pos.as_slice(), "scale": b.scale.as_slice(), "yaw": b.rot.y });
    boxes.iter().map(one).collect()
}

/// What is asked of the other code, and our scores.
type Cases = Vec<(Value, Vec<f64>)>;

/// Pairs of objects; those that are all round one.
fn between(dice: &mut Dice) -> Cases {
    let relations: Vec<Relation> = Relation::ALL.into_iter().filter(|r| *r != Relation::Surround).collect();
    let mut out = Vec::new();
    for number in 0..CASES {
        // Some far apart, some inside each other.
        let reach = [0.4, 1.5, 3.0, 5.0][number % 4];
        let boxes = [dice.placement([0.0, 0.0], 0.3), dice.placement([reach, reach], 0.8)];
        let [reference, target] = [&boxes[0], &boxes[1]].map(Shape::new);
        let inside = reference.share_inside(&target) > 0.0;
        let meant = |r: &&Relation| match r {
            // What is lower is not on a thing here, and half of it at most is there.
            Relation::OnTop => target.obb.center.y > reference.obb.center.y,
            // Of what is inside each other it depends on which points are drawn.
            Relation::Near | Relation::Facing => !inside,
            _ => true,
        };
        let asked: Vec<&Relation> = relations.iter().filter(meant).collect();
        let own = asked.iter().map(|r| r.score(&target, &reference, &Thresholds::PUBLISHED)).collect();
        let names: Vec<&str> = asked.iter().map(|r| r.name()).collect();
        out.push((json!({ "boxes": told(&boxes), "relations": names }), own));

        let boxes: Vec<Placement> = (0..4 + number % 3).map(|_| dice.placement([2.0, 2.0], 0.4)).collect();
        let shapes: Vec<Shape> = boxes.iter().map(Shape::new).collect();
        let own = vec![surround(&shapes[1..].iter().collect::<Vec<_>>(), &shapes[0])];
        out.push((json!({ "boxes": told(&boxes), "relations": ["surround"] }), own));
    }
    out
}

/// Objects in a room, and a door on one of its walls.
fn within(dice: &mut Dice) -> Cases {
    let room = ScoredRoom::with(Polygon::new(&OUTLINE).unwrap(), 0.0, HEIGHT);
    // The original has no relation of these.
    let own = [RoomRelation::Floor, RoomRelation::BelowOpening];
    let relations: Vec<RoomRelation> = RoomRelation::ALL.into_iter().filter(|r| !own.contains(r)).collect();
    let names: Vec<&str> = relations.iter().map(|r| r.name()).collect();
    let mut out = Vec::new();
    for number in 0..CASES {
        let mut thing = dice.placement([3.0, 2.5], 0.5);
        match number % 4 {
            // Flush with a wall, or below the ceiling.
            0 => (thing.pos.z, thing.rot.y) = (-2.5 + thing.scale.z / 2.0 + dice.between(0.0, 0.02), 0.0),
            1 => (thing.pos.x, thing.rot.y) = (3.0 - thing.scale.x / 2.0 - dice.between(0.0, 0.5), 0.0),
            2 => thing.pos.y = HEIGHT - thing.scale.y - dice.between(0.0, 0.05),
            _ => {}
        }
        let mut door = dice.placement([0.5, 0.0], 0.0);
        (door.scale, door.rot.y, door.pos.z) = (Vec3::new(0.9, 2.0, 0.06), 0.0, -2.53);
        let boxes = [thing, door];
        let [thing, door] = [&boxes[0], &boxes[1]].map(Shape::new);
        let score = |r: &RoomRelation| r.score(&thing, std::slice::from_ref(&room), &[&door], &Thresholds::PUBLISHED);
        let asked = json!({
            "boxes": told(&boxes), "relations": names, "room": { "outline": OUTLINE, "height": HEIGHT },
        });
        out.push((asked, relations.iter().map(score).collect()));
    }
    out
}

#[test]
fn scores_are_those_of_the_benchmarks_own_code() {
    let Some(checkout) = std::env::var_os("SCENELANG_SCENEEVAL") else {
        return eprintln!("skipped: SCENELANG_SCENEEVAL does not say where a copy of the benchmark's repository is");
    };
    let mut dice = Dice(5);
    let cases: Cases = between(&mut dice).into_iter().chain(within(&mut dice)).collect();
    let oracle = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/oracles/sceneeval.py");
    let python = std::env::var_os("SCENELANG_PYTHON").unwrap_or_else(|| "python3".into());
    let mut child = Command::new(python)
        .arg("-B")
        .args([oracle.as_os_str(), &checkout])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .expect("python starts");
    let lines: String = cases.iter().map(|(asked, _)| format!("{asked}\n")).collect();
    let mut input = child.stdin.take().unwrap();
    let feed = std::thread::spawn(move || input.write_all(lines.as_bytes()));
    let output = child.wait_with_output().unwrap();
    feed.join().unwrap().unwrap();
    assert!(output.status.success());
    let text = String::from_utf8(output.stdout).unwrap();
    let others: Vec<Vec<f64>> = text.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    assert_eq!(others.len(), cases.len());
    let (mut wrong, mut some) = (Vec::new(), 0);
    for ((asked, own), other) in cases.iter().zip(&others) {
        assert_eq!(own.len(), other.len());
        for (i, (a, b)) in own.iter().zip(other).enumerate() {
            some += usize::from(*b > 0.01 && *b < 0.99);
            if (a - b).abs() > CLOSE {
                wrong.push(format!("{} {a:.4} is not {b:.4}: {}", asked["relations"][i], asked["boxes"]));
            }
        }
    }
    assert!(some > CASES, "{some} of the scores say something");
    assert!(wrong.is_empty(), "{} differ:\n{}", wrong.len(), wrong.join("\n"));
}
