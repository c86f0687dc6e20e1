//! What was spent, what may be, and how that is said at the end of a run.

use crate::error::Error;
use crate::message::{Request, Usage};
use std::fmt;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

/// What may be spent. Without a limit, as much as it takes.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Budget {
    /// Requests over the network, those that failed included.
    pub calls: Option<u64>,
    /// Tokens read and written.
    pub tokens: Option<u64>,
    /// Money, in the currency of the prices.
    pub money: Option<f64>,
}

impl Budget {
    /// The most requests of one run, unless the user says otherwise.
    pub const CALLS: u64 = 100;
    /// The most tokens of one run, unless the user says otherwise.
    pub const TOKENS: u64 = 500_000;

    /// What may be spent where nobody said anything: enough for a large scene, and little enough not to be regretted.
    pub fn standard() -> Self {
        Self { calls: Some(Self::CALLS), tokens: Some(Self::TOKENS), money: None }
    }
}

/// Shown, it is what a user reads before anything is spent.
impl fmt::Display for Budget {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.calls {
            Some(1) => write!(f, "at most 1 call")?,
            Some(calls) => write!(f, "at most {calls} calls")?,
            None => write!(f, "any number of calls")?,
        }
        match self.tokens {
            Some(tokens) => write!(f, " and {tokens} tokens")?,
            None => write!(f, " and any number of tokens")?,
        }
        match self.money {
            Some(money) => write!(f, ", for no more than {money}"),
            None => Ok(()),
        }
    }
}

/// What several sessions spend of one budget together.
#[derive(Clone, Debug, Default)]
pub struct Account(Arc<Mutex<Total>>);

#[derive(Clone, Copy, Debug, Default)]
struct Total {
    calls: u64,
    usage: Usage,
}

impl Account {
    /// Counts a request, if the budget has room for it; how long an answer may be (tokens).
    ///
    /// # Errors
    /// Which part of the budget is spent.
    pub(crate) fn begin(&self, spent: &Spent, budget: &Budget, request: &Request) -> Result<u64, Error> {
        let mut total = self.total();
        let room = Spent { calls: total.calls, usage: total.usage, ..spent.clone() }.admit(budget, request)?;
        total.calls += 1;
        Ok(room)
    }

    /// A request that was begun was not made.
    pub(crate) fn undo(&self) {
        let mut total = self.total();
        total.calls = total.calls.saturating_sub(1);
    }

    pub(crate) fn add(&self, usage: Usage) {
        self.total().usage.add(usage);
    }

    fn total(&self) -> MutexGuard<'_, Total> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// What a million tokens cost.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Price {
    /// Tokens read.
    pub input: f64,
    /// Tokens written.
    pub output: f64,
}

impl Price {
    fn of(&self, usage: &Usage) -> f64 {
        (usage.input as f64 * self.input + usage.output as f64 * self.output) / 1e6
    }
}

/// What was spent. Shown, it is the summary of a run.
#[derive(Clone, Debug, PartialEq)]
pub struct Spent {
    pub model: String,
    /// Requests over the network, those that failed included.
    pub calls: u64,
    /// How many of them were made again after a failure.
    pub again: u64,
    /// Answers that were in the cache.
    pub cached: u64,
    /// Tokens over the network.
    pub usage: Usage,
    /// What a token costs, if anybody said so.
    pub price: Option<Price>,
    /// Why an answer is not in the cache.
    pub unkept: Option<Error>,
}

impl Spent {
    pub(crate) fn new(model: &str, price: Option<Price>) -> Self {
        Self { model: model.to_owned(), calls: 0, again: 0, cached: 0, usage: Usage::default(), price, unkept: None }
    }

    /// What it cost; `None`: nobody said what a token costs.
    pub fn money(&self) -> Option<f64> {
        if self.calls == 0 { Some(0.0) } else { self.price.map(|p| p.of(&self.usage)) }
    }

