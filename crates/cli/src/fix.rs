//! `check --fix`: makes the safe fixes before the judgement.

use scenelang_lang::mend::mend;
use scenelang_lang::sources::Disk;
use scenelang_verify::program_of;
use scenelang_verify::report::model::Fixed;
use std::io::Write;
use std::path::Path;

/// Makes the safe fixes in a program, or in that of a layout, and writes the files that they change, each whole or not at
/// all. To `out` it says how many there were.
///
/// # Errors
/// What the file system says of a file that cannot be written.
pub fn run(path: &Path, compile: scenelang_lang::Options, out: Option<&mut impl Write>) -> std::io::Result<Vec<Fixed>> {
    // A layout without a program is an error that the check reports.
    let Some((name, path)) = program_of(&path.display().to_string(), path) else { return Ok(Vec::new()) };
    let mended = mend(&name, &path, compile, &Disk);
    let mut fixed = Vec::new();
    for file in &mended.files {
        scenelang_base::fs::write_whole(&file.path, file.text.as_bytes())?;
        let made = file.made.iter();
        fixed.extend(made.map(|m| Fixed {
            file: file.name.clone(),
            line: m.line,
            code: m.code.to_string(),
            title: m.title.clone(),
        }));
    }
    if let Some(out) = out {
        // A closed pipe is no reason to fail, as for the report.
        let _ = mended.files.iter().try_for_each(|file| {
            let (made, all) = (file.made.len(), file.made.len() + file.left);
            let plural = if all == 1 { "" } else { "s" };
            writeln!(out, "fixed {made} of {all} finding{plural} in {}", file.name)
        });
        let _ = match mended.refused {
            0 => Ok(()),
            n => writeln!(out, "{n} not fixed, since what they change overlaps"),
        };
        let _ = mended
            .foreign
            .iter()
            .try_for_each(|name| writeln!(out, "{name} is outside the program's folder and stays as it is"));
    }
    Ok(fixed)
}
