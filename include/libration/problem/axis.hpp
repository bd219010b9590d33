// A named axis along which a problem, or a study of it, can be varied: exact values, their unit and their range.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "libration/scalar/exact.hpp"

namespace libration {

/// What the values of an axis are: exact numbers, whole numbers from 0 on, words, or a single exact number.
enum class axis_form { numbers, whole, words, one_number };

/// An axis.
struct axis {
    std::string name;    ///< gap
    std::string option;  ///< --gaps
    std::string help;    ///< what its values are, for the command line
    std::string unit;    ///< of the values; empty for pure numbers
    axis_form form;
    std::string remedy;  ///< what to write instead of what was wrong
    /// Throws error saying why a value (of an axis of words: its text) is outside the range, as
    /// "has '3', which makes the energy negative".
    std::function<void(const exact&)> check;
    /// The coordinate that the value stands for. Axes of the same coordinate are ways to say the same: the energy 2 - g
    /// by its gap g. Values of one put the usual ones of the others aside.
    std::string coordinate;
    /// The value of the coordinate; empty where the axis is its coordinate itself.
    std::function<exact(const exact&)> to_coordinate;
    /// The largest value of an axis of whole numbers; 0 for no bound.
    long largest = 0;

    exact coordinate_of(const exact& value) const;
};

/// Values by the name of their axis; words stand in the text of their value.
class axis_values {
public:
    void set(const std::string& name, std::vector<exact> values) { all_[name] = std::move(values); }
    /// Nothing where the axis has no value.
    const std::vector<exact>& of(const std::string& name) const;
    /// Those of an axis of whole numbers.
    std::vector<integer> whole(const std::string& name) const;
    std::vector<int> counts(const std::string& name) const;
    /// By name.
    const std::map<std::string, std::vector<exact>>& all() const { return all_; }

private:
    std::map<std::string, std::vector<exact>> all_;
};

/// Throws error for what has a unit: "has '90deg', which is not a decimal or a fraction".
void require_plain_number(const exact& value);

/// A number without unit as a decimal: as it was typed where that is one, exactly where a decimal ends, else to
/// `digits` digits. Angles in radians. Throws error for multiples of a period, which only a motion knows.
std::string decimal_of(const exact& value, long digits);

/// The same of a fraction.
std::string decimal_of(const rational& value, long digits);

}  // namespace libration
