//! `check --fix` and `check --unsafe-fixes`: fixes are made before the judgement.

use crate::out;
use scenelang_base::Applicability;
use scenelang_base::door::Door;
use scenelang_engine::program_of;
use scenelang_lang::fixes::fix_all;
use scenelang_verify::report::model::Fixed;
use std::path::Path;

/// Makes the fixes in a program, or in that of a layout, up to those that are guesses, and writes the files that they change, each whole or not at
/// all. With `tell` it prints how many there were.
///
/// # Errors
/// What the file system says of a file that cannot be written.
pub fn run(
    path: &Path,
    compile: scenelang_lang::Options,
    up_to: Applicability,
    door: &Door,
    tell: bool,
) -> std::io::Result<Vec<Fixed>> {
    // A layout without a program is an error that the check reports.
    let Some((name, program)) = program_of(&path.display().to_string(), path, door) else { return Ok(Vec::new()) };
    let outcome = fix_all(&name, &program, compile, up_to, door);
    // What a layout or an import names may be anything.
    let is_ours = |file: &Path| file == path || file.extension().is_some_and(|e| e.eq_ignore_ascii_case("scene"));
    let mut fixed = Vec::new();
    let ours: Vec<_> = outcome.files.iter().filter(|file| is_ours(&file.path)).collect();
    ours.iter().try_for_each(|file| door.permits(&file.path))?;
    let set: Vec<_> = ours.iter().map(|file| (file.path.clone(), file.text.as_bytes())).collect();
    scenelang_base::fs::write_set(&set)?;
    for file in ours {
        let made = file.made.iter();
        fixed.extend(made.map(|m| Fixed {
            file: file.name.clone(),
            line: m.line,
            code: m.code.to_string(),
            title: m.title.clone(),
        }));
    }
    if tell {
        for file in outcome.files.iter().filter(|file| is_ours(&file.path)) {
            let (made, all) = (file.made.len(), file.made.len() + file.left);
            let plural = if all == 1 { "" } else { "s" };
            out::show(&format!("fixed {made} of {all} finding{plural} in {}\n", file.name));
        }
        if outcome.refused > 0 {
            println!("{} fixes were not applied, because they overlap with others", outcome.refused);
        }
        for name in &outcome.foreign {
            out::show(&format!("{name} is outside the program's folder and was not changed\n"));
        }
    }
    Ok(fixed)
}
