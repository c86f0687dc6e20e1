//! The `scenelang` command line: options in, exit code out. What it does lives in the other rooms.

#[macro_use]
mod out;

mod args;
mod assets;
mod batch;
mod bench;
mod check;
mod consent;
mod diff;
mod drawings;
mod edited;
mod eval;
mod export;
mod fix;
mod fmt;
mod foreign;
mod formalize;
mod formats;
mod furniture;
mod gallery;
mod import;
mod input;
mod inspect;
mod interrupt;
mod look;
mod lsp;
mod manual;
mod mcp;
mod model;
mod parallel;
mod permissions;
mod plain;
mod progress;
mod query;
mod rebuild;
mod repair;
mod replace;
mod room;
mod sample;
mod settings;
mod solution;
mod solve;
mod summary;
mod synth;
mod table;
mod targets;
mod trace;
mod trial;
mod view;
mod watch;
mod words;

use args::{Args, Assets, Batch, BatchCommand, Bench, Command, Eval};
use clap::Parser;
use std::process::ExitCode;

/// Everything is good.
pub const GOOD: u8 = 0;
/// There are findings: a violation, a contradiction, a file that is not formatted.
pub const FINDINGS: u8 = 1;
/// It could not be judged, or not be done.
pub const FAILED: u8 = 2;
/// Ended by Ctrl-C, as shells have it.
pub const INTERRUPTED: u8 = 130;

fn main() -> ExitCode {
    let args = Args::try_parse().unwrap_or_else(|error| manual::with_near_option(error).exit());
    interrupt::listen();
    let code = match args.command {
        Command::Check(check) => check::run(&check),
        Command::Solve(solve) => solve::run(&solve),
        Command::Repair(repair) => repair::run(&repair),
        Command::Formalize(args) => formalize::run(&args),
        Command::Synth(synth) => synth::run(&synth),
        Command::Sample(args) => sample::run(&args),
        Command::Batch(Batch { command: Some(BatchCommand::Merge(args)), .. }) => batch::merge(&args),
        Command::Batch(Batch { run: Some(args), .. }) => batch::run(&args),
        // It asks for one of the two before it comes to this.
        Command::Batch(_) => FAILED,
        Command::BatchLine => batch::worker(),
        Command::View(view) => view::run(&view),
        Command::Export(args) => export::run(&args),
        Command::Import(args) => import::run(&args),
        Command::Fmt(fmt) => fmt::run(&fmt),
        Command::New(new) => look::new(&new),
        Command::Explain(explain) => look::explain(&explain),
        Command::Categories(args) => words::categories(&args),
        Command::Assets(Assets::Search(args)) => assets::search(&args),
        Command::Assets(Assets::List(args)) => assets::list(&args),
        Command::Assets(Assets::Check(args)) => assets::check(&args),
        Command::Assets(Assets::Import(args)) => assets::import(&args),
        Command::Assets(Assets::Queries(args)) => assets::queries(&args),
        Command::Assets(Assets::Gallery(args)) => gallery::run(&args),
        Command::Syntax(args) => inspect::syntax(&args),
        Command::Hir(args) => inspect::hir(&args),
        Command::Constraints(args) => inspect::constraints(&args),
        Command::Diff(diff) => diff::run(&diff),
        Command::Trace(args) => trace::run(&args),
        Command::Query(args) => query::run(&args),
        Command::Lsp(lsp) => lsp::run(&lsp),
        Command::Mcp(args) => mcp::run(&args),
        Command::Completions(args) => manual::completions(&args),
        Command::Man(args) => manual::man(&args),
        Command::Schema(schema) => look::schema(&schema),
        Command::Bench(Bench::Solve(solve)) => bench::solve(&solve),
        Command::Eval(Eval::Requests(requests)) => eval::requests(&requests),
        Command::Eval(Eval::Sceneeval(args)) => eval::sceneeval(&args),
        Command::Eval(Eval::Dataset(args)) => eval::dataset(&args),
        Command::Eval(Eval::Run(args)) => eval::run(&args),
        Command::Eval(Eval::Report(args)) => eval::report(&args),
    };
    ExitCode::from(out::end(code))
}
