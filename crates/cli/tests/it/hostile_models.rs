//! Language models, and settings that a stranger wrote: nobody is asked unless the user said so, nothing is sent to where
//! the user did not say, and nothing costs more than the user allowed.

use crate::model::server::{Act, Server};
use crate::model::{KEY, folder, lamp_to, texts};
use crate::support::{Ended, binary, root, run};
use serde_json::{Value, json};
use std::fs;
use std::io::{BufRead, BufReader, Read, Write};
use std::net::TcpListener;
use std::path::Path;
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc::channel;
use std::sync::{Arc, Mutex};

/// How many requests there are.
#[derive(Clone, Copy, Debug)]
enum Asked {
    Never,
    /// From one to so many.
    UpTo(usize),
}
use Asked::{Never, UpTo};

/// A case: `{url}` is where the scripted model is, `{elsewhere}` another server, which must never hear anything.
#[derive(Clone, Copy)]
struct Case {
    name: &'static str,
    /// `scenelang.toml`, a stranger's.
    workspace: &'static str,
    /// `config.toml`, the user's own.
    own: &'static str,
    /// `SCENELANG_MODEL`.
    environment: Option<&'static str>,
    args: &'static [&'static str],
    /// What the model does; a lamp is moved where it does not belong, unless said otherwise.
    act: Option<fn() -> Act>,
    asked: Asked,
    code: i32,
    /// What is said of it, on either stream.
    said: &'static str,
}

const CASE: Case =
    Case { name: "", workspace: "", own: "", environment: None, args: &[], act: None, asked: Never, code: 0, said: "" };
/// The user has turned a model on.
const ON: &[&str] = &["--model", "compatible:m", "--base-url", "{url}"];
/// The user has turned on what the workspace names.
const CONFIGURED: &[&str] = &["--model", "configured", "--base-url", "{url}"];
const OWN: &str = "[llm]\nmodel = \"compatible:m\"\nbase_url = \"{url}\"\n";

fn off() -> Vec<Case> {
    let named = "[llm]\nmodel = \"compatible:m\"\nrounds = 100\n";
    vec![
        Case {
            name: "a workspace names a model, and that is all",
            workspace: named,
            args: &["--base-url", "{url}"],
            said: "note: the language model compatible:m in scenelang.toml is not used; enable it with `--model configured`\n",
            ..CASE
        },
        Case { name: "none, on the command line", workspace: named, own: OWN, args: &["--model", "none"], ..CASE },
        Case { name: "none, in the environment", workspace: named, own: OWN, environment: Some("none"), ..CASE },
        Case {
            name: "none, in the user's own file",
            workspace: named,
            own: "[llm]\nmodel = \"none\"\n",
            args: &["--base-url", "{url}"],
            ..CASE
        },
        Case {
            name: "a flag is above the environment",
            own: OWN,
            environment: Some("compatible:m"),
            args: &["--model", "none"],
            ..CASE
        },
        Case {
            name: "offline",
            workspace: named,
            own: OWN,
            args: &["--offline"],
            said: "the network is switched off",
            ..CASE
        },
        Case {
            name: "the workspace says `configured` of itself",
            workspace: "[llm]\nmodel = \"configured\"\n",
            args: &["--base-url", "{url}"],
            ..CASE
        },
        Case {
            name: "a spell for a name",
            workspace: "[llm]\nmodel = \"compatible:\\u001b[2J\\u202e\"\n",
            args: &["--base-url", "{url}"],
            said: "is not used",
            ..CASE
        },
    ]
}

fn on() -> Vec<Case> {
    vec![
        Case {
            name: "the command line",
            args: ON,
            asked: UpTo(5),
            said: "at most 100 calls and 500000 tokens\n",
            ..CASE
        },
        Case {
            name: "the user's own file",
            own: OWN,
            asked: UpTo(5),
            said: "asking the language model compatible:m at ",
            ..CASE
        },
        Case {
            name: "the environment",
            own: OWN,
            environment: Some("compatible:other"),
            asked: UpTo(5),
            said: "compatible:other",
            ..CASE
        },
        Case {
            name: "the model of the workspace, wanted by the user",
            workspace: "[llm]\nmodel = \"compatible:theirs\"\n",
            args: CONFIGURED,
            asked: UpTo(5),
            said: "asking the language model compatible:theirs at ",
            ..CASE
        },
    ]
}

