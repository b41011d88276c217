//! The manual's demos from text: the bits of compiled ones.

use plm::dynamic;
use plm::runtime::Described;

use crate::beside_text::same;
use crate::demos::{
    connect_plm_hcd, connect_plm_hyd, double_arm, double_pendulum, plmassembly, plmbod02, plmcalcul,
    plmemb01, plmj00, plmpiv00, plmpiv10, plmt01d, plmt01d01, plmtra00, plmtra10, plmtrpi00, prismatic_joint,
    quadrorhomb,
};

#[test]
fn demos_of_mechanics_have_the_bits_of_compiled_code() {
    same!(
        double_pendulum::DoublePendulum: 0.5,
        prismatic_joint::System1: 0.2,
        prismatic_joint::Systems23: 0.2,
        plmpiv00::Plmpiv00: 0.2,
        plmpiv10::Plmpiv10: 0.2,
        plmtra00::Plmtra00: 0.2,
        plmtra10::Plmtra10: 0.2,
        plmtrpi00::Plmtrpi00: 0.2,
        plmj00::Plmj00: 0.2,
        quadrorhomb::Quadrorhomb: 0.2,
        plmbod02::Relative: 0.2,
        plmbod02::Drawn: 0.2,
        plmemb01::Plmemb01: 0.2,
        plmt01d::Plmt01d: 0.2,
        plmt01d01::Plmt01d01: 0.2,
        plmcalcul::Plmcalcul: 0.2,
    );
}

#[test]
fn hydraulic_demos_have_the_bits_of_compiled_code() {
    same!(
        connect_plm_hyd::ConnectPlmHyd: 0.02,
        connect_plm_hcd::ConnectPlmHcd: 0.02,
        double_arm::DoubleArm: 0.02,
    );
}

/// The start that the manual shows as refused is refused in the same words.
#[test]
fn redundant_locks_are_those_of_compiled_code() {
    let fault = plmassembly::Plmassembly::new().start().unwrap_err();
    let text = dynamic::Mechanism::from_text(<plmassembly::Plmassembly as Described>::DECLARATION).unwrap();
    assert_eq!(text.start().unwrap_err().to_string(), fault.to_string());
}
