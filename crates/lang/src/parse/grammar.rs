//! The grammar: tokens of one statement → its tree.
//!
//! Contextual words and the two readings of `<-` are settled before (see `words`), so that one token of look-ahead
//! decides everywhere: nothing is ever parsed twice, and time is linear however deep the nesting. Formulas and
//! arithmetic are two layers: a comparison's sides are arithmetic, so `a > not b` asks for parentheses.

use super::builder::Builder;
use super::wanted::{Failure, Wanted};
use crate::ast::{Allow, BinaryOp, ExprId, ExprKind, Name, Param, Quantifier, StmtKind, TypeWord};
use crate::program::Comparison;
use crate::token::Kind;
use chumsky::inspector::SimpleState;
use chumsky::pratt::{infix, left, prefix, right};
use chumsky::prelude::*;
use scenelang_base::TextRange;

type Extra<'t> = extra::Full<Failure, SimpleState<Builder<'t>>, ()>;

/// A statement with what stands before it.
pub struct Parsed {
    /// What it says.
    pub kind: StmtKind,
    /// Its place, attributes not counted.
    pub range: TextRange,
    /// Sentences of `@req`, with the ranges of the strings.
    pub requirements: Vec<(String, TextRange)>,
    /// The place of the first `@req(…)`.
    pub attribute: Option<TextRange>,
}

/// Parses the tokens of one statement, its `;` taken off.
pub fn parse<'t>(kinds: &'t [Kind], builder: Builder<'t>) -> (Result<Parsed, Failure>, Builder<'t>) {
    let mut state = SimpleState(builder);
    let result = statement().parse_with_state(kinds, &mut state).into_result();
    let result = result.map_err(|failures| match failures.first() {
        Some(failure) => *failure,
        None => Failure { at: kinds.len(), wanted: Wanted::default() },
    });
    (result, state.0)
}

fn statement<'t>() -> impl Parser<'t, &'t [Kind], Parsed, Extra<'t>> {
    let formula = formula().boxed();
    let name = just(Kind::Ident).map_with(|_, e| word(e)).labelled(Wanted::NAME);
    let index = formula.clone().delimited_by(just(Kind::LBracket), just(Kind::RBracket));
    let arguments = formula.clone().separated_by(just(Kind::Comma)).collect::<Vec<_>>();
    let arguments = arguments.delimited_by(just(Kind::LParen), just(Kind::RParen));

    let declaration = type_word().then(name).then(index.clone().or_not());
    let declaration = declaration.map(|(((ty, ty_range), name), size)| StmtKind::Declare { ty, ty_range, name, size });

    let property = just(Kind::Dot).ignore_then(property());
    let path = property.repeated().collect::<Vec<_>>();
    let target = name.then(index.or_not()).then(path).map_with(|target, e| (target, range(e)));
    let arrow = one_of([Kind::Arrow, Kind::ArrowSign]).labelled(Wanted::ARROW);
    let assignment = target.then_ignore(arrow).then(formula.clone());
    let assignment = assignment.map(|((((name, index), path), target), value)| StmtKind::Assign {
        name,
        index,
        path,
        target,
        value,
    });

    let assertion = just(Kind::Assert).ignore_then(formula.clone()).map(|formula| StmtKind::Assert { formula });

    let weight = just(Kind::Weight).ignore_then(formula.clone()).or_not();
    let preference = just(Kind::Prefer).ignore_then(formula.clone()).then(weight);
    let preference = preference.map(|(formula, weight)| StmtKind::Prefer { formula, weight });

    let rule = select! {
        Kind::AllowCollide => Allow::Collide,
        Kind::AllowOutside => Allow::Outside,
        Kind::AllowFloat => Allow::Float,
    };
    let allowance = rule.map_with(|rule, e| (rule, range(e))).then(arguments);
    let allowance = allowance.map(|((rule, word), args)| StmtKind::Allow { rule, word, args });

    let parameter = parameter_type().then(name).map(|((ty, ty_range), name)| Param { ty, ty_range, name });
    let parameters = parameter.separated_by(just(Kind::Comma)).collect::<Vec<_>>();
    let parameters = parameters.delimited_by(just(Kind::LParen), just(Kind::RParen));
    let callee = callee().map_with(|_, e| word(e)).labelled(Wanted::NAME);
    let predicate = just(Kind::Predicate).ignore_then(callee).then(parameters);
    let predicate = predicate.then_ignore(just(Kind::Define)).then(formula);
    let predicate = predicate.map(|((name, params), body)| StmtKind::Predicate { name, params, body });

    let string = just(Kind::Str).map_with(|_, e| (text(e), range(e)));
    let import = just(Kind::Import).ignore_then(string);
    let import = import.map(|(path, range)| StmtKind::Import { path, range });

    let requirement = just(Kind::Req).ignore_then(string.delimited_by(just(Kind::LParen), just(Kind::RParen)));
    let requirements = requirement.map_with(|string, e| (string, range(e))).repeated().collect::<Vec<_>>();

    let body = choice((declaration, assertion, assignment, preference, allowance, predicate, import));
    let body = body.labelled(Wanted::STATEMENT).map_with(|kind, e| (kind, range(e)));
    requirements.then(body).then_ignore(end()).map(|(requirements, (kind, range))| Parsed {
        kind,
        range,
        attribute: requirements.first().map(|(_, place)| *place),
        requirements: requirements.into_iter().map(|(string, _)| string).collect(),
    })
}

