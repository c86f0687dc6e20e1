//! What is sent and what is taken: answers as a whole, news as they come, requests up to a size.

use hyper::body::{Body, Bytes, Frame, Incoming, SizeHint};
use std::convert::Infallible;
use std::future::poll_fn;
use std::pin::Pin;
use std::task::{Context, Poll};
use tokio::sync::mpsc::Receiver;

/// What is answered.
pub enum ResponseBody {
    /// All at once.
    Whole(Bytes),
    /// As long as there is somebody who says something.
    News(Receiver<Bytes>),
}

impl Body for ResponseBody {
    type Data = Bytes;
    type Error = Infallible;

    fn poll_frame(mut self: Pin<&mut Self>, cx: &mut Context<'_>) -> Poll<Option<Result<Frame<Bytes>, Infallible>>> {
        let next = match &mut *self {
            Self::Whole(bytes) => Poll::Ready((!bytes.is_empty()).then(|| std::mem::take(bytes))),
            Self::News(news) => news.poll_recv(cx),
        };
        next.map(|bytes| bytes.map(|bytes| Ok(Frame::data(bytes))))
    }

    fn is_end_stream(&self) -> bool {
        matches!(self, Self::Whole(bytes) if bytes.is_empty())
    }

    fn size_hint(&self) -> SizeHint {
        match self {
            Self::Whole(bytes) => SizeHint::with_exact(bytes.len() as u64),
            Self::News(_) => SizeHint::default(),
        }
    }
}

/// Why a request is not taken.
#[derive(Debug, PartialEq, Eq)]
pub enum Untaken {
    /// It is larger than allowed.
    TooLarge,
    /// It broke off.
    Broken,
}

/// Whether a request says of itself that it is larger than so many bytes: then nothing of it is read.
pub fn is_larger(body: &Incoming, most: usize) -> bool {
    body.size_hint().lower() > most as u64
}

/// The body of a request.
///
/// # Errors
/// It is larger than so many bytes, said or not, or it broke off.
pub async fn read(mut body: Incoming, most: usize) -> Result<Vec<u8>, Untaken> {
    let mut bytes = Vec::new();
    while let Some(frame) = poll_fn(|cx| Pin::new(&mut body).poll_frame(cx)).await {
        let Ok(data) = frame.map_err(|_| Untaken::Broken)?.into_data() else { continue };
        if bytes.len() + data.len() > most {
            return Err(Untaken::TooLarge);
        }
        bytes.extend_from_slice(&data);
    }
    Ok(bytes)
}
