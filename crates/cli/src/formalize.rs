//! `scenelang formalize`: a request in plain words as a program, and what became of each of its clauses.

use crate::args::{Formalize, Judging, SummaryFormat};
use crate::model::ModelSession;
use crate::progress::{Progress, solving};
use crate::solve::explain;
use crate::synth::is_name;
use crate::{FAILED, FINDINGS, GOOD, input, interrupt, replace, settings};
use scenelang_base::door::Door;
use scenelang_formalize::brief::{Word, json};
use scenelang_formalize::draft::{Statement, ThingOrigin};
use scenelang_formalize::read::{BECAME_NOTHING, PURPOSE};
use scenelang_formalize::write::write;
use scenelang_formalize::{Brief, Options, Reading, of_brief, read, read_brief};
use scenelang_layout::Layout;
use scenelang_solve::Stop;
use scenelang_synth::{Failure, Tried, rehearse_reading};
use serde_json::json;
use std::fmt::Write;
use std::io::Read;
use std::path::Path;
use std::time::{Duration, Instant};

/// What the outcome as JSON calls itself.
const FORMALIZATION: &str = "scenelang.formalization/1";

/// The part of the time after which the trial ends.
const TRIAL: f64 = 0.6;

/// More of a file than this is no request (bytes).
const MOST: u64 = 4 << 20;

/// Writes the program; 0 if something was understood, 1 if nothing was.
pub fn run(args: &Formalize) -> u8 {
    let time = args.time.map(Duration::from_secs_f64);
    interrupt::within(time);
    let asked = match (&args.request, &args.file, &args.from_brief) {
        (Some(request), _, _) => named(request).map(|()| RequestSource::Words(request.clone())),
        (None, Some(path), _) => text(path).and_then(|text| worded(path, text)).map(RequestSource::Words),
        (None, None, Some(path)) => brief(path).map(|brief| RequestSource::Brief(Box::new(brief))),
        (None, None, None) => Err("there is no request".to_owned()),
    };
    let asked = match asked {
        Ok(asked) => asked,
        Err(message) => return fail(&message),
    };
    let inputs: Vec<&Path> = args.file.as_deref().into_iter().chain(args.from_brief.as_deref()).collect();
    if let Some(path) = &args.output
        && let Err(message) = replace::permit(path, &inputs, args.force)
    {
        return fail(&message);
    }
    let beside = args.output.as_deref().unwrap_or(Path::new("room.scene"));
    let settings = match settings::all(&Judging::default(), &Door::of(beside)) {
        Ok((_, settings)) => settings,
        Err(refused) => return explain(&Failure::Input(refused.sources, refused.diagnostics)),
    };
    let mut model = match ModelSession::new(&args.model, &settings.llm, 0) {
        Ok(model) => model,
        Err(error) => return fail(&error.to_string()),
    };
    if model.is_some() && (args.brief || args.from_brief.is_some()) {
        return fail("briefs are made by the built-in reader only: leave out --model, or --brief and --from-brief");
    }
    if let (RequestSource::Words(request), true) = (&asked, args.brief) {
        let brief = read_brief(request);
        print!("{}", json::write(&brief));
        return if brief.words.iter().any(|word| word.used) { GOOD } else { FINDINGS };
    }
    let trial = time.map(|time| time.mul_f64(TRIAL));
    let understood = understand(asked, args.literal, !args.untried, trial, &interrupt::stop(), model.as_mut());
    let Understood { reading, program, diagnostics, .. } = match understood {
        Ok(understood) => understood,
        Err(message) => return fail(&message),
    };
    if let Some(path) = &args.output
        && let Err(message) = replace::program(path, &program)
    {
        return fail(&message);
    }
    match args.format {
        SummaryFormat::Json => {
            let mut outcome = summary(&reading);
            outcome["program"] = json!(program);
            outcome["diagnostics"] = json!(diagnostics);
            if let Some(asked) = &model {
                let spent = asked.spent();
                outcome["model"] = json!({
                    "name": spent.model,
                    "calls": spent.calls,
                    "cached": spent.cached,
                    "input_tokens": spent.usage.input,
                    "output_tokens": spent.usage.output,
                    "cost": spent.money(),
                });
            }
            println!("{outcome}");
        }
        SummaryFormat::Human => {
            match (&args.output, args.explain) {
                (None, _) => print!("{program}"),
                (Some(_), true) => crate::out::show(&explained(&reading)),
                (Some(path), false) => println!("{} written", path.display()),
            }
            if args.explain && args.output.is_none() {
                eprint!("{}", explained(&reading));
            }
            eprint!("{}", notes(&reading));
            tell(&diagnostics, model.as_ref());
        }
    }
    let short = args.strict && (reading.words.iter().any(|word| !word.used) || relaxed(&reading) > 0);
    if reading.nothing || short { FINDINGS } else { GOOD }
}

