/* Elementary functions of plm-math in C99: same operations in the same order, so the same bits. Nothing is fused: every product that
 * is added to stands in a statement of its own, which ISO C (6.5p8) keeps a compiler from contracting. */
#ifndef PLM_MATH_H
#define PLM_MATH_H

#ifdef __CUDACC_RTC__
/* NVRTC has no headers, and memset and memcpy by itself. */
typedef int int32_t;
typedef unsigned int uint32_t;
typedef unsigned long long uint64_t;
#else
#include <float.h>
#include <stdint.h>
#include <string.h>
#endif

/* No product and sum may be fused into one operation; to nvcc and NVRTC the option -fmad=false says so. */
#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#elif defined(__GNUC__) && !defined(__CUDACC__)
#pragma GCC optimize ("fp-contract=off")
#elif defined(_MSC_VER)
#pragma fp_contract (off)
#endif

/* 16 and 32 widen numbers of 16 bits alone (C23, annex H): processors with arithmetic of those have 16. */
#if !defined(__cplusplus) && FLT_EVAL_METHOD != 0 && FLT_EVAL_METHOD != 16 && FLT_EVAL_METHOD != 32
#error "plm: expressions must be evaluated in their own type (no x87)"
#endif
#if defined(__FAST_MATH__) || (defined(__CUDACC__) && (__USE_FAST_MATH__ + 0))
#error "plm: without -ffast-math"
#endif
#ifndef PLM_MAY_BE_UNUSED
#ifdef __GNUC__
#define PLM_MAY_BE_UNUSED __attribute__((unused))
#else
#define PLM_MAY_BE_UNUSED
#endif
#endif
#ifndef PLM_DEVICE
#ifdef __CUDACC__
#define PLM_DEVICE __device__
#else
#define PLM_DEVICE
#endif
#endif
/* Functions that seldom run, or are long: on a GPU they would take registers from what always runs. */
#ifdef __CUDACC__
#define PLM_APART __noinline__
#else
#define PLM_APART
#endif
#define PLM_FUNCTION PLM_DEVICE static PLM_MAY_BE_UNUSED

#ifdef PLM_SINGLE
typedef float plm_real;
typedef uint32_t plm_bits;
#define PLM_DIGITS 24
#define PLM_MAX_EXP 128
#define PLM_C(x) ((plm_real)x##F)
#ifndef __CUDACC_RTC__
typedef char plm_check_real[(FLT_MANT_DIG == 24) ? 1 : -1];
#endif
#else
typedef double plm_real;
typedef uint64_t plm_bits;
#define PLM_DIGITS 53
#define PLM_MAX_EXP 1024
#define PLM_C(x) ((plm_real)x)
#ifndef __CUDACC_RTC__
typedef char plm_check_real[(DBL_MANT_DIG == 53) ? 1 : -1];
#endif
#endif

typedef struct { plm_real sine; plm_real cosine; } plm_pair;
/* The number high - less. */
typedef struct { plm_real high; plm_real less; } plm_rest;

PLM_FUNCTION plm_bits plm_to_bits(plm_real x) {
    plm_bits bits;
    memcpy(&bits, &x, sizeof bits);
    return bits;
}

PLM_FUNCTION plm_real plm_of_bits(plm_bits bits) {
    plm_real x;
    memcpy(&x, &bits, sizeof x);
    return x;
}

#define PLM_SIGN_BIT ((plm_bits)((plm_bits)1 << (sizeof(plm_bits) * 8u - 1u)))
#define PLM_FRACTION ((plm_bits)(((plm_bits)1 << (PLM_DIGITS - 1)) - 1u))
#define PLM_LEADING ((plm_bits)((plm_bits)1 << (PLM_DIGITS - 1)))
#define PLM_INFINITY plm_of_bits((plm_bits)((plm_bits)(2 * PLM_MAX_EXP - 1) << (PLM_DIGITS - 1)))
#define PLM_NAN plm_of_bits((plm_bits)(((plm_bits)(2 * PLM_MAX_EXP - 1) << (PLM_DIGITS - 1)) | ((plm_bits)1 << (PLM_DIGITS - 2))))

PLM_FUNCTION plm_real plm_abs(plm_real x) { return plm_of_bits(plm_to_bits(x) & (plm_bits)~PLM_SIGN_BIT); }

