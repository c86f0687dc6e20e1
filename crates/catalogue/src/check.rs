//! What is wrong with the models of a folder, beyond what keeps them from being read: findings that a person should look
//! at, because the model would be used all the same.

use crate::folder::Catalogue;
use crate::model::CatalogueModel;
use scenelang_base::{Diagnostic, codes};
use scenelang_layout::Vec3;
use std::path::Path;

/// A lowest point so near the origin (metres, and as a share of the height) is at it.
const BASE: f64 = 0.005;
const BASE_SHARE: f64 = 0.01;
/// A size that differs by more than this factor from the usual one is another unit.
const UNIT: f64 = 5.0;
/// Without a usual size: what furniture is not (metres).
const SMALLEST: f64 = 0.005;
const LARGEST: f64 = 20.0;
/// The size on the card may differ by so much from the proportions of the triangles.
const DISTORTION: f64 = 1.1;
/// A single piece that fills less than this share of its hull, and leaves more room in it than this (m³), is not what the
/// hull says, and where to cut it is a guess. Cups and baskets leave less: nothing is pushed under them.
const HOLLOW: f64 = 0.5;
const ROOM: f64 = 0.1;
/// Air has about one kilogram per cubic metre, a block of steel about eight thousand.
const LIGHTEST: f64 = 1.0;
const HEAVIEST: f64 = 8000.0;
/// Units that numbers may be in, in metres.
const UNITS: [(f64, &str); 5] =
    [(0.001, "millimetres"), (0.01, "centimetres"), (0.0254, "inches"), (0.1, "decimetres"), (0.3048, "feet")];

/// A model with what was found.
#[derive(Clone, Debug)]
pub struct Checked {
    /// The file, below the folder.
    pub file: String,
    /// An error where it cannot be used, else warnings; nothing where all is good.
    pub findings: Vec<Diagnostic>,
}

/// Looks at all models of a folder. `usual`: the usual size of a category (w, h, d in metres).
///
/// # Errors
/// There is no such folder, or nothing to read in it.
pub fn check(folder: &Path, usual: &dyn Fn(&str) -> Option<Vec3>) -> Result<Vec<Checked>, Box<Diagnostic>> {
    let catalogue = Catalogue::list(folder)?;
    let mut out: Vec<Checked> = catalogue
        .refused
        .iter()
        .map(|r| Checked { file: r.file.clone(), findings: vec![r.finding.clone()] })
        .chain(catalogue.entries.iter().map(|entry| {
            let findings = match catalogue.model(entry) {
                Ok(model) => findings(&model, usual(&model.card.category)),
                Err(finding) => vec![*finding],
            };
            Checked { file: entry.file.clone(), findings }
        }))
        .collect();
    out.sort_by(|a, b| a.file.cmp(&b.file));
    Ok(out)
}

/// What is to be said of a model, in the order of the codes. Room and density mean nothing where the size is wrong.
fn findings(model: &CatalogueModel, usual: Option<Vec3>) -> Vec<Diagnostic> {
    let size = size(model, usual);
    let (parts, mass) = if size.is_none() { (parts(model), mass(model)) } else { (None, None) };
    [open(model), size, front(model), base(model), parts, mass, licence(model)].into_iter().flatten().collect()
}

fn open(model: &CatalogueModel) -> Option<Diagnostic> {
    let open = model.origin.open_edges;
    let edges = if open == 1 { "edge has" } else { "edges have" };
    let say = format!("its mesh is not closed: {open} {edges} only one triangle");
    (open > 0).then(|| {
        Diagnostic::without_place(codes::W0701, say).note("close the holes, or merge vertices with the same position")
    })
}

