/* Libraries of two suppliers in one program, who both have a mechanism `Press`; one of them in single precision too. Prints the
   bits of where they are. */
#include <inttypes.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include "acme_press.h"
#include "press.h"
#include "single_press.h"

int main(void) {
    static double of_first[PRESS_SIZE / sizeof(double)], of_second[ACME_PRESS_SIZE / sizeof(double)],
        of_third[SINGLE_PRESS_SIZE / sizeof(double) + 1];
    press *first = (press *)of_first;
    acme_press *second = (acme_press *)of_second;
    single_press *third = (single_press *)of_third;
    int k;
    if (press_init(of_first, sizeof of_first) || acme_press_init(of_second, sizeof of_second) ||
        single_press_init(of_third, sizeof of_third) || press_start(first) || single_press_start(third)) {
        return 1;
    }
    /* A step by itself looks at its object as all functions do. */
    if (single_press_step_rk4(NULL, 0.01f) != PLM_NULL_POINTER ||
        single_press_step_rk4((single_press *)of_second, 0.01f) != PLM_NO_OBJECT ||
        single_press_step_rk4(third, -0.01f) == PLM_OK) {
        return 1;
    }
    /* Its usual method is the classical one of Runge and Kutta. */
    if (acme_press_set_longest_step(second, 1e-3) || acme_press_start_at(second, 2.5)) {
        return 1;
    }
    for (k = 0; k < 100; k++) {
        double angle, place;
        float single;
        uint64_t bits[2];
        uint32_t short_bits;
        if (press_get(first, PLM_OUTPUT, PRESS_OUTPUT_CRANK_ANGLE, &angle) ||
            acme_press_set(second, PLM_INPUT, ACME_PRESS_INPUT_PUSH, 10.0 * angle) ||
            single_press_set(third, PLM_INPUT, SINGLE_PRESS_INPUT_PUSH, (float)angle) || press_step(first, 0.01) ||
            acme_press_step(second, 0.01) || single_press_step_rk4(third, 0.01f) ||
            press_get(first, PLM_OUTPUT, PRESS_OUTPUT_CRANK_ANGLE, &angle) ||
            acme_press_get(second, PLM_OUTPUT, ACME_PRESS_OUTPUT_CART_X, &place) ||
            single_press_get(third, PLM_OUTPUT, SINGLE_PRESS_OUTPUT_CART_X, &single)) {
            return 1;
        }
        memcpy(&bits[0], &angle, sizeof angle);
        memcpy(&bits[1], &place, sizeof place);
        memcpy(&short_bits, &single, sizeof single);
        printf("%016" PRIx64 " %016" PRIx64 " %08" PRIx32 "\n", bits[0], bits[1], short_bits);
    }
    return 0;
}
