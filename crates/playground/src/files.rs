//! The files that there are: one program, and nothing beside it.

use scenelang_lang::sources::Loader;
use std::io;
use std::path::Path;

/// A program by itself.
pub struct Alone<'a> {
    /// Its name, which is its path.
    pub name: &'a str,
    pub text: &'a str,
}

impl Loader for Alone<'_> {
    fn load(&self, path: &Path) -> io::Result<Vec<u8>> {
        if path == Path::new(self.name) {
            return Ok(self.text.as_bytes().to_vec());
        }
        let say = "a program in the playground is one file; put what it imports into it, or use the command line";
        Err(io::Error::new(io::ErrorKind::NotFound, say))
    }
}

/// The name of a program without its ending: what its other files are called by.
pub fn stem(name: &str) -> &str {
    name.strip_suffix(".scene").unwrap_or(name)
}

/// What the layout of a program is called.
pub fn layout_name(name: &str) -> String {
    format!("{}.layout.json", stem(name))
}
