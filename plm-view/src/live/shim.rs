thread_local! {
    static LIVE: std::cell::RefCell<Option<plm::live::Live<NAME>>> = const { std::cell::RefCell::new(None) };
    static TEXT: std::cell::RefCell<String> = const { std::cell::RefCell::new(String::new()) };
}

fn with<T>(run: impl FnOnce(&mut plm::live::Live<NAME>) -> T) -> T {
    LIVE.with_borrow_mut(|live| run(live.get_or_insert_with(|| plm::live::Live::new(NAME::new()))))
}

/// Begins again with parameters and starts as they are set; 1 if it could be assembled.
#[unsafe(no_mangle)]
pub extern "C" fn plm_restart() -> i32 {
    with(|live| live.restart().into())
}

/// Begins again as declared; 1 if it could be assembled.
#[unsafe(no_mangle)]
pub extern "C" fn plm_reset() -> i32 {
    with(|live| live.reset().into())
}

/// Goes on by `dt`, s; 1 if it could.
#[unsafe(no_mangle)]
pub extern "C" fn plm_step(dt: f64) -> i32 {
    with(|live| live.step(dt).into())
}

/// Where the numbers of the moment stand: time; x, y, angle, vx, vy, omega of each body; x, y, angle of each port of the
/// ground; all observed quantities, SI.
#[unsafe(no_mangle)]
pub extern "C" fn plm_read() -> *const f64 {
    with(|live| live.read().as_ptr())
}

/// How many they are.
#[unsafe(no_mangle)]
pub extern "C" fn plm_length() -> usize {
    with(|live| live.read().len())
}

/// Where what parameters change of bodies and ground stands: of each body mass, moment of inertia, depth, x, y, angle of each
/// port, the number of points of its contour, and these; x, y, angle, depth of each port of the ground; SI.
#[unsafe(no_mangle)]
pub extern "C" fn plm_shape() -> *const f64 {
    with(|live| live.shape().as_ptr())
}

/// How many numbers they are.
#[unsafe(no_mangle)]
pub extern "C" fn plm_shape_length() -> usize {
    with(|live| live.shape().len())
}

#[unsafe(no_mangle)]
pub extern "C" fn plm_parameter(index: usize) -> f64 {
    with(|live| live.parameter(index))
}

#[unsafe(no_mangle)]
pub extern "C" fn plm_set_parameter(index: usize, value: f64) {
    with(|live| live.set_parameter(index, value))
}

#[unsafe(no_mangle)]
pub extern "C" fn plm_input(index: usize) -> f64 {
    with(|live| live.input(index))
}

#[unsafe(no_mangle)]
pub extern "C" fn plm_set_input(index: usize, value: f64) {
    with(|live| live.set_input(index, value))
}

/// Pulls a body at a point of it (m) by a force (N), absolute axes.
#[unsafe(no_mangle)]
pub extern "C" fn plm_pull(body: usize, x: f64, y: f64, fx: f64, fy: f64) {
    with(|live| live.pull(body, [x, y], [fx, fy]))
}

/// Begins again with a body near a pose of its centre of gravity; 1 if the joints close there.
#[unsafe(no_mangle)]
pub extern "C" fn plm_place(body: usize, x: f64, y: f64, angle: f64) -> i32 {
    with(|live| live.place(body, [x, y, angle]).into())
}

/// Where the words of what is wrong stand, UTF-8: time, part and cause, a line each; nothing where nothing is wrong.
#[unsafe(no_mangle)]
pub extern "C" fn plm_trouble() -> *const u8 {
    let text = with(|live| live.trouble().map(|trouble| format!("{}\n{}\n{}", trouble.time, trouble.part, trouble.text)));
    TEXT.with_borrow_mut(|own| {
        *own = text.unwrap_or_default();
        own.as_ptr()
    })
}

/// How many bytes they are.
#[unsafe(no_mangle)]
pub extern "C" fn plm_trouble_length() -> usize {
    TEXT.with_borrow(String::len)
}
