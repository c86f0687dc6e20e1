//! `scenelang export`: a layout as it is, in the formats of others.

use crate::args::{Export, SummaryFormat};
use crate::edited::{self, Taken};
use crate::rebuild::Rebuild;
use crate::replace::May;
use crate::room::CheckedLayout;
use crate::trial::{self, TrialOutcome};
use crate::{FAILED, FINDINGS, formats, out, replace};
use scenelang_base::FileId;
use scenelang_base::owned::sealed_json;
use scenelang_export::{Exporter, Loss, losses, mjcf::Mjcf, unity, urdf::Urdf};
use scenelang_layout::{Layout, file};
use scenelang_verify::exit_code;
use serde_json::{Value, json};
use std::path::{Path, PathBuf};

/// What the outcome as JSON calls itself.
const EXPORT: &str = "scenelang.export/1";

/// Writes the files; 0 if all hard constraints hold, and with `--try` if the engine finds nothing either.
pub fn run(args: &Export) -> u8 {
    let exported = match export(args) {
        Ok(exported) => exported,
        Err(why) => {
            eprintln!("{why}");
            return FAILED;
        }
    };
    let trial = exported.model.as_deref().map(trial::run);
    match args.format {
        SummaryFormat::Human => human(&exported, trial.as_ref()),
        SummaryFormat::Json => println!("{}", exported.json(trial.as_ref())),
    }
    match trial {
        Some(Err(why)) => {
            eprintln!("error: {why}");
            FAILED
        }
        Some(Ok(trial)) if !trial.holds() => exported.code.max(FINDINGS),
        _ => exported.code,
    }
}

/// What came of it.
struct Exported {
    code: u8,
    written: Vec<PathBuf>,
    lost: Vec<Loss>,
    taken: Option<Taken>,
    /// The file to be tried.
    model: Option<PathBuf>,
    /// What was made again, and why, if that is asked for.
    rebuilt: Option<Rebuilt>,
}

/// What was made again: for people and for programs.
struct Rebuilt {
    text: String,
    json: Value,
}

impl Exported {
    fn json(&self, trial: Option<&Result<TrialOutcome, String>>) -> Value {
        let files: Vec<String> = self.written.iter().map(|p| p.display().to_string()).collect();
        let lost = formats::json(&self.lost);
        let mut out = json!({ "format": EXPORT, "ok": self.code == 0, "files": files, "lost": lost });
        if let Some(taken) = &self.taken {
            out["taken"] = json!({ "from": taken.name, "changes": taken.changes });
        }
        if let Some(Ok(trial)) = trial {
            out["trial"] = trial.json();
        }
        if let Some(rebuilt) = &self.rebuilt {
            out["rebuild"] = rebuilt.json.clone();
        }
        out
    }
}

fn human(exported: &Exported, trial: Option<&Result<TrialOutcome, String>>) {
    eprint!("{}", formats::notes(&exported.lost));
    if let Some(rebuilt) = &exported.rebuilt {
        out::show(&format!("{}\n", rebuilt.text));
    }
    for path in &exported.written {
        out::show(&format!("{}\n", path.display()));
    }
    if let Some(Ok(trial)) = trial {
        out::show(&trial.human());
    }
}

