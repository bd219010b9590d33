// A motion in the cells of a row: the columns that define it, and their contents, read exactly.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "libration/pendulum/typed_motion.hpp"
#include "motion_options.hpp"
#include "text/column_names.hpp"

namespace libration {

/// The text of a cell or of an option, with the name by which the user refers to it.
struct named_text {
    std::string text = {};
    std::string name = {};
};

/// A text for each number of a motion, empty if there is none.
struct motion_cells {
    named_text theta0 = {}, omega0 = {}, gap = {}, energy = {}, direction = {}, length = {}, gravity = {};

    /// Those of a command line.
    static motion_cells of(const motion_options& options);
    bool names_a_motion() const {
        return (!theta0.text.empty() && !omega0.text.empty()) || !gap.text.empty() || !energy.text.empty();
    }
    /// Copies from another what is empty here. Throws error if both have a text and the texts differ.
    void complete_from(const motion_cells& other);
    /// All texts: identifies the motion.
    std::string key() const;
    static constexpr pendulum::number_notation of_programs{.of_programs = true};
    /// theta0 and omega0, else the gap, else the energy, these two from theta0 if it is given. Throws error of the name of a cell if it cannot be read, if there is no motion, and if
    /// the cells contradict each other: if the energies that they give differ by more than the rounding of doubles,
    /// 2^-50 of their size, or the direction is not the sign of omega0.
    pendulum::typed_motion read(const pendulum::number_notation& by = of_programs) const;
    /// The motion of what was read. Throws error of the name of a cell, for example if an energy is negative.
    pendulum::motion motion_of(const pendulum::typed_motion& typed) const;
    /// The motion with the texts that represent it in the output. Throws as both.
    chosen_motion choose(const pendulum::number_notation& by = of_programs) const;

private:
    pendulum::typed_motion numbers(const pendulum::number_notation& by) const;
    const named_text& cell_of(error_subject quantity) const;
    /// That of the energy or of the last number of a state.
    const named_text& deciding(const pendulum::typed_motion& typed) const;
};

/// The columns of a motion. A table of this program has further columns with its numbers as typed, which are exact.
class motion_columns {
public:
    /// The quantities, for column_names.
    static std::vector<known_column> known();
    explicit motion_columns(const column_names& names);

    bool names_a_motion() const { return (at(0) && at(1)) || at(2) || at(3); }
    bool has_angle() const { return at(0).has_value(); }
    bool has_speed() const { return at(1).has_value(); }
    bool has_direction() const { return at(4).has_value(); }
    bool has_length() const { return at(5).has_value(); }
    motion_cells in(const std::vector<std::string>& cells) const;

private:
    const std::optional<std::size_t>& at(std::size_t i) const { return places_[i]; }

    const column_names* names_;
    std::array<std::optional<std::size_t>, 7> places_;
    std::array<std::optional<std::size_t>, 4> typed_;  ///< theta0, omega0, gap, energy
};

/// The columns of a time, as numbers and as typed.
class time_columns {
public:
    static std::vector<known_column> known();
    explicit time_columns(const column_names& names)
        : names_(&names), at_(names.find("time")), typed_(names.find("time_typed")) {}

    bool there() const { return at_.has_value(); }
    named_text in(const std::vector<std::string>& cells) const;

private:
    const column_names* names_;
    std::optional<std::size_t> at_, typed_;
};

/// A time such as 0.7 or T/4; throws error.
exact time_in(const std::string& text);

/// The same in a cell, of a motion in this regime; throws error of its name, also for a multiple of an infinite period.
exact time_for(const named_text& cell, pendulum::regime r);

/// read(cell.text); errors are rethrown with the name of the cell.
template <class Read>
auto reading_cell(const named_text& cell, const Read& read) {
    try {
        return read(cell.text);
    } catch (const error& problem) {
        throw error(problem.kind(), cell.name, cell.text, problem.reason());
    }
}

}  // namespace libration
