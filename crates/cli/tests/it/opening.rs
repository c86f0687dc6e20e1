//! What is claimed of doors, drawers and lids in rooms with things planted before them, against MuJoCo and a sampled sweep
//! (`tests/oracles/opening.py`), which know the layout and no code of ours.
//!
//! `SCENELANG_ROOMS=300` judges as many rooms as the figures in the book are about.

use crate::hostile::Dice;
use crate::support::{python, run, skip};
use scenelang_assets::{AssetRequest, furnish};
use scenelang_base::FileId;
use scenelang_lang::library::usual_size;
use scenelang_lang::{Program, compile_text};
use scenelang_layout::convex::{aabb, separation};
use scenelang_layout::{Convex, Joint, Layout, Moving, Part, Placement, RegionPlacement, Vec3, file, rotation};
use scenelang_verify::check::Subject;
use scenelang_verify::{DEFAULT_ETA, Detail, Explain, Opens, Options, Tolerances, World, check, opening};
use serde_json::{Value, json};
use std::path::Path;
use std::process::Command;

/// Rooms in a usual run of the tests, for each of the two tolerances.
const ROOMS: usize = 12;
/// Furniture with movable parts, as programs say it.
const FURNITURE: [(&str, &str); 18] = [
    ("wardrobe", ""),
    ("cabinet", ""),
    ("sideboard", ""),
    ("kitchen cabinet", ""),
    ("dresser", ""),
    ("nightstand", ""),
    ("filing cabinet", ""),
    ("tv stand", ""),
    ("desk", ""),
    ("locker", ""),
    ("fridge", ""),
    ("oven", ""),
    ("dishwasher", ""),
    ("washing machine", ""),
    ("microwave", ""),
    ("display case", ""),
    ("toilet", ""),
    ("treasure chest", ""),
];
const DOORS: [(&str, &str); 5] = [
    ("door", ""),
    ("door", "hinged right"),
    ("door", "opens outward"),
    ("door", "opens outward, hinged right"),
    ("double door", ""),
];
/// What is planted: boxes, posts, and things that people push aside.
const PLANTED: [&str; 4] = ["crate", "crate", "post", "chair"];
/// What is planted stands at least so far from what it is planted before (metres).
const APART: f64 = 2e-3;

/// Random numbers are as fine as this.
const FINE: usize = 1 << 40;

/// Random numbers in a range.
fn between(dice: &mut Dice, from: f64, to: f64) -> f64 {
    from + (to - from) * dice.below(FINE) as f64 / FINE as f64
}

fn pick<T: Copy>(dice: &mut Dice, list: &[T]) -> T {
    list[dice.below(list.len())]
}

/// A room, and what its program says of it.
struct Room {
    text: String,
    layout: Layout,
    outward: bool,
    light: Vec<String>,
}

/// Furniture as the library makes it, as large as something of it opens.
fn made(dice: &mut Dice, (category, features): (&str, &str), factor: f64) -> Placement {
    let usual = usual_size(category).map_or(Vec3::new(0.6, 0.9, 0.5), Vec3::from);
    for _ in 0..100 {
        let size = usual.map(|extent| extent * between(dice, 1.0 - factor, 1.0 + factor));
        let asset =
            furnish(&AssetRequest { name: "it", category, features, size: Some(size), ..AssetRequest::default() });
        if !asset.joints.is_empty() {
            let (pos, rot) = (Vec3::zeros(), Vec3::zeros());
            return Placement {
                pos,
                rot,
                scale: size,
                parts: asset.parts,
                surface: asset.surface,
                joints: asset.joints,
            };
        }
    }
    panic!("{category} ({features}) has nothing that opens");
}

/// Something in the way: a box or an upright post.
fn planted(dice: &mut Dice, kind: &str) -> Placement {
    let mut size = Vec3::new(between(dice, 0.05, 0.7), between(dice, 0.2, 1.9), between(dice, 0.05, 0.7));
    let mut parts = Vec::new();
    if kind == "post" {
        size.z = size.x.min(0.3);
        size.x = size.z;
        let (pos, rot) = (Vec3::new(0.0, size.y / 2.0, 0.0), Vec3::zeros());
        parts.push(Part::Cylinder { pos, radius: size.x / 2.0, height: size.y, rot });
    }
    let rot = Vec3::new(0.0, between(dice, -180.0, 180.0), 0.0);
    Placement { pos: Vec3::zeros(), rot, scale: size, parts, surface: None, joints: Vec::new() }
}

/// The convex solid of an object in the world.
fn solid(of: &Placement) -> Vec<Convex> {
    let axes = rotation::matrix(of.rot);
    let whole = [Part::Box { pos: Vec3::new(0.0, of.scale.y / 2.0, 0.0), size: of.scale, rot: Vec3::zeros() }];
    let parts = if of.parts.is_empty() { &whole[..] } else { &of.parts };
    parts.iter().filter_map(Convex::from_part).map(|part| part.moved(&axes, &of.pos)).collect()
}

