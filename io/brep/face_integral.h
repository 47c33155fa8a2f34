#pragma once

class TopoDS_Shape;

namespace knead {

/// Integrals over the faces of a shape.
struct FaceIntegrals {
    double area = 0;   ///< [mm^2]
    double volume = 0; ///< [mm^3]; negative when the faces look inward, of no meaning when they do not close
};

/// Gauss integration, both integrals in one pass, faces beside each other on all cores. Pieces end where splines have their
/// knots, so that smooth functions are integrated; edges along which the inner integral or the step is zero cost nothing,
/// which on a patch is three of four. The sum has the same bits for any number of threads.
/// Infinite when a face is.
FaceIntegrals faceIntegralsOf(const TopoDS_Shape& shape);

} // namespace knead
