//! Built-ins, all alike: what each says of itself is true. Arguments are made from the signatures, so that a new built-in
//! is tested by being there.
//!
//! - Where there is fast code, its verdict is the exact one, and so is its margin where it holds.
//! - What proofs assume allows the exact value: a program that states it is never called contradictory.
//! - What is declared to look at its arguments alone is not changed by anything else.

use crate::dice::Dice;
use crate::proofs::{Hidden, compiled, hidden};
use scenelang_lang::natives::SIDES;
use scenelang_lang::program::{BuiltIn, Formula, Node, NodeId, Program};
use scenelang_lang::types::Ty;
use scenelang_layout::{Joint, Layout, Motion, Part, Vec3};
use scenelang_verify::coded::Coder;
use scenelang_verify::prove::{ProveOptions, prove};
use scenelang_verify::{Options, Value, World, evaluate, surroundings};
use std::collections::{BTreeMap, BTreeSet};

/// A scene in which every object is a body with a door over a drawer.
fn opening(dice: &mut Dice) -> Hidden {
    let mut hidden = hidden(dice);
    for (_, thing) in &mut hidden.layout.objects {
        let [w, h, d] = thing.scale.into();
        let part = |[y, z]: [f64; 2], [high, deep]: [f64; 2]| Part::Box {
            pos: Vec3::new(0.0, y * h, z * d),
            size: Vec3::new(w, high * h, deep * d),
            rot: Vec3::zeros(),
        };
        thing.parts =
            vec![part([0.5, -0.05], [1.0, 0.9]), part([0.75, 0.45], [0.5, 0.1]), part([0.25, 0.45], [0.5, 0.1])];
        let joint = |motion, axis, [most, useful]: [f64; 2], part: usize| Joint {
            name: format!("part {part}").into(),
            motion,
            axis,
            anchor: Vec3::new(-w / 2.0, 0.0, d / 2.0),
            limits: [0.0, most],
            useful: Some(useful),
            handle: None,
            parts: vec![part],
        };
        thing.joints =
            vec![joint(Motion::Hinge, -Vec3::y(), [110.0, 90.0], 1), joint(Motion::Slide, Vec3::z(), [1.6, 0.5], 2)];
    }
    hidden
}

fn cases() -> u64 {
    std::env::var("SCENELANG_CASES").ok().and_then(|n| n.parse().ok()).unwrap_or(150)
}

/// An argument of a type, as text. Objects are chosen without repetition as long as there are others.
fn argument(ty: Ty, hidden: &Hidden, left: &mut Vec<&'static str>, dice: &mut Dice) -> String {
    match ty {
        Ty::Object => {
            if left.is_empty() || dice.chance(3) {
                return dice.one(&hidden.names).to_owned();
            }
            left.remove(dice.below(left.len())).to_owned()
        }
        Ty::Region => dice.one(&hidden.regions).to_owned(),
        Ty::Number => dice.between(0.05, 1.5).to_string(),
        Ty::Degree => format!("{}deg", dice.between(0.0, 180.0)),
        Ty::Vector3 => format!("{}.center + vec3({}, 0, 0.5)", dice.one(&hidden.names), dice.between(-3.0, 3.0)),
        Ty::Side => dice.one(SIDES).0.to_owned(),
        other => panic!("no argument of type {other:?} can be made: teach this test"),
    }
}

/// A use of each signature of each built-in.
fn calls(hidden: &Hidden, dice: &mut Dice) -> Vec<(BuiltIn, String)> {
    let mut out = Vec::new();
    for &built_in in BuiltIn::ALL {
        for signature in built_in.signatures() {
            let mut left = hidden.names.clone();
            let args = signature.params.iter().map(|ty| argument(*ty, hidden, &mut left, dice));
            let args = args.collect::<Vec<_>>().join(", ");
            out.push((built_in, format!("{}({args})", built_in.name())));
        }
    }
    out
}

/// The formula of a built-in alone, and its node.
fn alone(program: &Program, at: usize) -> (Formula, NodeId) {
    let formula = &program.constraints[at].formula;
    let index = formula.nodes.iter().position(|n| matches!(n, Node::BuiltIn(..))).expect("it is a call");
    let root = NodeId(index as u32);
    (Formula { root, ..formula.clone() }, root)
}

/// A program that states each call as it stands, measures as compared with 0.
fn stating(hidden: &Hidden, calls: &[(BuiltIn, String)]) -> Program {
    let state = |(built_in, call): &(BuiltIn, String)| {
        let compared = if built_in.is_predicate() { "" } else { " >= 0" };
        format!("assert {call}{compared};\n")
    };
    compiled(&(hidden.declarations.clone() + &calls.iter().map(state).collect::<String>()))
}

