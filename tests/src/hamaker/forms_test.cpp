// SPDX-License-Identifier: BSD-3-Clause
#include "hamaker/forms.h"

#include "named_table.h"
#include "refuses.h"

namespace cohesion::hamaker {
namespace {

const HamakerParameters smooth{1e-19, 4e-10, 1e-4}, rough{1e-19, 4e-10, 1e-4, 1e-8};
const PairGeometry pair = two_spheres(1e-3, 2e-3);

AnyLaw named(const char* name, const HamakerParameters& p, bool knows_asperities) {
  return find_by_name(forms, "form", name).law(p, knows_asperities);
}

double force(const AnyLaw& law, double gap) {
  return std::visit([&](const auto& chosen) { return chosen.force(gap, pair); }, law);
}

}  // namespace

TEST(HamakerForms, NamesLeadToTheirLaws) {
  for (const double gap : {1e-9, 5e-5}) {
    EXPECT_EQ(force(named("small_gap", smooth, false), gap),
              HamakerLaw<SmallGap>(smooth).force(gap, pair));
    EXPECT_EQ(force(named("exact", smooth, false), gap),
              HamakerLaw<Exact>(smooth).force(gap, pair));
    EXPECT_EQ(force(named("small_gap", rough, true), gap),
              HamakerLaw<Rough<SmallGap>>(rough).force(gap, pair));
    EXPECT_EQ(force(named("exact", rough, true), gap),
              HamakerLaw<Rough<Exact>>(rough).force(gap, pair));
  }
}

TEST(HamakerForms, LawThatKnowsAsperitiesTakesSmoothSurfacesToo) {
  for (const Form& form : forms)
    EXPECT_EQ(force(form.law(smooth, true), 1e-9), force(form.law(smooth, false), 1e-9));
}

TEST(HamakerForms, LawOfSmoothSurfacesRefusesAnAsperity) {
  for (const Form& form : forms)
    expect_refused([&] { form.law(rough, false); }, "law of smooth surfaces");
}

TEST(HamakerForms, UnknownNameListsTheValidOnes) {
  expect_refused([] { named("full", smooth, false); }, "valid names: small_gap, exact");
}

}  // namespace cohesion::hamaker
