"""What the programs about the wheel of the gantry of tests/python.rs share."""

import sys


def expect(holds, what):
    print(("holds: " if holds else "DOES NOT HOLD: ") + what)
    if not holds:
        sys.exit(1)


# Words of Rust, and of its documentation.
RUST = ("`", "::", "Sim", "Trouble", "unwrap", "f64", "Option", "plm")


def refused(kind, said, call):
    """A call is refused with these words, and none of Rust."""
    try:
        call()
    except kind as error:
        expect(said in str(error), f"{kind.__name__}: {error}")
        words = [word for word in RUST if word in str(error)]
        expect(not words, f"in words of Python: {words}")
        return error
    expect(False, f"nothing was wrong where {kind.__name__} was expected: {said}")
