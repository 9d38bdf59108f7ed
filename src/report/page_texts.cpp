// SPDX-License-Identifier: Apache-2.0
#include "report/page_texts.h"

#include <fmt/format.h>

#include <cctype>
#include <stdexcept>

namespace millwright::report {

std::string_view code(Language language) { return language == Language::indonesian ? "id" : "en"; }

std::optional<Language> language_of(std::string_view code) {
  if (code == "en") return Language::english;
  if (code == "id") return Language::indonesian;
  return std::nullopt;
}

std::vector<std::string> language_codes() { return {"en", "id"}; }

std::string Texts::operator()(std::string_view key) const {
  for (const PageText& text : page_texts())
    if (text.key == key) return std::string(language_ == Language::indonesian ? text.indonesian : text.english);
  throw std::logic_error(fmt::format("the page has no text '{}'", key));
}

namespace {

/// Numbers as gaps, and what stood there.
std::string with_gaps(std::string_view text, std::vector<std::string>& numbers) {
  std::string out;
  for (std::size_t i = 0; i < text.size();) {
    const bool begins = std::isdigit(static_cast<unsigned char>(text[i])) != 0 && (i == 0 || text[i - 1] == ' ');
    std::size_t end = i;
    while (begins && end < text.size() &&
           (std::isalnum(static_cast<unsigned char>(text[end])) != 0 || text[end] == '.' || text[end] == '+' ||
            text[end] == '-'))
      ++end;
    if (!begins) {
      out += text[i++];
      continue;
    }
    numbers.emplace_back(text.substr(i, end - i));
    out += "{}";
    i = end;
  }
  return out;
}

std::string filled(std::string_view text, const std::vector<std::string>& numbers) {
  std::string out;
  std::size_t next = 0;
  for (std::size_t gap = text.find("{}"); gap != std::string_view::npos && next < numbers.size();
       gap = text.find("{}")) {
    out += std::string(text.substr(0, gap)) + numbers[next++];
    text.remove_prefix(gap + 2);
  }
  return out + std::string(text);
}

}  // namespace

std::string Texts::said(std::string_view english) const {
  if (language_ == Language::english) return std::string(english);
  std::vector<std::string> numbers;
  const std::string form = with_gaps(english, numbers);
  for (const Saying& saying : sayings()) {
    if (saying.english == english) return std::string(saying.indonesian);
    if (saying.english == form) return filled(saying.indonesian, numbers);
  }
  return std::string(english);
}

std::string Texts::clauses(std::string_view english) const {
  std::string out;
  while (true) {
    const std::size_t end = english.find("; ");
    out += said(english.substr(0, end));
    if (end == std::string_view::npos) return out;
    out += "; ";
    english.remove_prefix(end + 2);
  }
}

const std::vector<PageText>& page_texts() {
  static const std::vector<PageText> texts{
      {"kind.solve", "Design and calculation", "Rancangan dan perhitungan"},
      {"kind.check", "Check of a bill of materials", "Pemeriksaan daftar komponen"},
      {"kind.pareto", "Front of builds", "Garis depan Pareto"},
      {"kind.sweep", "One value over a range", "Satu nilai sepanjang rentang"},
      {"kind.audit", "Audit of a published calculation", "Audit perhitungan terbitan"},
      {"footer",
       "Made by Millwright. Values are computed in SI and shown with four significant digits; the complete result for "
       "programs is inside this page.",
       "Dibuat dengan Millwright. Nilai dihitung dalam SI dan ditampilkan dengan empat angka penting; hasil lengkap "
       "untuk program ada di dalam halaman ini."},

      {"summary", "Summary", "Ringkasan"},
      {"summary.governing", "Governing check of each axis", "Pemeriksaan penentu tiap sumbu"},
      {"summary.failures", "Failed checks", "Pemeriksaan yang gagal"},
      {"summary.asked", "Asked for beside the problem", "Permintaan di luar berkas masalah"},
      {"summary.voltage", "Supply voltage", "Tegangan catu daya"},
      {"banner.proved",
       "Compliant, and proved to be the best build of these catalogues.",
       "Memenuhi semua syarat, dan terbukti terbaik dari katalog ini."},
      {"banner.proved_robust",
       "Compliant for every value within the stated tolerances, and proved to be the best such build of these "
       "catalogues.",
       "Memenuhi semua syarat untuk setiap nilai dalam toleransi yang dinyatakan, dan terbukti terbaik dari katalog "
       "ini."},
      {"banner.best_so_far",
       "Compliant; the best build found before the limit, not proved to be the best.",
       "Memenuhi syarat; terbaik yang ditemukan sebelum batas, belum terbukti terbaik."},
      {"banner.satisfied", "It satisfies every check.", "Semua pemeriksaan terpenuhi."},
      {"banner.failed", "It fails {} of {} checks.", "Gagal pada {} dari {} pemeriksaan."},
      {"banner.none", "No compliant build exists.", "Tidak ada rancangan yang memenuhi syarat."},
      {"banner.limit_none",
       "The limit was reached before a compliant build was found.",
       "Batas tercapai sebelum rancangan yang memenuhi syarat ditemukan."},
      {"banner.front", "{} builds that no other build beats.", "{} rancangan yang tidak terkalahkan."},
      {"banner.front_open",
       "{} builds found before the limit; points may be missing.",
       "{} rancangan ditemukan sebelum batas; mungkin belum lengkap."},
      {"quantity.cost", "Cost", "Biaya"},
      {"quantity.mass", "Mass", "Massa"},
      {"quantity.cycle_time", "Cycle time", "Waktu siklus"},
      {"quantity.energy", "Energy per cycle", "Energi per siklus"},
      {"quantity.position_error", "Position error", "Galat posisi"},

      {"axis", "Axis", "Sumbu"},
      {"machine", "Machine", "Mesin"},
      {"axis.title", "Axis {}", "Sumbu {}"},
      {"axis.whole", "The whole machine", "Seluruh mesin"},
      {"axis.motion", "Motion over one cycle", "Gerak selama satu siklus"},
      {"axis.torque",
       "Torque over speed of the motor: published pull-out curve, what of it is permitted, and every phase",
       "Torsi terhadap putaran motor: kurva pull-out terbitan, bagian yang diizinkan, dan setiap fase"},
      {"axis.torque_estimate",
       "Torque over speed of the motor: estimate from the winding (no published curve), what of it is permitted, and "
       "every phase",
       "Torsi terhadap putaran motor: perkiraan dari lilitan (tanpa kurva terbitan), bagian yang diizinkan, dan setiap "
       "fase"},
      {"axis.hollow", "hollow: phases that cannot govern", "kosong: fase yang tidak menentukan"},
      {"axis.dwells", "long dwells are drawn shorter", "jeda panjang digambar lebih pendek"},
      {"axis.checks", "Checks, the closest to its limit first", "Pemeriksaan, yang terdekat ke batas lebih dulu"},
      {"axis.soft",
       "* reported, not enforced. The mark in the bars is the limit, 100 %.",
       "* dilaporkan, tidak diwajibkan. Tanda pada batang adalah batas, 100 %."},
      {"axis.errors", "Error budget", "Anggaran galat"},
      {"axis.stiffness", "Stiffness of the drive along the travel", "Kekakuan penggerak sepanjang gerak"},

      {"check", "Check", "Pemeriksaan"},
      {"check.id", "Id", "Id"},
      {"check.value", "Value", "Nilai"},
      {"check.limit", "Limit", "Batas"},
      {"check.unit", "Unit", "Satuan"},
      {"check.used", "Used", "Terpakai"},
      {"check.worst", "Worst in", "Terburuk pada"},
      {"verdict.ok", "ok", "ok"},
      {"verdict.fail", "FAIL", "GAGAL"},
      {"verdict.over", "over", "lebih"},
      {"verdict.open", "open", "terbuka"},

      {"drawing.title", "The machine", "Mesin"},
      {"drawing.caption",
       "To scale: rails, carriages in the middle and at both ends of the stroke, screws, belts and racks in their cut "
       "lengths, motors by their flange. Supports, nuts and rotary tables are marks. The tool side is above, the base "
       "below.",
       "Sesuai skala: rel, kereta di tengah dan di kedua ujung langkah, ulir, sabuk dan rak dalam panjang potongnya, "
       "motor menurut flensanya. Dudukan, mur dan meja putar hanya tanda. Sisi alat di atas, dasar di bawah."},
      {"drawing.vertical", "upright", "tegak"},
      {"drawing.inclined", "inclined", "miring"},
      {"drawing.rotary", "rotary table", "meja putar"},

      {"parts", "Bill of materials", "Daftar komponen"},
      {"parts.slot", "Slot", "Tempat"},
      {"parts.part", "Part", "Komponen"},
      {"parts.quantity", "Qty", "Jumlah"},
      {"parts.owned", "in stock", "tersedia"},
      {"parts.length", "Length", "Panjang"},
      {"parts.spare", "spare", "cadangan"},
      {"parts.bars", "Cut from whole bars", "Dipotong dari batang utuh"},
      {"parts.bar", "Bar", "Batang"},
      {"parts.pieces", "Pieces", "Potongan"},
      {"parts.left_over", "Left over", "Sisa"},
      {"parts.shipping", "Shipping", "Ongkos kirim"},
      {"parts.top_up", "Filling up to the minimum order", "Penggenapan ke pesanan minimum"},
      {"parts.supplier", "Supplier", "Pemasok"},
      {"parts.confidence", "Confidence", "Keyakinan"},
      {"parts.notes", "Notes", "Catatan"},
      {"parts.price_basis", "price", "harga"},
      {"parts.source", "figures", "data"},
      {"parts.made", "Members made to measure, by their mass", "Bagian yang dibuat khusus, menurut massa"},
      {"parts.total", "Total", "Jumlah"},
      {"parts.estimate",
       "~ the price, or a figure of the part that matters, is an estimate",
       "~ harga, atau data komponen yang penting, adalah perkiraan"},
      {"settings", "Dimensions and settings", "Ukuran dan pengaturan"},
      {"settings.name", "Name", "Nama"},
      {"alternatives", "Alternatives", "Alternatif"},
      {"tolerances", "Tolerances", "Toleransi"},

      {"sheet", "Calculation sheet", "Lembar perhitungan"},
      {"sheet.element", "Calculation: {}", "Perhitungan: {}"},
      {"sheet.given", "Given", "Diketahui"},
      {"sheet.shared", "Used by several checks", "Dipakai beberapa pemeriksaan"},
      {"sheet.checks", "Checks", "Pemeriksaan"},
      {"sheet.limit", "limit", "batas"},
      {"sheet.worst", "worst in", "terburuk pada"},
      {"sheet.set_by", "limit set by", "batas ditentukan oleh"},
      {"sheet.source", "source", "sumber"},
      {"sheet.note", "note", "catatan"},

      {"chart.time", "time", "waktu"},
      {"chart.speed", "speed", "kecepatan"},
      {"chart.position", "travel", "perjalanan"},
      {"chart.motor_speed", "motor speed", "putaran motor"},
      {"chart.torque", "torque", "torsi"},
      {"chart.pull_out", "available", "tersedia"},
      {"chart.permitted", "permitted", "diizinkan"},
      {"chart.phase", "phase", "fase"},

      {"front", "The front", "Garis depan"},
      {"front.hint",
       "Every point is a compliant build that no other beats. Point at one for what it changes; click for its sheet.",
       "Setiap titik adalah rancangan yang tidak terkalahkan. Tunjuk untuk melihat perubahannya; klik untuk "
       "lembarnya."},
      {"front.build", "Build", "Rancangan"},
      {"front.changes", "What changes from the build before", "Perubahan dari rancangan sebelumnya"},
      {"front.first", "the first", "yang pertama"},
      {"front.dimensions", "dimensions and settings only", "hanya ukuran dan pengaturan"},
      {"front.previous", "previous", "sebelumnya"},
      {"front.next", "next", "berikutnya"},

      {"outside", "Outside the range a formula is stated for", "Di luar rentang berlakunya rumus"},
      {"outside.about",
       "That fails no check; it tells how far the figures can be trusted.",
       "Ini bukan kegagalan; ini menunjukkan sejauh mana angka dapat dipercaya."},
      {"outside.element", "Of", "Bagian"},
      {"outside.formula", "Formula", "Rumus"},
      {"outside.limit", "Limit", "Batas"},
      {"requirements", "Requirements behind the checks", "Persyaratan di balik pemeriksaan"},
      {"requirements.name", "Name", "Nama"},
      {"requirements.axes", "Axes", "Sumbu"},
      {"requirements.meaning", "Meaning", "Arti"},
      {"requirements.from", "From", "Asal"},
      {"requirements.given", "problem file", "berkas masalah"},
      {"requirements.default", "default", "bawaan"},
      {"assumptions", "Assumptions and estimates", "Asumsi dan perkiraan"},
      {"assume.machining_stated",
       "End machining of screws costs what the catalogue states of each, and that of shafts nothing; cables, fasteners "
       "and tax are not included.",
       "Biaya pengerjaan ujung ulir menurut katalog masing-masing, ujung poros tidak dihitung; kabel, pengikat dan "
       "pajak tidak termasuk."},
      {"assume.machining",
       "End machining of screws and shafts costs nothing here; cables, fasteners and tax are not included.",
       "Pengerjaan ujung ulir dan poros tidak dihitung; kabel, pengikat dan pajak tidak termasuk."},
      {"assume.length_bars",
       "Parts are cut to the length shown. Where whole bars are sold they are paid; elsewhere what is left of a bar is "
       "not.",
       "Komponen dipotong sesuai panjang yang tertera. Batang yang dijual utuh dibayar utuh; selain itu sisa batang "
       "tidak dibayar."},
      {"assume.length",
       "Parts are cut to the length shown; what is left of a bar is not paid for.",
       "Komponen dipotong sesuai panjang yang ditampilkan; sisa batang tidak dibayar."},
      {"assume.brake",
       "{}: a holding brake of {} N.m (brake_torque) is assumed; it is not among the parts, nor in price and mass.",
       "{}: rem penahan {} N.m (brake_torque) diandaikan ada; tidak termasuk komponen, harga, dan massa."},
      {"assume.counterbalance",
       "{}: a counterbalance of {} N (counterbalance_force) is assumed; it is not among the parts, nor in price and "
       "mass.",
       "{}: penyeimbang {} N (counterbalance_force) diandaikan ada; tidak termasuk komponen, harga, dan massa."},
      {"assume.cycle",
       "Cycle time: every move of every axis, and its dwell, one after the other; coordinated moves once.",
       "Waktu siklus: setiap gerak tiap sumbu beserta jedanya, satu per satu; gerak terkoordinasi sekali."},
      {"assume.energy",
       "Energy is an estimate, of the drives' input while their own axis goes through its cycle: copper losses at full "
       "current, usual iron losses, driver efficiency 0.9; nothing is fed back.",
       "Energi adalah perkiraan masukan penggerak selama siklus sumbunya: rugi tembaga pada arus penuh, rugi besi yang "
       "lazim, efisiensi driver 0,9; tidak ada yang dikembalikan."},
      {"assume.prices", "Prices", "Harga"},
      {"assume.estimates", "Estimated inputs", "Masukan perkiraan"},
      {"certificate", "Certificate", "Sertifikat"},
      {"catalogues", "Catalogues", "Katalog"},
      {"catalogues.about",
       "What this result rests on. Of a catalogue, the SHA-256 of the list that sha256sum prints of its files, "
       "ascending "
       "by name; then that of each file from which a part above comes.",
       "Dasar hasil ini. Untuk katalog: SHA-256 dari daftar yang dicetak sha256sum untuk berkas-berkasnya, urut nama; "
       "lalu SHA-256 tiap berkas asal komponen di atas."},
      {"catalogues.place", "Catalogue", "Katalog"},
      {"catalogues.file", "File", "Berkas"},
      {"catalogues.files", "Files", "Berkas"},
      {"catalogues.rows", "Rows", "Baris"},
      {"certificate.none",
       "Proved: no combination is compliant.",
       "Terbukti: tidak ada kombinasi yang memenuhi syarat."},
      {"certificate.none_robust",
       "Proved: no combination is compliant for every value within the stated tolerances.",
       "Terbukti: tidak ada kombinasi yang memenuhi syarat untuk setiap nilai dalam toleransi yang dinyatakan."},
      {"certificate.best_robust",
       "Proved: no build of these catalogues (with what was asked for) that is compliant for every value within the "
       "stated tolerances {}.",
       "Terbukti: tidak ada rancangan dari katalog ini (dengan permintaan yang diajukan) yang memenuhi syarat untuk "
       "setiap nilai dalam toleransi yang dinyatakan yang {}."},
      {"certificate.best",
       "Proved: no compliant build of these catalogues {}.",
       "Terbukti: tidak ada rancangan yang memenuhi syarat dari katalog ini yang {}."},
      {"certificate.best_asked",
       "Proved: no compliant build of these catalogues, with what was asked for above, {}.",
       "Terbukti: tidak ada rancangan yang memenuhi syarat dari katalog ini, dengan permintaan di atas, yang {}."},
      {"certificate.better.cost", "is cheaper", "lebih murah"},
      {"certificate.better.mass", "is lighter", "lebih ringan"},
      {"certificate.better.cycle_time", "is faster", "lebih cepat"},
      {"certificate.better.energy",
       "takes less energy, as it is estimated",
       "memakai energi lebih sedikit menurut perkiraan"},
      {"certificate.better.position_error", "is more exact", "lebih teliti"},
      {"certificate.better.sum", "has less {}", "memiliki {} lebih kecil"},
      {"certificate.open",
       "Not proved: a build of {} or more may still exist (gap {} %).",
       "Belum terbukti: rancangan dengan {} atau lebih mungkin masih ada (celah {} %)."},
      {"certificate.one_build",
       "Proved: there is only 1 compliant build, each set of parts counted once.",
       "Terbukti: hanya ada 1 rancangan yang memenuhi syarat, tiap set komponen dihitung sekali."},
      {"certificate.few_builds",
       "Proved: there are only {} compliant builds, each set of parts counted once.",
       "Terbukti: hanya ada {} rancangan yang memenuhi syarat, tiap set komponen dihitung sekali."},
      {"certificate.cheapest",
       "Proved: these are the {} cheapest builds, each set of parts counted once.",
       "Terbukti: inilah {} rancangan termurah, tiap set komponen dihitung sekali."},
      {"certificate.lightest",
       "Proved: these are the {} lightest builds, each set of parts counted once.",
       "Terbukti: inilah {} rancangan teringan, tiap set komponen dihitung sekali."},
      {"certificate.some",
       "Of {} builds asked for, proved before the limit: {}.",
       "Dari {} rancangan yang diminta, terbukti sebelum batas: {}."},
      {"certificate.front_within",
       "Proved: the front is covered to {} %, as said below.",
       "Terbukti: garis depan tercakup sampai {} %, seperti diterangkan di bawah."},
      {"certificate.front", "Proved: the front is complete and exact.", "Terbukti: garis depan lengkap dan tepat."},
      {"certificate.front_open",
       "Not proved: the limit was reached, points may be missing.",
       "Belum terbukti: batas tercapai, mungkin ada titik yang belum ditemukan."},
      {"certificate.combinations", "{} combinations of parts.", "{} kombinasi komponen."},
      {"certificate.again",
       "Every figure above was computed again from scratch for the build shown.",
       "Setiap angka di atas dihitung ulang dari awal untuk rancangan yang ditampilkan."},
      {"certificate.effort",
       "time: {} s reading, {} s solving, {} nodes, {} evaluations",
       "waktu: {} s membaca, {} s mencari, {} simpul, {} evaluasi"},

      {"sweep", "The best build at each value", "Rancangan terbaik pada tiap nilai"},
      {"sweep.speed", "Against the cycle time", "Terhadap waktu siklus"},
      {"sweep.hint",
       "Point at a mark for its figures. A cross: no compliant build exists there; an open circle: not proved.",
       "Tunjuk sebuah tanda untuk angkanya. Silang: tidak ada rancangan yang memenuhi syarat; lingkaran kosong: belum "
       "terbukti."},
      {"sweep.proof", "Proof", "Bukti"},
      {"sweep.proved", "proved", "terbukti"},
      {"sweep.open", "not proved", "belum terbukti"},

      {"audit.count", "{} printed results were recomputed.", "{} hasil cetak dihitung ulang."},
      {"audit.results", "Printed against recomputed", "Cetak dibandingkan hitung ulang"},
      {"audit.quantity", "Quantity", "Besaran"},
      {"audit.printed", "Printed", "Tercetak"},
      {"audit.computed", "Computed", "Dihitung"},
      {"audit.ratio", "Ratio", "Rasio"},
      {"audit.verdict", "Verdict", "Putusan"},
      {"audit.missing", "missing", "tidak ada"},
      {"audit.factor", "factor", "faktor"},
      {"audit.agrees", "within half a unit of the last printed digit", "dalam setengah satuan angka terakhir"},
      {"audit.rounding", "within 1 %", "dalam 1 %"},
      {"audit.unit", "a slip of units", "salah satuan"},
      {"audit.differs", "something else", "hal lain"},
      {"audit.missing-input", "an input is not printed", "masukan tidak tercetak"}};
  return texts;
}

}  // namespace millwright::report
