//! Latches, ratchets, locks, stops and frictions.

scene! {
    /// A latch, a ratchet and two locks, side by side.
    pub Catches {
        input release = 0;
        input lifted = 0;
        input torque: N*m = 2 N*m;
        ground { port bolt: (0, 0) m; port spring: (-1, 0) m; port axle: (0, 2) m; port shaft: (0, 4) m; port hole: (0, 6) m; }
        body drawer { mass: 2 kg; inertia: 1 kg*m^2; port p: (0, 0) m; start vx: 1 m/s, locked; }
        prismatic rail(ground.bolt, drawer.p) { drive: -8 N; }
        latch bolt(ground.bolt, drawer.p) { position: 0.05 m; release: release; strength: 20 N; }
        force pull(drawer.p) { x: if t > 2 s then -10 N/s*(t - 2 s) else 0 N; }

        body wheel { mass: 2 kg; inertia: 0.5 kg*m^2; port hub: (0, 0) m; start y: 2 m; start omega: 0 rad/s, locked; }
        revolute axle(ground.axle, wheel.hub) { drive: torque; }
        ratchet pawl(ground.axle, wheel.hub) { teeth: 12; lifted: lifted; }

        discrete grips = 0;
        when t > 1 s { grips = 1; }
        body rotor { mass: 2 kg; inertia: 0.5 kg*m^2; port hub: (0, 0) m; start y: 4 m; start omega: 3 rad/s, locked; }
        revolute shaft(ground.shaft, rotor.hub) { drive: if t > 3 s then 3 N*m/s*(t - 3 s) else 0 N*m; }
        lock brake(ground.shaft, rotor.hub) { closed: grips; strength: 6 N*m; }

        discrete pinned = 0;
        body arm { mass: 2 kg; inertia: 0.5 kg*m^2; port hub: (0, 0) m; start y: 6 m; start omega: 1 rad/s, locked; }
        revolute hinge(ground.hole, arm.hub);
        lock pin(ground.hole, arm.hub) { closed: pinned; angle: 60 deg; }
        when arm.angle > 60 deg and t < 2 s { pinned = 1; }
        when t > 3 s { pinned = 0; }
        force push(arm.hub) { torque: if t > 2 s then 5 N*m else 0 N*m; }

        output bolt.catches, bolt.force, pawl.torque, brake.torque, brake.locked, pin.torque;
        output sticks = if is_sticking(brake.grip) then 1 else 0;
    }
}

scene! {
    /// Joints with limits, side by side.
    pub Limits {
        param loss: N*m*s = 8 N*m*s;
        gravity: 9.81 m/s^2;
        ground {
            port o: (0, 0) m;
            port axle: (5, 0) m;
            port slope: (10, 0) m, axis: -20 deg;
            port slot: (15, 0) m, axis: 90 deg;
            port cap: (20, 0) m;
        }
        body bob { mass: 2 kg; inertia: 0.5 kg*m^2; port o: (0, 1) m; start angle: -70 deg, locked; }
        revolute hinge(ground.o, bob.o) { upper_limit: 0 deg; restitution: 0.8; }

        body disc { mass: 3 kg; inertia: 0.5 kg*m^2; port hub: (0, 0) m; start x: 5 m; start omega: -4 rad/s, locked; }
        revolute axle(ground.axle, disc.hub) {
            lower_limit: -1 rad; upper_limit: 1 rad;
            limit_stiffness: 5e3 N*m/rad; limit_damping: loss;
        }

        body sled { mass: 2 kg; inertia: 0.1 kg*m^2; port p: (0, 0) m; start x: 10 m; start angle: -20 deg; }
        prismatic slope(ground.slope, sled.p) { upper_limit: 0.5 m; restitution: 0.5; }

        body block { mass: 2 kg; inertia: 0.1 kg*m^2; port p: (0, 0) m; start x: 15 m; start angle: 0 deg, locked; }
        pin_slot slot(ground.slot, block.p) { lower_limit: -0.5 m; limit_stiffness: 1e4 N/m; }

        body rod { mass: 4 kg; inertia: 0.1 kg*m^2; port p: (0, 0) m; start x: 20.5 m; }
        constraint level: rod.y = 0;
        constraint upright: rod.angle = 0;
        jack ram(ground.cap, rod.p) { free_length: 0.4 m; upper_limit: 0.3 m; drive: 40 N; seal_friction: 10 N; }

        output hinge.upper_limit_torque, axle.upper_limit_torque, axle.lower_limit_torque, slope.upper_limit_force,
            slot.lower_limit_force, slot.force, ram.upper_limit_force, ram.friction_force, ram.lost;
    }
}

