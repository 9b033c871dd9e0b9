// SPDX-License-Identifier: MIT
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "tests/support/catch.hpp"
#include "tests/support/real_data.hpp"

namespace fs = std::filesystem;

namespace {

struct Layer {
    std::set<std::string> may;
    std::set<std::string> third;
};

using Layers = std::map<std::string, Layer>;

std::set<std::string> words(const std::string& text) {
    std::istringstream in(text);
    std::set<std::string> all;
    for (std::string word; in >> word;) all.insert(word);
    return all;
}

Layers read_layers(std::istream& in) {
    Layers layers;
    for (std::string line; std::getline(in, line);) {
        if (line.empty() || line.front() == '#') continue;
        const auto colon = line.find(':');
        const auto bar = line.find('|');
        REQUIRE(colon != std::string::npos);
        REQUIRE(bar != std::string::npos);
        const std::string folder = *words(line.substr(0, colon)).begin();
        layers[folder] = {words(line.substr(colon + 1, bar - colon - 1)), words(line.substr(bar + 1))};
    }
    return layers;
}

Layers read_layers() {
    std::ifstream in(planum::test::source_folder() / "cmake/layers.txt");
    REQUIRE(in);
    return read_layers(in);
}

// Folder of the table that a path like strat/matrix/x.hpp belongs to; empty: none.
std::string layer_of(const Layers& layers, const std::string& path) {
    std::string best;
    for (const auto& [folder, layer] : layers) {
        if (path.rfind(folder + "/", 0) == 0 && folder.size() > best.size()) best = folder;
    }
    return best;
}

// Which library a header in angle brackets belongs to; empty: the language's or the system's.
std::string library_of(const std::string& header) {
    static const std::vector<std::pair<std::regex, std::string>> table = {
        {std::regex("fmt/.*"), "fmt"},
        {std::regex("openssl/.*"), "crypto"},
        {std::regex("sqlite3\\.h"), "sqlite"},
        {std::regex("boost/.*"), "boost_graph"},
        {std::regex("Eigen/.*"), "eigen"},
        {std::regex("pugixml\\.hpp"), "pugixml"},
        {std::regex("nlohmann/.*"), "json"},
        {std::regex("CLI/.*"), "cli11"},
        {std::regex("archive.*\\.h"), "archive"},
        {std::regex("xlsxwriter.*"), "xlsx"},
        {std::regex("(graphviz/.*|gvc\\.h|cgraph\\.h)"), "graphviz"},
        {std::regex("geos.*"), "geos"},
        {std::regex("proj.*\\.h"), "proj"},
        {std::regex("opencv2/.*"), "opencv"},
        {std::regex("nanoflann\\.hpp"), "nanoflann"},
        {std::regex("png\\.h"), "png"},
        {std::regex("(jpeglib|jerror)\\.h"), "jpeg"},
        {std::regex("Q(OpenGLWidget|.*Widget|MainWindow|.*Dialog|MessageBox|Application|.*View|.*Button|.*Edit|"
                    "ComboBox|CheckBox|.*SpinBox|Slider|Splitter|ScrollArea|AbstractScrollArea|(.*Box|Grid|Form|"
                    "Stacked)?Layout|Menu|MenuBar|"
                    "ToolBar|ToolTip|StatusBar|Label|Frame|Completer|Style|ProxyStyle|StyleFactory|StyleOption|.*"
                    "ItemDelegate|HeaderView|"
                    "ProgressBar|Shortcut|ScrollBar|ScrollerProperties|Scroller|GraphicsItem|GraphicsScene)"),
         "qtwidgets"},
        {std::regex("QOpenGL.*"), "opengl"},
        {std::regex("Q(Object|String|StringList|Abstract.*Model|ModelIndex|SortFilterProxyModel|Timer|Thread.*|Variant|"
                    "Hash|List|DateTime|Date|Settings|StandardPaths|File|FileInfo|FileSystemWatcher|Dir|Event|"
                    "EventLoop|CoreApplication|Pointer|MetaObject|Point|PointF|Rect|RectF|Size|SizeF|Locale|"
                    "Translator|RegularExpression|ElapsedTimer|SignalBlocker|LockFile|CryptographicHash|"
                    "XmlStreamReader|Url|Mutex|"
                    "ByteArray|LibraryInfo|t)|Qt[A-"
                    "Z].*|Qt"),
         "qtcore"},
        {std::regex("Q[A-Z].*"), "qtgui"},
    };
    for (const auto& [pattern, library] : table) {
        if (std::regex_match(header, pattern)) return library;
    }
    return {};
}

std::vector<std::string> violations(const Layers& layers, const std::string& path, std::istream& in) {
    static const std::regex include("^\\s*#\\s*include\\s*([\"<])([^\">]+)[\">].*");
    const std::string from = layer_of(layers, path);
    const Layer& layer = layers.at(from);
    std::vector<std::string> bad;
    for (std::string line; std::getline(in, line);) {
        std::smatch match;
        if (!std::regex_match(line, match, include)) continue;
        const std::string header = match[2];
        if (match[1] == "\"") {
            const std::string to = layer_of(layers, header);
            if (to.empty()) bad.push_back(path + " includes " + header + ", which is not named from the root");
            if (!to.empty() && to != from && layer.may.count(to) == 0) bad.push_back(path + " includes " + header);
            continue;
        }
        const std::string library = library_of(header);
        // fmt is everybody's; qtwidgets brings qtgui along, and that qtcore.
        if (library.empty() || library == "fmt" || layer.third.count(library) > 0) continue;
        const bool has_widgets = layer.third.count("qtwidgets") > 0;
        if (library == "qtgui" && has_widgets) continue;
        if (library == "qtcore" && (has_widgets || layer.third.count("qtgui") > 0)) continue;
        bad.push_back(path + " includes <" + header + ">");
    }
    return bad;
}

} // namespace

