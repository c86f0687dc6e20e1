//! The stages of the corridor, timed: how long a long program takes to compile, a large layout to check, an example to
//! solve. `./x bench`, or `./x bench check` for some of them.

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use scenelang_base::door::Door;
use scenelang_lang::{Options, Program, compile_text};
use scenelang_layout::{Layout, Placement, RegionPlacement, Vec3};
use scenelang_solve::{Progress, QUALITY, Stop};
use scenelang_synth::{Hold, LayoutRequest, Observer, Stage};
use std::fmt::Write;
use std::hint::black_box;
use std::path::{Path, PathBuf};

fn compiled(text: &str) -> Program {
    let compiled = compile_text("bench.scene", Path::new("bench.scene"), text, Options::default());
    assert!(!compiled.has_errors(), "{:?}", compiled.diagnostics.first());
    compiled.program.expect("no errors, so a program")
}

/// A program of so many lines, with what real ones have: declarations, assignments, relations, arithmetic.
fn long_program(lines: usize) -> String {
    let mut text = String::from("region room;\nroom.pos <- vec3(0, 0, 0);\nroom.scale <- vec3(500, 3, 500);\n");
    for i in 0..(lines - 3) / 5 {
        let j = i.saturating_sub(1);
        writeln!(text, "object thing{i};").expect("a string takes all");
        writeln!(text, "thing{i}.category <- \"chair\";").expect("a string takes all");
        writeln!(text, "thing{i}.dimensions <- vec3(0.5, 0.9, {});", 0.5 + (i % 7) as f64 / 100.0).expect("as above");
        writeln!(text, "assert inside(thing{i}, room) and thing{i}.pos.x >= {} + 2 * (1 - 0.5);", i % 100)
            .expect("as above");
        writeln!(text, "assert near(thing{i}, thing{j}, 2) or leftOf(thing{i}, thing{j});").expect("as above");
    }
    text
}

fn compile(c: &mut Criterion) {
    let text = long_program(10_000);
    let mut group = c.benchmark_group("compile");
    group.throughput(Throughput::Bytes(text.len() as u64)).sample_size(20);
    group.bench_function("10000 lines", |b| b.iter(|| compiled(black_box(&text))));
    group.finish();
}

/// Boxes on a square grid, 1 m apart, that satisfy the program.
fn grid(n: usize) -> (Program, Layout) {
    let side = (n as f64).sqrt().ceil();
    let program = compiled(&format!(
        "region hall; object thing[{n}];\n\
         assert forall x in thing: x.pos.x >= 0 and x.top <= 2;\n\
         assert forall i in 0..{}: gap(thing[i], thing[i + 1]) >= 0.3;",
        n - 1
    ));
    let objects = program.objects.iter().enumerate().map(|(i, object)| {
        let pos = Vec3::new((i as f64 % side) + 0.5, 0.0, (i as f64 / side).floor() + 0.5);
        let rot = Vec3::new(0.0, (i % 4) as f64 * 10.0, 0.0);
        (
            object.name.clone(),
            Placement { pos, rot, scale: Vec3::repeat(0.5), parts: Vec::new(), surface: None, joints: Vec::new() },
        )
    });
    let hall = RegionPlacement {
        pos: Vec3::new(side / 2.0, 0.0, side / 2.0),
        rot: Vec3::zeros(),
        scale: Vec3::new(side, 3.0, side),
        vertices: None,
    };
    let layout = Layout { objects: objects.collect(), regions: vec![("hall".into(), hall)], ..Layout::default() };
    (program, layout)
}

fn check(c: &mut Criterion) {
    let mut group = c.benchmark_group("check");
    group.sample_size(10);
    for n in [1_000, 10_000] {
        let (program, layout) = grid(n);
        let options = scenelang_verify::Options::default();
        let summary = scenelang_verify::check(&program, &layout, &options).summary;
        assert_eq!(summary.assertions.total, summary.assertions.satisfied, "the grid satisfies its program");
        group.throughput(Throughput::Elements(n as u64));
        group.bench_function(BenchmarkId::new("objects", n), |b| {
            b.iter(|| scenelang_verify::check(black_box(&program), black_box(&layout), &options));
        });
    }
    group.finish();
}

struct Silent;

impl Observer for Silent {
    fn enter(&mut self, _: Stage) {}
    fn leave(&mut self, _: Stage) {}
    fn solving(&mut self, _: &Progress) {}
}

fn solve(c: &mut Criterion) {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples");
    let mut scenes: Vec<PathBuf> = std::fs::read_dir(folder)
        .expect("the examples are there")
        .map(|e| e.expect("a readable folder").path())
        .filter(|p| p.extension().is_some_and(|e| e == "scene"))
        .collect();
    scenes.sort();
    let mut group = c.benchmark_group("solve");
    group.sample_size(10);
    for scene in &scenes {
        let file = scene.file_name().expect("a file has a name").to_string_lossy().into_owned();
        let layout_name = scene.with_extension("layout.json").display().to_string();
        let request = LayoutRequest {
            name: &file,
            path: scene,
            files: &Door::of(scene),
            start: None,
            before: None,
            share: 1,
            layout_name: &layout_name,
            scene_member: &file,
            hold: Hold::Nothing,
            time: None,
            alternatives: None,
            free: 0,
            threads: 0,
            effort: 1,
            quality: QUALITY,
            stop: &Stop::default(),
            seed: 0,
            judge: scenelang_verify::Options::default(),
            furniture: None,
        };
        group.bench_function(file.trim_end_matches(".scene"), |b| {
            b.iter(|| scenelang_synth::solve(black_box(&request), &mut Silent).ok());
        });
    }
    group.finish();
}

criterion_group!(corridor, compile, check, solve);
criterion_main!(corridor);
