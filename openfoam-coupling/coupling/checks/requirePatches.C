// SPDX-License-Identifier: GPL-3.0-or-later
#include "caseChecks.H"

#include "boundBox.H"
#include "cyclicPolyPatch.H"
#include "error.H"
#include "processorCyclicPolyPatch.H"
#include "wedgePolyPatch.H"

namespace Foam
{

namespace
{

//- Index of the patch, the same on all ranks, that a patch's faces belong to as periodic ones; else -1
label periodic(const polyPatch& patch)
{
    if (isA<processorCyclicPolyPatch>(patch))
    {
        return refCast<const processorCyclicPolyPatch>(patch).referPatchID();
    }
    return isA<cyclicPolyPatch>(patch) ? patch.index() : -1;
}


//- The box around all of a periodic patch, on all ranks
boundBox around(const polyBoundaryMesh& patches, const label patchi)
{
    boundBox box;
    for (const polyPatch& patch : patches)
    {
        if (periodic(patch) == patchi)
        {
            box.add(patch.localPoints());
        }
    }
    box.reduce();
    return box;
}


//- Points may be written with six digits
scalar tolerance(const polyMesh& mesh)
{
    return 1e-5*mesh.bounds().mag();
}


//- The axis along which a patch and its neighbour are opposite sides of the mesh; -1: none
label axis(const polyMesh& mesh, const boundBox& patch, const boundBox& neighbour)
{
    const boundBox& bounds = mesh.bounds();
    for (direction d = 0; d < 3; ++d)
    {
        for (const bool low : {true, false})
        {
            vector shift = Zero;
            shift[d] = low ? bounds.span()[d] : -bounds.span()[d];
            const scalar end = low ? bounds.min()[d] : bounds.max()[d];
            const scalar off = max
            (
                max(mag(patch.min()[d] - end), mag(patch.max()[d] - end)),
                max(mag(patch.min() + shift - neighbour.min()), mag(patch.max() + shift - neighbour.max()))
            );
            if (off < tolerance(mesh))
            {
                return d;
            }
        }
    }
    return -1;
}


//- A patch that has faces on an outermost plane of the mesh across the axis and is not periodic, on this
//  rank; -1: none
label besidePeriodic(const polyMesh& mesh, const label axis)
{
    const boundBox& bounds = mesh.bounds();
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        if (isA<coupledPolyPatch>(patch))
        {
            continue;
        }
        for (label facei = patch.start(); facei < patch.start() + patch.size(); ++facei)
        {
            const scalar at = mesh.faceCentres()[facei][axis];
            const vector& area = mesh.faceAreas()[facei];
            const bool outermost = min(at - bounds.min()[axis], bounds.max()[axis] - at) < tolerance(mesh);
            if (outermost && mag(area[axis]) > 0.5*mag(area))
            {
                return patch.index();
            }
        }
    }
    return -1;
}


void fail(const dictionary& dict, const polyPatch& patch, const string& what)
{
    FatalIOErrorInFunction(dict)
        << "patch " << patch.name() << " of constant/polyMesh/boundary is a " << patch.type() << what.c_str()
        << exit(FatalIOError);
}


//- FatalIOError, by the types of patches alone
void requireTypes(const polyMesh& mesh, const dictionary& dict)
{
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        if (isA<wedgePolyPatch>(patch))
        {
            fail
            (
                dict,
                patch,
                ", and cells that thin out towards an axis cannot hold spheres: make a 3-D mesh, or a plane one"
                " of one layer of cells between patches of type empty"
            );
        }
        if (isA<coupledPolyPatch>(patch) && !isA<processorPolyPatch>(patch) && !isA<cyclicPolyPatch>(patch))
        {
            fail
            (
                dict,
                patch,
                ", and particles come back through patches of type cyclic alone: make the faces of the two sides"
                " alike, and their type cyclic"
            );
        }
    }
}


//- The axis along which a cyclic patch and its neighbour are opposite sides of the mesh; -1: none. All ranks call it.
label axisOf(const polyMesh& mesh, const cyclicPolyPatch& patch)
{
    const polyBoundaryMesh& patches = mesh.boundaryMesh();
    return axis(mesh, around(patches, patch.index()), around(patches, patch.neighbPatchID()));
}


//- FatalIOError unless a cyclic patch and its neighbour are whole opposite sides of the mesh
void requireOppositeSides(const polyMesh& mesh, const dictionary& dict, const cyclicPolyPatch& patch)
{
    const polyBoundaryMesh& patches = mesh.boundaryMesh();
    const label neighbour = patch.neighbPatchID();
    const label along = axisOf(mesh, patch);
    if (along < 0)
    {
        fail
        (
            dict,
            patch,
            " that does not lead to " + patches[neighbour].name()
          + " by the length of the mesh along an axis, and particles come back in no other way: make the two"
            " opposite plane sides of the mesh across x, y or z"
        );
    }
    const label beside = besidePeriodic(mesh, along);
    if (beside >= 0)
    {
        fail
        (
            dict,
            patch,
            " on a part of a side of the mesh, which has " + patches[beside].name()
          + " beside it, and particles come back on all of it: make the whole side cyclic"
        );
    }
}

} // End anonymous namespace


void requirePatches(const polyMesh& mesh, const dictionary& dict)
{
    requireTypes(mesh, dict);
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        if (isA<cyclicPolyPatch>(patch))
        {
            requireOppositeSides(mesh, dict, refCast<const cyclicPolyPatch>(patch));
        }
    }
}


FixedList<bool, 3> periodicDirections(const polyMesh& mesh)
{
    FixedList<bool, 3> periodic(false);
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        const label along = isA<cyclicPolyPatch>(patch) ? axisOf(mesh, refCast<const cyclicPolyPatch>(patch)) : -1;
        if (along >= 0)
        {
            periodic[along] = true;
        }
    }
    return periodic;
}

} // End namespace Foam
