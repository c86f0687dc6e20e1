//! What the assets of each category fill of their boxes is what the language's table says, from which proofs take it.
#![allow(clippy::unwrap_used, reason = "helpers of tests may panic, too")]

use scenelang_base::{SourceFile, SourceMap};
use scenelang_lang::compile::compile_main;
use scenelang_lang::library;
use scenelang_lang::program::{Object, Program};
use scenelang_lang::sources::Loader;
use scenelang_layout::{Part, Vec3};
use scenelang_synth::asset_of;
use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::{fs, io};

struct Nothing;

impl Loader for Nothing {
    fn load(&self, _: &Path) -> io::Result<Vec<u8>> {
        Err(io::ErrorKind::NotFound.into())
    }
}

/// Names that objects have: small things about an asset depend on that.
const NAMES: [&str; 2] = ["kind", "the_other_one"];
/// How far width and depth, and the height, are from the usual ones.
const RANGES: [(&str, f64, f64); 4] = [("any", 8.0, 8.0), ("long", 5.0, 1.5), ("wide", 2.0, 2.0), ("usual", 1.3, 1.3)];
/// How far from the sides the solid may begin (metres), and parts of the width and depth that it may have.
const EDGES: [f64; 4] = [0.0, 0.005, 0.015, 0.03];
const PARTS: [f64; 4] = [0.7, 0.65, 0.5, 0.3];
/// What a side may be out of line where things only have to be shut (metres).
const OUT_OF_LINE: f64 = 0.005;
/// Thinner than this, as a part of the height, is not worth a row.
const THIN: f64 = 0.003;

/// Objects of each known category.
fn kinds() -> Program {
    let mut text = String::new();
    for (i, (category, _)) in library::categories().iter().enumerate() {
        for name in NAMES {
            writeln!(text, "object {name}{i}; {name}{i}.category <- \"{category}\";").unwrap();
        }
    }
    let mut sources = SourceMap::new();
    let main = sources.add(SourceFile::new("kinds.scene", "kinds.scene", &text));
    compile_main(main, scenelang_lang::Options { core: false }, &Nothing, sources).program.unwrap()
}

/// Sizes around the usual one, each axis up to a factor off.
fn sizes(usual: [f64; 3], [plan, height]: [f64; 2]) -> Vec<[f64; 3]> {
    let (a, b, m) = (-1.0, 1.0, 0.5);
    let steps = [
        [0.0, 0.0, 0.0],
        [a, a, a],
        [b, b, b],
        [a, b, a],
        [b, a, b],
        [0.0, a, 0.0],
        [0.0, b, 0.0],
        [a, 0.0, b],
        [b, 0.0, a],
        [m, 0.0, m],
        [0.0, m, 0.0],
        [0.0, -m, 0.0],
        [m, -m, 0.0],
        [b, 0.0, 0.0],
        [0.0, 0.0, b],
    ];
    let factors = [plan, height, plan];
    steps.map(|s| std::array::from_fn(|i| usual[i] * factors[i].powf(s[i]))).to_vec()
}

/// What of a box is solid in plan.
#[derive(Clone, Copy, PartialEq)]
enum Plan {
    /// All but so much at each side (metres).
    Edge(f64),
    /// A part of its width and depth, in the middle.
    Part(f64),
}

impl std::fmt::Display for Plan {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Edge(edge) => write!(f, "{edge}"),
            Self::Part(part) => write!(f, "{}%", part * 100.0),
        }
    }
}

struct Boxes {
    parts: Vec<(Vec3, Vec3)>,
    shut: bool,
}

