/* Steps of a C source on a board: what its check says, a number of all bits of all states, bytes of the object and of the stack.
   NAME is the mechanism, HEADER its header, STEPS how many steps of 1 ms are made. */
#include <string.h>

#include HEADER

#define JOINED(name, what) name##what
#define OF(name, what) JOINED(name, what)
#define MECHANISM NAME

/* Of a board: text to the host, and the end. */
void board_say(const char *text);
size_t board_stack(void);

static uint32_t digest(uint32_t hash, const void *bytes, size_t count)
{
    const unsigned char *at = (const unsigned char *)bytes;
    size_t k;
    for (k = 0u; k < count; k++) {
        hash = (uint32_t)((hash ^ at[k]) * UINT32_C(16777619));
    }
    return hash;
}

static void say(const char *what, uint32_t number)
{
    char text[12];
    int k = 11;
    text[k] = '\0';
    do {
        k--;
        text[k] = (char)('0' + (char)(number % 10u));
        number /= 10u;
    } while (number > 0u);
    board_say(what);
    board_say(&text[k]);
}

static MECHANISM self;

int main(void)
{
    uint32_t hash = UINT32_C(2166136261);
    int k, status = 0;
    say("check ", (uint32_t)OF(NAME, _check)());
    OF(NAME, _init)(&self);
    for (k = 0; (k < STEPS) && (status == 0); k++) {
        status = OF(NAME, _step)(&self, (REAL)0.0009765625);
        hash = digest(hash, self.x, sizeof self.x);
    }
    say(" steps ", (uint32_t)k);
    say(" status ", (uint32_t)status);
    say(" bits ", hash);
    say(" object ", (uint32_t)sizeof self);
    say(" stack ", (uint32_t)board_stack());
    board_say("\n");
    return 0;
}
