/* Start-up code of Cortex-M and RISC-V under QEMU, with semihosting; the stack is filled so that its use can be read. */
#include <stddef.h>
#include <stdint.h>

extern uint32_t _data_from[], _data[], _data_end[], _bss_end[], _stack[];
int main(void);
void board_say(const char *text);
size_t board_stack(void);
void board_begin(void);

#define FILLED UINT32_C(0xa5a5a5a5)

#if defined(__arm__)
static uintptr_t ask(uintptr_t what, uintptr_t with)
{
    register uintptr_t r0 __asm__("r0") = what;
    register uintptr_t r1 __asm__("r1") = with;
    __asm__ volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory");
    return r0;
}
__attribute__((section(".vectors"), used)) static void *const vectors[2] = { _stack, (void *)board_begin };
#else
static uintptr_t ask(uintptr_t what, uintptr_t with)
{
    register uintptr_t a0 __asm__("a0") = what;
    register uintptr_t a1 __asm__("a1") = with;
    __asm__ volatile(".balign 16\n.option push\n.option norvc\nslli x0, x0, 0x1f\nebreak\nsrai x0, x0, 7\n.option pop"
                     : "+r"(a0) : "r"(a1) : "memory");
    return a0;
}
__attribute__((section(".vectors"), used, naked)) void _begin(void)
{
    __asm__ volatile("la sp, _stack\nj board_begin");
}
#endif

void *memcpy(void *to, const void *from, size_t count);
void *memset(void *to, int value, size_t count);

void *memcpy(void *to, const void *from, size_t count)
{
    volatile unsigned char *at = (volatile unsigned char *)to;
    const unsigned char *own = (const unsigned char *)from;
    while (count-- > 0u) {
        *at++ = *own++;
    }
    return to;
}

void *memset(void *to, int value, size_t count)
{
    volatile unsigned char *at = (volatile unsigned char *)to;
    while (count-- > 0u) {
        *at++ = (unsigned char)value;
    }
    return to;
}

void board_begin(void)
{
    uint32_t here = 0u;
    volatile uint32_t *at;
    const uint32_t *from = _data_from;
#if defined(__ARM_FP)
    /* The floating-point unit is off after a reset. */
    *(volatile uint32_t *)0xe000ed88 |= UINT32_C(0xf) << 20;
    __asm__ volatile("dsb\nisb");
#endif
    for (at = _data; at < _data_end; at++) {
        *at = *from++;
    }
    for (; at < _bss_end; at++) {
        *at = 0u;
    }
    /* Not the part in which this function stands. */
    for (; at < &here - 64; at++) {
        *at = FILLED;
    }
    (void)main();
    /* The end, by itself: of 32 bits this is the reason itself. */
    (void)ask(0x18u, 0x20026u);
    for (;;) {
    }
}

void board_say(const char *text)
{
    (void)ask(4u, (uintptr_t)text);
}

size_t board_stack(void)
{
    const volatile uint32_t *at = _bss_end;
    while (*at == FILLED) {
        at++;
    }
    return (size_t)((uintptr_t)_stack - (uintptr_t)at);
}
