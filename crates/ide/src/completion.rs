//! What could be written at a place. Nothing is proposed in comments and numbers, nothing for a name that is being invented;
//! what fits the type that is expected comes first.

use crate::Snapshot;
use crate::hover;
use crate::names::declared_kind;
use scenelang_assets as assets;
use scenelang_base::TextRange;
use scenelang_lang::ast::StmtKind;
use scenelang_lang::chunk::{Chunk, cut};
use scenelang_lang::db::Cancelled;
use scenelang_lang::hir::Meanings;
use scenelang_lang::items::ItemKind;
use scenelang_lang::library;
use scenelang_lang::natives::{self, BUILT_INS, OBJECT_PROPERTIES, Property, REGION_PROPERTIES, ROOMS, SIDES};
use scenelang_lang::roles;
use scenelang_lang::syntax::{CallSite, Expects, context_at, parse};
use scenelang_lang::token::{Kind, Token, UNITS, lex};
use scenelang_lang::types::Ty;
use smol_str::SmolStr;

/// Paths of programs that could be imported, for whoever asks.
pub type Imports<'a> = &'a dyn Fn() -> Vec<String>;

/// What a proposal is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sort {
    /// A word of the language.
    Keyword,
    /// An object or an array.
    Object,
    Region,
    /// A variable, or a name that a statement binds.
    Variable,
    /// A property, or a component.
    Property,
    Function,
    Predicate,
    Type,
    /// A side, or another word that is a value.
    Constant,
    /// A unit behind a number.
    Unit,
    Color,
    /// Other text.
    Text,
    /// A path.
    File,
}

#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Proposal {
    /// What is shown.
    pub label: String,
    pub sort: Sort,
    /// A little more: a type.
    pub detail: String,
    /// What is inserted, `$1` and `${1:name}` being places to fill in; `None`: the label.
    pub snippet: Option<String>,
    /// Smaller comes first: 0 fits what is expected.
    pub rank: u8,
    /// What [`describe`] is to be asked, if there is more to say.
    pub about: Option<String>,
}

/// Proposals and what of the text they replace.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Proposals {
    /// What is replaced, on one line.
    pub replaces: TextRange,
    /// In the order of their labels within a rank.
    pub list: Vec<Proposal>,
}

/// What could be written at an offset of the main file; `asked`: somebody wants to know, and did not just type.
///
/// # Errors
/// [`Cancelled`]: the text has changed.
pub fn complete(snapshot: &Snapshot, imports: Imports<'_>, offset: u32, asked: bool) -> Result<Proposals, Cancelled> {
    let text = snapshot.text();
    // The statement is enough; half a one that runs into the next is read as such.
    let (start, part) = surroundings(text, offset);
    let here = offset - start;
    let context = context_at(&parse(part), here);
    let mut at = At { snapshot, meanings: snapshot.meanings()?, part, here, list: Vec::new() };
    let mut replaces = context.word.shifted(start);
    let expects = match at.attribute() {
        // Half of `@req` is a word of its own.
        Some(written) => {
            replaces = written.shifted(start);
            Expects::Statement
        }
        None => context.expects,
    };
    match expects {
        Expects::Statement => at.statements(),
        Expects::Property { of } => at.properties(&part[of.bytes()]),
        Expects::OwnProperty => {
            for name in ["category", "color", "features", "material", "role"] {
                at.push(name, Sort::Property, "String", 0);
            }
        }
        Expects::Value => at.values(context.call),
        Expects::Operator => at.operators(),
        Expects::ParameterType => {
            for ty in [
                "Object", "Region", "Objects", "Number", "Degree", "Bool", "Vector3", "Rotation", "Color", "Material",
                "String",
            ] {
                at.push(ty, Sort::Type, "", 0);
            }
        }
        Expects::Text { written } => {
            replaces = written.shifted(start);
            at.texts();
        }
        Expects::ImportPath { written } => {
            replaces = written.shifted(start);
            let quoted = part.get(..written.start as usize).is_some_and(|before| before.ends_with('"'));
            for path in imports() {
                let snippet = (!quoted).then(|| format!("\"{path}\""));
                at.add(Proposal {
                    label: path,
                    sort: Sort::File,
                    detail: String::new(),
                    snippet,
                    rank: 0,
                    about: None,
                });
            }
        }
        Expects::NewName => {}
        Expects::Nothing => {
            if let Some(number) = at.number(asked) {
                replaces = number.shifted(start);
            }
        }
    }
    // A proposal must not reach over a line's end.
    if text.get(replaces.bytes()).is_none_or(|t| t.contains(['\n', '\r'])) {
        replaces = TextRange::empty(offset);
    }
    let mut list = at.list;
    list.sort_by(|a, b| a.rank.cmp(&b.rank).then_with(|| a.label.cmp(&b.label)));
    list.dedup_by(|a, b| a.label == b.label && a.sort == b.sort);
    Ok(Proposals { replaces, list })
}

