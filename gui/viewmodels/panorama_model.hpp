// SPDX-License-Identifier: MIT
#pragma once

#include <QObject>
#include <QPointF>
#include <QString>
#include <QStringList>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/regions/ready_patches.hpp"
#include "app/scans/panorama_file.hpp"
#include "app/scans/scan_panorama.hpp"
#include "core/geometry/rigid.hpp"
#include "core/model/scan.hpp"
#include "gui/viewmodels/outline_edit.hpp"
#include "gui/viewmodels/outline_tool.hpp"
#include "gui/viewmodels/region_shapes.hpp"
#include "gui/viewmodels/workspace.hpp"

namespace planum::gui {

class TimeModel;

/// What a panorama is once it is made; any number of threads may read it.
struct LoadedPanorama {
    model::Scan scan;
    scans::Panorama panorama;
    scans::Picture picture;
    std::optional<geometry::Rigid3> site_from_scan; ///< unset: the scan is not on the site grid
    std::shared_ptr<const void> prepared;           ///< what the view made of the picture, see set_preparation()
};

/// The panorama of one scan of the surface that the time line shows: made in a thread, with the outlines of that
/// surface as the scanner saw them.
class PanoramaModel : public QObject {
    Q_OBJECT

  public:
    PanoramaModel(Workspace& workspace, TimeModel& time, QObject* parent = nullptr);

    /// Makes of a picture what a view paints from, in the thread that unrolled it: shrinking 20,000 pixels takes longer
    /// than a window may wait.
    using Preparation = std::function<std::shared_ptr<const void>(const scans::Picture&)>;

    void set_preparation(Preparation preparation) { preparation_ = std::move(preparation); }

    void set_watched(bool watched);

    /// Names of the scans of the current surface.
    [[nodiscard]] QStringList scans() const;

    [[nodiscard]] QString scan() const { return QString::fromStdString(scan_); }

    void set_scan(const QString& name);
    void set_projection(const QString& projection);
    void set_channel(const QString& channel);

    /// Null until it is there.
    [[nodiscard]] const std::shared_ptr<const LoadedPanorama>& loaded() const noexcept { return loaded_; }

    [[nodiscard]] const QString& trouble() const noexcept { return trouble_; }

    [[nodiscard]] bool is_loading() const noexcept { return loading_; }

    /// Outlines of the surface in pixels of the picture.
    [[nodiscard]] std::vector<RegionShape> shapes() const;

    /// Shapes of the site, such as patches of changed ground, in pixels of the picture, in their order; one that is not
    /// to be seen has no rings.
    [[nodiscard]] std::vector<RegionShape> in_picture(const std::vector<app::ReadyPatch>& patches,
                                                      std::vector<RegionShape> shapes) const;

    /// `x 12.31  y 8.02  height 48.77 m`, or what the pixel lacks.
    [[nodiscard]] QString place_text(QPointF pixel) const;

    /// How corners in pixels become an outline on the ground; empty where they cannot, because of why().
    [[nodiscard]] OutlineTool::ToOutlines ground() const;
    /// The same for outlines that are changed.
    [[nodiscard]] EditGround edit_ground() const;
    [[nodiscard]] QString why_no_ground() const;

  signals:
    void changed();

  private:
    void load();
    void take_surface();

    Workspace& workspace_;
    TimeModel& time_;
    std::string scan_;
    app::PanoramaRequest request_;
    Preparation preparation_;
    bool watched_ = false;
    bool stale_ = true;
    bool loading_ = false;
    std::shared_ptr<const LoadedPanorama> loaded_;
    QString trouble_;
};

/// The same of a ring in the site grid; cut where it leaves the picture or crosses its border.
[[nodiscard]] std::vector<PointList> ring_in_picture(const scans::Projection& projection,
                                                     const geometry::Rigid3& scan_from_site, const model::Ring& ring);

} // namespace planum::gui
