//! `scenelang sample`: many verified layouts of one program, and how far they are spread.

mod piece;
mod stored;

use crate::args::{Sample, SummaryFormat};
use crate::check::color;
use crate::progress::Progress;
use crate::replace::May;
use crate::{FAILED, FINDINGS, GOOD, INTERRUPTED, interrupt, out, parallel, replace, settings, solution, solve};
use piece::Piece;
use scenelang_base::door::Door;
use scenelang_engine::{check_layout_of, check_program};
use scenelang_export::{Exporter, OutFile, Scene, SceneInput, all_exporters};
use scenelang_lang::{Compiled, Program, compile_file};
use scenelang_sample::{Coverage, Drawn, Sampler, Settings};
use scenelang_synth::{Failure, Hold, LayoutRequest, Observer, Stage, too_large};
use scenelang_verify::prove::{ProveOptions, WORK, prove};
use scenelang_verify::report::{self, Human, statement_id};
use scenelang_verify::{Checked, exit_code};
use serde_json::{Value, json};
use std::ops::Range;
use std::path::Path;
use stored::{Origin, Store, permit_split};

/// What the report calls itself.
const FORMAT: &str = "scenelang.samples/1";
/// So many samples are in one file: it is written as a whole, and a run of any length needs no more memory than that.
const PIECE: u64 = 1_000;
/// The part of the usual work that goes into proofs before anything is drawn; where no layout is found, more is tried.
const CHEAP: u64 = 6;
const REPORT: &str = "report.json";

/// Draws and writes; 0 if all samples for whose draws there is a layout are stored, 1 if there is none.
pub fn run(args: &Sample) -> u8 {
    interrupt::gently();
    let name = args.scene.display().to_string();
    let judging = match settings::all(&args.judging, &Door::of(&args.scene)) {
        Ok((judging, _)) => judging,
        Err(refused) => return solve::explain(&Failure::Input(refused.sources, refused.diagnostics)),
    };
    let compiled = compile_file(&name, &args.scene, scenelang_lang::Options::default());
    let Some(program) = &compiled.program else {
        return solve::explain(&Failure::Input(compiled.sources, compiled.diagnostics));
    };
    if let Some(finding) = too_large(program) {
        return solve::explain(&Failure::Input(compiled.sources, vec![finding]));
    }
    let work = WORK / CHEAP;
    let options =
        ProveOptions { judging: judging.options, redundant: false, usual: true, work, ..ProveOptions::default() };
    let findings = prove(program, &options);
    if !findings.contradictions.is_empty() {
        return contradiction(args, &name, &check_program(&name, compiled, &findings, &judging.options));
    }
    let run = Run { args, name: &name, judge: judging.options, compiled: &compiled, program };
    match run.all() {
        Ok(code) => code,
        Err(message) => {
            eprintln!("error: {message}");
            FAILED
        }
    }
}

/// Says which statements cannot hold together.
fn contradiction(args: &Sample, name: &str, checked: &Checked) -> u8 {
    match args.format {
        SummaryFormat::Json => println!("{}", solution::refuted(name, checked)),
        SummaryFormat::Human => {
            out::show(&report::human(checked, Human { color: color(), all: false }));
            out::show("no sample was written, because no layout satisfies the program\n");
        }
    }
    exit_code(&checked.report)
}

struct Run<'a> {
    args: &'a Sample,
    name: &'a str,
    judge: scenelang_verify::Options,
    compiled: &'a Compiled,
    program: &'a Program,
}

