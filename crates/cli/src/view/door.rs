//! Who may come in. Any page in the browser can send requests to a port of this machine, and so can any other user of it.
//! So a request must know a secret that was printed to the terminal of the user alone. It comes in the address once, becomes
//! a cookie that no script can read and no other site can send, and the browser is sent on to an address without it. Besides
//! that only requests are answered that are addressed to this server by one of its own names (another name that leads here
//! is an attack, DNS rebinding) and do not come from a page of another origin.

use hyper::HeaderMap;
use hyper::header::{COOKIE, HOST, HeaderName, ORIGIN};
use hyper::http::request::Parts;
use std::io;

/// 256 bits: nobody guesses them.
const BYTES: usize = 32;
/// What the secret is called in the address.
const KEY: &str = "key";

/// What becomes of a request at the door.
#[derive(Debug, PartialEq, Eq)]
pub enum Admission {
    /// It has the cookie.
    In,
    /// It has the secret in its address, and gets the cookie for it.
    Exchange,
    /// It gets nothing.
    Out,
}

/// The secret, and by which names this server is addressed.
pub struct Door {
    secret: String,
    /// Cookies do not know ports: the port is part of the name, so that two rooms can be shown at a time.
    cookie: String,
    names: [String; 2],
}

impl Door {
    /// For a server on this port.
    ///
    /// # Errors
    /// The system has no random numbers.
    pub fn new(port: u16) -> io::Result<Self> {
        let names = [format!("127.0.0.1:{port}"), format!("localhost:{port}")];
        Ok(Self { secret: secret()?, cookie: format!("scenelang-view-{port}"), names })
    }

    /// The address for the user.
    pub fn address(&self) -> String {
        format!("http://{}/?{KEY}={}", self.names[0], self.secret)
    }

    /// What a browser is to keep.
    pub fn cookie(&self) -> String {
        format!("{}={}; HttpOnly; SameSite=Strict; Path=/", self.cookie, self.secret)
    }

    /// Whether a request comes in.
    pub fn admit(&self, request: &Parts) -> Admission {
        let Some(host) = only(&request.headers, &HOST).filter(|host| self.names.iter().any(|name| name == host)) else {
            return Admission::Out;
        };
        let own = |origin: &str| origin.strip_prefix("http://") == Some(host);
        let foreign = request.headers.contains_key(ORIGIN) && !only(&request.headers, &ORIGIN).is_some_and(own);
        // Only a proxy is asked for a whole address.
        if foreign || request.uri.authority().is_some() {
            return Admission::Out;
        }
        if self.knows(&request.headers) {
            return Admission::In;
        }
        let given = request.uri.query().and_then(|query| query.strip_prefix(KEY)?.strip_prefix('='));
        match given {
            Some(given) if request.uri.path() == "/" && same(given, &self.secret) => Admission::Exchange,
            _ => Admission::Out,
        }
    }

    fn knows(&self, headers: &HeaderMap) -> bool {
        let texts = headers.get_all(COOKIE).iter().filter_map(|value| value.to_str().ok());
        let mut cookies = texts.flat_map(|text| text.split(';')).filter_map(|cookie| cookie.trim().split_once('='));
        cookies.any(|(name, value)| name == self.cookie && same(value, &self.secret))
    }
}

/// A header that is there once; one that is there twice may mean one thing to us and another to somebody else.
fn only<'h>(headers: &'h HeaderMap, name: &HeaderName) -> Option<&'h str> {
    let mut all = headers.get_all(name).iter();
    all.next().filter(|_| all.next().is_none()).and_then(|value| value.to_str().ok())
}

/// Compares in a time that does not tell where the first difference is.
fn same(given: &str, wanted: &str) -> bool {
    let differences = given.bytes().zip(wanted.bytes()).fold(0, |all, (a, b)| all | (a ^ b));
    given.len() == wanted.len() && differences == 0
}

/// A text that nobody can guess.
///
/// # Errors
/// The system has no random numbers.
pub fn secret() -> io::Result<String> {
    let mut bytes = [0; BYTES];
    getrandom::fill(&mut bytes).map_err(io::Error::other)?;
    Ok(bytes.iter().map(|byte| format!("{byte:02x}")).collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use hyper::Request;

    /// An address, headers, and what becomes of them.
    type Case<'a> = (&'a str, &'a [(&'a str, &'a str)], Admission);

    #[test]
    fn nobody_comes_in_without_the_secret() {
        let door = Door { secret: "s3cret".to_owned(), ..Door::new(80).unwrap() };
        let (host, cookie) = (("host", "127.0.0.1:80"), ("cookie", "a=b; scenelang-view-80=s3cret"));
        let cases: &[Case<'_>] = &[
            ("/", &[host, cookie], Admission::In),
            ("/scene?known=1", &[("host", "localhost:80"), cookie], Admission::In),
            ("/move", &[host, ("origin", "http://127.0.0.1:80"), cookie], Admission::In),
            ("/?key=s3cret", &[host], Admission::Exchange),
            ("/?key=s3cret", &[host, cookie], Admission::In),
            ("/", &[host], Admission::Out),
            ("/", &[cookie], Admission::Out),
            ("/?key=s3cre", &[host], Admission::Out),
            ("/?key=", &[host], Admission::Out),
            ("/?keys3cret", &[host], Admission::Out),
            ("/scene?key=s3cret", &[host], Admission::Out),
            ("/?key=s3cret", &[("host", "evil.example:80")], Admission::Out),
            ("/?key=s3cret", &[host, host], Admission::Out),
            ("/", &[host, ("cookie", "scenelang-view-81=s3cret")], Admission::Out),
            ("/", &[host, ("cookie", "scenelang-view-80=")], Admission::Out),
            ("/", &[host, ("cookie", "scenelang-view-80=wrong!; x")], Admission::Out),
            ("/", &[("host", "127.0.0.1"), cookie], Admission::Out),
            ("/", &[host, ("origin", "http://evil.example"), cookie], Admission::Out),
            ("/", &[host, ("origin", "http://localhost:80"), cookie], Admission::Out),
            ("/", &[host, ("origin", "null"), cookie], Admission::Out),
            ("http://127.0.0.1:80/", &[host, cookie], Admission::Out),
        ];
        for (uri, headers, wanted) in cases {
            let mut request = Request::builder().uri(*uri);
            for (name, value) in *headers {
                request = request.header(*name, *value);
            }
            let (parts, ()) = request.body(()).unwrap().into_parts();
            assert_eq!(door.admit(&parts), *wanted, "{uri} {headers:?}");
        }
    }

    #[test]
    fn secrets_differ() {
        let (a, b) = (secret().unwrap(), secret().unwrap());
        assert!(a != b && a.len() == 2 * BYTES && a.bytes().all(|c| c.is_ascii_hexdigit()));
    }
}
