//! By how much at least a number in a constraint must change so that the constraint holds in the layout as it is.
//!
//! The number is changed in the compiled formula until it holds, then in the text; what is offered has been compiled and
//! judged anew.

use super::judge::Judge;
use super::room::describe;
use super::{Alternative, How, RepairOptions, Text, edit};
use scenelang_base::{Edit, SourceMap, Span, TextRange};
use scenelang_lang::Program;
use scenelang_lang::program::{Arg, Arith, Formula, Node, NodeId, Unit};
use scenelang_lang::token::{self, Kind, UNITS};
use scenelang_layout::Layout;
use scenelang_verify::check::Subject;
use scenelang_verify::explain::RowRef;
use scenelang_verify::{World, cone, judge as evaluate, surroundings};

/// The first change that is tried (metres or degrees), and how much larger each next one is.
const FIRST: f64 = 1e-3;
const GROWTH: f64 = 1.5;
/// No change is larger than this.
const MOST: f64 = 1e4;
/// So often the interval is halved in which the least change lies.
const HALVINGS: usize = 40;
/// The same where each look is dear: ways over the floor are looked for.
const DEAR: (f64, usize) = (3.0, 8);
/// What is measured by a built-in predicate and is no more than this part of what was asked for asks for nothing any more:
/// a path 4 cm wide.
const NOTHING: f64 = 0.1;
/// A number that is rounder may be so much further off than it must; of what is asked for, that may take no more than so
/// many metres, or so much of it.
const ROUND: f64 = 0.1;
const LOST: (f64, f64) = (0.01, 0.05);

/// A number in a text.
struct Literal {
    place: Span,
    /// What it says, in its own unit.
    written: f64,
    unit: String,
    /// Metres or degrees (or plain) for one of its own unit.
    per: f64,
    /// The nodes of the formula that come from it, and whether each is its negative.
    nodes: Vec<(usize, f64)>,
}

/// A number that repairs a statement.
#[derive(Clone, Debug, PartialEq)]
pub struct Relaxed {
    /// The edit of the text.
    pub edit: Edit,
    /// What it was and what it becomes, with its unit.
    pub shown: [String; 2],
    /// How far it must change at least, in its own unit.
    pub least: f64,
    /// How far it changes (metres or degrees).
    pub cost: f64,
}

/// Numbers written in a statement that repair it in a layout, each by itself, the smallest change first. As nothing else of
/// the program has them, no other statement changes.
pub fn in_statement(program: &Program, sources: &SourceMap, world: &World<f64>, index: usize) -> Vec<Relaxed> {
    let own = program.constraints[index].span;
    let mut found = statement((program, sources), world, index, false);
    // One statement may be several constraints, which share its numbers.
    if program.constraints.iter().enumerate().any(|(i, c)| i != index && c.span == own) {
        found.clear();
    }
    found.sort_by(|a, b| a.cost.total_cmp(&b.cost));
    found
}

/// Whether numbers are written in a statement, or in what it is made with.
pub fn has_numbers(program: &Program, sources: &SourceMap, index: usize) -> bool {
    let constraint = &program.constraints[index];
    let definitions = constraint.definitions.iter().map(|definition| program.definitions[*definition].span);
    definitions.chain([constraint.span]).any(|span| !in_text(sources, span).is_empty())
}

/// Numbers to be changed so that all targets hold: of one statement each number that does it, of several one each.
pub(super) fn numbers(
    judge: &Judge<'_>,
    text: &Text<'_>,
    options: &RepairOptions,
    apart: &[(Vec<RowRef>, Layout)],
) -> Vec<Alternative> {
    for (rows, layout) in apart {
        let found = numbers_of(judge, text, options, (rows, layout));
        if !found.is_empty() {
            return found;
        }
    }
    numbers_of(judge, text, options, (&judge.targets, judge.layout))
}

/// Numbers to be changed so that some rows hold in a layout.
fn numbers_of(
    judge: &Judge<'_>,
    text: &Text<'_>,
    options: &RepairOptions,
    (rows, layout): (&[RowRef], &Layout),
) -> Vec<Alternative> {
    let world = World::<f64>::new(judge.program, layout, &judge.options);
    let mut each: Vec<Vec<Relaxed>> = Vec::new();
    for row in rows {
        let Subject::Statement(index) = row.subject else { return Vec::new() };
        let mut found = statement((judge.program, text.sources), &world, index, true);
        if found.is_empty() {
            return Vec::new();
        }
        found.sort_by(|a, b| a.cost.total_cmp(&b.cost));
        each.push(found);
    }
    let sets: Vec<Vec<Relaxed>> = match each.len() {
        1 => each.remove(0).into_iter().map(|one| vec![one]).collect(),
        _ => vec![each.into_iter().filter_map(|found| found.into_iter().next()).collect()],
    };
    let offered = sets.into_iter().filter_map(|set| offer(judge, text, set, layout));
    offered.take(options.alternatives).collect()
}

