// The value and the first derivative of a function at one point.
#pragma once

namespace libration::series {

template <class T>
struct jet {
    T value;
    T slope;
};

}  // namespace libration::series