fn addresses_and_keys() -> Vec<Case> {
    let refused = Case { code: 2, ..CASE };
    vec![
        Case {
            name: "a base URL of the workspace",
            workspace: "[llm]\nmodel = \"compatible:m\"\nbase_url = \"{elsewhere}\"\n",
            args: CONFIGURED,
            said: "`base_url` is not a workspace setting",
            ..refused
        },
        Case {
            name: "an address of the user's is that of one provider",
            workspace: "[llm]\nmodel = \"openai:m\"\n",
            own: OWN,
            args: &["--model", "configured"],
            said: "error: openai needs a key: set OPENAI_API_KEY\n",
            ..refused
        },
        Case {
            name: "a key in the workspace",
            workspace: "[llm]\napi_key = \"sk-stolen\"\n",
            args: ON,
            said: "`api_key` is not a setting: keys come from the environment, never from a file",
            ..refused
        },
        Case {
            name: "a key in the user's own file",
            own: "[llm]\nkey = \"sk-mine\"\n",
            args: ON,
            said: "config.toml:2:1: `key` is not a setting: keys come from the environment, never from a file\n",
            ..refused
        },
        Case {
            name: "a redirection",
            args: ON,
            act: Some(|| Act::fails(302, "").with("location", "{elsewhere}/steal")),
            asked: UpTo(1),
            said: "it redirects to another host, which must not receive the key",
            ..CASE
        },
        Case {
            name: "a redirection that keeps the body",
            args: ON,
            act: Some(|| Act::fails(307, "").with("location", "{elsewhere}/steal")),
            asked: UpTo(1),
            said: "it redirects to another host, which must not receive the key",
            ..CASE
        },
        Case {
            name: "an unknown provider",
            workspace: "[llm]\nmodel = \"evil:m\"\n",
            args: CONFIGURED,
            said: "there is no provider `evil`; valid names: openai, ",
            ..refused
        },
        Case {
            name: "a path for a name",
            workspace: "[llm]\nmodel = \"compatible:../../v1/files\"\n",
            args: CONFIGURED,
            said: "is not a valid model name",
            ..refused
        },
        Case {
            name: "a command for a name",
            workspace: "[llm]\nmodel = \"compatible:$(touch pwned)\"\n",
            args: CONFIGURED,
            said: "is not a valid model name",
            ..refused
        },
        Case {
            name: "a command for a provider",
            workspace: "[llm]\nmodel = \"exec:touch pwned\"\n",
            args: CONFIGURED,
            said: "there is no provider `exec`",
            ..refused
        },
        Case {
            name: "a command",
            workspace: "[llm]\ncommand = \"touch pwned\"\n",
            args: ON,
            said: "there is no `[llm]` setting `command`",
            ..refused
        },
        Case {
            name: "a file to replay",
            workspace: "[llm]\nmodel = \"replay:/etc/passwd\"\n",
            args: CONFIGURED,
            said: "the settings of a workspace cannot name a recording (replay:/etc/passwd)",
            ..refused
        },
    ]
}

fn numbers() -> Vec<Case> {
    let wrong = Case { args: ON, code: 2, ..CASE };
    vec![
        Case {
            name: "calls below zero",
            workspace: "[llm]\nmax_calls = -1\n",
            said: "`max_calls` takes a number from 0 to ",
            ..wrong
        },
        Case {
            name: "tokens beyond numbers",
            workspace: "[llm]\nmax_tokens = 99999999999999999999\n",
            said: "invalid TOML",
            ..wrong
        },
        Case {
            name: "rounds",
            workspace: "[llm]\nrounds = 1000000\n",
            said: "`rounds` takes a number from 0 to 100",
            ..wrong
        },
        Case {
            name: "tries",
            workspace: "[llm]\ntries = 1000\n",
            said: "`tries` takes a number from 1 to 10",
            ..wrong
        },
        Case {
            name: "output",
            workspace: "[llm]\nmax_output = 1000000000\n",
            said: "`max_output` takes a number from 1 to 100000",
            ..wrong
        },
        Case {
            name: "no time",
            workspace: "[llm]\ntimeout = 0\n",
            said: "`timeout` takes a number from 1 to 3600",
            ..wrong
        },
        Case {
            name: "not a number",
            workspace: "[llm]\nmax_money = nan\n",
            said: "`max_money` takes a number from 0 to ",
            ..wrong
        },
        Case {
            name: "an endless rate",
            workspace: "[llm]\nper_minute = inf\n",
            said: "`per_minute` takes a number from 0.01 to ",
            ..wrong
        },
    ]
}

