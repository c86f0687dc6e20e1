//! What a program says: which things there are, and of each constraint what it mentions, calls and measures.
//!
//! Things and mentions come from the compiled program, so that `forall c in objects where .category = "chair"` mentions
//! the chairs. Calls and constants come from the statements as written, where library predicates are names still; of a
//! predicate that the program defines itself, what its body calls and measures counts as well.

use crate::words::Called;
use scenelang_base::FileId;
use scenelang_lang::ast::{BinaryOp, ExprId, ExprKind, Stmt, StmtKind, UnitSuffix};
use scenelang_lang::parse::parse_file;
use scenelang_lang::program::{
    Arg, Constraint, ConstraintKind, Formula, Node, NodeId, Object, Owner, Pinned, Program, RegionId,
};
use std::collections::{BTreeMap, BTreeSet};

/// A program, as far as scores go.
#[derive(Debug, Default)]
pub struct ProgramOutline {
    /// Its objects by name: an array is one, and so is a series `chair1`, `chair2`, ….
    pub things: Vec<Named>,
    pub regions: Vec<Called>,
    /// Its assertions, preferences and assignments of places and sizes.
    pub statements: Vec<Statement>,
}

/// Objects of one name.
#[derive(Debug)]
pub struct Named {
    /// The name, without an index.
    pub name: String,
    /// The words of name and category.
    pub called: Called,
    /// How many there are.
    pub count: usize,
    /// Name, category, colours, materials and features.
    pub texts: Vec<String>,
    /// The regions that some statement mentions together with it: indices into [`ProgramOutline::regions`].
    pub regions: BTreeSet<usize>,
}

/// A constraint.
#[derive(Debug, Default)]
pub struct Statement {
    /// Whether it is an `assert` or a `prefer`.
    pub asks: bool,
    /// Whether it must hold.
    pub must: bool,
    /// Whether it says that the request asks for it, and does not say that it was inferred.
    pub stated: bool,
    /// The predicates that it calls with two or more things or regions.
    pub said: Vec<Said>,
    /// Things that it mentions.
    pub things: BTreeSet<usize>,
    /// Regions that it mentions.
    pub regions: BTreeSet<usize>,
    /// What was written.
    pub written: Written,
}

/// A call of a predicate.
#[derive(Clone, Debug, PartialEq)]
pub struct Said {
    /// The predicate.
    pub name: String,
    /// Whether it is denied.
    pub denied: bool,
    /// Its arguments in their order; what is neither a thing nor a region is left out.
    pub of: Vec<Argument>,
}

/// What a predicate is said of: indices into [`ProgramOutline::things`] and [`ProgramOutline::regions`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Argument {
    /// Objects of one name.
    Thing(usize),
    Region(usize),
}

/// What a statement says as written.
#[derive(Clone, Debug, Default)]
pub struct Written {
    /// Predicates that it calls.
    pub calls: BTreeSet<String>,
    /// Predicates that it calls to deny them.
    pub denials: BTreeSet<String>,
    /// Its numbers, lengths in metres.
    pub constants: Vec<f64>,
    /// The same calls with the names of their arguments; whether each is denied.
    pub arguments: Vec<(String, bool, Vec<String>)>,
}

impl ProgramOutline {
    /// What a compiled program says; `text` is its main file.
    pub fn new(program: &Program, main: FileId, text: &str) -> Self {
        let (groups, mut things) = group(&program.objects);
        let regions = program.regions.iter().map(|r| Called::by([r.name.as_str(), r.text("features")])).collect();
        let statements = statements(program, main, text, &groups);
        for statement in &statements {
            for thing in &statement.things {
                things[*thing].regions.extend(&statement.regions);
            }
        }
        Self { things, regions, statements }
    }
}

