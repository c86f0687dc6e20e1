//! What is answered to those who come in: the page, the room, its news, and moves. No path of a request is ever a path of a
//! file.

use super::body::{ResponseBody, Untaken, is_larger, read};
use super::connection::Connection;
use super::door::{Admission, Door, secret};
use super::live::{Move, News, Refused, Shown};
use hyper::body::{Bytes, Incoming};
use hyper::header::{HeaderName, HeaderValue};
use hyper::http::request::Parts;
use hyper::{Method, Request, Response, StatusCode};
use std::io;
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::Duration;
use tokio::sync::{mpsc, watch};
use tokio::time::timeout;

/// A move is a few numbers.
const MOST: usize = 64 << 10;
/// Pages that follow the room at a time.
const PAGES: usize = 32;
/// A page that is gone is noticed when it is written to.
const HEARTBEAT: Duration = Duration::from_secs(5);
/// How long the body of a request may take.
const PATIENCE: Duration = Duration::from_secs(10);

const HEADERS: [(&str, &str); 6] = [
    (
        "content-security-policy",
        "default-src 'none'; script-src 'self'; connect-src 'self' blob: data:; img-src data: blob:; base-uri 'none'; \
         form-action 'none'; frame-ancestors 'none'",
    ),
    ("x-content-type-options", "nosniff"),
    ("cross-origin-resource-policy", "same-origin"),
    ("cross-origin-opener-policy", "same-origin"),
    ("referrer-policy", "no-referrer"),
    ("cache-control", "no-store"),
];

/// What is shown, and to whom.
pub struct Site {
    door: Door,
    shown: Arc<Shown>,
    viewer: &'static str,
    page: String,
    /// Only our own page has it: a move needs it besides the cookie, which a page on another port of this machine can send.
    token: String,
    news: watch::Receiver<News>,
    pages: AtomicUsize,
}

impl Site {
    /// A site behind a door.
    ///
    /// # Errors
    /// The system has no random numbers.
    pub fn new(door: Door, viewer: &'static str, shown: Arc<Shown>, news: watch::Receiver<News>) -> io::Result<Self> {
        let token = secret()?;
        let page = include_str!("page.html").replace("{{token}}", &token);
        Ok(Self { door, shown, viewer, page, token, news, pages: AtomicUsize::new(0) })
    }

    /// Answers a request.
    pub async fn answer(
        self: Arc<Self>,
        connection: Arc<Connection>,
        request: Request<Incoming>,
    ) -> Response<ResponseBody> {
        let (parts, body) = request.into_parts();
        match self.door.admit(&parts) {
            Admission::Out => {
                return text(StatusCode::FORBIDDEN, "access denied: open the address that `scenelang view` printed");
            }
            _ if is_larger(&body, MOST) => return text(StatusCode::PAYLOAD_TOO_LARGE, "the request is too large"),
            Admission::Exchange => {
                let mut response = text(StatusCode::SEE_OTHER, "");
                set(&mut response, "location", "/");
                set(&mut response, "set-cookie", &self.door.cookie());
                return response;
            }
            Admission::In => connection.trust(),
        }
        match (&parts.method, parts.uri.path()) {
            (&Method::GET, "/") => send(StatusCode::OK, "text/html", self.page.clone()),
            (&Method::GET, "/viewer.js") => {
                send(StatusCode::OK, "text/javascript", Bytes::from_static(self.viewer.as_bytes()))
            }
            (&Method::GET, "/scene") => self.scene(&parts),
            (&Method::GET, "/events") => self.events(&connection),
            (&Method::POST, "/move") => self.go(&parts, body).await,
            (_, "/" | "/viewer.js" | "/scene" | "/events" | "/move") => text(StatusCode::METHOD_NOT_ALLOWED, "not so"),
            _ => text(StatusCode::NOT_FOUND, "there is nothing"),
        }
    }

    fn scene(&self, parts: &Parts) -> Response<ResponseBody> {
        let known = parts.uri.query().and_then(|query| query.strip_prefix("known=")).unwrap_or_default();
        match self.shown.data(known) {
            Ok(data) => send(StatusCode::OK, "application/json", data),
            Err(why) => text(StatusCode::CONFLICT, why),
        }
    }

