//! A session against the scripted server: retries, waits, budgets, the cache, recordings.

use crate::server::{Act, Server};
use crate::{question, remote};
use scenelang_llm::{Account, Budget, Clock, Error, Limits, Model, Price, Replay, Request, Retry, Session, typed};
use serde::Deserialize;
use std::path::Path;
use std::sync::{Arc, Mutex};
use std::time::Duration;

/// A clock that moves only when somebody sleeps, and writes down how long.
#[derive(Clone, Default)]
struct Fake {
    slept: Arc<Mutex<Vec<Duration>>>,
    ended: bool,
}

impl Clock for Fake {
    fn now(&self) -> Duration {
        self.slept.lock().unwrap().iter().sum()
    }
    fn sleep(&mut self, time: Duration) -> bool {
        self.slept.lock().unwrap().push(time);
        !self.ended
    }
}

impl Fake {
    fn seconds(&self) -> Vec<f64> {
        self.slept.lock().unwrap().iter().map(Duration::as_secs_f64).collect()
    }
}

fn session(server: &Server, limits: Limits) -> (Session, Fake) {
    let clock = Fake::default();
    let model = remote("openai:m", &server.url, Some("sk-very-secret"));
    (Session::new(Box::new(model), limits, Box::new(clock.clone())).unwrap(), clock)
}

#[derive(Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
struct Point {
    x: f64,
}

fn good() -> Act {
    Act::says("{\"x\": 1}")
}

#[test]
fn what_passes_is_waited_for() {
    let date = "Sun, 06 Nov 1994 08:49:37 GMT";
    for (script, wanted) in [
        (vec![good()], vec![]),
        (vec![Act::fails(429, "").with("retry-after", "7"), good()], vec![7.0..7.5]),
        (
            vec![Act::fails(503, "").with("Retry-After", "Sun, 06 Nov 1994 08:49:47 GMT").with("date", date), good()],
            vec![10.0..10.5],
        ),
        (vec![Act::fails(429, ""), Act::fails(500, ""), good()], vec![0.5..1.0, 1.0..2.0]),
        (vec![Act::HangUp, Act::HangUp, Act::Broken(b"{".to_vec()), good()], vec![0.5..1.0, 1.0..2.0, 2.0..4.0]),
    ] {
        let shown = format!("{script:?}");
        let n = script.len();
        let server = Server::new(script);
        let (mut session, clock) = session(&server, Limits::default());
        assert_eq!(typed(&mut session, &question()), Ok(Point { x: 1.0 }), "{shown}");
        let slept = clock.seconds();
        assert!(
            slept.len() == wanted.len() && slept.iter().zip(&wanted).all(|(s, w)| w.contains(s)),
            "{shown}: {slept:?}"
        );
        assert_eq!((session.spent().calls, session.spent().again), (n as u64, n as u64 - 1), "{shown}");
    }
}

#[test]
fn patience_has_an_end() {
    let server = Server::new(vec![Act::fails(500, "oops")]);
    let (mut model, clock) = session(&server, Limits::default());
    let error = model.ask(&question()).unwrap_err();
    assert_eq!(error.to_string(), "the provider reports an internal error (500): oops; tried 4 times");
    assert_eq!((clock.seconds().len(), server.asked().len()), (3, 4));
    // A provider that wants to be left alone for an hour is.
    let server = Server::new(vec![Act::fails(429, "later").with("retry-after", "3600")]);
    let (mut model, clock) = session(&server, Limits::default());
    assert!(matches!(model.ask(&question()), Err(Error::Limited { wait: Some(_), .. })));
    assert_eq!((clock.seconds().len(), server.asked().len()), (0, 1));
    // What does not pass is not tried again.
    let server = Server::new(vec![Act::fails(401, "who?")]);
    let (mut model, _) = session(&server, Limits::default());
    assert!(matches!(model.ask(&question()), Err(Error::Refused { status: 401, .. })));
    assert_eq!(server.asked().len(), 1);
}

#[test]
fn waiting_can_be_ended() {
    let server = Server::new(vec![Act::fails(500, "")]);
    let clock = Fake { ended: true, ..Fake::default() };
    let model = Box::new(remote("openai:m", &server.url, None));
    let mut session = Session::new(model, Limits::default(), Box::new(clock)).unwrap();
    assert_eq!(session.ask(&question()), Err(Error::Interrupted));
}

