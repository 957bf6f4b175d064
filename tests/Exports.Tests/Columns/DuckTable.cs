using DuckDB.NET.Data;

namespace Harvester.Exports.Tests.Columns;

/// <summary>Reads Parquet with DuckDB, which shares no code with what writes it.</summary>
internal static class DuckTable
{
    /// <summary>The rows of a query, in order; an unknown value is null.</summary>
    /// <param name="sql">The query.</param>
    /// <param name="folder">The folder from which it reads tables.</param>
    public static List<Dictionary<string, object?>> Query(string sql, string folder)
    {
        using var connection = new DuckDBConnection("DataSource=:memory:");
        connection.Open();
        using DuckDBCommand command = connection.CreateCommand();
        command.CommandText = $"SET file_search_path = '{folder.Replace("'", "''", StringComparison.Ordinal)}'";
        command.ExecuteNonQuery();
        command.CommandText = sql;
        using DuckDBDataReader reader = command.ExecuteReader();
        var rows = new List<Dictionary<string, object?>>();
        while (reader.Read())
        {
            rows.Add(
                Enumerable.Range(0, reader.FieldCount).ToDictionary(reader.GetName, i => reader.IsDBNull(i) ? null : reader.GetValue(i))
            );
        }

        return rows;
    }
}
