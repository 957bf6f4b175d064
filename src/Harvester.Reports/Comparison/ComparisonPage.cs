using System.Globalization;
using Harvester.Geometry;
using Harvester.Pages;
using Harvester.Pages.Plots;
using Harvester.Sessions.Text;

namespace Harvester.Reports.Comparison;

/// <summary>Shows two datasets side by side as one HTML page: a plot and a table for each quantity, and tables of classes.</summary>
public static class ComparisonPage
{
    private const string First = "first";
    private const string Second = "second";
    private const double BarPixels = 120;
    private const double BarHeightPixels = 10;
    private const int Percent = 100;

    /// <summary>The axis of shares is a little longer than the greatest share.</summary>
    private const double Headroom = 1.05;

    private const string Style = """
        body { max-width: 1240px; }
        main { display: grid; gap: 20px; grid-template-columns: minmax(0, 1fr); }
        section.panel { padding: 16px; }
        .pair { display: grid; grid-template-columns: minmax(0, 3fr) minmax(280px, 2fr); gap: 24px; align-items: start; }
        .first { stroke: var(--accent); } .second { stroke: #cf8a00; stroke-dasharray: 6 4; }
        b.first { color: var(--accent); } b.second { color: #b27700; }
        rect.first { fill: var(--accent); stroke: none; } rect.second { fill: #cf8a00; stroke: none; }
        .plot polyline { stroke-width: 2; }
        .table + .hint { margin-top: 10px; }
        td svg { display: inline-block; vertical-align: middle; }
        details { margin-top: 10px; } summary { cursor: pointer; color: var(--quiet); }
        .facts b, h1 b { overflow-wrap: anywhere; }
        th { white-space: normal; overflow-wrap: anywhere; }
        @media (max-width: 800px) { .pair { grid-template-columns: minmax(0, 1fr); } }

        """;

    private static readonly (string Name, double Fraction)[] Quantiles =
    [
        ("5 %", 0.05),
        ("25 %", 0.25),
        ("median", 0.5),
        ("75 %", 0.75),
        ("95 %", 0.95),
    ];

    /// <summary>Writes the page.</summary>
    /// <param name="stream">Receives the page; stays open.</param>
    /// <param name="comparison">The datasets.</param>
    /// <exception cref="IOException">The stream cannot be written.</exception>
    public static void Write(Stream stream, DatasetComparison comparison)
    {
        ArgumentNullException.ThrowIfNull(comparison);
        HtmlPage.Write(
            stream,
            $"{comparison.First.Name} and {comparison.Second.Name}",
            Style,
            page =>
            {
                page.Start("header").NewLine().Start("h1");
                page.Start("b").With("class", First).Text(comparison.First.Name).End().Text(" and ");
                page.Start("b").With("class", Second).Text(comparison.Second.Name).End().End().NewLine();
                page.Start("dl").With("class", "facts");
                WriteFact(page, comparison.First);
                WriteFact(page, comparison.Second);
                page.End().End().NewLine().Start("main").NewLine();
                WriteSummary(page, comparison);
                WriteCounts(page, "Classes", comparison, profile => profile.Classes);
                WriteCounts(page, "Levels of occlusion or visibility", comparison, profile => profile.Levels);
                foreach (ComparedQuantity quantity in ComparedQuantity.All)
                {
                    WriteQuantity(page, comparison, quantity);
                }

                WriteKitti(page, comparison);
                page.End().NewLine();
            }
        );
    }

    /// <summary>A number with three significant digits, or the whole number if it has more.</summary>
    public static string Rounded(double value)
    {
        int decimals = value == 0 ? 0 : Math.Clamp(2 - (int)Math.Floor(Math.Log10(Math.Abs(value))), 0, 6);
        return InvariantNumber.Format(value, decimals);
    }

    private static string OrNone(double? value) => value is { } known ? Rounded(known) : "none";

    private static string Whole(long value) => value.ToString(CultureInfo.InvariantCulture);

    private static string Share(double fraction) => $"{(Percent * fraction).ToString("0.0", CultureInfo.InvariantCulture)} %";

    private static string Unit(ComparedQuantity quantity) => quantity.Unit.Length == 0 ? "" : ", " + quantity.Unit;

    private static void WriteFact(MarkupWriter page, DatasetProfile profile) =>
        page.Start("div")
            .Element("dt", profile.Name)
            .Element("dd", $"{Counted.Of(profile.Frames, "frame")}, {Counted.Of(profile.Labels, "label")}")
            .End()
            .NewLine();