/// Refuses the name of a file as a request.
fn named(request: &str) -> Result<(), String> {
    if input::is_program(request) {
        return Err("this is a program already, not a request in words".to_owned());
    }
    if !is_name(request) {
        return Ok(());
    }
    let path = Path::new(request);
    let is_scene = path.extension().is_some_and(|end| end == "scene");
    Err(match (path.exists(), is_scene) {
        (true, true) => {
            format!("{request} is a program already; a request is written in words, or is a text file (-f FILE)")
        }
        (true, false) => format!("{request} is a file; to read the request from it, use -f {request}"),
        (false, _) => {
            format!("{request} looks like the name of a file, but there is none; a request is written in words")
        }
    })
}

/// The text of a file, unless it is a program.
fn worded(path: &Path, text: String) -> Result<String, String> {
    match input::is_program(&text) {
        true => Err(format!("{} is a program already, not a request in words", input::name_of(path))),
        false => Ok(text),
    }
}

/// What a program is to be written from.
pub enum RequestSource {
    /// A text.
    Words(String),
    /// What was understood of one.
    Brief(Box<Brief>),
}

/// How many statements that the request makes became preferences.
fn relaxed(reading: &Reading) -> usize {
    let stated = |s: &&Statement| s.relaxed && matches!(s.source, ThingOrigin::Stated(_));
    reading.draft.statements.iter().filter(stated).count()
}

fn brief(path: &Path) -> Result<Brief, String> {
    json::read(&text(path)?)
        .map_err(|why| format!("{} is not a brief: {why}; `scenelang schema brief` prints its schema", path.display()))
}

/// What a request says, and the program of it.
pub struct Understood {
    /// What became of its clauses, or its sentences where a model was asked.
    pub reading: Reading,
    pub program: String,
    /// What went wrong with the model, or when it was tried.
    pub diagnostics: Vec<String>,
    /// A layout of the program, where the trial found one by placing what was added: a solver may begin with it.
    pub layout: Option<Layout>,
    /// Why what is asked for does not fit on a floor, if that is known.
    pub overfull: Option<String>,
}

/// Asks the model, if there is one, else the reader. `tried`: and gives up what no layout is found with.
///
/// # Errors
/// The model failed, and the reader understood nothing.
///
/// With a time, the trial ends when it is over; `stop` ends it, too.
pub fn understand(
    request: RequestSource,
    literal: bool,
    tried: bool,
    time: Option<Duration>,
    stop: &Stop,
    model: Option<&mut ModelSession>,
) -> Result<Understood, String> {
    let begun = Instant::now();
    let options = Options { literal };
    let (mut reading, mut diagnostics) = match (request, model) {
        (RequestSource::Brief(brief), _) => (of_brief(*brief, &options), Vec::new()),
        (RequestSource::Words(request), None) => (read(&request, &options), Vec::new()),
        (RequestSource::Words(request), Some(model)) => {
            let formalized = model.formalize(&request, &options).map_err(|error| error.to_string())?;
            (formalized.reading(), formalized.diagnostics)
        }
    };
    let stop = stop.below();
    if let Some(time) = time {
        let (stop, left) = (stop.clone(), time.saturating_sub(begun.elapsed()));
        let wait = move || {
            std::thread::sleep(left);
            stop.set();
        };
        std::thread::Builder::new().spawn(wait).map_err(|e| e.to_string())?;
    }
    let objects: usize = reading.draft.things.iter().map(|thing| thing.count).sum();
    let tried = tried && objects <= scenelang_solve::MOST_OBJECTS;
    if objects > scenelang_solve::MOST_OBJECTS {
        diagnostics.push(format!("{objects} objects are too many to check whether a layout exists"));
    }
    let (end, layout) = if tried { try_out(&mut reading, &stop) } else { (Tried::Holds, None) };
    let holds = end == Tried::Holds;
    let overfull = if end == Tried::Overfull { scenelang_formalize::overfull(&reading.draft) } else { None };
    if end == Tried::Spent {
        diagnostics.push(
            "the trial reached its work limit before it found a layout in which everything holds; \
             `scenelang solve` searches longer and says what is in the way"
                .to_owned(),
        );
    } else if let Some(why) = overfull.as_ref() {
        diagnostics.push(format!("{why}; the solver was not run"));
    } else if !holds && time.is_some() && stop.is_set() {
        diagnostics.push("the time limit was reached before a layout was found that satisfies everything".to_owned());
    } else if !holds {
        diagnostics.push(
            "no layout was found that satisfies everything; `scenelang solve` searches longer and says what is in the way"
                .to_owned(),
        );
    }
    Ok(Understood { program: write(&reading.draft), reading, diagnostics, layout, overfull })
}

