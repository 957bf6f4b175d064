using System.Globalization;

namespace Harvester.Benchmarks.Figures;

/// <summary>A figure on its line, "name value", as bench/run reads it.</summary>
internal static class FigureLine
{
    public static void Write(string name, double value) =>
        Console.WriteLine(string.Create(CultureInfo.InvariantCulture, $"{name} {value:R}"));
}
