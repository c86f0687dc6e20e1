//! Static proofs: planted contradictions are found, exactly; what can be satisfied is never called contradictory.
//!
//! The second is tested with programs that are made from a layout: random objects, and random constraints of which the
//! verifier itself says that they hold there. None of these programs is contradictory, whatever a prover says.

use crate::dice::Dice;
use scenelang_base::{SourceFile, SourceMap};
use scenelang_lang::compile::compile_main;
use scenelang_lang::program::Program;
use scenelang_lang::sources::Loader;
use scenelang_layout::Layout;
use scenelang_layout::file::read;
use scenelang_verify::prove::{Findings, ProveOptions, prove};
use scenelang_verify::{Options, check};
use std::fmt::Write as _;
use std::path::Path;
use std::{fs, io};

struct Nothing;

impl Loader for Nothing {
    fn load(&self, _: &Path) -> io::Result<Vec<u8>> {
        Err(io::ErrorKind::NotFound.into())
    }
}

pub fn compiled(text: &str) -> Program {
    let mut sources = SourceMap::new();
    let main = sources.add(SourceFile::new("room.scene", "room.scene", text));
    let compiled = compile_main(main, scenelang_lang::Options { core: false }, &Nothing, sources);
    compiled.program.unwrap_or_else(|| panic!("{:?}\n{text}", compiled.diagnostics))
}

fn proved(program: &Program) -> Findings {
    prove(program, &ProveOptions::default())
}

/// The lines of the members of each contradiction.
pub fn lines(text: &str, program: &Program, findings: &Findings) -> Vec<Vec<usize>> {
    let line = |offset: u32| text[..offset as usize].matches('\n').count() + 1;
    let of = |c: &scenelang_verify::prove::Contradiction| {
        let statements = c.statements.iter().map(|s| program.constraints[*s].span);
        let definitions = c.definitions.iter().map(|d| program.definitions[*d].span);
        let mut lines: Vec<usize> = statements.chain(definitions).map(|s| line(s.range.start)).collect();
        lines.sort_unstable();
        lines
    };
    findings.contradictions.iter().map(of).collect()
}

/// Programs in `tests/proofs`: the lines that end in `//!` are the one contradiction, or several, by a digit behind it.
#[test]
fn planted_contradictions_are_found_exactly() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/proofs");
    let entries = fs::read_dir(folder).unwrap().map(|e| e.unwrap().path());
    let mut files: Vec<_> = entries.filter(|path| path.is_file()).collect();
    files.sort();
    assert!(files.len() > 10, "only {} files", files.len());
    let mut wrong = String::new();
    for file in files {
        let text = fs::read_to_string(&file).unwrap();
        let mut wanted: Vec<(String, Vec<usize>)> = Vec::new();
        for (index, line) in text.lines().enumerate() {
            let Some((_, name)) = line.split_once("//!") else { continue };
            match wanted.iter_mut().find(|(n, _)| n == name) {
                Some((_, lines)) => lines.push(index + 1),
                None => wanted.push((name.to_owned(), vec![index + 1])),
            }
        }
        let mut wanted: Vec<Vec<usize>> = wanted.into_iter().map(|(_, lines)| lines).collect();
        wanted.sort();
        let program = compiled(&text);
        let mut found = lines(&text, &program, &proved(&program));
        found.sort();
        if found != wanted {
            writeln!(wrong, "{}: expected {wanted:?}, found {found:?}", file.display()).unwrap();
        }
    }
    assert!(wrong.is_empty(), "\n{wrong}");
}

#[test]
fn a_proof_names_what_is_given_and_ends_in_the_impossible() {
    let program = compiled("object a; object b;\nassert a.pos.x < b.pos.x; assert b.pos.x + 1 <= a.pos.x;");
    let findings = prove(&program, &ProveOptions { explain: true, ..ProveOptions::default() });
    let proof = findings.contradictions[0].proof.as_ref().unwrap();
    let steps: Vec<&str> = proof.steps.iter().map(|s| s.text.as_str()).collect();
    for given in ["given: `a.pos.x < b.pos.x`", "given: `b.pos.x + 1 <= a.pos.x`"] {
        assert!(steps.contains(&given), "{steps:#?}");
    }
    assert!(steps.last().is_some_and(|s| s.starts_with("no value") || s.contains("contradict")), "{steps:#?}");
}