/// What is said of a proposal when somebody looks at it.
///
/// # Errors
/// [`Cancelled`]: the text has changed.
pub fn describe(about: &str) -> Option<String> {
    let (kind, name) = about.split_once(' ')?;
    match kind {
        "library" => hover::library_predicate(name),
        "builtin" if natives::is_built_in(name) => Some(hover::built_ins(name)),
        "property" => {
            OBJECT_PROPERTIES.iter().chain(REGION_PROPERTIES).find(|p| p.name == name).map(|p| p.doc.to_owned())
        }
        _ => None,
    }
}

/// The statements around an offset: from the one before it to the one behind it; without the one before if that is over.
fn surroundings(text: &str, offset: u32) -> (u32, &str) {
    let cut = cut(text);
    let chunks = &cut.chunks;
    let at = chunks.partition_point(|c| c.range.end < offset);
    let kind = |chunk: &Chunk| cut.tokens.get(chunk.tokens.end.checked_sub(1)?).map(|last| last.kind);
    // Blanks behind what has no `;` yet belong to it, but for a string that ended with its line.
    let is_over = |chunk: &Chunk| matches!(kind(chunk), Some(Kind::Semi | Kind::OpenStr) | None);
    let before = (0..at).rev().find_map(|before| chunks.get(before).filter(|c| before + 1 < at || is_over(c)));
    let start = before.map_or(0, |c| c.range.end.min(offset));
    let end = chunks.get(at).map_or(text.len() as u32, |c| c.range.end.max(offset));
    (start, text.get(start as usize..end as usize).unwrap_or_default())
}

struct At<'a> {
    snapshot: &'a Snapshot,
    meanings: Meanings<'a>,
    /// The statement, and what is between it and the one before.
    part: &'a str,
    here: u32,
    list: Vec<Proposal>,
}

