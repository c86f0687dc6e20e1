//! The search: the score against a plain reference, and catalogues with known best answers.

use crate::made::{block, write};
use scenelang_assets::{family_of, words};
use scenelang_catalogue::{B, Catalogue, Entry, Index, K1, size_factor};
use scenelang_layout::Vec3;
use serde_json::{Value, json};
use tempfile::{TempDir, tempdir};

/// A folder with a model of one box for each card, of the size that it says.
fn shop(cards: &[Value]) -> (TempDir, Catalogue) {
    let folder = tempdir().unwrap();
    for (i, card) in cards.iter().enumerate() {
        let [w, h, d] = [0, 1, 2].map(|axis: usize| card["size"][axis].as_f64().unwrap_or(1.0) as f32);
        write(folder.path(), &format!("m{i:04}.glb"), &block(w, h, d).glb(), card);
    }
    let catalogue = Catalogue::open(folder.path()).unwrap();
    assert!(catalogue.refused.is_empty(), "{:?}", catalogue.refused);
    (folder, catalogue)
}

/// The furniture shop of these tests.
fn furniture() -> Vec<Value> {
    let card = |category: &str, description: &str, materials: &[&str], size: [f64; 3]| {
        json!({ "category": category, "description": description, "materials": materials, "size": size,
                "synset": format!("{}.n.01", category.replace(' ', "_")) })
    };
    vec![
        card("chair", "a plain wooden kitchen chair with four legs", &["oak"], [0.45, 0.9, 0.5]),
        card("office chair", "swivel chair with armrests and castors", &["mesh", "plastic"], [0.65, 1.1, 0.65]),
        card("couch", "three seats, low back", &["leather"], [2.1, 0.8, 0.9]),
        card("table", "dining table for six chairs", &["oak"], [1.8, 0.75, 0.9]),
        card("coffee table", "low round table", &["glass", "steel"], [0.8, 0.4, 0.8]),
        card("table", "small side table", &["oak"], [0.45, 0.55, 0.45]),
        card("desk lamp", "reading lamp with a green shade", &["brass"], [0.2, 0.45, 0.2]),
        card("bookcase", "five shelves", &["pine"], [0.9, 1.9, 0.3]),
    ]
}

/// The score as the book has it, from the texts alone.
fn reference(entries: &[Entry], query: &str, wanted: Option<Vec3>) -> Vec<(usize, f64)> {
    let empty = [
        "a", "an", "and", "as", "at", "by", "for", "from", "in", "is", "it", "of", "on", "or", "some", "that", "the",
        "this", "to", "with",
    ];
    let terms = |text: &str, named: &str| -> Vec<String> {
        let mut all: Vec<String> = words(text).into_iter().filter(|w| !empty.contains(&w.as_str())).collect();
        all.extend(family_of(named, "").map(|f| format!("family:{f}")));
        all
    };
    let documents: Vec<Vec<String>> = entries
        .iter()
        .map(|e| {
            let c = &e.card;
            let synset = c.synset.split('.').next().unwrap();
            terms(&format!("{}. {}. {}. {}", c.category, c.description, synset, c.materials.join(" ")), &c.category)
        })
        .collect();
    let n = documents.len() as f64;
    let mean = documents.iter().map(|d| d.len() as f64).sum::<f64>() / n;
    let mut asked = terms(query, query);
    asked.sort();
    asked.dedup();
    let mut out = Vec::new();
    for (i, document) in documents.iter().enumerate() {
        let mut score = 0.0;
        for term in &asked {
            let with = documents.iter().filter(|d| d.contains(term)).count() as f64;
            let often = document.iter().filter(|t| *t == term).count() as f64;
            let rarity = (1.0 + (n - with + 0.5) / (with + 0.5)).ln();
            score += rarity * often * (K1 + 1.0) / (often + K1 * (1.0 - B + B * document.len() as f64 / mean));
        }
        if let Some(w) = wanted {
            let s = entries[i].size.unwrap();
            let d = ((s.y / w.y).ln().abs()
                + (s.x.max(s.z) / w.x.max(w.z)).ln().abs()
                + (s.x.min(s.z) / w.x.min(w.z)).ln().abs())
                / 3.0;
            score /= 1.0 + d;
        }
        if score > 0.0 {
            out.push((i, score));
        }
    }
    out.sort_by(|a, b| b.1.total_cmp(&a.1));
    out
}

