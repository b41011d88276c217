//! An arm, its controller, and both in one.

plm::mechanism! {
    /// An arm on a pin, turned by a torque.
    pub Arm {
        gravity: 9.81 m/s^2;
        input torque: N*m = 0;
        ground { port o: (0, 0) m; }
        body arm {
            mass: 4 kg;
            inertia: 0.12 kg*m^2;
            port pin: (-0.3, 0) m;
            start angle: -90 deg, locked;
            start omega: 0 rad/s, locked;
        }
        revolute hinge(ground.o, arm.pin) { damping: 0.2 N*m*s/rad; drive: torque; }
        output arm.angle, arm.omega;
    }
}

plm::mechanism! {
    /// A controller of an angle: proportional, integral, differential. The integral is a state; its case is all that it has of bodies.
    pub Controller {
        param target: rad = 30 deg;
        param stiffness: N*m/rad = 60 N*m/rad;
        param reset: s = 0.4 s;
        param damping: N*m*s/rad = 8 N*m*s/rad;
        input angle: rad = -90 deg;
        input omega: rad/s = 0;
        state sum: rad*s = 0;
        rate sum = target - angle;
        ground { port o: (0, 0) m; }
        body case { mass: 1 kg; inertia: 0.01 kg*m^2; port o: (0, 0) m; }
        weld foot(ground.o, case.o);
        output torque = stiffness*(target - angle + sum/reset) - damping*omega;
    }
}

plm::mechanism! {
    /// The arm with its controller.
    pub Whole {
        gravity: 9.81 m/s^2;
        param target: rad = 30 deg;
        param stiffness: N*m/rad = 60 N*m/rad;
        param reset: s = 0.4 s;
        param damping: N*m*s/rad = 8 N*m*s/rad;
        state sum: rad*s = 0;
        rate sum = target - arm.angle;
        ground { port o: (0, 0) m; }
        body arm {
            mass: 4 kg;
            inertia: 0.12 kg*m^2;
            port pin: (-0.3, 0) m;
            start angle: -90 deg, locked;
            start omega: 0 rad/s, locked;
        }
        revolute hinge(ground.o, arm.pin) {
            damping: 0.2 N*m*s/rad;
            drive: stiffness*(target - arm.angle + sum/reset) - damping*arm.omega;
        }
        output arm.angle, arm.omega, sum;
    }
}
