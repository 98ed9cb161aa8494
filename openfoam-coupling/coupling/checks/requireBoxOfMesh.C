// SPDX-License-Identifier: GPL-3.0-or-later
#include "caseChecks.H"

#include "boundBox.H"
#include "PstreamReduceOps.H"
#include "error.H"
#include "globalMeshData.H"
#include "scalarField.H"

#include "coupling/sixDigits.H"

#include <cmath>

using SimulationBox = cohesion::coupling::DemEngine::SimulationBox;

namespace Foam
{

namespace
{

//- Mean width of the cells, in the directions that the mesh resolves [m]. All ranks call it.
scalar meanCellWidth(const polyMesh& mesh)
{
    scalar size = gSum(mesh.cellVolumes())/mesh.globalData().nTotalCells();
    for (direction d = 0; d < 3; ++d)
    {
        size /= mesh.geometricD()[d] < 0 ? mesh.bounds().span()[d] : 1;
    }
    return std::pow(size, 1.0/mesh.nGeometricD());
}


//- FatalIOError unless box and mesh end at the same places: to round-off of six digits, or to `fixedTolerance` where
//  the ends of the box are fixed and those of the mesh are not periodic, so that walls hold the particles
void requireSameEnds
(
    const dictionary& dict,
    const boundBox& bounds,
    const bool periodicMesh,
    const SimulationBox& box,
    const scalar fixedTolerance,
    const direction d
)
{
    const bool walls = box.fixed[d] && !periodicMesh;
    const scalar tolerance = walls ? fixedTolerance : 1e-6*bounds.span()[d];
    if
    (
        mag(box.low[d] - bounds.min()[d]) > tolerance
     || mag(box.high[d] - bounds.max()[d]) > tolerance
    )
    {
        FatalIOErrorInFunction(dict)
            << "in direction " << vector::componentNames[d] << " the box of the particle"
            << " script reaches from " << box.low[d] << " to " << box.high[d]
            << " m, the mesh from " << bounds.min()[d] << " to " << bounds.max()[d]
            << " m: give the script's box the size of the mesh, "
            << (walls ? "to less than a cell's width of " : "to ") << sixDigits(tolerance).c_str() << " m"
            << exit(FatalIOError);
    }
}


//- FatalIOError unless the slab of particles, a box that is periodic in a direction that the mesh does not resolve,
//  is as deep as the mesh is thick, or dict gives its depth
void requireDepth(const dictionary& dict, const polyMesh& mesh, const SimulationBox& box, const direction d)
{
    const scalar ofBox = box.high[d] - box.low[d];
    const scalar ofMesh = mesh.bounds().span()[d];
    const std::string deep(sixDigits(ofBox));
    if (dict.found("depth"))
    {
        // Numbers of three digits may stand for each other.
        const scalar depth = dict.get<scalar>("depth");
        if (mag(depth - ofBox) > 1e-3*ofBox)
        {
            IOWarningInFunction(dict)
                << "depth = " << sixDigits(depth).c_str() << " m, while the box of the particle script is periodic in"
                << " direction " << vector::componentNames[d] << " and " << deep.c_str() << " m deep. Where particles"
                << " are all over it, their void fraction is that of 'depth " << deep.c_str() << ";'" << endl;
        }
        return;
    }
    if (mag(ofBox - ofMesh) > 1e-6*ofMesh)
    {
        FatalIOErrorInFunction(dict)
            << "in direction " << vector::componentNames[d] << ", which the mesh does not resolve, the box of the"
            << " particle script is periodic and " << deep.c_str() << " m deep, the mesh " << sixDigits(ofMesh).c_str()
            << " m thick" << nl
            << "    Say how deep the slab of particles is, from which the void fraction follows: 'depth "
            << deep.c_str() << ";' where they are all over the box; or make the mesh as thick" << exit(FatalIOError);
    }
}

//- Warns where particles come back on the other side and the gas does not, or the other way round
void warnOfPeriodicity(const dictionary& dict, const bool mesh, const bool box, const direction d)
{
    if (mesh == box)
    {
        return;
    }
    const char* const name = vector::componentNames[d];
    IOWarningInFunction(dict)
        << "in direction " << name << " the box of the particle script is " << (box ? "periodic" : "not periodic")
        << ", and the mesh is " << (mesh ? "periodic" : "not") << ": "
        << (box ? "particles touch through the ends of the mesh, and leave it on one side to come back on the other"
                : "gas passes from one side to the other, and particles do not") << nl
        << "    Take " << (box ? "'f'" : "'p'") << " for " << name << " in the command boundary of the script"
        << (box ? ", with walls at both ends; or cyclic patches" : "; or other patches than cyclic ones")
        << " in that direction of the mesh" << endl;
}

} // End anonymous namespace


void requireEndsOfMesh(const dictionary& dict, const polyMesh& mesh, const SimulationBox& box)
{
    const FixedList<bool, 3> periodic(periodicDirections(mesh));
    const scalar width = meanCellWidth(mesh);
    for (direction d = 0; d < 3; ++d)
    {
        if (mesh.geometricD()[d] > 0)
        {
            requireSameEnds(dict, mesh.bounds(), periodic[d], box, width, d);
        }
    }
}


void requireBoxOfMesh(const dictionary& dict, const polyMesh& mesh, const SimulationBox& box)
{
    requireEndsOfMesh(dict, mesh, box);
    const FixedList<bool, 3> periodic(periodicDirections(mesh));
    for (direction d = 0; d < 3; ++d)
    {
        if (mesh.geometricD()[d] > 0)
        {
            warnOfPeriodicity(dict, periodic[d], box.periodic[d], d);
        }
        else if (box.periodic[d])
        {
            requireDepth(dict, mesh, box, d);
        }
    }
}

} // End namespace Foam
