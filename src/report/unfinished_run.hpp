// What an interrupted `libration reproduce` had made already: the next one goes on there.
#pragma once

#include <set>
#include <string>

namespace libration {

/// The record of a run in its folder, DIR/unfinished.json, which is there until all of it is made: the parts that are,
/// and the program that made them. Another program (another commit, or built anew) begins from the start.
class unfinished_run {
public:
    /// Reads the record of an earlier run of this very program, if there is one.
    explicit unfinished_run(const std::string& folder);

    bool has(const std::string& part) const { return made_.contains(part); }
    /// Records a part, on disk. Throws input_error of --out.
    void add(const std::string& part);
    /// All is made: the record goes.
    void finish();

private:
    std::string path_;
    std::string program_;
    std::set<std::string> made_;
};

}  // namespace libration
