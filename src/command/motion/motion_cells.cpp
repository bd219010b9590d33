#include "motion/motion_cells.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

#include "text/csv_records.hpp"
#include "text/quotation.hpp"

namespace libration {

using namespace pendulum;

namespace {

constexpr std::array<named_text motion_cells::*, 7> members{
    &motion_cells::theta0,    &motion_cells::omega0, &motion_cells::gap,    &motion_cells::energy,
    &motion_cells::direction, &motion_cells::length, &motion_cells::gravity};
constexpr std::array<const char*, 7> quantities{"theta0", "omega0", "gap", "energy", "direction", "length", "gravity"};
constexpr std::array<const char*, 4> typed_quantities{"theta0_typed", "omega0_typed", "gap_typed", "energy_typed"};

exact pure_number(const std::string& text) {
    exact number = read_typed(text);
    if (!number.is_number()) {
        throw error(error_kind::argument, "number", text, "has a unit");
    }
    return number;
}

exact positive_number(const std::string& text) {
    exact number = pure_number(text);
    if (sign_of_exact(number) <= 0) {
        throw error(error_kind::argument, "number", text, "is not positive");
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

int direction_in(const std::string& text) {
    if (text.empty() || text == "+" || text == "+1" || text == "1") {
        return 1;
    }
    if (text != "-" && text != "-1") {
        throw error(error_kind::argument, "direction", text, "is neither + nor -");
    }
    return -1;
}

// The number in a cell, or the double nearest to it; std::nullopt if the cell is empty.
std::optional<exact> number_in(const named_text& cell, exact (*read)(const std::string&), bool as_double) {
    if (cell.text.empty()) {
        return std::nullopt;
    }
    return reading_cell(cell, [&](const std::string& text) {
        const exact number = read(text);
        return as_double ? nearest_double(number) : number;
    });
}

bool same_number(const std::string& a, const std::string& b) {
    if (a == b) {
        return true;
    }
    try {
        const exact difference = read_typed(a) - read_typed(b);
        return difference.is_fraction() && difference.coefficient == 0;
    } catch (const error&) {
        return false;
    }
}

[[noreturn]] void refuse(const named_text& cell, const named_text& other) {
    throw error(error_kind::argument, cell.name, cell.text, "contradicts " + other.name + " " + quotation(other.text));
}

// An energy given by cells, with the uncertainty due to doubles from which it may have been computed.
struct given_energy {
    const named_text* by;
    mpfr energy;
    mpfr size;
};

// Throws if energies differ by more than doubles of their size do.
void require_one_energy(const std::vector<given_energy>& given) {
    constexpr int open_bits = 50;
    for (const given_energy& each : given) {
        const mpfr size = std::max(each.size, given.front().size);
        if (abs(mpfr(each.energy - given.front().energy)) > ldexp(size, -open_bits)) {
            refuse(*given.front().by, *each.by);
        }
    }
}

void require_consistent(const motion_cells& cells, const typed_motion& typed, const std::optional<exact>& gap,
                        const std::optional<exact>& energy) {
    const bool one = (typed.by_state() ? 1 : 0) + (gap ? 1 : 0) + (energy ? 1 : 0) <= 1;
    if (one || (typed.theta0 && typed.theta0->has_periods())) {
        return;
    }
    const precision_scope scope(100);
    std::vector<given_energy> given;
    if (gap) {
        const auto value = from_exact<mpfr>(*gap);
        given.push_back({&cells.gap, 2 - value, abs(value) + 2});
    }
    if (energy) {
        const auto value = from_exact<mpfr>(*energy);
        given.push_back({&cells.energy, value, abs(value) + 2});
    }
    if (typed.by_state()) {
        const auto theta = from_exact<mpfr>(*typed.theta0);
        const auto omega = from_exact<mpfr>(*typed.omega0);
        const mpfr kinetic = omega * omega / (from_exact<mpfr>(typed.squared_frequency) * 2);
        given.push_back({&cells.omega0, kinetic + 1 - cos(theta), kinetic + 2 + abs(theta)});
    }
    require_one_energy(given);
}

}  // namespace

motion_cells motion_cells::of(const motion_options& options) {
    motion_cells cells;
    for (std::size_t i = 0; i < members.size(); ++i) {
        const std::string option = std::string("--") + quantities[i];
        cells.*members[i] = {options.given(option).value_or(""), option};
    }
    return cells;
}

void motion_cells::complete_from(const motion_cells& other) {
    for (const auto member : members) {
        named_text& mine = this->*member;
        const named_text& theirs = other.*member;
        if (mine.text.empty()) {
            mine = theirs.text.empty() ? mine : theirs;
        } else if (!theirs.text.empty() && !same_number(mine.text, theirs.text)) {
            refuse(mine, theirs);
        }
    }
}

std::string motion_cells::key() const {
    std::string key;
    for (const auto member : members) {
        key += (this->*member).text + ',';
    }
    return key;
}

typed_motion motion_cells::read(bool as_doubles) const {
    if (!names_a_motion()) {
        throw error(error_kind::argument, "the row", "", "has no motion: theta0 and omega0, a gap or an energy");
    }
    typed_motion typed;
    if (length.text.empty() != gravity.text.empty()) {
        const named_text& there = length.text.empty() ? gravity : length;
        const named_text& lacking = length.text.empty() ? length : gravity;
        throw error(error_kind::argument, there.name, there.text,
                    "comes without " + (lacking.name.empty() ? std::string("the other one") : lacking.name));
    }
    if (!length.text.empty()) {
        typed.squared_frequency =
            *number_in(gravity, positive_number, as_doubles) / *number_in(length, positive_number, as_doubles);
    }
    typed.theta0 = number_in(theta0, angle, as_doubles);
    typed.omega0 = number_in(omega0, pure_number, as_doubles);
    const auto gap_read = number_in(gap, pure_number, as_doubles);
    const auto energy_read = number_in(energy, pure_number, as_doubles);
    typed.direction = reading_cell(direction, direction_in);
    if (typed.omega0 && !typed.theta0) {
        throw error(error_kind::argument, omega0.name, omega0.text, "comes without a theta0");
    }
    require_consistent(*this, typed, gap_read, energy_read);
    if (typed.by_state()) {
        const int sign = sign_of_exact(*typed.omega0);
        if (!direction.text.empty() && sign != 0 && sign != typed.direction) {
            refuse(direction, omega0);
        }
    } else {
        (gap_read ? typed.gap : typed.energy) = gap_read ? gap_read : energy_read;
    }
    return typed;
}

motion motion_cells::motion_of(const typed_motion& typed) const {
    try {
        return typed.motion();
    } catch (const error& problem) {
        const named_text& cell = problem.subject() == "theta0" ? theta0
                                 : typed.by_state()            ? omega0
                                 : typed.gap                   ? gap
                                                               : energy;
        throw error(problem.kind(), cell.name, cell.text, problem.reason());
    }
}

chosen_motion motion_cells::choose() const {
    const typed_motion typed = read();
    motion of = motion_of(typed);
    std::optional<std::string> energy_text = ending_decimal(of.exact_energy());
    std::optional<std::string> gap_text = ending_decimal(of.exact_gap());
    const named_text& chosen = typed.by_state() ? omega0 : typed.gap ? gap : energy;
    return {.of = std::move(of),
            .by_state = typed.by_state(),
            .option = chosen.name,
            .value = chosen.text,
            .energy = std::move(energy_text),
            .gap = std::move(gap_text),
            .energy_typed = typed.energy ? energy.text : "",
            .gap_typed = typed.gap ? gap.text : "",
            .theta0_typed = typed.theta0 ? theta0.text : "",
            .omega0_typed = typed.by_state() ? omega0.text : ""};
}

std::vector<known_column> motion_columns::known() {
    std::vector<known_column> columns{{"theta0", {"theta0", "θ0", "theta(0)", "angle0"}},
                                      {"omega0", {"omega0", "ω0", "omega(0)", "thetadot0", "theta'0"}},
                                      {"gap", {"gap", "2-e", "2-energy"}},
                                      {"energy", {"energy", "e"}},
                                      {"direction", {"direction"}},
                                      {"length", {"length", "l"}},
                                      {"gravity", {"gravity", "g"}}};
    for (const char* const name : typed_quantities) {
        columns.push_back({name});
    }
    return columns;
}

motion_columns::motion_columns(const column_names& names) : names_(&names) {
    for (std::size_t i = 0; i < places_.size(); ++i) {
        places_[i] = names.find(quantities[i]);
    }
    for (std::size_t i = 0; i < typed_.size(); ++i) {
        typed_[i] = names.find(typed_quantities[i]);
    }
}

motion_cells motion_columns::in(const std::vector<std::string>& cells) const {
    const auto cell = [&](const std::optional<std::size_t>& at) {
        return at ? named_text{trimmed(cells[*at]), names_->own(*at)} : named_text();
    };
    const bool typed = std::any_of(typed_.begin(), typed_.end(),
                                   [&](const auto& place) { return place && !trimmed(cells[*place]).empty(); });
    motion_cells here;
    for (std::size_t i = 0; i < members.size(); ++i) {
        here.*members[i] = cell(typed && i < typed_.size() ? typed_[i] : places_[i]);
    }
    return here;
}

std::vector<known_column> time_columns::known() { return {{"time", {"time", "t"}}, {"time_typed"}}; }

named_text time_columns::in(const std::vector<std::string>& cells) const {
    if (typed_ && !trimmed(cells[*typed_]).empty()) {
        return {trimmed(cells[*typed_]), names_->own(*typed_)};
    }
    return {trimmed(cells[*at_]), names_->own(*at_)};
}

exact time_in(const std::string& text) {
    exact number = read_typed(text);
    if (number.measure == unit::degree) {
        throw error(error_kind::argument, "time", text, "is an angle");
    }
    return number;
}

exact time_for(const named_text& cell, regime r) {
    exact time = reading_cell(cell, time_in);
    if (time.has_periods() && at_critical_energy(r)) {
        throw error(error_kind::argument, cell.name, cell.text, "is a multiple of an infinite period");
    }
    return time;
}

}  // namespace libration
