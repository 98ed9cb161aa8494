// SPDX-License-Identifier: GPL-3.0-or-later
#include "twoFluidFilter.H"

#include "zeroGradientFvPatchFields.H"

#include "coupling/drag/cellSizes.H"
#include "coupling/input/selectRow.H"
#include "two-fluid/eachValue.H"

using namespace cohesion;


Foam::twoFluidFilter::twoFluidFilter(const dictionary& dict, const phasePair& pair)
:
    law_(selectRow(dict, "filter", powder::cell_filters, "none"))
{
    if (!active())
    {
        return;
    }
    const auto refuse = [&](const char* why)
    {
        FatalIOErrorInFunction(dict)
            << "filter " << law_.name.data() << " goes by the speed at which particles fall, and " << why
            << ": remove the entry" << exit(FatalIOError);
    };
    if (!(mag(pair.g().value()) > 0))
    {
        refuse("constant/g is zero");
    }
    if (!(gMin(pair.dispersed().rho()) > gMax(pair.continuous().rho())))
    {
        refuse("they are not heavier than the gas");
    }
    const fvMesh& mesh = pair.phase1().mesh();
    sizes_.reset
    (
        new volScalarField
        (
            IOobject("cellSizes", mesh.time().timeName(), mesh, IOobject::NO_READ, IOobject::NO_WRITE, false),
            mesh,
            dimensionedScalar(dimLength, Zero),
            zeroGradientFvPatchScalarField::typeName
        )
    );
    sizes_->primitiveFieldRef() = cellSizes(mesh);
    sizes_->correctBoundaryConditions();
    Info<< "Drag filtered by filter " << law_.name.data() << ", in cells of " << gMin(*sizes_) << " to "
        << gMax(*sizes_) << " m" << endl;
}


Foam::tmp<Foam::volScalarField> Foam::twoFluidFilter::factor(const phasePair& pair) const
{
    const scalar g = mag(pair.g().value());
    const auto left = [&]
    (
        const scalar solid,
        const scalar size,
        const scalar d,
        const scalar density,
        const scalar rho,
        const scalar mu
    )
    {
        return law_.factor(max(solid, scalar(0)), {size, {d, density}, {rho, mu}, g});
    };
    const phaseModel& gas = pair.continuous();
    const phaseModel& grains = pair.dispersed();
    try
    {
        return eachValue("filter", dimless, left, grains, *sizes_, grains.d()(), grains.rho(), gas.rho(), gas.mu()());
    }
    catch (const InvalidParameter& error)
    {
        FatalErrorInFunction << "filter " << law_.name.data() << ": " << error.what() << exit(FatalError);
        throw;
    }
}
