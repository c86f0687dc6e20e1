//! The server: which call goes to which tool, how many work at once, and when one ends.

use super::resources;
use super::tools::{self, Answered, Call, TOOLS};
use super::workspace::Workspace;
use rmcp::model::{
    CallToolRequestParams, CallToolResponse, CallToolResult, ContentBlock, ErrorData, Implementation,
    ListResourceTemplatesResult, ListResourcesResult, ListToolsResult, PaginatedRequestParams,
    ReadResourceRequestParams, ReadResourceResponse, ReadResourceResult, ServerCapabilities, ServerConfig,
};
use rmcp::service::RequestContext;
use rmcp::{RoleServer, ServerHandler};
use scenelang_solve::Stop;
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::Duration;
use tokio::sync::Semaphore;
use tokio::time::{sleep, timeout};

/// So many calls are worked on at once.
pub const WORKERS: usize = 2;
/// And so many more wait; others are turned away.
const WAITING: usize = 64;
/// What a call that was told to end may take to do so.
const GRACE: Duration = Duration::from_secs(2);

/// What a client is told at the beginning.
const ABOUT: &str = "\
Scenes as programs. A program (room.scene) says what stands in a room and what must hold; a layout (room.layout.json) says \
where things are. Use `solve` to make a layout; do not write one yourself. Usual workflow: `formalize` a request (or read \
scenelang://guide and write a program), then `check`, `solve` and `render` it. Where something fails, `repair` names the \
smallest changes; where nothing can hold, `why_not` names the smallest set of statements to blame. Try an edit with \
`speculate` before making it.";

/// Serves one client.
pub struct Server(Arc<Inner>);

struct Inner {
    workspace: Workspace,
    time: Duration,
    workers: Arc<Semaphore>,
    waiting: AtomicUsize,
}

impl Server {
    /// For a workspace; a call takes at most so long.
    pub fn new(workspace: Workspace, time: Duration) -> Self {
        let (workers, waiting) = (Arc::new(Semaphore::new(WORKERS)), AtomicUsize::new(0));
        Self(Arc::new(Inner { workspace, time, workers, waiting }))
    }

    /// Does work on a thread of its own, until it is done, cancelled, or its time is over.
    async fn work<T: Send + 'static>(
        &self,
        context: &RequestContext<RoleServer>,
        work: impl FnOnce(&Call<'_>) -> Result<T, String> + Send + 'static,
    ) -> Result<T, String> {
        let inner = Arc::clone(&self.0);
        let place = Waiting::take(&inner)?;
        let permit = tokio::select! {
            permit = Arc::clone(&inner.workers).acquire_owned() => permit.map_err(|e| e.to_string())?,
            () = context.ct.cancelled() => return Err("the call was cancelled".to_owned()),
        };
        drop(place);
        let (stop, time) = (Stop::default(), inner.time);
        let theirs = stop.clone();
        let mut job = tokio::task::spawn_blocking(move || {
            // Given back when the work has ended, even if nobody waits for it any more.
            let _permit = permit;
            work(&Call { workspace: &inner.workspace, stop: &theirs, time })
        });
        let broken = |_| Err("scenelang failed because of an internal error; please report it".to_owned());
        tokio::select! {
            done = &mut job => return done.unwrap_or_else(broken),
            () = context.ct.cancelled() => {
                stop.set();
                return Err("the call was cancelled".to_owned());
            }
            () = sleep(time) => { stop.set(); }
        }
        match timeout(GRACE, job).await {
            Ok(done) => done.unwrap_or_else(broken),
            Err(_) => Err(format!(
                "it took longer than {} s; `scenelang mcp --time SECONDS` lets a call take longer",
                time.as_secs_f64()
            )),
        }
    }
}

/// A place among those who wait.
struct Waiting<'a>(&'a AtomicUsize);

impl<'a> Waiting<'a> {
    fn take(inner: &'a Inner) -> Result<Self, String> {
        if inner.waiting.fetch_add(1, Ordering::SeqCst) >= WAITING {
            inner.waiting.fetch_sub(1, Ordering::SeqCst);
            return Err(format!("{WAITING} calls are already waiting; call again when some are done"));
        }
        Ok(Self(&inner.waiting))
    }
}

impl Drop for Waiting<'_> {
    fn drop(&mut self) {
        self.0.fetch_sub(1, Ordering::SeqCst);
    }
}

impl ServerHandler for Server {
    fn get_info(&self) -> ServerConfig {
        let can = ServerCapabilities::builder().enable_tools().enable_resources().build();
        let who = Implementation::new("scenelang", env!("CARGO_PKG_VERSION"));
        ServerConfig::new(can).with_server_info(who).with_instructions(ABOUT)
    }

    async fn list_tools(
        &self,
        _: Option<PaginatedRequestParams>,
        _: RequestContext<RoleServer>,
    ) -> Result<ListToolsResult, ErrorData> {
        Ok(ListToolsResult::with_all_items(TOOLS.iter().map(tools::Spec::described).collect()))
    }

    async fn call_tool(
        &self,
        request: CallToolRequestParams,
        context: RequestContext<RoleServer>,
    ) -> Result<CallToolResponse, ErrorData> {
        let Some(tool) = tools::find(&request.name) else {
            let names: Vec<&str> = TOOLS.iter().map(|tool| tool.name).collect();
            let say = format!("there is no tool `{}`; valid names: {}", request.name, names.join(", "));
            return Err(ErrorData::invalid_params(say, None));
        };
        let arguments = request.arguments.unwrap_or_default();
        let answered: Answered = self.work(&context, move |call| tool.call(call, arguments)).await;
        let result = match answered {
            Ok(answer) => answer.into_result(),
            Err(why) => CallToolResult::error(vec![ContentBlock::text(why)]),
        };
        Ok(result.into())
    }

    async fn list_resources(
        &self,
        _: Option<PaginatedRequestParams>,
        context: RequestContext<RoleServer>,
    ) -> Result<ListResourcesResult, ErrorData> {
        let listed = self.work(&context, |_| Ok(resources::listed())).await;
        listed.map(ListResourcesResult::with_all_items).map_err(|why| ErrorData::internal_error(why, None))
    }

    async fn list_resource_templates(
        &self,
        _: Option<PaginatedRequestParams>,
        _: RequestContext<RoleServer>,
    ) -> Result<ListResourceTemplatesResult, ErrorData> {
        Ok(ListResourceTemplatesResult::with_all_items(resources::templates()))
    }

    async fn read_resource(
        &self,
        request: ReadResourceRequestParams,
        context: RequestContext<RoleServer>,
    ) -> Result<ReadResourceResponse, ErrorData> {
        let address = request.uri;
        let read = self.work(&context, move |call| resources::read(call, &address)).await;
        let contents = read.map_err(|why| ErrorData::resource_not_found(why, None))?;
        Ok(ReadResourceResult::new(vec![contents]).into())
    }
}
