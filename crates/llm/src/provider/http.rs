//! One request over HTTP: bounded in time and size, given up when somebody asks for it, and what its status means.

use super::wait;
use super::{Call, Key};
use crate::error::{Error, plain};
use serde_json::Value;
use std::io::Read;
use std::sync::Arc;
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::time::Duration;
use ureq::http::Uri;
use ureq::tls::{Certificate, RootCerts, TlsConfig};

/// How often it is looked whether somebody wants to end it.
const LOOK: Duration = Duration::from_millis(50);
/// How long a connection may take.
const CONNECT: Duration = Duration::from_secs(15);
/// How much of what a server says goes into an error (characters).
const SAID: usize = 300;

/// What a server answered.
pub(super) struct Got {
    pub status: u16,
    pub wait: Option<Duration>,
    pub body: Vec<u8>,
}

/// Makes requests to one server.
pub(super) struct Http {
    agent: ureq::Agent,
    timeout: Duration,
    largest: u64,
    stop: fn() -> bool,
}

impl Http {
    /// For a server at `base`.
    ///
    /// # Errors
    /// It takes certificates, and the system has none.
    pub fn new(base: &str, timeout: Duration, largest: u64, stop: fn() -> bool) -> Result<Self, Error> {
        let mut config = ureq::Agent::config_builder()
            .timeout_global(Some(timeout))
            .timeout_connect(Some(CONNECT.min(timeout)))
            .http_status_as_error(false)
            // Whoever answers elsewhere must not get the key.
            .max_redirects(0)
            .max_redirects_will_error(false)
            .user_agent(concat!("scenelang/", env!("CARGO_PKG_VERSION")));
        if base.starts_with("https:") {
            config = config.tls_config(tls()?);
        }
        if is_here(base) {
            config = config.proxy(None);
        }
        Ok(Self { agent: config.build().new_agent(), timeout, largest, stop })
    }

    /// Sends `call` to `base`; without a body it asks for something that is there.
    ///
    /// # Errors
    /// No answer, one that is too large, or somebody ended it. A status that is no success is none of these.
    pub fn post(&self, base: &str, call: Call, key: Option<&Key>) -> Result<Got, Error> {
        let (agent, largest, timeout) = (self.agent.clone(), self.largest, self.timeout);
        let url = format!("{base}{}", call.path);
        let (send, receive) = channel();
        // Of its own, so that it can be given up at once: nothing ends a read from a network but time.
        std::thread::spawn(move || send.send(exchange(&agent, &url, &call, largest, timeout)));
        let got = loop {
            if (self.stop)() {
                return Err(Error::Interrupted);
            }
            match receive.recv_timeout(LOOK) {
                Ok(got) => break got,
                Err(RecvTimeoutError::Timeout) => {}
                Err(RecvTimeoutError::Disconnected) => {
                    break Err(Error::Unreachable("the connection was closed during the request".into()));
                }
            }
        };
        let Some(key) = key else { return got };
        match got {
            Ok(got) => Ok(Got { body: key.redact(got.body), ..got }),
            Err(Error::Unreachable(said)) => {
                Err(Error::Unreachable(String::from_utf8_lossy(&key.redact(said.into_bytes())).into_owned()))
            }
            error => error,
        }
    }
}

fn exchange(agent: &ureq::Agent, url: &str, call: &Call, largest: u64, timeout: Duration) -> Result<Got, Error> {
    let broken = |e: &dyn std::fmt::Display| Error::Unreachable(plain(&e.to_string(), SAID));
    let failed = |e: ureq::Error| match e {
        ureq::Error::Timeout(_) => Error::TimedOut(timeout),
        other => broken(&other),
    };
    let sent = if call.body.is_null() {
        call.headers.iter().fold(agent.get(url), |request, (name, value)| request.header(*name, value)).call()
    } else {
        let request = agent.post(url).header("content-type", "application/json");
        let request = call.headers.iter().fold(request, |request, (name, value)| request.header(*name, value));
        request.send(call.body.to_string().as_bytes())
    };
    let mut answer = sent.map_err(failed)?;
    let header = |name: &str| answer.headers().get(name).and_then(|v| v.to_str().ok());
    let (status, wait) = (answer.status().as_u16(), wait::asked(header));
    let mut body = Vec::new();
    // One byte more than allowed tells too large from just right.
    let reader = answer.body_mut().as_reader().take(largest.saturating_add(1)).read_to_end(&mut body);
    if body.len() as u64 > largest {
        return Err(Error::TooLarge(largest));
    }
    if let Err(e) = reader {
        let late = e.get_ref().and_then(|e| e.downcast_ref::<ureq::Error>());
        return Err(match late {
            Some(ureq::Error::Timeout(_)) => Error::TimedOut(timeout),
            _ => broken(&e),
        });
    }
    Ok(Got { status, wait, body })
}

