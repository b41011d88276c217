//! Rows of contact whose runs from text have the bits of compiled code.

scene! {
    pub Ball {
        gravity: 9.81 m/s^2;
        body ball { mass: 1 kg; inertia: 1 kg*m^2; start y: 1 m; }
        unilateral floor: ball.y >= 0 m { restitution: 0.5; }
        output push = reaction(floor);
    }
}
