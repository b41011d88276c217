//! Four-bars and slider-cranks.

declare!(four_bar {
    ground { a(gax gay gaw), d(gdx gdy gdw) }
    body one(m1 i1) { a(ax1 ay1 aw1), b(bx1 by1 bw1) }
    body two(m2 i2) { b(bx2 by2 bw2), c(cx2 cy2 cw2) }
    body three(m3 i3) { d(dx3 dy3 dw3), c(cx3 cy3 cw3) }
    drive ja(ground.a, one.a) ka da ra;
    revolute jb(one.b, two.b) kb db rb;
    revolute jc(two.c, three.c) kc dc rc;
    revolute jd(ground.d, three.d) kd dd rd;
});

declare!(slider_crank {
    ground { a(gax gay gaw), g(ggx ggy ggw) }
    body one(m1 i1) { a(ax1 ay1 aw1), b(bx1 by1 bw1) }
    body two(m2 i2) { b(bx2 by2 bw2), c(cx2 cy2 cw2) }
    body slider(m3 i3) { c(cx3 cy3 cw3) }
    drive ja(ground.a, one.a) ka da ra;
    revolute jb(one.b, two.b) kb db rb;
    revolute jc(two.c, slider.c) kc dc rc;
    prismatic jg(ground.g, slider.c) kh dh rh;
});

declare!(shaper {
    ground { a(gax gay gaw), d(gdx gdy gdw), g(ggx ggy ggw) }
    body one(m1 i1) { a(ax1 ay1 aw1), b(bx1 by1 bw1) }
    body lever(m2 i2) { d(dx2 dy2 dw2), s(sx2 sy2 sw2), e(ex2 ey2 ew2) }
    body link(m3 i3) { e(ex3 ey3 ew3), f(fx3 fy3 fw3) }
    body ram(m4 i4) { f(fx4 fy4 fw4) }
    drive ja(ground.a, one.a) ka da ra;
    revolute jd(ground.d, lever.d) kd dd rd;
    revolute je(lever.e, link.e) ke de re;
    revolute jf(link.f, ram.f) kf df rf;
    prismatic jg(ground.g, ram.f) kh dh rh;
    pin_slot js(lever.s, one.b) ks ds rs;
});