PLM_FUNCTION plm_real plm_copysign(plm_real x, plm_real sign) {
    return plm_of_bits((plm_to_bits(x) & (plm_bits)~PLM_SIGN_BIT) | (plm_to_bits(sign) & PLM_SIGN_BIT));
}

PLM_FUNCTION int plm_is_finite(plm_real x) { return plm_abs(x) < PLM_INFINITY; }

PLM_FUNCTION plm_real plm_sign(plm_real x) {
    const plm_real upper = (PLM_C(0.0) < x) ? PLM_C(1.0) : PLM_C(0.0);
    return (x < PLM_C(0.0)) ? PLM_C(-1.0) : upper;
}

PLM_FUNCTION plm_real plm_power_of_two(int32_t k) {
    return plm_of_bits((plm_bits)((plm_bits)(uint32_t)(k + PLM_MAX_EXP - 1) << (PLM_DIGITS - 1)));
}

PLM_FUNCTION int32_t plm_exponent(plm_real x) {
    return (int32_t)((plm_to_bits(x) & (plm_bits)~PLM_SIGN_BIT) >> (PLM_DIGITS - 1)) - (PLM_MAX_EXP - 1);
}

PLM_FUNCTION plm_real plm_significand(plm_real x) {
    return plm_of_bits((plm_to_bits(x) & PLM_FRACTION) | plm_to_bits(PLM_C(1.0)));
}

/* 1.5 2^(p-1): x + this is x rounded to an integer, in the low bits. */
#ifdef PLM_SINGLE
#define PLM_ROUNDER PLM_C(12582912.0)
#define PLM_INTEGERS PLM_C(8388608.0)
#else
#define PLM_ROUNDER PLM_C(6755399441055744.0)
#define PLM_INTEGERS PLM_C(4503599627370496.0)
#endif

/* The integer of x + PLM_ROUNDER. */
PLM_FUNCTION int32_t plm_rounded(plm_real sum) {
    const plm_bits half = (plm_bits)1 << (PLM_DIGITS - 3);
    const plm_bits low = plm_to_bits(sum) & (plm_bits)(((plm_bits)1 << (PLM_DIGITS - 2)) - 1u);
    return (low < half) ? (int32_t)low : -(int32_t)(((plm_bits)1 << (PLM_DIGITS - 2)) - low);
}

PLM_FUNCTION plm_real plm_times_plus(plm_real x, plm_real a, plm_real b) {
    const plm_real product = x * a;
    return product + b;
}

PLM_FUNCTION plm_real plm_polynomial(plm_real x, const plm_real c[], int count) {
    plm_real sum = c[count - 1];
    int k;
    for (k = count - 2; k >= 0; k--) {
        const plm_real product = sum * x;
        sum = product + c[k];
    }
    return sum;
}

PLM_FUNCTION plm_real plm_floor(plm_real x) {
    plm_real integer = x;
    if (plm_abs(x) < PLM_INTEGERS) {
        const plm_real sum = plm_abs(x) + PLM_INTEGERS;
        integer = plm_copysign(sum - PLM_INTEGERS, x);
    }
    /* Zero has one sign. */
    return ((integer > x) ? (integer - PLM_C(1.0)) : integer) + PLM_C(0.0);
}

/* ---- pairs ---- */
PLM_FUNCTION plm_rest plm_ordered_sum(plm_real a, plm_real b) {
    plm_rest r;
    r.high = a + b;
    r.less = (r.high - a) - b;
    return r;
}

PLM_FUNCTION plm_real plm_head(plm_real x) {
    return plm_of_bits(plm_to_bits(x) & (plm_bits)((plm_bits)~(plm_bits)0 << ((PLM_DIGITS + 1) / 2)));
}

PLM_FUNCTION plm_rest plm_product(plm_real a, plm_real b) {
    plm_rest r;
    const plm_real ah = plm_head(a), bh = plm_head(b);
    const plm_real at = a - ah, bt = b - bh;
    const plm_real hh = ah * bh, ht = ah * bt, th = at * bh, tt = at * bt;
    r.high = a * b;
    r.less = (((r.high - hh) - ht) - th) - tt;
    return r;
}

PLM_FUNCTION plm_rest plm_over(plm_rest n, plm_rest d) {
    plm_rest r;
    plm_rest product;
    plm_real excess, correction;
    r.high = n.high / d.high;
    product = plm_product(r.high, d.high);
    excess = (product.high - n.high) - product.less;
    correction = r.high * d.less;
    r.less = ((excess + n.less) - correction) / d.high;
    return r;
}

