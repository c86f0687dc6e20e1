//! Why statements contradict each other, in a sentence with numbers: how much of what one of them asks for is possible.
//!
//! What is asked for is loosened until the others allow it, as far as the prover sees: so "at most 4.7 m" is proved like
//! the contradiction itself.

use super::loosened::Loosened;
use super::minimal::Prover;
use super::model::{Choice, Rules};
use super::packing::short;
use super::relations::{circle, exclusive};
use super::{Contradiction, WORK};
use scenelang_base::TextRange;
use scenelang_lang::program::{
    Arg, Axis, BuiltIn, Comparison, ConstraintKind, Formula, Function, Node, NodeId, ObjectId, ObjectProperty,
    ObjectSide, Owner, Pin, Pinned, Program, RegionId, Unit, Wording,
};
use scenelang_lang::wording::{Named, Shown, TemplatePiece, Term};

/// The work that one trial, all trials for one contradiction, and all of its words may take. It is the same however much the
/// proofs may take, so that all commands say the same.
const TRIAL: u64 = WORK / 12;
const TRIALS: u64 = WORK / 5;
const WORDS: u64 = WORK / 3;
/// So many contradictions are put into words.
const MOST_WORDED: usize = 3;
/// A statement with more parts says too much for a sentence.
const MOST_LEAVES: usize = 40;
/// So many things that could be loosened are tried.
const MOST_TRIED: usize = 10;
/// What is missed by less than this (metres, degrees) is not worth a number.
const LEAST: [f64; 2] = [0.004, 0.4];

/// Something that can be loosened.
#[derive(Clone, Copy)]
enum Candidate {
    /// A comparison of a measure with a number.
    Measure { statement: usize, node: NodeId },
    /// A comparison for which a predicate has a sentence; its left side, where the other is at least 0.
    Worded { statement: usize, node: NodeId, side: bool },
    /// The depth of a space, or the width of a path.
    Width { statement: usize, node: NodeId, number: NodeId },
    /// An extent of a region.
    Size { region: RegionId, axis: usize, extent: f64 },
}

