//! What each expression is: types, resolutions, targets, as an editor asks for them.

use super::*;
use crate::ast::{ExprKind, StmtKind};
use crate::compile::Options;
use crate::db::Analysis;
use crate::items::PredicateHead;
use scenelang_base::door::Door;
use scenelang_base::{SourceFile, SourceMap};

/// What the last statement of a program means: `text: type = what it stands for`, children before parents.
fn meaning(text: &str) -> String {
    let mut sources = SourceMap::new();
    let main = sources.add(SourceFile::new("a.scene", "a.scene", text));
    let mut analysis = Analysis::new(Options::default());
    analysis.update(main, &mut sources, &Door::of("a.scene".as_ref()));
    let meanings = analysis.meanings(main).expect("nobody changes it");
    let (Located { offset, stmt, .. }, hir) = *meanings.statements.last().expect("a statement");
    let slice = |range: TextRange| &text[range.shifted(offset).bytes()];
    let mut lines: Vec<String> = Vec::new();
    lines.extend(hir.target.as_ref().map(|t| format!("target: {} = {}", t.ty.name(), words(&t.owner))));
    for (i, expr) in stmt.exprs.iter().enumerate() {
        let id = ExprId(i as u32);
        let ty = hir.type_of(id).map_or("?", Ty::name);
        let meant = hir.resolution(id).map_or(String::new(), |r| format!(" = {}", words(r)));
        lines.push(format!("{}: {ty}{meant}", slice(expr.range)));
    }
    for local in &hir.locals {
        assert_eq!(slice(local.range), local.name);
    }
    lines.join("\n")
}

fn words(resolution: &Resolution) -> String {
    match resolution {
        Resolution::Item(name, kind) => format!("{name} {kind:?}"),
        Resolution::Element { array, index } => format!("{array}[{}]", index.map_or("_".into(), |i| i.to_string())),
        Resolution::AllObjects => "all".into(),
        Resolution::AllRooms => "all rooms".into(),
        Resolution::Local(local) => format!("local {local}"),
        Resolution::Predicate { name, library } => format!("{} {name}", if *library { "std" } else { "own" }),
        Resolution::BuiltIn(s) => format!("{}({}) of {:?}", s.name, s.names, s.params),
        Resolution::Property { of, property } => format!("{}.{}", of.name(), property.name),
        Resolution::Component => "component".into(),
        Resolution::Side(side) => format!("{side:?}"),
    }
}

const DECLARED: &str = "object lamp; object chair[2]; region room; Number n; Degree d; Color c; c <- \"red\";
predicate tall(Object a) := a.top > 2;\n";

#[test]
fn names_and_types() {
    let cases = [
        (
            "assert lamp.pos.x > n + 1;",
            "lamp: Object = lamp Object
lamp.pos: Vector3 = Object.pos
lamp.pos.x: Number = component
n: Number = n Variable(Number)
1: Literal
n + 1: Number
lamp.pos.x > n + 1: Bool",
        ),
        (
            "assert forall i in 0..1: near(chair[i], chair[1], 30cm);",
            "0: Literal
1: Literal
0..1: Range
chair: Objects = chair Array(2)
i: Literal = local 0
chair[i]: Object = chair[_]
chair: Objects = chair Array(2)
1: Literal
chair[1]: Object = chair[1]
30cm: Number
near(chair[i], chair[1], 30cm): Bool = std near
forall i in 0..1: near(chair[i], chair[1], 30cm): Bool",
        ),
        (
            "assert exists a in objects where .color = \"red\": tall(a) and clear(a, front, 1) and gap(a, room) > 0;",
            "objects: Objects = all
.color: String = Object.color
\"red\": String
.color = \"red\": Bool
objects where .color = \"red\": Objects
a: Object = local 0
tall(a): Bool = own tall
a: Object = local 0
front: Side = Front
1: Literal
clear(a, front, 1): Bool = clear(a, side, depth) of [Object, Side, Number]
tall(a) and clear(a, front, 1): Bool
a: Object = local 0
room: Region = room Region
gap(a, room): Number = gap(a, r) of [Object, Region]
0: Literal
gap(a, room) > 0: Bool
tall(a) and clear(a, front, 1) and gap(a, room) > 0: Bool
exists a in objects where .color = \"red\": tall(a) and clear(a, front, 1) and gap(a, room) > 0: Bool",
        ),
        (
            "chair[1].color <- c;",
            "target: Color = chair[1]
1: Literal
c: Color = c Variable(Color)",
        ),
        (
            "n <- d / 2;",
            "target: Number = n Variable(Number)
d: Degree = d Variable(Degree)
2: Literal
d / 2: Degree",
        ),
        (
            "predicate p(Object a, Region r) := inside(a, r);",
            "a: Object = local 0
r: Region = local 1
inside(a, r): Bool = inside(a, r) of [Object, Region]",
        ),
        ("object more[3];", "3: Literal"),
        (
            "prefer nothing.pos = nowhere(1) weight 2;",
            "nothing: Error\nnothing.pos: Error\n1: Literal\nnowhere(1): Error\nnothing.pos = nowhere(1): Bool\n2: Literal",
        ),
        ("allowFloat(lamp, chair);", "lamp: Object = lamp Object\nchair: Objects = chair Array(2)"),
        (
            "assert lamp.pos.y > gap(lamp);",
            "lamp: Object = lamp Object\nlamp.pos: Vector3 = Object.pos\nlamp.pos.y: Number = component\nlamp: Object = lamp Object\ngap(lamp): Number = gap(a, b) of [Object, Object]\nlamp.pos.y > gap(lamp): Bool",
        ),
    ];
    for (text, wanted) in cases {
        assert_eq!(meaning(&format!("{DECLARED}{text}")), wanted, "{text}");
    }
}

/// The innermost name wins, and a name is out of scope behind its quantifier.
#[test]
fn scopes() {
    let text = "assert (forall lamp in chair: exists lamp in 0..1: lamp = 1) and lamp.pos.x > 0;";
    let found = meaning(&format!("{DECLARED}{text}"));
    let names: Vec<&str> = found.lines().filter(|l| l.starts_with("lamp:")).collect();
    assert_eq!(names, ["lamp: Literal = local 1", "lamp: Object = lamp Object"]);
}

/// Every expression of a statement without errors has a type.
#[test]
fn the_library_has_types() {
    for file in crate::library::parsed() {
        for (_, stmt) in &file.statements {
            let hir = statement(&Library, stmt);
            for (i, expr) in stmt.exprs.iter().enumerate() {
                let id = ExprId(i as u32);
                assert!(hir.type_of(id).is_some_and(|ty| ty != Ty::Error), "{expr:?}");
                let named = matches!(expr.kind, ExprKind::Name(_) | ExprKind::Member(..) | ExprKind::Call(..));
                assert!(!named || hir.resolution(id).is_some(), "{expr:?}");
            }
            let StmtKind::Predicate { params, .. } = &stmt.kind else { continue };
            assert!(hir.locals.len() >= params.len());
        }
    }
}

/// The names that the library sees: its own.
struct Library;

impl Names for Library {
    fn item(&self, _: &str) -> Option<ItemKind> {
        None
    }
    fn is_assigned(&self, _: &str) -> bool {
        false
    }
    fn is_poisoned(&self, _: &str) -> bool {
        false
    }
    fn predicate(&self, name: &str) -> Option<PredicateHead> {
        crate::library::predicate_head(name)
    }
    fn declared(&self) -> Vec<SmolStr> {
        Vec::new()
    }
    fn predicates(&self) -> Vec<SmolStr> {
        Vec::new()
    }
}