PLM_FUNCTION plm_real plm_plus(plm_rest a, plm_real factor, plm_rest small) {
    const plm_real head = factor * small.high;
    const plm_real tail = factor * small.less;
    const plm_rest sum = plm_ordered_sum(a.high, head);
    return sum.high - (sum.less + (a.less + tail));
}

PLM_FUNCTION plm_rest plm_round_pair(plm_rest a) {
    plm_rest r;
    r.high = a.high - a.less;
    r.less = (r.high - a.high) + a.less;
    return r;
}

/* ---- square root: correctly rounded, as IEEE 754 demands of a processor's ---- */
#if !defined(PLM_SQRT) && defined(__CUDACC__)
#ifdef PLM_SINGLE
#define PLM_SQRT(x) __fsqrt_rn(x)
#else
#define PLM_SQRT(x) __dsqrt_rn(x)
#endif
#endif
#if !defined(PLM_SQRT) && (defined(__SSE2__) || defined(_M_X64))
#include <emmintrin.h>
#ifdef PLM_SINGLE
#define PLM_SQRT(x) _mm_cvtss_f32(_mm_sqrt_ss(_mm_set_ss(x)))
#else
#define PLM_SQRT(x) _mm_cvtsd_f64(_mm_sqrt_sd(_mm_setzero_pd(), _mm_set_sd(x)))
#endif
#endif
#ifndef PLM_SQRT
#ifdef PLM_SINGLE
#define PLM_ROOT_START ((plm_bits)0x5f3759dfu)
#define PLM_ROOT_STEPS 2
#else
#define PLM_ROOT_START ((plm_bits)0x5fe6eb50c7b537a9u)
#define PLM_ROOT_STEPS 3
#endif
PLM_FUNCTION plm_real plm_sqrt(plm_real x0) {
    plm_real x = x0, m, half, inverse, root, most;
    plm_rest square;
    plm_bits n, bits, remainder, result;
    int32_t shift = 0, exponent, odd;
    int k;
    if (!((x > PLM_C(0.0)) && (x < PLM_INFINITY))) {
        return (x >= PLM_C(0.0)) ? x : PLM_NAN;
    }
    if (plm_to_bits(x) <= PLM_FRACTION) {
        x = x * PLM_INTEGERS;
        shift = 1 - PLM_DIGITS;
    }
    exponent = plm_exponent(x) + shift;
    odd = (int32_t)((uint32_t)exponent & 1u);
    m = plm_significand(x) * (plm_real)(1 + odd);
    inverse = plm_of_bits(PLM_ROOT_START - (plm_to_bits(m) >> 1));
    half = PLM_C(0.5) * m;
    for (k = 0; k < PLM_ROOT_STEPS; k++) {
        const plm_real part = half * inverse;
        const plm_real all = part * inverse;
        inverse = inverse * (PLM_C(1.5) - all);
    }
    root = m * inverse;
    square = plm_product(root, root);
    {
        const plm_real off = (square.high - m) - square.less;
        const plm_real by = PLM_C(0.5) * inverse;
        const plm_real correction = off * by;
        root = root - correction;
    }
    most = plm_of_bits(plm_to_bits(PLM_C(2.0)) - 1u);
    root = (root < PLM_C(1.0)) ? PLM_C(1.0) : ((root > most) ? most : root);
    n = (plm_to_bits(root) & PLM_FRACTION) | PLM_LEADING;
    bits = (plm_bits)(((plm_to_bits(x) & PLM_FRACTION) | PLM_LEADING) << (PLM_DIGITS - 1 + odd));
    remainder = (plm_bits)(bits - (plm_bits)(n * n));
    if ((remainder & PLM_SIGN_BIT) == 0u) {
        result = n + (plm_bits)((remainder > n) ? 1u : 0u);
    } else {
        result = n - (plm_bits)((((plm_bits)~remainder + 1u) >= n) ? 1u : 0u);
    }
    exponent = (exponent - odd) / 2;
    return plm_of_bits((plm_bits)((plm_bits)((plm_bits)(uint32_t)(exponent + PLM_MAX_EXP - 2) << (PLM_DIGITS - 1)) + result));
}
#else
PLM_FUNCTION plm_real plm_sqrt(plm_real x) { return PLM_SQRT(x); }
#endif

