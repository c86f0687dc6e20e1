//! The process that started us: when it is gone, so are we.

use std::path::Path;
use std::process::{Command, Stdio};
use std::thread;
use std::time::Duration;

/// How often we look.
const EVERY: Duration = Duration::from_secs(2);

/// Calls `gone` once the process has ended. Where that cannot be seen, the end of our input says it.
pub fn watch(process: u32, gone: impl FnOnce() + Send + 'static) {
    thread::spawn(move || {
        while is_alive(process) {
            thread::sleep(EVERY);
        }
        gone();
    });
}

fn is_alive(process: u32) -> bool {
    if Path::new("/proc/self").exists() {
        return Path::new(&format!("/proc/{process}")).exists();
    }
    if cfg!(unix) {
        let mut ask = Command::new("kill");
        ask.args(["-0", &process.to_string()]).stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null());
        return ask.status().map_or(true, |status| status.success());
    }
    true
}