impl Run<'_> {
    fn all(&self) -> Result<u8, String> {
        let args = self.args;
        let folder = args.shard.folder(&args.output);
        let range = args.shard.range(args.number);
        let pieces = pieces(range.clone());
        let inputs = [args.scene.as_path()];
        // As seen from the folder of all parts, so that it is the same in each.
        let scene = solve::relative(&args.scene, &args.output.join(REPORT));
        let origin = Origin::new(self.compiled, args.seed, &scene, &format!("{:?} {}", self.judge, args.effort));
        let store = Store { folder: &folder, program: self.program, origin: &origin, export: &args.export };
        if args.force {
            store.clear(range.end)?;
        } else {
            store.permit(range.end)?;
            permit_split(&args.output, args.shard)?;
        }
        for name in pieces.iter().flat_map(|piece| [file_of(piece), record_of(piece)]).chain([REPORT.to_owned()]) {
            replace::permit(&folder.join(name), &inputs, args.force)?;
        }
        let progress = Progress::new("looking for layouts to start from");
        let mut sampler = None;
        let (mut coverage, mut files, mut before) = (Coverage::new(self.program), Vec::new(), 0);
        for range in &pieces {
            let (mut piece, drawn) = store.open(range);
            before += piece.count();
            drawn.iter().for_each(|drawn| coverage.add(drawn));
            coverage.count(&piece.tally, piece.whole);
            if !self.export_rest(&mut piece, &drawn, &folder, &progress)? {
                break;
            }
            drop(drawn);
            if piece.count() < range.end - range.start && sampler.is_none() {
                sampler = Sampler::new(self.program, self.settings(&scene));
                if sampler.is_none() {
                    drop(progress);
                    return Ok(self.none());
                }
            }
            if let Some(sampler) = &sampler {
                self.draw_rest((&mut piece, range), sampler, &folder, (&mut coverage, before, &progress))?;
            }
            if interrupt::asked() {
                break;
            }
            piece.finish(&inputs, args.force)?;
            files.push(file_of(range));
        }
        drop(progress);
        if interrupt::asked() {
            eprintln!(
                "interrupted after {} of {} samples; run the same command again to continue",
                coverage.asked,
                range.end - range.start
            );
            return Ok(INTERRUPTED);
        }
        if coverage.stored == 0 && range.start < range.end {
            return Ok(self.none());
        }
        let report = self.report(&coverage, &files);
        let file = OutFile::new(REPORT, format!("{report:#}\n"));
        replace::folder(&folder, &[file], &inputs, May { force: args.force, these: &[] })?;
        match args.format {
            SummaryFormat::Json => println!("{report}"),
            SummaryFormat::Human => {
                if before > 0 {
                    out::show(&format!("{before} samples were drawn before\n"));
                }
                out::show(&coverage.text(self.program, &|index| self.statement(index)));
                out::show(&format!("{} written\n", folder.display()));
            }
        }
        Ok(if coverage.unverified > 0 { FINDINGS } else { GOOD })
    }

    fn settings(&self, scene: &str) -> Settings {
        Settings {
            seed: self.args.seed,
            judge: self.judge,
            effort: self.args.effort,
            budget: 0,
            scene: scene.to_owned(),
            whole: true,
            stop: interrupt::stop(),
        }
    }

    fn jobs(&self) -> usize {
        self.args.jobs.map_or_else(parallel::usual, usize::from)
    }

    /// Draws the samples that a file does not have yet.
    fn draw_rest(
        &self,
        (piece, range): (&mut Piece, &Range<u64>),
        sampler: &Sampler<'_>,
        folder: &Path,
        (coverage, before, progress): (&mut Coverage, u64, &Progress),
    ) -> Result<(), String> {
        let numbers: Vec<u64> = (range.start + piece.count()..range.end).collect();
        let all = self.args.shard.range(self.args.number);
        let total = all.end - all.start;
        let mut failure = None;
        let draw = |number: &u64| self.draw(sampler, *number, folder);
        parallel::in_order(&numbers, self.jobs(), draw, |(drawn, exported)| {
            coverage.add(&drawn);
            failure = failure.take().or_else(|| exported.and_then(|()| piece.add(&drawn)).err());
            let [done, open] = [coverage.asked - before, total - coverage.asked].map(|n| n as usize);
            progress.say(format!("{} of {total} samples{}", coverage.asked, progress.left(done, open)));
        });
        failure.map_or(Ok(()), Err)
    }

    /// Exports samples that an earlier run drew, in the formats that they lack; `false`: it was interrupted.
    fn export_rest(
        &self,
        piece: &mut Piece,
        drawn: &[Drawn],
        folder: &Path,
        progress: &Progress,
    ) -> Result<bool, String> {
        let formats = piece.lacks(&self.args.export);
        if formats.is_empty() {
            return Ok(!interrupt::asked());
        }
        let (mut failure, mut count) = (None, 0);
        let export = |drawn: &Drawn| match &drawn.result {
            Ok(sample) if !interrupt::asked() => self.export(&sample.line, drawn.index, folder, &formats),
            _ => Ok(()),
        };
        parallel::in_order(drawn, self.jobs(), export, |exported: Result<(), String>| {
            failure = failure.take().or(exported.err());
            count += 1;
            progress.say(format!("exporting {count} of {} samples drawn before", drawn.len()));
        });
        match failure {
            Some(message) => Err(message),
            None if interrupt::asked() => Ok(false),
            None => {
                piece.exported(formats);
                Ok(true)
            }
        }
    }

    /// One sample, and its files in the formats asked for.
    fn draw(&self, sampler: &Sampler<'_>, number: u64, folder: &Path) -> (Drawn, Result<(), String>) {
        let drawn = sampler.sample(number);
        let exported = match &drawn.result {
            Ok(sample) if !self.args.export.is_empty() => self.export(&sample.line, number, folder, &self.args.export),
            _ => Ok(()),
        };
        (drawn, exported)
    }

    fn export(&self, line: &str, number: u64, folder: &Path, formats: &[String]) -> Result<(), String> {
        let stem = stem_of(number);
        let called = format!("{stem}.layout.json");
        let program = (self.name, self.args.scene.as_path());
        let reading = scenelang_lang::Options::default();
        let door = Door::of(&self.args.scene);
        let checked = check_layout_of(&called, line.to_owned(), program, &self.judge, reading, &door);
        let (Some(program), Some(layout)) = (&checked.program, &checked.layout) else {
            return Err(format!("cannot read back the layout of {stem} to export it"));
        };
        let report = serde_json::to_value(&checked.report).map_err(|e| e.to_string())?;
        let files: Vec<_> = self
            .compiled
            .sources
            .iter()
            .filter_map(|(_, own)| checked.sources.iter().find(|(_, file)| file.path() == own.path()).map(|(id, _)| id))
            .collect();
        let input = SceneInput {
            name: &stem,
            program,
            sources: &checked.sources,
            files: &files,
            layout,
            layout_text: line,
            report: &report,
        };
        let scene = Scene::build(&input).map_err(|e| format!("{stem}: {e}"))?;
        let chosen = all_exporters().into_iter().filter(|e| formats.iter().any(|name| name == e.name()));
        let mut files = Vec::new();
        for exporter in chosen {
            files.extend(Exporter::files(&*exporter, &scene).map_err(|e| format!("{stem}: {e}"))?);
        }
        replace::folder(&folder.join(&stem), &files, &[&self.args.scene], May { force: self.args.force, these: &[] })?;
        Ok(())
    }

    fn statement(&self, index: usize) -> String {
        statement_id(self.name, &self.compiled.sources, self.program.constraints[index].span)
    }

    fn report(&self, coverage: &Coverage, files: &[String]) -> Value {
        let args = self.args;
        let mut report = json!({
            "format": FORMAT,
            "program": self.name,
            "seed": args.seed,
            "shard": { "index": args.shard.index, "of": args.shard.of },
            "files": files,
        });
        if let (Some(own), Value::Object(more)) =
            (report.as_object_mut(), coverage.json(self.program, &|i| self.statement(i)))
        {
            own.extend(more);
        }
        report
    }

    /// Says why there is no sample: what is proved, or what comes closest to a layout.
    fn none(&self) -> u8 {
        let stop = interrupt::stop();
        if stop.is_set() {
            eprintln!("interrupted; nothing was written");
            return INTERRUPTED;
        }
        let request = LayoutRequest {
            name: self.name,
            path: &self.args.scene,
            files: &Door::of(&self.args.scene),
            start: None,
            before: None,
            share: 1,
            layout_name: "closest.layout.json",
            scene_member: "",
            hold: Hold::Nothing,
            time: None,
            alternatives: None,
            free: 0,
            threads: 0,
            effort: self.args.effort,
            quality: 0,
            stop: &stop,
            seed: self.args.seed,
            furniture: None,
            judge: self.judge,
        };
        match scenelang_synth::solve(&request, &mut Silent) {
            Err(Failure::Contradiction(checked)) => contradiction(self.args, self.name, &checked),
            Err(failure) => solve::explain(&failure),
            Ok(solved) => {
                match self.args.format {
                    SummaryFormat::Json => println!("{}", report::json(&solved.first.checked.report)),
                    SummaryFormat::Human => {
                        out::show(&report::human(&solved.first.checked, Human { color: color(), all: false }));
                        out::show(
                            "no sample was written, because no layout was found that satisfies all hard constraints; the best one is shown above\n",
                        );
                    }
                }
                FINDINGS
            }
        }
    }
}

