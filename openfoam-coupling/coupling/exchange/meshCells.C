// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshCells.H"

#include "PstreamReduceOps.H"
#include "cyclicPolyPatch.H"
#include "polyMesh.H"
#include "processorCyclicPolyPatch.H"
#include "triPointRef.H"

#include <algorithm>
#include <limits>

using namespace cohesion;

namespace
{

constexpr double infinity = std::numeric_limits<double>::infinity();

Vector3 toVector3(const Foam::vector& v)
{
    return {v.x(), v.y(), v.z()};
}

} // End anonymous namespace


class Foam::meshCells::KernelCell
:
    public void_fraction::Cell
{
    const meshCells& cells_;
    const label celli_;

public:

    KernelCell(const meshCells& cells, const label celli)
    :
        cells_(cells),
        celli_(celli)
    {}

    const void_fraction::Box* box() const override
    {
        return cells_.isBox_[celli_] ? &cells_.boxes_[celli_] : nullptr;
    }

    bool contains(const Vector3& at) const override
    {
        const void_fraction::Box& box = cells_.boxes_[celli_];
        if
        (
            at.x < box.low.x || at.x > box.high.x
         || at.y < box.low.y || at.y > box.high.y
         || at.z < box.low.z || at.z > box.high.z
        )
        {
            return false;
        }
        const void_fraction::Box& inner = cells_.inner_[std::size_t(celli_)];
        if
        (
            cells_.isBox_[celli_]
         ||
            (
                at.x > inner.low.x && at.x < inner.high.x
             && at.y > inner.low.y && at.y < inner.high.y
             && at.z > inner.low.z && at.z < inner.high.z
            )
        )
        {
            return true;
        }
        const point where = cells_.inPlane(point(at.x, at.y, at.z), celli_);
        if (!cells_.plane())
        {
            return cells_.mesh_.pointInCell(where, celli_, cells_.decomposition_);
        }
        const auto isBehind = [&](const FacePlane& plane) { return plane.beyond(where) <= 0; };
        return std::all_of(cells_.cut_.begin(), cells_.cut_.end(), isBehind);
    }
};


Foam::polyMesh::cellDecomposition Foam::meshCells::decomposition(const polyMesh& mesh)
{
    // A face that is warped by the share w of its size is larger than its projection by about w^2.
    constexpr scalar warped = 1e-12;
    bool plane = true;
    forAll(mesh.faces(), facei)
    {
        const face& f = mesh.faces()[facei];
        const point& middle = mesh.faceCentres()[facei];
        scalar area = 0;
        forAll(f, k)
        {
            area +=
                triPointRef(mesh.points()[f[k]], mesh.points()[f.nextLabel(k)], middle).mag();
        }
        plane = plane && area < (1 + warped)*mag(mesh.faceAreas()[facei]);
    }
    return returnReduce(plane, andOp<bool>()) ? polyMesh::FACE_PLANES : polyMesh::CELL_TETS;
}


Foam::meshCells::meshCells(const polyMesh& mesh, const void_fraction::Kernel& kernel)
:
    mesh_(mesh),
    kernel_(kernel),
    decomposition_(decomposition(mesh)),
    resolved_(0.5*(vector::one + vector(mesh.geometricD()))),
    search_(mesh, decomposition_),
    boxes_(boxes())
{
    // Demand-driven data that all ranks make together
    search_.cellTree();
    for (label celli = 0; celli < mesh.nCells(); ++celli)
    {
        inner_.push_back(isBox_[celli] ? boxes_[std::size_t(celli)] : innerBox(celli));
    }
}


bool Foam::meshCells::isBox(const label celli, const boundBox& around) const
{
    // A convex cell as large as the box around it may still lack a corner or an edge, as far as the root of what
    // is missing of the volume: then a face lies in none of the box's sides.
    constexpr scalar off = 1e-9;
    const auto liesIn = [&](const face& f, const direction d, const scalar side)
    {
        const auto near = [&](const label pointi)
        {
            return mag(mesh_.points()[pointi][d] - side) <= off*around.span()[d];
        };
        return std::all_of(f.begin(), f.end(), near);
    };
    const auto inAnySide = [&](const label facei)
    {
        const face& f = mesh_.faces()[facei];
        for (direction d = 0; d < 3; ++d)
        {
            if (liesIn(f, d, around.min()[d]) || liesIn(f, d, around.max()[d]))
            {
                return true;
            }
        }
        return false;
    };
    const cell& faces = mesh_.cells()[celli];
    return mesh_.cellVolumes()[celli] > (1 - off)*around.volume()
     && std::all_of(faces.begin(), faces.end(), inAnySide);
}


std::vector<void_fraction::Box> Foam::meshCells::boxes()
{
    std::vector<void_fraction::Box> boxes(mesh_.nCells());
    isBox_.setSize(mesh_.nCells());
    forAll(isBox_, celli)
    {
        boundBox bounds(mesh_.cells()[celli].points(mesh_.faces(), mesh_.points()), false);
        isBox_[celli] = isBox(celli, bounds);
        for (direction d = 0; d < 3; ++d)
        {
            if (mesh_.geometricD()[d] < 0)
            {
                bounds.min()[d] = -infinity;
                bounds.max()[d] = infinity;
            }
        }
        boxes[celli] = {toVector3(bounds.min()), toVector3(bounds.max())};
    }
    return boxes;
}


void Foam::meshCells::find(const point& centre, const scalar half) const
{
    const Vector3 at = toVector3(centre);
    const Vector3 aside{half, half, half};
    boxes_.meeting({at - aside, at + aside}, found_);
}


