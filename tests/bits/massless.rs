//! Bodies without mass in driven mechanisms.

use plm::Described;

use crate::beside_text::same;
use crate::massless_scenes::driven;

driven!(without);

#[test]
fn bodies_without_mass_have_the_bits_of_compiled_code() {
    same!(without::FourBar: 1.0, without::Plate: 1.0, without::Hanging: 1.0);
}

/// Neither a mass nor an inertia is a parameter.
#[test]
fn a_body_without_mass_has_no_parameters_of_it() {
    assert_eq!(<without::FourBar as Described>::TABLES.parameters.len(), 1);
}