/// An answer without moves, and what it says of its tokens.
fn says(usage: &Value) -> Act {
    let content = json!({ "moves": [] }).to_string();
    Act::json(&json!({ "choices": [{ "message": { "content": content }, "finish_reason": "stop" }], "usage": usage }))
}

fn budgets() -> Vec<Case> {
    let on = Case { args: ON, ..CASE };
    vec![
        Case {
            name: "a workspace that wants a million calls",
            workspace: "[llm]\nmax_calls = 1_000_000\nrounds = 100\n",
            own: "[llm]\nmax_calls = 7\n",
            asked: UpTo(7),
            said: "note: scenelang.toml asks for 1000000 calls; 7 are allowed unless you pass --max-calls 1000000\n",
            ..on
        },
        Case {
            name: "a budget of none",
            own: "[llm]\nmax_calls = 0\n",
            workspace: "[llm]\nmax_calls = 50\n",
            said: "the budget is used up: 0 of 0 calls",
            ..on
        },
        Case {
            name: "a budget on the command line",
            args: &["--model", "compatible:m", "--base-url", "{url}", "--max-calls", "2"],
            asked: UpTo(2),
            said: "the budget is used up: 2 of 2 calls",
            ..CASE
        },
        Case {
            name: "a budget of tokens",
            args: &["--model", "compatible:m", "--base-url", "{url}", "--max-tokens", "1"],
            said: "the budget is used up: 0 of 1 tokens",
            ..CASE
        },
        Case {
            name: "a server that boasts of its work",
            act: Some(|| says(&json!({ "prompt_tokens": u64::MAX, "completion_tokens": u64::MAX }))),
            asked: UpTo(1),
            said: "the budget is used up: 18446744073709551615 of 500000 tokens",
            ..on
        },
        Case {
            name: "a server that counts below zero",
            act: Some(|| says(&json!({ "prompt_tokens": -5, "completion_tokens": 1.5 }))),
            asked: UpTo(10),
            said: "",
            ..on
        },
        Case {
            name: "an answer without an end",
            act: Some(|| Act::Endless),
            asked: UpTo(1),
            said: "the answer is larger than 4194304 bytes",
            ..on
        },
        Case {
            name: "a server that is always busy",
            workspace: "[llm]\ntries = 10\nrounds = 100\n",
            act: Some(|| Act::fails(503, "later").with("retry-after", "0")),
            args: &["--model", "compatible:m", "--base-url", "{url}", "--max-calls", "3"],
            asked: UpTo(3),
            said: "the budget is used up: 3 of 3 calls",
            ..CASE
        },
    ]
}

