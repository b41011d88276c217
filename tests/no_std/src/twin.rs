//! The scene in an ordinary program, with std and its square root.

mod scene;

fn main() {
    scene::run(|bits| println!("{bits:016x}")).expect("the scene runs");
}