Foam::point Foam::meshCells::inPlane(const point& at, const label celli) const
{
    return cmptMultiply(resolved_, at) + cmptMultiply(vector::one - resolved_, mesh_.cellCentres()[celli]);
}


Foam::meshCells::OverlapKind Foam::meshCells::overlap(const label celli, const point& centre, const scalar half) const
{
    cut_.clear();
    const point at = inPlane(centre, celli);
    for (const label facei : mesh_.cells()[celli])
    {
        const vector& area = mesh_.faceAreas()[facei];
        const FacePlane plane{mesh_.faceOwner()[facei] == celli ? area : -area, mesh_.faceCentres()[facei]};
        const scalar away = plane.beyond(at);
        // The sphere has no extent in a direction that is not resolved.
        const scalar extent = half*mag(cmptMultiply(resolved_, area));
        if (away > extent)
        {
            return OverlapKind::none;
        }
        if (away > -extent)
        {
            cut_.push_back(plane);
        }
    }
    return cut_.empty() ? OverlapKind::full : OverlapKind::partial;
}


Foam::label Foam::meshCells::findBox(const point& position) const
{
    // In a direction without end the mesh knows where it ends.
    if (!mesh_.bounds().contains(position))
    {
        return -1;
    }
    // Far more than the sides of what counts as a box are off. A side at infinity has no border.
    constexpr scalar border = 1e-6;
    const auto within = [](const scalar low, const scalar at, const scalar high)
    {
        const scalar width = border*(high - low);
        return !(at - low < width || high - at < width);
    };
    find(position, 0);
    for (const label celli : found_)
    {
        const void_fraction::Box& box = inner_[std::size_t(celli)];
        if
        (
            box.low.x < box.high.x
         && within(box.low.x, position.x(), box.high.x)
         && within(box.low.y, position.y(), box.high.y)
         && within(box.low.z, position.z(), box.high.z)
        )
        {
            return celli;
        }
    }
    return -1;
}


Foam::label Foam::meshCells::findCell(const point& position) const
{
    const label box = findBox(position);
    return box >= 0 ? box : search_.findCell(position, -1, true);
}


inline Foam::scalar Foam::meshCells::share
(
    const void_fraction::Sphere& sphere,
    const point& centre,
    const label celli
) const
{
    if (plane() && !isBox_[celli])
    {
        const OverlapKind there = overlap(celli, centre, reach(sphere.radius));
        if (there != OverlapKind::partial)
        {
            return there == OverlapKind::full;
        }
    }
    return kernel_.share(sphere, KernelCell(*this, celli));
}


inline bool Foam::meshCells::isWithinBox(const label celli, const point& centre, const scalar radius) const
{
    const auto within = [&](const scalar low, const scalar at, const scalar high)
    {
        return at - low >= reach(radius) && high - at >= reach(radius);
    };
    const void_fraction::Box& box = inner_[std::size_t(celli)];
    return box.low.x < box.high.x
     && within(box.low.x, centre.x(), box.high.x)
     && within(box.low.y, centre.y(), box.high.y)
     && within(box.low.z, centre.z(), box.high.z);
}


Foam::scalar Foam::meshCells::appendShares
(
    const point& centre,
    const scalar radius,
    const label centreCell,
    Weights& weights
) const
{
    const void_fraction::Sphere sphere{toVector3(centre), radius};
    const auto append = [&](const label celli)
    {
        const scalar ofCell = share(sphere, centre, celli);
        if (ofCell > 0)
        {
            weights.cells.append(celli);
            weights.weights.append(ofCell);
        }
        return ofCell;
    };
    if (centreCell >= 0 && isWithinBox(centreCell, centre, radius))
    {
        return append(centreCell);
    }

    scalar sum = 0;
    find(centre, reach(radius));
    for (const label celli : found_)
    {
        sum += append(celli);
    }
    if (sum == 0 && centreCell >= 0)
    {
        // Round-off has put a point on the outermost face outside.
        weights.cells.append(centreCell);
        weights.weights.append(1);
        sum = 1;
    }
    return sum;
}


Foam::List<Foam::vector> Foam::meshCells::images(const FixedList<bool, 3>& periodic, const vector& periods)
{
    List<vector> shifts(1, vector::zero);
    for (direction d = 0; d < 3; ++d)
    {
        if (periodic[d])
        {
            const List<vector> before(shifts);
            for (const scalar sign : {-1, 1})
            {
                for (vector shift : before)
                {
                    shift[d] = sign*periods[d];
                    shifts.append(shift);
                }
            }
        }
    }
    return shifts;
}


Foam::List<Foam::vector> Foam::meshCells::images(const polyMesh& mesh)
{
    FixedList<bool, 3> periodic(false);
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        if ((isA<cyclicPolyPatch>(patch) || isA<processorCyclicPolyPatch>(patch)) && patch.size())
        {
            const vector across = cmptMag(mesh.faceAreas()[patch.start()]);
            for (direction d = 0; d < 3; ++d)
            {
                periodic[d] = periodic[d] || across[d] == cmptMax(across);
            }
        }
    }
    for (bool& anywhere : periodic)
    {
        reduce(anywhere, orOp<bool>());
    }
    return images(periodic, mesh.bounds().span());
}


Foam::vector Foam::meshCells::minimumImageShift(const UList<vector>& images, const vector& displacement)
{
    vector best = Zero;
    for (const vector& shift : images)
    {
        if (magSqr(displacement + shift) < magSqr(displacement + best))
        {
            best = shift;
        }
    }
    return best;
}
