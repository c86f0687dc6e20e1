//! Stage II: a size and convex parts for every object of a program.
//!
//! The size is what the program assigns (`scale`, else `dimensions`), else the usual size of the category or, without
//! one, of what the name says, else a cube of 0.5 m. The parts come from the asset library at that size.

use crate::rebuild::{AssetInput, Before, shape};
use scenelang_assets::{Asset, AssetRequest, family_of, solid, stand_in};
use scenelang_base::{Code, Diagnostic, Label, codes};
use scenelang_catalogue::{Chain, Choice, Query, Why};
use scenelang_lang::Program;
use scenelang_lang::library::usual_size;
use scenelang_lang::program::{Formula, Object, ObjectId, Owner, Pinned};
use scenelang_layout::{Layout, Placement, Vec3};
use scenelang_verify::{Options, Value, World, evaluate};
use std::collections::BTreeMap;

/// Edge of what has no size at all (metres).
const DEFAULT_EDGE: f64 = 0.5;
/// How many kinds of things are named in a sentence.
const NAMED: usize = 3;
/// How many of their declarations are shown beside the first.
const SHOWN: usize = 4;

/// A layout that carries sizes and parts; positions are not decided yet.
#[derive(Debug)]
pub struct Furnished {
    /// Every object with its size and parts, at the origin unless `previous` had a place for it.
    pub layout: Layout,
    /// What had no asset or no size of its own: one for each kind of thing. [`gathered`] makes fewer of them.
    pub warnings: Vec<Diagnostic>,
    /// Who gave each object what, in the order of the program; nothing, where only the library was asked.
    pub chosen: Vec<Chosen>,
    /// What was asked for and given, in the order of the program.
    pub looks: Vec<AssetInput>,
}

/// What an object was given, and by whom.
#[derive(Clone, Debug)]
pub struct Chosen {
    pub object: String,
    /// What it was given.
    pub choice: Choice,
}

impl Chosen {
    /// Whether what is seen of it is not what the library draws.
    pub fn is_own(&self) -> bool {
        !matches!(self.choice.provider.as_str(), "library" | "box")
    }
}

/// Opens into a wall, and is cut out of it: such things are always from the library.
const BUILT_IN: [&str; 3] = ["door", "garage_door", "window"];

/// The asset for an object at a size, without its mesh.
pub fn asset_of(object: &Object, size: Option<Vec3>) -> Asset {
    solid(&AssetRequest {
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
    furnish_from(program, draws, Earlier { previous, made: None }, options, None, &mut |_| {})
}

/// What is there already.
#[derive(Clone, Copy, Debug, Default)]
pub struct Earlier<'a> {
    /// A layout whose places, sizes and parts are kept where the program does not speak against it.
    pub previous: Option<&'a Layout>,
    /// What an earlier run made: parts of objects that ask for the same as then.
    pub made: Option<&'a Before>,
}

impl Earlier<'_> {
    /// What an earlier run made for the same wish.
    fn piece(&self, object: &Object, look: &AssetInput) -> Option<(&Placement, &AssetInput)> {
        let made = self.made?;
        let known = made.looks.get(object.name.as_str()).filter(|known| known.asks_the_same(look))?;
        let placement = made.layout.object(&object.name)?;
        (shape(placement) == known.shape).then_some((placement, known))
    }
}