#[test]
fn the_score_is_that_of_a_plain_reference() {
    let (_folder, catalogue) = shop(&furniture());
    let index = Index::of(&catalogue.entries);
    let sizes = [None, Some(Vec3::new(0.5, 0.5, 0.5)), Some(Vec3::new(0.9, 0.75, 1.8))];
    for query in ["chair", "oak table", "sofa", "reading lamps", "a table for six chairs", "round glass table", "zebra"]
    {
        for wanted in sizes {
            let found = index.search(query, wanted, usize::MAX);
            let plain = reference(&catalogue.entries, query, wanted);
            assert_eq!(found.len(), plain.len(), "{query}");
            for (hit, (entry, score)) in found.iter().zip(plain) {
                assert!(hit.entry == entry && (hit.score - score).abs() < 1e-5, "{query}: {hit:?} {entry} {score}");
            }
        }
    }
}

#[test]
fn the_best_answer_is_the_expected_one() {
    let (_folder, catalogue) = shop(&furniture());
    let index = Index::of(&catalogue.entries);
    let best = |query: &str, wanted: Option<[f64; 3]>| {
        let hits = index.search(query, wanted.map(Vec3::from), 3);
        hits.first().map(|hit| hit.entry)
    };
    for (query, wanted, entry) in [
        ("chair", None, Some(0)),
        ("wooden chairs", None, Some(0)),
        ("office chair", None, Some(1)),
        ("sofa", None, Some(2)),
        ("table", Some([1.8, 0.75, 0.9]), Some(3)),
        ("table", Some([0.9, 0.75, 1.8]), Some(3)),
        ("table", Some([0.4, 0.5, 0.4]), Some(5)),
        ("coffee table", None, Some(4)),
        ("bookshelf", None, Some(7)),
        ("green reading lamp", None, Some(6)),
        ("submarine", None, None),
        ("", None, None),
        ("the of a", None, None),
    ] {
        assert_eq!(best(query, wanted), entry, "{query} {wanted:?}");
    }
}

#[test]
fn two_thousand_models_are_each_found_by_what_is_said_of_them() {
    let kinds = ["chair", "table", "sofa", "bookshelf", "floor lamp", "bed", "wardrobe", "desk", "rug", "mirror"];
    let colours = ["red", "green", "blue", "yellow", "black", "white", "brown", "gray", "pink", "orange"];
    let stuffs = ["oak", "walnut", "steel", "brass", "leather"];
    let styles = ["rustic", "modern", "baroque", "nordic"];
    let mut cards = Vec::new();
    let mut asked = Vec::new();
    for kind in kinds {
        for colour in colours {
            for stuff in stuffs {
                for style in styles {
                    cards.push(json!({ "category": kind, "description": format!("a {style} {colour} {kind}"), "materials": stuff }));
                    asked.push(format!("{style} {kind} of {colour} {stuff}"));
                }
            }
        }
    }
    let (_folder, catalogue) = shop(&cards);
    let index = Index::of(&catalogue.entries);
    let right = asked.iter().enumerate().filter(|(i, query)| index.search(query, None, 1)[0].entry == *i).count();
    assert_eq!((right, asked.len()), (2000, 2000), "recall at 1");
}

#[test]
fn equal_models_come_in_the_order_of_their_names() {
    let card = json!({ "category": "stool" });
    let (_folder, catalogue) = shop(&[card.clone(), card.clone(), card]);
    let hits = Index::of(&catalogue.entries).search("stool", None, 2);
    assert_eq!(hits.iter().map(|h| h.entry).collect::<Vec<_>>(), [0, 1]);
    assert_eq!(Index::of(&[]).search("stool", None, 2), []);
}

#[test]
fn a_size_that_differs_costs_score() {
    let wanted = Vec3::new(1.0, 2.0, 3.0);
    assert_eq!(size_factor(Some(wanted), &wanted), 1.0);
    assert_eq!(size_factor(Some(Vec3::new(3.0, 2.0, 1.0)), &wanted), 1.0);
    assert!((size_factor(Some(wanted * 2.0), &wanted) - size_factor(None, &wanted)).abs() < 1e-12);
    assert!(size_factor(Some(wanted * 4.0), &wanted) < size_factor(Some(wanted / 2.0), &wanted));
}