impl Prover<'_> {
    /// Finds the reasons of contradictions, and the parts of their statements that matter. That is no part of the work that
    /// proofs may take.
    pub(super) fn words(&mut self, found: &mut [Contradiction]) {
        let (spent, short) = (self.spent, self.short);
        for found in found.iter_mut().take(MOST_WORDED) {
            self.spent = self.options.work.saturating_sub(WORDS);
            self.put_in_words(found);
        }
        // Whether a number is found says nothing of whether contradictions are.
        (self.spent, self.short) = (spent, short);
    }

    fn put_in_words(&mut self, found: &mut Contradiction) {
        self.narrow_to_parts(found);
        if found.reason.is_some() || found.statements.is_empty() {
            return;
        }
        found.reason = too_large(self, found)
            .or_else(|| circle(self.program, found))
            .or_else(|| self.measured(found))
            .or_else(|| exclusive(self.program, found));
    }

    /// The work that one trial may take.
    pub(super) fn share(&self) -> u64 {
        TRIAL.min(self.left())
    }

    fn measured(&mut self, found: &Contradiction) -> Option<String> {
        let end = self.spent + TRIALS;
        let usual = if found.as_usual { None } else { self.usual.take() };
        // The fewer rules there are, the less there is to look through.
        let rules = std::mem::replace(&mut self.rules, rules_of(found));
        let mut said = None;
        for candidate in self.candidates(found).into_iter().take(MOST_TRIED) {
            said = self.sentence(&found.statements, candidate, end);
            if said.is_some() || self.spent > end {
                break;
            }
        }
        self.usual = self.usual.or(usual);
        self.rules = rules;
        said
    }

    /// What could be loosened, the most telling first.
    fn candidates(&self, found: &Contradiction) -> Vec<Candidate> {
        let program = self.program;
        let mut ranked: Vec<(u8, Candidate)> = Vec::new();
        let is_preference = |s: &usize| matches!(program.constraints[*s].kind, ConstraintKind::Prefer { .. });
        // What was said last first, and what is only preferred before it.
        let mut statements: Vec<usize> = found.statements.iter().rev().copied().collect();
        statements.sort_by_key(|s| !is_preference(s));
        for statement in statements {
            let constraint = &program.constraints[statement];
            if constraint.kind == ConstraintKind::Pin {
                continue;
            }
            let formula = &constraint.formula;
            let leaves = leaves(formula, found.parts.iter().find(|(s, _)| *s == statement).map(|(_, p)| &p[..]));
            if leaves.len() > MOST_LEAVES {
                continue;
            }
            for node in leaves {
                match formula.node(node) {
                    Node::Compare(op, _, a, b) if !matches!(op, Comparison::Eq | Comparison::Ne) => {
                        let wording = constraint.wordings.iter().find(|w| w.node == node);
                        let number = matches!(formula.node(*b), Node::Number(_));
                        let signed = is_at_least_zero(formula, *b) && matches!(op, Comparison::Ge | Comparison::Gt);
                        match wording {
                            None if number && noun(program, formula, *a).is_some() => {
                                let lower = matches!(op, Comparison::Ge | Comparison::Gt) || is_preference(&statement);
                                ranked.push((u8::from(!lower), Candidate::Measure { statement, node }));
                            }
                            Some(w) if number && says(w) => {
                                ranked.push((4, Candidate::Worded { statement, node, side: false }));
                            }
                            Some(w) if signed && says(w) => {
                                ranked.push((5, Candidate::Worded { statement, node, side: true }));
                            }
                            _ => {}
                        }
                    }
                    Node::BuiltIn(BuiltIn::Clear | BuiltIn::Reachable, args) => {
                        let number = |arg: &Arg| match arg {
                            Arg::Value(id) if matches!(formula.node(*id), Node::Number(_)) => Some(*id),
                            _ => None,
                        };
                        if let Some(number) = args.iter().find_map(number) {
                            ranked.push((0, Candidate::Width { statement, node, number }));
                        }
                    }
                    _ => {}
                }
            }
        }
        let of_region = |p: &&Pin| {
            p.property == Pinned::Scale
                && matches!(p.owner, Owner::Region(_))
                && found.statements.contains(&p.constraint)
        };
        let regions = program.pins.iter().filter(of_region).count();
        // Where things are in each other's way, it is the room that lacks.
        let side = if found.rules.iter().any(|rule| rule.starts_with("P-COLLIDE")) { 3 } else { 6 };
        for pin in program.pins.iter().filter(of_region) {
            let Owner::Region(region) = pin.owner else { continue };
            // Of two rooms, neither is the one that is too small.
            if regions > 1 {
                continue;
            }
            let Some([x, y, z]) = self.size_of(pin.constraint).filter(|_| found.statements.contains(&pin.constraint))
            else {
                continue;
            };
            ranked.extend(
                [(2, 1, y), (side, 0, x), (side, 2, z)]
                    .map(|(rank, axis, extent)| (rank, Candidate::Size { region, axis, extent })),
            );
        }
        ranked.sort_by_key(|(rank, _)| *rank);
        ranked.into_iter().map(|(_, candidate)| candidate).collect()
    }

    /// The greatest amount by which something may be loosened so that it is still refuted.
    fn shortfall(
        &mut self,
        statements: &[usize],
        unit: Unit,
        most: f64,
        end: u64,
        loosen: &dyn Fn(f64) -> Loosened,
    ) -> Option<f64> {
        let least = LEAST[usize::from(unit == Unit::Degree)];
        let refuted = |own: &mut Self, by: f64| {
            own.spent < end && {
                let choice = Choice { loosened: Some(loosen(by)), ..own.whole(statements) };
                let model = own.model(choice, false);
                let most = own.share();
                own.search(&model, &mut model.problem(), &|_| false, most, false).is_some()
            }
        };
        // What does not matter however much it is loosened is not why; nor is what the least makes good.
        if refuted(self, most) || !refuted(self, least) {
            return None;
        }
        let (mut lo, mut hi) = (least, 4.0 * least);
        while hi < most && refuted(self, hi) {
            (lo, hi) = (hi, 2.5 * hi);
        }
        hi = hi.min(most);
        while hi - lo > least {
            let mid = (lo + hi) / 2.0;
            if refuted(self, mid) { lo = mid } else { hi = mid }
        }
        Some(lo)
    }

    fn sentence(&mut self, statements: &[usize], candidate: Candidate, end: u64) -> Option<String> {
        let program = self.program;
        match candidate {
            Candidate::Measure { statement, node } => {
                let formula = &program.constraints[statement].formula;
                let Node::Compare(op, unit, a, b) = formula.node(node) else { return None };
                let Node::Number(limit) = *formula.node(*b) else { return None };
                let most = if *unit == Unit::Degree { 360.0 } else { 1000.0 };
                let by =
                    self.shortfall(statements, *unit, most, end, &|by| Loosened::Missed { statement, node, by })?;
                let upper = matches!(op, Comparison::Le | Comparison::Lt);
                let bound = if upper { limit + by } else { limit - by };
                let noun = noun(program, formula, *a)?;
                let [bound, limit] = [bound, limit].map(|n| with_unit(n, *unit));
                Some(if upper {
                    format!("{} is at least {bound}, but must be at most {limit}", noun)
                } else {
                    format!("{} is at most {bound}, but must be at least {limit}", noun)
                })
            }
            Candidate::Worded { statement, node, side } => {
                let constraint = &program.constraints[statement];
                let Node::Compare(op, unit, _, b) = constraint.formula.node(node) else { return None };
                let limit = if let Node::Number(n) = constraint.formula.node(*b) { *n } else { 0.0 };
                let upper = matches!(op, Comparison::Le | Comparison::Lt);
                let most = if *unit == Unit::Degree { 360.0 } else { 1000.0 };
                let loosen = |by: f64| match side {
                    true => Loosened::Left { statement, node, bound: limit - by, upper: false },
                    false => Loosened::Missed { statement, node, by },
                };
                let by = self.shortfall(statements, *unit, most, end, &loosen)?;
                let wording = constraint.wordings.iter().find(|w| w.node == node)?;
                measured_words(program, wording, *unit, [if upper { limit + by } else { limit - by }, limit], upper)
            }
            Candidate::Width { statement, node, number } => {
                let formula = &program.constraints[statement].formula;
                let (Node::Number(width), Node::BuiltIn(_, args)) = (formula.node(number), formula.node(node)) else {
                    return None;
                };
                let loosen = |by: f64| Loosened::Number { statement, node: number, to: (width - by).max(1e-3) };
                let by = self.shortfall(statements, Unit::Metre, *width, end, &loosen);
                let objects: Vec<&str> = args
                    .iter()
                    .filter_map(|a| if let Arg::Object(id) = a { Some(name(program, *id)) } else { None })
                    .collect();
                let bound = short(width - by?);
                Some(
                    match (
                        objects.as_slice(),
                        args.iter().find_map(|a| if let Arg::Side(s) = a { Some(*s) } else { None }),
                    ) {
                        ([a, b], _) => format!(
                            "a path from `{a}` to `{b}` is at most {bound} m wide, but must be {} m wide",
                            short(*width)
                        ),
                        ([a], Some(side)) => {
                            format!(
                                "there can be at most {bound} m of free space {} `{a}`, but {} m are required",
                                beside(side),
                                short(*width)
                            )
                        }
                        _ => return None,
                    },
                )
            }
            Candidate::Size { region, axis, extent } => {
                let loosen = |by: f64| Loosened::Size { region, axis, to: extent + by };
                let by = self.shortfall(statements, Unit::Metre, 1000.0, end, &loosen)?;
                let what = ["wide (x)", "high", "deep (z)"][axis];
                let name = &program.regions[region.0 as usize].name;
                Some(format!(
                    "this needs a region at least {} m {what}, but `{name}` is {} m {what}",
                    short(extent + by),
                    short(extent)
                ))
            }
        }
    }
}