#[test]
fn a_search_that_is_called_off_finds_nothing_and_says_so() {
    let program = compiled("object a;\nassert a.pos.x < 1; assert a.pos.x > 2;");
    let cancel = Some(std::sync::Arc::new(std::sync::atomic::AtomicBool::new(true)));
    let findings = prove(&program, &ProveOptions { cancel, ..ProveOptions::default() });
    assert!(findings.contradictions.is_empty() && !findings.complete);
    let findings = prove(&program, &ProveOptions { work: 0, ..ProveOptions::default() });
    assert!(findings.contradictions.is_empty() && !findings.complete);
}

/// A hidden layout: objects `a`, `b`, …, a room and perhaps a zone, of four walls or more, and variables of each kind.
pub struct Hidden {
    pub names: Vec<&'static str>,
    pub regions: Vec<&'static str>,
    pub declarations: String,
    pub pins: Vec<String>,
    pub layout: Layout,
}

pub fn hidden(dice: &mut Dice) -> Hidden {
    any_hidden(dice, false)
}

/// One as proofs take it for granted, if it is to be `usual`: rooms unturned, things upright on the floor.
fn any_hidden(dice: &mut Dice, usual: bool) -> Hidden {
    let names = ["a", "b", "c", "d", "e", "f"][..2 + dice.below(5)].to_vec();
    let mut regions = vec!["room"];
    if dice.chance(40) {
        regions.push("zone");
    }
    let (mut declarations, mut pins) = (String::new(), Vec::new());
    let mut json = String::from("{ \"format\": \"scenelang.layout/1\", \"objects\": {");
    let triple = |v: [f64; 3]| format!("[{}, {}, {}]", v[0], v[1], v[2]);
    let vec3 = |v: [f64; 3], f: &str| format!("{f}({}, {}, {})", v[0], v[1], v[2]);
    // The room comes first, so that things can hang on its back wall, stand in it as doors do, or touch its ceiling.
    let room = ([dice.between(-0.5, 0.5), 0.0, dice.between(-0.5, 0.5)], [0; 3].map(|_| dice.between(5.0, 7.0)));
    let ([room_x, _, room_z], [_, height, depth]) = room;
    let mut last: Option<([f64; 3], [f64; 3])> = None;
    for (i, name) in names.iter().enumerate() {
        let yaw = if dice.chance(60) { 90.0 * dice.below(4) as f64 } else { dice.between(0.0, 359.0) };
        let tilt = if dice.chance(10) { dice.between(-60.0, 60.0) } else { 0.0 };
        let mut pos = [
            dice.between(-2.0, 2.0),
            if dice.chance(70) { 0.0 } else { dice.between(0.0, 2.0) },
            dice.between(-2.0, 2.0),
        ];
        let (mut rot, mut scale) = ([tilt, yaw, 0.0], [0, 1, 2].map(|_| dice.between(0.1, 1.2)));
        match (dice.below(12), last) {
            (0, _) => (rot, pos) = ([0.0; 3], [room_x, dice.between(0.0, 2.0), room_z - depth / 2.0 + scale[2] / 2.0]),
            (1, _) => (rot, pos) = ([0.0; 3], [room_x + dice.between(-1.0, 1.0), 0.0, room_z - depth / 2.0]),
            (2, _) => (rot, pos[1]) = ([0.0; 3], height - scale[1]),
            // Within the one before: small, or not small enough.
            (3 | 4, Some((at, size))) => (pos, scale) = (at, size.map(|s| s * dice.one(&[0.5, 0.7, 1.0]))),
            _ => {}
        }
        if usual {
            (rot[0], pos[1]) = (0.0, 0.0);
        }
        last = Some((pos, scale));
        writeln!(declarations, "object {name};").unwrap();
        if usual && dice.chance(50) {
            let category = dice.one(&["table", "desk", "cabinet", "crate", "sofa", "bed", "chair", "lamp"]);
            writeln!(declarations, "{name}.category <- \"{category}\";").unwrap();
        }
        pins.push(format!("{name}.pos <- {}", vec3(pos, "vec3")));
        pins.push(format!("{name}.rot <- {}", vec3(rot, "rot")));
        pins.push(format!("{name}.scale <- {}", vec3(scale, "vec3")));
        let comma = if i > 0 { "," } else { "" };
        write!(
            json,
            "{comma} \"{name}\": {{ \"pos\": {}, \"rot\": {}, \"scale\": {} }}",
            triple(pos),
            triple(rot),
            triple(scale)
        )
        .unwrap();
    }
    json += " }, \"regions\": {";
    for (i, name) in regions.iter().enumerate() {
        let yaw = if dice.chance(70) || usual { 0.0 } else { dice.between(0.0, 359.0) };
        let side = if i == 0 { 5.0 } else { 2.0 };
        let (mut pos, rot) = ([dice.between(-0.5, 0.5), 0.0, dice.between(-0.5, 0.5)], [0.0, yaw, 0.0]);
        let mut scale = [dice.between(side, side + 2.0), dice.between(2.0, 4.0), dice.between(side, side + 2.0)];
        if i == 0 {
            (pos, scale) = room;
        }
        writeln!(declarations, "region {name};").unwrap();
        let comma = if i > 0 { "," } else { "" };
        let placed = [triple(pos), triple(rot), triple(scale)];
        let [at, turned, size] = &placed;
        write!(json, "{comma} \"{name}\": {{ \"pos\": {at}, \"rot\": {turned}, \"scale\": {size}").unwrap();
        pins.push(format!("{name}.pos <- {}", vec3(pos, "vec3")));
        if dice.chance(35) {
            let corners = outline(dice, pos, side);
            let floor = corners.iter().map(|[x, z]| format!("vec3({x}, 0, {z})")).collect::<Vec<_>>().join(", ");
            pins.push(format!("{name}.vertices <- polygon({floor})"));
            write!(json, ", \"vertices\": {corners:?}").unwrap();
        } else {
            pins.push(format!("{name}.rot <- {}", vec3(rot, "rot")));
            pins.push(format!("{name}.scale <- {}", vec3(scale, "vec3")));
        }
        json += " }";
    }
    let (number, flag, turn) = (dice.between(-3.0, 3.0), dice.chance(50), dice.between(0.0, 359.0));
    let (at, way) = ([0; 3].map(|_| dice.between(-2.0, 2.0)), [0; 3].map(|_| dice.between(0.0, 359.0)));
    let (at, way) = (triple(at), triple(way));
    write!(
        json,
        " }}, \"variables\": {{ \"n\": {number}, \"p\": {flag}, \"t\": {turn}, \"v\": {at}, \"w\": {way} }} }}"
    )
    .unwrap();
    declarations += "Number n;\nBool p;\nDegree t;\nVector3 v;\nRotation w;\n";
    let mut sources = SourceMap::new();
    let file = sources.add(SourceFile::new("room.layout.json", "room.layout.json", json.as_str()));
    Hidden { names, regions, declarations, pins, layout: read(&json, file).layout }
}

