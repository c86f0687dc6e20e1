//! Every family over a grid of sizes and words: parts fill the box, meshes are closed and wound outward, things stand.

use crate::geometry::{bounds, corners, inside_hull, mass, planes, triangles, volume};
use crate::nouns::{Noun, SHAPES, families, sizes, table, usual};
use nalgebra::Matrix3;
use scenelang_assets::{Asset, AssetRequest, furnish};
use scenelang_layout::{Convex, Joint, Moving, Part, Vec3};
use std::collections::BTreeMap;

const EXTENTS: [f64; 3] = [0.05, 0.7, 5.0];

fn grid() -> impl Iterator<Item = Vec3> {
    let n = EXTENTS.len();
    (0..n * n * n).map(move |k| Vec3::new(EXTENTS[k % n], EXTENTS[k / n % n], EXTENTS[k / n / n]))
}

/// Leaves with a message unless the condition holds.
macro_rules! ensure {
    ($holds:expr, $($message:tt)*) => {
        if $holds {
        } else {
            return Err(format!($($message)*));
        }
    };
}

/// What is wrong with an asset that should fill this box.
fn check(asset: &Asset, size: Vec3) -> Result<(), String> {
    let want = (Vec3::new(-size.x / 2.0, 0.0, -size.z / 2.0), Vec3::new(size.x / 2.0, size.y, size.z / 2.0));
    let (lo, hi) = bounds(asset.parts.iter().flat_map(corners));
    ensure!((lo - want.0).amax() < 1e-6 && (hi - want.1).amax() < 1e-6, "parts fill {lo:?} {hi:?}");
    ensure!(asset.parts.len() <= 24, "{} parts", asset.parts.len());
    for part in &asset.parts {
        let (lo, hi) = bounds(corners(part));
        ensure!((hi - lo).min() > 1e-7, "a flat part {part:?}");
    }
    let (lo, hi) = asset.mesh.bounds().ok_or("no mesh")?;
    ensure!((lo - want.0).amax() < 1e-4 && (hi - want.1).amax() < 1e-4, "mesh fills {lo:?} {hi:?}");
    if let Some(surface) = asset.surface {
        ensure!(surface > 0.0 && surface < size.y, "surface at {surface}");
    }
    let mut names = Vec::new();
    for g in &asset.mesh.groups {
        ensure!(!names.contains(&&g.surface.name), "{} twice", g.surface.name);
        names.push(&g.surface.name);
        ensure!(g.positions.len() == g.normals.len() && g.indices.len() % 3 == 0, "lengths");
        ensure!(g.indices.iter().all(|i| (*i as usize) < g.positions.len()), "indices");
        ensure!(g.positions.iter().flatten().all(|c| c.is_finite()), "a position is not finite");
        for n in &g.normals {
            let length = Vec3::from(n.map(f64::from)).norm();
            ensure!((length - 1.0).abs() < 1e-4, "normal of length {length}");
        }
    }
    let count = asset.mesh.triangles();
    ensure!(count > 0 && count < 12_000, "{count} triangles");
    ensure!(volume(&asset.mesh) > 0.0, "inside out");
    for [a, b, c] in triangles(&asset.mesh) {
        ensure!((b - a).cross(&(c - a)).norm() > 0.0, "degenerate {a:?} {b:?} {c:?}");
    }
    Ok(())
}

fn report(bad: &[String]) {
    assert!(bad.is_empty(), "{} bad:\n{}", bad.len(), bad.join("\n"));
}

#[test]
fn every_family_fills_its_box_at_every_size() {
    let mut bad = Vec::new();
    for noun in families().chain(SHAPES.iter().copied()).chain(["whatever"]) {
        bad.extend(grid().find_map(|size| {
            let asset =
                furnish(&AssetRequest { name: "it", category: noun, size: Some(size), ..AssetRequest::default() });
            check(&asset, size).err().map(|e| format!("{noun} {size:?}: {e}"))
        }));
    }
    report(&bad);
}

