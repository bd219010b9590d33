// Initial value problems in double by CVODE of SUNDIALS, for the study `solvers`: see equation_code.hpp.
#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sundials/sundials_config.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include <algorithm>
#include <memory>

#include "equation_code.hpp"

namespace {

int slopes(realtype t, N_Vector y, N_Vector out, void* of) {
    return static_cast<peers::equations*>(of)->slopes(t, N_VGetArrayPointer(y), N_VGetArrayPointer(out)) ? 0 : -1;
}

void silent(int, const char*, const char*, char*, void*) {}

// What CVODE needs, freed in the opposite order.
struct run_of_cvode {
    SUNContext context = nullptr;
    N_Vector y = nullptr;
    N_Vector tolerances = nullptr;
    SUNMatrix matrix = nullptr;
    SUNLinearSolver linear = nullptr;
    SUNNonlinearSolver fixed_point = nullptr;
    void* memory = nullptr;

    run_of_cvode() { SUNContext_Create(nullptr, &context); }
    run_of_cvode(const run_of_cvode&) = delete;
    run_of_cvode& operator=(const run_of_cvode&) = delete;
    ~run_of_cvode() {
        CVodeFree(&memory);
        SUNNonlinSolFree(fixed_point);
        SUNLinSolFree(linear);
        SUNMatDestroy(matrix);
        N_VDestroy(tolerances);
        N_VDestroy(y);
        SUNContext_Free(&context);
    }
};

void require(int code) {
    if (code < 0) {
        throw peers::no_answer();
    }
}

void solve(peers::equations& of, const std::string& method, double tolerance, std::vector<double>& values) {
    const bool stiff = method == "cvode-bdf";
    if (!stiff && method != "cvode-adams") {
        throw peers::no_answer();
    }
    const auto size = static_cast<sunindextype>(of.size());
    run_of_cvode run;
    run.y = N_VNew_Serial(size, run.context);
    std::copy(of.start.begin(), of.start.end(), N_VGetArrayPointer(run.y));
    run.tolerances = N_VNew_Serial(size, run.context);
    std::transform(of.scale.begin(), of.scale.end(), N_VGetArrayPointer(run.tolerances),
                   [&](double scale) { return tolerance * scale; });
    run.memory = CVodeCreate(stiff ? CV_BDF : CV_ADAMS, run.context);
    require(CVodeInit(run.memory, slopes, of.begin, run.y));
    require(CVodeSetErrHandlerFn(run.memory, silent, nullptr));
    require(CVodeSetUserData(run.memory, &of));
    require(CVodeSVtolerances(run.memory, tolerance, run.tolerances));
    require(CVodeSetMaxNumSteps(run.memory, of.limit));
    if (stiff) {
        run.matrix = SUNDenseMatrix(size, size, run.context);
        run.linear = SUNLinSol_Dense(run.y, run.matrix, run.context);
        require(CVodeSetLinearSolver(run.memory, run.linear, run.matrix));
    } else {
        run.fixed_point = SUNNonlinSol_FixedPoint(run.y, 0, run.context);
        require(CVodeSetNonlinearSolver(run.memory, run.fixed_point));
    }
    for (const double end : of.times) {
        double reached = 0;
        require(CVodeSetStopTime(run.memory, end));
        require(CVode(run.memory, end, run.y, &reached, CV_NORMAL));
        const double* const y = N_VGetArrayPointer(run.y);
        values.insert(values.end(), y, y + of.size());
    }
}

}  // namespace

int main() { return peers::answer("SUNDIALS " SUNDIALS_VERSION, solve); }
