//! The demos of the manual, one file each, under the manual's names.

pub mod balance;
pub mod sheet;

pub mod connect_plm_hcd;
pub mod connect_plm_hyd;
pub mod double_arm;
pub mod double_pendulum;
pub mod plmassembly;
pub mod plmbod02;
pub mod plmcalcul;
pub mod plmemb01;
pub mod plmj00;
pub mod plmpiv00;
pub mod plmpiv10;
pub mod plmt01d;
pub mod plmt01d01;
pub mod plmtra00;
pub mod plmtra10;
pub mod plmtrpi00;
pub mod prismatic_joint;
pub mod quadrorhomb;

use sheet::Demo;

/// Every demo, in the order of the manual.
pub const DEMOS: [Demo; 18] = [
    ("DoublePendulum", double_pendulum::sheet),
    ("PrismaticJoint", prismatic_joint::sheet),
    ("ConnectPlmHyd", connect_plm_hyd::sheet),
    ("ConnectPlmHCD", connect_plm_hcd::sheet),
    ("DoubleArm", double_arm::sheet),
    ("PLMPIV00", plmpiv00::sheet),
    ("PLMPIV10", plmpiv10::sheet),
    ("PLMTRA00", plmtra00::sheet),
    ("PLMTRA10", plmtra10::sheet),
    ("PLMTRPI00", plmtrpi00::sheet),
    ("PLMJ00", plmj00::sheet),
    ("Quadrorhomb", quadrorhomb::sheet),
    ("PLMBOD02", plmbod02::sheet),
    ("PLMASSEMBLY", plmassembly::sheet),
    ("PLMEMB01", plmemb01::sheet),
    ("PLMT01D", plmt01d::sheet),
    ("PLMT01D01", plmt01d01::sheet),
    ("PLMCALCUL", plmcalcul::sheet),
];