impl At<'_> {
    fn add(&mut self, proposal: Proposal) {
        self.list.push(proposal);
    }

    fn push(&mut self, label: &str, sort: Sort, detail: &str, rank: u8) {
        let about = (sort == Sort::Property).then(|| format!("property {label}"));
        self.add(Proposal { label: label.into(), sort, detail: detail.into(), snippet: None, rank, about });
    }

    fn snippet(&mut self, label: &str, sort: Sort, detail: &str, snippet: &str, rank: u8) {
        let snippet = Some(snippet.to_owned());
        self.add(Proposal { label: label.into(), sort, detail: detail.into(), snippet, rank, about: None });
    }

    /// All that is declared in the program, with what it is.
    fn declared(&self) -> Vec<(SmolStr, ItemKind)> {
        let mut out = Vec::new();
        for (id, _) in self.snapshot.sources().iter() {
            let Ok(meanings) = self.snapshot.analysis().meanings(id) else { continue };
            out.extend(meanings.statements.iter().filter_map(|(place, _)| declared_kind(place)));
        }
        out.retain(|(name, _)| !name.is_empty());
        out
    }

    /// Tokens of the statement up to the offset, without blanks and comments.
    fn before(&self) -> Vec<Token> {
        let tokens = lex(self.part);
        tokens.into_iter().filter(|t| !t.kind.is_trivia() && t.range.start < self.here).collect()
    }

    fn slice(&self, token: &Token) -> &str {
        &self.part[token.range.bytes()]
    }

    /// Names that the statement binds before the offset: parameters, and variables of quantifiers.
    fn locals(&self) -> Vec<(String, Ty)> {
        let tokens = self.before();
        let mut out: Vec<(String, Ty)> = Vec::new();
        for pair in tokens.windows(2) {
            let [a, b] = pair else { continue };
            if b.kind != Kind::Ident {
                continue;
            }
            let ty = match (a.kind, self.slice(a)) {
                (_, "forall" | "exists") | (Kind::LParen, _) if self.is_domain(&tokens, b) => Ty::Object,
                (_, "Object") => Ty::Object,
                (_, "Region") => Ty::Region,
                (_, "Objects") => Ty::Objects,
                (_, "String") => Ty::String,
                (Kind::NumberType, _) => Ty::Number,
                (Kind::Degree, _) => Ty::Degree,
                (Kind::Bool, _) => Ty::Bool,
                (Kind::Vector3, _) => Ty::Vector3,
                (Kind::Rotation, _) => Ty::Rotation,
                _ => continue,
            };
            // What declares a thing of the program binds nothing.
            let statement_declares = std::ptr::eq(a, &tokens[0]);
            if !statement_declares && b.range.end < self.here {
                out.push((self.slice(b).to_owned(), ty));
            }
        }
        out
    }

    /// Whether `in` follows a name.
    fn is_domain(&self, tokens: &[Token], name: &Token) -> bool {
        let next = tokens.iter().find(|t| t.range.start >= name.range.end);
        next.is_some_and(|t| self.slice(t) == "in")
    }

    /// The `@…` that the offset is at the end of or in, where a statement could begin with it.
    fn attribute(&self) -> Option<TextRange> {
        let tokens = lex(self.part);
        let is = |t: &Token| {
            matches!(t.kind, Kind::Req | Kind::BadAttribute) && t.range.start < self.here && self.here <= t.range.end
        };
        let index = tokens.iter().position(is)?;
        let before = tokens[..index].iter().rev().find(|t| !t.kind.is_trivia());
        // Behind another requirement, too: that ends in a bracket.
        let begins = before.is_none_or(|t| matches!(t.kind, Kind::Semi | Kind::RParen));
        begins.then(|| tokens[index].range)
    }

    fn statements(&mut self) {
        for (word, snippet) in [
            ("object", "object ${1:name};"),
            ("region", "region ${1:name};"),
            ("assert", "assert $1;"),
            ("prefer", "prefer $1;"),
            ("predicate", "predicate ${1:name}(${2:Object a}) := $0;"),
            ("import", "import \"$1\";"),
            ("allowCollide", "allowCollide(${1:a}, ${2:b});"),
            ("allowOutside", "allowOutside(${1:a});"),
            ("allowFloat", "allowFloat(${1:a});"),
            ("@req", "@req(\"$1\")"),
        ] {
            self.snippet(word, Sort::Keyword, "", snippet, 1);
        }
        for ty in ["Number", "Degree", "Bool", "Vector3", "Rotation", "Color", "Material"] {
            self.snippet(ty, Sort::Type, "", &format!("{ty} ${{1:name}};"), 2);
        }
        self.names(None, 3);
    }

    /// Names of the program; those of a type that is wanted first.
    fn names(&mut self, wanted: Option<Ty>, rank: u8) {
        for (name, kind) in self.declared() {
            let (sort, detail) = match kind {
                ItemKind::Object => (Sort::Object, "object".to_owned()),
                ItemKind::Array(n) => (Sort::Object, format!("object[{n}]")),
                ItemKind::Region => (Sort::Region, "region".to_owned()),
                ItemKind::Variable(ty) => (Sort::Variable, ty.name().to_owned()),
            };
            let fits = wanted.is_some_and(|ty| kind.ty().fits(ty));
            self.push(&name, sort, &detail, if fits { 0 } else { rank });
        }
    }

    fn properties(&mut self, of: &str) {
        let ty = self.type_of(of);
        let table: &[Property] = match ty {
            Some(Ty::Object) => OBJECT_PROPERTIES,
            Some(Ty::Region) => REGION_PROPERTIES,
            Some(Ty::Vector3 | Ty::Rotation) => {
                let detail = if ty == Some(Ty::Vector3) { "Number" } else { "Degree" };
                for axis in ["x", "y", "z"] {
                    self.push(axis, Sort::Property, detail, 0);
                }
                return;
            }
            _ => return,
        };
        // To the left of an arrow only what can be assigned makes sense.
        let assigned = self
            .before()
            .iter()
            .take_while(|t| t.range.end < self.here)
            .all(|t| matches!(t.kind, Kind::Ident | Kind::Dot | Kind::LBracket | Kind::RBracket | Kind::Number));
        for property in table {
            let rank = u8::from(assigned && !property.assignable);
            self.push(property.name, Sort::Property, property.ty.name(), rank);
        }
    }

    /// The type of what stands before a dot, as far as its text says it.
    fn type_of(&self, of: &str) -> Option<Ty> {
        let of = of.trim();
        if let Some((owner, last)) = of.rsplit_once('.') {
            return match self.type_of(owner)? {
                owner @ (Ty::Object | Ty::Region) => natives::property(owner, last.trim()).map(|p| p.ty),
                _ => None,
            };
        }
        let name = of.split('[').next().unwrap_or(of).trim();
        if let Some((_, ty)) = self.locals().into_iter().rev().find(|(local, _)| local == name) {
            return Some(if ty == Ty::Objects { Ty::Object } else { ty });
        }
        if let Some((_, kind)) = self.declared().into_iter().find(|(n, _)| n == name) {
            return match kind {
                // Of a bare array nothing can be read, but what is assigned to it is assigned to all its elements.
                ItemKind::Array(_) => Some(Ty::Object),
                kind => Some(kind.ty()),
            };
        }
        // `(a.pos - b.pos).`, `vec3(…).`
        let vector = of.starts_with("vec3") || of.contains(".pos") || of.contains(".center") || of.contains(".front");
        vector.then_some(Ty::Vector3)
    }

    fn values(&mut self, call: Option<CallSite>) {
        let wanted = call.and_then(|call| self.wanted(&call));
        if wanted == Some(Ty::Side) {
            for (word, _) in SIDES {
                self.push(word, Sort::Constant, "side", 0);
            }
            return;
        }
        for (name, ty) in self.locals() {
            let fits = wanted.is_none_or(|w| ty.fits(w));
            self.push(&name, Sort::Variable, ty.name(), u8::from(!fits));
        }
        self.names(wanted, 2);
        self.push("objects", Sort::Constant, "Objects", if wanted == Some(Ty::Objects) { 0 } else { 3 });
        if wanted.is_none() && self.after_in() {
            self.push(ROOMS, Sort::Constant, "Regions", 3);
        }
        if wanted.is_some_and(|ty| matches!(ty, Ty::Object | Ty::Region | Ty::Objects)) {
            return;
        }
        for word in ["true", "false"] {
            self.push(word, Sort::Keyword, "Bool", 4);
        }
        self.push("not", Sort::Keyword, "", 4);
        self.snippet("forall", Sort::Keyword, "", "forall ${1:c} in ${2:objects}: $0", 4);
        self.snippet("exists", Sort::Keyword, "", "exists ${1:c} in ${2:objects}: $0", 4);
        self.snippet("count", Sort::Keyword, "", "count(${1:c} in ${2:objects}: $3)", 4);
        let mut before = "";
        for signature in BUILT_INS.iter().filter(|s| s.name != std::mem::replace(&mut before, s.name)) {
            let sort = if signature.result == Ty::Bool { Sort::Predicate } else { Sort::Function };
            let names: Vec<&str> = signature.names.split(", ").filter(|n| *n != "…").collect();
            let fits = wanted.is_some_and(|w| signature.result.fits(w));
            self.callable(signature.name, sort, &names, signature.result.name(), "builtin", if fits { 1 } else { 3 });
        }
        for name in library::names() {
            let params = library::predicates().get(name).map(|p| p.params).unwrap_or_default();
            let names: Vec<&str> = params.iter().map(|p| p.name.text.as_str()).collect();
            self.callable(name, Sort::Predicate, &names, "std", "library", 3);
        }
        let mut own: Vec<SmolStr> = self.meanings.defined.keys().cloned().collect();
        own.sort_unstable();
        for name in own {
            let names = self.parameters(&name);
            let names: Vec<&str> = names.iter().map(String::as_str).collect();
            self.callable(&name, Sort::Predicate, &names, "", "own", 2);
        }
    }

    /// Names of the parameters of a predicate of the main file.
    fn parameters(&self, predicate: &str) -> Vec<String> {
        let found = self.meanings.statements.iter().find_map(|(place, _)| match &place.stmt.kind {
            StmtKind::Predicate { name, params, .. } if name.text == predicate => Some(params),
            _ => None,
        });
        found.into_iter().flatten().map(|p| p.name.text.to_string()).collect()
    }

    fn callable(&mut self, name: &str, sort: Sort, params: &[&str], detail: &str, about: &str, rank: u8) {
        let places: Vec<String> = params.iter().enumerate().map(|(i, p)| format!("${{{}:{p}}}", i + 1)).collect();
        let snippet = Some(format!("{name}({})", places.join(", ")));
        let about = Some(format!("{about} {name}"));
        self.add(Proposal { label: name.to_owned(), sort, detail: detail.to_owned(), snippet, rank, about });
    }

    /// The type of the argument that is being written.
    fn wanted(&self, call: &CallSite) -> Option<Ty> {
        let callee = self.part.get(call.callee.bytes())?;
        match callee {
            "allowCollide" | "allowOutside" | "allowFloat" => return Some(Ty::Objects),
            _ if natives::is_built_in(callee) => {
                let mut types = natives::overloads(callee).map(|s| s.param(call.argument));
                let first = types.next()?;
                // Where overloads differ, either will do.
                return types.all(|ty| ty == first).then_some(first);
            }
            _ => {}
        }
        let own = self.meanings.statements.iter().find_map(|(place, _)| match &place.stmt.kind {
            StmtKind::Predicate { name, params, .. } if name.text == callee => Some(params.as_slice()),
            _ => None,
        });
        let params = own.or_else(|| library::predicates().get(callee).map(|p| p.params))?;
        params.get(call.argument).map(|p| Ty::of(p.ty))
    }

    fn operators(&mut self) {
        let tokens = self.before();
        let word = |t: &Token| self.part[t.range.bytes()].to_owned();
        let last: Vec<String> = tokens.iter().rev().take(3).map(word).collect();
        let binds = |at: usize| last.get(at).is_some_and(|w| w == "forall" || w == "exists" || w == "(");
        let domain = tokens.iter().rev().map(word).take_while(|w| w != ":").any(|w| w == "in");
        if binds(1) || binds(2) {
            self.push("in", Sort::Keyword, "", 0);
        }
        if domain {
            self.push("where", Sort::Keyword, "", 0);
        }
        for op in ["and", "or", "implies"] {
            self.push(op, Sort::Keyword, "", 1);
        }
        if tokens.first().is_some_and(|t| self.slice(t) == "prefer") {
            self.push("weight", Sort::Keyword, "", 1);
        }
    }

    /// Whether the domain of a quantifier is wanted.
    fn after_in(&self) -> bool {
        self.before().last().is_some_and(|token| self.slice(token) == "in")
    }

    /// Texts of the property that the string is given to or compared with.
    fn texts(&mut self) {
        let tokens = self.before();
        let words =
            ["category", "color", "floorColor", "wallColor", "material", "floorMaterial", "wallMaterial", "role"];
        let property = tokens.iter().rev().map(|t| self.slice(t).to_owned()).find(|w| words.contains(&w.as_str()));
        let colour = self.is_color_variable(&tokens);
        match property.as_deref() {
            Some("category") => self.words(&assets::categories().collect::<Vec<_>>(), Sort::Text),
            Some("role") => self.words(&roles::all().collect::<Vec<_>>(), Sort::Text),
            Some(p) if p.ends_with("aterial") => self.words(&assets::material_names().collect::<Vec<_>>(), Sort::Text),
            Some(_) => self.words(&assets::color_names().collect::<Vec<_>>(), Sort::Color),
            None if colour => self.words(&assets::color_names().collect::<Vec<_>>(), Sort::Color),
            None => {}
        }
    }

    /// Whether a variable of type Color is being assigned.
    fn is_color_variable(&self, tokens: &[Token]) -> bool {
        let [name, arrow, ..] = tokens else { return false };
        let declared = self.declared();
        let kind = declared.iter().find(|(n, _)| n == self.slice(name)).map(|(_, kind)| *kind);
        matches!(arrow.kind, Kind::Arrow | Kind::ArrowSign) && kind == Some(ItemKind::Variable(Ty::Color))
    }

    fn words(&mut self, words: &[&str], sort: Sort) {
        for word in words {
            self.push(word, sort, "", 0);
        }
    }

    /// Units behind the number at the offset: where one has been begun, or somebody asks.
    fn number(&mut self, asked: bool) -> Option<TextRange> {
        let own = |t: &Token| matches!(t.kind, Kind::Number | Kind::BadNumber) && t.range.end == self.here;
        let number = lex(self.part).into_iter().find(own)?;
        let text = self.slice(&number).to_owned();
        let digits = text.trim_end_matches(char::is_alphabetic);
        let begun = &text[digits.len()..];
        if begun.is_empty() && !asked {
            return None;
        }
        for unit in UNITS.iter().filter(|unit| unit.starts_with(begun)) {
            let detail = match *unit {
                "m" => "metres",
                "cm" => "centimetres",
                "mm" => "millimetres",
                "ft" => "feet",
                "in" => "inches",
                "deg" => "degrees",
                _ => "radians",
            };
            self.push(&format!("{digits}{unit}"), Sort::Unit, detail, 0);
        }
        Some(number.range)
    }
}