/* ---- sine and cosine ---- */
#ifdef PLM_SINGLE
#define PLM_ANGLE_BOUND PLM_C(402.0)
#define PLM_TWO_OVER_PI PLM_C(0x1.45f306p-1)
#else
#define PLM_ANGLE_BOUND PLM_C(411774.0)
#define PLM_TWO_OVER_PI PLM_C(0x1.45f306dc9c883p-1)
#endif

typedef struct { uint64_t hi; uint64_t lo; } plm_wide;

PLM_FUNCTION plm_wide plm_multiply(uint64_t a, uint64_t b) {
    const uint64_t low = 0xffffffffu;
    const uint64_t al = a & low, ah = a >> 32, bl = b & low, bh = b >> 32;
    const uint64_t ll = al * bl, lh = al * bh, hl = ah * bl, hh = ah * bh;
    const uint64_t middle = (ll >> 32) + (lh & low) + (hl & low);
    plm_wide r;
    r.lo = (middle << 32) | (ll & low);
    r.hi = hh + (lh >> 32) + (hl >> 32) + (middle >> 32);
    return r;
}

PLM_APART PLM_FUNCTION int plm_turns_of_large(plm_real x, plm_rest *rest) {
    static const uint64_t two_over_pi[20] = {
        0u, 0xa2f9836e4e441529u, 0xfc2757d1f534ddc0u, 0xdb6295993c439041u, 0xfe5163abdebbc561u, 0xb7246e3a424dd2e0u,
        0x06492eea09d1921cu, 0xfe1deb1cb129a73eu, 0xe88235f52ebb4484u, 0xe99c7026b45f7e41u, 0x3991d639835339f4u,
        0x9c845f8bbdf9283bu, 0x1ff897ffde05980fu, 0xef2f118b5a0a6d1fu, 0x6d367ecf27cb09b7u, 0x4f463f669e5fea2du,
        0x7527bac7ebe5f17bu, 0x3d0739f78a5292eau, 0x6bfb5fb11f8d5d08u, 0x56033046fc7b6babu };
    const uint64_t m = (uint64_t)((plm_to_bits(x) & PLM_FRACTION) | PLM_LEADING);
    const int32_t e = plm_exponent(x) - (PLM_DIGITS - 1);
    const int32_t position = (e + 62 > 0) ? (e + 62) : 0;
    uint64_t window[3];
    plm_wide q, p;
    uint64_t top, fraction, high, low, carry;
    int quarters, negative, is_negative = x < PLM_C(0.0);
    int32_t zeros = 0, exponent, k;
    plm_real unit;
    plm_rest r;
    for (k = 0; k < 3; k++) {
        const int32_t i = position / 64 + k;
        const uint32_t s = (uint32_t)(position % 64);
        const uint64_t a = (i < 20) ? two_over_pi[i] : 0u;
        const uint64_t b = (i + 1 < 20) ? two_over_pi[i + 1] : 0u;
        window[k] = (s == 0u) ? a : ((a << s) | (b >> (64u - s)));
    }
    q.hi = plm_multiply(m, window[0]).lo;
    p = plm_multiply(m, window[1]);
    q.lo = p.lo;
    q.hi += p.hi;
    carry = plm_multiply(m, window[2]).hi;
    q.lo += carry;
    q.hi += (q.lo < carry) ? 1u : 0u;
    quarters = (int)((((q.hi >> 61) + 1u) >> 1) & 3u);
    p.hi = (q.hi << 2) | (q.lo >> 62);
    p.lo = q.lo << 2;
    negative = (p.hi >> 63) != 0u;
    if (negative) {
        p.lo = ~p.lo + 1u;
        p.hi = ~p.hi + ((p.lo == 0u) ? 1u : 0u);
    }
    while (zeros < 128 && (p.hi >> 63) == 0u) {
        p.hi = (p.hi << 1) | (p.lo >> 63);
        p.lo = p.lo << 1;
        zeros++;
    }
    top = p.hi;
    fraction = plm_multiply(top, 0xc90fdaa22168c235u).hi;
    exponent = 1 - zeros;
    high = fraction >> (64 - PLM_DIGITS);
    low = (uint64_t)(fraction << PLM_DIGITS) >> (64 - PLM_DIGITS);
    unit = plm_power_of_two(exponent - PLM_DIGITS);
    r.high = (plm_real)high * unit;
    r.less = -((plm_real)low * unit * plm_power_of_two(-PLM_DIGITS));
    r = plm_round_pair(r);
    if (is_negative != negative) {
        r.high = -r.high;
        r.less = -r.less;
    }
    *rest = r;
    return is_negative ? (4 - quarters) : quarters;
}

