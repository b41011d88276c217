//! Open chains with branches.

declare!(tree_2 {
    ground { a(gax gay gaw) }
    body one(m1 i1) { a(ax1 ay1 aw1), b(bx1 by1 bw1) }
    body two(m2 i2) { b(bx2 by2 bw2) }
    drive ja(ground.a, one.a) ka da ra;
    revolute jb(one.b, two.b) kb db rb;
});

declare!(tree_3 {
    ground { a(gax gay gaw) }
    body one(m1 i1) { a(ax1 ay1 aw1), b(bx1 by1 bw1) }
    body two(m2 i2) { b(bx2 by2 bw2), c(cx2 cy2 cw2) }
    body three(m3 i3) { c(cx3 cy3 cw3) }
    drive ja(ground.a, one.a) ka da ra;
    revolute jc(two.c, three.c) kc dc rc;
    prismatic jb(one.b, two.b) kb db rb;
});

declare!(tree_4 {
    ground { a(gax gay gaw) }
    body one(m1 i1) { a(ax1 ay1 aw1), b(bx1 by1 bw1), c(cx1 cy1 cw1) }
    body two(m2 i2) { b(bx2 by2 bw2) }
    body three(m3 i3) { c(cx3 cy3 cw3), d(dx3 dy3 dw3) }
    body four(m4 i4) { d(dx4 dy4 dw4) }
    drive ja(ground.a, one.a) ka da ra;
    revolute jc(one.c, three.c) kc dc rc;
    revolute jd(three.d, four.d) kd dd rd;
    prismatic jb(one.b, two.b) kb db rb;
});

declare!(tree_5 {
    ground { a(gax gay gaw), g(ggx ggy ggw) }
    body one(m1 i1) { a(ax1 ay1 aw1), b(bx1 by1 bw1), c(cx1 cy1 cw1) }
    body two(m2 i2) { b(bx2 by2 bw2), e(ex2 ey2 ew2) }
    body three(m3 i3) { c(cx3 cy3 cw3) }
    body cart(m4 i4) { a(ax4 ay4 aw4), g(gx4 gy4 gw4) }
    body five(m5 i5) { e(ex5 ey5 ew5) }
    drive ja(cart.a, one.a) ka da ra;
    revolute jb(one.b, two.b) kb db rb;
    revolute jc(one.c, three.c) kc dc rc;
    prismatic jg(ground.g, cart.g) kh dh rh;
    pin_slot je(two.e, five.e) ke de re;
});