/// A floor that is no rectangle: an L, or a ring of corners around the middle.
fn outline(dice: &mut Dice, [x, _, z]: [f64; 3], side: f64) -> Vec<[f64; 2]> {
    let (w, d) = (dice.between(side, side + 2.0), dice.between(side, side + 2.0));
    let corners: Vec<[f64; 2]> = if dice.chance(50) {
        let k = dice.between(0.3, 0.7);
        vec![[0.0, 0.0], [w, 0.0], [w, d * k], [w * k, d * k], [w * k, d], [0.0, d]]
            .into_iter()
            .map(|[a, b]| [a - w / 2.0, b - d / 2.0])
            .collect()
    } else {
        let n = 3 + dice.below(5);
        let at = |i: usize| (i as f64 * 360.0 / n as f64).to_radians();
        (0..n).map(|i| (i, dice.between(side / 2.0, side))).map(|(i, r)| [r * at(i).cos(), r * at(i).sin()]).collect()
    };
    let near = |v: f64| (v * 1000.0).round() / 1000.0;
    corners.into_iter().map(|[a, b]| [near(x + a), near(z + b)]).collect()
}

impl Hidden {
    /// What statements come to in the layout: whether they hold, and their margins.
    fn judged(&self, statements: &[String]) -> Vec<(Option<bool>, Option<f64>)> {
        let text = statements.iter().fold(self.declarations.clone(), |t, s| t + "assert " + s + ";\n");
        let options = Options { physics: false, ..Options::default() };
        let verdict = check(&compiled(&text), &self.layout, &options);
        verdict.rows.iter().map(|r| (r.satisfied, r.margin.map(|m| m.0))).collect()
    }