PLM_FUNCTION plm_pair plm_sin_cos(plm_real x) {
#ifdef PLM_SINGLE
    static const plm_real sine[3] = { PLM_C(0x1.555546p-3), PLM_C(-0x1.110778p-7), PLM_C(0x1.9953f2p-13) };
    static const plm_real cosine[3] = { PLM_C(0x1.55554ap-5), PLM_C(-0x1.6c0c28p-10), PLM_C(0x1.99e80cp-16) };
    const plm_real first = PLM_C(0x1.921e00p+0), second = PLM_C(0x1.b54400p-16), third = PLM_C(0x1.0b4612p-34);
#else
    static const plm_real sine[6] = { 0x1.5555555555548p-3, -0x1.111111110f73p-7, 0x1.a01a019be9209p-13, -0x1.71de35552a1afp-19,
        0x1.ae5e4b82dcbe4p-26, -0x1.5d8b55497e50dp-33 };
    static const plm_real cosine[6] = { 0x1.555555555554bp-5, -0x1.6c16c16c15011p-10, 0x1.a01a019c8e7b6p-16, -0x1.27e4f7f0f0385p-22,
        0x1.1ee9db4c938cep-29, -0x1.8fa637f4a7715p-37 };
    const plm_real first = 0x1.921fb54440000p+0, second = 0x1.68c234c4c0000p-39, third = 0x1.98a2e03707345p-77;
#endif
    const int count = (int)(sizeof sine / sizeof sine[0]);
    plm_rest r;
    plm_pair result;
    plm_real z, half, w, z_r, small, by_r, by_z, s, c, circle[5];
    unsigned quarters;
    if (plm_abs(x) <= PLM_ANGLE_BOUND) {
        const plm_real turns = x * PLM_TWO_OVER_PI;
        const plm_real sum = turns + PLM_ROUNDER;
        const plm_real k = sum - PLM_ROUNDER;
        const plm_real a = k * -first;
        const plm_real rest = a + x;
        const plm_real b = k * -second;
        const plm_real high = b + rest;
        const plm_real d = k * second;
        const plm_real e = d + (high - rest);
        const plm_real f = k * third;
        r.high = high;
        r.less = f + e;
        quarters = (unsigned)(plm_to_bits(sum) & 3u);
    } else if (plm_abs(x) < PLM_INFINITY) {
        quarters = (unsigned)plm_turns_of_large(x, &r) & 3u;
    } else {
        result.sine = PLM_NAN;
        result.cosine = PLM_NAN;
        return result;
    }
    z = r.high * r.high;
    half = PLM_C(0.5) * z;
    w = PLM_C(1.0) - half;
    z_r = r.high * z;
    by_r = z_r * plm_polynomial(z, sine, count);
    small = r.less * w;
    s = r.high - (small + by_r);
    z_r = z * z;
    by_z = z_r * plm_polynomial(z, cosine, count);
    small = r.high * r.less;
    c = w - (-(((PLM_C(1.0) - w) - half) + (small + by_z)));
    circle[0] = s;
    circle[1] = c;
    circle[2] = -s;
    circle[3] = -c;
    circle[4] = s;
    result.sine = circle[quarters];
    result.cosine = circle[quarters + 1u];
    return result;
}

/* ---- arc functions, exponential, logarithm ---- */
#ifdef PLM_SINGLE
#define PLM_SCALE 40
#define PLM_RESCALE 100
#define PLM_ATAN_COUNT 6
#define PLM_ASIN_COUNT 5
#define PLM_EXP_COUNT 6
#define PLM_LN_COUNT 3
#else
#define PLM_SCALE 400
#define PLM_RESCALE 800
#define PLM_ATAN_COUNT 12
#define PLM_ASIN_COUNT 13
#define PLM_EXP_COUNT 11
#define PLM_LN_COUNT 7
#endif

