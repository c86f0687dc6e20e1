//! `check --fix`: makes the safe fixes before the judgement.

use scenelang_lang::mend::mend;
use scenelang_lang::sources::Disk;
use scenelang_verify::program_of;
use scenelang_verify::report::model::Fixed;
use std::path::Path;

/// Makes the safe fixes in a program, or in that of a layout, and writes the files that they change, each whole or not at
/// all. With `tell` it prints how many there were.
///
/// # Errors
/// What the file system says of a file that cannot be written.
pub fn run(path: &Path, compile: scenelang_lang::Options, tell: bool) -> std::io::Result<Vec<Fixed>> {
    // A layout without a program is an error that the check reports.
    let Some((name, path)) = program_of(&path.display().to_string(), path) else { return Ok(Vec::new()) };
    let mended = mend(&name, &path, compile, &Disk);
    let mut fixed = Vec::new();
    let set: Vec<_> = mended.files.iter().map(|file| (file.path.clone(), file.text.as_bytes())).collect();
    scenelang_base::fs::write_set(&set)?;
    for file in &mended.files {
        let made = file.made.iter();
        fixed.extend(made.map(|m| Fixed {
            file: file.name.clone(),
            line: m.line,
            code: m.code.to_string(),
            title: m.title.clone(),
        }));
    }
    if tell {
        for file in &mended.files {
            let (made, all) = (file.made.len(), file.made.len() + file.left);
            let plural = if all == 1 { "" } else { "s" };
            println!("fixed {made} of {all} finding{plural} in {}", file.name);
        }
        if mended.refused > 0 {
            println!("{} not fixed, since what they change overlaps", mended.refused);
        }
        for name in &mended.foreign {
            println!("{name} is outside the program's folder and stays as it is");
        }
    }
    Ok(fixed)
}
