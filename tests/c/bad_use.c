/* Every wrong call gives a code with a text and changes nothing. Prints what it got. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "press.h"

static void tell(const char *what, int status) {
    printf("%s: %d %s\n", what, status, press_status_text(status));
}

int main(void) {
    size_t size = press_size(), index;
    unsigned char *memory = malloc(size + 16), *copy = malloc(size);
    press *self = (press *)memory;
    double value, pose[6], room[100];
    char name[4];
    if (!memory || !copy) {
        return 1;
    }
    memset(memory, 0xa5, size + 16);
    tell("null memory", press_init(NULL, size));
    tell("small memory", press_init(memory, size - 1));
    tell("memory that is not aligned", press_init(memory + 1, size));
    tell("no object", press_step(self, 0.1));
    tell("null object", press_step(NULL, 0.1));
    tell("object that is not aligned", press_start((press *)(memory + 4)));
    printf("text of no object: \"%s\" \"%s\"\n", press_text(NULL), press_text(self));
    tell("init", press_init(memory, size));
    tell("step before start", press_step(self, 0.1));
    printf("text: %s\n", press_text(self));
    tell("time before start", press_time(self, &value));
    tell("input before start", press_set(self, PLM_INPUT, 0, 1.0));
    tell("rates before start", press_rates(self, room, press_count(PLM_RATE)));
    tell("linearisation before start", press_linearise(self, PLM_A, room, 4));
    tell("start at NaN", press_start_at(self, NAN));
    tell("start", press_start(self));
    tell("step", press_step(self, 0.1));
    memcpy(copy, memory, size);
    tell("step back", press_step(self, -0.1));
    printf("text: %s\n", press_text(self));
    tell("step to the past", press_step_to(self, 0.05));
    tell("step of NaN", press_step(self, NAN));
    tell("step without end", press_step_to(self, INFINITY));
    tell("input of NaN", press_set(self, PLM_INPUT, PRESS_INPUT_PUSH, NAN));
    tell("parameter without bound", press_set(self, PLM_PARAMETER, 0, INFINITY));
    tell("parameter beyond the last", press_set(self, PLM_PARAMETER, 1000, 1.0));
    tell("output that is set", press_set(self, PLM_OUTPUT, 0, 1.0));
    tell("output beyond the last", press_get(self, PLM_OUTPUT, (size_t)-1, &value));
    tell("kind that is none", press_get(self, 77, 0, &value));
    tell("null for a value", press_get(self, PLM_OUTPUT, 0, NULL));
    tell("null for a time", press_time(self, NULL));
    tell("null for a pose", press_pose(self, 0, NULL));
    tell("body beyond the last", press_pose(self, 3, pose));
    tell("rate that is set", press_set(self, PLM_RATE, 0, 1.0));
    tell("rate beyond the last", press_get(self, PLM_RATE, 99, &value));
    tell("null for rates", press_rates(self, NULL, press_count(PLM_RATE)));
    tell("room for more rates", press_rates(self, room, press_count(PLM_RATE) + 1));
    tell("null for directions", press_directions(self, NULL));
    tell("matrix that is none", press_linearise(self, 5, room, 1));
    tell("null for a matrix", press_linearise(self, PLM_A, NULL, 9));
    tell("room for another matrix", press_linearise(self, PLM_A, room, 10));
    tell("method that is none", press_set_method(self, -1));
    tell("method that the library does not have", press_set_method(self, PLM_RK4));
    tell("null object for a matrix", press_linearise(NULL, PLM_A, room, 9));
    tell("unknown name", press_find(PLM_OUTPUT, "no such", &index));
    tell("null name", press_find(PLM_OUTPUT, NULL, &index));
    tell("null index", press_find(PLM_PARAMETER, "stiff", NULL));
    tell("name that is cut off", press_name(PLM_PARAMETER, 0, name, sizeof name));
    printf("name: %s\n", name);
    tell("no room for a name", press_name(PLM_PARAMETER, 0, name, 0));
    tell("mass that is negative", press_set(self, PLM_PARAMETER, PRESS_PARAMETER_LOAD, -1.0));
    tell("step with it", press_step(self, 0.1));
    printf("text: %s\n", press_text(self));
    tell("start with it", press_start(self));
    tell("mass as it was", press_set(self, PLM_PARAMETER, PRESS_PARAMETER_LOAD, 0.5));
    tell("start value that cannot be", press_set(self, PLM_START, PRESS_START_CRANK_X, 50.0));
    tell("requirement", press_step(self, 100.0));
    printf("text: %s\n", press_text(self));
    /* Whatever was refused, it goes on as the copy does that saw nothing of it. */
    tell("after all", press_step(self, 0.1));
    tell("the copy", press_step((press *)copy, 0.1));
    for (index = 0; index < press_count(PLM_OUTPUT); index++) {
        double other;
        press_get(self, PLM_OUTPUT, index, &value);
        press_get((press *)copy, PLM_OUTPUT, index, &other);
        if (memcmp(&value, &other, sizeof value)) {
            printf("output %lu differs\n", (unsigned long)index);
        }
    }
    press_time(self, &value);
    printf("time: %g\n", value);
    free(memory);
    free(copy);
    return 0;
}
