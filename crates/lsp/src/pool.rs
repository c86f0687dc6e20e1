//! A few threads that answer questions.

use std::collections::VecDeque;
use std::sync::{Arc, Condvar, Mutex, PoisonError};
use std::thread;

type Job = Box<dyn FnOnce() + Send>;

/// Threads that take jobs in order. They end with the pool.
pub struct Pool(Arc<Shared>);

#[derive(Default)]
struct Shared {
    jobs: Mutex<Jobs>,
    more: Condvar,
}

#[derive(Default)]
struct Jobs {
    waiting: VecDeque<Job>,
    closed: bool,
}

impl Pool {
    /// As many threads as there are processors, within reason.
    pub fn new() -> Self {
        let shared = Arc::new(Shared::default());
        let threads = thread::available_parallelism().map_or(2, usize::from).clamp(2, 4);
        for _ in 0..threads {
            let shared = Arc::clone(&shared);
            // Where no thread can be had, the others do the work.
            let _ = thread::Builder::new().name("reader".to_owned()).stack_size(8 << 20).spawn(move || shared.work());
        }
        Self(shared)
    }

    /// Does a job as soon as a thread is free.
    pub fn run(&self, job: impl FnOnce() + Send + 'static) {
        self.0.jobs.lock().unwrap_or_else(PoisonError::into_inner).waiting.push_back(Box::new(job));
        self.0.more.notify_one();
    }
}

impl Drop for Pool {
    fn drop(&mut self) {
        let mut jobs = self.0.jobs.lock().unwrap_or_else(PoisonError::into_inner);
        jobs.closed = true;
        jobs.waiting.clear();
        self.0.more.notify_all();
    }
}

impl Shared {
    fn work(&self) {
        loop {
            let mut jobs = self.jobs.lock().unwrap_or_else(PoisonError::into_inner);
            let job = loop {
                if let Some(job) = jobs.waiting.pop_front() {
                    break job;
                }
                if jobs.closed {
                    return;
                }
                jobs = self.more.wait(jobs).unwrap_or_else(PoisonError::into_inner);
            };
            drop(jobs);
            job();
        }
    }
}
