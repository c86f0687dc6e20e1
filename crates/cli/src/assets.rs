//! `scenelang assets`: what things will look like, from the furniture library and from a folder of the user's own models.

use crate::args::{AssetsCheck, AssetsFormat, AssetsImport, AssetsList, AssetsQueries, AssetsSearch, Plain};
use crate::replace::{self, May};
use crate::solve::color_err;
use crate::table::Table;
use crate::{FAILED, FINDINGS, GOOD, input, out};
use scenelang_assets::family_of;
use scenelang_base::door::Door;
use scenelang_base::{Diagnostic, Severity, SourceMap, plain};
use scenelang_catalogue::{
    Catalogue, Checked as Found, Entry, Hit, Imported, Index, Query, check as look_at, import as read_all,
};
use scenelang_export::OutFile;
use scenelang_lang::compile_main;
use scenelang_lang::library::usual_size;
use scenelang_layout::Vec3;
use scenelang_verify::report::{self, diagnostics};
use scenelang_verify::{Checked, Options};
use serde_json::{Value, json};
use std::path::{Path, PathBuf};

/// What would be drawn for some words, and which models of a folder fit them.
pub fn search(args: &AssetsSearch) -> u8 {
    let family = family_of(&args.words, "");
    let usual = usual_size(&args.words);
    let wanted = args.size.or(usual).map(Vec3::from);
    let catalogue = match args.folder.as_deref().map(open).transpose() {
        Ok(catalogue) => catalogue,
        Err(code) => return code,
    };
    let entries = catalogue.as_ref().map_or(&[][..], |c| c.entries.as_slice());
    // Words that features were computed for are judged by them.
    let features = catalogue.as_ref().and_then(|c| c.features.as_ref());
    let published = features.and_then(|f| f.search(entries, &args.words, usize::from(args.most)));
    let by = if published.is_some() { "features" } else { "words" };
    let hits = published.unwrap_or_else(|| Index::of(entries).search(&args.words, wanted, usize::from(args.most)));
    match args.format {
        Plain::Json => {
            let model = |hit: &Hit| {
                let mut row = described(&entries[hit.entry]);
                row["score"] = json!(hit.score);
                row
            };
            let found = json!({
                "format": "scenelang.assets/1",
                "words": args.words,
                "by": by,
                "size": wanted.map(|s| [s.x, s.y, s.z]),
                "library": { "family": family, "size": usual },
                "models": hits.iter().map(model).collect::<Vec<_>>(),
                "refused": catalogue.as_ref().map_or_else(|| json!([]), refused),
            });
            out::show(&format!("{found}\n"));
        }
        Plain::Text => {
            out::show(&library(family, usual));
            if args.folder.is_some() && hits.is_empty() {
                out::show("no model in the folder matches these words\n");
            } else if !hits.is_empty() {
                let mut table = Table::new(&["score", "model", "category", "size", "description"]);
                for hit in &hits {
                    let entry = &entries[hit.entry];
                    let [file, category, description] = [&entry.file, &entry.card.category, &entry.card.description]
                        .map(|t| plain::line(t).into_owned());
                    table.row([format!("{:.3}", hit.score), file, category, sized(entry.size), description]);
                }
                out::show(&table.render());
            }
            catalogue.iter().for_each(warn);
        }
    }
    if family.is_none() && hits.is_empty() { FINDINGS } else { GOOD }
}

/// What the furniture library would draw, in a sentence.
fn library(family: Option<&str>, usual: Option<[f64; 3]>) -> String {
    let size = match usual {
        Some(size) => format!("usually {}", sized(Some(size.into()))),
        None => "no usual size is known".to_owned(),
    };
    match family {
        Some(family) => format!("the furniture library has a generator for it: {family}; {size}\n"),
        None => format!("the library would draw a labelled box; {size}\n"),
    }
}