/// Every noun of the language that is drawn is drawn at its usual size.
#[test]
fn every_noun_of_the_language_fills_its_box() {
    let mut bad = Vec::new();
    for (noun, Noun { size, .. }) in table() {
        let asset = furnish(&AssetRequest { name: "it", category: noun, size: Some(*size), ..AssetRequest::default() });
        bad.extend(check(&asset, *size).err().map(|e| format!("{noun}: {e}")));
    }
    report(&bad);
}

/// The bodies that a joint moves, and those that nothing does.
fn moving(asset: &Asset, joint: &Joint) -> (Moving, Vec<Convex>) {
    let bodies: Vec<Convex> = asset.parts.iter().map(|part| Convex::from_part(part).unwrap()).collect();
    let moved = joint.parts.iter().map(|&i| &bodies[i]);
    let moving = Moving::new(joint, moved, &Matrix3::identity(), &Vec3::zeros());
    let fixed = |i: &usize| !asset.joints.iter().any(|joint| joint.parts.contains(i));
    (moving, (0..bodies.len()).filter(fixed).map(|i| bodies[i].clone()).collect())
}

/// What opens, with how many movable parts at its usual size.
const OPENING: &[(&str, &str, usize)] = &[
    ("door", "", 1),
    ("door", "opens outward, hinged right", 1),
    ("double door", "", 2),
    ("window", "", 2),
    ("wardrobe", "", 3),
    ("cabinet", "", 2),
    ("sideboard", "", 3),
    ("kitchen cabinet", "", 1),
    ("dresser", "", 4),
    ("nightstand", "", 2),
    ("filing cabinet", "", 4),
    ("tv stand", "", 2),
    ("desk", "", 3),
    ("locker", "", 1),
    ("fridge", "", 2),
    ("oven", "", 1),
    ("stove", "", 1),
    ("dishwasher", "", 1),
    ("washing machine", "", 1),
    ("microwave", "", 1),
    ("display case", "", 1),
    ("display freezer", "", 1),
    ("toilet", "", 1),
    ("laptop", "closed", 1),
    ("treasure chest", "", 1),
];

#[test]
fn what_opens_does_not_meet_its_own_body() {
    let mut bad = Vec::new();
    for (noun, features, least) in OPENING {
        let usual = sizes().get(*noun).copied().unwrap_or(Vec3::new(0.9, 1.0, 0.5));
        let usual = if *features == "closed" { Vec3::new(0.34, 0.02, 0.24) } else { usual };
        for size in [usual, usual * 0.7, usual.component_mul(&Vec3::new(1.6, 1.2, 1.3))] {
            let asset = furnish(&AssetRequest {
                name: "it",
                category: noun,
                features,
                size: Some(size),
                ..AssetRequest::default()
            });
            bad.extend(check(&asset, size).err().map(|e| format!("{noun} {size:?}: {e}")));
            if size == usual && asset.joints.len() < *least {
                bad.push(format!("{noun} ({features}): {} parts open, not {least}", asset.joints.len()));
            }
            let mut taken = Vec::new();
            for joint in &asset.joints {
                let (moving, fixed) = moving(&asset, joint);
                assert_eq!(joint.useful.is_none(), *noun == "window", "{noun}: a family says how far");
                let useful = joint.useful.unwrap_or(90.0);
                let gap = moving.least(&fixed, useful, f64::INFINITY, &mut { 100_000 }).map_or(1.0, |swept| swept.gap);
                if gap < -1e-3 || useful > joint.limits[1] {
                    bad.push(format!("{noun} ({features}) {size:?}: {} comes {gap} near its body", joint.name));
                }
                // It goes somewhere: away from where it was, and not below the floor.
                let opened = moving.opened(useful);
                let low = opened.iter().map(|body| body.aabb().min.y).fold(f64::INFINITY, f64::min);
                if low < -1e-6 || joint.parts.iter().any(|i| taken.contains(i)) {
                    bad.push(format!("{noun} {size:?}: {} is {low} high, or moves what moves already", joint.name));
                }
                taken.extend(&joint.parts);
            }
        }
    }
    report(&bad);
}

