// How a mechanism runs, chosen by the classes of C++. Prints matrices of a linearisation, then the bits of two runs.
#include <cstdint>
#include <cstdio>
#include <cstring>

#include "acme_press.hpp"
#include "press.hpp"
#include "single_press.hpp"

static unsigned long long bits(double number) {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &number, sizeof bits);
    return bits;
}

static bool throws(plm::AcmePress &object, int status) {
    try {
        object.step(-1.0);
    } catch (const plm::Error &error) {
        return error.status() == status && std::strlen(error.what()) > 0;
    }
    return false;
}

int main() {
    plm::Press press;
    press.start_at(1.5);
    const plm::Linear<double> linear = press.linearise();
    if (press.rates().size() != linear.integrated || linear.a.size() != linear.states * linear.states) {
        return 1;
    }
    for (double entry : linear.a) {
        std::printf("%.9e\n", entry);
    }
    for (double entry : linear.b) {
        std::printf("%.9e\n", entry);
    }

    plm::AcmePress alone, stiff;
    if (!throws(alone, PLM_NOT_STARTED)) {
        return 2;
    }
    alone.set(ACME_PRESS_PARAMETER_STIFF, 50.0);
    stiff = alone;
    alone.start_at(0.5);
    stiff.set_method(PLM_RADAU_IIA5);
    stiff.set_tolerance(1e-7);
    stiff.start_at(0.5);
    if (!throws(stiff, PLM_INTERVAL)) {
        return 3;
    }
    for (int k = 0; k < 50; k++) {
        if (k == 20) {
            // Saved, and gone on with in another object.
            plm::AcmePress other;
            other.restore(stiff.save());
            stiff = other;
        }
        alone.step_linearly_implicit(0.01);
        stiff.step(0.01);
        std::printf("%016llx %016llx\n", bits(alone.get(ACME_PRESS_OUTPUT_CART_X)), bits(stiff.pose(0).x));
    }
    if (plm::AcmePress::name(PLM_RATE, 0) != "rail.displacement" || alone.time() < 0.99) {
        return 4;
    }
    try {
        stiff.set_method(PLM_VERN9);
        return 5;
    } catch (const plm::Error &error) {
        if (error.status() != PLM_CHOICE) {
            return 6;
        }
    }
    plm::SinglePress single;
    single.start();
    const float before = single.get(SINGLE_PRESS_OUTPUT_CART_X);
    single.step_rk4(0.01f);
    return single.get(SINGLE_PRESS_OUTPUT_CART_X) != before ? 0 : 7;
}