/// Puts a thing before a joint: as far from all that the joint sweeps as `gap` says, somewhere around it and in nothing that
/// is there already. Whether there was such a place.
fn plant(dice: &mut Dice, owner: &Placement, joint: &Joint, gap: f64, there: &[Convex], thing: &mut Placement) -> bool {
    let own: Vec<Convex> = joint.parts.iter().filter_map(|&i| Convex::from_part(&owner.parts[i])).collect();
    let moving = Moving::new(joint, own.iter(), &rotation::matrix(owner.rot), &owner.pos);
    let useful = joint.useful.expect("the library says how far");
    let around = moving.around(useful);
    let middle = (around.min + around.max) / 2.0;
    let base = if dice.below(3) == 0 { between(dice, 0.0, middle.y) } else { 0.0 };
    for _ in 0..60 {
        let angle = between(dice, 0.0, 360.0).to_radians();
        let way = Vec3::new(angle.sin(), 0.0, angle.cos());
        let aside = Vec3::new(way.z, 0.0, -way.x) * between(dice, -0.4, 0.4);
        let mut at = |distance: f64| {
            let place = middle + aside + way * distance;
            thing.pos = Vec3::new(place.x, base, place.z);
            let solid = solid(thing);
            let least = moving.least(&solid, useful, f64::INFINITY, &mut 50_000).map_or(f64::INFINITY, |s| s.gap);
            let clear = there.iter().all(|a| solid.iter().all(|b| separation(a, b).gap > APART));
            (least, clear)
        };
        let (mut near, mut far) = (0.0, 4.0);
        for _ in 0..30 {
            let middle = (near + far) / 2.0;
            if at(middle).0 < gap { near = middle } else { far = middle }
        }
        let (least, clear) = at(far);
        if clear && (least - gap).abs() < 2e-3 {
            return true;
        }
    }
    false
}

/// A room with a door or without, two pieces of furniture that open, and things planted before them: most within two
/// centimetres of where they begin to be in the way, the others anywhere near.
fn room(dice: &mut Dice) -> Room {
    let (w, d) = (between(dice, 3.0, 6.0), between(dice, 3.0, 6.0));
    let corner = dice.below(4) == 0;
    let middle = Vec3::new(between(dice, -9.0, 9.0), 0.0, between(dice, -9.0, 9.0));
    let region = RegionPlacement {
        pos: middle,
        rot: Vec3::zeros(),
        scale: Vec3::new(w, 2.6, d),
        vertices: corner.then(|| {
            let l = [[-0.5, -0.5], [0.5, -0.5], [0.5, 0.1], [0.15, 0.1], [0.15, 0.5], [-0.5, 0.5]];
            l.map(|[x, z]| [middle.x + w * x, middle.z + d * z]).to_vec()
        }),
    };
    let mut room = Room { text: "region room;\n".into(), layout: Layout::default(), outward: false, light: Vec::new() };
    let mut owners = Vec::new();
    if !dice.below(3) == 0 {
        let kind = pick(dice, &DOORS);
        let mut door = made(dice, kind, 0.1);
        room.outward = kind.1.contains("outward");
        door.pos = middle + Vec3::new(between(dice, -0.5, 0.5) * (w - door.scale.x), 0.0, -d / 2.0 - 0.015);
        room.text += "object door;\nassert connects(door, room);\n";
        owners.push("door".to_owned());
        room.layout.objects.push(("door".into(), door));
    }
    for i in 0..2 {
        let (name, kind) = (format!("thing_{i}"), pick(dice, &FURNITURE));
        let mut thing = made(dice, kind, 0.3);
        let stands = (0..200).any(|_| {
            thing.pos = middle + Vec3::new(between(dice, -0.5, 0.1) * w, 0.0, between(dice, -0.5, 0.1) * d);
            thing.rot.y = if dice.below(3) == 0 { 90.0 * dice.below(4) as f64 } else { between(dice, -180.0, 180.0) };
            let whole = aabb(&solid(&thing));
            let [low, high] = [whole.min - middle, whole.max - middle];
            let [right, back] = if corner { [0.15 * w, 0.1 * d] } else { [0.5 * w, 0.5 * d] };
            let inside = low.x >= -0.5 * w && low.z >= -0.5 * d && high.x <= right && high.z <= back;
            let apart = |(_, other): &(_, Placement)| aabb(&solid(other)).distance(&whole) > 0.01;
            inside && room.layout.objects.iter().all(apart)
        });
        if !stands {
            continue;
        }
        room.text += &format!("object {name};\n{name}.category <- \"{}\";\n", kind.0);
        owners.push(name.clone());
        room.layout.objects.push((name.into(), thing));
    }
    for (i, owner) in owners.iter().enumerate() {
        let (name, kind) = (format!("planted_{i}"), pick(dice, &PLANTED));
        let owner = room.layout.object(owner).expect("it was put there").clone();
        let joint = owner.joints[dice.below(owner.joints.len())].clone();
        let gap = if dice.below(5) == 0 { between(dice, -0.3, 0.3) } else { between(dice, -0.02, 0.02) };
        let mut thing = planted(dice, kind);
        // Their boxes: what is within the box of furniture is in it, and goes along.
        let whole = |(_, other): &(_, Placement)| solid(&Placement { parts: Vec::new(), ..other.clone() });
        let there: Vec<Convex> = room.layout.objects.iter().flat_map(whole).collect();
        if !plant(dice, &owner, &joint, gap, &there, &mut thing) {
            continue;
        }
        room.text += &format!("object {name};\n{name}.category <- \"{kind}\";\n");
        if kind == "chair" {
            room.light.push(name.clone());
        }
        room.layout.objects.push((name.into(), thing));
    }
    room.layout.regions.push(("room".into(), region));
    room
}

