// SPDX-License-Identifier: Apache-2.0
#include "catalogue/import_names.h"

#include <algorithm>
#include <map>

#include "catalogue/import_sheet.h"
#include "text/characters.h"
#include "text/nearest.h"

namespace millwright::catalogue {
namespace {

struct Synonyms {
  std::string_view column;
  std::string_view phrases;  ///< divided by bars
};

/// What makers and shops write, in English, German and Indonesian. A phrase may stand at several columns of a family;
/// units and figures then decide.
constexpr Synonyms synonyms[] = {
    {"manufacturer", "brand|maker|vendor|mfr|make|producer|hersteller|marke|merek|pabrikan"},
    {"part_number",
     "part no|part nr|part|pn|mpn|model|model no|model number|sku|article|article no|article number|"
     "item|item no|item number|order code|order no|order number|type|product|product code|product no|"
     "artikelnummer|artikel|artikel nr|bestellnummer|bestell nr|typ|teilenummer|kode|kode barang|tipe"},
    {"price",
     "unit price|nut price|price nut|carriage price|block price|net price|price each|list price|price per "
     "piece|cost|unit cost|preis|einzelpreis|"
     "st\xC3\xBC"
     "ckpreis|nettopreis|listenpreis|harga|harga satuan"},
    {"price_per_length",
     "price|preis|harga|price per metre|price per meter|price per m|meterpreis|preis pro meter|harga per meter"},
    {"price_per_mass", "price|preis|harga|price per kg|kilopreis|preis pro kg|harga per kg"},
    {"currency", "curr|w\xC3\xA4hrung|mata uang"},
    {"source", "url|link|datasheet|data sheet|datenblatt|web page|sumber"},
    {"confidence", "konfidenz|vertrauen|vertrauensw\xC3\xBCrdigkeit|keyakinan"},
    {"supplier", "shop|seller|distributor|dealer|lieferant|h\xC3\xA4ndler|toko|pemasok"},
    {"note", "notes|remark|remarks|comment|comments|description|bemerkung|beschreibung|catatan|keterangan"},
    {"pack_size", "pack quantity|package quantity|pack qty|qty per pack|vpe"},
    {"frame",
     "nema|nema size|frame size|motor frame|motor size|baugr\xC3\xB6\xC3\x9F"
     "e"},
    {"frame_size", "flange|flange size|flange width|motor width|flansch|flanschma\xC3\x9F|square flange"},
    {"body_length", "length|motor length|body|body length l|stack length|l\xC3\xA4nge|motorl\xC3\xA4nge|panjang"},
    {"shaft_diameter", "shaft|shaft dia|shaft d|shaft size|wellendurchmesser|welle|diameter poros|poros"},
    {"step_angle", "step|angle|angle per step|schrittwinkel|sudut langkah"},
    {"holding_torque",
     "torque|static torque|max torque|max holding torque|haltemoment|haltedrehmoment|drehmoment|torsi|"
     "torsi tahan"},
    {"detent_torque", "detent|cogging torque|residual torque|rastmoment|selbsthaltemoment"},
    {"rated_current",
     "current|phase current|current per phase|rated current per phase|amps|amps per phase|amperage|"
     "nennstrom|strom|phasenstrom|arus|arus per fasa"},
    {"phase_resistance",
     "resistance|resistance per phase|winding resistance|coil resistance|widerstand|"
     "phasenwiderstand|wicklungswiderstand|hambatan|resistansi"},
    {"phase_inductance",
     "inductance|inductance per phase|winding inductance|coil inductance|induktivit\xC3\xA4t|"
     "phaseninduktivit\xC3\xA4t|induktansi"},
    {"rotor_inertia",
     "inertia|rotor moment of inertia|moment of inertia|tr\xC3\xA4gheitsmoment|rotortr\xC3\xA4gheit|"
     "rotortr\xC3\xA4gheitsmoment|massentr\xC3\xA4gheitsmoment|inersia|inersia rotor"},
    {"nut_mass", "nut weight|weight nut|weight of nut|muttergewicht"},
    {"screw_mass_per_length", "shaft weight|screw weight|weight shaft|weight of shaft"},
    {"carriage_mass", "block weight|block mass|carriage weight|weight block|weight carriage|wagengewicht"},
    {"rail_mass_per_length", "rail weight|rail mass|weight rail|schienengewicht"},
    {"inertia", "moment of inertia|tr\xC3\xA4gheitsmoment|massentr\xC3\xA4gheitsmoment|inersia"},
    {"mass", "weight|net weight|motor weight|gewicht|masse|berat|wt"},
    {"maximum_voltage", "max voltage|voltage max|supply voltage max|max spannung"},
    {"drive_voltage", "voltage|supply voltage|spannung|tegangan"},
    {"phase_current", "current|strom|arus"},
    {"speed", "rpm|drehzahl|kecepatan"},
    {"torque", "pull out torque|drehmoment|torsi"},
    {"nominal_diameter", "diameter|dia|nominal dia|size|d|d0|durchmesser|nenndurchmesser"},
    {"outside_diameter",
     "od|outer diameter|outer dia|external diameter|au\xC3\x9F"
     "endurchmesser|diameter luar"},
    {"lead", "thread lead|travel per rev|travel per revolution|steigung"},
    {"root_diameter", "root dia|core diameter|kerndurchmesser"},
    {"pitch", "teilung|tooth pitch|thread pitch"},
    {"dynamic_load_rating",
     "dynamic load|dynamic load c|dynamic load ca|dynamic load capacity|basic dynamic load rating|dynamic rating|ca|c|"
     "dynamische tragzahl|dyn tragzahl"},
    {"static_load_rating",
     "static load|static load c0|static load c0a|static load capacity|basic static load rating|static "
     "rating|c0a|c0|coa|co|"
     "statische tragzahl|stat tragzahl"},
    {"accuracy_grade", "accuracy|grade|accuracy class|genauigkeit|toleranzklasse"},
    {"minimum_bore", "bore min|min bore|bohrung min"},
    {"maximum_bore", "bore max|max bore|bohrung max|bore"},
    {"bore", "bore diameter|inner diameter|id|bohrung|shaft bore"},
    {"rated_torque", "torque|nominal torque|nenndrehmoment|nennmoment"},
    {"maximum_torque", "max torque|peak torque|maximalmoment"},
    {"torsional_stiffness", "stiffness|torsional rigidity|static torsional stiffness|torsionssteife"},
    {"maximum_speed",
     "max speed|max rpm|speed|rpm|h\xC3\xB6"
     "chstdrehzahl|max drehzahl"},
    {"teeth", "number of teeth|no of teeth|tooth count|z|z\xC3\xA4hne|z\xC3\xA4hnezahl|jumlah gigi"},
    {"width", "breite|lebar|belt width"},
    {"belt_width", "width|breite"},
    {"height", "h\xC3\xB6he|tinggi"},
    {"length", "overall length|l\xC3\xA4nge|panjang"},
    {"material", "werkstoff|bahan"},
    {"efficiency", "wirkungsgrad|eff|efisiensi"},
    {"output_voltage", "voltage|dc voltage|output|ausgangsspannung|tegangan"},
    {"output_current", "current|ausgangsstrom|arus"},
    {"power", "wattage|watt|watts|rated power|leistung|daya"},
    {"peak_current", "max current|current max|current|spitzenstrom"},
    {"rms_current", "current rms|continuous current"},
    {"minimum_voltage", "min voltage|voltage min"},
    {"mass_per_length", "weight per metre|weight per meter|weight per m|mass per metre|metergewicht|gewicht pro meter"},
    {"profile", "belt profile|tooth profile|profil"},
    {"module", "modul|m"},
};

bool is_upper(char c) { return c >= 'A' && c <= 'Z'; }
bool is_lower(char c) { return c >= 'a' && c <= 'z'; }
bool is_letter(char c) { return is_upper(c) || is_lower(c) || (static_cast<unsigned char>(c) & 0x80U) != 0; }

/// One spelling for what is often abbreviated.
std::string in_full(const std::string& word) {
  static const std::map<std::string, std::string> all = {{"dia", "diameter"},
                                                         {"max", "maximum"},
                                                         {"min", "minimum"},
                                                         {"no", "number"},
                                                         {"nr", "number"},
                                                         {"num", "number"},
                                                         {"qty", "quantity"},
                                                         {"wt", "weight"},
                                                         {"dyn", "dynamic"},
                                                         {"stat", "static"}};
  const auto found = all.find(word);
  return found == all.end() ? word : found->second;
}

/// Said of so many figures that they tell nothing.
bool is_filler(const std::string& word) {
  return word == "of" || word == "the" || word == "in" || word == "approx" || word == "ca." || word == "nominal";
}

std::string joined(const std::vector<std::string>& words) {
  std::string all;
  for (const std::string& word : words) all += word;
  return all;
}

struct Phrase {
  std::vector<std::string> words;
  std::string joined;
};

std::vector<Phrase> phrases_of(std::string_view column) {
  std::vector<Phrase> phrases;
  const auto add = [&](std::string_view text) {
    Phrase phrase{words_of(text), {}};
    phrase.joined = joined(phrase.words);
    phrases.push_back(std::move(phrase));
  };
  add(column);
  for (const Synonyms& each : synonyms) {
    if (each.column != column) continue;
    for (std::size_t begin = 0; begin <= each.phrases.size();) {
      const std::size_t end = std::min(each.phrases.find('|', begin), each.phrases.size());
      add(each.phrases.substr(begin, end - begin));
      begin = end + 1;
    }
  }
  return phrases;
}

bool all_in(const std::vector<std::string>& some, const std::vector<std::string>& all) {
  return std::all_of(
      some.begin(), some.end(), [&](const auto& word) { return std::find(all.begin(), all.end(), word) != all.end(); });
}

/// `said`: the words of a header, joined.
double phrase_match(const std::vector<std::string>& words, const std::string& said, const Phrase& phrase, bool own) {
  if (words.empty() || phrase.words.empty()) return 0.0;
  if (said == phrase.joined) return own ? 1.0 : 0.95;
  const std::size_t length = phrase.joined.size();
  const auto more = static_cast<double>(words.size()) - static_cast<double>(phrase.words.size());
  // With five words too many it is no likeness worth looking for.
  if (more < 5.0 && all_in(phrase.words, words)) {
    if (more <= 0.0) return 0.9;
    // A short word among others says little: "part" in "moving part", "type" in "cable type".
    return std::max(0.0, (phrase.words.size() > 1 || length > 5 ? 0.85 : 0.7) - 0.08 * more);
  }
  if (more < 5.0 && said.size() > 3 && all_in(words, phrase.words)) return std::max(0.0, 0.7 + 0.08 * more);
  const std::size_t allowed = said.size() / 5;
  const std::size_t apart = said.size() > length ? said.size() - length : length - said.size();
  if (own && said.size() > 5 && apart <= allowed && text::edit_distance(said, phrase.joined) <= allowed) return 0.75;
  return 0.0;
}

}  // namespace

std::vector<std::string> words_of(std::string_view name) {
  std::vector<std::string> words;
  std::string word;
  const auto finish = [&] {
    if (!word.empty() && !is_filler(word)) words.push_back(in_full(word));
    word.clear();
  };
  for (std::size_t i = 0; i < name.size(); ++i) {
    const char c = name[i];
    if (!is_letter(c) && !text::is_digit(c)) {
      finish();
      continue;
    }
    if (is_upper(c) && i > 0 && is_lower(name[i - 1])) finish();
    word += is_upper(c) ? static_cast<char>(c - 'A' + 'a') : c;
  }
  finish();
  return words;
}

bool has_quantity(std::string_view header) {
  for (std::size_t begin = 0; begin < header.size(); ++begin) {
    if (!text::is_digit(header[begin])) continue;
    std::size_t end = begin;
    while (end < header.size() && text::is_digit(header[end])) ++end;
    if (header.substr(begin, end - begin) != "1") return true;
    begin = end;
  }
  return false;
}

std::vector<HeaderReading> header_readings(std::string_view header) {
  header = without_blanks(header);
  std::vector<HeaderReading> readings;
  const auto add = [&](std::size_t name_end, std::size_t unit_begin, std::size_t unit_end) {
    const std::string_view name = without_blanks(header.substr(0, name_end));
    const std::string_view unit = without_blanks(header.substr(unit_begin, unit_end - unit_begin));
    if (!name.empty() && !unit.empty()) readings.push_back({name, unit});
  };
  for (const auto& [open, close] : {std::pair{'[', ']'}, std::pair{'(', ')'}}) {
    const std::size_t begin = header.rfind(open);
    const std::size_t end = header.rfind(close);
    if (begin != std::string_view::npos && end != std::string_view::npos && begin < end) add(begin, begin + 1, end);
  }
  if (const std::size_t at = header.rfind(" in "); at != std::string_view::npos) add(at, at + 4, header.size());
  for (const char mark : {',', ':', '|', '/'})
    if (const std::size_t at = header.rfind(mark); at != std::string_view::npos) add(at, at + 1, header.size());
  std::size_t at = header.size();
  for (int tokens = 0; tokens < 2 && at != std::string_view::npos && at > 0; ++tokens) {
    at = header.find_last_of(" _", at - 1);
    if (at != std::string_view::npos) add(at, at + 1, header.size());
  }
  readings.push_back({header, {}});
  return readings;
}

double name_match(const std::vector<std::string>& words, Column column) {
  static const auto all = [] {
    std::map<std::string_view, std::vector<Phrase>> phrases;
    for (const FamilyDeclaration& family : families)
      for (std::size_t index = 0; index < column_count(family.family); ++index) {
        const std::string_view name = declaration(Column{family.family, static_cast<std::uint8_t>(index)}).name;
        if (phrases.find(name) == phrases.end()) phrases.emplace(name, phrases_of(name));
      }
    return phrases;
  }();
  double best = 0.0;
  bool own = true;
  const std::string said = joined(words);
  for (const Phrase& phrase : all.at(declaration(column).name)) {
    best = std::max(best, phrase_match(words, said, phrase, own));
    own = false;
  }
  return best;
}

}  // namespace millwright::catalogue
