//! Parts for mechanisms of other crates.

plm::parts! {
    pub thermal {
        /// Heat: temperatures, and heat flows that add up.
        domain heat {
            across temperature: K;
            through power: W;
        }
        /// A body of one temperature.
        part block() {
            param capacity: J/K;
            state temperature: K = 293 K;
            node port: heat = temperature;
            rate temperature = port.power/capacity;
            output temperature;
        }
        /// What heat flows through.
        part contact(a: heat, b: heat) {
            param conductance: W/K;
            power on b from a: conductance*(a.temperature - b.temperature);
        }
    }
}
