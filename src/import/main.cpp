// libration-import FILE: prints a model in SBML as a problem of libration. Exit status: 2 if it cannot be read or
// expressed.
#include <sbml/SBMLTypes.h>

#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <memory>
#include <string>

#include "expansion.hpp"
#include "formula.hpp"
#include "model_text.hpp"

namespace {

using libration::import::incomplete;
using libration::import::unsupported;

// The first error of a document.
std::string first_error(const SBMLDocument& document) {
    for (unsigned int i = 0; i < document.getNumErrors(); ++i) {
        const SBMLError& each = *document.getError(i);
        if (each.isError() || each.isFatal()) {
            std::string message = each.getShortMessage();
            return fmt::format("line {}: {}", each.getLine(), message.empty() ? each.getMessage() : message);
        }
    }
    return {};
}

std::string text_of(const std::string& file) {
    const std::unique_ptr<SBMLDocument> document(readSBMLFromFile(file.c_str()));
    if (const std::string wrong = first_error(*document); !wrong.empty()) {
        throw std::runtime_error("is not read (" + wrong + "): give a file in SBML");
    }
    if (document->getModel() == nullptr) {
        throw std::runtime_error("contains no model: give one that does");
    }
    Model& model = *document->getModel();
    libration::import::expand_functions(model);
    libration::import::promote_local_parameters(model);
    return libration::import::model_text(model);
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        fmt::print(stderr, "libration: import requires one file: write libration import model.xml\n");
        return 2;
    }
    const std::string file = argv[1];
    try {
        fmt::print("{}", text_of(file));
        return 0;
    } catch (const unsupported& what) {
        fmt::print(stderr, "libration: FILE '{}' contains {}, which is not supported: replace it in the model\n", file,
                   what.what());
    } catch (const incomplete& what) {
        fmt::print(stderr, "libration: FILE '{}' has {}: {}\n", file, what.what(), what.remedy());
    } catch (const std::exception& problem) {
        fmt::print(stderr, "libration: FILE '{}' {}\n", file, problem.what());
    }
    return 2;
}
