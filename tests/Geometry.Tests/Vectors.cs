using System.Globalization;

namespace Harvester.Geometry.Tests;

/// <summary>Reads golden vectors: a CSV file beside the tests, one case a line, named by its first column.</summary>
internal static class Vectors
{
    public static IEnumerable<IReadOnlyDictionary<string, string>> Read(string path)
    {
        string[] lines = File.ReadAllLines(Path.Combine(AppContext.BaseDirectory, path));
        string[] names = lines[0].Split(',');

        // The last column, the source, is free text.
        return lines
            .Skip(1)
            .Select(line => line.Split(',', names.Length))
            .Select(cells => names.Zip(cells).ToDictionary(pair => pair.First, pair => pair.Second));
    }

    public static double Number(this IReadOnlyDictionary<string, string> row, string name) =>
        double.Parse(row[name], CultureInfo.InvariantCulture);

    public static Vector3D Vector(this IReadOnlyDictionary<string, string> row, string prefix) =>
        new(row.Number(prefix + "X"), row.Number(prefix + "Y"), row.Number(prefix + "Z"));
}
