//! `scenelang repair`: the smallest changes that repair a layout, and one of them made.

use crate::args::{Plain, Repair};
use crate::progress::Progress;
use crate::solve::color_err;
use crate::{FAILED, FINDINGS, GOOD, interrupt, out, replace, settings};
use scenelang_base::FileId;
use scenelang_base::door::{Door, Named};
use scenelang_base::fs::{is_same, write_set};
use scenelang_base::owned::sealed_json;
use scenelang_engine::{check_file_with, program_of};
use scenelang_layout::file as layout_file;
use scenelang_solve::repair::told::{AlternativesReport, rows};
use scenelang_solve::repair::{
    Alternative, Damaged, How, RepairOptions, Repaired, Text, Unjudged, Which, edited, repair as look,
};
use scenelang_synth::Hold;
use scenelang_verify::report;
use scenelang_verify::{Checked, Explain};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

/// The part of the time that the search may take.
const SEARCH: f64 = 0.6;

/// Repairs; 0 if the layout holds or can be repaired, 1 if not without asking, 2 if it cannot be judged.
pub fn run(args: &Repair) -> u8 {
    interrupt::within(args.time.map(Duration::from_secs_f64));
    match repair(args) {
        Ok(code) => code,
        Err(message) => {
            eprintln!("error: {message}");
            FAILED
        }
    }
}

fn repair(args: &Repair) -> Result<u8, String> {
    let begun = Instant::now();
    let name = args.layout.display().to_string();
    if !args.layout.extension().is_some_and(|e| e.eq_ignore_ascii_case("json")) {
        return Err(format!("{name} is not a layout; `repair` takes a layout"));
    }
    let named = Named::new(std::iter::once(args.layout.as_path()));
    let door = &Door::of(&args.layout).named(&named);
    let (judging, _) = match settings::all(&args.judging, door) {
        Ok(both) => both,
        Err(refused) => {
            eprint!("{}", report::diagnostics(&refused.diagnostics, &refused.sources, color_err()));
            return Ok(FAILED);
        }
    };
    let mut options = judging.options;
    options.detail.explain = Explain::First(0);
    let mut checked = check_file_with(&name, &args.layout, &options, scenelang_lang::Options::default(), door);
    checked.silence(&judging.allow);
    checked.report.judged_with = judging.with;
    let errors: Vec<_> = checked.verdict.diagnostics.iter().filter(|d| d.is_error()).cloned().collect();
    eprint!("{}", report::diagnostics(&errors, &checked.sources, color_err()));
    let (Some(program), Some(layout), Some((main, path))) =
        (&checked.program, &checked.layout, program_of(&name, &args.layout, door))
    else {
        return Ok(FAILED);
    };
    if !errors.is_empty() {
        return Ok(FAILED);
    }
    if let Some(output) = args.output.as_ref().filter(|output| !is_same(output, &args.layout)) {
        replace::permit(output, &[&path], args.force)?;
    }
    if let Some(finding) = scenelang_synth::too_large(program) {
        eprint!("{}", report::diagnostics(&[finding], &checked.sources, color_err()));
        return Ok(FAILED);
    }
    let which = match &args.constraint {
        None => Which::All,
        Some(asked) => Which::Rows(rows(&checked, &main, asked)?),
    };
    let locked = match Hold::These(&args.lock).objects(program, Some(layout)) {
        Ok(locked) => locked,
        Err(finding) => {
            eprint!("{}", report::diagnostics(&[*finding], &checked.sources, color_err()));
            return Ok(FAILED);
        }
    };
    let text = Text {
        name: &main,
        path: &path,
        compile: scenelang_lang::Options::default(),
        loader: door,
        sources: &checked.sources,
    };
    let damaged = Damaged { program, layout, text: Some(text) };
    let progress = Progress::new(format!("repairing {name}"));
    // The rest is for what was found to be judged and written.
    let time = args.time.map(|time| Duration::from_secs_f64(SEARCH * time).saturating_sub(begun.elapsed()));
    let found = look(&damaged, &which, &RepairOptions { judge: options, time, locked, ..RepairOptions::default() });
    drop(progress);
    let found = found.map_err(|Unjudged| format!("{name} cannot be checked completely; `scenelang check` says why"))?;
    let choice = choose(args, &found)?;
    let mut written = Vec::new();
    if let Some(chosen) = choice.filter(|_| !args.dry_run) {
        written = apply(args, door, &checked, &found.alternatives[chosen])?;
    }
    let told = AlternativesReport { checked: &checked, program, name: &name };
    let all_holds = found.failing.is_empty();
    match args.format {
        Plain::Json => {
            let applied = choice.filter(|_| !args.dry_run).map(|i| i + 1);
            println!("{}", told.json(&found, applied, &written));
        }
        Plain::Text => out::show(&for_people(&told, &found, choice, args, &written)),
    }
    Ok(if all_holds || choice.is_some() { GOOD } else { FINDINGS })
}