scene! {
    /// Joints with friction, side by side.
    pub Frictions {
        param slope_friction = 0.3;
        param stribeck: rad/s = 0.5 rad/s;
        gravity: 9.81 m/s^2;
        ground {
            port axle: (5, 0) m;
            port slope: (10, 0) m, axis: -20 deg;
            port slot: (15, 0) m;
            port eye: (25, 0) m;
            port drawer: (30, 0) m;
        }
        body disc { mass: 3 kg; inertia: 0.02 kg*m^2; port hub: (0, 0) m; start x: 5 m; start omega: 4 rad/s, locked; }
        revolute axle(ground.axle, disc.hub) {
            friction: 0.2; static_friction: 0.5; stribeck_speed: stribeck; pin_diameter: 40 mm;
            seal_friction: 0.03 N*m; static_seal_friction: 0.05 N*m; damping: 0.01 N*m*s;
        }
        body sled { mass: 2 kg; inertia: 0.1 kg*m^2; port p: (0, 0) m; start x: 10 m; start angle: -20 deg; }
        prismatic slope(ground.slope, sled.p) {
            friction: slope_friction; static_friction: slope_friction + 0.07;
            drive: if t < 1 s then 0 else 5 N;
        }
        body block { mass: 2 kg; inertia: 0.1 kg*m^2; port p: (0, 0) m; start x: 15 m; start vx: 3 m/s, locked; start omega: 2 rad/s, locked; }
        pin_slot slot(ground.slot, block.p) { friction: 0.25; }
        body drawer { mass: 2 kg; inertia: 0.1 kg*m^2; port p: (-0.3, 0) m; start x: 30.3 m; start vx: 3 m/s, locked; }
        prismatic case(ground.drawer, drawer.p) { friction: 0.25; guide_length: 0.4 m; }

        discrete holds = 1;
        when t > 0.2 s { holds = 0; }
        body wheel { mass: 3 kg; inertia: 0.02 kg*m^2; port hub: (0, 0) m; start x: 25 m; start omega: 4 rad/s, locked; }
        revolute eye(ground.eye, wheel.hub) { friction: 0.2; pin_diameter: 40 mm; upper_limit: 1 rad; when: holds > 0.5; }
        output axle.friction_torque, axle.lost, slope.friction_force, slot.friction_force, case.friction_force;
    }
}

scene! {
    /// Journals in bushes, a ball between stops, and two bodies on a bushing, without gravity.
    pub Loose {
        param e = 0.9;
        ground { port o: (0, 0) m; port p: (1, 0) m; port wall: (2, 0) m, axis: 30 deg; }
        body rigid { mass: 2 kg; inertia: 0.004 kg*m^2; port pin: (0, 0) m; start vx: 0.3 m/s; start vy: 0.4 m/s; start omega: 0 rad/s, locked; }
        clearance bush(ground.o, rigid.pin) { clearance: 1 mm; restitution: e; friction: 0.2; radius: 20 mm; }

        body soft { mass: 2 kg; inertia: 0.004 kg*m^2; port pin: (0, 0) m; start x: 1 m; start vx: 0.3 m/s; start vy: 0.4 m/s; }
        clearance shell(ground.p, soft.pin) { clearance: 1 mm; contact: compliant; restitution: e; radius: 20 mm; }

        body ball { mass: 1 kg; inertia: 0.1 kg*m^2; port p: (0, 0) m; start x: 2 m + 1 m*cos(30 deg); start y: 1 m*sin(30 deg); start vx: -2 m/s*cos(30 deg); start vy: -2 m/s*sin(30 deg); }
        stop wall(ground.wall, ball.p) { distance: 0.2 m; restitution: 0.5; }

        body one { mass: 1 kg; inertia: 0.1 kg*m^2; port p: (0.1, 0.05) m, angle: 20 deg; start y: 5 m; start omega: 2 rad/s; }
        body two { mass: 2 kg; inertia: 0.3 kg*m^2; port p: (-0.2, 0.1) m; start x: 0.4 m; start y: 5 m; start vx: 0.3 m/s; }
        bushing mount(one.p, two.p) {
            stiffness_x: 500 N/m; stiffness_y: 200 N/m; stiffness_angle: 20 N*m/rad;
            stiffness_xy: 50 N/m; stiffness_x_angle: 10 N/rad; stiffness_y_angle: -8 N/rad;
            damping_x: 3 N*s/m; damping_y: 2 N*s/m; damping_angle: 0.1 N*m*s/rad; damping_xy: 0.5 N*s/m;
            free_x: 0.05 m; free_y: -0.02 m; rest: 5 deg;
        }
        stop buffer(one.p, two.p) { distance: 0.1 m; stiffness: 2000 N/m; damping: 5 N*s/m; }
        state lost: J = 0;
        rate lost = mount.lost + buffer.lost;
        output bush.force, shell.force, shell.penetration, wall.gap, mount.energy, mount.force, buffer.gap, lost;
        allow(W0002);
    }
}

