//! The pages over HTTP, to this machine alone.
//!
//! Any page in the browser can send requests to a port of this machine. So only those are answered that are addressed to it
//! by one of its own names (another name that leads here is an attack, DNS rebinding), nothing may be read from another
//! origin, and a move needs a token that only our own page carries. No path of a request is ever a path of a file.

use super::live::{Move, Refused, Shown};
use crate::interrupt;
use std::collections::hash_map::RandomState;
use std::hash::BuildHasher;
use std::io::{self, Read, Write};
use std::net::{Ipv4Addr, SocketAddr};
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::Duration;
use tiny_http::{Header, Method, Request, Response, Server};

/// A move is a few numbers.
const MOST: u64 = 64 << 10;
/// Threads that answer.
const THREADS: usize = 4;
/// Pages that follow the room at a time.
const PAGES: usize = 32;
/// A page that is gone is noticed when it is written to.
const HEARTBEAT: Duration = Duration::from_secs(5);
/// Between two looks at Ctrl-C.
const TICK: Duration = Duration::from_millis(200);

const POLICY: &str = "default-src 'none'; script-src 'self'; connect-src 'self' blob: data:; img-src data: blob:; \
                      base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

/// What every thread has.
struct Site {
    shown: Arc<Shown>,
    viewer: &'static str,
    page: String,
    token: String,
    /// Names by which this server may be addressed.
    names: [String; 2],
    pages: AtomicUsize,
}

/// Listens on a port, 0: any that is free; says where.
///
/// # Errors
/// The port is taken, or may not be used.
pub fn start(port: u16, viewer: &'static str, shown: &Arc<Shown>) -> io::Result<SocketAddr> {
    let server = Server::http((Ipv4Addr::LOCALHOST, port)).map_err(io::Error::other)?;
    let address = server.server_addr().to_ip().ok_or_else(|| io::Error::other("no address"))?;
    let token = token();
    let page = include_str!("page.html").replace("{{token}}", &token);
    let names = [format!("127.0.0.1:{}", address.port()), format!("localhost:{}", address.port())];
    let site = Arc::new(Site { shown: shown.clone(), viewer, page, token, names, pages: AtomicUsize::new(0) });
    let server = Arc::new(server);
    for _ in 0..THREADS {
        let (site, server) = (site.clone(), server.clone());
        std::thread::spawn(move || {
            while !interrupt::asked() {
                if let Ok(Some(request)) = server.recv_timeout(TICK) {
                    answer(&site, request);
                }
            }
        });
    }
    Ok(address)
}

/// 128 bits that nobody can guess: what the standard library seeds its hash tables with comes from the system.
fn token() -> String {
    let half = || RandomState::new().hash_one(0_u8);
    format!("{:016x}{:016x}", half(), half())
}

fn answer(site: &Arc<Site>, mut request: Request) {
    let header = |name: &str| {
        let found = request.headers().iter().find(|h| h.field.as_str().as_str().eq_ignore_ascii_case(name));
        found.map(|h| h.value.as_str().to_owned())
    };
    let host = header("host").unwrap_or_default();
    let foreign = header("origin").is_some_and(|origin| origin != format!("http://{host}"));
    if !site.names.contains(&host) || foreign {
        return send(request, 403, "text/plain", "not for you");
    }
    let trusted = header("x-scenelang-token").is_some_and(|token| token == site.token);
    let (path, query) = request.url().split_once('?').unwrap_or((request.url(), ""));
    let (path, known) = (path.to_owned(), query.strip_prefix("known=").unwrap_or_default().to_owned());
    match (request.method(), path.as_str()) {
        (Method::Get, "/") => send(request, 200, "text/html", &site.page),
        (Method::Get, "/viewer.js") => send(request, 200, "text/javascript", site.viewer),
        (Method::Get, "/scene") => match site.shown.data(&known) {
            Ok(data) => send(request, 200, "application/json", &data),
            Err(why) => send(request, 409, "text/plain", &why),
        },
        (Method::Get, "/events") => {
            if site.pages.fetch_add(1, Ordering::SeqCst) >= PAGES {
                site.pages.fetch_sub(1, Ordering::SeqCst);
                return send(request, 503, "text/plain", "too many pages follow this room");
            }
            let site = site.clone();
            std::thread::spawn(move || {
                // It ends when the page is gone.
                let _ = follow(&site.shown, request.into_writer());
                site.pages.fetch_sub(1, Ordering::SeqCst);
            });
        }
        (Method::Post, "/move") if !trusted => send(request, 403, "text/plain", "not for you"),
        (Method::Post, "/move") => {
            let mut body = String::new();
            let read = request.as_reader().take(MOST).read_to_string(&mut body);
            let asked = read.map_err(|e| e.to_string()).and_then(|_| parse(&body));
            match asked.map_err(Refused::Wrong).and_then(|asked| site.shown.go(&asked)) {
                Ok(verdicts) => send(request, 200, "application/json", &verdicts.to_string()),
                Err(Refused::Wrong(why)) => send(request, 400, "text/plain", &why),
                Err(Refused::Changed(why)) => send(request, 409, "text/plain", &why),
                Err(Refused::Failed(why)) => send(request, 500, "text/plain", &why),
            }
        }
        (_, "/" | "/viewer.js" | "/scene" | "/events" | "/move") => send(request, 405, "text/plain", "not so"),
        _ => send(request, 404, "text/plain", "there is nothing"),
    }
}

fn parse(body: &str) -> Result<Move, String> {
    serde_json::from_str(body).map_err(|e| format!("this is no move: {e}"))
}

fn send(request: Request, status: u16, kind: &str, body: &str) {
    let mut response = Response::from_string(body).with_status_code(status);
    let kind = format!("{kind}; charset=utf-8");
    let headers = [
        ("Content-Type", kind.as_str()),
        ("Content-Security-Policy", POLICY),
        ("X-Content-Type-Options", "nosniff"),
        ("Cross-Origin-Resource-Policy", "same-origin"),
        ("Referrer-Policy", "no-referrer"),
        ("Cache-Control", "no-store"),
    ];
    for (name, value) in headers {
        if let Ok(header) = Header::from_bytes(name, value) {
            response.add_header(header);
        }
    }
    // Whoever asked may be gone.
    let _ = request.respond(response);
}

/// Tells a page of news until it is gone.
fn follow(shown: &Shown, mut page: Box<dyn Write + Send>) -> io::Result<()> {
    page.write_all(
        b"HTTP/1.1 200 OK\r\nContent-Type: text/event-stream\r\nCache-Control: no-store\r\n\
          X-Content-Type-Options: nosniff\r\nConnection: close\r\n\r\n",
    )?;
    page.flush()?;
    // What it is now is news to a page that has just come.
    let mut version = u64::MAX;
    while !interrupt::asked() {
        let (now, why) = shown.after(version, HEARTBEAT);
        match why {
            _ if now == version => page.write_all(b": still here\n\n")?,
            None => page.write_all(b"event: changed\ndata: 1\n\n")?,
            Some(why) => {
                let lines: String = why.lines().map(|line| format!("data: {line}\n")).collect();
                page.write_all(format!("event: stale\n{lines}\n").as_bytes())?;
            }
        }
        page.flush()?;
        version = now;
    }
    Ok(())
}
