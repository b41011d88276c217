//! Rows of contact along the motion.
//!
//! A row has the displacement `z(q, t)`, the rate `z' = w v + r` and the acceleration `z'' = w a + zeta` with `w = dz/dq`
//! (F. Pfeiffer, Ch. Glocker, Multibody Dynamics with Unilateral Contacts, 1996, chapter 3).

use plm_cas::Expr;

use super::{Columns, SparseRow, along_motion};
use crate::collect::CollectVec;
use crate::model::Model;

/// A row of contact.
pub(crate) struct ContactRow {
    /// `w`: (coordinate, entry).
    pub(crate) direction: SparseRow,
    /// `w v + r`, m/s or rad/s.
    pub(crate) rate: Expr,
    /// `zeta`: what the acceleration has beside `w a`, m/s^2 or rad/s^2.
    pub(crate) bias: Expr,
}

/// All rows of contact.
pub(super) fn rows(model: &Model, (q, v): (&[Expr], &[Expr]), columns: &Columns) -> Vec<ContactRow> {
    let row = |displacement: Expr| {
        let (direction, rate, bias) = along_motion(model, (q, v), columns, displacement);
        ContactRow { direction, rate, bias }
    };
    model.contacts.iter().map(|contact| row(contact.displacement)).collect_vec()
}
