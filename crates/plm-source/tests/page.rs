//! The examples of the book's pages on C source and on GPUs: their declarations, their programs, and what these print.

#![allow(clippy::unwrap_used, reason = "a test ends where something is missing")]

use std::fs;
use std::path::Path;
use std::process::Command;

use plm_dynamic::Mechanism;
use plm_source::Precision;

/// The text of the page's only block in a language.
fn block<'a>(page: &'a str, language: &str) -> &'a str {
    let (_, after) = page.split_once(&format!("```{language}\n")).unwrap();
    after.split_once("```").unwrap().0
}

/// The page of CUDA C: its files, and what its commands on a processor print.
#[test]
fn four_pendulums_of_the_page_on_gpus_have_their_parameters() {
    let page = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/src/running/cuda.md");
    let page = fs::read_to_string(page).unwrap();
    let mut mechanism = Mechanism::from_text(block(&page, "plm")).unwrap();
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("cuda-page");
    fs::create_dir_all(&folder).unwrap();
    for file in plm_source::cuda(&mechanism, Precision::Double).unwrap() {
        assert!(page.contains(&format!("written: pendulum/{}", file.name)), "{}", file.name);
        fs::write(folder.join(&file.name), &file.text).unwrap();
    }
    let (_, commands) = page.split_once("$ cd pendulum\n").unwrap();
    let commands = commands.split_once("```").unwrap().0.replace("$ ", "");
    let ran = Command::new("sh").args(["-e", "-c", &commands]).current_dir(&folder).output().unwrap();
    let said = String::from_utf8(ran.stdout).unwrap();
    assert_eq!(said.lines().count(), 4, "{}", String::from_utf8_lossy(&ran.stderr));
    for (line, friction) in said.lines().zip([0.0, 1.0 / 3.0, 2.0 / 3.0, 1.0].map(|share| share * 0.3)) {
        mechanism.set_parameter("friction", friction).unwrap();
        let mut steps = mechanism.steps().unwrap();
        (0..1000).for_each(|_| steps.step(1e-3).unwrap());
        assert!(line.starts_with("0 0 "), "{line}");
        let angle = line.split(' ').nth(2).unwrap();
        assert_eq!(angle, hexadecimal(steps.numbers().x[0]), "{friction} N m s");
    }
}

/// A normal number as C's `%a` writes it.
fn hexadecimal(number: f64) -> String {
    let bits = number.to_bits();
    let digits = format!("{:013x}", bits & ((1 << 52) - 1));
    let exponent = ((bits >> 52) & 0x7ff) as i32 - 1023;
    let sign = if number < 0.0 { "-" } else { "" };
    let digits = digits.trim_end_matches('0');
    format!("{sign}0x1{}{digits}p{exponent:+}", if digits.is_empty() { "" } else { "." })
}

#[test]
fn the_example_of_the_book_prints_what_the_book_says() {
    let page = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/src/running/c-source.md");
    let page = fs::read_to_string(page).unwrap();
    let mechanism = Mechanism::from_text(block(&page, "plm")).unwrap();
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("page");
    fs::create_dir_all(&folder).unwrap();
    let files = plm_source::c(&mechanism, Precision::Double).unwrap();
    for file in &files {
        assert!(page.contains(&format!("written: pendulum/{}", file.name)), "{}", file.name);
        fs::write(folder.join(&file.name), &file.text).unwrap();
    }
    fs::write(folder.join("main.c"), block(&page, "c")).unwrap();
    let made = Command::new("cc")
        .args(["-std=c99", "-O2", "-Wall", "-Werror", "main.c", "pendulum.c", "-o", "main"])
        .current_dir(&folder)
        .output()
        .unwrap();
    assert!(made.status.success(), "{}", String::from_utf8_lossy(&made.stderr));
    let ran = Command::new(folder.join("main")).output().unwrap();
    let said = String::from_utf8(ran.stdout).unwrap();
    assert!(page.contains(&format!("./main\n{said}```")), "{said}");
}
