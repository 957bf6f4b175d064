namespace Harvester.Reports.Comparison;

/// <summary>Two datasets side by side.</summary>
/// <param name="First">The first.</param>
/// <param name="Second">The second.</param>
public sealed record DatasetComparison(DatasetProfile First, DatasetProfile Second)
{
    /// <summary>The 1-Wasserstein distance of a quantity, in its unit; null if one of the datasets lacks it.</summary>
    public double? WassersteinOf(ComparedQuantity quantity) => quantity.Between(First.Of(quantity), Second.Of(quantity));

    /// <summary>The Jensen-Shannon divergence of a quantity's histograms, bits; null if one of the datasets lacks it.</summary>
    public double? JensenShannonOf(ComparedQuantity quantity)
    {
        (ValueSketch first, ValueSketch second) = (First.Of(quantity), Second.Of(quantity));
        double[] edges = quantity.Edges(first, second);
        return first.Count == 0 || second.Count == 0
            ? null
            : DistributionDistance.JensenShannon(first.Fractions(edges), second.Fractions(edges));
    }

    /// <summary>The names of both, in ordinal order, with their fractions in each.</summary>
    public static IReadOnlyList<(string Name, double First, double Second)> FractionsOf(CategoryCounts first, CategoryCounts second) =>
        [
            .. first
                .Names.Union(second.Names)
                .Order(System.StringComparer.Ordinal)
                .Select(name => (name, first.FractionOf(name), second.FractionOf(name))),
        ];

    /// <summary>Total variation and Jensen-Shannon divergence (bits) of two counts; null if one is empty.</summary>
    public static (double TotalVariation, double JensenShannon)? Between(CategoryCounts first, CategoryCounts second)
    {
        IReadOnlyList<(string Name, double First, double Second)> names = FractionsOf(first, second);
        double[] one = [.. names.Select(name => name.First)];
        double[] other = [.. names.Select(name => name.Second)];
        return first.Count == 0 || second.Count == 0
            ? null
            : (DistributionDistance.TotalVariation(one, other), DistributionDistance.JensenShannon(one, other));
    }
}
