//! Server: accepts connections, each with its limits.

use std::error::Error;
use std::net::{Ipv4Addr, SocketAddr};
use std::path::PathBuf;
use std::pin::pin;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

use bytes::Bytes;
use http_body_util::{BodyExt as _, LengthLimitError, Limited};
use hyper::body::Incoming;
use hyper::server::conn::http1;
use hyper::service::service_fn;
use hyper::{Method, Request, StatusCode};
use hyper_util::rt::{TokioIo, TokioTimer};
use polhode_source::files::Disk;
use polhode_web::Engine;
use tokio::net::TcpListener;
use tokio::sync::mpsc;
use tokio::task::JoinError;
use tokio::time::error::Elapsed;
use tokio::time::timeout;

use crate::answer::{Answer, Refusal, refusal};
use crate::connections::{Connections, Place};
use crate::dropped::Dropped;
use crate::error::LiveError;
use crate::guard::Guard;
use crate::limits;
use crate::route::{Cost, Route};
use crate::session::Session;
use crate::turns::{Turn, Turns};
use crate::watch::Within;

/// Options of the server: files and address.
#[derive(Clone, Debug, Default)]
pub struct LiveOptions {
    /// Port on the loopback address; 0 selects a free one.
    pub port: u16,
    /// Files to show: scenarios, meshes, robots, molecules, particles. Without files, a default
    /// scenario is shown.
    pub files: Vec<PathBuf>,
    /// Lesson to begin with: the id of one of [`lessons`](crate::lessons), or a file.
    pub lesson: Option<String>,
}

/// A server that listens, and answers once it runs.
#[derive(Debug)]
pub struct Live {
    listener: std::net::TcpListener,
    session: Arc<Session>,
}

impl Live {
    /// Opens the files and listens on the address.
    ///
    /// # Errors
    /// [`LiveError`] if a file cannot be opened, or the address cannot be listened on.
    pub fn bind(options: &LiveOptions) -> Result<Self, LiveError> {
        let address = SocketAddr::from((Ipv4Addr::LOCALHOST, options.port));
        let engine = engine(options)?;
        let listen = || {
            let listener = std::net::TcpListener::bind(address)?;
            listener.set_nonblocking(true)?;
            let port = listener.local_addr()?.port();
            Ok((listener, port))
        };
        let (listener, port) = listen().map_err(|error| LiveError::Address { address, error })?;
        let guard = Guard::new(port).ok_or(LiveError::Random)?;
        let dropped = Dropped::new().map_err(|error| LiveError::Folder { error })?;
        let session = Session { guard, engine, dropped, turns: Turns::new() };
        Ok(Self { listener, session: Arc::new(session) })
    }

    /// Returns the address of the page, with its token. Anyone who has the address is admitted.
    pub fn address(&self) -> String {
        let address = self.session.guard.address();
        match self.session.engine.first_lesson() {
            Some(id) => format!("{address}#lesson={}", encoded(id)),
            None => address,
        }
    }

    /// Returns the HTTP status of a POST request of the page, without a connection; `path` is the
    /// part after the token.
    ///
    /// This is for tests and fuzzing: checks of the connection, such as that of the token, are
    /// skipped.
    pub fn status_of(&self, path: &str, body: &[u8]) -> u16 {
        let route = Route::of(&Method::POST, path, None);
        let answer = route.and_then(|route| route.answer(body, &self.session, &AtomicBool::new(false)));
        answer.map_or_else(|refusal| refusal.status.as_u16(), |answer| answer.status().as_u16())
    }

    /// Answers requests until the process is interrupted or terminated.
    ///
    /// # Errors
    /// [`LiveError::Start`].
    pub fn run(self) -> Result<(), LiveError> {
        self.run_until(interrupted())
    }

    /// Answers requests while `goes_on` is true. The value is checked every 20 ms.
    ///
    /// # Errors
    /// [`LiveError::Start`].
    pub fn run_while(self, goes_on: &AtomicBool) -> Result<(), LiveError> {
        self.run_until(async {
            while goes_on.load(Ordering::Relaxed) {
                tokio::time::sleep(Duration::from_millis(20)).await;
            }
            Ok(())
        })
    }

    fn run_until(self, end: impl Future<Output = std::io::Result<()>>) -> Result<(), LiveError> {
        let runtime = tokio::runtime::Builder::new_current_thread().enable_all().build();
        let runtime = runtime.map_err(|error| LiveError::Start { error })?;
        let Self { listener, session } = self;
        let served = runtime.block_on(async {
            let listener = TcpListener::from_std(listener)?;
            tokio::spawn(async move { accept(&listener, &session).await });
            end.await
        });
        // Computations that nobody waits for do not delay the end.
        runtime.shutdown_background();
        served.map_err(|error| LiveError::Start { error })
    }
}