/// Absurd sizes make absurd furniture, but no panic and no number that is none.
#[test]
fn absurd_sizes_do_no_harm() {
    for noun in families().chain(SHAPES.iter().copied()).chain(["whatever"]) {
        for size in [[1e-6; 3], [1e-3; 3], [1e5; 3], [1e5, 1e-5, 1.0], [1e-5, 1e5, 1e-5], [1.0, 1e-5, 1e5]] {
            let size = Some(Vec3::from(size));
            let asset = furnish(&AssetRequest { name: "it", category: noun, size, ..AssetRequest::default() });
            assert!(!asset.parts.is_empty(), "{noun} {size:?}");
            let numbers = asset.mesh.groups.iter().flat_map(|g| g.positions.iter().chain(&g.normals)).flatten();
            assert!(numbers.into_iter().all(|x| x.is_finite()), "{noun} {size:?}");
            assert!(asset.parts.iter().flat_map(corners).all(|p| p.iter().all(|x| x.is_finite())), "{noun} {size:?}");
        }
    }
}

/// Words that change a shape, each with a noun and a size they make sense for.
const VARIANTS: &[(&str, &str, [f64; 3])] = &[
    ("chair", "with armrests", [0.55, 0.9, 0.55]),
    ("office chair", "armless", [0.6, 1.1, 0.6]),
    ("stool", "round bar", [0.4, 0.75, 0.4]),
    ("bench", "backless", [1.4, 0.8, 0.4]),
    ("corner sofa", "", [2.8, 0.85, 1.7]),
    ("pouf", "round", [0.5, 0.4, 0.5]),
    ("round table", "", [1.2, 0.75, 1.2]),
    ("table", "oval", [2.4, 0.75, 1.1]),
    ("conference table", "", [3.6, 0.75, 1.4]),
    ("conference table", "", [1.4, 0.75, 3.6]),
    ("coffee table", "", [1.1, 0.42, 0.6]),
    ("standing desk", "", [1.6, 0.75, 0.8]),
    ("school desk", "", [0.7, 0.75, 0.5]),
    ("bar counter", "", [3.0, 1.1, 0.7]),
    ("kitchen island", "", [2.0, 0.9, 0.9]),
    ("lab bench", "", [2.0, 0.9, 0.75]),
    ("ping pong table", "", [1.52, 0.91, 2.74]),
    ("sideboard", "glass doors", [1.6, 0.8, 0.45]),
    ("filing cabinet", "", [0.45, 1.3, 0.6]),
    ("locker", "double", [0.9, 1.8, 0.5]),
    ("wall shelf", "", [0.9, 0.25, 0.25]),
    ("bookshelf", "empty", [0.9, 2.0, 0.3]),
    ("bunk bed", "", [1.0, 1.7, 2.0]),
    ("bed", "", [1.6, 1.0, 2.1]),
    ("hospital bed", "", [1.0, 1.0, 2.1]),
    ("gurney", "", [0.7, 0.85, 2.0]),
    ("lamp", "globe pendant", [0.4, 1.0, 0.4]),
    ("ceiling light", "track spots", [1.5, 0.15, 0.1]),
    ("ceiling light", "led panel", [1.2, 0.06, 0.3]),
    ("double door", "", [1.6, 2.1, 0.12]),
    ("door", "glass", [0.9, 2.05, 0.12]),
    ("emergency exit", "", [1.0, 2.1, 0.12]),
    ("curtain", "closed", [2.0, 2.4, 0.15]),
    ("railing", "", [2.0, 1.0, 0.06]),
    ("partition", "glass", [1.6, 1.8, 0.4]),
    ("safety fence", "", [2.6, 1.6, 2.4]),
    ("music stand", "", [0.5, 1.2, 0.5]),
    ("medical cart", "", [0.65, 0.95, 0.5]),
    ("wine rack", "", [1.0, 1.8, 0.35]),
    ("church organ", "", [3.0, 3.6, 1.2]),
    ("host stand", "", [0.6, 1.15, 0.45]),
    ("cauldron", "", [0.7, 0.62, 0.7]),
    ("pillar", "square", [0.4, 2.6, 0.4]),
    ("whiteboard", "on wheels", [1.5, 1.9, 0.6]),
    ("cork board", "", [0.9, 0.6, 0.03]),
    ("mirror", "round", [0.7, 0.7, 0.03]),
    ("menu board", "", [0.8, 1.0, 0.03]),
    ("rug", "round", [2.0, 0.012, 2.0]),
    ("television", "wall mounted", [1.2, 0.7, 0.08]),
    ("monitor", "", [0.6, 0.45, 0.2]),
    ("laptop", "closed", [0.34, 0.02, 0.24]),
    ("copier", "", [0.6, 1.15, 0.65]),
    ("vending machine", "", [1.0, 1.83, 0.85]),
    ("fridge", "", [0.9, 1.8, 0.7]),
    ("beverage fridge", "glass door", [0.6, 1.8, 0.6]),
    ("dishwasher", "", [0.6, 0.85, 0.6]),
    ("washbasin", "", [0.55, 1.0, 0.45]),
    ("kitchen sink", "", [1.6, 1.1, 0.6]),
    ("eyewash", "", [0.4, 1.1, 0.4]),
    ("emergency shower", "", [0.7, 2.3, 0.7]),
    ("tool cart", "", [0.7, 1.0, 0.45]),
    ("service robot", "", [0.5, 1.3, 0.5]),
    ("barrel", "", [0.6, 0.9, 0.6]),
    ("grand piano", "", [1.5, 1.0, 1.8]),
    ("recycling bin", "", [0.4, 0.7, 0.4]),
    ("wooden crate", "", [0.6, 0.4, 0.4]),
    ("tool box", "", [0.5, 0.25, 0.25]),
    ("ceiling fan", "", [1.2, 0.35, 1.2]),
    ("palm", "", [1.0, 1.9, 1.0]),
    ("snake plant", "", [0.4, 0.9, 0.4]),
    ("cactus", "", [0.3, 0.6, 0.3]),
    ("olive tree", "", [1.4, 2.4, 1.4]),
    ("bush", "flowers", [0.6, 0.9, 0.6]),
    ("flower vase", "", [0.3, 0.5, 0.3]),
    ("wine glass", "", [0.08, 0.22, 0.08]),
    ("mug", "", [0.12, 0.1, 0.085]),
    ("fruit bowl", "", [0.3, 0.12, 0.3]),
    ("books", "", [0.22, 0.12, 0.16]),
    ("grandfather clock", "", [0.5, 2.0, 0.3]),
    ("globe", "", [0.35, 0.45, 0.35]),
    ("soap dispenser", "", [0.12, 0.25, 0.1]),
];

