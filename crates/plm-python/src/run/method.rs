//! Parses the method of integration by its names in Python.

use plm_run::{BadOption, Integrator, nearest};

/// Which method it is, and how exactly; also as on the command line, `rk4:1e-3`.
///
/// # Errors
/// A name that there is not, with the nearest; a tolerance where a longest step is wanted, or the other way round; one that is
/// missing, or not positive.
pub fn method(
    name: &str,
    tolerance: Option<f64>,
    longest_step: Option<f64>,
) -> Result<Integrator, BadOption> {
    let (name, number) = name.split_once(':').map_or((name, None), |(name, number)| (name, Some(number)));
    let Some((own, is_fixed)) = Integrator::named(name) else { return Err(unknown(name)) };
    let own = own.to_lowercase();
    let keyword = if is_fixed { "longest_step" } else { "tolerance" };
    let (given, other) = if is_fixed { (longest_step, tolerance) } else { (tolerance, longest_step) };
    if other.is_some() {
        return Err(BadOption::new(if is_fixed {
            format!("'{own}' has steps of fixed length: longest_step, not tolerance")
        } else {
            format!("'{own}' chooses its steps by their error: tolerance, not longest_step")
        }));
    }
    let wrong = |text: &str| BadOption::new(format!("{keyword} must be a positive number, not {text}"));
    let value = match (number, given) {
        (Some(_), Some(_)) => {
            return Err(BadOption::new(format!("{keyword} is given twice: in method and by its keyword")));
        }
        (Some(text), None) => Some(text.parse::<f64>().map_err(|_| wrong(&format!("'{text}'")))?),
        (None, given) => given,
    };
    match value {
        Some(value) if !(value > 0.0 && value.is_finite()) => Err(wrong(&number_of_python(value))),
        Some(value) => Integrator::by_name(&own, Some(value)).ok_or_else(|| unknown(name)),
        None => Integrator::by_name(&own, None).ok_or_else(|| {
            BadOption::new(format!(
                "'{own}' has steps of fixed length, which must be given: longest_step=1e-3, in s"
            ))
        }),
    }
}

fn unknown(name: &str) -> BadOption {
    let names: Vec<String> = Integrator::names().map(str::to_lowercase).collect();
    let near = nearest(name, names.iter().map(String::as_str));
    let hint = near.map_or("there are".to_owned(), |near| format!("did you mean '{near}'? There are"));
    BadOption::new(format!("there is no method '{name}'; {hint} {}", names.join(", ")))
}

/// As Python writes it.
fn number_of_python(number: f64) -> String {
    match number {
        number if number.is_nan() => "nan".to_owned(),
        number => format!("{number:?}"),
    }
}

#[cfg(test)]
mod tests {
    use super::{Integrator, method};

    #[test]
    fn methods_are_told_by_name_and_number() {
        for (name, tolerance, step, said) in [
            ("dop853", None, None, Ok(Integrator::Dop853(1e-9))),
            ("Dopri5", Some(1e-6), None, Ok(Integrator::Dopri5(1e-6))),
            ("rk4", None, Some(1e-3), Ok(Integrator::Rk4(1e-3))),
            ("rk4:2e-3", None, None, Ok(Integrator::Rk4(2e-3))),
            ("rk4:2e-3", None, Some(1e-3), Err("longest_step is given twice: in method and by its keyword")),
            ("Rk4:x", None, None, Err("longest_step must be a positive number, not 'x'")),
            ("rk4", Some(1e-6), None, Err("'rk4' has steps of fixed length: longest_step, not tolerance")),
            (
                "dop853",
                None,
                Some(1.0),
                Err("'dop853' chooses its steps by their error: tolerance, not longest_step"),
            ),
            ("Dop853", Some(-1.0), None, Err("tolerance must be a positive number, not -1.0")),
            ("dop853", Some(f64::NAN), None, Err("tolerance must be a positive number, not nan")),
            (
                "rk4",
                None,
                None,
                Err("'rk4' has steps of fixed length, which must be given: longest_step=1e-3, in s"),
            ),
            (
                "rk5",
                None,
                Some(1.0),
                Err(
                    "there is no method 'rk5'; did you mean 'rk4'? There are dop853, vern9, adams, dopri5, radauiia5, \
                     rk4, semiimpliciteuler, gauss2, gauss3, ros34pw2, moreaujean",
                ),
            ),
        ] {
            let found = method(name, tolerance, step).map_err(|bad| bad.to_string());
            assert_eq!(found, said.map_err(ToString::to_string), "{name}");
        }
    }
}
