//! What proofs take for granted of usual things holds for the assets that they get.
#![allow(clippy::unwrap_used, reason = "helpers of tests may panic, too")]

use scenelang_base::{SourceFile, SourceMap};
use scenelang_lang::compile::compile_main;
use scenelang_lang::library;
use scenelang_lang::program::Program;
use scenelang_lang::sources::Loader;
use scenelang_layout::Vec3;
use scenelang_synth::asset_of;
use std::fmt::Write as _;
use std::io;
use std::path::Path;

struct Nothing;

impl Loader for Nothing {
    fn load(&self, _: &Path) -> io::Result<Vec<u8>> {
        Err(io::ErrorKind::NotFound.into())
    }
}

/// One object of each known category.
fn kinds() -> Program {
    let mut text = String::new();
    for (i, (name, _)) in library::categories().iter().enumerate() {
        writeln!(text, "object kind{i}; kind{i}.category <- \"{name}\";").unwrap();
    }
    let mut sources = SourceMap::new();
    let main = sources.add(SourceFile::new("kinds.scene", "kinds.scene", &text));
    compile_main(main, scenelang_lang::Options { core: false }, &Nothing, sources).program.unwrap()
}

#[test]
fn support_surfaces_are_well_above_the_base() {
    for (object, (name, size)) in kinds().objects.iter().zip(library::categories()) {
        let surface = asset_of(object, Some(Vec3::from(*size))).surface;
        assert!(surface.is_none_or(|s| s >= 0.1 * size[1]), "{name}: {surface:?} of {}", size[1]);
    }
}

#[test]
fn the_language_knows_the_colors_that_furniture_can_have() {
    let mut ours: Vec<&str> = library::colors().collect();
    let mut theirs: Vec<&str> = scenelang_assets::color_names().chain(scenelang_assets::material_names()).collect();
    for names in [&mut ours, &mut theirs] {
        names.sort_unstable();
        names.dedup();
    }
    assert_eq!(ours, theirs);
    for name in ours {
        assert!(scenelang_assets::color_of(name).is_some(), "{name}");
        assert_eq!(library::meant_color(name), None, "{name}");
    }
}