/// The things, and of each object which it belongs to.
fn group(objects: &[Object]) -> (Vec<usize>, Vec<Named>) {
    let mut numbered: BTreeMap<(&str, &str), usize> = BTreeMap::new();
    let own: BTreeSet<&str> = objects.iter().map(|o| o.array.as_ref().map_or(&*o.name, |(a, _)| a)).collect();
    let stem = |o: &Object| {
        let stem = o.name.trim_end_matches(|c: char| c.is_ascii_digit()).trim_end_matches('_').len();
        (o.array.is_none() && stem > 0 && stem < o.name.len() && !own.contains(&o.name[..stem])).then_some(stem)
    };
    for object in objects {
        if let Some(end) = stem(object) {
            *numbered.entry((&object.name[..end], &object.category)).or_default() += 1;
        }
    }
    let (mut groups, mut things): (Vec<usize>, Vec<Named>) = (Vec::new(), Vec::new());
    let mut known: BTreeMap<(&str, &str), usize> = BTreeMap::new();
    for object in objects {
        let series = stem(object)
            .map(|end| (&object.name[..end], object.category.as_str()))
            .filter(|key| numbered.get(key).is_some_and(|n| *n > 1));
        // A name stands for one thing whatever its elements are; a series for things of one category.
        let key = series.unwrap_or_else(|| (object.array.as_ref().map_or(&*object.name, |(a, _)| a), ""));
        let thing = *known.entry(key).or_insert(things.len());
        if thing == things.len() {
            let name = key.0.to_owned();
            let called = Called::by([name.as_str(), &object.category]);
            things.push(Named { name, called, count: 0, texts: Vec::new(), regions: BTreeSet::new() });
        }
        things[thing].count += 1;
        let texts = [key.0, &object.category, &object.color, &object.material, &object.features];
        things[thing].texts.extend(texts.map(str::to_owned));
        groups.push(thing);
    }
    (groups, things)
}

fn statements(program: &Program, main: FileId, text: &str, groups: &[usize]) -> Vec<Statement> {
    let file = parse_file(text);
    let at: BTreeMap<u32, &Stmt> = file.statements.iter().map(|(offset, s)| (offset + s.range.start, s)).collect();
    let predicates: BTreeMap<&str, &Stmt> = at
        .values()
        .filter_map(|s| if let StmtKind::Predicate { name, .. } = &s.kind { Some((&*name.text, *s)) } else { None })
        .collect();
    let named = |name: &String| -> Option<Argument> {
        let own = |o: &Object| o.array.as_ref().map_or(&*o.name, |(array, _)| array) == name.as_str();
        let thing = program.objects.iter().position(own).map(|at| Argument::Thing(groups[at]));
        thing.or_else(|| program.regions.iter().position(|r| r.name == name.as_str()).map(Argument::Region))
    };
    let mut out: Vec<Statement> = program
        .constraints
        .iter()
        .map(|constraint| {
            let mut written = Written::default();
            let definitions = constraint.definitions.iter().filter_map(|d| program.definitions.get(*d));
            for span in [constraint.span].into_iter().chain(definitions.map(|d| d.span)) {
                if let Some(stmt) = at.get(&span.range.start).filter(|_| span.file == main) {
                    let (inside, ranges) = (Vec::new(), Vec::new());
                    Reader { predicates: &predicates, inside, ranges, out: &mut written }.statement(stmt);
                }
            }
            let things = constraint.formula.objects().iter().map(|o| groups[o.0 as usize]).collect();
            let calls = written.arguments.iter();
            let said = calls.map(|(name, denied, of)| {
                let of = of.iter().filter_map(named).collect();
                Said { name: name.clone(), denied: *denied, of }
            });
            let said = said.filter(|said| said.of.len() > 1).collect();
            let must = constraint.kind == ConstraintKind::Assert;
            let told = &constraint.requirements;
            let stated = !told.is_empty() && !told.iter().any(|why| why.starts_with("inferred"));
            let regions = regions(&constraint.formula);
            Statement { asks: asks(constraint), must, stated, said, things, regions, written }
        })
        .collect();
    for pin in &program.pins {
        if let (Owner::Region(_), Pinned::Vertices) = (pin.owner, pin.property) {
            out[pin.constraint].written.constants.extend(extents(&pin.values));
        }
    }
    out
}

fn asks(constraint: &Constraint) -> bool {
    matches!(constraint.kind, ConstraintKind::Assert | ConstraintKind::Prefer { .. })
}

