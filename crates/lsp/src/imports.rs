//! Files that a program could import, for completion.

use crate::disk;
use std::path::Path;

/// The other programs in the folder of a program, and below it, as it would import them.
pub fn imports(program: &Path) -> Vec<String> {
    let Some(folder) = program.parent().filter(|folder| folder.is_absolute()) else { return Vec::new() };
    let others = disk::programs(folder).into_iter().filter(|path| path != program);
    others.filter_map(|path| Some(path.strip_prefix(folder).ok()?.to_string_lossy().replace('\\', "/"))).collect()
}