/// A condition or a value: everything that may stand in parentheses.
fn formula<'t>() -> impl Parser<'t, &'t [Kind], ExprId, Extra<'t>> + Clone {
    recursive(|formula| {
        let sum = sum(formula.clone()).boxed();
        let comparison_op = select! {
            Kind::Eq => Comparison::Eq,
            Kind::Ne => Comparison::Ne,
            Kind::Lt => Comparison::Lt,
            Kind::Le => Comparison::Le,
            Kind::Gt => Comparison::Gt,
            Kind::Ge => Comparison::Ge,
        };
        let comparison_op = comparison_op.map_with(|op, e| (op, range(e))).labelled(Wanted::OPERATOR);
        let step = comparison_op.then(sum.clone()).map(|((op, place), right)| (op, place, right));
        let comparison = sum.then(step.repeated().collect::<Vec<_>>()).map_with(|(first, steps), e| {
            if steps.is_empty() { first } else { push(e, ExprKind::Compare(first, steps)) }
        });

        let quantifier = select! { Kind::Forall => Quantifier::Forall, Kind::Exists => Quantifier::Exists };
        let quantified = quantifier.then(binding(formula)).map_with(|(quantifier, (name, domain, body)), e| {
            push(e, ExprKind::Quantified(quantifier, name, domain, body))
        });

        let operand = choice((quantified.labelled(Wanted::CONDITION), comparison)).boxed();
        let connective = |kind, op| {
            just(kind).map_with(move |_, e: &mut Extras<'t, '_>| (op, range(e))).labelled(Wanted::CONNECTIVE)
        };
        operand.pratt((
            prefix(5, just(Kind::Not).labelled(Wanted::CONDITION), |_, a, e: &mut Extras<'t, '_>| {
                push(e, ExprKind::Not(a))
            }),
            infix(left(4), connective(Kind::And, BinaryOp::And), |a, (op, place), b, e: &mut Extras<'t, '_>| {
                push(e, ExprKind::Binary(op, place, a, b))
            }),
            infix(left(3), connective(Kind::Or, BinaryOp::Or), |a, (op, place), b, e: &mut Extras<'t, '_>| {
                push(e, ExprKind::Binary(op, place, a, b))
            }),
            infix(
                right(2),
                connective(Kind::Implies, BinaryOp::Implies),
                |a, (op, place), b, e: &mut Extras<'t, '_>| push(e, ExprKind::Binary(op, place, a, b)),
            ),
            infix(left(1), just(Kind::Where), |set, _, filter, e: &mut Extras<'t, '_>| {
                push(e, ExprKind::Where(set, filter))
            }),
        ))
    })
}

