#include "libration/scalar/convert.hpp"

namespace libration {

integer nearest_integer(const rational& q) {
    const rational twice = q * 2;
    integer floor_of_twice = numerator(twice) / denominator(twice);
    if (twice < 0 && rational(floor_of_twice) != twice) {
        --floor_of_twice;
    }
    // q in [f/2, (f+1)/2): nearest is f/2 for even f, (f+1)/2 for odd f above the tie; a tie is an odd exact 2q.
    if (floor_of_twice % 2 == 0) {
        return floor_of_twice / 2;
    }
    const integer above = (floor_of_twice + 1) / 2;
    const bool tie = rational(floor_of_twice) == twice;
    return tie && above % 2 != 0 ? integer(above - 1) : above;
}

}  // namespace libration