/// Nobody wants to know how far it is.
struct Silent;

impl Observer for Silent {
    fn enter(&mut self, _stage: Stage) {}
    fn leave(&mut self, _stage: Stage) {}
    fn solving(&mut self, _progress: &scenelang_solve::Progress) {}
}

/// The samples of each file: cut at the same numbers however the work is split, and at the ends of the part.
fn pieces(range: Range<u64>) -> Vec<Range<u64>> {
    let mut pieces = Vec::new();
    let mut from = range.start;
    while from < range.end {
        let to = ((from / PIECE + 1) * PIECE).min(range.end);
        pieces.push(from..to);
        from = to;
    }
    pieces
}

/// By the number of its first sample, so that files in the order of their names are samples in order.
fn file_of(piece: &Range<u64>) -> String {
    format!("samples-{:09}.jsonl", piece.start)
}

/// The record of such a file.
fn record_of(piece: &Range<u64>) -> String {
    format!("samples-{:09}.json", piece.start)
}

/// The folder of an exported sample, and the name of its files.
fn stem_of(number: u64) -> String {
    format!("sample-{number:09}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pieces_are_cut_at_whole_thousands() {
        assert_eq!(pieces(0..2500), [0..1000, 1000..2000, 2000..2500]);
        assert_eq!(pieces(999..1001), [999..1000, 1000..1001]);
        assert!(pieces(5..5).is_empty());
        assert_eq!(file_of(&(1000..2000)), "samples-000001000.jsonl");
    }
}
