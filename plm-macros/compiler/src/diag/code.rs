//! The catalogue of diagnostics.

/// Writes the enum, its names, its titles and its hints from one table: `hint` stands after the title of a code that says what is
/// hardly meant.
macro_rules! catalogue {
    (@is_hint) => { false };
    (@is_hint hint) => { true };
    ($($name:ident = $id:literal, $title:literal $(, $hint:ident)?;)*) => {
        /// Code of a diagnostic. Each has a page in the book.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub enum Code {
            $(#[doc = $title] $name,)*
        }

        impl Code {
            /// Every code, in the order of the catalogue.
            pub const ALL: &'static [Code] = &[$(Code::$name,)*];

            /// As it is printed: `E0201`.
            pub fn id(self) -> &'static str {
                match self { $(Code::$name => $id,)* }
            }

            /// Its title, in a few words.
            pub fn title(self) -> &'static str {
                match self { $(Code::$name => $title,)* }
            }

            /// Does it say what is hardly meant? Such a warning waits until there is no error.
            pub fn is_hint(self) -> bool {
                match self { $(Code::$name => catalogue!(@is_hint $($hint)?),)* }
            }
        }
    };
}

catalogue! {
    // E01: the form of the declaration.
    UnexpectedToken = "E0101", "something else was expected here";
    UnclosedDelimiter = "E0102", "a bracket has no partner";
    UnknownItem = "E0103", "no such item";
    SuffixedNumber = "E0104", "a unit touches its number";
    BadNumber = "E0105", "a number that cannot be read";
    TooDeep = "E0106", "an expression or a definition is nested too deeply";
    MisplacedItem = "E0107", "an item stands where it has no meaning";
    RepeatedItem = "E0108", "an item that may stand once stands twice";
    NoMechanism = "E0109", "the declaration declares no mechanism";

    // E02: names.
    UnknownName = "E0201", "unknown name";
    DuplicateName = "E0202", "a name is declared twice";
    UnknownMember = "E0203", "unknown member";
    UnknownPort = "E0204", "unknown port";
    UnknownPart = "E0205", "unknown part";
    UnknownField = "E0206", "unknown parameter of a part";
    UnknownFunction = "E0207", "unknown function";
    ReservedName = "E0208", "a reserved word is used as a name";
    UnitAsName = "E0209", "the name of a unit is used as a name";
    NeedsIndex = "E0210", "a name needs an index";
    Cycle = "E0211", "a definition needs itself";
    UnknownOption = "E0212", "unknown option of a choice";
    UnknownRow = "E0213", "unknown row";
    TypeName = "E0214", "the name of a mechanism is not that of a type";

    // E03: units and dimensions.
    WrongDimension = "E0301", "wrong dimension";
    MissingUnit = "E0302", "a quantity has no unit";
    MissingAngleUnit = "E0303", "an angle has no unit";
    UnknownUnit = "E0304", "unknown unit";
    MixedDimensions = "E0305", "two sides of an operation have different dimensions";
    BadUnit = "E0306", "a unit that cannot be read";

    // E04: values.
    MissingValue = "E0401", "a value is missing";
    NotPositive = "E0402", "a mass, an inertia or a compliance is not positive";
    DivisionByZero = "E0403", "division by zero";
    OutOfDomain = "E0404", "an argument is outside of the domain of its function";
    WrongKind = "E0405", "another kind of value is expected";
    WrongCount = "E0406", "wrong number of arguments";
    NotConstant = "E0407", "a value changes where it must not";
    NotInteger = "E0408", "a whole number is expected";
    StateRate = "E0409", "a state has no rate, or two";
    NoRate = "E0410", "a rate that is not defined";
    Feedback = "E0411", "a force reads an acceleration or a reaction";
    BadTable = "E0412", "a table that cannot be read";
    TooMany = "E0413", "more repetitions or parts than can be";
    BadIndex = "E0414", "an index out of range";
    BadContour = "E0415", "a contour that cannot be drawn";
    JumpingMotion = "E0416", "a prescribed motion jumps";
    ContactNumber = "E0417", "a restitution or a bound of friction that cannot be";

    // E05: topology, mobility, assembly.
    SelfJoint = "E0501", "a joint joins a body with itself";
    TooManyLocks = "E0502", "there are more locks than degrees of freedom";
    NotAssembled = "E0503", "the mechanism cannot be assembled";
    NoBody = "E0504", "the mechanism has no body";
    NoFormulation = "E0505", "a formulation that does not hold the mechanism";
    PairDisagrees = "E0506", "a joint's constraints are not those of its pair";
    OtherBranch = "E0507", "the mirror image that a joint asks for was not found";
    NoMotion = "E0508", "the start is a change point, and its velocities belong to no motion";

    // W0: warnings.
    RedundantConstraint = "W0001", "a constraint says what others say already";
    Unreached = "W0002", "a body that nothing holds or reaches";
    UnknownCode = "W0003", "an allowed code that does not exist";
    Strained = "W0004", "a joint with a compliance is open at the start";
    Upwards = "W0005", "gravity pulls upwards", hint;
    Idle = "W0006", "a part does nothing", hint;
    Unread = "W0007", "nothing reads a name", hint;
    Renamed = "W0008", "the former name of an item";
    UnitOrName = "W0009", "a unit that is the name of a value too";
    ChangePoint = "W0010", "the start is a change point";
    FarStart = "W0011", "the start closes only far from where it is declared";
    OpenDefaults = "W0012", "the mechanism cannot be assembled with its parameters as declared";
}

impl core::fmt::Display for Code {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.write_str(self.id())
    }
}

#[cfg(test)]
mod tests {
    use super::Code;

    #[test]
    fn codes_are_in_order_and_unique() {
        let ids: Vec<&str> = Code::ALL.iter().map(|code| code.id()).collect();
        let mut sorted = ids.clone();
        sorted.sort_unstable();
        sorted.dedup();
        assert_eq!(ids, sorted);
    }

    #[test]
    fn hints_are_warnings() {
        let hints = Code::ALL.iter().filter(|code| code.is_hint()).map(|code| code.id());
        assert_eq!(hints.collect::<Vec<_>>(), ["W0005", "W0006", "W0007"]);
    }
}
