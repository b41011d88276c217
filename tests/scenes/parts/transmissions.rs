//! Transmissions and drives.

scene! {
    pub Belts {
        param pull: N*m = 60 N*m;
        ground { port a: (0, 0) m; port b: (0.5, 0) m; port c: (0, 1) m; port d: (0.6, 1) m; }
        body first { mass: 1 kg; inertia: 0.02 kg*m^2; port hub: (0, 0) m; }
        body second { mass: 2 kg; inertia: 0.05 kg*m^2; port hub: (0, 0) m; start x: 0.5 m; }
        revolute one(ground.a, first.hub) { drive: pull*t/(1 s); }
        revolute two(ground.b, second.hub);
        belt drive(ground.a, first.hub, second.hub) { radius_a: 50 mm; radius_b: 100 mm; preload: 200 N; friction: 0.3; }

        body third { mass: 1 kg; inertia: 0.02 kg*m^2; port hub: (0, 0) m; start y: 1 m; start omega: 1 rad/s, locked; }
        body fourth { mass: 2 kg; inertia: 0.05 kg*m^2; port hub: (0, 0) m; start x: 0.6 m; start y: 1 m; start omega: -0.2 rad/s, locked; }
        revolute three(ground.c, third.hub);
        revolute four(ground.d, fourth.hub);
        elastic_belt rubber(ground.c, third.hub, fourth.hub) {
            radius_a: 50 mm; radius_b: 100 mm; distance: 0.6 m; preload: 100 N; stiffness: 2e4 N/m;
        }

        output drive.force, drive.slip, drive.wrap, drive.lost, drive.tension_left, drive.tension_right, drive.torque_a, drive.torque_b;
        output one.force, two.force, three.force, first.omega, second.omega, third.omega, fourth.omega;
        output rubber.tension_left, rubber.tension_right, rubber.energy, rubber.lost, rubber.torque_a, rubber.torque_b;
    }
}

scene! {
    pub Chains {
        ground { port e: (0, 2) m; port f: (0.5, 2) m; port g: (0, 3) m; port h: (0.5, 3) m; }
        body fifth { mass: 1 kg; inertia: 0.02 kg*m^2; port hub: (0, 0) m; start y: 2 m; }
        body sixth { mass: 2 kg; inertia: 0.05 kg*m^2; port hub: (0, 0) m; start x: 0.5 m; start y: 2 m; }
        revolute five(ground.e, fifth.hub) { drive: 3 N*m; }
        revolute six(ground.f, sixth.hub);
        chain tied(ground.e, fifth.hub, sixth.hub) { pitch: 12.7 mm; teeth_a: 17; teeth_b: 34; }

        body seventh { mass: 1 kg; inertia: 0.02 kg*m^2; port hub: (0, 0) m; start y: 3 m; }
        body eighth { mass: 2 kg; inertia: 0.05 kg*m^2; port hub: (0, 0) m; start x: 0.5 m; start y: 3 m; }
        revolute seven(ground.g, seventh.hub) { drive: 3 N*m; }
        revolute eight(ground.h, eighth.hub);
        chain loose(ground.g, seventh.hub, eighth.hub) { radius_a: 50 mm; radius_b: 100 mm; slack: 2 mm; distance: 0.5 m; }

        elastic_rope strand() { length: 0.6 m; stiffness: 1e4 N/m; }
        slider_ground span() { position: 0.6 m; }
        strand_of_length straight(strand.end, span.slider);
        sliding_mass idler() { mass: 0.2 kg; start: 0.1 m; drive: 60 N; y: -1 m; }
        slider_ground base();
        slider_spring damper(base.slider, idler.slider) { damping: 100 N/(m/s); }
        belt_tensioner push(strand.end, idler.slider) { span: 0.6 m; place: 0.2 m; }

        part strand_of_length(rope: cable, a: slider) { way on rope: a.position; }

        output tied.force, tied.torque_a, fifth.omega, sixth.omega;
        output loose.force, loose.tension_left, loose.tension_right, seven.force, seventh.omega, eighth.omega;
        output push.force, push.tension, idler.position, strand.elongation;
    }
}

