//! `scenelang mcp`: an assistant's tools over standard input and output, by the Model Context Protocol. What a tool does is
//! what the command of that name does; what is said of it is short, in names and sentences instead of positions.
//!
//! Absent here: the protocol, which is `rmcp`'s.

mod judging;
mod looking;
mod making;
mod resources;
mod server;
mod tools;
mod verdict;
mod workspace;

use crate::args::Mcp;
use crate::{FAILED, GOOD};
use rmcp::ServiceExt;
use rmcp::transport::async_rw::AsyncRwTransport;
use server::Server;
use std::time::Duration;
use workspace::Workspace;

/// The longest message that is read (bytes).
const MESSAGE: usize = 8 << 20;
/// Threads of the runtime: two for calls, and one each to read and to write.
const THREADS: usize = server::WORKERS + 2;
/// As much as the main thread has: programs may be nested deeply.
const STACK: usize = 8 << 20;

/// Serves until the client closes standard input.
pub fn run(args: &Mcp) -> u8 {
    let workspace = match Workspace::open(&args.folder, args.write) {
        Ok(workspace) => workspace,
        Err(message) => return fail(&message),
    };
    let server = Server::new(workspace, Duration::from_secs_f64(args.time));
    let mut builder = tokio::runtime::Builder::new_current_thread();
    let runtime = match builder.enable_all().max_blocking_threads(THREADS).thread_stack_size(STACK).build() {
        Ok(runtime) => runtime,
        Err(e) => return fail(&format!("cannot start the server: {e}")),
    };
    let transport = AsyncRwTransport::new_server(tokio::io::stdin(), tokio::io::stdout()).with_max_line_length(MESSAGE);
    let served = runtime.block_on(async {
        let running = server.serve(transport).await.map_err(|e| e.to_string())?;
        running.waiting().await.map_err(|e| e.to_string())
    });
    // Whoever has gone does not wait for what is still being worked on.
    runtime.shutdown_background();
    match served {
        Ok(_) => GOOD,
        Err(message) => fail(&format!("the connection to the MCP client failed: {message}")),
    }
}

fn fail(message: &str) -> u8 {
    eprintln!("error: {message}");
    FAILED
}
