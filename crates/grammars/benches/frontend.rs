//! The front end beside tree-sitter on the same program: lexing, parsing, diagnosing, compiling; how that grows with the
//! length of a program; and what an edit of one statement costs. `cargo bench -p scenelang-grammars`.

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use scenelang_base::door::Door;
use scenelang_base::{FileId, SourceFile, SourceMap};
use scenelang_lang::db::Analysis;
use scenelang_lang::parse::parse_file;
use scenelang_lang::token::lex;
use scenelang_lang::{Options, compile_text};
use std::fmt::Write;
use std::hint::black_box;
use std::path::Path;
use tree_sitter::{InputEdit, Parser, Point};

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

fn parser() -> Parser {
    let mut parser = Parser::new();
    parser.set_language(&scenelang_grammars::language()).expect("the parser is of a version that the library reads");
    parser
}

fn whole(c: &mut Criterion) {
    let text = long_program(10_000);
    let mut group = c.benchmark_group("10000 lines");
    group.throughput(Throughput::Bytes(text.len() as u64)).sample_size(20);
    group.bench_function("lex", |b| b.iter(|| lex(black_box(&text))));
    group.bench_function("parse", |b| b.iter(|| parse_file(black_box(&text))));
    group.bench_function("diagnostics", |b| b.iter(|| Opened::new(black_box(text.clone()))));
    group.bench_function("compile", |b| {
        b.iter(|| compile_text("bench.scene", Path::new("bench.scene"), black_box(&text), Options::default()));
    });
    let mut parser = parser();
    group.bench_function("tree-sitter parse", |b| b.iter(|| parser.parse(black_box(&text), None)));
    group.finish();
}

/// Diagnostics of whole programs, from nothing: how the time grows with the length.
fn growth(c: &mut Criterion) {
    let mut group = c.benchmark_group("cold diagnostics");
    group.sample_size(10);
    for lines in [1_000, 10_000, 100_000, 200_000] {
        let text = long_program(lines);
        group.throughput(Throughput::Elements(lines as u64));
        group.bench_function(lines.to_string(), |b| b.iter(|| Opened::new(black_box(text.clone()))));
    }
    group.finish();
}

/// A program as an editor has it open, diagnosed.
struct Opened {
    sources: SourceMap,
    file: FileId,
    analysis: Analysis,
}

impl Opened {
    fn new(text: String) -> Self {
        let mut sources = SourceMap::new();
        let file = sources.put(source(text));
        let mut opened = Self { sources, file, analysis: Analysis::new(Options::default()) };
        opened.diagnose();
        opened
    }

    /// Fresh diagnostics after an edit.
    fn change(&mut self, text: String) {
        self.sources.put(source(text));
        self.diagnose();
    }

    fn diagnose(&mut self) {
        self.analysis.update(self.file, &mut self.sources, &Door::of(Path::new("bench.scene")));
        black_box(self.analysis.diagnostics().expect("nobody cancels it"));
    }
}

fn source(text: String) -> SourceFile {
    SourceFile::new("bench.scene", "bench.scene", text)
}

/// One digit in the middle of the program becomes another, and back.
fn edit(c: &mut Criterion) {
    for lines in [1_000, 10_000] {
        let mut texts = [long_program(lines), String::new()];
        let row = lines / 2;
        let line_start = texts[0].lines().take(row).map(|line| line.len() + 1).sum::<usize>();
        let at = line_start + texts[0][line_start..].find(|c: char| c.is_ascii_digit()).expect("a line with a number");
        texts[1] = texts[0].clone();
        texts[1].replace_range(at..at + 1, if texts[0][at..].starts_with('7') { "8" } else { "7" });
        let place = |column| Point { row, column };
        let change = InputEdit {
            start_byte: at,
            old_end_byte: at + 1,
            new_end_byte: at + 1,
            start_position: place(at - line_start),
            old_end_position: place(at - line_start + 1),
            new_end_position: place(at - line_start + 1),
        };

        let mut group = c.benchmark_group(format!("edit one of {lines} lines"));
        group.sample_size(20);
        let mut turn = 0;
        let mut next = || {
            turn = 1 - turn;
            &texts[turn]
        };
        let mut opened = Opened::new(texts[0].clone());
        group.bench_function("diagnostics", |b| b.iter(|| opened.change(next().clone())));
        let mut parser = parser();
        let mut tree = parser.parse(&texts[0], None).expect("nothing cancels it");
        group.bench_function("tree-sitter parse", |b| {
            b.iter(|| {
                tree.edit(&change);
                tree = parser.parse(black_box(next()), Some(&tree)).expect("nothing cancels it");
            });
        });
        group.finish();
    }
}

criterion_group!(frontend, whole, growth, edit);
criterion_main!(frontend);