scene! {
    pub Ropes {
        param counter: kg = 1 kg;
        param heavy: kg = 3 kg;
        param hoisting: N*m = 30 N*m;
        gravity: 9.81 m/s^2;
        ground {
            port line[0]: (0, 0) m, axis: 90 deg; port line[1]: (0.2, 0) m, axis: 90 deg; port line[2]: (5, 0) m, axis: 90 deg;
            port line[3]: (6, 0) m, axis: 90 deg; port line[4]: (7, 0) m, axis: 90 deg; port line[5]: (8, 0) m, axis: 90 deg;
            port top: (-0.05, 3) m; port top2: (0.05, 3) m; port pulley: (0.2, 3) m; port bridge: (5, 3) m;
            port post: (6, 3) m; port post2: (7, 3) m; port crane: (8, 3) m;
        }
        // Two falls to a block, and a third to a weight.
        body block { mass: 4 kg; inertia: 1 kg*m^2; port line: (0, 0) m, angle: 90 deg; port left: (-0.05, 0) m; port right: (0.05, 0) m; start y: 1 m, locked; start vy: 0 m/s, locked; }
        body weight { mass: counter; inertia: 1 kg*m^2; port line: (0, 0) m, angle: 90 deg; start x: 0.2 m; start y: 1 m, locked; }
        prismatic guide[0](ground.line[0], block.line);
        prismatic guide[1](ground.line[1], weight.line);
        rope tackle() { length: 6 m; }
        fall first(tackle.end, ground.top, block.left);
        fall second(tackle.end, ground.top2, block.right);
        fall third(tackle.end, ground.pulley, weight.line);

        body jumper { mass: 70 kg; inertia: 1 kg*m^2; port line: (0, 0) m, angle: 90 deg; start x: 5 m; start y: 2.5 m, locked; }
        prismatic guide[2](ground.line[2], jumper.line);
        elastic_rope bungee() { length: 10 m; stiffness: 100 N/m; }
        fall leap(bungee.end, ground.bridge, jumper.line);

        body load { mass: heavy; inertia: 1 kg*m^2; port line: (0, 0) m, angle: 90 deg; start x: 6 m; start y: 2 m, locked; }
        body light { mass: 1 kg; inertia: 1 kg*m^2; port line: (0, 0) m, angle: 90 deg; start x: 7 m; start y: 2 m, locked; }
        prismatic guide[3](ground.line[3], load.line);
        prismatic guide[4](ground.line[4], light.line);
        shaft_ground bollard();
        capstan turns(bollard.shaft) { length: 2 m; radius: 5 cm; wrap: 270 deg; friction: 0.25; }
        fall down(turns.near, ground.post, load.line);
        fall up(turns.far, ground.post2, light.line);

        rotor drum() { inertia: 0.5 kg*m^2; drive: hoisting; }
        body crate { mass: 10 kg; inertia: 1 kg*m^2; port line: (0, 0) m, angle: 90 deg; start x: 8 m; start y: 1 m, locked; }
        prismatic guide[5](ground.line[5], crate.line);
        rope hoist() { length: 2 m; }
        fall hang(hoist.end, ground.crane, crate.line);
        winch lift(hoist.end, drum.shaft) { radius: 0.1 m; }

        output tackle.tension, tackle.slack, block.y, block.vy, weight.vy, bungee.tension, bungee.elongation, jumper.vy;
        output turns.tension_near, turns.tension_far, turns.lost, turns.speed, turns.torque, load.y, load.vy;
        output lift.speed, hoist.tension, drum.speed, crate.vy, bungee.energy, bungee.lost, first.length;
    }
}

