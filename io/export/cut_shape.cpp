#include "io/export/cut_shape.h"

#include "core/geometry/disjoint_sets.h"

#include <Eigen/Dense>
#include <Eigen/Eigenvalues>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Splitter.hxx>
#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepClass3d_SolidClassifier.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRep_Builder.hxx>
#include <Bnd_Box.hxx>
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
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <gp_Ax3.hxx>
#include <gp_Pln.hxx>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <span>
#include <utility>

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
constexpr double hair = 5e-3;         // width of a slit at its mouth [spacings]

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

/// What became of a shape in steps.
std::vector<TopoDS_Shape> imagesOf(const TopoDS_Shape& shape, std::span<BRepAlgoAPI_BuilderAlgo* const> steps)
{
    std::vector<TopoDS_Shape> images{shape};
    for (BRepAlgoAPI_BuilderAlgo* step : steps) {
        std::vector<TopoDS_Shape> next;
        for (const TopoDS_Shape& image : images) {
            const TopTools_ListOfShape& parts = step->Modified(image);
            if (parts.IsEmpty())
                next.push_back(image);
            next.insert(next.end(), parts.begin(), parts.end());
        }
        images = std::move(next);
    }
    return images;
}

/// Which face of the whole each face of the piece is a part of.
/// @param steps that made the one of the other
std::vector<std::uint32_t> originsOf(const TopoDS_Shape& whole, const TopoDS_Shape& piece,
                                     std::span<BRepAlgoAPI_BuilderAlgo* const> steps)
{
    TopTools_IndexedMapOfShape before;
    TopTools_IndexedMapOfShape after;
    TopExp::MapShapes(whole, TopAbs_FACE, before);
    TopExp::MapShapes(piece, TopAbs_FACE, after);
    std::vector<std::uint32_t> origin(static_cast<std::size_t>(after.Extent()), CutShape::noFace);
    for (int i = 1; i <= before.Extent(); ++i)
        for (const TopoDS_Shape& part : imagesOf(before(i), steps))
            if (const int index = after.FindIndex(part); index > 0)
                origin[static_cast<std::size_t>(index - 1)] = static_cast<std::uint32_t>(i - 1);
    return origin;
}

std::size_t solidsIn(const TopoDS_Shape& shape)
{
    std::size_t count = 0;
    for (TopExp_Explorer solid(shape, TopAbs_SOLID); solid.More(); solid.Next())
        ++count;
    return count;
}

/// As wide as a hair at its mouth, and nothing at its tip.
TopoDS_Shape slitSolid(const KnifeSlit& slit)
{
    const Vec3 from = 1e3 * (slit.origin - slit.halfTip * slit.along);
    const Vec3 way = 1e3 * slit.length * slit.opening;
    const Vec3 half = 1e3 * hair / 2 * slit.spacing * slit.normal();
    BRepBuilderAPI_MakePolygon outline;
    if (slit.hasTip) {
        outline.Add(pointOf(from));
    } else {
        outline.Add(pointOf(from + half));
        outline.Add(pointOf(from - half));
    }
    outline.Add(pointOf(from + way - half));
    outline.Add(pointOf(from + way + half));
    outline.Close();
    const Vec3 along = 2e3 * slit.halfTip * slit.along;
    return BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(outline.Wire(), true).Face(),
                                 gp_Vec(along.x(), along.y(), along.z()))
        .Shape();
}

/// The plane of a slit, through all of a solid: no surface of the skin may be on both sides of it, since none can follow them both.
TopoDS_Face planeOf(const KnifeSlit& slit, double size)
{
    const Vec3 normal = slit.normal();
    const gp_Pln plane(pointOf(1e3 * slit.origin), gp_Dir(normal.x(), normal.y(), normal.z()));
    return BRepBuilderAPI_MakeFace(plane, -size, size, -size, size).Face();
}

/// The solids of a shape as one, without the faces between them.
TopoDS_Solid joinedOverShared(const TopoDS_Shape& shape)
{
    TopTools_IndexedMapOfShape faces;
    std::vector<int> count;
    std::vector<TopoDS_Shape> oriented;
    for (TopExp_Explorer solid(shape, TopAbs_SOLID); solid.More(); solid.Next())
        for (TopExp_Explorer face(solid.Current(), TopAbs_FACE); face.More(); face.Next()) {
            const auto index = static_cast<std::size_t>(faces.Add(face.Current()));
            count.resize(std::max(count.size(), index + 1), 0);
            oriented.resize(count.size());
            ++count[index];
            oriented[index] = face.Current();
        }
    TopTools_IndexedMapOfShape edges; // faces that share any make a shell
    DisjointSets sets(count.size());
    std::vector<std::size_t> faceOfEdge;
    for (std::size_t i = 1; i < count.size(); ++i)
        for (TopExp_Explorer edge(oriented[i], TopAbs_EDGE); count[i] == 1 && edge.More(); edge.Next()) {
            const auto index = static_cast<std::size_t>(edges.Add(edge.Current()));
            faceOfEdge.resize(std::max(faceOfEdge.size(), index + 1), i);
            sets.join(i, faceOfEdge[index]);
        }
    BRep_Builder builder;
    std::map<std::size_t, TopoDS_Shell> shells;
    for (std::size_t i = 1; i < count.size(); ++i) {
        if (count[i] != 1)
            continue;
        const auto [shell, isNew] = shells.try_emplace(sets.find(i));
        if (isNew)
            builder.MakeShell(shell->second);
        builder.Add(shell->second, oriented[i]);
    }
    TopoDS_Solid joined;
    builder.MakeSolid(joined);
    for (auto& [set, shell] : shells) {
        shell.Closed(true);
        builder.Add(joined, shell);
    }
    return joined;
}

double sizeOf(const TopoDS_Shape& shape)
{
    Bnd_Box box;
    BRepBndLib::Add(shape, box);
    return std::sqrt(box.SquareExtent());
}

TopTools_ListOfShape listOf(const TopoDS_Shape& shape)
{
    TopTools_ListOfShape list;
    list.Append(shape);
    return list;
}

} // namespace

std::optional<CutShape> slitShape(const TopoDS_Shape& whole, const KnifeSlit& slit)
{
    try {
        BRepAlgoAPI_Cut cutter(whole, slitSolid(slit));
        if (cutter.HasErrors() || solidsIn(whole) != 1 || solidsIn(cutter.Shape()) != 1)
            return {};
        BRepAlgoAPI_Splitter splitter;
        splitter.SetArguments(listOf(cutter.Shape()));
        splitter.SetTools(listOf(planeOf(slit, 2 * sizeOf(whole))));
        splitter.Build();
        if (splitter.HasErrors())
            return {};
        CutShape result{.shape = joinedOverShared(splitter.Shape()), .origin = {}};
        if (!BRepCheck_Analyzer(result.shape).IsValid())
            return {};
        result.origin = originsOf(whole, result.shape, std::array<BRepAlgoAPI_BuilderAlgo*, 2>{&cutter, &splitter});
        return result;
    } catch (const Standard_Failure&) {
        return {};
    }
}

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
        result.origin = originsOf(whole, result.shape, std::array<BRepAlgoAPI_BuilderAlgo*, 1>{&splitter});
        return result;
    } catch (const Standard_Failure&) {
        return {};
    }
}

} // namespace knead