    /// Whether the budget has room for a request, and for how long an answer (tokens).
    ///
    /// # Errors
    /// Which part of the budget is spent.
    pub(crate) fn admit(&self, budget: &Budget, request: &Request) -> Result<u64, Error> {
        let spent = |what: String| Err(Error::Spent(what));
        if let Some(most) = budget.calls
            && self.calls >= most
        {
            return spent(format!("{} of {most} calls", self.calls));
        }
        let question = Usage::estimate(request, "");
        let mut room = request.max_output;
        if let Some(most) = budget.tokens {
            room = room.min(most.saturating_sub(self.usage.total()).saturating_sub(question.input));
            if room == 0 {
                return spent(format!(
                    "{} of {most} tokens are used, and the next question needs more",
                    self.usage.total()
                ));
            }
        }
        if let (Some(most), Some(price)) = (budget.money, self.price) {
            let left = most - price.of(&self.usage) - price.of(&question);
            // One token more than fits is none.
            let fits = if price.output > 0.0 { left * 1e6 / price.output } else { f64::INFINITY };
            room = room.min(if left > 0.0 { fits as u64 } else { 0 });
            if room == 0 {
                let spent_so_far = price.of(&self.usage);
                return spent(format!(
                    "{spent_so_far:.4} of the money budget of {most} is spent, and the next question needs more"
                ));
            }
        }
        Ok(room)
    }

    pub(crate) fn add(&mut self, usage: Usage) {
        self.usage.add(usage);
    }
}

impl fmt::Display for Spent {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let calls = if self.calls == 1 { "call" } else { "calls" };
        write!(f, "{}: {} {calls}", self.model, self.calls)?;
        if self.again > 0 {
            write!(f, " ({} of them retried)", self.again)?;
        }
        if self.cached > 0 {
            write!(f, ", {} from the cache", self.cached)?;
        }
        if self.calls > 0 {
            let about = if self.usage.estimated { "about " } else { "" };
            write!(f, ", {about}{} tokens in, {about}{} out", self.usage.input, self.usage.output)?;
        }
        match self.money() {
            Some(money) => write!(f, ", cost {money:.4}")?,
            None => write!(f, ", cost unknown, because no price is set for this model")?,
        }
        match &self.unkept {
            Some(error) => write!(f, "; answers are not cached: {error}"),
            None => Ok(()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::message::{Message, Role, Schema};

    fn question(bytes: usize) -> Request {
        Request {
            messages: vec![Message::new(Role::User, "x".repeat(bytes - "null".len()))],
            schema: Schema { name: "s".into(), json: serde_json::Value::Null },
            temperature: None,
            seed: None,
            max_output: 1000,
        }
    }

    #[test]
    fn each_budget_stops_by_itself() {
        let price = Some(Price { input: 2.0, output: 10.0 });
        let mut spent = Spent::new("m", price);
        spent.calls = 3;
        spent.add(Usage { input: 5000, output: 1000, estimated: false });
        let money = |m: f64| Budget { money: Some(m), ..Budget::default() };
        let tokens = |t: u64| Budget { tokens: Some(t), ..Budget::default() };
        let calls = |c: u64| Budget { calls: Some(c), ..Budget::default() };
        for (budget, wanted) in [
            (Budget::default(), Ok(1000)),
            (calls(4), Ok(1000)),
            (calls(3), Err("3 of 3 calls")),
            (tokens(10_000), Ok(1000)),
            (tokens(6500), Ok(400)), // 6000 are spent, the question has 100
            (tokens(6100), Err("6000 of 6100 tokens are used, and the next question needs more")),
            (tokens(0), Err("6000 of 0 tokens are used, and the next question needs more")),
            (money(1.0), Ok(1000)),
            (money(0.0222), Ok(200)), // 0.02 are spent, the question is 0.0002
            (money(0.0202), Err("0.0200 of the money budget of 0.0202 is spent, and the next question needs more")),
            (money(f64::NAN), Err("0.0200 of the money budget of NaN is spent, and the next question needs more")),
        ] {
            let got = spent.admit(&budget, &question(300));
            assert_eq!(got, wanted.map_err(|w| Error::Spent(w.to_owned())), "{budget:?}");
        }
    }

    #[test]
    fn the_summary_does_not_guess() {
        let mut spent = Spent::new("openai:m", None);
        assert_eq!(spent.to_string(), "openai:m: 0 calls, cost 0.0000");
        spent.cached = 2;
        spent.calls = 1;
        spent.add(Usage { input: 1200, output: 34, estimated: false });
        let unknown = "openai:m: 1 call, 2 from the cache, 1200 tokens in, 34 out, cost unknown, because no price is set for this model";
        assert_eq!(spent.to_string(), unknown);
        spent.price = Some(Price { input: 2.5, output: 10.0 });
        spent.calls = 3;
        spent.again = 1;
        spent.add(Usage { input: 0, output: 0, estimated: true });
        let known =
            "openai:m: 3 calls (1 of them retried), 2 from the cache, about 1200 tokens in, about 34 out, cost 0.0033";
        assert_eq!(spent.to_string(), known);
    }
}
