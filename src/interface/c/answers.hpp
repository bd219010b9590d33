// Requests to a solution, and its answers as tables.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "guarded.hpp"
#include "handles.hpp"
#include "libration/problem/answer.hpp"
#include "libration/problem/solution.hpp"

namespace libration::c {

/// This many digits, ROUNDED or PROVED; throws error of the kind argument for another rigour.
request digits_by(long digits, int rigour);

/// A value of an answer of this rigour: proved, two-method, or exact for fractions.
libration_number number_of(const answer_value& value, const std::string& rigour);

/// An answer of which every value is a number, or not decided: then it is 0 to within its bound, or an empty cell if
/// there is no bound.
libration_table table_of_numbers(const answer& found);

/// A name and a value in each row.
libration_table table_of_values(const answer& found);

/// The points of a branch: words in the first column, then numbers as above; a last column `note` is empty except in the
/// last row, which has the note "end" of the answer.
libration_table table_of_branch(const answer& found);

/// A row for each time, with what is known of it, and the reason if something is missing.
struct known_states {
    libration_table table;
    std::optional<error> missing;

    /// The table; throws the reason if something is missing.
    libration_table complete() &&;
    /// The table in a handle of the caller; then throws the reason if something is missing.
    void write(libration_table** to) &&;
};

/// Like made(), of a table that is also returned if something is missing in it, which is the error.
template <class Make>
int partly_made(libration_table** handle, const Make& make) noexcept {
    return guarded([&] {
        given(handle, "the pointer to the result");
        *handle = nullptr;
        known_states(make()).write(handle);
    });
}

/// The quantities at a list of times, and their derivatives with respect to `numbers`.
known_states states_of(const solution& of, const std::string& times, request how, const watcher& watch,
                       std::vector<std::string> numbers = {});

}  // namespace libration::c