scene! {
    /// A pinion and a wheel, a rack, and an arm with a planet between a sun and a ring.
    pub Meshes {
        ground {
            port o: (0, 0) m; port w: (0.2, 0) m; port p: (1, 0.05) m; port rail: (1, 0) m;
            port sun: (2, 0) m; port arm: (2, 0) m; port ring: (2, 0) m;
        }
        body pinion { mass: 1 kg; inertia: 0.01 kg*m^2; port hub: (0, 0) m; }
        body wheel { mass: 3 kg; inertia: 0.27 kg*m^2; port hub: (0, 0) m; start x: 0.2 m; }
        revolute first(ground.o, pinion.hub) { drive: 2 N*m; }
        revolute second(ground.w, wheel.hub);
        gear mesh(ground.o, pinion.hub, wheel.hub) { module: 5 mm; teeth_a: 20; teeth_b: 60; }

        body roller { mass: 1 kg; inertia: 0.01 kg*m^2; port hub: (0, 0) m; start x: 1 m; start y: 0.05 m; }
        body bar { mass: 2 kg; inertia: 0.1 kg*m^2; port line: (0, 0) m; start x: 1 m; }
        revolute hub(ground.p, roller.hub) { drive: 3 N*m; }
        prismatic guide(ground.rail, bar.line);
        rack teeth(roller.hub, bar.line) { radius: 50 mm; }

        body sun { mass: 1 kg; inertia: 0.01 kg*m^2; port hub: (0, 0) m; start x: 2 m; start omega: 7 rad/s, locked; }
        body arm { mass: 1 kg; inertia: 0.01 kg*m^2; port hub: (0, 0) m; port tip: (0.15, 0) m; start x: 2 m; start omega: 3 rad/s, locked; }
        body planet { mass: 1 kg; inertia: 0.01 kg*m^2; port hub: (0, 0) m; start x: 2.15 m; }
        body ring { mass: 1 kg; inertia: 0.5 kg*m^2; port hub: (0, 0) m; start x: 2 m; }
        revolute at_sun(ground.sun, sun.hub);
        revolute at_arm(ground.arm, arm.hub);
        revolute at_planet(arm.tip, planet.hub);
        revolute at_ring(ground.ring, ring.hub);
        gear inner(arm.hub, sun.hub, planet.hub) { radius_a: 100 mm; radius_b: 50 mm; }
        gear outer(arm.tip, planet.hub, ring.hub) { radius_a: 50 mm; radius_b: -200 mm; }
        output first.force, second.force, mesh.torque_a, mesh.torque_b, mesh.tooth_force, mesh.radial_force;
        output hub.force, guide.force, teeth.force, teeth.torque, bar.vx, roller.omega, wheel.omega;
    }
}

scene! {
    /// Two wheels that rattle, and two that are driven, with play and losses.
    pub Play {
        param e: 1 = 0.8;
        param efficiency: 1 = 0.95;
        param apart: m = 0.15 m;
        ground { port a: (0, 0) m; port b: (0.15, 0) m; port c: (0, 1) m; port d: (apart, 1 m); }
        body one { mass: 1 kg; inertia: 0.01 kg*m^2; port hub: (0, 0) m; start omega: 2 rad/s, locked; }
        body two { mass: 1 kg; inertia: 0.03 kg*m^2; port hub: (0, 0) m; start x: 0.15 m; start omega: 0 rad/s, locked; }
        revolute at_one(ground.a, one.hub);
        revolute at_two(ground.b, two.hub);
        gear loose(ground.a, one.hub, two.hub) { radius_a: 50 mm; radius_b: 100 mm; backlash: 1 mm; restitution: e; }
        body three { mass: 1 kg; inertia: 0.01 kg*m^2; port hub: (0, 0) m; start y: 1 m; start omega: 0 rad/s, locked; }
        body four { mass: 1 kg; inertia: 0.03 kg*m^2; port hub: (0, 0) m; start x: apart; start y: 1 m; start omega: 0 rad/s, locked; }
        revolute at_three(ground.c, three.hub) { drive: 4 N*m; }
        revolute at_four(ground.d, four.hub) { damping: 0.5 N*m*s; }
        gear driven(ground.c, three.hub, four.hub) { radius_a: 50 mm; radius_b: 100 mm; backlash: 1 mm; efficiency: efficiency; }
        output loose.play_taken, loose.tooth_force, driven.play_taken, driven.tooth_force, driven.torque_a, driven.torque_b, driven.lost;
        output driven.radial_force, at_three.force;
    }
}

