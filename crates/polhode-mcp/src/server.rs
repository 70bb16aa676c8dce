//! The server: one thread reads messages, and each call of a tool has a thread.

use std::collections::HashMap;
use std::io::{self, BufRead, Write};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::channel;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::thread;
use std::time::Duration;

use polhode_source::files::Files;
use serde_json::Value;

use crate::message::ProtocolError;
use crate::session::{Call, Session, Step};

/// Largest number of calls that run at the same time.
const MOST: usize = 16;

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
    let (working, ended) = channel::<()>();
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
                Ok(cancelled) => {
                    let (server, working) = (server.clone(), working.clone());
                    thread::Builder::new().spawn(move || {
                        // If the output is closed, the client is gone, and the input ends too.
                        let _ = server.run(call, &cancelled);
                        drop(working);
                    })?;
                }
                Err(error) => server.send(&error.answer(&call.id))?,
            },
        }
    }
    drop(working);
    // Disconnected as soon as all threads have ended.
    let _ = ended.recv_timeout(GRACE);
    Ok(())
}

/// State that the threads share.
struct Server<W, F> {
    output: Mutex<W>,
    files: F,
    /// Running calls by id, each with its cancellation.
    running: Mutex<HashMap<String, Arc<AtomicBool>>>,
}

impl<W: Write, F: Files> Server<W, F> {
    /// Writes a message as one line.
    fn send(&self, message: &Value) -> io::Result<()> {
        let mut output = lock(&self.output);
        writeln!(output, "{message}")?;
        output.flush()
    }

    /// Registers a call and returns its cancellation.
    fn begin(&self, id: &Value) -> Result<Arc<AtomicBool>, ProtocolError> {
        let mut running = lock(&self.running);
        let refused = |rule: String| Err(ProtocolError::new(ProtocolError::INVALID_REQUEST, rule));
        match id.to_string() {
            key if running.contains_key(&key) => refused(format!("a call with the id {key} is running")),
            _ if running.len() >= MOST => refused(format!("{MOST} calls are running: wait for one")),
            key => Ok(running.entry(key).or_default().clone()),
        }
    }

    /// Cancels a call, if it has not ended.
    fn cancel(&self, id: &Value) {
        if let Some(cancelled) = lock(&self.running).get(&id.to_string()) {
            cancelled.store(true, Ordering::Relaxed);
        }
    }

    /// Runs a call and sends its answer, unless it was cancelled.
    fn run(&self, call: Call, cancelled: &AtomicBool) -> io::Result<()> {
        let Call { id, era, tool, arguments } = call;
        let run = || era.answer(&id, tool.call(arguments, &self.files, cancelled).to_result());
        // A panic is a bug; the client gets an answer all the same.
        let answer = catch_unwind(AssertUnwindSafe(run)).unwrap_or_else(|_| {
            let what = format!("{} failed: please report this bug, with its arguments", tool.name);
            ProtocolError::new(ProtocolError::INTERNAL, what).answer(&id)
        });
        lock(&self.running).remove(&id.to_string());
        if cancelled.load(Ordering::Relaxed) { Ok(()) } else { self.send(&answer) }
    }
}

fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}
