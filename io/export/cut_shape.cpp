#include "io/export/cut_shape.h"

#include <Eigen/Dense>
#include <Eigen/Eigenvalues>

#include <BRepAlgoAPI_Splitter.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepClass3d_SolidClassifier.hxx>
#include <BRep_Builder.hxx>
#include <GeomAPI_PointsToBSplineSurface.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Standard_Failure.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Face.hxx>
#include <gp_Ax3.hxx>
#include <gp_Pln.hxx>

#include <algorithm>
#include <cmath>

namespace knead {

namespace {

// A cut goes on beyond the places that are known of it, which end in the last connections below the skin [spacings].
constexpr double beyond = 2;
// What is nearer to a plane than this is one, and what a surface is nearer to than this is met [spacings].
constexpr double flatCut = 0.01;
constexpr double nearCut = 0.05;
constexpr int highestDegree = 4;
constexpr int gridPoints = 16;        // along a surface that is no plane
constexpr double fitTolerance = 1e-4; // of such a surface [mm]
constexpr double classified = 1e-6;   // [mm]

gp_Pnt pointOf(const Vec3& place)
{
    return {place.x(), place.y(), place.z()};
}

/// Places of a cut over the plane that lies best between them.
class Sheet {
public:
    /// @param places [m]
    Sheet(const std::vector<Vec3>& places, double spacing)
        : m_spacing(1e3 * spacing)
    {
        for (const Vec3& place : places)
            m_middle += 1e3 * place / static_cast<double>(places.size());
        Mat3 moments = Mat3::Zero();
        for (const Vec3& place : places)
            moments += (1e3 * place - m_middle) * (1e3 * place - m_middle).transpose();
        const Eigen::SelfAdjointEigenSolver<Mat3> principal(moments);
        m_axes.col(0) = principal.eigenvectors().col(2);
        m_axes.col(1) = principal.eigenvectors().col(1);
        m_axes.col(2) = m_axes.col(0).cross(m_axes.col(1));
        for (const Vec3& place : places) {
            m_local.push_back(m_axes.transpose() * (1e3 * place - m_middle));
            m_box.extend(m_local.back());
        }
    }

    TopoDS_Face face() const
    {
        const Vec3 low = m_box.min() - Vec3::Constant(beyond * m_spacing);
        const Vec3 high = m_box.max() + Vec3::Constant(beyond * m_spacing);
        const double thickest = m_box.sizes().z();
        if (thickest < 2 * flatCut * m_spacing) {
            const gp_Ax3 frame(pointOf(m_middle), gp_Dir(pointOf(m_axes.col(2)).XYZ()),
                               gp_Dir(pointOf(m_axes.col(0)).XYZ()));
            return BRepBuilderAPI_MakeFace(gp_Pln(frame), low.x(), high.x(), low.y(), high.y()).Face();
        }
        const Eigen::VectorXd heights = fitted();
        TColgp_Array2OfPnt grid(1, gridPoints, 1, gridPoints);
        for (int i = 0; i < gridPoints; ++i)
            for (int k = 0; k < gridPoints; ++k) {
                const double u = low.x() + (high.x() - low.x()) * i / (gridPoints - 1);
                const double v = low.y() + (high.y() - low.y()) * k / (gridPoints - 1);
                grid.SetValue(i + 1, k + 1,
                              pointOf(m_middle + m_axes * Vec3(u, v, basisAt(u, v, degreeOf(heights)).dot(heights))));
            }
        const Handle(Geom_BSplineSurface) surface =
            GeomAPI_PointsToBSplineSurface(grid, 3, 8, GeomAbs_C2, fitTolerance).Surface();
        return BRepBuilderAPI_MakeFace(surface, classified).Face();
    }

private:
    static int countOf(int degree) { return (degree + 1) * (degree + 2) / 2; }
    static int degreeOf(const Eigen::VectorXd& heights)
    {
        int degree = 0;
        while (countOf(degree) < heights.size())
            ++degree;
        return degree;
    }

    /// Polynomials up to a degree, in lengths of the sheet.
    Eigen::VectorXd basisAt(double u, double v, int degree) const
    {
        const double scale = 2 / m_box.sizes().head<2>().maxCoeff();
        Eigen::VectorXd basis(countOf(degree));
        int n = 0;
        for (int total = 0; total <= degree; ++total)
            for (int i = 0; i <= total; ++i)
                basis[n++] = std::pow(scale * u, total - i) * std::pow(scale * v, i);
        return basis;
    }

