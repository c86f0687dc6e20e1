//! Words that the asset library knows, and files that could be imported, for completion and colours.

use crate::disk;
use scenelang_assets as assets;
use scenelang_ide::completion::Vocabulary;
use std::path::Path;

/// The words for a program at a path.
pub struct Words<'a>(pub &'a Path);

impl Vocabulary for Words<'_> {
    fn colors(&self) -> Vec<&str> {
        assets::color_names().collect()
    }
    fn color(&self, text: &str) -> Option<[u8; 3]> {
        assets::color_of(text)
    }
    fn materials(&self) -> Vec<&str> {
        assets::material_names().collect()
    }
    fn categories(&self) -> Vec<&str> {
        assets::categories().collect()
    }
    fn imports(&self) -> Vec<String> {
        let Some(folder) = self.0.parent().filter(|folder| folder.is_absolute()) else { return Vec::new() };
        let others = disk::programs(folder).into_iter().filter(|path| path != self.0);
        others.filter_map(|path| Some(path.strip_prefix(folder).ok()?.to_string_lossy().replace('\\', "/"))).collect()
    }
}
