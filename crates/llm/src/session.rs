//! What is asked in practice: a model, with the cache before it, the budget that is kept, waits and retries, the record of
//! what was said.

use crate::cache::Cache;
use crate::clock::Clock;
use crate::error::Error;
use crate::ledger::{Account, Budget, Price, Spent};
use crate::message::{Reply, Request};
use crate::model::{Model, json_of};
use crate::retry::Retry;
use crate::tape::Recorder;
use std::path::PathBuf;
use std::time::Duration;

/// A model that still does not know a part of the request after so many tries never will.
const MOST: u32 = 10;

/// How a session spends, waits and remembers.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Limits {
    /// How patient to be with what may pass.
    pub retry: Retry,
    /// At most so many requests are begun in a minute.
    pub per_minute: Option<f64>,
    /// What may be spent.
    pub budget: Budget,
    /// What a million tokens cost.
    pub price: Option<Price>,
    /// A folder for answers, so that a question is paid once.
    pub cache: Option<PathBuf>,
    /// A file for the conversation.
    pub record: Option<PathBuf>,
}

/// Says who is asked, and what may be spent.
type Announce = Box<dyn FnOnce(&str)>;

/// A model with everything around it.
pub struct Session {
    model: Box<dyn Model>,
    clock: Box<dyn Clock>,
    limits: Limits,
    cache: Option<Cache>,
    recorder: Option<Recorder>,
    account: Account,
    announce: Option<Announce>,
    spent: Spent,
    begun: Option<Duration>,
}

impl Session {
    /// Puts everything around a model.
    ///
    /// # Errors
    /// There is a budget of money, but no price; the record cannot be written.
    pub fn new(model: Box<dyn Model>, limits: Limits, clock: Box<dyn Clock>) -> Result<Self, Error> {
        let name = model.name().to_owned();
        if limits.budget.money.is_some() && limits.price.is_none() {
            return Err(Error::Setup(format!("a money budget needs a price, and none is set for {name}")));
        }
        let cache = limits.cache.as_deref().map(Cache::new);
        let recorder = limits.record.as_deref().map(|path| Recorder::new(path, &name)).transpose()?;
        let spent = Spent::new(&name, limits.price);
        let account = Account::default();
        Ok(Self { model, clock, limits, cache, recorder, account, announce: None, spent, begun: None })
    }

    /// Spends of an account that other sessions may spend of, too: the budget is that of all of them.
    #[must_use]
    pub fn spending_of(self, account: &Account) -> Self {
        Self { account: account.clone(), ..self }
    }

    /// Has a sentence said before the first request leaves: who is asked, and what may be spent.
    #[must_use]
    pub fn announced_by(self, say: impl FnOnce(&str) + 'static) -> Self {
        Self { announce: Some(Box::new(say)), ..self }
    }

    /// What was spent so far.
    pub fn spent(&self) -> &Spent {
        &self.spent
    }

    /// From the cache, else over the network.
    fn answer(&mut self, request: &Request) -> Result<Reply, Error> {
        let name = self.model.name();
        if let Some(reply) = self.cache.as_ref().and_then(|cache| cache.get(name, request)) {
            self.spent.cached += 1;
            return Ok(reply);
        }
        let reply = self.patiently(request)?;
        // What holds no JSON may be better the next time.
        if let Some(cache) = &self.cache
            && json_of(&reply.text).is_ok()
        {
            // The answer is paid for and good, kept or not.
            self.spent.unkept = cache.put(self.model.name(), request, &reply).err().or(self.spent.unkept.take());
        }
        Ok(reply)
    }

    /// Over the network, again if need be.
    fn patiently(&mut self, request: &Request) -> Result<Reply, Error> {
        let (mut tries, mut failures) = (0, 0);
        loop {
            let room = self.account.begin(&self.spent, &self.limits.budget, request)?;
            if let Err(error) = self.take_turn() {
                self.account.undo();
                return Err(error);
            }
            if self.model.reaches_out()
                && let Some(say) = self.announce.take()
            {
                say(&format!("asking the language model {}: {}", self.model.name(), self.limits.budget));
            }
            self.spent.calls += 1;
            self.spent.again += u64::from(tries > 0);
            tries += 1;
            let error = match self.model.ask(&Request { max_output: room, ..request.clone() }) {
                Ok(reply) => {
                    self.spent.add(reply.usage);
                    self.account.add(reply.usage);
                    return Ok(reply);
                }
                Err(error) => error,
            };
            match error {
                // Nobody was called.
                Error::Offline => {
                    self.spent.calls -= 1;
                    self.account.undo();
                }
                // No failure: the next request is another one.
                Error::Unsupported(_) if tries < MOST => continue,
                _ => {}
            }
            failures += 1;
            let wait = self.limits.retry.wait(failures, error.wait());
            match wait {
                Some(wait) if error.is_passing() && failures < self.limits.retry.tries => {
                    if !self.clock.sleep(wait) {
                        return Err(Error::Interrupted);
                    }
                }
                _ if failures > 1 => return Err(Error::GaveUp(failures, Box::new(error))),
                _ => return Err(error),
            }
        }
    }

    /// Waits until the next request may begin.
    fn take_turn(&mut self) -> Result<(), Error> {
        if let Some(rate) = self.limits.per_minute
            && let Some(begun) = self.begun
        {
            let gap = Duration::try_from_secs_f64(60.0 / rate).unwrap_or(Duration::MAX);
            let left = begun.saturating_add(gap).saturating_sub(self.clock.now());
            if !left.is_zero() && !self.clock.sleep(left) {
                return Err(Error::Interrupted);
            }
        }
        self.begun = Some(self.clock.now());
        Ok(())
    }
}

impl Model for Session {
    fn name(&self) -> &str {
        self.model.name()
    }

    fn ask(&mut self, request: &Request) -> Result<Reply, Error> {
        let answer = self.answer(request);
        if let Some(recorder) = &mut self.recorder {
            recorder.add(request, &answer)?;
        }
        answer
    }
}
