// The arguments of an elliptic function, in the cells of a row.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "table/complex_argument.hpp"
#include "table/elliptic_values.hpp"
#include "text/column_names.hpp"

namespace libration {

/// The columns of one function: k, m, m1, or the modular angle as alpha (a number of radians, or with a unit, 30deg) or
/// alpha_deg (a number of degrees), of theta functions q, its argument u, phi, x or z, and the characteristic n
/// of Pi. Complex arguments of the functions that support them are in u as typed, 1+2i, or in u_re and u_im.
class elliptic_columns {
public:
    /// The quantities, for column_names.
    static std::vector<known_column> known();
    /// Whether there is a modulus.
    static bool has_modulus(const column_names& names);
    /// Throws input_error for a column that is missing, and for two moduli.
    elliptic_columns(const column_names& names, const elliptic::named_function& function);

    /// k, m, m1, alpha, alpha_deg or q.
    const std::string& modulus() const { return modulus_; }
    bool has_argument() const { return argument_.has_value(); }
    /// Throws error of the name of a column. The numbers as typed, or the doubles nearest to them.
    elliptic_point read(const std::vector<std::string>& cells, bool as_doubles = false) const;

private:
    void find_modulus();
    void find_argument();
    complex_argument argument_in(const std::vector<std::string>& cells, bool as_double) const;
    exact modulus_in(const std::vector<std::string>& cells, bool as_double) const;
    exact number_in(const std::vector<std::string>& cells, std::size_t at, bool as_double) const;

    const column_names* names_;
    const elliptic::named_function* function_;
    std::string modulus_;
    std::size_t modulus_at_ = 0;
    std::optional<std::size_t> argument_, imaginary_, characteristic_;
};

}  // namespace libration