/* k quarters of pi. */
PLM_FUNCTION plm_rest plm_eighths(int k) {
#ifdef PLM_SINGLE
    static const plm_real high[5] = { 0.0F, 0x1.921fb6p-1F, 0x1.921fb6p+0F, 0x1.2d97c8p+1F, 0x1.921fb6p+1F };
    static const plm_real less[5] = { 0.0F, 0x1.777a5cp-26F, 0x1.777a5cp-25F, 0x1.99bc5cp-28F, 0x1.777a5cp-24F };
#else
    static const plm_real high[5] = { 0.0, 0x1.921fb54442d18p-1, 0x1.921fb54442d18p+0, 0x1.2d97c7f3321d2p+1, 0x1.921fb54442d18p+1 };
    static const plm_real less[5] = { 0.0, -0x1.1a62633145c07p-55, -0x1.1a62633145c07p-54, -0x1.a79394c9e8a0ap-54,
        -0x1.1a62633145c07p-53 };
#endif
    plm_rest r;
    r.high = high[k];
    r.less = less[k];
    return r;
}

PLM_FUNCTION plm_real plm_direction(plm_real y, plm_real x) {
#ifdef PLM_SINGLE
    static const plm_real c[PLM_ATAN_COUNT] = { 0x1.555552p-2F, -0x1.999744p-3F, 0x1.24503p-3F, -0x1.c07268p-4F, 0x1.480d54p-4F,
        -0x1.3fd5b2p-5F };
#else
    static const plm_real c[PLM_ATAN_COUNT] = { 0x1.5555555555516p-2, -0x1.999999999113bp-3, 0x1.249249215da88p-3,
        -0x1.c71c7090d06bep-4,
        0x1.745cf4c887043p-4, -0x1.3b113d93972d1p-4, 0x1.10f31d2ed7279p-4, -0x1.dfe95c675c473p-5, 0x1.a397e6952d585p-5,
        -0x1.56f4521a2dbabp-5, 0x1.c17afcf441fc5p-6, -0x1.4b7d11fed64dap-7 };
#endif
    const int steep = plm_abs(y) > plm_abs(x);
    const plm_real larger = steep ? plm_abs(y) : plm_abs(x);
    const plm_real smaller = steep ? plm_abs(x) : plm_abs(y);
    const int diagonal = smaller + smaller > larger;
    const int backward = x < PLM_C(0.0);
    plm_rest numerator, denominator, u;
    plm_real z, first, most, rest;
    int axis;
    numerator.high = diagonal ? (larger - smaller) : smaller;
    numerator.less = PLM_C(0.0);
    if (diagonal) {
        denominator = plm_ordered_sum(larger, smaller);
        axis = backward ? 3 : 1;
    } else {
        denominator.high = larger;
        denominator.less = PLM_C(0.0);
        axis = steep ? 2 : (backward ? 4 : 0);
    }
    u = plm_over(numerator, denominator);
    z = u.high * u.high;
    first = u.high * z;
    most = first * plm_polynomial(z, c, PLM_ATAN_COUNT);
    rest = u.less * z;
    u.less = most + (u.less - rest);
    return plm_copysign(plm_plus(plm_eighths(axis), ((diagonal != 0) ^ steep ^ backward) ? PLM_C(-1.0) : PLM_C(1.0), u), y);
}

PLM_FUNCTION int32_t plm_scale_to_one(plm_real x) {
    const int32_t e = plm_exponent(x);
    return -((e < -PLM_RESCALE) ? -PLM_RESCALE : ((e > PLM_RESCALE) ? PLM_RESCALE : e));
}

PLM_FUNCTION plm_real plm_rounded_eighths(int k) {
    const plm_rest r = plm_eighths(k);
    return r.high - r.less;
}

PLM_FUNCTION plm_real plm_atan2(plm_real y, plm_real x) {
    const plm_real ay = plm_abs(y), ax = plm_abs(x);
    const plm_real larger = (ay > ax) ? ay : ax, smaller = (ay > ax) ? ax : ay;
    const plm_real negligible = plm_power_of_two(-PLM_DIGITS - 8);
    if ((smaller >= plm_power_of_two(-PLM_SCALE)) && (larger <= plm_power_of_two(PLM_SCALE))) {
        return plm_direction(y, x);
    }
    if (!((ax <= PLM_INFINITY) && (ay <= PLM_INFINITY))) {
        return PLM_NAN;
    }
    if (larger >= PLM_INFINITY) {
        int k = 2;
        if (ax >= PLM_INFINITY) {
            k = (ay >= PLM_INFINITY) ? ((x > PLM_C(0.0)) ? 1 : 3) : ((x > PLM_C(0.0)) ? 0 : 4);
        }
        return plm_copysign(plm_rounded_eighths(k), y);
    }
    if (ay <= ax * negligible) {
        if (plm_copysign(PLM_C(1.0), x) < PLM_C(0.0)) {
            return plm_copysign(plm_rounded_eighths(4), y);
        }
        return (ay <= PLM_C(0.0)) ? y : plm_copysign(y / x, y);
    }
    if (ax <= ay * negligible) {
        return plm_copysign(plm_rounded_eighths(2), y);
    }
    {
        const plm_real scale = plm_power_of_two(plm_scale_to_one((ax > ay) ? x : y));
        return plm_direction(y * scale, x * scale);
    }
}

