// A claim: a statement of the paper in our words, and the measurement that tests it.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "libration/scalar/mpfr.hpp"

namespace libration {

class table;

/// The result of the measurement for a statement.
enum class verdict {
    holds,
    corrected,  ///< holds with the given correction
    fails
};

/// holds | holds with correction | fails.
std::string name_of(verdict v);

/// The outcome of a measurement: the number that decided, and the verdict.
struct finding {
    libration::verdict verdict;
    mpfr number;
};

/// A statement of the paper, or of this program. Its measurement compares with something independent of the statement:
/// the equation itself, a closed form, a second route. The test tests/paper/*_test.cpp "claim NAME: ..." tests it
/// independently.
struct claim {
    std::string name;        ///< an identifier, unique
    std::string label;       ///< \label of the paper's source, or the section and what kind of text;
                             ///< "libration: subject" for our own
    std::string statement;   ///< in our words
    std::string number;      ///< the meaning of the measured number
    std::string correction;  ///< the correct statement, with the smallest counterexample; empty if the claim holds
    std::string command;     ///< a command that shows it
    std::function<finding()> measure;
};

/// All claims in the order of the paper, followed by this program's own.
std::vector<claim> all_claims();

/// The claims of each part of the paper.
std::vector<claim> claims_of_background();                 ///< abstract, sections I and II
std::vector<claim> claims_of_exact_period();               ///< section II, the period and the symmetries
std::vector<claim> claims_of_closed_solutions();           ///< section II, the Jacobi functions
std::vector<claim> claims_of_series();                     ///< section III A, the coefficients
std::vector<claim> claims_of_singularities();              ///< section III B, singularities and radii of libration
std::vector<claim> claims_of_singularities_of_rotation();  ///< the same of rotation
std::vector<claim> claims_of_extension();                  ///< section III C, all times
std::vector<claim> claims_of_resummation();                ///< section IV, the formulas
std::vector<claim> claims_of_resummation_errors();         ///< section IV, the errors
std::vector<claim> claims_of_period();                     ///< section V
std::vector<claim> claims_of_conclusions();                ///< section VI
std::vector<claim> claims_of_scenarios();                  ///< section VI, the three scenarios
std::vector<claim> claims_of_appendix();                   ///< the appendix
std::vector<claim> claims_of_libration();                  ///< the claims of this program, not of the paper

/// Whether a label is that of a claim of this program's own: "libration: ...".
bool is_own(const std::string& label);

/// A tested claim.
struct judged_claim {
    const claim* of;
    finding found;
};

/// Measures all of them with 50 digits on `jobs` threads; the result does not depend on the number of threads. An
/// exception of a measurement is rethrown as std::runtime_error with the claim's name.
std::vector<judged_claim> judge(const std::vector<claim>& claims, int jobs);

/// Columns claim,label,statement,verdict,number,measured,correction,command,severity,printed.
table claims_table(const std::vector<judged_claim>& judged);

}  // namespace libration
