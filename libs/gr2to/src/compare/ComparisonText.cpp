#include <iomanip>
#include <locale>
#include <nlohmann/json.hpp>
#include <sstream>

#include "gr2to/compare/Comparison.h"

namespace gr2to
{
namespace
{
using Json = nlohmann::ordered_json;

/** Lines of a table: what is measured, its value, what it says. */
class Table
{
 public:
    Table() { m_out.imbue(std::locale::classic()); }
    void heading(const std::string& text) { m_out << (m_out.tellp() > 0 ? "\n" : "") << text << '\n'; }
    void line(const std::string& name, double value, const std::string& meaning)
    {
        std::ostringstream text;
        text.imbue(std::locale::classic());
        text << std::fixed << std::setprecision(3) << value;
        put(name, text.str(), meaning);
    }
    void line(const std::string& name, int value, const std::string& meaning)
    {
        put(name, std::to_string(value), meaning);
    }
    void line(const std::string& name, const std::optional<double>& value, const std::string& meaning)
    {
        if (value)
            line(name, *value, meaning);
        else
            put(name, "-", meaning);
    }
    std::string text() const { return m_out.str(); }

 private:
    void put(const std::string& name, const std::string& value, const std::string& meaning)
    {
        m_out << "  " << std::left << std::setw(20) << name << std::right << std::setw(8) << value
              << (meaning.empty() ? "" : "  " + meaning) << '\n';
    }
    std::ostringstream m_out;
};

void addRooms(Table& table, const ComparisonScores& scores)
{
    const auto& m = scores.matched;
    table.heading("Rooms, paired with places one to one on free cells");
    table.line("rooms", m.rooms, "in the reference");
    table.line("places", m.segments, "in the map, of more than 100 cells");
    table.line("count error", m.countError, "places - rooms");
    table.line("mean IoU", m.meanIou, "overlap / union, mean over rooms");
    table.line("IoU >= 0.5", m.iouOverHalf, "share of the rooms");
    table.line("MCC", m.mcc, "correlation of rooms and places, -1 to 1");
    table.line("split rooms", m.splitRooms, "held by two places or more");
    table.line("merging places", m.mergingSegments, "that hold two rooms or more");
    table.line("labelled", m.labelledFree, "share of the free cells that have a place");
    const auto& b = scores.bormann;
    table.heading("Rooms, after Bormann et al. 2016");
    table.line("recall", b.recall, "share of a room in its largest place");
    table.line("recall ceiling", b.recallCeiling, "recall of a perfect map of this grid");
    table.line("precision", b.precision, "share of a place in its largest room");
    table.line("recall by cells", b.recallByCells, "weighted by area");
    table.line("precision by cells", b.precisionByCells, "weighted by area");
    table.heading("Rooms, after the MAORIS evaluation");
    table.line("MCC", scores.maoris.mcc, "with its inflated true negatives");
    table.line("recall", scores.maoris.recall, "");
    table.line("precision", scores.maoris.precision, "");
}

void addDoors(Table& table, const DoorScores& doors, bool reliable)
{
    table.heading(reliable ? "Doors, within 0.75 m"
                           : "Doors, within 0.75 m (the reference's doors are not reliable)");
    table.line("annotated", doors.annotated, "in the reference");
    table.line("predicted", doors.predicted, "in the map");
    table.line("recall", doors.recall, "share of the annotated doors that are found");
    table.line("precision", doors.precision, "share of the predicted doors that are there");
    table.line("lenient precision", doors.precisionLenient, "leaving out those at openings and slits");
    table.line("F1", doors.f1, "");
    table.line("width error", doors.widthError_m, "m, mean over the doors found");
}

void addEdges(Table& table, const EdgeScores& edges)
{
    table.heading("Pairs of neighbouring rooms");
    table.line("annotated", edges.annotated, "in the reference");
    table.line("predicted", edges.predicted, "in the map");
    table.line("recall", edges.recall, "share of the annotated pairs that are found");
    table.line("precision", edges.precision, "share of the predicted pairs that are there");
    table.line("F1", edges.f1, "");
    table.line("internal", edges.internal, "connections between places in one room");
}

Json roomsJson(const ComparisonScores& scores)
{
    const auto& b = scores.bormann;
    const auto& m = scores.matched;
    Json json;
    json["bormann"] = {{"recall", b.recall},
                       {"precision", b.precision},
                       {"recall_px", b.recallByCells},
                       {"precision_px", b.precisionByCells}};
    if (b.recallCeiling) json["bormann"]["recall_ceiling"] = *b.recallCeiling;
    json["maoris"] = {
        {"mcc", scores.maoris.mcc}, {"precision", scores.maoris.precision}, {"recall", scores.maoris.recall}};
    json["matched"] = {{"mean_iou", m.meanIou},          {"mcc", m.mcc},
                       {"iou_over_half", m.iouOverHalf}, {"n_gt", m.rooms},
                       {"n_pred", m.segments},           {"count_error", m.countError},
                       {"split_rooms", m.splitRooms},    {"merging_segments", m.mergingSegments}};
    if (m.labelledFree) json["matched"]["labelled_free"] = *m.labelledFree;
    return json;
}
}  // namespace

std::string toText(const ComparisonScores& scores)
{
    Table table;
    addRooms(table, scores);
    if (scores.doors) addDoors(table, *scores.doors, scores.doorsReliable);
    if (scores.edges) addEdges(table, *scores.edges);
    return table.text();
}

std::string toJson(const ComparisonScores& scores)
{
    Json json = roomsJson(scores);
    if (const auto& e = scores.edges)
        json["edges"] = {{"precision", e->precision}, {"recall", e->recall},    {"f1", e->f1},
                         {"n_gt", e->annotated},      {"n_pred", e->predicted}, {"internal", e->internal}};
    if (const auto& d = scores.doors) {
        json["doors"] = {{"precision", d->precision},
                         {"recall", d->recall},
                         {"f1", d->f1},
                         {"n_gt", d->annotated},
                         {"n_pred", d->predicted},
                         {"precision_lenient", d->precisionLenient}};
        if (d->widthError_m) json["doors"]["width_error_m"] = *d->widthError_m;
        json["doors"]["reliable"] = scores.doorsReliable;
    }
    return json.dump(1) + "\n";
}
}  // namespace gr2to