    private static void WriteSummary(MarkupWriter page, DatasetComparison comparison)
    {
        StartSection(page, "Distances between the distributions");
        StartTable(page, ["Quantity", .. Names(comparison).Select(name => $"Median, {name}"), "1-Wasserstein", "Jensen-Shannon, bits"]);
        foreach (ComparedQuantity quantity in ComparedQuantity.All)
        {
            WriteRow(
                page,
                quantity.Title + Unit(quantity),
                OrNone(comparison.First.Of(quantity).Quantile(0.5)),
                OrNone(comparison.Second.Of(quantity).Quantile(0.5)),
                OrNone(comparison.WassersteinOf(quantity)),
                OrNone(comparison.JensenShannonOf(quantity))
            );
        }

        EndTable(page);
        page.Start("p")
            .With("class", "hint")
            .Text(
                "The 1-Wasserstein distance, in the unit of the quantity, is how far the values of one dataset must move on average to be "
                    + "distributed as those of the other. The Jensen-Shannon divergence is 0 for equal and 1 for disjoint "
                    + "histograms. Quantities "
                    + "that a dataset does not have are \"none\"."
            )
            .End()
            .NewLine();
        page.End().NewLine();
    }

    private static void WriteQuantity(MarkupWriter page, DatasetComparison comparison, ComparedQuantity quantity)
    {
        (DatasetProfile Profile, ValueSketch Values)[] sides =
        [
            (comparison.First, comparison.First.Of(quantity)),
            (comparison.Second, comparison.Second.Of(quantity)),
        ];
        StartSection(page, quantity.Title);
        if (sides.All(side => side.Values.Count == 0))
        {
            page.Start("p").With("class", "hint").Text("Neither dataset has it.").End().End().NewLine();
            return;
        }

        double[] edges = quantity.Edges(sides[0].Values, sides[1].Values);
        double[][] fractions = [.. sides.Select(side => side.Values.Count == 0 ? [] : side.Values.Fractions(edges))];
        page.Start("div").With("class", "pair").Start("div");
        WritePlot(page, quantity, edges, fractions);
        page.Start("p")
            .With("class", "hint")
            .Text("Solid: ")
            .Start("b")
            .With("class", First)
            .Text(comparison.First.Name)
            .End()
            .Text("; dashed: ")
            .Start("b")
            .With("class", Second)
            .Text(comparison.Second.Name)
            .End()
            .Text(quantity.Range is null ? ". The last bin has all greater values." : ".")
            .End()
            .End()
            .NewLine()
            .Start("div");
        StartTable(page, [quantity.Title + Unit(quantity), .. Names(comparison)]);
        WriteRow(page, "count", [.. sides.Select(side => Whole(side.Values.Count))]);
        WriteRow(page, "mean", [.. sides.Select(side => OrNone(side.Values.Mean))]);
        foreach ((string name, double fraction) in Quantiles)
        {
            WriteRow(page, name, [.. sides.Select(side => OrNone(side.Values.Quantile(fraction)))]);
        }

        EndTable(page);
        WriteBins(page, comparison, quantity, edges, fractions);
        page.End().End().End().NewLine();
    }

    private static void WritePlot(MarkupWriter page, ComparedQuantity quantity, double[] edges, double[][] fractions)
    {
        double most = fractions.SelectMany(share => share).DefaultIfEmpty(1).Max();
        var plot = new LinePlot(
            new PlotAxis(quantity.Title + Unit(quantity), edges[0], edges[^1]),
            new PlotAxis("share of values, %", 0, Percent * most * Headroom)
        );
        foreach ((string style, double[] shares) in new[] { First, Second }.Zip(fractions))
        {
            Vector2D[] outline =
            [
                .. shares.SelectMany(
                    (share, bin) => new[] { new Vector2D(edges[bin], Percent * share), new Vector2D(edges[bin + 1], Percent * share) }
                ),
            ];
            if (outline.Length > 0)
            {
                plot.Add(new PlotLine(style, outline));
            }
        }

        plot.Write(page);
    }

