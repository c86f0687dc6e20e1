//! `scenelang view` among hundreds of connections that mean it no good: it stays up, and answers who knows the secret.
#![cfg(unix)]

use crate::view::{View, there};
use serde_json::json;
use std::io::{ErrorKind, Read, Write};
use std::net::{Shutdown, TcpStream};
use std::time::{Duration, Instant};

/// How many there are, of each kind the same number.
const ALL: usize = 400;
/// A server that reads no more is not written to any longer.
const ENOUGH: Duration = Duration::from_millis(20);

/// What is sent, and whether it goes on like that for as long as anybody reads.
struct Kind {
    name: &'static str,
    start: Vec<u8>,
    rest: Option<&'static [u8]>,
}

fn kinds(view: &View) -> Vec<Kind> {
    let (host, cookie) = (format!("Host: {}", view.address), view.cookie());
    let kind =
        |name: &'static str, start: String, rest: Option<&'static [u8]>| Kind { name, start: start.into(), rest };
    let post = |head: &str| format!("POST /move HTTP/1.1\r\n{host}\r\n{cookie}\r\n{head}\r\n\r\n");
    vec![
        kind("says nothing", String::new(), None),
        kind("half a line", "GET /sce".to_owned(), None),
        kind("half a head", format!("GET / HTTP/1.1\r\n{host}\r\n"), None),
        kind(
            "a head without an end",
            format!("GET / HTTP/1.1\r\n{host}\r\nX: "),
            Some(b"aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa"),
        ),
        kind("lines without an end", format!("GET / HTTP/1.1\r\n{host}\r\n"), Some(b"X-A: b\r\nX-C: d\r\n")),
        kind("an address without an end", "GET /".to_owned(), Some(b"../../../../../../../../../../")),
        kind("the body of a giant", post("Content-Length: 1099511627776"), Some(b"{\"object\":\"lamp\"}")),
        kind("no length", post("Transfer-Encoding: chunked"), Some(b"10\r\n0123456789abcdef\r\n")),
        kind("two lengths", post("Content-Length: 5\r\nContent-Length: 50"), Some(b"0123456789")),
        kind("a length below zero", post("Content-Length: -1"), Some(b"0123456789")),
        kind("a giant piece", post("Transfer-Encoding: chunked") + "fffffffffffffffff\r\n", Some(b"0123456789")),
        kind("half a body", post("Content-Length: 100") + "{", None),
        kind("a wrong secret", format!("GET /scene HTTP/1.1\r\n{host}\r\nCookie: {}\r\n\r\n", "0".repeat(64)), None),
        kind("no secret", format!("GET /events HTTP/1.1\r\n{host}\r\n\r\n"), None),
        kind("another host", format!("GET /scene HTTP/1.1\r\nHost: evil.example\r\n{cookie}\r\n\r\n"), None),
        kind(
            "another origin",
            format!("GET /scene HTTP/1.1\r\n{host}\r\nOrigin: http://evil.example\r\n{cookie}\r\n\r\n"),
            None,
        ),
        kind("no HTTP", "\u{0}\u{1}\u{2}\r\n\r\n\u{fffd}".to_owned(), Some(b"\xff\x00\xfe")),
        kind("TLS", "\u{16}\u{3}\u{1}\u{2}\u{0}\u{1}\u{0}\u{1}".to_owned(), None),
        kind("HTTP/2", "PRI * HTTP/2.0\r\n\r\nSM\r\n\r\n".to_owned(), Some(b"\0\0\0\x04\0\0\0\0\0")),
        // What ended tiny_http, the library before: a header with nothing before its colon, and one of no text.
        kind("strange names", "GET / HTTP/1.1\r\n: x\r\nHost\r\n\u{e9}: \u{0}\r\n\r\n".to_owned(), None),
    ]
}

