//! Oil, air and signals.

scene! {
    pub Circuit {
        allow(W0002);
        ground { port o: (0, 0) m; }
        oil_tank tank();

        shaft_velocity engine() { speed: 1500 rev/min; }
        chamber line() { dead_volume: 1 L; }
        pump feed(engine.shaft, tank.port, line.port) {
            displacement: 16 cm^3/rev;
            setting: 0.9;
            leakage: 1 L/min/(100 bar);
            friction: 0.02 N*m*s;
        }
        relief_valve relief(line.port, tank.port) { cracking: 150 bar; rise: 10 bar; rated_drop: 10 bar; }
        output line.pressure, feed.flow, feed.power, feed.lost, relief.flow, relief.opening;

        body drum { mass: 1 kg; inertia: 0.05 kg*m^2; port o: (0, 0) m; }
        revolute axle(ground.o, drum.o) { damping: 0.3 N*m*s; }
        oil_source supply() { pressure: 100 bar; }
        hydraulic_motor motor(supply.port, tank.port, axle.shaft) {
            displacement: 10 cm^3/rev;
            leakage: 2 L/min/(100 bar);
            friction: 0.1 N*m*s;
        }
        output motor.flow, motor.power, motor.lost, motor.torque;

        oil_source high() { pressure: 300 bar; }
        accumulator store() { volume: 1 L; charge: 50 bar; polytropic_index: 1.3; dead_volume: 200 cm^3; }
        flow_control fill(high.port, store.port) { setting: 60 L/min; }
        output store.pressure, store.gas_volume, store.oil_volume;

        oil_source pulse() { pressure: 20 bar*sin(pi*t*5 Hz)^2; }
        chamber vessel() { dead_volume: 0.5 L; }
        check_valve check(pulse.port, vessel.port) { cracking: 1 bar; }
        discrete openings: 1 = 0;
        discrete closings: 1 = 0;
        when check.opening > 0 { openings = openings + 1; }
        when check.opening <= 0 { closings = closings + 1; }
        output openings, closings, vessel.pressure, check.flow;
    }
}

scene! {
    pub Valves {
        allow(W0002);
        body anything { mass: 1 kg; inertia: 1 kg*m^2; }
        input drop: Pa = 0;
        input command: 1 = 0;
        oil_tank tank();
        oil_source a() { pressure: drop; }
        flow_control hold(a.port, tank.port) { setting: 5 L/min; }
        output hold.flow, hold.lost;

        oil_source pilot() { pressure: 40 bar; }
        oil_source back() { pressure: 5 bar; }
        counterbalance_valve holder(a.port, back.port, pilot.port) { cracking: 230 bar; back_ratio: 4; }
        output holder.flow, holder.opening;

        oil_source left() { pressure: 30 bar; }
        oil_source right() { pressure: 50 bar; }
        proportional_valve valve(a.port, left.port, right.port, tank.port) {
            signal: command;
            rated_signal: 10;
            dead_band: 0.04;
            overlap: 0.2;
            leakage: 0.001;
            frequency: 100 Hz;
        }
        output valve.flow_a, valve.flow_b, valve.opening;

        slider_velocity hand() { velocity: 5 mm/s; position: 0.1 m; }
        cylinder press(hand.slider) {
            piston_diameter: 40 mm;
            stroke: 0.3 m;
            friction: 200 N*s/m;
            dry_friction: 60 N;
            static_friction: 100 N;
            stribeck_speed: 10 mm/s;
            leakage: 0.1 L/min/(100 bar);
            chamber1.pressure: 20 bar;
            chamber1.oil.vapour_pressure: 2300 Pa;
        }
        output press.force, press.pressure1, press.pressure2, press.leak_flow, press.lost;
        output rate1 = rate(press.pressure1);
    }
}

scene! {
    pub Air {
        allow(W0002);
        input left: Pa = 1 bar;
        input right: Pa = 1 bar;
        air_source a() { pressure: left; }
        air_source b() { pressure: right; }
        air_orifice nozzle(a.port, b.port) { conductance: 2 L/s/bar; critical_ratio: 0.3; temperature: 340 K; opening: 0.5; }
        output nozzle.mass_flow, nozzle.normal_flow, nozzle.ratio;

        // A vessel blows into the atmosphere.
        air_source atmosphere();
        air_chamber vessel() { dead_volume: 0.1 L; pressure: 8 bar; }
        air_orifice outlet(vessel.port, atmosphere.port) { conductance: 1 L/s/bar; critical_ratio: 0.4; }
        state left_over: kg = 0 kg;
        rate left_over = -outlet.mass_flow;
        output vessel.pressure, left_over;

        // A piston compresses what does not leave.
        slider_velocity hand() { velocity: -0.2 m/s; position: 0.4 m; }
        air_chamber cap() { dead_volume: 20 cm^3; polytropic_index: 1.4; pressure: 2 bar; }
        air_piston ram(hand.slider, cap.port) { diameter: 50 mm; }
        output cap.pressure, cap.volume, ram.force;

        // A cylinder lifts a load to its upper stop.
        air_source supply() { pressure: 7 bar; }
        sliding_mass load() { mass: 20 kg; }
        slider_ground floor();
        slider_spring weight(floor.slider, load.slider) { preload: -196.2 N; }
        air_cylinder lift(load.slider) {
            piston_diameter: 40 mm;
            rod_diameter: 16 mm;
            stroke: 0.2 m;
            friction: 100 N*s/m;
            dry_friction: 15 N;
        }
        air_orifice inlet(supply.port, lift.port1) { conductance: 0.5 L/s/bar; }
        air_orifice exhaust(lift.port2, atmosphere.port) { conductance: 0.5 L/s/bar; }
        output lift.force, lift.pressure1, lift.pressure2, lift.volume1, lift.volume2, lift.stop_force, load.speed;
        output lift.displacement;
    }
}

scene! {
    pub Signals {
        allow(W0002);
        body anything { mass: 1 kg; inertia: 1 kg*m^2; }
        let wave = sin(2*pi*1 Hz*t);
        rate_limit climb() { signal: 1; rising: 2 Hz; time_constant: 0.1 s; }
        rate_limit fall() { signal: -1; rising: 2 Hz; falling: 4 Hz; time_constant: 0.05 s; value: 1; }
        saturation bounded() { signal: 2*wave; low: -0.5; high: 1; }
        hysteresis relay() { signal: wave; low: -0.5; high: 0.5; off: -2; on: 3; }
        state area: s = 0;
        rate area = relay.value;
        output climb.value, fall.value, bounded.value, relay.value, area;

        // A controller at 100 Hz holds a lag of 50 ms.
        state plant: 1 = 0;
        sampled_controller control() {
            error: 1 - plant;
            proportional: 2;
            integral: 20 Hz;
            derivative: 5 ms;
            period: 10 ms;
            low: 0;
            high: 1.05;
        }
        rate plant = (control.value - plant)/(50 ms);
        output plant, control.value;
    }
}

scene! {
    pub Delays {
        allow(W0002);
        body anything { mass: 1 kg; inertia: 1 kg*m^2; }
        let wave = sin(2*pi*1 Hz*t);
        delay late() { signal: t/(1 s); period: 20 ms; samples: 4; }
        delay one() { signal: wave; period: 28 ms; }
        output late.value, one.value;
    }
}

scene! {
    pub Hiss {
        allow(W0002);
        body anything { mass: 1 kg; inertia: 1 kg*m^2; }
        noise normal() { period: 1 ms; mean: 2; deviation: 0.5; }
        noise even() { period: 2 ms; distribution: uniform; }
        output normal.value, normal.seed, even_value = even.value, even.seed;
    }
}
