//! What of a layout to start from can be used: a place, a size or a value that no layout file could hold is none.

use crate::problem::Problem;
use scenelang_layout::file::LARGEST;
use scenelang_layout::{DecisionValue, Layout, Part, Placement, Polygon, RegionPlacement, Vec3};

/// The problem without what cannot be used of its layout, and a sentence for each thing left out. `None`: all can be.
pub(crate) fn sound<'a>(problem: &Problem<'a>) -> Option<(Problem<'a>, Vec<String>)> {
    let start = &problem.start;
    let objects = start.objects.iter().filter(|(_, p)| !is_object(p)).map(|(name, _)| name);
    let regions = start.regions.iter().filter(|(_, r)| !is_region(r)).map(|(name, _)| name);
    let variables = start.variables.iter().filter(|(_, v)| !is_value(v)).map(|(name, _)| name);
    let bad: Vec<String> = objects
        .chain(regions)
        .chain(variables)
        .map(|name| format!("the starting layout has an invalid value for `{name}`, which is ignored"))
        .collect();
    if bad.is_empty() {
        return None;
    }
    let layout = Layout {
        objects: start.objects.iter().filter(|(_, p)| is_object(p)).cloned().collect(),
        regions: start.regions.iter().filter(|(_, r)| is_region(r)).cloned().collect(),
        variables: start.variables.iter().filter(|(_, v)| is_value(v)).cloned().collect(),
        ..start.clone()
    };
    Some((Problem { start: layout, ..problem.clone() }, bad))
}

fn is_number(x: f64) -> bool {
    x.abs() <= LARGEST
}

fn is_triple(v: &Vec3) -> bool {
    v.iter().all(|x| is_number(*x))
}

fn is_size(v: &Vec3) -> bool {
    is_triple(v) && v.iter().all(|x| *x > 0.0)
}

fn is_object(p: &Placement) -> bool {
    let part = |part: &Part| match part {
        Part::Box { pos, size, rot } => is_triple(pos) && is_size(size) && is_triple(rot),
        Part::Cylinder { pos, radius, height, rot } => {
            is_triple(pos) && is_size(&Vec3::new(*radius, *height, 1.0)) && is_triple(rot)
        }
        Part::Hull { points } => points.iter().all(is_triple),
    };
    is_triple(&p.pos)
        && is_triple(&p.rot)
        && is_size(&p.scale)
        && p.parts.iter().all(part)
        && p.surface.is_none_or(is_number)
}

fn is_region(r: &RegionPlacement) -> bool {
    let simple = |v: &Vec<[f64; 2]>| v.as_flattened().iter().all(|x| is_number(*x)) && Polygon::new(v).is_ok();
    is_triple(&r.pos) && is_triple(&r.rot) && is_size(&r.scale) && r.vertices.as_ref().is_none_or(simple)
}

fn is_value(value: &DecisionValue) -> bool {
    match value {
        DecisionValue::Number(x) => is_number(*x),
        DecisionValue::Triple(t) => t.iter().all(|x| is_number(*x)),
        DecisionValue::Bool(_) => true,
    }
}