/// That one thing is too large for its region.
fn too_large(prover: &Prover<'_>, found: &Contradiction) -> Option<String> {
    let program = prover.program;
    let [a, b] = found.statements[..] else { return None };
    let sized = |statement: usize| {
        let mut pins = program.pins.iter().filter(|p| p.constraint == statement && p.property == Pinned::Scale);
        pins.next().map(|pin| (pin.owner, statement))
    };
    let (object, region) = match (sized(a)?, sized(b)?) {
        ((Owner::Object(o), s), (Owner::Region(r), t)) | ((Owner::Region(r), t), (Owner::Object(o), s)) => {
            ((o, s), (r, t))
        }
        _ => return None,
    };
    let size = |statement: usize| prover.size_of(statement).map(|s| s.map(short).join(" × "));
    Some(format!(
        "`{}` ({} m) does not fit into `{}` ({} m)",
        name(program, object.0),
        size(object.1)?,
        program.regions[region.0.0 as usize].name,
        size(region.1)?
    ))
}

/// The rules that a contradiction rests on.
fn rules_of(found: &Contradiction) -> Rules {
    match found.rules.as_slice() {
        [] => Rules::None,
        rules if rules.iter().all(|rule| rule.starts_with("P-BOUNDS")) => Rules::Bounds,
        _ => Rules::All,
    }
}

