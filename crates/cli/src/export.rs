//! `scenelang export`: a layout as it is, in the formats of others.

use crate::args::{Export, SummaryFormat};
use crate::room::Room;
use crate::trial::{self, Trial};
use crate::{FAILED, FINDINGS, formats, out, replace};
use scenelang_export::{Exporter, Loss, losses, mjcf::Mjcf, unity};
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
    /// The file to be tried.
    model: Option<PathBuf>,
}

impl Exported {
    fn json(&self, trial: Option<&Result<Trial, String>>) -> Value {
        let files: Vec<String> = self.written.iter().map(|p| p.display().to_string()).collect();
        let lost = formats::json(&self.lost);
        let mut out = json!({ "format": EXPORT, "ok": self.code == 0, "files": files, "lost": lost });
        if let Some(Ok(trial)) = trial {
            out["trial"] = trial.json();
        }
        out
    }
}

fn human(exported: &Exported, trial: Option<&Result<Trial, String>>) {
    eprint!("{}", formats::notes(&exported.lost));
    for path in &exported.written {
        out::show(&format!("{}\n", path.display()));
    }
    if let Some(Ok(trial)) = trial {
        out::show(&trial.human());
    }
}

fn export(args: &Export) -> Result<Exported, String> {
    let room = Room::read(&args.layout, None)?;
    replace::unedited(&args.output, args.force).map_err(|message| format!("error: {message}"))?;
    let scene = room.scene().map_err(|e| format!("error: {e}"))?;
    let mut chosen = formats::chosen(&args.formats, unity::Pipeline::BuiltIn);
    if args.trial && !chosen.iter().any(|e| e.name() == Mjcf.name()) {
        chosen.push(Box::new(Mjcf));
    }
    let mut files = Vec::new();
    // All bytes before the first file.
    for exporter in &chosen {
        files.extend(exporter.files(&scene).map_err(|e| format!("error: {e}"))?);
    }
    let inputs: Vec<&Path> = room.checked.sources.iter().map(|(_, file)| file.path()).collect();
    let written =
        replace::folder(&args.output, &files, &inputs, args.force).map_err(|message| format!("error: {message}"))?;
    let model = args.trial.then(|| args.output.join(Mjcf::model(&scene)));
    Ok(Exported { code: exit_code(&room.checked.report), written, lost: losses(&scene, &chosen), model })
}
