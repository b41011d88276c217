//! Groups of links that no dyad opens.

declare!(platform {
    ground { a(gax gay gaw), b(gbx gby gbw), c(gcx gcy gcw) }
    body tube_a(m1 i1) { a(ax1 ay1 aw1), s(sx1 sy1 sw1) }
    body tube_b(m2 i2) { b(ax2 ay2 aw2), s(sx2 sy2 sw2) }
    body tube_c(m3 i3) { c(ax3 ay3 aw3), s(sx3 sy3 sw3) }
    body rod_a(m4 i4) { s(sx4 sy4 sw4), p(px4 py4 pw4) }
    body rod_b(m5 i5) { s(sx5 sy5 sw5), p(px5 py5 pw5) }
    body rod_c(m6 i6) { s(sx6 sy6 sw6), p(px6 py6 pw6) }
    body plate(m7 i7) { a(ax7 ay7 aw7), b(bx7 by7 bw7), c(cx7 cy7 cw7) }
    drive ja(ground.a, tube_a.a) ka da ra;
    revolute jb(ground.b, tube_b.b) kb db rb;
    revolute jc(ground.c, tube_c.c) kc dc rc;
    revolute pa(rod_a.p, plate.a) kp dp rp;
    revolute pb(rod_b.p, plate.b) kq dq rq;
    revolute pc(rod_c.p, plate.c) kr dr rr;
    prismatic sa(tube_a.s, rod_a.s) ks ds rs;
    prismatic sb(tube_b.s, rod_b.s) kt dt rt;
    prismatic sc(tube_c.s, rod_c.s) ku du ru;
});

declare!(butterfly {
    ground { a(gax gay gaw), c(gcx gcy gcw), e(gex gey gew) }
    body base(m1 i1) { a(ax1 ay1 aw1), h(hx1 hy1 hw1), j(jx1 jy1 jw1) }
    body left(m2 i2) { b(bx2 by2 bw2), d(dx2 dy2 dw2), i(ix2 iy2 iw2) }
    body right(m3 i3) { b(bx3 by3 bw3), f(fx3 fy3 fw3), k(kx3 ky3 kw3) }
    body strut_0(m4 i4) { p(px4 py4 pw4), q(qx4 qy4 qw4) }
    body strut_1(m5 i5) { p(px5 py5 pw5), q(qx5 qy5 qw5) }
    body strut_2(m6 i6) { p(px6 py6 pw6), q(qx6 qy6 qw6) }
    body strut_3(m7 i7) { p(px7 py7 pw7), q(qx7 qy7 qw7) }
    drive j0(ground.a, base.a) k0 d0 r0;
    revolute j1(left.b, right.b) k1 d1 r1;
    revolute j2(ground.c, strut_0.p) k2 d2 r2;
    revolute j3(strut_0.q, left.d) k3 d3 r3;
    revolute j4(ground.e, strut_1.p) k4 d4 r4;
    revolute j5(strut_1.q, right.f) k5 d5 r5;
    revolute j6(base.h, strut_2.p) k6 d6 r6;
    revolute j7(strut_2.q, left.i) k7 d7 r7;
    revolute j8(base.j, strut_3.p) k8 d8 r8;
    revolute j9(strut_3.q, right.k) k9 d9 r9;
});
