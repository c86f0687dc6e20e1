//! `scenelang view`: who is answered, what is moved and written, what pages are told; Ctrl-C ends it.
#![cfg(unix)]

use crate::support::{binary, folder_with};
use scenelang_export::preview::has_viewer;
use serde_json::{Value, json};
use std::fs;
use std::io::{BufRead, BufReader, Read, Write};
use std::net::TcpStream;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::time::Duration;

/// What does not come in this time does not come at all. Nothing here depends on how long it takes.
const NEVER: Duration = Duration::from_secs(60);

pub struct View {
    pub child: Child,
    /// `127.0.0.1:PORT`
    pub address: String,
    pub secret: String,
    pub layout: PathBuf,
    _folder: tempfile::TempDir,
}

pub struct Answer {
    pub status: u16,
    pub head: String,
    pub body: String,
}

impl View {
    /// Shows the solved meeting room.
    pub fn start() -> Self {
        Self::start_with(&["view", "--no-open"], Stdio::null())
    }

    fn start_with(args: &[&str], input: Stdio) -> Self {
        let (folder, scene) = folder_with("meeting-room");
        let program = |args: &[&str]| {
            let mut command = binary();
            command.args(args).arg(&scene).current_dir(folder.path()).stdin(Stdio::null());
            command
        };
        assert!(program(&["solve"]).output().unwrap().status.success());
        let mut command = program(args);
        let mut child = command.stdin(input).stdout(Stdio::piped()).stderr(Stdio::null()).spawn().unwrap();
        let mut line = String::new();
        BufReader::new(child.stdout.take().unwrap()).read_line(&mut line).unwrap();
        let (address, secret) = line.trim().strip_prefix("http://").unwrap().split_once("/?key=").unwrap();
        let (address, secret) = (address.to_owned(), secret.to_owned());
        assert!(address.starts_with("127.0.0.1:"), "{address}");
        assert!(secret.len() == 64 && secret.bytes().all(|c| c.is_ascii_hexdigit()), "{secret}");
        let view = Self { child, address, secret, layout: scene.with_extension("layout.json"), _folder: folder };
        // The first event comes when the room has been read.
        assert_eq!(view.follow().until("changed"), "1");
        view
    }

    fn connect(&self) -> TcpStream {
        let stream = TcpStream::connect(&self.address).unwrap();
        stream.set_read_timeout(Some(NEVER)).unwrap();
        stream
    }

    pub fn cookie(&self) -> String {
        format!("Cookie: scenelang-view-{}={}", self.address.rsplit(':').next().unwrap(), self.secret)
    }

    /// A request with these header lines; `Host` and the cookie are added unless they have one.
    pub fn ask(&self, line: &str, headers: &[&str], body: &str) -> Answer {
        let lacks = |name: &str| !headers.iter().any(|h| h.to_ascii_lowercase().starts_with(name));
        let (host, cookie) = (format!("Host: {}", self.address), self.cookie());
        let usual = [lacks("host:").then_some(host.as_str()), lacks("cookie:").then_some(cookie.as_str())];
        let lines = headers.iter().copied().chain(usual.into_iter().flatten()).collect::<Vec<_>>().join("\r\n");
        let length = body.len();
        self.say(&format!("{line} HTTP/1.1\r\n{lines}\r\nContent-Length: {length}\r\nConnection: close\r\n\r\n{body}"))
    }

    /// What is answered to these bytes.
    pub fn say(&self, request: &str) -> Answer {
        let mut stream = self.connect();
        stream.write_all(request.as_bytes()).unwrap();
        let mut text = String::new();
        stream.read_to_string(&mut text).unwrap();
        let (head, body) = text.split_once("\r\n\r\n").unwrap();
        let status = head.split(' ').nth(1).unwrap().parse().unwrap();
        // Long answers come in pieces, each after its length.
        let pieces = head.to_ascii_lowercase().contains("transfer-encoding: chunked");
        let body = if pieces { join(body) } else { body.to_owned() };
        Answer { status, head: head.to_ascii_lowercase(), body }
    }

    pub fn token(&self) -> String {
        let page = self.ask("GET /", &[], "").body;
        page.split("data-token=\"").nth(1).unwrap().split('"').next().unwrap().to_owned()
    }

    /// A move by a page that has the token.
    pub fn go(&self, asked: &Value) -> Answer {
        self.go_with(&self.token(), asked)
    }

    pub fn go_with(&self, token: &str, asked: &Value) -> Answer {
        self.ask("POST /move", &[&format!("X-Scenelang-Token: {token}")], &asked.to_string())
    }

