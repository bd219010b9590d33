#include "verify/verify_summary.hpp"

#include <fmt/format.h>

#include <cstdio>

#include "libration/scalar/decimal.hpp"
#include "text/quotation.hpp"

namespace libration {

namespace {

constexpr long most_named = 10;
constexpr std::size_t longest_reason = 400;
constexpr long exact_digits = 1L << 40;

void print_more(long count, const char* what) {
    if (count > 0) {
        fmt::print(stderr, "and {} more rows {}\n", count, what);
    }
}

}  // namespace

void verify_summary::add(const compared_row& row) {
    ++rows_;
    if (row.verdict == row_verdict::malformed) {
        name(row, ++malformed_, malformed_named_);
        return;
    }
    if (row.verdict == row_verdict::undecided) {
        name(row, ++undecided_, undecided_named_);
        return;
    }
    unproved_ += row.proved ? 0 : 1;
    ++digits_[row.least_tenths ? *row.least_tenths / 10 : exact_digits];
    if (row.verdict == row_verdict::miss) {
        name(row, ++misses_, misses_named_);
    }
    if (!worst_ || is_worse(row.least_tenths, row.of_tolerance, worst_->least_tenths, worst_->of_tolerance)) {
        worst_ = row;
    }
    if (row.numbers) {
        mistake_.add(*row.numbers, row.verdict == row_verdict::ok);
    }
}

void verify_summary::print() const {
    print_more(misses_ - misses_named_, "that miss");
    print_more(malformed_ - malformed_named_, "malformed");
    print_more(undecided_ - undecided_named_, "undecided");
    fmt::print(stderr, "{}: {} rows, {} ok, {} miss, {} malformed{}\n", without_controls(file_, longest_quotation),
               rows_, rows_ - misses_ - malformed_ - undecided_, misses_, malformed_,
               undecided_ > 0 ? fmt::format(", {} undecided", undecided_) : "");
    if (!of_doubles_.empty()) {
        fmt::print(stderr,
                   "doubles in decimal: {}: without another tolerance, within half a unit in the last place of a "
                   "double\n",
                   without_controls(listed(of_doubles_), longest_reason));
    }
    if (!inputs_.empty()) {
        fmt::print(
            stderr,
            "doubles in decimal: {}: the values are compared at these doubles; --inputs decimal for the numbers as "
            "typed\n",
            without_controls(listed(inputs_), longest_reason));
    }
    if (unproved_ > 0) {
        fmt::print(stderr,
                   "{} rows are compared with values on which two computations agree, and which are not proved\n",
                   unproved_);
    }
    if (worst_) {
        const precision_scope scope(20);
        fmt::print(stderr,
                   "worst row: line {}, {}: error {}, {} times the tolerance, {} correct digits, condition {}\n",
                   worst_->line, without_controls(worst_->column, longest_quotation), worst_->error,
                   to_decimal(worst_->of_tolerance, 3), correct_digits_text(worst_->least_tenths), worst_->condition);
    }
    if (const std::string mistake = mistake_.found(); !mistake.empty()) {
        fmt::print(stderr, "probable mistake: {}\n", without_controls(mistake, longest_reason));
    }
    for (const auto& [digits, count] : digits_) {
        fmt::print(stderr, "{:>6} correct digits: {:>9}\n", digits == exact_digits ? "all" : std::to_string(digits),
                   count);
    }
}

void verify_summary::name(const compared_row& row, long count, long& named) const {
    if (count <= most_named) {
        ++named;
        fmt::print(stderr, "{}:{}: {}\n", without_controls(file_, longest_quotation), row.line,
                   without_controls(row.reason, longest_reason));
    }
}

}  // namespace libration