/// The comparisons and built-ins that must all hold, in the parts that matter.
fn leaves(formula: &Formula, parts: Option<&[TextRange]>) -> Vec<NodeId> {
    let (mut open, mut found) = (vec![formula.root], Vec::new());
    let matters = |id: NodeId| {
        let range = formula.ranges[id.0 as usize];
        parts.is_none_or(|parts| parts.iter().any(|p| p.start <= range.start && range.end <= p.end))
    };
    while let Some(id) = open.pop() {
        match formula.node(id) {
            Node::And(members) => open.extend(members.iter().rev()),
            _ if matters(id) => found.push(id),
            _ => {}
        }
    }
    found
}

fn name(program: &Program, id: ObjectId) -> &str {
    &program.objects[id.0 as usize].name
}

fn with_unit(n: f64, unit: Unit) -> String {
    match unit {
        Unit::Metre if n.abs() < 0.01 => format!("{} m", (n * 1e3).round() / 1e3),
        Unit::Metre => format!("{} m", short(n)),
        Unit::Degree => format!("{}°", (n * 10.0).round() / 10.0),
    }
}

/// Where a free space is.
fn beside(side: ObjectSide) -> &'static str {
    match side {
        ObjectSide::Front => "in front of",
        ObjectSide::Behind => "behind",
        ObjectSide::Left => "on the left of",
        ObjectSide::Right => "on the right of",
        ObjectSide::Above => "above",
    }
}

/// What a formula measures, if people have a word for it.
fn noun(program: &Program, formula: &Formula, id: NodeId) -> Option<String> {
    let object = |id: NodeId, wanted: &[ObjectProperty]| match formula.node(id) {
        Node::Object(property, object) if wanted.contains(property) => Some(name(program, *object)),
        _ => None,
    };
    Some(match formula.node(id) {
        Node::BuiltIn(BuiltIn::Gap, args) => match args.as_ref() {
            [Arg::Object(a), Arg::Object(b)] => {
                format!("the gap between `{}` and `{}`", name(program, *a), name(program, *b))
            }
            [Arg::Object(a), Arg::Region(r)] => {
                let room = &program.regions[r.0 as usize].name;
                format!("the distance of `{}` from the walls of `{room}`", name(program, *a))
            }
            _ => return None,
        },
        Node::Call(Function::Distance, points) => {
            let places = [ObjectProperty::Center, ObjectProperty::Pos];
            let [a, b] = [object(points[0], &places)?, object(points[1], &places)?];
            format!("the distance between `{a}` and `{b}`")
        }
        Node::Call(Function::Angle, axes) => {
            let front = [ObjectProperty::Front];
            let [a, b] = [object(axes[0], &front)?, object(axes[1], &front)?];
            format!("the angle between the fronts of `{a}` and `{b}`")
        }
        Node::Component(axis, of) => {
            let (id, property) = match formula.node(*of) {
                Node::Object(ObjectProperty::Pos, id) => (id, "pos"),
                Node::Object(ObjectProperty::Center, id) => (id, "center"),
                Node::Object(ObjectProperty::Rot, id) => (id, "rot"),
                _ => return None,
            };
            let axis = match axis {
                Axis::X => 'x',
                Axis::Y => 'y',
                Axis::Z => 'z',
            };
            format!("`{}.{property}.{axis}`", name(program, *id))
        }
        Node::Object(ObjectProperty::Top, id) => format!("the top of `{}`", name(program, *id)),
        Node::Object(ObjectProperty::Bottom, id) => format!("the base of `{}`", name(program, *id)),
        _ => return None,
    })
}

