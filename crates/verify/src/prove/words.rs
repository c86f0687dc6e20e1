//! Findings in words: diagnostics, and the steps of a proof.

use super::conjuncts::located;
use super::minimal::{LARGEST, MOST_SAID};
use super::model::{ClaimModel, GivenSource};
use super::problem::{Affine, Function, Problem, UnknownKind, Var, VariableFormula};
use super::refute::ProofEvent;
use super::state::{EventKind, Rule};
use super::tape::{Claim, Op, Term};
use super::{Contradiction, Findings, Proof, ProofStep};
use rustc_hash::FxHashMap;
use scenelang_base::{Diagnostic, Span, codes};
use scenelang_lang::program::{BuiltIn, ConstraintKind, Node, ObjectId, Program};
use scenelang_lang::roles::role_of;

/// Of a contradiction that rests on what is usual.
const AS_USUAL: &str = "this is impossible unless something is tilted, turned or of an unusual size: it is proved for layouts like \
    those that `solve` makes, in which rooms are not rotated, and objects stand upright, rest on something and have their usual sizes";
/// The same, of one that rests on the shapes of furniture, too.
const WITH_SHAPES: &str = "this is impossible unless something is tilted, turned or of an unusual size or shape: it is proved for layouts \
    like those that `solve` makes, in which rooms are not rotated, and objects stand upright, rest on something and have their usual sizes and \
    shapes";

pub(super) fn diagnostics(findings: &Findings, program: &Program) -> Vec<Diagnostic> {
    let mut out: Vec<Diagnostic> = findings.contradictions.iter().map(|c| contradiction(c, program)).collect();
    out.extend(findings.unsatisfiable.iter().map(|c| contradiction(c, program)));
    for &statement in &findings.always {
        let place = program.constraints[statement].span;
        out.push(
            Diagnostic::new(codes::W0402, place, "this always holds")
                .note("it has no effect, because it holds in every layout"),
        );
    }
    for redundancy in &findings.redundant {
        let place = program.constraints[redundancy.statement].span;
        let mut finding = Diagnostic::new(codes::W0401, place, "this is implied by other statements");
        for &by in &redundancy.by {
            finding = finding.related(program.constraints[by].span, "one of them");
        }
        out.push(finding);
    }
    if let (true, Some(first)) = (findings.too_large, program.constraints.first()) {
        let say = "the program is too large to be searched for contradictions as a whole";
        let note = format!(
            "the statements may mention at most {LARGEST} objects, and may expand to at most {MOST_SAID} parts"
        );
        out.push(Diagnostic::new(codes::W0403, first.span, say).note(note));
    }
    out.sort_by_key(|d| d.primary.as_ref().map(|p| (p.place.file, p.place.range.start)));
    out
}

fn contradiction(found: &Contradiction, program: &Program) -> Diagnostic {
    let of = |index: usize| &program.constraints[index];
    let rules = match (&found.reason, found.rules.as_slice()) {
        (Some(reason), _) => format!(": {reason}"),
        (None, []) => String::new(),
        (None, [one]) => format!(", given that {one}"),
        (None, [one, two]) => format!(", given that {one} and {two}"),
        (None, [one, two, three]) => format!(", given that {one}, {two} and {three}"),
        (None, [one, two, rest @ ..]) => format!(", given that {one}, {two} and {} more (see below)", rest.len()),
    };
    // Where the reader looks first: at what is said of an object, rather than of what surrounds it.
    let speaks = |s: &usize| !of(*s).formula.objects().is_empty();
    let is_preference = |s: &usize| matches!(of(*s).kind, ConstraintKind::Prefer { .. });
    let preference = found.statements.iter().copied().find(is_preference);
    let main = preference.or_else(|| found.statements.iter().copied().find(speaks)).unwrap_or(found.statements[0]);
    // What of a statement matters, and where that is.
    let placed = |s: &usize| match found.parts.iter().find(|(statement, _)| statement == s) {
        Some((_, parts)) => {
            parts.iter().map(|p| located(of(*s), *p)).map(|(span, text)| (span, text.unwrap_or(&of(*s).text))).collect()
        }
        None => vec![(of(*s).span, of(*s).text.as_str())],
    };
    let mut members: Vec<(Span, &str)> = found.statements.iter().flat_map(placed).collect();
    members.extend(found.definitions.iter().map(|d| &program.definitions[*d]).map(|d| (d.span, d.text.as_str())));
    let count = found.statements.len() + found.definitions.len();
    members.sort_by_key(|(span, _)| (span.file, span.range.start));
    let mut finding = match count {
        1 if preference.is_some() => {
            Diagnostic::new(codes::W0404, of(main).span, format!("this preference can never hold{rules}"))
        }
        n if preference.is_some() => {
            let others = if n == 2 { "another statement".to_owned() } else { format!("{} other statements", n - 1) };
            let say = format!("this preference can never hold because of {others}{rules}");
            Diagnostic::new(codes::W0404, of(main).span, say)
        }
        1 => Diagnostic::new(codes::E0402, of(main).span, format!("this statement can never hold{rules}")),
        n => Diagnostic::new(codes::E0401, of(main).span, format!("these {n} statements contradict each other{rules}")),
    };
    for (span, text) in members {
        finding = finding.related(span, format!("`{text}`"));
    }
    if let (None, [_, _, rest @ ..]) = (&found.reason, found.rules.as_slice())
        && rest.len() > 1
    {
        finding = finding.note(format!("it also follows from these: {}", list(rest)));
    }
    if found.as_usual {
        finding = finding.note(if found.shapes { WITH_SHAPES } else { AS_USUAL });
    }
    if let Some((first, _)) = found.sizes.first() {
        let name = |id: ObjectId| program.objects[id.0 as usize].name.as_str();
        let size = |(id, [w, h, d]): &(ObjectId, [f64; 3])| {
            format!("`{}` {} × {} × {} m", name(*id), short(*w), short(*h), short(*d))
        };
        let sizes: Vec<String> = found.sizes.iter().map(size).collect();
        finding = finding.note(format!(
            "usual sizes are assumed (width × height × depth): {}; to change one, write `{}.dimensions <- vec3(…);` or a \
             more specific category",
            list(&sizes),
            name(*first)
        ));
    }
    if let Some(opening) = unconnected(found, program) {
        let room = match program.regions.as_slice() {
            [room] => room.name.as_str(),
            _ => "…",
        };
        finding = finding.note(format!(
            "a door or window belongs in a wall: add `assert connects({0}, {room});`",
            program.objects[opening.0 as usize].name
        ));
    }
    if let Some(proof) = &found.proof {
        for step in &proof.steps {
            finding = finding.note(format!("{}{}", "  ".repeat(step.depth), step.text));
        }
    }
    finding
}

