// The contents of a results directory, read back from its files: the report and the index are made from this alone, so
// that they are also correct for a directory of which only a part was recomputed.
#pragma once

#include <string>
#include <vector>

#include "paper/claims/claim.hpp"
#include "sweep/study.hpp"

namespace libration {

/// The files of one study, relative to the folder, and their description in its JSON.
struct published_study {
    const study* what;
    std::string command;
    std::string commit;                ///< of the program that made it
    std::vector<std::string> tables;   ///< CSV files
    std::vector<std::string> figures;  ///< SVG files; the one that has the study's name comes first
};

/// A row of claims.csv.
struct published_claim {
    std::string name, label, statement, verdict, number, measured, correction, command, severity, printed;
};

/// A table of reference/, as described in reference.json.
struct published_reference {
    std::string title;
    std::string command;             ///< of its CSV
    std::vector<std::string> files;  ///< relative to the folder
};

/// A results folder. Studies are in the order of the paper's figures; those that belong to no figure come behind, by
/// name.
struct published {
    std::string folder;
    std::vector<published_study> studies;
    std::vector<published_claim> claims;  ///< in the paper's order, then this program's; empty if they were not tested
    std::vector<published_reference> references;
};

/// Reads the folder. Throws std::runtime_error where a file of it is not what this program writes.
published read_published(const std::string& folder);

/// Those of the paper, or those of this program's own.
std::vector<published_claim> claims_by(const std::vector<published_claim>& claims, bool own);

/// Those with a verdict.
std::vector<published_claim> claims_with(const std::vector<published_claim>& claims, verdict judged);

/// Those of a severity, by its name.
std::vector<published_claim> claims_of_severity(const std::vector<published_claim>& claims,
                                                const std::string& severity);

/// "fig:subcrit (figure 4)": the label, followed by its place in print if that is different.
std::string place_of(const published_claim& each);

/// The whole text of a file. Throws std::runtime_error.
std::string text_of(const std::string& path);

}  // namespace libration
