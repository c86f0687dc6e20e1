//! All overlapping pairs of turned boxes, side by side with other people's libraries on the same boxes: `./x peers`
//! installs those, `./x bench overlap` shows the table. Those of Python are left out where they are not installed.

use parry3d_f64::bounding_volume::Aabb as ParryAabb;
use parry3d_f64::partitioning::{Bvh, BvhBuildStrategy, BvhWorkspace};
use scenelang_layout::obb::apart;
use scenelang_layout::{Obb, Placement, Vec3, broad};
use serde_json::{Value, json};
use std::hint::black_box;
use std::io::Write;
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::Instant;

/// Overlaps of no more than this are none (metres).
const TOLERANCE: f64 = 1e-3;

/// Numbers in [0, 1), the same on every machine.
fn random() -> impl FnMut() -> f64 {
    let mut state = 7u64;
    move || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1u64 << 53) as f64
    }
}

/// Furniture-sized boxes, turned about all axes, on a square floor: each overlaps about one other.
fn boxes(n: usize) -> Vec<Obb> {
    let mut r = random();
    let side = 1.6 * (n as f64).sqrt();
    let mut one = || {
        let pos = Vec3::new(side * r(), 1.5 * r(), side * r());
        let rot = Vec3::new(20.0 * r(), 360.0 * r(), 20.0 * r());
        let scale = Vec3::new(0.3 + r(), 0.3 + r(), 0.3 + r());
        Obb::from_placement(&Placement { pos, rot, scale, parts: Vec::new(), surface: None, joints: Vec::new() })
    };
    (0..n).map(|_| one()).collect()
}

/// The best time of some runs, and what they found.
fn best<T>(mut run: impl FnMut() -> T) -> (f64, T) {
    let mut times = Vec::new();
    let mut found = None;
    for _ in 0..15 {
        let start = Instant::now();
        found = Some(black_box(run()));
        times.push(start.elapsed().as_secs_f64() * 1e3);
    }
    (times.into_iter().fold(f64::INFINITY, f64::min), found.expect("ran more than once"))
}

/// The floor: parry's tree, then the separating axes.
fn bare_tree(boxes: &[Obb]) -> usize {
    let vector = |v: Vec3| parry3d_f64::math::Vector::new(v.x, v.y, v.z);
    let leaves: Vec<ParryAabb> =
        boxes.iter().map(Obb::aabb).map(|b| ParryAabb::new(vector(b.min), vector(b.max))).collect();
    let tree = Bvh::from_leaves(BvhBuildStrategy::Binned, &leaves);
    let mut found = 0;
    tree.traverse_bvtt_single_tree::<false>(&mut BvhWorkspace::default(), &mut |i, j| {
        found += usize::from(!apart(&boxes[i as usize], &boxes[j as usize], -TOLERANCE));
    });
    found
}

/// What the peers say, where they are installed.
fn peers(boxes: &[Obb]) -> Option<Value> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let column = |o: &Obb, i: usize| [o.axes[(0, i)], o.axes[(1, i)], o.axes[(2, i)]];
    let list = boxes.iter().map(|o| {
        let axes = [column(o, 0), column(o, 1), column(o, 2)];
        json!({ "center": o.center.as_slice(), "half": o.half.as_slice(), "axes": axes })
    });
    let input = json!({ "boxes": list.collect::<Vec<_>>() }).to_string();
    let mut child = Command::new(root.join(".venv-peers/bin/python"))
        .arg(root.join("tests/peers/overlap.py"))
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .ok()?;
    child.stdin.take()?.write_all(input.as_bytes()).ok()?;
    serde_json::from_slice(&child.wait_with_output().ok()?.stdout).ok()
}

fn main() {
    for n in [1_000, 10_000] {
        let boxes = boxes(n);
        let (own, pairs) = best(|| broad::overlapping(&boxes, TOLERANCE).len());
        let (tree, same) = best(|| bare_tree(&boxes));
        assert_eq!(pairs, same, "two ways to find the pairs, two answers");
        println!("\n{n} boxes, {pairs} overlapping pairs\n{:<36} {:>10} {:>8} {:>8}", "", "ms", "ratio", "pairs");
        let row = |name: &str, ms: f64, pairs: u64| println!("{name:<36} {ms:>10.2} {:>8.1} {pairs:>8}", ms / own);
        row("scenelang", own, pairs as u64);
        row("parry's tree + separating axes", tree, same as u64);
        match peers(&boxes) {
            Some(Value::Object(found)) => {
                for (name, result) in found {
                    match (result["ms"].as_f64(), result["pairs"].as_u64()) {
                        (Some(ms), Some(pairs)) => row(&name, ms, pairs),
                        _ => println!("{name:<36} not installed"),
                    }
                }
            }
            _ => println!("(no peers: ./x peers installs them)"),
        }
    }
}