fn tried(case: &Case) {
    let elsewhere = Server::new(vec![lamp_to(2.0, 1.5)]);
    let act = match case.act.map_or_else(|| lamp_to(2.0, 2.2), |act| act()) {
        Act::Answer(status, headers, body) => {
            let there = |(name, value): (&'static str, String)| (name, value.replace("{elsewhere}", &elsewhere.url));
            Act::Answer(status, headers.into_iter().map(there).collect(), body)
        }
        other => other,
    };
    let server = Server::new(vec![act]);
    let filled = |text: &str| text.replace("{url}", &server.url).replace("{elsewhere}", &elsewhere.url);
    let workspace = if case.workspace.is_empty() { "[llm]\ntries = 1\n".to_owned() } else { filled(case.workspace) };
    let folder = folder(&workspace);
    let home = tempfile::tempdir().unwrap();
    own(home.path(), &filled(case.own));
    let args: Vec<String> = case.args.iter().map(|arg| filled(arg)).collect();
    let ended = solve(folder.path(), home.path(), case.environment, &args);
    let (name, all) = (case.name, ended.stdout.clone() + &ended.stderr);
    assert_eq!(ended.code, case.code, "{name}: {all}");
    assert!(all.contains(case.said), "{name}: {all}");
    let count = server.asked().len();
    match case.asked {
        Never => assert_eq!(count, 0, "{name}: {all}"),
        UpTo(most) => assert!((1..=most).contains(&count), "{name}: {count} requests\n{all}"),
    }
    assert_eq!(elsewhere.asked().len(), 0, "{name}: it went elsewhere");
    // Who is asked is said, and only where somebody is.
    assert_eq!(ended.stderr.contains("asking the language model"), count > 0, "{name}: {all}");
    assert!(!(all.clone() + &texts(folder.path())).contains(KEY), "{name}: the key");
    assert!(!all.contains(['\u{1b}', '\u{202e}']), "{name}: {all:?}");
    assert!(!folder.path().join("pwned").exists(), "{name}: a command was run");
}

fn own(home: &Path, text: &str) {
    fs::create_dir_all(home.join("scenelang")).unwrap();
    fs::write(home.join("scenelang/config.toml"), text).unwrap();
}

fn solve(folder: &Path, home: &Path, environment: Option<&str>, args: &[String]) -> Ended {
    let mut command = binary();
    command.args(["solve", "room.scene", "--layout", "start.json", "-o", "end.json"]).args(args);
    command.current_dir(folder).env_clear().env("SCENELANG_CACHE", home.join("cache")).env("XDG_CONFIG_HOME", home);
    if let Some(model) = environment {
        command.env("SCENELANG_MODEL", model);
    }
    run(command.env("SCENELANG_API_KEY", KEY), b"")
}

#[test]
fn nobody_is_asked_unless_the_user_says_so() {
    off().iter().for_each(tried);
}

#[test]
fn the_user_has_several_ways_to_say_so() {
    on().iter().for_each(tried);
}

#[test]
fn nothing_goes_where_the_user_did_not_say() {
    addresses_and_keys().iter().for_each(tried);
}

#[test]
fn numbers_have_bounds() {
    numbers().iter().for_each(tried);
}

#[test]
fn what_is_spent_has_bounds() {
    budgets().iter().for_each(tried);
}

/// A folder of settings in the workspace is no folder of the user's.
#[test]
fn a_relative_path_is_not_the_users_own() {
    let server = Server::new(vec![lamp_to(2.0, 1.5)]);
    let folder = folder("");
    own(&folder.path().join("here"), &OWN.replace("{url}", &server.url));
    let ended = solve(folder.path(), Path::new("here"), None, &[]);
    assert_eq!((ended.code, server.asked().len()), (0, 0), "{ended:?}");
}

/// The model answers only when the sentence has been read.
#[test]
fn who_is_asked_is_said_before() {
    let (read, heard) = channel::<()>();
    let heard = Mutex::new(heard);
    let server = Server::playing(move |n, _| {
        if n == 0 {
            heard.lock().unwrap().recv().unwrap();
        }
        lamp_to(2.0, 1.5)
    });
    let folder = folder("[llm]\ntries = 1\ntimeout = 120\n");
    let mut command = binary();
    command.args(["solve", "room.scene", "--layout", "start.json", "-o", "end.json", "--model", "compatible:m"]);
    command.args(["--base-url", &server.url, "--max-calls", "9", "--max-tokens", "90000"]).current_dir(folder.path());
    command.env_clear().env("SCENELANG_CACHE", folder.path().join("cache"));
    let mut child = command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    let mut said = String::new();
    BufReader::new(child.stderr.take().unwrap()).read_line(&mut said).unwrap();
    let wanted =
        format!("asking the language model compatible:m at {}: at most 9 calls and 90000 tokens\n", server.url);
    assert_eq!(said, wanted);
    read.send(()).unwrap();
    let mut out = String::new();
    child.stdout.take().unwrap().read_to_string(&mut out).unwrap();
    assert_eq!(child.wait().unwrap().code(), Some(0), "{out}");
    assert!(out.contains("1 of its 1 moves were made"), "{out}");
}

/// The examples of the book: a user's own file, and what is said before a request.
#[test]
fn the_book_shows_what_the_user_says_and_hears() {
    let page = fs::read_to_string(root().join("spec/src/models.md")).unwrap();
    let block = |tag: &str| page.split(&format!("```{tag}\n")).nth(1).unwrap().split("```").next().unwrap();
    let server = Server::new(vec![lamp_to(2.0, 1.5)]);
    let (folder, home) = (folder(""), tempfile::tempdir().unwrap());
    own(home.path(), &block("toml own").replace("https://models.example/v1", &server.url));
    let ended = solve(folder.path(), home.path(), None, &[]);
    let wanted = format!("asking the language model compatible:qwen3 at {}: at most 200 calls", server.url);
    assert!(ended.code == 0 && ended.stderr.contains(&wanted), "{ended:?}");

    let mut command = binary();
    command.args(["solve", "room.scene", "--layout", "start.json", "-o", "end.json", "--model", "openai:gpt-4o"]);
    command.args(["--base-url", &server.url]).current_dir(folder.path()).env_clear().env("OPENAI_API_KEY", KEY);
    let ended = run(&mut command, b"");
    assert_eq!(ended.stderr.replace(&format!(" at {}", server.url), ""), block("text asking"), "{ended:?}");
}

/// A language server of its own process, and what the editor is told.
struct Editor {
    child: Child,
    to: ChildStdin,
    from: BufReader<ChildStdout>,
    told: Vec<Value>,
}

impl Editor {
    fn start(command: &mut Command, options: &Value) -> Self {
        let mut child =
            command.arg("lsp").stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::null()).spawn().unwrap();
        let (to, from) = (child.stdin.take().unwrap(), BufReader::new(child.stdout.take().unwrap()));
        let mut editor = Self { child, to, from, told: Vec::new() };
        editor.ask(
            1,
            "initialize",
            &json!({
                "capabilities": { "workspace": { "applyEdit": true } }, "initializationOptions": options,
            }),
        );
        editor.say(&json!({ "method": "initialized", "params": {} }));
        editor
    }

    fn say(&mut self, message: &Value) {
        let mut message = message.clone();
        message["jsonrpc"] = "2.0".into();
        let body = message.to_string();
        write!(self.to, "Content-Length: {}\r\n\r\n{body}", body.len()).unwrap();
        self.to.flush().unwrap();
    }

    /// The answer.
    fn ask(&mut self, id: i64, method: &str, params: &Value) -> Value {
        self.say(&json!({ "id": id, "method": method, "params": params }));
        loop {
            let message = self.read();
            if message["method"].is_string() && !message["id"].is_null() {
                // The editor's own model has nothing to say, and no change is made.
                let text = json!({ "text": "{\"moves\": []}", "applied": false });
                self.say(&json!({ "id": message["id"], "result": text }));
            }
            if message["id"] == id && message.get("method").is_none() {
                return message;
            }
            self.told.push(message);
        }
    }

    fn read(&mut self) -> Value {
        let mut length = 0;
        loop {
            let mut line = String::new();
            assert_ne!(self.from.read_line(&mut line).unwrap(), 0, "the server is gone");
            match line.trim() {
                "" => break,
                line => length = line.strip_prefix("Content-Length: ").unwrap().parse().unwrap(),
            }
        }
        let mut body = vec![0; length];
        self.from.read_exact(&mut body).unwrap();
        serde_json::from_slice(&body).unwrap()
    }

    /// Repairs the constraint that fails, so many times, and says how often the editor's own model was asked.
    fn repair(&mut self, folder: &Path, times: i64) -> usize {
        let scene = folder.join("room.scene");
        let (uri, text) = (format!("file://{}", scene.display()), fs::read_to_string(&scene).unwrap());
        let line = text.lines().position(|line| line.starts_with("assert table.pos.x")).unwrap();
        let document = json!({ "uri": uri, "languageId": "scenelang", "version": 1, "text": text });
        self.say(&json!({ "method": "textDocument/didOpen", "params": { "textDocument": document } }));
        for id in 0..times {
            let repair = json!({ "command": "scenelang.repair", "arguments": [{ "uri": uri, "line": line }] });
            self.ask(100 + id, "workspace/executeCommand", &repair);
        }
        self.told.iter().filter(|m| m["method"] == "scenelang/languageModel").count()
    }

    /// What stands in the editor's log.
    fn log(&self) -> String {
        let logged = self.told.iter().filter(|m| m["method"] == "window/logMessage");
        logged.map(|m| m["params"]["message"].as_str().unwrap().to_owned() + "\n").collect()
    }
}

