using System.Globalization;
using System.Reflection;
using Harvester.Geometry.Lanes;
using Harvester.TestSupport;

namespace Harvester.Geometry.Tests.Lanes;

public sealed class IndicatorTableTests
{
    [Fact]
    public void Names_are_in_the_order_of_the_training_data() =>
        Assert.Equal(
            [
                "angle",
                "toMarkingL",
                "toMarkingM",
                "toMarkingR",
                "distL",
                "distR",
                "toMarkingLL",
                "toMarkingML",
                "toMarkingMR",
                "toMarkingRR",
                "distLL",
                "distMM",
                "distRR",
            ],
            IndicatorTable.All.Select(indicator => indicator.Name)
        );

    [Fact]
    public void Each_row_reads_the_property_of_its_name()
    {
        LaneIndicators all = LaneIndicators.From(indicator => Indicator.Of(IndicatorTable.IndexOf(indicator.Name) + 1));

        foreach (IndicatorDefinition indicator in IndicatorTable.All)
        {
            PropertyInfo property = typeof(LaneIndicators).GetProperty(char.ToUpperInvariant(indicator.Name[0]) + indicator.Name[1..])!;
            Assert.Equal(indicator.Of(all), property.GetValue(all));
            Assert.Equal(IndicatorTable.IndexOf(indicator.Name) + 1, indicator.Of(all).Value);
        }
    }

    [Fact]
    public void Replace_changes_one_indicator_only()
    {
        foreach (IndicatorDefinition indicator in IndicatorTable.All)
        {
            LaneIndicators changed = indicator.Replace(LaneIndicators.Unknown, Indicator.Of(1.25));

            Assert.Equal([indicator], IndicatorTable.All.Where(other => other.Of(changed) != other.Of(LaneIndicators.Unknown)));
        }
    }

    [Fact]
    public void An_estimate_is_active_up_to_its_limit()
    {
        foreach (IndicatorDefinition indicator in IndicatorTable.All)
        {
            if (indicator.ActiveLimit is not { } limit)
            {
                Assert.Equal("angle", indicator.Name);
                continue;
            }

            double beyond = limit + (0.001 * Math.Sign(indicator.Range.InactiveValue - limit));
            Assert.Equal(Indicator.Of(limit), indicator.Estimate(limit));
            Assert.Equal(indicator.Range.Inactive, indicator.Estimate(beyond));
        }
    }

    [Fact]
    public void IndexOf_refuses_an_unknown_name() => Assert.Throws<ArgumentException>(() => IndicatorTable.IndexOf("toMarking_LL"));

    [Fact]
    public void Documentation_lists_the_same_ranges()
    {
        Dictionary<string, (string Active, string Inactive)> rows = DocumentedRows();
        Assert.Equal(IndicatorTable.All.Select(indicator => indicator.Name).Order(), rows.Keys.Order());
        foreach (IndicatorDefinition indicator in IndicatorTable.All)
        {
            (string active, string inactive) = rows[indicator.Name];
            string range =
                indicator.Quantity == IndicatorQuantity.Angle
                    ? "-π to π"
                    : FormattableString.Invariant($"{indicator.Range.Min} to {indicator.Range.Max}");
            Assert.StartsWith(range, active, StringComparison.Ordinal);
            Assert.Equal(indicator.Range.InactiveValue.ToString(CultureInfo.InvariantCulture), inactive);
        }
    }

    /// <summary>The rows of the table in docs/lanes.md: name(s), meaning, active values, inactive value.</summary>
    private static Dictionary<string, (string Active, string Inactive)> DocumentedRows()
    {
        string[] lines = File.ReadAllLines(Path.Combine(RepositoryFolder.Path, "docs", "lanes.md"));
        return lines
            .SkipWhile(line => !line.StartsWith("| indicator | meaning", StringComparison.Ordinal))
            .Skip(2)
            .TakeWhile(line => line.StartsWith('|'))
            .Select(line => line.Split('|', StringSplitOptions.TrimEntries))
            .SelectMany(cells => cells[1].Split(',', StringSplitOptions.TrimEntries).Select(name => (Name: name.Trim('`'), cells)))
            .ToDictionary(row => row.Name, row => (row.cells[3], row.cells[4]));
    }
}
