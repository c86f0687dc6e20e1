//! `scenelang eval requests`: reads requests without a model and scores the programs by their ground truth, or scores
//! programs that others have made of them.

mod dataset;
mod sceneeval;
mod suite;

pub use dataset::run as dataset;
pub use sceneeval::run as sceneeval;
pub use suite::{report, run};

use crate::args::{EvalRequests, SummaryFormat};
use crate::formalize::try_out;
use crate::progress::Progress;
use crate::table::Table;
use crate::{FAILED, FINDINGS, GOOD, interrupt, replace};
use scenelang_base::door::Door;
use scenelang_eval::{Case, EvalRequest, Reading, Requests, Share, read_folder};
use scenelang_formalize::Options;
use std::fmt::Write;
use std::path::Path;
use std::time::{Duration, Instant};

/// Scores each request; 0 if all programs compile and none has a proved contradiction.
pub fn requests(args: &EvalRequests) -> u8 {
    let progress = Progress::new("reading");
    let follow = |n: usize, of: usize| progress.say(format!("request {} of {of}", n + 1));
    let reader = |request: EvalRequest<'_>| match &args.programs {
        Some(folder) => written(folder, request),
        None => read_now(args, request),
    };
    let requests = read_folder(&args.folder, &reader, follow);
    drop(progress);
    let requests = match requests {
        Ok(requests) if requests.cases.is_empty() => {
            return fail(&format!(
                "{} contains no requests; a request is a file NAME.txt with a NAME.expect.json",
                args.folder.display()
            ));
        }
        Ok(requests) => requests,
        Err(message) => return fail(&message),
    };
    match args.format {
        SummaryFormat::Json => println!("{}", requests.json()),
        SummaryFormat::Human => crate::out::show(&text(&requests, args.worst)),
    }
    let free = requests.free();
    if free.part == free.whole { GOOD } else { FINDINGS }
}

/// What our English reader makes of a request.
fn read_now(args: &EvalRequests, request: EvalRequest<'_>) -> Result<Reading, String> {
    let begun = Instant::now();
    let mut read = scenelang_formalize::read(request.text, &Options { literal: !args.expand });
    if !args.untried {
        try_out(&mut read, &interrupt::stop());
    }
    let program = scenelang_formalize::write::write(&read.draft);
    let took = Some(begun.elapsed());
    if let Some(folder) = &args.output {
        let path = folder.join(format!("{}.scene", request.name));
        replace::permit(&path, &[], args.force)?;
        replace::program(&path, &program)?;
    }
    let silent = read.silent().into_iter().map(|at| request.text[at].to_owned()).collect();
    let (clauses, understood, words) = (read.clauses, read.understood, read.words.len());
    Ok(Reading { program, clauses, understood, words, silent, took })
}

/// The program that a folder has for a request.
fn written(folder: &Path, request: EvalRequest<'_>) -> Result<Reading, String> {
    let path = folder.join(format!("{}.scene", request.name));
    let bytes = Door::within(folder).read(&path).map_err(|e| format!("{}: {e}", path.display()))?;
    let program = String::from_utf8(bytes).map_err(|_| format!("{} is not valid UTF-8", path.display()))?;
    Ok(Reading { program, ..Reading::default() })
}

fn text(requests: &Requests, worst: usize) -> String {
    let mut table = Table::new(&[
        "request",
        "words",
        "precision",
        "recall",
        "counts",
        "texts",
        "relations",
        "named",
        "numbers",
        "program",
        "clauses",
        "ms",
    ]);
    for case in &requests.cases {
        let [precision, recall, counts, texts, mentioned, named, numbers] =
            case.score.shares().map(|(_, share)| percent(share.value()));
        table.row([
            case.name.clone(),
            case.words.to_string(),
            precision,
            recall,
            counts,
            texts,
            mentioned,
            named,
            numbers,
            state(case),
            of(case.clauses()),
            milliseconds(case.reading.took),
        ]);
    }
    let means: Vec<String> = requests.means().into_iter().map(|(_, mean)| percent(mean)).collect();
    let mut row: [String; 12] = std::array::from_fn(|_| String::new());
    row[0] = "mean".to_owned();
    row[2..9].clone_from_slice(&means);
    row[9] = format!("{} good", of(requests.free()));
    row[10] = of(requests.clauses());
    row[11] = milliseconds(requests.slowest());
    table.row(row);
    let mut out = table.render();
    let faults = requests.faults().into_iter().filter(|(_, share)| share.whole > 0);
    let faults: Vec<String> =
        faults.map(|(name, share)| format!("{name} {} ({})", of(share), percent(share.value()))).collect();
    if !faults.is_empty() {
        let _ = writeln!(out, "\n{}", faults.join(", "));
    }
    for case in requests.worst(worst) {
        let _ = write!(out, "\n  {}\n", case.name);
        for miss in &case.score.misses {
            let _ = writeln!(out, "    {miss}");
        }
        if !case.reading.silent.is_empty() {
            let _ = writeln!(out, "    ignored, and not mentioned in a note: {}", case.reading.silent.join(", "));
        }
    }
    out
}

/// What becomes of the program.
fn state(case: &Case) -> String {
    match case.contradictions {
        None => "broken".to_owned(),
        Some(0) => "good".to_owned(),
        Some(_) => "contradictory".to_owned(),
    }
}

fn of(share: Share) -> String {
    if share.whole == 0 { String::new() } else { format!("{}/{}", share.part, share.whole) }
}

fn milliseconds(time: Option<Duration>) -> String {
    time.map_or_else(String::new, |t| format!("{:.1}", t.as_secs_f64() * 1e3))
}

fn percent(value: Option<f64>) -> String {
    value.map_or_else(String::new, |v| format!("{:.0} %", v * 100.0))
}

fn fail(message: &str) -> u8 {
    eprintln!("error: {message}");
    FAILED
}
