//! What is emitted after errors: the name of the mechanism, so that its absence adds none of rustc's.

use super::{Code, names};
use crate::span::Span;

/// A type without content under the declared name; its methods accept what users write most.
pub(crate) fn emit_stub(name: &str, visibility: &str, crate_path: &str, span: Span) -> Code {
    let name = names::ident(name);
    let module = names::snake_case(&name);
    Code {
        before: format!("#[doc(inline)]\n{visibility} use self::{module}::{name};\n"),
        module: format!("#[allow(clippy::all, clippy::pedantic, missing_docs, unused)]\n{visibility} mod {module}"),
        public: format!(
            "    #[derive(Clone, Copy, Debug)]
    pub struct {name}<S = f64>(core::marker::PhantomData<S>);

    impl {name}<f64> {{
        pub fn new() -> Self {{
            {name}(core::marker::PhantomData)
        }}
    }}

    impl<S> {name}<S> {{
        pub fn of() -> Self {{
            {name}(core::marker::PhantomData)
        }}
        pub fn start(self) -> Result<Self, {crate_path}::Fault> {{
            Ok(self)
        }}
        pub fn start_with<I>(self, _method: I) -> Result<Self, {crate_path}::Fault> {{
            Ok(self)
        }}
        pub fn step<T>(&mut self, _by: T) -> Result<(), {crate_path}::Fault> {{
            Ok(())
        }}
    }}
"
        ),
        implementation: String::new(),
        names: vec![(name, span)],
    }
}
