//! Coherence of pictures, with a model that answers by a script.

use scenelang_eval::coherence::{descriptions, rate};
use scenelang_eval::correctness::compiled;
use scenelang_eval::dataset::scene;
use scenelang_eval::resemblance::Lexical;
use scenelang_eval::suite::{Figures, Means, Suite, page};
use scenelang_layout::Layout;
use scenelang_llm::{Error, Image, Model, Reply, Request, Usage};
use scenelang_solve::Stop;

/// Answers from a list, the last one first, and keeps what it was asked.
struct Script(Vec<String>, Vec<Request>);

impl Model for Script {
    fn name(&self) -> &str {
        "scripted"
    }
    fn ask(&mut self, request: &Request) -> Result<Reply, Error> {
        self.1.push(request.clone());
        let text = self.0.pop().unwrap_or_default();
        Ok(Reply { text, usage: Usage::default() })
    }
}

fn scores(list: &[f64]) -> Script {
    Script(list.iter().rev().map(|score| format!("{{\"score\": {score}}}")).collect(), Vec::new())
}

fn picture() -> Image {
    Image { media: "image/png".to_owned(), base64: "AAAA".to_owned() }
}

#[test]
fn the_better_of_two_answers_counts_for_each_text() {
    let scene = scene(7, 0);
    let mut model = scores(&[20.0, 35.5, 60.0, 40.0]);
    assert_eq!(rate(&mut model, &scene, &picture()).unwrap(), [35.5, 60.0]);
    let texts: Vec<String> = descriptions(&scene).concat();
    assert!(texts[0] == scene.request && texts[1].starts_with("a top-down view of ") && texts[2] == scene.sentence);
    for (asked, text) in model.1.iter().zip(&texts) {
        let shown = &asked.messages[1];
        assert_eq!((shown.images.as_slice(), asked.temperature), (&[picture()][..], Some(0.0)));
        let told: serde_json::Value = serde_json::from_str(&shown.text).unwrap();
        assert_eq!(told["description"], text.as_str());
    }
    // No score is beyond its range, and an answer without one is an error, after a second try.
    assert_eq!(rate(&mut scores(&[-3.0, 0.0, 250.0, 1.0]), &scene, &picture()).unwrap(), [0.0, 100.0]);
    assert!(
        rate(&mut Script(vec!["good".to_owned(), "very good".to_owned()], Vec::new()), &scene, &picture()).is_err()
    );
}

#[test]
fn a_suite_has_it_where_pictures_are_drawn() {
    let suite: Suite =
        scenelang_eval::suite::parse(r#"{"format": "scenelang.suite/1", "name": "one", "scenes": 1, "seed": 7}"#)
            .unwrap();
    let reader = |_: &str| String::new();
    let stop = Stop::default();
    let objects = compiled(&scene(7, 0).program).unwrap().objects.len();
    let draw = |_: &_, layout: &Layout| {
        assert_eq!(layout.objects.len(), objects);
        Ok(picture())
    };
    let mut means = Means { reader: &reader, similarity: &Lexical, draw: Some(&draw), stop: &stop };
    let script =
        || Script([vec!["{\"score\": 30}".to_owned(); 4], vec!["{\"objects\": []}".to_owned()]].concat(), Vec::new());
    let case = suite.case(0, &means, Some(&mut script())).unwrap().unwrap();
    assert_eq!(case.coherence, Some([30.0, 30.0]));
    let figures = Figures::of("one", std::slice::from_ref(&case));
    assert_eq!(figures.coherence, Some([30.0, 30.0]));
    let text = page(&figures, std::slice::from_ref(&case)).markdown("images");
    assert!(text.contains("| ours | 30.0 | 30.0 |") && text.contains("| published: GPT-4o | 28.3 | 44.8 |"), "{text}");
    // With pictures it is another measurement.
    let with = suite.key(0, &means, Some("m"));
    means.draw = None;
    assert_ne!(with, suite.key(0, &means, Some("m")));
    let case = suite.case(0, &means, Some(&mut script())).unwrap().unwrap();
    assert_eq!(case.coherence, None);
    assert!(!page(&Figures::of("one", &[case]), &[]).markdown("images").contains("Coherence"));
}
