// SPDX-License-Identifier: MIT
#include "strat/layout/svg_writer.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <span>

#include "core/base/text.hpp"
#include "strat/layout/drawing_colours.hpp"
#include "strat/layout/drawing_style.hpp"

namespace planum::strat {

namespace {

// At most two decimals, without trailing zeros and without "-0".
std::string number(double value) {
    const double rounded = std::round(value * 100.0) / 100.0;
    std::string s = fmt::format("{:.2f}", rounded == 0.0 ? 0.0 : rounded);
    while (s.back() == '0') s.pop_back();
    if (s.back() == '.') s.pop_back();
    return s;
}

std::string path_data(std::span<const DrawPoint> points, bool closed) {
    std::string d;
    for (const DrawPoint& p : points) {
        d += d.empty() ? "M" : " L";
        d += number(p.x) + "," + number(p.y);
    }
    return closed ? d + " Z" : d;
}

std::string hex(Colour colour) { return fmt::format("#{:06x}", colour); }

std::string stroke_attributes(const StrokeStyle& stroke) {
    std::string s = fmt::format("stroke=\"{}\" stroke-width=\"{}\"", hex(stroke.colour), number(stroke.width));
    if (stroke.dash != Dash::Solid) {
        std::string pattern;
        for (const double length : pattern_of(stroke.dash)) pattern += (pattern.empty() ? "" : ",") + number(length);
        s += fmt::format(" stroke-dasharray=\"{}\"", pattern);
    }
    return s;
}

class SvgWriter {
  public:
    explicit SvgWriter(const MatrixDrawing& drawing) : d_(drawing) {}

    std::string write() {
        head();
        bands();
        lines();
        boxes();
        legend();
        texts();
        out_ += "</svg>\n";
        return std::move(out_);
    }

  private:
    template<class... Args>
    void put(fmt::format_string<Args...> format, Args&&... args) {
        fmt::format_to(std::back_inserter(out_), format, std::forward<Args>(args)...);
    }

    void head() {
        put("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n");
        put("<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\" version=\"1.1\" "
            "width=\"{0}pt\" height=\"{1}pt\" viewBox=\"0 0 {0} {1}\" role=\"img\" "
            "aria-labelledby=\"drawing-title drawing-description\" font-family=\"'DejaVu Sans', Verdana, "
            "sans-serif\">\n",
            number(d_.width), number(d_.height));
        put("<title id=\"drawing-title\">{}</title>\n", xml_escaped(d_.title));
        put("<desc id=\"drawing-description\">{}</desc>\n", xml_escaped(d_.description));
        put("<rect class=\"paper\" width=\"{}\" height=\"{}\" fill=\"{}\"/>\n", number(d_.width), number(d_.height),
            hex(kPaper));
    }

    void bands() {
        if (!d_.bands.empty()) {
            put("<g id=\"drawing-bands\">\n");
            for (const DrawnBand& band : d_.bands) {
                put("<rect id=\"{}\" class=\"band\" {} fill=\"{}\" stroke=\"{}\" stroke-width=\"0.5\"/>\n",
                    xml_escaped(band.id), rect(band.rect), hex(band.shaded ? kBandShade : kPaper), hex(kBandEdge));
            }
            put("</g>\n");
        }
        if (!d_.frames.empty()) {
            put("<g id=\"drawing-frames\">\n");
            for (const DrawnFrame& frame : d_.frames) {
                put("<rect id=\"{}\" class=\"frame\" {} rx=\"4\" fill=\"none\" stroke=\"{}\" stroke-width=\"1\"/>\n",
                    xml_escaped(frame.id), rect(frame.rect), hex(kFrameEdge));
            }
            put("</g>\n");
        }
    }

    static std::string rect(const DrawRect& r) {
        return fmt::format("x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"", number(r.x), number(r.y), number(r.width),
                           number(r.height));
    }

    static std::string classes(const DrawnLine& line) {
        std::string c = "order";
        if (!line.kind.empty()) c += " " + line.kind;
        if (line.in_cycle) c += " cycle";
        if (line.upwards) c += " upwards";
        if (line.uncertain) c += " uncertain";
        if (line.through) c += " through";
        if (line.mark != Mark::None) c += " " + std::string(to_word(line.mark));
        if (line.verdict != model::EvidenceVerdict::None) c += " " + std::string(to_word(line.verdict));
        return c;
    }