#[test]
fn variants_fill_their_boxes_too() {
    let mut bad = Vec::new();
    for (noun, features, size) in VARIANTS {
        bad.extend([1.0, 0.37, 2.9].into_iter().find_map(|scale| {
            let size = Vec3::from(*size) * scale;
            let asset = furnish(&AssetRequest {
                name: "it",
                category: noun,
                features,
                size: Some(size),
                ..AssetRequest::default()
            });
            check(&asset, size).err().map(|e| format!("{noun} ({features}) {size:?}: {e}"))
        }));
    }
    report(&bad);
}

/// Points where an asset touches the floor.
fn contacts(asset: &Asset) -> Vec<(f64, f64)> {
    asset.parts.iter().flat_map(corners).filter(|p| p.y < 1e-6).map(|p| (p.x, p.z)).collect()
}

/// Held by a wall: these need no footing.
const HUNG: [&str; 3] = ["wall shelf", "sconce", "wall lamp"];

#[test]
fn things_stand_on_their_own() {
    let mut bad = Vec::new();
    let (sizes, hangs) =
        (sizes(), |noun: &str| table().get(noun).is_some_and(|n| ["wall", "ceiling"].contains(&n.stands)));
    let named = VARIANTS.iter().map(|(noun, features, size)| (*noun, *features, Vec3::from(*size)));
    let sized = sizes.iter().map(|(n, s)| (n.as_str(), "", *s));
    let more = more().filter(|(noun, _)| !hangs(noun)).map(|(noun, size)| (noun, "", size));
    for (noun, features, size) in named.chain(sized).chain(more).filter(|(noun, ..)| !HUNG.contains(noun)) {
        let asset = furnish(&AssetRequest {
            name: "it",
            category: noun,
            features,
            size: Some(size),
            ..AssetRequest::default()
        });
        let feet = contacts(&asset);
        let margin = 0.001_f64.max(0.03 * size.x.min(size.z));
        let masses: Vec<_> = asset.parts.iter().map(mass).collect();
        let total: f64 = masses.iter().map(|m| m.0).sum();
        let centre = masses.iter().fold(Vec3::zeros(), |sum, (v, c)| sum + c * (v / total));
        for (what, x, z) in [("middle", 0.0, 0.0), ("centre of mass", centre.x, centre.z)] {
            let within = inside_hull(&feet, (x, z));
            if within < margin {
                bad.push(format!("{noun} ({features}): the {what} is {within:.3} within the feet"));
            }
        }
    }
    report(&bad);
}

