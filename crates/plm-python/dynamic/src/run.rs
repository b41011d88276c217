//! A run of a mechanism from text.

use plm_dynamic::{OnRun, Run};
use plm_python::run::{Running, Work};
use plm_runtime::held::Discrete;
use plm_runtime::{Described, Linear, Method, Sim, Statics};

/// A run of a mechanism from text. A copy goes on as the original does, to the bit.
#[derive(Clone)]
pub(crate) struct Own(pub(crate) Run);

impl Running for Own {
    fn then<W: Work>(&mut self, work: W) -> W::Output {
        self.0.then(OnText(work))
    }
}

/// Work on a run of a mechanism from text.
struct OnText<W>(W);

impl<W: Work> OnRun for OnText<W> {
    type Output = W::Output;

    fn on<M, I>(self, sim: &mut Sim<M, I>) -> W::Output
    where
        M: Described<S = f64, U: Discrete> + Statics + Linear<Lifted<1>: Described + Statics>,
        I: Method<M>,
    {
        self.0.on(sim)
    }
}
