//! `scenelang eval sceneeval`: programs and layouts for the requests of SceneEval-500, or layouts that others made of
//! them, scored by its annotations.

use super::{fail, of, percent};
use crate::args::{EvalSceneEval, SummaryFormat};
use crate::model::ModelSession;
use crate::progress::Progress;
use crate::replace::May;
use crate::table::Table as Columns;
use crate::{FINDINGS, GOOD, INTERRUPTED, interrupt, parallel, replace};
use scenelang_base::door::Door;
use scenelang_base::owned::{Standing, standing};
use scenelang_engine::{check_file, program_of};
use scenelang_eval::Share;
use scenelang_eval::sceneeval::{AnnotatedRequest, Benchmark, Case, Made, Scores, Table, by_model, categories, read};
use scenelang_export::OutFile;
use scenelang_formalize::write::write;
use scenelang_llm::Session;
use scenelang_solve::MOST_OBJECTS;
use scenelang_synth::{Failure, Hold, LayoutRequest, Observer, Stage, rehearse_reading, solve};
use scenelang_verify::{Explain, exit_code};
use std::fmt::Write;
use std::path::{Path, PathBuf};

/// What is written beside programs and layouts.
const REPORT: [&str; 2] = ["report.json", "summary.csv"];

/// Scores the requests; 0 if there is a layout for each in which all holds that must.
pub fn run(args: &EvalSceneEval) -> u8 {
    let benchmark = match chosen(args) {
        Ok(benchmark) => benchmark,
        Err(message) => return fail(&message),
    };
    if let Some(folder) = args.layouts.as_ref().filter(|folder| !folder.is_dir()) {
        return fail(&format!("--layouts {}: there is no such folder", folder.display()));
    }
    let mut model = match ModelSession::new(&args.model, &scenelang_verify::settings::Llm::default(), 0) {
        Ok(asked) => asked.map(|asked| asked.into_parts().0),
        Err(why) => return fail(&why.to_string()),
    };
    if let Err(message) = permitted(args, &benchmark.requests) {
        return fail(&message);
    }
    for unread in &benchmark.unread {
        crate::out::tell(format_args!("warning: {}: {unread}; it is not checked\n", args.annotations.display()));
    }
    interrupt::gently();
    let mut scores = Scores { cases: Vec::new(), unread: benchmark.unread };
    let mut failure = None;
    let progress = Progress::new("starting");
    let requests = &benchmark.requests;
    let mut each = |case| {
        match case {
            Ok(Some(case)) => scores.cases.push(case),
            Ok(None) => {}
            Err(message) => failure = failure.take().or(Some(message)),
        }
        let good = scores.cases.iter().filter(|case| case.is_good()).count();
        progress.say(format!("{} of {} requests, {good} with a layout", scores.cases.len(), requests.len()));
    };
    match &mut model {
        // A conversation goes one question after the other.
        Some(model) => requests.iter().for_each(|asked| each(case(args, asked, Some(model)))),
        None => {
            let jobs = args.jobs.map_or_else(parallel::usual, usize::from);
            parallel::in_order(requests, jobs, |asked| case(args, asked, None), each);
        }
    }
    drop(progress);
    if let Some(message) = failure {
        return fail(&message);
    }
    if interrupt::asked() {
        eprintln!("interrupted after {} of {} requests; use --resume to continue", scores.cases.len(), requests.len());
        return INTERRUPTED;
    }
    let files = REPORT.into_iter().zip([format!("{:#}\n", scores.json()), scores.csv()]);
    let files: Vec<OutFile> = files.map(|(name, text)| OutFile::new(name, text)).collect();
    if let Err(message) =
        replace::folder(&args.output, &files, &[&args.annotations], May { force: args.force, these: &[] })
    {
        return fail(&message);
    }
    match args.format {
        SummaryFormat::Json => println!("{}", scores.json()),
        SummaryFormat::Human => crate::out::show(&text(&scores, args.worst)),
    }
    if scores.cases.iter().all(Case::is_good) { GOOD } else { FINDINGS }
}