/// What is claimed of a room, for the judges.
fn claims(room: &Room, program: &Program, layout: &Layout, options: &Options) -> Vec<Value> {
    let world = World::<f64>::new(program, layout, options);
    let rows = check(program, layout, options).rows;
    let mut out = Vec::new();
    for row in rows {
        let Subject::Part(id, part) = row.subject else { continue };
        let name = program.objects[id.0 as usize].name.as_str();
        let joint = &layout.object(name).expect("it is judged").joints[usize::from(part)];
        let (free, met) =
            opening::free(&world, id, usize::from(part), joint.limits[1], &mut { opening::LOOKS }).unwrap();
        assert_eq!(met.is_none(), free == joint.limits[1], "{name}: {free} {met:?}");
        let is_door = name == "door";
        let ignored = if is_door { &[][..] } else { &room.light };
        // The walls around furniture, and those of the room that a door opens into.
        let walls = (!is_door || !room.outward).then_some("room");
        out.push(json!({
            "object": name,
            "joint": joint.name.as_str(),
            "free": free,
            "opens": row.satisfied.expect("it can be judged"),
            "walls": walls,
            "ignored": ignored,
        }));
    }
    out
}

/// How many rooms are judged.
fn rooms() -> usize {
    std::env::var("SCENELANG_ROOMS").ok().and_then(|n| n.parse().ok()).unwrap_or(ROOMS)
}

/// Rooms with this tolerance of contact, judged; what the judges say.
fn judged(python: &Path, contact: f64, seed: u64) -> Value {
    let folder = tempfile::tempdir().unwrap();
    let detail = Detail { all: true, explain: Explain::First(0), ..Detail::default() };
    let tolerances = Tolerances { contact, ..Tolerances::default() };
    let options = Options { opens: Opens::All, detail, tolerances, ..Options::default() };
    let mut dice = Dice(seed);
    let mut cases = Vec::new();
    for i in 0..rooms() {
        let room = room(&mut dice);
        let compiled =
            compile_text("room.scene", Path::new("room.scene"), &room.text, scenelang_lang::Options::default());
        let program = compiled.program.unwrap_or_else(|| panic!("{:?}", compiled.diagnostics));
        // What is claimed is claimed of the file, as the judges read it.
        let text = file::to_json(&room.layout, None);
        let layout = file::read(&text, FileId(0)).layout;
        let name = format!("{i:03}.layout.json");
        std::fs::write(folder.path().join(&name), text).unwrap();
        let claims = claims(&room, &program, &layout, &options);
        cases.push(json!({ "layout": name, "eta": DEFAULT_ETA, "contact": contact, "slack": tolerances.door,
                           "doors": ["door"], "claims": claims }));
    }
    let path = folder.path().join("cases.json");
    std::fs::write(&path, Value::from(cases).to_string()).unwrap();
    let script = crate::checkers::oracle("opening.py");
    let ended = run(Command::new(python).arg(script).arg(path), b"");
    println!("{}", ended.stdout.trim());
    assert!(ended.code < 2, "{}", ended.stderr);
    serde_json::from_str(&ended.stdout).unwrap()
}

#[test]
fn what_is_claimed_of_joints_is_what_an_engine_and_samples_meet() {
    let Some(python) = python() else { return skip("joints not driven by MuJoCo: no .venv") };
    // With the usual tolerance, and with none: then the first touch is what counts.
    for (contact, seed) in [(Tolerances::default().contact, 18), (0.0, 1800)] {
        let said = judged(&python, contact, seed);
        let wrong = said["wrong"].as_array().unwrap();
        assert!(wrong.is_empty(), "contact {contact}: {} wrong:\n{wrong:#?}", wrong.len());
        let count = |what: &str| said[what].as_u64().unwrap();
        assert_eq!((count("cases"), count("missed")), (rooms() as u64, 0));
        // Both verdicts are there, and what is hard to judge.
        let (joints, blocked, near) = (count("joints"), count("blocked"), count("near"));
        assert!(blocked > 0 && blocked < joints && 5 * near > count("cases"), "{said}");
    }
}