/// Tries whether there is a layout, and gives up what is in the way.
pub fn try_out(reading: &mut Reading, stop: &Stop) -> (Tried, Option<Layout>) {
    if reading.nothing {
        return (Tried::Holds, None);
    }
    let progress = Progress::new("checking whether a layout exists");
    let mut follow = |now: scenelang_solve::Progress| progress.say(format!("trying: {}", solving(&now)));
    let tried = rehearse_reading(reading, stop, &mut follow);
    reading.draft.notes.sort_by_key(|n| (n.at.start, n.at.end));
    tried
}

/// What went wrong with the model, and what it took, for people.
pub fn tell(diagnostics: &[String], model: Option<&ModelSession>) {
    for diagnostic in diagnostics {
        eprintln!("warning: {diagnostic}");
    }
    if let Some(model) = model {
        eprintln!("model {}", model.spent());
    }
}

/// The text of a file, or of standard input.
pub fn text(path: &Path) -> Result<String, String> {
    let mut bytes = Vec::new();
    let name = path.display();
    let read = if path == Path::new("-") {
        std::io::stdin().take(MOST + 1).read_to_end(&mut bytes)
    } else {
        Door::of(path).read(path).map(|read| {
            bytes = read;
            bytes.len()
        })
    };
    read.map_err(|e| format!("cannot read {name}: {e}"))?;
    if bytes.len() as u64 > MOST {
        return Err(format!("{name} is longer than 4 MB, which is too long for a request"));
    }
    String::from_utf8(bytes).map_err(|_| format!("{name} is not valid UTF-8"))
}

/// How much was understood, and what was not.
pub fn notes(reading: &Reading) -> String {
    let mut out = String::new();
    let clauses = if reading.clauses == 1 { "clause" } else { "clauses" };
    let _ = match reading.clauses {
        0 => writeln!(out, "the request describes no room and no object"),
        n => writeln!(out, "understood {} of {n} {clauses}", reading.understood),
    };
    if !reading.words.is_empty() {
        let _ = writeln!(out, "{}", accounted(reading));
    }
    match relaxed(reading) {
        0 => {}
        1 => out.push_str(
            "1 statement from the request became a preference, because it cannot hold together with the others\n",
        ),
        n => {
            let _ = writeln!(
                out,
                "{n} statements from the request became preferences, because they cannot hold together with the others"
            );
        }
    }
    // Single words that became nothing are listed already.
    for note in reading.draft.notes.iter().filter(|note| ![BECAME_NOTHING, PURPOSE].contains(&note.reason.as_str())) {
        let _ = match note.at.is_empty() {
            true => writeln!(out, "  {}", note.reason),
            false => {
                let (place, words) = (place(reading, note.at.start), quoted(reading, &note.at));
                writeln!(out, "  {place}: \"{words}\": {}", note.reason)
            }
        };
    }
    for (name, at) in &reading.absent {
        let _ = writeln!(out, "  {}: no {name}", place(reading, at.start));
    }
    for narrowed in told_narrowed(reading) {
        let _ = writeln!(out, "{narrowed}");
    }
    if let Some(left_out) = told_left_out(reading) {
        let _ = writeln!(out, "{left_out}");
    }
    out
}

/// What usually belongs in such a room and was left out again, in a sentence.
fn told_left_out(reading: &Reading) -> Option<String> {
    const NAMED: usize = 6;
    let left_out = &reading.draft.left_out;
    let more: usize = left_out.iter().skip(NAMED).map(|(_, count)| count).sum();
    let named = left_out.iter().take(NAMED).map(|(category, count)| match category.replace('_', " ") {
        noun if *count > 1 => format!("{noun} ({count})"),
        noun => noun,
    });
    let more = (more > 0).then(|| format!("{more} more"));
    let all: Vec<String> = named.chain(more).collect();
    let (last, first) = all.split_last()?;
    let list = if first.is_empty() { last.clone() } else { format!("{} and {last}", first.join(", ")) };
    Some(format!("left out, because no layout was found with them: {list}"))
}

/// What opens less far than is useful, each in a sentence.
fn told_narrowed(reading: &Reading) -> Vec<String> {
    reading.draft.narrowed.iter().map(|narrowed| narrowed.told(&reading.draft)).collect()
}

/// How many of the words that say something became part of the program, and which did not.
fn accounted(reading: &Reading) -> String {
    const LISTED: usize = 40;
    let all = reading.words.len();
    let lost: Vec<&Word> = reading.words.iter().filter(|word| !word.used).collect();
    let words = if all == 1 { "word" } else { "words" };
    let mut out = format!("{} of {all} {words} became part of the program", all - lost.len());
    if !lost.is_empty() {
        let shown: Vec<String> =
            lost.iter().take(LISTED).map(|word| format!("\"{}\"", quoted(reading, &word.at))).collect();
        let more = if lost.len() > LISTED { format!(" and {} more", lost.len() - LISTED) } else { String::new() };
        let _ = write!(out, "; not used: {}{more}", shown.join(", "));
    }
    out
}