scene! {
    pub Shafts {
        param motor: N*m = 2 N*m;
        rotor sun() { inertia: 0.01 kg*m^2; drive: motor; }
        rotor ring() { inertia: 0.1 kg*m^2; }
        rotor carrier() { inertia: 0.2 kg*m^2; }
        planetary set(sun.shaft, ring.shaft, carrier.shaft) { teeth_sun: 20; teeth_ring: 60; }
        rotor fast() { drive: motor; }
        rotor slow() { inertia: 2 kg*m^2; }
        gearbox reducer(fast.shaft, slow.shaft) { ratio: 10; efficiency: 0.9; }
        output set.torque_sun, set.torque_ring, set.torque_carrier, sun.speed, ring.speed, carrier.speed;
        output reducer.torque_a, reducer.torque_b, reducer.lost, fast.speed, slow.speed;
    }
}

scene! {
    pub Screws {
        param mu: 1 = 0.05;
        param spin: N*m = 2 N*m;
        param load: N*m = 0;
        param turn: N*m = 100 N*m;
        rotor spindle() { inertia: 0.02 kg*m^2; drive: spin; }
        rotor wheel() { inertia: 0.3 kg*m^2; drive: load; }
        worm drive(spindle.shaft, wheel.shaft) { worm_radius: 20 mm; wheel_radius: 100 mm; lead_angle: 5 deg; friction: mu; }
        rotor screw() { drive: turn; }
        sliding_mass nut() { mass: 3 kg; drive: -6.4 kN; }
        lead_screw thread(screw.shaft, nut.slider) {
            lead: 8 mm; diameter: 30 mm; friction: 0.08; collar_friction: 0.08; collar_diameter: 40 mm;
        }
        output drive.torque_a, drive.torque_b, drive.lost, drive.normal_force, spindle.speed, wheel.speed, wheel.angle;
        output thread.torque, thread.force, thread.lost, nut.position, nut.speed, screw.speed;
    }
}

scene! {
    pub Motors {
        gravity: 9.81 m/s^2;
        // A motion that is handed over: value, rate and acceleration at a time.
        param at: s = 0;
        param place: rad = 0;
        param speed: rad/s = 0;
        param gain: rad/s^2 = 0;
        rotor six() { inertia: 1e-3 kg*m^2; }
        dc_motor motor(six.shaft) { voltage: 12 volt; resistance: 0.5 ohm; inductance: 2e-2 henry; constant: 0.05 N*m/ampere; }
        rotor seven() { inertia: 0.01 kg*m^2; }
        motor_curve curve(seven.shaft) { stall_torque: 2 N*m; free_speed: 300 rad/s; command: 0.5; }
        rotor eight() { inertia: 0.02 kg*m^2; }
        servo position(eight.shaft) {
            target: 2 rad; position_gain: 20 Hz; speed_gain: 1 N*m/(rad/s); speed_limit: 1 rad/s; torque_limit: 0.1 N*m;
        }
        rotor nine() { inertia: 0.03 kg*m^2; }
        motion told(nine.shaft) { value: place + speed*(t - at) + gain*(t - at)^2/2; }
        rotor ten() { inertia: 0.03 kg*m^2; }
        motion planned(ten.shaft) { value: smooth_table(t, (0 s, 0 rad), (1 s, 2 rad)); }
        output motor.current, motor.back_emf, motor.energy, motor.input_power, motor.power, motor.lost, six.speed;
        output curve.power, curve.torque, seven.speed, position.torque, position.error, eight.speed, eight.angle;
        output told.torque, told.power, nine.angle, nine.speed, planned.torque, ten.speed;
    }
}