/// The answer for people.
fn for_people(
    told: &AlternativesReport<'_>,
    found: &Repaired,
    choice: Option<usize>,
    args: &Repair,
    written: &[String],
) -> String {
    let with = told.checked.report.judged_with.as_ref().map_or(String::new(), |with| with.in_words() + "\n");
    let Repaired { failing, contradiction, alternatives: all } = found;
    if failing.is_empty() {
        return format!("{}: nothing to repair\n{with}", told.name);
    }
    let mut out = String::new();
    for (id, _, text) in told.failing(failing) {
        let text = text.split_whitespace().collect::<Vec<_>>().join(" ");
        let text = what_fails(&id, text);
        out += &format!("fails: {id}: {text}\n");
    }
    if let Some(found) = contradiction {
        // What is proved of usual layouts holds for those that a search would try.
        let upright = if found.as_usual { " in which things stand upright" } else { "" };
        out += &format!("no layout{upright} satisfies all of these statements:\n");
        for (id, text) in told.members(found) {
            out += &format!("     {id} `{text}`\n");
        }
    }
    for (i, a) in all.iter().enumerate() {
        out += &format!("{:3}  {}\n", i + 1, told.words(a));
    }
    out + &match (choice, all.is_empty()) {
        (_, true) if contradiction.is_some() => "change or remove one of them\n".to_owned(),
        (_, true) => "no repair was found, which is not a proof that none exists\n".to_owned(),
        (None, false) => "nothing was written; use --apply N to apply one of these repairs\n".to_owned(),
        (Some(i), _) if args.dry_run => format!("repair {} would be applied; nothing was written\n", i + 1),
        (Some(i), _) => format!("repair {} applied; {} written\n", i + 1, written.join(", ")),
    } + &with
}

/// What a physical rule says, as it fails: "fails: they do not collide" would have to be read twice.
fn what_fails(id: &str, text: String) -> String {
    let reversed = [
        ("P-COLLIDE:", " do not collide", " collide"),
        ("P-SUPPORT:", " is supported", " is not supported"),
        ("P-BOUNDS:", " is inside a region", " is not inside a region"),
        ("P-OPEN:", " opens ", " does not open "),
    ];
    match reversed.into_iter().find(|(rule, ..)| id.starts_with(rule)) {
        Some((_, says, fails)) => text.replacen(says, fails, 1),
        None => text,
    }
}

/// The alternative to be made: what was asked for, else the first, if it moves things and no more.
fn choose(args: &Repair, found: &Repaired) -> Result<Option<usize>, String> {
    let alternatives = &found.alternatives;
    match args.apply.map(usize::from) {
        None => Ok(alternatives.first().filter(|a| a.how == How::Moves).map(|_| 0)),
        Some(n) if n <= alternatives.len() => Ok(Some(n - 1)),
        Some(n) => Err(no_repair(n, found)),
    }
}

/// That there is no repair of a number.
pub fn no_repair(n: usize, found: &Repaired) -> String {
    match found.alternatives.len() {
        0 if found.failing.is_empty() => format!("there is no repair number {n}: nothing needs repair"),
        0 => format!("there is no repair number {n}: no repair was found"),
        1 => format!("there is no repair number {n}; there is only 1 repair"),
        more => format!("there is no repair number {n}; there are only {more} repairs"),
    }
}

/// The programs that an alternative changes, as they will be: name, file and text.
///
/// # Errors
/// Its edits overlap, or a file may not be written.
pub fn programs(
    door: &Door,
    checked: &Checked,
    chosen: &Alternative,
) -> Result<Vec<(String, PathBuf, String)>, String> {
    let texts = edited(&checked.sources, &chosen.edits).ok_or("the edits overlap")?;
    let changed = texts.into_iter().map(|(id, text)| {
        let source = checked.sources.get(id);
        door.permits(source.path()).map_err(|e| e.to_string())?;
        Ok((source.name().to_owned(), source.path().to_path_buf(), text))
    });
    changed.collect()
}

/// Whether an alternative changes the layout.
pub fn changes_layout(chosen: &Alternative) -> bool {
    !chosen.moves.is_empty() || !chosen.also.is_empty()
}

/// Writes what an alternative changes, all of it or nothing. Which files.
fn apply(args: &Repair, door: &Door, checked: &Checked, chosen: &Alternative) -> Result<Vec<String>, String> {
    let (mut names, mut files) = (Vec::new(), Vec::new());
    for (name, path, text) in programs(door, checked, chosen)? {
        names.push(name);
        files.push((path, text));
    }
    let output = args.output.as_ref().unwrap_or(&args.layout);
    if changes_layout(chosen) || args.output.is_some() {
        let same = |path: &Path| path == args.layout;
        let old = checked.sources.iter().find(|(_, source)| same(source.path())).map(|(_, source)| source.text());
        let text = old.unwrap_or_default();
        let old = layout_file::read(text, FileId(0));
        let mut layout = chosen.layout.clone();
        // What a search has left undone is done, if all of it holds now.
        layout.incomplete &= args.constraint.is_some();
        if let (Some(_), Some((_, scene))) =
            (&args.output, program_of(&args.layout.display().to_string(), &args.layout, door))
        {
            layout.scene = Some(crate::solve::relative(&scene, output));
        }
        let new = layout_file::checked(output, &layout, old.usable.then_some(&old.document));
        let new = new.map_err(|e| e.to_string())?;
        // What was edited by hand is still in it, and in no other file.
        let ours = !is_same(output, &args.layout) || replace::is_ours(&args.layout, text);
        files.push((output.clone(), if ours { sealed_json(&new) } else { new }));
        names.push(output.display().to_string());
    }
    let set: Vec<_> = files.iter().map(|(path, text)| (path.clone(), text.as_bytes())).collect();
    write_set(&set).map_err(|e| e.to_string())?;
    Ok(names)
}