/// Writes until nobody takes any more; the connection stays open.
fn attack(view: &View, kind: &Kind) -> TcpStream {
    let mut stream = TcpStream::connect(&view.address).unwrap();
    stream.set_write_timeout(Some(ENOUGH)).unwrap();
    // Whoever is hung up on has what he wanted: an error here is an answer.
    let mut going = stream.write_all(&kind.start).is_ok();
    let rest = kind.rest.map(|rest| rest.repeat(4096 / rest.len()));
    let mut sent = 0;
    while let (true, Some(rest), true) = (going, &rest, sent < 256 << 10) {
        going = stream.write_all(rest).is_ok();
        sent += rest.len();
    }
    stream
}

#[test]
fn hundreds_who_mean_no_good_are_in_nobodys_way() {
    if !there() {
        return;
    }
    let mut view = View::start();
    let drag = json!({ "object": "lamp", "pos": [0.5, 0, 0.25], "rot": [0, 30, 0], "commit": false });
    let before = view.go(&drag);
    assert_eq!(before.status, 200, "{}", before.body);
    let mut page = view.follow();
    page.until("changed");

    let kinds = kinds(&view);
    let open: Vec<TcpStream> = (0..ALL).map(|n| attack(&view, &kinds[n % kinds.len()])).collect();
    let token = view.token();
    let mut longest = Duration::ZERO;
    for _ in 0..10 {
        let since = Instant::now();
        let among = view.go_with(&token, &drag);
        longest = longest.max(since.elapsed());
        assert_eq!((among.status, &among.body), (200, &before.body), "the same verdict as in peace");
    }
    eprintln!("among {ALL} hostile connections, the slowest of 10 moves was judged in {longest:?}");
    assert!(view.child.try_wait().unwrap().is_none(), "it has ended");

    // And what each of them got is no room: nothing, or a refusal.
    for (n, mut stream) in open.into_iter().enumerate() {
        let name = kinds[n % kinds.len()].name;
        let _ = stream.shutdown(Shutdown::Write);
        stream.set_read_timeout(Some(Duration::from_secs(60))).unwrap();
        let mut said = Vec::new();
        match stream.read_to_end(&mut said) {
            Ok(_) => {}
            Err(e) => assert!(!matches!(e.kind(), ErrorKind::WouldBlock | ErrorKind::TimedOut), "{name}: {e}"),
        }
        let said = String::from_utf8_lossy(&said);
        let refused =
            ["HTTP/1.1 400 ", "HTTP/1.1 403 ", "HTTP/1.1 408 ", "HTTP/1.1 413 ", "HTTP/1.1 414 ", "HTTP/1.1 431 "];
        assert!(said.is_empty() || refused.iter().any(|status| said.starts_with(status)), "{name}: {said}");
        assert!(!said.contains(&view.secret) && !said.contains(&token), "{name}: {said}");
    }

    // The page that was open all the time is still told of news.
    let text = std::fs::read_to_string(&view.layout).unwrap();
    std::fs::write(&view.layout, "{ broken").unwrap();
    page.until("stale");
    std::fs::write(&view.layout, text).unwrap();
    page.until("changed");
    assert_eq!(view.go(&drag).status, 200);
}

#[test]
fn what_is_too_large_is_refused_unread() {
    if !there() {
        return;
    }
    let view = View::start();
    let head = |length: usize| {
        format!(
            "POST /move HTTP/1.1\r\nHost: {}\r\n{}\r\nX-Scenelang-Token: {}\r\nContent-Length: {length}\r\n\r\n",
            view.address,
            view.cookie(),
            view.token()
        )
    };
    // Not one byte of the body is sent, and the answer comes.
    for length in [(64 << 10) + 1, 1 << 40] {
        assert_eq!(view.say(&head(length)).status, 413, "{length}");
    }
    let most = " ".repeat(64 << 10);
    assert_eq!(view.say(&(head(most.len()) + &most)).status, 400, "as large as it may be, but no move");
    let pieces = head(0).replace("Content-Length: 0", "Transfer-Encoding: chunked");
    let piece = format!("8000\r\n{}\r\n", " ".repeat(0x8000));
    assert_eq!(view.say(&(pieces + &piece.repeat(2) + "1\r\n \r\n")).status, 413);
}