/// The planes of a part (of a hull only), and its bounds.
type Solid = (Vec<(Vec3, f64)>, Vec3, Vec3);

/// How far a point is from the nearest part.
fn distance(parts: &[Solid], p: Vec3) -> f64 {
    parts
        .iter()
        .map(|(planes, lo, hi)| {
            let out = (lo - p).sup(&(p - hi)).sup(&Vec3::zeros()).norm();
            planes.iter().map(|(n, d)| n.dot(&p) - d).fold(out, f64::max)
        })
        .fold(f64::MAX, f64::min)
}

/// The families whose own name has no usual size, and the nouns that have shapes of their own.
fn more() -> impl Iterator<Item = (&'static str, Vec3)> {
    let families = usual().values().map(|(noun, size)| (noun.as_str(), *size));
    families
        .filter(|(noun, _)| !sizes().contains_key(*noun))
        .chain(SHAPES.iter().map(|noun| (*noun, table()[*noun].size)))
}

/// What is seen is (nearly) what is touched: nothing visible sticks out of the solids by more than a few centimetres.
#[test]
fn meshes_stay_near_their_solids() {
    let mut bad = Vec::new();
    for (noun, size) in sizes().iter().map(|(noun, size)| (noun.as_str(), *size)).chain(more()) {
        let asset = furnish(&AssetRequest { name: "it", category: noun, size: Some(size), ..AssetRequest::default() });
        let solids: Vec<Solid> = asset
            .parts
            .iter()
            .map(|p| {
                let points = corners(p);
                let (lo, hi) = bounds(points.iter().copied());
                (if matches!(p, Part::Hull { .. }) { planes(&points) } else { Vec::new() }, lo, hi)
            })
            .collect();
        let points = asset.mesh.groups.iter().flat_map(|g| &g.positions).map(|p| Vec3::from(p.map(f64::from)));
        let far = points.map(|p| (distance(&solids, p), p)).max_by(|a, b| a.0.total_cmp(&b.0)).unwrap();
        if far.0 > 0.03_f64.min(0.1 * size.max()) {
            bad.push(format!("{noun}: {:?} is {:.3} out of the solids", far.1, far.0));
        }
    }
    report(&bad);
}

/// Tops and seats are level faces at the promised height, wide enough to put things on.
#[test]
fn supports_are_level() {
    for noun in [
        "table",
        "round table",
        "desk",
        "counter",
        "workbench",
        "nightstand",
        "cabinet",
        "bookshelf",
        "bed",
        "sofa",
        "chair",
        "bench",
        "cart",
        "tv stand",
        "coffee table",
        "kitchen sink",
        "platform",
        "rug",
        "fridge",
        "stool",
    ] {
        let size = sizes()[noun];
        let asset = furnish(&AssetRequest { name: "it", category: noun, size: Some(size), ..AssetRequest::default() });
        let height = asset.surface.unwrap_or(size.y);
        let area: f64 = asset
            .parts
            .iter()
            .filter_map(|p| match p {
                Part::Box { pos, size, .. } => {
                    ((pos.y + size.y / 2.0 - height).abs() < 1e-9).then_some(size.x * size.z)
                }
                Part::Cylinder { pos, radius, height: h, .. } => {
                    ((pos.y + h / 2.0 - height).abs() < 1e-9).then_some(3.1 * radius * radius)
                }
                Part::Hull { .. } => None,
            })
            .sum();
        assert!(area > 0.4 * size.x * size.z, "{noun}: {area} m² at {height}");
    }
}

