/* A thousand steps: inputs and a parameter are set on the way, the run is saved and restored. Prints the bits of all outputs. */
#include <inttypes.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include "press.h"

static union {
    double aligned;
    unsigned char bytes[PRESS_SIZE];
} object, saved;

static int check(press *self, int status) {
    if (status != PLM_OK) {
        printf("%d: %s\n", status, press_text(self));
    }
    return status;
}

static int print(press *self) {
    size_t k, count = press_count(PLM_OUTPUT);
    for (k = 0; k < count; k++) {
        double value;
        uint64_t bits;
        if (check(self, press_get(self, PLM_OUTPUT, k, &value))) {
            return 1;
        }
        memcpy(&bits, &value, sizeof bits);
        printf("%016" PRIx64 "%s", bits, k + 1 < count ? " " : "\n");
    }
    return 0;
}

int main(void) {
    press *self = (press *)&object;
    int k;
    if (press_size() != PRESS_SIZE || PRESS_ALIGN > sizeof(double)) {
        return 1;
    }
    if (press_init(&object, sizeof object) || check(self, press_start(self))) {
        return 1;
    }
    for (k = 0; k < 1000; k++) {
        if (k == 300 && check(self, press_set(self, PLM_INPUT, PRESS_INPUT_PUSH, -7.5))) {
            return 1;
        }
        if (k == 500 && check(self, press_set(self, PLM_PARAMETER, PRESS_PARAMETER_STIFF, 350.0))) {
            return 1;
        }
        if (k == 600) {
            saved = object;
        }
        if (k == 700) {
            /* What came since is forgotten, and comes again with the same bits. */
            object = saved;
            if (check(self, press_step(self, 0.1))) {
                return 1;
            }
            object = saved;
            for (k = 600; k < 700; k++) {
                if (check(self, press_step(self, 0.001))) {
                    return 1;
                }
            }
        }
        if (check(self, press_step(self, 0.001)) || print(self)) {
            return 1;
        }
    }
    return 0;
}
