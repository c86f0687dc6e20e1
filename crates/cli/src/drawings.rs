//! The drawings of the book that `explain` shows: what they show in words, and the drawing itself as an SVG file.

use crate::replace::{self, May};
use scenelang_export::OutFile;
use std::path::Path;

/// A drawing that a section of the book refers to.
pub struct Drawing {
    pub name: &'static str,
    svg: &'static str,
}

macro_rules! drawings {
    ($($name:literal)*) => {
        &[$(Drawing { name: $name, svg: include_str!(concat!("../../../spec/src/pictures/", $name, ".svg")) },)*]
    };
}

/// Those of the chapters that have a section for each word; a test compares the list with the chapters.
const DRAWINGS: &[Drawing] = drawings!(
    "above" "againstWall" "aligned" "armchairsAt" "around" "backToWall" "balanced" "bedSet" "behind" "below" "beside"
    "between" "ceilingMounted" "centeredIn" "clear" "connects" "counterSet" "deskSet" "diningSet" "displayRow"
    "emergency" "facing" "far" "inCorner" "inFrontOf" "inRow" "inside" "inside-corner" "kitchenRun" "leftOf" "looksAt"
    "looksAtFrom" "near" "on" "onFloor" "oppositeWays" "over" "parallel" "rackAisles" "reachable" "receptionSet"
    "restsOn" "rightOf" "rowsBefore" "sameWay" "screenBefore" "seatingGroup" "seenLeftOf" "seenRightOf" "under"
    "visible" "walk" "wallMounted" "wardBay" "within"
);

/// The line of a section that refers to a drawing: what it shows, and the drawing.
pub fn of_line(line: &str) -> Option<(&str, &'static Drawing)> {
    let (shows, target) = line.strip_prefix("![")?.strip_suffix(')')?.split_once("](")?;
    let name = target.rsplit('/').next()?.strip_suffix(".svg")?;
    Some((shows, DRAWINGS.iter().find(|drawing| drawing.name == name)?))
}

/// The names of all.
#[cfg(test)]
pub fn all() -> impl Iterator<Item = &'static str> {
    DRAWINGS.iter().map(|drawing| drawing.name)
}

/// Writes drawings into a folder.
pub fn write(drawings: &[&Drawing], folder: &Path, force: bool) -> Result<(), String> {
    let file = |drawing: &&Drawing| OutFile::new(format!("{}.svg", drawing.name), drawing.svg.as_bytes());
    let files: Vec<OutFile> = drawings.iter().map(file).collect();
    let written = replace::folder(folder, &files, &[], May { force, these: &[] })?;
    let plural = if written.len() == 1 { "" } else { "s" };
    eprintln!("{} drawing{plural} written to {}", written.len(), folder.display());
    Ok(())
}
