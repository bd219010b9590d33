#include "libration/number/two_proofs.hpp"

#include <stdexcept>

#include "libration/number/exact.hpp"

namespace libration {

namespace {

rational fraction_of(const std::string& decimal) { return read_exact(decimal).coefficient; }

bool at_most(const std::string& a, const std::string& b) {
    return b == "inf" || (a != "inf" && fraction_of(a) <= fraction_of(b));
}

std::string enclosure_text(const proved_decimal& x) { return x.text + " +- " + x.uncertainty; }

}  // namespace

bool enclosures_meet(const proved_decimal& first, const proved_decimal& second) {
    const rational distance = abs(rational(fraction_of(first.text) - fraction_of(second.text)));
    return distance <= fraction_of(first.uncertainty) + fraction_of(second.uncertainty);
}

void require_agreement(const proved_decimal& first, const proved_decimal& second, const std::string& what) {
    if (!enclosures_meet(first, second)) {
        throw std::runtime_error("the two proofs disagree on " + what + ": " + enclosure_text(first) +
                                 " by the first, " + enclosure_text(second) + " by the second");
    }
}

bool intervals_meet(const std::string& lower, const std::string& upper, const std::string& other_lower,
                    const std::string& other_upper) {
    return at_most(lower, other_upper) && at_most(other_lower, upper);
}

}  // namespace libration
