// Drawings as written by a program: a check that they are complete, and their preparation for print and for the page.
#pragma once

#include <string>

namespace libration {

/// Whether the file ends as its kind requires: a PNG with its chunk IEND, a PDF with %%EOF, an SVG with </svg>. This
/// fails for a drawing that was cut short, for example by a full disk. False for other kinds. `extension` is ".png",
/// ".pdf" or ".svg".
bool is_whole_image(const std::string& extension, const std::string& content);

/// The same drawing: a PNG declares 300 dots per inch (chunk pHYs [PNG, 11.3.4.3]), an SVG loses elements that draw
/// nothing, the titles of its curves and the second decimal of its pixels, and keeps the spaces around subscripts and
/// superscripts in every viewer, a PDF has no time of day, so that equal drawings are byte-identical.
std::string finished_image(const std::string& extension, const std::string& content);

}  // namespace libration