/// Whether a side of a comparison is never less than 0.
fn is_at_least_zero(formula: &Formula, id: NodeId) -> bool {
    match formula.node(id) {
        Node::Call(Function::Max, args) => args.iter().any(|a| is_at_least_zero(formula, *a)),
        Node::Call(Function::Abs | Function::Length | Function::Distance, _) => true,
        Node::Number(n) => *n >= 0.0,
        _ => false,
    }
}

/// Whether the sentence of a predicate can be said of a bound.
fn says(wording: &Wording) -> bool {
    wording.template.pieces.iter().all(|piece| match piece {
        TemplatePiece::Value { terms, shown } => {
            !matches!(shown, Shown::Turn(_)) && terms.iter().all(|(_, term)| number(wording, term).is_some())
        }
        TemplatePiece::Name(index) => matches!(wording.named.get(*index), Some(Named::Object(_) | Named::Region(_))),
        _ => true,
    })
}

fn number(wording: &Wording, term: &Term) -> Option<f64> {
    match term {
        Term::Number(n) => n.parse().ok(),
        Term::Name(index) => match wording.named.get(*index) {
            Some(Named::Constant(n, _)) => Some(*n),
            _ => None,
        },
    }
}

/// The sentence of a predicate about a bound of what it measures, and about what that must be.
fn measured_words(
    program: &Program,
    wording: &Wording,
    unit: Unit,
    [bound, limit]: [f64; 2],
    upper: bool,
) -> Option<String> {
    let pieces = &wording.template.pieces;
    let mut shift = 0.0;
    for piece in pieces {
        if let TemplatePiece::Value { terms, .. } = piece {
            for (minus, term) in terms {
                let n = number(wording, term)?;
                shift += if *minus { -n } else { n };
            }
        }
    }
    let choice = pieces.iter().any(|p| matches!(p, TemplatePiece::Choice(_)));
    let bound = bound + shift;
    // What is at most -0.7 m beyond is at least 0.7 m short.
    let at_least = upper != (choice && bound < 0.0);
    let quantity = with_unit(if choice { bound.abs() } else { bound }, unit);
    let mut out = String::new();
    for piece in pieces {
        match piece {
            TemplatePiece::Text(text) => out += text,
            TemplatePiece::Name(index) => match wording.named.get(*index)? {
                Named::Object(id) => out += &format!("`{}`", name(program, *id)),
                Named::Region(id) => out += &format!("`{}`", program.regions[id.0 as usize].name),
                _ => return None,
            },
            TemplatePiece::Value { .. } => {
                out += if at_least { "at least " } else { "at most " };
                out += &quantity;
            }
            TemplatePiece::Choice(texts) => out += &texts[usize::from(bound < 0.0)],
        }
    }
    let must = if choice {
        String::new()
    } else {
        format!(", but must be {} {}", if upper { "at most" } else { "at least" }, with_unit(limit + shift, unit))
    };
    Some(out + &must)
}
