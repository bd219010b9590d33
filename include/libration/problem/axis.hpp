// A named axis along which a problem, or a study of it, can be varied: exact values, their unit and their range.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "libration/number/exact.hpp"

namespace libration {

/// The kind of values of an axis: exact numbers, whole numbers from 0 on, words, or a single exact number.
enum class axis_form { numbers, whole, words, one_number };

/// An axis.
struct axis {
    std::string name;        ///< gap
    std::string option;      ///< --gaps
    std::string help;        ///< a description of its values, for the command line
    std::string forms = {};  ///< what may be written; empty if `form` is complete
    std::string unit = {};   ///< of the values; empty for pure numbers
    axis_form form;
    std::string remedy;  ///< the advice printed for an invalid value
    /// Throws error with the reason why a value (of an axis of words: its text) is outside the range, as
    /// "has '3', which makes the energy negative".
    std::function<void(const exact&)> check = {};
    /// The coordinate that the value represents. Axes of the same coordinate are alternatives: the energy 2 - g can be
    /// given by its gap g. Values of one replace the defaults of the others.
    std::string coordinate;
    /// The value of the coordinate; empty if the axis is its coordinate itself.
    std::function<exact(const exact&)> to_coordinate = {};
    /// The largest value of an axis of whole numbers; 0 for no bound.
    long largest = 0;

    exact coordinate_of(const exact& value) const;
};

/// Values by the name of their axis; words are the text of their value.
class axis_values {
public:
    void set(const std::string& name, std::vector<exact> values) { all_[name] = std::move(values); }
    /// An empty list if the axis has no value.
    const std::vector<exact>& of(const std::string& name) const;
    /// Those of an axis of whole numbers.
    std::vector<integer> whole(const std::string& name) const;
    std::vector<int> counts(const std::string& name) const;
    /// By name.
    const std::map<std::string, std::vector<exact>>& all() const { return all_; }

private:
    std::map<std::string, std::vector<exact>> all_;
};

/// Throws error for a number with a unit: "has '90deg', which is not a decimal or a fraction".
void require_plain_number(const exact& value);

/// A number without unit as a decimal: unchanged if it was given as one, exactly if the decimal terminates, else to
/// `digits` digits. Angles in radians. Throws error for multiples of a period, which are defined only for a motion.
std::string decimal_of(const exact& value, long digits);

/// The same of a fraction.
std::string decimal_of(const rational& value, long digits);

}  // namespace libration