#[test]
fn fast_code_says_what_is_exact() {
    let mut checked: BTreeMap<&str, usize> = BTreeMap::new();
    for seed in 0..cases() {
        let mut dice = Dice(seed);
        let hidden = opening(&mut dice);
        let calls = calls(&hidden, &mut dice);
        let program = stating(&hidden, &calls);
        let world = World::<f64>::new(&program, &hidden.layout, &Options::default());
        let mut coder = Coder::new(&program, &world, &|_| false, &|_| true);
        for (at, (built_in, call)) in calls.iter().enumerate() {
            let (formula, node) = alone(&program, at);
            let exact = evaluate(&formula, &world).expect("all is there");
            let said = format!("seed {seed}: {call}: {exact:?}\n{:?}", hidden.layout);
            let agree = match exact {
                Value::Truth(exact) => {
                    let Some(code) = coder.truth(&formula) else { continue };
                    let mut slots = coder.slots();
                    code.run(&mut slots);
                    let fast = code.truth(node, &slots).expect("it has code");
                    // At the very limit rounding decides.
                    let limit = exact.margin.abs() < 1e-9;
                    let margin = exact.margin < 0.0 || (fast.margin - exact.margin).abs() < 1e-9;
                    (limit || fast.holds == exact.holds) && margin && fast.unit == exact.unit
                }
                Value::Number(exact) => {
                    let Some(code) = coder.value(&formula) else { continue };
                    let [fast, ..] = code.run(&mut coder.slots());
                    // Of what overlaps, or is outside, code and geometry may see another way out.
                    if exact < 0.0 { fast < 1e-9 } else { (fast - exact).abs() < 1e-9 }
                }
                other => panic!("{call} yields {other:?}"),
            };
            assert!(agree, "{said}");
            *checked.entry(built_in.name()).or_default() += 1;
        }
    }
    assert!(checked.len() >= 4 && checked.values().all(|n| *n as u64 > cases() / 2), "{checked:?}");
}

#[test]
fn proofs_allow_what_is_exact() {
    let mut refuted: BTreeSet<&str> = BTreeSet::new();
    let judging = Options { physics: false, ..Options::default() };
    let options = ProveOptions { judging, redundant: false, ..ProveOptions::default() };
    for seed in 0..cases() {
        let mut dice = Dice(seed ^ 0xb0_07ed);
        let hidden = opening(&mut dice);
        let calls = calls(&hidden, &mut dice);
        let program = stating(&hidden, &calls);
        let world = World::<f64>::new(&program, &hidden.layout, &Options::default());
        let mut placed = hidden.declarations.clone();
        placed.extend(hidden.pins.iter().map(|pin| format!("{pin};\n")));
        let (mut exact, mut contrary) = (Vec::new(), Vec::new());
        for (at, (_, call)) in calls.iter().enumerate() {
            let (stated, opposed) = match evaluate(&alone(&program, at).0, &world).expect("all is there") {
                Value::Truth(truth) => {
                    let not = format!("not {call}");
                    if truth.holds { (call.clone(), not) } else { (not, call.clone()) }
                }
                Value::Number(n) if n.is_infinite() => (format!("{call} > 1000"), format!("{call} <= 1000")),
                Value::Number(n) => (
                    format!("{call} >= {n:.12} - 1e-5 and {call} <= {n:.12} + 1e-5"),
                    format!("{call} <= {n:.12} - 100"),
                ),
                other => panic!("{call} yields {other:?}"),
            };
            exact.push(stated);
            contrary.push(opposed);
        }
        let text = exact.iter().fold(placed.clone(), |text, stated| text + "assert " + stated + ";\n");
        let findings = prove(&compiled(&text), &options);
        assert!(findings.contradictions.is_empty(), "seed {seed}: {:?}\n{text}", findings.contradictions);
        // And it is no empty promise: the contrary is refuted, at least of some.
        let one = seed as usize % calls.len();
        let text = format!("{placed}assert {};\n", contrary[one]);
        if !prove(&compiled(&text), &options).contradictions.is_empty() {
            refuted.insert(calls[one].0.name());
        }
    }
    assert!(refuted.len() >= 4, "only of these the contrary is refuted: {refuted:?}");
}

#[test]
fn what_looks_at_its_arguments_alone_is_changed_by_nothing_else() {
    let mut changed: BTreeSet<&str> = BTreeSet::new();
    let mut declared: BTreeSet<&str> = BTreeSet::new();
    for seed in 0..cases() {
        let mut dice = Dice(seed ^ 0x5eed);
        let hidden = opening(&mut dice);
        let calls = calls(&hidden, &mut dice);
        let program = stating(&hidden, &calls);
        let world = World::<f64>::new(&program, &hidden.layout, &Options::default());
        for (at, (built_in, _)) in calls.iter().enumerate() {
            let (formula, node) = alone(&program, at);
            let arguments = formula.objects();
            let mut layout: Layout = hidden.layout.clone();
            for (index, (_, placement)) in layout.objects.iter_mut().enumerate() {
                if arguments.iter().all(|id| id.0 as usize != index) {
                    placement.pos += Vec3::new(dice.between(-1.0, 1.0), 0.0, dice.between(-1.0, 1.0));
                }
            }
            let moved = World::<f64>::new(&program, &layout, &Options::default());
            if evaluate(&formula, &moved) != evaluate(&formula, &world) {
                changed.insert(built_in.name());
            }
            if surroundings(&formula, formula.node(node)).is_something() {
                declared.insert(built_in.name());
            }
        }
    }
    assert!(changed.is_subset(&declared), "changed {changed:?}, but declared {declared:?}");
    assert!(
        declared.is_subset(&changed),
        "declared {declared:?}, but changed {changed:?}: more than is so, or too few cases"
    );
}