/// Every clause with what became of it.
fn explained(reading: &Reading) -> String {
    let mut out = String::new();
    for (at, understood) in &reading.read {
        let mark = if *understood { "+" } else { "-" };
        let _ = writeln!(out, "{mark} {}: {}", place(reading, at.start), quoted(reading, at));
        for line in became(reading, at) {
            let _ = writeln!(out, "      {line}");
        }
    }
    let inferred = inferred(reading);
    if !inferred.is_empty() {
        let _ = writeln!(out, "added:");
        for line in inferred {
            let _ = writeln!(out, "      {line}");
        }
    }
    out
}

/// Things, openings and statements that come from some bytes of the request.
fn became(reading: &Reading, at: &std::ops::Range<usize>) -> Vec<String> {
    let within =
        |source: &ThingOrigin| matches!(source, ThingOrigin::Stated(s) if s.start >= at.start && s.start < at.end);
    let draft = &reading.draft;
    let rooms = draft.rooms.iter().filter(|r| within(&r.source)).map(|r| format!("region {}", r.name));
    let openings = draft.openings.iter().filter(|o| within(&o.source)).map(|o| format!("object {}", o.name));
    let things = draft.things.iter().filter(|t| within(&t.source)).map(|t| match t.count {
        1 => format!("object {}", t.name),
        n => format!("object {}[{n}]", t.name),
    });
    let statements = draft.statements.iter().filter(|s| within(&s.source)).map(Statement::line);
    rooms.chain(openings).chain(things).chain(statements).collect()
}

/// What the request does not say, and why it is there.
fn inferred(reading: &Reading) -> Vec<String> {
    let draft = &reading.draft;
    let why = |source: &ThingOrigin| match source {
        ThingOrigin::Inferred(why) => Some(why.clone()),
        ThingOrigin::Stated(_) => None,
    };
    let things = draft.things.iter().filter_map(|t| why(&t.source).map(|w| format!("object {}: {w}", t.name)));
    let openings = draft.openings.iter().filter_map(|o| why(&o.source).map(|w| format!("object {}: {w}", o.name)));
    let statements = draft.statements.iter().filter_map(|s| why(&s.source).map(|w| format!("{} {w}", s.line())));
    openings.chain(things).chain(statements).collect()
}

/// Line and column, from 1.
fn place(reading: &Reading, at: usize) -> String {
    let before = reading.draft.request.get(..at).unwrap_or("");
    let line = before.matches('\n').count() + 1;
    let column = before.rsplit('\n').next().map_or(0, |l| l.chars().count()) + 1;
    format!("{line}:{column}")
}

fn quoted(reading: &Reading, at: &std::ops::Range<usize>) -> String {
    let text = reading.draft.request.get(at.clone()).unwrap_or("");
    let folded = text.split_whitespace().collect::<Vec<_>>().join(" ");
    match folded.char_indices().nth(100) {
        Some((cut, _)) => format!("{}…", &folded[..cut]),
        None => folded,
    }
}

/// How a request was read, as JSON.
pub fn summary(reading: &Reading) -> serde_json::Value {
    let clauses = reading.read.iter().map(|(at, understood)| {
        json!({ "bytes": [at.start, at.end], "text": quoted(reading, at), "understood": understood, "became": became(reading, at) })
    });
    let notes = reading.draft.notes.iter().map(|note| {
        json!({ "bytes": [note.at.start, note.at.end], "text": quoted(reading, &note.at), "reason": note.reason })
    });
    let unused = reading.words.iter().filter(|word| !word.used);
    let unused = unused.map(|word| json!({ "bytes": [word.at.start, word.at.end], "text": quoted(reading, &word.at) }));
    json!({
        "format": FORMALIZATION,
        "understood": reading.understood,
        "clauses": reading.clauses,
        "words": {
            "used": reading.words.iter().filter(|word| word.used).count(),
            "all": reading.words.len(),
            "unused": unused.collect::<Vec<_>>(),
        },
        "preferences": relaxed(reading),
        "read": clauses.collect::<Vec<_>>(),
        "notes": notes.collect::<Vec<_>>(),
        "absent": reading.absent.iter().map(|(name, _)| name).collect::<Vec<_>>(),
        "inferred": inferred(reading),
        "narrowed": told_narrowed(reading),
        "left_out": reading.draft.left_out.iter().map(|(category, count)| json!({ "category": category.replace('_', " "), "count": count })).collect::<Vec<_>>(),
    })
}

fn fail(message: &str) -> u8 {
    eprintln!("error: {message}");
    FAILED
}
