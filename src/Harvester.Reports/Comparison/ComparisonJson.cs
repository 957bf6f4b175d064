using System.Text.Json;
using Harvester.Sessions.Reading.Json;

namespace Harvester.Reports.Comparison;

/// <summary>Writes a comparison as JSON; docs/compare.md describes it.</summary>
public static class ComparisonJson
{
    private const int Decimals = 6;

    /// <summary>Quantiles of each quantity, as fractions.</summary>
    private static readonly double[] Quantiles = [0.05, 0.25, 0.5, 0.75, 0.95];

    /// <summary>Writes one object and a line feed.</summary>
    public static void Write(Stream stream, DatasetComparison comparison)
    {
        string text = JsonLine.Of(json =>
        {
            json.WriteStartObject();
            json.WriteString("first", comparison.First.Name);
            json.WriteString("second", comparison.Second.Name);
            json.Numbers("frames", [comparison.First.Frames, comparison.Second.Frames], 0);
            json.Numbers("labels", [comparison.First.Labels, comparison.Second.Labels], 0);
            json.WriteStartObject("quantities");
            foreach (ComparedQuantity quantity in ComparedQuantity.All)
            {
                WriteQuantity(json, comparison, quantity);
            }

            json.WriteEndObject();
            WriteCounts(json, "classes", comparison.First.Classes, comparison.Second.Classes);
            WriteCounts(json, "levels", comparison.First.Levels, comparison.Second.Levels);
            json.WriteEndObject();
        });
        using var writer = new StreamWriter(stream, leaveOpen: true) { NewLine = "\n" };
        writer.WriteLine(text);
    }

    private static void WriteQuantity(Utf8JsonWriter json, DatasetComparison comparison, ComparedQuantity quantity)
    {
        ValueSketch first = comparison.First.Of(quantity);
        ValueSketch second = comparison.Second.Of(quantity);
        double[] edges = quantity.Edges(first, second);
        json.WriteStartObject(quantity.Key);
        json.WriteString("unit", quantity.Unit);
        json.Number("wasserstein", comparison.WassersteinOf(quantity), Decimals);
        json.Number("jensenShannon", comparison.JensenShannonOf(quantity), Decimals);
        json.Numbers("edges", edges, Decimals);
        foreach ((string name, ValueSketch values) in new[] { ("first", first), ("second", second) })
        {
            json.WriteStartObject(name);
            json.WriteNumber("count", values.Count);
            json.Number("mean", values.Mean, Decimals);
            json.WriteStartArray("quantiles");
            foreach (double fraction in values.Count == 0 ? [] : Quantiles)
            {
                json.Value(values.Quantile(fraction)!.Value, Decimals);
            }

            json.WriteEndArray();
            json.Numbers("fractions", values.Count == 0 ? [] : values.Fractions(edges), Decimals);
            json.WriteEndObject();
        }

        json.WriteEndObject();
    }

    private static void WriteCounts(Utf8JsonWriter json, string name, CategoryCounts first, CategoryCounts second)
    {
        json.WriteStartObject(name);
        (double TotalVariation, double JensenShannon)? distance = DatasetComparison.Between(first, second);
        json.Number("totalVariation", distance?.TotalVariation, Decimals);
        json.Number("jensenShannon", distance?.JensenShannon, Decimals);
        json.WriteStartObject("counts");
        foreach ((string kind, _, _) in DatasetComparison.FractionsOf(first, second))
        {
            json.Numbers(kind, [first.Of(kind), second.Of(kind)], 0);
        }

        json.WriteEndObject();
        json.WriteEndObject();
    }
}
