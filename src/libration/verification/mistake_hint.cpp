#include "libration/verification/mistake_hint.hpp"

#include <cstddef>
#include <utility>

#include "libration/scalar/decimal.hpp"

namespace libration {

namespace {

constexpr long least_rows = 3;
constexpr int improvement = 100;  // of the root mean square

mpfr square(const mpfr& x) { return x * x; }

bool explains(const mpfr& without, const mpfr& with) { return with > 0 && without * square(improvement) < with; }

// "its errors are then 1.2e+5 times smaller".
std::string gain(const mpfr& without, const mpfr& with) {
    return without == 0 ? "without an error"
                        : "with errors " + to_decimal(mpfr(sqrt(mpfr(with / without))), 2) + " times smaller";
}

std::string quoted(const std::string& name) { return "'" + name + "'"; }

}  // namespace

mistake_hint::mistake_hint(std::vector<std::string> names) : names_(std::move(names)) {
    const precision_scope scope(digits_of_row_numbers);
    const mpfr zero(0);
    apart_.assign(names_.size(), std::vector<mpfr>(names_.size(), zero));
    in_degrees_.assign(names_.size(), zero);
    errors_ = slopes_ = products_ = zero;
}

void mistake_hint::add(const row_numbers& row, bool within) {
    const precision_scope scope(digits_of_row_numbers);
    ++rows_;
    misses_ += within ? 0 : 1;
    const mpfr degree = pi<mpfr>() / 180;
    for (std::size_t i = 0; i < names_.size(); ++i) {
        for (std::size_t j = 0; j < names_.size(); ++j) {
            apart_[i][j] += i == j ? square(row.errors[i]) : square(mpfr(row.written[i] - row.truths[j]));
        }
        in_degrees_[i] += square(mpfr(row.written[i] * degree - row.truths[i]));
    }
    if (row.slopes.empty()) {
        return;
    }
    ++sloped_rows_;
    for (std::size_t i = 0; i < names_.size(); ++i) {
        errors_ += square(row.errors[i]);
        slopes_ += square(row.slopes[i]);
        products_ += row.errors[i] * row.slopes[i];
    }
}

std::string mistake_hint::found() const {
    const precision_scope scope(digits_of_row_numbers);
    if (rows_ < least_rows || misses_ * 10 < rows_ * 9) {
        return "";
    }
    for (const auto& mistake : {degrees(), exchanged(), offset()}) {
        if (!mistake.empty()) {
            return mistake;
        }
    }
    return "";
}

std::string mistake_hint::degrees() const {
    std::string of;
    mpfr with(0);
    mpfr without(0);
    for (std::size_t i = 0; i < names_.size(); ++i) {
        if (explains(in_degrees_[i], apart_[i][i])) {
            of += (of.empty() ? "" : ", ") + quoted(names_[i]);
            with += apart_[i][i];
            without += in_degrees_[i];
        }
    }
    return of.empty() ? "" : of + " in degrees instead of radians: in radians " + gain(without, with);
}

std::string mistake_hint::exchanged() const {
    for (std::size_t i = 0; i < names_.size(); ++i) {
        for (std::size_t j = i + 1; j < names_.size(); ++j) {
            const mpfr without = apart_[i][j] + apart_[j][i];
            const mpfr with = apart_[i][i] + apart_[j][j];
            if (explains(without, with)) {
                return quoted(names_[i]) + " and " + quoted(names_[j]) + " are exchanged: in the other order " +
                       gain(without, with);
            }
        }
    }
    return "";
}

std::string mistake_hint::offset() const {
    if (sloped_rows_ < least_rows || slopes_ == 0) {
        return "";
    }
    const mpfr offset = products_ / slopes_;
    const mpfr left = errors_ - offset * products_;
    const mpfr without = left > 0 ? left : mpfr(0);
    if (!explains(without, errors_)) {
        return "";
    }
    return "the times are off by a constant: the values are those of times " + to_decimal(mpfr(abs(offset)), 3) +
           (offset > 0 ? " later, " : " earlier, ") + gain(without, errors_);
}

}  // namespace libration
