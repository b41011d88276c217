//! Ladders of four-bars: the IFToMM benchmark A02 with numbers of its own (M. González et al., Library of Computational
//! Benchmark Problems). A ladder of one window is a four-bar.

declare!(ladder_2 {
    ground { a0(gx0 gy0 gw0), a1(gx1 gy1 gw1), a2(gx2 gy2 gw2) }
    body post_0(mp0 ip0) { a(pax0 pay0 paw0), b(pbx0 pby0 pbw0) }
    body post_1(mp1 ip1) { a(pax1 pay1 paw1), b(pbx1 pby1 pbw1) }
    body post_2(mp2 ip2) { a(pax2 pay2 paw2), b(pbx2 pby2 pbw2) }
    body rung_1(mr1 ir1) { b(rbx1 rby1 rbw1), c(rcx1 rcy1 rcw1) }
    body rung_2(mr2 ir2) { b(rbx2 rby2 rbw2), c(rcx2 rcy2 rcw2) }
    drive j0(ground.a0, post_0.a) k0 d0 r0;
    revolute j1(ground.a1, post_1.a) k1 d1 r1;
    revolute j2(ground.a2, post_2.a) k2 d2 r2;
    revolute jb1(post_0.b, rung_1.b) kb1 db1 rb1;
    revolute jc1(rung_1.c, post_1.b) kc1 dc1 rc1;
    revolute jb2(post_1.b, rung_2.b) kb2 db2 rb2;
    revolute jc2(rung_2.c, post_2.b) kc2 dc2 rc2;
});

declare!(ladder_3 {
    ground { a0(gx0 gy0 gw0), a1(gx1 gy1 gw1), a2(gx2 gy2 gw2), a3(gx3 gy3 gw3) }
    body post_0(mp0 ip0) { a(pax0 pay0 paw0), b(pbx0 pby0 pbw0) }
    body post_1(mp1 ip1) { a(pax1 pay1 paw1), b(pbx1 pby1 pbw1) }
    body post_2(mp2 ip2) { a(pax2 pay2 paw2), b(pbx2 pby2 pbw2) }
    body post_3(mp3 ip3) { a(pax3 pay3 paw3), b(pbx3 pby3 pbw3) }
    body rung_1(mr1 ir1) { b(rbx1 rby1 rbw1), c(rcx1 rcy1 rcw1) }
    body rung_2(mr2 ir2) { b(rbx2 rby2 rbw2), c(rcx2 rcy2 rcw2) }
    body rung_3(mr3 ir3) { b(rbx3 rby3 rbw3), c(rcx3 rcy3 rcw3) }
    drive j0(ground.a0, post_0.a) k0 d0 r0;
    revolute j1(ground.a1, post_1.a) k1 d1 r1;
    revolute j2(ground.a2, post_2.a) k2 d2 r2;
    revolute j3(ground.a3, post_3.a) k3 d3 r3;
    revolute jb1(post_0.b, rung_1.b) kb1 db1 rb1;
    revolute jc1(rung_1.c, post_1.b) kc1 dc1 rc1;
    revolute jb2(post_1.b, rung_2.b) kb2 db2 rb2;
    revolute jc2(rung_2.c, post_2.b) kc2 dc2 rc2;
    revolute jb3(post_2.b, rung_3.b) kb3 db3 rb3;
    revolute jc3(rung_3.c, post_3.b) kc3 dc3 rc3;
});