    /// Statements that allow what the layout does against the physical rules.
    fn allowances(&self, text: &str) -> String {
        use scenelang_verify::check::Subject;
        let program = compiled(text);
        let name = |id: scenelang_lang::program::ObjectId| program.objects[id.0 as usize].name.clone();
        let mut out = String::new();
        for row in check(&program, &self.layout, &Options::default()).rows {
            match (row.subject, row.satisfied) {
                // Nothing in these layouts opens.
                (_, Some(true)) | (Subject::Statement(_) | Subject::Part(..), _) => {}
                (Subject::Pair(a, b), _) => writeln!(out, "allowCollide({}, {});", name(a), name(b)).unwrap(),
                (Subject::Object(a), _) if row.text.contains("region") => {
                    writeln!(out, "allowOutside({});", name(a)).unwrap();
                }
                (Subject::Object(a), _) => writeln!(out, "allowFloat({});", name(a)).unwrap(),
            }
        }
        out
    }

    /// A number that the layout knows.
    fn expression(&self, dice: &mut Dice) -> String {
        let (a, b) = (dice.one(&self.names), dice.one(&self.names));
        let r = dice.one(&self.regions);
        let axis = dice.one(&["x", "y", "z"]);
        match dice.below(34) {
            0 | 1 => format!("{a}.pos.{axis}"),
            2 | 3 => format!("{a}.pos.{axis} - {b}.pos.{axis}"),
            4 => format!("{a}.center.{axis} + {b}.scale.{axis}"),
            5 | 6 => format!("distance({a}, {b})"),
            7 => format!("length(vec3({a}.center.x - {b}.center.x, 0, {a}.center.z - {b}.center.z))"),
            8 if a != b => format!("gap({a}, {b})"),
            9 => format!("gap({a}, {r})"),
            10 => format!("{a}.top - {b}.bottom"),
            11 => format!("{a}.size.x * {b}.size.z"),
            12 => format!("dot({a}.center - {b}.center, {b}.right)"),
            13 => format!("abs({a}.pos.x) + max({b}.pos.z, {a}.pos.z, n)"),
            14 => format!("{a}.front.{axis}"),
            15 => format!("min({a}.pos.x, {b}.pos.x, {a}.scale.{axis} * 2)"),
            16 => format!("{a}.pos.x * {a}.pos.x + {b}.pos.z * {b}.pos.z"),
            17 => format!("distance({a}, {b}) + distance({b}, {})", dice.one(&self.names)),
            18 => "n".to_owned(),
            19 => format!("{a}.max.{axis} - {b}.min.{axis}"),
            20 => format!("gap({a}.center, {r})"),
            21 => format!("{a}.rot.{axis}"),
            22 => format!("{a}.rot.y - {b}.rot.y"),
            23 => format!("angle({a}.front, {b}.{})", dice.one(&["front", "right", "up"])),
            24 => format!("angle({a}.rot, {})", dice.one(&["w".to_owned(), format!("{b}.rot")])),
            25 => "t".to_owned(),
            26 => format!("{a}.rot.y + t"),
            27 => format!("v.{axis}"),
            28 => format!("distance({a}, v)"),
            29 => format!("{}({a}.rot.y)", dice.one(&["sin", "cos"])),
            30 => format!("{r}.area"),
            31 => format!("{r}.center.{axis} - {a}.center.{axis}"),
            32 => format!("count(o in objects: o.pos.x > {a}.pos.x) * 2"),
            _ => format!("{r}.scale.{axis} - {a}.scale.{axis}"),
        }
    }

