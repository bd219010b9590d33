// The radius of convergence and the nearest singularities from a list of coefficients: start with report_on_list(), or
// with report_on_radius() for coefficients that are already scaled to their unit.
#pragma once

#include "libration/convergence/coefficient_list.hpp"
#include "libration/convergence/coefficient_unit.hpp"
#include "libration/convergence/list_report.hpp"
#include "libration/convergence/radius_report.hpp"
#include "libration/convergence/radius_verdict.hpp"
