// The radius of convergence and the nearest singularities from a list of coefficients: start with report_on_radius().
#pragma once

#include "libration/convergence/list/coefficient_list.hpp"
#include "libration/convergence/list/coefficient_unit.hpp"
#include "libration/convergence/radius_report.hpp"
#include "libration/convergence/radius_verdict.hpp"
