//! Layouts drawn in the plainest way: everything anywhere in the rectangle of the room, on the floor or on something, turned
//! anyhow, until `check` finds that all holds. No code of the sampler is asked but the judgement.

use scenelang_lang::{Compiled, Options, Program, compile_text};
use scenelang_layout::Layout;
use scenelang_sample::holds;
use std::path::Path;

/// A program.
pub fn compiled(text: &str) -> Compiled {
    let compiled = compile_text("t.scene", Path::new("t.scene"), text, Options::default());
    assert!(compiled.program.is_some(), "{:?}", compiled.diagnostics);
    compiled
}

/// SplitMix64: nothing that the sampler uses.
struct Numbers(u64);

impl Numbers {
    fn between(&mut self, lo: f64, hi: f64) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        let unit = ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 53) as f64;
        lo + (hi - lo) * unit
    }
}

/// So many layouts.
pub fn plain(program: &Program, count: usize, seed: u64) -> Vec<Layout> {
    let judge = scenelang_verify::Options::default();
    let mut numbers = Numbers(seed);
    let solved = {
        let start = scenelang_synth::furnish(program, Vec::new(), None, &judge).layout;
        let problem = scenelang_solve::Problem { program, start, placed: scenelang_solve::Placed::None };
        scenelang_solve::solve(&problem, &Default::default(), &mut |_| std::ops::ControlFlow::Continue(())).layout
    };
    let text: String = program.constraints.iter().map(|c| c.text.as_str()).collect();
    let [low, high] = rectangle(&solved);
    let mut found = Vec::new();
    while found.len() < count {
        let mut layout = solved.clone();
        for (_, placement) in &mut layout.objects {
            placement.pos = [numbers.between(low[0], high[0]), 0.0, numbers.between(low[1], high[1])].into();
        }
        // What the text sets exactly cannot be met by chance.
        if text.contains("b.pos.x = a.pos.x") {
            layout.objects[1].1.pos.x = layout.objects[0].1.pos.x;
        }
        for (name, placement) in &mut layout.objects {
            let is_set = text.contains(&format!("{name}.rot = rot(0, 0, 0)"));
            placement.rot.y = if is_set { 0.0 } else { numbers.between(0.0, 360.0) };
        }
        // Each height that a thing can have counts alike: what is on a level that is not there fails the check.
        for i in 0..layout.objects.len() {
            let on_the_other = layout.objects.len() == 2 && numbers.between(0.0, 1.0) < 0.5;
            layout.objects[i].1.pos.y = if on_the_other { layout.objects[1 - i].1.scale.y } else { 0.0 };
        }
        if holds(program, &layout, &judge) {
            found.push(layout);
        }
    }
    found
}

/// The rectangle around all rooms (x and z).
fn rectangle(layout: &Layout) -> [[f64; 2]; 2] {
    let corners = layout.regions.iter().flat_map(|(_, region)| match &region.vertices {
        Some(corners) => corners.clone(),
        None => [-0.5, 0.5]
            .map(|part| [region.pos.x + part * region.scale.x, region.pos.z + part * region.scale.z])
            .to_vec(),
    });
    corners.fold([[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]], |[low, high], corner| {
        [[low[0].min(corner[0]), low[1].min(corner[1])], [high[0].max(corner[0]), high[1].max(corner[1])]]
    })
}

/// A layout as numbers that are near each other where layouts are.
pub fn features(program: &Program, layout: &Layout) -> Vec<f64> {
    assert_eq!(program.objects.len(), layout.objects.len());
    let of = |placement: &scenelang_layout::Placement| {
        let (sin, cos) = placement.rot.y.to_radians().sin_cos();
        [placement.pos.x, placement.pos.y, placement.pos.z, 0.5 * sin, 0.5 * cos]
    };
    layout.objects.iter().flat_map(|(_, placement)| of(placement)).collect()
}