    async fn go(&self, parts: &Parts, body: Incoming) -> Response<ResponseBody> {
        let token = parts.headers.get("x-scenelang-token");
        if token.is_none_or(|token| token != self.token.as_str()) {
            return text(StatusCode::FORBIDDEN, "the token is missing or wrong");
        }
        let bytes = match timeout(PATIENCE, read(body, MOST)).await {
            Ok(Ok(bytes)) => bytes,
            Ok(Err(Untaken::TooLarge)) => return text(StatusCode::PAYLOAD_TOO_LARGE, "the request is too large"),
            Ok(Err(Untaken::Broken)) => return text(StatusCode::BAD_REQUEST, "the request was cut off"),
            Err(_) => return text(StatusCode::REQUEST_TIMEOUT, "the request did not end in time"),
        };
        let asked: Move = match serde_json::from_slice(&bytes) {
            Ok(asked) => asked,
            Err(e) => return text(StatusCode::BAD_REQUEST, format!("this is not a valid move: {e}")),
        };
        // Judging takes a while; the other pages are answered meanwhile.
        let shown = Arc::clone(&self.shown);
        match tokio::task::spawn_blocking(move || shown.go(&asked)).await {
            Ok(Ok(verdicts)) => send(StatusCode::OK, "application/json", verdicts.to_string()),
            Ok(Err(Refused::Wrong(why))) => text(StatusCode::BAD_REQUEST, why),
            Ok(Err(Refused::Changed(why))) => text(StatusCode::CONFLICT, why),
            Ok(Err(Refused::Failed(why))) => text(StatusCode::INTERNAL_SERVER_ERROR, why),
            Err(_) => text(StatusCode::INTERNAL_SERVER_ERROR, "the move could not be checked"),
        }
    }

    /// Tells a page of news until it is gone.
    fn events(self: &Arc<Self>, connection: &Connection) -> Response<ResponseBody> {
        if self.pages.fetch_add(1, Ordering::SeqCst) >= PAGES {
            self.pages.fetch_sub(1, Ordering::SeqCst);
            return text(StatusCode::SERVICE_UNAVAILABLE, "too many pages are following this room");
        }
        connection.follow();
        let (page, lines) = mpsc::channel(1);
        let site = Arc::clone(self);
        tokio::spawn(async move {
            let mut news = site.news.clone();
            // What it is now is news to a page that has just come.
            let mut told: Option<News> = None;
            loop {
                let now = news.borrow_and_update().clone();
                let lines = events(told.as_ref(), &now);
                told = Some(now);
                if page.send(lines).await.is_err() {
                    break;
                }
                if let Ok(Err(_)) = timeout(HEARTBEAT, news.changed()).await {
                    break;
                }
            }
            site.pages.fetch_sub(1, Ordering::SeqCst);
        });
        respond(StatusCode::OK, "text/event-stream", ResponseBody::News(lines))
    }
}

/// What a page that knows of some news is to be told.
fn events(told: Option<&News>, now: &News) -> Bytes {
    let event = |kind: &str, data: &str| {
        let lines: String = data.lines().map(|line| format!("data: {line}\n")).collect();
        format!("event: {kind}\n{lines}\n")
    };
    let mut out = String::new();
    if told.is_none_or(|told| told.rooms != now.rooms) {
        out += &now.why.as_ref().map_or_else(|| event("changed", "1"), |why| event("stale", why));
    }
    if told.map_or(0, |told| told.selections) != now.selections {
        out += &event("select", &now.selected);
    }
    if out.is_empty() {
        out += ": still here\n\n";
    }
    Bytes::from(out)
}

fn text(status: StatusCode, said: impl Into<Bytes>) -> Response<ResponseBody> {
    send(status, "text/plain", said)
}

fn send(status: StatusCode, kind: &str, body: impl Into<Bytes>) -> Response<ResponseBody> {
    respond(status, kind, ResponseBody::Whole(body.into()))
}

fn respond(status: StatusCode, kind: &str, body: ResponseBody) -> Response<ResponseBody> {
    let mut response = Response::new(body);
    *response.status_mut() = status;
    for (name, value) in HEADERS {
        set(&mut response, name, value);
    }
    set(&mut response, "content-type", &format!("{kind}; charset=utf-8"));
    response
}

fn set(response: &mut Response<ResponseBody>, name: &'static str, value: &str) {
    if let Ok(value) = HeaderValue::from_str(value) {
        response.headers_mut().insert(HeaderName::from_static(name), value);
    }
}
