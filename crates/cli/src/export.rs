//! `scenelang export`: a layout as it is, in the formats of others.

use crate::args::Export;
use crate::room::Room;
use crate::{FAILED, out, replace};
use scenelang_export::exporters;
use scenelang_verify::exit_code;
use std::path::{Path, PathBuf};

/// Writes the files; 0 if all hard constraints hold.
pub fn run(args: &Export) -> u8 {
    match export(args) {
        Ok((code, written)) => {
            for path in written {
                out::show(&format!("{}\n", path.display()));
            }
            code
        }
        Err(why) => {
            eprintln!("{why}");
            FAILED
        }
    }
}

fn export(args: &Export) -> Result<(u8, Vec<PathBuf>), String> {
    let room = Room::read(&args.layout, None)?;
    replace::unedited(&args.output, args.force).map_err(|message| format!("error: {message}"))?;
    let scene = room.scene().map_err(|e| format!("error: {e}"))?;
    let mut files = Vec::new();
    // All bytes before the first file.
    for exporter in exporters().iter().filter(|e| args.only.is_empty() || args.only.iter().any(|o| o == e.name())) {
        files.extend(exporter.files(&scene).map_err(|e| format!("error: {e}"))?);
    }
    let inputs: Vec<&Path> = room.checked.sources.iter().map(|(_, file)| file.path()).collect();
    let written =
        replace::folder(&args.output, &files, &inputs, args.force).map_err(|message| format!("error: {message}"))?;
    Ok((exit_code(&room.checked.report), written))
}

/// `--only`: the name of an exporter.
pub fn format(text: &str) -> Result<String, String> {
    let all = exporters();
    let names: Vec<_> = all.iter().map(|e| e.name()).collect();
    if names.contains(&text) { Ok(text.to_owned()) } else { Err(format!("there are {}", names.join(", "))) }
}
