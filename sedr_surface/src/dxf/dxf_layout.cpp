// SPDX-License-Identifier: BSD-3-Clause
#include "dxf_file.h"

namespace pcl::sedr {

void
DxfBlock::viewport(const char* layer, const View& view, int number)
{
  constexpr int always = 32768;
  begin("VIEWPORT", layer, "AcDbViewport").place(view.box.center());
  entities_.group(40, view.box.sizes().x()).group(41, view.box.sizes().y());
  entities_.group(68, number).group(69, number);
  entities_.group(12, view.middle.x()).group(22, view.middle.y());
  for (const int code : {13, 14, 15}) // snap and grid
    entities_.group(code, code == 13 ? 0.0 : 10.0)
        .group(code + 10, code == 13 ? 0.0 : 10.0);
  entities_.group(16, 0.0).group(26, 0.0).group(36, 1.0).place({0, 0}, 17);
  entities_.group(42, 50.0).group(43, 0.0).group(44, 0.0).group(45, view.height);
  entities_.group(50, 0.0).group(51, view.degrees).group(72, 100).group(90, always);
}

DxfText
DxfFile::objects()
{
  const std::string root = handles_.next();
  const std::string groups = handles_.next();
  const std::string layouts = handles_.next();
  DxfText objects;
  const auto begin = [&](const std::string& handle, const std::string& owner) {
    objects.group(0, "DICTIONARY").group(5, handle).group(330, owner);
    objects.group(100, "AcDbDictionary").group(281, 1);
  };
  begin(root, "0");
  objects.group(3, "ACAD_GROUP").group(350, groups);
  objects.group(3, "ACAD_LAYOUT").group(350, layouts);
  begin(groups, root);
  begin(layouts, root);
  objects.group(3, "Model").group(350, model_layout_);
  objects.group(3, "Sheet").group(350, paper_layout_);
  return objects.append(layout(model_layout_, layouts, "Model", model_))
      .append(layout(paper_layout_, layouts, "Sheet", paper_));
}

DxfText
DxfFile::layout(const std::string& handle,
                const std::string& owner,
                const std::string& name,
                const DxfBlock& block) const
{
  constexpr int usual = 688; // plot flags
  constexpr int of_model = 1024;
  constexpr int millimetres = 1;
  constexpr int whole_layout = 5;
  constexpr int one_to_one = 16;
  const bool is_paper = block.name() == paper_space;
  const Eigen::Vector2d size =
      is_paper ? paper_size_ : Eigen::Vector2d(Eigen::Vector2d::Zero());
  DxfText text;
  text.group(0, "LAYOUT").group(5, handle).group(330, owner);
  text.group(100, "AcDbPlotSettings").group(1, "").group(2, "none_device");
  text.group(4, is_paper ? paper_name_ : "").group(6, "");
  for (const int code : {40, 41, 42, 43}) // margins
    text.group(code, 0.0);
  text.group(44, size.x()).group(45, size.y());
  for (const int code : {46, 47, 48, 49, 140, 141}) // what is plotted
    text.group(code, 0.0);
  text.group(142, 1.0).group(143, 1.0).group(70, is_paper ? usual : usual + of_model);
  text.group(72, millimetres).group(73, 0).group(74, whole_layout).group(7, "");
  text.group(75, one_to_one).group(147, 1.0).group(148, 0.0).group(149, 0.0);
  text.group(100, "AcDbLayout").group(1, name).group(70, 1).group(71, is_paper ? 1 : 0);
  text.group(10, 0.0).group(20, 0.0).group(11, size.x()).group(21, size.y());
  text.place({0, 0}, 12).place({0, 0}, 14).place(size, 15).group(146, 0.0);
  text.place({0, 0}, 13).place({1, 0}, 16).place({0, 1}, 17).group(76, 0);
  return text.group(330, block.record());
}

} // namespace pcl::sedr
