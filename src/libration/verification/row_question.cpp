#include "libration/verification/row_question.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "libration/digits/precision_loop.hpp"
#include "libration/number/written_number.hpp"
#include "libration/scalar/error.hpp"

namespace libration {

namespace {

// The number of turns by which a value is away, rounded to the nearest.
true_value turned_towards(const std::string& value, true_value truth) {
    written_number written{0, 1};
    try {
        written = read_written(value);
    } catch (const error&) {
        return truth;  // nan, or a value for which the comparison throws
    }
    const ball turn = pi<ball>() * 2;
    const integer turns = nearest_integer(ball((from_rational<ball>(written.value) - truth.value()) / turn));
    if (turns != 0) {
        truth.enclosure = truth.value() + from_rational<ball>(rational(turns)) * turn;
        truth.exactly = std::nullopt;
    }
    return truth;
}

// The decimal places needed for the values.
long places_of_row(const std::vector<written_value>& values, const compare_rules& rules) {
    long places = 0;
    for (const written_value& value : values) {
        if (value.text.empty()) {
            throw error(error_kind::argument, value.name, "", "is empty");
        }
        try {
            places = std::max(places, places_for(value.text, rules));
        } catch (const error& problem) {
            throw error(problem.kind(), value.name, value.text, problem.reason());
        }
    }
    return places;
}

// The slopes are not needed for a row without an error.
std::optional<row_numbers> numbers_of(const std::vector<written_value>& values, const std::vector<true_value>& truths,
                                      bool within, const row_question& question, long digits) {
    row_numbers numbers;
    const auto to_few_digits = [](const ball& x) {
        const precision_scope scope(digits_of_row_numbers);
        return binary_exponent(x) < smallest_exponent ? mpfr(0)
                                                      : mpfr(midpoint_of(x), mpfr::thread_default_precision());
    };
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (is_not_finite(values[i].text) || truths[i].infinite != 0) {
            return std::nullopt;
        }
        const auto written = from_rational<ball>(read_written(values[i].text).value);
        numbers.written.push_back(to_few_digits(written));
        numbers.truths.push_back(to_few_digits(truths[i].value()));
        numbers.errors.push_back(to_few_digits(written - truths[i].value()));
    }
    if (!within && question.slopes) {
        numbers.slopes = question.slopes(digits);
    }
    return numbers;
}

}  // namespace

bool compared_values::within() const {
    return std::ranges::all_of(values, [](const comparison& each) { return each.within; });
}

void require_numbers(const std::vector<written_value>& values, const compare_rules& rules) {
    static_cast<void>(places_of_row(values, rules));
}

compared_values compare_row(const std::vector<written_value>& values, const row_question& question,
                            const compare_rules& rules) {
    const long start = question.first_digits(places_of_row(values, rules));
    constexpr int attempts = 5;
    subject_name undecided = values.front().name;
    const auto attempt = [&](const precision_run& run) -> std::optional<compared_values> {
        compared_values here;
        here.proved = question.proved;
        auto truths = question.truths(run.more);
        for (std::size_t i = 0; i < truths.size(); ++i) {
            if (i == 0 && rules.modulo_turn) {
                truths[i] = turned_towards(values[i].text, truths[i]);
            }
            auto value = compare_value(values[i], truths[i], rules, run.last);
            if (!value) {
                undecided = values[i].name;
                return std::nullopt;
            }
            here.values.push_back(*std::move(value));
        }
        here.numbers = numbers_of(values, truths, here.within(), question, run.more);
        here.condition = question.condition(run.more);
        return here;
    };
    return with_growing_precision({0, start, attempts * start, digit_growth::by_first}, undecided, attempt);
}

std::string correct_digits_text(const std::optional<long>& tenths) {
    return tenths ? std::to_string(*tenths / 10) + "." + std::to_string(*tenths % 10) : "inf";
}

}  // namespace libration