declare!(ladder_4 {
    ground { a0(gx0 gy0 gw0), a1(gx1 gy1 gw1), a2(gx2 gy2 gw2), a3(gx3 gy3 gw3), a4(gx4 gy4 gw4) }
    body post_0(mp0 ip0) { a(pax0 pay0 paw0), b(pbx0 pby0 pbw0) }
    body post_1(mp1 ip1) { a(pax1 pay1 paw1), b(pbx1 pby1 pbw1) }
    body post_2(mp2 ip2) { a(pax2 pay2 paw2), b(pbx2 pby2 pbw2) }
    body post_3(mp3 ip3) { a(pax3 pay3 paw3), b(pbx3 pby3 pbw3) }
    body post_4(mp4 ip4) { a(pax4 pay4 paw4), b(pbx4 pby4 pbw4) }
    body rung_1(mr1 ir1) { b(rbx1 rby1 rbw1), c(rcx1 rcy1 rcw1) }
    body rung_2(mr2 ir2) { b(rbx2 rby2 rbw2), c(rcx2 rcy2 rcw2) }
    body rung_3(mr3 ir3) { b(rbx3 rby3 rbw3), c(rcx3 rcy3 rcw3) }
    body rung_4(mr4 ir4) { b(rbx4 rby4 rbw4), c(rcx4 rcy4 rcw4) }
    drive j0(ground.a0, post_0.a) k0 d0 r0;
    revolute j1(ground.a1, post_1.a) k1 d1 r1;
    revolute j2(ground.a2, post_2.a) k2 d2 r2;
    revolute j3(ground.a3, post_3.a) k3 d3 r3;
    revolute j4(ground.a4, post_4.a) k4 d4 r4;
    revolute jb1(post_0.b, rung_1.b) kb1 db1 rb1;
    revolute jc1(rung_1.c, post_1.b) kc1 dc1 rc1;
    revolute jb2(post_1.b, rung_2.b) kb2 db2 rb2;
    revolute jc2(rung_2.c, post_2.b) kc2 dc2 rc2;
    revolute jb3(post_2.b, rung_3.b) kb3 db3 rb3;
    revolute jc3(rung_3.c, post_3.b) kc3 dc3 rc3;
    revolute jb4(post_3.b, rung_4.b) kb4 db4 rb4;
    revolute jc4(rung_4.c, post_4.b) kc4 dc4 rc4;
});

declare!(ladder_5 {
    ground { a0(gx0 gy0 gw0), a1(gx1 gy1 gw1), a2(gx2 gy2 gw2), a3(gx3 gy3 gw3), a4(gx4 gy4 gw4), a5(gx5 gy5 gw5) }
    body post_0(mp0 ip0) { a(pax0 pay0 paw0), b(pbx0 pby0 pbw0) }
    body post_1(mp1 ip1) { a(pax1 pay1 paw1), b(pbx1 pby1 pbw1) }
    body post_2(mp2 ip2) { a(pax2 pay2 paw2), b(pbx2 pby2 pbw2) }
    body post_3(mp3 ip3) { a(pax3 pay3 paw3), b(pbx3 pby3 pbw3) }
    body post_4(mp4 ip4) { a(pax4 pay4 paw4), b(pbx4 pby4 pbw4) }
    body post_5(mp5 ip5) { a(pax5 pay5 paw5), b(pbx5 pby5 pbw5) }
    body rung_1(mr1 ir1) { b(rbx1 rby1 rbw1), c(rcx1 rcy1 rcw1) }
    body rung_2(mr2 ir2) { b(rbx2 rby2 rbw2), c(rcx2 rcy2 rcw2) }
    body rung_3(mr3 ir3) { b(rbx3 rby3 rbw3), c(rcx3 rcy3 rcw3) }
    body rung_4(mr4 ir4) { b(rbx4 rby4 rbw4), c(rcx4 rcy4 rcw4) }
    body rung_5(mr5 ir5) { b(rbx5 rby5 rbw5), c(rcx5 rcy5 rcw5) }
    drive j0(ground.a0, post_0.a) k0 d0 r0;
    revolute j1(ground.a1, post_1.a) k1 d1 r1;
    revolute j2(ground.a2, post_2.a) k2 d2 r2;
    revolute j3(ground.a3, post_3.a) k3 d3 r3;
    revolute j4(ground.a4, post_4.a) k4 d4 r4;
    revolute j5(ground.a5, post_5.a) k5 d5 r5;
    revolute jb1(post_0.b, rung_1.b) kb1 db1 rb1;
    revolute jc1(rung_1.c, post_1.b) kc1 dc1 rc1;
    revolute jb2(post_1.b, rung_2.b) kb2 db2 rb2;
    revolute jc2(rung_2.c, post_2.b) kc2 dc2 rc2;
    revolute jb3(post_2.b, rung_3.b) kb3 db3 rb3;
    revolute jc3(rung_3.c, post_3.b) kc3 dc3 rc3;
    revolute jb4(post_3.b, rung_4.b) kb4 db4 rb4;
    revolute jc4(rung_4.c, post_4.b) kc4 dc4 rc4;
    revolute jb5(post_4.b, rung_5.b) kb5 db5 rb5;
    revolute jc5(rung_5.c, post_5.b) kc5 dc5 rc5;
});
