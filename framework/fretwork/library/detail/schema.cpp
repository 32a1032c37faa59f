// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/library/detail/schema.hpp>

namespace fretwork::library::detail {
namespace {

constexpr const char* kSchema = R"sql(
CREATE TABLE layout(
    name TEXT NOT NULL PRIMARY KEY,
    json TEXT NOT NULL
) WITHOUT ROWID;

CREATE TABLE setting(
    id   INTEGER NOT NULL PRIMARY KEY CHECK (id = 1),
    json TEXT NOT NULL
);

CREATE TABLE scenario(
    name          TEXT NOT NULL PRIMARY KEY,
    position      INTEGER NOT NULL,
    weight        REAL NOT NULL,
    max_magnitude REAL NOT NULL,
    description   TEXT NOT NULL
) WITHOUT ROWID;

CREATE TABLE pattern(
    id     TEXT NOT NULL PRIMARY KEY,
    layout TEXT NOT NULL REFERENCES layout(name),
    edges  INTEGER NOT NULL,
    mirror TEXT
) WITHOUT ROWID;

CREATE TABLE response_state(
    pattern_id TEXT NOT NULL REFERENCES pattern(id),
    scenario   TEXT NOT NULL REFERENCES scenario(name),
    step       INTEGER NOT NULL,
    magnitude  REAL NOT NULL,
    converged  INTEGER NOT NULL CHECK (converged IN (0, 1)),
    stable     INTEGER NOT NULL CHECK (stable IN (0, 1)),
    limit_load INTEGER NOT NULL CHECK (limit_load IN (0, 1)),
    discretization_error REAL,
    PRIMARY KEY (pattern_id, scenario, step)
) WITHOUT ROWID;

CREATE TABLE response(
    pattern_id TEXT NOT NULL,
    scenario   TEXT NOT NULL,
    step       INTEGER NOT NULL,
    node       INTEGER NOT NULL,
    ux REAL NOT NULL, uy REAL NOT NULL, uz REAL NOT NULL,
    rx REAL NOT NULL, ry REAL NOT NULL, rz REAL NOT NULL,
    PRIMARY KEY (pattern_id, scenario, step, node),
    FOREIGN KEY (pattern_id, scenario, step) REFERENCES response_state(pattern_id, scenario, step)
) WITHOUT ROWID;

CREATE TABLE calibration(
    pattern_id  TEXT NOT NULL REFERENCES pattern(id),
    model       TEXT NOT NULL,
    optimizer   TEXT NOT NULL,
    seed        INTEGER NOT NULL,
    starts      INTEGER NOT NULL,
    budget      INTEGER NOT NULL,
    objective   REAL NOT NULL,
    evaluations INTEGER NOT NULL,
    converged   INTEGER NOT NULL CHECK (converged IN (0, 1)),
    at_bound    TEXT NOT NULL,
    seconds     REAL NOT NULL,
    PRIMARY KEY (pattern_id, model, optimizer, seed, starts, budget)
) WITHOUT ROWID;

CREATE TABLE calibration_error(
    pattern_id TEXT NOT NULL,
    model      TEXT NOT NULL,
    optimizer  TEXT NOT NULL,
    seed       INTEGER NOT NULL,
    starts     INTEGER NOT NULL,
    budget     INTEGER NOT NULL,
    scenario   TEXT NOT NULL REFERENCES scenario(name),
    error      REAL NOT NULL,
    PRIMARY KEY (pattern_id, model, optimizer, seed, starts, budget, scenario),
    FOREIGN KEY (pattern_id, model, optimizer, seed, starts, budget)
        REFERENCES calibration(pattern_id, model, optimizer, seed, starts, budget)
) WITHOUT ROWID;

CREATE TABLE property(
    pattern_id TEXT NOT NULL REFERENCES pattern(id),
    name       TEXT NOT NULL,
    value      REAL NOT NULL,
    PRIMARY KEY (pattern_id, name)
) WITHOUT ROWID;

CREATE TABLE failure(
    pattern_id TEXT NOT NULL REFERENCES pattern(id),
    stage      TEXT NOT NULL,
    reason     TEXT NOT NULL,
    PRIMARY KEY (pattern_id, stage)
) WITHOUT ROWID;

CREATE TABLE provenance(
    session INTEGER NOT NULL,
    name    TEXT NOT NULL,
    value   TEXT NOT NULL,
    PRIMARY KEY (session, name)
) WITHOUT ROWID;
)sql";

constexpr const char* kBehaviour = R"sql(
SELECT p.id AS pattern_id, p.mirror,
       max(CASE WHEN name = 'mass_per_area' THEN value END) AS mass_per_area,
       max(CASE WHEN name = 'membrane_stiffness' THEN value END) AS membrane_stiffness,
       max(CASE WHEN name = 'membrane_shear' THEN value END) AS membrane_shear,
       max(CASE WHEN name = 'membrane_poisson' THEN value END) AS membrane_poisson,
       max(CASE WHEN name = 'membrane_anisotropy' THEN value END) AS membrane_anisotropy,
       max(CASE WHEN name = 'bending_stiffness' THEN value END) AS bending_stiffness,
       max(CASE WHEN name = 'bending_shear' THEN value END) AS bending_shear,
       max(CASE WHEN name = 'bending_poisson' THEN value END) AS bending_poisson,
       max(CASE WHEN name = 'bending_anisotropy' THEN value END) AS bending_anisotropy
FROM pattern AS p JOIN property ON property.pattern_id = p.id GROUP BY p.id)sql";