/// The regions that a formula reads.
fn regions(formula: &Formula) -> BTreeSet<usize> {
    let mut out = BTreeSet::new();
    let mut add = |id: &RegionId| {
        out.insert(id.0 as usize);
    };
    for node in &formula.nodes {
        match node {
            Node::Region(_, id) | Node::SamePolygon(id, _) => add(id),
            Node::BuiltIn(_, args) => {
                args.iter().for_each(|a| {
                    if let Arg::Region(id) = a {
                        add(id)
                    }
                });
            }
            _ => {}
        }
    }
    out
}

/// Width and depth of an outline: a room drawn by its corners says its size by them.
fn extents(corners: &[Formula]) -> Vec<f64> {
    let mut out = Vec::new();
    for axis in [0, 2] {
        let values: Vec<f64> = corners
            .iter()
            .filter_map(|corner| match corner.root_node() {
                Node::Vector(parts) => number(corner, parts[axis]),
                _ => None,
            })
            .collect();
        if values.len() == corners.len() && !values.is_empty() {
            let reach = |f: fn(f64, f64) -> f64, start| values.iter().copied().fold(start, f);
            out.push(reach(f64::max, f64::NEG_INFINITY) - reach(f64::min, f64::INFINITY));
        }
    }
    out
}

fn number(formula: &Formula, id: NodeId) -> Option<f64> {
    match formula.node(id) {
        Node::Number(value) => Some(*value),
        Node::Neg(inner) => number(formula, *inner).map(|v| -v),
        _ => None,
    }
}

/// Reads what statements call and measure.
struct Reader<'a> {
    /// The program's own predicates.
    predicates: &'a BTreeMap<&'a str, &'a Stmt>,
    /// Those it is in, so that one that calls itself comes to an end.
    inside: Vec<String>,
    /// Range variables, and what they range over.
    ranges: Vec<(String, String)>,
    out: &'a mut Written,
}

/// Whether a part of a formula is claimed, denied, or both.
#[derive(Clone, Copy)]
struct Sense {
    claimed: bool,
    denied: bool,
}

impl Sense {
    const BOTH: Self = Self { claimed: true, denied: true };
    fn contrary(self) -> Self {
        Self { claimed: self.denied, denied: self.claimed }
    }
}

impl Reader<'_> {
    fn statement(&mut self, stmt: &Stmt) {
        let root = match &stmt.kind {
            StmtKind::Assert { formula } | StmtKind::Prefer { formula, .. } => *formula,
            StmtKind::Assign { value, .. } => *value,
            _ => return,
        };
        self.formula(stmt, root, Sense { claimed: true, denied: false });
    }

    fn formula(&mut self, stmt: &Stmt, id: ExprId, sense: Sense) {
        let kind = &stmt.expr(id).kind;
        match kind {
            ExprKind::Number(value, unit) => self.out.constants.push(value * factor(*unit)),
            ExprKind::Not(inner) => return self.formula(stmt, *inner, sense.contrary()),
            ExprKind::Binary(BinaryOp::Implies, _, left, right) => {
                self.formula(stmt, *left, sense.contrary());
                return self.formula(stmt, *right, sense);
            }
            ExprKind::Call(name, args) => {
                self.call(&name.text, sense);
                // What a predicate of the program says of its parameters is said of no thing by name.
                if self.inside.is_empty() && sense.claimed != sense.denied {
                    let of = args.iter().map(|arg| self.name(stmt, *arg)).collect();
                    self.out.arguments.push((name.text.to_string(), sense.denied, of));
                }
            }
            ExprKind::Quantified(_, variable, domain, _) => {
                let over = self.name(stmt, *domain);
                self.ranges.push((variable.text.to_string(), over));
            }
            _ => {}
        }
        // What is compared or counted is neither claimed nor denied.
        let within = match kind {
            ExprKind::Compare(..) | ExprKind::Where(..) => Sense::BOTH,
            ExprKind::Quantified(scenelang_lang::ast::Quantifier::Count, ..) => Sense::BOTH,
            _ => sense,
        };
        kind.for_each_child(|child| self.formula(stmt, child, within));
    }

    /// The name of the array, object or region that an expression is, or is an element of; else nothing.
    fn name(&self, stmt: &Stmt, id: ExprId) -> String {
        match &stmt.expr(id).kind {
            ExprKind::Name(name) => {
                let range = self.ranges.iter().rev().find(|(variable, _)| variable == name.as_str());
                range.map_or_else(|| name.to_string(), |(_, over)| over.clone())
            }
            ExprKind::Index(of, _) | ExprKind::Where(of, _) => self.name(stmt, *of),
            _ => String::new(),
        }
    }

    fn call(&mut self, name: &str, sense: Sense) {
        if sense.claimed {
            self.out.calls.insert(name.to_owned());
        }
        if sense.denied {
            self.out.denials.insert(name.to_owned());
        }
        let Some(stmt) = self.predicates.get(name) else { return };
        if let StmtKind::Predicate { body, .. } = &stmt.kind
            && !self.inside.iter().any(|n| n == name)
        {
            self.inside.push(name.to_owned());
            self.formula(stmt, *body, sense);
            self.inside.pop();
        }
    }
}

