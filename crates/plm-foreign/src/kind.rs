//! Kinds of numbers of an object.

use plm_runtime::{Rate, StartValues, Vector};

use crate::{Error, Foreign, Status};

/// Kind of a number. The numbers of each kind count from 0 in the order of the declaration.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(i32)]
pub enum Kind {
    /// A parameter, SI; can be set at any time.
    Parameter = 0,
    /// An input, SI; can be set once the mechanism has started, and is constant until it is set again.
    Input = 1,
    /// A first-order state, SI; can be read.
    State = 2,
    /// A quantity that is observed, the declared outputs among them, SI; can be read.
    Output = 3,
    /// A start value, SI: x, y, angle, vx, vy, omega of each body, then the first-order states. Counts at the next start.
    Start = 4,
    /// A body: has a name and a pose.
    Body = 5,
    /// Integrated state, SI: coordinates, their velocities, first-order states; can be read. Of a loop it is another
    /// coordinate now and then.
    Integrated = 6,
    /// The rate of each of these, SI; can be read.
    Rate = 7,
    /// A row of contact: what it does, as [`Mode::number`](plm_runtime::contact::Mode::number) says; can be read once the mechanism has started.
    Contact = 8,
}

impl Kind {
    /// All kinds, in the order of their numbers.
    pub const ALL: [Self; 9] = [
        Self::Parameter,
        Self::Input,
        Self::State,
        Self::Output,
        Self::Start,
        Self::Body,
        Self::Integrated,
        Self::Rate,
        Self::Contact,
    ];

    /// The kind with this number.
    ///
    /// # Errors
    /// [`Status::NoSuch`]
    pub fn of(number: i32) -> Result<Self, Error> {
        Self::ALL.into_iter().find(|kind| *kind as i32 == number).ok_or(Status::NoSuch.into())
    }

    /// Its name in C, after `PLM_`.
    pub(crate) fn word(self) -> &'static str {
        match self {
            Self::Parameter => "PARAMETER",
            Self::Input => "INPUT",
            Self::State => "STATE",
            Self::Output => "OUTPUT",
            Self::Start => "START",
            Self::Body => "BODY",
            Self::Integrated => "INTEGRATED",
            Self::Rate => "RATE",
            Self::Contact => "CONTACT",
        }
    }

    /// Gives `each` the names of this kind, in their order; `declared` is any mechanism of the type.
    pub fn names<M: Foreign>(self, declared: &M, each: &mut impl FnMut(&'static str)) {
        match self {
            Self::Parameter => declared.tables().parameters.iter().for_each(|row| each(row.name)),
            Self::Input => declared.tables().inputs.iter().for_each(|row| each(row.name)),
            Self::State => declared.tables().states.iter().for_each(|row| each(row.name)),
            Self::Output => declared.observables().iter().for_each(|(name, _)| each(name)),
            Self::Start => {
                let mut copy = *declared;
                copy.starts_mut().each(&mut |name, _| each(name));
            }
            Self::Body => declared.tables().bodies.iter().for_each(|body| each(body.name)),
            Self::Contact => (0..declared.contact_count()).for_each(|row| each(declared.contact_name(row))),
            Self::Integrated | Self::Rate => {
                for index in 0..<M as Rate>::X::LEN {
                    each(declared.name_of_state(index));
                }
            }
        }
    }

    /// How many there are of this kind.
    pub fn count<M: Foreign>(self, declared: &M) -> usize {
        let mut count = 0;
        self.names(declared, &mut |_| count += 1);
        count
    }

    /// A name of this kind.
    ///
    /// # Errors
    /// [`Status::NoSuch`]
    pub fn name<M: Foreign>(self, declared: &M, index: usize) -> Result<&'static str, Error> {
        let (mut at, mut found) = (0, None);
        self.names(declared, &mut |name| {
            if at == index {
                found = Some(name);
            }
            at += 1;
        });
        found.ok_or(Status::NoSuch.into())
    }

    /// The number of a name of this kind.
    ///
    /// # Errors
    /// [`Status::NoSuch`]
    pub fn find<M: Foreign>(self, declared: &M, name: &[u8]) -> Result<usize, Error> {
        let (mut at, mut found) = (0, None);
        self.names(declared, &mut |own| {
            if found.is_none() && own.as_bytes() == name {
                found = Some(at);
            }
            at += 1;
        });
        found.ok_or(Status::NoSuch.into())
    }
}
