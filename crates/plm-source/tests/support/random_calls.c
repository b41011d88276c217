/* A hundred thousand random calls of a source, half of them with special numbers: nothing that C leaves undefined may happen. */
#include <stdio.h>
#include <string.h>

#include HEADER

/* splitmix64 (G. L. Steele, D. Lea, C. H. Flood, OOPSLA 2014). */
static uint64_t state = 7;

static uint64_t word(void)
{
    uint64_t z;
    state += 0x9E3779B97F4A7C15u;
    z = state;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return z ^ (z >> 31);
}

static double number(void)
{
    const uint64_t bits = word();
    double any;
    switch (word() % 4) {
    case 0:
        return (word() % 2 == 0) ? 0.0 : 1.0;
    case 1:
        memcpy(&any, &bits, sizeof any);
        return any;
    case 2:
        return ((double)bits / 18446744073709551616.0 - 0.5) * 4.0;
    default:
        return ((double)bits / 18446744073709551616.0 - 0.5) * 1e6;
    }
}

int main(void)
{
    NAME self;
    double value, pose[6];
    long k, failed = 0;
    INIT(&self);
    for (k = 0; k < 100000; k++) {
        switch (word() % 6) {
        case 0:
        case 1:
            failed += STEP(&self, (word() % 4 == 0) ? number() : 1e-3) != PLM_OK;
            break;
        case 2:
            (void)GET(&self, (int)(word() % 12) - 1, (size_t)(word() % 40), &value);
            break;
        case 3:
            (void)SET(&self, (int)(word() % 12) - 1, (size_t)(word() % 40), number());
            break;
        case 4:
            (void)POSE(&self, (size_t)(word() % 8), pose);
            break;
        default:
            if (word() % 50 == 0) {
                INIT(&self);
            } else if (word() % 200 == 0) {
                self.x[word() % (sizeof self.x / sizeof self.x[0])] = number();
            }
            (void)TEXT(&self);
            break;
        }
    }
    printf("%ld steps failed\n", failed);
    return 0;
}
