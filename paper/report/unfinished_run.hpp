// The finished parts of an interrupted `libration reproduce`, from which the next run resumes.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace libration {

/// The record of a run in its folder, DIR/unfinished.json, which is there until all of it is made: the parts that are,
/// with their files, and the program that made them. Another program (another commit, or built anew) begins from the
/// start, and a part that lacks one of its files is not made.
class unfinished_run {
public:
    /// Reads the record of an earlier run of this very program, if there is one.
    explicit unfinished_run(const std::string& folder);

    /// Whether a part is made: all of its files are there.
    bool has(const std::string& part) const;
    /// Records a part with the files that it has now, on disk. Throws input_error of --out.
    void add(const std::string& part);
    /// All is made: the record goes.
    void finish();

private:
    std::string folder_;
    std::string path_;
    std::string program_;
    std::map<std::string, std::vector<std::string>> made_;  // files within the folder, by part
};

}  // namespace libration
