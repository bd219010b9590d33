#include "given_parameter.hpp"

#include <array>

#include "libration/number/given_number.hpp"

namespace libration::elliptic {

exact_parameter exact_parameter_of(const given_modulus& given) {
    struct arc {
        const char* name;
        const std::string& text;
        exact_parameter (*from)(const rational&);
    };
    const std::array<arc, 3> ways{arc{"modulus k", given.k, &exact_parameter::from_modulus},
                                  {"parameter m", given.m, &exact_parameter::from_parameter},
                                  {"complementary parameter m1", given.m1, &exact_parameter::from_complement}};
    const arc* chosen = nullptr;
    for (const arc& each : ways) {
        if (each.text.empty()) {
            continue;
        }
        if (chosen != nullptr) {
            throw error(error_kind::argument, each.name, each.text,
                        std::string("cannot be combined with the ") + chosen->name);
        }
        chosen = &each;
    }
    if (chosen == nullptr) {
        throw error(error_kind::argument, "modulus", "", "is not given: write k, m or m1");
    }
    const rational value = given_fraction(chosen->name, chosen->text);
    if (value < 0 || value > 1) {
        throw error(error_kind::argument, chosen->name, chosen->text, "is outside [0, 1]");
    }
    return chosen->from(value);
}

exact exact_argument(const std::string& text) {
    exact u = given_number("argument", text);
    if (u.measure == unit::period || u.measure == unit::degree) {
        throw error(error_kind::argument, error_subject::argument, text, "has a unit");
    }
    return u;
}

}  // namespace libration::elliptic