/// Arithmetic, and ranges `a..b`.
fn sum<'t>(
    formula: impl Parser<'t, &'t [Kind], ExprId, Extra<'t>> + Clone + 't,
) -> impl Parser<'t, &'t [Kind], ExprId, Extra<'t>> + Clone {
    let product_op = select! { Kind::Star => BinaryOp::Mul, Kind::Slash => BinaryOp::Div };
    let product_op = product_op.map_with(|op, e: &mut Extras<'t, '_>| (op, range(e))).labelled(Wanted::OPERATOR);
    let sum_op = select! { Kind::Plus => BinaryOp::Add, Kind::Minus => BinaryOp::Sub };
    let sum_op = sum_op.map_with(|op, e: &mut Extras<'t, '_>| (op, range(e))).labelled(Wanted::OPERATOR);
    part(formula).boxed().pratt((
        prefix(4, just(Kind::Minus).labelled(Wanted::VALUE), |_, a, e: &mut Extras<'t, '_>| push(e, ExprKind::Neg(a))),
        infix(left(3), product_op, |a, (op, place), b, e: &mut Extras<'t, '_>| {
            push(e, ExprKind::Binary(op, place, a, b))
        }),
        infix(left(2), sum_op, |a, (op, place), b, e: &mut Extras<'t, '_>| push(e, ExprKind::Binary(op, place, a, b))),
        infix(left(1), just(Kind::DotDot), |a, _, b, e: &mut Extras<'t, '_>| push(e, ExprKind::Range(a, b))),
    ))
}

/// A literal, a name, a call, something in parentheses; with `.property` and `[index]` behind it.
fn part<'t>(
    formula: impl Parser<'t, &'t [Kind], ExprId, Extra<'t>> + Clone + 't,
) -> impl Parser<'t, &'t [Kind], ExprId, Extra<'t>> + Clone {
    let arguments = formula.clone().separated_by(just(Kind::Comma)).collect::<Vec<_>>();
    let arguments = arguments.delimited_by(just(Kind::LParen), just(Kind::RParen)).boxed();

    let literal = select! {
        Kind::Number = e => number(e),
        Kind::Str = e => string(e),
        Kind::True = e => push(e, ExprKind::Bool(true)),
        Kind::False = e => push(e, ExprKind::Bool(false)),
        Kind::Objects = e => push(e, ExprKind::Objects),
    };
    let named = just(Kind::Ident).map_with(|_, e| word(e)).then(arguments.clone().or_not());
    let named = named.map_with(|(name, args), e| match args {
        Some(args) => push(e, ExprKind::Call(name, args)),
        None => push(e, ExprKind::Name(name.text)),
    });
    let call = constructor().map_with(|_, e| word(e)).then(arguments);
    let call = call.map_with(|(name, args), e| push(e, ExprKind::Call(name, args)));
    let own = just(Kind::Dot).ignore_then(property()).map_with(|name, e| push(e, ExprKind::Own(name)));
    let count = binding(formula.clone()).delimited_by(just(Kind::LParen), just(Kind::RParen));
    let count = just(Kind::Count)
        .ignore_then(count)
        .map_with(|(name, domain, body), e| push(e, ExprKind::Quantified(Quantifier::Count, name, domain, body)));
    let parenthesised = formula.clone().delimited_by(just(Kind::LParen), just(Kind::RParen));
    let atom = choice((literal, named, call, own, count, parenthesised)).labelled(Wanted::VALUE);

    enum Suffix {
        Member(Name),
        Index(ExprId),
    }
    let member = just(Kind::Dot).ignore_then(property()).map(Suffix::Member);
    let index = formula.delimited_by(just(Kind::LBracket), just(Kind::RBracket)).map(Suffix::Index);
    atom.foldl_with(choice((member, index)).repeated(), |base, suffix, e| match suffix {
        Suffix::Member(name) => push(e, ExprKind::Member(base, name)),
        Suffix::Index(index) => push(e, ExprKind::Index(base, index)),
    })
}