    static std::string classes(const DrawnBox& box) {
        std::string c = "unit " + std::string(to_word(box.shape));
        if (box.in_cycle) c += " cycle";
        if (box.inner_cycle) c += " contradiction";
        if (box.has_finds) c += " finds";
        if (box.mentioned_only) c += " mentioned";
        if (box.isolated) c += " isolated";
        if (box.mark != Mark::None) c += " " + std::string(to_word(box.mark));
        return c;
    }

    void line(const DrawnLine& line) {
        const StrokeStyle style = style_of(line);
        put("<g id=\"{}\" class=\"{}\" data-later=\"{}\" data-earlier=\"{}\"><title>{}</title><path d=\"{}\" "
            "fill=\"none\" {}/>",
            xml_escaped(line.id), xml_escaped(classes(line)), xml_escaped(d_.boxes[line.later].id),
            xml_escaped(d_.boxes[line.earlier].id), xml_escaped(line.title), path_data(line.points, false),
            stroke_attributes(style));
        const std::vector<DrawPoint> arrow = arrow_head(line);
        if (!arrow.empty()) put("<path d=\"{}\" fill=\"{}\"/>", path_data(arrow, true), hex(style.colour));
        put("</g>\n");
    }

    // Cycles last, so that no other line hides them.
    void lines() {
        // Crisp: strokes that share a segment must not look thicker than others.
        put("<g id=\"drawing-orders\" shape-rendering=\"crispEdges\">\n");
        for (const bool red : {false, true}) {
            for (const DrawnLine& l : d_.lines) {
                if ((l.in_cycle || l.upwards) == red) line(l);
            }
        }
        for (const DrawPoint& p : d_.junctions) {
            put("<circle class=\"junction\" cx=\"{}\" cy=\"{}\" r=\"{}\" fill=\"{}\"/>\n", number(p.x), number(p.y),
                number(kJunctionRadius), hex(kLineInk));
        }
        put("</g>\n");
    }

    void shape(const DrawnBox& box) {
        const BoxOutline outline = outline_of(box);
        const BoxStyle style = style_of(box);
        StrokeStyle stroke = style.stroke;
        stroke.width = std::max(stroke.width, outline.stroke_width);
        put("<path d=\"{}\" fill=\"{}\" {}/>", path_data(outline.polygon, true), hex(style.fill),
            stroke_attributes(stroke));
        for (const std::vector<DrawPoint>& inner : outline.strokes) {
            put("<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"0.8\"/>", path_data(inner, false),
                hex(stroke.colour));
        }
        if (box.has_finds) {
            put("<path class=\"finds-mark\" d=\"{}\" fill=\"{}\"/>", path_data(finds_mark(box.rect), true),
                hex(stroke.colour));
        }
    }

    // Several units in one box, each with its own name in the label.
    static bool is_joined(const DrawnBox& box) { return box.shape != BoxShape::Folded && box.names.size() > 1; }

    void boxes() {
        put("<g id=\"drawing-units\">\n");
        for (const DrawnBox& box : d_.boxes) {
            const bool one_link = !box.links.empty() && !is_joined(box) && box.shape != BoxShape::Folded;
            if (one_link) open_link(box.links.front());
            put("<g id=\"{}\" class=\"{}\"", xml_escaped(box.id), classes(box));
            if (box.unit_ids.size() > 1) put(" data-units=\"{}\"", xml_escaped(text::join(box.unit_ids, " ")));
            put("><title>{}</title>", xml_escaped(box.title));
            shape(box);
            label(box);
            put("</g>{}\n", one_link ? "</a>" : "");
        }
        put("</g>\n");
    }

    void open_link(const std::string& link) { put("<a xlink:href=\"{0}\" href=\"{0}\">", xml_escaped(link)); }

    // What is still to be written of the names of a joined box; a long name goes on over several lines.
    struct NamesLeft {
        std::size_t name = 0;
        std::size_t from = 0; // of that name: what stands before is written
    };

    // The names in a line of a joined box, each with its link and, but for the first, which is the box's, its id.
    std::string marked_names(const DrawnBox& box, const std::string& line, NamesLeft& left) {
        std::string marked;
        std::size_t at = 0;
        while (left.name < box.names.size()) {
            const std::string rest = box.names[left.name].substr(left.from);
            const std::size_t found = line.find(rest, at);
            // A name begins a line of its own if it goes on in the next, behind the sign of equality.
            const std::size_t sign = line.starts_with("= ") ? 2 : line.starts_with("=? ") ? 3 : 0;
            const std::size_t begin = found != std::string::npos ? found : at == 0 ? sign : at;
            const std::string part = found != std::string::npos ? rest : line.substr(begin);
            if (part.empty() || !rest.starts_with(part)) break;
            marked += xml_escaped(line.substr(at, begin - at)) + marked_name(box, left, part);
            at = begin + part.size();
            if (part.size() < rest.size()) {
                left.from += part.size();
                break;
            }
            left = {left.name + 1, 0};
        }
        return marked + xml_escaped(line.substr(at));
    }