#[test]
fn what_a_model_does_not_know_is_left_out() {
    let server = Server::playing(|_, asked| match asked.body.get("temperature").is_some() {
        true => Act::fails(400, "Unsupported value: 'temperature' does not support 0.7 with this model."),
        false if asked.body["response_format"]["type"] == "json_schema" => {
            Act::fails(422, "response_format: json_schema is not available")
        }
        false => good(),
    });
    let (mut session, clock) = session(&server, Limits::default());
    assert_eq!(typed(&mut session, &question()), Ok(Point { x: 1.0 }));
    assert_eq!(clock.seconds(), [0.0; 0], "nobody waits for that");
    assert_eq!(session.spent().calls, 3);
    // It is remembered.
    session.ask(&question()).unwrap();
    assert_eq!(session.spent().calls, 4);
}

#[test]
fn requests_keep_their_distance() {
    let server = Server::new(vec![good()]);
    let (mut session, clock) = session(&server, Limits { per_minute: Some(20.0), ..Limits::default() });
    for _ in 0..3 {
        session.ask(&question()).unwrap();
    }
    assert_eq!(clock.seconds(), [3.0, 3.0]);
}

#[test]
fn a_budget_stops_everything() {
    let price = Some(Price { input: 1000.0, output: 5000.0 });
    for (budget, calls, said) in [
        (Budget { calls: Some(2), ..Budget::default() }, 2, "the budget is used up: 2 of 2 calls"),
        (
            Budget { tokens: Some(250), ..Budget::default() },
            2,
            "the budget is used up: 240 of 250 tokens are used, and the next question needs more",
        ),
        (
            Budget { money: Some(0.41), ..Budget::default() },
            2,
            "the budget is used up: 0.4000 of the money budget of 0.41 is spent, and the next question needs more",
        ),
        (Budget { calls: Some(0), ..Budget::default() }, 0, "the budget is used up: 0 of 0 calls"),
    ] {
        let server = Server::new(vec![good()]);
        let (mut session, _) = session(&server, Limits { budget, price, ..Limits::default() });
        let error = loop {
            if let Err(error) = session.ask(&question()) {
                break error;
            }
        };
        assert_eq!(error.to_string(), said);
        assert_eq!((session.spent().calls, server.asked().len()), (calls, calls as usize));
        // The answers were kept to what was left.
        if let (Some(tokens), Some(last)) = (budget.tokens, server.asked().last()) {
            assert!(last.body["max_completion_tokens"].as_u64().unwrap() < tokens - 120);
        }
    }
    // Failures count as calls.
    let server = Server::new(vec![Act::fails(500, "")]);
    let (mut session, _) =
        session(&server, Limits { budget: Budget { calls: Some(2), ..Budget::default() }, ..Limits::default() });
    assert!(matches!(session.ask(&question()), Err(Error::Spent(_))));
}

#[test]
fn sessions_of_one_account_have_one_budget() {
    let server = Server::new(vec![good()]);
    let account = Account::default();
    let budget = Budget { calls: Some(3), ..Budget::standard() };
    let ask = || {
        let (session, _) = session(&server, Limits { budget, ..Limits::default() });
        session.spending_of(&account).ask(&question())
    };
    let answers: Vec<bool> = (0..5).map(|_| ask().is_ok()).collect();
    assert_eq!(answers, [true, true, true, false, false]);
    assert_eq!(ask().unwrap_err().to_string(), "the budget is used up: 3 of 3 calls");
    assert_eq!(server.asked().len(), 3);
}

#[test]
fn who_is_asked_is_said_once_and_only_where_somebody_is() {
    for (calls, wanted) in [(2, 1), (0, 0)] {
        let server = Server::new(vec![good()]);
        let said = Arc::new(Mutex::new(Vec::new()));
        let budget = Budget { calls: Some(calls), ..Budget::standard() };
        let (session, _) = session(&server, Limits { budget, ..Limits::default() });
        let (heard, asked) = (Arc::clone(&said), server.url.clone());
        let mut session = session.announced_by(move |text| heard.lock().unwrap().push(text.to_owned()));
        while session.ask(&question()).is_ok() {}
        let said = said.lock().unwrap();
        assert_eq!((said.len(), server.asked().len()), (wanted, calls as usize));
        let sentence =
            format!("asking the language model openai:m at {asked}: at most {calls} calls and 500000 tokens");
        assert!(said.iter().all(|text| *text == sentence), "{said:?}");
    }
}

