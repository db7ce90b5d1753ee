// SPDX-License-Identifier: BSD-3-Clause
#include "key_style.h"

#include <vtkObjectFactory.h>
#include <vtkRenderWindowInteractor.h>

namespace pcl {
namespace sedr {
namespace tools {

vtkStandardNewMacro(KeyStyle);

void
KeyStyle::OnKeyDown()
{
  const char* symbol = Interactor->GetKeySym();
  if (symbol && on_key)
    on_key(symbol);
}

} // namespace tools
} // namespace sedr
} // namespace pcl
