// SPDX-License-Identifier: Apache-2.0
#include "report/page_texts_sweep_audit.h"

namespace millwright::report {

std::vector<PageText> sweep_and_audit_texts() {
  return {
      {"sweep", "The best build at each value", "Rancangan terbaik pada tiap nilai"},
      {"sweep.speed", "Against the cycle time", "Terhadap waktu siklus"},
      {"sweep.hint",
       "Point at a mark for its figures. A cross: no compliant build exists there; an open circle: not proved. Between "
       "the marks nothing was solved; the table says which parts change from one to the next.",
       "Tunjuk sebuah tanda untuk angkanya. Silang: tidak ada rancangan yang memenuhi syarat; lingkaran kosong: belum "
       "terbukti. Di antara tanda tidak ada yang dihitung; tabel menyebut komponen yang berubah dari satu ke "
       "berikutnya."},
      {"sweep.preferred",
       "Compared with the prices of preferred parts divided by 1 + preference; the prices shown are the real ones.",
       "Dibandingkan dengan harga komponen pilihan dibagi 1 + preference; harga yang ditampilkan adalah harga "
       "sebenarnya."},
      {"sweep.proof", "Proof", "Bukti"},
      {"sweep.proved", "proved", "terbukti"},
      {"sweep.open", "not proved", "belum terbukti"},

      {"front.hint_open",
       "Every point is a compliant build; the search was ended, so others may beat it. Point at one for what it "
       "changes; click for its sheet.",
       "Setiap titik adalah rancangan yang memenuhi syarat; pencarian dihentikan, jadi mungkin ada yang "
       "mengunggulinya. Tunjuk untuk melihat perubahannya; klik untuk lembarnya."},
      {"banner.within",
       "The proof is to {} %: another build may be better by that much.",
       "Buktinya sampai {} %: rancangan lain mungkin lebih baik sebanyak itu."},
      {"certificate.within", "{}, by more than {} %", "{}, dengan selisih lebih dari {} %"},
      {"tolerances.robust_less",
       "with the figures as they stand the best is {} worse at real prices, which is not how builds were compared",
       "dengan data apa adanya yang terbaik {} lebih buruk menurut harga sebenarnya, bukan cara pembandingannya"},
      {"tolerances.stopped",
       "Not settled before the search was ended whether it is compliant for every value within the stated tolerances "
       "of {}.",
       "Belum pasti sebelum pencarian dihentikan apakah memenuhi syarat untuk setiap nilai dalam toleransi yang "
       "disebut dari {}."},
      {"tolerances.front_stopped",
       "Of these builds it was not settled before the search was ended: {}.",
       "Untuk rancangan ini belum dipastikan sebelum pencarian dihentikan: {}."},

      {"audit.count", "{} printed results were recomputed.", "{} hasil cetak dihitung ulang."},
      {"audit.results", "Printed against recomputed", "Cetak dibandingkan hitung ulang"},
      {"audit.quantity", "Quantity", "Besaran"},
      {"audit.printed", "Printed", "Tercetak"},
      {"audit.computed", "Computed", "Dihitung"},
      {"parts.converted", "Prices were converted at", "Harga dikonversi dengan kurs"},
      {"parts.no_date", "date not stated", "tanggal tidak disebut"},
      {"audit.ratio", "Ratio", "Rasio"},
      {"audit.verdict", "Verdict", "Putusan"},
      {"audit.missing", "missing", "tidak ada"},
      {"audit.factor", "factor", "faktor"},
      {"audit.agrees", "within half a unit of the last printed digit", "dalam setengah satuan angka terakhir"},
      {"audit.rounding", "within 1 %", "dalam 1 %"},
      {"audit.unit", "a slip of units", "salah satuan"},
      {"audit.differs", "something else", "hal lain"},
      {"audit.missing-input", "an input is not printed", "masukan tidak tercetak"}};
}

}  // namespace millwright::report