/// The same, with all but doors and windows from a chain of providers, if there is one. `say` is told how far it is.
pub fn furnish_from(
    program: &Program,
    draws: Vec<(String, f64)>,
    earlier: Earlier<'_>,
    options: &Options,
    chain: Option<&Chain>,
    say: &mut dyn FnMut(&str),
) -> Furnished {
    let program = &*program.dressed(&draws);
    let previous = earlier.previous;
    let mut layout = previous.cloned().unwrap_or_default();
    layout.draws = draws;
    let known: Vec<_> = std::mem::take(&mut layout.objects);
    let mut warnings = Vec::new();
    let sizes = assigned_sizes(program, &layout, options);
    // One warning for a kind of thing, not for each of its instances.
    let mut unknown: BTreeMap<String, (usize, Diagnostic)> = BTreeMap::new();
    let before = |object: &Object| known.iter().find(|(name, _)| *name == object.name).map(|(_, p)| p);
    let mut chosen = chain.map_or_else(BTreeMap::new, |chain| {
        let wanted = |(i, object): (usize, &Object)| {
            (!is_built_in(object)).then(|| (i, query(object, sizes[i], before(object).map(|p| p.scale))))
        };
        let (ids, queries): (Vec<usize>, Vec<Query>) = program.objects.iter().enumerate().filter_map(wanted).unzip();
        ids.into_iter().zip(chain.choose(&queries, say)).collect()
    });
    let (mut kept, mut looks) = (Vec::new(), Vec::new());
    for (i, object) in program.objects.iter().enumerate() {
        let before = before(object);
        let what = what_of(object);
        let (pos, rot) = before.map_or((Vec3::zeros(), Vec3::zeros()), |p| (p.pos, p.rot));
        let chosen = chosen.remove(&i).map(|choice| Chosen { object: object.name.to_string(), choice });
        if let Some(chosen) = chosen.filter(|chosen| {
            let own = chosen.is_own();
            passed_over(&chosen.choice, &mut warnings);
            kept.push(chosen.clone());
            own
        }) {
            let piece = chosen.choice.given.piece;
            let placement = Placement {
                pos,
                rot,
                scale: piece.size,
                parts: piece.parts,
                surface: piece.surface,
                joints: piece.joints,
            }
            .in_short();
            looks.push(AssetInput::asked(object, placement.scale).given(&placement, true));
            layout.objects.push((object.name.clone(), placement));
            continue;
        }
        let size = sizes[i].or(before.map(|p| p.scale)).or_else(|| usual_size(what).map(Vec3::from));
        if size.is_none() {
            let d = Diagnostic::new(codes::W0602, object.span, message(codes::W0602, &[what]))
                .label(what)
                .note(format!("give its size: `{}.dimensions <- vec3(…);`", base_name(object)));
            unknown.entry(format!("size {what}")).or_insert((i, d));
        }
        let size = size.unwrap_or_else(|| Vec3::repeat(DEFAULT_EDGE));
        let look = AssetInput::asked(object, size);
        if let Some(p) = before.filter(|p| !p.parts.is_empty() && (p.scale - size).amax() < 1e-9) {
            looks.push(look.given(p, true));
            layout.objects.push((object.name.clone(), p.clone()));
            continue;
        }
        let (placement, is_known) = match earlier.piece(object, &look) {
            Some((p, known)) => (Placement { pos, rot, ..p.clone() }, known.is_known),
            None => {
                let Asset { size: scale, parts, surface, joints, known, .. } = asset_of(object, Some(size));
                (Placement { pos, rot, scale, parts, surface, joints }.in_short(), known)
            }
        };
        looks.push(look.given(&placement, is_known));
        if !is_known {
            let d = Diagnostic::new(codes::W0601, object.span, message(codes::W0601, &[what]))
                .label(what)
                .note(format!("use a category from the library: `{}.category <- \"chair\";`", base_name(object)));
            unknown.entry(format!("asset {what}")).or_insert((i, d));
        } else if let Some(family) = stand_in(&object.category, &object.name) {
            let d = Diagnostic::new(codes::W0604, object.span, message(codes::W0604, &[what]))
                .label(what)
                .note(format!("\"{what}\" has the shape of \"{}\"", family.replace('_', " ")));
            unknown.entry(format!("similar {what}")).or_insert((i, d));
        }
        layout.objects.push((object.name.clone(), placement));
    }
    let mut found: Vec<(usize, Diagnostic)> = unknown.into_values().collect();
    found.sort_by_key(|(i, d)| (*i, d.code));
    warnings.extend(found.into_iter().map(|(_, d)| d));
    Furnished { layout, warnings, chosen: kept, looks }
}

