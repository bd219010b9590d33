#include "text/html.hpp"

#include <algorithm>
#include <cstddef>

namespace libration {

namespace {

constexpr const char* style = R"css(
:root { color-scheme: light; --ink: #1d232a; --soft: #57606a; --line: #d8dee4; --paper: #fff; --wash: #f6f8fa;
  --link: #0b5cad; --holds: #00694a; --corrected: #8a5a00; --fails: #a63a00; }
* { box-sizing: border-box; }
html { scroll-behavior: smooth; }
body { margin: 0; color: var(--ink); background: var(--paper); font: 1rem/1.55 system-ui, "DejaVu Sans", sans-serif; }
main, header > div, footer { max-width: 74rem; margin: 0 auto; padding: 0 1.25rem; }
header { background: var(--wash); border-bottom: 1px solid var(--line); padding: 2.2rem 0 1.4rem; }
h1 { font-size: 1.9rem; line-height: 1.2; margin: 0 0 .6rem; }
h2 { font-size: 1.4rem; margin: 3rem 0 .8rem; padding-bottom: .3rem; border-bottom: 2px solid var(--line); }
h3 { font-size: 1.12rem; margin: 0 0 .4rem; }
p, ul, ol { max-width: 52rem; margin: .5rem 0; }
a { color: var(--link); }
code { font: .88em/1.4 ui-monospace, "DejaVu Sans Mono", monospace; background: var(--wash); border-radius: 4px;
  padding: .1em .3em; overflow-wrap: anywhere; }
nav { display: flex; flex-wrap: wrap; gap: .3rem 1.1rem; margin-top: 1rem; font-size: .95rem; }
.soft { color: var(--soft); }
.tally { display: flex; flex-wrap: wrap; gap: .7rem; margin: 1.1rem 0; padding: 0; list-style: none; max-width: none; }
.tally li { border: 1px solid var(--line); border-left: 6px solid; border-radius: 6px; padding: .5rem 1rem; background: var(--paper); }
.tally b { font-size: 1.5rem; display: block; line-height: 1.2; }
.holds { border-left-color: var(--holds) !important; } .corrected { border-left-color: var(--corrected) !important; }
.fails { border-left-color: var(--fails) !important; }
section.study { padding: 1.6rem 0 1.2rem; border-bottom: 1px solid var(--line); }
.question { font-style: italic; color: var(--soft); }
figure { margin: 1rem 0; overflow-x: auto; }
figure img { display: block; width: 100%; height: auto; border: 1px solid var(--line); border-radius: 6px; background: #fff; }
.files { font-size: .92rem; }
.cards { display: grid; grid-template-columns: repeat(auto-fill, minmax(min(100%, 32rem), 1fr)); gap: .8rem; margin: 1rem 0; }
article { border: 1px solid var(--line); border-left: 6px solid; border-radius: 6px; padding: .8rem 1rem; min-width: 0; }
article p { margin: .35rem 0; max-width: 62rem; }
article .meta { color: var(--soft); font-size: .9rem; }
.chip { font-weight: 600; }
.chip.holds { color: var(--holds); } .chip.corrected { color: var(--corrected); } .chip.fails { color: var(--fails); }
.scroll { overflow-x: auto; }
table { border-collapse: collapse; font-size: .95rem; }
th, td { text-align: left; vertical-align: top; padding: .35rem .9rem .35rem 0; border-bottom: 1px solid var(--line); }
footer { padding: 2.5rem 1.25rem; color: var(--soft); font-size: .92rem; }
@media (max-width: 40rem) { h1 { font-size: 1.5rem; } header { padding-top: 1.4rem; } figure img { min-width: 40rem; }
  figure::before { content: "swipe the figure sideways, or tap it to open it alone"; display: block; font-size: .8rem; color: var(--soft); position: sticky; left: 0; } }
)css";

}  // namespace

std::string html_text(const std::string& text) {
    std::string out;
    for (const char c : text) {
        switch (c) {
            case '&': out += "&amp;"; break;
            case '<': out += "&lt;"; break;
            case '>': out += "&gt;"; break;
            case '"': out += "&quot;"; break;
            default: out += c;
        }
    }
    return out;
}

std::string html_prose(const std::string& text) {
    std::string out;
    bool code = false;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find('`', begin), text.size());
        const std::string part = text.substr(begin, end - begin);
        out += code ? "<code>" + html_text(part) + "</code>" : html_mathematics(part);
        code = !code;
        begin = end + 1;
    }
    return out;
}

std::string svg_uri(const std::string& svg) {
    std::string out = "data:image/svg+xml,";
    for (const char c : svg) {
        switch (c) {
            case '%': out += "%25"; break;
            case '#': out += "%23"; break;
            case '"': out += "'"; break;
            case '&': out += "&amp;"; break;
            case '\n': out += ' '; break;
            default: out += c;
        }
    }
    return out;
}

std::string html_page(const std::string& title, const std::string& body) {
    return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
           "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
           "<link rel=\"icon\" href=\"data:,\">\n<title>" +
           html_text(title) + "</title>\n<style>" + style + "</style>\n</head>\n<body>\n" + body + "</body>\n</html>\n";
}

}  // namespace libration