    /// A predicate that holds or not.
    fn predicate(&self, dice: &mut Dice) -> String {
        let (a, b, c) = (dice.one(&self.names), dice.one(&self.names), dice.one(&self.names));
        let r = dice.one(&self.regions);
        let x = dice.between(-2.0, 2.0);
        match dice.below(21) {
            0..4 => {
                let of = [
                    "leftOf",
                    "rightOf",
                    "inFrontOf",
                    "behind",
                    "above",
                    "below",
                    "facing",
                    "aligned",
                    "parallel",
                    "on",
                    "under",
                    "beside",
                    "restsOn",
                    "looksAt",
                    "seenLeftOf",
                ];
                format!("{}({a}, {b})", dice.one(&of))
            }
            4 => format!("between({a}, {b}, {c})"),
            5 => format!("inside({a}, {r})"),
            6 => format!("{}({a}, {r})", dice.one(&["againstWall", "inCorner", "centeredIn", "onFloor"])),
            7 => format!("inside({a}, {b})"),
            8 if a != b => format!("{}({a}, {b})", dice.one(&["collides", "visible"])),
            9 => format!("clear({a}, {}, {})", dice.one(&["front", "behind", "left", "right", "above"]), x.abs()),
            10 => format!("count(o in objects: o.pos.x > {x}) >= {}", dice.below(self.names.len() + 1)),
            11 => format!("{}(o in objects: o.pos.z < {x} or o.top > {})", dice.one(&["count"]), x.abs()) + " <= 2",
            12 => format!("({} o in objects: distance(o, {a}) <= {})", dice.one(&["forall", "exists"]), x.abs() + 1.0),
            13 => format!("{}({a}, {r})", dice.one(&["wallMounted", "ceilingMounted", "connects", "connects"])),
            14 => format!("connects({a}, {}, {})", self.regions[0], self.regions[self.regions.len() - 1]),
            15 => format!("{a}.rot = {}", dice.one(&["w".to_owned(), format!("{b}.rot"), "rot(0, t, 0)".to_owned()])),
            16 => format!("{a}.{} = {b}.{}", dice.one(&["pos", "center"]), dice.one(&["pos", "max"])),
            17 => format!("forall o in objects: exists q in objects: o != q and gap(o, q) <= {}", x.abs()),
            18 => format!("(forall o in objects: o.top <= {r}.ceiling) = (exists o in objects: inside(o, {r}))"),
            19 => format!("count(o in objects: inside(o, {r})) {} {}", dice.one(&["=", "<", ">"]), dice.below(4)),
            _ => dice.one(&["p", "p = (n > 0)", "(n < 1) = p", "t < 180 implies p"]).to_owned(),
        }
    }

    /// Statements that hold in the layout, about `count` of them.
    fn truths(&self, dice: &mut Dice, count: usize) -> Vec<String> {
        let expressions: Vec<String> = (0..count).map(|_| self.expression(dice)).collect();
        let zeros: Vec<String> = expressions.iter().map(|e| format!("{e} >= 0")).collect();
        let values = self.judged(&zeros);
        let mut atoms: Vec<String> = expressions
            .iter()
            .zip(values)
            .filter_map(|(e, (_, value))| {
                // As near to the truth as can be, or not.
                let off = dice.one(&[0.0, 0.0005, -0.0005, 0.001, -0.001, 0.02, -0.02, 0.5, -0.5]);
                let sign = dice.one(&["<", "<=", ">", ">=", "=", "!=", "<=", ">="]);
                Some(format!("{e} {sign} {:.4}", value? + off))
            })
            .collect();
        atoms.extend((0..count / 2).map(|_| self.predicate(dice)));
        let mut truths: Vec<String> = Vec::new();
        for (atom, (holds, _)) in atoms.iter().zip(self.judged(&atoms)) {
            match holds {
                Some(true) => truths.push(atom.clone()),
                Some(false) => truths.push(format!("not ({atom})")),
                None => {}
            }
        }
        // Joined with others, true or not.
        let mut out = Vec::new();
        for truth in &truths {
            let other = dice.one(&atoms);
            out.push(match dice.below(8) {
                0 => format!("({truth}) or ({other})"),
                1 => format!("({other}) implies ({truth})"),
                2 => format!("not (not ({truth}) and ({other}))"),
                3 => format!("({truth}) and ({})", dice.one(&truths)),
                _ => truth.clone(),
            });
        }
        out
    }
}

