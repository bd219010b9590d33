// Parts of a self-contained HTML page.
#pragma once

#include <string>

namespace libration {

/// Text as HTML shows it.
std::string html_text(const std::string& text);

/// Plain text as HTML with symbols and indices: theta and omega0 are written in Greek, a_n and T*^(N+1) with subscripts
/// and superscripts, 2.5e-7 as a power of ten, sqrt as a root, <= and +- as one sign, and a minus between blanks as
/// one. Everything else is unchanged, with & < > " escaped.
std::string html_mathematics(const std::string& text);

/// Text with formulas as html_mathematics writes them, and text between backticks as code.
std::string html_prose(const std::string& text);

/// An SVG image as a data: URI for an attribute in double quotes, with the few characters escaped that are not allowed
/// there: two thirds of the size in base64. Its double quotes become single ones, so it must not contain text with
/// either.
std::string svg_uri(const std::string& svg);

/// A whole page: title, style and body.
std::string html_page(const std::string& title, const std::string& body);

}  // namespace libration