TEST_CASE("No file includes what the layer table does not allow") {
    const Layers layers = read_layers();
    const fs::path root = planum::test::source_folder();
    std::vector<std::string> bad;
    std::size_t files = 0;
    for (const auto& [folder, layer] : layers) {
        if (!fs::exists(root / folder)) continue;
        for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
            const std::string path = fs::relative(entry.path(), root).generic_string();
            if (entry.path().extension() != ".hpp" && entry.path().extension() != ".cpp") continue;
            if (layer_of(layers, path) != folder) continue;
            std::ifstream in(entry.path());
            const auto found = violations(layers, path, in);
            bad.insert(bad.end(), found.begin(), found.end());
            ++files;
        }
    }
    CHECK(files > 30);
    CHECK(bad == std::vector<std::string>{});
}

TEST_CASE("The include test sees an include that the table does not allow") {
    std::istringstream table(
        "core/base : |\ncore/model : core/base |\nstrat/matrix : core/base core/model | boost_graph\n");
    const Layers layers = read_layers(table);
    std::istringstream upwards("#include \"strat/matrix/harris_matrix.hpp\"\n");
    CHECK(violations(layers, "core/model/unit.cpp", upwards).size() == 1);
    std::istringstream library("#include <boost/graph/strong_components.hpp>\n#include <vector>\n");
    CHECK(violations(layers, "core/model/unit.cpp", library).size() == 1);
    std::istringstream fine("#include \"core/model/unit.hpp\"\n#include <boost/graph/strong_components.hpp>\n");
    CHECK(violations(layers, "strat/matrix/harris_matrix.cpp", fine).empty());
}

TEST_CASE("A source file includes its own header first, so that the header is proven to compile alone") {
    const Layers layers = read_layers();
    const fs::path root = planum::test::source_folder();
    const std::regex include("^\\s*#\\s*include\\s*[\"<]([^\">]+)[\">].*");
    std::vector<std::string> bad;
    std::size_t files = 0;
    for (const auto& [folder, layer] : layers) {
        if (!fs::exists(root / folder)) continue;
        for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
            fs::path header = entry.path();
            header.replace_extension(".hpp");
            if (entry.path().extension() != ".cpp" || !fs::exists(header)) continue;
            ++files;
            std::ifstream in(entry.path());
            std::string first;
            std::smatch match;
            for (std::string line; first.empty() && std::getline(in, line);) {
                if (std::regex_match(line, match, include)) first = match[1];
            }
            if (first != fs::relative(header, root).generic_string())
                bad.push_back(entry.path().string() + " begins with " + first);
        }
    }
    CHECK(files > 20);
    CHECK(bad == std::vector<std::string>{});
}

TEST_CASE("Only files of core/store hold SQL on the project's tables") {
    const fs::path root = planum::test::source_folder();
    const std::regex sql("\"[^\"]*\\b(INSERT INTO|UPDATE [a-z_]+ SET|DELETE FROM)\\b");
    std::vector<std::string> bad;
    for (const char* folder : {"app", "cli", "gui", "paint", "scans", "strat", "core/model", "core/geometry"}) {
        if (!fs::exists(root / folder)) continue;
        for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
            if (entry.path().extension() != ".cpp") continue;
            std::ifstream in(entry.path());
            for (std::string line; std::getline(in, line);) {
                if (std::regex_search(line, sql)) bad.push_back(entry.path().string());
            }
        }
    }
    CHECK(bad == std::vector<std::string>{});
}
