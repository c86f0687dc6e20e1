//! The pages over HTTP, to this machine and this user alone: one thread that accepts and answers, within limits of number,
//! size and time for everything that a stranger can send.

use super::body::ResponseBody;
use super::connection::{Connection, Connections};
use super::door::Door;
use super::live::{News, Shown};
use super::peer::is_another_user;
use super::site::Site;
use crate::interrupt;
use hyper::server::conn::http1;
use hyper::service::service_fn;
use hyper::{Request, Response};
use hyper_util::rt::{TokioIo, TokioTimer};
use std::convert::Infallible;
use std::io;
use std::net::{Ipv4Addr, TcpListener};
use std::pin::pin;
use std::sync::Arc;
use std::time::Duration;
use tokio::net::TcpStream;
use tokio::sync::watch;
use tokio::time::{sleep, timeout};

/// The largest head of a request (bytes), and the most lines in it: browsers send about a thousandth of it.
const HEAD: usize = 16 << 10;
const LINES: usize = 64;
/// How long a head may take, and how long everything that is not news.
const HEAD_TIME: Duration = Duration::from_secs(5);
const WHOLE_TIME: Duration = Duration::from_secs(30);
/// Moves that are judged or wait for the judge at a time.
const JUDGES: usize = 4;
/// Between two looks at Ctrl-C, and after a connection that could not be accepted: there are too many open files, say.
const TICK: Duration = Duration::from_millis(200);

/// Listens on a port, 0: any that is free; the address for the user.
///
/// # Errors
/// The port is taken, or may not be used.
pub fn start(port: u16, viewer: &'static str, shown: &Arc<Shown>) -> io::Result<String> {
    let listener = TcpListener::bind((Ipv4Addr::LOCALHOST, port))?;
    listener.set_nonblocking(true)?;
    let door = Door::new(listener.local_addr()?.port())?;
    let address = door.address();
    let (tell, news) = watch::channel(News::none());
    let site = Arc::new(Site::new(door, viewer, Arc::clone(shown), news)?);
    let runtime =
        tokio::runtime::Builder::new_current_thread().enable_io().enable_time().max_blocking_threads(JUDGES).build()?;
    let shown = Arc::clone(shown);
    std::thread::Builder::new().name("news".to_owned()).spawn(move || {
        let mut version = u64::MAX;
        while !interrupt::asked() {
            let news = shown.after(version, TICK);
            let now = news.version;
            if now != version && tell.send(news).is_err() {
                break;
            }
            version = now;
        }
    })?;
    std::thread::Builder::new().name("view".to_owned()).spawn(move || runtime.block_on(accept(listener, site)))?;
    Ok(address)
}

/// Takes connections as long as the process lives. No failure of one is a failure of all.
async fn accept(listener: TcpListener, site: Arc<Site>) {
    let Ok(listener) = tokio::net::TcpListener::from_std(listener) else { return };
    let connections = Arc::new(Connections::default());
    loop {
        let Ok((stream, peer)) = listener.accept().await else {
            sleep(TICK).await;
            continue;
        };
        if listener.local_addr().is_ok_and(|here| is_another_user(peer, here)) {
            continue;
        }
        let Some((number, connection)) = connections.admit() else { continue };
        let (site, all) = (Arc::clone(&site), Arc::clone(&connections));
        let task = tokio::spawn(async move {
            serve(stream, &site, &connection).await;
            all.end(number);
        });
        connections.served_by(number, task.abort_handle());
    }
}

/// One connection, to its end.
async fn serve(stream: TcpStream, site: &Arc<Site>, connection: &Arc<Connection>) {
    let service = service_fn(|request: Request<hyper::body::Incoming>| {
        let (site, connection) = (Arc::clone(site), Arc::clone(connection));
        async move { Ok::<Response<ResponseBody>, Infallible>(site.answer(connection, request).await) }
    });
    let mut http = http1::Builder::new();
    // One request each: on this machine another connection costs nothing, and none is left to wait for.
    http.keep_alive(false)
        .timer(TokioTimer::new())
        .header_read_timeout(HEAD_TIME)
        .max_buf_size(HEAD)
        .max_headers(LINES);
    let mut served = pin!(http.serve_connection(TokioIo::new(stream), service));
    // What a client does wrong is its own affair.
    if timeout(WHOLE_TIME, served.as_mut()).await.is_err() && connection.follows() {
        let _ = served.await;
    }
}