/// Some things, as a sentence lists them.
fn list(parts: &[String]) -> String {
    match parts {
        [] => String::new(),
        [one] => one.clone(),
        [rest @ .., last] => format!("{} and {last}", rest.join(", ")),
    }
}

/// A door or window in a contradiction of which nothing says that it connects rooms.
fn unconnected(found: &Contradiction, program: &Program) -> Option<ObjectId> {
    let is_opening = |id: &ObjectId| {
        let object = &program.objects[id.0 as usize];
        let what = if object.category.is_empty() { object.name.as_str() } else { object.category.as_str() };
        matches!(role_of(what), "door" | "window")
    };
    let connects = |id: ObjectId| {
        program.constraints.iter().any(|c| {
            let is_connects = |node: &Node| matches!(node, Node::BuiltIn(BuiltIn::Connects, _));
            c.formula.nodes.iter().any(is_connects) && c.formula.objects().contains(&id)
        })
    };
    let spoken = found.statements.iter().flat_map(|s| program.constraints[*s].formula.objects());
    spoken.filter(is_opening).find(|id| !connects(*id))
}

/// A proof in words.
pub(super) fn proof(program: &Program, model: &ClaimModel, problem: &Problem, told: &[ProofEvent]) -> Proof {
    let mut speaker = Speaker { model, problem, names: FxHashMap::default() };
    for (index, term) in problem.terms.iter().enumerate() {
        if let (Some(name), Some(Affine { var, minus: false, .. })) = (model.names.get(&Term(index as u32)), term) {
            speaker.names.insert(*var, name.clone());
        }
    }
    let mut steps: Vec<ProofStep> = Vec::new();
    for step in told {
        let Some(text) = speaker.step(program, step, told) else { continue };
        if steps.last().is_none_or(|last| last.text != text) {
            steps.push(ProofStep { depth: step.depth, text });
        }
    }
    Proof { steps }
}

struct Speaker<'a> {
    model: &'a ClaimModel,
    problem: &'a Problem,
    names: FxHashMap<Var, String>,
}