PLM_FUNCTION plm_real plm_asin_series(plm_real z) {
#ifdef PLM_SINGLE
    static const plm_real c[PLM_ASIN_COUNT] = { 0x1.5555c8p-3F, 0x1.330204p-4F, 0x1.747bb4p-5F, 0x1.8c3ea6p-6F, 0x1.595c0ap-5F };
#else
    static const plm_real c[PLM_ASIN_COUNT] = { 0x1.5555555555577p-3, 0x1.333333332e131p-4, 0x1.6db6db7212693p-5,
        0x1.f1c71a94f216bp-6,
        0x1.6e8bdee05e2d9p-6, 0x1.1c49f05a83b1cp-6, 0x1.ca1f8da85976ep-7, 0x1.758588088d6aep-7, 0x1.613c93b3a8ba7p-7,
        0x1.e5f541f7c3802p-9, 0x1.639c78c1b3ff4p-6, -0x1.57fd6d9212d39p-6, 0x1.0b46b0de141aep-5 };
#endif
    return plm_polynomial(z, c, PLM_ASIN_COUNT);
}

PLM_FUNCTION plm_rest plm_near_zero(plm_real s) {
    const plm_real z = s * s, first = s * z;
    plm_rest r;
    r.high = s;
    r.less = -(first * plm_asin_series(z));
    return r;
}

PLM_FUNCTION plm_rest plm_near_one(plm_real a) {
    const plm_real z = PLM_C(0.5) * (PLM_C(1.0) - a);
    const plm_real s = plm_sqrt(z);
    const plm_rest square = plm_product(s, s);
    const plm_real error = (s > PLM_C(0.0)) ? (((square.high - z) - square.less) / (s + s)) : PLM_C(0.0);
    const plm_real first = s * z, most = first * plm_asin_series(z);
    plm_rest r;
    r.high = s;
    r.less = error - most;
    return r;
}

PLM_FUNCTION plm_real plm_asin(plm_real x) {
    const plm_real a = plm_abs(x);
    if (a <= PLM_C(0.5)) {
        const plm_rest r = plm_near_zero(a);
        return plm_copysign(r.high - r.less, x);
    }
    return (a <= PLM_C(1.0)) ? plm_copysign(plm_plus(plm_eighths(2), PLM_C(-2.0), plm_near_one(a)), x) : PLM_NAN;
}

PLM_FUNCTION plm_real plm_acos(plm_real x) {
    const plm_real a = plm_abs(x);
    if (a <= PLM_C(0.5)) {
        return plm_plus(plm_eighths(2), PLM_C(-1.0), plm_near_zero(x));
    }
    if (a <= PLM_C(1.0)) {
        const plm_rest r = plm_near_one(a);
        return (x > PLM_C(0.0)) ? (PLM_C(2.0) * (r.high - r.less)) : plm_plus(plm_eighths(4), PLM_C(-2.0), r);
    }
    return PLM_NAN;
}

#ifdef PLM_SINGLE
#define PLM_LN2_HIGH 0x1.62e4p-1F
#define PLM_LN2_LOW 0x1.7f7d1cp-20F
#define PLM_LOG2_E 0x1.715476p+0F
#define PLM_EXP_BOUND 87.0F
#define PLM_SQRT_2 0x1.6a09e6p+0F
#else
#define PLM_LN2_HIGH 0x1.62e42fefa38p-1
#define PLM_LN2_LOW 0x1.ef35793c7673p-45
#define PLM_LOG2_E 0x1.71547652b82fep+0
#define PLM_EXP_BOUND 708.0
#define PLM_SQRT_2 0x1.6a09e667f3bcdp+0
#endif

