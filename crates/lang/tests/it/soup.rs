//! Random programs for property tests: right ones, and soup of their words.

use proptest::prelude::*;
use proptest::strategy::Union;

/// A formula or value that parses, in random spellings.
fn expression() -> impl Strategy<Value = String> {
    let words = [
        "a",
        "b.pos.x",
        "chair[1]",
        "30cm",
        ".5",
        "5.",
        "1e3",
        "\"red\"",
        "true",
        "objects",
        "objects.pos",
        "weight",
        "lámpara.top",
        "écran(a)",
    ];
    let leaf = prop::sample::select(words.to_vec()).prop_map(str::to_owned);
    leaf.prop_recursive(6, 40, 4, |inner| {
        let infix = ["and", "or", "&&", "∨", "implies", "=", "==", "!=", "<", "≤", ">=", "+", "-", "*", "/", "<-"];
        let infix = prop::sample::select(infix.to_vec());
        let call = prop::collection::vec(inner.clone(), 0..4);
        Union::new_weighted(vec![
            (6, (inner.clone(), infix, inner.clone()).prop_map(|(a, op, b)| format!("({a}) {op} ({b})")).boxed()),
            (3, (inner.clone(), inner.clone()).prop_map(|(a, b)| format!("({a}) and ({b}) and ({a})")).boxed()),
            (2, inner.clone().prop_map(|a| format!("not ({a})")).boxed()),
            (1, inner.clone().prop_map(|a| format!("-({a})")).boxed()),
            (3, call.prop_map(|args| format!("near({})", args.join(","))).boxed()),
            (1, inner.clone().prop_map(|a| format!("vec3(0,-1,{a})")).boxed()),
            (
                2,
                (inner.clone(), inner.clone())
                    .prop_map(|(s, f)| format!("(forall x in ({s}) where ({f}): {f})"))
                    .boxed(),
            ),
            (1, inner.clone().prop_map(|f| format!("exists in in 0..5: {f}")).boxed()),
            (1, inner.prop_map(|f| format!("count(c in chair where .color = \"red\": {f}) >= 2")).boxed()),
        ])
    })
}

/// Words of one statement that parses, without its `;`.
fn statement() -> impl Strategy<Value = String> {
    let plain = [
        "object a",
        "entity chair[6]",
        "region room",
        "Number weight",
        "allowCollide(a, b)",
        "allowFloat(a)",
        "import \"x.scene\"",
    ];
    let sentence = prop::sample::select(vec!["", "", "", "@req(\"one\") ", "///doc\n"]);
    let body = Union::new_weighted(vec![
        (3, prop::sample::select(plain.to_vec()).prop_map(str::to_owned).boxed()),
        (4, expression().prop_map(|e| format!("assert {e}")).boxed()),
        (2, expression().prop_map(|e| format!("prefer {e} weight 2")).boxed()),
        (2, expression().prop_map(|e| format!("chair[1].color ← {e}")).boxed()),
        (2, expression().prop_map(|e| format!("predicate near(Object a,Region r) := {e}")).boxed()),
    ]);
    (sentence, body).prop_map(|(sentence, body)| format!("{sentence}{body}"))
}

/// Blanks and comments between words.
fn trivia() -> impl Strategy<Value = &'static str> {
    let all = [
        " ",
        " ",
        " ",
        " ",
        " ",
        " ",
        "\n",
        "  \t",
        "\r\n",
        "\n\n\n",
        " // line\n",
        "\n// own line\n",
        " /* in */ ",
        " /* two\n lines */ ",
        "\n/* own */ ",
        " /// doc\n",
        "\n/// doc\n",
        "\r",
    ];
    prop::sample::select(all.to_vec())
}

/// A program that parses, with comments and line ends anywhere.
pub fn program() -> impl Strategy<Value = String> {
    prop::collection::vec((trivia(), statement(), prop::collection::vec(trivia(), 12)), 0..6).prop_map(|statements| {
        let mut text = String::new();
        for (before, statement, between) in statements {
            text.push_str(before);
            // Comments go where blanks are; those inside quotation marks are left alone.
            let mut quoted = false;
            let mut blanks = between.iter().cycle();
            for c in statement.chars() {
                quoted ^= c == '"';
                match c {
                    ' ' if !quoted => text.push_str(blanks.next().copied().unwrap_or(" ")),
                    c => text.push(c),
                }
            }
            text.push_str(between[0]);
            text.push(';');
        }
        text
    })
}

/// Words in any order.
pub fn soup() -> impl Strategy<Value = String> {
    let words = [
        "object",
        "region",
        "assert",
        "prefer",
        "weight",
        "predicate",
        "import",
        "allowFloat",
        "allowCollide",
        "Number",
        "forall",
        "exists",
        "count",
        "in",
        "where",
        "implies",
        "objects",
        "and",
        "not",
        "a",
        "b",
        "chair",
        "1",
        "2.5cm",
        "3kg",
        "1e999",
        "0..5",
        "\"red\"",
        "\"open",
        "“x”",
        "'y'",
        "(",
        ")",
        "[",
        "]",
        ",",
        ";",
        ";",
        ";",
        ":",
        ":=",
        "<-",
        "←",
        "=",
        "=>",
        "<",
        "-",
        "+",
        "*",
        ".",
        "pos",
        "rot",
        "@req(\"x\")",
        "@req",
        "@",
        "#",
        "{",
        "}",
        "\u{200b}",
        "\n",
        "\n",
        "// c\n",
        "/// d\n",
        "/*",
        "*/",
        "/* c */",
        "\u{feff}",
        "\r\n",
    ];
    let word = prop::sample::select(words.to_vec());
    prop::collection::vec((word, prop::bool::weighted(0.8)), 0..60).prop_map(|words| {
        words.into_iter().map(|(w, blank)| if blank { format!("{w} ") } else { w.to_owned() }).collect()
    })
}
