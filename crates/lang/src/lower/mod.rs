//! From statements to a [`Program`]: arrays become elements, quantifiers conjunctions, predicates and definitions are
//! put in place. Statements with errors are left out; whoever needs one of them is left out too, without a word.

mod builder;
mod draws;
mod expr;
mod filter;
mod guidelines;
mod pins;
mod words;

use crate::ast::{Allow, ExprId, Stmt, StmtKind};
use crate::db::Unit;
use crate::items::{AssignKey, Assignment, ItemKind, Items, Located, Predicate};
use crate::program::*;
use crate::roles;
use crate::types::Ty;
use builder::Builder;
use guidelines::Guidelines;
use rustc_hash::{FxHashMap, FxHashSet};
use scenelang_base::{Diagnostic, FileId, SourceMap, Span, TextRange, codes};
use smol_str::{SmolStr, format_smolstr};
use std::rc::Rc;
use std::sync::Arc;

/// How many nodes a program may have after expansion.
pub const MAX_NODES: usize = 4_000_000;
/// How many steps its expansion may take.
const MAX_STEPS: u64 = 40_000_000;

/// A value at expansion time: static things, or a node of the formula under construction.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
enum Val {
    /// A number and whether it is a Number, a Degree or a literal.
    Num(NodeId, Ty),
    Vec(NodeId),
    Rot(NodeId),
    Truth(NodeId),
    Text(SmolStr),
    /// A text that a draw chooses.
    TextOf(DrawId, Rc<[SmolStr]>),
    Object(ObjectId),
    Region(RegionId),
    Set(Rc<[ObjectId]>),
    Range(i64, i64),
    /// All rooms.
    Rooms,
    Polygon(Rc<[NodeId]>),
    Side(ObjectSide),
}

/// The statement has no formula: something in it is wrong and has been reported (here or where it is defined).
struct Poison;
type Lowered<T> = Result<T, Poison>;

/// Lowers all good statements. `bad` says which statements (file, offset) have errors of their own.
pub(crate) fn lower<'a>(
    items: &'a Items<'a>,
    units: &[Unit<'a>],
    sources: &'a SourceMap,
    bad: &FxHashSet<(FileId, u32)>,
) -> (Program, Vec<Diagnostic>) {
    let mut l = Lowerer {
        items,
        sources,
        bad,
        program: Program::default(),
        objects: FxHashMap::default(),
        regions: FxHashMap::default(),
        variables: FxHashMap::default(),
        draws: FxHashMap::default(),
        pure: FxHashMap::default(),
        templates: FxHashMap::default(),
        guidelines: Guidelines::of(units),
        values_open: Vec::new(),
        texts: FxHashMap::default(),
        filtered: filter::Filtered::default(),
        steps: 0,
        nodes: 0,
        exhausted: false,
        out: Vec::new(),
        f: Frame::default(),
    };
    l.declare();
    l.texts_and_dimensions();
    for unit in units {
        let (mut asserts, mut prefers) = (0, 0);
        let prefix = if unit.prefix.is_empty() { String::new() } else { format!("{}:", unit.prefix) };
        for place in unit.places() {
            let (keyword, count) = match &place.stmt.kind {
                StmtKind::Assert { .. } => ("assert", &mut asserts),
                StmtKind::Prefer { .. } => ("prefer", &mut prefers),
                _ => ("", &mut 0),
            };
            let key = format!("{prefix}{keyword}[{count}]");
            *count += 1;
            let said = unit.bundled && l.guidelines.stated_anew(place.stmt);
            if !l.exhausted && !said && !bad.contains(&(unit.file, place.offset)) {
                let _ = l.statement(place, key);
            }
        }
    }
    l.finish()
}