    /// The polynomial of the lowest degree that comes near; they go on beyond the sheet, which high ones do badly.
    Eigen::VectorXd fitted() const
    {
        Eigen::VectorXd heights;
        for (int degree = 1; degree <= highestDegree; ++degree) {
            if (static_cast<std::size_t>(3 * countOf(degree)) > m_local.size() && degree > 1)
                break;
            Eigen::MatrixXd rows(static_cast<Eigen::Index>(m_local.size()), countOf(degree));
            Eigen::VectorXd wanted(rows.rows());
            for (Eigen::Index i = 0; i < rows.rows(); ++i) {
                const Vec3& local = m_local[static_cast<std::size_t>(i)];
                rows.row(i) = basisAt(local.x(), local.y(), degree);
                wanted[i] = local.z();
            }
            heights = rows.colPivHouseholderQr().solve(wanted);
            if ((rows * heights - wanted).norm() < nearCut * m_spacing * std::sqrt(static_cast<double>(rows.rows())))
                break;
        }
        return heights;
    }

    double m_spacing; // [mm]
    Vec3 m_middle = Vec3::Zero();
    Mat3 m_axes;
    std::vector<Vec3> m_local; // of the places, in these axes
    Box m_box;
};

std::size_t countWithin(const TopoDS_Shape& solid, const std::vector<Vec3>& places)
{
    BRepClass3d_SolidClassifier classifier(solid);
    return static_cast<std::size_t>(std::count_if(places.begin(), places.end(), [&](const Vec3& place) {
        classifier.Perform(pointOf(1e3 * place), classified);
        return classifier.State() == TopAbs_IN;
    }));
}

/// Which face of the whole each face of the piece is a part of.
std::vector<std::uint32_t> originsOf(const TopoDS_Shape& whole, const TopoDS_Shape& piece,
                                     BRepAlgoAPI_Splitter& splitter)
{
    TopTools_IndexedMapOfShape before;
    TopTools_IndexedMapOfShape after;
    TopExp::MapShapes(whole, TopAbs_FACE, before);
    TopExp::MapShapes(piece, TopAbs_FACE, after);
    std::vector<std::uint32_t> origin(static_cast<std::size_t>(after.Extent()), CutShape::noFace);
    const auto note = [&](const TopoDS_Shape& face, int from) {
        if (const int index = after.FindIndex(face); index > 0)
            origin[static_cast<std::size_t>(index - 1)] = static_cast<std::uint32_t>(from - 1);
    };
    for (int i = 1; i <= before.Extent(); ++i) {
        note(before(i), i);
        for (const TopoDS_Shape& part : splitter.Modified(before(i)))
            note(part, i);
    }
    return origin;
}

} // namespace

std::optional<CutShape> cutShape(const TopoDS_Shape& whole, const PieceCut& cut)
{
    try {
        TopTools_ListOfShape arguments;
        arguments.Append(whole);
        TopTools_ListOfShape tools;
        for (const std::vector<Vec3>& sheet : cut.sheets)
            tools.Append(Sheet(sheet, cut.spacing).face());
        BRepAlgoAPI_Splitter splitter;
        splitter.SetArguments(arguments);
        splitter.SetTools(tools);
        splitter.Build();
        if (splitter.HasErrors())
            return {};
        TopoDS_Compound compound;
        BRep_Builder builder;
        builder.MakeCompound(compound);
        TopoDS_Shape only;
        std::size_t solids = 0;
        std::size_t found = 0;
        for (TopExp_Explorer solid(splitter.Shape(), TopAbs_SOLID); solid.More(); solid.Next()) {
            const std::size_t inside = countWithin(solid.Current(), cut.inside);
            if (inside == 0)
                continue;
            if (countWithin(solid.Current(), cut.outside) > 0)
                return {};
            found += inside;
            only = solid.Current();
            builder.Add(compound, only);
            ++solids;
        }
        if (solids == 0 || found < cut.inside.size())
            return {};
        CutShape result{.shape = solids == 1 ? only : compound, .origin = {}};
        if (!BRepCheck_Analyzer(result.shape).IsValid())
            return {};
        result.origin = originsOf(whole, result.shape, splitter);
        return result;
    } catch (const Standard_Failure&) {
        return {};
    }
}

} // namespace knead