/// Opens the lesson or the files, or a default scenario.
fn engine(options: &LiveOptions) -> Result<Engine, LiveError> {
    let stop = AtomicBool::new(false);
    if let Some(name) = &options.lesson {
        let watch = Within::new(limits::MOTION, &stop);
        return Engine::beginning_with_lesson(name, &Disk, &watch).map_err(LiveError::Lesson);
    }
    let engine = Engine::default();
    if options.files.is_empty() {
        engine.open_example(&Disk);
    }
    for file in &options.files {
        let opened = engine.open(file, None, &Disk, &Within::new(limits::INSPECTION, &stop));
        opened
            .map_err(Refusal::from)
            .map_err(|Refusal { message, hint, .. }| LiveError::File { message, hint })?;
    }
    Ok(engine)
}

/// Percent-encodes a text as a part of an address.
fn encoded(text: &str) -> String {
    let one = |byte: u8| match byte {
        b'-' | b'_' | b'.' => char::from(byte).to_string(),
        _ if byte.is_ascii_alphanumeric() => char::from(byte).to_string(),
        _ => format!("%{byte:02X}"),
    };
    text.bytes().map(one).collect()
}

/// Completes at Ctrl-C, or when the system terminates the process.
async fn interrupted() -> std::io::Result<()> {
    #[cfg(unix)]
    {
        use tokio::signal::unix::{SignalKind, signal};
        let [mut interrupt, mut end] = [signal(SignalKind::interrupt())?, signal(SignalKind::terminate())?];
        std::future::poll_fn(|context| {
            let either = [interrupt.poll_recv(context), end.poll_recv(context)];
            if either.iter().any(std::task::Poll::is_ready) {
                std::task::Poll::Ready(())
            } else {
                std::task::Poll::Pending
            }
        })
        .await;
        Ok(())
    }
    #[cfg(not(unix))]
    tokio::signal::ctrl_c().await
}

/// Accepts connections forever, up to the maximum number at a time.
async fn accept(listener: &TcpListener, session: &Arc<Session>) {
    let connections = Arc::new(Connections::default());
    loop {
        let Ok((stream, _)) = listener.accept().await else {
            // This happens if there are no more file descriptors. Wait until some are released.
            tokio::time::sleep(Duration::from_millis(50)).await;
            continue;
        };
        let place = connections.place().await;
        let (session, own) = (session.clone(), place.clone());
        let task = tokio::spawn(async move {
            let _ = stream.set_nodelay(true);
            let service = service_fn(|request| {
                let (session, place) = (session.clone(), own.clone());
                async move {
                    Ok::<_, std::convert::Infallible>(
                        answered(request, &session, &place).await.unwrap_or_else(refusal),
                    )
                }
            });
            let connection = http1::Builder::new()
                .timer(TokioTimer::new())
                .header_read_timeout(limits::HEADERS)
                .max_buf_size(64 << 10)
                .serve_connection(TokioIo::new(stream), service);
            // Errors of a connection concern only the client.
            let _ = connection.await;
        });
        place.served_by(task.abort_handle());
    }
}

async fn answered(
    request: Request<Incoming>,
    session: &Arc<Session>,
    place: &Place,
) -> Result<Answer, Refusal> {
    let (head, body) = request.into_parts();
    let path = session.guard.admit(&head.method, &head.uri, head.version, &head.headers)?;
    let _busy = place.busy();
    let route = Route::of(&head.method, path, head.uri.query())?;
    let most = route.most();
    let body = match &route {
        Route::Drop { set, name } => {
            kept(body, most, session.clone(), *set, name.clone()).await?;
            Bytes::new()
        }
        _ => whole(body, most).await?,
    };
    let (cost, route) = (route.cost(session), Arc::new(route));
    let (turn, most) = match cost {
        Cost::Nothing => return route.answer(&body, session, &AtomicBool::new(false)),
        Cost::Light => (session.turns.light().await?, limits::MOTION),
        Cost::Heavy => (session.turns.heavy().await?, limits::MOTION),
        Cost::Unknown => {
            let turn = session.turns.light().await?;
            let light = LightTurn { session: session.clone(), turn: turn.clone() };
            let mut first = pin!(computed(&route, &body, session, turn, limits::FIRST_TRY));
            let answer = match timeout(limits::OVERRUN, &mut first).await {
                Ok(answer) => answer?,
                Err(_) => {
                    drop(light);
                    first.await?
                }
            };
            if let Some(answer) = answer {
                return Ok(answer);
            }
            (session.turns.heavy().await?, limits::MOTION)
        }
    };
    let answer = computed(&route, &body, session, turn, most).await?;
    answer.ok_or_else(long)
}