fn export(args: &Export) -> Result<Exported, String> {
    let error = |message: String| format!("error: {message}");
    let mut room = CheckedLayout::read(&args.layout, None)?;
    let mut chosen = chosen(args);
    if args.trial && !chosen.iter().any(|e| e.name() == Mjcf.name()) {
        chosen.push(Box::new(Mjcf));
    }
    let answer = edited::ask(&args.output, &room.stem(), &chosen, args.edits, args.force).map_err(error)?;
    let layout = match &answer.taken {
        Some(taken) => layout_of(&room, taken, args.force).map_err(error)?,
        None => None,
    };
    if let Some(text) = &layout {
        room = room.with_layout(text)?;
    }
    let scene = room.scene().map_err(error)?;
    let stem = room.stem();
    let mut rebuild = Rebuild::of(&args.output, &stem, None);
    // All bytes before the first file.
    let planned = rebuild.formats(&scene, &chosen, &mut |_| true).map_err(error)?.unwrap_or_default();
    let inputs: Vec<&Path> = room.checked.sources.iter().map(|(_, file)| file.path()).collect();
    let may = May { force: args.force, these: &answer.replaced };
    let mut written = Vec::new();
    if let Some(text) = &layout {
        replace::permit_folder(&args.output, &planned.files, &inputs, may).map_err(error)?;
        // The layout first: if anything ends the command then, the edited scene is still there to be taken again.
        replace::layouts(&[(&room.path, text)], |_| true).map_err(error)?;
        written.push(room.path.clone());
    }
    written.extend(rebuild.write(Vec::new(), planned, &inputs, may, false).map_err(error)?);
    let model = args.trial.then(|| args.output.join(Mjcf::model(&scene)));
    let (code, lost) = (exit_code(&room.checked.report), losses(&scene, &chosen));
    let told = &rebuild.told;
    let told = || Rebuilt { text: told.human(&args.output), json: told.json(&args.output) };
    let rebuilt = args.explain_rebuild.then(told);
    Ok(Exported { code, written, lost, taken: answer.taken, model, rebuilt })
}

/// The exporters asked for. One object alone is no scene, so that nothing else is written with it unless it is named.
fn chosen(args: &Export) -> Vec<Box<dyn Exporter>> {
    let Some(object) = &args.object else {
        return formats::chosen(&args.formats, unity::Pipeline::BuiltIn, &args.output);
    };
    let named = args.formats.all_formats || !args.formats.only.is_empty();
    let mut out =
        if named { formats::chosen(&args.formats, unity::Pipeline::BuiltIn, &args.output) } else { Vec::new() };
    out.push(Box::new(Urdf { object: object.clone() }));
    out
}

/// The text of the layout file with what was edited in an exported scene; `None`: it says the same as before.
fn layout_of(room: &CheckedLayout, taken: &Taken, force: bool) -> Result<Option<String>, String> {
    let (path, name) = (room.path.display(), &taken.name);
    let [old, was, now] =
        [room.text(), &taken.scene.exported, &taken.scene.layout].map(|text| file::read(text, FileId(0)));
    if !now.usable || now.diagnostics.iter().any(scenelang_base::Diagnostic::is_error) {
        return Err(format!("the layout in {name} cannot be used; `scenelang check {name}` says why"));
    }
    let says = |layout: &Layout| {
        let Layout { objects, regions, variables, draws, .. } = layout.clone();
        (objects, regions, variables, draws)
    };
    let is_edited = taken.is_rewritten || says(&now.layout) != says(&was.layout);
    if !is_edited || says(&now.layout) == says(&old.layout) {
        return Ok(None);
    }
    // Of what was edited by itself nobody knows what it was before.
    if !taken.is_rewritten && says(&was.layout) != says(&old.layout) {
        return Err(format!(
            "{path} is no longer the layout that {name} was exported from, so the edits made there cannot be merged into \
             it; use `scenelang import {name} -o FOLDER` to write the layout of the scene, or --overwrite to discard the edits"
        ));
    }
    let is_ours = replace::is_ours(&room.path, room.text());
    if !is_ours && !force {
        return Err(format!(
            "the edits made in {name} would have to be written to {path}, which was itself edited or which scenelang did not \
             write, so it is left unchanged; use --force to write to it"
        ));
    }
    let layout = Layout { scene: old.layout.scene.clone(), ..now.layout };
    let text = file::checked(&room.path, &layout, Some(&old.document)).map_err(|e| e.to_string())?;
    Ok(Some(if is_ours { sealed_json(&text) } else { text }))
}
