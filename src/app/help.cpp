// SPDX-License-Identifier: Apache-2.0
#include "app/help.h"

#include <utility>

namespace millwright::app {

namespace {

constexpr std::pair<std::string_view, std::string_view> help_texts[] = {
    {"millwright",
     "Exit codes:\n"
     "  0 done and compliant   1 no compliant design, or a check failed   2 bad input\n"
     "  3 a limit was reached before the proof was complete   70 a mistake of this program\n\n"
     "Environment:\n"
     "  MILLWRIGHT_CATALOGUES  folder of the shipped catalogues, if they are not where they were installed\n"
     "  NO_COLOR               set: no colours on a terminal\n\n"
     "Examples:\n"
     "  millwright new --template mill my-mill.toml\n"
     "  millwright solve problems/sander.toml\n"
     "  millwright check problems/sander.toml my-bom.csv\n"
     "  millwright calc power_screw.raising_torque force='6.4 kN' mean_diameter='30 mm' lead='8 mm' friction=0.08\n"
     "'millwright COMMAND --help' tells more about each command."},
    {"new",
     "The file says what every line means; optional keys are there behind a '#'. It solves as it is.\n"
     "Examples:\n"
     "  millwright new --template mill my-mill.toml\n"
     "  millwright new --template printer my-printer.toml --force"},
    {"solve",
     "Examples:\n"
     "  millwright solve problems/sander.toml --bom sander.csv\n"
     "  millwright solve problems/sander.toml --order sander.xlsx\n"
     "  millwright solve problems/sander.toml --catalogue my-shops --set spares.motor=1 --order order.csv\n"
     "  millwright solve problems/sander.toml --set 'axis.x.moves[0].time=12:36:7 s' --csv sweep.csv --report "
     "sweep.html\n"
     "  millwright solve problems/sander.toml --report sander.html\n"
     "  millwright solve problems/sander.toml --minimise mass --set axis.x.stroke='800 mm'\n"
     "  millwright solve problems/sander.toml --minimise 'cost + 25*mass'\n"
     "  millwright solve problems/sander.toml --catalogue my-parts --json -\n"
     "  millwright solve problems/lifter.toml --alternatives 5\n"
     "  millwright solve problems/lifter.toml --robust\n"
     "  millwright solve problems/sander.toml --write-lock sander.lock\n"
     "  millwright solve problems/sander.toml --locked sander.lock\n"
     "  millwright solve problems/sander.toml --limit mass='11.5 kg' --without A4988 --fix y.motor=17HS8401S\n"
     "  millwright solve problems/sander.toml --fix machine.supply_voltage='36 V' --fix x.acceleration_time='0.2 s'"},
    {"pareto",
     "Examples:\n"
     "  millwright pareto problems/sander.toml --minimise cost,mass --json front.json\n"
     "  millwright pareto problems/lifter.toml --minimise cost,energy\n"
     "  millwright pareto problems/sander.toml --report front.html\n"
     "  millwright pareto problems/lifter.toml --without BK10 --limit cost='200 USD'\n"
     "  millwright pareto problems/bar-feeder.toml --robust"},
    {"check",
     "Exit code 1 if a check fails. Printed is what fails, what is next to its limit, and the parts; --full prints "
     "the\n"
     "rest. A slot that the bill of materials leaves open is an error without --complete.\n"
     "Examples:\n"
     "  millwright check problems/sander.toml problems/sander-bom.csv\n"
     "  millwright check problems/sander.toml problems/sander-bom.csv --full\n"
     "  millwright check problems/sander.toml problems/sander-bom.csv --hold-origin paper\n"
     "  millwright check problems/lifter.toml problems/lifter-bom.csv --robust\n"
     "  millwright check problems/sander.toml problems/sander-bom.csv --report sander.html --language id\n"
     "  millwright check problems/sander.toml problems/sander-bom.csv --limit cost='450 USD'\n"
     "  millwright check problems/sander.toml problems/sander-bom.csv --order order.csv\n"
     "  millwright check problems/sander.toml problems/sander-bom.csv --write-lock bom.lock\n"
     "  millwright check problems/sander.toml problems/sander-bom.csv --locked bom.lock"},
    {"explain",
     "Nothing compliant (exit code 1): a smallest set of things that are asked and contradict each other, and by how\n"
     "much each of them must be eased. Else: what is forced, what the next best choice costs, what each requirement\n"
     "costs. The machine is solved some dozens of times; --time-limit counts for all of them together,\n"
     "and a question about a choice or a price gets 10 s at most.\n"
     "Examples:\n"
     "  millwright explain problems/lifter.toml\n"
     "  millwright explain problems/lifter.toml --set 'axis.z.moves[0].time=0.5 s'\n"
     "  millwright explain problems/lifter.toml --limit cost='150 USD' --without BK10"},
    {"compare",
     "A and B are results of solve or check, as --json writes them, or bills of materials. The figures of a result "
     "are\n"
     "shown as they were recorded; a bill of materials is evaluated now, with the problem of --problem or, without "
     "it,\n"
     "the one that the result names. Exit code 1 if a check of one of both fails.\n"
     "Examples:\n"
     "  millwright compare monday.json tuesday.json\n"
     "  millwright compare sander.json problems/sander-bom.csv\n"
     "  millwright compare mine.csv problems/sander-bom.csv --problem problems/sander.toml --complete"},
    {"audit",
     "Exit code 0 whatever the verdicts are: a wrong figure in a paper is a finding, not a failure.\n"
     "Examples:\n"
     "  millwright audit problems/papers/sander.toml --derive\n"
     "  millwright audit problems/papers/sander.toml --report audit.html"},
    {"calc",
     "Arguments are name=value with a unit, lists separated by commas, ends=fixed_free and the like by name.\n"
     "Examples:\n"
     "  millwright calc power_screw.raising_torque force='6.4 kN' mean_diameter='30 mm' lead='8 mm' friction=0.08\n"
     "  millwright calc power_screw.raising_torque force='1500 N' mean_diameter='14 mm' lead='4 mm' friction=0.155 "
     "--unit N.cm"},
    {"formulas",
     "Examples:\n"
     "  millwright formulas torque\n"
     "  millwright formulas --json formulas.json"},
    {"reference",
     "Examples:\n"
     "  millwright reference | less\n"
     "  millwright reference > problem-file.md"},
    {"schema",
     "Editors that know TOML complete and check a problem file whose first line names the schema:\n"
     "  #:schema ./millwright.schema.json\n"
     "Examples:\n"
     "  millwright schema > millwright.schema.json"},
    {"catalogue",
     "Examples:\n"
     "  millwright catalogue list steppers\n"
     "  millwright catalogue show 23HS22-2804S\n"
     "  millwright catalogue lint my-parts/steppers/motors.csv\n"
     "  millwright catalogue diff my-parts"},
    {"import",
     "Shows which column of the table is which of ours, in what unit, and how sure that is; asks; writes a catalogue "
     "file that lint\n"
     "has examined. Columns that are not ours are kept as x_NAME. Exit code 1 if it was not confirmed, 2 if something "
     "is wrong.\n"
     "Examples:\n"
     "  millwright catalogue import prices.csv --family steppers --constant manufacturer=ACT\n"
     "  millwright catalogue import prices.csv --family steppers --constant manufacturer=ACT --unit mass=kg \\\n"
     "    --output my-parts/steppers/act.csv --save-mapping act.toml --yes\n"
     "  millwright catalogue import prices-2027.csv --mapping act.toml --output my-parts/steppers/act.csv --force"},
    {"list",
     "Examples:\n"
     "  millwright catalogue list\n"
     "  millwright catalogue list ball_screws\n"
     "  millwright catalogue list --gaps"},
    {"show",
     "Examples:\n"
     "  millwright catalogue show 23HS22-2804S"},
    {"diff",
     "A and B are folders or single files. One alone is put on top of the shipped parts (and of --catalogue), as an\n"
     "overlay, and what it adds and changes is shown. Neither the order of rows nor the units of headers count.\n"
     "Exit code 0 if nothing differs, 1 if something does, 2 if a file cannot be read.\n"
     "Examples:\n"
     "  millwright catalogue diff parts-2025 parts-2026\n"
     "  millwright catalogue diff parts-2025/steppers/motors.csv parts-2026/steppers/motors.csv --json changes.json\n"
     "  millwright catalogue diff my-parts --family steppers"},
    {"lint",
     "Each row is judged by what usually holds between its figures. A finding says which figure is odd, by how much, "
     "what would explain it and how surely; the rules it rests on stand in brackets. A row that is right nevertheless "
     "says so in its column waiver: \"motor-mass: with brake\". stock.csv, suppliers.csv and offers.csv of a folder "
     "are read too: parts that nobody has, prices far from the catalogue's own, fees above all that is sold there.\n"
     "Exit code 2 if a file cannot be read or holds impossible rows; warnings alone leave it 0.\n"
     "Examples:\n"
     "  millwright catalogue lint my-parts\n"
     "  millwright catalogue lint motors.csv --family steppers"},
};

}  // namespace

std::string examples(std::string_view verb) {
  for (const auto& [name, text] : help_texts)
    if (name == verb) return std::string(text);
  return {};
}

}  // namespace millwright::app