/// `x in S: φ`
fn binding<'t>(
    formula: impl Parser<'t, &'t [Kind], ExprId, Extra<'t>> + Clone,
) -> impl Parser<'t, &'t [Kind], (Name, ExprId, ExprId), Extra<'t>> + Clone {
    let name = just(Kind::Ident).map_with(|_, e| word(e)).labelled(Wanted::NAME);
    let domain = just(Kind::In).ignore_then(formula.clone());
    let body = just(Kind::Colon).ignore_then(formula);
    name.then(domain).then(body).map(|((name, domain), body)| (name, domain, body))
}

fn property<'t>() -> impl Parser<'t, &'t [Kind], Name, Extra<'t>> + Clone {
    just(Kind::Ident).map_with(|_, e| word(e)).labelled(Wanted::PROPERTY)
}

/// Reserved words that are called like functions.
fn constructor<'t>() -> impl Parser<'t, &'t [Kind], Kind, Extra<'t>> + Clone {
    one_of([Kind::Inside, Kind::Rand, Kind::Vec3, Kind::Rot, Kind::DotWord])
}

/// A name that a predicate could have, the reserved ones included: redefining them is told elsewhere.
fn callee<'t>() -> impl Parser<'t, &'t [Kind], Kind, Extra<'t>> + Clone {
    just(Kind::Ident).or(constructor())
}

fn type_word<'t>() -> impl Parser<'t, &'t [Kind], (TypeWord, TextRange), Extra<'t>> + Clone {
    let word = select! {
        Kind::Object | Kind::Entity => TypeWord::Object,
        Kind::Region => TypeWord::Region,
        Kind::NumberType => TypeWord::Number,
        Kind::Degree => TypeWord::Degree,
        Kind::Bool => TypeWord::Bool,
        Kind::Vector3 => TypeWord::Vector3,
        Kind::Rotation => TypeWord::Rotation,
        Kind::Color => TypeWord::Color,
        Kind::Material => TypeWord::Material,
    };
    word.map_with(|word, e| (word, range(e))).labelled(Wanted::TYPE)
}

fn parameter_type<'t>() -> impl Parser<'t, &'t [Kind], (TypeWord, TextRange), Extra<'t>> + Clone {
    let word = select! {
        Kind::NumberType => TypeWord::Number,
        Kind::Degree => TypeWord::Degree,
        Kind::Bool => TypeWord::Bool,
        Kind::Vector3 => TypeWord::Vector3,
        Kind::Rotation => TypeWord::Rotation,
        Kind::Color => TypeWord::Color,
        Kind::Material => TypeWord::Material,
        Kind::ParamType = e => match slice(e) {
            "Object" => TypeWord::Object,
            "Region" => TypeWord::Region,
            "Objects" => TypeWord::Objects,
            _ => TypeWord::String,
        },
    };
    word.map_with(|word, e| (word, range(e))).labelled(Wanted::TYPE)
}

type Extras<'t, 'b> = chumsky::input::MapExtra<'t, 'b, &'t [Kind], Extra<'t>>;

fn range(e: &mut Extras<'_, '_>) -> TextRange {
    let span = e.span();
    e.state().range(span)
}

fn word(e: &mut Extras<'_, '_>) -> Name {
    let span = e.span();
    e.state().name(span)
}

fn slice<'t>(e: &mut Extras<'t, '_>) -> &'t str {
    let span = e.span();
    e.state().slice(span)
}

fn text(e: &mut Extras<'_, '_>) -> String {
    let span = e.span();
    e.state().string(span)
}

fn string(e: &mut Extras<'_, '_>) -> ExprId {
    let span = e.span();
    e.state().push_string(span)
}

fn number(e: &mut Extras<'_, '_>) -> ExprId {
    let span = e.span();
    e.state().push_number(span)
}

fn push(e: &mut Extras<'_, '_>, kind: ExprKind) -> ExprId {
    let span = e.span();
    e.state().push(span, kind)
}
