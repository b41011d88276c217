// The same header from C++: the names are found, and the run of C++ has the bits of that of C.
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <vector>

#include "press.h"

int main() {
    std::vector<double> memory(press_size() / sizeof(double) + 1);
    press *self = reinterpret_cast<press *>(memory.data());
    std::size_t push = 99;
    if (press_init(memory.data(), memory.size() * sizeof(double)) || press_start(self)) {
        return 1;
    }
    if (press_find(PLM_INPUT, "push", &push) || push != PRESS_INPUT_PUSH) {
        return 1;
    }
    for (int k = 0; k < 300; k++) {
        if (press_step(self, 0.001)) {
            return 1;
        }
        const std::size_t count = press_count(PLM_OUTPUT);
        for (std::size_t j = 0; j < count; j++) {
            double value = 0.0;
            std::uint64_t bits = 0;
            press_get(self, PLM_OUTPUT, j, &value);
            std::memcpy(&bits, &value, sizeof bits);
            std::printf("%016llx%s", static_cast<unsigned long long>(bits), j + 1 < count ? " " : "\n");
        }
    }
    return 0;
}