/// Computes an answer in another thread; `None` for a motion that takes longer than `most`.
async fn computed(
    route: &Arc<Route>,
    body: &Bytes,
    session: &Arc<Session>,
    turn: Turn,
    most: Duration,
) -> Result<Option<Answer>, Refusal> {
    let stop = StopOnDrop(Arc::default());
    let (flag, session, route, body) = (stop.0.clone(), session.clone(), route.clone(), body.clone());
    let work = tokio::task::spawn_blocking(move || {
        let answer = route.answer_within(most, &body, &session, &flag);
        // The turn lasts as long as the computation, even if nobody waits.
        turn.end();
        answer
    });
    timeout(limits::ANSWER, work).await.map_err(|_| long())?.map_err(defect)?
}

fn long() -> Refusal {
    let took = format!("the answer takes more than {} s", limits::ANSWER.as_secs());
    Refusal::new(StatusCode::SERVICE_UNAVAILABLE, took)
        .hint("use a smaller mesh, or the polhode command, which has no time limit")
}
/// Returns the body, if it is not too large and arrives in time.
async fn whole(body: Incoming, most: usize) -> Result<Bytes, Refusal> {
    let collected = timeout(limits::BODY, Limited::new(body, most).collect()).await;
    Ok(collected.map_err(late)?.map_err(|error| broken(&*error, most))?.to_bytes())
}

/// Saves the body as a file of a set, under the same conditions. Another thread writes it while it
/// arrives.
async fn kept(
    body: Incoming,
    most: usize,
    session: Arc<Session>,
    set: u64,
    name: String,
) -> Result<(), Refusal> {
    let (frames, mut written) = mpsc::channel::<Option<Bytes>>(AHEAD);
    let keeping = tokio::task::spawn_blocking(move || {
        let mut file = session.dropped.receive(set, &name)?;
        while let Some(frame) = written.blocking_recv() {
            match frame {
                Some(bytes) => file.write(&bytes)?,
                None => return file.end(),
            }
        }
        Ok(())
    });
    let mut body = Limited::new(body, most);
    let coming = async {
        while let Some(frame) = body.frame().await {
            let frame = frame.map_err(|error| broken(&*error, most))?;
            let Ok(bytes) = frame.into_data() else { continue };
            // If the writer has ended, it reports the reason itself.
            if frames.send(Some(bytes)).await.is_err() {
                break;
            }
        }
        Ok::<(), Refusal>(())
    };
    timeout(limits::BODY, coming).await.map_err(late)??;
    let _ = frames.send(None).await;
    keeping.await.map_err(defect)?
}

/// Maximum number of frames of a body that wait to be written.
const AHEAD: usize = 16;

fn late(_: Elapsed) -> Refusal {
    Refusal::new(StatusCode::REQUEST_TIMEOUT, "the body of the request did not arrive in time")
}

fn broken(error: &(dyn Error + 'static), most: usize) -> Refusal {
    if error.is::<LengthLimitError>() {
        let rule = format!("the body of the request has more than {most} bytes");
        return Refusal::new(StatusCode::PAYLOAD_TOO_LARGE, rule);
    }
    Refusal::new(StatusCode::BAD_REQUEST, "the body of the request is incomplete")
}

fn defect(_: JoinError) -> Refusal {
    Refusal::new(StatusCode::INTERNAL_SERVER_ERROR, "internal error in polhode: please report it")
}

/// Ends the light turn of a computation that overruns it, or that nobody waits for:
/// [`Turns::make_heavy`].
struct LightTurn {
    session: Arc<Session>,
    turn: Turn,
}

impl Drop for LightTurn {
    fn drop(&mut self) {
        self.session.turns.make_heavy(&self.turn);
    }
}

/// Stops a computation when nobody waits for it: the connection is closed, and the future of the
/// answer is dropped.
struct StopOnDrop(Arc<AtomicBool>);

impl Drop for StopOnDrop {
    fn drop(&mut self) {
        self.0.store(true, Ordering::Relaxed);
    }
}
