/* Two mechanisms of one library: the crank of the press turns the arm, which runs with a tolerance of its own. Prints the bits of
   its angle. */
#include <inttypes.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include "arm.h"
#include "press.h"

int main(void) {
    static double of_press[PRESS_SIZE / sizeof(double)], of_arm[ARM_SIZE / sizeof(double)];
    press *first = (press *)of_press;
    arm *second = (arm *)of_arm;
    int k;
    if (press_init(of_press, sizeof of_press) || arm_init(of_arm, sizeof of_arm) || press_start(first)) {
        return 1;
    }
    if (arm_set_tolerance(second, 0.0) != PLM_CHOICE || arm_set_tolerance(second, 0.5) != PLM_CHOICE ||
        arm_set_longest_step(second, -1.0) != PLM_CHOICE) {
        return 1;
    }
    /* Before the start, and while it runs. */
    if (arm_set_tolerance(second, 1e-5) || arm_start(second) || arm_set_longest_step(second, 0.04)) {
        return 1;
    }
    for (k = 0; k < 100; k++) {
        double angle;
        uint64_t bits;
        if (press_get(first, PLM_OUTPUT, PRESS_OUTPUT_CRANK_ANGLE, &angle) ||
            arm_set(second, PLM_INPUT, ARM_INPUT_TORQUE, 10.0 * angle) || press_step(first, 0.01) ||
            arm_step(second, 0.01) || arm_get(second, PLM_OUTPUT, ARM_OUTPUT_ARM_ANGLE, &angle)) {
            return 1;
        }
        memcpy(&bits, &angle, sizeof bits);
        printf("%016" PRIx64 "\n", bits);
    }
    return 0;
}
