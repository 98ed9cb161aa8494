// SPDX-License-Identifier: BSD-3-Clause
#include "named_table.h"

#include <set>

#include "drag/drag_closure.h"
#include "refuses.h"
#include "void_fraction/void_fraction_kernel.h"

namespace cohesion {

TEST(NamedTable, FindsEveryRowByItsName) {
  for (const auto& row : drag::closures)
    EXPECT_EQ(find_by_name(drag::closures, "drag", row.name).per_solid_volume,
              row.per_solid_volume);
  for (const auto& row : void_fraction::kernels)
    EXPECT_EQ(find_by_name(void_fraction::kernels, "void fraction", row.name).share, row.share);
}

TEST(NamedTable, HasNoNameTwice) {
  std::set<std::string_view> names;
  for (const auto& row : drag::closures) EXPECT_TRUE(names.insert(row.name).second) << row.name;
  names.clear();
  for (const auto& row : void_fraction::kernels)
    EXPECT_TRUE(names.insert(row.name).second) << row.name;
}

TEST(NamedTable, ListsTheValidNamesForAnUnknownOne) {
  expect_refused([] { find_by_name(drag::closures, "drag", "syamlalObrien"); },
                 "unknown drag 'syamlalObrien'; valid names: syamlalOBrien");
}

}  // namespace cohesion
