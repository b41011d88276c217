//! A mechanism from text as a module of WebAssembly: the compiler and the runtime behind functions of numbers.
//!
//! A page writes a text into [`plm_room`] and calls [`plm_compile`]. Where it is a mechanism, [`plm_results`] has what a page draws it by,
//! and the functions of a live module (`crates/plm-view/src/live/shim.rs.txt`) run it; bodies can be pulled. Where it is none,
//! [`plm_message`] has the diagnostics, and the mechanism before goes on.

mod session;

use std::cell::RefCell;

pub use session::Session;

/// Texts and bytes that were asked for last, and the session.
#[derive(Default)]
struct Page {
    session: Session,
    language: plm_cli::Server,
    room: Vec<u8>,
    text: String,
}

thread_local! {
    static PAGE: RefCell<Page> = RefCell::default();
}

fn with<T>(run: impl FnOnce(&mut Page) -> T) -> T {
    PAGE.with_borrow_mut(run)
}

/// Keeps a text, and tells where it stands; [`plm_text_length`] has its bytes.
fn keep(page: &mut Page, text: String) -> *const u8 {
    page.text = text;
    page.text.as_ptr()
}

/// Makes room for a text of so many bytes, and tells where it begins.
#[unsafe(no_mangle)]
pub extern "C" fn plm_room(length: usize) -> *mut u8 {
    with(|page| {
        page.room = vec![0; length];
        page.room.as_mut_ptr()
    })
}

/// Compiles the text in the room, and stands at its start; 1 if it is a mechanism.
#[unsafe(no_mangle)]
pub extern "C" fn plm_compile() -> i32 {
    with(|page| {
        let text = String::from_utf8_lossy(&page.room).into_owned();
        page.session.compile(&text).into()
    })
}

/// The place of the diagnostics of the last text, UTF-8; nothing where it is a mechanism.
#[unsafe(no_mangle)]
pub extern "C" fn plm_message() -> *const u8 {
    with(|page| {
        let text = page.session.message().to_owned();
        keep(page, text)
    })
}

/// Answers the message of the language server protocol in the room: the place of a list of messages, JSON.
#[unsafe(no_mangle)]
pub extern "C" fn plm_answer() -> *const u8 {
    with(|page| {
        let message = String::from_utf8_lossy(&page.room).into_owned();
        let answers = page.language.message(&message);
        keep(page, format!("[{}]", answers.join(",")))
    })
}

/// The place of a results file of the start, which tells a page what the mechanism is.
#[unsafe(no_mangle)]
pub extern "C" fn plm_results() -> *const u8 {
    with(|page| page.session.results().as_ptr())
}

/// Bytes of the results file.
#[unsafe(no_mangle)]
pub extern "C" fn plm_results_length() -> usize {
    with(|page| page.session.results().len())
}

/// Begins again with parameters and starts as they are set; 1 if it could be assembled.
#[unsafe(no_mangle)]
pub extern "C" fn plm_restart() -> i32 {
    with(|page| page.session.restart().into())
}

/// Begins again as declared; 1 if it could be assembled.
#[unsafe(no_mangle)]
pub extern "C" fn plm_reset() -> i32 {
    with(|page| page.session.reset().into())
}

/// Goes on by `dt`, s; 1 if it could.
#[unsafe(no_mangle)]
pub extern "C" fn plm_step(dt: f64) -> i32 {
    with(|page| page.session.step(dt).into())
}

/// The place of the numbers of the moment, as `plm::live::Live::read` has them.
#[unsafe(no_mangle)]
pub extern "C" fn plm_read() -> *const f64 {
    with(|page| page.session.read().as_ptr())
}

/// How many numbers the moment has.
#[unsafe(no_mangle)]
pub extern "C" fn plm_length() -> usize {
    with(|page| page.session.read().len())
}

/// The place of the numbers of the picture that parameters change, as `plm::live::Live::shape` has them.
#[unsafe(no_mangle)]
pub extern "C" fn plm_shape() -> *const f64 {
    with(|page| page.session.shape().as_ptr())
}

/// How many numbers the picture has.
#[unsafe(no_mangle)]
pub extern "C" fn plm_shape_length() -> usize {
    with(|page| page.session.shape().len())
}

/// A parameter, SI.
#[unsafe(no_mangle)]
pub extern "C" fn plm_parameter(index: usize) -> f64 {
    with(|page| page.session.parameter(index))
}

/// Sets a parameter, SI.
#[unsafe(no_mangle)]
pub extern "C" fn plm_set_parameter(index: usize, value: f64) {
    with(|page| page.session.set_parameter(index, value));
}

/// An input, SI.
#[unsafe(no_mangle)]
pub extern "C" fn plm_input(index: usize) -> f64 {
    with(|page| page.session.input(index))
}

/// Sets an input, SI.
#[unsafe(no_mangle)]
pub extern "C" fn plm_set_input(index: usize, value: f64) {
    with(|page| page.session.set_input(index, value));
}

/// Pulls a body at a point of it (m) by a force (N), absolute axes.
#[unsafe(no_mangle)]
pub extern "C" fn plm_pull(body: usize, x: f64, y: f64, fx: f64, fy: f64) {
    with(|page| page.session.pull(body, [x, y], [fx, fy]));
}

/// Begins again with a body near a pose of its centre of gravity; 1 if the joints close there.
#[unsafe(no_mangle)]
pub extern "C" fn plm_place(body: usize, x: f64, y: f64, angle: f64) -> i32 {
    with(|page| page.session.place(body, [x, y, angle]).into())
}

/// The place of the words of an error of the run, UTF-8: time, part, by how much it stays open and cause, a line each.
#[unsafe(no_mangle)]
pub extern "C" fn plm_trouble() -> *const u8 {
    with(|page| {
        let text = page.session.trouble();
        keep(page, text)
    })
}

/// The place of the names of parts that have sizes, a line each, UTF-8.
#[unsafe(no_mangle)]
pub extern "C" fn plm_size_names() -> *const u8 {
    with(|page| {
        let text = page.session.size_names();
        keep(page, text)
    })
}

/// The place of the rows of contact, a line each: mode, tab, name; UTF-8.
#[unsafe(no_mangle)]
pub extern "C" fn plm_contacts() -> *const u8 {
    with(|page| {
        let text = page.session.contacts();
        keep(page, text)
    })
}

/// Bytes of the text that was asked for last.
#[unsafe(no_mangle)]
pub extern "C" fn plm_text_length() -> usize {
    with(|page| page.text.len())
}
