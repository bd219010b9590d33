// What a claim is: a statement of the paper in our words, and the measurement that judges it.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "libration/scalar/mpfr.hpp"

namespace libration {

class table;

/// What the measurement says of a statement.
enum class verdict {
    holds,
    corrected,  ///< holds with the correction that stands beside it
    fails
};

/// holds | holds with correction | fails.
std::string name_of(verdict v);

/// The outcome of a measurement: the number that decided, and what it decided.
struct finding {
    libration::verdict verdict;
    mpfr number;
};

/// A statement of the paper, or one of our own. Its measurement compares with something independent of the statement:
/// the equation itself, a closed form, a second route. The test tests/paper/*_test.cpp "claim NAME: ..." judges it
/// again in its own words.
struct claim {
    std::string name;        ///< an identifier, unique
    std::string label;       ///< \label of the paper's source, or the section and what kind of text;
                             ///< "libration: subject" for our own
    std::string statement;   ///< in our words
    std::string number;      ///< what the measured number is
    std::string correction;  ///< what is true instead, with the smallest counterexample; empty where it holds
    std::string command;     ///< shows it
    std::function<finding()> measure;
};

/// All claims in the order of the paper, this program's own behind them.
std::vector<claim> all_claims();

/// The claims of each part of the paper.
std::vector<claim> claims_of_background();          ///< abstract, sections I and II
std::vector<claim> claims_of_exact_period();        ///< section II, the period and the symmetries
std::vector<claim> claims_of_closed_solutions();    ///< section II, the Jacobi functions
std::vector<claim> claims_of_series();              ///< section III A, the coefficients
std::vector<claim> claims_of_singularities();       ///< section III B, singularities and radii
std::vector<claim> claims_of_extension();           ///< section III C, all times
std::vector<claim> claims_of_resummation();         ///< section IV, the formulas
std::vector<claim> claims_of_resummation_errors();  ///< section IV, the errors
std::vector<claim> claims_of_period();              ///< section V
std::vector<claim> claims_of_conclusions();         ///< section VI
std::vector<claim> claims_of_appendix();            ///< the appendix
std::vector<claim> claims_of_libration();           ///< none of the paper's: what this program claims itself

/// Whether a label is that of a claim of this program's own: "libration: ...".
bool is_own(const std::string& label);

/// A judged claim.
struct judged_claim {
    const claim* of;
    finding found;
};

/// Measures all of them with 50 digits on `jobs` threads; the result does not depend on how many. A measurement that
/// throws is passed on as std::runtime_error with the claim's name.
std::vector<judged_claim> judge(const std::vector<claim>& claims, int jobs);

/// Columns claim,label,statement,verdict,number,measured,correction,command.
table claims_table(const std::vector<judged_claim>& judged);

}  // namespace libration
