//! Between two byte streams and the state: threads that read and write, and tower-lsp between them.
//!
//! The transport is used for what it is good at, framing and matching of messages. Three things that it does not do well
//! are kept from it: it sees only well-formed messages (`frames`), since one that is not ends it; a handler does nothing but
//! hand its message to the state's queue, before anything is awaited, so messages keep their order and none waits for
//! another; and what it writes goes to a queue without end, so that a client which does not read cannot stop it from reading.

use crate::frames::{self, Frame};
use crate::record::Recorder;
use crate::state::{Event, Setup, State};
use futures::channel::{mpsc, oneshot};
use std::convert::Infallible;
use std::future::Future;
use std::io::{BufReader, Read, Write};
use std::pin::Pin;
use std::sync::mpsc as queue;
use std::task::{Context, Poll};
use std::thread;
use tokio::io::{AsyncRead, AsyncWrite, ReadBuf};
use tower_lsp::jsonrpc::{Error, Id, Request, Response};
use tower_lsp::{Loopback, Server};
use tower_service::Service;

/// Stands for what was no message.
const MALFORMED: &str = "$/scenelang/malformed";
/// More requests at once than there will ever be: how many are worked on is decided by the state.
const MANY: usize = 1 << 20;

/// Serves one client until it says `exit` or closes its stream. The exit code: 0 after `shutdown`, else 1.
pub fn serve(input: impl Read + Send + 'static, output: impl Write + Send + 'static, mut setup: Setup) -> u8 {
    let recorder = setup.record.take();
    let (bytes, incoming) = mpsc::unbounded();
    let (outgoing, written) = queue::channel::<Vec<u8>>();
    let (events, state_events) = queue::channel();
    let (to_client, requests) = mpsc::unbounded();

    let heard = recorder.clone();
    thread::spawn(move || listen(input, &bytes, heard.as_ref()));
    let writer = thread::spawn(move || write(output, &written, recorder.as_ref()));
    let own_events = events.clone();
    let state = thread::Builder::new()
        .name("state".to_owned())
        .stack_size(16 << 20)
        .spawn(move || State::new(&setup, own_events, to_client).run(&state_events));
    let Ok(state) = state else { return 1 };

    let socket = Socket { requests, events: events.clone() };
    let server = Server::new(FromClient { incoming, rest: Vec::new(), at: 0 }, ToClient(outgoing), socket);
    futures::executor::block_on(server.concurrency_level(MANY).serve(Queue(events.clone())));
    // The other side may be gone: then so is the state.
    let _ = events.send(Event::Closed);
    let code = state.join().unwrap_or(1);
    let _ = writer.join();
    code
}

/// Reads messages until the stream ends.
fn listen(input: impl Read, bytes: &mpsc::UnboundedSender<Vec<u8>>, recorder: Option<&Recorder>) {
    let mut input = BufReader::with_capacity(1 << 16, input);
    while let Ok(Some(frame)) = frames::next(&mut input) {
        let message = match frame {
            Frame::Message(mut message) => {
                if let Some(recorder) = recorder {
                    recorder.heard(&message);
                }
                message["jsonrpc"] = "2.0".into();
                message
            }
            Frame::Malformed => serde_json::json!({ "jsonrpc": "2.0", "method": MALFORMED }),
        };
        if bytes.unbounded_send(frames::framed(&message)).is_err() {
            return;
        }
    }
}

fn write(mut output: impl Write, written: &queue::Receiver<Vec<u8>>, recorder: Option<&Recorder>) {
    while let Ok(mut chunk) = written.recv() {
        while let Ok(more) = written.try_recv() {
            chunk.extend(more);
        }
        if let Some(recorder) = recorder {
            recorder.said(&chunk);
        }
        if output.write_all(&chunk).and_then(|()| output.flush()).is_err() {
            return;
        }
    }
}

/// What was read, as the transport wants it.
struct FromClient {
    incoming: mpsc::UnboundedReceiver<Vec<u8>>,
    rest: Vec<u8>,
    at: usize,
}