/// Certificates of the system, ring for the arithmetic.
fn tls() -> Result<TlsConfig, Error> {
    let found = rustls_native_certs::load_native_certs();
    if found.certs.is_empty() {
        let say = "the system has no certificates to verify servers with (on Debian: apt-get install ca-certificates)";
        return Err(Error::Setup(say.into()));
    }
    let roots: Vec<Certificate<'static>> =
        found.certs.iter().map(|c| Certificate::from_der(c.as_ref()).to_owned()).collect();
    Ok(TlsConfig::builder()
        .root_certs(RootCerts::from(roots))
        .unversioned_rustls_crypto_provider(Arc::new(rustls::crypto::ring::default_provider()))
        .build())
}

/// Whether a URL can be the beginning of others.
///
/// # Errors
/// What is wrong with it; it is not repeated where it may hold a secret.
pub(super) fn check_base(base: &str) -> Result<(), Error> {
    let setup = |why: String| Err(Error::Setup(why));
    if base.contains('@') {
        return setup("a base URL must not contain a user or a password; keys come from the environment".into());
    }
    let shown = plain(base, 100);
    let Ok(uri) = base.parse::<Uri>() else { return setup(format!("`{shown}` is not a base URL")) };
    if uri.host().is_none_or(str::is_empty) || uri.query().is_some() {
        return setup(format!("`{shown}` is not a base URL"));
    }
    if !matches!(uri.scheme_str(), Some("https" | "http")) {
        return setup(format!("`{shown}` must start with https:// or http://"));
    }
    Ok(())
}

/// Whether what is sent there can be read on the way by nobody: it is encrypted, or stays on this machine.
pub(super) fn is_private(base: &str) -> bool {
    base.starts_with("https:") || is_here(base)
}

pub(super) fn is_here(base: &str) -> bool {
    let uri = base.parse::<Uri>().ok();
    matches!(uri.as_ref().and_then(Uri::host), Some("localhost" | "127.0.0.1" | "[::1]"))
}

/// The error that a status means, if it means one.
pub(super) fn verdict(got: &Got) -> Option<Error> {
    let (status, wait) = (got.status, got.wait);
    let said = || said(&got.body);
    match status {
        200..=299 => None,
        // Waiting does not fill an empty purse.
        429 if said().contains("insufficient_quota") => Some(Error::Refused { status, said: said() }),
        429 => Some(Error::Limited { wait, said: said() }),
        408 | 425 | 500..=599 => Some(Error::Failed { status, wait, said: said() }),
        300..=399 => {
            Some(Error::Refused { status, said: "it redirects to another host, which must not receive the key".into() })
        }
        _ => Some(Error::Refused { status, said: said() }),
    }
}

/// The message in the body of an error, as providers write it; else its beginning.
fn said(body: &[u8]) -> String {
    let json: Option<Value> = serde_json::from_slice(body).ok();
    let inner = json.as_ref().map(|v| v.get("error").unwrap_or(v));
    let text = |v: &Value| v.as_str().map(str::to_owned);
    let message = inner.and_then(|e| text(e).or_else(|| e.get("message").and_then(text)));
    let code = inner.and_then(|e| e.get("code").or(e.get("type"))).and_then(text);
    match (message, code) {
        (Some(message), Some(code)) => plain(&format!("{message} ({code})"), SAID),
        (Some(message), None) => plain(&message, SAID),
        (None, _) => plain(&String::from_utf8_lossy(&body[..body.len().min(4 * SAID)]), SAID),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_key_stays_private() {
        for (base, wanted) in [
            ("https://api.example", true),
            ("http://127.0.0.1:8080/v1", true),
            ("http://localhost:8080", true),
            ("http://[::1]:8080", true),
            ("http://10.0.0.2", false),
            ("http://localhost.example", false),
        ] {
            assert_eq!(is_private(base), wanted, "{base}");
        }
    }

    #[test]
    fn what_servers_say_is_found() {
        for (body, wanted) in [
            (r#"{"error": {"message": "no\u001b[31m", "code": "bad"}}"#, "no [31m (bad)"),
            (
                r#"{"type": "error", "error": {"type": "overloaded_error", "message": "later"}}"#,
                "later (overloaded_error)",
            ),
            (r#"{"error": "model not found"}"#, "model not found"),
            (r#"{"message": "hm"}"#, "hm"),
            ("<html>\n<h1>502</h1>", "<html> <h1>502</h1>"),
            ("", ""),
        ] {
            assert_eq!(said(body.as_bytes()), wanted);
        }
        assert_eq!(said(&[0xff; 10_000]).chars().count(), SAID + 1);
    }

    #[test]
    fn a_connection_with_certificates_can_be_prepared() {
        // Where there are none, the error says so; it must not panic either way.
        match Http::new("https://api.example", Duration::from_secs(1), 10, || false) {
            Ok(_) => {}
            Err(e) => assert!(e.to_string().contains("certificates"), "{e}"),
        }
    }
}
