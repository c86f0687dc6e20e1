//! Judging a warehouse from program and layout in memory, with three assertions for each object and all physical rules:
//! the whole of it, and again after one object moved. `./x bench judge`.

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use scenelang_engine::Live;
use scenelang_lang::program::{ObjectId, Program};
use scenelang_layout::{Layout, Placement, RegionPlacement, Vec3};
use scenelang_verify::{Detail, Explain, Options, check};
use std::fmt::Write;
use std::hint::black_box;
use std::path::Path;

/// Metres from one shelf to the next.
const STEP: f64 = 1.6;

/// Boxes of all sizes and turns, on a grid in one hall, that all stand where their assertions want them.
fn warehouse(n: usize) -> (Program, Layout) {
    let mut text = String::from("region hall;\n");
    let mut layout = Layout::default();
    let mut state = 7u64;
    let mut random = move || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1u64 << 53) as f64
    };
    let side = (n as f64).sqrt().ceil() as usize;
    for i in 0..n {
        let other = if i > 0 { i - 1 } else { 1 };
        writeln!(
            text,
            "object box{i};\nassert box{i}.pos.x > -1;\nassert inside(box{i}, hall);\n\
             assert distance(box{i}, box{other}) < 10 or box{i}.top > 0.2;"
        )
        .expect("a string takes all");
        let placement = Placement {
            pos: Vec3::new((i % side) as f64 * STEP, 0.0, (i / side) as f64 * STEP),
            rot: Vec3::new(0.0, 360.0 * random(), 0.0),
            scale: Vec3::new(0.4 + 0.7 * random(), 0.5 + random(), 0.4 + 0.7 * random()),
            parts: Vec::new(),
            surface: None,
            joints: Vec::new(),
        };
        layout.objects.push((format!("box{i}").into(), placement));
    }
    let width = side as f64 * STEP;
    let middle = (width - STEP) / 2.0;
    let hall = RegionPlacement {
        pos: Vec3::new(middle, 0.0, middle),
        rot: Vec3::zeros(),
        scale: Vec3::new(width + 4.0, 5.0, width + 4.0),
        vertices: None,
    };
    layout.regions.push(("hall".into(), hall));
    let compiled = scenelang_lang::compile_text("hall.scene", Path::new("hall.scene"), &text, Default::default());
    (compiled.program.expect("it is a program"), layout)
}

fn verdicts() -> Options {
    let detail = Detail { sentences: false, explain: Explain::First(0), ..Detail::default() };
    Options { detail, ..Options::default() }
}

fn whole(c: &mut Criterion) {
    let mut group = c.benchmark_group("judge everything");
    group.sample_size(10);
    for n in [1_000, 10_000, 100_000] {
        group.throughput(Throughput::Elements(n as u64));
        group.bench_with_input(BenchmarkId::from_parameter(n), &n, |b, _| {
            let (program, layout) = warehouse(n);
            b.iter(|| {
                let verdict = check(&program, black_box(&layout), &verdicts());
                assert!(verdict.rows.iter().all(|row| row.satisfied == Some(true)));
                verdict
            });
        });
    }
    group.finish();
}

fn one_moved(c: &mut Criterion) {
    let mut group = c.benchmark_group("judge what one move changes");
    for n in [1_000, 10_000] {
        group.bench_with_input(BenchmarkId::from_parameter(n), &n, |b, _| {
            let (program, layout) = warehouse(n);
            let mut live = Live::new(&program, &layout, &verdicts());
            let id = ObjectId(n as u32 / 2);
            let place = &layout.objects[id.0 as usize].1;
            let mut turn = 0.0;
            b.iter(|| {
                turn += 10.0;
                live.place(id, place.pos, Vec3::new(0.0, turn, 0.0))
            });
        });
    }
    group.finish();
}

criterion_group!(judge, whole, one_moved);
criterion_main!(judge);