/// Knees go under tables: the solids leave the space in front free, below the top.
#[test]
fn chairs_go_under_tables() {
    for (noun, features) in [
        ("table", ""),
        ("round table", ""),
        ("conference table", ""),
        ("desk", ""),
        ("standing desk", ""),
        ("student desk", ""),
    ] {
        let size = sizes()[noun];
        let asset = furnish(&AssetRequest {
            name: "it",
            category: noun,
            features,
            size: Some(size),
            ..AssetRequest::default()
        });
        // A person in front, 0.45 wide, knees 0.25 under the top; a desk with drawers seats them left of the middle.
        let x = if noun == "desk" { -0.15 } else { 0.0 };
        let (lo, hi) = (Vec3::new(x - 0.22, 0.05, size.z / 2.0 - 0.25), Vec3::new(x + 0.22, 0.64, size.z / 2.0));
        for part in &asset.parts {
            let (a, b) = bounds(corners(part));
            let free = (0..3).any(|i| b[i] <= lo[i] || a[i] >= hi[i]);
            assert!(free, "{noun}: {part:?} is where knees are");
        }
    }
}

#[test]
fn the_same_request_gives_the_same_asset_and_names_vary_it() {
    let make = |name| {
        let r = AssetRequest {
            name,
            category: "bookshelf",
            size: Some(Vec3::new(1.0, 2.0, 0.3)),
            ..AssetRequest::default()
        };
        furnish(&r).mesh
    };
    assert_eq!(make("a"), make("a"));
    assert_ne!(make("a"), make("b"));
    let chair = |name| furnish(&AssetRequest { name, category: "chair", ..AssetRequest::default() }).mesh;
    assert_eq!(chair("chair[0]"), chair("chair[1]"), "chairs of a set are alike");
}

#[test]
fn colours_and_materials_are_as_asked() {
    let share = |category, color, material, want: [f32; 3]| {
        let asset = furnish(&AssetRequest { name: "it", category, color, material, ..AssetRequest::default() });
        let mut area: BTreeMap<bool, f64> = BTreeMap::new();
        for g in &asset.mesh.groups {
            let hit = g.surface.color.iter().zip(want).all(|(a, b)| (a - b).abs() < 0.01);
            let one = scenelang_assets::Mesh::from(vec![g.clone()]);
            *area.entry(hit).or_default() +=
                triangles(&one).map(|[a, b, c]| (b - a).cross(&(c - a)).norm()).sum::<f64>();
        }
        area.get(&true).copied().unwrap_or(0.0) / area.values().sum::<f64>()
    };
    let hex = |v: u32| [v >> 16, v >> 8, v].map(|c| (c & 0xff) as f32 / 255.0);
    for noun in
        ["table", "chair", "sofa", "cabinet", "wardrobe", "rug", "bed", "door", "lamp", "box", "bin", "whatever"]
    {
        assert!(share(noun, "#2a6f97", "", hex(0x2a6f97)) > 0.05, "{noun}");
    }
    assert!(share("table", "", "walnut", hex(0x74503a)) > 0.5);
    let glass = furnish(&AssetRequest { category: "table", material: "glass", ..AssetRequest::default() });
    assert!(glass.mesh.groups[0].surface.opacity < 0.5);
    let lamp = furnish(&AssetRequest {
        category: "floor lamp",
        size: Some(Vec3::new(0.4, 1.6, 0.4)),
        ..AssetRequest::default()
    });
    assert!(lamp.mesh.groups.iter().any(|g| g.surface.emissive.is_some()));
}

#[test]
fn the_unknown_is_a_labelled_box() {
    let asset = furnish(&AssetRequest { name: "thing", category: "flux capacitor", ..AssetRequest::default() });
    assert_eq!((asset.family, asset.known, asset.label.as_str()), ("unknown", false, "flux capacitor"));
    assert_eq!((asset.size, asset.parts.len()), (Vec3::repeat(0.5), 1));
    let nameless = furnish(&AssetRequest { size: Some(Vec3::new(f64::NAN, 1.0, 1.0)), ..AssetRequest::default() });
    assert_eq!((nameless.label.as_str(), nameless.size), ("object", Vec3::repeat(0.5)));
}
