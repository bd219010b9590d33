// Parts of a self-contained HTML page.
#pragma once

#include <string>

namespace libration {

/// Text as HTML shows it.
std::string html_text(const std::string& text);

/// The same with formulas as html_mathematics writes them, and text between backticks as code.
std::string html_prose(const std::string& text);

/// An SVG image as a data: URI for an attribute in double quotes, with the few characters escaped that are not allowed
/// there: two thirds of the size in base64. Its double quotes become single ones, so it must not contain text with either.
std::string svg_uri(const std::string& svg);

/// A whole page: title, style and body.
std::string html_page(const std::string& title, const std::string& body);

}  // namespace libration
