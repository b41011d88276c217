/* An ATmega under simavr: its serial line is the output; the stack is filled so that its use can be read. */
#include <avr/interrupt.h>
#include <avr/io.h>
#include <avr/sleep.h>
#include <stddef.h>
#include <stdint.h>

extern uint8_t _end, __stack;
int run(void);
void board_say(const char *text);
size_t board_stack(void);

#define FILLED 0xa5

void fill(void) __attribute__((naked, used, section(".init3")));
void fill(void)
{
    uint8_t *at = &_end;
    while (at < &__stack) {
        *at++ = FILLED;
    }
}

void board_say(const char *text)
{
    UCSR0B = _BV(TXEN0);
    for (; *text != '\0'; text++) {
        while ((UCSR0A & _BV(UDRE0)) == 0) {
        }
        UDR0 = (uint8_t)*text;
    }
}

size_t board_stack(void)
{
    const uint8_t *at = &_end;
    while (*at == FILLED) {
        at++;
    }
    return (size_t)(&__stack - at);
}

int main(void)
{
    (void)run();
    cli();
    sleep_enable();
    sleep_cpu();
    return 0;
}
