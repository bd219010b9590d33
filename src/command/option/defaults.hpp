// What the options of commands are if they are not given, unless a study or the library determines it.
#pragma once

namespace libration::defaults {

inline constexpr long digits = 50;
inline constexpr long digits_of_list = 20;  ///< of `series`
inline constexpr long digits_of_singularities = 15;
inline constexpr long digits_of_law = 30;
inline constexpr const char* step = "1e-5";  ///< of --method rk4
inline constexpr const char* format = "text";
inline constexpr const char* format_of_table = "csv";  ///< of `table` and `verify`
inline constexpr const char* name_of_array = "reference_values";

}  // namespace libration::defaults