/// What a provider is asked for an object.
/// What providers are asked for by a program, in its order; sizes are left open.
pub fn queries(program: &Program) -> Vec<Query> {
    program.objects.iter().filter(|object| !is_built_in(object)).map(|object| query(object, None, None)).collect()
}

fn is_built_in(object: &Object) -> bool {
    family_of(&object.category, &object.name).is_some_and(|family| BUILT_IN.contains(&family))
}

fn query(object: &Object, size: Option<Vec3>, before: Option<Vec3>) -> Query {
    let what = what_of(object);
    Query {
        name: object.name.to_string(),
        what: what.to_owned(),
        category: object.category.clone(),
        color: object.color.clone(),
        material: object.material.clone(),
        features: object.features.clone(),
        size,
        usual: before.or_else(|| usual_size(what).map(Vec3::from)),
    }
}

/// Tells of models that cannot be used and of providers that do not work, each once.
fn passed_over(choice: &Choice, warnings: &mut Vec<Diagnostic>) {
    for (provider, remark) in &choice.passed {
        let note = match remark.why {
            Why::Broken => "`scenelang assets check` says more about it",
            Why::Failed => "the next provider was asked",
            _ => continue,
        };
        let say = format!("{provider}: {}", remark.say);
        if !warnings.iter().any(|d| d.message == say) {
            warnings.push(Diagnostic::without_place(codes::W0603, say).note(note));
        }
    }
}

/// What is said of kinds of things, the first ones by name.
fn message(code: Code, kinds: &[&str]) -> String {
    let [named, rest] = [&kinds[..kinds.len().min(NAMED)], &kinds[kinds.len().min(NAMED)..]];
    let mut list = named.iter().map(|kind| format!("\"{kind}\"")).collect::<Vec<_>>().join(", ");
    if !rest.is_empty() {
        list = format!("{list} and {} more", rest.len());
    }
    let one = kinds.len() == 1;
    if code == codes::W0604 {
        let drawn = if one {
            "such an object is drawn as something similar"
        } else {
            "such objects are drawn as something similar"
        };
        format!("the library has no shape specifically for {list}; {drawn}")
    } else if code == codes::W0601 {
        let turns = if one { "such an object becomes a labelled box" } else { "such objects become labelled boxes" };
        format!("the library has no model for {list}; {turns}")
    } else {
        let turns = if one { "such an object becomes a cube" } else { "such objects become cubes" };
        format!("there is no usual size for {list}; {turns} with an edge length of {DEFAULT_EDGE} m")
    }
}

/// One warning of each code instead of one for each kind of thing: where the first kind is declared, with places of
/// others, and a note that names what has no place there. To be done when those that the user does not want to hear of
/// are gone.
pub(crate) fn gathered(warnings: &[Diagnostic]) -> Vec<Diagnostic> {
    let mut codes: Vec<Code> = Vec::new();
    for code in warnings.iter().map(|d| d.code) {
        if !codes.contains(&code) {
            codes.push(code);
        }
    }
    let gather = |code: Code| {
        let mut of_code = warnings.iter().filter(|d| d.code == code);
        let mut first = of_code.next()?.clone();
        let others: Vec<&Label> = of_code.filter_map(|d| d.primary.as_ref()).collect();
        if others.is_empty() {
            return Some(first);
        }
        let kinds: Vec<&str> = first.primary.iter().chain(others.iter().copied()).map(|l| l.message.as_str()).collect();
        first.message = message(code, &kinds);
        let (shown, rest) = others.split_at(others.len().min(SHOWN));
        first.related = shown.iter().map(|&label| label.clone()).collect();
        if !rest.is_empty() {
            let rest: Vec<&str> = rest.iter().map(|label| label.message.as_str()).collect();
            first.notes.push(format!("the others are {}", rest.join(", ")));
        }
        Some(first)
    };
    let each = |code: &Code| *code == codes::W0603;
    let all = warnings.iter().filter(|d| each(&d.code)).cloned();
    codes.into_iter().filter(|code| !each(code)).filter_map(gather).chain(all).collect()
}

