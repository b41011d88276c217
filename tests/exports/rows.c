/* The block of tests/snapshots/bouncer.plm every 10 ms, pushed from 1 s to 2 s: a line for each output. */
#include <stdio.h>

#include "bouncer.h"

int main(void) {
    static double memory[BOUNCER_SIZE / sizeof(double)];
    bouncer *self = (bouncer *)memory;
    double place;
    int k;

    if (bouncer_init(memory, sizeof memory) || bouncer_start(self)) {
        return 1;
    }
    for (k = 1; k <= 500; k++) {
        bouncer_set(self, PLM_INPUT, BOUNCER_INPUT_PUSH, k > 100 && k <= 200 ? 1.5 : 0.0);
        if (bouncer_step(self, 0.01)) {
            fprintf(stderr, "%s\n", bouncer_text(self));
            return 1;
        }
        bouncer_get(self, PLM_OUTPUT, BOUNCER_OUTPUT_BLOCK_X, &place);
        printf("%.17g\n", place);
    }
    return 0;
}