scene! {
    /// A carriage that is driven, one that is pushed, and a disc that is turned.
    pub Bristles {
        param speed: m/s = 1e-4 m/s;
        param stribeck: m/s = 1e-3 m/s;
        param sticking: N = 1.5 N;
        param damping: N*s/m = 0 N*s/m;
        param viscous: N*s/m = 0.4 N*s/m;
        ground { port o: (0, 0) m; port p: (0, 1) m; port axle: (0, 2) m; }
        body driven { mass: 1 kg; inertia: 1 kg*m^2; port p: (0, 0) m; }
        prismatic first(ground.o, driven.p);
        constraint motor: driven.x = speed*t;
        bristle_friction pad(ground.o, driven.p) {
            friction: 1 N; static_friction: sticking; stribeck_speed: stribeck;
            stiffness: 1e5 N/m; damping: damping; viscous: viscous;
        }
        body pushed { mass: 1 kg; inertia: 1 kg*m^2; port p: (0, 0) m; start y: 1 m; }
        prismatic second(ground.p, pushed.p) { drive: 1 N/s*t; }
        bristle_friction brake(ground.p, pushed.p) {
            friction: 1 N; static_friction: 1.5 N; stiffness: 1e5 N/m; damping: 316.227766016838 N*s/m; viscous: 0.4 N*s/m;
        }
        body disc { mass: 1 kg; inertia: 2 kg*m^2; port hub: (0, 0) m; start y: 2 m; start omega: 1 rad/s, locked; }
        revolute axle(ground.axle, disc.hub);
        bristle_friction bearing(ground.axle, disc.hub) { motion: rotation; friction: 3 N*m; stiffness: 1e3 N*m/rad; }
        output pad.force, brake.force, bearing.torque, bearing.lost;
    }
}

scene! {
    pub Jumps {
        allow(W0002);
        ground { port o: (0, 0) m; port p: (3, 0) m; }
        // A wheel that turns by 3 rad/s, from an integer on.
        body wheel { mass: 1 kg; inertia: 1 kg*m^2; port o: (0, 0) m; start angle: 3 rad, locked; start omega: 3 rad/s, locked; }
        revolute axle(ground.o, wheel.o);
        let angle = wheel.angle/(1 rad);
        output tooth = floor(angle), back = floor(-angle), place = mod(wheel.angle, 2 rad);

        state stairs: s = 0;
        rate stairs = floor(t/(1 s));
        state saw: s = 0;
        rate saw = mod(angle, 2);
        state downstairs: s = 0;
        rate downstairs = floor(-0.7*angle);
        output stairs, saw, downstairs;

        // Full power towards the middle: arcs of parabolas.
        state x: 1 = 1;
        state speed: 1/s = 0;
        rate x = speed;
        rate speed = -sign(x)/(1 s)^2;
        output x, speed;

        // A periodic prescribed motion.
        body arm { port o: (0, 0) m; }
        revolute elbow(ground.p, arm.o);
        constraint drive: arm.angle = smooth_table(mod(t, 2 s), (0 s, 0 deg), (1 s, 40 deg), (2 s, 0 deg));
        output arm.angle, arm.omega;

        input u: 1 = 0;
        input v: 1 = 0;
        let cell = table(u,
            (0, table(v, (0, 1), (2, 3), (5, 0))),
            (10, table(v, (0, 2), (2, -1), (5, 4))),
            (30, table(v, (0, 5), (2, 5), (5, 6))));
        output cell, level = floor(u), rest = mod(u, v + 3);
    }
}

scene! {
    pub Slide {
        sliding_mass block() { mass: 1 kg; start_speed: 1 m/s; }
        slider_ground floor();
        slider_spring pull(floor.slider, block.slider) { preload: 1 N; }
        part dry(a: slider) { force on a: -3 N*sign(rate(a.position)); }
        dry rub(block.slider);
        output block.speed;
    }
}

scene! {
    pub Plates {
        allow(W0002);
        param width: m = 200 mm;
        param density: kg/m^3 = 7850 kg/m^3;
        // At the centre of gravity.
        part push(a: body) {
            force on a: (1 N, 0 N);
            torque on a: 1 N*m;
        }
        // A polygon of 48 corners, radius 30 mm, about (20, -10) mm.
        body disc { density: density; thickness: 5 mm; contour: "tests/contours/disc.csv"; start x: 0, locked; start y: 0, locked; }
        // A rectangle, drawn clockwise, with that as a hole.
        body plate {
            density: density;
            thickness: 5 mm;
            contour: (-100, -50) mm, (-100, 50) mm, (width - 0.1 m, 50 mm), (width - 0.1 m, -50 mm);
            hole: "tests/contours/disc.csv";
            hole: (-80, 10), (-60, 10), (-60, 40), (-80, 40) mm;
            port corner: (100, 50) mm;
            start x: 0, locked;
            start y: 0, locked;
        }
        // Drawn far away, in absolute axes.
        body drawn {
            coordinates: absolute;
            density: 1000 kg/m^3;
            thickness: 1 cm;
            contour: (1000, 2000), (1003, 2000), (1000, 2006) m;
        }
        push one(disc);
        push two(plate);
        push three(drawn);
        output disc.ax, disc.alpha, disc.position, plate.ax, plate.alpha, plate.position, plate.corner.position;
        output drawn.ax, drawn.alpha, drawn.position;
    }
}
