// Which column of a file is which quantity: by its name, by a common spelling of it, or as the user maps it.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace libration {

/// A quantity under its name here, with other spellings: lower-case, without blanks, underscores and units.
struct known_column {
    std::string_view name;
    std::vector<std::string_view> spellings = {};
};

/// What to do about a column that is not found, where --columns is an option.
inline constexpr const char* mapping_remedy = "name yours in --columns THEIRS=OURS";

/// The columns of a file. A mapped column is what the user specifies; of the others one with exactly the name of the
/// quantity has priority, then one with another spelling of it: "Time", "t [s]", "theta_0 (rad)".
class column_names {
public:
    /// `mapping` is --columns: t=time,E=energy, with a name of `known` or - (ignored) on the right; or, if the file has
    /// no names, the names of its columns in their order. Throws input_error.
    column_names(std::string file, std::vector<std::string> own, std::size_t count,
                 const std::optional<std::string>& mapping, std::vector<known_column> known);

    /// The index of the column of a quantity; std::nullopt if the file lacks it. Throws input_error if two columns
    /// match, and std::logic_error for an unknown name.
    std::optional<std::size_t> find(std::string_view name) const;
    std::size_t count() const { return own_.size(); }
    /// Whether the user leaves a column out, by NAME=-.
    bool is_ignored(std::size_t at) const { return mapped_[at] == "-"; }
    /// What the file calls a column.
    const std::string& own(std::size_t at) const { return own_[at]; }
    const std::vector<std::string>& own() const { return own_; }
    const std::string& file() const { return file_; }
    /// 'time', 'theta': the existing columns, for messages.
    std::string listed() const;

private:
    void name_by_place(const std::string& mapping, const std::vector<std::string>& items, std::size_t count);
    void map(const std::string& mapping, const std::string& item);
    void require_known(const std::string& mapping, const std::string& name) const;

    std::string file_;
    std::vector<std::string> own_;
    std::vector<std::string> mapped_;  ///< the user's name for each column; empty if none
    std::vector<known_column> known_;
};

/// 'a', 'b' of names; of more than 20 the first ones and how many more.
std::string listed(const std::vector<std::string>& names);

}  // namespace libration
