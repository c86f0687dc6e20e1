//! Requests that mean the same say the same, whatever their words: pairs made of phrases, each held against its twin.

use scenelang_formalize::{Draft, Options, as_said, read};

/// How many pairs of each kind.
const CASES: usize = 500;

const FURNITURE: [&str; 16] = [
    "sofa",
    "wardrobe",
    "bookcase",
    "piano",
    "fridge",
    "stove",
    "dresser",
    "bench",
    "armchair",
    "cabinet",
    "fireplace",
    "washing machine",
    "workbench",
    "sideboard",
    "locker",
    "bathtub",
];

/// A choice that is the same each time.
struct Dice(u64);

impl Dice {
    fn upto(&mut self, n: usize) -> usize {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) as usize % n
    }

    /// So many different pieces of furniture.
    fn furniture<const N: usize>(&mut self) -> [&'static str; N] {
        let mut all = FURNITURE.to_vec();
        std::array::from_fn(|_| all.remove(self.upto(all.len())))
    }
}

/// What a request says: things and statements, in no order.
fn meaning(request: &str) -> Vec<String> {
    lines(&as_said(request))
}

/// What is left of it once the prover has looked at it.
fn proved(request: &str) -> Vec<String> {
    lines(&read(request, &Options { literal: true }).draft)
}

fn lines(draft: &Draft) -> Vec<String> {
    let things = draft.things.iter().map(|t| format!("{} {} {:?}", t.count, t.name, t.size));
    let mut out: Vec<String> = things.chain(draft.statements.iter().map(|s| s.line())).collect();
    out.sort();
    out
}

/// That two requests say the same, and, in each twentieth case, that the prover leaves the same of them.
fn same(case: usize, a: &str, b: &str) {
    assert_eq!(meaning(a), meaning(b), "\n{a}\n{b}");
    if case.is_multiple_of(20) {
        assert_eq!(proved(a), proved(b), "\n{a}\n{b}");
    }
}

#[test]
fn digits_and_words() {
    const WORDS: [&str; 19] = [
        "two",
        "three",
        "four",
        "five",
        "six",
        "seven",
        "eight",
        "nine",
        "ten",
        "eleven",
        "twelve",
        "thirteen",
        "fourteen",
        "fifteen",
        "sixteen",
        "seventeen",
        "eighteen",
        "nineteen",
        "twenty",
    ];
    let mut dice = Dice(1);
    for case in 0..CASES {
        let (i, k, [a]) = (dice.upto(WORDS.len()), dice.upto(5), dice.furniture());
        let request = |n: &str, k: &str| {
            format!("A hall with {n} stools and a {a}. Keep at least {k} metres between the {a} and the stools.")
        };
        same(case, &request(WORDS[i], WORDS[k]), &request(&(i + 2).to_string(), &(k + 2).to_string()));
    }
}

#[test]
fn feet_and_metres() {
    let mut dice = Dice(2);
    for case in 0..CASES {
        let (n, m, [a, b]) = (2 + dice.upto(20), 20 + dice.upto(20), dice.furniture());
        let request = |far: &str, wide: &str| {
            format!("A room, {wide} by {wide}. A {a} and a {b}. The {a} is at least {far} from the {b}.")
        };
        let metres = |feet: usize| format!("{} m", (feet as f64 * 3048.0).round() / 10_000.0);
        let feet = |n: usize| format!("{n} {}", ["ft", "feet"][n % 2]);
        same(case, &request(&feet(n), &feet(m)), &request(&metres(n), &metres(m)));
    }
}

/// "a three-metre-long bench" is "a 3 m long bench", and one bench.
#[test]
fn units_with_hyphens() {
    const WORDS: [&str; 5] = ["two", "three", "four", "five", "six"];
    let mut dice = Dice(9);
    for case in 0..CASES {
        let (k, [a, b]) = (dice.upto(WORDS.len()), dice.furniture());
        let side = ["long", "wide", "deep", "high"][dice.upto(4)];
        let unit = ["metre", "foot"][dice.upto(2)];
        let of = |size: String| format!("A hall with a {size} {a} and a {b}.");
        let plain = of(format!("{} {unit} {side}", k + 2));
        let number = [WORDS[k].to_owned(), (k + 2).to_string()][dice.upto(2)].clone();
        same(case, &of(format!("{number}-{unit}-{side}")), &plain);
    }
}

