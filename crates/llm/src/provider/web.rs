//! Requests to a service that is no language model: JSON to it, JSON or a file from it, with the same care for keys, sizes,
//! times and redirections.

use super::Call;
use super::http::{Got, Http, check_base, is_private, verdict};
use super::key::Key;
use crate::error::Error;
use serde_json::Value;
use std::time::Duration;

/// A service.
pub struct Web {
    base: String,
    key: Option<Key>,
    timeout: Duration,
    largest: u64,
    stop: fn() -> bool,
    http: Http,
}

impl std::fmt::Debug for Web {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "Web({})", self.base)
    }
}

impl Web {
    /// A service at `base`, which gets `key` as a bearer. A request that takes longer than `timeout` has failed, and so has
    /// one whose answer is larger than so many bytes.
    ///
    /// # Errors
    /// The address is none, or the key would cross the network for all to read.
    pub fn new(
        base: &str,
        key: Option<Key>,
        timeout: Duration,
        largest: u64,
        stop: fn() -> bool,
    ) -> Result<Self, Error> {
        let base = base.trim_end_matches('/').to_owned();
        check_base(&base)?;
        if key.is_some() && !is_private(&base) {
            let say = format!("the key would be sent unencrypted: {base} must start with https");
            return Err(Error::Setup(say));
        }
        let http = Http::new(&base, timeout, largest, stop)?;
        Ok(Self { base, key, timeout, largest, stop, http })
    }

    /// Sends JSON; the body of the answer.
    ///
    /// # Errors
    /// No answer, a status that is no success, or somebody ended it.
    pub fn post(&self, path: &str, body: Value) -> Result<Vec<u8>, Error> {
        self.ask(path, body)
    }

    /// Asks for something.
    ///
    /// # Errors
    /// As for [`Self::post`].
    pub fn get(&self, path: &str) -> Result<Vec<u8>, Error> {
        self.ask(path, Value::Null)
    }

    fn ask(&self, path: &str, body: Value) -> Result<Vec<u8>, Error> {
        let bearer = self.key.as_ref().map(|key| ("authorization", format!("Bearer {}", key.reveal())));
        let call = Call { path: path.to_owned(), headers: bearer.into_iter().collect(), body };
        succeeded(self.http.post(&self.base, call, self.key.as_ref())?)
    }

    /// A file at an address that the service named. The key is not sent there, and the address is one that nobody can
    /// listen to, or on this machine where the service is, too.
    ///
    /// # Errors
    /// As for [`Self::post`], or the address is none of these.
    pub fn fetch(&self, url: &str) -> Result<Vec<u8>, Error> {
        let own = url.strip_prefix(&self.base).is_some_and(|rest| rest.starts_with('/'));
        let (base, path) = if own {
            (self.base.clone(), url[self.base.len()..].to_owned())
        } else {
            let host = url.strip_prefix("https://").filter(|rest| !rest.starts_with('/'));
            let Some(rest) = host else {
                return Err(Error::Malformed("it names a file at an address that is not https".to_owned()));
            };
            let end = rest.find('/').unwrap_or(rest.len());
            (format!("https://{}", &rest[..end]), rest[end..].to_owned())
        };
        check_base(&base)?;
        if !own && super::http::is_here(&base) {
            return Err(Error::Malformed("it names a file on this machine".to_owned()));
        }
        let http = Http::new(&base, self.timeout, self.largest, self.stop)?;
        succeeded(http.post(&base, Call { path, headers: Vec::new(), body: Value::Null }, None)?)
    }
}

fn succeeded(got: Got) -> Result<Vec<u8>, Error> {
    match verdict(&got) {
        None => Ok(got.body),
        Some(error) => Err(error),
    }
}