constexpr const char* kParameterTable = R"sql(
CREATE TABLE calibration_parameter(
    pattern_id TEXT NOT NULL,
    model      TEXT NOT NULL,
    optimizer  TEXT NOT NULL,
    seed       INTEGER NOT NULL,
    starts     INTEGER NOT NULL,
    budget     INTEGER NOT NULL,
    name       TEXT NOT NULL,
    value      REAL NOT NULL,
    PRIMARY KEY (pattern_id, model, optimizer, seed, starts, budget, name),
    FOREIGN KEY (pattern_id, model, optimizer, seed, starts, budget)
        REFERENCES calibration(pattern_id, model, optimizer, seed, starts, budget)
) WITHOUT ROWID;
)sql";

/// Check that the name of one of a library's tables belongs to an ordinary table in the file. If the file
/// has no such name, the first query reports the missing table.
void require_ordinary_table(const Database& database, std::string_view name) {
    Statement entry(database,
                    "SELECT type, sql LIKE 'CREATE VIRTUAL%' FROM sqlite_master WHERE lower(name) = ?");
    if (!entry.bind_all(name).step()) return;
    const std::string kind = entry.integer(1) != 0 ? "virtual table" : std::string(entry.text(0));
    if (kind != "table")
        throw base::InputError(database.path().string(), std::string(name),
                               "is a " + kind + ", where a pattern library has a table of its own");
    Statement computed(database, "SELECT name FROM pragma_table_xinfo(?) WHERE hidden > 1");
    if (computed.bind_all(name).step())
        throw base::InputError(database.path().string(), std::string(name),
                               "has a computed column, '" + base::printable(computed.text(0)) +
                                   "', where a pattern library has values");
}

std::int64_t header_field(const Database& database, const std::string& name) {
    return query_integer(database, "PRAGMA " + name).value_or(0);
}

void set_header_field(Database& database, const std::string& name, std::int64_t value) {
    database.execute("PRAGMA " + name + " = " + std::to_string(value));
}

}  // namespace

std::span<const Table> content_tables() {
    using Columns = std::vector<std::string_view>;
    static const Columns calibration_key = {"pattern_id", "model", "optimizer", "seed", "starts", "budget"};
    static const Columns calibration_error_key = {"pattern_id", "model",  "optimizer", "seed",
                                                  "starts",     "budget", "scenario"};
    static const Columns parameter_key = {"pattern_id", "model",  "optimizer", "seed",
                                          "starts",     "budget", "name"};
    static const std::vector<Table> tables = {
        {"layout", {"name"}, {"json"}, {}},
        {"setting", {"id"}, {"json"}, {}},
        {"scenario", {"name"}, {"position", "weight", "max_magnitude", "description"}, {}},
        {"pattern", {"id"}, {"layout", "edges", "mirror"}, {}},
        {"response_state",
         {"pattern_id", "scenario", "step"},
         {"magnitude", "converged", "stable", "limit_load", "discretization_error"},
         {}},
        {"response", {"pattern_id", "scenario", "step", "node"}, {"ux", "uy", "uz", "rx", "ry", "rz"}, {}},
        {"calibration", calibration_key, {"objective", "evaluations", "converged", "at_bound"}, {"seconds"}},
        {"calibration_parameter", parameter_key, {"value"}, {}},
        {"calibration_error", calibration_error_key, {"error"}, {}},
        {"property", {"pattern_id", "name"}, {"value"}, {}},
        {"failure", {"pattern_id", "stage"}, {"reason"}, {}},
    };
    return tables;
}

std::string behaviour_query() {
    return kBehaviour;
}

std::string content_columns(const Table& table) {
    std::vector<std::string> columns(table.keys.begin(), table.keys.end());
    columns.insert(columns.end(), table.values.begin(), table.values.end());
    return base::join(columns, ", ");
}

void create_schema(Database& database) {
    database.execute(kSchema);
    database.execute(std::string("CREATE VIEW behaviour AS") + kBehaviour);
    create_parameter_table(database);
    set_header_field(database, "application_id", kApplicationId);
    set_schema_version(database);
}

void create_parameter_table(Database& database) {
    database.execute(kParameterTable);
}

std::int64_t schema_version(const Database& database, const std::string& database_name) {
    return header_field(database, database_name + ".user_version");
}

void set_schema_version(Database& database) {
    set_header_field(database, "user_version", kSchemaVersion);
}

bool is_empty(const Database& database) {
    return header_field(database, "application_id") == 0 &&
           query_integer(database, "SELECT count(*) FROM sqlite_master") == 0;
}

void check_schema(const Database& database) {
    const std::string file = database.path().string();
    if (header_field(database, "application_id") != kApplicationId)
        throw base::InputError(file, "", "is not a pattern library");
    for (const Table& table : content_tables()) require_ordinary_table(database, table.name);
    require_ordinary_table(database, "provenance");
    const std::int64_t version = schema_version(database);
    if (version == kSchemaVersion || version == kOldestSchemaVersion) return;
    const std::string what = "is a library of schema version " + std::to_string(version);
    if (version > kSchemaVersion)
        throw base::InputError(file, "",
                               what + ", where this program knows versions up to " +
                                   std::to_string(kSchemaVersion) + ": use a newer program");
    throw base::InputError(file, "",
                           what + ", where this program reads versions from " +
                               std::to_string(kOldestSchemaVersion) +
                               " on: enumerate its patterns into a new library and calibrate them");
}

}  // namespace fretwork::library::detail
