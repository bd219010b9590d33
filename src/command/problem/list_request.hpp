// The request of `libration series`.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "libration/number/exact.hpp"

namespace libration {

/// How a list becomes a value, apart from the verdict of all methods.
enum class list_method { series, pade, endpoint };

/// series | pade | endpoint.
std::string name_of(list_method method);

/// What the values are compared with: nothing, one for each time.
using reference_values = std::vector<exact>;

/// A list of coefficients, where to evaluate it, how, and the reference values.
struct list_request {
    std::vector<exact> coefficients;  ///< a_0 .. a_N
    long digits;                      ///< to print
    std::vector<exact> times;
    bool verdict;  ///< whether the value with an uncertainty is requested, too
    std::vector<list_method> methods;
    std::optional<exact> end;    ///< the other end of endpoint approximants
    std::vector<exact> at_end;   ///< f, f', f'', ... there
    reference_values reference;  ///< empty, or one a time
    /// Significant digits of the decimals, 0 if they are exact; as they are written unless given.
    std::optional<long> rounded = std::nullopt;

    int order() const { return static_cast<int>(coefficients.size()) - 1; }
};

/// As the options have it.
struct list_words {
    std::string file;
    std::optional<std::string> order, times, method, end, at_end, reference;
};

/// Throws input_error.
list_request list_request_of(const list_words& words, long digits);

}  // namespace libration