impl Boxes {
    /// Whether parts fill a rectangle about the middle axis at a height, as far as samples show; or shut it off, where that
    /// is enough: from each sample one of them is met in every direction. What is open in front has things in it.
    fn fill(&self, [w, d]: [f64; 2], y: f64) -> bool {
        const SAMPLES: i32 = 10;
        let along = |k: i32, length: f64| length * (f64::from(k) / f64::from(SAMPLES - 1) - 0.5);
        let within = |p: Vec3, (pos, half): &(Vec3, Vec3), axes: &[usize], gap: f64| {
            axes.iter().all(|i| (p[*i] - pos[*i]).abs() <= half[*i] + gap)
        };
        (0..SAMPLES).flat_map(|i| (0..SAMPLES).map(move |k| (i, k))).all(|(i, k)| {
            let p = Vec3::new(along(i, w), y, along(k, d));
            if self.parts.iter().any(|b| within(p, b, &[0, 1, 2], 1e-6)) {
                return true;
            }
            if !self.shut {
                return false;
            }
            // Nothing stands in the gap beside a door.
            let outer = [i, k].iter().any(|n| *n == 0 || *n == SAMPLES - 1);
            let gap = if outer { OUT_OF_LINE } else { 0.015 };
            let met = |axis: usize, way: f64| {
                let beside: Vec<usize> = (0..3).filter(|i| *i != axis).collect();
                self.parts.iter().any(|b| within(p, b, &beside, gap) && (b.0[axis] - p[axis]) * way >= -b.1[axis])
            };
            (0..3).flat_map(|axis| [(axis, -1.0), (axis, 1.0)]).all(|(axis, way)| met(axis, way))
        })
    }

    /// The parts of the height at which they do, from and to.
    fn slabs(&self, [w, h, d]: [f64; 3], plan: Plan) -> Vec<[f64; 2]> {
        let inner = [w, d].map(|s| match plan {
            Plan::Edge(edge) => s - 2.0 * edge,
            Plan::Part(part) => s * part,
        });
        if matches!(plan, Plan::Edge(edge) if inner[0].min(inner[1]) < edge) {
            return Vec::new();
        }
        let mut ends: Vec<f64> = self.parts.iter().flat_map(|(pos, half)| [pos.y - half.y, pos.y + half.y]).collect();
        ends.extend([0.0, h]);
        ends.retain(|y| (0.0..=h).contains(y));
        ends.sort_by(f64::total_cmp);
        let mut out: Vec<[f64; 2]> = Vec::new();
        for pair in ends.windows(2).filter(|p| p[1] - p[0] > 1e-9) {
            if self.fill(inner, f64::midpoint(pair[0], pair[1])) {
                match out.last_mut().filter(|last| last[1] * h >= pair[0] - 1e-9) {
                    Some(last) => last[1] = pair[1] / h,
                    None => out.push([pair[0] / h, pair[1] / h]),
                }
            }
        }
        out
    }
}

/// A box in the hull of points that is round in plan: its corners are in the hull, since it has all of the ring of points
/// above and below.
fn box_in(points: &[Vec3]) -> Option<(Vec3, Vec3)> {
    let ends = |axis: usize| {
        points.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), p| (l.min(p[axis]), h.max(p[axis])))
    };
    let ends = [0, 1, 2].map(ends);
    let center = Vec3::from(ends.map(|(l, h)| f64::midpoint(l, h)));
    let half = Vec3::from(ends.map(|(l, h)| (h - l) / 2.0));
    // On both levels there is a point near to each of sixteen directions, on the ellipse.
    let is_round = [-1.0, 1.0].iter().all(|level| {
        (0..16).all(|k| {
            let (s, c) = (f64::from(k) * std::f64::consts::PI / 8.0).sin_cos();
            let at = center + Vec3::new(s * half.x, level * half.y, c * half.z);
            points.iter().any(|p| (p - at).norm() < 0.02 * half.x.min(half.z))
        })
    });
    is_round.then(|| (center, Vec3::new(0.67 * half.x, half.y, 0.67 * half.z)))
}

fn boxes(object: &Object, size: [f64; 3]) -> Boxes {
    let parts = asset_of(object, Some(Vec3::from(size))).parts;
    // Of a cylinder, two boxes in it: the 24-gon holds the circle of 0.99 times its radius.
    let upright = parts.iter().flat_map(|part| match part {
        Part::Box { pos, size, rot } if *rot == Vec3::zeros() => vec![(*pos, *size / 2.0)],
        Part::Cylinder { pos, radius, height, rot } if *rot == Vec3::zeros() => {
            vec![(*pos, Vec3::new(0.7 * radius, height / 2.0, 0.7 * radius))]
        }
        Part::Hull { points } => box_in(points).into_iter().collect(),
        _ => Vec::new(),
    });
    Boxes { parts: upright.collect(), shut: matches!(object.role.as_str(), "storage" | "appliance") }
}

