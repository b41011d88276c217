//! Bodies that rest on rows of contact, for equilibria.

/// Declares the same mechanism in the formulation that the compiler takes, and in absolute coordinates.
macro_rules! in_both_formulations {
    ($module:ident { $($item:tt)* }) => {
        pub(crate) mod $module {
            pub(crate) mod least {
                scene! { pub Scene { $($item)* } }
            }
            pub(crate) mod absolute {
                scene! { pub Scene { formulation: absolute; $($item)* } }
            }
        }
    };
}

in_both_formulations!(wheel {
    gravity: 9.81 m/s^2;
    param mu: 1 = 0.5;
    input pull: N = 0 N;
    ground { port o: (0, 0) m; }
    body wheel { mass: 2 kg; inertia: 0.3 kg*m^2; port hub: (0, 0) m; start x: 0.1 m; start y: 0.5 m; }
    force spring(wheel.hub) { x: pull - (40 N/m)*wheel.x; }
    unilateral floor: wheel.y >= 0.5 m;
    friction grip: rate(wheel.x + (0.5 m)*wheel.angle) within mu*reaction(floor);
    output wheel.x, drag = reaction(grip);
});

scene! {
    /// A block above a slope.
    pub Slope {
        gravity: 9.81 m/s^2;
        param tilt: deg = 20 deg;
        param mu = 0.5;
        ground { port o: (0, 0) m; }
        body block { mass: 2 kg; inertia: 1 kg*m^2; port o: (0, 0) m; start y: 3 m; }
        constraint level: block.angle = 0;
        unilateral plane: cos(tilt)*block.y - sin(tilt)*block.x >= 0 m;
        friction slip: rate(cos(tilt)*block.x + sin(tilt)*block.y) within mu*reaction(plane);
    }
}

scene! {
    /// A ladder that leans on a smooth wall, on a rough floor.
    pub Ladder {
        gravity: 9.81 m/s^2;
        body ladder {
            mass: 3 kg; inertia: 1 kg*m^2; port top: (0, 1) m; port foot: (0, -1) m;
            start angle: 25 deg; start x: sin(25 deg)*(1 m); start y: cos(25 deg)*(1 m);
        }
        unilateral wall: ladder.top.x >= 0 m;
        unilateral floor: ladder.foot.y >= 0 m;
        friction slide: rate(ladder.foot.x) within 0.4*reaction(floor);
    }
}

scene! {
    /// An arm on a pin, which falls on a stop, and a table on two rough feet.
    pub Feet {
        gravity: 9.81 m/s^2;
        ground { port o: (0, 0) m; }
        body arm { mass: 2 kg; inertia: 0.1 kg*m^2; port o: (-0.5, 0) m; start angle: -10 deg; start x: 0.5 m; }
        revolute hinge(ground.o, arm.o);
        unilateral stop: arm.angle >= -30 deg;
        body table { mass: 4 kg; inertia: 1 kg*m^2; port left: (-0.6, -0.5) m; port right: (0.4, -0.5) m; start x: 3 m; start y: 0.5 m; }
        unilateral left: table.left.y >= 0 m;
        unilateral right: table.right.y >= 0 m;
        friction left_grip: rate(table.left.x) within 0.5*reaction(left);
        friction right_grip: rate(table.right.x) within 0.5*reaction(right);
    }
}
