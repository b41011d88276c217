//! A mechanism as numbers: what a declaration's parameters are set to, and what the reference solves.

/// Structure of a declaration by names, in its order.
pub struct Shape {
    pub name: &'static str,
    /// Names of the ports of the ground.
    pub ground: &'static [&'static str],
    /// Names of bodies and of their ports.
    pub bodies: &'static [(&'static str, &'static [&'static str])],
    /// Kind, name, and the two frames.
    pub joints: &'static [JointShape],
}

/// A joint by names.
pub struct JointShape {
    pub kind: Kind,
    pub name: &'static str,
    pub a: (&'static str, &'static str),
    pub b: (&'static str, &'static str),
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    Revolute,
    Prismatic,
    Slot,
}

/// A port: place in the axes of its body, m; angle of its axis, rad.
pub type Port = [f64; 3];

/// Numbers of a body. Its origin is its centre of gravity.
#[derive(Clone, Debug, Default)]
pub struct Body {
    /// kg
    pub mass: f64,
    /// kg m^2
    pub inertia: f64,
    pub ports: Vec<Port>,
}

/// Numbers of a joint: spring, damper, and where the spring is free; along the axis where there is one.
#[derive(Clone, Copy, Debug, Default)]
pub struct Joint {
    pub stiffness: f64,
    pub damping: f64,
    pub rest: f64,
}

/// Load on the first joint: `push (S((t - begin)/rise) - 2 S((t - turn)/fall))`, S the step 3u^2 - 2u^3 from 0 to 1:
/// it waits, begins and reverses.
#[derive(Clone, Copy, Debug)]
pub struct Load {
    /// N m
    pub push: f64,
    /// s
    pub begin: f64,
    pub rise: f64,
    pub turn: f64,
    pub fall: f64,
}

impl Default for Load {
    fn default() -> Self {
        Self { push: 0.0, begin: 0.0, rise: 1.0, turn: 2.0, fall: 1.0 }
    }
}

impl Load {
    /// Times at which the load is not analytic, s.
    pub fn knots(&self) -> [f64; 4] {
        [self.begin, self.begin + self.rise, self.turn, self.turn + self.fall]
    }
}

/// A mechanism with its numbers.
#[derive(Clone)]
pub struct Scene {
    pub shape: &'static Shape,
    pub ground: Vec<Port>,
    pub bodies: Vec<Body>,
    pub joints: Vec<Joint>,
    pub load: Load,
    /// m/s^2, along -y
    pub gravity: f64,
    /// How much farther along x a port is than its number, m: what rounding has left out of a length that is meant to be exact.
    pub rests: Vec<(Frame, f64)>,
}

/// Which frame: the body (none is the ground) and the number of its port.
pub type Frame = (Option<usize>, usize);

impl Scene {
    /// Everything zero.
    pub fn of(shape: &'static Shape) -> Self {
        let bodies = shape.bodies.iter();
        let bodies = bodies.map(|(_, ports)| Body { ports: vec![[0.0; 3]; ports.len()], ..Body::default() });
        Self {
            shape,
            ground: vec![[0.0; 3]; shape.ground.len()],
            bodies: bodies.collect(),
            joints: vec![Joint::default(); shape.joints.len()],
            load: Load::default(),
            gravity: 0.0,
            rests: Vec::new(),
        }
    }

    /// The frame of these names.
    pub fn frame(&self, (body, port): (&str, &str)) -> Frame {
        let position = |ports: &[&str]| ports.iter().position(|name| *name == port);
        if body == "ground" {
            return (None, position(self.shape.ground).unwrap_or(usize::MAX));
        }
        let index = self.shape.bodies.iter().position(|(name, _)| *name == body).unwrap_or(usize::MAX);
        (Some(index), position(self.shape.bodies[index].1).unwrap_or(usize::MAX))
    }

    /// The numbers of a frame.
    pub fn port(&self, (body, port): Frame) -> Port {
        body.map_or_else(|| self.ground[port], |body| self.bodies[body].ports[port])
    }

    /// Mutable numbers of a frame.
    pub fn port_mut(&mut self, (body, port): Frame) -> &mut Port {
        match body {
            None => &mut self.ground[port],
            Some(body) => &mut self.bodies[body].ports[port],
        }
    }

    /// Puts a port to a place along x, m, and what rounding has left out of it.
    pub fn set_along(&mut self, frame: Frame, [place, rest]: [f64; 2]) {
        self.port_mut(frame)[0] = place;
        self.rests.push((frame, rest));
    }

    /// Remainder of a port's place along x that rounding has left out, m; 0 if none is known.
    pub fn rest(&self, frame: Frame) -> f64 {
        self.rests.iter().find(|(of, _)| *of == frame).map_or(0.0, |(_, rest)| *rest)
    }

    /// All numbers in the order of the declaration's parameters.
    pub fn numbers(&self) -> Vec<f64> {
        let mut all = vec![self.gravity];
        let load = self.load;
        all.extend([load.push, load.begin, load.rise, load.turn, load.fall]);
        all.extend(self.ground.iter().flatten());
        for body in &self.bodies {
            all.extend([body.mass, body.inertia]);
            all.extend(body.ports.iter().flatten());
        }
        for joint in &self.joints {
            all.extend([joint.stiffness, joint.damping, joint.rest]);
        }
        all
    }
}