    pub fn follow(&self) -> Events {
        let mut stream = self.connect();
        write!(stream, "GET /events HTTP/1.1\r\nHost: {}\r\n{}\r\n\r\n", self.address, self.cookie()).unwrap();
        Events(BufReader::new(stream))
    }

    fn pos(&self, name: &str) -> Value {
        let layout: Value = serde_json::from_str(&fs::read_to_string(&self.layout).unwrap()).unwrap();
        layout["objects"][name]["pos"].clone()
    }
}

impl Drop for View {
    fn drop(&mut self) {
        // A test that fails leaves nobody behind.
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

fn join(mut pieces: &str) -> String {
    let mut out = String::new();
    while let Some((length, rest)) = pieces.split_once("\r\n") {
        let length = usize::from_str_radix(length, 16).unwrap();
        out.push_str(&rest[..length]);
        pieces = rest[length..].trim_start_matches("\r\n");
    }
    out
}

/// What a page is told.
pub struct Events(BufReader<TcpStream>);

impl Events {
    /// The data of the next event of a kind.
    pub fn until(&mut self, kind: &str) -> String {
        let mut now = String::new();
        loop {
            let mut line = String::new();
            assert!(self.0.read_line(&mut line).unwrap() > 0, "the server hung up");
            if let Some(event) = line.strip_prefix("event: ") {
                event.trim().clone_into(&mut now);
            } else if let Some(data) = line.strip_prefix("data: ")
                && now == kind
            {
                return data.trim().to_owned();
            }
        }
    }
}

pub fn there() -> bool {
    let there = has_viewer();
    assert!(there || std::env::var("CI").as_deref() != Ok("true"), "in CI nothing may be skipped: no viewer/dist");
    if !there {
        eprintln!("skipped: no viewer/dist (Node)");
    }
    there
}

#[test]
fn only_its_own_pages_are_answered() {
    if !there() {
        return;
    }
    let view = View::start();
    let port = view.address.rsplit(':').next().unwrap();
    let own = format!("Host: localhost:{port}");
    let origin = format!("Origin: http://{}", view.address);
    let rebound = format!("Host: evil.example:{port}");
    let cases: &[(&str, &[&str], u16)] = &[
        ("GET /", &[], 200),
        ("GET /", &[&own], 200),
        ("GET /scene", &[&origin], 200),
        ("GET /viewer.js", &[], 200),
        ("GET /", &[&rebound], 403),
        ("GET /scene", &["Host: 127.0.0.1"], 403),
        ("GET /scene", &["Host: 127.0.0.1:1"], 403),
        ("GET /scene", &["Origin: http://evil.example"], 403),
        ("GET /scene", &["Origin: null"], 403),
        ("POST /move", &[], 403),
        ("POST /move", &["X-Scenelang-Token: 0"], 403),
        ("PUT /move", &[], 405),
        ("DELETE /", &[], 405),
        ("GET /meeting-room.scene", &[], 404),
        ("GET /../meeting-room.scene", &[], 404),
        ("GET /%2e%2e/meeting-room.scene", &[], 404),
        ("GET //etc/passwd", &[], 404),
        ("GET /viewer.js/../../Cargo.toml", &[], 404),
        // Without the secret, nothing at all.
        ("GET /", &["Cookie: a=b"], 403),
        ("GET /viewer.js", &["Cookie: a=b"], 403),
        ("GET /scene", &["Cookie: a=b"], 403),
        ("GET /events", &["Cookie: a=b"], 403),
        ("POST /move", &["Cookie: a=b"], 403),
        ("GET /nothing", &["Cookie: a=b"], 403),
        ("GET /", &[&format!("Cookie: scenelang-view-{port}={}", "0".repeat(64))], 403),
        ("GET /?key=", &["Cookie: a=b"], 403),
        (&format!("GET /?key={}", "0".repeat(64)), &["Cookie: a=b"], 403),
        (&format!("GET /scene?key={}", view.secret), &["Cookie: a=b"], 403),
        (&format!("GET /?key={}", view.secret), &["Cookie: a=b", &rebound], 403),
    ];
    for (line, headers, status) in cases {
        assert_eq!(view.ask(line, headers, "").status, *status, "{line} {headers:?}");
    }
    // With it, a cookie, and an address that does not have it.
    let exchanged = view.ask(&format!("GET /?key={}", view.secret), &["Cookie: a=b"], "");
    let cookie = format!("set-cookie: scenelang-view-{port}={}; httponly; samesite=strict; path=/\r\n", view.secret);
    assert!(exchanged.status == 303 && exchanged.head.contains(&cookie), "{}", exchanged.head);
    assert!(exchanged.head.contains("location: /\r\n") && exchanged.body.is_empty(), "{}", exchanged.head);
    let page = view.ask("GET /", &[], "");
    assert!(!page.body.contains(&view.secret) && !page.head.contains(&view.secret), "no script can read it");
    assert!(page.head.contains("content-security-policy: default-src 'none'; script-src 'self'"), "{}", page.head);
    assert!(page.head.contains("frame-ancestors 'none'") && page.head.contains("nosniff"));
    assert!(!page.body.contains("<script>"), "no script is inline");
    let room: Value = serde_json::from_str(&view.ask("GET /scene", &[], "").body).unwrap();
    assert_eq!(room["format"], "scenelang.preview/1");
    assert!(!room["glb"].as_str().unwrap().is_empty());
}

#[test]
fn what_a_language_server_names_is_selected() {
    if !there() {
        return;
    }
    let mut view = View::start_with(&["view", "--no-open", "--follow"], Stdio::piped());
    let mut input = view.child.stdin.take().unwrap();
    let mut events = view.follow();
    writeln!(input, "lamp").unwrap();
    assert_eq!(events.until("select"), "lamp");
    writeln!(input, "chair[2]").unwrap();
    assert_eq!(events.until("select"), "chair[2]");
    // A page that comes later has it, too.
    assert_eq!(view.follow().until("select"), "chair[2]");
    drop(input);
    assert!(view.child.wait().unwrap().success(), "it ends with the server");
}

#[test]
fn what_is_dragged_is_judged_and_written_when_let_go() {
    if !there() {
        return;
    }
    let view = View::start();
    let before = fs::read(&view.layout).unwrap();
    let away =
        |commit: bool| json!({ "object": "sideboard", "pos": [0.5, 0, -1.5], "rot": [0, 0, 0], "commit": commit });
    let judged = view.go(&away(false));
    assert_eq!(judged.status, 200, "{}", judged.body);
    let judged: Value = serde_json::from_str(&judged.body).unwrap();
    let fails = |v: &Value| v["constraints"].as_array().unwrap().iter().filter(|c| c["state"] == "fails").count();
    assert!(fails(&judged) > 0 && !judged["physical"].as_array().unwrap().is_empty(), "{judged}");
    assert_eq!(fs::read(&view.layout).unwrap(), before, "judging writes nothing");

    for (wrong, status, what) in [
        (json!({ "object": "nobody", "pos": [0, 0, 0], "rot": [0, 0, 0], "commit": true }), 400, "no such object"),
        (json!({ "object": "sideboard", "pos": [1e300, 0, 0], "rot": [0, 0, 0], "commit": true }), 400, "too far"),
        (json!({ "object": "sideboard", "pos": [0, 0], "rot": [0, 0, 0], "commit": true }), 400, "two numbers"),
        (json!("x".repeat(100_000)), 413, "too much"),
    ] {
        assert_eq!(view.go(&wrong).status, status, "{what}");
    }
    assert_eq!(fs::read(&view.layout).unwrap(), before, "what is refused writes nothing");

    // Whoever takes up another object has let go of the first.
    let home: Value = serde_json::from_slice(&before).unwrap();
    let home = &home["objects"]["lamp"];
    let still = json!({ "object": "lamp", "pos": home["pos"], "rot": home["rot"], "commit": false });
    let judged: Value = serde_json::from_str(&view.go(&still).body).unwrap();
    assert_eq!((fails(&judged), &judged["physical"]), (0, &json!([])), "{judged}");

    let first: Value = serde_json::from_str(&view.ask("GET /scene", &[], "").body).unwrap();
    let mut events = view.follow();
    events.until("changed");
    assert_eq!(view.go(&away(true)).status, 200);
    assert_eq!(view.pos("sideboard"), json!([0.5, 0, -1.5]));
    events.until("changed");
    let room: Value = serde_json::from_str(&view.ask("GET /scene", &[], "").body).unwrap();
    let shown = room["objects"].as_array().unwrap().iter().find(|o| o["name"] == "sideboard").unwrap();
    assert_eq!(shown["pos"], json!([0.5, 0.0, -1.5]));

    // Who has the geometry is told of places only; it is the same as before, for nothing was but moved.
    let shape = room["shape"].as_str().unwrap();
    assert_eq!(first["shape"], shape);
    let places = view.ask(&format!("GET /scene?known={shape}"), &[], "").body;
    let places: Value = serde_json::from_str(&places).unwrap();
    assert_eq!((&places["glb"], &places["objects"]), (&Value::Null, &room["objects"]));
    assert_eq!(first["glb"], room["glb"]);
    let other = view.ask("GET /scene?known=other", &[], "").body;
    assert_eq!(serde_json::from_str::<Value>(&other).unwrap(), room);

    // And back: only its place has changed in the file, which is no longer as `solve` wrote it.
    let home: Value = serde_json::from_slice(&before).unwrap();
    let home = &home["objects"]["sideboard"];
    let back = json!({ "object": "sideboard", "pos": home["pos"], "rot": home["rot"], "commit": true });
    assert_eq!(view.go(&back).status, 200);
    let after = fs::read_to_string(&view.layout).unwrap();
    let before = String::from_utf8(before).unwrap();
    let sum = before.lines().find(|line| line.starts_with("  \"written\": ")).expect("what is solved has a checksum");
    let before = before.replacen(&format!("{sum}\n"), "", 1);
    if let Some((n, (now, was))) = after.lines().zip(before.lines()).enumerate().find(|(_, (now, was))| now != was) {
        panic!("line {}: {was:?} became {now:?}", n + 1);
    }
    assert_eq!(after.len(), before.len());
}

#[test]
fn changes_of_others_are_shown_and_never_overwritten() {
    if !there() {
        return;
    }
    let mut view = View::start();
    let mut events = view.follow();
    events.until("changed");
    let text = fs::read_to_string(&view.layout).unwrap();

    // At the very moment: the server has not looked at the file yet.
    let other = text.replacen("\"seed\": 0", "\"seed\": 7", 1);
    fs::write(&view.layout, &other).unwrap();
    let asked = json!({ "object": "lamp", "pos": [0, 0, 0], "rot": [0, 0, 0], "commit": true });
    let answer = view.go(&asked);
    if answer.status == 409 {
        assert!(answer.body.contains("was changed in the meantime"), "{}", answer.body);
        assert_eq!(fs::read_to_string(&view.layout).unwrap(), other);
    } else {
        // It had looked already.
        assert!(fs::read_to_string(&view.layout).unwrap().contains("\"seed\": 7"));
    }

    fs::write(&view.layout, "{ broken").unwrap();
    assert!(!events.until("stale").is_empty());
    let answer = view.ask("GET /scene", &[], "");
    assert!(answer.status == 409 && answer.body.contains("error"), "{}", answer.body);
    fs::write(&view.layout, &text).unwrap();
    events.until("changed");

    let id = view.child.id().to_string();
    assert!(Command::new("kill").args(["-INT", &id]).status().unwrap().success());
    assert_eq!(view.child.wait().unwrap().code(), Some(0));
}

#[test]
fn a_layout_is_exported_as_it_is() {
    let (folder, scene) = folder_with("meeting-room");
    let run = |args: &[&str]| {
        let mut command = binary();
        command.args(args).current_dir(folder.path()).output().unwrap()
    };
    let layout = scene.with_extension("layout.json").display().to_string();
    assert_eq!(run(&["export", &layout]).status.code(), Some(2), "there is none yet");
    assert!(!Path::new(&folder.path().join("out")).exists());
    assert!(run(&["solve", &scene.display().to_string()]).status.success());
    // Moved by hand, and exported where it is.
    let text = fs::read_to_string(&layout).unwrap();
    let mut moved: Value = serde_json::from_str(&text).unwrap();
    moved["objects"]["sideboard"]["pos"] = json!([0.5, 0, -1.5]);
    fs::write(&layout, moved.to_string()).unwrap();
    assert_eq!(run(&["export", &layout, "--only", "glb,plan"]).status.code(), Some(1), "it breaks constraints");
    let mut names: Vec<_> = fs::read_dir(folder.path().join("out")).unwrap().map(|f| f.unwrap().file_name()).collect();
    names.sort();
    assert_eq!(
        names,
        [".scenelang-files.sha256", ".scenelang-manifest.json", "meeting-room.glb", "plan.png", "plan.svg"]
    );
    let again = run(&["check", "out/meeting-room.glb", "--format", "json"]);
    let report: Value = serde_json::from_slice(&again.stdout).unwrap();
    assert_eq!(report["ok"], false);
    assert_eq!(run(&["export", &layout, "--only", "fbx"]).status.code(), Some(2));
}