struct Lowerer<'a, 'b> {
    items: &'a Items<'a>,
    sources: &'a SourceMap,
    bad: &'b FxHashSet<(FileId, u32)>,
    program: Program,
    objects: FxHashMap<SmolStr, Vec<ObjectId>>,
    regions: FxHashMap<SmolStr, RegionId>,
    variables: FxHashMap<SmolStr, VariableId>,
    draws: FxHashMap<String, DrawId>,
    /// Whether a predicate draws no random number, itself or through others, so that its expansions can be shared.
    pure: FxHashMap<(SmolStr, bool), bool>,
    /// Templates of the messages of predicates, the library's apart.
    templates: FxHashMap<(SmolStr, bool), words::Templates>,
    /// Definitions and properties being put in place, outermost first.
    values_open: Vec<String>,
    /// Texts of objects' properties that were asked for, by the property.
    texts: FxHashMap<(ObjectId, SmolStr), Val>,
    /// Of filters that name nothing but properties of the object.
    filtered: filter::Filtered,
    guidelines: Guidelines,
    steps: u64,
    nodes: usize,
    exhausted: bool,
    out: Vec<Diagnostic>,
    f: Frame<'a>,
}

/// What belongs to the formula under construction.
#[derive(Default)]
struct Frame<'a> {
    b: Builder,
    place: Option<Located<'a>>,
    scope: Vec<(SmolStr, Val)>,
    /// Inside a definition or predicate: the place that uses it, and the statement that place is in.
    user: Option<TextRange>,
    /// The statement whose formula it is.
    root: Option<Located<'a>>,
    /// The object that a `where` is asking about.
    own: Option<ObjectId>,
    draw_key: String,
    draw_count: u32,
    /// Whether the current expression is a conjunct of an assertion, perhaps under `forall`.
    top: bool,
    expanded: FxHashMap<(SmolStr, bool, Vec<Val>), NodeId>,
    /// How to say what comparisons measured.
    wordings: Vec<Wording>,
    defined: FxHashMap<SmolStr, Val>,
    /// Members of `forall`, each with the object that it speaks of.
    subjects: Vec<(NodeId, ObjectId)>,
}

