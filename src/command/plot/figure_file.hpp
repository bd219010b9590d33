// The figure of a command with --plot: its file, and its drawing by gnuplot from tables.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "option/options.hpp"
#include "sweep/study.hpp"
#include "sweep/study_figures.hpp"

namespace libration {

/// What a figure script needs: tables in files, and texts in variables.
struct figure_content {
    std::string script;  ///< studies/plot/SCRIPT.gp, which draws "figure" in each of the kinds
    std::vector<text_file> tables;
    script_variables variables;
};

/// The file of --out as a figure: FILE.svg, FILE.pdf or FILE.png, or all three for a name without an ending. Its
/// directory is tested before anything is computed.
class figure_file {
public:
    /// Throws input_error if there is no file, for another ending, and for a directory that cannot be written.
    explicit figure_file(const std::optional<std::string>& out);

    /// Draws the figure completely or not at all, and reports the written files on stderr. Throws as draw_figures, and
    /// input_error of --out.
    void draw(const figure_content& content) const;

    const std::vector<std::string>& kinds() const { return kinds_; }

private:
    std::string path_;  ///< without the ending
    std::vector<std::string> kinds_;
};

/// Lists as a script reads them: "\"a\" \"b c\"".
std::string words_for_script(const std::vector<std::string>& words);

/// Text for a figure as it is: without the meaning that _, ^ and others have there.
std::string text_in_figure(const std::string& text);

/// A name of an equation as text of a figure: theta as its Greek letter, x_12 with a subscript, primes as they are.
std::string name_in_figure(const std::string& name);

/// The heading of a problem (problem_options::heading) for a script: escaped if it is a text, else the name.
std::string heading_in_figure(const std::string& heading);

}  // namespace libration