/// Compiles and judges anew.
fn offer(judge: &Judge<'_>, text: &Text<'_>, mut set: Vec<Relaxed>, layout: &Layout) -> Option<Alternative> {
    // One number may be in the way of two statements, in a variable that both read: the larger change serves both.
    set.sort_by(|a, b| a.edit.place.cmp(&b.edit.place).then(b.cost.total_cmp(&a.cost)));
    set.dedup_by(|a, b| a.edit.place == b.edit.place);
    let edits: Vec<Edit> = set.iter().map(|r| r.edit.clone()).collect();
    let program = edit::compiled(text, &edits)?;
    let broken = judge.judge_with(&program, layout, Some)?;
    if !broken.is_empty() {
        return None;
    }
    let least = set.iter().map(|r| r.least).collect();
    let cost = set.iter().map(|r| r.cost).sum();
    let shown = set.into_iter().map(|r| r.shown).collect();
    Some(Alternative { how: How::Numbers, edits, least, shown, cost, ..describe(judge, layout.clone(), &[]) })
}

/// The numbers of a statement that repair it by themselves; with `defined`, those of what it is made with, too.
fn statement(
    (program, sources): (&Program, &SourceMap),
    world: &World<f64>,
    index: usize,
    defined: bool,
) -> Vec<Relaxed> {
    let constraint = &program.constraints[index];
    let formula = &constraint.formula;
    let source = sources.get(constraint.span.file);
    let start = constraint.span.range.start;
    let ranges: Vec<TextRange> = formula.ranges.iter().map(|r| r.shifted(start)).collect();
    let mut literals = in_text(sources, constraint.span);
    for literal in &mut literals {
        let own = |range: &TextRange| {
            let place = literal.place.range;
            *range == place
                || range.end == place.end
                    && source.slice(*range).trim_start_matches(['-', ' ']).len() == place.len() as usize
        };
        literal.nodes = nodes(formula, literal.written * literal.per, |i| own(&ranges[i]));
        if literal.nodes.is_empty() {
            // Equal numbers are one node, which has the place of the first.
            literal.nodes = nodes(formula, literal.written * literal.per, |_| true);
        }
    }
    for definition in constraint.definitions.iter().filter(|_| defined) {
        // What a variable stands for has the place of the variable.
        let named = |i: usize| source.slice(ranges[i]).starts_with(|c: char| c.is_alphabetic() || c == '_');
        for mut literal in in_text(sources, program.definitions[*definition].span) {
            literal.nodes = nodes(formula, literal.written * literal.per, named);
            literals.push(literal);
        }
    }
    literals.iter().filter_map(|literal| relaxed(formula, world, literal)).collect()
}

/// The numbers that stand in a text, indices and the ends of ranges left out.
fn in_text(sources: &SourceMap, span: Span) -> Vec<Literal> {
    let whole = sources.text(span);
    let tokens: Vec<token::Token> = token::lex(whole).into_iter().filter(|t| !t.kind.is_trivia()).collect();
    let mut out = Vec::new();
    for (i, token) in tokens.iter().enumerate().filter(|(_, t)| t.kind == Kind::Number) {
        let beside = |j: Option<usize>| j.and_then(|j| tokens.get(j)).map(|t| &whole[t.range.bytes()]);
        let counts = [beside(i.checked_sub(1)), beside(Some(i + 1))];
        if counts.iter().flatten().any(|t| matches!(*t, "[" | "]" | "..")) {
            continue;
        }
        let digits = &whole[token.range.bytes()];
        let unit = UNITS.iter().filter(|u| digits.ends_with(**u)).max_by_key(|u| u.len()).copied().unwrap_or_default();
        let Ok(written) = digits[..digits.len() - unit.len()].parse::<f64>() else { continue };
        let per = match unit {
            "cm" => 0.01,
            "mm" => 0.001,
            "ft" => 0.3048,
            "in" => 0.0254,
            "rad" => 1f64.to_degrees(),
            _ => 1.0,
        };
        let place = token.range.shifted(span.range.start).in_file(span.file);
        out.push(Literal { place, written, unit: unit.to_owned(), per, nodes: Vec::new() });
    }
    out
}

