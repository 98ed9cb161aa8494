// SPDX-License-Identifier: GPL-3.0-or-later
#include "boundParticles.H"

#include "Pstream.H"
#include "PstreamReduceOps.H"

#include "coupling/input/selectRow.H"
#include "coupling/sixDigits.H"

using namespace cohesion;

namespace
{

//- Largest over smallest diameter above which spheres are of several sizes
constexpr Foam::scalar severalSizesFrom = 1.05;

} // End anonymous namespace


void Foam::boundParticles::Counts::add(const Counts& more)
{
    all += more.all;
    bound += more.bound;
    reduced += more.reduced;
    endless += more.endless;
    factors += more.factors;
    least = min(least, more.least);
}


Foam::boundParticles::Counts Foam::boundParticles::Counts::overRanks() const
{
    Counts sums;
    sums.all = returnReduce(all, sumOp<scalar>());
    sums.bound = returnReduce(bound, sumOp<scalar>());
    sums.reduced = returnReduce(reduced, sumOp<scalar>());
    sums.endless = returnReduce(endless, sumOp<scalar>());
    sums.factors = returnReduce(factors, sumOp<scalar>());
    sums.least = returnReduce(least, minOp<scalar>());
    return sums;
}


void Foam::boundParticles::Counts::print() const
{
    Info<< "bound " << bound << " of " << all << ", with less drag " << reduced << ", factor "
        << sixDigits(bound > 0 ? factors/bound : scalar(1)).c_str() << " in the mean of the bound, least "
        << sixDigits(least).c_str() << ", bound to their own image " << endless << endl;
}


Foam::boundParticles::boundParticles(const dictionary& dict, const particleDrag& drag)
:
    law_(selectRow(dict, "agglomerateDrag", drag::agglomerate_laws, "none")),
    drag_(drag)
{
    if (on() && (drag_.mixture().mixes || drag_.parcels().ratio() > 1))
    {
        FatalIOErrorInFunction(dict)
            << "agglomerateDrag " << law_.name.data() << " is a law of equal spheres that are bound themselves: it goes"
            << " with neither a dragMixture nor coarseGraining above 1" << nl
            << "    Remove one of the entries" << exit(FatalIOError);
    }
}


void Foam::boundParticles::start(coupling::DemEngine& engine)
{
    engine.agglomerates();
    const auto particles = engine.particles();
    scalar least = GREAT;
    scalar most = -GREAT;
    for (label i = 0; i < particles.count; ++i)
    {
        least = min(least, particles.radius[i]);
        most = max(most, particles.radius[i]);
    }
    reduce(least, minOp<scalar>());
    reduce(most, maxOp<scalar>());
    Info<< "    agglomerateDrag " << law_.name.data() << ": particles that the script's fix agglomerates finds bound"
        << " have the drag of one sphere for each agglomerate, where that is less than the closure's";
    if (most > severalSizesFrom*least)
    {
        Info<< ". That is a law of equal spheres; here each takes its agglomerate to be of spheres of its own size,"
            << " and they differ by a factor of " << sixDigits(most/least).c_str();
    }
    Info<< endl;
}


void Foam::boundParticles::look(coupling::DemEngine& engine)
{
    in_ = engine.agglomerates();
    step_ = Counts();
    step_.all = engine.particles().count;
}


Foam::scalar Foam::boundParticles::factor(const label i, const particleDrag::DragConditions& sphere)
{
    const drag::InAgglomerate& in = in_[i];
    if (!in.bound())
    {
        return 1;
    }
    const scalar factor = drag::EquivalentSphere::factor
    (
        drag_.law(),
        in,
        sphere.voidFraction,
        sphere.slip,
        sphere.radius,
        sphere.rho,
        drag_.mu()
    );
    ++step_.bound;
    step_.reduced += factor < 1;
    step_.endless += in.endless();
    step_.factors += factor;
    step_.least = min(step_.least, factor);
    return factor;
}


void Foam::boundParticles::endStep()
{
    run_.add(step_);
    Info<< "Agglomerates: ";
    step_.overRanks().print();
}


void Foam::boundParticles::report() const
{
    if (on())
    {
        Info<< "Drag of agglomerates, " << law_.name.data() << ", particles times steps" << nl << "    ";
        run_.overRanks().print();
    }
}
