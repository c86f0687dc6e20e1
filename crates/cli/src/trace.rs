//! `scenelang trace`: what became of each requirement, and which requirements an object answers.

use crate::args::{By, SummaryFormat, Trace as Args};
use crate::solve::color_err;
use crate::{FAILED, input, settings};
use scenelang_base::door::Door;
use scenelang_base::{Diagnostic, SourceMap, plain};
use scenelang_engine::check_layout_of;
use scenelang_lang::sources::plain;
use scenelang_lang::{Compiled, Options, compile_main};
use scenelang_verify::report::diagnostics;
use scenelang_verify::trace::{Requirement, Statement, StatementKind, Trace, Verdict, trace};
use scenelang_verify::{Checked, exit_code};
use std::collections::BTreeMap;

/// Traces; 0 if every requirement has a statement and none fails, 1 if not, 2 if program or layout cannot be judged.
pub fn run(args: &Args) -> u8 {
    let name = input::name_of(&args.file);
    let (sources, main) = match input::read(&args.file) {
        Ok(read) => read,
        Err(message) => {
            eprintln!("error: {message}");
            return FAILED;
        }
    };
    let compiled = compile_main(main, Options::default(), &Door::of(&args.file), sources);
    if compiled.has_errors() {
        tell(&compiled.diagnostics, &compiled.sources);
        return FAILED;
    }
    let judged = match judged(args, &name, &compiled) {
        Ok(judged) => judged,
        Err(code) => return code,
    };
    let trace = trace(&name, &compiled, judged.as_ref().map(|(layout, checked)| (layout.as_str(), &checked.report)));
    let text = match args.format {
        SummaryFormat::Human => plain::lines(&human(&trace, args.by)).into_owned(),
        SummaryFormat::Json => match serde_json::to_string(&trace) {
            Ok(text) => text + "\n",
            Err(e) => {
                eprintln!("error: {e}");
                return FAILED;
            }
        },
    };
    // A closed pipe is no reason to fail: whoever reads has seen enough.
    print!("{text}");
    let unjudged = judged.iter().any(|(_, checked)| exit_code(&checked.report) == FAILED);
    if unjudged { FAILED } else { trace.exit_code() }
}

/// The layout that was asked for, or that stands beside the program, judged.
///
/// # Errors
/// An exit code: it is asked for and not there, or the settings cannot be read.
fn judged(args: &Args, name: &str, compiled: &Compiled) -> Result<Option<(String, Checked)>, u8> {
    let path = match &args.layout {
        Some(path) => path.clone(),
        None if input::is_stdin(&args.file) => return Ok(None),
        None => args.file.with_extension("layout.json"),
    };
    if args.layout.is_none() && !path.exists() {
        return Ok(None);
    }
    let layout = path.display().to_string();
    let door = Door::of(&path);
    let bytes = door.read(&path).map_err(|e| format!("cannot read {layout}: {}", plain(&e)));
    let text = bytes.and_then(|bytes| String::from_utf8(bytes).map_err(|_| format!("{layout} is not valid UTF-8")));
    let text = text.map_err(|message| {
        eprintln!("error: {message}");
        FAILED
    })?;
    let (judging, _) = settings::all(&args.judging, &door).map_err(|refused| {
        tell(&refused.diagnostics, &refused.sources);
        FAILED
    })?;
    let program = compiled.sources.get(compiled.main).path();
    let own = Door::of(&args.file);
    let mut checked = check_layout_of(&layout, text, (name, program), &judging.options, Options::default(), &own);
    checked.report.judged_with = judging.with;
    tell(&checked.verdict.diagnostics, &checked.sources);
    Ok(Some((layout, checked)))
}

/// Errors, to standard error.
fn tell(found: &[Diagnostic], sources: &SourceMap) {
    let errors: Vec<Diagnostic> = found.iter().filter(|d| d.is_error()).cloned().collect();
    eprint!("{}", diagnostics(&errors, sources, color_err()));
}

fn human(trace: &Trace, by: By) -> String {
    let mut out = match by {
        By::Requirement => by_requirement(trace),
        By::Object => by_object(trace),
    };
    out.push_str(&summary(trace));
    if let Some(with) = &trace.judged_with {
        out.push_str(&format!("{}\n", with.in_words()));
    }
    out
}