/// The requests of the file that are asked for.
fn chosen(args: &EvalSceneEval) -> Result<Benchmark, String> {
    let name = args.annotations.display();
    let bytes = Door::of(&args.annotations).read(&args.annotations).map_err(|e| format!("cannot read {name}: {e}"))?;
    let text = String::from_utf8(bytes).map_err(|_| format!("{name} is not valid UTF-8"))?;
    let mut benchmark = read(&text).map_err(|why| format!("{name}: {why}"))?;
    let parity = |asked: &AnnotatedRequest| {
        asked.id.bytes().all(|b| b.is_ascii_digit()).then(|| asked.id.bytes().last()).flatten()
    };
    let ids: Vec<&str> = args.ids.iter().map(String::as_str).collect();
    match ids.as_slice() {
        [] => {}
        ["even"] => benchmark.requests.retain(|asked| parity(asked).is_some_and(|digit| digit % 2 == 0)),
        ["odd"] => benchmark.requests.retain(|asked| parity(asked).is_some_and(|digit| digit % 2 == 1)),
        ids => {
            if let Some(id) = ids.iter().find(|id| !benchmark.requests.iter().any(|asked| asked.id == **id)) {
                return Err(format!(
                    "{name} has no request {id:?}; --ids takes `even`, `odd`, or request IDs from the file"
                ));
            }
            benchmark.requests.retain(|asked| ids.contains(&asked.id.as_str()));
        }
    }
    if benchmark.requests.is_empty() { Err(format!("{name} has no such request")) } else { Ok(benchmark) }
}

/// The program and the layout of a request in a folder.
fn files(folder: &Path, asked: &AnnotatedRequest) -> [PathBuf; 2] {
    ["scene", "layout.json"].map(|end| folder.join(format!("{}.{end}", asked.id)))
}

/// Whether all that will be written may be.
fn permitted(args: &EvalSceneEval, requests: &[AnnotatedRequest]) -> Result<(), String> {
    let inputs = [args.annotations.as_path()];
    let own = requests.iter().filter(|_| args.layouts.is_none()).flat_map(|asked| files(&args.output, asked));
    own.chain(REPORT.map(|name| args.output.join(name)))
        .try_for_each(|path| replace::permit(&path, &inputs, args.force))
}

/// Makes what there is to make for a request, and scores it; `None`: the end was asked for.
fn case(args: &EvalSceneEval, asked: &AnnotatedRequest, model: Option<&mut Session>) -> Result<Option<Case>, String> {
    let table = &Table::new();
    if interrupt::asked() {
        return Ok(None);
    }
    let folder = args.layouts.as_ref().unwrap_or(&args.output);
    let [scene, layout] = files(folder, asked);
    if args.layouts.is_some() {
        if !Door::within(folder).is_file(&layout) {
            let trouble = format!("there is no {}", layout.display());
            return Ok(Some(Case::without(asked, trouble, table)));
        }
    } else if !(args.resume && [&scene, &layout].iter().all(|path| standing(path).is_ok_and(|is| is == Standing::Ours)))
    {
        let trouble = make(asked, &scene, &layout)?;
        if interrupt::asked() {
            return Ok(None);
        }
        if let Some(trouble) = trouble {
            return Ok(Some(Case::without(asked, trouble, table)));
        }
    }
    scored(asked, &layout, model).map(Some)
}

/// Writes program and layout of a request. What is returned says why there is no layout.
fn make(asked: &AnnotatedRequest, scene: &Path, layout: &Path) -> Result<Option<String>, String> {
    let stop = interrupt::stop();
    let mut reading = scenelang_formalize::read(&asked.description, &scenelang_formalize::Options { literal: false });
    if reading.nothing {
        return Ok(Some("nothing in the request was understood".to_owned()));
    }
    let objects: usize = reading.draft.things.iter().map(|thing| thing.count).sum();
    let mut planned = None;
    if objects <= MOST_OBJECTS {
        planned = rehearse_reading(&mut reading, &stop, &mut |_| {}).1;
    }
    if stop.is_set() {
        return Ok(None);
    }
    replace::program(scene, &write(&reading.draft))?;
    if let Some(why) = scenelang_formalize::overfull(&reading.draft) {
        return Ok(Some(why));
    }
    let start = planned.map(|layout| scenelang_layout::file::to_json(&layout, None));
    let name = layout.display().to_string();
    let request = LayoutRequest {
        name: &scene.display().to_string(),
        path: scene,
        files: &Door::of(scene),
        start: start.as_deref().map(|text| (name.as_str(), text)),
        before: None,
        share: 1,
        layout_name: &name,
        scene_member: &format!("{}.scene", asked.id),
        hold: Hold::Nothing,
        time: None,
        alternatives: None,
        free: 0,
        // As many requests at once are worth more than as many threads for each.
        threads: 1,
        effort: 1,
        quality: scenelang_solve::QUALITY,
        stop: &stop,
        seed: 0,
        judge: scenelang_verify::Options::default(),
        furniture: None,
    };
    match solve(&request, &mut Unseen) {
        Ok(solved) if !solved.first.layout().incomplete => {
            replace::layouts(&[(layout, solved.first.text.as_str())], |_| false)?;
            Ok(None)
        }
        Ok(_) | Err(Failure::Interrupted) => Ok(None),
        Err(Failure::Contradiction(_)) => Ok(Some("the program contradicts itself".to_owned())),
        Err(Failure::Input(_, findings)) => {
            let first = findings.into_iter().find(scenelang_base::Diagnostic::is_error);
            Ok(Some(first.map_or_else(|| "the program has errors".to_owned(), |finding| finding.message)))
        }
    }
}

