//! What proofs take for granted of usual things holds for the assets that they get.
#![allow(clippy::unwrap_used, reason = "helpers of tests may panic, too")]

use scenelang_base::{SourceFile, SourceMap};
use scenelang_lang::compile::compile_main;
use scenelang_lang::library;
use scenelang_lang::program::Program;
use scenelang_lang::sources::Loader;
use scenelang_layout::{Part, Vec3};
use scenelang_synth::asset_of;
use scenelang_verify::prove::core_of;
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

/// Whether parts fill a box about the middle axis, as far as samples show; or shut it off, where that is enough: from
/// each sample one of them is met in every direction but one.
fn filled(parts: &[Part], [w, d]: [f64; 2], [from, to]: [f64; 2], shut: bool) -> bool {
    const SAMPLES: i32 = 8;
    let along = |k: i32, length: f64| length * (f64::from(k) / f64::from(SAMPLES - 1) - 0.5);
    let boxes = || {
        parts.iter().filter_map(|part| match part {
            Part::Box { pos, size, rot } if *rot == Vec3::zeros() => Some((pos, size / 2.0)),
            _ => None,
        })
    };
    // Nothing stands in the gap beside a door.
    let gap = if shut { 0.015 } else { 1e-6 };
    let within = |p: Vec3, (pos, half): (&Vec3, Vec3), axes: &[usize]| {
        axes.iter().all(|i| (p[*i] - pos[*i]).abs() <= half[*i] + gap)
    };
    let solid = |p: Vec3| {
        let met = |axis: usize, way: f64| {
            let beside: Vec<usize> = (0..3).filter(|i| *i != axis).collect();
            boxes().any(|b| within(p, b, &beside) && (b.0[axis] - p[axis]) * way >= -b.1[axis])
        };
        let open = (0..3).flat_map(|axis| [(axis, -1.0), (axis, 1.0)]).filter(|(axis, way)| !met(*axis, *way)).count();
        boxes().any(|b| within(p, b, &[0, 1, 2])) || (shut && open <= 1)
    };
    [0.001, 0.25, 0.5, 0.75, 0.999].into_iter().all(|part| {
        let y = from + (to - from) * part;
        (0..SAMPLES).all(|i| (0..SAMPLES).all(|k| solid(Vec3::new(along(i, w), y, along(k, d)))))
    })
}

#[test]
fn what_counts_as_solid_is() {
    let (mut known, mut wrong) = (0, String::new());
    for (object, (name, size)) in kinds().objects.iter().zip(library::categories()) {
        let shut = matches!(object.role.as_str(), "storage" | "appliance");
        for factor in [0.8, 0.95, 1.0, 1.05, 1.25] {
            let size = size.map(|s| s * factor);
            let Some((core, heights)) = core_of(object, size) else { continue };
            known += 1;
            let asset = asset_of(object, Some(Vec3::from(size)));
            if !filled(&asset.parts, core, heights, shut) {
                writeln!(wrong, "{name} at {size:?}").unwrap();
            }
        }
    }
    assert!(known > 900, "{known}");
    assert!(wrong.is_empty(), "\n{wrong}");
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
