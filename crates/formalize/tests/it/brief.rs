//! The brief as a document: what is read from it is what was written, and what is wrong with it is said with its place.

use crate::support::requests;
use scenelang_formalize::brief::json;
use scenelang_formalize::write::write;
use scenelang_formalize::{Options, of_brief, read, read_brief};

#[test]
fn every_request_goes_through_its_brief() {
    for (at, request) in requests().into_iter().enumerate() {
        let brief = read_brief(&request);
        let again = json::read(&json::write(&brief)).unwrap();
        assert_eq!(again, brief, "{request}");
        // The briefs are the same, so that of a few requests all is compared that comes of them.
        for literal in [true, false].into_iter().filter(|_| at % 4 == 0) {
            let options = Options { literal };
            let (direct, through) = (read(&request, &options), of_brief(again.clone(), &options));
            assert_eq!(write(&through.draft), write(&direct.draft), "{request}");
            assert_eq!((through.read, through.words), (direct.read, direct.words), "{request}");
        }
    }
}

/// What is put in place of what, and what is said of it.
#[test]
fn what_is_wrong_is_said_with_its_place() {
    let request = "A study with two desks, a lamp on each desk, and a sofa. The first desk is near the sofa.";
    let good = json::write(&read_brief(request));
    assert!(json::read(&good).is_ok());
    for (from, to, want) in [
        ("\"noun\"", "\"nuon\"", "unknown field `nuon`"),
        ("\"noun\"", "\"nuon\"", " at line "),
        ("scenelang.brief/1", "scenelang.brief/2", "format: expected \"scenelang.brief/1\""),
        ("\"relation\": \"near\"", "\"relation\": \"nigh\"", "unknown variant `nigh`"),
        ("\"id\": \"sofa\"", "\"id\": \"couch\"", "there is no thing \"sofa\""),
        ("\"id\": \"sofa\"", "\"id\": \"lamp\"", "things[2].id: \"lamp\" is already the name of things[1]"),
        ("\"room\": \"study\"", "\"room\": \"attic\"", "things[0].room: there is no room \"attic\""),
        ("\"head\": 1", "\"head\": 7", "things[0].head: expected 1 to 1"),
        ("\"exactly\": 2", "\"exactly\": -2", "invalid value: integer `-2`"),
        ("\"rooms\": [", "\"rooms\": [],\n\"rooms\": [", "duplicate field `rooms`"),
    ] {
        assert!(good.contains(from), "{from} is not in {good}");
        let why = json::read(&good.replacen(from, to, 1)).unwrap_err();
        assert!(why.contains(want), "{to}: {why}");
    }
    let turned = good.replacen("\"exactly\": 2", "\"each\": { \"of\": \"lamp\", \"number\": 1 }", 1);
    assert!(json::read(&turned).is_ok_and(|brief| brief.count(0) > 0), "two numbers that depend on each other");
    let looped = good.replacen("\"exactly\": 2", "\"each\": { \"of\": \"desk 2\", \"number\": 1 }", 1);
    assert!(json::read(&looped).unwrap_err().contains("it depends on itself"));
    let far = good.replacen("\"bytes\": [\n", "\"bytes\": [\n 9999,", 1);
    assert!(json::read(&far).is_err());
    for text in ["", "{}", "[]", "null", "{\"format\":\"scenelang.brief/1\"}"] {
        assert!(json::read(text).is_err(), "{text}");
    }
}

/// A cooktop is deeper than a small cart: the cart grows, since all of the cooktop is to rest on it.
#[test]
fn what_rests_on_another_fits_there() {
    let request = "A kitchen with a small cart. A portable induction cooktop is on the cart.";
    let draft = read(request, &Options { literal: true }).draft;
    let footprint = |word: &str| {
        let thing = draft.things.iter().find(|thing| thing.category.contains(word)).unwrap();
        let [width, _, depth] = thing.size.unwrap();
        [width.min(depth), width.max(depth)]
    };
    let (cart, cooktop) = (footprint("cart"), footprint("cooktop"));
    assert!((0..2).all(|side| cart[side] >= cooktop[side]), "{cart:?} {cooktop:?}");
}
