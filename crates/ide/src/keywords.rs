//! What the words of the language say, in a sentence each: for who points at one.

/// Words with what they say and how they are written; `@req` is a word, too.
const WORDS: &[(&str, &str, &str)] = &[
    ("object", "declares an object or, with a number, an array of objects", "object chair[4];"),
    ("region", "declares a region: a room, or part of one, or a place outdoors", "region kitchen;"),
    ("assert", "states what must hold in every layout", "assert near(chair, desk, 0.5);"),
    ("prefer", "states a preference: it is met as far as the assertions allow", "prefer bed.pos.x > 1 weight 2;"),
    (
        "weight",
        "sets how much a preference counts compared with others; 1 by default",
        "prefer near(a, b, 1) weight 3;",
    ),
    ("predicate", "gives a condition a name and parameters", "predicate low(Object a) := a.top < 0.5;"),
    (
        "import",
        "reads another program, whose declarations and predicates can then be used here",
        "import \"parts.scene\";",
    ),
    ("allowCollide", "lifts the rule that two objects, or arrays, may not overlap", "allowCollide(rug, table);"),
    ("allowOutside", "lifts the rule that an object must be inside a region", "allowOutside(tree);"),
    ("allowFloat", "lifts the rule that something must support an object", "allowFloat(balloon);"),
    (
        "forall",
        "holds if the condition after the colon holds for each element",
        "forall c in chair: near(c, table, 0.5)",
    ),
    (
        "exists",
        "holds if the condition after the colon holds for at least one element",
        "exists c in chair: near(c, door, 1)",
    ),
    ("count", "is the number of elements for which the condition holds", "count(c in chair: near(c, table, 0.5)) >= 3"),
    (
        "in",
        "names the set that a quantifier ranges over: an array, `objects` or `rooms`",
        "forall c in chair: c.top < 1",
    ),
    (
        "where",
        "keeps the elements of a set that have a property",
        "forall o in objects where .category = \"chair\": o.top < 1",
    ),
    ("and", "holds if both sides hold; its margin is the smaller of the two", "near(a, b, 1) and a.top < b.top"),
    ("or", "holds if one side holds; its margin is the larger of the two", "near(a, b, 1) or near(a, c, 1)"),
    ("not", "holds if the condition does not; its margin has the opposite sign", "not near(a, b, 1)"),
    ("implies", "holds if the left side does not hold or the right side does", "near(a, b, 1) implies facing(a, b)"),
    ("objects", "all objects of the program, including elements of arrays", "forall o in objects: o.top < 2"),
    (
        "@req",
        "names the requirement that the next statement implements, in the words of the request",
        "@req(\"a desk by the window\")",
    ),
    ("Number", "declares a number that the layout chooses, unless one is assigned", "Number space;"),
    ("Degree", "declares an angle in degrees that the layout chooses, unless one is assigned", "Degree turn;"),
    ("Bool", "declares a truth value that the layout chooses, unless one is assigned", "Bool open;"),
    ("Vector3", "declares a vector that the layout chooses, unless one is assigned", "Vector3 spot;"),
    ("Rotation", "declares a rotation that the layout chooses, unless one is assigned", "Rotation turn;"),
    ("Color", "declares a colour that can be given to several objects", "Color accent;"),
    ("Material", "declares a material that can be given to several objects", "Material wood;"),
    ("true", "the condition that always holds", "true"),
    ("false", "the condition that never holds", "false"),
];

/// What a word of the language says: how it is written, and a sentence.
pub fn says(word: &str) -> Option<String> {
    let (_, says, example) = WORDS.iter().find(|(known, ..)| *known == word)?;
    Some(format!("```scene\n{example}\n```\n\n`{word}` {says}"))
}

/// All keywords that have such a sentence.
pub fn all() -> impl Iterator<Item = &'static str> {
    WORDS.iter().map(|(word, ..)| *word)
}

#[cfg(test)]
mod tests {
    use super::*;
    use scenelang_lang::token::{Kind, lex};

    #[test]
    fn each_word_is_one_of_the_language() {
        for (word, _, example) in WORDS {
            let tokens = lex(word);
            let kinds: Vec<Kind> = tokens.iter().map(|t| t.kind).collect();
            assert!(kinds.len() == 1 && kinds[0] != Kind::BadAttribute, "{word}: {kinds:?}");
            assert!(example.contains(word), "{word}: {example}");
        }
    }
}
