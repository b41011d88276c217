//! Steps that are taken over where a loop is nearly flat, in numbers of twice the precision: the bits of compiled code.

use plm::{Gauss, Rk4, Ros34Pw2};

use crate::beside_text::same_bits;
use crate::near_singular_scenes::{Kite, TripleRocker};

#[test]
fn steps_near_a_flat_pose_have_the_bits_of_compiled_code() {
    let stack = std::thread::Builder::new().stack_size(8 << 20);
    let compare = || {
        for (h, name) in [(0.1, "Rk4:0.1"), (0.05, "Rk4:0.05"), (0.02, "Rk4:0.02")] {
            same_bits(TripleRocker::new(), (Rk4::new(h), name), (20, 0.1));
            same_bits(Kite::new(), (Rk4::new(h), name), (20, 0.1));
        }
        same_bits(TripleRocker::new(), (Ros34Pw2::new(0.02), "Ros34Pw2:0.02"), (20, 0.1));
        same_bits(TripleRocker::new(), (Gauss::<_, 2>::new(0.02), "Gauss2:0.02"), (20, 0.1));
    };
    stack.spawn(compare).unwrap().join().unwrap();
}
