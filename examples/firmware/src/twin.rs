//! The same steps in an ordinary program, with std and its square root.

mod arm;
mod contact;
mod filter;
mod steps;

fn main() {
    steps::run(&mut |bits| println!("{bits:016x}"), &mut |_| ()).expect("the mechanisms move");
}
