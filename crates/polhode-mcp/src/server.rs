//! The server: one thread reads messages, and several run the calls.

use std::collections::HashMap;
use std::io::{self, BufRead, Write};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{Receiver, channel};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::thread;
use std::time::Duration;

use polhode_source::files::Files;
use serde_json::Value;

use crate::message::ProtocolError;
use crate::session::{Call, Session, Step};

/// Number of calls that run at the same time.
const WORKERS: usize = 4;

/// Time for calls that are still running at the end of the input.
const GRACE: Duration = Duration::from_secs(5);

/// Answers the messages of `input` on `output` until the input ends. Tools read only `files`.
///
/// Calls that are still running 5 s after the end of the input are abandoned: their threads end with
/// the process.
///
/// # Errors
/// I/O errors of the streams.
pub fn serve<F>(input: impl BufRead, output: impl Write + Send + 'static, files: F) -> io::Result<()>
where
    F: Files + Send + 'static,
{
    let server = Arc::new(Server { output: Mutex::new(output), files, running: Mutex::default() });
    let (calls, queue) = channel();
    let queue = Arc::new(Mutex::new(queue));
    let (working, ended) = channel::<()>();
    for _ in 0..WORKERS {
        let (server, queue, working) = (server.clone(), queue.clone(), working.clone());
        thread::Builder::new().spawn(move || {
            server.work(&queue);
            drop(working);
        })?;
    }
    drop(working);
    let mut session = Session::default();
    for line in input.split(b'\n') {
        let line = line?;
        if line.trim_ascii().is_empty() {
            continue;
        }
        match session.step(&line) {
            Step::Nothing => {}
            Step::Send(message) => server.send(&message)?,
            Step::Cancel(id) => server.cancel(&id),
            Step::Start(call) => match server.begin(&call.id) {
                // The workers hold the other end until this one is dropped.
                Some(cancelled) => _ = calls.send((call, cancelled)),
                None => {
                    let rule = "a request with this id is still running";
                    let error = ProtocolError::new(ProtocolError::INVALID_REQUEST, rule);
                    server.send(&error.answer(&call.id))?;
                }
            },
        }
    }
    drop(calls);
    // Disconnected as soon as all workers have ended.
    let _ = ended.recv_timeout(GRACE);
    Ok(())
}

/// State that the threads share.
struct Server<W, F> {
    output: Mutex<W>,
    files: F,
    /// Calls that wait or run, by id, each with its cancellation.
    running: Mutex<HashMap<String, Arc<AtomicBool>>>,
}

/// Call with its cancellation.
type Started = (Call, Arc<AtomicBool>);

impl<W: Write, F: Files> Server<W, F> {
    /// Writes a message as one line.
    fn send(&self, message: &Value) -> io::Result<()> {
        let mut output = lock(&self.output);
        writeln!(output, "{message}")?;
        output.flush()
    }

    /// Registers a call; `None` if its id is in use.
    fn begin(&self, id: &Value) -> Option<Arc<AtomicBool>> {
        let mut running = lock(&self.running);
        let key = id.to_string();
        if running.contains_key(&key) {
            return None;
        }
        Some(running.entry(key).or_default().clone())
    }

    /// Cancels a call, if it has not ended.
    fn cancel(&self, id: &Value) {
        if let Some(cancelled) = lock(&self.running).get(&id.to_string()) {
            cancelled.store(true, Ordering::Relaxed);
        }
    }

    /// Runs calls until the queue ends.
    fn work(&self, queue: &Mutex<Receiver<Started>>) {
        loop {
            let next = lock(queue).recv();
            let Ok((call, cancelled)) = next else { return };
            let Call { id, era, tool, arguments } = call;
            let is_cancelled = || cancelled.load(Ordering::Relaxed);
            let run = || tool.call(arguments, &self.files, &cancelled);
            // A panic is a bug; the client gets an answer all the same.
            let outcome = if is_cancelled() { None } else { Some(catch_unwind(AssertUnwindSafe(run))) };
            lock(&self.running).remove(&id.to_string());
            let answer = match outcome {
                _ if is_cancelled() => continue,
                None => continue,
                Some(Ok(outcome)) => era.answer(&id, outcome.to_result()),
                Some(Err(_)) => {
                    let what = format!(
                        "{} failed: please report this bug, with its arguments",
                        tool.definition.name
                    );
                    ProtocolError::new(ProtocolError::INTERNAL, what).answer(&id)
                }
            };
            // If the output is closed, the client is gone, and the input ends too.
            let _ = self.send(&answer);
        }
    }
}

fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}
