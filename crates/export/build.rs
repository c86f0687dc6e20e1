//! Puts the viewer's bundle, if it has been built, where `preview.rs` embeds it; else an empty file.

use std::path::{Path, PathBuf};
use std::{env, fs, io};

fn main() -> io::Result<()> {
    println!("cargo::rerun-if-changed=build.rs");
    let viewer = Path::new("../../viewer");
    let bundle = viewer.join("dist/viewer.js");
    // A path that does not exist would make cargo run this every time; the nearest folder that does exist changes when
    // the bundle appears in it.
    let mut watched = bundle.as_path();
    while !watched.exists() && watched != viewer {
        watched = watched.parent().unwrap_or(viewer);
    }
    if watched.exists() {
        println!("cargo::rerun-if-changed={}", watched.display());
    }
    let text = if bundle.exists() { fs::read_to_string(&bundle)? } else { String::new() };
    let out = PathBuf::from(env::var_os("OUT_DIR").unwrap_or_default()).join("viewer.js");
    fs::write(out, text)
}