/// The models of a folder.
pub fn list(args: &AssetsList) -> u8 {
    let catalogue = match open(&args.folder) {
        Ok(catalogue) => catalogue,
        Err(code) => return code,
    };
    match args.format {
        Plain::Json => {
            let models: Vec<Value> = catalogue.entries.iter().map(described).collect();
            let found = json!({ "format": "scenelang.assets/1", "models": models, "refused": refused(&catalogue) });
            out::show(&format!("{found}\n"));
        }
        Plain::Text => {
            let mut table = Table::new(&["model", "category", "size", "licence"]);
            for entry in &catalogue.entries {
                let licence = entry.card.licence.as_deref().unwrap_or("–");
                let [file, category, licence] =
                    [&entry.file, &entry.card.category, licence].map(|t| plain::line(t).into_owned());
                table.row([file, category, sized(entry.size), licence]);
            }
            out::show(&table.render());
            warn(&catalogue);
        }
    }
    if catalogue.refused.is_empty() { GOOD } else { FAILED }
}

/// What is wrong with the models of a folder.
pub fn check(args: &AssetsCheck) -> u8 {
    let folder = args.folder.display().to_string();
    let usual = |category: &str| usual_size(category).map(Vec3::from);
    let checked = match look_at(&args.folder, &usual) {
        Ok(checked) => checked,
        Err(finding) => return fail(&folder, &finding),
    };
    let code = |findings: &[Diagnostic]| match findings.iter().map(|d| d.severity).min() {
        None => GOOD,
        Some(Severity::Warning) => FINDINGS,
        Some(Severity::Error) => FAILED,
    };
    let worst = checked.iter().map(|c| code(&c.findings)).max().unwrap_or(GOOD);
    let (total, bad) = (checked.len(), checked.iter().filter(|c| !c.findings.is_empty()).count());
    // `./chair.glb` would look odd in a report.
    let here = args.folder == Path::new(".");
    let name = |file: &str| if here { file.to_owned() } else { args.folder.join(file).display().to_string() };
    if args.format == AssetsFormat::Human {
        let lines = |c: &Found| -> String { c.findings.iter().map(|d| in_words(&name(&c.file), d)).collect() };
        out::show(&checked.iter().map(lines).collect::<String>());
        let models = if total == 1 { "model" } else { "models" };
        out::show(&format!("{folder}: {total} {models} checked, {bad} with findings\n"));
        return worst;
    }
    let judged = |c: Found| Checked::refused(&name(&c.file), SourceMap::new(), c.findings, &Options::default());
    let judged: Vec<Checked> = checked.into_iter().map(judged).collect();
    match args.format {
        AssetsFormat::Sarif => println!("{}", report::sarif(&judged)),
        _ => judged.iter().for_each(|checked| println!("{}", report::json(&checked.report))),
    }
    worst
}

/// Writes the models of a folder as a catalogue.
pub fn import(args: &AssetsImport) -> u8 {
    let folder = args.folder.display().to_string();
    if let Err(message) = replace::unedited(&args.output, args.force) {
        eprintln!("error: {message}");
        return FAILED;
    }
    let imported = match read_all(&args.folder) {
        Ok(imported) => imported,
        Err(finding) => return fail(&folder, &finding),
    };
    let mut files = Vec::new();
    for kept in imported.iter().filter_map(|i| i.outcome.as_ref().ok()) {
        let card = format!("{:#}\n", kept.card);
        files.push(OutFile::new(Path::new(&kept.name), kept.glb.clone()));
        files.push(OutFile::new(Path::new(&kept.name).with_extension("json"), card));
    }
    let inputs: Vec<PathBuf> = imported.iter().map(|i| args.folder.join(&i.file)).collect();
    let inputs: Vec<&Path> = inputs.iter().map(PathBuf::as_path).collect();
    let good = files.len() / 2;
    if good > 0
        && let Err(message) = replace::folder(&args.output, &files, &inputs, May { force: args.force, these: &[] })
    {
        eprintln!("error: {message}");
        return FAILED;
    }
    match args.format {
        Plain::Json => {
            let row = |i: &Imported| match &i.outcome {
                Ok(kept) => json!({ "file": i.file, "model": kept.name, "parts": kept.parts, "card": kept.card }),
                Err(d) => json!({ "file": i.file, "model": null, "code": d.code.as_str(), "message": d.message }),
            };
            let rows: Vec<Value> = imported.iter().map(row).collect();
            out::show(&format!("{}\n", json!({ "format": "scenelang.assets/1", "imported": rows })));
        }
        Plain::Text => {
            let mut table = Table::new(&["file", "model", "size", "parts"]);
            for (file, kept) in imported.iter().filter_map(|i| Some((&i.file, i.outcome.as_ref().ok()?))) {
                let size: Option<[f64; 3]> = serde_json::from_value(kept.card["size"].clone()).ok();
                let [file, name] = [file, &kept.name].map(|t| plain::line(t).into_owned());
                table.row([file, name, sized(size.map(Vec3::from)), kept.parts.to_string()]);
            }
            out::show(&table.render());
            for (file, finding) in imported.iter().filter_map(|i| Some((&i.file, i.outcome.as_ref().err()?))) {
                eprint!("{}", in_words(file, finding));
            }
            let into = args.output.display();
            out::show(&format!("{good} of {} models were written to {into}\n", imported.len()));
        }
    }
    if good == imported.len() { GOOD } else { FAILED }
}

