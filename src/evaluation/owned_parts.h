// SPDX-License-Identifier: Apache-2.0
//
// Parts of which the user owns some pieces: those cost nothing, and more of them cost their price. How many of them a
// machine takes is known only when all its stages are decided, so every stage hands on how many were taken so far, and
// the last one charges what goes beyond those that are there:
//
//   stage: price 0, count += pieces     ...     last stage: cost += price * max(0, count - owned)
#pragma once

#include <span>
#include <vector>

#include "catalogue/catalogue.h"
#include "evaluation/price_book.h"
#include "evaluation/slot_table.h"

namespace millwright::evaluation {

struct OwnedPart {
  catalogue::Family family{};
  int row = 0;            ///< in the catalogue's table
  double pieces = 0.0;    ///< that are there
  double price = 0.0;     ///< of each further one, in the problem's currency
  std::size_t state = 0;  ///< where the state vector counts them
};

/// How many pieces of an owned part the rows of a slot take.
struct PieceCount {
  std::size_t slot = 0;
  std::size_t state = 0;
  std::vector<double> of_row;  ///< [row of the slot's table]
};

/// What so many pieces of a part cost.
template <class T>
T charge(const OwnedPart& part, const T& taken) {
  using namespace scalar;
  return T(part.price) * larger(T(0.0), taken - T(part.pieces));
}

/// Finds the owned parts among the candidates of all stages.
class OwnedParts {
 public:
  /// The state vector counts them from `first_state` on.
  OwnedParts(const catalogue::Catalogue& catalogue, const PriceBook& prices, std::size_t first_state)
      : catalogue_(catalogue), prices_(prices), first_state_(first_state) {}

  /// What the slots of one stage take, by slot.
  std::vector<PieceCount> counts(std::span<const SlotTable> tables);
  /// Those found so far.
  [[nodiscard]] const std::vector<OwnedPart>& parts() const { return parts_; }

 private:
  const OwnedPart* find_or_add(const PartUse& use);

  const catalogue::Catalogue& catalogue_;
  const PriceBook& prices_;
  std::size_t first_state_;
  std::vector<OwnedPart> parts_;
};

/// Goes through the parts of a build and says what each is charged.
class OwnedPartsLedger {
 public:
  explicit OwnedPartsLedger(std::span<const OwnedPart> parts) : parts_(parts), taken_(parts.size(), 0.0) {}

  struct Share {
    double owned = 0.0;    ///< pieces of it that are there
    double charged = 0.0;  ///< for the others, in the problem's currency
  };
  Share take(const PartUse& use);

 private:
  std::span<const OwnedPart> parts_;
  std::vector<double> taken_;
};

}  // namespace millwright::evaluation
