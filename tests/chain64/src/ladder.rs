//! A ladder of four-bars with equal bars, after the benchmark A02 of IFToMM (M. González et al., Library of Computational
//! Benchmark Problems).

plm::mechanism! {
    /// Ten windows, upright, moving to the right at 1 m/s.
    pub Ladder10 {
        gravity: 9.81 m/s^2;
        ground {
            port f0: (0, 0) m; port f1: (1, 0) m; port f2: (2, 0) m; port f3: (3, 0) m;
            port f4: (4, 0) m; port f5: (5, 0) m; port f6: (6, 0) m; port f7: (7, 0) m;
            port f8: (8, 0) m; port f9: (9, 0) m; port f10: (10, 0) m;
        }
        repeat i in 0..=10 {
            body up[i] {
                mass: 1 kg;
                inertia: 1 kg*m^2/12;
                port low: (-0.5, 0) m;
                port high: (0.5, 0) m;
                start x: i*1 m;
                start y: 0.5 m;
                start angle: 90 deg;
                start vx: 0.5 m/s;
                start omega: -1 rad/s;
            }
        }
        repeat i in 1..=10 {
            body top[i] {
                mass: 1 kg;
                inertia: 1 kg*m^2/12;
                port a: (-0.5, 0) m;
                port b: (0.5, 0) m;
                start x: (i - 0.5)*1 m;
                start y: 1 m;
                start vx: 1 m/s;
            }
            revolute left[i](up[i-1].high, top[i].a);
            revolute right[i](top[i].b, up[i].high);
        }
        revolute foot0(ground.f0, up[0].low);
        revolute foot1(ground.f1, up[1].low);
        revolute foot2(ground.f2, up[2].low);
        revolute foot3(ground.f3, up[3].low);
        revolute foot4(ground.f4, up[4].low);
        revolute foot5(ground.f5, up[5].low);
        revolute foot6(ground.f6, up[6].low);
        revolute foot7(ground.f7, up[7].low);
        revolute foot8(ground.f8, up[8].low);
        revolute foot9(ground.f9, up[9].low);
        revolute foot10(ground.f10, up[10].low);
    }
}