/// First what the request states, then what was inferred, then statements without a requirement.
fn by_requirement(trace: &Trace) -> String {
    let mut out = String::new();
    let stated = trace.requirements.iter().filter(|r| !r.inferred);
    for requirement in stated.chain(trace.requirements.iter().filter(|r| r.inferred)) {
        let Requirement { text, inferred, verdict, declares, statements } = requirement;
        let text = if *inferred { format!("(inferred) {text}") } else { format!("\"{text}\"") };
        out.push_str(&format!("{text}: {}\n", words(*verdict)));
        if !declares.is_empty() {
            out.push_str(&format!("  declares {}\n", declares.join(", ")));
        }
        statements.iter().for_each(|statement| out.push_str(&line(statement, trace.layout.is_some())));
        out.push('\n');
    }
    if !trace.untraced.is_empty() {
        out.push_str("statements without a requirement:\n");
        trace.untraced.iter().for_each(|statement| out.push_str(&line(statement, trace.layout.is_some())));
        out.push('\n');
    }
    out
}

fn by_object(trace: &Trace) -> String {
    let mut out = String::new();
    let stated = trace.requirements.iter().flat_map(|r| &r.statements).chain(&trace.untraced);
    let mut found: BTreeMap<&str, &Statement> = BTreeMap::new();
    let mut order: BTreeMap<&str, usize> = BTreeMap::new();
    for (place, statement) in stated.enumerate() {
        found.entry(&statement.id).or_insert(statement);
        order.entry(&statement.id).or_insert(place);
    }
    for thing in &trace.objects {
        let verdict = match (thing.satisfied, &trace.layout) {
            (Some(true), _) => ": all its hard constraints hold",
            (Some(false), _) => ": some of its hard constraints fail",
            (None, Some(_)) => "",
            (None, None) => ": not checked",
        };
        out.push_str(&format!("{} {}{verdict}\n", thing.kind, thing.name));
        for number in &thing.requirements {
            let requirement = &trace.requirements[*number];
            let reason = if requirement.inferred { "inferred" } else { "required by" };
            out.push_str(&format!("  {reason} \"{}\"\n", requirement.text));
        }
        let mut own: Vec<&str> = thing.statements.iter().map(String::as_str).collect();
        own.sort_by_key(|id| order.get(id));
        own.dedup();
        for statement in own.iter().filter_map(|id| found.get(id)) {
            out.push_str(&line(statement, trace.layout.is_some()));
        }
        out.push('\n');
    }
    out
}

/// A statement on a line: verdict, place, text, objects.
fn line(statement: &Statement, judged: bool) -> String {
    let verdict = match (statement.kind, statement.satisfied) {
        (StatementKind::Allow | StatementKind::Property, _) => "needs no check",
        (_, Some(true)) => "holds",
        (StatementKind::Prefer, Some(false)) => "is not met",
        (_, Some(false)) => "FAILS",
        (_, None) if judged => "cannot be checked",
        (_, None) => "is stated",
    };
    let objects =
        if statement.objects.is_empty() { String::new() } else { format!("  [{}]", statement.objects.join(", ")) };
    format!("  {verdict}  {}  {}{objects}\n", statement.id, statement.text)
}

fn words(verdict: Verdict) -> &'static str {
    match verdict {
        Verdict::Holds => "holds",
        Verdict::Fails => "FAILS",
        Verdict::Unmet => "a preference that is not met",
        Verdict::Unknown => "cannot be checked",
        Verdict::NotJudged => "not checked",
        Verdict::Declared => "declared",
        Verdict::None => "NO STATEMENT",
    }
}

fn summary(trace: &Trace) -> String {
    let s = &trace.summary;
    let counts = [
        (s.holds, ["holds", "hold"]),
        (s.fails, ["fails", "fail"]),
        (s.unmet, ["is a preference that is not met", "are preferences that are not met"]),
        (s.unknown, ["cannot be checked", "cannot be checked"]),
        (s.not_judged, ["is not checked", "are not checked"]),
        (s.declared, ["is declared", "are declared"]),
        (s.none, ["has no statement", "have no statement"]),
    ];
    let counts = counts.iter().filter(|(count, _)| *count > 0);
    let counts: Vec<String> =
        counts.map(|(count, [one, more])| format!("{count} {}", if *count == 1 { one } else { more })).collect();
    let of = match &trace.layout {
        Some(layout) => format!("{}, checked with {layout}", trace.file),
        None => format!("{}, without a layout", trace.file),
    };
    let colon = if counts.is_empty() { "" } else { ": " };
    let requirements = if s.requirements == 1 { "requirement" } else { "requirements" };
    format!("{of}: {} {requirements} ({} inferred){colon}{}\n", s.requirements, s.inferred, counts.join(", "))
}
