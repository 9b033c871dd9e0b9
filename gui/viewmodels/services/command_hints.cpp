// SPDX-License-Identifier: MIT
#include "gui/viewmodels/services/sentence_tables.hpp"

#include <QtGlobal>

#include <array>

namespace planum::gui::services {

namespace {

// Below the window nothing knows which menu does what a command does;
// tests/gui/gui_viewmodels/service_sentences_test.cpp finds a hint that is missing here.
constexpr std::array kHints = {
    Reworded{"no such file; make a project with planum new",
             QT_TRANSLATE_NOOP("services", "no such file; Project › New project makes one")},
    Reworded{"not a SQLite database", QT_TRANSLATE_NOOP("services", "not a Planum project")},
    Reworded{"no area %1; planum area list shows them", QT_TRANSLATE_NOOP("services", "no area %1")},
    Reworded{"no area %1; planum area list names all", QT_TRANSLATE_NOOP("services", "no area %1")},
    Reworded{"no scan %1; planum scan list shows them", QT_TRANSLATE_NOOP("services", "no scan %1")},
    Reworded{"no surface %1; planum surface list shows them", QT_TRANSLATE_NOOP("services", "no surface %1")},
    Reworded{"no surface %1; planum surface list names all", QT_TRANSLATE_NOOP("services", "no surface %1")},
    Reworded{"no region %1; planum region list names all, as SURFACE/UNIT#n",
             QT_TRANSLATE_NOOP("services", "no region %1")},
    Reworded{"%1 has no field %2; see planum %3 --help", QT_TRANSLATE_NOOP("services", "%1 has no field %2")},
    Reworded{"%1 %2 exists already; change it with `planum %3 set`",
             QT_TRANSLATE_NOOP("services", "%1 %2 exists already; choose it in the list to change it")},
    Reworded{"a region needs its outline: --outline \"x y z, x y z, …\"",
             QT_TRANSLATE_NOOP("services", "an outline is drawn: on the panorama, in plan or on a section")},
    Reworded{"a problem is accepted with a reason: --accept ID --because TEXT",
             QT_TRANSLATE_NOOP("services", "a problem is kept silent with a reason only")},
    Reworded{"no undecided problem has the id %1; planum check lists them",
             QT_TRANSLATE_NOOP("services", "this problem is not open any more; the list was checked again meanwhile")},
    Reworded{"no problem has the id %1; planum check lists them",
             QT_TRANSLATE_NOOP("services", "this problem is not in the list any more")},
    Reworded{"no open suggestion has the id %1; planum suggest lists them",
             QT_TRANSLATE_NOOP("services", "this suggestion is not open any more")},
    Reworded{"%1 is a question; state what you saw with planum relation add, or --reject it",
             QT_TRANSLATE_NOOP("services", "%1 is a question; state the relation that you saw, or reject it")},
    Reworded{"a suggestion is rejected with a reason: --because TEXT",
             QT_TRANSLATE_NOOP("services", "a suggestion is rejected with a reason only")},
    Reworded{
        "there is an interpretation %1 already; choose another name, or delete it with planum interpretation delete",
        QT_TRANSLATE_NOOP("services",
                          "there is a reading %1 already; choose another name, or delete it in Finds and lists")},
    Reworded{"of which day? Put it into a folder named by its date (2025-06-01) or say --day 2025-06-01",
             QT_TRANSLATE_NOOP("services",
                               "of which day? Put it into a folder named by its date (2025-06-01) and add that")},
    Reworded{"the project has another scan %1 with other content; rename the file, say another --day, or delete that "
             "scan first",
             QT_TRANSLATE_NOOP("services", "the project has another scan %1 with other content; rename the file or put "
                                           "it into the folder of another day")},
    Reworded{"scan %1: has no %2; range and normals can always be drawn",
             QT_TRANSLATE_NOOP("services", "scan %1 has no %2; range and shading can always be drawn")},
    Reworded{"scan %1: %2 is no longer the file that was added (its hash differs); put that back, or delete the scan "
             "and add the file as it is now",
             QT_TRANSLATE_NOOP("services", "scan %1: %2 is no longer the file that was added; put that back")},
    Reworded{"%1 is no longer the file that was added (its hash differs); put that back, or delete the scan and add "
             "the file as it is now",
             QT_TRANSLATE_NOOP("services", "%1 is no longer the file that was added; put that back")},
    Reworded{
        "block %1 with %2 points is damaged; planum verify makes it again from the original scan",
        QT_TRANSLATE_NOOP(
            "services",
            "block %1 with %2 points is damaged; Tools › Verify the project makes it again from the original scan")},
    Reworded{
        "this is LAZ, compressed LAS (point format %1), which is not read here; %2",
        QT_TRANSLATE_NOOP("services", "this is LAZ, compressed LAS, which is not read here; unpack it to LAS first")},
    Reworded{"marker %1 of %2 is %3 mm from where the file has it; kept (--update takes the file's)",
             QT_TRANSLATE_NOOP("services", "marker %1 of %2 is %3 mm from where the file has it; it was kept")},
    Reworded{
        "the project's markers cannot be read: planum undo takes the change back that spoilt them",
        QT_TRANSLATE_NOOP("services",
                          "the project's markers cannot be read: take the change back that spoilt them (Edit › Undo)")},
    Reworded{"the project has no scans yet: planum scan add SITE FILE|FOLDER",
             QT_TRANSLATE_NOOP("services", "the project has no scans yet: Add scans takes the folder of a day")},
    Reworded{"every scan is on the site grid already; --again places them anew, --day DAY those of a day",
             QT_TRANSLATE_NOOP("services", "every scan is on the site grid already")},
    Reworded{"nothing says where the site grid is: import the markers of one scan at least (planum markers import), or "
             "name a scan whose own frame is the grid (--origin)",
             QT_TRANSLATE_NOOP(
                 "services", "nothing says where the site grid is: import the markers of one scan at least (Markers)")},
    Reworded{"there is no registration run yet: planum register SITE",
             QT_TRANSLATE_NOOP("services", "there is no registration yet: Register places the scans")},
    Reworded{"the run is not in force: %1; planum register SITE --accept %2 puts it in force, --discard %3 drops it",
             QT_TRANSLATE_NOOP("services", "the registration %2 is not in force: %1; Tools › Accept a registration "
                                           "puts it in force, Discard a registration drops it")},
    Reworded{"surface %1: none of its scans stands on the site grid; planum register places them",
             QT_TRANSLATE_NOOP(
                 "services",
                 "surface %1: none of its scans stands on the site grid; Register in the list of scans places them")},
    Reworded{"surface %1: no scan of its days is in the project; planum scan add brings them",
             QT_TRANSLATE_NOOP("services", "surface %1: no scan of its days is in the project; Add scans brings them")},
    Reworded{"surface %1 stands before %2, though its day is later: nothing is concluded from either until --order or "
             "their days are put right",
             QT_TRANSLATE_NOOP("services", "surface %1 stands before %2, though its day is later: nothing is concluded "
                                           "from either until their places in time or their days are put right")},
    Reworded{"its days and its place in the order of surfaces disagree; planum check says with which",
             QT_TRANSLATE_NOOP("services", "its days and its place in the order of surfaces disagree")},
    Reworded{"an outline is left out, more than %1 m from all scans; planum check says where",
             QT_TRANSLATE_NOOP("services", "an outline is left out, more than %1 m from all scans")},
    Reworded{"%1 outlines are left out, more than %2 m from all scans; planum check says where",
             QT_TRANSLATE_NOOP("services", "%1 outlines are left out, more than %2 m from all scans")},
    Reworded{"none of its scans stands on the site grid; planum register places them",
             QT_TRANSLATE_NOOP("services",
                               "none of its scans stands on the site grid; Register in the list of scans places them")},
    Reworded{"no scan of its days is in the project; planum scan add brings them",
             QT_TRANSLATE_NOOP("services", "no scan of its days is in the project; Add scans brings them")},
    Reworded{"the project has no surface yet; planum scan add or region import make them",
             QT_TRANSLATE_NOOP("services", "the project has no surface yet; scans or outlines of a day make them")},
    Reworded{"neither outlines nor registered scans say where the area is: planum region import, planum register",
             QT_TRANSLATE_NOOP("services", "neither outlines nor registered scans say where the trench is")},
    Reworded{"it names neither a surface nor a day; give --day",
             QT_TRANSLATE_NOOP("services", "it names neither a surface nor a day")},
    Reworded{"fold: the site has no %1 yet", QT_TRANSLATE_NOOP("services", "the site has no %1 yet")},
    Reworded{"bands: the site has no %1 yet", QT_TRANSLATE_NOOP("services", "the site has no %1 yet")},
    Reworded{"no scan is on the site grid: planum register",
             QT_TRANSLATE_NOOP("services", "no scan is on the site grid: register the scans first")},
    Reworded{"no scan of this surface is on the site grid: planum register",
             QT_TRANSLATE_NOOP("services", "no scan of this surface is on the site grid: register its scans first")},
    Reworded{"not recognised; looked for %1 by content, name and the files beside it; name the format with --format",
             QT_TRANSLATE_NOOP("services", "not recognised: none of the lists that Planum reads (%1)")},
    Reworded{"read as %1 (%2)%3; --format overrules", QT_TRANSLATE_NOOP("services", "read as %1 (%2)%3")},
    Reworded{"left out: too large for a record; scans are added with planum scan add",
             QT_TRANSLATE_NOOP("services", "left out: too large for a list; scans are added with Add scans")},
    Reworded{"number %1 is used in area %2 and in area %3 and was taken for one unit; if they are two, import with "
             "--numbers area",
             QT_TRANSLATE_NOOP("services", "number %1 is used in area %2 and in area %3 and was taken for one unit")},
    Reworded{"site %1 with %2 units was read; left out: %3; --site takes another or all (*)",
             QT_TRANSLATE_NOOP("services", "site %1 with %2 units was read; left out: %3")},
    Reworded{"none of its rows holds coordinates; see --columns",
             QT_TRANSLATE_NOOP(
                 "services",
                 "none of its rows holds coordinates; its first line must name the columns (name, x, y, z, code, …)")},
    Reworded{"%1 areas have a unit %2; say --area",
             QT_TRANSLATE_NOOP("services", "%1 trenches have a unit %2; the file must say which (TRENCH::NUMBER)")},
};

} // namespace

std::span<const Reworded> command_hints() { return kHints; }

} // namespace planum::gui::services