impl Drop for Editor {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

/// A workspace with a layout in which a constraint fails, and an editor on it.
fn editor(
    workspace: &str,
    own_text: &str,
    options: &Value,
    proxy: &str,
) -> (tempfile::TempDir, tempfile::TempDir, Editor) {
    let folder = folder(workspace);
    fs::copy(folder.path().join("start.json"), folder.path().join("room.layout.json")).unwrap();
    let home = tempfile::tempdir().unwrap();
    own(home.path(), own_text);
    let mut command = binary();
    command.current_dir(folder.path()).env_clear().env("XDG_CONFIG_HOME", home.path());
    command.env("SCENELANG_CACHE", home.path().join("cache")).env("SCENELANG_API_KEY", KEY).env("OPENAI_API_KEY", KEY);
    if !proxy.is_empty() {
        command.env("ALL_PROXY", proxy);
    }
    let editor = Editor::start(&mut command, options);
    (folder, home, editor)
}

/// Counts who knocks.
fn knocks() -> (String, Arc<AtomicUsize>) {
    let listener = TcpListener::bind("127.0.0.1:0").unwrap();
    let (url, count) = (format!("http://{}", listener.local_addr().unwrap()), Arc::new(AtomicUsize::new(0)));
    let counted = Arc::clone(&count);
    std::thread::spawn(move || {
        listener.incoming().for_each(|_| {
            counted.fetch_add(1, Ordering::SeqCst);
        })
    });
    (url, count)
}

#[test]
fn an_editor_whose_user_did_not_say_so_has_nobody_asked() {
    // Providers would be reached through the proxy, and that is where requests are counted.
    for options in [
        Value::Null,
        json!({ "languageModel": "none" }),
        json!({ "languageModel": null }),
        json!({ "languageModel": true }),
        json!({ "languageModel": "Configured" }),
        json!({ "languageModel": "openai:m" }),
    ] {
        let (proxy, knocked) = knocks();
        let server = Server::new(vec![lamp_to(2.0, 2.2)]);
        let workspace = "[llm]\nmodel = \"openai:m\"\nrounds = 100\ntries = 1\n";
        let (folder, _home, mut editor) = editor(workspace, &OWN.replace("{url}", &server.url), &options, &proxy);
        let lent = editor.repair(folder.path(), 1);
        assert_eq!((knocked.load(Ordering::SeqCst), server.asked().len(), lent), (0, 0, 0), "{options}");
        assert!(!editor.log().contains("language model"), "{options}: {}", editor.log());
    }
}

#[test]
fn an_editor_whose_user_said_so_keeps_to_one_budget() {
    let server = Server::new(vec![lamp_to(2.0, 2.2)]);
    let own = OWN.replace("{url}", &server.url) + "max_calls = 12\n";
    let (folder, _home, mut editor) = editor(
        "[llm]\nmax_calls = 1000\nrounds = 100\ntries = 1\ncache = false\n",
        &own,
        &json!({ "languageModel": "configured" }),
        "",
    );
    editor.repair(folder.path(), 4);
    let count = server.asked().len();
    assert_eq!(count, 12, "{}", editor.log());
    let said =
        format!("asking the language model compatible:m at {}: at most 12 calls and 500000 tokens\n", server.url);
    assert!(editor.log().contains(&said), "{}", editor.log());
    assert!(editor.log().contains("the budget is used up: 12 of 12 calls"), "{}", editor.log());
}

#[test]
fn the_editors_own_model_has_a_budget_too() {
    let (folder, _home, mut editor) = editor("", "", &json!({ "languageModel": "client" }), "");
    let count = editor.repair(folder.path(), 120);
    assert_eq!(count, 100, "{}", editor.log());
    assert!(editor.log().contains("asking the language model editor: at most 100 calls"), "{}", editor.log());
}
