//! Words that the asset library knows, for completion. There are no other files that could be imported.

use scenelang_assets as assets;
use scenelang_ide::completion::Vocabulary;

/// The words.
pub struct Words;

impl Vocabulary for Words {
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
        Vec::new()
    }
}
