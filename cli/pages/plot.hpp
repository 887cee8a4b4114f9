#pragma once
/// Pictures that commands draw.

#include <subcert/analysis/regularity/multivariate_regularity.hpp>
#include <subcert/reports/formats/figure.hpp>
#include <subcert/schemes/data/formats/table.hpp>
#include <subcert/schemes/data/refine/grid_data.hpp>
#include <subcert/schemes/specification.hpp>

#include <string>
#include <utility>
#include <vector>

namespace subcert::cli {

/// Throws a usage error for a file that is neither .svg nor .png; an empty name draws nothing.
void require_picture_name(const std::string& plot);

/// Throws a usage error for data that draw_refined() cannot draw.
void require_drawable(const std::string& plot, const data::GridData<double>& data);

/// What a scheme made of data, by its name.
using NamedGrid = std::pair<std::string, data::GridData<double>>;

/// Data and what schemes made of them, in one picture: curves of one or two coordinates, named by the header of
/// `table`, or surfaces of one or three. Domain: one scheme or more. Errors: throws missing_file.
void draw_refined(const std::string& plot, const data::Table& table, const data::GridData<double>& data,
                  const std::vector<NamedGrid>& refined);

/// Throws a usage error for a picture of a limit function of three variables.
void require_drawable(const std::string& plot, const Scheme& scheme);

/// The basic limit function by exact values, or, where convergence is not proved, the unit sequence after some steps.
/// Domain: as require_drawable(). Errors: throws missing_file.
void draw_limit(const std::string& plot, const Scheme& scheme, const Decision& convergence);

/// All functions of a vector. Domain: one variable, proved continuous, one solution up to a factor, rational matrices.
/// Errors: throws an undecided error otherwise, or missing_file.
void draw_vector(const std::string& plot, const Scheme& scheme, const FunctionVector& vector);

}  // namespace subcert::cli