    private static void WriteBins(
        MarkupWriter page,
        DatasetComparison comparison,
        ComparedQuantity quantity,
        double[] edges,
        double[][] fractions
    )
    {
        page.Start("details").Element("summary", "The plot as a table").NewLine();
        StartTable(page, [$"From{Unit(quantity)}", .. Names(comparison)]);
        for (int bin = 0; bin < edges.Length - 1; bin++)
        {
            WriteRow(page, Rounded(edges[bin]), [.. fractions.Select(shares => shares.Length == 0 ? "none" : Share(shares[bin]))]);
        }

        EndTable(page);
        page.End().NewLine();
    }

    private static void WriteCounts(
        MarkupWriter page,
        string title,
        DatasetComparison comparison,
        Func<DatasetProfile, CategoryCounts> countsOf
    )
    {
        (CategoryCounts first, CategoryCounts second) = (countsOf(comparison.First), countsOf(comparison.Second));
        StartSection(page, title);
        StartTable(page, ["Name", .. Names(comparison).SelectMany(name => new[] { $"Labels, {name}", "Share" }), "Shares"]);
        foreach ((string name, double one, double other) in DatasetComparison.FractionsOf(first, second))
        {
            page.Start("tr").Start("th").With("scope", "row").Text(name).End();
            foreach (string cell in new[] { Whole(first.Of(name)), Share(one), Whole(second.Of(name)), Share(other) })
            {
                page.Element("td", cell);
            }

            WriteBars(page.Start("td"), one, other);
            page.End().End().NewLine();
        }

        EndTable(page);
        if (DatasetComparison.Between(first, second) is { } distance)
        {
            page.Start("p")
                .With("class", "hint")
                .Text(
                    $"Total variation {Rounded(distance.TotalVariation)}, Jensen-Shannon divergence {Rounded(distance.JensenShannon)} bits."
                )
                .End()
                .NewLine();
        }

        page.End().NewLine();
    }

    private static void WriteBars(MarkupWriter page, double first, double second)
    {
        page.Start("svg").With("width", BarPixels, 0).With("height", 2 * BarHeightPixels, 0).With("aria-hidden", "true");
        page.Start("rect").With("class", First).With("width", BarPixels * first).With("height", BarHeightPixels - 1).End();
        page.Start("rect")
            .With("class", Second)
            .With("width", BarPixels * second)
            .With("height", BarHeightPixels - 1)
            .With("y", BarHeightPixels)
            .End()
            .End();
    }

    private static void WriteKitti(MarkupWriter page, DatasetComparison comparison)
    {
        StartSection(page, "KITTI's types");
        StartTable(page, ["Type", "KITTI training set", "Share", .. Names(comparison).SelectMany(name => new[] { name, "Share" })]);
        foreach ((string type, int labels) in KittiFigures.Training)
        {
            WriteRow(
                page,
                type,
                [
                    Whole(labels),
                    Share((double)labels / KittiFigures.Labels),
                    .. new[] { comparison.First, comparison.Second }.SelectMany(profile =>
                        profile.KittiTypes.Count == 0
                            ? ["none", "none"]
                            : new[] { Whole(profile.KittiTypes.Of(type)), Share(profile.KittiTypes.FractionOf(type)) }
                    ),
                ]
            );
        }

        EndTable(page);
        page.Start("p")
            .With("class", "hint")
            .Text(
                "Published: the labels of KITTI's object detection training set, 7,481 images, without DontCare. Signs and traffic lights, "
                    + "which KITTI does not label, are left out."
            )
            .End()
            .End()
            .NewLine();
    }

    private static string[] Names(DatasetComparison comparison) => [comparison.First.Name, comparison.Second.Name];

    private static void StartSection(MarkupWriter page, string title) =>
        page.Start("section").With("class", "panel").Element("h2", title).NewLine();

    private static void StartTable(MarkupWriter page, IEnumerable<string> columns)
    {
        page.Start("div").With("class", "table").Start("table").NewLine().Start("thead").Start("tr");
        foreach (string column in columns)
        {
            page.Start("th").With("scope", "col").Text(column).End();
        }

        page.End().End().NewLine().Start("tbody").NewLine();
    }

    private static void EndTable(MarkupWriter page) => page.End().End().End().NewLine();

    private static void WriteRow(MarkupWriter page, string name, params IEnumerable<string> cells)
    {
        page.Start("tr").Start("th").With("scope", "row").Text(name).End();
        foreach (string cell in cells)
        {
            page.Element("td", cell);
        }

        page.End().NewLine();
    }
}
