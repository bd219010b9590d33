// The studies audit_boost and audit_gsl: our own double holds its promise, and the judge's numbers agree with each
// other.
#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "studies/study_rows.hpp"

namespace studies_audit_test {

using namespace libration;
using namespace libration::tests;

namespace {

const std::vector<std::string>& audits() {
    static const std::vector<std::string> both{"audit_boost", "audit_gsl"};
    return both;
}

// The library that an audit judges beside ours.
std::string judged_by(const std::string& audit) { return audit == "audit_boost" ? "boost" : "gsl"; }

}  // namespace

TEST_CASE("our double is within 4 units of max(1, |theta|) at every exact gap", "[studies][audit]") {
    const precision_scope scope(40);
    std::size_t ours = 0;
    for (const table_row& row : rows_of_study("audit_boost", {})) {
        if (row.at("library") == "libration") {
            ++ours;
            INFO("gap " << row.at("gap") << ", t = " << row.at("time"));
            CHECK(number_of(row.at("error_ulp")) <= 4);  // the promise of the issue
            CHECK(row.at("input_ulp") == "0");
        }
    }
    CHECK(ours == 46 * 5);
}

TEST_CASE("what a library loses is at most what it was not told and what it lost itself", "[studies][audit]") {
    const precision_scope scope(40);
    for (const std::string& audit : audits()) {
        for (const table_row& row : rows_of_study(audit, {{"--gaps", "1,1e-5,1e-15"}, {"--times", "0.7,3T/16"}})) {
            INFO(audit << ", gap " << row.at("gap") << ", t = " << row.at("time") << ", " << row.at("library"));
            const mpfr error = number_of(row.at("error_ulp"));
            const mpfr told = number_of(row.at("input_ulp"));
            const mpfr own = number_of(row.at("own_ulp"));
            const mpfr printed = mpfr("1e-5");  // six digits of each
            CHECK(error <= (told + own) * (1 + printed));
            CHECK(error >= abs(told - own) - (told + own) * printed);
            // k is off by 2^-54 relative at most, so E = 2 k^2 by 2^-53: half a unit. At 1e-15 that is 0.2 of the gap,
            // and the condition changes by as much itself.
            if (row.at("library") != "libration") {
                CHECK(told <= number_of(row.at("condition")));
            }
        }
    }
}

TEST_CASE("errors and digits of an audit follow from its theta and its reference", "[studies][audit]") {
    const precision_scope scope(40);
    for (const std::string& audit : audits()) {
        for (const table_row& row : rows_of_study(audit, {{"--gaps", "0.29,1e-9"}, {"--times", "10,T/8"}})) {
            INFO(audit << ", gap " << row.at("gap") << ", t = " << row.at("time") << ", " << row.at("library"));
            const mpfr reference = number_of(row.at("reference"));
            const mpfr error = abs(number_of(row.at("theta")) - reference);
            const mpfr size = abs(reference) < 1 ? mpfr(1) : mpfr(abs(reference));
            // theta is printed with 17 digits, up to 5e-17 of it off what the double is; the error with six digits.
            CHECK(abs(error - number_of(row.at("error"))) < size * mpfr("6e-17") + error * mpfr("1e-5"));
            const mpfr digits = -log10(number_of(row.at("error")) / size);
            CHECK(abs(digits - number_of(row.at("correct_digits"))) < mpfr("0.006"));
        }
    }
}

TEST_CASE("both libraries are right far from the separatrix and not next to it", "[studies][audit]") {
    const precision_scope scope(40);
    for (const std::string& audit : audits()) {
        for (const table_row& row : rows_of_study(audit, {{"--gaps", "1,1e-15"}, {"--times", "T/8"}})) {
            if (row.at("library") == judged_by(audit)) {
                INFO(audit << ", gap " << row.at("gap"));
                CHECK((number_of(row.at("correct_digits")) > 15) == (row.at("gap") == "1"));
                CHECK((number_of(row.at("correct_digits")) < 6) == (row.at("gap") == "1e-15"));
            }
        }
    }
}

TEST_CASE("an audit refuses energies that have no modulus below 1", "[studies][audit]") {
    CHECK_THROWS_AS(rows_of_study("audit_boost", {{"--gaps", "-1e-3"}}), libration::error);
    CHECK_THROWS_AS(rows_of_study("audit_boost", {{"--energies", "2"}}), libration::error);
    CHECK_THROWS_AS(rows_of_study("audit_boost", {{"--energies", "0"}}), libration::error);
}

}  // namespace studies_audit_test
