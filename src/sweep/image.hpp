// Drawings as a program left them: whether they are whole, and what they still lack for print and for the page.
#pragma once

#include <string>

namespace libration {

/// Whether the file ends as its kind does: a PNG with its chunk IEND, a PDF with %%EOF, an SVG with </svg>. A drawing
/// that was cut short, by a full disk say, does not. False for other kinds. `extension` is ".png", ".pdf" or ".svg".
bool is_whole_image(const std::string& extension, const std::string& content);

/// The same drawing: PNG says that it has 300 dots an inch (chunk pHYs [PNG, 11.3.4.3]), SVG loses what draws nothing,
/// the titles of its curves and the second decimal of its pixels, PDF says no time of day, so that the same drawing has the same bytes.
std::string finished_image(const std::string& extension, const std::string& content);

}  // namespace libration