#[test]
fn money_without_a_price_is_refused() {
    let server = Server::new(vec![good()]);
    let limits = Limits { budget: Budget { money: Some(1.0), ..Budget::default() }, ..Limits::default() };
    let model = Box::new(remote("openai:m", &server.url, None));
    assert!(matches!(Session::new(model, limits, Box::new(Fake::default())), Err(Error::Setup(_))));
}

#[test]
fn a_question_is_paid_once() {
    let folder = tempfile::tempdir().unwrap();
    let limits = Limits { cache: Some(folder.path().join("cache")), ..Limits::default() };
    let server = Server::new(vec![good(), Act::says("nothing of use"), Act::says("{\"x\": 2}")]);
    let first = session(&server, limits.clone()).0.ask(&question()).unwrap();
    let (mut again, _) = session(&server, limits);
    assert_eq!(again.ask(&question()), Ok(first));
    assert_eq!((again.spent().calls, again.spent().cached, server.asked().len()), (0, 1, 1));
    // Another seed is another question; an answer without JSON is not kept.
    let other = Request { seed: Some(6), ..question() };
    assert_eq!(again.ask(&other).unwrap().text, "nothing of use");
    assert_eq!(again.ask(&other).unwrap().text, "{\"x\": 2}");
    assert!(!texts(folder.path()).contains("sk-very-secret"));
}

#[test]
fn a_folder_that_takes_nothing_is_told() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("file");
    std::fs::write(&file, "").unwrap();
    let server = Server::new(vec![good()]);
    let (mut model, _) = session(&server, Limits { cache: Some(file.join("cache")), ..Limits::default() });
    assert!(model.ask(&question()).is_ok());
    assert!(model.spent().to_string().contains("; answers are not cached: cannot write "), "{}", model.spent());
    let limits = Limits { record: Some(file.join("tape.json")), ..Limits::default() };
    let model = Box::new(remote("openai:m", &server.url, None));
    assert!(matches!(Session::new(model, limits, Box::new(Fake::default())), Err(Error::File(_))));
}

#[test]
fn a_conversation_can_be_played_back() {
    let folder = tempfile::tempdir().unwrap();
    let tape = folder.path().join("a/conversation.json");
    let limits = Limits { record: Some(tape.clone()), ..Limits::default() };
    let server = Server::new(vec![Act::says("{\"x\": \"left\"}"), good(), Act::fails(400, "no sk-very-secret")]);
    let (mut live, _) = session(&server, limits);
    let point: Point = typed(&mut live, &question()).unwrap();
    assert!(live.ask(&question()).is_err());

    let mut replay = Replay::open(&tape).unwrap();
    assert_eq!(typed(&mut replay, &question()), Ok(point));
    assert_eq!(replay.played(), 2);
    let said = replay.ask(&question()).unwrap_err().to_string();
    assert_eq!(said, "as recorded: the provider refuses the request (400): no [key]");
    assert!(replay.ask(&question()).unwrap_err().to_string().contains("ends before question 4"));
    let mut replay = Replay::open(&tape).unwrap();
    let other = Request { seed: None, ..question() };
    assert!(replay.ask(&other).unwrap_err().to_string().contains("question 1 differs from the recording"));
    assert!(!texts(folder.path()).contains("sk-very-secret"));
    assert!(Replay::open(&folder.path().join("none")).is_err());
    for (text, wanted) in [("{", "EOF"), ("{\"format\": \"x\", \"model\": \"m\", \"turns\": []}", "format is not")] {
        assert!(Replay::read(text).unwrap_err().contains(wanted));
    }
}

#[test]
fn waits_are_those_of_the_seed() {
    let slept = |seed: u64| {
        let server = Server::new(vec![Act::fails(500, "")]);
        let limits = Limits { retry: Retry { seed, ..Retry::default() }, ..Limits::default() };
        let (mut session, clock) = session(&server, limits);
        assert!(session.ask(&question()).is_err());
        clock.seconds()
    };
    assert_eq!(slept(1), slept(1));
    assert_ne!(slept(1), slept(2));
}

/// All that is written below a folder.
fn texts(folder: &Path) -> String {
    let mut out = String::new();
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        out += &if path.is_dir() { texts(&path) } else { std::fs::read_to_string(&path).unwrap() };
    }
    out
}
