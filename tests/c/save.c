/* Saves a run to a file and goes on: `save FILE`. Goes on from it in a process of its own: `save FILE go`. Prints the bits of
   the outputs after that. */
#include <inttypes.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "press.h"

static int go_on(press *self) {
    int k;
    for (k = 0; k < 200; k++) {
        double value;
        uint64_t bits;
        if (press_step(self, 0.001) || press_get(self, PLM_OUTPUT, PRESS_OUTPUT_CRANK_ANGLE, &value)) {
            printf("%s\n", press_text(self));
            return 1;
        }
        memcpy(&bits, &value, sizeof bits);
        printf("%016" PRIx64 "\n", bits);
    }
    return 0;
}

static int fails(press *self, int status) {
    if (status) {
        printf("%d: %s\n", status, press_text(self));
    }
    return status;
}

int main(int count, char **words) {
    static double memory[PRESS_SIZE / sizeof(double)];
    static unsigned char bytes[100000];
    press *self = (press *)memory;
    size_t size;
    FILE *file;
    if (count < 2 || press_init(memory, sizeof memory)) {
        return 1;
    }
    if (count > 2) {
        file = fopen(words[1], "rb");
        if (!file) {
            return 1;
        }
        size = fread(bytes, 1, sizeof bytes, file);
        fclose(file);
        bytes[size / 2] ^= 1;
        if (press_restore(self, bytes, size) != PLM_DAMAGED || press_step(self, 0.1) != PLM_NOT_STARTED) {
            return 1;
        }
        bytes[size / 2] ^= 1;
        return fails(self, press_restore(self, bytes, size)) || go_on(self);
    }
    if (fails(self, press_start(self)) || fails(self, press_set(self, PLM_INPUT, PRESS_INPUT_PUSH, -7.5)) ||
        fails(self, press_step(self, 0.3)) || fails(self, press_saved_size(self, &size)) || size > sizeof bytes ||
        press_save(self, bytes, size - 1) != PLM_MEMORY || fails(self, press_save(self, bytes, size))) {
        return 1;
    }
    file = fopen(words[1], "wb");
    if (!file || fwrite(bytes, 1, size, file) != size || fclose(file)) {
        return 1;
    }
    return go_on(self);
}