impl Speaker<'_> {
    fn step(&self, program: &Program, step: &ProofEvent, told: &[ProofEvent]) -> Option<String> {
        Some(match step.what {
            EventKind::Given(index) => match &self.model.given[index as usize].what {
                GivenSource::Statement(s) | GivenSource::Contrary(s) => {
                    format!("given: `{}`", program.constraints[*s].text)
                }
                GivenSource::Rule(rule) => format!("rule: {rule}"),
            },
            EventKind::Supposed => return None,
            EventKind::Decided(claim) => {
                let supposed = step.reasons.iter().any(|r| told[*r].what == EventKind::Supposed);
                // What is part of something said already needs no words, and a comparison is said as a bound.
                let plain = matches!(
                    self.problem.verdicts[claim.index()],
                    VariableFormula::AtLeast(..) | VariableFormula::Iff(..)
                );
                if !supposed && !plain {
                    return None;
                }
                format!("{} {}", if supposed { "suppose" } else { "so" }, self.claim(claim))
            }
            EventKind::Bound { var, upper, value } => {
                // The float next to 0 stands for what is strictly beyond it.
                let strict = value != 0.0 && value.abs() < f64::MIN_POSITIVE;
                let way = match (upper, strict) {
                    (true, false) => "at most",
                    (false, false) => "at least",
                    (true, true) => "less than",
                    (false, true) => "more than",
                };
                format!("{} is {way} {}", self.var(var, 0), short(if strict { 0.0 } else { value }))
            }
            EventKind::Conflict(rule) => match rule {
                Rule::Empty(var) => format!("no value is left for {}", self.var(var, 0)),
                Rule::Verdict(_) => "that is a contradiction".to_owned(),
                Rule::Sum => "added up, these inequalities contradict each other".to_owned(),
                Rule::Packing => "together the boxes are too large for the region".to_owned(),
                Rule::Beside { fit } => format!("at most {fit} of the boxes fit beside each other"),
            },
            EventKind::Excluded => "that cannot be".to_owned(),
        })
    }

    fn claim(&self, claim: Claim) -> String {
        let contrary = claim.is_contrary();
        match &self.problem.verdicts[claim.index()] {
            VariableFormula::Atom { term, bound, strict } => {
                let sign = match (contrary, strict) {
                    (false, false) => ">=",
                    (false, true) => ">",
                    (true, false) => "<",
                    (true, true) => "<=",
                };
                format!("{} {sign} {}", self.affine(*term, 0), short(*bound))
            }
            VariableFormula::All(parts) if contrary => {
                let parts: Vec<String> = parts.iter().take(4).map(|p| self.claim(Claim(p.0 ^ 1))).collect();
                parts.join(" or ")
            }
            VariableFormula::All(parts) => {
                let parts: Vec<String> = parts.iter().take(4).map(|p| self.claim(*p)).collect();
                parts.join(" and ")
            }
            VariableFormula::AtLeast(n, parts) => {
                format!("{}at least {n} of {} hold", if contrary { "not " } else { "" }, parts.len())
            }
            VariableFormula::Iff(a, b) => {
                format!(
                    "{} {} {}",
                    self.claim(*a),
                    if contrary { "differs from" } else { "is the same as" },
                    self.claim(*b)
                )
            }
            VariableFormula::Open => (if contrary { "a predicate fails" } else { "a predicate holds" }).to_owned(),
        }
    }

    fn affine(&self, term: Affine, depth: usize) -> String {
        let own = if term.var == 0 { String::new() } else { self.var(term.var, depth) };
        let add = term.add.lo + term.add.width() / 2.0;
        match (own.is_empty(), term.minus, add == 0.0) {
            (true, ..) => short(add),
            (_, false, true) => own,
            (_, true, true) => format!("-({own})"),
            (_, false, false) => format!("{own} + {}", short(add)),
            (_, true, false) => format!("{} - ({own})", short(add)),
        }
    }

    fn var(&self, var: Var, depth: usize) -> String {
        if let Some(name) = self.names.get(&var) {
            return name.clone();
        }
        if depth > 4 {
            return "…".to_owned();
        }
        match &self.problem.kinds[var as usize] {
            UnknownKind::Free => self.measure(var),
            UnknownKind::Row(parts) => {
                let mut out = String::new();
                for (index, (part, c)) in parts.iter().take(8).enumerate() {
                    let sign = match (index, *c < 0.0) {
                        (0, false) => "",
                        (0, true) => "-",
                        (_, false) => " + ",
                        (_, true) => " - ",
                    };
                    out += sign;
                    if c.abs() != 1.0 {
                        out += &format!("{}·", short(c.abs()));
                    }
                    out += &self.var(*part, depth + 1);
                }
                out
            }
            UnknownKind::Apply(function, a, b) => {
                let (x, y) = (self.affine(*a, depth + 1), self.affine(*b, depth + 1));
                match function {
                    Function::Mul => format!("({x})·({y})"),
                    Function::Div => format!("({x}) / ({y})"),
                    Function::Square => format!("({x})²"),
                    Function::Sqrt => format!("√({x})"),
                    Function::Abs => format!("|{x}|"),
                    Function::Min => format!("min({x}, {y})"),
                    Function::Max => format!("max({x}, {y})"),
                    Function::Sin => format!("sin({x})"),
                    Function::Cos => format!("cos({x})"),
                    Function::Atan => format!("atan({x}, {y})"),
                    Function::Wrap => format!("({x} modulo 360)"),
                }
            }
            UnknownKind::Indicator(claim) => format!("[{}]", self.claim(*claim)),
        }
    }

    /// An unknown without a name: something that geometry measures.
    fn measure(&self, var: Var) -> String {
        let term = self.problem.terms.iter().position(|t| t.is_some_and(|t| t.var == var));
        match term.map(|t| self.model.tape.ops[t]) {
            Some(Op::Unknown(n)) => format!("measure {n}"),
            _ => "a measure".to_owned(),
        }
    }
}

/// A number for people: six digits.
fn short(value: f64) -> String {
    if value.abs() >= 1e5 || value != 0.0 && value.abs() < 1e-4 {
        return format!("{value:.3e}");
    }
    let text = format!("{value:.6}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}