fn common(a: &[[f64; 2]], b: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let pairs = a.iter().flat_map(|p| b.iter().map(move |q| [p[0].max(q[0]), p[1].min(q[1])]));
    pairs.filter(|[from, to]| to - from >= THIN).collect()
}

/// The longest slab that all sizes in a range have, and how much of the plan it has.
fn solid_in(objects: &[Object], usual: [f64; 3], factors: [f64; 2]) -> Option<([f64; 2], Plan)> {
    let all: Vec<([f64; 3], Boxes)> = objects
        .iter()
        .flat_map(|o| sizes(usual, factors).into_iter().map(move |size| (size, boxes(o, size))))
        .collect();
    let longest = |plan: Plan| {
        let mut found = vec![[0.0, 1.0]];
        for (size, boxes) in &all {
            found = common(&found, &boxes.slabs(*size, plan));
            if found.is_empty() {
                return None;
            }
        }
        let rounded = found
            .into_iter()
            .map(|[from, to]| [(from * 500.0 - 1e-6).ceil().max(0.0) / 500.0, (to * 500.0 + 1e-6).floor() / 500.0]);
        let slab = rounded.filter(|[from, to]| to > from).max_by(|a, b| (a[1] - a[0]).total_cmp(&(b[1] - b[0])))?;
        let shut = all.iter().any(|(_, boxes)| boxes.shut);
        Some((
            slab,
            if let (Plan::Edge(edge), true) = (plan, shut) {
                Plan::Edge(((edge + OUT_OF_LINE) * 1e3).round() / 1e3)
            } else {
                plan
            },
        ))
    };
    let best = |plans: &[Plan]| {
        let found: Vec<([f64; 2], Plan)> = plans.iter().filter_map(|plan| longest(*plan)).collect();
        let most = found.iter().map(|([from, to], _)| to - from).fold(0.0, f64::max);
        found.into_iter().find(|([from, to], _)| to - from >= 0.5 * most)
    };
    best(&EDGES.map(Plan::Edge)).or_else(|| best(&PARTS.map(Plan::Part)))
}

fn table() -> String {
    let mut rows: BTreeMap<String, Vec<String>> = BTreeMap::new();
    let program = kinds();
    for ((name, usual), objects) in library::categories().iter().zip(program.objects.chunks(NAMES.len())) {
        let mut wider = Vec::new();
        for (range, plan, height) in RANGES {
            let found = solid_in(objects, *usual, [plan, height]);
            if let Some(found) = found.filter(|found| wider.last() != Some(found)) {
                let ([from, to], plan) = found;
                rows.entry(format!("{range} {from} {to} {plan}")).or_default().push(name.clone());
                wider.push(found);
            }
        }
    }
    let mut out = String::new();
    for (row, mut names) in rows {
        names.sort();
        let mut line = format!("{row}:");
        for (i, name) in names.iter().enumerate() {
            let end = if i + 1 == names.len() { "" } else { "," };
            if line.len() + name.len() + 2 > 118 {
                writeln!(out, "{line}").unwrap();
                line = " ".to_owned();
            }
            write!(line, " {name}{end}").unwrap();
        }
        writeln!(out, "{line}").unwrap();
    }
    out
}

/// The table of the language.
fn written() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../lang/std/solids.txt")
}

/// `SOLIDS_UPDATE=1` writes the table anew.
#[test]
fn the_table_of_what_is_solid_is_that_of_the_assets() {
    let now = fs::read_to_string(written()).unwrap();
    let head: String =
        now.lines().filter(|line| line.starts_with('#')).fold(String::new(), |all, line| all + line + "\n");
    let fresh = head + &table();
    if std::env::var_os("SOLIDS_UPDATE").is_some() {
        fs::write(written(), fresh).unwrap();
        return;
    }
    assert!(
        fresh == now,
        "the assets fill their boxes otherwise than solids.txt says: run this test with SOLIDS_UPDATE=1"
    );
}