PLM_FUNCTION plm_real plm_exp_kernel(plm_real x, int32_t *k) {
#ifdef PLM_SINGLE
    static const plm_real c[PLM_EXP_COUNT] = { 0.5F, 0x1.555552p-3F, 0x1.5554aep-5F, 0x1.111638p-7F, 0x1.6d7c6p-10F,
        0x1.9a88c6p-13F };
#else
    static const plm_real c[PLM_EXP_COUNT] = { 0.5, 0x1.555555555555bp-3, 0x1.5555555555504p-5, 0x1.111111110ec4dp-7,
        0x1.6c16c16c301dep-10, 0x1.a01a01b3846fcp-13, 0x1.a01a013731efbp-16, 0x1.71ddf011b5408p-19, 0x1.27e5b321a6f5ep-22,
        0x1.af6c01bdc5d29p-26, 0x1.1e3ec1fd46bbfp-29 };
#endif
    const plm_real powers = x * PLM_LOG2_E;
    const plm_real sum = powers + PLM_ROUNDER;
    const plm_real whole = sum - PLM_ROUNDER;
    const plm_real most = whole * PLM_LN2_HIGH;
    plm_rest r, w;
    plm_real square, curve, small;
    r.high = x - most;
    r.less = whole * PLM_LN2_LOW;
    r = plm_round_pair(r);
    w = plm_ordered_sum(PLM_C(1.0), r.high);
    square = r.high * r.high;
    curve = square * plm_polynomial(r.high, c, PLM_EXP_COUNT);
    small = r.less * w.high;
    *k = plm_rounded(sum);
    return w.high + (curve - (w.less + small));
}

PLM_FUNCTION plm_real plm_exp(plm_real x) {
    const plm_real far = PLM_EXP_BOUND + PLM_EXP_BOUND;
    int32_t k;
    plm_real y;
    if (plm_abs(x) <= PLM_EXP_BOUND) {
        y = plm_exp_kernel(x, &k);
        return y * plm_power_of_two(k);
    }
    if (x > far) {
        return PLM_INFINITY;
    }
    if (x < -far) {
        return PLM_C(0.0);
    }
    if (plm_abs(x) <= far) {
        int32_t half;
        y = plm_exp_kernel(x, &k);
        half = k / 2;
        return y * plm_power_of_two(half) * plm_power_of_two(k - half);
    }
    return PLM_NAN;
}

PLM_FUNCTION plm_real plm_ln(plm_real x0) {
#ifdef PLM_SINGLE
    static const plm_real c[PLM_LN_COUNT] = { 0x1.55557ap-1F, 0x1.995ed2p-2F, 0x1.31e132p-2F };
#else
    static const plm_real c[PLM_LN_COUNT] = { 0x1.5555555555593p-1, 0x1.999999997f9fap-2, 0x1.249249422a0f2p-2,
        0x1.c71c51d80e067p-3,
        0x1.7466499f1964p-3, 0x1.39a097921ab74p-3, 0x1.2f1166f8c856ap-3 };
#endif
    plm_real x = x0, m, f, k, s, z, square, most, series, part, low, small;
    int32_t shift = 0, e;
    plm_rest sum;
    if (!(x > PLM_C(0.0))) {
        return (x >= PLM_C(0.0)) ? -PLM_INFINITY : PLM_NAN;
    }
    if (x >= PLM_INFINITY) {
        return x;
    }
    if (plm_to_bits(x) <= PLM_FRACTION) {
        x = x * plm_power_of_two(PLM_DIGITS);
        shift = -PLM_DIGITS;
    }
    m = plm_significand(x);
    e = plm_exponent(x) + shift;
    if (m > PLM_SQRT_2) {
        f = PLM_C(0.5) * m;
        f = f - PLM_C(1.0);
        e = e + 1;
    } else {
        f = m - PLM_C(1.0);
    }
    k = (plm_real)e;
    s = f / (PLM_C(2.0) + f);
    z = s * s;
    square = PLM_C(0.5) * f * f;
    most = k * PLM_LN2_HIGH;
    sum = plm_ordered_sum(most, f);
    series = z * plm_polynomial(z, c, PLM_LN_COUNT);
    part = s * (square + series);
    low = k * PLM_LN2_LOW;
    small = part + (low - sum.less);
    return sum.high - (square - small);
}

#endif
