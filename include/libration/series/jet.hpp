// The value and the first derivative of a function at one point.
#pragma once

namespace libration {

template <class T>
struct jet {
    T value;
    T slope;
};

}  // namespace libration
