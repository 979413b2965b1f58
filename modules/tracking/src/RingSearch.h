#pragma once
#include <Eigen/Core>
#include <initializer_list>
#include <optional>
#include <utility>

#include "CellDetector.h"

namespace pellucida {

/// A closed edge found in the ring round a centre, and how good it is.
struct RingEdge {
  FoundEdge edge;
  contour::Circle circle;  ///< through the edge's undeformed part
  double score = 0.0;      ///< 0..1: how complete, clear, round, dominant the edge is, and how much of it in the image
  double amplitude = 0.0;  ///< mean feature along the edge, grey value
};

/// Every kind of edge an outline may show: dark and bright line, step up and down.
constexpr std::initializer_list<EdgeKind> kAnyEdgeKind = {{1.0, 0.0}, {-1.0, 0.0}, {0.0, 1.0}, {0.0, -1.0}};

/// The best closed edge between the radii `from` and `to` (px of `image`) round `center`, of the kinds and filter
/// scales given: the ring is unrolled and the closed path of most evidence found by dynamic programming. Score 0 when
/// the ring is empty. `noise`: standard deviation of a pixel; `rays`: places round the ring.
RingEdge best_in_ring(const GrayImage& image, const Eigen::Vector2d& center, double from, double to,
                      std::initializer_list<double> sigmas, double noise, std::initializer_list<EdgeKind> kinds,
                      int rays = 96);

/// The same round an outline (closed, positive area) instead of a circle, from `inward` px inside to `outward` px
/// outside of it. Its shape is known, so that roundness does not count.
RingEdge best_along(const GrayImage& image, const Eigen::Matrix2Xd& outline, double inward, double outward,
                    std::initializer_list<double> sigmas, double noise, std::initializer_list<EdgeKind> kinds,
                    int rays = 96);

/// Two dark lines side by side, found together (outer, inner): a zona whose edges are alike would make a single path
/// hop between them. Nothing where one of them is not closed or far fainter than the other, or no brighter band parts
/// them.
std::optional<std::pair<RingEdge, RingEdge>> pair_in_ring(const GrayImage& image, const Eigen::Vector2d& center,
                                                          double radius, double sigma, double noise,
                                                          const std::pair<double, double>* known = nullptr);

/// A cell lets light through: a pigmented body (an eye, a speck) does not.
bool translucent(const GrayImage& image, const contour::Circle& circle);

}  // namespace pellucida
