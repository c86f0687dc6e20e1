//! Damage to solved scenes: one object displaced, or one bound in the program tightened, so that something hard fails.

use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{RngCore, SeedableRng};
use scenelang_base::FileId;
use scenelang_lang::Program;
use scenelang_lang::compile::compile_text;
use scenelang_layout::{Layout, Vec3, file};
use scenelang_verify::report::model::RowKind;
use scenelang_verify::{Explain, Options, check};
use std::path::{Path, PathBuf};

/// A program and a layout that does not satisfy it.
pub struct Damaged {
    pub program: Program,
    pub layout: Layout,
    /// What was done, in words.
    pub what: String,
}

/// What is done to a scene.
#[derive(Clone, Copy, Debug)]
pub enum Damage {
    Displaced,
    Tightened,
}

/// So many attempts are made at damage that shows.
const ATTEMPTS: usize = 50;

/// The scenes below a folder that have a solution beside them, `NAME.witness.json`; sorted.
pub fn scenes(folder: &Path) -> Vec<PathBuf> {
    let mut found = Vec::new();
    let mut open = vec![folder.to_owned()];
    while let Some(folder) = open.pop() {
        for entry in std::fs::read_dir(&folder).into_iter().flatten().flatten() {
            let path = entry.path();
            if path.is_dir() {
                open.push(path);
            } else if path.extension().is_some_and(|e| e == "scene") && path.with_extension("witness.json").exists() {
                found.push(path);
            }
        }
    }
    found.sort();
    found
}

/// A solved scene, damaged; `None`: nothing that was tried made a hard constraint fail.
pub fn damaged(scene: &Path, damage: Damage, seed: u64) -> Option<Damaged> {
    let text = std::fs::read_to_string(scene).ok()?;
    let witness = std::fs::read_to_string(scene.with_extension("witness.json")).ok()?;
    let layout = file::read(&witness, FileId(0)).layout;
    let mut chance = ChaCha8Rng::seed_from_u64(seed);
    (0..ATTEMPTS).find_map(|_| match damage {
        Damage::Displaced => displaced(scene, &text, &layout, &mut chance),
        Damage::Tightened => tightened(scene, &text, &layout, &mut chance),
    })
}

/// One object up to two metres away, sometimes turned by quarters.
fn displaced(path: &Path, text: &str, layout: &Layout, chance: &mut ChaCha8Rng) -> Option<Damaged> {
    let mut layout = layout.clone();
    let index = below(chance, layout.objects.len());
    let (name, placement) = &mut layout.objects[index];
    let (angle, far) = (unit(chance) * std::f64::consts::TAU, 0.3 + 1.7 * unit(chance));
    placement.pos += Vec3::new(angle.cos() * far, 0.0, angle.sin() * far);
    if unit(chance) < 0.3 {
        placement.rot.y = (placement.rot.y + 90.0 * (1 + below(chance, 3)) as f64) % 360.0;
    }
    let what = format!("{name} displaced by {far:.2} m");
    show(path, text, layout, what)
}

/// One bound tightened, by as little as makes it fail.
fn tightened(path: &Path, text: &str, layout: &Layout, chance: &mut ChaCha8Rng) -> Option<Damaged> {
    let lines: Vec<&str> = text.lines().collect();
    let bounded = |l: &str| l.contains("assert") && !l.contains(" or ") && (l.contains("<= ") || l.contains(">= "));
    let bounds: Vec<usize> = (0..lines.len()).filter(|i| bounded(lines[*i])).collect();
    let line = *bounds.get(below(chance, bounds.len()))?;
    let sign = if lines[line].contains("<= ") { "<= " } else { ">= " };
    let (head, number) = lines[line].rsplit_once(sign)?;
    let value: f64 = number.trim_end_matches(';').parse().ok()?;
    (1..12).find_map(|k| {
        let by = 0.05 * f64::from(k) * value.abs().max(0.5);
        let bound = if sign == "<= " { value - by } else { value + by };
        let tighter = format!("{head}{sign}{bound:.3};");
        let changed: Vec<&str> =
            lines.iter().enumerate().map(|(i, l)| if i == line { tighter.as_str() } else { l }).collect();
        show(path, &changed.join("\n"), layout.clone(), format!("line {} tightened", line + 1))
    })
}

/// The damaged scene, if the damage shows.
fn show(path: &Path, text: &str, layout: Layout, what: String) -> Option<Damaged> {
    let program = compile_text("room.scene", path, text, scenelang_lang::Options::default()).program?;
    fails(&program, &layout).then_some(Damaged { program, layout, what })
}

/// Whether something that must hold does not.
pub fn fails(program: &Program, layout: &Layout) -> bool {
    let mut options = Options::default();
    options.detail.explain = Explain::First(0);
    let verdict = check(program, layout, &options);
    verdict.rows.iter().any(|r| r.satisfied != Some(true) && r.kind != RowKind::Prefer)
}

fn unit(chance: &mut ChaCha8Rng) -> f64 {
    (chance.next_u64() >> 11) as f64 / (1u64 << 53) as f64
}

fn below(chance: &mut ChaCha8Rng, n: usize) -> usize {
    (unit(chance) * n as f64) as usize
}
