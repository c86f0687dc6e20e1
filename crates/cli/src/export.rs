//! `scenelang export`: a layout as it is, in the formats of others.

use crate::args::{Export, SummaryFormat};
use crate::room::Room;
use crate::{FAILED, formats, out, replace};
use scenelang_export::{Loss, losses, unity};
use scenelang_verify::exit_code;
use serde_json::json;
use std::path::{Path, PathBuf};

/// What the outcome as JSON calls itself.
const EXPORT: &str = "scenelang.export/1";

/// Writes the files; 0 if all hard constraints hold.
pub fn run(args: &Export) -> u8 {
    let exported = match export(args) {
        Ok(exported) => exported,
        Err(why) => {
            eprintln!("{why}");
            return FAILED;
        }
    };
    match args.format {
        SummaryFormat::Human => {
            eprint!("{}", formats::notes(&exported.lost));
            for path in exported.written {
                out::show(&format!("{}\n", path.display()));
            }
        }
        SummaryFormat::Json => {
            let files: Vec<String> = exported.written.iter().map(|p| p.display().to_string()).collect();
            let ok = exported.code == 0;
            println!("{}", json!({ "format": EXPORT, "ok": ok, "files": files, "lost": formats::json(&exported.lost) }));
        }
    }
    exported.code
}

/// What came of it.
struct Exported {
    code: u8,
    written: Vec<PathBuf>,
    lost: Vec<Loss>,
}

fn export(args: &Export) -> Result<Exported, String> {
    let room = Room::read(&args.layout, None)?;
    replace::unedited(&args.output, args.force).map_err(|message| format!("error: {message}"))?;
    let scene = room.scene().map_err(|e| format!("error: {e}"))?;
    let chosen = formats::chosen(&args.formats, unity::Pipeline::BuiltIn);
    let mut files = Vec::new();
    // All bytes before the first file.
    for exporter in &chosen {
        files.extend(exporter.files(&scene).map_err(|e| format!("error: {e}"))?);
    }
    let inputs: Vec<&Path> = room.checked.sources.iter().map(|(_, file)| file.path()).collect();
    let written =
        replace::folder(&args.output, &files, &inputs, args.force).map_err(|message| format!("error: {message}"))?;
    Ok(Exported { code: exit_code(&room.checked.report), written, lost: losses(&scene, &chosen) })
}