fn size(model: &CatalogueModel, usual: Option<Vec3>) -> Option<Diagnostic> {
    let found = |say: String| Diagnostic::without_place(codes::W0702, say);
    if model.origin.distortion > DISTORTION {
        let say = format!(
            "the proportions of the size on its card differ from those of its mesh by a factor of {:.2}",
            model.origin.distortion
        );
        return Some(found(say).note("give its width, height and depth with the front facing +z"));
    }
    let largest = model.size.max();
    match usual.map(|usual| usual.max()) {
        Some(usual) if largest / usual > UNIT || usual / largest > UNIT => {
            let category = &model.card.category;
            let say = format!(
                "its longest side is {} m; the usual size of \"{category}\" is {} m",
                shown(largest),
                shown(usual)
            );
            Some(with_unit(found(say), largest / usual))
        }
        None if !(SMALLEST..=LARGEST).contains(&largest) => {
            Some(with_unit(found(format!("its longest side is {} m", shown(largest))), largest))
        }
        _ => None,
    }
}

/// With the unit in which the numbers would make sense, if there is one.
fn with_unit(found: Diagnostic, ratio: f64) -> Diagnostic {
    let fits = |unit: &&(f64, &str)| (ratio * unit.0).ln().abs();
    let best = UNITS.iter().min_by(|a, b| fits(a).total_cmp(&fits(b))).filter(|unit| fits(unit) < 1.0);
    let found = match best {
        Some((_, name)) => found.note(format!("its unit may be {name}")),
        None => found,
    };
    found.note("write its size in metres on its card: `\"size\": [w, h, d]`")
}

fn front(model: &CatalogueModel) -> Option<Diagnostic> {
    model.card.front.is_none().then(|| {
        Diagnostic::without_place(codes::W0703, "the direction of its front is not given; +z is assumed")
            .note("state it on its card: `\"front\": \"+z\"`, another axis, or an angle in degrees")
    })
}

fn base(model: &CatalogueModel) -> Option<Diagnostic> {
    let base = model.origin.base;
    let most = BASE.max(BASE_SHARE * model.size.y);
    let side = if base > 0.0 { "above" } else { "below" };
    let say = format!("its lowest point is {} m {side} the origin of the file", shown(base.abs()));
    (base.abs() > most).then(|| {
        Diagnostic::without_place(codes::W0704, say)
            .note("it is placed on the floor; if it should hang, give its height in the program")
    })
}

fn parts(model: &CatalogueModel) -> Option<Diagnostic> {
    let origin = model.origin;
    let volume = origin.volume?;
    let (filled, room) = (volume / origin.filled, origin.filled - volume);
    let say = format!("it is one piece that fills {:.0} % of its convex hull", 100.0 * filled);
    let note = match model.parts.len() {
        1 => "no object can stand in or under it".to_owned(),
        parts => format!("it is cut into {parts} parts at the most suitable positions"),
    };
    (origin.pieces == 1 && filled < HOLLOW && room > ROOM).then(|| {
        Diagnostic::without_place(codes::W0705, say)
            .note(format!("{note}; build it from several convex pieces that do not share edges"))
    })
}

fn mass(model: &CatalogueModel) -> Option<Diagnostic> {
    let mass = model.card.mass?;
    let density = mass / model.size.product();
    let why = match () {
        () if mass <= 0.0 => "which is not possible".to_owned(),
        () if density < LIGHTEST => format!("{:.2} kg/m³: lighter than air", density),
        () if density > HEAVIEST => format!("{density:.0} kg/m³: heavier than a block of steel of the same size"),
        () => return None,
    };
    let say = format!("its mass is {} kg, {why}", shown(mass));
    Some(Diagnostic::without_place(codes::W0706, say).note("give the mass in kilograms on its card: `\"mass\": 7.5`"))
}

fn licence(model: &CatalogueModel) -> Option<Diagnostic> {
    model.card.licence.is_none().then(|| {
        Diagnostic::without_place(codes::W0707, "no licence is stated")
            .note("state it on its card: `\"licence\": \"CC0-1.0\"`")
    })
}

/// A number with as many digits as are of use.
fn shown(x: f64) -> String {
    let text = if x >= 100.0 {
        format!("{x:.0}")
    } else if x >= 0.1 {
        format!("{x:.2}")
    } else {
        format!("{x:.5}")
    };
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_owned() } else { text }
}
