// SPDX-License-Identifier: GPL-3.0-or-later
//
// Operations of a film's step cell by cell, on padded arrays of one size: pressures p [Pa], volumes V [m^3], contents V
// p [Pa m^3].
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace touchdown {

/// Sum of a b.
double product(std::span<const double> a, std::span<const double> b);
/// Sum of (p + change - content/volume)^2 where there is a volume.
double unforeseenSquares(std::span<const double> change, std::span<const double> p, std::span<const double> content,
                         std::span<const double> volume);
/// history = the shares [1/s] of three contents, from the last one back; none where there is no volume.
void setHistories(std::size_t count, const std::array<double, 3>& share, const double* volume, const double* content1,
                  const double* content2, const double* content3, double* history);
/// Pressures from the last four contents by the weights of a parabola and of the third difference, over the volume; at
/// most doubled or halved against the last ones. `foreseen` is the content by the parabola alone. Without a volume they
/// are the last pressures.
void extrapolate(std::size_t count, const std::array<double, 3>& parabola, const std::array<double, 4>& third,
                 const std::array<const double*, 4>& content, const double* last, const double* volume, double* p,
                 double* foreseen);
/// Keeps pressures and contents; returns how many cells have no content that had some before.
long long setContents(std::size_t count, const double* volume, const double* p, const double* before, double* pressure,
                      double* content);
/// change *= sqrt(volume at the linearisation/volume now), within a factor of two.
void scaleToVolumes(std::size_t count, const double* before, const double* now, double* change);
/// change = -(sum of responses times dq); zero; to = from.
void setChange(const std::array<const double*, 3>& responses, const std::array<double, 3>& dq,
               std::span<double> change);
void clearAll(std::span<double> v);
void copyAll(std::span<const double> from, std::span<double> to);
/// out = -v; image = -residual - image.
void setNegative(std::span<const double> v, std::span<double> out);
void setLeft(std::span<const double> residual, std::span<double> image);
/// out -= part v
void subtract(double part, const std::vector<double>& v, std::vector<double>& out);

} // namespace touchdown
