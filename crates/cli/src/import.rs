//! `scenelang import`: the program and the layout of a GLB file, a USD file or a Unity project, as the scene stands
//! there now; and of a house or a layout of another system, as far as that says it.

use crate::args::Import;
use crate::replace::May;
use crate::solve::color_err;
use crate::targets::{JudgeTarget, find};
use crate::{FAILED, GOOD, foreign, out, replace};
use scenelang_base::door::{Door, Named, relative};
use scenelang_base::{Diagnostic, SourceMap, plain};
use scenelang_export::OutFile;
use scenelang_export::embedded::{self, Embedded};
use scenelang_verify::report;
use std::path::{Component, Path, PathBuf};

/// Writes the files; 0 if they are written, 2 if not.
pub fn run(args: &Import) -> u8 {
    match import(args) {
        Ok(written) => {
            written.iter().for_each(|path| out::show(&format!("{}\n", path.display())));
            GOOD
        }
        Err(why) => {
            eprintln!("error: {why}");
            FAILED
        }
    }
}

fn import(args: &Import) -> Result<Vec<PathBuf>, String> {
    let targets = find(std::slice::from_ref(&args.scene));
    let (path, kind) = match targets.as_slice() {
        [JudgeTarget::Carrier(path, kind)] => (path, kind),
        [JudgeTarget::File(path)] if foreign::may_be(path) => return from_others(args, path),
        _ => {
            return Err(format!(
                "{} is neither a GLB or USD file, nor the folder of a Unity project, nor a JSON file of another system",
                args.scene.display()
            ));
        }
    };
    replace::unedited(&args.output, args.force)?;
    let door = Door::of(path).named(&Named::new([path.as_path()]));
    let name = path.display().to_string();
    let scene = embedded::read(&name, path, *kind, &door).map_err(|finding| {
        let notes: String = finding.notes.iter().map(|note| format!("\n  {note}")).collect();
        format!("{}{notes}", finding.message)
    })?;
    for change in &scene.changes {
        eprintln!("{name}: {}", plain::line(&change.message));
    }
    let may = May { force: args.force, ..May::default() };
    replace::folder(&args.output, &files(&scene)?, &[path], may)
}

/// A house or a layout of another system.
fn from_others(args: &Import, path: &Path) -> Result<Vec<PathBuf>, String> {
    replace::unedited(&args.output, args.force)?;
    let door = Door::of(path).named(&Named::new([path]));
    let name = path.display().to_string();
    let said = |sources: &SourceMap, findings: &[Diagnostic]| report::diagnostics(findings, sources, color_err());
    let scene = foreign::open(&name, path, &args.beside, &door).map_err(|refused| {
        // The report says it with its place; the sentence alone goes to the end.
        eprint!("{}", said(&refused.0, std::slice::from_ref(&refused.1)));
        format!("{name} cannot be imported; nothing was written")
    })?;
    eprint!("{}", said(&SourceMap::new(), &scene.notes));
    let beside = |path: &Path| path.file_name().map(PathBuf::from).unwrap_or_default();
    let files = [(&scene.main, &scene.program), (&scene.layout_path, &scene.layout)];
    let files = files.map(|(path, text)| OutFile::new(beside(path), text.as_str()));
    let mut inputs = vec![path];
    inputs.extend(args.beside.sizes.as_deref());
    inputs.extend(args.beside.room.as_deref());
    replace::folder(&args.output, &files, &inputs, May { force: args.force, ..May::default() })
}

/// The files of a scene, as they stood in relation to each other. Where one stood above the folder of the program, that
/// folder is a folder below. A file of somebody else's may call its parts whatever it likes: only programs are written.
fn files(scene: &Embedded) -> Result<Vec<OutFile>, String> {
    let folder = scene.layout_path.parent().unwrap_or(Path::new(""));
    let programs: Vec<(PathBuf, &str)> =
        scene.files().map(|(path, text)| (relative(path, folder).into(), text)).collect();
    if let Some((path, _)) = programs.iter().find(|(path, _)| path.extension().is_none_or(|e| e != "scene")) {
        let name = path.display().to_string();
        let shown = plain::line(&name);
        return Err(format!(
            "nothing was written: the scene has a file `{shown}`, which is not a program, because it does not end in .scene"
        ));
    }
    let above = |path: &Path| path.components().take_while(|part| *part == Component::ParentDir).count();
    let depth = programs.iter().map(|(path, _)| above(path)).max().unwrap_or(0);
    let place = |path: &Path| -> PathBuf {
        let up = above(path);
        let below = std::iter::repeat_n("scene", depth - up).map(PathBuf::from);
        below.chain(std::iter::once(path.components().skip(up).collect())).collect()
    };
    let main = PathBuf::from(relative(&scene.main, folder));
    let layout = place(Path::new(&format!("{}.layout.json", main.file_stem().unwrap_or_default().to_string_lossy())));
    let mut out: Vec<OutFile> = programs.iter().map(|(path, text)| OutFile::new(place(path), *text)).collect();
    out.push(OutFile::new(layout, scene.layout.as_str()));
    Ok(out)
}
