#include "motion_cells.hpp"

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
constexpr std::array subjects{error_subject::theta0, error_subject::omega0,    error_subject::gap,
                              error_subject::energy, error_subject::direction, error_subject::length,
                              error_subject::gravity};
constexpr std::array<std::string given_motion::*, 7> fields{
    &given_motion::theta0,    &given_motion::omega0, &given_motion::gap,    &given_motion::energy,
    &given_motion::direction, &given_motion::length, &given_motion::gravity};
constexpr std::array<const char*, 4> typed_quantities{"theta0_typed", "omega0_typed", "gap_typed", "energy_typed"};

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

void require_consistent(const motion_cells& cells, const typed_motion& typed) {
    if ((typed.by_state() ? 1 : 0) + (typed.gap ? 1 : 0) + (typed.energy ? 1 : 0) <= 1) {
        return;
    }
    const precision_scope scope(100);
    std::vector<given_energy> given;
    if (typed.gap) {
        const auto value = from_exact<mpfr>(*typed.gap);
        given.push_back({&cells.gap, 2 - value, abs(value) + 2});
    }
    if (typed.energy) {
        const auto value = from_exact<mpfr>(*typed.energy);
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
        const std::string option = std::string("--") + name_of(subjects[i]);
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

const named_text& motion_cells::cell_of(error_subject quantity) const {
    const auto* const found = std::find(subjects.begin(), subjects.end(), quantity);
    return this->*members.at(static_cast<std::size_t>(found - subjects.begin()));
}

typed_motion motion_cells::numbers(const number_notation& by) const {
    given_motion given;
    for (std::size_t i = 0; i < members.size(); ++i) {
        given.*fields[i] = (this->*members[i]).text;
    }
    try {
        return typed_numbers(given, by);
    } catch (const error& problem) {
        const named_text& cell = cell_of(problem.about());
        throw error(problem.kind(), cell.name, cell.text, problem.reason());
    }
}

typed_motion motion_cells::read(const number_notation& by) const {
    if (!names_a_motion()) {
        throw error(error_kind::argument, "the row", "", "has no motion: theta0 and omega0, a gap or an energy");
    }
    typed_motion typed = numbers(by);
    if (typed.omega0 && !typed.theta0) {
        throw error(error_kind::argument, omega0.name, omega0.text, "comes without a theta0");
    }
    require_consistent(*this, typed);
    if (typed.by_state()) {
        if (!direction.text.empty() && sign_of_exact(*typed.omega0) == -typed.direction) {
            refuse(direction, omega0);
        }
        typed.gap = typed.energy = std::nullopt;
    } else if (typed.gap) {
        typed.energy = std::nullopt;
    }
    return typed;
}

const named_text& motion_cells::deciding(const typed_motion& typed) const {
    return typed.by_state() ? omega0 : typed.gap ? gap : energy;
}

motion motion_cells::motion_of(const typed_motion& typed) const {
    try {
        return typed.motion();
    } catch (const error& problem) {
        const bool negative =
            typed.gap && problem.is_about(error_subject::energy) && problem.kind() == error_kind::argument;
        const named_text& cell = problem.is_about(error_subject::theta0) ? theta0 : deciding(typed);
        throw error(problem.kind(), cell.name, cell.text, negative ? "makes the energy negative" : problem.reason());
    }
}

chosen_motion motion_cells::choose(const number_notation& by) const {
    const typed_motion typed = read(by);
    motion of = motion_of(typed);
    std::optional<std::string> energy_text = ending_decimal(of.exact_energy());
    std::optional<std::string> gap_text = ending_decimal(of.exact_gap());
    return {.of = std::move(of),
            .by_state = typed.by_state(),
            .option = deciding(typed).name,
            .value = deciding(typed).text,
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
        places_[i] = names.find(name_of(subjects[i]));
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
        throw error(error_kind::argument, error_subject::time, text, "is an angle");
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
