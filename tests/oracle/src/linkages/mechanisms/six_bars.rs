//! The two kinds of six-bar, by which bar is the ground (K. Luck, K.-H. Modler, Getriebetechnik, 1990, chapter 2).

declare!(watt_1 {
    ground { a(gax gay gaw), d(gdx gdy gdw) }
    body one(m1 i1) { a(ax1 ay1 aw1), b(bx1 by1 bw1) }
    body two(m2 i2) { b(bx2 by2 bw2), c(cx2 cy2 cw2), e(ex2 ey2 ew2) }
    body three(m3 i3) { d(dx3 dy3 dw3), c(cx3 cy3 cw3), g(gx3 gy3 gw3) }
    body link(m4 i4) { e(ex4 ey4 ew4), f(fx4 fy4 fw4) }
    body arm(m5 i5) { g(gx5 gy5 gw5), f(fx5 fy5 fw5) }
    drive ja(ground.a, one.a) ka da ra;
    revolute jb(one.b, two.b) kb db rb;
    revolute jc(two.c, three.c) kc dc rc;
    revolute jd(ground.d, three.d) kd dd rd;
    revolute je(two.e, link.e) ke de re;
    revolute jf(link.f, arm.f) kf df rf;
    revolute jg(three.g, arm.g) kh dh rh;
});

declare!(watt_2 {
    ground { a(gax gay gaw), d(gdx gdy gdw), g(ggx ggy ggw) }
    body one(m1 i1) { a(ax1 ay1 aw1), b(bx1 by1 bw1) }
    body two(m2 i2) { b(bx2 by2 bw2), c(cx2 cy2 cw2) }
    body three(m3 i3) { d(dx3 dy3 dw3), c(cx3 cy3 cw3), e(ex3 ey3 ew3) }
    body link(m4 i4) { e(ex4 ey4 ew4), f(fx4 fy4 fw4) }
    body arm(m5 i5) { g(gx5 gy5 gw5), f(fx5 fy5 fw5) }
    drive ja(ground.a, one.a) ka da ra;
    revolute jb(one.b, two.b) kb db rb;
    revolute jc(two.c, three.c) kc dc rc;
    revolute jd(ground.d, three.d) kd dd rd;
    revolute je(three.e, link.e) ke de re;
    revolute jf(link.f, arm.f) kf df rf;
    revolute jg(ground.g, arm.g) kh dh rh;
});

declare!(stephenson_1 {
    ground { a(gax gay gaw), d(gdx gdy gdw) }
    body one(m1 i1) { a(ax1 ay1 aw1), b(bx1 by1 bw1), e(ex1 ey1 ew1) }
    body two(m2 i2) { b(bx2 by2 bw2), c(cx2 cy2 cw2) }
    body three(m3 i3) { d(dx3 dy3 dw3), c(cx3 cy3 cw3), g(gx3 gy3 gw3) }
    body link(m4 i4) { e(ex4 ey4 ew4), f(fx4 fy4 fw4) }
    body arm(m5 i5) { g(gx5 gy5 gw5), f(fx5 fy5 fw5) }
    drive ja(ground.a, one.a) ka da ra;
    revolute jb(one.b, two.b) kb db rb;
    revolute jc(two.c, three.c) kc dc rc;
    revolute jd(ground.d, three.d) kd dd rd;
    revolute je(one.e, link.e) ke de re;
    revolute jf(link.f, arm.f) kf df rf;
    revolute jg(three.g, arm.g) kh dh rh;
});

declare!(stephenson_2 {
    ground { a(gax gay gaw), d(gdx gdy gdw) }
    body one(m1 i1) { a(ax1 ay1 aw1), b(bx1 by1 bw1) }
    body two(m2 i2) { b(bx2 by2 bw2), c(cx2 cy2 cw2), e(ex2 ey2 ew2) }
    body three(m3 i3) { d(dx3 dy3 dw3), g(gx3 gy3 gw3), f(fx3 fy3 fw3) }
    body link(m4 i4) { c(cx4 cy4 cw4), g(gx4 gy4 gw4) }
    body arm(m5 i5) { e(ex5 ey5 ew5), f(fx5 fy5 fw5) }
    drive ja(ground.a, one.a) ka da ra;
    revolute jb(one.b, two.b) kb db rb;
    revolute jc(two.c, link.c) kc dc rc;
    revolute jd(ground.d, three.d) kd dd rd;
    revolute je(two.e, arm.e) ke de re;
    revolute jf(arm.f, three.f) kf df rf;
    revolute jg(link.g, three.g) kh dh rh;
});

declare!(stephenson_3 {
    ground { a(gax gay gaw), d(gdx gdy gdw), g(ggx ggy ggw) }
    body one(m1 i1) { a(ax1 ay1 aw1), b(bx1 by1 bw1) }
    body two(m2 i2) { b(bx2 by2 bw2), c(cx2 cy2 cw2), e(ex2 ey2 ew2) }
    body three(m3 i3) { d(dx3 dy3 dw3), c(cx3 cy3 cw3) }
    body link(m4 i4) { e(ex4 ey4 ew4), f(fx4 fy4 fw4) }
    body arm(m5 i5) { g(gx5 gy5 gw5), f(fx5 fy5 fw5) }
    drive ja(ground.a, one.a) ka da ra;
    revolute jb(one.b, two.b) kb db rb;
    revolute jc(two.c, three.c) kc dc rc;
    revolute jd(ground.d, three.d) kd dd rd;
    revolute je(two.e, link.e) ke de re;
    revolute jf(link.f, arm.f) kf df rf;
    revolute jg(ground.g, arm.g) kh dh rh;
});
