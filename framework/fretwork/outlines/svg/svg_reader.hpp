// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/geometry/plane.hpp>
#include <fretwork/outlines/detail/coloured_picture.hpp>
#include <fretwork/outlines/detail/outline_readers.hpp>
#include <fretwork/outlines/detail/remarks.hpp>
#include <fretwork/outlines/regions/drawn_lines.hpp>
#include <fretwork/outlines/svg/svg_geometry.hpp>
#include <fretwork/outlines/svg/svg_page.hpp>
#include <fretwork/outlines/svg/svg_style.hpp>

namespace fretwork::outlines::detail {

/// A reader of the areas of an SVG drawing that a browser would fill (SVG 2, chapters 5 to 14). If there are
/// none, run() gives the areas inside closed lines, and run_for_colours() throws GeometryError.
class SvgReader {
  public:
    explicit SvgReader(const std::filesystem::path& path);
    SvgReader(std::string text, std::string source);

    OutlineFile run();
    ColouredPicture run_for_colours();

  private:
    /// The state that an element inherits from the elements around it.
    struct Surroundings {
        SvgStyle style{};
        Affine map{};  ///< map to metres
        SvgMeasure measure{};
        std::optional<std::size_t> clip{};
        int depth = 1;
    };
    /// The purpose of reading an element. For Clip and Box, shapes count even if they are not painted.
    enum class Purpose { Paint, Clip, Box };

    /// The depth of groups, copies and clips: no drawing needs more, and the reader's stack is limited.
    static constexpr int kDeepest = 256;

    void read();
    /// The region that the lines of a drawing enclose. It is used if the filled shapes give no part, as in
    /// drawings for laser cutters. Lines are joined as in DXF, and a line inside another is a hole. Throws
    /// GeometryError if the lines enclose nothing.
    Region stroked_region();
    [[nodiscard]] std::string nothing_filled() const;
    /// The list, in brackets, of the content that was left out.
    [[nodiscard]] std::string left_out_text() const;
    void read_children(pugi::xml_node parent, const Surroundings& around);
    void read_element(pugi::xml_node node, const Surroundings& outer);
    /// Count an element that is drawn or that clips. Throws InputError if there are too many, or if it lies
    /// too deep.
    void enter(pugi::xml_node node, int depth);
    void read_kind(std::string_view name, const SvgElement& element, const Surroundings& around);
    /// Read the first alternative of a `switch` that meets its conditions.
    void read_switch(pugi::xml_node parent, const Surroundings& around);
    /// Read an `svg` or `symbol`, which shows its viewBox in its own box. `sized` is the element that states
    /// the size of that box.
    void read_viewport(const SvgElement& element, const SvgElement& sized, Surroundings around);
    void read_use(const SvgElement& element, Surroundings around);
    void read_copied_viewport(pugi::xml_node copied, const SvgElement& use, Surroundings around);
    void read_shape(std::string_view name, const SvgElement& element, const Surroundings& around);
    void remember_stroke(pugi::xml_node node, const Surroundings& around);
    void add_stroke(pugi::xml_node node, const Surroundings& around);
    void add_open_line(geometry::Polygon points, pugi::xml_node node, std::optional<std::size_t> clip);
    void add_closed_line(geometry::Polygon points, pugi::xml_node node, std::optional<std::size_t> clip);
    /// Count the work of a line in a clip. Throws InputError if many lines lie in clips of many points.
    void count_clipping(double work, pugi::xml_node node);
    /// The polygons of a shape. Once they have more points than a drawing may have, the rest is left out:
    /// check_loops() refuses them.
    [[nodiscard]] std::vector<geometry::Polygon> loops_of(const std::vector<Subpath>& subpaths,
                                                          const Affine& map) const;
    void count_points(std::size_t points, pugi::xml_node node);
    void check_loops(const std::vector<geometry::Polygon>& loops, pugi::xml_node node);
    /// True if a point lies in the drawing, or no further away than a fixed multiple of the drawing's size.
    [[nodiscard]] bool is_near_page(geometry::Point2 point) const;
    void check_on_page(geometry::Point2 point, pugi::xml_node node) const;
    /// Add a clip of `node` to the picture. Returns its index.
    std::size_t add_clip(Clip clip, pugi::xml_node node);
    /// The clip of an element, inside the clip of its surroundings.
    std::optional<std::size_t> clip_of(const SvgElement& element, const Surroundings& around);
    std::size_t read_clip(pugi::xml_node clip, const SvgElement& clipped, Surroundings around);
    /// The map from the unit square to the box of an element, in the element's own coordinates.
    Affine unit_box_of(const SvgElement& element, const Surroundings& around);

    std::string source_;
    SvgDocument document_;
    SvgPage page_;
    Flattening how_{.tolerance = kFlatteningTolerance};
    Picture picture_;
    std::vector<int> clip_depths_;  // for each clip of the picture, the number of clips around it and itself
    std::vector<std::size_t> clip_points_;  // for each clip, the points of these clips
    double clipping_ = 0;                   // work of lines in clips
    std::vector<FilledShape>* shapes_ = &picture_.shapes;
    std::vector<pugi::xml_node> places_;   // elements of the picture's shapes
    std::vector<std::string> colours_;     // colours of the picture's shapes
    std::vector<pugi::xml_node> copying_;  // elements being copied, or used as clips
    Purpose purpose_ = Purpose::Paint;
    Remarks remarks_;
    int elements_ = 0;
    int lines_ = 0;  // shapes that are stroked and not filled
    /// All stroked elements, which are drawn only if the filled shapes give no part.
    std::vector<std::pair<pugi::xml_node, Surroundings>> strokes_;
    DrawnLines lines_drawn_;
    std::vector<pugi::xml_node> open_places_;  // elements of the open lines
    std::size_t points_ = 0;
};

}  // namespace fretwork::outlines::detail
