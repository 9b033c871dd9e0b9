// SPDX-License-Identifier: MIT
#include "gui/viewmodels/space_contents.hpp"

#include <algorithm>

#include "gui/viewmodels/models.hpp"
#include "gui/viewmodels/space_model.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gui_project.hpp"
#include "tests/support/measured_days.hpp"

using namespace planum;
using namespace planum::gui;
using test::settle;

namespace {

// Two days with a scan and two outlines each, of which that of unit 3 has heights.
struct Shown {
    test::TemporaryFolder folder;
    Models models{app::Session{"Ada"}};
    SpaceModel space{models.workspace, models.time};
    SpaceContents& contents = space.contents();

    Shown() {
        test::ensure_core_application();
        {
            app::Project project = test::make_measured_days(folder, folder / "site.gpkg");
            for (const char* day : {"2025-06-01", "2025-06-02"}) {
                app::record_kind("region").set(project, std::string(day) + "/3#1",
                                               {{"outline", "1 0 5, 2 0 5, 2 1 5, 1 1 5"}});
            }
        }
        models.workspace.open(folder / "site.gpkg", store::OpenMode::ReadWrite);
        space.set_watched(true);
        wait();
    }

    void wait() {
        settle(models.workspace);
        settle(models.workspace);
    }

    // A row by the texts on the way to it; of a group the text is Scans or Outlines.
    [[nodiscard]] QModelIndex at(const QStringList& texts) const {
        QModelIndex index;
        for (const QString& text : texts) {
            QModelIndex found;
            for (int row = 0; row < contents.rowCount(index); ++row) {
                const QModelIndex child = contents.index(row, 0, index);
                if (child.data().toString().startsWith(text)) found = child;
            }
            if (!found.isValid()) throw std::runtime_error("no row " + text.toStdString());
            index = found;
        }
        return index;
    }

    [[nodiscard]] Qt::CheckState state(const QStringList& texts) const {
        return static_cast<Qt::CheckState>(at(texts).data(Qt::CheckStateRole).toInt());
    }

    void set(const QStringList& texts, bool on) {
        contents.setData(at(texts), on ? Qt::Checked : Qt::Unchecked, Qt::CheckStateRole);
        wait();
    }

    [[nodiscard]] std::vector<std::string> days() const {
        std::vector<std::string> found;
        for (const app::PlacedScan& placed : space.scans()) found.push_back(placed.scan.day);
        return found;
    }
};

using Days = std::vector<std::string>;

const QString kFirst = QStringLiteral("2025-06-01");
const QString kSecond = QStringLiteral("2025-06-02");
const QString kScans = QStringLiteral("Scans");
const QString kOutlines = QStringLiteral("Outlines");

} // namespace

TEST_CASE("By itself 3D shows what the time line stands on; its row says so") {
    Shown s;
    CHECK(s.days() == Days{"2025-06-02"});
    CHECK(s.state({kSecond}) == Qt::Checked);
    CHECK(s.state({kFirst}) == Qt::Unchecked);
    CHECK_FALSE(s.contents.is_chosen());
    CHECK(s.contents.current() == s.at({kSecond}));
    s.models.time.go_to(0);
    s.wait();
    CHECK(s.days() == Days{"2025-06-01"});
    CHECK(s.state({kFirst, kOutlines}) == Qt::Checked);
    CHECK(s.state({kSecond}) == Qt::Unchecked);
}

TEST_CASE("A scan of another day is shown beside this one's and stays while the time line moves; undone in one go") {
    Shown s;
    s.set({kFirst, kScans, QStringLiteral("s")}, true);
    CHECK(s.days() == Days{"2025-06-01", "2025-06-02"});
    CHECK(s.state({kFirst}) == Qt::PartiallyChecked);
    CHECK(s.state({kFirst, kScans}) == Qt::Checked);
    CHECK(s.space.outlines().size() == 1); // those of the first day are not shown for that
    s.models.time.go_to(0);
    s.models.time.go_to(1);
    s.wait();
    CHECK(s.days().size() == 2);
    CHECK(s.contents.is_chosen());
    s.contents.follow_time_line();
    s.wait();
    CHECK(s.days() == Days{"2025-06-02"});
    CHECK_FALSE(s.contents.is_chosen());
}

TEST_CASE("All scans off leaves the outlines; a surface switches all that is below it") {
    Shown s;
    s.set({kSecond, kScans}, false);
    CHECK(s.space.scans().empty());
    CHECK(s.space.outlines().size() == 1);
    CHECK(s.state({kSecond}) == Qt::PartiallyChecked);
    s.set({kSecond}, false);
    CHECK(s.space.outlines().empty());
    s.set({kFirst}, true);
    CHECK(s.days() == Days{"2025-06-01"});
    CHECK(s.space.outlines().size() == 1);
    s.set({kSecond, kOutlines, QStringLiteral("3")}, true);
    CHECK(s.space.outlines().size() == 2);
    s.set({kSecond}, true); // what was chosen singly gives way
    CHECK(s.state({kSecond}) == Qt::Checked);
}

TEST_CASE("Who moves the time line to a surface that was cleared sees it again") {
    Shown s;
    s.set({kSecond}, false);
    CHECK(s.space.scans().empty());
    s.models.time.go_to(0);
    s.models.time.go_to(1);
    s.wait();
    CHECK(s.days() == Days{"2025-06-02"});
}

TEST_CASE("All surfaces at once are scans of all days; one can be taken out of them") {
    Shown s;
    s.contents.set_all_surfaces(true);
    s.wait();
    CHECK(s.days().size() == 2);
    s.set({kFirst, kScans, QStringLiteral("s")}, false);
    CHECK(s.days() == Days{"2025-06-02"});
}

TEST_CASE("What cannot be shown says why and cannot be checked") {
    Shown s;
    const QModelIndex flat = s.at({kSecond, kOutlines, QStringLiteral("2")});
    CHECK(flat.data().toString().contains(QStringLiteral("no heights")));
    CHECK_FALSE(s.contents.flags(flat).testFlag(Qt::ItemIsEnabled));
    CHECK_FALSE(s.contents.setData(flat, Qt::Checked, Qt::CheckStateRole));
    CHECK(s.state({kSecond, kOutlines}) == Qt::Checked); // all that can be
}

TEST_CASE("A change of the record keeps what was chosen, and the tree where nothing of it is other") {
    Shown s;
    s.set({kFirst, kScans}, true);
    int resets = 0;
    QObject::connect(&s.contents, &QAbstractItemModel::modelReset, [&resets] { ++resets; });
    s.models.workspace.edit(QStringLiteral("Add a find"),
                            [](app::Project& project, Progress&) { app::record_kind("find").add(project, "9", {}); });
    s.wait();
    CHECK(resets == 0);
    CHECK(s.days().size() == 2);
    s.models.workspace.edit(QStringLiteral("Take an outline away"), [](app::Project& project, Progress&) {
        app::record_kind("region").remove(project, "2025-06-01/3#1");
    });
    s.wait();
    CHECK(resets == 1);
    CHECK(s.days().size() == 2);
    s.models.workspace.close();
    CHECK_FALSE(s.contents.is_chosen());
    CHECK(s.contents.rowCount({}) == 0);
}

TEST_CASE("A day keeps its place among all days of the site, whatever is shown") {
    Shown s;
    CHECK(s.space.place_of_day("2025-06-01") == 0);
    CHECK(s.space.place_of_day("2025-06-02") == 1);
    s.set({kFirst}, true);
    CHECK(s.space.place_of_day("2025-06-02") == 1);
}