scene! {
    /// A gas spring, a counterweight, a cubic spring.
    pub Springs {
        gravity: 9.81 m/s^2;
        param index: 1 = 1.4;
        ground { port o: (0, 0) m, axis: 0 deg; port base: (0, 0) m; port pivot: (5, 0) m; }
        body lid { mass: 5 kg; inertia: 1 kg*m^2; port foot: (0, 0) m; start x: 0.3 m, locked; }
        prismatic guide(ground.o, lid.foot);
        gas_spring strut(ground.base, lid.foot) {
            extended_length: 0.5 m; rod_diameter: 10 mm; volume: 30 cm^3; pressure: 60 bar; polytropic_index: index;
        }
        body arm { mass: 2 kg; inertia: 0.1 kg*m^2; port pivot: (-0.4, 0) m; port tail: (-0.6, 0) m; start x: 5.4 m; }
        revolute pivot(ground.pivot, arm.pivot);
        counterweight balance(arm.tail) { balances: 2 kg*0.4 m; arm: 0.2 m; radius: 5 cm; }
        body cart { mass: 2 kg; inertia: 1 kg*m^2; port foot: (0, 0) m; start x: 0.2 m; start y: 2 m; }
        ground { port low: (0, 2) m, axis: 0 deg; }
        prismatic line(ground.low, cart.foot);
        spring hard(ground.low, cart.foot) { free_length: 0.1 m; characteristic: 1e4 N/m^3*hard.displacement^3; }
        output strut.force, strut.gas_pressure, strut.gas_volume, lid.x, lid.vx, balance.mass, pivot.force, arm.alpha, cart.x, cart.vx;
    }
}

scene! {
    pub Clutches {
        param pull: N*m = 2 N*m;
        rotor one() { start_speed: 100 rad/s; inertia: 0.2 kg*m^2; }
        rotor two() { start_speed: 20 rad/s; inertia: 0.3 kg*m^2; }
        clutch coupling(one.shaft, two.shaft) { force: 1 kN; radius: 5 cm; friction: 0.3; static_ratio: 1.2; }
        state heat: J = 0;
        rate heat = coupling.lost;
        rotor three() { inertia: 0.1 kg*m^2; drive: if t < 1 s then pull else if t < 2 s then -pull else pull; }
        rotor four() { inertia: 0.3 kg*m^2; }
        freewheel hub(three.shaft, four.shaft) { capacity: 100 N*m; }
        ground { port bed: (0, 0) m; }
        body driver { mass: 1 kg; inertia: 0.2 kg*m^2; port hub: (0, 0) m; start omega: 20 rad/s; }
        body driven { mass: 1 kg; inertia: 0.3 kg*m^2; port hub: (0, 0) m; start omega: 20 rad/s; }
        revolute front(ground.bed, driver.hub) { drive: if t < 1 s then 0 else if t < 2 s then 100 N*m/s*(t - 1 s) else 0; }
        revolute rear(ground.bed, driven.hub);
        torque_limiter limiter(driver.hub, driven.hub) { capacity: 30 N*m; static_ratio: 1.5; }
        when t > 0.1 s { driver.omega = 100 rad/s; }
        state slip_heat: J = 0;
        rate slip_heat = limiter.lost;
        output one.speed, two.speed, coupling.speed, coupling.locked, coupling.torque, heat;
        output three.speed, four.speed, hub.torque, hub.locked;
        output driver.omega, driven.omega, limiter.slip, limiter.torque, limiter.lost, limiter.locked, slip_heat;
    }
}

scene! {
    pub Brakes {
        rotor five() { start_speed: 20 rad/s; inertia: 10 kg*m^2; }
        drum_brake drum(five.shaft) {
            force: 2.28 kN; radius: 150 mm; pivot_radius: 122.7 mm; arm: 212 mm; end: 126 deg; friction: 0.32;
        }
        rotor six() { start_speed: 20 rad/s; inertia: 10 kg*m^2; }
        drum_brake pair(six.shaft) {
            force: 2.28 kN; radius: 150 mm; pivot_radius: 122.7 mm; arm: 212 mm; end: 126 deg; friction: 0.32;
            shoes: two_leading;
        }
        rotor seven() { start_speed: 10 rad/s; inertia: 1 kg*m^2; drive: 1 N*m*(t/1 s); }
        brake stop(seven.shaft) { capacity: 10 N*m; static_ratio: 1.5; }
        output drum.torque, drum.leading_torque, drum.trailing_torque, drum.lost, pair.torque, seven.speed, stop.torque, stop.lost;
    }
}