/// Scores a layout with the program that it belongs to, where that is there. A model says what words mean, if there is one.
fn scored(asked: &AnnotatedRequest, layout: &Path, model: Option<&mut Session>) -> Result<Case, String> {
    let mut options = scenelang_verify::Options::default();
    options.detail.explain = Explain::First(0);
    let name = layout.display().to_string();
    let door = Door::of(layout);
    let program = program_of(&name, layout, &door).map(|(_, path)| path).filter(|path| door.is_file(path));
    let checked = check_file(&name, layout, &options, scenelang_lang::Options::default());
    let errors = || checked.report.diagnostics.iter().filter(|finding| finding.severity == "error");
    // That there is no program is no error of the layout: names say what things are.
    let absent = |code: &str| program.is_none() && matches!(code, "E0009" | "E0510");
    let trouble = errors().find(|finding| !absent(&finding.code)).map(|finding| finding.message.clone());
    let without = |trouble: Option<String>| {
        let trouble = trouble.unwrap_or_else(|| format!("{name} cannot be read"));
        Ok(Case::without(asked, trouble, &Table::new()))
    };
    let Some(placed) = checked.layout.as_ref().filter(|_| trouble.is_none() || checked.program.is_some()) else {
        return without(trouble);
    };
    let main = program.as_ref().and_then(|path| checked.sources.iter().find(|(_, file)| file.path() == path));
    let made = Made {
        layout: placed,
        program: checked.program.as_ref().zip(main).map(|(program, (id, file))| (program, id, file.text())),
        holds: checked.program.as_ref().map(|_| exit_code(&checked.report) == 0),
    };
    let table = match model {
        Some(model) => by_model(asked, &categories(placed, checked.program.as_ref()), model)
            .map_err(|why| format!("request {}: {why}", asked.id))?,
        None => Table::new(),
    };
    match Case::of(asked, &made, &table) {
        Ok(case) => Ok(Case { trouble, ..case }),
        Err(why) => without(Some(why)),
    }
}

/// Nobody watches one of many.
struct Unseen;

impl Observer for Unseen {
    fn enter(&mut self, _: Stage) {}
    fn leave(&mut self, _: Stage) {}
    fn solving(&mut self, _: &scenelang_solve::Progress) {}
}

fn text(scores: &Scores, worst: usize) -> String {
    let mut measures = Columns::new(&["requests", "number", "CNT", "ATR", "OOR", "OAR", "all of it", "layout holds"]);
    let mut plausible =
        Columns::new(&["requests", "supported", "apart", "in bounds", "navigable", "accessible", "free of collisions"]);
    let share = |share: Share| match share.value() {
        Some(_) => format!("{} ({})", percent(share.value()), of(share)),
        None => String::new(),
    };
    for group in scores.groups() {
        let [counts, attributes, between, places] = group.shares.map(share);
        let number = group.good.whole.to_string();
        let name = || group.name.clone();
        measures.row([name(), number, counts, attributes, between, places, of(group.perfect), of(group.good)]);
        let [held, apart, within] = group.plausible.map(share);
        let [walked, reached] = [group.navigability, group.accessibility].map(percent);
        plausible.row([name(), held, apart, within, walked, reached, of(group.free)]);
    }
    let mut out = measures.render();
    if let Some(all) = scores.groups().first() {
        let [_, _, between, places] = all.published.map(share);
        let _ = writeln!(out, "\nwith the published thresholds alone: OOR {between}, OAR {places}");
    }
    let _ = write!(out, "\n{}", plausible.render());
    let fates = scores.fates().into_iter().filter(|(_, count)| *count > 0);
    let fates: Vec<String> = fates.map(|(name, count)| format!("{name} {count}")).collect();
    if !fates.is_empty() {
        let _ = writeln!(out, "\nmisses: {}", fates.join(", "));
    }
    let mut cases: Vec<&Case> = scores.cases.iter().filter(|case| !case.misses.is_empty()).collect();
    cases.sort_by_key(|case| std::cmp::Reverse(case.misses.len()));
    for case in cases.into_iter().take(worst) {
        let _ = writeln!(out, "\n  {}", case.id);
        if let Some(trouble) = &case.trouble {
            let _ = writeln!(out, "    {trouble}");
        }
        for miss in &case.misses {
            let fate = miss.fate.map_or(if miss.absent { "not there" } else { "not satisfied" }, |fate| fate.name());
            let (measure, asked, found) = (miss.measure.name(), &miss.annotation, miss.found);
            let _ = writeln!(out, "    {measure} {asked}: {found} found; {fate}: \"{}\"", miss.sentence);
            for statement in &miss.statements {
                let _ = writeln!(out, "      {statement}");
            }
        }
    }
    out
}
