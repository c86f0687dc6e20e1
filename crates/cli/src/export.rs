//! `scenelang export`: a layout as it is, in the formats of others.

use crate::args::Export;
use crate::room::Room;
use crate::{FAILED, interrupt, out};
use scenelang_base::door::Door;
use scenelang_export::exporters;
use scenelang_verify::exit_code;
use std::path::PathBuf;

/// Writes the files; 0 if all hard constraints hold.
pub fn run(args: &Export) -> u8 {
    interrupt::listen();
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
    let scene = room.scene().map_err(|e| format!("error: {e}"))?;
    let mut files = Vec::new();
    // All bytes before the first file.
    for exporter in exporters().iter().filter(|e| args.only.is_empty() || args.only.iter().any(|o| o == e.name())) {
        files.extend(exporter.files(&scene).map_err(|e| format!("error: {e}"))?);
        if interrupt::asked() {
            return Err("interrupted; nothing is written".to_owned());
        }
    }
    let door = Door::within(&args.output);
    let mut written = Vec::with_capacity(files.len());
    for file in files {
        let path = args.output.join(&file.path);
        door.write(&path, &file.bytes).map_err(|e| format!("error: {e}"))?;
        written.push(path);
    }
    Ok((exit_code(&room.checked.report), written))
}

/// `--only`: the name of an exporter.
pub fn format(text: &str) -> Result<String, String> {
    let all = exporters();
    let names: Vec<_> = all.iter().map(|e| e.name()).collect();
    if names.contains(&text) { Ok(text.to_owned()) } else { Err(format!("there are {}", names.join(", "))) }
}
