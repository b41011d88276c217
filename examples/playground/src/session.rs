//! A text, and the live mechanism that it declares.

use plm::dynamic::{Compiled, Dynamic, Large, Refused, Small};
use plm::live::{Live, with_pulls};
use plm::runtime::described::Described;
use plm::runtime::{Mechanism, Statics};
use plm_view::{Recorder, Results};

/// The mechanism of the last text that was one.
#[derive(Default)]
pub struct Session {
    live: Option<OfSize>,
    message: String,
    results: Vec<u8>,
}

/// A live mechanism of either size.
enum OfSize {
    Small(Box<Live<Small>>),
    Large(Box<Live<Large>>),
}

/// Asks the live mechanism; nothing of its kind where there is none.
macro_rules! ask {
    ($session:expr, $live:ident => $value:expr) => {
        match &mut $session.live {
            None => Default::default(),
            Some(OfSize::Small($live)) => $value,
            Some(OfSize::Large($live)) => $value,
        }
    };
}

impl Session {
    /// Compiles a text, and stands at its start; false if it is no mechanism, and then the one before goes on.
    pub fn compile(&mut self, text: &str) -> bool {
        match compiled(text) {
            Ok((live, results)) => {
                (self.live, self.results, self.message) = (Some(live), results, String::new());
                true
            }
            Err(refused) => {
                self.message = refused.to_string();
                false
            }
        }
    }

    /// The diagnostics of the last text.
    pub fn message(&self) -> &str {
        &self.message
    }

    /// A results file of the start.
    pub fn results(&self) -> &[u8] {
        &self.results
    }

    /// As [`Live::restart`].
    pub fn restart(&mut self) -> bool {
        ask!(self, live => live.restart())
    }

    /// As [`Live::reset`].
    pub fn reset(&mut self) -> bool {
        ask!(self, live => live.reset())
    }

    /// As [`Live::step`].
    pub fn step(&mut self, dt: f64) -> bool {
        ask!(self, live => live.step(dt))
    }

    /// As [`Live::read`].
    pub fn read(&mut self) -> &[f64] {
        ask!(self, live => live.read())
    }

    /// As [`Live::shape`].
    pub fn shape(&mut self) -> &[f64] {
        ask!(self, live => live.shape())
    }

    /// As [`Live::parameter`].
    pub fn parameter(&mut self, index: usize) -> f64 {
        ask!(self, live => live.parameter(index))
    }

    /// As [`Live::set_parameter`].
    pub fn set_parameter(&mut self, index: usize, value: f64) {
        ask!(self, live => live.set_parameter(index, value));
    }

    /// As [`Live::input`].
    pub fn input(&mut self, index: usize) -> f64 {
        ask!(self, live => live.input(index))
    }

    /// As [`Live::set_input`].
    pub fn set_input(&mut self, index: usize, value: f64) {
        ask!(self, live => live.set_input(index, value));
    }

    /// As [`Live::pull`].
    pub fn pull(&mut self, body: usize, at: [f64; 2], force: [f64; 2]) {
        ask!(self, live => live.pull(body, at, force));
    }

    /// As [`Live::place`].
    pub fn place(&mut self, body: usize, pose: [f64; 3]) -> bool {
        ask!(self, live => live.place(body, pose))
    }

    /// The error of the run: time, part, gap and cause, a line each; nothing where there is none.
    pub fn trouble(&mut self) -> String {
        ask!(self, live => live.error().map(told).unwrap_or_default())
    }

    /// As [`Live::size_names`].
    pub fn size_names(&mut self) -> String {
        ask!(self, live => live.size_names())
    }

    /// As [`Live::contacts`].
    pub fn contacts(&mut self) -> String {
        ask!(self, live => live.contacts())
    }
}

fn told(error: &plm::live::Error) -> String {
    format!("{}\n{}\n{}\n{}", error.time, error.part, error.gap, error.text)
}

/// The mechanism of a text with inputs that pull its bodies, where there is room for them, and the results file of its start.
fn compiled(text: &str) -> Result<(OfSize, Vec<u8>), Refused> {
    let declared = Compiled::new("text", text)?;
    let fits: Result<Small, Refused> = declared.clone().mechanism();
    match fits {
        Ok(small) => {
            let bodies: Vec<&str> = small.tables().bodies.iter().map(|body| body.name).collect();
            let pulled = Compiled::new("text", &with_pulls(text, &bodies)).and_then(Compiled::mechanism);
            let own: Small = pulled.unwrap_or(small);
            #[cfg(target_arch = "wasm32")]
            translate(own);
            Ok((OfSize::Small(Box::new(Live::new(own))), results(own)))
        }
        Err(Refused::TooLarge { .. }) => {
            let own: Large = declared.mechanism()?;
            #[cfg(target_arch = "wasm32")]
            translate(own);
            Ok((OfSize::Large(Box::new(Live::new(own))), results(own)))
        }
        Err(refused) => Err(refused),
    }
}

/// The page makes code of what is evaluated often.
#[cfg(target_arch = "wasm32")]
fn translate<const NQ: usize, const NC: usize, const N: usize, const L: usize>(
    own: Dynamic<f64, NQ, NC, N, L>,
) {
    if let Some(host) = plm_jit::Host::new() {
        own.translate_by(std::sync::Arc::new(host));
    }
}

/// A results file of the start; without a row where it cannot be assembled, so that its parameters can be turned until it can.
fn results<const NQ: usize, const NC: usize, const N: usize, const L: usize>(
    own: Dynamic<f64, NQ, NC, N, L>,
) -> Vec<u8>
where
    Dynamic<f64, NQ, NC, N, L>: Statics<S = f64> + Described,
{
    let mut recorder = Recorder::describing(&own);
    if let Ok(sim) = own.start() {
        recorder.take(sim.state());
    }
    let results = Results { runs: vec![recorder.into_recording()], ..Results::default() };
    results.to_bytes().unwrap_or_default()
}