impl<'a> Lowerer<'a, '_> {
    fn declare(&mut self) {
        let items = self.items;
        for name in items.order {
            let Some(item) = items.names.get(name) else { continue };
            let stmt = item.place.stmt;
            let doc = stmt.doc.clone();
            let requirements = requirements(stmt);
            let object = |name: SmolStr, array: Option<(SmolStr, u32)>| Object {
                name,
                array,
                color: String::new(),
                material: String::new(),
                features: String::new(),
                category: String::new(),
                role: String::new(),
                dimensions: None,
                span: item.span,
                doc: doc.clone(),
                requirements: requirements.clone(),
            };
            match item.kind {
                ItemKind::Object => {
                    let id = ObjectId(self.program.objects.len() as u32);
                    self.program.objects.push(object(name.clone(), None));
                    self.objects.insert(name.clone(), vec![id]);
                }
                ItemKind::Array(n) => {
                    let first = self.program.objects.len();
                    if first + n as usize > MAX_NODES {
                        self.exhausted(item.span);
                        return;
                    }
                    for i in 0..n {
                        let element = object(format_smolstr!("{name}[{i}]"), Some((name.clone(), i)));
                        self.program.objects.push(element);
                    }
                    let ids = (first..first + n as usize).map(|i| ObjectId(i as u32)).collect();
                    self.objects.insert(name.clone(), ids);
                }
                ItemKind::Region => {
                    let key = |p: &str| self.key(name, None, p);
                    let (has_vertices, has_scale) = (
                        items.assignments.contains_key(&key("vertices")),
                        items.assignments.contains_key(&key("scale")),
                    );
                    self.regions.insert(name.clone(), RegionId(self.program.regions.len() as u32));
                    self.program.regions.push(Region {
                        name: name.clone(),
                        texts: Vec::new(),
                        has_vertices,
                        has_scale,
                        span: item.span,
                        doc,
                        requirements,
                    });
                }
                ItemKind::Variable(ty) => {
                    if items.assignments.contains_key(&self.key(name, None, "")) {
                        self.program.assigned_variables.push(name.clone());
                        continue;
                    }
                    let kind = match ty {
                        Ty::Number => VariableKind::Number,
                        Ty::Degree => VariableKind::Degree,
                        Ty::Bool => VariableKind::Bool,
                        Ty::Vector3 => VariableKind::Vector,
                        Ty::Rotation => VariableKind::Rotation,
                        _ => continue,
                    };
                    self.variables.insert(name.clone(), VariableId(self.program.variables.len() as u32));
                    self.program.variables.push(Variable { name: name.clone(), kind, span: item.span, used: false });
                }
            }
        }
    }

    /// Text properties and dimensions, which are known without a layout.
    fn texts_and_dimensions(&mut self) {
        for i in 0..self.program.objects.len() {
            let id = ObjectId(i as u32);
            for property in ["color", "material", "features", "category", "role"] {
                let value = self.object_text(id, property).unwrap_or_else(|_| Val::Text(SmolStr::default()));
                let text = self.declared_text(Owner::Object(id), property, &value);
                let object = &mut self.program.objects[i];
                *match property {
                    "color" => &mut object.color,
                    "material" => &mut object.material,
                    "features" => &mut object.features,
                    "role" => &mut object.role,
                    _ => &mut object.category,
                } = text;
            }
        }
        for i in 0..self.program.regions.len() {
            let name = self.program.regions[i].name.clone();
            for p in crate::natives::REGION_PROPERTIES.iter().filter(|p| p.assignable && p.ty.is_text()) {
                let Some(a) = self.items.assignments.get(&self.key(&name, None, p.name)).copied() else { continue };
                if let Ok(value) = self.static_text(a, format!("{name}.{}", p.name)) {
                    let text = self.declared_text(Owner::Region(RegionId(i as u32)), p.name, &value);
                    self.program.regions[i].texts.push((p.name.into(), text));
                }
            }
        }
        for i in 0..self.program.objects.len() {
            let (name, element) = self.object_key(ObjectId(i as u32));
            let Some(a) = self.items.assignments.get(&self.key(&name, element, "dimensions")).copied() else {
                continue;
            };
            let key = format!("{}.dimensions", self.program.objects[i].name);
            self.values_open.push(key.clone());
            let value = self.in_frame(a.place, key, |l| {
                let Val::Vec(v) = l.lower(a.value)? else { return Err(Poison) };
                Ok(l.f.b.extract(v))
            });
            self.values_open.pop();
            self.program.objects[i].dimensions = value.ok();
        }
    }

    fn key(&self, name: &SmolStr, element: Option<u32>, property: &str) -> AssignKey {
        AssignKey { name: name.clone(), element, property: property.into() }
    }

    fn object_key(&self, id: ObjectId) -> (SmolStr, Option<u32>) {
        let object = &self.program.objects[id.0 as usize];
        match &object.array {
            Some((name, i)) => (name.clone(), Some(*i)),
            None => (object.name.clone(), None),
        }
    }

    /// What a program says of a text property before anything is drawn. What a thing is cannot be drawn: sizes, roles and
    /// sets depend on it.
    fn declared_text(&mut self, owner: Owner, property: &str, value: &Val) -> String {
        let (draw, texts) = match value {
            Val::Text(text) => return text.to_string(),
            Val::TextOf(draw, texts) => (*draw, texts),
            _ => return String::new(),
        };
        if matches!(property, "category" | "features" | "role") {
            let span = self.program.draws[draw.0 as usize].span;
            let message = format!("`{property}` must be known before anything is drawn, so `oneOf` cannot choose it");
            let d = Diagnostic::new(codes::E0306, span, message)
                .note("`oneOf` can choose colors, materials, numbers, vectors (such as sizes) and rotations");
            if !self.out.contains(&d) {
                self.out.push(d);
            }
            return String::new();
        }
        let all: Vec<String> = texts.iter().map(SmolStr::to_string).collect();
        let first = all[0].clone();
        self.program.drawn_texts.push(DrawnText { owner, property: property.into(), draw, texts: all });
        first
    }

    /// The text of an object's property: what is assigned, else `""`; of a role, else what the category says.
    fn object_text(&mut self, id: ObjectId, property: &str) -> Lowered<Val> {
        // Quantifiers over pairs of objects ask for the same texts over and over.
        let key = (id, SmolStr::new(property));
        if let Some(text) = self.texts.get(&key) {
            return Ok(text.clone());
        }
        let text = self.find_object_text(id, property)?;
        self.texts.insert(key, text.clone());
        Ok(text)
    }

    fn find_object_text(&mut self, id: ObjectId, property: &str) -> Lowered<Val> {
        let (name, element) = self.object_key(id);
        let Some(a) = self.items.assignments.get(&self.key(&name, element, property)).copied() else {
            return match property {
                "role" => match self.object_text(id, "category")? {
                    Val::Text(category) => Ok(Val::Text(roles::role_of(&category).into())),
                    _ => Err(Poison),
                },
                _ => Ok(Val::Text(SmolStr::default())),
            };
        };
        let key = format!("{}.{property}", self.program.objects[id.0 as usize].name);
        if let Some(at) = self.values_open.iter().position(|k| *k == key) {
            let circle: Vec<String> = self.values_open[at..].iter().chain([&key]).map(|k| format!("`{k}`")).collect();
            self.circle(a, format!("properties are defined in terms of each other: {}", circle.join(" → ")));
            return Err(Poison);
        }
        self.values_open.push(key.clone());
        let text = self.static_text(a, key);
        self.values_open.pop();
        text
    }

    /// Reports a circle once, whichever of its members is met first.
    fn circle(&mut self, a: Assignment<'a>, message: String) {
        if let Some(span) = a.place.span(a.target)
            && !self.out.iter().any(|d| d.code == codes::E0204)
        {
            self.out.push(Diagnostic::new(codes::E0204, span, message));
        }
    }

    fn static_text(&mut self, a: Assignment<'a>, draw_key: String) -> Lowered<Val> {
        let value = self.in_frame(a.place, draw_key, |l| l.lower(a.value))?;
        if matches!(value, Val::Text(_) | Val::TextOf(..)) { Ok(value) } else { Err(Poison) }
    }

    /// Runs `work` on a fresh formula for `place`, unless that statement is bad.
    fn in_frame<T>(
        &mut self,
        place: Located<'a>,
        draw_key: String,
        work: impl FnOnce(&mut Self) -> Lowered<T>,
    ) -> Lowered<T> {
        if let Some(file) = place.file
            && self.bad.contains(&(file, place.offset))
        {
            return Err(Poison);
        }
        let fresh = Frame { place: Some(place), root: Some(place), draw_key, ..Frame::default() };
        let outer = std::mem::replace(&mut self.f, fresh);
        let result = work(self);
        self.nodes += self.f.b.size();
        self.f = outer;
        result
    }

    fn statement(&mut self, place: Located<'a>, draw_key: String) -> Lowered<()> {
        let stmt = place.stmt;
        match &stmt.kind {
            StmtKind::Assert { formula } => self.in_frame(place, draw_key, |l| {
                l.f.top = true;
                let root = l.truth(*formula)?;
                l.constraint(place, ConstraintKind::Assert, "assert", root);
                Ok(())
            }),
            StmtKind::Prefer { formula, weight } => self.in_frame(place, draw_key, |l| {
                let root = l.truth(*formula)?;
                let weight = weight.and_then(|w| crate::check::constant::number(stmt, w)).unwrap_or(1.0);
                let kind = ConstraintKind::Prefer { weight };
                match l.guidelines.name(stmt) {
                    Some(name) => l.instances(place, kind, &name, root),
                    None => l.constraint(place, kind, "prefer", root),
                }
                Ok(())
            }),
            StmtKind::Allow { rule, args, .. } => {
                let sets = self.in_frame(place, draw_key, |l| {
                    args.iter().map(|a| l.set(*a)).collect::<Lowered<Vec<Rc<[ObjectId]>>>>()
                })?;
                let allow = &mut self.program.allow;
                match (rule, sets.as_slice()) {
                    (Allow::Collide, [a, b]) => Arc::make_mut(&mut allow.collide).add(a, b),
                    (Allow::Outside, [a]) => allow.outside.extend(a.iter()),
                    (Allow::Float, [a]) => allow.float.extend(a.iter()),
                    _ => {}
                }
                if let Some(span) = place.span(stmt.range) {
                    allow.stated.push(Allowance {
                        rule: *rule,
                        arguments: sets.iter().map(|set| set.to_vec()).collect(),
                        span,
                        text: folded(self.sources.text(span)),
                        requirements: requirements(stmt),
                    });
                }
                Ok(())
            }
            StmtKind::Assign { .. } => self.assignment(place),
            _ => Ok(()),
        }
    }

    fn constraint(&mut self, place: Located<'a>, kind: ConstraintKind, keyword: &str, root: NodeId) {
        let Some(span) = place.span(place.stmt.range) else { return };
        let written = self.sources.text(span);
        let written = written.strip_prefix(keyword).unwrap_or(written);
        let (mut formula, places) = self.f.b.extract_with_places(root);
        let wordings = words::placed(std::mem::take(&mut self.f.wordings), &places);
        let definitions = self.definitions_used();
        for range in &mut formula.ranges {
            // From the start of the text that belongs to the statement (`@req` and all) to the start of its span.
            let from = place.stmt.range.start;
            *range = TextRange { start: range.start.saturating_sub(from), end: range.end.saturating_sub(from) };
        }
        self.program.constraints.push(Constraint {
            kind,
            formula,
            span,
            text: folded(written),
            requirements: requirements(place.stmt),
            definitions,
            wordings,
            guideline: None,
        });
    }

    /// The assignments that the formula under construction was made with.
    fn definitions_used(&mut self) -> Vec<usize> {
        let mut names: Vec<SmolStr> = self.f.defined.keys().cloned().collect();
        names.sort_unstable();
        let mut used = Vec::new();
        for name in &names {
            let Some(assignment) = self.items.assignments.get(&self.key(name, None, "")) else { continue };
            let Some(span) = assignment.place.span(assignment.place.stmt.range) else { continue };
            let known = self.program.definitions.iter().position(|d| d.span == span);
            used.push(known.unwrap_or_else(|| {
                let text = folded(self.sources.text(span));
                self.program.definitions.push(Definition { name: name.clone(), span, text });
                self.program.definitions.len() - 1
            }));
        }
        used.sort_unstable();
        used
    }

    /// The place to blame for something in the current expression.
    fn blame(&self, range: TextRange) -> Option<Span> {
        self.f.root?.span(self.f.user.unwrap_or(range))
    }

    fn error(&mut self, code: scenelang_base::Code, range: TextRange, message: impl Into<String>) {
        if let Some(span) = self.blame(range) {
            let d = Diagnostic::new(code, span, message);
            if !self.out.contains(&d) {
                self.out.push(d);
            }
        }
    }

    fn exhausted(&mut self, span: Span) {
        if !self.exhausted {
            self.exhausted = true;
            self.out.push(
                Diagnostic::new(codes::E0005, span, "the program becomes too large to check when this is expanded")
                    .note(format!("the limit is {MAX_NODES} parts; quantify over smaller sets, or split the scene")),
            );
        }
    }

    /// The library's or the program's predicate of that name.
    fn predicate(&self, name: &str) -> Option<Predicate<'a>> {
        let library = self.f.place.is_some_and(|p| p.file.is_none());
        self.items.predicate(name, library)
    }

    fn finish(mut self) -> (Program, Vec<Diagnostic>) {
        let p = &mut self.program;
        Arc::make_mut(&mut p.allow.collide).finish();
        for list in [&mut p.allow.outside, &mut p.allow.float] {
            list.sort_unstable();
            list.dedup();
        }
        p.allow.contents.sort_unstable();
        p.allow.contents.dedup();
        let formulas = p.constraints.iter().map(|c| &c.formula).chain(p.allow.mounts.iter().map(|m| &m.formula));
        for node in formulas.flat_map(|f| &f.nodes) {
            if let Node::Variable(id) = node {
                p.variables[id.0 as usize].used = true;
            }
        }
        self.out.extend(pins::cycles(&self.program, self.items));
        (self.program, self.out)
    }

    fn truth(&mut self, id: ExprId) -> Lowered<NodeId> {
        match self.lower(id)? {
            Val::Truth(n) => Ok(n),
            _ => Err(Poison),
        }
    }

    fn set(&mut self, id: ExprId) -> Lowered<Rc<[ObjectId]>> {
        match self.lower(id)? {
            Val::Set(s) => Ok(s),
            Val::Object(o) => Ok(Rc::from([o])),
            _ => Err(Poison),
        }
    }
}

/// A text with its blanks folded.
fn folded(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for word in text.split_whitespace() {
        if !out.is_empty() {
            out.push(' ');
        }
        out.push_str(word);
    }
    out
}

/// The sentences of a statement's `@req`.
fn requirements(stmt: &Stmt) -> Vec<String> {
    stmt.requirements.iter().map(|(sentence, _)| sentence.clone()).collect()
}