    static std::string marked_name(const DrawnBox& box, const NamesLeft& name, const std::string& part) {
        const bool has_id = name.name > 0 && name.from == 0;
        const std::string id = has_id ? fmt::format(" id=\"{}\"", xml_escaped(box.unit_ids[name.name])) : "";
        const std::string span = fmt::format("<tspan{} class=\"unit-name\">{}</tspan>", id, xml_escaped(part));
        if (box.links.empty()) return span;
        return fmt::format("<a xlink:href=\"{0}\" href=\"{0}\">{1}</a>", xml_escaped(box.links[name.name]), span);
    }

    // textLength: viewers with another font squeeze the label into its box.
    void label(const DrawnBox& box) {
        const double top = box.rect.centre().y - style::kLineHeight * static_cast<double>(box.lines.size() - 1) / 2.0;
        NamesLeft left;
        for (std::size_t i = 0; i < box.lines.size() && i < box.line_widths.size(); ++i) {
            const double y = top + style::kLineHeight * static_cast<double>(i) + box.text_size * 0.36;
            put("<text x=\"{}\" y=\"{}\" font-size=\"{}\" text-anchor=\"middle\" fill=\"{}\" textLength=\"{}\" "
                "lengthAdjust=\"spacingAndGlyphs\">{}</text>",
                number(box.rect.centre().x), number(y), number(box.text_size), hex(style_of(box).text),
                number(box.line_widths[i]),
                is_joined(box) ? marked_names(box, box.lines[i], left) : xml_escaped(box.lines[i]));
        }
    }

    void legend() {
        if (d_.legend.empty()) return;
        put("<g id=\"drawing-legend\">\n");
        for (const LegendSample& sample : d_.legend) {
            if (sample.kind == LegendSample::Kind::Box) {
                shape(sample.box);
            } else {
                const StrokeStyle style = style_of(sample.line);
                put("<path d=\"{}\" fill=\"none\" {}/>", path_data(sample.line.points, false),
                    stroke_attributes(style));
                const std::vector<DrawPoint> arrow = arrow_head(sample.line);
                if (!arrow.empty()) put("<path d=\"{}\" fill=\"{}\"/>", path_data(arrow, true), hex(style.colour));
            }
            put("\n");
        }
        put("</g>\n");
    }

    void texts() {
        put("<g id=\"drawing-texts\">\n");
        for (const DrawnText& t : d_.texts) {
            const char* anchor = t.anchor == TextAnchor::Start    ? "start"
                                 : t.anchor == TextAnchor::Middle ? "middle"
                                                                  : "end";
            const bool strong = t.role == "title" || t.role == "legend";
            put("<text class=\"{}\" x=\"{}\" y=\"{}\" font-size=\"{}\" text-anchor=\"{}\" fill=\"{}\"",
                xml_escaped(t.role), number(t.at.x), number(t.at.y), number(t.size), anchor,
                hex(strong ? kInk : kFaintInk));
            if (t.bold) put(" font-weight=\"bold\"");
            if (t.upright) put(" transform=\"rotate(-90 {} {})\"", number(t.at.x), number(t.at.y));
            if (t.width > 0.0) put(" textLength=\"{}\" lengthAdjust=\"spacingAndGlyphs\"", number(t.width));
            put(">{}</text>\n", xml_escaped(t.text));
        }
        put("</g>\n");
    }

    const MatrixDrawing& d_;
    std::string out_;
};

} // namespace

std::string xml_escaped(std::string_view text) {
    std::string out;
    out.reserve(text.size());
    for (const char c : text) {
        switch (c) {
        case '&': out += "&amp;"; break;
        case '<': out += "&lt;"; break;
        case '>': out += "&gt;"; break;
        case '"': out += "&quot;"; break;
        case '\'': out += "&#39;"; break;
        case '\t':
        case '\n':
        case '\r': out += ' '; break;
        default:
            if (static_cast<unsigned char>(c) < 0x20) {
                out += "\xEF\xBF\xBD";
            } else {
                out += c;
            }
        }
    }
    return out;
}

std::string write_svg(const MatrixDrawing& drawing) { return SvgWriter(drawing).write(); }

} // namespace planum::strat
