// The pages of a results folder, made of its files: the index in Markdown, the errata, the report.
#pragma once

#include <string>

#include "published.hpp"

namespace libration {

/// README.md of a results folder: the claims table and the list of studies.
std::string results_readme(const published& results);

/// errata.md: studies/errata.md.in with each {{NAME}} replaced by the measured number of the claim NAME, and each
/// {{printed LABEL}} by the number that the paper prints. Throws std::runtime_error for a claim or a label that there is
/// not, and where a claim does not hold and no placeholder or name mentions it.
std::string errata_page(const published& results, const std::string& outline);

/// index.html: one page that needs no network, with figures, claims, links to the tables, and provenance.
std::string report_page(const published& results);

/// Writes the three of them, and claims.tex, into the folder.
void write_report(const std::string& folder);

}  // namespace libration