impl AsyncRead for FromClient {
    fn poll_read(mut self: Pin<&mut Self>, cx: &mut Context<'_>, out: &mut ReadBuf<'_>) -> Poll<std::io::Result<()>> {
        use futures::Stream;
        while self.at == self.rest.len() {
            match Pin::new(&mut self.incoming).poll_next(cx) {
                Poll::Pending => return Poll::Pending,
                Poll::Ready(None) => return Poll::Ready(Ok(())),
                Poll::Ready(Some(bytes)) => (self.rest, self.at) = (bytes, 0),
            }
        }
        let end = self.rest.len().min(self.at + out.remaining());
        out.put_slice(&self.rest[self.at..end]);
        self.at = end;
        Poll::Ready(Ok(()))
    }
}

/// What is to be written, taken at once.
struct ToClient(queue::Sender<Vec<u8>>);

impl AsyncWrite for ToClient {
    fn poll_write(self: Pin<&mut Self>, _: &mut Context<'_>, bytes: &[u8]) -> Poll<std::io::Result<usize>> {
        let sent = self.0.send(bytes.to_vec());
        Poll::Ready(sent.map(|()| bytes.len()).map_err(|_| std::io::ErrorKind::BrokenPipe.into()))
    }
    fn poll_flush(self: Pin<&mut Self>, _: &mut Context<'_>) -> Poll<std::io::Result<()>> {
        Poll::Ready(Ok(()))
    }
    fn poll_shutdown(self: Pin<&mut Self>, _: &mut Context<'_>) -> Poll<std::io::Result<()>> {
        Poll::Ready(Ok(()))
    }
}

/// Our side of the conversation in the other direction: what we ask, and where the answers go.
struct Socket {
    requests: mpsc::UnboundedReceiver<Request>,
    events: queue::Sender<Event>,
}

impl Loopback for Socket {
    type RequestStream = mpsc::UnboundedReceiver<Request>;
    type ResponseSink = Answers;

    fn split(self) -> (Self::RequestStream, Self::ResponseSink) {
        (self.requests, Answers(self.events))
    }
}

/// Answers of the client, for the state.
struct Answers(queue::Sender<Event>);

impl futures::Sink<Response> for Answers {
    type Error = Infallible;

    fn poll_ready(self: Pin<&mut Self>, _: &mut Context<'_>) -> Poll<Result<(), Infallible>> {
        Poll::Ready(Ok(()))
    }
    fn start_send(self: Pin<&mut Self>, answer: Response) -> Result<(), Infallible> {
        let _ = self.0.send(Event::Answer(answer));
        Ok(())
    }
    fn poll_flush(self: Pin<&mut Self>, _: &mut Context<'_>) -> Poll<Result<(), Infallible>> {
        Poll::Ready(Ok(()))
    }
    fn poll_close(self: Pin<&mut Self>, _: &mut Context<'_>) -> Poll<Result<(), Infallible>> {
        Poll::Ready(Ok(()))
    }
}

/// The handler of all messages: it hands them on.
struct Queue(queue::Sender<Event>);

impl Service<Request> for Queue {
    type Response = Option<Response>;
    type Error = Infallible;
    type Future = Pin<Box<dyn Future<Output = Result<Option<Response>, Infallible>> + Send>>;

    fn poll_ready(&mut self, _: &mut Context<'_>) -> Poll<Result<(), Infallible>> {
        Poll::Ready(Ok(()))
    }

    fn call(&mut self, request: Request) -> Self::Future {
        let (method, id, params) = request.into_parts();
        let Some(id) = id else {
            if method == MALFORMED {
                return Box::pin(async { Ok(Some(Response::from_error(Id::Null, Error::parse_error()))) });
            }
            let _ =
                self.0.send(Event::Notification { method: method.into_owned(), params: params.unwrap_or_default() });
            return Box::pin(async { Ok(None) });
        };
        let (reply, answer) = oneshot::channel();
        let event =
            Event::Request { id: id.clone(), method: method.into_owned(), params: params.unwrap_or_default(), reply };
        let _ = self.0.send(event);
        Box::pin(async move {
            // Nobody answers once the state is gone.
            Ok(answer.await.ok().map(|body| Response::from_parts(id, body)))
        })
    }
}
