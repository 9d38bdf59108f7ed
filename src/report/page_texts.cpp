// SPDX-License-Identifier: Apache-2.0
#include "report/page_texts.h"

#include "report/page_texts_certificate.h"
#include "report/page_texts_sweep_audit.h"

namespace millwright::report {

namespace {

std::vector<PageText> report_texts() {
  std::vector<PageText> all{
      {"kind.solve", "Design and calculation", "Rancangan dan perhitungan"},
      {"kind.check", "Check of a bill of materials", "Pemeriksaan daftar komponen"},
      {"kind.pareto", "Front of builds", "Garis depan Pareto"},
      {"kind.sweep", "One value over a range", "Satu nilai sepanjang rentang"},
      {"kind.audit", "Audit of a published calculation", "Audit perhitungan terbitan"},
      {"footer",
       "Made by Millwright {}. Values are computed in SI and shown with four significant digits; the complete result "
       "for programs is inside this page.",
       "Dibuat dengan Millwright {}. Nilai dihitung dalam SI dan ditampilkan dengan empat angka penting; hasil lengkap "
       "untuk program ada di dalam halaman ini."},

      {"footer.prices", "Prices are of {}.", "Harga dari {}."},
      {"footer.page", "page", "halaman"},

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
       "Compliant; the best build found before the search was ended, not proved to be the best.",
       "Memenuhi syarat; terbaik yang ditemukan sebelum pencarian dihentikan, belum terbukti terbaik."},
      {"banner.satisfied", "It satisfies every check.", "Semua pemeriksaan terpenuhi."},
      {"banner.failed", "It fails {} of {} checks.", "Gagal pada {} dari {} pemeriksaan."},
      {"banner.completion_ended",
       "What the bill leaves open was chosen so that the build complies; the search was ended before it was proved to "
       "be the best.",
       "Yang belum ditentukan dipilih agar rancangan memenuhi syarat; pencarian dihentikan sebelum terbukti terbaik."},
      {"banner.completion_refuted",
       "Nothing complies with what the bill holds (proved); the rest are the cheapest parts that fit.",
       "Tidak ada rancangan yang memenuhi syarat dengan isi daftar ini (terbukti); sisanya komponen termurah yang "
       "cocok."},
      {"banner.completion_open",
       "The search was ended before it was known whether anything complies with what the bill holds.",
       "Pencarian dihentikan sebelum diketahui apakah ada yang memenuhi syarat dengan isi daftar ini."},
      {"banner.none", "No compliant build exists.", "Tidak ada rancangan yang memenuhi syarat."},
      {"banner.limit_none",
       "The search was ended before a compliant build was found.",
       "Pencarian dihentikan sebelum rancangan yang memenuhi syarat ditemukan."},
      {"banner.front", "{} builds that no other build beats.", "{} rancangan yang tidak terkalahkan."},
      {"banner.front_open",
       "{} builds found before the search was ended; points may be missing.",
       "{} rancangan ditemukan sebelum pencarian dihentikan; mungkin belum lengkap."},
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
      {"parts.preferred", "preferred", "pilihan"},
      {"parts.length", "Length", "Panjang"},
      {"parts.spare", "spare", "cadangan"},
      {"parts.bars", "Cut from whole bars", "Dipotong dari batang utuh"},
      {"parts.bar", "Bar", "Batang"},
      {"parts.pieces", "Pieces", "Potongan"},
      {"parts.left_over", "Left over", "Sisa"},
      {"parts.shipping", "Shipping", "Ongkos kirim"},
      {"parts.top_up", "Filling up to the minimum order", "Penggenapan ke pesanan minimum"},
      {"parts.supplier", "Supplier", "Pemasok"},
      {"parts.no_supplier", "not stated", "tidak disebut"},
      {"parts.paper_only",
       "known only from a paper, from no maker: verify before ordering",
       "hanya dikenal dari sebuah makalah, bukan dari pembuat: periksa sebelum memesan"},
      {"parts.confidence", "Confidence", "Keyakinan"},
      {"parts.notes", "Notes", "Catatan"},
      {"parts.price_basis", "price", "harga"},
      {"parts.source", "figures", "data"},
      {"slot.screw", "screw", "ulir"},
      {"slot.nut", "nut", "mur"},
      {"slot.motor", "motor", "motor"},
      {"slot.driver", "driver", "driver motor"},
      {"slot.coupling", "coupling", "kopling"},
      {"slot.support_fixed", "support_fixed", "tumpuan tetap"},
      {"slot.support_free", "support_free", "tumpuan bebas"},
      {"slot.guide", "guide", "pemandu"},
      {"slot.belt", "belt", "sabuk"},
      {"slot.pulley_drive", "pulley_drive", "puli penggerak"},
      {"slot.pulley_idle", "pulley_idle", "puli bebas"},
      {"slot.reduction", "reduction", "reduksi"},
      {"slot.rack", "rack", "batang gigi"},
      {"slot.pinion", "pinion", "pinion"},
      {"slot.supply", "supply", "catu daya"},
      {"slot.drive", "drive", "penggerak"},
      {"parts.made", "Members made to measure, by their mass", "Bagian yang dibuat khusus, menurut massa"},
      {"parts.total", "Total", "Jumlah"},
      {"parts.estimate",
       "~ the price, or a figure of the part that matters, is an estimate",
       "~ harga, atau data komponen yang penting, adalah perkiraan"},
      {"settings", "Dimensions and settings", "Ukuran dan pengaturan"},
      {"settings.name", "Name", "Nama"},
      {"alternatives", "Alternatives", "Alternatif"},
      {"tolerances", "Tolerances", "Toleransi"},
      {"tolerances.figure", "{} figure", "{} data"},
      {"tolerances.figures", "{} figures", "{} data"},
      {"tolerances.comes_to", "comes to {} % of its limit", "mencapai {} % dari batasnya"},
      {"tolerances.fails", "fails", "gagal"},
      {"tolerances.estimate", ", an estimate", ", perkiraan"},
      {"tolerances.single",
       "{} ({}) {}{}: compliant up to about {} ({}); at {} {}",
       "{} ({}) {}{}: memenuhi syarat sampai sekitar {} ({}); pada {} {}"},
      {"tolerances.together", "together {}: {}", "bersama-sama {}: {}"},
      {"tolerances.good", "Compliant", "Memenuhi syarat"},
      {"tolerances.bad", "Not compliant", "Tidak memenuhi syarat"},
      {"tolerances.none",
       "No figure of the chosen parts states a tolerance: with --robust this is no stronger than without.",
       "Tidak ada data komponen terpilih yang menyebut toleransi: dengan --robust hasil ini tidak lebih kuat daripada "
       "tanpanya."},
      {"tolerances.compliant",
       "{} for every value within the stated tolerances of {}, proved with intervals.",
       "{} untuk setiap nilai dalam toleransi yang disebut dari {}, terbukti dengan selang."},
      {"tolerances.broken_together",
       "{} for every value within the stated tolerances of {}; no single one breaks it.",
       "{} untuk setiap nilai dalam toleransi yang disebut dari {}; tidak ada satu pun yang sendirian "
       "menggagalkannya."},
      {"tolerances.broken",
       "{} for every value within the stated tolerances: {} of {} can break it alone.",
       "{} untuk setiap nilai dalam toleransi yang disebut: {} dari {} dapat menggagalkannya sendirian."},
      {"tolerances.unsettled",
       "Not settled whether it is compliant for every value within the stated tolerances of {}: neither proved nor "
       "refuted in {} pieces.",
       "Belum pasti apakah memenuhi syarat untuk setiap nilai dalam toleransi yang disebut dari {}: tidak terbukti dan "
       "tidak terbantah dalam {} bagian."},
      {"tolerances.not_asked",
       "Not asked: it fails with the figures as they stand.",
       "Tidak diperiksa: gagal dengan data apa adanya."},
      {"tolerances.unstated_one",
       "No tolerance is stated for {} that is estimated: taken as it stands.",
       "Tidak ada toleransi disebut untuk {} yang diperkirakan: dipakai apa adanya."},
      {"tolerances.unstated",
       "No tolerance is stated for {} that are estimated: taken as they stand.",
       "Tidak ada toleransi disebut untuk {} yang diperkirakan: dipakai apa adanya."},
      {"tolerances.robust",
       "No build that is compliant for every value within the stated tolerances is better",
       "Tidak ada rancangan yang lebih baik yang memenuhi syarat untuk setiap nilai dalam toleransi yang disebut"},
      {"tolerances.robust_open",
       "Whether a better build is compliant for every value within the stated tolerances is open",
       "Apakah ada rancangan lebih baik yang memenuhi syarat untuk setiap nilai dalam toleransi belum pasti"},
      {"tolerances.robust_same",
       "with the figures as they stand none is better either",
       "dengan data apa adanya pun tidak ada yang lebih baik"},
      {"tolerances.robust_costs",
       "with the figures as they stand the best is {} better",
       "dengan data apa adanya yang terbaik {} lebih baik"},
      {"tolerances.scenario",
       "{} set of values was asked of every part on the way; ramps, dimensions and settings are the same for all "
       "values.",
       "{} himpunan nilai dituntut dari setiap komponen; ramp, ukuran, dan pengaturan sama untuk semua nilai."},
      {"tolerances.scenarios",
       "{} sets of values were asked of every part on the way; ramps, dimensions and settings are the same for all "
       "values.",
       "{} himpunan nilai dituntut dari setiap komponen; ramp, ukuran, dan pengaturan sama untuk semua nilai."},
      {"tolerances.front",
       "Every build of it is compliant for every value within the stated tolerances.",
       "Setiap rancangan di sini memenuhi syarat untuk setiap nilai dalam toleransi yang disebut."},
      {"tolerances.front_open",
       "Of {} of these builds it is not settled whether they are compliant for every value within the tolerances.",
       "Untuk {} rancangan di sini belum pasti apakah memenuhi syarat untuk setiap nilai dalam toleransi."},
      {"tolerances.front_none",
       "No figure of the parts of these builds states a tolerance: --robust asks no more than without it.",
       "Tidak ada data komponen rancangan ini yang menyebut toleransi: --robust tidak menuntut lebih."},

      {"sheet", "Calculation sheet", "Lembar perhitungan"},
      {"sheet.element", "Calculation: {}", "Perhitungan: {}"},
      {"sheet.given", "Given", "Diketahui"},
      {"sheet.shared", "Used by several checks", "Dipakai beberapa pemeriksaan"},
      {"sheet.checks", "Checks", "Pemeriksaan"},
      {"sheet.derived", "Where other figures come from", "Asal besaran lain"},
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
       "mass. It is taken as a spring: a counterweight would move with the axis and add its mass to what is "
       "accelerated.",
       "{}: penyeimbang {} N (counterbalance_force) diandaikan ada; tidak termasuk komponen, harga, dan massa. Ia "
       "dianggap pegas: bobot imbang akan ikut bergerak dan menambah massa yang dipercepat."},
      {"assume.cycle",
       "Cycle time: every move of every axis, and its dwell, one after the other; coordinated moves once, there and "
       "back "
       "where one of their axes climbs.",
       "Waktu siklus: setiap gerak tiap sumbu beserta jedanya, satu per satu; gerak terkoordinasi sekali, pergi dan "
       "kembali bila salah satu sumbunya menanjak."},
      {"assume.energy",
       "Energy is an estimate, of the drives' input while their own axis goes through its cycle: copper losses at full "
       "current, usual iron losses, driver efficiency 0.9; nothing is fed back.",
       "Energi adalah perkiraan masukan penggerak selama siklus sumbunya: rugi tembaga pada arus penuh, rugi besi yang "
       "lazim, efisiensi driver 0,9; tidak ada yang dikembalikan."},
      {"assume.prices", "Prices", "Harga"},
      {"assume.torque", "torque at speed, by the model of the winding", "torsi pada putaran, menurut model lilitan"},
      {"assume.estimates", "Estimated inputs", "Masukan perkiraan"},
      {"certificate", "Certificate", "Sertifikat"},
      {"catalogues", "Catalogues", "Katalog"},
      {"catalogues.about",
       "What this result rests on. Of a catalogue, the SHA-256 of the list that sha256sum prints of its files, "
       "ascending by name; then that of each file from which a part above comes.",
       "Dasar hasil ini. Untuk katalog: SHA-256 dari daftar yang dicetak sha256sum untuk berkas-berkasnya, urut nama; "
       "lalu SHA-256 tiap berkas asal komponen di atas."},
      {"catalogues.place", "Catalogue", "Katalog"},
      {"catalogues.file", "File", "Berkas"},
      {"catalogues.files", "Files", "Berkas"},
      {"catalogues.rows", "Rows", "Baris"}};
  return all;
}

}  // namespace

const std::vector<PageText>& page_texts() {
  static const std::vector<PageText> texts = [] {
    std::vector<PageText> all = report_texts();
    for (const std::vector<PageText>& more : {certificate_texts(), sweep_and_audit_texts()})
      all.insert(all.end(), more.begin(), more.end());
    return all;
  }();
  return texts;
}

}  // namespace millwright::report
