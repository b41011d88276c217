/* A step of a mechanism in an interrupt: what the book's page *In an interrupt* shows. `act` and `read_torque` are of the machine. */
#include "pendulum.h"

float read_torque(void);
void act(float angle);
void stop(void);
void main_loop(void);

/* The object belongs to the interrupt alone; others read copies. */
static pendulum plant;
static volatile float angle;
static volatile int fault;

int begin(void)
{
    if (pendulum_check() != 0) {
        return -1;
    }
    pendulum_init(&plant);
    return 0;
}

void SysTick_Handler(void);
void SysTick_Handler(void)
{
    float now;
    if (fault != PLM_OK) {
        return;
    }
    (void)pendulum_set(&plant, PLM_INPUT, PENDULUM_INPUT_DRIVE, read_torque());
    fault = pendulum_step(&plant, 0.001f);
    if (fault != PLM_OK) {
        /* The object is as it was before the step. */
        stop();
        return;
    }
    (void)pendulum_get(&plant, PLM_OUTPUT, PENDULUM_OUTPUT_BAR_ANGLE, &now);
    angle = now;
    act(now);
}