/// The noun of an object, or what its name says.
fn what_of(object: &Object) -> &str {
    if object.category.is_empty() { base_name(object) } else { &object.category }
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
                let placement = Placement {
                    pos: Vec3::zeros(),
                    rot: Vec3::zeros(),
                    scale: size,
                    parts: Vec::new(),
                    surface: None,
                    joints: Vec::new(),
                };
                known.objects.push((program.objects[id.0 as usize].name.clone(), placement));
            }
            false
        });
        if formulas.is_empty() || formulas.len() == before {
            return sizes;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use scenelang_lang::compile::compile_text;
    use std::fmt::Write;
    use std::path::Path;

    /// What is told of a program of things with these categories: code and message, what is said elsewhere, the last note.
    fn told(categories: &[&str]) -> Vec<(String, String, String)> {
        let mut text = String::new();
        for (i, category) in categories.iter().enumerate() {
            writeln!(text, "object it{i};\nit{i}.category <- \"{category}\";").unwrap();
        }
        let compiled = compile_text("room.scene", Path::new("room.scene"), &text, scenelang_lang::Options::default());
        let found = furnish(&compiled.program.unwrap(), Vec::new(), None, &Options::default());
        let tell = |d: Diagnostic| {
            let labels: Vec<&str> = d.related.iter().map(|label| label.message.as_str()).collect();
            let elsewhere = labels.join(" ");
            (format!("{} {}", d.code, d.message), elsewhere, d.notes.last().cloned().unwrap_or_default())
        };
        gathered(&found.warnings).into_iter().map(tell).collect()
    }

    #[test]
    fn what_is_drawn_as_something_else_is_told() {
        let say = "W0604 the library has no shape specifically for \"elliptical trainer\"; such an object is drawn as something similar";
        let note = "\"elliptical trainer\" has the shape of \"treadmill\"";
        assert_eq!(told(&["elliptical trainer", "treadmill"]), [(say.to_owned(), String::new(), note.to_owned())]);
        let both = told(&["elliptical trainer", "humidifier", "elliptical trainer"]);
        let say = "W0604 the library has no shape specifically for \"elliptical trainer\", \"humidifier\"; such objects are drawn as something similar";
        assert_eq!(both.len(), 1);
        assert_eq!((both[0].0.as_str(), both[0].1.as_str()), (say, "humidifier"));
    }

    #[test]
    fn what_is_unknown_is_told_once() {
        assert!(told(&["chair", "table"]).is_empty());
        let size = "give its size: `it0.dimensions <- vec3(…);`";
        let asset = "use a category from the library: `it0.category <- \"chair\";`";
        let all = |wanted: [(&str, &str, &str); 2], categories: &[&str]| {
            let wanted = wanted.map(|(a, b, c)| (a.to_owned(), b.to_owned(), c.to_owned()));
            assert_eq!(told(categories), wanted);
        };
        all(
            [
                ("W0601 the library has no model for \"gizmo\"; such an object becomes a labelled box", "", asset),
                (
                    "W0602 there is no usual size for \"gizmo\"; such an object becomes a cube with an edge length of 0.5 m",
                    "",
                    size,
                ),
            ],
            &["gizmo", "chair", "gizmo"],
        );
        let rest = "the others are g5, g6";
        all(
            [
                (
                    "W0601 the library has no model for \"g0\", \"g1\", \"g2\" and 4 more; such objects become labelled boxes",
                    "g1 g2 g3 g4",
                    rest,
                ),
                (
                    "W0602 there is no usual size for \"g0\", \"g1\", \"g2\" and 4 more; such objects become cubes with an edge length of 0.5 m",
                    "g1 g2 g3 g4",
                    rest,
                ),
            ],
            &["g0", "g1", "g2", "g3", "g4", "g5", "g6"],
        );
    }
}
