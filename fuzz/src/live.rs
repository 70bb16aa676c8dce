//! Requests from the page of `polhode live`.

use std::sync::OnceLock;

use polhode_source::files::Memory;
use polhode_web::Engine;

/// Largest request, bytes; a longer one would take too long.
const LONGEST: usize = 4000;

/// Checks that every request gets an answer or a refusal, and the same one when repeated.
pub fn live(data: &[u8]) {
    static ENGINE: OnceLock<(Engine, Memory)> = OnceLock::new();
    let (engine, files) = ENGINE.get_or_init(|| {
        let (engine, files) = (Engine::default(), Memory::default());
        engine.open_example(&files);
        (engine, files)
    });
    if data.len() > LONGEST {
        return;
    }
    for name in ["motion", "complete", "open"] {
        let request = [format!("{{\"{name}\":").as_bytes(), data, b"}"].concat();
        let answer = engine.answer(&request, files, &|| true);
        assert!(!answer.starts_with(b"{\"refusal\":{\"kind\":\"internal\""), "{name}");
        assert_eq!(answer, engine.answer(&request, files, &|| true), "{name}");
    }
}