/// From a number as written to metres; angles stay what they are.
fn factor(unit: Option<UnitSuffix>) -> f64 {
    match unit {
        Some(UnitSuffix::Cm) => 0.01,
        Some(UnitSuffix::Mm) => 0.001,
        Some(UnitSuffix::Ft) => 0.3048,
        Some(UnitSuffix::In) => 0.0254,
        Some(UnitSuffix::M | UnitSuffix::Deg | UnitSuffix::Rad) | None => 1.0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use scenelang_lang::{Options, compile_text};
    use std::path::Path;

    fn told(text: &str) -> ProgramOutline {
        let compiled = compile_text("a.scene", Path::new("a.scene"), text, Options::default());
        let program = compiled.program.unwrap_or_else(|| panic!("{:?}", compiled.diagnostics));
        ProgramOutline::new(&program, compiled.main, text)
    }

    #[test]
    fn arrays_and_series_are_one_thing() {
        let t = told(
            "object chair[4]; object lamp1; object lamp2; object mirror; object mirror2; object bed3;
             object rug1; rug1.category <- \"rug\"; object rug2; rug2.category <- \"bath mat\";",
        );
        let found: Vec<_> = t.things.iter().map(|t| (t.name.as_str(), t.count)).collect();
        let want = [("chair", 4), ("lamp", 2), ("mirror", 1), ("mirror2", 1), ("bed3", 1), ("rug1", 1), ("rug2", 1)];
        assert_eq!(found, want);
    }

    #[test]
    fn what_statements_mention_call_and_measure() {
        let t = told(
            "region room; room.scale <- vec3(5, 2.6, 4);
             object desk; object chair[2]; object tv; Number aisle; aisle <- 90cm;
             predicate tucked(Object a, Object b) := under(a, b) and gap(a, b) <= 6in;
             assert forall c in chair: tucked(c, desk);
             prefer not between(tv, desk, chair[0]);
             assert facing(desk, tv) implies gap(desk, tv) > aisle;",
        );
        let s: Vec<_> = t.statements.iter().filter(|s| s.asks).collect();
        assert_eq!((s[0].things.len(), s[0].regions.len()), (2, 0));
        assert!(s[0].written.calls.contains("tucked") && s[0].written.calls.contains("under"));
        assert!(s[0].written.constants.iter().any(|c| (c - 0.1524).abs() < 1e-9));
        assert!(s[1].written.denials.contains("between") && !s[1].written.calls.contains("between"));
        assert!(s[2].written.denials.contains("facing") && s[2].written.constants == [0.9]);
        let pin = t.statements.iter().find(|s| !s.asks).unwrap();
        assert_eq!((pin.regions.len(), &pin.written.constants), (1, &vec![5.0, 2.6, 4.0]));
    }

    #[test]
    fn an_outline_says_its_size() {
        let t = told(
            "region r; r.vertices <- polygon(vec3(-2, 0, -1), vec3(3, 0, -1), vec3(3, 0, 1.5), vec3(-2, 0, 1.5));",
        );
        assert!([5.0, 2.5].iter().all(|v| t.statements[0].written.constants.contains(v)), "{t:?}");
    }
}
