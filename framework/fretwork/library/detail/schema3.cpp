// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/text.hpp>
#include <fretwork/library/detail/schema.hpp>
#include <fretwork/library/detail/schema3.hpp>

#include <array>
#include <vector>

namespace fretwork::library::detail {
namespace {

constexpr std::array<const char*, 6> kParameters = {"A", "I2", "I3", "J", "theta", "R"};
constexpr const char* kKey = "pattern_id, model, optimizer, seed, starts, budget";

}  // namespace

std::string schema3_parameters(const std::string& database_name) {
    std::vector<std::string> selections;
    selections.reserve(kParameters.size());
    for (const std::string name : kParameters) {
        std::string& query = selections.emplace_back("SELECT ");
        query.append(kKey).append(", '").append(name).append("' AS name, ").append(name);
        query.append(" AS value FROM ")
            .append(database_name)
            .append(".calibration WHERE optimizer <> 'none'");
    }
    return base::join(selections, " UNION ALL ");
}

void view_schema3(Database& database) {
    // The view is in memory; the file stays as it is.
    database.execute("PRAGMA query_only = OFF");
    database.execute("CREATE TEMP VIEW calibration_parameter AS " + schema3_parameters("main"));
    database.execute("PRAGMA query_only = ON");
}

void migrate_schema3(Database& database) {
    Transaction transaction(database, Transaction::Kind::Write);
    if (schema_version(database) != 3) return;
    create_parameter_table(database);
    database.execute("INSERT INTO calibration_parameter " + schema3_parameters("main"));
    for (const std::string name : kParameters)
        database.execute("ALTER TABLE calibration DROP COLUMN " + name);
    set_schema_version(database);
    transaction.commit();
}

std::string schema3_calibrations() {
    std::vector<std::string> columns;
    columns.reserve(kParameters.size());
    for (const std::string name : kParameters) {
        columns.push_back(
            "coalesce((SELECT value FROM calibration_parameter AS p WHERE p.pattern_id = c.pattern_id AND "
            "p.model = c.model AND p.optimizer = c.optimizer AND p.seed = c.seed AND p.starts = c.starts AND "
            "p.budget = c.budget AND p.name = '" +
            name + "'), 0.0)");
    }
    return "SELECT " + std::string(kKey) + ", objective, evaluations, converged, " +
           base::join(columns, ", ") + ", at_bound FROM calibration AS c ORDER BY " + kKey;
}

}  // namespace fretwork::library::detail