/// A program that the hidden layout of a seed satisfies, as the verifier itself says.
fn satisfiable(seed: u64, usual: bool) -> Option<(String, Program)> {
    let mut dice = Dice(seed);
    let hidden = any_hidden(&mut dice, usual);
    let count = 3 + dice.below(14);
    let mut text = hidden.declarations.clone();
    for pin in &hidden.pins {
        // The sizes of these are not the usual ones.
        let sized = usual && pin.contains(".scale");
        if dice.chance(35) || sized {
            writeln!(text, "{pin};").unwrap();
        }
    }
    for truth in hidden.truths(&mut dice, count) {
        writeln!(text, "assert {truth};").unwrap();
    }
    // Twice: what an allowance lifts may have stood for something else.
    for _ in 0..2 {
        text += &hidden.allowances(&text);
    }
    let program = compiled(&text);
    let verdict = check(&program, &hidden.layout, &Options::default());
    verdict.rows.iter().all(|r| r.satisfied == Some(true)).then_some((text, program))
}

/// How many are made; `SCENELANG_PROOFS=10000` makes more.
fn how_many() -> u64 {
    std::env::var("SCENELANG_PROOFS").ok().and_then(|n| n.parse().ok()).unwrap_or(150)
}

#[test]
fn what_a_layout_satisfies_is_not_contradictory() {
    refutes_nothing_satisfiable(false);
}

/// Under what `check` takes for granted, too.
#[test]
fn what_a_usual_layout_satisfies_is_not_contradictory_as_usual() {
    refutes_nothing_satisfiable(true);
}

fn refutes_nothing_satisfiable(usual: bool) {
    let (mut made, mut wrong) = (0, String::new());
    for seed in 0..how_many() {
        let Some((text, program)) = satisfiable(seed, usual) else { continue };
        made += 1;
        let findings = prove(&program, &ProveOptions { work: 1_000_000, usual, ..ProveOptions::default() });
        if !findings.contradictions.is_empty() {
            let lines = lines(&text, &program, &findings);
            writeln!(wrong, "seed {seed}: {lines:?}\n{text}").unwrap();
        }
    }
    println!("{made} programs that their layout satisfies");
    assert!(wrong.is_empty(), "\n{wrong}");
    assert!(made * 10 > how_many() * 8, "only {made} programs");
}

/// What is said to be redundant follows: so without it, and with its contrary, nothing in sight may hold. Here: whatever
/// holds in the layout of the others holds for it.
#[test]
fn what_is_called_always_true_holds_in_every_layout() {
    let mut wrong = String::new();
    for seed in 0..how_many() / 3 {
        let mut dice = Dice(seed ^ 0xa11);
        let (first, second) = (hidden(&mut dice), hidden(&mut dice));
        if first.declarations != second.declarations {
            continue;
        }
        // True in the one; judged in the other.
        let truths = first.truths(&mut dice, 8);
        let text = truths.iter().fold(first.declarations.clone(), |t, s| t + "assert " + s + ";\n");
        let program = compiled(&text);
        let findings = prove(&program, &ProveOptions { work: 1_000_000, ..ProveOptions::default() });
        let there = second.judged(&truths);
        for always in findings.always {
            if there[always].0 == Some(false) {
                writeln!(wrong, "seed {seed}: `{}` does not always hold", truths[always]).unwrap();
            }
        }
        for redundancy in findings.redundant {
            let given = redundancy.by.iter().all(|s| there[*s].0 == Some(true));
            if given && there[redundancy.statement].0 == Some(false) {
                writeln!(wrong, "seed {seed}: `{}` does not follow", truths[redundancy.statement]).unwrap();
            }
        }
    }
    assert!(wrong.is_empty(), "\n{wrong}");
}