#[test]
fn left_and_right_in_a_mirror() {
    let swapped = |text: &str, [a, b]: [&str; 2]| text.replace(a, "\u{1}").replace(b, a).replace('\u{1}', b);
    let mut dice = Dice(3);
    for _ in 0..CASES {
        let ([a, b, c], side) = (dice.furniture(), dice.upto(3));
        let request = match side {
            0 => {
                format!("A {a}, a {b} and a {c}. The {a} stands to the left of the {b}. The {c} is to the right of it.")
            }
            1 => format!("A {a} and a {b}. To the right of the {a} stands the {b}. A {c} is left of the {a}."),
            _ => format!("There is a {a} on the left of the {b}, and a {c} to the right of the {a}."),
        };
        let turned = swapped(&request, ["left", "right"]);
        let mut want: Vec<String> =
            meaning(&request).iter().map(|s| swapped(s, ["seenLeftOf", "seenRightOf"])).collect();
        want.sort();
        assert_eq!(meaning(&turned), want, "\n{request}\n{turned}");
    }
}

#[test]
fn the_order_of_sentences() {
    let mut dice = Dice(4);
    for case in 0..CASES {
        let [a, b, c, d, e, f] = dice.furniture();
        let mut sentences = [
            format!("There is a {a} next to a {b}."),
            format!("A {c} stands against the wall."),
            format!("A {d} is near a {e}."),
            format!("There is a {f} in the corner."),
        ];
        let first = sentences.join(" ");
        for i in (1..sentences.len()).rev() {
            sentences.swap(i, dice.upto(i + 1));
        }
        same(case, &first, &sentences.join(" "));
    }
}

#[test]
fn active_and_passive() {
    let mut dice = Dice(5);
    for case in 0..CASES {
        let ([a, b], kind) = (dice.furniture(), dice.upto(3));
        let n = 2 + dice.upto(6);
        let (active, passive) = match kind {
            0 => (format!("Two lamps flank the {a}."), format!("The {a} is flanked by two lamps.")),
            1 => (format!("{n} stools surround the {a}."), format!("The {a} is surrounded by {n} stools.")),
            _ => (format!("The {a} faces the {b}."), format!("The {a} is facing the {b}.")),
        };
        let setting = format!("A room with a {a} and a {b}. ");
        same(case, &(setting.clone() + &active), &(setting + &passive));
    }
}

#[test]
fn synonyms() {
    const PAIRS: [(&str, &str); 7] = [
        ("next to", "beside"),
        ("close to", "near"),
        ("across from", "opposite"),
        ("underneath", "beneath"),
        ("to the left of", "left of"),
        ("to the right of", "right of"),
        ("in back of", "behind"),
    ];
    let mut dice = Dice(6);
    for case in 0..CASES {
        let ([a, b], (one, other)) = (dice.furniture(), PAIRS[dice.upto(PAIRS.len())]);
        let request = |relation: &str| format!("A room with a {b}. A {a} stands {relation} the {b}.");
        same(case, &request(one), &request(other));
    }
}

#[test]
fn what_has_nothing_to_do_with_it_changes_nothing() {
    const CHATTER: [&str; 6] = [
        "The atmosphere is calm.",
        "Thank you very much!",
        "We like the evening.",
        "Everyone likes the colours.",
        "My uncle had the idea.",
        "The budget is small.",
    ];
    let mut dice = Dice(7);
    for case in 0..CASES {
        let ([a, b, c], chatter) = (dice.furniture(), CHATTER[dice.upto(CHATTER.len())]);
        let sentences = [
            format!("There is a {a} next to a {b}."),
            format!("A {c} stands against the wall."),
            format!("The {a} faces the {c}."),
        ];
        let mut more: Vec<&str> = sentences.iter().map(String::as_str).collect();
        more.insert(dice.upto(4), chatter);
        same(case, &sentences.join(" "), &more.join(" "));
    }
}

/// "X within d of every Y" is "every Y within d of X"; each is said of all of them.
#[test]
fn every_one_of_them() {
    let mut dice = Dice(8);
    for _ in 0..CASES {
        let ([a], n, d) = (dice.furniture(), 2 + dice.upto(8), 1 + dice.upto(4));
        let every = ["every", "each"][dice.upto(2)];
        let setting = format!("A hall with {n} desks and a {a}. ");
        let of_every = meaning(&format!("{setting}The {a} is within {d} m of {every} desk."));
        let by_one = meaning(&format!("{setting}Every desk is within {d} m of the {a}."));
        let near = |list: &[String]| list.iter().filter(|s| s.contains("near(")).cloned().collect::<Vec<_>>();
        let (of_every, by_one) = (near(&of_every), near(&by_one));
        assert!(of_every.len() == 1 && of_every[0].contains("forall b in desk: near("), "{of_every:?}");
        assert!(by_one.len() == 1 && by_one[0].contains("forall a in desk: near("), "{by_one:?}");
    }
}
