//! Stage II: a size and convex parts for every object of a program.
//!
//! The size is what the program assigns (`scale`, else `dimensions`), else the usual size of the category or, without
//! one, of what the name says, else a cube of 0.5 m. The parts come from the asset library at that size.

use scenelang_assets::{Asset, Request, furnish as asset};
use scenelang_base::{Diagnostic, codes};
use scenelang_lang::Program;
use scenelang_lang::library::usual_size;
use scenelang_lang::program::{Formula, Object, ObjectId, Owner, Pinned};
use scenelang_layout::{Layout, Placement, Vec3};
use scenelang_verify::{Options, Value, World, evaluate};
use std::collections::BTreeMap;

/// Edge of what has no size at all (metres).
const DEFAULT_EDGE: f64 = 0.5;

/// A layout that carries sizes and parts; positions are not decided yet.
#[derive(Debug)]
pub struct Furnished {
    /// Every object with its size and parts, at the origin unless `previous` had a place for it.
    pub layout: Layout,
    /// What had no asset or no size of its own.
    pub warnings: Vec<Diagnostic>,
}

/// The asset for an object at a size.
pub fn asset_of(object: &Object, size: Option<Vec3>) -> Asset {
    asset(&Request {
        name: &object.name,
        category: &object.category,
        color: &object.color,
        material: &object.material,
        features: &object.features,
        size,
    })
}

/// Chooses sizes and parts. What `previous` says of an object (place, size, parts) is kept where the program does not
/// speak against it.
pub fn furnish(
    program: &Program,
    draws: Vec<(String, f64)>,
    previous: Option<&Layout>,
    options: &Options,
) -> Furnished {
    let mut layout = previous.cloned().unwrap_or_default();
    layout.draws = draws;
    let known: Vec<_> = std::mem::take(&mut layout.objects);
    let mut warnings = Vec::new();
    let sizes = assigned_sizes(program, &layout, options);
    // One warning for a kind of thing, not for each of its instances.
    let mut unknown: BTreeMap<String, (usize, Diagnostic)> = BTreeMap::new();
    for (i, object) in program.objects.iter().enumerate() {
        let before = known.iter().find(|(name, _)| *name == object.name).map(|(_, p)| p);
        let what = if object.category.is_empty() { base_name(object) } else { object.category.as_str() };
        let size = sizes[i].or(before.map(|p| p.scale)).or_else(|| usual_size(what).map(Vec3::from));
        if size.is_none() {
            let message = format!("no usual size is known for \"{what}\"; it becomes a cube of {DEFAULT_EDGE} m");
            let d = Diagnostic::new(codes::W0602, object.span, message)
                .note(format!("say how large it is: `{}.dimensions <- vec3(…);`", base_name(object)));
            unknown.entry(format!("size {what}")).or_insert((i, d));
        }
        let size = size.unwrap_or_else(|| Vec3::repeat(DEFAULT_EDGE));
        if let Some(p) = before.filter(|p| !p.parts.is_empty() && (p.scale - size).amax() < 1e-9) {
            layout.objects.push((object.name.clone(), p.clone()));
            continue;
        }
        let asset = asset_of(object, Some(size));
        if !asset.known {
            let message = format!("the library has nothing for \"{what}\"; it becomes a labelled box");
            let d = Diagnostic::new(codes::W0601, object.span, message)
                .note(format!("give it a category the library knows: `{}.category <- \"chair\";`", base_name(object)));
            unknown.entry(format!("asset {what}")).or_insert((i, d));
        }
        let (pos, rot) = before.map_or((Vec3::zeros(), Vec3::zeros()), |p| (p.pos, p.rot));
        let placement = Placement { pos, rot, scale: asset.size, parts: asset.parts, surface: asset.surface };
        layout.objects.push((object.name.clone(), placement));
    }
    let mut found: Vec<(usize, Diagnostic)> = unknown.into_values().collect();
    found.sort_by_key(|(i, d)| (*i, d.code));
    warnings.extend(found.into_iter().map(|(_, d)| d));
    Furnished { layout, warnings }
}

/// The name to speak of an object's kind by: that of its array, or its own.
fn base_name(object: &Object) -> &str {
    object.array.as_ref().map_or(object.name.as_str(), |(name, _)| name.as_str())
}

/// Sizes that the program assigns. One may be defined by another, so they are found in rounds.
fn assigned_sizes(program: &Program, layout: &Layout, options: &Options) -> Vec<Option<Vec3>> {
    let mut formulas: Vec<(ObjectId, &Formula)> = Vec::new();
    for pin in program.pins.iter().filter(|p| p.property == Pinned::Scale) {
        if let (Owner::Object(id), [value]) = (pin.owner, pin.values.as_slice()) {
            formulas.push((id, value));
        }
    }
    for (i, object) in program.objects.iter().enumerate() {
        let id = ObjectId(i as u32);
        if let Some(dimensions) = &object.dimensions
            && !formulas.iter().any(|(o, _)| *o == id)
        {
            formulas.push((id, dimensions));
        }
    }
    let mut sizes = vec![None; program.objects.len()];
    let mut known = layout.clone();
    loop {
        let world = World::<f64>::new(program, &known, options);
        let before = formulas.len();
        formulas.retain(|(id, formula)| {
            let Ok(Value::Vector(v)) = evaluate(formula, &world) else { return true };
            let size = v.value();
            // A size that is none is left for the verifier to report against its statement.
            if size.iter().all(|x| x.is_finite() && *x > 0.0) {
                sizes[id.0 as usize] = Some(size);
                let placement =
                    Placement { pos: Vec3::zeros(), rot: Vec3::zeros(), scale: size, parts: Vec::new(), surface: None };
                known.objects.push((program.objects[id.0 as usize].name.clone(), placement));
            }
            false
        });
        if formulas.is_empty() || formulas.len() == before {
            return sizes;
        }
    }
}
