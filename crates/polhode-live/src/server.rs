//! Server: accepts connections, each with its limits.

use std::io::Read as _;
use std::net::{Ipv4Addr, Shutdown, SocketAddr, TcpListener, TcpStream};
use std::sync::Arc;
use std::thread;
use std::time::{Duration, Instant};

use crate::answer::{Answer, NOT_FOUND, Refusal};
use crate::connections::{Connections, Place};
use crate::error::LiveError;
use crate::guard::Guard;
use crate::head::Head;
use crate::limits;
use crate::options::LiveOptions;
use crate::page::served;
use crate::source::Source;

/// A server that listens, and answers once it runs.
#[derive(Debug)]
pub struct Live {
    listener: TcpListener,
    session: Arc<Session>,
}

/// State that all requests of a page share.
#[derive(Debug)]
struct Session {
    guard: Guard,
    page: Arc<Vec<u8>>,
    source: Source,
}

impl Live {
    /// Reads the files and listens on the address.
    ///
    /// # Errors
    /// [`LiveError`] if a file cannot be opened, or the address cannot be listened on.
    pub fn bind(options: &LiveOptions) -> Result<Self, LiveError> {
        let address = SocketAddr::from((Ipv4Addr::LOCALHOST, options.port));
        let source = Source::open(options.clone())?;
        let listen = || {
            let listener = TcpListener::bind(address)?;
            let port = listener.local_addr()?.port();
            Ok((listener, port))
        };
        let (listener, port) = listen().map_err(|error| LiveError::Address { address, error })?;
        let guard = Guard::new(port).ok_or(LiveError::Random)?;
        Ok(Self { listener, session: Arc::new(Session { guard, page: Arc::new(served()), source }) })
    }

    /// Returns the address of the page, with its token. Anyone who has the address is admitted.
    pub fn address(&self) -> String {
        self.session.guard.address()
    }

    /// Answers requests until the process ends.
    pub fn run(&self) -> ! {
        let connections = Arc::new(Connections::default());
        loop {
            let accepted =
                self.listener.accept().and_then(|(stream, _)| Ok((connections.place(&stream)?, stream)));
            let Ok((place, stream)) = accepted else {
                // This happens if there are no more file descriptors. Wait until some are released.
                thread::sleep(Duration::from_millis(50));
                continue;
            };
            let session = self.session.clone();
            // Without a thread the connection is closed.
            let _ = thread::Builder::new().spawn(move || session.serve(stream, &place));
        }
    }
}

impl Session {
    /// Answers the request of a connection. Errors of a connection concern only the client.
    fn serve(&self, mut stream: TcpStream, place: &Place) {
        let Some(head) = Head::read(&mut stream) else { return };
        let is_head = head.as_ref().is_ok_and(|head| head.method == "HEAD");
        let answer = head.and_then(|head| self.answer(&head, place)).unwrap_or_else(Answer::from);
        let _ = stream.set_nodelay(true);
        let _ = stream.set_write_timeout(Some(limits::WRITE_TIME));
        let written = answer.write(is_head, &mut stream).and_then(|()| stream.shutdown(Shutdown::Write));
        place.set_busy(false);
        // A connection closed with unread bytes is reset, and the client may lose the answer.
        let end = Instant::now() + limits::CLOSE_TIME;
        let _ = written.and_then(|()| stream.set_read_timeout(Some(limits::CLOSE_TIME)));
        while Instant::now() < end && stream.read(&mut [0; 4096]).is_ok_and(|count| count > 0) {}
    }

    fn answer(&self, head: &Head, place: &Place) -> Result<Answer, Refusal> {
        let path = self.guard.admit(head)?;
        place.set_busy(true);
        match path {
            "" => Ok(Answer::page(self.page.clone())),
            "files" => {
                let pack = self.source.pack();
                let is_known = head.all("if-none-match").any(|etag| etag == pack.etag);
                Ok(if is_known { Answer::unchanged(pack.etag) } else { Answer::pack(pack.bytes, pack.etag) })
            }
            _ => Err(NOT_FOUND),
        }
    }
}
