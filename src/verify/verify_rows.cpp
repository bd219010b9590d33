#include "verify/verify_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <utility>

#include "libration/digits/growing_precision.hpp"
#include "libration/scalar/error.hpp"
#include "libration/scalar/text/decimal.hpp"

namespace libration {

using namespace pendulum;

namespace {

constexpr std::size_t most_known_motions = 4;
constexpr long least_places = 17;
constexpr long double_digits = 53;

// read(text), with the column and the text before its complaint.
template <class Read>
auto reading_cell(const char* column, const std::string& text, const Read& read) {
    const auto quoted = [&] { return text.size() > 60 ? text.substr(0, 60) + "..." : text; };
    try {
        return read(text);
    } catch (const error& problem) {
        throw error(problem.kind(), column, quoted(), problem.reason());
    }
}

exact pure_number(const std::string& text) {
    exact number = read_typed(text);
    if (!number.is_number()) {
        throw error(error_kind::argument, "number", text, "has a unit");
    }
    return number;
}

exact angle(const std::string& text) {
    exact number = read_typed(text);
    if (number.has_periods()) {
        throw error(error_kind::argument, "angle", text, "is a time");
    }
    return number;
}

exact time_of(const std::string& text, bool as_double) {
    exact number = read_typed(text);
    if (number.measure == unit::degree) {
        throw error(error_kind::argument, "time", text, "is an angle");
    }
    return as_double ? nearest_double(number) : number;
}

int direction_of(const std::string& text) {
    if (text.empty() || text == "+" || text == "+1" || text == "1") {
        return 1;
    }
    if (text != "-" && text != "-1") {
        throw error(error_kind::argument, "direction", text, "is neither + nor -");
    }
    return -1;
}

// theta0 and omega0, else the gap, else the energy, these two from theta0 where it is there.
typed_motion typed_of(const motion_cells& cells) {
    typed_motion typed;
    const bool by_state = !cells.theta0.empty() && !cells.omega0.empty();
    if (!by_state && cells.gap.empty() && cells.energy.empty()) {
        throw error(error_kind::argument, "row", "", "has no motion: theta0 and omega0, a gap or an energy");
    }
    if (!cells.theta0.empty()) {
        typed.theta0 = reading_cell("theta0", cells.theta0, angle);
    }
    if (by_state) {
        typed.omega0 = reading_cell("omega0", cells.omega0, pure_number);
    } else if (!cells.gap.empty()) {
        typed.gap = reading_cell("gap", cells.gap, pure_number);
    } else {
        typed.energy = reading_cell("energy", cells.energy, pure_number);
    }
    typed.direction = reading_cell("direction", cells.direction, direction_of);
    return typed;
}

// "nan" and "inf" are answers of a program, wrong ones.
bool is_no_number(const std::string& text) {
    std::string word;
    for (const char c : text) {
        word += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
    word.erase(0, word.starts_with('-') || word.starts_with('+') ? 1 : 0);
    return word.starts_with("nan") || word == "inf" || word == "infinity";
}

// p with 10^-p <= |x|, at most one more than needed.
long places_of(const rational& x) {
    const precision_scope scope(20);
    const long exponent = binary_exponent(from_rational<mpfr>(x));
    return exponent == exponent_of_zero ? 0
           : exponent > 0               ? 1 - decimal_digits(exponent - 1)
                                        : decimal_digits(1 - exponent);
}

// The e of |t| < 2^e.
long exponent_of(const exact& time) {
    const precision_scope scope(20);
    if (time.is_zero()) {
        return 0;
    }
    if (time.measure == unit::expression) {
        return std::max(binary_exponent(from_exact<mpfr>(time.without_periods())),
                        binary_exponent(from_rational<mpfr>(time.periods())) + 3);
    }
    return binary_exponent(from_rational<mpfr>(time.coefficient)) + (time.measure == unit::one ? 0 : 3);
}

std::string tenths_text(const std::optional<long>& tenths) {
    return tenths ? fmt::format("{}.{}", *tenths / 10, *tenths % 10) : "inf";
}

}  // namespace

void motion_cells::complete_from(const motion_cells& other) {
    for (const auto member : {&motion_cells::theta0, &motion_cells::omega0, &motion_cells::gap, &motion_cells::energy,
                              &motion_cells::direction}) {
        if ((this->*member).empty()) {
            this->*member = other.*member;
        }
    }
}

std::vector<std::string> added_columns(const verify_columns& columns) {
    std::vector<std::string> names{"reference", "error", "correct_digits", "verdict", "condition"};
    if (columns.omega) {
        names.insert(names.end(), {"omega_reference", "omega_error", "omega_correct_digits"});
    }
    return names;
}

judged_row row_judge::operator()(const csv_record& record) {
    const auto cells = cells_of(record.text);
    if (!cells) {
        return malformed(record, {record.text}, "a quote is not closed");
    }
    if (cells->size() != columns_.count) {
        return malformed(record, *cells, fmt::format("has {} cells, the header has {}", cells->size(), columns_.count));
    }
    try {
        return judged(record, *cells);
    } catch (const error& problem) {  // what cannot be read, motions that there are not, and what cannot be proved
        return malformed(record, *cells, problem.value().empty() ? problem.reason() : problem.what());
    }
}

judged_row row_judge::malformed(const csv_record& record, const std::vector<std::string>& cells,
                                const std::string& reason) const {
    std::string text;
    for (std::size_t i = 0; i < columns_.count; ++i) {
        text += (i > 0 ? "," : "") + (i < cells.size() ? written_cell(cells[i]) : "");
    }
    text += ",,,,malformed,";
    text += columns_.omega ? ",,," : "";
    return {record.line, row_verdict::malformed, text, reason, "", 0, "", mpfr(0)};
}

asked_row row_judge::read(const std::vector<std::string>& cells) const {
    const auto cell = [&](const std::optional<std::size_t>& at) { return at ? trimmed(cells[*at]) : std::string(); };
    asked_row row;
    const bool as_double = rules_.inputs_are_doubles;
    const std::string time_typed = cell(columns_.time_typed);
    row.time = reading_cell("time", time_typed.empty() ? trimmed(cells[columns_.time]) : time_typed,
                            [&](const std::string& text) { return time_of(text, as_double); });
    row.theta = trimmed(cells[columns_.theta]);
    row.omega = cell(columns_.omega);
    const motion_cells typed{cell(columns_.theta0_typed), cell(columns_.omega0_typed), cell(columns_.gap_typed),
                             cell(columns_.energy_typed), cell(columns_.direction)};
    row.motion = {cell(columns_.theta0), cell(columns_.omega0), cell(columns_.gap), cell(columns_.energy),
                  cell(columns_.direction)};
    if (!typed.is_empty()) {
        row.motion = typed;
    }
    if (!row.motion.names_a_motion()) {
        row.motion.complete_from(rules_.usual);
    }
    return row;
}

row_judge::known_motion& row_judge::motion_for(const motion_cells& cells) {
    const std::string text = cells.text();
    const auto found =
        std::find_if(known_.begin(), known_.end(), [&](const auto& known) { return known->text == text; });
    if (found != known_.end()) {
        std::rotate(known_.begin(), found, found + 1);
        return *known_.front();
    }
    typed_motion typed = typed_of(cells);
    if (rules_.inputs_are_doubles) {
        typed = typed.in_double();
    }
    typed.squared_frequency = rules_.squared_frequency;
    pendulum::motion exactly = typed.motion();
    known_.insert(known_.begin(), std::make_unique<known_motion>(known_motion{text, typed, std::move(exactly), {}}));
    known_.resize(std::min(known_.size(), most_known_motions));
    return *known_.front();
}

const conditioned_motion& row_judge::in_precision(known_motion& known, long digits) {
    for (const auto& [made_with, made] : known.by_digits) {
        if (made_with == digits) {
            return *made;
        }
    }
    known.by_digits.emplace_back(digits, std::make_unique<conditioned_motion>(known.typed, known.exactly));
    return *known.by_digits.back().second;
}

std::optional<judgement> row_judge::judge_value(const std::string& text, const ball& truth, bool last_attempt) const {
    // A program's answer that is no number is infinitely wrong.
    const bool missing = is_no_number(text);
    const written_number value = missing ? written_number{0, 1} : read_written(text);
    rational tolerance = rules_.tolerance.value_or(value.last_place);
    if (rules_.ulps) {
        const long exponent = std::max(1L, binary_exponent(midpoint(truth)));
        tolerance = *rules_.ulps * power_of(2, exponent - double_digits);
    }
    const long places = std::max({places_of(value.last_place), places_of(tolerance), least_places}) + 3;
    auto result = judge(value.value, truth, from_rational<ball>(tolerance), places, last_attempt);
    if (result && missing) {
        result->within = false;
        result->error = "inf";
        result->tenths_of_digits = 0;
        mpfr_set_inf(handle(result->of_tolerance), 1);
    }
    return result;
}

std::optional<row_judge::value_verdicts> row_judge::try_verdicts(const asked_row& row, known_motion& known, long digits,
                                                                 bool last_attempt) const {
    const conditioned_motion& motion = in_precision(known, digits);
    const enclosed_state state = motion.of().at(row.time);
    const auto theta = judge_value(row.theta, state.theta, last_attempt);
    const auto omega = row.omega.empty() ? std::nullopt : judge_value(row.omega, state.omega, last_attempt);
    if (!theta || (!row.omega.empty() && !omega)) {
        return std::nullopt;
    }
    const auto condition = motion.at(row.time, state);
    return value_verdicts{*theta, omega, condition ? to_decimal(*condition, 3) : "inf"};
}

row_judge::value_verdicts row_judge::verdicts(const asked_row& row, known_motion& known) {
    const long time_exponent = exponent_of(row.time);
    long places = least_places;
    for (const auto& [name, text] : {std::pair{"theta", &row.theta}, std::pair{"omega", &row.omega}}) {
        if (!text->empty() && !is_no_number(*text)) {
            places = std::max(places, places_of(reading_cell(name, *text, read_written).last_place));
        }
    }
    places = std::max(places, rules_.tolerance ? places_of(*rules_.tolerance) : 0);
    const long for_truth = places + 20 + decimal_digits(std::max(0L, time_exponent));
    const long for_condition = decimal_digits(conditioned_motion::bits_for(known.exactly, time_exponent));
    const long start = (std::max(for_truth, for_condition) + 9) / 10 * 10;
    constexpr int attempts = 5;
    return with_growing_precision(
        {0, start, attempts * start, digit_growth::by_first}, "theta",
        [&](const precision_run& run) { return try_verdicts(row, known, run.more, run.last); });
}

judged_row row_judge::judged(const csv_record& record, const std::vector<std::string>& cells) {
    const asked_row row = read(cells);
    if (row.theta.empty()) {
        throw error(error_kind::argument, "row", "", "has no theta");
    }
    if (columns_.omega && row.omega.empty()) {
        throw error(error_kind::argument, "row", "", "has no omega");
    }
    const value_verdicts at = verdicts(row, motion_for(row.motion));
    const bool theta_ok = at.theta.within;
    const bool omega_ok = !at.omega || at.omega->within;
    std::string text = record.text;
    text += ',' + at.theta.reference + ',' + at.theta.error + ',' + tenths_text(at.theta.tenths_of_digits) +
            (theta_ok && omega_ok ? ",ok," : ",miss,") + at.condition;
    if (at.omega) {
        text += ',' + at.omega->reference + ',' + at.omega->error + ',' + tenths_text(at.omega->tenths_of_digits);
    }
    std::string reason;
    if (!theta_ok || !omega_ok) {
        reason = theta_ok ? "omega misses by " + at.omega->error : "theta misses by " + at.theta.error;
    }
    const bool omega_worse = at.omega && at.omega->of_tolerance > at.theta.of_tolerance;
    return {record.line,
            theta_ok && omega_ok ? row_verdict::ok : row_verdict::miss,
            std::move(text),
            std::move(reason),
            omega_worse ? at.omega->error : at.theta.error,
            at.theta.tenths_of_digits,
            at.condition,
            omega_worse ? at.omega->of_tolerance : at.theta.of_tolerance};
}

}  // namespace libration