/// The nodes of a formula that are a number or its negative, and which of the two.
fn nodes(formula: &Formula, value: f64, fits: impl Fn(usize) -> bool) -> Vec<(usize, f64)> {
    let near = |a: f64, b: f64| (a - b).abs() <= 1e-12 * (1.0 + b.abs());
    let sign = |i: usize| match formula.nodes[i] {
        Node::Number(x) if near(x, value) => Some((i, 1.0)),
        Node::Number(x) if near(x, -value) => Some((i, -1.0)),
        _ => None,
    };
    (0..formula.nodes.len()).filter(|i| fits(*i)).filter_map(sign).collect()
}

/// The least change of a number after which a formula holds.
fn relaxed(formula: &Formula, world: &World<f64>, literal: &Literal) -> Option<Relaxed> {
    if literal.nodes.is_empty() {
        return None;
    }
    let mut changed = formula.clone();
    let mut holds = |value: f64| {
        for &(i, sign) in &literal.nodes {
            changed.nodes[i] = Node::Number(sign * value);
        }
        evaluate(&changed, world).is_ok_and(|truth| truth.holds)
    };
    let walks = formula.nodes.iter().any(|node| surroundings(formula, node).is_path());
    let (growth, halvings) = if walks { DEAR } else { (GROWTH, HALVINGS) };
    let from = literal.written * literal.per;
    let mut by = FIRST;
    let (mut low, mut high) = (
        0.0,
        loop {
            if let Some(sign) = [1.0, -1.0].into_iter().find(|sign| holds(from + sign * by)) {
                break sign * by;
            }
            by *= growth;
            if by > MOST {
                return None;
            }
        },
    );
    for _ in 0..halvings {
        let middle = (low + high) / 2.0;
        if holds(from + middle) {
            high = middle;
        } else {
            low = middle;
        }
    }
    let (value, least) = ((from + high) / literal.per, high / literal.per);
    // The roundest number that is not much further off.
    let round = |digits: i32| {
        let grid = 10f64.powi(digits);
        let scaled = value * grid;
        let out = if high > 0.0 { (scaled - 1e-9).ceil() } else { (scaled + 1e-9).floor() };
        out / grid
    };
    let lost = (LOST.0 / literal.per).max(LOST.1 * value.abs());
    let fits = |x: &f64| (x - value).abs() <= lost.min(ROUND * least.abs());
    let best = (0..=9).map(round).filter(fits).find(|x| holds(x * literal.per))?;
    if is_measure(formula, literal) && best <= NOTHING * literal.written {
        return None;
    }
    let edit = Edit { place: literal.place, text: format!("{}{}", best + 0.0, literal.unit) };
    let margin = evaluate(formula, world).map_or(Unit::Metre, |truth| truth.unit);
    let unit = unit(formula, literal, margin);
    let shown = [literal.written, best + 0.0].map(|x| format!("{x}{unit}"));
    Some(Relaxed { edit, shown, least, cost: high.abs() })
}

/// The unit of a number as it is read: the one that is written or, where it is compared with a length or an angle, that
/// of these.
fn unit(formula: &Formula, literal: &Literal, margin: Unit) -> String {
    if !literal.unit.is_empty() {
        return if literal.unit == "deg" { "°".to_owned() } else { format!(" {}", literal.unit) };
    }
    let own = |id: &NodeId| literal.nodes.iter().any(|(node, _)| *node == id.0 as usize);
    // A count has no unit, and a product or a quotient may have another one.
    let plain = |id: NodeId| {
        let nodes = cone(formula, id);
        nodes.iter().any(|id| matches!(formula.node(*id), Node::Count(_) | Node::Arith(Arith::Mul | Arith::Div, ..)))
    };
    let compared = formula.nodes.iter().find_map(|node| match node {
        Node::Compare(_, unit, a, b) if own(a) => Some((*unit, *b)),
        Node::Compare(_, unit, a, b) if own(b) => Some((*unit, *a)),
        _ => None,
    });
    // What is measured by a built-in predicate has the unit of its margin.
    let measured = is_measure(formula, literal);
    let compared = compared.filter(|(_, other)| !plain(*other)).map(|(unit, _)| unit);
    match compared.or(measured.then_some(margin)) {
        Some(Unit::Degree) => "°".to_owned(),
        Some(Unit::Metre) => " m".to_owned(),
        _ => String::new(),
    }
}

/// Whether a number is what a built-in predicate is given.
fn is_measure(formula: &Formula, literal: &Literal) -> bool {
    let own = |id: &NodeId| literal.nodes.iter().any(|(node, _)| *node == id.0 as usize);
    let given = |arg: &Arg| matches!(arg, Arg::Value(id) if own(id));
    formula.nodes.iter().any(|n| matches!(n, Node::BuiltIn(_, args) if args.iter().any(given)))
}