/// What a program asks providers for, each text once.
pub fn queries(args: &AssetsQueries) -> u8 {
    let mut texts: Vec<String> = Vec::new();
    for file in &args.files {
        let read = match input::read(file) {
            Ok((sources, main)) => compile_main(main, scenelang_lang::Options::default(), &Door::of(file), sources),
            Err(message) => {
                eprintln!("error: {message}");
                return FAILED;
            }
        };
        let Some(program) = &read.program else {
            eprint!("{}", diagnostics(&read.diagnostics, &read.sources, color_err()));
            return FAILED;
        };
        for text in scenelang_synth::queries(program).iter().map(Query::published) {
            if !texts.contains(&text) {
                texts.push(text);
            }
        }
    }
    match args.format {
        Plain::Json => out::show(&format!("{}\n", json!(texts))),
        Plain::Text => out::show(&texts.iter().map(|text| format!("{}\n", plain::line(text))).collect::<String>()),
    }
    GOOD
}

/// A finding for people: a line that says what it is, and one for each thing to do.
fn in_words(file: &str, finding: &Diagnostic) -> String {
    let Diagnostic { code, severity, message, notes, .. } = finding;
    let head = format!("{file}: {}[{code}]: {message}", severity.as_str());
    let notes = notes.iter().map(|note| format!("  {note}"));
    std::iter::once(head).chain(notes).map(|line| format!("{}\n", plain::line(&line))).collect()
}

/// Opens a folder; the exit code where that cannot be done.
fn open(folder: &Path) -> Result<Catalogue, u8> {
    Catalogue::open(folder).map_err(|finding| fail(&folder.display().to_string(), &finding))
}

fn fail(folder: &str, finding: &Diagnostic) -> u8 {
    let mut finding = finding.clone();
    finding.message = format!("{folder}: {}", finding.message);
    eprint!("{}", diagnostics(&[finding], &SourceMap::new(), false));
    FAILED
}

/// Tells of what is passed over.
fn warn(catalogue: &Catalogue) {
    for refused in &catalogue.refused {
        eprintln!("warning: {} was skipped: {}", refused.file, refused.finding.message);
    }
}

fn refused(catalogue: &Catalogue) -> Value {
    let row = |r: &scenelang_catalogue::Refused| json!({ "file": r.file, "code": r.finding.code.as_str(), "message": r.finding.message });
    catalogue.refused.iter().map(row).collect()
}

/// A model for programs.
fn described(entry: &Entry) -> Value {
    let card = &entry.card;
    json!({
        "file": entry.file,
        "category": card.category,
        "description": card.description,
        "materials": card.materials,
        "size": entry.size.map(|s| [s.x, s.y, s.z]),
        "mass": card.mass,
        "licence": card.licence,
    })
}

/// A size as it is written for people.
fn sized(size: Option<Vec3>) -> String {
    size.map_or_else(|| "unknown".to_owned(), |s| format!("{:.2} × {:.2} × {:.2} m", s.x, s.y, s.z))
}

/// `--size`: width, height and depth.
pub fn size(text: &str) -> Result<[f64; 3], String> {
    let numbers: Option<Vec<f64>> = text.split(['x', '×']).map(|n| n.trim().parse().ok()).collect();
    let size: Option<[f64; 3]> = numbers.and_then(|n| n.try_into().ok());
    size.filter(|s| s.iter().all(|x| x.is_finite() && *x > 0.0))
        .ok_or_else(|| "a size is written WxHxD in metres, such as 0.5x0.9x0.5".to_owned())
}
