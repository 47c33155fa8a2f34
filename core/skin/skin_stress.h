#pragma once

#include "core/mechanics/object_strain.h"
#include "core/skin/free_surface.h"
#include "core/skin/skin_gradients.h"

#include <span>
#include <vector>

namespace knead {

/// Von Mises stress at the points of a surface.
struct SkinStresses {
    std::vector<float> vonMises; ///< [Pa]
    std::vector<float> error; ///< about how wrong that may be, by the resolution [Pa]; empty when it was not asked for
    double errorShare = 0;    ///< the same where stress is largest, as a share of it: "about +-8 %" is 0.08
};

/// Strain and stress at points, in world axes.
struct SkinTensors {
    std::vector<Mat3> strain; ///< Hencky, ln sqrt(F F^T), flow included
    std::vector<Mat3> stress; ///< Cauchy [Pa]
};

/// Strain and stress of the material at the skin of a body, prepared for many moments.
///
/// Objects are inside of the material, and their strain is a mean over two spacings. At the skin, F is the gradient of the
/// quadratic map that carries it (skin_gradients.h), and the metric C of what has flowed the mean of the objects' ln C, each with
/// its share in the skin: of logarithms, so that C stays positive and flow without change of volume is one here, too, where
/// shares are negative. cauchyStress() makes the stress of both. What presses on a free surface is nothing: the traction that is
/// left of errors is taken off (free_surface.h), but around objects that something holds or presses on, where it is real. Last,
/// the von Mises stress is limited to what the material can bear.
///
/// Beside broken connections, and where objects lie in a plane or on a line, F says nothing: there the stress is that of the
/// objects, each with its share.
///
/// The error is estimated by how much the stress changes within what the objects resolve: by its difference from the mean of the
/// objects around the point, which lies about a spacing deeper. Where the skin goes inwards, as in holes and fillets, stress rises
/// within their radius, and the lattice may have smeared that before anything is read: there the estimate is at least
/// errorPerHollow times spacing over radius. It knows nothing of what else is wrong, such as a wall that is too stiff.
/// Points may lie inside of the material as well, those with FreeSurface::Kind::none: there nothing is taken off.
/// Immutable after construction. Any thread; uses several. About 0.5 us a point and moment on one core where nothing has flowed,
/// 1.5 us with the error.
class SkinStress {
public:
    /// So much of that difference is taken for the error. Bars bent to a given curvature, 2, 4 and 6 cells across, were 3, 1 and
    /// 0.5 % off, where it says 22, 11 and 7 %; under a given load 16, 5 and 2 %; holes of 4 to 12 cells mostly 5 to 12 %, where it
    /// says 10 to 16 %.
    static constexpr double errorPerDifference = 0.4;

    /// Around holes of 6 to 16 cells across in a strip that is pulled, at 12 spacings, stress was off by up to .85 of the largest
    /// times the spacing by their radius. Chosen on other holes.
    static constexpr double errorPerHollow = 0.9;

    /// @param surface a mesh, or points of one with what is known of the air around them
    /// @param numbers of the aggregate's objects in the body that they are a piece of, which then has no broken connections of its
    /// own; empty: it is the body
    /// @throws std::invalid_argument for an aggregate without objects. @throws Cancelled
    SkinStress(const Aggregate& aggregate, const TriangleMesh& mesh, std::span<const ObjectIndex> numbers = {},
               TaskControl& control = TaskControl::none());
    SkinStress(const Aggregate& aggregate, std::span<const Vec3> points, std::vector<FreeSurface> surfaces,
               std::span<const ObjectIndex> numbers = {}, TaskControl& control = TaskControl::none());

    std::size_t size() const { return m_surfaces.size(); }

    /// @param body of which the aggregate is all or a piece
    /// @param loaded objects of it that something holds or presses on; in any order
    SkinStresses stresses(const ObjectStrains& body, std::span<const ObjectIndex> loaded, bool wantsError) const;

    /// Equivalent strain at the points, flow included.
    std::vector<float> strains(const ObjectStrains& body) const;

    /// The tensors that both are numbers of. @param loaded as above
    SkinTensors tensors(const ObjectStrains& body, std::span<const ObjectIndex> loaded) const;

private:
    bool m_isPiece;
    double m_spacing; ///< [m]
    SkinGradients m_gradients;
    std::vector<FreeSurface> m_surfaces;
};

} // namespace knead
